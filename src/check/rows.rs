//! The rows of a form: every quantity of the steps once, in the order of the construction.

use super::sheet::UNDER_SLIDER;
use crate::construction::{Construction, PlaceId};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;

/// The names of the quantities of the steps, once each: those that a form asks for.
///
/// A segment may have several names, as p a₃ and o a₃ where o is fixed: the one that is measured stands there. Of links
/// that turn together, as a block and its lever, the one with more points is asked for.
#[must_use]
pub fn form_names(construction: &Construction) -> Vec<String> {
    rows(construction).into_iter().map(|row| row.name).collect()
}

/// The name by which a form asks for a quantity; of one that it does not ask for its own name.
#[must_use]
pub fn form_name(construction: &Construction, name: &str) -> String {
    FormNames::new(construction).of(construction, name).to_owned()
}

/// The rows of a construction's form, to look many names up.
#[derive(Debug)]
pub(super) struct FormNames(Vec<FormRow>);

impl FormNames {
    pub fn new(construction: &Construction) -> FormNames {
        FormNames(rows(construction))
    }

    /// The names of the rows, in their order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|row| row.name.as_str())
    }

    /// The row of a segment from the image of the ground under a slider, for a name that has the pole in its place: the
    /// two are one point, and the sheet shows the pole.
    pub fn row_with_pole<'n>(&'n self, construction: &Construction, name: &str) -> Option<&'n str> {
        let segment = Segment::of(construction, name)?;
        let row = self.0.iter().find(|row| row.segment == Some(segment))?;
        (row.name != name && row.name.contains(UNDER_SLIDER)).then_some(row.name.as_str())
    }

    /// The name by which the form asks for a quantity, as [`form_name`].
    pub fn of<'n>(&'n self, construction: &'n Construction, name: &'n str) -> &'n str {
        let name = construction.same_rates.get(name).map_or(name, String::as_str);
        // No two rows ask for one segment, so a row of that very name is the one.
        if self.0.iter().any(|row| row.name == name) {
            return name;
        }
        let segment = Segment::of(construction, name);
        self.0.iter().find(|row| row.is(name, segment)).map_or(name, |row| row.name.as_str())
    }
}

/// A row of a form.
#[derive(Debug)]
struct FormRow {
    name: String,
    segment: Option<Segment>,
    is_measured: bool,
}

impl FormRow {
    /// Whether it asks for the quantity of that name, which is this segment.
    fn is(&self, name: &str, segment: Option<Segment>) -> bool {
        self.name == name || (segment.is_some() && self.segment == segment)
    }
}

/// The two places between which a segment of a plan lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Segment(Sheet, [PlaceId; 2]);

impl Segment {
    /// The segment of that name; `None` for other quantities.
    fn of(construction: &Construction, name: &str) -> Option<Segment> {
        let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
        let Head::Between(sheet) = name.head else { return None };
        let place = |name: &String| construction.place(sheet, construction.plan_name(sheet, name));
        let (a, b) = (place(name.arguments.first()?)?, place(name.arguments.get(1)?)?);
        Some(Segment(sheet, if a.0 <= b.0 { [a, b] } else { [b, a] }))
    }
}

fn rows(construction: &Construction) -> Vec<FormRow> {
    let mut rows: Vec<FormRow> = Vec::new();
    for step in construction.numbered_steps() {
        let is_measured = step.action.is_measured();
        for name in step.names() {
            let name = construction.same_rates.get(&name).cloned().unwrap_or(name);
            let segment = Segment::of(construction, &name);
            match rows.iter().position(|row| row.is(&name, segment)) {
                Some(row) if is_measured && !rows[row].is_measured => drop(rows.remove(row)),
                Some(_) => continue,
                None => {}
            }
            rows.push(FormRow { name, segment, is_measured });
        }
    }
    rows
}
