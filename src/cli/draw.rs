use super::figures::{Figures, stem};
use super::files::{self, Source};
use super::message::Failure;
use super::work::{Mode, Work, work};
use crate::drawing::{Drawing, figure, stepwise};
use crate::motion::Order;
use crate::scene::{Panel, Scene};
use clap::Args;
use std::path::PathBuf;

/// The two figures of Quintero et al. (2011), drawn when no scene is named.
const PAPER: [(&str, &str); 2] = [
    ("figure-1", include_str!("../../examples/figure-1.json")),
    ("figure-2", include_str!("../../examples/figure-2.json")),
];

/// Draw the figure of a scene.
#[derive(Debug, Args)]
pub(super) struct Draw {
    /// Scene file, `-` for stdin; without one the two figures of Quintero et al. (2011).
    scene: Option<PathBuf>,
    /// Write a sheet for each step of the construction: figure-01, figure-02 …
    #[arg(long, conflicts_with_all = ["upto", "layered"])]
    steps: bool,
    /// Write the sheet as it stands after this step alone.
    #[arg(long, value_name = "N", conflicts_with = "layered")]
    upto: Option<usize>,
    /// Write one SVG whose groups `step-01`, `step-02` … a slide program can reveal one after another.
    #[arg(long)]
    layered: bool,
    #[command(flatten)]
    figures: Figures,
    #[command(flatten)]
    mode: Mode,
}

impl Draw {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let scenes = match &self.scene {
            Some(path) => vec![(stem(path), files::read(path)?)],
            None => PAPER
                .map(|(name, text)| {
                    let source = Source {
                        name: format!("{name}.json"),
                        text: text.to_owned(),
                    };
                    (name.to_owned(), source)
                })
                .to_vec(),
        };
        let mut drawings = Vec::new();
        for (name, source) in scenes {
            let work = work(&source, self.mode.number, needed)?;
            work.warn();
            self.sheets(name, &work, &mut drawings)?;
        }
        if self.layered {
            return self.figures.write_layered(self.scene.as_deref(), &drawings);
        }
        self.figures.write(self.scene.as_deref(), &drawings)
    }

    /// The figure, or those of its steps that were asked for, under names of their own.
    fn sheets(
        &self,
        name: String,
        work: &Work,
        drawings: &mut Vec<(String, Drawing)>,
    ) -> Result<(), Failure> {
        let (scene, mechanism, pose) = (&work.scene, &work.mechanism, &work.pose);
        let wanted = match (self.steps, self.upto) {
            (false, None) => {
                let name = if self.layered {
                    format!("{name}-layered")
                } else {
                    name
                };
                let drawing = figure(scene, mechanism, pose, &work.construction);
                drawings.push((name, drawing));
                return Ok(());
            }
            (_, upto) => upto,
        };
        let all = stepwise(scene, mechanism, pose, &work.construction);
        let count = all.steps.len();
        let digits = count.to_string().len().max(2);
        let (first, last) = match wanted {
            Some(step) if (1..=count).contains(&step) => (step, step),
            Some(step) => {
                return Err(Failure::Misuse(
                    format!("there is no step {step}"),
                    Some(format!(
                        "the construction has steps 1 to {count}; `kinegon steps` lists them"
                    )),
                ));
            }
            None => (1, count),
        };
        let sheets =
            (first..=last).map(|step| (format!("{name}-{step:0digits$}"), all.after_step(step)));
        drawings.extend(sheets);
        Ok(())
    }
}

/// Accelerations only for a figure that shows them.
fn needed(scene: &Scene) -> Order {
    if scene.figure.panels.contains(&Panel::Acceleration) {
        Order::Acceleration
    } else {
        Order::Velocity
    }
}
