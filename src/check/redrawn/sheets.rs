//! The student's sheets: where each place is, and which lines lead there.

use super::super::answer_key::AnswerKey;
use super::super::mistakes::Candidate;
use super::super::model::{Changes, Edit, Model};
use super::super::report::significant;
use super::super::sheet::Measured;
use super::super::verdict::Judged;
use super::panel;
use crate::construction::{Change, Disturbance, Does, How, LineId, PlaceId, Sheet, Values};
use crate::drawing::{OwnKind, OwnLine, OwnPoint};
use crate::geometry::{Point, Vector, cross, degrees_of, turn_of_degrees, unit};
use crate::quantity::Kind;
use crate::words::{Medium, Wording};
use indexmap::IndexMap;

/// So far apart on paper, in mm, a place is seen to be another one.
const SEEN: f64 = 0.3;
/// From this distance on paper, in mm, a given point bears its own name beside that of the right one.
const NAMED: f64 = 1.0;
/// A line that meets no other is drawn so long, in mm of paper.
const LONG: f64 = 400.0;

/// The sheets as they were probably drawn.
pub(super) struct Sheets<'a> {
    key: &'a AnswerKey<'a>,
    right: &'a Model,
    own: &'a Model,
    values: Values,
    /// What was done instead of an operation.
    instead: Vec<(usize, &'a Does)>,
    /// Points of plans that are given, by their names.
    given: IndexMap<(Sheet, String), Vector>,
    words: &'a Wording,
    points: Vec<OwnPoint>,
    lines: Vec<OwnLine>,
}

impl<'a> Sheets<'a> {
    pub(super) fn new(
        key: &'a AnswerKey<'a>,
        right: &'a Model,
        own: &'a Model,
        found: &[&'a Candidate],
        words: &'a Wording,
    ) -> Self {
        let mut changes = Changes::new();
        let mut instead = Vec::new();
        for candidate in found {
            for (operation, edit) in &candidate.edits {
                let change = edit.change();
                changes.push(Disturbance { operation: *operation, change });
                if let Edit::Instead(does) = edit {
                    instead.push((*operation, does));
                }
            }
            for &(operation, number, value) in &candidate.goes_on {
                let change = Change::Written(number, value);
                changes.push(Disturbance { operation, change });
            }
        }
        changes.sort_by_key(|c| c.operation);
        Self {
            values: own.replay(&changes),
            key,
            right,
            own,
            instead,
            given: IndexMap::new(),
            words,
            points: Vec::new(),
            lines: Vec::new(),
        }
    }

    /// What was drawn: points and lines.
    pub(super) fn finish(mut self) -> (Vec<OwnPoint>, Vec<OwnLine>) {
        for ((sheet, name), place) in core::mem::take(&mut self.given) {
            let apart = self.right_place(sheet, &name);
            let apart = apart.map_or(0.0, |right| (right - place).norm());
            let is_named = apart > NAMED * self.per_mm(sheet);
            self.point(sheet, &name, place, is_named);
        }
        (self.points, self.lines)
    }

    /// Lays the points of plans that are given with pole on pole, and turns them as they fit best to what was probably drawn; by how many degrees.
    pub(super) fn lay_points(&mut self, measured: &Measured) -> Vec<(Sheet, f64)> {
        let mut turns = Vec::new();
        for points in &measured.points {
            let sheet = points.kind.sheet();
            let (Some(pole), Some(mu)) = (points.pole(), measured.mu[sheet as usize]) else {
                continue;
            };
            let origin = Vector::from(points.places[pole]);
            let own = |place: &[f64; 2]| (Vector::from(*place) - origin) * mu;
            let pairs = points.places.iter().filter_map(|(name, place)| {
                let id = self.own.construction.place(sheet, name)?;
                Some((own(place), self.values.place(id)))
            });
            let pairs: Vec<(Vector, Vector)> = pairs.collect();
            let degrees = best_turn(&pairs, SEEN * mu);
            for (name, place) in &points.places {
                let is_pole = name == pole;
                let name = if is_pole { points.kind.pole() } else { name };
                let place: Vector = turn_of_degrees(degrees).transform_vector(&own(place));
                self.given.insert((sheet, name.to_owned()), place);
            }
            turns.push((sheet, degrees));
        }
        turns
    }

    /// Draws the points that are not where they should be, with the lines that lead there, and lengths that were measured otherwise.
    pub(super) fn draw_operations(&mut self) {
        for index in 0..self.own.construction.operations.len() {
            let sheet = self.own.construction.operations[index].sheet;
            let is_changed = self.instead.iter().any(|(operation, _)| *operation == index);
            match *self.done(index) {
                Does::Plot { place, .. } if self.is_elsewhere(sheet, place) => {
                    self.mark(sheet, place);
                }
                Does::LayOff { place, from, .. } => {
                    let end = self.leads_to(place);
                    if self.is_elsewhere(sheet, end) {
                        self.mark(sheet, place);
                        let ends = [from, place].map(|p| self.at(sheet, p));
                        self.line(sheet, end, ends, OwnKind::Vector, None);
                    }
                }
                Does::Cross { place, ref lines } if self.is_elsewhere(sheet, place) => {
                    self.crossing(sheet, place, lines);
                }
                Does::Measure { number, from, to, how } if is_changed => {
                    let value = self.values.number(number);
                    self.measured(sheet, [from, to], how, value);
                }
                _ => {}
            }
        }
    }

    /// Draws the links of a mechanism that is assembled otherwise.
    pub(super) fn draw_links(&mut self) {
        let mechanism = &self.key.solution.mechanism;
        for (_, body) in mechanism.links() {
            let names = body.points.iter().map(|&p| mechanism.point_name(p));
            let places = names.filter_map(|n| self.own.construction.place(Sheet::Scheme, n));
            let places: Vec<PlaceId> = places.collect();
            let next = places.iter().cycle().skip(1);
            let count = if places.len() > 2 { places.len() } else { 1 };
            for (&a, &b) in places.iter().zip(next).take(count) {
                if [a, b].into_iter().any(|p| self.is_elsewhere(Sheet::Scheme, p)) {
                    let ends = [a, b].map(|p| self.at(Sheet::Scheme, p));
                    self.line(Sheet::Scheme, b, ends, OwnKind::Line, None);
                }
            }
        }
    }

    /// Draws a value that is a measured length, or the size of a vector, at the student's own length where it was probably begun.
    pub(super) fn draw_value(&mut self, index: usize, value: &Judged) {
        let Ok(reading) = self.own.readings[index] else {
            return;
        };
        let mut operations = self.own.construction.operations.iter();
        let drawn = operations.find_map(|operation| match operation.does {
            Does::Measure { number, from, to, how: How::Size | How::Along(_) } if number == reading.number => {
                Some((operation.sheet, from, to))
            }
            Does::LayOff { place, from, size, .. } if size == reading.number => Some((operation.sheet, from, place)),
            _ => None,
        });
        let Some((sheet, from, to)) = drawn else {
            return;
        };
        let (start, end) = (self.at(sheet, from), self.at(sheet, to));
        if let Some(along) = unit(end - start) {
            let ends = [start, start + along * value.entry.value.abs()];
            let label = self.with_unit(sheet, value.entry.value);
            self.line(
                sheet,
                to,
                ends,
                match sheet {
                    Sheet::Scheme => OwnKind::Line,
                    _ => OwnKind::Vector,
                },
                Some(label),
            );
        }
    }

    /// A length that was measured between other places, or along an axis.
    fn measured(&mut self, sheet: Sheet, [from, to]: [PlaceId; 2], how: How, value: f64) {
        let (start, end) = (self.at(sheet, from), self.at(sheet, to));
        let foot = match how {
            How::X => Vector::new(end.x, start.y),
            How::Y => Vector::new(start.x, end.y),
            _ => end,
        };
        let label = self.with_unit(sheet, value);
        self.line(sheet, to, [start, foot], OwnKind::Line, Some(label));
        self.line(sheet, to, [foot, end], OwnKind::Helper, None);
    }

    /// A point where two lines cross, with both; in a plan with its vector from the pole.
    fn crossing(&mut self, sheet: Sheet, place: PlaceId, lines: &[LineId; 2]) {
        let at = self.at(sheet, place);
        let meets = at.norm().is_finite();
        let pole = self.pole(sheet);
        if meets {
            self.mark(sheet, place);
            if let Some(pole) = pole {
                let ends = [self.at(sheet, pole), at];
                self.line(sheet, place, ends, OwnKind::Vector, None);
            }
        }
        for line in lines {
            let starts = self.starts(*line);
            // The vector lies there already.
            if meets && starts.iter().any(|s| Some(*s) == pole) {
                continue;
            }
            let starts = starts.into_iter().map(|s| self.at(sheet, s));
            let apart = |p: &Vector| (p - at).norm();
            let Some(start) = starts.min_by(|a, b| apart(a).total_cmp(&apart(b))) else {
                continue;
            };
            let (_, along) = self.values.line(*line);
            let half = along * (LONG * self.per_mm(sheet));
            let ends = if meets { [start, at] } else { [start - half, start + half] };
            self.line(sheet, place, ends, OwnKind::Line, None);
        }
    }

    /// Places that a line was drawn through.
    fn starts(&self, line: LineId) -> Vec<PlaceId> {
        let operations = (0..self.own.construction.operations.len()).map(|index| self.done(index));
        let mut starts = operations.filter_map(|deed| match deed {
            Does::Draw { line: own, through, .. } if *own == line => Some(vec![*through]),
            Does::Join { line: own, from, towards } if *own == line => Some(vec![*from, *towards]),
            _ => None,
        });
        starts.next().unwrap_or_default()
    }

    /// What was done at an operation.
    fn done(&self, index: usize) -> &'a Does {
        let mut instead = self.instead.iter();
        let changed = instead.find(|(operation, _)| *operation == index);
        changed.map_or(&self.own.construction.operations[index].does, |(_, does)| does)
    }

    /// The pole of a plan; the scheme has none.
    fn pole(&self, sheet: Sheet) -> Option<PlaceId> {
        let mut operations = self.own.construction.operations.iter().filter(|a| a.sheet == sheet);
        operations.find_map(|operation| match operation.does {
            Does::Pole { place, .. } if sheet != Sheet::Scheme => Some(place),
            _ => None,
        })
    }

    fn per_mm(&self, sheet: Sheet) -> f64 {
        self.own.scales.per_mm[sheet as usize]
    }

    /// A size on a sheet with its unit.
    fn with_unit(&self, sheet: Sheet, value: f64) -> String {
        let kind = [Kind::Length, Kind::Velocity, Kind::Acceleration][sheet as usize];
        let value = self.words.write(value.abs(), significant(4).on(Medium::Figure));
        format!("{value} {}", kind.unit(self.key.solution.scene.units))
    }

    /// The names of a place.
    fn names(&self, sheet: Sheet, place: PlaceId) -> impl Iterator<Item = &'a str> {
        let named = self.own.construction.named_places();
        named.filter_map(move |(of, name, id)| (of == sheet && id == place).then_some(name))
    }

    /// The name by which the figure knows a place: the first that its plan has.
    fn name(&self, sheet: Sheet, place: PlaceId) -> Option<&'a str> {
        let construction = &self.key.solution.construction;
        let plan = construction.plan_on(sheet);
        let is_shown = |name: &&str| match plan {
            Some(plan) => plan.points.contains_key(*name),
            None => !name.is_empty(),
        };
        self.names(sheet, place).find(is_shown)
    }

    /// Where a place is, as given or as replayed, from the sheet's pole or the mechanism's first point.
    fn at(&self, sheet: Sheet, place: PlaceId) -> Vector {
        let mut names = self.names(sheet, place);
        let given = names.find_map(|name| self.given.get(&(sheet, name.to_owned())));
        given.map_or_else(|| self.values.place(place), |place| *place)
    }

    /// Where the right drawing has a point.
    fn right_place(&self, sheet: Sheet, name: &str) -> Option<Vector> {
        let id = self.right.construction.place(sheet, name)?;
        Some(self.right.exact.place(id))
    }

    /// Whether a place is visibly elsewhere than it should be, or nowhere.
    fn is_elsewhere(&self, sheet: Sheet, place: PlaceId) -> bool {
        let Some(name) = self.name(sheet, place) else {
            return false;
        };
        let right = self.right_place(sheet, name);
        let apart = right.map(|right| (self.at(sheet, place) - right).norm());
        // What is nowhere is not near.
        apart.is_some_and(|apart| apart.is_nan() || apart > SEEN * self.per_mm(sheet))
    }

    /// The point to which a vector leads, over further vectors where its own end has no name.
    fn leads_to(&self, place: PlaceId) -> PlaceId {
        let sheets = self.own.construction.operations.iter();
        let mut next = sheets.filter_map(|operation| match operation.does {
            Does::LayOff { place: end, from, .. } if from == place => Some(end),
            _ => None,
        });
        match self.own.place_names[place.0] {
            Some(_) => place,
            None => next.next().map_or(place, |end| self.leads_to(end)),
        }
    }

    /// Marks a place, unless it is one of those that are given.
    fn mark(&mut self, sheet: Sheet, place: PlaceId) {
        let given = self.given.keys().any(|(of, _)| *of == sheet);
        if let Some(name) = self.name(sheet, place).filter(|_| !given) {
            self.point(sheet, name, self.at(sheet, place), true);
        }
    }

    fn point(&mut self, sheet: Sheet, name: &str, at: Vector, is_named: bool) {
        if at.norm().is_finite() {
            self.points.push(OwnPoint {
                panel: panel(sheet),
                name: name.to_owned(),
                at: self.on_figure(sheet, at),
                is_named,
            });
        }
    }

    fn line(&mut self, sheet: Sheet, leads_to: PlaceId, ends: [Vector; 2], kind: OwnKind, label: Option<String>) {
        let there = ends.iter().all(|end| end.norm().is_finite()) && ends[0] != ends[1];
        if let Some(name) = self.name(sheet, leads_to).filter(|_| there) {
            self.lines.push(OwnLine {
                panel: panel(sheet),
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
            Sheet::Scheme => self.own.construction.origin + at,
            _ => Point::from(at),
        }
    }
}

/// The angle in degrees by which the first of each pair is turned to lie on the second: what makes the sum of distances, not of their squares, least, so that one
/// wrong point does not turn the right ones. Distances below `near` count alike.
///
/// Least squares, in which the tangent is Σ q × r / Σ q · r, with weights 1 / distance, again and again (Weiszfeld 1937).
fn best_turn(pairs: &[(Vector, Vector)], near: f64) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_wrong_point_does_not_turn_the_others() {
        let right = [[80.0, 0.0], [10.0, 60.0], [-30.0, 20.0], [50.0, 40.0]];
        let mut pairs = right.map(|r| {
            let r = Vector::from(r);
            (turn_of_degrees(-25.0).transform_vector(&r), r)
        });
        assert!((best_turn(&pairs, 0.3) - 25.0).abs() < 1e-9);
        pairs[1].0 += Vector::new(14.0, 9.0);
        assert!((best_turn(&pairs, 0.3) - 25.0).abs() < 0.1);
    }
}
