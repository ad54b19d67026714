//! Decides which variants are exercises: those that a careful hand draws well.

use super::asked::to_ask;
use super::centers;
use super::forces;
use super::says;
use super::sheets::{key_rows, sentences};
use crate::check::{BANDS, arm_names, asked_names, form_names, is_arm};
use crate::construction::{Action, Construction, Rate, Solution, Tolerance};
use crate::drawing::{
    Drawing, FigureSheets, KeyRow, RichText, drawing_sheets, exercise_scale, exercise_sheet, key_scales,
    shows_special_points,
};
use crate::mechanism::mechanism;
use crate::message::Message;
use crate::position::{pose, with_nearest_sides};
use crate::quantity::{Pencil, QuantityRequest, What, pencil};
use crate::scene::{Figure, Page, PageSize, ScalesFor, Scene};
use crate::sheet::{Order, Scales, Sheet};
use indexmap::{IndexMap, IndexSet};

/// Largest condition number of a group: near singular positions an error of a length is enlarged many times.
const CONDITION: f64 = 40.0;
/// Smallest sine of the angle between lines that are crossed: that of 20°.
const SINE: f64 = 0.35;
/// Smallest length on paper of what is read off a sheet and not zero, in mm: lengths and segments that are measured, images
/// from the pole.
const SHORTEST: f64 = 5.0;
/// The same of vectors that are laid off, whose size is known before.
const SHORTEST_LAID_OFF: f64 = 4.0;
/// A rate below this part of the largest of its kind is judged as if it were that large.
const SMALL: f64 = 1.0 / 3.0;
/// Largest band of a rate, in parts of the rate.
const BAND: f64 = 0.15;
/// Relative tolerance for zero, in parts of the largest of its kind; rounding leaves less.
const ZERO: f64 = 1e-9;

/// A scene to be drawn by hand, with its solution and its sheet.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// The text of its scene file.
    pub text: String,
    /// The scene, solved.
    pub solution: Solution,
    /// The scales of its sheets.
    pub scales: Scales,
    /// The band of a careful hand for each quantity of the form.
    pub pencil: Pencil,
    /// The sheet that the student gets: the scheme without special points, the given numbers, boxes for the results.
    /// [`Exercise::sheets`] are the same with markers.
    pub sheet: Drawing,
    /// The values that it should ask for, with their marks.
    pub(super) to_ask: IndexMap<String, f64>,
    /// The page of the student's sheets.
    page: Page,
    /// Whether they have markers; never in a projector's proportions.
    pub(super) has_markers: bool,
}

/// Why a variant is no exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, thiserror::Error)]
#[error("{}", self.message())]
#[non_exhaustive]
pub enum Refusal {
    /// The scene is not understood.
    Numbers,
    /// The mechanism cannot be assembled.
    Assembly,
    /// A singular position, or nearly one.
    Singular,
    /// The plans have no construction.
    NoConstruction,
    /// The construction and the loop equations differ by more than rounding allows.
    Routes,
    /// Lines cross under small angles.
    Crossing,
    /// A special point or a plan has no room on the sheet.
    Sheet,
    /// Segments are too short to be measured or laid off.
    Short,
    /// The band of a rate is too wide.
    Unsure,
    /// An instant centre has no room on the sheet.
    CenterFar,
    /// Two instant centres are close to each other.
    CentersClose,
    /// A distance of instant centres is too short.
    CenterDistance,
    /// An instant centre is not found well.
    CenterUnsure,
    /// Directions of forces, or lines about whose crossing moments are taken, cross under small angles.
    ForcesCross,
    /// A force is too short on paper.
    ForceShort,
    /// An arm is too short on paper.
    ArmShort,
    /// A force is much smaller than another one.
    ForcesUnequal,
    /// A force or a moment is not found well.
    ForceUnsure,
    /// An earlier exercise has the same numbers.
    Same,
}

impl Refusal {
    /// What it says.
    #[must_use]
    pub fn message(self) -> Message {
        match self {
            Refusal::Numbers => says::numbers(),
            Refusal::Assembly => says::assembly(),
            Refusal::Singular => says::singular(),
            Refusal::NoConstruction => says::no_plans(),
            Refusal::Routes => says::routes(),
            Refusal::Crossing => says::crossing(),
            Refusal::Sheet => says::sheet(),
            Refusal::Short => says::short(),
            Refusal::Unsure => says::unsure(),
            Refusal::CenterFar => says::center_far(),
            Refusal::CentersClose => says::centers_close(),
            Refusal::CenterDistance => says::center_distance(),
            Refusal::CenterUnsure => says::center_unsure(),
            Refusal::ForcesCross => says::forces_cross(),
            Refusal::ForceShort => says::force_short(),
            Refusal::ArmShort => says::arm_short(),
            Refusal::ForcesUnequal => says::forces_unequal(),
            Refusal::ForceUnsure => says::force_unsure(),
            Refusal::Same => says::same(),
        }
    }
}

impl Exercise {
    /// The scene of that text, if it is an exercise for a sheet of that size; with the scene's figure, or with `asked`. Its form asks for arms
    /// if the scene's does, or if it `has_arms`.
    pub(super) fn of(text: &str, page: Page, asked: Option<&Figure>, has_arms: bool) -> Result<Exercise, Refusal> {
        let mut scene = Scene::read(text).map_err(|_| Refusal::Numbers)?;
        scene.figure = asked.unwrap_or(&scene.figure).clone();
        // A sheet for the hand has letters for the hand, in a style for the hall too.
        scene.figure.sizes.get_or_insert_default();
        let mechanism = mechanism(&scene).map_err(|_| Refusal::Numbers)?;
        let mechanism = with_nearest_sides(&scene, mechanism);
        let pose = pose(&mechanism, &scene.near).map_err(|_| Refusal::Assembly)?;
        let mut solution = Solution::new(scene, mechanism, pose, Order::Acceleration).map_err(|_| Refusal::Singular)?;
        let conditions = solution.motion.conditions.iter().copied();
        if conditions.fold(1.0, f64::max) > CONDITION {
            return Err(Refusal::Singular);
        }
        crosses_well(&solution.construction)?;
        forces::are_alike(&solution.construction)?;
        // Whether a variant is an exercise does not hang on what it asks for.
        let names = names_to_ask(&solution, has_arms);
        let further = names.iter().filter(|name| is_arm(name)).cloned();
        let quantities: Vec<QuantityRequest> = form_names(&solution.construction)
            .into_iter()
            .chain(further)
            .map(|name| QuantityRequest::new(&name, &solution.mechanism))
            .collect::<Result<_, _>>()
            .map_err(|_| Refusal::NoConstruction)?;
        // Scheme and plans are as large as fits on the key's sheet; the scheme is smaller where the student's sheet
        // needs it.
        let mut students = for_students(&solution, page);
        let figure = &mut solution.scene.figure;
        (figure.page, figure.worksheet) = (key_page(page), true);
        // The key is the only sheet with plans; the accepted file says its scales, which then hold everywhere.
        figure.scales = ScalesFor::Sheet;
        let expected = pencil(&solution, &solution.scales(), Tolerance::default(), quantities.clone());
        let mut scales = key_scales(&solution, &key_rows(&solution, &expected)).ok_or(Refusal::Sheet)?;
        if solution.scene.figure.mu[Sheet::Scheme].is_none() {
            let given = sentences(&solution, &scales);
            let mu = exercise_scale(&students, &quantities, &given);
            scales[Sheet::Scheme] = if mu > scales[Sheet::Scheme] { mu } else { scales[Sheet::Scheme] };
        }
        for figure in [&mut solution.scene.figure, &mut students.scene.figure] {
            figure.mu = scales;
        }
        is_long_enough(&solution.construction, &scales)?;
        if solution.off_guides().next().is_some() {
            return Err(Refusal::Assembly);
        }
        let has_plans = solution.construction.draws_plans();
        let shows_all = !has_plans || shows_special_points(&solution);
        if !(FigureSheets::new(&solution).overflow_warnings().is_empty() && shows_all) {
            return Err(Refusal::Sheet);
        }
        centers::are_clear(&solution, &scales)?;
        forces::are_clear(&solution.construction, &scales)?;
        let mut pencil = pencil(&solution, &scales, Tolerance::default(), quantities.clone());
        let rows = key_rows(&solution, &pencil);
        is_sure(&rows)?;
        centers::are_sure(&rows, &scales)?;
        forces::are_sure(&rows)?;
        key_scales(&solution, &rows).ok_or(Refusal::Sheet)?;
        let asked: Vec<KeyRow<'_>> = rows.into_iter().filter(|row| names.contains(row.asked.name())).collect();
        let to_ask = to_ask(&asked, &solution);
        pencil.quantities.retain(|(quantity, _)| names.contains(quantity.name()));
        pencil.quantities.sort_by_key(|(quantity, _)| names.get_index_of(quantity.name()));
        let quantities: Vec<QuantityRequest> = pencil.quantities.iter().map(|(asked, _)| asked.clone()).collect();
        let given = sentences(&solution, &scales);
        let sheet = exercise_sheet(&students, &quantities, &given).ok_or(Refusal::Sheet)?;
        let has_markers = students.scene.figure.has_markers();
        Ok(Exercise { text: text.to_owned(), scales, pencil, sheet, solution, to_ask, page, has_markers })
    }

    /// The sheets on which a student draws: the scheme's, then those for the plans, all with markers and a small code by
    /// which a photograph of them is read; `name` stands in the codes. A table without room beside the scheme comes
    /// last.
    ///
    /// Just [`Exercise::sheet`] where the figure is to have no markers.
    #[must_use]
    pub fn sheets(&self, name: &str) -> Vec<Drawing> {
        if !self.has_markers {
            return vec![self.sheet.clone()];
        }
        let students = for_students(&self.solution, self.page);
        let given = sentences(&students, &self.scales);
        // A variant whose scheme has no room between the markers stays an exercise: its first sheet is without them, and
        // the numbers of a seed do not hang on what sheets look like.
        drawing_sheets(&students, &self.scales, name, &self.asked(), &given)
    }

    /// The sentences of the student's sheet with all given numbers and the scales of the plans.
    #[must_use]
    pub fn given(&self) -> Vec<RichText> {
        let sentences = sentences(&self.solution, &self.scales);
        sentences.iter().map(|sentence| RichText::plain(sentence)).collect()
    }

    /// The quantities of the form.
    pub(crate) fn asked(&self) -> Vec<QuantityRequest> {
        self.pencil.quantities.iter().map(|(asked, _)| asked.clone()).collect()
    }
}

/// The solution of a scene for the sheets of a student, on that page.
fn for_students(solution: &Solution, page: Page) -> Solution {
    let mut students = solution.clone();
    let figure = &mut students.scene.figure;
    // What is to be found is not shown.
    figure.inflection.clear();
    (figure.page, figure.worksheet) = (page, false);
    students
}

/// The names of all that a scene's form asks for; with arms where it `has_arms`.
fn names_to_ask(solution: &Solution, has_arms: bool) -> IndexSet<String> {
    let arms = if has_arms { arm_names(solution) } else { Vec::new() };
    asked_names(solution).into_iter().chain(arms).collect()
}

/// The page of the key, which has the plans too: the largest size.
pub(super) fn key_page(students: Page) -> Page {
    Page { size: PageSize::A3, ..students }
}

/// Whether a hand finds all angular velocities and accelerations well.
fn is_sure(rows: &[KeyRow<'_>]) -> Result<(), Refusal> {
    let is_rate = |row: &&KeyRow<'_>| matches!(&row.asked.what, What::Rate(Rate::Angular(..)));
    let rates = || rows.iter().filter(is_rate);
    for KeyRow { asked, value, allowed } in rates() {
        let alike = rates().filter(|other| other.asked.kind() == asked.kind());
        let largest = alike.map(|other| other.value.abs()).fold(0.0, f64::max);
        let size = value.abs().max(SMALL * largest);
        let is_zero = value.abs() <= ZERO * largest;
        let allowed = allowed.ok_or(Refusal::Unsure)?;
        // A drawing that passes must show the sense of a rate that is not zero.
        if allowed > BANDS * BAND * size || (allowed > value.abs() && !is_zero) {
            return Err(Refusal::Unsure);
        }
    }
    Ok(())
}

/// Whether all groups have a construction, exact and with good crossings.
fn crosses_well(construction: &Construction) -> Result<(), Refusal> {
    for agreement in construction.agreement.iter().filter(|_| construction.draws_plans()) {
        let agreement = agreement.ok_or(Refusal::NoConstruction)?;
        if agreement.difference > agreement.allowed {
            return Err(Refusal::Routes);
        }
    }
    centers::are_constructed(construction)?;
    forces::are_constructed(construction)?;
    let sines = construction.steps_by_hand().filter_map(|s| match &s.action {
        Action::Cross { sine, .. } | Action::SpecialPoint { sine, .. } => Some(sine.abs()),
        Action::Center(id) => centers::sine(construction, *id),
        _ => None,
    });
    match sines.fold(1.0, f64::min) < SINE {
        true => Err(Refusal::Crossing),
        false => Ok(()),
    }
}

/// Whether everything that is measured or laid off is long enough on paper, or zero.
fn is_long_enough(construction: &Construction, scales: &Scales) -> Result<(), Refusal> {
    for step in construction.steps_by_hand() {
        let (value, shortest) = match (step.action, step.plan) {
            (Action::Measure { value, .. }, _) => (value.abs(), SHORTEST),
            (Action::LayOff(arrow), Some(plan)) => {
                let segment = plan.segment(&arrow.from, &arrow.to).ok_or(Refusal::NoConstruction)?;
                (segment.norm(), SHORTEST_LAID_OFF)
            }
            (action, Some(plan)) => match action.image() {
                Some(point) => (plan.points[point].vector.norm(), SHORTEST),
                None => continue,
            },
            _ => continue,
        };
        let sizes = step.plan.into_iter().flat_map(|plan| plan.points.values()).map(|point| point.vector.norm());
        let largest = sizes.reduce(f64::max).unwrap_or(value);
        let mm = value / scales[step.sheet].ok_or(Refusal::Sheet)?;
        if mm < shortest && value > ZERO * largest {
            return Err(Refusal::Short);
        }
    }
    Ok(())
}
