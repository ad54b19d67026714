//! What a hand probably did where an operation is wrong: the same operation in the catalogue of mistakes of the check; and where a
//! construction leads that goes on with the hand's own things.

use super::file::{Entry, LayOff};
use super::judge::Judge;
use super::table::{DrawnLine, Made, Table};
use crate::check::Told;
use crate::check::replayed::{Replayed, Touched};
use crate::construction::{OperationKind, Tolerance, Values};
use crate::geometry::{Vector, cross};
use crate::quantity::{QuantityRequest, readable_names};
use crate::sheet::Sheet;
use std::cell::OnceCell;

/// A mistake of the catalogue that does the same.
pub(super) struct Cause {
    /// What is told of it.
    pub told: Told,
    /// Its share of the drawings with a mistake, in per cent.
    share: f64,
}

/// The catalogue, replayed in the scene and in those like it; worked out when the first wrong entry asks.
pub(super) struct Causes<'j> {
    judge: &'j Judge,
    replayed: OnceCell<Vec<Option<Replayed<'j>>>>,
    known: OnceCell<Vec<Vec<f64>>>,
}

impl<'j> Causes<'j> {
    pub fn new(judge: &'j Judge) -> Causes<'j> {
        Causes { judge, replayed: OnceCell::new(), known: OnceCell::new() }
    }

    fn replayed(&self) -> &[Option<Replayed<'j>>] {
        self.replayed.get_or_init(|| {
            let all = std::iter::once(self.judge.given()).chain(self.judge.others());
            all.map(|given| Replayed::new(&given.solution, self.judge.usual_scales())).collect()
        })
    }

    /// The mistake that does in all scenes what this entry does with right inputs; of several the commonest.
    pub fn of(&self, entry: &Entry, made: &Made, right: &[Table<'_>]) -> Option<Cause> {
        let mut left: Option<Vec<Cause>> = None;
        for (replayed, table) in self.replayed().iter().zip(right) {
            let (Some(replayed), Ok(alone)) = (replayed, table.carry_out(entry)) else { continue };
            let start = match (entry, made) {
                (Entry::LayOff(LayOff { from, .. }), Made::Place(sheet, ..)) => table.place(*sheet, from),
                _ => None,
            };
            let seen = Seen { table, alone: &alone, start };
            let found = replayed.candidates().filter(|(_, touched)| touched.iter().any(|t| seen.is_of(t, replayed)));
            let found: Vec<Cause> = found
                .map(|(candidate, _)| Cause { told: candidate.told.clone(), share: candidate.mistake().share() })
                .collect();
            left = Some(match left {
                None => found,
                // Another scene may lack a mistake that makes no difference there.
                Some(before) if found.is_empty() => before,
                Some(before) => {
                    let is_told = |one: &Cause| found.iter().any(|other| other.told.is_same_place(&one.told));
                    before.into_iter().filter(is_told).collect()
                }
            });
            if left.as_ref().is_some_and(Vec::is_empty) {
                return None;
            }
        }
        let left = left?;
        left.into_iter().reduce(|best, other| if other.share > best.share { other } else { best })
    }

    /// Whether a number that an entry makes is in all scenes that of a quantity with a name.
    pub fn is_known_number(&self, entry: &Entry, right: &[Table<'_>]) -> bool {
        let known = self.known.get_or_init(|| right.iter().map(|table| known_numbers(table)).collect());
        let found = |table: &Table<'_>| match table.carry_out(entry) {
            Ok(Made::Numbers(all)) => all.first().map(|(_, number)| number.abs()),
            _ => None,
        };
        let Some(first) = right.first().and_then(found) else { return false };
        let is_same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.max(b);
        (0..known[0].len()).any(|at| {
            is_same(known[0][at], first)
                && right.iter().zip(known).all(|(table, known)| {
                    found(table).is_none_or(|found| known.get(at).is_none_or(|known| is_same(*known, found)))
                })
        })
    }

    /// Where the construction puts a point that goes on with the hand's own things.
    pub fn expected_place(&self, own: &Table<'_>, sheet: Sheet, name: &str) -> Option<Vector> {
        let values = self.gone_on(own)?;
        let construction = self.judge.given().construction();
        let place = construction.place(sheet, construction.plan_name(sheet, name))?;
        Some(values.place(place)).filter(|place| place.iter().all(|x| x.is_finite()))
    }

    /// The number that the construction finds which goes on with the hand's own things.
    pub fn expected_number(&self, own: &Table<'_>, name: &str) -> Option<f64> {
        let values = self.gone_on(own)?;
        let construction = self.judge.given().construction();
        let mechanism = self.judge.given().mechanism();
        let numbers = 0..construction.numbers.len();
        let number =
            numbers.map(crate::construction::NumberId).find(|n| construction.number_name(mechanism, *n) == name)?;
        Some(values.number(number)).filter(|x| x.is_finite())
    }

    /// The construction with the hand's own points and numbers in place of its own, as far as there are any.
    fn gone_on(&self, own: &Table<'_>) -> Option<Values> {
        let given = self.judge.given();
        let construction = given.construction();
        let scales = self.judge.usual_scales();
        let mut values = construction.run(scales, &[]);
        for operation in &construction.operations {
            values.repeat(operation, [0.0; 2], scales);
            if let Some(place) = operation.kind.place() {
                let mut names = construction.named_places().filter(|(.., other)| *other == place);
                let at = names.find_map(|(sheet, name, _)| own.place(sheet, name));
                at.into_iter().for_each(|at| values.put_place(place, at));
            }
            for number in operation.kind.numbers() {
                let name = construction.number_name(given.mechanism(), *number);
                let found = own.numbers().find(|(own, _)| *own == name);
                // What is measured stays: the hand's own places are there.
                if let (Some((_, found)), OperationKind::Solve { .. } | OperationKind::Compute { .. }) =
                    (found, &operation.kind)
                {
                    values.put_number(*number, found);
                }
            }
        }
        Some(values)
    }

    /// How far from its place a point may be that a hand has found, in millimetres.
    pub fn reach(&self, sheet: Sheet, name: &str, scale: f64, tolerance: &Tolerance) -> f64 {
        let segment = sheet.order().map(|order| sheet.segment_name(order.pole(), name));
        let band = segment.map_or(0.0, |segment| self.band(&segment, tolerance) / scale);
        3.0 * tolerance.mm + band
    }

    /// The band of honest drawings of a quantity; 0 where a hand does not read it.
    pub fn band(&self, name: &str, tolerance: &Tolerance) -> f64 {
        let given = self.judge.given();
        let Ok(asked) = QuantityRequest::new(name, given.mechanism()) else { return 0.0 };
        let scales = self.judge.usual_scales().map(Some);
        let pencil = crate::quantity::pencil(&given.solution, &scales, *tolerance, vec![asked]);
        pencil.band(name).map_or(0.0, |band| if band.band.is_finite() { 3.0 * band.band } else { 0.0 })
    }
}

/// An entry with right inputs in one scene.
struct Seen<'s, 'g> {
    table: &'s Table<'g>,
    alone: &'s Made,
    start: Option<Vector>,
}

impl Seen<'_, '_> {
    /// Whether what a mistake makes otherwise is what the entry makes.
    fn is_of(&self, touched: &Touched, replayed: &Replayed<'_>) -> bool {
        match (self.alone, touched) {
            (Made::Line(_, line), Touched::Line(sheet, at, along)) => {
                *sheet == line.sheet && self.is_on(line, *at) && cross(line.along, *along).abs() < 1e-6
            }
            (Made::Place(sheet, name, at), Touched::Place(place, other, start)) => {
                let is_meant = replayed.is_called(*place, *sheet, name);
                let small = 1e-6 * self.table.given.size(*sheet);
                let near = |a: Vector, b: Vector| (a - b).norm() <= small;
                let has_meaning = self.table.given.place(*sheet, name).is_some();
                near(*at, *other)
                    && (is_meant
                        || (!has_meaning && self.start.zip(*start).is_some_and(|(own, other)| near(own, other))))
            }
            (Made::Numbers(all), Touched::Number(name, value)) => {
                all.iter().any(|(own, number)| own == name && same_size(*number, *value))
            }
            _ => false,
        }
    }

    fn is_on(&self, line: &DrawnLine, at: Vector) -> bool {
        line.distance(at).abs() <= 1e-6 * self.table.given.size(line.sheet)
    }
}

fn same_size(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs())
}

/// The sizes of all numbers that have names in a scene.
fn known_numbers(table: &Table<'_>) -> Vec<f64> {
    let given = table.given;
    let names = readable_names(&given.solution);
    let mut known: Vec<f64> = names.iter().filter_map(|name| given.number(name)).map(f64::abs).collect();
    for sheet in Sheet::ALL {
        known.extend(given.vectors(sheet).into_iter().map(|v| v.norm()));
        let places: Vec<Vector> = given.places(sheet).map(|(_, place)| place).collect();
        for (at, a) in places.iter().enumerate() {
            known.extend(places[at + 1..].iter().map(|b| (a - b).norm()));
        }
    }
    known
}
