//! Photographs of a student's sheets: the right plans over them, the points that their pencil lines show, and the form that these give.

use super::files::{self, Unread, read_unnamed};
use super::forms::has_ending;
use super::message::{Failure, note, refuse};
use super::output::FileSet;
use super::picture::{broken, decoded};
use super::pieces::caught;
use crate::check::{
    AnswerKey, Measured, PaperPoints, PencilledPlan, PointVerdict, Proposal, aligned, common_scale, proposed,
    proposed_form,
};
use crate::construction::Solution;
use crate::drawing::markers::SheetCode;
use crate::drawing::{Drawing, SeenPoint, over_photo};
use crate::format::Backdrop;
use crate::message::Message;
use crate::photo::{PhotoSheet, Picture, Stroke, read, says};
use crate::sheet::Sheet;
use crate::text::{cell, quoted, shown};
use crate::words::NumberStyle;
use std::path::{Path, PathBuf};

/// Pixels per mm of the picture under the right plans.
const PIXELS: f64 = 6.0;

/// A photograph with the sheet that it shows.
pub(super) struct Photo {
    pub path: PathBuf,
    picture: Picture,
    pub sheet: PhotoSheet,
    strokes: Vec<Stroke>,
}

/// What photographs of one student's sheets tell.
pub(super) struct PhotoResult {
    /// All points of the plans that they show.
    pub points: Vec<Proposal>,
    /// The places that were found, as a form has them.
    pub measured: Measured,
    /// What makes the photographs of less use, and what to do.
    pub warnings: Vec<(Message, Message)>,
    /// By photograph: the code of its sheet, and that sheet, straightened out, with the right plans over it.
    sheets: Vec<(PathBuf, SheetCode, Backdrop, Drawing)>,
}

impl Photo {
    /// Reads a photograph; `expected` are the codes that its sheet may have.
    pub(super) fn read(path: &Path, expected: impl FnOnce() -> Vec<SheetCode>) -> Result<Photo, Failure> {
        let picture = read_picture(path)?;
        let sheet = read(&picture, expected)
            .map_err(|refusal| Failure::misuse(format!("{}: {refusal}", path.display()), refusal.hint()))?;
        Ok(Photo { path: path.to_owned(), strokes: sheet.strokes(&picture), picture, sheet })
    }

    fn plans<'a>(&'a self, solution: &'a Solution) -> impl Iterator<Item = PencilledPlan<'a>> {
        PencilledPlan::on(solution, &self.sheet, &self.strokes)
    }

    /// The sheet, straightened out and evenly lit.
    fn backdrop(&self) -> Backdrop {
        let page = self.sheet.code.page.size_mm();
        let paper = self.sheet.straightened(&self.picture, [[0.0; 2], page], 1.0 / PIXELS);
        let grey = paper.dark.iter().map(|dark| (255.0 * (1.0 - dark)).clamp(0.0, 255.0) as u8).collect();
        Backdrop { size: paper.size.map(|size| size as u32), grey }
    }
}

/// The codes of a scene's own sheets, under the names that they may have: that of its file, and of its folder as an exercise has it.
pub(super) fn expected(solution: &Solution, scene: &Path) -> Vec<SheetCode> {
    let folder = scene.parent().and_then(Path::file_name);
    let names = [scene.file_stem(), folder].into_iter().flatten().map(|name| name.to_string_lossy().into_owned());
    names.flat_map(|name| solution.drawing_sheets(&name)).filter_map(|sheet| sheet.code).collect()
}

impl PhotoResult {
    /// What photographs of the sheets of a scene tell.
    pub(super) fn of(photos: Vec<Photo>, key: &AnswerKey<'_>) -> Result<PhotoResult, Failure> {
        let own = key.solution.scene.fingerprint();
        if let Some(photo) = photos.iter().find(|photo| photo.sheet.code.scene != own) {
            return refuse(
                format!(
                    "{} shows sheet {} of `{}`, which is not of this scene",
                    photo.path.display(),
                    photo.sheet.code.number,
                    shown(&photo.sheet.code.name)
                ),
                "name the scene from which that sheet was printed; a scene that was changed since needs new sheets",
            );
        }
        let all: Vec<(&Photo, PencilledPlan<'_>)> =
            photos.iter().flat_map(|photo| photo.plans(key.solution).map(move |plan| (photo, plan))).collect();
        let is_of_forces = |sheet: Sheet| matches!(sheet, Sheet::Forces | Sheet::Lever);
        let mut panels = photos.iter().flat_map(|photo| &photo.sheet.code.panels);
        if let (true, Some(placed)) = (all.is_empty(), panels.find(|placed| is_of_forces(placed.panel))) {
            return refuse(
                format!(
                    "{} shows the {}, whose points are read of no photograph",
                    photos[0].path.display(),
                    placed.panel.name()
                ),
                "write what was measured on it into the form (`kinegon check scene.json --template`), or draw it on the drawing board of the workbench",
            );
        }
        if all.is_empty() {
            return refuse(
                format!("{} shows no plan, only the sheet with the scheme", photos[0].path.display()),
                "photograph the sheets on which the plans are drawn",
            );
        }
        for (index, (photo, plan)) in all.iter().enumerate() {
            if let Some((other, _)) = all[..index].iter().find(|(_, other)| other.of() == plan.of()) {
                return refuse(
                    format!("{} and {} both show the {}", other.path.display(), photo.path.display(), plan.of().name()),
                    "give one photograph of each sheet",
                );
            }
        }
        let plans: Vec<PencilledPlan<'_>> = all.iter().map(|(_, plan)| *plan).collect();
        let proposals = proposed(key, &plans)?;
        let measured = proposed_form(&proposals, &plans, key);
        let sheet = |photo: &Photo| {
            let seen: Vec<SeenPoint> = photo.plans(key.solution).flat_map(|plan| seen(&plan, &proposals)).collect();
            let code = &photo.sheet.code;
            (photo.path.clone(), code.clone(), photo.backdrop(), over_photo(key.solution, code, &seen))
        };
        let sheets = photos.iter().map(sheet).collect();
        Ok(PhotoResult { warnings: warnings(&photos, &proposals, key.solution), points: proposals, measured, sheets })
    }

    /// Adds the pictures and the form to a set of files in a folder; `name` is that of the form.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        folder: &Path,
        name: &str,
        key: &AnswerKey<'_>,
    ) -> Result<PathBuf, Failure> {
        for (path, _, backdrop, drawing) in &self.sheets {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let made = pictures(backdrop, drawing);
            let made = made.map_err(|error| Failure::outside(format!("{}: {error}", path.display())))?;
            for (ending, bytes) in made {
                let picture = folder.join(format!("{stem}-check.{ending}"));
                files::refuse_overwriting("photograph", path, &picture)?;
                files.add(&picture, &bytes)?;
            }
        }
        let form = folder.join(format!("{name}.json"));
        files.add(&form, self.measured.json(key.solution).as_bytes())?;
        Ok(form)
    }

    /// How many points have this verdict; `None` for those that are left to the student.
    pub(super) fn count(&self, verdict: Option<PointVerdict>) -> usize {
        self.points.iter().filter(|point| point.found.map(|found| found.verdict) == verdict).count()
    }

    /// A line of the table of a class.
    pub(super) fn row(&self, name: &str) -> String {
        let verdicts = [Some(PointVerdict::Right), Some(PointVerdict::Off), Some(PointVerdict::CannotTell), None];
        let [right, wrong, unclear, left] = verdicts.map(|verdict| self.count(verdict));
        let said = self.warnings.iter().map(|(message, hint)| format!("{message} ({hint})"));
        let said = said.collect::<Vec<_>>().join("; ");
        let said = if said.is_empty() { said } else { quoted(&cell(&said)) };
        let name = quoted(&cell(name));
        format!("{name},{},{right},{wrong},{unclear},{left},{said}\n", self.sheets.len())
    }

    /// Which sheets these are, and the table of their points, which have the names of the form.
    pub(super) fn table(&self, solution: &Solution) -> String {
        let words = solution.wording();
        let language = words.language;
        let sheets = self.sheets.iter().map(|(path, code, ..)| {
            let file = shown(&path.file_name().unwrap_or_default().to_string_lossy());
            language.photo_sheet(&file, &code.number.to_string(), &shown(&code.name)) + "\n"
        });
        let head = language.photo_columns().map(str::to_owned);
        let mut rows = vec![head];
        for point in &self.points {
            let origin = PaperPoints::of(solution, point.sheet).map_or("", |points| points.origin());
            let mm = |x: f64| words.write(x, NumberStyle::decimals(1));
            let distance = |[x, y]: [f64; 2]| libm::hypot(x, y);
            let found = point.found.map(|found| {
                let off = distance([found.at[0] - point.right[0], found.at[1] - point.right[1]]);
                let told = match found.verdict {
                    PointVerdict::Right => language.check_right(),
                    PointVerdict::Off => language.check_off(),
                    PointVerdict::CannotTell => language.photo_cannot_tell(),
                };
                [mm(distance(found.at)), mm(off), mm(found.band), told.to_owned()]
            });
            let blank = || [String::new(), String::new(), String::new(), language.photo_left().to_owned()];
            let [length, off, band, told] = found.unwrap_or_else(blank);
            rows.push([format!("{origin} {}", point.name), mm(distance(point.right)), length, off, band, told]);
        }
        sheets.chain(aligned(&rows).into_iter().map(|line| line + "\n")).collect()
    }
}

/// What makes photographs of less use, and what to do.
fn warnings(photos: &[Photo], points: &[Proposal], solution: &Solution) -> Vec<(Message, Message)> {
    let named =
        |photo: &Photo, message: Message| Message::list([format!("{}: ", photo.path.display()).into(), message], "");
    let crowded = photos.iter().filter(|photo| !photo.sheet.is_alone);
    let mut all: Vec<(Message, Message)> =
        crowded.map(|photo| (named(photo, says::second_sheet()), says::each_by_itself())).collect();
    for photo in photos {
        let mut own =
            points.iter().filter(|point| photo.plans(solution).any(|plan| plan.of() == point.sheet)).peekable();
        if own.peek().is_some() && own.all(|point| point.found.is_none()) {
            let width = photo.sheet.edge_width();
            let message = match width > SOFT {
                true => says::nothing_in_blur(format!("{width:.1}")),
                false => says::nothing_drawn(),
            };
            all.push((named(photo, message), says::mark_by_hand()));
        }
    }
    if let Some(scale) = common_scale(points) {
        let percent = format!("{:.1}", 100.0 * (scale - 1.0).abs());
        let message = if scale > 1.0 { says::scaled(percent) } else { says::scaled_down(percent) };
        all.push((message, says::measure_ruler()));
    }
    all
}

/// Width of edges from which blur hides pencil lines, in mm.
const SOFT: f64 = 0.45;

/// A drawing over its picture in the formats that are built in: endings and bytes.
fn pictures(backdrop: &Backdrop, drawing: &Drawing) -> Result<Vec<(&'static str, Vec<u8>)>, String> {
    #[cfg(not(any(feature = "png", feature = "pdf")))]
    let _ = (backdrop, drawing);
    Ok(vec![
        #[cfg(feature = "png")]
        ("png", drawing.png_over(backdrop).map_err(|error| error.to_string())?),
        #[cfg(feature = "pdf")]
        ("pdf", drawing.pdf_over(backdrop).map_err(|error| error.to_string())?),
    ])
}

/// The points of a sheet that were found, on its paper.
fn seen(plan: &PencilledPlan<'_>, points: &[Proposal]) -> Vec<SeenPoint> {
    let own = points.iter().filter(|point| point.sheet == plan.of());
    own.filter_map(|point| {
        let found = point.found?;
        Some(SeenPoint {
            panel: plan.of(),
            name: point.name.clone(),
            at: plan.on_sheet(found.at),
            band: found.band,
            is_off: found.verdict == PointVerdict::Off,
        })
    })
    .collect()
}

/// The name of the student whose sheets these are: that of the first file, without its ending and a number behind it.
pub(super) fn student(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let name = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    match name.strip_suffix(['-', '_', ' ']) {
        Some(name) if !name.is_empty() => name.to_owned(),
        _ => stem,
    }
}

/// Says how to go on from proposed places.
pub(super) fn note_next(form: Option<&Path>, scene: &Path) {
    match form {
        Some(form) => note(&format!(
            "look at the pictures; places can be changed or taken out in {0}; then `kinegon check {1} {0}`, or --accept takes them as they are",
            form.display(),
            scene.display()
        )),
        None => note(
            "-o DIR writes the pictures with the right plans over them, and the form; --accept takes the places as they are and checks them",
        ),
    }
}

/// Largest file, in bytes.
const LARGEST: u64 = 64 << 20;
/// Whether a file's name is that of a photograph.
pub(super) fn is_photograph(path: &Path) -> bool {
    has_ending(path, &["jpg", "jpeg", "png", "heic", "heif", "webp", "tif", "tiff", "bmp", "gif"])
}

/// The picture in a file, upright as the file says, in grey.
pub fn read_picture(path: &Path) -> Result<Picture, Failure> {
    let name = path.display().to_string();
    let refuse = |message: String, hint: Message| Failure::misuse(format!("{name} {message}"), hint);
    let bytes = read_unnamed(path, None, LARGEST).map_err(|why| {
        let hint = match why {
            Unread::Large(_) => "send the photograph in a smaller size",
            _ => "give the path of a photograph",
        };
        refuse(why.to_string(), hint.into())
    })?;
    if bytes.get(4..8) == Some(b"ftyp") {
        return Err(refuse(
            "is a HEIC or AVIF picture, which is not read".to_owned(),
            "save or send it as JPEG (on an iPhone: Settings, Camera, Formats, Most Compatible)".into(),
        ));
    }
    if is_cut_short(&bytes) {
        return Err(refuse(says::cut_short().to_string(), says::send_again()));
    }
    // The decoders are not ours: whatever a broken file does to them is a message.
    let decoded = caught(|| decoded(&bytes)).unwrap_or_else(|panic| Err(broken(panic)));
    decoded.map_err(|(message, hint)| refuse(message, hint.into()))
}

/// Whether a JPEG or PNG file lacks its end: decoders show the rest as grey.
fn is_cut_short(bytes: &[u8]) -> bool {
    let last = |mark: &[u8]| bytes.windows(mark.len()).rposition(|at| at == mark);
    if bytes.starts_with(b"\xff\xd8") {
        // The pixels follow the last start of a scan; a preview before them has an end of its own.
        last(b"\xff\xda") > last(b"\xff\xd9")
    } else {
        bytes.starts_with(b"\x89PNG") && last(b"IEND").is_none()
    }
}
