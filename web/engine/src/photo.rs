//! The last photograph of a sheet: the right plans and lines of centres over it, what is tapped on it, how its points stand.

use crate::desk::Desk;
use crate::forms::usual_key;
use crate::photo_answers::{
    Photo, PhotoPlan, PhotoPoint, PhotoRead, PhotoRefused, PlacedPoint, PointVerdict, Proposed, Tapped,
};
use crate::refused::Refused;
use kinegon::check::{self, BANDS, PaperPoints, PencilledPlan, hundredths, sheet_points};
use kinegon::construction::{Plan, Teller, Tolerance};
use kinegon::drawing::markers::SheetCode;
use kinegon::format::html_text;
use kinegon::geometry::Vector;
use kinegon::photo::{self, PhotoSheet, Picture, Stroke, says};
use kinegon::words::Language;
use kinegon::{Message, Sheet, Solution};

/// Length of the straight pieces by which a line of the plan follows the picture, in mm of paper.
const PIECE: f64 = 8.0;

/// A photograph of a sheet that has plans or centres of the scene.
pub struct Photograph {
    /// The scene's text.
    text: String,
    picture: Picture,
    sheet: Upright,
    plans: Vec<PlanInPhoto>,
    found: Option<Pencil>,
}

/// What the pencil has drawn on the sheet.
struct Pencil {
    strokes: Vec<Stroke>,
    /// Where plan points seem to be, with the index of the plan.
    points: Vec<(usize, check::Proposal)>,
}

/// A sheet in its photograph, which is turned by quarters so that the sheet stands upright.
struct Upright {
    sheet: PhotoSheet,
    /// Quarters clockwise.
    turn: u8,
    /// Width and height of the photograph as it was taken, in pixels.
    size: [f64; 2],
}

impl Upright {
    fn new(sheet: PhotoSheet, picture: &Picture) -> Upright {
        let [width, height] = sheet.code.page.size_mm();
        let [left, right] = [0.25, 0.75].map(|share| sheet.pixel([share * width, 0.5 * height]));
        let way = [right[0] - left[0], right[1] - left[1]];
        let turn = match (way[0].abs() >= way[1].abs(), way[0] > 0.0, way[1] > 0.0) {
            (true, true, _) => 0,
            (true, false, _) => 2,
            (false, _, true) => 3,
            (false, _, false) => 1,
        };
        Upright { sheet, turn, size: [picture.width() as f64, picture.height() as f64] }
    }

    /// Where a place on the sheet is in the turned picture.
    fn pixel(&self, paper: [f64; 2]) -> [f64; 2] {
        turned(self.sheet.pixel(paper), self.size, self.turn)
    }

    /// Where a place in the turned picture is on the sheet.
    fn paper(&self, pixel: [f64; 2]) -> Option<[f64; 2]> {
        let [width, height] = self.size;
        let size = if matches!(self.turn, 0 | 2) { [width, height] } else { [height, width] };
        self.sheet.paper(turned(pixel, size, (4 - self.turn) % 4))
    }

    fn band(&self, paper: [f64; 2]) -> f64 {
        self.sheet.band(paper)
    }

    /// Pixels per mm in the sheet's middle.
    fn per_mm(&self) -> f64 {
        let [width, height] = self.sheet.code.page.size_mm();
        let [a, b] = [-5.0, 5.0].map(|x| self.pixel([0.5 * width + x, 0.5 * height]));
        0.1 * hypot(b[0] - a[0], b[1] - a[1])
    }
}

/// A place in a picture of that size after quarters of a turn clockwise.
fn turned([x, y]: [f64; 2], [width, height]: [f64; 2], quarters: u8) -> [f64; 2] {
    match quarters {
        1 => [height - y, x],
        2 => [width - x, height - y],
        3 => [y, width - x],
        _ => [x, y],
    }
}

/// A plan or figure of instant centres on the sheet.
struct PlanInPhoto {
    sheet: Sheet,
    mu: f64,
    /// The place of its origin, in mm, y down.
    origin: [f64; 2],
    points: Vec<RightPoint>,
    /// Its vectors, rays and pole lines by their ends, in mm from the origin with y up.
    lines: Vec<[[f64; 2]; 2]>,
}

/// A point of the right plan; lengths in mm.
struct RightPoint {
    name: String,
    label: String,
    /// From the origin, y up.
    at: [f64; 2],
    /// How far from there an honest hand may have it.
    tolerance: f64,
}

/// Reads a photograph of a sheet of this scene, or of the exercise of that name; one that can be measured on is kept.
pub fn read(
    desk: &mut Desk,
    text: &str,
    name: &str,
    size: [usize; 2],
    grey: Vec<u8>,
) -> Result<(PhotoRead, Option<Photograph>), Refused> {
    let picture = Picture::new(size[0], size[1], grey)
        .ok_or_else(|| Refused::whole("the picture has not as many pixels as its width and height say"))?;
    let language = desk.language();
    let solution = desk.solution(text)?;
    let own = || solution.drawing_sheets(name).into_iter().filter_map(|sheet| sheet.code).collect();
    let read = photo::read(&picture, own);
    let sheet = match read {
        Ok(sheet) => sheet,
        Err(why) => return Ok((PhotoRead { photo: None, refused: Some(PhotoRefused::of(&why, language)) }, None)),
    };
    let sheet = Upright::new(sheet, &picture);
    let code = &sheet.sheet.code;
    let is_own = code.scene == solution.scene.fingerprint();
    let plans = if is_own { plans(solution, code) } else { Vec::new() };
    let shown = plans.iter().map(|plan| plan.shown(&sheet)).collect();
    let photo = Photo {
        name: code.name.clone(),
        number: code.number,
        is_own,
        turn: sheet.turn,
        per_mm: sheet.per_mm(),
        bend: sheet.sheet.bend(),
        warning: (!sheet.sheet.is_alone).then(|| told(language, &[says::second_sheet(), says::each_by_itself()])),
        band: plans.iter().flat_map(|plan| plan.bands(&sheet)).fold(0.0, f64::max),
        plans: shown,
    };
    let kept = (!plans.is_empty()).then(|| Photograph { text: text.to_owned(), picture, sheet, plans, found: None });
    Ok((PhotoRead { photo: Some(photo), refused: None }, kept))
}

/// The plans on a sheet.
fn plans(solution: &Solution, code: &SheetCode) -> Vec<PlanInPhoto> {
    let mut labels = sheet_points(solution);
    let found = code.panels.iter().filter_map(|panel| {
        let own = PaperPoints::of(solution, panel.panel)?;
        let named = std::mem::take(&mut labels[own.sheet]);
        // Images of points at rest are the pole itself.
        let is_asked = |name: &str| name == own.origin() || own.found().any(|(found, _)| found == name);
        let points = named.into_iter().filter(|(name, _)| is_asked(name)).filter_map(|(name, label)| {
            let vector = own.right(&name)? / panel.mu;
            Some(RightPoint {
                tolerance: BANDS * Tolerance::default().mm,
                label: html_text(&label),
                at: [vector.x, vector.y],
                name,
            })
        });
        let origin = panel.at(own.origin_on_panel().into());
        let lines = match solution.construction.plan_on(own.sheet) {
            Some(plan) => lines(solution, plan, panel.mu),
            None => lines_of_centers(solution, panel.mu),
        };
        Some(PlanInPhoto { sheet: own.sheet, mu: panel.mu, origin, points: points.collect(), lines })
    });
    found.collect()
}

/// The lines of a plan by their ends, each once.
fn lines(solution: &Solution, plan: &Plan, mu: f64) -> Vec<[[f64; 2]; 2]> {
    let words = solution.wording();
    let mut lines: Vec<[[f64; 2]; 2]> = Vec::new();
    for vector in Teller::new(solution, &words).vectors(plan) {
        let ends = vector.ends.each_ref().map(|name| plan.points.get(name).map(|point| point.vector / mu));
        let [Some(a), Some(b)] = ends else { continue };
        let line = [[a.x, a.y], [b.x, b.y]];
        if a != b && !lines.iter().any(|&[c, d]| [c, d] == line || [d, c] == line) {
            lines.push(line);
        }
    }
    lines
}

/// The lines that lead to instant centres, each over its places on the sheet.
fn lines_of_centers(solution: &Solution, mu: f64) -> Vec<[[f64; 2]; 2]> {
    let Some(centers) = solution.construction.centers.as_deref() else { return Vec::new() };
    let mut lines = Vec::new();
    for center in &centers.all {
        for line in center.lines() {
            let on_line = line.through.iter().map(|id| centers.get(*id).place).chain([center.place]);
            let places: Vec<_> = on_line.filter_map(|place| place.finite()).collect();
            let Some((first, others)) = places.split_first() else { continue };
            let Some(along) = others.iter().map(|place| *place - *first).find(|along| along.norm() > 0.0) else {
                continue;
            };
            let at = places.iter().map(|place| along.dot(&(*place - *first)) / along.norm_squared());
            let (low, high) = at.fold((0.0_f64, 0.0_f64), |(low, high), t| (low.min(t), high.max(t)));
            lines.push([low, high].map(|t| {
                let from_origin = (*first + along * t - solution.construction.origin) / mu;
                [from_origin.x, from_origin.y]
            }));
        }
    }
    lines
}

impl PlanInPhoto {
    /// A place of the plan, in mm from the origin with y up, on the sheet.
    fn on_sheet(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + x, self.origin[1] - y]
    }

    fn point(&self, name: &str) -> Option<&RightPoint> {
        self.points.iter().find(|point| point.name == name)
    }

    /// How sure places are at its points, in mm.
    fn bands(&self, sheet: &Upright) -> impl Iterator<Item = f64> {
        self.points.iter().map(|point| sheet.band(self.on_sheet(point.at)))
    }

    fn shown(&self, sheet: &Upright) -> PhotoPlan {
        let point = |point: &RightPoint| PhotoPoint {
            name: point.name.clone(),
            label: point.label.clone(),
            at: sheet.pixel(self.on_sheet(point.at)),
        };
        let line = |&[from, to]: &[[f64; 2]; 2]| {
            let length = hypot(to[0] - from[0], to[1] - from[1]);
            let count = (length / PIECE).ceil().max(1.0) as u32;
            let along = |share: f64| std::array::from_fn(|i| from[i] + share * (to[i] - from[i]));
            let places = (0..=count).map(|i| along(f64::from(i) / f64::from(count)));
            places.map(|place| sheet.pixel(self.on_sheet(place))).collect()
        };
        PhotoPlan {
            plan: self.sheet,
            mu: self.mu,
            points: self.points.iter().map(point).collect(),
            lines: self.lines.iter().map(line).collect(),
        }
    }
}

impl Photograph {
    /// The points that the pencil lines show.
    pub fn proposed(&mut self, desk: &mut Desk) -> Result<Vec<Proposed>, Refused> {
        self.find(desk)?;
        let points = self.found.iter().flat_map(|found| &found.points);
        let proposed = points.filter_map(|(index, proposal)| {
            let (plan, found) = (&self.plans[*index], proposal.found?);
            let place = self.place(found.at, plan.on_sheet(found.at), found.band, true);
            Some(Proposed { plan: plan.sheet, name: proposal.name.clone(), place })
        });
        Ok(proposed.collect())
    }

    /// Finds pencil lines, and among them the points of the plans, once.
    fn find(&mut self, desk: &mut Desk) -> Result<(), Refused> {
        if self.found.is_some() {
            return Ok(());
        }
        let strokes = self.sheet.sheet.strokes(&self.picture);
        let solution = desk.solution(&self.text)?;
        let pencilled: Vec<PencilledPlan<'_>> = PencilledPlan::on(solution, &self.sheet.sheet, &strokes).collect();
        let all = check::proposed(&usual_key(solution), &pencilled)?;
        let mut points = Vec::new();
        for proposal in all {
            let Some(index) = self.plans.iter().position(|plan| plan.sheet == proposal.sheet) else { continue };
            let own = self.plans[index].points.iter_mut().find(|point| point.name == proposal.name);
            if let Some(point) = own {
                point.tolerance = proposal.tolerance;
                points.push((index, proposal));
            }
        }
        self.found = Some(Pencil { strokes, points });
        Ok(())
    }

    /// A plan on the sheet with the pencil lines that were found.
    fn plan<'a>(&'a self, solution: &'a Solution, sheet: Sheet) -> Option<(&'a PlanInPhoto, PencilledPlan<'a>)> {
        let plan = self.plans.iter().find(|plan| plan.sheet == sheet)?;
        let mut pencilled = PencilledPlan::on(solution, &self.sheet.sheet, &self.found.as_ref()?.strokes);
        Some((plan, pencilled.find(|pencilled| pencilled.of() == sheet)?))
    }

    /// The place of a point that is tapped in the picture, in pixels: the crossing of pencil lines within `reach` mm, else the
    /// place itself, which the hand meets within `aim` mm with 95 %; none outside of the sheet.
    pub fn tapped(
        &mut self,
        desk: &mut Desk,
        plan: Sheet,
        pixel: [f64; 2],
        [reach, aim]: [f64; 2],
    ) -> Result<Option<Tapped>, Refused> {
        self.find(desk)?;
        let solution = desk.solution(&self.text)?;
        let (Some((_, plan)), Some(paper)) = (self.plan(solution, plan), self.sheet.paper(pixel)) else {
            return Ok(None);
        };
        let [width, height] = self.sheet.sheet.code.page.size_mm();
        if !((0.0..width).contains(&paper[0]) && (0.0..height).contains(&paper[1])) {
            return Ok(None);
        }
        let aimed = plan.aimed(paper, reach, aim);
        Ok(Some(self.place(plan.from_origin(aimed.at), aimed.at, aimed.band, aimed.is_crossing)))
    }

    /// A place of a plan and of its sheet, known within `band` mm.
    fn place(&self, at: [f64; 2], paper: [f64; 2], band: f64, is_snapped: bool) -> Tapped {
        let (pixel, band_pixels) = self.circle(paper, band);
        Tapped { at: at.map(hundredths), pixel, is_snapped, band: hundredths(band), band_pixels }
    }

    /// A circle on the sheet: its middle in the picture, and its radius in pixels.
    fn circle(&self, paper: [f64; 2], radius: f64) -> ([f64; 2], f64) {
        let at = self.sheet.pixel(paper);
        let across = self.sheet.pixel([paper[0] + 1.0, paper[1]]);
        (at, radius * hypot(across[0] - at[0], across[1] - at[1]))
    }

    /// How points of the student stand: where in the picture, and beside the right ones. Each plan hangs on its pole, on
    /// the printed one where the student has none.
    pub fn judged(&mut self, desk: &mut Desk, placed: &[PlacedPoint]) -> Result<Vec<PointVerdict>, Refused> {
        self.find(desk)?;
        let solution = desk.solution(&self.text)?;
        let place = |point: &PlacedPoint| check::PlacedPoint { at: point.at, band: point.band };
        let verdict = |point: &PlacedPoint| {
            let (plan, pencilled) = self.plan(solution, point.plan)?;
            let right = plan.point(&point.name)?;
            let own = place(point);
            let pole = plan.points.first().filter(|pole| pole.name != point.name);
            let pole = pole.and_then(|pole| placed.iter().find(|p| p.plan == plan.sheet && p.name == pole.name));
            let (off, verdict) = pencilled.judged(&own, pole.map(place).as_ref(), (right.at, right.tolerance));
            let (pixel, band_pixels) = self.circle(plan.on_sheet(point.at), pencilled.band(&own));
            Some(PointVerdict {
                plan: plan.sheet,
                name: point.name.clone(),
                pixel,
                band_pixels,
                off: hundredths(off),
                verdict,
            })
        };
        Ok(placed.iter().filter_map(verdict).collect())
    }
}

/// Sentences, one after the other.
fn told(language: &Language, sentences: &[Message]) -> String {
    let said = sentences.iter().map(|sentence| {
        let said = language.says(sentence);
        let mut letters = said.chars();
        letters.next().map_or(said.clone(), |first| first.to_uppercase().chain(letters).collect::<String>()) + "."
    });
    said.collect::<Vec<_>>().join(" ")
}

fn hypot(a: f64, b: f64) -> f64 {
    Vector::new(a, b).norm()
}
