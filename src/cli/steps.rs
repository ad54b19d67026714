use super::files;
use super::message::Failure;
use super::work::{Mode, work};
use crate::drawing::scales;
use crate::format;
use crate::motion::Order;
use clap::Args;
use std::path::PathBuf;

/// Print the construction of a scene.
#[derive(Debug, Args)]
pub(super) struct Steps {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
    #[command(flatten)]
    mode: Mode,
}

impl Steps {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let work = work(&source, self.mode.number, |_| Order::Acceleration)?;
        let scales = scales(&work.scene, &work.mechanism, &work.pose, &work.construction);
        let text = format::steps(&work.scene, &work.construction, &scales);
        work.warn();
        files::print(text.as_bytes())
    }
}
