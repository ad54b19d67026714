use super::figures::{Figures, stem};
use super::message::Failure;
use super::paper::Paper;
use super::sweep::{Range, split_names};
use super::wording::Words;
use crate::cycle::{Curves, Hodographs};
use crate::drawing::{curves, hodographs};
use clap::Args;

/// Draw quantities over the motion while a drive moves, along the branch of the scene's own position.
///
/// Greatest and least values, dead centres and limits are marked; a quantity that is a vector is drawn as its size, or `.x` and `.y`.
/// The figure keeps what can be reached; where the range goes beyond a limit position, that is said and the exit code is 1.
#[derive(Debug, Args)]
pub(super) struct CurvesCommand {
    #[command(flatten)]
    range: Range,
    /// Draw the way of vectors' tips from a pole in place of curves: as "v(D), a(D)".
    #[arg(long, value_name = "VECTORS", conflicts_with = "want")]
    hodograph: Vec<String>,
    #[command(flatten)]
    figures: Figures,
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    paper: Paper,
}

impl CurvesCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let mut moved = self.range.moved()?;
        self.words.put_into(&mut moved.scene.figure);
        self.paper.put_into(&mut moved.scene.figure);
        let (mut branch, mut range) = moved.follow(&self.range)?;
        // A turn reads best from 0° to 360°.
        if !self.range.is_given() && branch.drive.is_angle() && branch.end(true).is_none() {
            let whole = 360.0 * (range[0] / 360.0).floor();
            branch.follow_to(whole);
            if branch.low() <= whole {
                range = [whole, whole + 360.0];
            }
        }
        let scene = &self.range.scene;
        let vectors = self.hodograph.iter().flat_map(|text| split_names(text));
        let vectors: Vec<String> = vectors.collect();
        let (kind, drawing) = if self.hodograph.is_empty() {
            let sampled = Curves::new(&branch, range, moved.names.as_deref());
            let sampled = sampled.map_err(|error| moved.fail(error))?;
            ("curves", curves(&moved.scene, &sampled))
        } else {
            let sampled = Hodographs::new(&branch, range, &vectors);
            let sampled = sampled.map_err(|error| moved.fail(error))?;
            ("hodograph", hodographs(&moved.scene, &sampled))
        };
        let drawing = drawing.map_err(|error| moved.fail(error))?;
        let name = format!("{}-{kind}", stem(scene));
        let page = |_| {
            Err(Failure::Misuse(
                "curves have no page".into(),
                Some("`kinegon draw --format html` makes one of the figure".into()),
            ))
        };
        self.figures.write(&[("scene", scene)], vec![(name, drawing)], page)?;
        self.range.tell(&branch, range, "figure")
    }
}
