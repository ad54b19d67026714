//! The construction carried out along the pencil lines: from the poles on, each vector along a line from where it begins, each crossing where two lines are that go through the
//! places which they are drawn from. What an operation asks for is one way to read the lines; other ways are wrong lengths, senses and directions, and a wrong place to
//! begin at. They cost a little, whatever the right plan is; what lines show decides.

use super::ink::{Ink, Spot};
use crate::check::model::Model;
use crate::check::photographs::PencilledPlan;
use crate::construction::{LineId, Operation, OperationKind, PlaceId, Values};
use crate::geometry::{Point, Vector, cross, unit};
use crate::photo::Stroke;
use crate::sheet::{PerSheet, Sheet};
use smallvec::SmallVec;
use std::collections::HashSet;

/// What speaks for a crossing of two lines, and for a vector with an end.
const CROSSING: f64 = 2.0;
const VECTOR: f64 = 1.5;
/// What speaks against an operation of which nothing is seen, and one that begins where nothing was seen.
const NOTHING: f64 = 1.5;
const HIDDEN: f64 = 1.0;
/// What speaks against a long line that nothing explains.
const UNEXPLAINED: f64 = 0.6;
/// What speaks against a vector of another length, the opposite one, one turned by a quarter, and one in any other direction; a line from another place; a vector left out.
const OTHER_LENGTH: f64 = 1.5;
const OPPOSITE: f64 = 2.0;
const QUARTER: f64 = 2.0;
const ANY: f64 = 3.0;
const ELSEWHERE: f64 = 2.5;
const LEFT_OUT: f64 = 2.0;
/// What speaks against the largest error of a hand.
const UNEVEN: f64 = 0.5;
/// Most that may speak against a crossing.
const MOST: f64 = 5.5;
/// Most difference of directions, in radians, and what is added to it for short lines, in mm.
const TURNED: f64 = 0.045;
const TURNED_MM: f64 = 0.25;
/// Most difference of lengths, in mm and as a part.
const LONGER: f64 = 0.8;
const LONGER_PART: f64 = 0.03;
/// Shortest vector that is drawn, in mm.
const DRAWN: f64 = 1.2;
/// How far beside a place a line may be that joins it to another, in mm.
const JOINING: f64 = 0.6;
/// Least distance of a crossing from the places that there are, in mm.
const APART: f64 = 1.0;
/// How many readings are kept.
const KEPT: usize = 100;

/// The construction with the pencil lines of the sheets that are there.
pub(super) struct Reader<'a> {
    model: &'a Model,
    /// By sheet, `None` for one that is not there.
    ink: PerSheet<Option<Ink>>,
}

/// A way to read the lines.
#[derive(Clone)]
pub(super) struct Reading {
    values: Values,
    /// Where it has places, and whether each is sure enough to be proposed.
    spots: SmallVec<[(PlaceId, Spot, bool); 16]>,
    /// By sheet and in mm: where it has places, that of the pole first.
    places: PerSheet<SmallVec<[Point; 16]>>,
    /// The lines that it uses.
    used: SmallVec<[(Sheet, usize); 32]>,
    hidden: Hidden,
    /// What speaks for it.
    pub worth: f64,
}

/// Places that are not seen, and places and lines that come from such.
#[derive(Clone, Default)]
struct Hidden {
    places: HashSet<PlaceId>,
    lines: HashSet<LineId>,
}

impl Hidden {
    /// Whether an operation begins at what is not seen; its result is then not seen, either.
    fn spreads_to(&mut self, operation: &OperationKind) -> bool {
        if self.places.is_empty() {
            return false;
        }
        let (places, lines) = operation.places_and_lines_read();
        let is_hidden = places.iter().any(|place| self.places.contains(place))
            || lines.iter().any(|line| self.lines.contains(line));
        if is_hidden {
            self.places.extend(operation.place());
            self.lines.extend(operation.line());
        }
        is_hidden
    }
}

impl Reading {
    /// Where it has a place that is sure enough to be proposed.
    pub(super) fn sure_spot(&self, place: PlaceId) -> Option<Spot> {
        self.spots.iter().find(|(own, _, is_sure)| *own == place && *is_sure).map(|(_, spot, _)| *spot)
    }

    /// Where it has a place.
    pub(super) fn place(&self, place: PlaceId) -> Option<Point> {
        self.spots.iter().find(|(own, ..)| *own == place).map(|(_, spot, _)| spot.at)
    }

    /// The reading in which a place is at a spot that those lines show.
    fn with(&self, sheet: Sheet, place: PlaceId, spot: Spot, is_sure: bool, lines: &[usize]) -> Reading {
        let mut reading = self.clone();
        reading.places[sheet].push(spot.at);
        reading.used.extend(lines.iter().map(|line| (sheet, *line)));
        reading.spots.push((place, spot, is_sure));
        reading
    }

    /// The reading in which nothing is seen of a place.
    fn without(mut self, place: PlaceId, cost: f64) -> Reading {
        self.hidden.places.insert(place);
        self.worth -= cost;
        self
    }

    /// Whether another has its places where this one has them.
    fn is_like(&self, other: &Reading) -> bool {
        let is_near =
            |(a, b): (&(PlaceId, Spot, bool), &(PlaceId, Spot, bool))| a.0 == b.0 && (a.1.at - b.1.at).norm() < 0.1;
        self.spots.len() == other.spots.len()
            && self.hidden.places == other.hidden.places
            && self.spots.iter().zip(&other.spots).all(is_near)
    }
}

impl<'a> Reader<'a> {
    pub(super) fn new(model: &'a Model, plans: &[PencilledPlan<'_>]) -> Reader<'a> {
        let ink = PerSheet::from_fn(|sheet| {
            let plan = plans.iter().find(|plan| plan.of() == sheet)?;
            let turned = |at: Point| Point::from(plan.from_origin([at.x, at.y]));
            let strokes = plan.strokes.iter().map(|stroke| Stroke { ends: stroke.ends.map(turned), ..*stroke });
            Some(Ink::new(strokes.collect()))
        });
        Reader { model, ink }
    }

    /// The ways to read the lines, the best first.
    pub(super) fn readings(&self) -> Vec<Reading> {
        let operations = &self.model.construction.operations;
        let mut all = vec![Reading {
            values: self.model.exact.clone(),
            spots: SmallVec::new(),
            places: PerSheet::from_fn(|_| SmallVec::from_slice(&[Point::origin()])),
            used: SmallVec::new(),
            hidden: Hidden::default(),
            worth: 0.0,
        }];
        for (index, operation) in operations.iter().enumerate() {
            let mut next = Vec::new();
            for mut reading in all {
                reading.values.carry_out(&operations[..=index], index, self.model.scales, &[]);
                self.see(operation, reading, &mut next);
            }
            all = next;
            if all.len() > KEPT {
                all.sort_by(|a, b| b.worth.total_cmp(&a.worth));
                let mut kept: Vec<Reading> = Vec::with_capacity(KEPT);
                for reading in all {
                    if kept.len() < KEPT && !kept.iter().any(|better| better.is_like(&reading)) {
                        kept.push(reading);
                    }
                }
                all = kept;
            }
        }
        for reading in &mut all {
            reading.worth -= UNEXPLAINED * self.unexplained(reading) as f64;
        }
        all.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        all
    }

    /// What becomes of a reading by an operation that was carried out in it as it should be.
    fn see(&self, operation: &Operation, mut reading: Reading, next: &mut Vec<Reading>) {
        let is_hidden = reading.hidden.spreads_to(&operation.kind);
        let Some(ink) = &self.ink[operation.sheet] else { return next.push(reading) };
        let before = next.len();
        let place = match operation.kind {
            // What the sheet has from the start.
            OperationKind::Plot { place, .. } => {
                let at = self.at(&reading, operation.sheet, place);
                reading.places[operation.sheet].push(at);
                return next.push(reading);
            }
            OperationKind::Cross { place, lines } => {
                if !is_hidden {
                    self.cross(ink, operation.sheet, &reading, (place, lines), next);
                }
                place
            }
            OperationKind::LayOff { place, from, .. } => {
                let length = self.at(&reading, operation.sheet, place) - self.at(&reading, operation.sheet, from);
                if !is_hidden && length.norm() < DRAWN {
                    return next.push(reading);
                }
                if !is_hidden {
                    self.lay_off(ink, operation.sheet, &reading, (place, from), next);
                }
                place
            }
            _ => return next.push(reading),
        };
        let mu = self.model.scales[operation.sheet];
        for reading in &mut next[before..] {
            if let Some(at) = reading.places[operation.sheet].last() {
                reading.values.put_place(place, at.coords * mu);
            }
        }
        next.push(reading.without(place, if is_hidden { HIDDEN } else { NOTHING }));
    }

    /// A place of a reading, in mm.
    fn at(&self, reading: &Reading, sheet: Sheet, place: PlaceId) -> Point {
        Point::from(reading.values.place(place) / self.model.scales[sheet])
    }

    /// The readings of a vector.
    fn lay_off(
        &self,
        ink: &Ink,
        sheet: Sheet,
        reading: &Reading,
        (place, from): (PlaceId, PlaceId),
        next: &mut Vec<Reading>,
    ) {
        let [from, to] = [from, place].map(|place| self.at(reading, sheet, place));
        let (length, Some(expected)) = ((to - from).norm(), unit(to - from)) else { return };
        for (index, aside) in ink.through(from) {
            let line = ink.line(index);
            for along in [line.along(), -line.along()] {
                for end in ink.ends(index, from, along) {
                    let own = along.dot(&(end.spot.at - from));
                    let [a, b] = line.ends.map(|end| along.dot(&(end - from)));
                    let covered = (a.max(b).min(own) - a.min(b).max(0.0)) / own;
                    if covered < 0.6 {
                        continue;
                    }
                    let longer = (own - length).abs() / (LONGER + LONGER_PART * length);
                    let cost = direction_cost(along, expected, own, true)
                        + if longer <= 1.0 { UNEVEN * longer * longer } else { OTHER_LENGTH }
                        + UNEVEN * aside * aside;
                    let mut reading = reading.with(sheet, place, end.spot, end.is_sure, &[index]);
                    reading.worth += VECTOR * end.strength - cost;
                    next.push(reading);
                }
            }
        }
        let mut left_out = reading.with(sheet, place, Spot { at: from, band: 0.0 }, false, &[]);
        left_out.worth -= LEFT_OUT;
        next.push(left_out);
    }

    /// The readings of a crossing.
    fn cross(
        &self,
        ink: &Ink,
        sheet: Sheet,
        reading: &Reading,
        (place, lines): (PlaceId, [LineId; 2]),
        next: &mut Vec<Reading>,
    ) {
        let [first, second] = lines.map(|line| {
            let (_, along) = reading.values.line(line);
            let on = self.drawn_through(line);
            let on: SmallVec<[Point; 2]> = on.iter().map(|place| self.at(reading, sheet, *place)).collect();
            if along.norm().is_finite() { self.rays(ink, sheet, reading, &on, along) } else { Vec::new() }
        });
        for (a, cost_a) in &first {
            for (b, cost_b) in &second {
                let cost = cost_a + cost_b;
                if a == b || cost > MOST {
                    continue;
                }
                let Some((spot, is_sure)) = ink.crossing([*a, *b]) else { continue };
                // Where the lines begin they cross, too.
                if reading.places[sheet].iter().any(|other| (other - spot.at).norm() < APART) {
                    continue;
                }
                // What no operation asks for is believed where a further line, as the vector from the pole, leads there, too.
                // To a centre no vector leads.
                let few = if sheet.order().is_some() { QUARTER } else { ANY };
                let is_sure = is_sure && (cost < few || ink.meet(spot.at, [*a, *b]));
                let mut reading = reading.with(sheet, place, spot, is_sure, &[*a, *b]);
                reading.worth += CROSSING - cost;
                next.push(reading);
            }
        }
    }

    /// The places through which a line is drawn.
    fn drawn_through(&self, line: LineId) -> SmallVec<[PlaceId; 2]> {
        let mut operations = self.model.construction.operations.iter();
        let drawn = operations.find(|operation| operation.kind.line() == Some(line));
        drawn.map_or_else(SmallVec::new, |operation| match operation.kind {
            OperationKind::Draw { through, .. } => SmallVec::from_slice(&[through]),
            OperationKind::Join { from, towards, .. } => SmallVec::from_slice(&[from, towards]),
            _ => SmallVec::new(),
        })
    }

    /// The lines that may be a ray in a direction through these places, with what speaks against each.
    fn rays(&self, ink: &Ink, sheet: Sheet, reading: &Reading, on: &[Point], along: Vector) -> Vec<(usize, f64)> {
        let mut rays: Vec<(usize, f64)> = Vec::new();
        // What is something else already is a ray only where it lies as a ray should.
        let is_free = |line: usize, cost: f64| cost < 2.0 * UNEVEN || !reading.used.contains(&(sheet, line));
        let mut add = |line: usize, cost: f64| match rays.iter_mut().find(|(other, _)| *other == line) {
            Some((_, other)) => *other = other.min(cost),
            None => rays.push((line, cost)),
        };
        for (line, aside) in on.iter().flat_map(|on| ink.through(*on)) {
            let stroke = ink.line(line);
            let cost = direction_cost(stroke.along(), along, stroke.length(), false) + UNEVEN * aside * aside;
            if is_free(line, cost) {
                add(line, cost);
            }
        }
        let is_other = |other: &&Point| on.iter().all(|on| (**other - on).norm() > 1.5);
        for other in reading.places[sheet].iter().filter(is_other) {
            for (line, aside) in ink.through(*other) {
                let stroke = ink.line(line);
                let cost = direction_cost(stroke.along(), along, stroke.length(), false);
                if cost <= UNEVEN && is_free(line, ELSEWHERE) {
                    add(line, cost + ELSEWHERE + UNEVEN * aside * aside);
                }
            }
        }
        // A line through two other centres.
        if sheet.order().is_none() {
            for line in (0..ink.is_meant.len()).filter(|line| ink.is_meant[*line]) {
                let stroke = ink.line(line);
                let is_on = |at: &&Point| stroke.aside(**at).abs() < JOINING;
                if reading.places[sheet].iter().filter(is_on).count() > 1 {
                    add(line, ELSEWHERE);
                }
            }
        }
        rays
    }

    /// How many long lines a reading leaves without an explanation: those that it does not use, that continue none which it uses, and that join no two of its places.
    fn unexplained(&self, reading: &Reading) -> usize {
        let of_sheet = |(sheet, ink): (Sheet, &Option<Ink>)| {
            let Some(ink) = ink else { return 0 };
            let own = |line: &usize| reading.used.contains(&(sheet, *line));
            let is_on = |at: &&Point, line: &Stroke| line.aside(**at).abs() < JOINING && line.beyond(**at) < 1.0;
            let is_explained = |index: usize| {
                let line = ink.line(index);
                let continues = |(_, other): &(Sheet, usize)| {
                    let other = ink.line(*other);
                    line.ends.iter().all(|end| other.aside(*end).abs() < JOINING)
                };
                let on: Vec<&Point> = reading.places[sheet].iter().filter(|at| is_on(at, line)).collect();
                let joins = on.iter().any(|a| on.iter().any(|b| (**a - **b).norm() > 3.0));
                joins || reading.used.iter().filter(|(of, _)| *of == sheet).any(continues)
            };
            let meant = (0..ink.is_meant.len()).filter(|index| ink.is_meant[*index]);
            meant.filter(|index| !own(index) && !is_explained(*index)).count()
        };
        self.ink.iter().map(of_sheet).sum()
    }
}

/// What speaks against a line of that length along one direction where another is asked for; for a vector both have a sense.
fn direction_cost(along: Vector, expected: Vector, length: f64, has_sense: bool) -> f64 {
    let limit = TURNED + TURNED_MM / length;
    let (sine, cosine) = (cross(expected, along).abs() / limit, expected.dot(&along));
    if sine <= 1.0 {
        UNEVEN * sine * sine + if has_sense && cosine < 0.0 { OPPOSITE } else { 0.0 }
    } else if cosine.abs() <= limit {
        QUARTER
    } else {
        ANY
    }
}
