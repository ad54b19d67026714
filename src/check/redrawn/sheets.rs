//! The student's sheets as they were probably drawn: the places that are wrong, and the lines that lead there.

use super::super::checked::Judged;
use super::super::measured::{AnswerKey, Measured, PlacedPoint};
use super::super::mistakes::Candidate;
use super::super::model::{Model, in_order};
use super::super::on_paper::PaperPoints;
use super::super::report::significant;
use crate::construction::{LineId, MeasuredAs, OperationKind, PlaceId, Values};
use crate::drawing::{OwnKind, OwnLine, OwnPoint};
use crate::geometry::{Point, Vector, cross, degrees_of, turn_of_degrees, unit};
use crate::sheet::Sheet;
use crate::words::Medium;
use indexmap::IndexMap;

/// Distance on paper above which two places are visibly different, in mm.
const SEEN: f64 = 0.3;
/// Distance on paper from the right point above which a given point gets a name of its own, in mm.
const NAMED: f64 = 1.0;
/// Half the length of a line that crosses no other, in mm of paper.
const LONG: f64 = 400.0;

/// The sheets as they were probably drawn.
pub(super) struct Sheets<'a> {
    key: &'a AnswerKey<'a>,
    right: &'a Model,
    own: &'a Model,
    values: Values,
    /// The mistakes that were made.
    found: &'a [&'a Candidate],
    /// Places of given plan points, by sheet and name.
    given: IndexMap<(Sheet, String), Vector>,
    points: Vec<OwnPoint>,
    lines: Vec<OwnLine>,
}

impl<'a> Sheets<'a> {
    pub(super) fn new(key: &'a AnswerKey<'a>, right: &'a Model, own: &'a Model, found: &'a [&'a Candidate]) -> Self {
        Self {
            values: own.replay(&in_order(found.iter().flat_map(|candidate| candidate.changes()))),
            key,
            right,
            own,
            found,
            given: IndexMap::new(),
            points: Vec::new(),
            lines: Vec::new(),
        }
    }

    /// The points and lines to be drawn.
    pub(super) fn finish(mut self) -> (Vec<OwnPoint>, Vec<OwnLine>) {
        for ((sheet, name), place) in core::mem::take(&mut self.given) {
            let apart = self.right_place(sheet, &name).map_or(0.0, |right| (right - place).norm());
            let is_named = apart > NAMED * self.own.scales[sheet];
            self.point(sheet, &name, place, is_named);
        }
        (self.points, self.lines)
    }

    /// Places the given plan points with pole on pole, rotated to fit best what was probably drawn; returns the
    /// rotation of each sheet in degrees.
    pub(super) fn lay_points(&mut self, measured: &Measured) -> Vec<(Sheet, f64)> {
        let mut turns = Vec::new();
        for points in &measured.points {
            let sheet = points.sheet;
            let Some(on_paper) = PaperPoints::of(self.key.solution, sheet) else { continue };
            let (Some(pole), Some(mu)) = (points.origin(&on_paper), measured.mu[sheet]) else {
                continue;
            };
            let origin = Vector::from(points.places[pole].at);
            let from_pole = |place: &PlacedPoint| (Vector::from(place.at) - origin) * mu;
            let pair = |(name, place): (&String, &PlacedPoint)| {
                let construction = &self.own.construction;
                let id = construction.place(sheet, construction.plan_name(sheet, name))?;
                Some((from_pole(place), self.values.place(id)))
            };
            let pairs: Vec<(Vector, Vector)> = points.places.iter().filter_map(pair).collect();
            let degrees = best_turn(&pairs, SEEN * mu);
            for (name, place) in &points.places {
                let is_pole = name == pole;
                let name = if is_pole { on_paper.origin() } else { self.own.construction.plan_name(sheet, name) };
                let place: Vector = turn_of_degrees(degrees).transform_vector(&from_pole(place));
                self.given.insert((sheet, name.to_owned()), place);
            }
            turns.push((sheet, degrees));
        }
        turns
    }

    /// Draws the points that are not where they should be, with the lines that lead there, and the lengths that were
    /// measured wrongly.
    pub(super) fn draw_operations(&mut self) {
        for index in 0..self.own.construction.operations.len() {
            let sheet = self.own.construction.operations[index].sheet;
            let is_changed = self.found.iter().any(|candidate| candidate.instead_of(index).is_some());
            match *self.done(index) {
                OperationKind::Plot { place, .. } | OperationKind::Divide { place, .. }
                    if self.is_elsewhere(sheet, place) =>
                {
                    self.mark(sheet, place);
                }
                OperationKind::LayOff { place, from, .. } => {
                    let end = self.leads_to(place);
                    if self.is_elsewhere(sheet, end) {
                        self.mark(sheet, place);
                        self.line(sheet, end, [from, place].map(|p| self.at(sheet, p)), OwnKind::Vector, None);
                    }
                }
                OperationKind::Cross { place, ref lines } if self.is_elsewhere(sheet, place) => {
                    self.crossing(sheet, place, lines);
                }
                OperationKind::Measure { number, from, to, how } if is_changed => {
                    let value = self.values.number(number);
                    self.measured(sheet, [from, to], how, value);
                }
                _ => {}
            }
        }
    }

    /// Draws the links of a mechanism in another assembly mode.
    pub(super) fn draw_links(&mut self) {
        let mechanism = &self.key.solution.mechanism;
        for (_, body) in mechanism.links() {
            let place = |&point| self.own.construction.place(Sheet::Scheme, mechanism.point_name(point));
            let places: Vec<PlaceId> = body.points.iter().filter_map(place).collect();
            let next = places.iter().cycle().skip(1);
            let count = if places.len() > 2 { places.len() } else { 1 };
            for (&a, &b) in places.iter().zip(next).take(count) {
                if [a, b].into_iter().any(|p| self.is_elsewhere(Sheet::Scheme, p)) {
                    self.line(Sheet::Scheme, b, [a, b].map(|p| self.at(Sheet::Scheme, p)), OwnKind::Line, None);
                }
            }
        }
    }

    /// Draws a value that is a measured length, or the size of a vector, at the student's length from where it was
    /// probably begun.
    pub(super) fn draw_value(&mut self, index: usize, value: &Judged) {
        let Ok(reading) = self.own.readings[index] else {
            return;
        };
        let mut operations = self.own.construction.operations.iter();
        let drawn = operations.find_map(|operation| match operation.kind {
            OperationKind::Measure { number, from, to, how: MeasuredAs::Size | MeasuredAs::Along(_) }
                if number == reading.number =>
            {
                Some((operation.sheet, from, to))
            }
            OperationKind::LayOff { place, from, size, .. } if size == reading.number => {
                Some((operation.sheet, from, place))
            }
            _ => None,
        });
        let Some((sheet, from, to)) = drawn else {
            return;
        };
        let (start, end) = (self.at(sheet, from), self.at(sheet, to));
        if let Some(along) = unit(end - start) {
            let ends = [start, start + along * value.entry.value.abs()];
            let kind = if sheet == Sheet::Scheme { OwnKind::Line } else { OwnKind::Vector };
            self.line(sheet, to, ends, kind, Some(self.with_unit(sheet, value.entry.value)));
        }
    }

    /// Draws a length that was measured between other places, or along an axis.
    fn measured(&mut self, sheet: Sheet, [from, to]: [PlaceId; 2], how: MeasuredAs, value: f64) {
        let (start, end) = (self.at(sheet, from), self.at(sheet, to));
        let foot = match how {
            MeasuredAs::X => Vector::new(end.x, start.y),
            MeasuredAs::Y => Vector::new(start.x, end.y),
            _ => end,
        };
        self.line(sheet, to, [start, foot], OwnKind::Line, Some(self.with_unit(sheet, value)));
        self.line(sheet, to, [foot, end], OwnKind::Helper, None);
    }

    /// Draws a crossing with its two lines; in a plan with its vector from the pole.
    fn crossing(&mut self, sheet: Sheet, place: PlaceId, lines: &[LineId; 2]) {
        let at = self.at(sheet, place);
        let meets = at.norm().is_finite();
        let pole = sheet.order().and_then(|order| self.own.construction.place(sheet, order.pole()));
        if meets {
            self.mark(sheet, place);
            if let Some(pole) = pole {
                self.line(sheet, place, [self.at(sheet, pole), at], OwnKind::Vector, None);
            }
        }
        for line in lines {
            let starts = self.starts(*line);
            // The vector from the pole covers this line.
            if meets && starts.iter().any(|s| Some(*s) == pole) {
                continue;
            }
            let apart = |p: &Vector| (p - at).norm();
            let nearest = starts.into_iter().map(|s| self.at(sheet, s)).min_by(|a, b| apart(a).total_cmp(&apart(b)));
            let Some(start) = nearest else { continue };
            let (_, along) = self.values.line(*line);
            let half = along * (LONG * self.own.scales[sheet]);
            let ends = if meets { [start, at] } else { [start - half, start + half] };
            self.line(sheet, place, ends, OwnKind::Line, None);
        }
    }

    /// Places through which a line was drawn.
    fn starts(&self, line: LineId) -> Vec<PlaceId> {
        let mut done = (0..self.own.construction.operations.len()).map(|index| self.done(index));
        match done.find(|kind| kind.line() == Some(line)) {
            Some(OperationKind::Draw { through, .. }) => vec![*through],
            Some(OperationKind::Join { from, towards, .. }) => vec![*from, *towards],
            _ => Vec::new(),
        }
    }

    /// What the student did at an operation.
    fn done(&self, index: usize) -> &'a OperationKind {
        let changed = self.found.iter().find_map(|candidate| candidate.instead_of(index));
        changed.unwrap_or(&self.own.construction.operations[index].kind)
    }

    /// The magnitude of a value with its unit.
    fn with_unit(&self, sheet: Sheet, value: f64) -> String {
        let value = self.key.solution.wording().write(value.abs(), significant(4).on(Medium::Figure));
        format!("{value} {}", sheet.facts().drawn.unit(self.key.solution.scene.units))
    }

    /// The names of a place.
    fn names(&self, sheet: Sheet, place: PlaceId) -> impl Iterator<Item = &'a str> {
        let all = self.own.construction.named_places();
        all.filter_map(move |(of, name, id)| (of == sheet && id == place).then_some(name))
    }

    /// The name that the figure has for a place: the first that its plan shows.
    fn name(&self, sheet: Sheet, place: PlaceId) -> Option<&'a str> {
        let plan = self.key.solution.construction.plan_on(sheet);
        let is_shown = |name: &&str| plan.map_or(!name.is_empty(), |plan| plan.points.contains_key(*name));
        self.names(sheet, place).find(is_shown)
    }

    /// A place, as given or as replayed, relative to the sheet's pole or, in the scheme, to the construction's origin.
    fn at(&self, sheet: Sheet, place: PlaceId) -> Vector {
        let mut names = self.names(sheet, place);
        let given = names.find_map(|name| self.given.get(&(sheet, name.to_owned())));
        given.map_or_else(|| self.values.place(place), |place| *place)
    }

    /// The place of a point in the right drawing.
    fn right_place(&self, sheet: Sheet, name: &str) -> Option<Vector> {
        let id = self.right.construction.place(sheet, name)?;
        Some(self.right.exact.place(id))
    }

    /// Whether a place is visibly elsewhere than it should be, or at infinity.
    fn is_elsewhere(&self, sheet: Sheet, place: PlaceId) -> bool {
        let right = self.name(sheet, place).and_then(|name| self.right_place(sheet, name));
        right.is_some_and(|right| {
            let apart = (self.at(sheet, place) - right).norm();
            // A crossing of parallel lines is NaN.
            apart.is_nan() || apart > SEEN * self.own.scales[sheet]
        })
    }

    /// The named point to which a vector leads: its end, or that of the vectors laid off from there.
    fn leads_to(&self, place: PlaceId) -> PlaceId {
        if self.own.place_names[place.0].is_some() {
            return place;
        }
        let next = self.own.construction.operations.iter().find_map(|operation| match operation.kind {
            OperationKind::LayOff { place: end, from, .. } if from == place => Some(end),
            _ => None,
        });
        next.map_or(place, |end| self.leads_to(end))
    }

    /// Marks a place, unless the sheet's points are given: these are marked anyway.
    fn mark(&mut self, sheet: Sheet, place: PlaceId) {
        let is_given = self.given.keys().any(|(of, _)| *of == sheet);
        if !is_given && let Some(name) = self.name(sheet, place) {
            self.point(sheet, name, self.at(sheet, place), true);
        }
    }

    fn point(&mut self, sheet: Sheet, name: &str, at: Vector, is_named: bool) {
        if at.norm().is_finite() {
            self.points.push(OwnPoint { panel: sheet, name: name.to_owned(), at: self.on_figure(sheet, at), is_named });
        }
    }

    fn line(&mut self, sheet: Sheet, leads_to: PlaceId, ends: [Vector; 2], kind: OwnKind, label: Option<String>) {
        let is_drawable = ends.iter().all(|end| end.norm().is_finite()) && ends[0] != ends[1];
        if is_drawable && let Some(name) = self.name(sheet, leads_to) {
            self.lines.push(OwnLine {
                panel: sheet,
                leads_to: name.to_owned(),
                ends: ends.map(|end| self.on_figure(sheet, end)),
                kind,
                label,
            });
        }
    }

    /// A place of a sheet in the panel's coordinates.
    fn on_figure(&self, sheet: Sheet, at: Vector) -> Point {
        match sheet {
            Sheet::Scheme | Sheet::Centers | Sheet::Speeds => self.own.construction.origin + at,
            Sheet::Velocity | Sheet::Acceleration | Sheet::Forces | Sheet::Lever => Point::from(at),
        }
    }
}

/// The rotation in degrees that brings the first of each pair nearest to the second: the sum of distances, not of their
/// squares, is least, so that one wrong point does not turn the right ones. Distances below `near` count alike.
///
/// Repeated least squares, tan = Σ q × r / Σ q · r, each time with weights 1 / distance (Weiszfeld 1937).
pub fn best_turn(pairs: &[(Vector, Vector)], near: f64) -> f64 {
    const ROUNDS: usize = 30;
    let mut degrees = 0.0;
    for round in 0..ROUNDS {
        let mut sums = Vector::zeros();
        for (q, r) in pairs.iter().filter(|(_, r)| r.norm().is_finite()) {
            let apart = (turn_of_degrees(degrees).transform_vector(q) - r).norm();
            let weight = if round == 0 { 1.0 } else { 1.0 / apart.max(near) };
            sums += Vector::new(q.dot(r), cross(*q, *r)) * weight;
        }
        degrees = degrees_of(sums);
    }
    degrees
}
