use super::check::CheckWords;
use super::class::ClassWords;
use super::exercise::ExerciseWords;

/// The normal parts that are laid off together along a cut line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalParts {
    /// Of one link.
    One,
    /// Of both links.
    Both,
    /// Of one link, and the Coriolis part.
    WithCoriolis,
    /// The Coriolis part alone.
    Coriolis,
}

/// A sentence with one blank, or with more.
type With1 = fn(&str) -> String;
type With2 = fn(&str, &str) -> String;
type With3 = fn(&str, &str, &str) -> String;
type With4 = fn(&str, &str, &str, &str) -> String;
type With5 = fn(&str, &str, &str, &str, &str) -> String;

/// All sentences of a language. The comment of each names its blanks in order; names of points come in backticks, numbers written out.
///
/// A language may take sentences that it lacks from English: `..ENGLISH` at the end of its table.
#[derive(Clone, Copy, Debug)]
pub struct Language {
    /// Its code, as scenes and the command line write it.
    pub code: &'static str,

    // Names of lines.
    /// The guide of a slider.
    pub guide_of: With1,
    /// A cut line: guide's slider, point that it goes through.
    pub normal_to_guide: With2,
    /// The line on which all directions meet.
    pub line_at_infinity: &'static str,

    // What a step says to do.
    /// Pole, scale.
    pub choose_pole: With2,
    /// Pole, scale, images of points at rest.
    pub choose_pole_with: With3,
    /// Point, link, two cut lines.
    pub special_point: With4,
    /// Point, link, direction in degrees, two cut lines.
    pub special_point_at_infinity: With5,
    /// Two points of the mechanism.
    pub measure_length: With2,
    /// Point, arm that it is normal to, link.
    pub lay_off_velocity: With3,
    /// Point, pivot, link: of a link that turns uniformly.
    pub lay_off_normal_acceleration: With3,
    /// Point, pivot, arm.
    pub lay_off_whole_acceleration: With3,
    /// Vector.
    pub lay_off_given: With1,
    /// Body, point above.
    pub lay_off_point_under: With2,
    /// Point that it goes through, line, point that lies on it.
    pub ray_normal: With3,
    /// The same.
    pub ray_parallel: With3,
    /// Image.
    pub cross: With1,
    /// Two plan points.
    pub measure_segment: With2,
    /// Cut line, two plan points.
    pub lay_off_normal: fn(NormalParts, &str, &str, &str) -> String,
    /// Unknowns.
    pub solve: With1,
    /// Where there is none.
    pub no_construction: &'static str,
    /// Special points.
    pub no_construction_far: With1,
    /// Link, point, point that it is relative to, arm.
    pub lay_off_relative: With4,
    /// Slider, two plan points; whether it counts backwards.
    pub lay_off_sliding_velocity: fn(&str, bool, &str, &str) -> String,
    /// The same.
    pub lay_off_sliding_acceleration: fn(&str, bool, &str, &str) -> String,
    /// The same.
    pub lay_off_coriolis: fn(&str, bool, &str, &str) -> String,

    // Words of equations.
    /// Behind a vector.
    pub given: &'static str,
    /// Before the first of what a vector is made of.
    pub made_from: &'static str,
    /// Before the next.
    pub and: &'static str,
    /// Before the Coriolis part.
    pub coriolis_word: &'static str,
    /// Names of parts.
    pub normal: &'static str,
    /// Names of parts.
    pub tangential: &'static str,
    /// Names of parts.
    pub sliding: &'static str,
    /// Names of parts.
    pub coriolis: &'static str,

    // The figure.
    /// Its title where the scene has none.
    pub title: &'static str,
    /// Heading of a panel.
    pub scheme: &'static str,
    /// Heading of a panel.
    pub velocity_plan: &'static str,
    /// Heading of a panel.
    pub acceleration_plan: &'static str,
    /// Special point, distance, point that it is counted from.
    pub far_away: With3,
    /// Special point.
    pub at_infinity: With1,
    /// Difference, allowed difference.
    pub agreement: With2,
    /// Why there is only one route.
    pub one_route_far: &'static str,
    /// Why there is only one route.
    pub one_route: &'static str,
    /// Size, degrees.
    pub with_direction: With2,
    /// Above the names of measured segments.
    pub segment: &'static str,
    /// Above what they are worth.
    pub value: &'static str,
    /// Above the ruler of 50 mm that shows whether a sheet was printed at 100 %.
    pub ruler: &'static str,
    /// For those who cannot see it: panels, Assur groups.
    pub description: With2,
    /// A panel in that sentence.
    pub described_scheme: &'static str,
    /// A panel in that sentence.
    pub described_velocity_plan: &'static str,
    /// A panel in that sentence.
    pub described_acceleration_plan: &'static str,
    /// A group in that sentence: class, links.
    pub described_group: With2,
    /// The class of a group above the fourth.
    pub higher: &'static str,

    // Curves.
    /// Their title where the scene has none.
    pub curves: &'static str,
    /// Vector: the way of its tip over the cycle.
    pub hodograph: With1,
    /// Kinds of quantities.
    pub angle: &'static str,
    /// Kinds of quantities.
    pub angular_velocity: &'static str,
    /// Kinds of quantities.
    pub angular_acceleration: &'static str,
    /// Kinds of quantities.
    pub position: &'static str,
    /// Kinds of quantities.
    pub length: &'static str,
    /// Kinds of quantities.
    pub velocity: &'static str,
    /// Kinds of quantities.
    pub acceleration: &'static str,
    /// Kind, unit.
    pub in_unit: With2,
    /// What stands before and behind the symbol of the drive's angle.
    pub drive_angle: [&'static str; 2],
    /// Drive, unit.
    pub drive_position: With2,
    /// A vertical line.
    pub limit: &'static str,
    /// A vertical line.
    pub change: &'static str,
    /// A vertical line: where the scene stands.
    pub scene: &'static str,
    /// A mark.
    pub dead_position: &'static str,
    /// A mark.
    pub extremes: &'static str,
    /// For those who cannot see it: drive's quantity, first and last value.
    pub over: With3,
    /// Quantity, value.
    pub is_constant: With2,
    /// Value, drive's value.
    pub least: With2,
    /// The same.
    pub greatest: With2,
    /// Without a least value.
    pub no_least: &'static str,
    /// Without a greatest value.
    pub no_greatest: &'static str,

    // The text of the steps.
    /// Scales.
    pub scales: With1,
    /// Scale, value, unit.
    pub scale_per_mm: With3,
    /// Errors of a hand, in mm and degrees.
    pub bands: With2,
    /// Why a value has no band.
    pub no_band_no_construction: &'static str,
    /// Panel that is missing.
    pub no_band_no_sheet: With1,
    /// Heading.
    pub on_the_mechanism: &'static str,
    /// Difference, allowed difference.
    pub routes_differ: With2,
    /// Millimetres.
    pub on_paper: With1,
    /// Behind a band that is a rough one.
    pub only_roughly: &'static str,
    /// Degrees.
    pub direction: With1,
    /// Degrees.
    pub angle_of_crossing: With1,

    /// What stands on the buttons of a page.
    pub page: PageWords,

    /// The report on a student's values.
    pub check: &'static CheckWords,
    /// Marks, and what is said of a whole class.
    pub class: &'static ClassWords,
    /// The sheets of exercises.
    pub exercise: &'static ExerciseWords,
}

/// What stands on the buttons of a page for the classroom, or is read out for them; names of keys are in brackets.
#[derive(Clone, Copy, Debug)]
pub struct PageWords {
    /// The whole row of buttons.
    pub figure: &'static str,
    /// Which panels show.
    pub panels: &'static str,
    /// All panels.
    pub all: &'static str,
    /// The steps of the construction.
    pub steps: &'static str,
    /// To the first step.
    pub first: &'static str,
    /// A step back.
    pub back: &'static str,
    /// A step forward.
    pub forward: &'static str,
    /// To the finished figure.
    pub finished: &'static str,
    /// Behind the number of steps.
    pub count: &'static str,
    /// The motion.
    pub motion: &'static str,
    /// Sets it going.
    pub play: &'static str,
    /// Stops it.
    pub pause: &'static str,
    /// Back to the scene's own position.
    pub own: &'static str,
    /// How fast.
    pub speed: &'static str,
    /// Colours and paper.
    pub look: &'static str,
    /// Dark or light.
    pub dark: &'static str,
    /// Prints.
    pub print: &'static str,
    /// What printing does.
    pub to_scale: &'static str,
    /// Where scripts are off.
    pub no_script: &'static str,
    /// Where the browser is too old.
    pub too_old: &'static str,
}
