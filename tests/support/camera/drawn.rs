//! The plans that a student of `support::students` draws, as pencil strokes on a page.

use super::pencil::Stroke;
use super::sketch::{Drawn, Habit, Line, Point, sketch};
use crate::random::Random;
use crate::students::hand::Skill;
use crate::students::plane::{Place, direction, size, unit};
use crate::students::sheet::{Sheet, ends_of};
use crate::students::task::{Planned, Task};

/// The names of a plan's pole.
const POLES: [&str; 3] = ["", "p", "π"];
/// A ray is drawn at least so long, in mm.
const RAY: f64 = 25.0;
/// Shorter vectors are not drawn, in mm.
const DOT: f64 = 0.3;

/// Where a plan is to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// 1: velocity plan, 2: acceleration plan.
    pub plan: usize,
    /// The pole, in mm of the page.
    pub pole: [f64; 2],
    /// Units of the plan per mm; none: as the student's scheme has it.
    pub mu: Option<f64>,
    /// The pole is printed with its letter; else the hand marks it.
    pub has_pole: bool,
}

/// What is on the page, and the truth about it.
#[derive(Clone, Debug)]
pub struct Drawing {
    pub strokes: Vec<Stroke>,
    /// The points of each plan where the student has them, in mm of the page, with the names of the form; of what is
    /// at rest there is the pole only.
    pub points: Vec<(usize, Point)>,
    /// The student's mistakes in words; none on an honest sheet.
    pub mistakes: Vec<String>,
}

impl Drawing {
    /// Whether all points lie so far from the edges of a page, in mm.
    pub fn fits(&self, page: [f64; 2], margin: f64) -> bool {
        let is_inside = |mm: [f64; 2]| (0..2).all(|i| mm[i] > margin && mm[i] < page[i] - margin);
        self.points.iter().all(|(_, point)| is_inside(point.mm))
    }

    /// The place of a point of a plan.
    pub fn place(&self, plan: usize, name: &str) -> Option<[f64; 2]> {
        self.points.iter().find(|(own, point)| *own == plan && point.name == name).map(|(_, point)| point.mm)
    }
}

/// The sheet of [`Task::hand_in`] with the same arguments, drawn on a page. The pencil wobbles about straight lines
/// between the student's places; those have the hand's errors and mistakes in them already.
pub fn drawn(task: &Task, planned: Option<&Planned>, skill: Skill, seed: u64, panels: &[Panel]) -> Drawing {
    let sheet = task.drawn(planned, skill, seed);
    let mut random = Random(seed ^ 0x009e_4c11);
    let habit = Habit::random(&mut random);
    let mut drawing = Drawing {
        strokes: Vec::new(),
        points: Vec::new(),
        mistakes: planned.map_or(Vec::new(), |planned| planned.causes.iter().map(|cause| cause.text.clone()).collect()),
    };
    for panel in panels {
        let points = points(&sheet, panel);
        let lines = lines(&sheet, panel);
        let marked = &points[usize::from(panel.has_pole)..];
        drawing.strokes.extend(sketch(marked, &lines, &habit, &mut random));
        drawing.points.extend(points.into_iter().map(|point| (panel.plan, point)));
    }
    drawing
}

/// The page's place of a place of the plan.
fn on_page(sheet: &Sheet<'_>, panel: &Panel, place: Place) -> [f64; 2] {
    let scale = panel.mu.map_or(1.0, |mu| sheet.scale(panel.plan) / mu);
    [panel.pole[0] + scale * place.re, panel.pole[1] - scale * place.im]
}

fn points(sheet: &Sheet<'_>, panel: &Panel) -> Vec<Point> {
    let pole = Point { name: POLES[panel.plan].to_owned(), mm: panel.pole };
    let images = &sheet.plans[panel.plan].images;
    let others = images.iter().map(|(name, place)| Point { name: name.clone(), mm: on_page(sheet, panel, *place) });
    std::iter::once(pole).chain(others).collect()
}

fn lines(sheet: &Sheet<'_>, panel: &Panel) -> Vec<Drawn> {
    let plan = panel.plan;
    let mut lines = Vec::new();
    let mut joined: Vec<[Place; 2]> = Vec::new();
    for trace in sheet.traces.iter().filter(|trace| trace.plan == plan) {
        let image = sheet.at(plan, &trace.ends[1]);
        let way = image - trace.start;
        if trace.is_vector {
            if size(way) > DOT {
                joined.push([trace.start, image]);
                lines.push((Line::Vector, trace.start, image));
            }
            continue;
        }
        // A ray goes through the crossing that was marked, if that tells its direction.
        let towards = if size(way) > 2.0 { direction(way) } else { trace.towards };
        let end = if size(way) > RAY { image } else { trace.start + unit(towards) * RAY };
        joined.push([trace.start, image]);
        lines.push((Line::Ray, trace.start, end));
    }
    for (from, to) in asked(sheet, plan) {
        let ends = [sheet.at(plan, &from), sheet.at(plan, &to)];
        let is_same = |other: &[Place; 2]| {
            let off = |k: usize| size(other[0] - ends[k]) + size(other[1] - ends[1 - k]);
            off(0).min(off(1)) < DOT
        };
        if size(ends[1] - ends[0]) > DOT && !joined.iter().any(is_same) {
            let line = if size(ends[0]) == 0.0 { Line::Vector } else { Line::Side };
            joined.push(ends);
            lines.push((line, ends[0], ends[1]));
        }
    }
    let placed = |(line, a, b)| Drawn { line, ends: [a, b].map(|place| on_page(sheet, panel, place)) };
    lines.into_iter().map(placed).collect()
}

/// The segments of a plan that the form asks for: they are drawn to be measured.
fn asked(sheet: &Sheet<'_>, plan: usize) -> Vec<(String, String)> {
    let names = sheet.scheme.form.iter().filter_map(|name| ends_of(name));
    let own = names.filter(|(own, from, to)| *own == plan && sheet.has(plan, from) && sheet.has(plan, to));
    own.map(|(_, from, to)| (from.to_owned(), to.to_owned())).collect()
}
