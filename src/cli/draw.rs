use super::figures::{Figures, stem};
use super::files::{self, Source};
use super::message::Failure;
use super::work::{Mode, work};
use crate::drawing::figure;
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
            let drawing = figure(&work.scene, &work.mechanism, &work.pose, &work.construction);
            drawings.push((name, drawing));
        }
        self.figures.write(self.scene.as_deref(), &drawings)
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
