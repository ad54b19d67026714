//! The construction carried out along the pencil lines, with or without mistakes.

use super::lines::{Spot, crossing, drawn, end};
use crate::check::mistakes::Candidate;
use crate::check::model::{Changes, Edit, Model};
use crate::check::photographs::PencilledPlan;
use crate::construction::{Disturbance, LineId, OperationKind, PlaceId};
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
/// A vector's line that goes on by more than this, in mm, must pass within the next of where the vector should end.
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
            let plan = plans.iter().find(|plan| plan.kind == sheet)?;
            let turned = |at: Point| Point::from(plan.from_pole([at.x, at.y]));
            Some(plan.strokes.iter().map(|stroke| Stroke { ends: stroke.ends.map(turned), ..*stroke }).collect())
        });
        Tracker { model, strokes }
    }

    /// Goes through the construction as it is with these mistakes.
    pub(super) fn follow(&self, mistakes: &[&Candidate]) -> Track {
        let mut changes = Changes::new();
        for (operation, edit) in mistakes.iter().flat_map(|candidate| &candidate.edits) {
            changes.push(Disturbance { operation: *operation, change: edit.change() });
        }
        changes.sort_by_key(|change| change.operation);
        let operations = &self.model.construction.operations;
        let mut values = self.model.exact.clone();
        let (mut track, mut lost, mut unsure) = (Track::default(), Lost::default(), HashSet::new());
        for (index, operation) in operations.iter().enumerate() {
            let from = changes.partition_point(|change| change.operation < index);
            let to = changes.partition_point(|change| change.operation <= index);
            values.carry_out(&operations[..=index], index, self.model.scales, &changes[from..to]);
            let Some(strokes) = &self.strokes[operation.sheet] else { continue };
            let mu = self.model.scales[operation.sheet];
            let done = mistakes.iter().flat_map(|candidate| &candidate.edits).find_map(|(own, edit)| match edit {
                Edit::Instead(kind) if *own == index => Some(kind),
                _ => None,
            });
            let at = |place: PlaceId| Point::from(values.place(place) / mu);
            if lost.goes_on_with(&operation.kind) {
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
    fn goes_on_with(&mut self, operation: &OperationKind) -> bool {
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
    // A line that goes on may be another one, drawn over this.
    let is_other = a.max(b) > length + PAST && line.aside(to).abs() > ON;
    match end(strokes, line, to).filter(|_| !is_other) {
        Some(spot) => Seen::There { spot, worth: VECTOR * (1.0 - 0.5 * off).max(0.2) },
        None => Seen::Line { worth: 0.2 },
    }
}
