use super::files;
use super::message::Failure;
use super::work::work;
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
    /// Assembly mode by its number in `kinegon modes`, in place of the one that `near` picks.
    #[arg(long)]
    mode: Option<usize>,
}

impl Steps {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let work = work(&source, self.mode, |_| Order::Acceleration)?;
        let scales = scales(&work.scene, &work.mechanism, &work.pose, &work.construction);
        let text = format::steps(&work.scene, &work.construction, &scales);
        work.warn();
        files::print(text.as_bytes())
    }
}
