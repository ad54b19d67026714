//! Empty forms: every quantity of the steps, in the order of the construction.

use super::shown::ShownNames;
use crate::construction::{Construction, PlaceId, Solution};
use crate::sheet::{Scales, Sheet};
use indexmap::IndexMap;
use serde::Serialize;

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

/// In the names of images of the ground under a slider, as `c_ground`.
pub(super) const UNDER_SLIDER: &str = "_ground";

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
        let (head, ends) = name.strip_suffix(')')?.split_once('(')?;
        let sheet = match head {
            "vplan" => Sheet::Velocity,
            "aplan" => Sheet::Acceleration,
            _ => return None,
        };
        let (from, to) = ends.split_once(',')?;
        let place = |name| construction.place(sheet, construction.plan_name(sheet, name));
        let (a, b) = (place(from)?, place(to)?);
        Some(Segment(sheet, if a.0 <= b.0 { [a, b] } else { [b, a] }))
    }
}

fn rows(construction: &Construction) -> Vec<FormRow> {
    let mut rows: Vec<FormRow> = Vec::new();
    for step in construction.numbered_steps() {
        let is_measured = step.step.action.is_measured();
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

/// A form without values.
#[derive(Clone, Copy, Debug)]
pub struct EmptyForm<'a> {
    /// The scene whose quantities are asked for.
    pub solution: &'a Solution,
    /// The scales that stand in it.
    pub scales: Scales,
    /// The name of the exercise that it belongs to.
    pub exercise: Option<&'a str>,
}

/// The sense of rotation that counts as positive in every form, as in scenes and results; a slide is positive along its
/// guide.
const POSITIVE: &str = "counter-clockwise";

/// The form as JSON: values are to be written between the quotes, or as numbers in place of them.
#[derive(Debug, Serialize)]
struct FormFile<'a> {
    kinegon_measured: u64,
    name: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    exercise: Option<&'a str>,
    #[serde(flatten, serialize_with = "Scales::by_key")]
    scales: Scales,
    positive: &'static str,
    values: IndexMap<String, &'static str>,
}

impl EmptyForm<'_> {
    /// The form as JSON.
    #[must_use]
    pub fn json(&self) -> String {
        crate::format::json(&FormFile {
            kinegon_measured: 1,
            name: "",
            exercise: self.exercise,
            scales: self.scales,
            positive: POSITIVE,
            values: self.names().into_iter().map(|name| (name, "")).collect(),
        })
    }

    /// The form as a table.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = String::from("quantity,value,unit\nname,,\n");
        if let Some(exercise) = self.exercise {
            text.push_str(&format!("exercise,{},\n", quoted(exercise)));
        }
        for (sheet, scale) in self.scales.given() {
            text.push_str(&format!("{},{scale},\n", sheet.scale_key()));
        }
        text.push_str(&format!("positive,{POSITIVE},\n"));
        for name in self.names() {
            text.push_str(&format!("{},,\n", quoted(&name)));
        }
        text
    }

    /// The names of the quantities, in the notation of the figure.
    fn names(&self) -> Vec<String> {
        let shown = ShownNames::of(self.solution);
        let rows = FormNames::new(&self.solution.construction);
        rows.names().map(|name| shown.in_form(name, &rows)).collect()
    }
}

/// The text of a cell, in quotes.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
