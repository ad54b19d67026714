//! The construction carried out along the pencil lines, with or without mistakes.

use crate::check::mistakes::Candidate;
use crate::check::model::{Model, in_order};
use crate::check::photographs::PencilledPlan;
use crate::construction::{LineId, OperationKind, PlaceId};
use crate::geometry::{Point, Vector, cross, unit};
use crate::photo::Stroke;
use crate::sheet::PerSheet;
use std::collections::HashSet;

/// What speaks for a crossing of two lines that are there, and for a vector.
const CROSSING: f64 = 2.0;
const VECTOR: f64 = 1.5;
/// What speaks against an operation of which nothing is seen.
const NOTHING: f64 = 1.0;
/// Shortest vector that is drawn, in mm.
const DRAWN: f64 = 1.2;
/// Most that may be missing where places are believed that nothing leads to, as a part of what agrees.
const MISSING: f64 = 0.3;
/// How far a crossing may be from where it should: always, and for each mm of its lines, in mm across them.
const NEAR: f64 = 0.7;
const NEAR_PER_MM: f64 = 0.012;
/// A vector's line that is longer by more than this, in mm, must pass within the next of where the vector should end.
const PAST: f64 = 4.0;
const ON: f64 = 0.4;
/// Least sine between lines whose crossing is a place.
const SINE: f64 = 0.1;

/// The construction with the pencil lines of the sheets that are there.
pub(super) struct Tracker<'a> {
    model: &'a Model,
    /// By sheet: the pencil lines from the pole, in mm, y up; `None` for a sheet that is not there.
    strokes: PerSheet<Option<Vec<Stroke>>>,
}

/// Where pencil lines show the places of a construction.
#[derive(Clone, Debug, Default)]
pub(super) struct Track {
    spots: Vec<(PlaceId, Spot)>,
    /// What speaks for it.
    pub agreeing: f64,
    /// What should be there and is not.
    pub missing: f64,
}

impl Track {
    pub(super) fn spot(&self, place: PlaceId) -> Option<Spot> {
        self.spots.iter().find(|(own, _)| *own == place).map(|(_, spot)| *spot)
    }
}

impl<'a> Tracker<'a> {
    pub(super) fn new(model: &'a Model, plans: &[PencilledPlan<'_>]) -> Tracker<'a> {
        let strokes = PerSheet::from_fn(|sheet| {
            let plan = plans.iter().find(|plan| plan.order.sheet() == sheet)?;
            let turned = |at: Point| Point::from(plan.from_pole([at.x, at.y]));
            Some(plan.strokes.iter().map(|stroke| Stroke { ends: stroke.ends.map(turned), ..*stroke }).collect())
        });
        Tracker { model, strokes }
    }

    /// Carries the construction out as it is, or with a mistake.
    pub(super) fn follow(&self, mistake: Option<&Candidate>) -> Track {
        let changes = in_order(mistake.iter().flat_map(|candidate| &candidate.edits));
        let operations = &self.model.construction.operations;
        let mut values = self.model.exact.clone();
        let (mut track, mut lost, mut unsure) = (Track::default(), Lost::default(), HashSet::new());
        for (index, operation) in operations.iter().enumerate() {
            let from = changes.partition_point(|change| change.operation < index);
            let to = changes.partition_point(|change| change.operation <= index);
            values.carry_out(&operations[..=index], index, self.model.scales, &changes[from..to]);
            let Some(strokes) = &self.strokes[operation.sheet] else { continue };
            let mu = self.model.scales[operation.sheet];
            let done = mistake.and_then(|candidate| candidate.instead_of(index));
            let at = |place: PlaceId| Point::from(values.place(place) / mu);
            if lost.spreads_to(&operation.kind) {
                unsure.extend(operation.kind.place());
            }
            let (place, seen) = match done.unwrap_or(&operation.kind) {
                OperationKind::Cross { place, lines } => {
                    let lines = lines.map(|line| {
                        let (on, along) = values.line(line);
                        (Point::from(on / mu), along)
                    });
                    (*place, cross_of(strokes, at(*place), lines))
                }
                OperationKind::LayOff { place, from, .. } => (*place, vector(strokes, at(*from), at(*place))),
                _ => continue,
            };
            match seen {
                Seen::Nothing => {
                    track.missing += NOTHING;
                    lost.places.insert(place);
                }
                Seen::Neutral => {}
                Seen::There { spot, worth } => {
                    track.agreeing += worth;
                    values.put_place(place, spot.at.coords * mu);
                    track.spots.push((place, spot));
                }
                Seen::Line { worth } => track.agreeing += worth,
            }
        }
        // Where much is missing such a place may be of other lines.
        if track.missing > MISSING * track.agreeing {
            track.spots.retain(|(place, _)| !unsure.contains(place));
        }
        track
    }
}

/// Places of which nothing is seen, and places and lines that come from such.
#[derive(Default)]
struct Lost {
    places: HashSet<PlaceId>,
    lines: HashSet<LineId>,
}

impl Lost {
    /// Whether an operation begins at what is lost; its result is then lost, too.
    fn spreads_to(&mut self, operation: &OperationKind) -> bool {
        let (places, lines) = operation.places_and_lines_read();
        let is_lost = places.iter().any(|place| self.places.contains(place))
            || lines.iter().any(|line| self.lines.contains(line));
        if is_lost {
            self.places.extend(operation.place());
            self.lines.extend(operation.line());
        }
        is_lost
    }
}

/// What is seen of an operation.
enum Seen {
    /// Nothing, though something should be.
    Nothing,
    /// Nothing needs to be.
    Neutral,
    /// Its line, but not where it ends.
    Line { worth: f64 },
    /// Its result.
    There { spot: Spot, worth: f64 },
}

/// What is seen of a crossing of two lines, each with a place that it was drawn through.
fn cross_of(strokes: &[Stroke], at: Point, lines: [(Point, Vector); 2]) -> Seen {
    let sine = cross(lines[0].1, lines[1].1).abs();
    if !(at.x.is_finite() && at.y.is_finite()) || sine < SINE {
        return Seen::Neutral;
    }
    let far = lines.map(|(on, _)| (at - on).norm());
    let [a, b] = [0, 1].map(|i| drawn(strokes, at, lines[i].1, far[i]));
    let (Some((a, off_a)), Some((b, off_b))) = (a, b) else {
        return if a.is_some() || b.is_some() { Seen::Line { worth: -0.3 } } else { Seen::Nothing };
    };
    match crossing(a, b) {
        Some(spot)
            if (spot.at - at).norm() < (NEAR + NEAR_PER_MM * far[0].max(far[1])) / sine.max(0.35)
                && a.beyond(spot.at) < 1.5
                && b.beyond(spot.at) < 1.5 =>
        {
            Seen::There { spot, worth: CROSSING * (1.0 - 0.4 * (off_a + off_b)).max(0.2) }
        }
        _ => Seen::Line { worth: -0.3 },
    }
}

/// What is seen of a vector from one place to another.
fn vector(strokes: &[Stroke], from: Point, to: Point) -> Seen {
    let length = (to - from).norm();
    let Some(along) = unit(to - from).filter(|_| length > DRAWN) else {
        return Seen::Neutral;
    };
    let Some((line, off)) = drawn(strokes, to, along, length) else {
        return Seen::Nothing;
    };
    // Its line must run between both places.
    let [a, b] = line.ends.map(|end| along.dot(&(end - from)));
    let covered = (a.max(b).min(length) - a.min(b).max(0.0)) / length;
    if covered < 0.5 {
        return Seen::Nothing;
    }
    // A line that is longer may be another one, drawn over this.
    let is_other = a.max(b) > length + PAST && line.aside(to).abs() > ON;
    match end(strokes, line, to).filter(|_| !is_other) {
        Some(spot) => Seen::There { spot, worth: VECTOR * (1.0 - 0.5 * off).max(0.2) },
        None => Seen::Line { worth: 0.2 },
    }
}

/// How far a line may be beside a place of which an operation says that it goes through: always, and for each mm from the place that it is drawn through.
const ASIDE: f64 = 0.6;
const ASIDE_PER_MM: f64 = 0.012;
/// Most of it, in mm.
const FARTHEST: f64 = 1.8;
/// Most difference of directions, in radians, and what is added to it for short lines, in mm.
const TURNED: f64 = 0.05;
const UNEVEN: f64 = 0.25;
/// How far a line may end before the place that it leads to, in mm: in an arrowhead it is no line any more.
const SHORT: f64 = 3.2;
/// Farther than this part of its length a short line is not drawn out, as its direction is not sure.
const AHEAD: f64 = 0.2;
/// So far, in mm, every line is.
const NEXT: f64 = 1.0;
/// How far from where it should be a vector's end is looked for, along its line, in mm.
const END: f64 = 0.9;
/// Distance within which signs of an end are one, in mm.
const SAME: f64 = 0.4;
/// Least length of what makes a line by itself, in mm; arrowheads and letters are shorter.
const LONG: f64 = 6.0;

/// A place that pencil lines show: from the pole, in mm, y up, with the radius that holds it with 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub at: Point,
    pub band: f64,
}

/// The line that was drawn along `along` through a place `far` mm from where it was begun, and how much it differs: 0 not at all, 1 as much as may be.
fn drawn(strokes: &[Stroke], at: Point, along: Vector, far: f64) -> Option<(&Stroke, f64)> {
    let aside = (ASIDE + ASIDE_PER_MM * far).min(FARTHEST);
    let rated = strokes.iter().filter_map(|stroke| {
        let turned = cross(stroke.along(), along).abs() / (TURNED + UNEVEN / stroke.length());
        let off = stroke.aside(at).abs() / aside;
        let is_one = turned <= 1.0 && off <= 1.0 && stroke.beyond(at) <= SHORT && stroke.length() > 2.0;
        // Of lines that fit the longer is the likelier one.
        is_one.then(|| (stroke, libm::hypot(turned, off) * 0.7, off + turned - 0.03 * stroke.length().min(30.0)))
    });
    let best = rated.min_by(|a, b| a.2.total_cmp(&b.2))?;
    Some((best.0, best.1))
}

/// Where two lines cross.
fn crossing(a: &Stroke, b: &Stroke) -> Option<Spot> {
    let at = a.crossing(b)?;
    let sine = cross(a.along(), b.along()).abs();
    Some(Spot { at, band: 2.45 * libm::hypot(libm::hypot(a.deviation, b.deviation) / sine, LEAST) })
}

/// Least standard deviation of a place, in mm: pencil lines are no thinner.
const LEAST: f64 = 0.08;

/// Where a vector along a line ends, near where it should: where long lines cross it, or else where both its own end and an arrowhead are. `None` where there is nothing,
/// or where several places come into question.
fn end(strokes: &[Stroke], line: &Stroke, expected: Point) -> Option<Spot> {
    let along = line.along();
    let position = |at: Point| along.dot(&(at - expected));
    let (mut long, mut short): (Vec<Sign>, Vec<Sign>) = (Vec::new(), Vec::new());
    for other in strokes {
        let sine = cross(along, other.along()).abs();
        let Some(at) = line.crossing(other).filter(|_| sine > 0.25) else { continue };
        let place = position(at);
        if place.abs() > END || other.beyond(at) > 0.8 || line.beyond(at) > SHORT.min(AHEAD * line.length()).max(NEXT) {
            continue;
        }
        let signs = if other.length() > LONG { &mut long } else { &mut short };
        signs.push(Sign { place, deviation: libm::hypot(LEAST, other.deviation / sine) });
    }
    let own = line.ends.map(position).into_iter().filter(|place| place.abs() <= END);
    let own: Vec<Sign> = own.map(|place| Sign { place, deviation: 0.15 }).collect();
    let signs = match (long.is_empty(), own.is_empty() || short.is_empty()) {
        (false, _) => long,
        (true, false) => own.into_iter().chain(short).collect(),
        (true, true) => return None,
    };
    let total: f64 = signs.iter().map(|sign| sign.deviation.powi(-2)).sum();
    let place = signs.iter().map(|sign| sign.place * sign.deviation.powi(-2)).sum::<f64>() / total;
    let scatter = signs.iter().map(|sign| (sign.place - place).abs()).fold(0.0, f64::max);
    if scatter > SAME {
        return None;
    }
    let foot = line.ends[0] + along * along.dot(&(expected - line.ends[0]));
    let deviation =
        libm::hypot(libm::hypot(line.deviation, LEAST), libm::hypot(libm::sqrt(1.0 / total), 0.5 * scatter));
    Some(Spot { at: foot + along * place, band: 2.45 * deviation })
}

/// A sign of a vector's end: how far beyond where it should be, and how sure, in mm.
struct Sign {
    place: f64,
    deviation: f64,
}
