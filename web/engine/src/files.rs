use crate::answers::Pane;
use crate::desk::{Desk, Kept};
use crate::refused::Refused;
use kinegon::construction::Tolerance;
use kinegon::cycle::{Curves, Drive, Hodographs, Path, PointPaths, Sweep, says};
use kinegon::drawing::{self, Drawing, Point, curves, drive_ends, hodograph_ways, hodographs, path_ways, paths};
use kinegon::format;
use kinegon::quantity::step_pencil;
use kinegon::scene::{LanguageName, SizeLimit};
use kinegon::words::{Language, Wording};
use kinegon::{Error, Order, Problem};
use serde::{Deserialize, Serialize};

/// Most numbers of a table: more do not fit into a page's memory.
const MOST_NUMBERS: usize = 10_000_000;

/// A file as the program writes it.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct FileRequest {
    /// What kind of file.
    pub format: Format,
    /// What is drawn.
    pub of: Subject,
}

/// A kind of file: `outlines` is SVG without letters, for a canvas that makes a PNG of it; `csv` is the table of the motion, `json` the result, `steps` the text of the construction.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Format {
    Svg,
    Outlines,
    Pdf,
    Tikz,
    Csv,
    Json,
    Steps,
}

/// What is drawn.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Subject {
    /// The figure, or its work sheet.
    Sheet(SheetName),
    /// A sheet of the work sheet.
    Worksheet {
        /// Counted from 1; a table without room beside the panels is on the second.
        worksheet: usize,
    },
    /// The sheet after a step.
    Step {
        /// Counted from 1.
        step: usize,
    },
    /// The sheet after the steps that a lecturer shows together.
    Passage {
        /// Counted from 1.
        passage: usize,
    },
    /// What is drawn over the cycle.
    Cycle(OverCycle),
}

/// A sheet.
#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum SheetName {
    Figure,
    Worksheet,
}

/// What is drawn over the cycle of the first drive, by names of quantities, points, vectors.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum OverCycle {
    /// Quantities over the drive.
    Curves {
        /// Their names; without any those that the scene wants, or all ω.
        curves: Vec<String>,
    },
    /// Paths of points.
    Path {
        /// Their names.
        path: Vec<String>,
        /// Whether the paths go on beyond limits of the drive.
        #[serde(default)]
        #[cfg_attr(feature = "types", schemars(skip_serializing_if = "std::ops::Not::not"))]
        beyond_limits: bool,
    },
    /// Ways of the tips of vectors.
    Hodograph {
        /// Their names.
        hodograph: Vec<String>,
    },
}

/// What is drawn over the cycle.
struct Course {
    sheet: Drawing,
    /// What happens on the way.
    events: Vec<String>,
    /// The values of the drive at the edges of graphs over it.
    ends: Option<[f64; 2]>,
    /// Where on the sheet points and tips go with the drive.
    ways: Vec<Vec<(f64, Point)>>,
}

/// Places of a way closer than this are left out, in mm: between the others they are on a straight line.
const APART: f64 = 0.2;

/// The places of a way as a page has them.
fn thinned(way: &[(f64, Point)]) -> Vec<[f64; 3]> {
    let mut kept: Vec<&(f64, Point)> = Vec::new();
    for (index, place) in way.iter().enumerate() {
        let is_far = kept.last().is_none_or(|last| last.1.distance(place.1) >= APART);
        if is_far || index + 1 == way.len() {
            kept.push(place);
        }
    }
    let hundredths = |mm: f64| (100.0 * mm).round() / 100.0;
    kept.into_iter().map(|(value, at)| [*value, hundredths(at.x), hundredths(at.y)]).collect()
}

/// What can be drawn over the cycle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "Curves"))]
pub struct Drawn {
    /// The sheet.
    pub svg: String,
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// Extreme positions, change points, limits, in words.
    pub events: Vec<String>,
    /// The axis of the drive; none where nothing is drawn over it.
    pub axis: Option<DriveAxis>,
    /// Ways of points and of tips of vectors, in pieces without a gap: the drive's value, x and y in mm.
    pub ways: Vec<Vec<[f64; 3]>>,
}

/// Where the values of the drive are in graphs one above the other.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct DriveAxis {
    /// The value at the left edge of the graphs, in degrees or units of length.
    pub low: f64,
    /// At the right edge.
    pub high: f64,
    /// The graphs: [x, y, width, height] in mm.
    pub areas: Vec<[f64; 4]>,
}

impl Desk {
    /// A file with the bytes that the program writes.
    pub fn file(&mut self, text: &str, FileRequest { format, of }: &FileRequest) -> Result<Vec<u8>, Refused> {
        let kept = self.kept(text)?;
        match format {
            Format::Csv => kept.table(of).map(String::into_bytes),
            Format::Json => {
                let solution = kept.solution(Order::Acceleration)?;
                let result = solution.whole_result().map_err(|error| Refused::of(text, error))?;
                Ok(format::json(&result).into_bytes())
            }
            Format::Steps => {
                kept.check(SizeLimit::HAND)?;
                let solution = kept.solution(Order::Acceleration)?;
                let pencil = step_pencil(solution, Tolerance::default()).map_err(|error| Refused::of(text, error))?;
                Ok(solution.steps(&pencil).into_bytes())
            }
            Format::Svg | Format::Outlines | Format::Pdf | Format::Tikz => {
                let sheets = kept.sheets(of)?;
                let number = if let Subject::Worksheet { worksheet } = of { *worksheet } else { 1 };
                let sheet = number.checked_sub(1).and_then(|index| sheets.get(index));
                let none = || Refused::whole(drawing::says::no_sheet(number, sheets.len()));
                bytes(sheet.ok_or_else(none)?, *format)
            }
        }
    }

    /// How many sheets of paper a drawing takes.
    pub fn pages(&mut self, text: &str, of: &Subject) -> Result<usize, Refused> {
        self.kept(text)?.sheets(of).map(|sheets| sheets.len())
    }

    /// What is drawn over the cycle, on the scene's page or on a part of the screen.
    pub fn curves(&mut self, text: &str, of: &OverCycle, pane: Option<Pane>) -> Result<Drawn, Refused> {
        let (kept, language) = self.kept_with_language(text)?;
        let Course { sheet, events, ends, ways } =
            kept.over_cycle(of, pane.map(Into::into), language).map_err(|error| kept.refused(error))?;
        let areas = sheet.panels.iter().map(|(_, area)| [area.x0, area.y0, area.width(), area.height()]);
        let axis = ends.map(|[low, high]| DriveAxis { low, high, areas: areas.collect() });
        let ways = ways.iter().map(|way| thinned(way)).collect();
        Ok(Drawn { svg: sheet.svg(), width: sheet.width, height: sheet.height, events, axis, ways })
    }
}

fn bytes(sheet: &Drawing, format: Format) -> Result<Vec<u8>, Refused> {
    match format {
        Format::Outlines => Ok(format::svg_with(sheet, format::Text::Outlines).into_bytes()),
        Format::Pdf => sheet.pdf().map_err(|error| Refused::whole(error.to_string())),
        Format::Tikz => Ok(sheet.tikz().into_bytes()),
        _ => Ok(sheet.svg().into_bytes()),
    }
}

impl Kept {
    /// The sheets of a drawing.
    fn sheets(&mut self, of: &Subject) -> Result<Vec<Drawing>, Refused> {
        let own_step = self.scene.figure.step;
        match of {
            Subject::Cycle(of) => {
                let course = self.over_cycle(of, None, None).map_err(|error| self.refused(error))?;
                Ok(vec![course.sheet])
            }
            Subject::Sheet(SheetName::Figure) => match own_step {
                Some(step) => self.after(step, false),
                None => Ok(self.figure()?.sheets()),
            },
            Subject::Sheet(SheetName::Worksheet) | Subject::Worksheet { .. } => {
                let mut solution = self.figure()?.clone();
                solution.scene.figure.worksheet = true;
                Ok(solution.sheets())
            }
            Subject::Step { step } => self.after(*step, false),
            Subject::Passage { passage } => self.after(*passage, true),
        }
    }

    /// The sheet after a step or a passage.
    fn after(&mut self, step: usize, is_coarse: bool) -> Result<Vec<Drawing>, Refused> {
        self.check(SizeLimit::STEPS)?;
        let solution = self.figure()?;
        let all = if is_coarse { solution.coarse_figure() } else { solution.stepwise_figure() };
        let count = all.steps.len();
        if !(1..=count).contains(&step) {
            return Err(Refused::whole(drawing::says::no_step(step, count)));
        }
        Ok(vec![all.after_step(step)])
    }

    /// The whole motion of the first drive.
    fn path(&self) -> Result<(Path<'_>, [f64; 2]), Error> {
        let drive = Drive::new(&self.mechanism, None)?;
        let mut path = Path::new(&self.mechanism, &self.pose, drive)?;
        let range = path.cover(None, None)?;
        Ok((path, range))
    }

    /// The table of the motion: of the quantities that are named, else of those that the scene wants, else of all.
    fn table(&self, of: &Subject) -> Result<String, Refused> {
        let names = match of {
            Subject::Cycle(OverCycle::Curves { curves }) if !curves.is_empty() => Some(curves.as_slice()),
            _ => self.scene.want.as_deref(),
        };
        let refused = |error: Error| self.refused(error);
        let (path, range) = self.path().map_err(refused)?;
        let steps = path.rows(range, path.usual_step(range)).map_err(|error| refused(error.into()))?;
        let sweep = Sweep::new(&path, steps, names).map_err(|error| refused(error.into()))?;
        let count = sweep.steps.count();
        if count.saturating_mul(sweep.header().len()) > MOST_NUMBERS {
            let message = says::table_too_long(count, sweep.header().len());
            return Err(Refused::whole(Problem::new(message).hint(says::sweep_or_fewer())));
        }
        let columns = format::columns_of(&sweep);
        Ok(format::csv_header(&columns) + &format::csv_rows(&columns, &sweep.rows(0..count)))
    }

    /// What is drawn over the cycle, on the scene's page or on a part of a screen; what is told beside it in a language, if one is
    /// given.
    fn over_cycle(
        &self,
        of: &OverCycle,
        pane: Option<drawing::Pane>,
        language: Option<LanguageName>,
    ) -> Result<Course, Error> {
        let scene = &self.scene;
        let (mut path, range) = self.path()?;
        let range = path.shown_range(range);
        let (mut ends, mut ways) = (None, Vec::new());
        let sheet = match of {
            OverCycle::Curves { curves: names } => {
                let names = if names.is_empty() { scene.want.as_deref() } else { Some(names.as_slice()) };
                let sampled = Curves::new(&path, range, names)?;
                ends = Some(drive_ends(scene, &sampled));
                curves(scene, &sampled, pane)
            }
            OverCycle::Path { path: points, beyond_limits } => {
                scene.check_traced(points, None)?;
                let sampled = PointPaths::new(&path, range, points)?;
                let sampled = if *beyond_limits { sampled.beyond_limits()? } else { sampled };
                ways = path_ways(scene, &sampled, pane);
                paths(scene, &sampled, pane)
            }
            OverCycle::Hodograph { hodograph } => {
                let sampled = Hodographs::new(&path, range, hodograph)?;
                ways = hodograph_ways(scene, &sampled, pane);
                hodographs(scene, &sampled, pane)
            }
        };
        let mut words = Wording::of(&scene.figure);
        words.language = language.map_or(words.language, Language::of);
        let events = path.happenings(range, &words).into_iter().chain(path.limits(None, &words)).collect();
        Ok(Course { sheet: sheet?, events, ends, ways })
    }
}
