use super::files;
use super::message::{Failure, note, warn};
use super::options::NamesAnd;
use super::output::{self, FileSet};
use crate::drawing::{Drawing, Style};
use crate::format::{self, Text};
use crate::scene::{Figure, StyleName};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// How many names without room are listed.
const MOST_LISTED: usize = 20;

/// Where figures go, and in which forms.
#[derive(Debug, Args)]
pub(super) struct Figures {
    /// Folder to write to, or a file whose ending gives the format, or `-` for stdout.
    #[arg(short, long, default_value = "out/")]
    output: PathBuf,
    #[command(flatten)]
    options: FigureOptions,
}

/// In which forms figures are written.
#[derive(Clone, Debug, Args)]
pub(super) struct FigureOptions {
    /// Formats to write into a folder; on stdout the one that is given, or SVG.
    #[arg(long, value_delimiter = ',', value_enum, default_values_t = FigureFormat::usual())]
    format: Vec<FigureFormat>,
    /// Write the letters of SVG as outlines, for programs that lack the font.
    #[arg(long)]
    outlines: bool,
    /// Drawing style in place of the scene's own: paper, print, lecture, board, or the path of a style file.
    #[arg(long, value_name = "NAME|FILE", value_parser = style_names(), hide_possible_values = true)]
    pub style: Option<String>,
    /// Resolution of PNG in dots per inch.
    #[arg(long, default_value_t = 100.0, value_parser = dots_per_inch)]
    dpi: f64,
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

impl Figures {
    /// The style of `--style`.
    pub(super) fn style(&self) -> Result<GivenStyle, Failure> {
        GivenStyle::read(self.options.style.as_deref())
    }

    /// Whether pages are among the formats.
    pub(super) fn has_page(&self) -> bool {
        let is_named = self.output.extension().is_some_and(|ending| ending == FigureFormat::Html.ending());
        is_named || self.options.format.contains(&FigureFormat::Html)
    }

    /// Figures that are written to a folder or to a file.
    pub(super) fn at(output: &Path, options: &FigureOptions) -> Figures {
        Figures { output: output.to_owned(), options: options.clone() }
    }

    /// Writes figures by their names in all formats, each with its further sheets, as files of a set, but not over the
    /// files `inputs` that were read; `page` makes the web page of the figure of an index. `joined` sheets are pages of one
    /// PDF.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        inputs: &[(&str, &Path)],
        drawings: Vec<(String, Vec<Drawing>)>,
        joined: bool,
        page: impl Fn(usize) -> Result<String, Failure>,
    ) -> Result<(), Failure> {
        warn_unlabelled(&drawings);
        let mut written = Vec::new();
        for (index, (name, sheets)) in drawings.iter().enumerate() {
            for (path, format) in self.targets(name, drawings.len())? {
                if format == FigureFormat::Html {
                    written.push((path, page(index)?.into_bytes()));
                    continue;
                }
                #[cfg(feature = "pdf")]
                if joined && format == FigureFormat::Pdf {
                    let pdf = format::pdf_pages(sheets, None);
                    written.push((path, pdf.map_err(|error| Failure::unclear(error.to_string()))?));
                    continue;
                }
                for (path, drawing) in self.sheet_paths(path, sheets.len(), joined).zip(sheets) {
                    written.push((path, self.bytes(drawing, format)?));
                }
            }
        }
        self.put(files, inputs, &written)
    }

    /// The file of a drawing in a format other than a page.
    fn bytes(&self, drawing: &Drawing, format: FigureFormat) -> Result<Vec<u8>, Failure> {
        match format {
            #[cfg(feature = "pdf")]
            FigureFormat::Pdf => drawing.pdf().map_err(|error| Failure::unclear(error.to_string())),
            #[cfg(feature = "png")]
            FigureFormat::Png => drawing.png(self.options.dpi).map_err(|error| Failure::unclear(error.to_string())),
            FigureFormat::Tikz => Ok(drawing.tikz().into_bytes()),
            FigureFormat::Svg | FigureFormat::Html => Ok(format::svg_with(drawing, self.text()).into_bytes()),
        }
    }

    /// The paths of a figure's sheets: the second has `-2` before its ending. Only the first is written on stdout.
    fn sheet_paths(&self, first: PathBuf, sheets: usize, joined: bool) -> impl Iterator<Item = PathBuf> {
        let on_stdout = self.is_stream();
        if on_stdout && sheets > 1 {
            let what = if joined { "further sheets are" } else { "the table is on a second sheet, which is" };
            note(&format!("{what} not on stdout; name a folder or a file to have all"));
        }
        let numbered = move |number: usize| {
            let [stem, ending] = [first.file_stem(), first.extension()].map(|part| part.unwrap_or_default());
            let name = format!("{}-{number}.{}", stem.to_string_lossy(), ending.to_string_lossy());
            if number == 1 { first.clone() } else { first.with_file_name(name) }
        };
        (1..=if on_stdout { 1 } else { sheets }).map(numbered)
    }

    /// Writes drawings as SVG with a group for each step of the construction.
    pub(super) fn write_layered(
        &self,
        files: &mut FileSet,
        inputs: &[(&str, &Path)],
        drawings: Vec<(String, Vec<Drawing>)>,
    ) -> Result<(), Failure> {
        warn_unlabelled(&drawings);
        let mut written = Vec::new();
        for (name, sheets) in &drawings {
            let targets = self.targets(name, drawings.len())?;
            let Some((path, _)) = targets.into_iter().find(|(_, format)| *format == FigureFormat::Svg) else {
                return Err(Failure::misuse(
                    "only SVG has layers",
                    "leave out --format, or name a file that ends in `.svg`",
                ));
            };
            for (path, drawing) in self.sheet_paths(path, sheets.len(), false).zip(sheets) {
                written.push((path, format::layered_svg(drawing, self.text()).into_bytes()));
            }
        }
        self.put(files, inputs, &written)
    }

    /// How letters of SVG are written.
    fn text(&self) -> Text {
        if self.options.outlines { Text::Outlines } else { Text::Letters }
    }

    /// Puts files into a set, but not over those that were read.
    fn put(
        &self,
        files: &mut FileSet,
        inputs: &[(&str, &Path)],
        written: &[(PathBuf, Vec<u8>)],
    ) -> Result<(), Failure> {
        if self.is_stream() {
            let [(path, bytes)] = written else {
                return Err(Failure::misuse(
                    "only one figure fits on stdout",
                    "name one scene and one step, or a folder to write to",
                ));
            };
            let is_stdout = self.output == Path::new("-");
            return if is_stdout { files::print(bytes) } else { files.add(path, bytes) };
        }
        let style = self.options.style.as_deref().map(|style| ("style", Path::new(style)));
        for (path, _) in written {
            for (what, input) in inputs.iter().copied().chain(style) {
                files::refuse_overwriting(what, input, path)?;
            }
        }
        files.add_all(written)
    }

    /// Whether figures go to stdout, to a pipe or to a device, so that there is only one.
    fn is_stream(&self) -> bool {
        self.output == Path::new("-") || output::is_special(&self.output)
    }

    /// The paths of a drawing's files with their formats; `drawings` is the number of drawings.
    fn targets(&self, name: &str, drawings: usize) -> Result<Vec<(PathBuf, FigureFormat)>, Failure> {
        if self.is_stream() {
            let format = match self.options.format.as_slice() {
                [format] => *format,
                _ => FigureFormat::Svg,
            };
            return Ok(vec![(self.output.clone(), format)]);
        }
        let ending = self.output.extension().and_then(|e| e.to_str());
        if ending.is_none() || files::is_folder(&self.output) {
            let path = |format: &FigureFormat| self.output.join(format!("{name}.{}", format.ending()));
            return Ok(self.options.format.iter().map(|f| (path(f), *f)).collect());
        }
        match FigureFormat::value_variants().iter().find(|f| Some(f.ending()) == ending) {
            Some(format) if drawings == 1 => Ok(vec![(self.output.clone(), *format)]),
            Some(_) => Err(Failure::misuse(
                "several figures do not fit into one file",
                "name one scene and one step, or a folder to write to",
            )),
            None => {
                let known: Vec<&str> = FigureFormat::value_variants().iter().map(|f| f.ending()).collect();
                Err(Failure::misuse(
                    format!("no format for files ending in `.{}`", ending.unwrap_or_default()),
                    format!("known endings: {}; a folder's name ends in `/`", known.join(", ")),
                ))
            }
        }
    }
}

/// Warns of names for which panels have no room, once for all sheets of a figure.
fn warn_unlabelled(drawings: &[(String, Vec<Drawing>)]) {
    let mut told: Vec<&(String, Vec<String>)> = Vec::new();
    for panel in drawings.iter().flat_map(|(_, sheets)| sheets).flat_map(|sheet| &sheet.unlabelled) {
        if !told.contains(&panel) {
            warn(&unlabelled(panel));
            told.push(panel);
        }
    }
}

/// The warning that a panel has no room for names.
fn unlabelled((panel, names): &(String, Vec<String>)) -> String {
    let listed = names.iter().take(MOST_LISTED).map(String::as_str).collect::<Vec<_>>().join("; ");
    let more = match names.len().saturating_sub(MOST_LISTED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let count = names.len();
    format!("{panel}: no room for {count} names, which are left out: {listed}{more}; a larger page has room for more")
}

/// A drawing style in place of the scene's.
pub(super) enum GivenStyle {
    /// The scene's own.
    Scene,
    /// One that comes with the program.
    Named(StyleName),
    /// That of a file.
    File(Style),
}

impl GivenStyle {
    /// The style of `--style`, if that is given.
    pub(super) fn read(asked: Option<&str>) -> Result<GivenStyle, Failure> {
        let Some(asked) = asked else {
            return Ok(GivenStyle::Scene);
        };
        let named = StyleName::ALL.into_iter().find(|name| name.as_str() == asked);
        named.map_or_else(|| style_file(asked).map(GivenStyle::File), |name| Ok(GivenStyle::Named(name)))
    }

    /// Copies the size options into the scene's figure. The looks of a style file are put on the finished drawing; its sizes must be known before.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        match self {
            GivenStyle::Scene => {}
            GivenStyle::Named(name) => (figure.style, figure.sizes, figure.usual_values) = (*name, None, None),
            GivenStyle::File(style) => {
                (figure.sizes, figure.usual_values) = (Some(style.sizes()), Some(style.shows_values()));
            }
        }
    }

    /// Gives drawings the looks of a style file.
    pub(super) fn put_on<'a>(&self, drawings: impl IntoIterator<Item = &'a mut Drawing>) {
        if let GivenStyle::File(style) = self {
            drawings.into_iter().for_each(|drawing| drawing.style = style.clone());
        }
    }
}

fn style_file(asked: &str) -> Result<Style, Failure> {
    if !asked.contains(['.', '/', '\\']) && asked != "-" && !Path::new(asked).exists() {
        let known = StyleName::ALL.map(StyleName::as_str).join(", ");
        return Err(Failure::misuse(
            format!("there is no style `{asked}`"),
            format!("known styles: {known}; or the path of a style file"),
        ));
    }
    let source = files::read_text("style", Path::new(asked))?;
    Style::read(&source.text).map_err(|error| source.fail(error))
}

/// The name of a scene's figures: that of the scene's file without its ending, `figure` for stdin.
pub(super) fn stem(path: &Path) -> String {
    let stem = path.file_stem().and_then(|s| s.to_str());
    stem.filter(|s| *s != "-").unwrap_or("figure").to_owned()
}
