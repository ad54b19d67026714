//! The motion of a scene while a drive moves, as a table or as curves.

use super::figures::{Figures, Made, OfScene, Sheets, stem};
use super::files;
use super::message::{Failure, Source, note, refuse, warn};
use super::options::{Paper, Words};
use super::output::FileSet;
use super::solve::{Mode, read};
use super::table::{self, TableFormat};
use crate::Problem;
use crate::cycle::{Curves, Drive, Hodographs, Path as Branch, PointPaths, Steps, Sweep, alone};
use crate::drawing::{curves, hodographs, paths};
use crate::mechanism::{Body, Mechanism, Role};
use crate::position::Pose;
use crate::scene::{Scene, SizeLimit};
use crate::words::{Medium, Wording};
use clap::Args;
use std::path::PathBuf;

/// Most extreme and change points that are listed.
const NOTES: usize = 30;

const SWEEP_HELP: &str = "\
The motion is followed from the scene's own position, without a jump to another assembly mode. The table keeps what can be \
reached: if a limit position comes before the end of the range, that is said and the exit code is 1. Cells without a number, \
as at a change point, are empty (null in JSON lines).

Examples:
  kinegon sweep scene.json --step 5                        every 5 degrees
  kinegon sweep scene.json --from 0 --to 180 -o half.csv   half a turn
  kinegon sweep scene.json --want \"omega(3), v(C).size\"   two quantities only";

#[derive(Debug, Args)]
#[command(after_help = SWEEP_HELP)]
pub(super) struct SweepCommand {
    #[command(flatten)]
    range: Range,
    /// Distance from one row to the next, in degrees or lengths; without it 1°, or about a two-hundredth of a slider's
    /// range.
    #[arg(long, allow_hyphen_values = true)]
    step: Option<f64>,
    /// Add a column behind each quantity with the bound of its error, as omega(4)_error; of a vector it holds for each
    /// component.
    #[arg(long)]
    errors: bool,
    /// File to write, or `-` for stdout.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// Form of the table; without it that of the file's ending, else CSV.
    #[arg(long, value_enum)]
    format: Option<TableFormat>,
    /// Write a table of more than 1 GB, too.
    #[arg(long)]
    yes: bool,
}

/// Which motion of which scene.
#[derive(Debug, Args)]
struct Range {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    /// First value of the drive: an angle in degrees, or a slider's position along its guide. With neither --from nor
    /// --to: once around, or from end to end.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last value of the drive; may be less than the first. Without --from the first is that of the scene.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<f64>,
    /// The drive that moves, if not the first: a driven link, or a slider on a moving link such as 3/2; other drives
    /// run along in proportion to their speeds.
    #[arg(long)]
    drive: Option<String>,
    /// Other drives stand still.
    #[arg(long)]
    alone: bool,
    /// Quantities by name, as in "omega(4), v_r(3/2), L(B,S3)"; without it those that the scene wants, else all;
    /// of curves, ω of all links that follow.
    #[arg(long)]
    want: Vec<String>,
    #[command(flatten)]
    mode: Mode,
}

/// A scene in its own position, and the drive that is to move it.
struct DrivenScene {
    source: Source,
    scene: Scene,
    mechanism: Mechanism,
    pose: Pose,
    drive: Drive,
    /// Names of the quantities asked for; `None` for all.
    names: Option<Vec<String>>,
}

impl Range {
    /// Reads the scene, finds its position and the drive.
    fn driven_scene(&self) -> Result<DrivenScene, Failure> {
        let source = files::read(&self.scene)?;
        let (scene, mechanism, pose) = read(&source, SizeLimit::NUMBERS, self.mode.number)?;
        let language = Wording::of(&scene.figure).language;
        mechanism.warnings.iter().chain(&pose.warnings).for_each(|warning| warn(&language.says(warning)));
        let drive = source.checked(Drive::new(&mechanism, self.drive.as_deref()))?;
        let speeds_up = |body: &Body| matches!(body.role, Role::Driver { alpha, .. } if alpha != 0.0);
        if mechanism.bodies.iter().any(speeds_up) {
            note(language.rates_of_every_position());
        }
        let mechanism = if self.alone { alone(&mechanism, &drive.name) } else { mechanism };
        let names = split_names(&self.want);
        let names = if names.is_empty() { scene.want.clone() } else { Some(names) };
        Ok(DrivenScene { source, scene, mechanism, pose, drive, names })
    }

    /// Whether one end of the range is given.
    fn is_given(&self) -> bool {
        self.from.is_some() || self.to.is_some()
    }

    /// Notes the extreme and change points of the branch within `range`, and its limit positions, in the words of the
    /// scene's figure. `product` is what is made.
    ///
    /// # Errors
    /// [`Failure::Outside`] if a given range goes beyond a limit position.
    fn report_events(&self, branch: &Branch, range: [f64; 2], words: &Wording, product: &str) -> Result<(), Failure> {
        let events = branch.happenings(range, words);
        events.iter().take(NOTES).for_each(|event| note(event));
        if events.len() > NOTES {
            note(&words.language.events_left_out(&(events.len() - NOTES).to_string()));
        }
        let beyond = |value: f64| !(branch.low()..=branch.high()).contains(&value);
        let ends = |words: &Wording| branch.limits(self.is_given().then_some(range), words);
        if self.is_given() && range.into_iter().any(beyond) {
            let [from, to] = range.map(|v| branch.drive.amount(v));
            let stops = ends(&Wording::default()).join("; ");
            let message = format!(
                "only a part of the range from {from} to {to} can be reached, and only it is in the {product}: {stops}"
            );
            return Err(Failure::Outside(match other_way_round(branch, range) {
                Some(Problem { message: detour, hint }) => {
                    Problem { message: format!("{message}; {detour}").into(), hint }
                }
                None => message.into(),
            }));
        }
        ends(words).iter().for_each(|end| note(end));
        branch.told_engagement(words, Medium::Text).iter().for_each(|said| note(said));
        Ok(())
    }
}

/// What of a range beyond a limit can be reached the other way round, and what to type for it.
fn other_way_round(branch: &Branch, range: [f64; 2]) -> Option<Problem> {
    let detour = branch.other_way_round(range)?;
    let named = |ends: [f64; 2]| ends.map(|v| branch.drive.amount(v)).join(" to ");
    // Whole degrees inside the limits.
    let [low, high] = [detour.both[0].ceil() + 0.0, detour.both[1].floor() + 0.0];
    let way = format!("from {} the drive gets the other way round, as {}", named(detour.asked), named(detour.part));
    let hint = format!("--from {low} --to {high}, or neither of them for the whole way between the limits");
    Some(Problem::new(way).hint(hint))
}

impl DrivenScene {
    /// The branch, followed over the range that is asked for, and that range in units of the drive.
    fn follow(&self, range: &Range) -> Result<(Branch<'_>, [f64; 2]), Failure> {
        let mut branch = self.source.checked(Branch::new(&self.mechanism, &self.pose, self.drive.clone()))?;
        let covered = self.source.checked(branch.cover(range.from, range.to))?;
        Ok((branch, covered))
    }
}

/// The names in lists separated by commas; commas within parentheses belong to names.
pub(super) fn split_names(lists: &[String]) -> Vec<String> {
    let names = lists.iter().flat_map(|list| {
        let mut depth = 0;
        list.split(move |c: char| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            c == ',' && depth == 0
        })
    });
    names.map(|n| n.trim().to_owned()).filter(|n| !n.is_empty()).collect()
}

/// Refuses an option that is given and names nothing, as `--path ","`.
pub(super) fn refuse_nothing(option: &str, given: &[String], names: &[String]) -> Result<(), Failure> {
    match names.is_empty() && !given.is_empty() {
        true => refuse(format!("{option} names nothing"), "leave it out, or write names as \"B, C\""),
        false => Ok(()),
    }
}

impl SweepCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let format = TableFormat::of(self.format, &self.output, "table", |_| true)?;
        let driven = self.range.driven_scene()?;
        let (branch, [from, to]) = driven.follow(&self.range)?;
        let step = self.step.unwrap_or_else(|| branch.usual_step([from, to]));
        let steps = if self.range.is_given() { Steps::new(from, to, step) } else { branch.rows([from, to], step) };
        let steps = driven.source.checked(steps)?;
        let sweep = driven.source.checked(Sweep::new(&branch, steps, driven.names.as_deref()))?;
        let sweep = if self.errors { sweep.with_errors(&driven.scene) } else { sweep };
        files::refuse_overwriting("scene", &self.range.scene, &self.output)?;
        if !self.yes {
            table::refuse_huge(&sweep, format)?;
        }
        table::write(&sweep, format, &self.output)?;
        self.range.report_events(&branch, [from, to], &Wording::of(&driven.scene.figure), "table")
    }
}

const CURVES_HELP: &str = "\
Examples:
  kinegon curves scene.json                                 ω of all links
  kinegon curves scene.json --want \"omega(3), a(C).size\" -o curves.pdf
  kinegon curves scene.json --hodograph \"v(C)\" -o tips.svg  tips of a vector
  kinegon curves scene.json --path C -o path.svg            path of a point";

#[derive(Debug, Args)]
#[command(after_help = CURVES_HELP)]
pub(super) struct CurvesCommand {
    #[command(flatten)]
    range: Range,
    /// Draw the way of vectors' tips from a pole in place of curves: as "v(D), a(D)".
    #[arg(long, value_name = "VECTORS", conflicts_with = "want")]
    hodograph: Vec<String>,
    /// Draw the paths of points in place of curves, y over x to one scale: as "F, M".
    #[arg(long, value_name = "POINTS", conflicts_with_all = ["want", "hodograph"])]
    path: Vec<String>,
    /// Let the paths go on beyond limits of the drive, dashed, in other assembly modes.
    #[arg(long, requires = "path", conflicts_with_all = ["from", "to"])]
    beyond_limits: bool,
    #[command(flatten)]
    figures: Figures,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    paper: Paper,
}

impl CurvesCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let mut driven = self.range.driven_scene()?;
        self.words.put_into(&mut driven.scene.figure);
        driven.scene.check_frame().map_err(|error| Failure::of_option("--frame", error))?;
        self.paper.put_into(&mut driven.scene.figure);
        let style = self.figures.style()?;
        style.put_into(&mut driven.scene.figure);
        let (mut branch, mut range) = driven.follow(&self.range)?;
        if !self.range.is_given() {
            range = branch.shown_range(range);
        }
        let scene = &self.range.scene;
        let (points, vectors) = (split_names(&self.path), split_names(&self.hodograph));
        refuse_nothing("--path", &self.path, &points)?;
        refuse_nothing("--hodograph", &self.hodograph, &vectors)?;
        let (kind, drawing) = if !points.is_empty() {
            let traced = driven.scene.check_traced(&points, None);
            traced.map_err(|error| Failure::of_option("--path", error))?;
            let sampled = PointPaths::new(&branch, range, &points);
            let sampled = if self.beyond_limits { sampled.and_then(PointPaths::beyond_limits) } else { sampled };
            let sampled = driven.source.checked(sampled)?;
            ("path", paths(&driven.scene, &sampled, None))
        } else if self.hodograph.is_empty() {
            let sampled = driven.source.checked(Curves::new(&branch, range, driven.names.as_deref()))?;
            ("curves", curves(&driven.scene, &sampled, None))
        } else {
            let sampled = driven.source.checked(Hodographs::new(&branch, range, &vectors))?;
            ("hodograph", hodographs(&driven.scene, &sampled, None))
        };
        let mut drawing = driven.source.checked(drawing)?;
        style.put_on([&mut drawing]);
        let name = format!("{}-{kind}", stem(scene));
        let of_scene = |_, made| match made {
            OfScene::Page => refuse("curves have no page", "`kinegon draw --format html` makes one of the figure"),
            #[cfg(feature = "png")]
            OfScene::Film(_) => refuse("curves do not move", "`kinegon draw` makes a film of the figure"),
        };
        let mut files = FileSet::default();
        self.figures.write(
            &mut files,
            &[("scene", scene)],
            vec![(name, Made::Sheets(vec![drawing]))],
            Sheets::Apart,
            of_scene,
        )?;
        files.finish()?;
        self.range.report_events(&branch, range, &Wording::of(&driven.scene.figure), "figure")
    }
}
