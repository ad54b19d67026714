//! Photographs of a student's sheets: the right plans over them, the points that their pencil lines show, and the form that these give.

use super::files;
use super::message::{Failure, note};
use super::output::FileSet;
use super::pictures::read_picture;
use crate::check::{AnswerKey, Measured, PencilledPlan, PointVerdict, Proposal, WrittenForm, proposed};
use crate::construction::Solution;
use crate::drawing::markers::SheetCode;
use crate::drawing::{Drawing, SeenPoint, over_photo};
use crate::format::Backdrop;
use crate::photo::{PhotoSheet, Picture, Stroke, read};
use crate::text::{Untrusted, shown};
use crate::words::{NumberStyle, Wording};
use std::path::{Path, PathBuf};

/// Pixels per mm of the picture under the right plans.
const PIXELS: f64 = 6.0;

/// A photograph with the sheet that it shows.
pub(super) struct Photo {
    pub path: PathBuf,
    picture: Picture,
    sheet: PhotoSheet,
    strokes: Vec<Stroke>,
}

/// What photographs of one student's sheets tell.
pub(super) struct PhotoResult {
    /// All points of the plans that they show.
    pub points: Vec<Proposal>,
    /// The places that were found, as a form has them.
    pub measured: Measured,
    /// By photograph: the sheet, straightened out, with the right plans over it.
    sheets: Vec<(PathBuf, Backdrop, Drawing)>,
    codes: Vec<(PathBuf, SheetCode)>,
}

impl Photo {
    /// Reads a photograph; `expected` are the codes that its sheet may have.
    pub(super) fn read(path: &Path, expected: impl FnOnce() -> Vec<SheetCode>) -> Result<Photo, Failure> {
        let picture = read_picture(path)?;
        let sheet = read(&picture, expected)
            .map_err(|refusal| Failure::misuse(format!("{}: {refusal}", path.display()), refusal.hint().to_owned()))?;
        Ok(Photo { path: path.to_owned(), strokes: sheet.strokes(&picture), picture, sheet })
    }

    /// What the code of its sheet says.
    pub(super) fn code(&self) -> &SheetCode {
        &self.sheet.code
    }

    fn plans(&self) -> impl Iterator<Item = PencilledPlan<'_>> {
        PencilledPlan::on(&self.sheet, &self.strokes)
    }

    /// The sheet, straightened out and evenly lit.
    fn backdrop(&self) -> Backdrop {
        let page = self.sheet.code.page.size_mm();
        let paper = self.sheet.straightened(&self.picture, [[0.0; 2], page], 1.0 / PIXELS);
        let grey = paper.dark().iter().map(|dark| (255.0 * (1.0 - dark)).clamp(0.0, 255.0) as u8).collect();
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
    pub(super) fn of(photos: Vec<Photo>, solution: &Solution, key: &AnswerKey<'_>) -> Result<PhotoResult, Failure> {
        let own = solution.scene.fingerprint();
        if let Some(photo) = photos.iter().find(|photo| photo.code().scene != own) {
            return Err(Failure::misuse(
                format!(
                    "{} shows sheet {} of `{}`, which is not of this scene",
                    photo.path.display(),
                    photo.code().number,
                    shown(&photo.code().name)
                ),
                "name the scene from which that sheet was printed; a scene that was changed since needs new sheets",
            ));
        }
        let all: Vec<(&Photo, PencilledPlan<'_>)> =
            photos.iter().flat_map(|photo| photo.plans().map(move |plan| (photo, plan))).collect();
        if all.is_empty() {
            return Err(Failure::misuse(
                format!("{} shows no plan, only the sheet with the scheme", photos[0].path.display()),
                "photograph the sheets on which the plans are drawn",
            ));
        }
        for (index, (photo, plan)) in all.iter().enumerate() {
            if let Some((other, _)) = all[..index].iter().find(|(_, other)| other.kind == plan.kind) {
                return Err(Failure::misuse(
                    format!("{} and {} both show the {}", other.path.display(), photo.path.display(), plan.kind.name()),
                    "give one photograph of each sheet",
                ));
            }
        }
        let plans: Vec<PencilledPlan<'_>> = all.iter().map(|(_, plan)| *plan).collect();
        let proposals = proposed(key, &plans).map_err(Failure::from)?;
        let measured = proposals.measured(&plans, key);
        let sheet = |photo: &Photo| {
            let seen: Vec<SeenPoint> = photo.plans().flat_map(|plan| seen(&plan, &proposals.points)).collect();
            (photo.path.clone(), photo.backdrop(), over_photo(solution, photo.code(), &seen))
        };
        let sheets = photos.iter().map(sheet).collect();
        let codes = photos.iter().map(|photo| (photo.path.clone(), photo.code().clone())).collect();
        Ok(PhotoResult { points: proposals.points, measured, sheets, codes })
    }

    /// Adds the pictures and the form to a set of files in a folder; `name` is that of the form.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        folder: &Path,
        name: &str,
        key: &AnswerKey<'_>,
    ) -> Result<PathBuf, Failure> {
        for (path, backdrop, drawing) in &self.sheets {
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
        files.add(&form, WrittenForm::filled(key.solution, &self.measured).json().as_bytes())?;
        Ok(form)
    }

    /// The same of a student of that name.
    pub(super) fn named(mut self, name: &str) -> PhotoResult {
        self.measured.name = Some(Untrusted::from(name));
        self
    }

    /// How many points have this verdict.
    pub(super) fn count(&self, verdict: PointVerdict) -> usize {
        self.points.iter().filter(|point| point.found.is_some_and(|found| found.verdict == verdict)).count()
    }

    /// How many points are left to the student.
    pub(super) fn left(&self) -> usize {
        self.points.iter().filter(|point| point.found.is_none()).count()
    }

    /// Which sheets these are, and the table of their points, which have the names of the form.
    pub(super) fn table(&self, solution: &Solution) -> String {
        let words = solution.wording();
        let sheets: String = self
            .codes
            .iter()
            .map(|(path, code)| {
                let file = shown(&path.file_name().unwrap_or_default().to_string_lossy());
                words.language.photo_sheet(&file, &code.number.to_string(), &shown(&code.name)) + "\n"
            })
            .collect();
        let language = words.language;
        let head = language.photo_columns().map(str::to_owned);
        let mut rows = vec![head];
        for point in &self.points {
            let pole = point.kind.pole();
            let mm = |x: f64| words.write(x, NumberStyle::decimals(1));
            let distance = |[x, y]: [f64; 2]| libm::hypot(x, y);
            let found = point.found.map(|found| {
                let off = distance([found.at[0] - point.right[0], found.at[1] - point.right[1]]);
                [mm(distance(found.at)), mm(off), mm(found.band), verdict(found.verdict, &words).to_owned()]
            });
            let blank = || [String::new(), String::new(), String::new(), language.photo_left().to_owned()];
            let [length, off, band, told] = found.unwrap_or_else(blank);
            rows.push([format!("{pole} {}", point.name), mm(distance(point.right)), length, off, band, told]);
        }
        sheets + &aligned(&rows)
    }
}

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

/// The points of a plan that were found, on the sheet.
fn seen(plan: &PencilledPlan<'_>, points: &[Proposal]) -> Vec<SeenPoint> {
    let own = points.iter().filter(|point| point.kind == plan.kind);
    own.filter_map(|point| {
        let found = point.found?;
        Some(SeenPoint {
            panel: plan.kind,
            name: point.name.clone(),
            at: plan.on_sheet(found.at),
            band: found.band,
            is_off: found.verdict == PointVerdict::Off,
        })
    })
    .collect()
}

fn verdict(verdict: PointVerdict, words: &Wording) -> &str {
    match verdict {
        PointVerdict::Right => words.language.check_right(),
        PointVerdict::Off => words.language.check_off(),
        PointVerdict::CannotTell => words.language.photo_cannot_tell(),
    }
}

/// Rows of cells in columns; numbers stand right.
fn aligned(rows: &[[String; 6]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 6] = std::array::from_fn(width);
    let line = |row: &[String; 6]| {
        let cell = |(column, text): (usize, &String)| {
            let blank = " ".repeat(widths[column] - text.chars().count());
            if (1..5).contains(&column) { blank + text } else { text.clone() + &blank }
        };
        row.iter().enumerate().map(cell).collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
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
