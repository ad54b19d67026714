//! What a hand probably did where an operation is wrong: the same operation in the catalogue of mistakes of the check; and where a
//! construction leads that goes on with the hand's own things.

use super::entry::{Compute, Entry, LayOff};
use super::judge::Judge;
use super::table::{Made, Table};
use crate::check::replayed::{Replayed, Touched};
use crate::check::{PaperPoints, Told};
use crate::construction::{NumberId, Operation, OperationKind, Values, image_name};
use crate::geometry::{Vector, cross};
use crate::quantity::{QuantityRequest, measured_names, readable_names};
use crate::scene::{Head, QuantityName};
use crate::sheet::{PerSheet, Sheet};
use std::cell::OnceCell;

/// A mistake of the catalogue that does the same.
pub(super) struct Cause {
    /// What is told of it.
    pub told: Told,
    /// Its share of the drawings with a mistake, in per cent; less where it is less like.
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

    /// The mistake that does in all scenes what this entry does with right inputs, and in the scene alone what `typed` numbers make of it;
    /// of several the commonest.
    pub fn of(&self, entry: &Entry, made: &Made, right: &[Table<'_>], typed: Option<&Made>) -> Option<Cause> {
        let scenes = if typed.is_some() { 1 } else { right.len() };
        let mut left: Option<Vec<Cause>> = None;
        for (replayed, table) in self.replayed().iter().zip(right).take(scenes) {
            let alone = typed.cloned().map_or_else(|| table.carry_out(entry), Ok);
            let (Some(replayed), Ok(alone)) = (replayed, alone) else { continue };
            let start = match (entry, made) {
                (Entry::LayOff(LayOff { from, .. }), Made::Place(sheet, ..)) => table.place(*sheet, from),
                _ => None,
            };
            let tolerance = if typed.is_some() { 0.012 } else { 1e-6 };
            let seen = Seen { table, entry, alone: &alone, start, tolerance };
            let found = replayed.candidates().filter_map(|(candidate, touched)| {
                let likeness = touched.iter().map(|touched| seen.likeness(touched, replayed)).fold(0.0, f64::max);
                let share = likeness * candidate.mistake().share();
                (share > 0.0).then(|| Cause { told: candidate.told.clone(), share })
            });
            let found: Vec<Cause> = found.collect();
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
        left?.into_iter().reduce(|best, other| if other.share > best.share { other } else { best })
    }

    /// Whether a number that an entry makes is in all scenes that of a quantity with a name.
    pub fn is_known_number(&self, entry: &Entry, right: &[Table<'_>]) -> bool {
        let known = self.known(right);
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

    fn known(&self, right: &[Table<'_>]) -> &[Vec<f64>] {
        self.known.get_or_init(|| right.iter().map(known_numbers).collect())
    }

    /// What could stand in the place of something of the hand's own: of a point those to which vectors of the plan lead from where it
    /// was laid off, parts of given ones among them, and where the same vector leads from elsewhere; of a number those with names.
    pub fn instead_of(&self, entry: &Entry, table: &Table<'_>) -> Vec<Made> {
        match (entry, table.carried_out_again(entry)) {
            (Entry::LayOff(LayOff { from, .. }), Ok(Made::Place(sheet, name, at))) => {
                let start = table.place(sheet, from).unwrap_or_default();
                let vectors = table.given.vectors(sheet).into_iter().chain(table.given.given_parts(sheet));
                let ends = vectors.flat_map(|v| [v, -v]).map(|v| start + v);
                let elsewhere = table.places(sheet).map(|(_, other)| other + (at - start));
                ends.chain(elsewhere).map(|end| Made::Place(sheet, name.clone(), end)).collect()
            }
            (Entry::Compute(_), Ok(Made::Numbers(all))) => {
                let Some((name, _)) = all.first() else { return Vec::new() };
                let known = known_numbers(table).into_iter().flat_map(|number| [number, -number]);
                known.map(|number| Made::Numbers(vec![(name.clone(), number)])).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Where the construction puts a point that goes on with the hand's own things.
    pub fn expected_place(&self, own: &Table<'_>, sheet: Sheet, name: &str) -> Option<Vector> {
        let values = self.gone_on(own);
        let construction = self.judge.given().construction();
        let place = construction.place(sheet, construction.plan_name(sheet, name))?;
        Some(values.place(place)).filter(|place| place.iter().all(|x| x.is_finite()))
    }

    /// The number that the construction finds which goes on with the hand's own things.
    pub fn expected_number(&self, own: &Table<'_>, name: &str) -> Option<f64> {
        let values = self.gone_on(own);
        let construction = self.judge.given().construction();
        let mechanism = self.judge.given().mechanism();
        let mut numbers = (0..construction.numbers.len()).map(NumberId);
        let is_it = |own: &str| own == name || self.judge.given().same_rates(name).any(|same| same == own);
        let number = numbers.find(|n| is_it(&construction.number_name(mechanism, *n)))?;
        Some(values.number(number)).filter(|x| x.is_finite())
    }

    /// Whether a number can be worked out from what the hand has: crossings must be drawn, all else that the construction does to come to it
    /// a calculator does, too. Numbers that are `unfounded` are none that the hand has.
    pub fn is_worked_out(&self, own: &Table<'_>, name: &str, unfounded: &[String]) -> bool {
        let given = self.judge.given();
        let (construction, mechanism) = (given.construction(), given.mechanism());
        let [places, lines, numbers] = construction.counts();
        let mut drawn = vec![false; places];
        for (sheet, name, place) in construction.named_places() {
            drawn[place.0] |= own.place(sheet, name).is_some();
        }
        let (mut places, mut lines, mut numbers) = (vec![false; places], vec![false; lines], vec![false; numbers]);
        let mut found = Vec::new();
        // Corners of force polygons have whatever names the hand gives them.
        let has_corners = own.places(Sheet::Forces).any(|(name, _)| !given.is_there(name));
        for Operation { kind, sheet, by_hand, .. } in &construction.operations {
            let (read, along) = kind.places_and_lines_read();
            let mut has_all =
                *by_hand && read.iter().all(|place| places[place.0]) && along.iter().all(|line| lines[line.0]);
            kind.each_number_read(|number| has_all &= numbers[number.0]);
            let is_crossed = matches!(kind, OperationKind::Cross { .. });
            if let Some(place) = kind.place() {
                let is_drawn = drawn[place.0] || (*sheet == Sheet::Forces && has_corners);
                places[place.0] = is_drawn || (has_all && !is_crossed);
            }
            if let Some(line) = kind.line() {
                lines[line.0] = has_all;
            }
            for number in kind.numbers() {
                let number_name = construction.number_name(mechanism, *number);
                let is_found = own.number_of(&number_name).is_some() && !unfounded.contains(&number_name);
                numbers[number.0] = has_all || is_found;
                if number_name == name || given.same_rates(name).any(|same| same == number_name) {
                    found.push(numbers[number.0]);
                }
            }
        }
        if !found.is_empty() {
            return found.contains(&true);
        }
        // What the construction does not come to by that name: the points and links of which it is.
        let Some(quantity) = QuantityName::parse(name) else { return true };
        let (sheet, named): (Sheet, fn(&str) -> String) = match quantity.head {
            Head::Velocity => (Sheet::Velocity, image_name),
            Head::Acceleration => (Sheet::Acceleration, image_name),
            Head::Between(sheet) => (sheet, str::to_owned),
            _ => return true,
        };
        let has_end = |end: &String| {
            let name = given.usual(sheet, &named(end));
            let place = construction.place(sheet, construction.plan_name(sheet, &name));
            place.map_or_else(|| own.place(sheet, &name).is_some(), |place| places[place.0])
        };
        quantity.arguments.iter().all(has_end)
    }

    /// The construction with the hand's own points and numbers in place of its own, as far as there are any.
    fn gone_on(&self, own: &Table<'_>) -> Values {
        let given = self.judge.given();
        let construction = given.construction();
        let scales = self.judge.usual_scales();
        let mut values = construction.run(scales, &[]);
        let [places, ..] = construction.counts();
        let mut drawn = vec![None; places];
        for (sheet, name, place) in construction.named_places() {
            drawn[place.0] = drawn[place.0].or_else(|| own.place(sheet, name));
        }
        for operation in &construction.operations {
            values.repeat(operation, [0.0; 2], scales);
            if let Some((place, at)) = operation.kind.place().and_then(|place| Some((place, drawn[place.0]?))) {
                values.put_place(place, at);
            }
            for number in operation.kind.numbers() {
                let found = own.number_of(&construction.number_name(given.mechanism(), *number));
                match (found, &operation.kind) {
                    // What is measured has the sign that the sheet shows.
                    (Some(found), OperationKind::Measure { .. }) => {
                        values.put_number(*number, found.abs() * values.number(*number).signum());
                    }
                    (Some(found), _) => values.put_number(*number, found),
                    (None, _) => {}
                }
            }
        }
        values
    }

    /// How far from its place a point may be that a hand has found on its sheets, in units of the sheet.
    pub fn reach(&self, sheet: Sheet, name: &str, own: &Table<'_>) -> f64 {
        let points = PaperPoints::of(&self.judge.given().solution, sheet);
        let bands = points.into_iter().flat_map(|points| points.quantities(name));
        let free = 3.0 * self.judge.tolerance().mm * own.scale(sheet);
        free + bands.map(|quantity| self.band(&quantity, own)).fold(0.0, libm::hypot)
    }

    /// The band of honest drawings of a quantity on the hand's sheets; 0 where a hand does not read it.
    pub fn band(&self, name: &str, own: &Table<'_>) -> f64 {
        let given = self.judge.given();
        let Ok(asked) = QuantityRequest::new(name, given.mechanism()) else { return 0.0 };
        let scales = PerSheet::from_fn(|sheet| Some(own.scale(sheet)));
        let pencil = crate::quantity::pencil(&given.solution, &scales, *self.judge.tolerance(), vec![asked]);
        pencil.band(name).map_or(0.0, |band| if band.band.is_finite() { band.band } else { 0.0 })
    }
}

/// An entry with right inputs in one scene.
struct Seen<'s, 'g> {
    table: &'s Table<'g>,
    entry: &'s Entry,
    alone: &'s Made,
    start: Option<Vector>,
    /// What numbers may differ by, in parts.
    tolerance: f64,
}

/// Likeness of a mistake that leads to the same point by another operation.
const LESS: f64 = 0.1;

impl Seen<'_, '_> {
    /// Whether what a mistake makes otherwise is what the entry makes: 0 where it is not, 1 where it is the same operation.
    fn likeness(&self, touched: &Touched, replayed: &Replayed<'_>) -> f64 {
        let given = self.table.given;
        let is_same = match (self.alone, touched) {
            // Polygons may be drawn in another order, and begin elsewhere: of a vector its size and direction count.
            (Made::Place(Sheet::Forces, _, at), Touched::Place { at: other, start, right, right_start, .. }) => {
                let vectors = self.start.zip(*start).map(|(own, other_start)| [at - own, other - other_start]);
                let is_moved = start.is_some_and(|start| {
                    (other - start - (right - right_start)).norm() > 1e-9 * given.size(Sheet::Forces)
                });
                vectors.is_some_and(|[own, other]| {
                    is_moved && (own - other).norm() <= self.tolerance.max(1e-6) * own.norm().max(other.norm())
                })
            }
            (Made::Line(_, line), Touched::Line(sheet, at, along)) => {
                let small = self.tolerance * given.size(line.sheet);
                *sheet == line.sheet
                    && line.distance(*at).abs() <= small
                    && cross(line.along, *along).abs() <= self.tolerance
            }
            // A line that goes through where a mistake puts a point, and not where the point is.
            (Made::Line(_, line), Touched::Place { place, at, right, is_crossing: true, .. }) => {
                let small = 1e-6 * given.size(line.sheet);
                // Special points are crossed by lines of the scheme; a ray has a direction to go by.
                let leads_there = line.sheet == Sheet::Scheme
                    && replayed.sheet_of(*place) == Some(line.sheet)
                    && line.distance(*at).abs() <= small
                    && line.distance(*right).abs() > 10.0 * small;
                return if leads_there { LESS } else { 0.0 };
            }
            (Made::Place(sheet, name, at), Touched::Place { place, at: other, start, is_edited, .. })
                if *is_edited || !matches!(self.entry, Entry::Cross(_)) =>
            {
                let near = |a: Vector, b: Vector, size: f64| (a - b).norm() <= self.tolerance * size;
                let has_meaning = given.place(*sheet, name).is_some();
                let run = self.start.map_or(given.size(*sheet), |start| (at - start).norm());
                let starts_there =
                    || self.start.zip(*start).is_some_and(|(own, other)| near(own, other, given.size(*sheet)));
                near(*at, *other, if self.tolerance > 1e-3 { run } else { given.size(*sheet) })
                    && (replayed.is_called(*place, *sheet, name) || (!has_meaning && starts_there()))
            }
            (Made::Numbers(all), Touched::Number { name, value, is_measured }) => {
                // An equation is wrong by a segment only where it has another one.
                let is_of_entry = !is_measured || !matches!(self.entry, Entry::Solve(_)) || self.has_other_segment();
                is_of_entry
                    && all.iter().any(|(own, number)| self.is_same_rate(own, name) && self.same_size(*number, *value))
            }
            // A number that is the size of a vector.
            (Made::Numbers(all), Touched::Place { at, start: Some(start), right, right_start, .. })
                if matches!(self.entry, Entry::Compute(Compute { .. })) =>
            {
                let [size, right_size] = [(at - start).norm(), (right - right_start).norm()];
                all.iter().any(|(name, number)| {
                    let meant = given.number(name).is_some_and(|meant| same(meant.abs(), right_size, 1e-9));
                    meant && self.same_size(*number, size) && !same(size, right_size, 1e-6)
                })
            }
            _ => false,
        };
        if is_same { 1.0 } else { 0.0 }
    }

    fn has_other_segment(&self) -> bool {
        let Entry::Solve(solve) = self.entry else { return false };
        let known = measured_names(self.table.given.construction());
        let sides = solve.equations.iter().filter_map(|text| super::formula::Formula::sides(text).ok());
        sides.flatten().any(|side| {
            let mut segments = side.names().into_iter().filter(|name| super::names::segment_of(name).is_some());
            segments.any(|name| !known.iter().any(|known| known == name))
        })
    }

    /// Whether both are the same number, as the rates of links that turn together.
    fn is_same_rate(&self, own: &str, name: &str) -> bool {
        own == name || self.table.given.same_rates(own).any(|same| same == name)
    }

    fn same_size(&self, a: f64, b: f64) -> bool {
        same(a.abs(), b.abs(), self.tolerance)
    }
}

fn same(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
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
