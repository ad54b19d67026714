use super::files;
use super::message::{Failure, note, refuse, warn};
use super::options::NamesAnd;
use super::output::{FileSet, is_stream};
use super::style::GivenStyle;
use crate::drawing::{Drawing, Unlabelled};
#[cfg(feature = "png")]
use crate::format::FilmFormat;
use crate::format::{self, Text};
use crate::scene::StyleName;
use clap::{Args, ValueEnum};
use indexmap::IndexSet;
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// How many names without room are listed.
const MOST_LISTED: usize = 20;

/// Millimetres in an inch.
#[cfg(feature = "png")]
pub(super) const INCH: f64 = 25.4;

/// Where figures go, and in which forms.
#[derive(Debug, Args)]
pub(super) struct Figures {
    /// Folder to write to, or a file whose ending gives the format, or `-` for stdout.
    #[arg(short, long, default_value = "out/")]
    pub output: PathBuf,
    #[command(flatten)]
    pub options: FigureOptions,
}

/// In which forms figures are written.
#[derive(Clone, Debug, Args)]
pub(super) struct FigureOptions {
    /// Formats to write into a folder, as svg,png, which are written if none is given; on stdout the one that is given, or SVG.
    #[arg(long, value_delimiter = ',', value_enum, default_values_t = FigureFormat::usual(), hide_default_value = true)]
    format: Vec<FigureFormat>,
    /// Write the letters of SVG as outlines, for programs that lack the font.
    #[arg(long)]
    outlines: bool,
    /// Drawing style in place of the scene's own: paper, print, lecture, board, or the path of a style file.
    #[arg(long, value_name = "NAME|FILE", value_parser = style_names(), hide_possible_values = true)]
    pub style: Option<String>,
    /// Resolution of PNG and films in dots per inch.
    #[arg(long, default_value_t = 100.0, value_parser = dots_per_inch)]
    dpi: f64,
    /// Width of PNG and films in pixels, in place of --dpi.
    #[arg(long, value_name = "PIXELS", conflicts_with = "dpi", value_parser = clap::value_parser!(u32).range(16..=20_000))]
    width: Option<u32>,
}

impl FigureOptions {
    /// The dots per inch of a sheet of that width in mm.
    #[cfg(feature = "png")]
    pub(super) fn dpi_of(&self, width: f64) -> f64 {
        self.width.map_or(self.dpi, |pixels| f64::from(pixels) * INCH / width)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FigureFormat {
    Svg,
    #[cfg(feature = "pdf")]
    Pdf,
    Tikz,
    #[cfg(feature = "png")]
    Png,
    /// The workbench with the scene open, to step through and to move.
    Html,
    /// A film of a turn of the drive, which all programs show.
    #[cfg(feature = "png")]
    Gif,
    /// The same in all colours, for browsers.
    #[cfg(feature = "png")]
    Apng,
}

/// What is made of a scene and not of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OfScene {
    Page,
    #[cfg(feature = "png")]
    Film(FilmFormat),
}

impl FigureFormat {
    /// The formats that are written if none is given.
    fn usual() -> Vec<FigureFormat> {
        vec![
            FigureFormat::Svg,
            #[cfg(feature = "png")]
            FigureFormat::Png,
        ]
    }

    fn ending(self) -> &'static str {
        match self {
            FigureFormat::Svg => "svg",
            #[cfg(feature = "pdf")]
            FigureFormat::Pdf => "pdf",
            FigureFormat::Tikz => "tex",
            #[cfg(feature = "png")]
            FigureFormat::Png => "png",
            FigureFormat::Html => "html",
            #[cfg(feature = "png")]
            FigureFormat::Gif => "gif",
            #[cfg(feature = "png")]
            FigureFormat::Apng => "apng",
        }
    }

    fn is_film(self) -> bool {
        self.of_scene().is_some_and(|made| made != OfScene::Page)
    }

    /// What it is made of a scene, if it is not made of sheets.
    fn of_scene(self) -> Option<OfScene> {
        match self {
            FigureFormat::Html => Some(OfScene::Page),
            #[cfg(feature = "png")]
            FigureFormat::Gif => Some(OfScene::Film(FilmFormat::Gif)),
            #[cfg(feature = "png")]
            FigureFormat::Apng => Some(OfScene::Film(FilmFormat::Apng)),
            _ => None,
        }
    }
}

/// Names of styles, or paths of style files.
pub(super) fn style_names() -> NamesAnd {
    NamesAnd(StyleName::ALL.map(StyleName::as_str).to_vec())
}

fn dots_per_inch(text: &str) -> Result<f64, String> {
    let dpi: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if (10.0..=2400.0).contains(&dpi) { Ok(dpi) } else { Err("must be from 10 to 2400".to_owned()) }
}

/// The sheets of a figure, to be written.
pub(super) enum Made {
    /// One after another.
    Sheets(Vec<Drawing>),
    /// The one after a step of a figure with all its steps. It is drawn when it is written: of a construction of many steps
    /// all would be as large as the square of their number.
    After(Rc<Drawing>, usize),
}

impl Made {
    /// How many they are.
    fn count(&self) -> usize {
        match self {
            Made::Sheets(sheets) => sheets.len(),
            Made::After(..) => 1,
        }
    }

    /// All of them.
    pub(super) fn sheets(&self) -> Cow<'_, [Drawing]> {
        match self {
            Made::Sheets(sheets) => Cow::Borrowed(sheets),
            Made::After(all, step) => Cow::Owned(vec![all.after_step(*step)]),
        }
    }

    /// Whether another one goes on with the steps of this one: what has no room is told of the last.
    fn goes_on_with(&self, next: Option<&(String, Made)>) -> bool {
        matches!((self, next), (Made::After(all, _), Some((_, Made::After(other, _)))) if Rc::ptr_eq(all, other))
    }
}

/// A file to be written.
enum File<'a> {
    /// What is made of the scene of an index.
    OfScene(usize, OfScene),
    /// All sheets of a figure as pages.
    #[cfg(feature = "pdf")]
    Pages(&'a Made),
    /// The sheet of an index in a format.
    Sheet(&'a Made, usize, FigureFormat),
}

/// How the sheets of a figure come into files.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Sheets {
    /// Each into its own.
    Apart,
    /// As pages of one PDF, where that is the format.
    Joined,
    /// As SVG with a group for each step of the construction.
    Layered,
}

impl Figures {
    /// The style of `--style`.
    pub(super) fn style(&self) -> Result<GivenStyle, Failure> {
        GivenStyle::read(self.options.style.as_deref())
    }

    /// The formats that are asked for: that of a file, or those of a folder.
    fn formats(&self) -> Vec<FigureFormat> {
        let given = self.options.format.as_slice();
        if is_stream(&self.output) {
            return vec![if let [format] = given { *format } else { FigureFormat::Svg }];
        }
        let ending = self.output.extension().and_then(|ending| ending.to_str());
        let of_file = || FigureFormat::value_variants().iter().find(|format| Some(format.ending()) == ending);
        match of_file().filter(|_| !files::is_folder(&self.output)) {
            Some(format) => vec![*format],
            None => given.to_vec(),
        }
    }

    /// Whether pages are among the formats.
    pub(super) fn has_page(&self) -> bool {
        self.formats().contains(&FigureFormat::Html)
    }

    /// Whether films are among the formats.
    pub(super) fn has_film(&self) -> bool {
        self.formats().into_iter().any(FigureFormat::is_film)
    }

    /// Whether pictures in pixels are among the formats.
    pub(super) fn has_png(&self) -> bool {
        self.formats().into_iter().any(|format| format.ending() == "png")
    }

    /// Whether there is nothing but films.
    pub(super) fn is_film(&self) -> bool {
        self.formats().into_iter().all(FigureFormat::is_film)
    }

    /// Writes figures by their names in all formats, each with its further sheets, as files of a set, but not over the
    /// files `inputs` that were read; `of_scene` makes what is made of the scene of an index.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        inputs: &[(&str, &Path)],
        drawings: Vec<(String, Made)>,
        kind: Sheets,
        of_scene: impl Fn(usize, OfScene) -> Result<Vec<u8>, Failure>,
    ) -> Result<(), Failure> {
        warn_unlabelled(&drawings);
        let mut written = Vec::new();
        for (index, (name, made)) in drawings.iter().enumerate() {
            let mut targets = self.targets(name, drawings.len())?;
            if kind == Sheets::Layered {
                targets.retain(|(_, format)| *format == FigureFormat::Svg);
                targets.truncate(1);
            }
            if targets.is_empty() {
                return refuse("only SVG has layers", "leave out --format, or name a file that ends in `.svg`");
            }
            for (path, format) in targets {
                if let Some(of) = format.of_scene() {
                    written.push((path, File::OfScene(index, of)));
                    continue;
                }
                #[cfg(feature = "pdf")]
                if kind == Sheets::Joined && format == FigureFormat::Pdf {
                    written.push((path, File::Pages(made)));
                    continue;
                }
                let paths = self.sheet_paths(path, made.count(), kind).zip(0..made.count());
                written.extend(paths.map(|(path, sheet)| (path, File::Sheet(made, sheet, format))));
            }
        }
        self.put(files, inputs, written, |file| match file {
            File::OfScene(index, of) => of_scene(index, of),
            #[cfg(feature = "pdf")]
            File::Pages(made) => format::pdf_pages(&made.sheets(), None).map_err(Failure::unclear),
            File::Sheet(made, sheet, format) => self.bytes(&made.sheets()[sheet], format, kind),
        })
    }

    /// The file of a drawing in a format other than a page.
    fn bytes(&self, drawing: &Drawing, format: FigureFormat, kind: Sheets) -> Result<Vec<u8>, Failure> {
        let text = if self.options.outlines { Text::Outlines } else { Text::Letters };
        match format {
            #[cfg(feature = "pdf")]
            FigureFormat::Pdf => drawing.pdf().map_err(Failure::unclear),
            #[cfg(feature = "png")]
            FigureFormat::Png => drawing.png(self.options.dpi_of(drawing.width)).map_err(Failure::unclear),
            FigureFormat::Tikz => Ok(drawing.tikz().into_bytes()),
            _ if kind == Sheets::Layered => Ok(format::layered_svg(drawing, text).into_bytes()),
            _ => Ok(format::svg_with(drawing, text).into_bytes()),
        }
    }

    /// The paths of a figure's sheets: the second has `-2` before its ending. Only the first is written on stdout.
    fn sheet_paths(&self, first: PathBuf, sheets: usize, kind: Sheets) -> impl Iterator<Item = PathBuf> {
        let on_stdout = is_stream(&self.output);
        if on_stdout && sheets > 1 {
            let what = match kind {
                Sheets::Apart | Sheets::Layered if sheets == 2 => "a second sheet is",
                _ => "further sheets are",
            };
            note(&format!("{what} not on stdout; name a folder or a file to have all"));
        }
        let numbered = move |number: usize| {
            let [stem, ending] = [first.file_stem(), first.extension()].map(|part| part.unwrap_or_default());
            let name = format!("{}-{number}.{}", stem.to_string_lossy(), ending.to_string_lossy());
            if number == 1 { first.clone() } else { first.with_file_name(name) }
        };
        (1..=if on_stdout { 1 } else { sheets }).map(numbered)
    }

    /// Makes files one after another and puts them into a set, but not over those that were read.
    fn put(
        &self,
        files: &mut FileSet,
        inputs: &[(&str, &Path)],
        mut written: Vec<(PathBuf, File<'_>)>,
        make: impl Fn(File<'_>) -> Result<Vec<u8>, Failure>,
    ) -> Result<(), Failure> {
        if is_stream(&self.output) {
            let (1, Some((path, file))) = (written.len(), written.pop()) else {
                return refuse(
                    "only one figure fits on stdout",
                    "name one scene and one step, or a folder to write to",
                );
            };
            let (is_stdout, bytes) = (self.output == Path::new("-"), make(file)?);
            return if is_stdout { files::print(&bytes) } else { files.add(&path, &bytes) };
        }
        let style = self.options.style.as_deref().map(|style| ("style", Path::new(style)));
        for (path, _) in &written {
            for (what, input) in inputs.iter().copied().chain(style) {
                files::refuse_overwriting(what, input, path)?;
            }
        }
        written.into_iter().try_for_each(|(path, file)| files.add(&path, &make(file)?))
    }

    /// The paths of a drawing's files with their formats; `drawings` is the number of drawings.
    fn targets(&self, name: &str, drawings: usize) -> Result<Vec<(PathBuf, FigureFormat)>, Failure> {
        if is_stream(&self.output) {
            return Ok(self.formats().into_iter().map(|format| (self.output.clone(), format)).collect());
        }
        let ending = self.output.extension().and_then(|e| e.to_str());
        if ending.is_none() || files::is_folder(&self.output) {
            let path = |format: &FigureFormat| self.output.join(format!("{name}.{}", format.ending()));
            return Ok(self.options.format.iter().map(|f| (path(f), *f)).collect());
        }
        match FigureFormat::value_variants().iter().find(|f| Some(f.ending()) == ending) {
            Some(format) if drawings == 1 => Ok(vec![(self.output.clone(), *format)]),
            Some(_) => refuse(
                "several figures do not fit into one file",
                "name one scene and one step, or a folder to write to",
            ),
            None => {
                let known: Vec<&str> = FigureFormat::value_variants().iter().map(|f| f.ending()).collect();
                let known = format!("known endings: {}; a folder's name ends in `/`", known.join(", "));
                let ending = ending.unwrap_or_default();
                // Films that others make.
                let known = match ending {
                    "webp" | "webm" | "mp4" => {
                        format!("`.gif` or `.apng` for a film; the workbench, `-o page.html`, saves WebM; {known}")
                    }
                    _ => known,
                };
                refuse(format!("no format for files ending in `.{ending}`"), known)
            }
        }
    }
}

/// Warns of names for which panels have no room, once for all sheets of a figure.
fn warn_unlabelled(drawings: &[(String, Made)]) {
    let mut told: IndexSet<(String, bool, Vec<String>)> = IndexSet::new();
    for (index, (_, made)) in drawings.iter().enumerate() {
        if !made.goes_on_with(drawings.get(index + 1)) {
            let sheets = made.sheets();
            let of_panels = sheets.iter().flat_map(|sheet| &sheet.unlabelled);
            let names = |of: &Unlabelled| of.names.iter().map(|name| name.text.content()).collect();
            told.extend(of_panels.map(|of| (of.panel.clone(), of.are_listed, names(of))));
        }
    }
    for (panel, are_listed, names) in told {
        let listed = names.iter().take(MOST_LISTED).map(String::as_str).collect::<Vec<_>>().join("; ");
        let more = match names.len().saturating_sub(MOST_LISTED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let count = match names.len() {
            1 => "1 name, which is".to_owned(),
            count => format!("{count} names, which are"),
        };
        let place = if are_listed { "listed below its heading" } else { "left out" };
        warn(&format!("{panel}: no room for {count} {place}: {listed}{more}; a larger page has room for more"));
    }
}

/// The name of a scene's figures: that of the scene's file without its ending, `figure` for stdin.
pub(super) fn stem(path: &Path) -> String {
    let stem = path.file_stem().and_then(|s| s.to_str());
    stem.filter(|s| *s != "-").unwrap_or("figure").to_owned()
}
