//! Films of `kinegon draw`.

#[cfg(feature = "png")]
use super::figures::GivenStyle;
#[cfg(feature = "png")]
use super::message::{Failure, Source, note, warn};
use crate::drawing::Timing;
use clap::Args;
#[cfg(feature = "png")]
use {
    super::pieces::progress,
    crate::construction::Solution,
    crate::drawing::{Drawing, Film},
    crate::format::FilmFormat,
    indexmap::IndexMap,
};

/// How a film runs.
#[derive(Debug, Args)]
pub(super) struct FilmOptions {
    /// Seconds that a turn of the drive takes in a film; of a drive that cannot turn, to and fro once.
    #[arg(long, value_name = "S", default_value_t = Timing::default().seconds, allow_negative_numbers = true)]
    seconds: f64,
    /// Pictures of a film in a second.
    #[arg(long = "fps", value_name = "N", default_value_t = Timing::default().per_second)]
    per_second: u16,
    /// The drive that a film follows, if not the first; others run along in proportion to their speeds.
    #[arg(long, value_name = "NAME")]
    pub drive: Option<String>,
}

#[cfg(feature = "png")]
impl FilmOptions {
    /// The film of a solution's figure as a file of so many dots per inch.
    pub(super) fn file(
        &self,
        source: &Source,
        solution: &Solution,
        style: &GivenStyle,
        format: FilmFormat,
        dpi: f64,
    ) -> Result<Vec<u8>, Failure> {
        let timing = Timing { seconds: self.seconds, per_second: self.per_second };
        let film = source.checked(Film::new(solution, self.drive.as_deref(), timing))?;
        let film = match style {
            GivenStyle::File(style) => film.in_style(style.clone()),
            GivenStyle::Scene | GivenStyle::Named(_) => film,
        };
        let running = film.running();
        match running.turns {
            None => {
                note("the drive goes to and fro; the plans are those for its speed in the scene, also on the way back")
            }
            Some(1) => {}
            Some(turns) => note(&format!("the mechanism is where it began after {turns} turns of the drive")),
        }
        let count = running.poses.len();
        let bar = progress(count as u64, Some("pictures"));
        let mut lacks = Lacks::default();
        let file = film.file(format, dpi, |drawing| {
            lacks.add(&film, drawing);
            bar.inc(1);
        });
        bar.finish_and_clear();
        lacks.tell(count);
        file.map_err(Failure::unclear)
    }
}

/// What pictures do not show: by panel in how many of them something is cut off, and in how many there is no room for all names.
#[cfg(feature = "png")]
#[derive(Default)]
struct Lacks {
    cut: IndexMap<String, usize>,
    names: IndexMap<String, usize>,
}

#[cfg(feature = "png")]
impl Lacks {
    fn add(&mut self, film: &Film, drawing: &Drawing) {
        for panel in film.layout().panels(drawing).into_iter().filter(|panel| panel.is_cut) {
            *self.cut.entry(panel.name).or_default() += 1;
        }
        for unlabelled in &drawing.unlabelled {
            *self.names.entry(unlabelled.panel.clone()).or_default() += 1;
        }
    }

    fn tell(&self, count: usize) {
        for (panel, pictures) in &self.cut {
            note(&format!("{panel}: cut off at the edge in {pictures} of {count} pictures"));
        }
        for (panel, pictures) in &self.names {
            warn(&format!(
                "{panel}: no room for all names in {pictures} of {count} pictures; a larger page has room for more"
            ));
        }
    }
}
