//! Films of `kinegon draw`.

#[cfg(feature = "png")]
use super::figures::INCH;
#[cfg(feature = "png")]
use super::message::{Failure, Source, note, refuse, warn};
use crate::drawing::Timing;
use clap::Args;
#[cfg(feature = "png")]
use {
    super::pieces::progress,
    super::style::GivenStyle,
    crate::construction::Solution,
    crate::drawing::{Drawing, Film},
    crate::format::{FilmFormat, MOST_FILM_AREA},
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

/// Most work on a film that is done without asking, about two seconds of one core: pixels of its pictures, and for each point
/// whose names are placed so many more.
#[cfg(feature = "png")]
const MOST_WORK: f64 = 2.7e8;
#[cfg(feature = "png")]
const WORK_OF_POINT: f64 = 70_000.0;

#[cfg(feature = "png")]
impl FilmOptions {
    /// Refuses a film of very much work, before the first picture is drawn.
    pub(super) fn refuse_long(&self, source: &Source, solution: &Solution, dpi: f64) -> Result<(), Failure> {
        let pictures = source.checked(Film::positions(solution, self.drive.as_deref(), self.timing()))?.poses.len();
        let [width, height] = solution.scene.figure.page.size_mm().map(|side| side / INCH * dpi);
        let points = solution.mechanism.points.len();
        let of_each = width * height + WORK_OF_POINT * points as f64;
        // What is too large for a film is refused by it.
        if pictures as f64 * of_each <= MOST_WORK || width * height > MOST_FILM_AREA {
            return Ok(());
        }
        let [pixels, fits] = [width * height / 1e6, MOST_WORK / of_each];
        refuse(
            format!(
                "the film would have {pictures} pictures of {pixels:.1} million pixels, with {points} points each; \
                 {fits:.0} of them are drawn without asking"
            ),
            "take fewer pictures (--seconds, --fps) or smaller ones (--width, --dpi); with --yes it is written",
        )
    }

    fn timing(&self) -> Timing {
        Timing { seconds: self.seconds, per_second: self.per_second }
    }

    /// The film of a solution's figure as a file of so many dots per inch.
    pub(super) fn file(
        &self,
        source: &Source,
        solution: &Solution,
        style: &GivenStyle,
        format: FilmFormat,
        dpi: f64,
    ) -> Result<Vec<u8>, Failure> {
        let film = source.checked(Film::new(solution, self.drive.as_deref(), self.timing()))?;
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
