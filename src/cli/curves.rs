use super::figures::{Figures, stem};
use super::message::Failure;
use super::options::{Paper, Words};
use super::output::FileSet;
use super::sweep::{Range, refuse_nothing, split_names};
use crate::cycle::{Curves, Hodographs, PointPaths};
use crate::drawing::{curves, hodographs, paths};
use crate::words::Wording;
use clap::Args;

const AFTER_HELP: &str = "\
Examples:
  kinegon curves scene.json                                 ω of all links
  kinegon curves scene.json --want \"omega(3), a(C).size\" -o curves.pdf
  kinegon curves scene.json --hodograph \"v(C)\" -o tips.svg  tips of a vector
  kinegon curves scene.json --path C -o path.svg            path of a point";

/// Draw quantities over the motion while a drive moves, along the branch of the scene's own position.
///
/// Greatest and least values, dead centres and limits are marked; a quantity that is a vector is drawn as its size, or
/// `.x` and `.y`. The figure keeps what can be reached; where the range goes beyond a limit position, that is said and
/// the exit code is 1.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
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
        self.paper.put_into(&mut driven.scene.figure);
        let style = self.figures.style()?;
        style.put_into(&mut driven.scene.figure);
        let (mut branch, mut range) = driven.follow(&self.range)?;
        if !self.range.is_given() {
            range = branch.shown_range(range);
        }
        let scene = &self.range.scene;
        let vectors: Vec<String> = self.hodograph.iter().flat_map(|text| split_names(text)).collect();
        let points: Vec<String> = self.path.iter().flat_map(|text| split_names(text)).collect();
        for (option, given, names) in [("--path", &self.path, &points), ("--hodograph", &self.hodograph, &vectors)] {
            refuse_nothing(option, given, names)?;
        }
        let (kind, drawing) = if !points.is_empty() {
            let traced = driven.scene.check_traced(&points, None);
            traced.map_err(|error| Failure::of_option("--path", error))?;
            let sampled = PointPaths::new(&branch, range, &points);
            let sampled = if self.beyond_limits { sampled.and_then(PointPaths::beyond_limits) } else { sampled };
            let sampled = sampled.map_err(|error| driven.fail(error))?;
            ("path", paths(&driven.scene, &sampled))
        } else if self.hodograph.is_empty() {
            let sampled = Curves::new(&branch, range, driven.names.as_deref()).map_err(|error| driven.fail(error))?;
            ("curves", curves(&driven.scene, &sampled))
        } else {
            let sampled = Hodographs::new(&branch, range, &vectors).map_err(|error| driven.fail(error))?;
            ("hodograph", hodographs(&driven.scene, &sampled))
        };
        let mut drawing = drawing.map_err(|error| driven.fail(error))?;
        style.put_on([&mut drawing]);
        let name = format!("{}-{kind}", stem(scene));
        let page =
            |_| Err(Failure::misuse("curves have no page", "`kinegon draw --format html` makes one of the figure"));
        let mut files = FileSet::default();
        self.figures.write(&mut files, &[("scene", scene)], vec![(name, vec![drawing])], false, page)?;
        files.finish()?;
        self.range.report_events(&branch, range, &Wording::of(&driven.scene.figure), "figure")
    }
}
