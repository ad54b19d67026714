//! Names of quantities: those that a form asks for, those that its sheets show, and what quantity a written name means.
//!
//! Quantities keep their names in results; a form writes `vplan(o,b)` where the figure's notation calls the pole o. A
//! form may have either name, and the usual ones of poles in all notations, the ends of segments in either order, and
//! letters that a program has lost.

use super::measured::{CheckError, UNDER_SLIDER};
use super::says;
use crate::centers::LinkPair;
use crate::construction::{Construction, PlaceId, Plan, Solution, image_name};
use crate::quantity::{Corners, Pole, QuantityError, QuantityRequest, Unread, What, read_by_hand};
use crate::scene::{Head, QuantityName, SceneError};
use crate::sheet::{Order, Sheet};
use crate::text::{Untrusted, shown};
use crate::words::{Notation, Wording, with_prime};
use indexmap::IndexMap;

/// The names of the quantities of the steps, once each: those that a form asks for.
///
/// A segment may have several names, as p a₃ and o a₃ where o is fixed: the one that is measured stands there. Of links
/// that turn together, as a block and its lever, the one with more points is asked for.
#[must_use]
pub fn form_names(construction: &Construction) -> Vec<String> {
    rows(construction).into_iter().map(|row| row.name).collect()
}

/// The names of the quantities for which a scene's form has boxes: of [`form_names`] those that its key `form` names, where it has one.
#[must_use]
pub fn asked_names(solution: &Solution) -> Vec<String> {
    Names::new(solution).rows().map(str::to_owned).collect()
}

/// The names of the arms that a hand measures for its force polygons: a form asks for those that the scene's key `form` names.
#[must_use]
pub fn arm_names(solution: &Solution) -> Vec<String> {
    solution.construction.arm_names(&solution.mechanism).into_iter().collect()
}

impl Solution {
    /// Refuses a scene whose form asks for what the mechanism does not have, or what no step finds.
    ///
    /// # Errors
    /// The first such name, with its place in the scene.
    pub fn check_form(&self) -> Result<(), SceneError> {
        let names = Names::new(self);
        let Some(name) = names.without_row.first() else { return Ok(()) };
        let CheckError { message, hint, .. } = match names.quantity(name) {
            Err(unknown) => unknown,
            Ok(_) => CheckError::new(says::no_box(shown(name)), crate::scene::says::form_names_quantities()),
        };
        Err(self.scene.error_at(&["form", name], message, hint))
    }
}

/// A row of a form.
#[derive(Debug)]
struct FormRow {
    name: String,
    segment: Option<Segment>,
    is_measured: bool,
    /// What it is worth, in marks; none where the scene's form has no box for it.
    worth: Option<f64>,
}

impl FormRow {
    /// Whether it asks for the quantity of that name, which is this segment.
    fn is(&self, name: &str, segment: Option<Segment>) -> bool {
        self.name == name || (segment.is_some() && self.segment == segment)
    }
}

/// The two places of a sheet between which a segment lies.
type Segment = (Sheet, [PlaceId; 2]);

/// The segment of that name; `None` for other quantities.
fn segment(construction: &Construction, name: &str) -> Option<Segment> {
    let (name, sheet) = between(name).filter(|(name, _)| name.is_plain())?;
    let place = |name: &String| construction.place(sheet, construction.plan_name(sheet, name));
    let (a, b) = (place(name.arguments.first()?)?, place(name.arguments.get(1)?)?);
    Some((sheet, if a.0 <= b.0 { [a, b] } else { [b, a] }))
}

/// A name that asks for the distance of two points of a sheet, and the sheet.
fn between(name: &str) -> Option<(QuantityName, Sheet)> {
    let name = QuantityName::parse(name)?;
    match name.head {
        Head::Between(sheet) => Some((name, sheet)),
        _ => None,
    }
}

/// Whether a name asks for what a form has a box for where the scene wants it alone: what lies between corners of a force polygon, which no
/// step finds by that name; or an arm, which a hand measures on its way to a moment.
fn is_extra(name: &str) -> bool {
    is_arm(name) || QuantityName::parse(name).is_some_and(|name| name.head == Head::Between(Sheet::Forces))
}

/// Whether a name asks for the arm of a force.
pub(crate) fn is_arm(name: &str) -> bool {
    QuantityName::parse(name).is_some_and(|name| name.head == Head::Arm)
}

fn rows(construction: &Construction) -> Vec<FormRow> {
    let mut rows: Vec<FormRow> = Vec::new();
    for step in construction.steps_by_hand() {
        let is_measured = step.action.is_measured();
        for name in step.names() {
            let name = construction.same_rates.get(&name).cloned().unwrap_or(name);
            let segment = segment(construction, &name);
            match rows.iter().position(|row| row.is(&name, segment)) {
                Some(row) if is_measured && !rows[row].is_measured => drop(rows.remove(row)),
                Some(_) => continue,
                None => {}
            }
            rows.push(FormRow { name, segment, is_measured, worth: Some(1.0) });
        }
    }
    rows
}

/// The names of a solved scene's quantities, also in its figure's notation with its labels.
#[derive(Debug)]
pub(super) struct Names<'a> {
    pub solution: &'a Solution,
    /// All quantities of the steps, in order, with the numbers of their steps.
    pub order: IndexMap<String, usize>,
    /// Those that a form may ask for.
    rows: Vec<FormRow>,
    /// The names in the scene's form for which it has no row.
    without_row: Vec<String>,
}

/// A quantity that a name means.
pub(super) struct Meant {
    /// The quantity, by the name that steps and results give it.
    pub asked: QuantityRequest,
    /// The name by which the form asks for it.
    pub row: String,
    /// Its exact value.
    pub expected: f64,
    /// The number of the step that gives it.
    pub step: usize,
}

impl<'a> Names<'a> {
    pub fn new(solution: &'a Solution) -> Names<'a> {
        let construction = &solution.construction;
        let steps = construction.steps_of_quantities().into_iter();
        let mut names = Names {
            solution,
            order: steps.map(|(name, step)| (name, construction.step_number(step))).collect(),
            rows: rows(construction),
            without_row: Vec::new(),
        };
        if let Some(form) = &solution.scene.form {
            let asked = form.iter().map(|(name, marks)| (names.row_of(&names.usual(name)).to_owned(), *marks));
            let asked: IndexMap<String, f64> = asked.collect();
            let has_no_step = |name: &&String| is_extra(name) || names.is_without_construction(name);
            let further: Vec<&String> = asked.keys().filter(has_no_step).collect();
            further.into_iter().for_each(|name| names.add_row(name));
            names.rows.iter_mut().for_each(|row| row.worth = asked.get(&row.name).copied());
            let has_row = |name: &&String| {
                let usual = names.usual(name);
                let own = names.row_of(&usual);
                names.rows.iter().any(|row| row.name == own)
            };
            names.without_row = form.keys().filter(|name| !has_row(name)).cloned().collect();
        }
        names
    }

    /// Whether no step can ask for a quantity, as its group has no construction by hand: it has a value all the same.
    fn is_without_construction(&self, name: &str) -> bool {
        let is_row = self.rows.iter().any(|row| row.name == name);
        let Ok(asked) = QuantityRequest::new(name, &self.solution.mechanism) else { return false };
        !is_row && matches!(read_by_hand(self.solution, &[asked]).1[..], [Err(Unread::NoConstruction)])
    }

    /// Adds a row that no step asks for: an arm before what its moment finds, all else behind the others.
    fn add_row(&mut self, name: &str) {
        let row = FormRow { name: name.to_owned(), segment: None, is_measured: true, worth: None };
        // What the plan does not have has no box.
        let Solution { mechanism, construction, .. } = self.solution;
        let Ok(asked) = QuantityRequest::new(name, mechanism) else { return };
        let is_there = match asked.is_arm() {
            true => asked.measured_arm(construction, mechanism).is_some(),
            false => {
                let scales = self.solution.scales();
                asked.value(&self.solution.snapshot(), Some(construction), Some(&scales)).is_ok()
            }
        };
        if !is_there {
            return;
        }
        let step = asked.is_arm().then(|| self.step_of(&asked));
        let is_later = |row: &FormRow| self.order.get(&row.name).zip(step).is_some_and(|(own, step)| *own >= step);
        let place = self.rows.iter().position(is_later).unwrap_or(self.rows.len());
        self.rows.insert(place, row);
    }

    /// What the scene asks for: the rows of its form in their order, and the names for which there is no row.
    pub fn all_asked(&self) -> impl Iterator<Item = &str> {
        self.rows().chain(self.without_row.iter().map(String::as_str))
    }

    /// The names of the rows of the scene's form, in their order.
    pub fn rows(&self) -> impl Iterator<Item = &str> {
        self.worths().map(|(name, _)| name)
    }

    /// The same with what each is worth, in marks.
    pub fn worths(&self) -> impl Iterator<Item = (&str, f64)> {
        self.rows.iter().filter_map(|row| Some((row.name.as_str(), row.worth?)))
    }

    /// The row of a segment from the image of the ground under a slider, for a name that has the pole in its place: the
    /// two are one point, and the sheet shows the pole.
    fn row_with_pole(&self, name: &str) -> Option<&str> {
        let segment = segment(&self.solution.construction, name)?;
        let row = self.rows.iter().find(|row| row.segment == Some(segment))?;
        (row.name != name && row.name.contains(UNDER_SLIDER)).then_some(row.name.as_str())
    }

    /// The name by which the form asks for a quantity; of one that it does not ask for its own name.
    pub fn row_of<'n>(&'n self, name: &'n str) -> &'n str {
        let construction = &self.solution.construction;
        let name = construction.same_rates.get(name).map_or(name, String::as_str);
        // No two rows ask for one segment, so a row of that very name is the one.
        if self.rows.iter().any(|row| row.name == name) {
            return name;
        }
        let segment = segment(construction, name);
        self.rows.iter().find(|row| row.is(name, segment)).map_or(name, |row| row.name.as_str())
    }

    /// The quantity that a name means in a form. The pole may stand in it for the image of the ground under a slider, but
    /// not in a form that `names_ground`, where the pole is itself.
    pub fn meant(&self, name: &str, names_ground: bool) -> Result<Meant, CheckError> {
        let of_ground = if names_ground { None } else { self.row_with_pole(&self.usual(name)) };
        self.quantity(of_ground.unwrap_or(name))
    }

    /// The quantity of a name.
    pub fn quantity(&self, written: &str) -> Result<Meant, CheckError> {
        let solution = self.solution;
        let wrong = |error| self.unknown(written, error);
        let name = &self.usual(written);
        if let Some(error) = self.lost_pole(name) {
            return Err(error);
        }
        let in_steps = self.in_steps(name);
        let name = in_steps.as_deref().unwrap_or(name);
        let mut asked = QuantityRequest::new(name, &solution.mechanism).map_err(wrong)?;
        asked.check_size().map_err(wrong)?;
        if asked.is_vector() {
            asked = QuantityRequest::new(&format!("{name}.size"), &solution.mechanism).map_err(wrong)?;
        }
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), None);
        let expected = value.map_err(wrong)?.as_number();
        let row = self.row_of(asked.name()).to_owned();
        let named = self.order.get(asked.name());
        let step = named.or_else(|| self.order.get(QuantityName::of_direction(asked.name())?)).copied();
        let step = step.unwrap_or_else(|| self.step_of(&asked));
        Ok(Meant { asked, row, expected, step })
    }

    /// The error of a name that means nothing here, with the nearest name that does.
    fn unknown(&self, name: &str, mut error: QuantityError) -> CheckError {
        let own = match &mut error {
            QuantityError::Unknown { nearest, .. } => nearest.take().map(says::did_you_mean),
            _ => None,
        };
        if let QuantityError::Form(_) = error {
            let near = crate::scene::nearest(name, self.order.keys().map(String::as_str));
            let hint = near.map_or_else(says::template_lists, says::nearest_name);
            return CheckError::new(says::no_quantity(shown(name)), hint);
        }
        CheckError::new(error.problem().message, own.unwrap_or_else(says::template_lists))
    }

    /// The error of a name whose π has become a question mark: an encoding without Greek letters lost it.
    fn lost_pole(&self, name: &str) -> Option<CheckError> {
        if !name.contains(['?', '\u{fffd}']) {
            return None;
        }
        let restored = name.replace(['?', '\u{fffd}'], "π");
        let is_known = |name: &str| self.order.contains_key(&self.usual(name));
        let reversed = || Some(QuantityName::parse(&restored)?.reversed().to_string());
        let was_pole = is_known(&restored) || reversed().is_some_and(|name| is_known(&name));
        was_pole.then(|| CheckError::new(says::pi_lost(shown(name)), says::save_as_utf8()))
    }

    /// The steps' name of a segment or length whose ends are written in the other order, or called as if every leg had
    /// a normal part; `None` for other names.
    fn in_steps(&self, name: &str) -> Option<String> {
        if self.order.contains_key(name) {
            return None;
        }
        let (name, sheet) = between(name).filter(|(name, _)| name.is_plain())?;
        let plan_name = |point: &String| self.solution.construction.plan_name(sheet, point).to_owned();
        let name = name.with_arguments(name.arguments.iter().map(plan_name).collect());
        [name.to_string(), name.reversed().to_string()].into_iter().find(|n| self.order.contains_key(n))
    }

    /// The number of the step after which a quantity that no step names can be read: that which makes the image of its
    /// point, or the later of a segment's ends, or else the last of its sheet. 0 on the scheme.
    fn step_of(&self, asked: &QuantityRequest) -> usize {
        let construction = &self.solution.construction;
        if let Some(arm) = asked.measured_arm(construction, &self.solution.mechanism) {
            return construction.step_of_number(arm).map_or(0, |step| construction.step_number(step));
        }
        let sheet = asked.sheet();
        if sheet == Sheet::Scheme {
            return 0;
        }
        if sheet == Sheet::Centers {
            let of_center = |pole: &Pole| self.order.get(&format!("{}.x", pole.name)).copied();
            return asked.centers().filter_map(of_center).max().unwrap_or(0);
        }
        let steps = || construction.steps_by_hand();
        if let What::Corners(Corners { ends, .. }) = &asked.what {
            let place = |name: &String| construction.place(sheet, name);
            let made = ends.iter().filter_map(place).filter_map(|place| construction.step_of_place(place));
            return made.map(|step| construction.step_number(step)).max().unwrap_or(0);
        }
        let maker = |image: &str| {
            let maker = steps().find(|s| s.sheet == sheet && s.action.image() == Some(image));
            maker.map(|step| step.number)
        };
        let made = match &asked.what {
            What::Segment(_, ends) => ends.iter().filter_map(|end| maker(construction.plan_name(sheet, end))).max(),
            _ => maker(&image_name(asked.written.subject().split('/').next().unwrap_or(""))),
        };
        let last = || steps().filter(|s| s.sheet <= sheet).last().map(|step| step.number);
        made.or_else(last).unwrap_or(0)
    }

    /// A quantity as a person reads it on the sheets: `p b`, `B S3`, `ω_2`.
    pub fn shown(&self, asked: &QuantityRequest) -> String {
        let between = |sheet, from: &str, to: &str| {
            let [from, to] = [from, to].map(|name| self.point(sheet, name).unwrap_or_else(|| name.to_owned()));
            format!("{from} {to}")
        };
        match &asked.what {
            What::Segment(order, [from, to]) if asked.written.component.is_none() => between(order.sheet(), from, to),
            What::Segment(order, [from, to]) => format!("∠ {}", between(order.sheet(), from, to)),
            What::Corners(Corners { ends: [from, to], .. }) if asked.written.component.is_none() => {
                between(Sheet::Forces, from, to)
            }
            What::Length(from, to) if asked.sheet() == Sheet::Scheme => between(Sheet::Scheme, from.name(), to.name()),
            _ => {
                let Wording { notation, .. } = self.solution.wording();
                plain(&asked.symbol(&self.solution.mechanism, &notation, &|name| self.label(name)))
            }
        }
    }

    /// A quantity by its name as a person reads it; names that mean none stay as they are.
    pub fn named(&self, name: &str) -> String {
        let asked = QuantityRequest::new(name, &self.solution.mechanism);
        asked.map_or_else(|_| name.to_owned(), |asked| self.shown(&asked))
    }

    /// The name by which a form in the figure's notation asks for a quantity; its usual name where that is not plain.
    pub fn in_form(&self, name: &str) -> String {
        let shown = || {
            let (parts, sheet) = between(name)?;
            let ends = parts.arguments.iter().map(|end| Some(self.point(sheet, end)?.replace('′', "'")));
            let shown = parts.with_arguments(ends.collect::<Option<Vec<String>>>()?).to_string();
            let usual = self.usual(&shown);
            (usual == name || self.row_with_pole(&usual) == Some(name)).then_some(shown)
        };
        shown().unwrap_or_else(|| name.to_owned())
    }

    /// The usual name of a quantity written by the names of any notation; what is not known stays as it is.
    fn usual(&self, written: &str) -> String {
        let Some((parts, sheet)) = between(written) else {
            return self.usual_center(written).unwrap_or_else(|| written.to_owned());
        };
        let ends =
            parts.arguments.iter().map(|end| self.usual_center(end).unwrap_or_else(|| self.usual_point(sheet, end)));
        parts.with_arguments(ends.collect()).to_string()
    }

    /// The usual name of an instant centre, or of a coordinate of it, whose links are written in either order, the frame as 0; `None` of what is none.
    fn usual_center(&self, written: &str) -> Option<String> {
        let parts = QuantityName::parse(written).filter(|name| name.head == Head::Center)?;
        let mechanism = &self.solution.mechanism;
        let pair = LinkPair::of_names(&parts.arguments, mechanism)?;
        let links = pair.links().map(|link| mechanism.body(link).name.clone());
        Some(parts.with_arguments(links.to_vec()).to_string())
    }

    /// The usual name of a point of a sheet written in any notation.
    pub fn usual_point(&self, sheet: Sheet, written: &str) -> String {
        let construction = &self.solution.construction;
        let name = written.trim().replace('′', "'");
        let Some(plan) = construction.plan_on(sheet) else {
            if let Some(center) = self.usual_center(&name).filter(|_| sheet == Sheet::Centers) {
                return center;
            }
            let known = self.scheme_points().any(|known| known == name);
            let labelled = || self.scheme_points().find(|known| self.point(sheet, known).as_ref() == Some(&name));
            return if known { name } else { labelled().map_or(name.clone(), str::to_owned) };
        };
        if plan.points.contains_key(construction.plan_name(sheet, &name)) {
            return name;
        }
        let shown = |point: &&String| self.point(sheet, point).is_some_and(|shown| shown.replace('′', "'") == name);
        if let Some(point) = plan.points.keys().find(shown) {
            return point.clone();
        }
        in_other_notation(plan, &name).unwrap_or(name)
    }

    /// A point as a sheet shows it, without markup; `None` where its label has been taken away or is no plain name.
    fn point(&self, sheet: Sheet, name: &str) -> Option<String> {
        let labels = &self.solution.scene.figure.labels;
        let shown = match (labels.get(name), self.solution.construction.plan_on(sheet)) {
            (Some(label), _) => plain(&label.for_setting()),
            (None, Some(plan)) => plain(&plan.shown(name, name.to_owned(), &self.solution.wording().notation)),
            (None, None) => name.to_owned(),
        };
        let is_plain = !shown.is_empty() && !shown.contains([',', '(', ')', ' ', '"', ';']);
        is_plain.then_some(shown)
    }

    /// A name of the scene with its label.
    fn label(&self, name: &str) -> String {
        let label = self.solution.scene.figure.labels.get(name).filter(|label| !label.is_blank());
        label.map_or_else(|| name.to_owned(), Untrusted::for_setting)
    }

    /// The names of the points of the scheme.
    fn scheme_points(&self) -> impl Iterator<Item = &str> {
        let special = self.solution.construction.special.iter().map(|special| special.name.as_str());
        self.solution.mechanism.points.iter().map(String::as_str).chain(special)
    }
}

/// The plan point with that name in any notation.
fn in_other_notation(plan: &Plan, name: &str) -> Option<String> {
    let is_pole = |notation: &&Notation| plain(notation.pole(plan.order)).replace('′', "'") == name;
    if Notation::ALL.iter().any(is_pole) || (plan.order == Order::Acceleration && name == "pi") {
        return Some(plan.order.pole().to_owned());
    }
    // Images in an acceleration plan may bear a prime.
    let primed = plan.points.keys().find(|point| with_prime(point).replace('′', "'") == name);
    primed.filter(|_| plan.order == Order::Acceleration).cloned()
}

/// Markup without its braces.
fn plain(markup: &str) -> String {
    markup.chars().filter(|c| !matches!(c, '{' | '}' | '`')).collect()
}
