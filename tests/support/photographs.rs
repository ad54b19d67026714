//! Sheets of exercises with students' drawings, photographed by the tests' camera, and what reading them comes to.

use super::camera::chance::Kind;
use super::camera::drawn::{Drawing, Panel, drawn};
use super::camera::page::Page;
use super::camera::{Photograph, Shot};
use super::files;
use super::random::Random;
use super::stages::{answer_key, solved};
use super::students::hand::{RIGHT, SKILLS};
use super::students::judge::{Class, Said, class};
use super::students::script;
use super::students::sheet::ends_of;
use super::students::task::{Planned, Task};
use kinegon::Sheet;
use kinegon::check::{
    AnswerKey, Measured, PaperPoints, PencilledPlan, PointVerdict, PointsOf, Proposal, check, check_result, proposed,
};
use kinegon::cli::picture;
use kinegon::drawing::markers::SheetCode;
use kinegon::exercise::Exercises;
use kinegon::photo::{self, PhotoSheet, Picture, Stroke};
use std::sync::{Mutex, PoisonError};

/// A grey, upright picture from a file's bytes, as the program reads it.
pub fn decoded(bytes: &[u8]) -> Picture {
    picture::decoded(bytes).expect("a picture")
}

/// A student's exercise, with the sheets that are drawn on.
pub struct Given {
    pub task: Task,
    /// By sheet with markers: its code and its SVG.
    pub sheets: Vec<(SheetCode, String)>,
}

/// The exercise of that number, of all kinds by turns; none where its kind has none for this number.
pub fn given(number: u64) -> Option<Given> {
    let kinds: Vec<&'static str> = script::kinds().collect();
    let kind = kinds[number as usize % kinds.len()];
    let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
    let text = files::read(&format!("{folder}/{kind}.json"));
    let base = solved(&text).expect("a good scene");
    let mut exercises = Exercises::new(&base, None, number).ok()?;
    let exercise = exercises.next().ok()?;
    let task = Task::new(kind, &exercise.text)?;
    let sheets = exercise.sheets(kind).into_iter();
    let sheets = sheets.filter_map(|sheet| Some((sheet.code.clone()?, sheet.svg()))).collect();
    Some(Given { task, sheets })
}

/// The plans of a sheet as panels of the tests' hand.
pub fn panels(code: &SheetCode) -> Vec<Panel> {
    let plans = code.panels.iter().filter(|panel| panel.panel != Sheet::Scheme);
    plans.map(|p| Panel { plan: p.panel as usize, pole: p.origin, mu: Some(p.mu), has_pole: true }).collect()
}

/// The picture of a sheet of that kind and number, with so many pixels along its longer edge at most.
pub fn by_lot(sheet: &(SheetCode, String), kind: Kind, number: u64, edge: usize) -> Photograph {
    let picture = Photograph::random(number, kind, sheet.0.page.size_mm());
    let own = picture.size[0].max(picture.size[1]);
    picture.with_edge(edge.min(own))
}

/// A photograph of a sheet with a drawing on it: the file and the truth.
pub fn photographed(sheet: &(SheetCode, String), drawing: &Drawing, picture: &Photograph) -> Shot {
    let per_mm = if picture.size[0].max(picture.size[1]) > 2000 { 24 } else { 12 };
    let page = blank(sheet, per_mm);
    picture.take(Some(&page.printed(&drawing.strokes, picture.seed)))
}

/// The sheet as it comes from the printer: the last one is kept, for it is often photographed again.
fn blank((code, svg): &(SheetCode, String), per_mm: usize) -> Page {
    static LAST: Mutex<Option<(String, usize, Page)>> = Mutex::new(None);
    let last = || LAST.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, _, page)) = last().as_ref().filter(|(last, fine, _)| last == svg && *fine == per_mm) {
        return page.clone();
    }
    let page = Page::draw(svg, code.page.size_mm(), per_mm, &Default::default());
    *last() = Some((svg.clone(), per_mm, page.clone()));
    page
}

/// What proposals for a student's plans come to.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    pub photographs: usize,
    pub read: usize,
    /// Points proposed within 0.5 mm of where the student has them, elsewhere, and not at all.
    pub right: usize,
    pub wrong: usize,
    pub left: usize,
    /// Points proposed whose radius holds the true place.
    pub covered: usize,
    /// Verdicts that are not those on the true places.
    pub misjudged: usize,
    pub untold: usize,
    /// Sheets with mistakes in the drawing, those of which the check tells all: from the typed form; with the plans' segments from the points that are proposed; and with those that
    /// the student taps besides.
    pub planted: usize,
    pub named: [usize; 3],
    pub told: Vec<String>,
}

impl Tally {
    pub fn join(&mut self, other: Tally) {
        self.photographs += other.photographs;
        self.read += other.read;
        self.right += other.right;
        self.wrong += other.wrong;
        self.left += other.left;
        self.covered += other.covered;
        self.misjudged += other.misjudged;
        self.untold += other.untold;
        self.planted += other.planted;
        self.named = std::array::from_fn(|i| self.named[i] + other.named[i]);
        self.told.extend(other.told);
    }
}

/// Photographs the plans of an exercise with a student's drawing, and tells points and mistakes from the pictures.
pub fn tally(number: u64, kind: Kind, edge: usize, tally: &mut Tally) {
    let Some(given) = given(number) else { return };
    let mut random = Random(number * 7919);
    let skill = SKILLS[1 + number as usize % 3];
    let task = &given.task;
    let planned: Option<Planned> =
        if number.is_multiple_of(4) { None } else { (0..50).find_map(|_| task.plan(&mut random, &skill)) };
    let key = answer_key(&task.solution, 5);
    let codes: Vec<SheetCode> = given.sheets.iter().map(|sheet| sheet.0.clone()).collect();
    let mut photos: Vec<(PhotoSheet, Vec<Stroke>)> = Vec::new();
    let mut truth: Vec<(Sheet, String, [f64; 2])> = Vec::new();
    for sheet in given.sheets.iter().filter(|sheet| !panels(&sheet.0).is_empty()) {
        let panels = panels(&sheet.0);
        let drawing = drawn(task, planned.as_ref(), skill, number, &panels);
        let picture = decoded(&photographed(sheet, &drawing, &by_lot(sheet, kind, number, edge)).jpeg);
        tally.photographs += 1;
        let found = match photo::read(&picture, || codes.clone()) {
            Ok(found) => found,
            Err(refusal) => {
                tally.told.push(format!("{} {number}: {refusal}", task.kind));
                continue;
            }
        };
        tally.read += 1;
        let lines = found.strokes(&picture);
        for (plan, point) in &drawing.points {
            let pole = panels.iter().find(|panel| panel.plan == *plan).expect("its panel").pole;
            truth.push((sheet_of(*plan), point.name.clone(), [point.mm[0] - pole[0], pole[1] - point.mm[1]]));
        }
        photos.push((found, lines));
    }
    let plans: Vec<PencilledPlan<'_>> =
        photos.iter().flat_map(|(found, strokes)| PencilledPlan::on(&task.solution, found, strokes)).collect();
    let Ok(proposals) = proposed(&key, &plans) else { return };
    let mut points = compare(&proposals, &truth, task, tally);
    for plan in &plans {
        if points.iter().all(|points| points.sheet != plan.of()) {
            let mut own = PointsOf::new(plan.of());
            own.put(plan.points.origin(), [0.0; 2], Some(0.1));
            points.push(own);
        }
    }
    let Some(planned) = planned.filter(|planned| are_drawn(task, planned)) else { return };
    let mut typed = task.hand_in(Some(&planned), skill, number);
    let told = |form: &Measured| class_of(form, &key, &planned);
    tally.planted += 1;
    tally.named[0] += usize::from(told(&typed) == Class::Named);
    typed.values.retain(|value| !(value.name.starts_with("vplan") || value.name.starts_with("aplan")));
    typed.points = points;
    for plan in &plans {
        typed.mu[plan.of()] = Some(plan.mu);
    }
    tally.named[1] += usize::from(told(&typed) == Class::Named);
    let left: Vec<(Sheet, String)> =
        proposals.iter().filter(|point| point.found.is_none()).map(|point| (point.sheet, point.name.clone())).collect();
    tap(&mut typed.points, &plans, &left, &truth, task, &mut random);
    tally.named[2] += usize::from(told(&typed) == Class::Named);
}

/// Whether all mistakes are in the drawing or in numbers: a segment that is right and only read or written wrongly is so in no photograph.
fn are_drawn(task: &Task, planned: &Planned) -> bool {
    let [right, wrong] = [None, Some(planned)].map(|planned| task.drawn(planned, RIGHT, 1));
    let is_drawn = |name: &String| match ends_of(name) {
        Some((plan, from, to)) if plan > 0 => {
            let [right, wrong] = [&right, &wrong].map(|sheet| sheet.at(plan, to) - sheet.at(plan, from));
            right != wrong
        }
        _ => true,
    };
    planned.causes.iter().all(|cause| cause.begins.iter().any(is_drawn))
}

/// Adds the points that nobody proposes, as a finger sets them: within a millimetre, at the crossing of lines there if there is one.
fn tap(
    points: &mut [PointsOf],
    plans: &[PencilledPlan<'_>],
    left: &[(Sheet, String)],
    truth: &[(Sheet, String, [f64; 2])],
    task: &Task,
    random: &mut Random,
) {
    for (sheet, name) in left {
        let own = |(other, same, _): &&(Sheet, String, [f64; 2])| sheet == other && is_same(task, *sheet, name, same);
        let Some((_, _, at)) = truth.iter().find(own) else { continue };
        let Some(plan) = plans.iter().find(|plan| plan.of() == *sheet) else { continue };
        let Some(own) = points.iter_mut().find(|points| points.sheet == *sheet) else { continue };
        let finger = plan.on_sheet([at[0] + random.between(-0.7, 0.7), at[1] + random.between(-0.7, 0.7)]);
        let (place, band) = match photo::crossing(plan.strokes, kinegon::geometry::Point::from(finger), 1.5) {
            Some(crossing) => ([crossing.at.x, crossing.at.y], crossing.band.max(0.2)),
            None => (finger, 1.0),
        };
        own.put(name.as_str(), plan.from_origin(place), Some(band));
    }
}

/// Whether two names mean one point of a plan.
fn is_same(task: &Task, sheet: Sheet, one: &str, other: &str) -> bool {
    let construction = &task.solution.construction;
    let place = |name: &str| construction.place(sheet, construction.plan_name(sheet, name));
    place(one) == place(other)
}

/// How well what is told of a form fits what was planted.
fn class_of(form: &Measured, key: &AnswerKey<'_>, planned: &Planned) -> Class {
    let checked = check(form, key).expect("a form that is understood");
    class(&Said::new(&check_result(&checked, key, None)), planned)
}

fn sheet_of(plan: usize) -> Sheet {
    if plan == 1 { Sheet::Velocity } else { Sheet::Acceleration }
}

/// Compares proposals with the truth; the places of the points that were proposed.
fn compare(
    proposals: &[Proposal],
    truth: &[(Sheet, String, [f64; 2])],
    task: &Task,
    tally: &mut Tally,
) -> Vec<PointsOf> {
    let mut found: Vec<PointsOf> = Vec::new();
    for point in proposals {
        let own = |(sheet, name, _): &&(Sheet, String, [f64; 2])| {
            *sheet == point.sheet && is_same(task, *sheet, name, &point.name)
        };
        let Some((_, _, at)) = truth.iter().find(own) else { continue };
        let distance = |a: [f64; 2], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]);
        let Some(spot) = point.found else {
            tally.left += 1;
            continue;
        };
        let (error, off) = (distance(spot.at, *at), distance(point.right, *at));
        if error <= 0.5 {
            tally.right += 1;
        } else {
            tally.wrong += 1;
            tally.told.push(format!("{} {} is at {at:.1?}, proposed at {:.1?}", task.kind, point.name, spot.at));
        }
        tally.covered += usize::from(error <= spot.band);
        match spot.verdict {
            PointVerdict::Right => tally.misjudged += usize::from(off > point.tolerance),
            PointVerdict::Off => tally.misjudged += usize::from(off <= point.tolerance),
            PointVerdict::CannotTell => tally.untold += 1,
        }
        let index = found.iter().position(|points| points.sheet == point.sheet).unwrap_or_else(|| {
            let mut points = PointsOf::new(point.sheet);
            let origin = PaperPoints::of(&task.solution, point.sheet).expect("a plan that is there").origin();
            points.put(origin, [0.0; 2], Some(0.1));
            found.push(points);
            found.len() - 1
        });
        found[index].put(point.name.as_str(), spot.at, Some(spot.band));
    }
    found
}
