//! What places of points on paper tell: of plan points their distances and directions from the pole and from each other, and how a plan lies to
//! the scheme; of instant centres their coordinates.

use super::entry::Entry;
use super::measured::{CheckError, Measured, PlacedPoint, PointsOf};
use super::names::{Meant, Names};
use super::on_paper::PaperPoints;
use super::says;
use super::written::Precision;
use crate::construction::{Construction, Solution};
use crate::geometry::{Vector, degrees_of, turn_of_degrees, with_turns};
use crate::sheet::Sheet;
use crate::words::sheet_told;
use indexmap::IndexMap;

/// Rounding of distances of places, in mm: people write these to a tenth or a hundredth of a millimetre.
pub(super) const ROUNDING: f64 = 0.05;

/// Largest radius behind a place that counts, in mm: photographs that are good enough have less.
pub(super) const COUNTED: f64 = 1.0;

/// How far what a place tells may be from what is written of it without contradicting it: as far as hands that mark a point and measure it come, in
/// mm and in degrees.
const CONTRADICTS: f64 = 1.0;
const CONTRADICTS_DEGREES: f64 = 2.0;

/// Least length of a vector that has a direction, in mm.
const SHORT: f64 = 3.0;

/// Largest doubt of a direction that still tells something, in degrees.
const DOUBTED: f64 = 2.0;

/// How far a point may be off across its vector to show how its plan lies: an angle in degrees, and in mm.
const NEAR: [f64; 2] = [1.5, 0.6];

/// Least angle by which a plan lies turned that is told, in degrees: less is how a sheet was laid.
const TOLD: f64 = 3.0;

/// A plan that lies turned to the scheme, sheet and all: lengths alone do not show it, and where the sheet was laid turned nothing is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TurnedPlan {
    /// The plan.
    pub sheet: Sheet,
    /// By how much, in degrees, positive counter-clockwise.
    pub degrees: f64,
}

/// Adds the coordinates of instant centres, and the distances and directions between plan points whose places are given: of each from the pole, and those that the steps name.
/// What is written already keeps its value, unless a place contradicts it and is farther from the right one.
pub(super) fn add(entries: &mut Vec<Entry>, measured: &Measured, names: &Names<'_>) -> Result<(), CheckError> {
    for points in &measured.points {
        let sheet = points.sheet;
        let Some(mu) = measured.mu[sheet] else {
            let mu = sheet.facts().scale_key;
            return Err(CheckError::new(says::points_without_scale(mu), says::add_scale_of(mu, sheet_told(sheet))));
        };
        let Some(own) = PaperPoints::of(names.solution, sheet) else {
            let hint = says::add_scale_or_panel(sheet.facts().scale_key);
            return Err(CheckError::new(says::no_sheet(sheet_told(sheet)), hint));
        };
        if points.origin(&own).is_none() {
            let (message, origin) =
                (if sheet.order().is_some() { says::no_pole } else { says::no_origin }, own.origin());
            return Err(CheckError::new(message(sheet_told(sheet), origin), says::add_pole(origin)));
        }
        let places = usual(points, &own, &names.solution.construction);
        let lies = Lies::of(points, &own, measured.upright);
        if sheet.order().is_none() {
            coordinates(entries, (&places, &own), (mu, lies), names)?;
            continue;
        }
        let at = |name: &str| format!("points: {name} of {}", sheet.facts().segment);
        let pole = own.origin();
        // Of each point from the pole, and of points that a step names.
        let others = || places.keys().map(String::as_str).filter(|name| *name != pole);
        let between = others().flat_map(|from| others().map(move |to| (from, to)));
        let between = between.filter(|(from, to)| names.order.contains_key(&sheet.segment_name(from, to)));
        for (from, to) in others().map(|to| (pole, to)).chain(between) {
            let vector = Placed::between(places[from], places[to]);
            let name = sheet.segment_name(from, to);
            let meant = |name: &str| names.quantity(name).map_err(|e| e.at(at(to)));
            let length = meant(&name)?;
            // The image of a point at rest is the pole itself, wherever its dot is set.
            if length.expected == 0.0 && vector.mm <= COUNTED {
                continue;
            }
            let has_direction = vector.mm.min(length.expected / mu) >= SHORT && vector.doubt() <= DOUBTED;
            let direction = lies.degrees().filter(|_| has_direction);
            let direction = direction.map(|turned| Ok((meant(&format!("{name}.angle"))?, turned))).transpose()?;
            put(entries, vector.length(length, mu), CONTRADICTS * mu);
            if let Some((meant, by)) = direction {
                put(entries, vector.direction(meant, by), CONTRADICTS_DEGREES);
            }
        }
    }
    Ok(())
}

/// Adds what places tell, where it is not written already. A written value that differs from it by more than `most` beside their digits and radii
/// is contradicted: of the two the worse one is judged.
fn put(entries: &mut Vec<Entry>, placed: Entry, most: f64) {
    let Some(written) = entries.iter_mut().find(|entry| entry.asked.name() == placed.asked.name()) else {
        return entries.push(placed);
    };
    // A length has no sign, whatever sign is written.
    let own = if placed.asked.is_distance() { written.value.abs() } else { written.value };
    let off = |value: f64, from: f64| placed.asked.turned(value - from).abs();
    let is_contradicted = off(own, placed.value) > most + written.rounding + placed.rounding + placed.doubt;
    if is_contradicted && off(placed.value, placed.expected) > off(own, placed.expected) {
        *written = placed;
    }
}

/// Adds the coordinates of instant centres whose places are given, in the scene's coordinates.
fn coordinates(
    entries: &mut Vec<Entry>,
    (places, own): (&IndexMap<String, PlacedPoint>, &PaperPoints<'_>),
    (mu, lies): (f64, Lies),
    names: &Names<'_>,
) -> Result<(), CheckError> {
    let Some(turned) = lies.degrees() else { return Ok(()) };
    for (name, place) in places.iter().filter(|(name, _)| own.joint(name).is_none()) {
        let from_origin = Placed::between(places[own.origin()], *place);
        let at = own.origin_on_panel() + turn_of_degrees(-turned).transform_vector(&from_origin.vector) * mu;
        for (quantity, value) in own.quantities(name).into_iter().zip([at.x, at.y]) {
            let meant = names.quantity(&quantity).map_err(|error| error.at(format!("points: {name}")))?;
            put(entries, from_origin.on_paper(meant, value, mu), CONTRADICTS * mu);
        }
    }
    Ok(())
}

/// The plans of a form whose places lie turned to the scheme.
pub(super) fn turned(measured: &Measured, solution: &Solution) -> Vec<TurnedPlan> {
    let lying = measured.points.iter().filter_map(|points| {
        let own = PaperPoints::of(solution, points.sheet)?;
        let degrees = Lies::of(points, &own, measured.upright).degrees()?;
        Some(TurnedPlan { sheet: points.sheet, degrees })
    });
    lying.filter(|plan| plan.degrees.abs() >= TOLD).collect()
}

/// The places by the names that the sheet has for its points.
fn usual(points: &PointsOf, own: &PaperPoints<'_>, construction: &Construction) -> IndexMap<String, PlacedPoint> {
    let origin = points.origin(own);
    let named = |name: &str| match origin == Some(name) {
        true => own.origin().to_owned(),
        false => construction.plan_name(points.sheet, name).to_owned(),
    };
    points.places.iter().map(|(name, &place)| (named(name), place)).collect()
}

/// A vector between two places on paper, in mm.
#[derive(Clone, Copy)]
struct Placed {
    vector: Vector,
    mm: f64,
    /// How far its ends may be off together as far as that counts, in mm.
    rounding: f64,
    /// How far they may be off together as their radii say, in mm.
    radius: f64,
}

impl Placed {
    fn between(from: PlacedPoint, to: PlacedPoint) -> Placed {
        let vector = Vector::from(to.at) - Vector::from(from.at);
        // Places from a photograph have their radii. Anybody may write one, so a larger one allows no more: it leaves the place untold.
        let together = |most: f64| {
            let [from, to] = [from, to].map(|place| place.band.unwrap_or(0.0).min(most));
            libm::hypot(from, to).max(ROUNDING)
        };
        Placed {
            vector,
            mm: libm::hypot(vector.x, vector.y),
            rounding: together(COUNTED),
            radius: together(f64::INFINITY),
        }
    }

    /// How far its direction may be off because its ends are, in degrees.
    fn doubt(self) -> f64 {
        libm::atan(self.radius / self.mm).to_degrees()
    }

    /// Its length as a value of a form.
    fn length(self, meant: Meant, mu: f64) -> Entry {
        self.on_paper(meant, self.mm * mu, mu)
    }

    /// What is measured between its ends on paper as a value of a form.
    fn on_paper(self, meant: Meant, value: f64, mu: f64) -> Entry {
        let entry = of(meant, value, self.rounding * mu);
        let doubt = (self.radius - self.rounding) * mu;
        Entry { doubt, factor: mu, factor_without_unit: mu, on_paper: true, per_mm: Some(mu), ..entry }
    }

    /// Its direction as a value of a form, on a plan that lies turned by so many degrees.
    fn direction(self, meant: Meant, turned: f64) -> Entry {
        let value = with_turns(degrees_of(self.vector) - turned, 0.0);
        of(meant, value, self.doubt())
    }
}

/// A value that nobody has written.
fn of(Meant { asked, row, expected, step }: Meant, value: f64, rounding: f64) -> Entry {
    Entry {
        row,
        asked,
        text: String::new(),
        value,
        rounding,
        doubt: 0.0,
        precision: Precision { decimals: 1, digits: 4 },
        is_magnitude: false,
        factor: 1.0,
        factor_without_unit: 1.0,
        unit: None,
        on_paper: false,
        per_mm: None,
        step,
        expected,
    }
}

/// How a plan lies on its sheet.
#[derive(Clone, Copy)]
enum Lies {
    /// Turned to the scheme by so many degrees.
    Turned(f64),
    /// Mirrored: its directions tell nothing more.
    Mirrored,
}

impl Lies {
    /// How the places of a plan lie: as most of its points show it, if they are not those of an upright sheet. Of two turns that as many
    /// points show it is the lesser.
    fn of(points: &PointsOf, own: &PaperPoints<'_>, is_upright: bool) -> Lies {
        let Some(pole) = points.origin(own) else { return Lies::Mirrored };
        if points.is_mirrored(own) {
            return Lies::Mirrored;
        }
        if is_upright {
            return Lies::Turned(0.0);
        }
        let pole = points.places[pole];
        let seen = points.places.iter().filter_map(|(name, &place)| {
            // Joints show how a figure of centres lies: a single centre that is wrong would turn it.
            let right = if own.sheet.order().is_some() { own.right(name) } else { own.joint(name) }?;
            let own = Placed::between(pole, place);
            let by = (own.mm >= SHORT && right != Vector::zeros())
                .then(|| with_turns(degrees_of(own.vector) - degrees_of(right), 0.0))?;
            let [degrees, mm] = NEAR;
            Some((by, degrees.max(libm::atan(mm / own.mm).to_degrees()), own.mm))
        });
        let seen: Vec<(f64, f64, f64)> = seen.collect();
        let near = |turn: f64| {
            seen.iter()
                .map(move |&(by, near, mm)| (with_turns(by - turn, 0.0), near, mm))
                .filter(|(off, near, _)| off.abs() <= *near)
        };
        let best = seen
            .iter()
            .map(|&(by, ..)| by)
            .max_by(|a, b| near(*a).count().cmp(&near(*b).count()).then_with(|| b.abs().total_cmp(&a.abs())));
        let Some(best) = best else { return Lies::Turned(0.0) };
        let (sum, weight) = near(best).fold((0.0, 0.0), |(sum, weight), (off, _, mm)| (sum + mm * off, weight + mm));
        Lies::Turned(with_turns(best + sum / weight, 0.0))
    }

    /// By how many degrees it lies turned; `None` where directions tell nothing.
    fn degrees(self) -> Option<f64> {
        match self {
            Lies::Turned(degrees) => Some(degrees),
            Lies::Mirrored => None,
        }
    }
}
