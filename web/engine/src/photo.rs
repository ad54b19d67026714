//! The last photograph of a sheet: the right plans over it, what is tapped on it, how its points stand.

use crate::desk::Desk;
use crate::photo_answers::{Photo, PhotoPlan, PhotoPoint, PhotoRead, PhotoRefused, PlacedPoint, PointVerdict, Tapped};
use crate::refused::Refused;
use kinegon::Solution;
use kinegon::check::{BANDS, form_boxes, plan_points};
use kinegon::construction::{Plan, PointRole, Teller, Tolerance};
use kinegon::drawing::markers::{PlacedPanel, SheetCode};
use kinegon::format::html_text;
use kinegon::geometry::{Point, Vector};
use kinegon::photo::{self, Crossing, PhotoSheet, Picture, Stroke, crossing, strokes};
use kinegon::quantity::{Asked, What, pencil};
use kinegon::scene::PanelName;

/// Distance of places at which the paper is looked at, in mm: a pencil line is three to five of them wide.
const STEP: f64 = 0.1;
/// Edge of the sheet on which nobody draws, with the markers in it, in mm.
const EDGE: f64 = 16.0;
/// Length of the straight pieces by which a line of the plan follows the picture, in mm of paper.
const PIECE: f64 = 8.0;
/// Radius that holds a place that a hand has aimed at with 95 %, in mm.
const AIMED: f64 = 0.5;

/// A photograph of a sheet that has plans of the scene.
pub struct Photograph {
    picture: Picture,
    sheet: Upright,
    plans: Vec<PlanInPhoto>,
    strokes: Option<Vec<Stroke>>,
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
        let size = if self.turn % 2 == 0 { [width, height] } else { [height, width] };
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

/// A plan on the sheet.
struct PlanInPhoto {
    key: &'static str,
    panel: PlacedPanel,
    points: Vec<RightPoint>,
}

/// A point of the right plan; lengths in mm.
struct RightPoint {
    name: String,
    label: String,
    /// From the pole, y up.
    at: [f64; 2],
    /// How far an honest hand may be off.
    allowed: f64,
}

/// Reads a photograph of a sheet of this scene; one that can be measured on is kept.
pub fn read(
    desk: &mut Desk,
    text: &str,
    size: [usize; 2],
    grey: Vec<u8>,
) -> Result<(PhotoRead, Option<Photograph>), Refused> {
    let picture = Picture::new(size[0], size[1], grey)
        .ok_or_else(|| Refused::whole("the picture has not as many pixels as its width and height say"))?;
    let solution = desk.solution(text)?;
    let sheet = match photo::read(&picture) {
        Ok(sheet) => sheet,
        Err(why) => return Ok((PhotoRead { photo: None, refused: Some(PhotoRefused::of(&why)) }, None)),
    };
    let sheet = Upright::new(sheet, &picture);
    let code = &sheet.sheet.code;
    let is_own = code.scene == solution.scene.fingerprint();
    let plans = if is_own { plans(solution, code) } else { Vec::new() };
    let shown = plans.iter().map(|(plan, lines)| plan.shown(&sheet, lines)).collect();
    let photo = Photo {
        name: code.name.clone(),
        number: code.number,
        is_own,
        turn: sheet.turn,
        per_mm: sheet.per_mm(),
        bend: sheet.sheet.bend(),
        band: plans.iter().flat_map(|(plan, _)| plan.bands(&sheet)).fold(0.0, f64::max),
        plans: shown,
    };
    let plans: Vec<PlanInPhoto> = plans.into_iter().map(|(plan, _)| plan).collect();
    let kept = (!plans.is_empty()).then(|| Photograph { picture, sheet, plans, strokes: None });
    Ok((PhotoRead { photo: Some(photo), refused: None }, kept))
}

/// The plans on a sheet, each with the ends of its lines by names.
fn plans(solution: &Solution, code: &SheetCode) -> Vec<(PlanInPhoto, Vec<[String; 2]>)> {
    let construction = &solution.construction;
    let mut labels = plan_points(solution);
    let found = code.panels.iter().filter_map(|panel| {
        let (key, index, kind) = match panel.panel {
            PanelName::Velocity => ("velocity", 0, kinegon::construction::Sheet::Velocity),
            PanelName::Acceleration => ("acceleration", 1, kinegon::construction::Sheet::Acceleration),
            _ => return None,
        };
        let plan = construction.plan_on(kind)?;
        let named = std::mem::take(&mut labels[index]);
        let allowed = Allowed::of(solution, plan, panel, named.iter().map(|(name, _)| name.as_str()));
        // Images of points at rest are the pole itself.
        let is_asked =
            |name: &str| name == plan.kind.pole() || plan.points.get(name).is_some_and(|p| p.role != PointRole::Pole);
        let points = named.into_iter().filter(|(name, _)| is_asked(name)).filter_map(|(name, label)| {
            let vector = plan.points.get(&name)?.vector / panel.mu;
            Some(RightPoint { allowed: allowed.at(&name), label: html_text(&label), at: [vector.x, vector.y], name })
        });
        let points = points.collect();
        Some((PlanInPhoto { key, panel: *panel, points }, lines(solution, plan)))
    });
    found.collect()
}

/// The lines of a plan by the names of their ends, each once.
fn lines(solution: &Solution, plan: &Plan) -> Vec<[String; 2]> {
    let words = solution.wording();
    let mut lines: Vec<[String; 2]> = Vec::new();
    for vector in Teller::new(solution, &words).vectors(plan) {
        let [a, b] = vector.ends;
        if !lines.iter().any(|[c, d]| (c == &a && d == &b) || (c == &b && d == &a)) {
            lines.push([a, b]);
        }
    }
    lines
}

/// How far an honest hand may be off at a plan's points, in mm: by the segments that end there.
struct Allowed(Vec<([String; 2], f64)>);

impl Allowed {
    fn of<'n>(solution: &Solution, plan: &Plan, panel: &PlacedPanel, names: impl Iterator<Item = &'n str>) -> Allowed {
        let mut scales = solution.scales();
        match panel.panel {
            PanelName::Acceleration => scales.acceleration = Some(panel.mu),
            _ => scales.velocity = Some(panel.mu),
        }
        let from_pole = names.map(|name| plan.kind.segment_name(plan.kind.pole(), name));
        let mut asked: Vec<Asked> = from_pole.filter_map(|name| Asked::new(&name, &solution.mechanism).ok()).collect();
        asked.extend(form_boxes(solution).into_iter().map(|found| found.asked));
        let bands = pencil(solution, &scales, Tolerance::default(), asked);
        let of_segment = |(asked, band): &(Asked, Result<kinegon::quantity::Band, _>)| match (asked.what(), band) {
            (What::Segment { kind, from, to, .. }, Ok(band)) if *kind == plan.kind => {
                Some(([from.clone(), to.clone()], band.band / panel.mu))
            }
            _ => None,
        };
        Allowed(bands.quantities.iter().filter_map(of_segment).collect())
    }

    fn at(&self, name: &str) -> f64 {
        let ending = self.0.iter().filter(|(ends, _)| ends.iter().any(|end| end == name));
        BANDS * ending.map(|(_, band)| *band).fold(Tolerance::default().mm, f64::max)
    }
}

impl PlanInPhoto {
    /// A place of the plan, in mm from the pole with y up, on the sheet.
    fn on_sheet(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.panel.origin[0] + x, self.panel.origin[1] - y]
    }

    /// A place of the sheet in the plan.
    fn in_plan(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x - self.panel.origin[0], self.panel.origin[1] - y]
    }

    fn point(&self, name: &str) -> Option<&RightPoint> {
        self.points.iter().find(|point| point.name == name)
    }

    /// How sure places are at its points, in mm.
    fn bands(&self, sheet: &Upright) -> impl Iterator<Item = f64> {
        self.points.iter().map(|point| sheet.band(self.on_sheet(point.at)))
    }

    fn shown(&self, sheet: &Upright, lines: &[[String; 2]]) -> PhotoPlan {
        let point = |point: &RightPoint| PhotoPoint {
            name: point.name.clone(),
            label: point.label.clone(),
            at: sheet.pixel(self.on_sheet(point.at)),
        };
        let line = |[from, to]: &[String; 2]| {
            let [from, to] = [self.point(from)?.at, self.point(to)?.at];
            let length = hypot(to[0] - from[0], to[1] - from[1]);
            let count = (length / PIECE).ceil().max(1.0) as u32;
            let along = |share: f64| std::array::from_fn(|i| from[i] + share * (to[i] - from[i]));
            let places = (0..=count).map(|i| along(f64::from(i) / f64::from(count)));
            Some(places.map(|place| sheet.pixel(self.on_sheet(place))).collect())
        };
        PhotoPlan {
            plan: self.key,
            mu: self.panel.mu,
            points: self.points.iter().map(point).collect(),
            lines: lines.iter().filter_map(line).collect(),
        }
    }
}

impl Photograph {
    /// Finds the pencil lines, once; their number.
    pub fn lines(&mut self) -> usize {
        let strokes = self.strokes.get_or_insert_with(|| {
            let [width, height] = self.sheet.sheet.code.page.size_mm();
            let corners = [[EDGE, EDGE], [width - EDGE, height - EDGE]];
            strokes(&self.sheet.sheet.straightened(&self.picture, corners, STEP))
        });
        strokes.len()
    }

    /// The place of a plan that is tapped in the picture, in pixels: the crossing of pencil lines within `reach` mm, else the
    /// place itself.
    pub fn tapped(&mut self, plan: &str, pixel: [f64; 2], reach: f64) -> Option<Tapped> {
        self.lines();
        let plan = self.plans.iter().find(|known| known.key == plan)?;
        let aimed = self.sheet.paper(pixel)?;
        let found = nearest(self.strokes.as_deref().unwrap_or_default(), Point::from(aimed), reach);
        let (paper, own) = match found {
            Some(Crossing { at, band, .. }) => ([at.x, at.y], band),
            None => (aimed, AIMED),
        };
        let band = hypot(own, self.sheet.band(paper));
        let (pixel, band_pixels) = self.circle(paper, band);
        Some(Tapped {
            at: plan.in_plan(paper).map(hundredths),
            pixel,
            is_snapped: found.is_some(),
            band: hundredths(band),
            band_pixels,
        })
    }

    /// A circle on the sheet: its middle in the picture, and its radius in pixels.
    fn circle(&self, paper: [f64; 2], radius: f64) -> ([f64; 2], f64) {
        let at = self.sheet.pixel(paper);
        let across = self.sheet.pixel([paper[0] + 1.0, paper[1]]);
        (at, radius * hypot(across[0] - at[0], across[1] - at[1]))
    }

    /// How points of the student stand: where in the picture, and beside the right ones. Each plan hangs on its pole, on
    /// the printed one where the student has none.
    pub fn judged(&self, placed: &[PlacedPoint]) -> Vec<PointVerdict> {
        let verdict = |point: &PlacedPoint| {
            let plan = self.plans.iter().find(|plan| plan.key == point.plan)?;
            let right = plan.point(&point.name)?;
            let band =
                |of: &PlacedPoint| of.band.unwrap_or_else(|| hypot(AIMED, self.sheet.band(plan.on_sheet(of.at))));
            let pole = plan.points.first().filter(|pole| pole.name != point.name);
            let pole = pole.and_then(|pole| placed.iter().find(|p| p.plan == plan.key && p.name == pole.name));
            let origin = pole.map_or([0.0; 2], |pole| pole.at);
            let off = hypot(point.at[0] - origin[0] - right.at[0], point.at[1] - origin[1] - right.at[1]);
            let unsure = hypot(band(point), pole.map_or(0.0, band));
            let verdict = if off + unsure <= right.allowed {
                "right"
            } else if off - unsure > right.allowed {
                "off"
            } else {
                "open"
            };
            let (pixel, band_pixels) = self.circle(plan.on_sheet(point.at), band(point));
            Some(PointVerdict {
                plan: plan.key,
                name: point.name.clone(),
                pixel,
                band_pixels,
                off: hundredths(off),
                verdict,
            })
        };
        placed.iter().filter_map(verdict).collect()
    }
}

/// The crossing of pencil lines nearest to a place, at most `reach` mm away: under a finger on a small screen there may be more
/// than one.
fn nearest(strokes: &[Stroke], near: Point, reach: f64) -> Option<Crossing> {
    let beside =
        |step: f64| [(step, 0.0), (0.0, step), (-step, 0.0), (0.0, -step)].map(|(x, y)| near + Vector::new(x, y));
    let around = [near].into_iter().chain([1.0, 2.0].into_iter().flat_map(|ring| beside(ring * photo::SNAP)));
    let far = |found: &Crossing| (found.at - near).norm();
    let found = around.filter(|place| (place - near).norm() <= reach).filter_map(|place| crossing(strokes, place));
    found.filter(|found| far(found) <= reach.max(photo::SNAP)).min_by(|a, b| far(a).total_cmp(&far(b)))
}

/// A length in mm, to 0.01.
fn hundredths(mm: f64) -> f64 {
    (100.0 * mm).round() / 100.0 + 0.0
}

fn hypot(a: f64, b: f64) -> f64 {
    Vector::new(a, b).norm()
}
