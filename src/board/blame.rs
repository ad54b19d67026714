//! Who is to blame for a wrong entry, and what was probably done there: the entry itself, or something of the hand's own on which it hangs.

use super::alone::Held;
use super::bench::{Bench, has_numbers, is_typed_here};
use super::direction::Direction;
use super::entry::{Compute, Entry, LayOff, Line, Measure};
use super::formula::Formula;
use super::judge::{Verdict, Wrong};
use super::reads::reads;
use super::says;
use super::slips::Slip;
use super::table::{Made, things};
use crate::check::{Blank, Mistake, Told, tell};
use crate::geometry::{Vector, complex_product, unit};
use crate::message::Message;
use crate::scene::{Head, QuantityName};
use crate::sheet::{QuantityKind, Sheet};
use std::collections::{BTreeMap, BTreeSet};

/// Most names of a formula that is written out.
const MOST_NAMES: usize = 40;

/// The longest chain of the hand's own things that is gone through.
const MOST_CHAINED: usize = 25;

impl Bench<'_> {
    /// The verdict on a wrong entry: it is wrong itself, or follows from something of the hand's own that nothing else has judged.
    pub(super) fn blamed(
        &self,
        entry: &Entry,
        made: &Made,
        is_typed: bool,
        what: Message,
        verdicts: &mut [Verdict],
    ) -> Verdict {
        let mistake = self.cause(entry, made, is_typed);
        let is_known = mistake.is_some();
        // A right vector or ray that does not begin where it should: its beginning may be what is wrong.
        let is_of_start = [Mistake::VectorFromWrongPoint, Mistake::RayFromWrongPoint];
        let begins_wrong =
            mistake.as_ref().is_some_and(|told| is_of_start.contains(&told.mistake)) && self.begins_at_own(entry, made);
        if !is_known || begins_wrong {
            for entry in self.as_meant(entry) {
                let Some((earlier, right)) = self.culprit(&entry, made, is_typed) else { continue };
                let own = self.done.iter().find(|(index, _)| *index == earlier);
                let told = own.and_then(|(_, own)| right.into_iter().find_map(|right| self.slip(own, right, is_typed)));
                if told.is_none() && is_known {
                    continue;
                }
                let name = things(made).into_iter().next().map_or_else(String::new, |(_, name)| name);
                verdicts[earlier] = Verdict::Wrong(Wrong { what: says::leads_wrong(name), mistake: told });
                return Verdict::Follows;
            }
        }
        Verdict::Wrong(Wrong { what, mistake })
    }

    /// The entry; of a free line all that it may mean.
    fn as_meant(&self, entry: &Entry) -> Vec<Entry> {
        match entry {
            Entry::Line(line) if line.drawn.is_some() => self.meant(line),
            other => vec![other.clone()],
        }
    }

    /// Whether a vector or a line begins at a point of the hand's own.
    fn begins_at_own(&self, entry: &Entry, made: &Made) -> bool {
        let begins = match (entry, made) {
            (Entry::LayOff(laid), Made::Place(sheet, ..)) => Some((*sheet, &laid.from)),
            (Entry::Line(line), Made::Line(_, drawn)) => line.through.as_ref().map(|through| (drawn.sheet, through)),
            _ => None,
        };
        begins.is_some_and(|(sheet, from)| self.made.contains_key(&(Some(sheet), from.clone())))
    }

    /// The mistake of the catalogue that does the same, or a slip that explains it; of a free line whatever it may have meant.
    fn cause(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<Told> {
        if let Some(told) = self.cause_with_centers(entry, made) {
            return Some(told);
        }
        let slip = || self.meant_to_be(entry, made).and_then(|right| self.slip(entry, right, is_typed));
        let of = |entry: &Entry| {
            let told = |typed: Option<&Made>| self.causes.of(entry, made, &self.right, typed).map(|cause| cause.told);
            if is_typed { self.as_if_right(entry, true).iter().find_map(|typed| told(Some(typed))) } else { told(None) }
        };
        let torque_sense = || self.reversed_drive(entry, made);
        match entry {
            Entry::Line(line) => {
                let meant = self.meant(line);
                let turned = || self.meant_turned_over(line).into_iter();
                meant
                    .iter()
                    .find_map(of)
                    .or_else(|| meant.iter().cloned().chain(turned()).find_map(|one| self.turned_over(&one)))
            }
            // A vector has its classical mistakes; another length or segment is a slip like others.
            Entry::LayOff(_) => match of(entry) {
                Some(told) if !matches!(told.mistake, Mistake::WrongLength | Mistake::WrongSegment) => Some(told),
                other => slip().or(other),
            },
            // In equations signs are wrong, too, which the catalogue takes for something else.
            Entry::Solve(_) if !is_of_forces(entry) => slip(),
            Entry::Measure(measure) if self.missing_where_measured(measure).is_some() => {
                self.missing_where_measured(measure)
            }
            Entry::Measure(Measure { read: Some(read), .. }) => slip()
                .or_else(|| self.misreading(entry, *read))
                .or_else(|| of(entry))
                .or_else(|| self.between_others(entry)),
            Entry::Measure(_) => slip().or_else(|| of(entry)).or_else(|| self.between_others(entry)),
            Entry::Compute(Compute { compute, by: None, value: Some(value), .. }) => {
                let told = self.mistyped(compute, *value).or_else(torque_sense);
                told.or_else(slip).or_else(|| of(entry))
            }
            // A sum of moments has mistakes of its own.
            _ if is_of_forces(entry) => {
                let told = torque_sense().or_else(|| of(entry));
                told.or_else(|| self.slip_of_moments(entry, made))
                    .or_else(|| slip().map(|told| self.as_arm(entry, told)))
            }
            _ => slip().or_else(|| of(entry)),
        }
    }

    /// What a drive needs, with the sense of what it works against.
    fn reversed_drive(&self, entry: &Entry, made: &Made) -> Option<Told> {
        let (Ok(Made::Numbers(found)), Made::Numbers(_)) = (self.right[0].carried_out_again(entry), made) else {
            return None;
        };
        let (name, found) = found.first()?;
        let is_drive = QuantityName::parse(name).is_some_and(|name| matches!(name.head, Head::Torque | Head::Push));
        let right = self.judge.given().number(name).filter(|_| is_drive)?;
        let is_turned = (found + right).abs() <= 0.012 * right.abs();
        is_turned.then(|| tell::torque_sense(Blank::Quantity(name.clone())))
    }

    /// A ray at the angle of a link's triangle that was laid off to the wrong side.
    fn turned_over(&self, entry: &Entry) -> Option<Told> {
        let Entry::Line(line) = entry else { return None };
        let Some(Direction::Turned { turned: [from, to], base }) = &line.along else { return None };
        let turned = [to.clone(), from.clone()];
        let other = Line { along: Some(Direction::Turned { turned, base: base.clone() }), ..line.clone() };
        let is_right = matches!(self.holds(&Entry::Line(other), &line.line, false), Held::All);
        let target = self.targets.get(&line.line)?.first()?;
        let through = line.through.as_deref()?;
        let end = base.split(',').map(str::trim).find(|end| *end != through)?;
        is_right.then(|| tell::mirrored_image(through.into(), target.as_str().into(), end.into()))
    }

    /// A segment of the hand's own that was measured between other points than its name says.
    fn between_others(&self, entry: &Entry) -> Option<Told> {
        let Entry::Measure(measure) = entry else { return None };
        let (sheet, _) = super::names::segment_of(&measure.measure).filter(|_| self.is_between_others(measure))?;
        Some(super::slips::between_others(self.judge.given(), sheet, &measure.measure, [&measure.from, &measure.to]))
    }

    /// Digits that were exchanged where a number was typed that the hand's own things give.
    fn mistyped(&self, name: &str, typed: f64) -> Option<Told> {
        let expected = self.causes.expected_number(&self.own, name)?;
        super::slips::digits_transposed(name, typed, expected, 0.012)
    }

    fn misreading(&self, entry: &Entry, read: f64) -> Option<Told> {
        let Entry::Measure(measure) = entry else { return None };
        Slip::misread(&self.own, measure, self.measured_on(measure)?, read)
    }

    /// The slip that explains how an entry makes something else than it should.
    fn slip(&self, entry: &Entry, right: Made, is_typed: bool) -> Option<Told> {
        let table = &self.right[0];
        let tolerance = if is_typed || has_numbers(entry) { 0.012 } else { 1e-6 };
        let (whole, measured) = (self.written_out(entry), self.measured(is_of_forces(entry)));
        let told = |alone: &Made| {
            Slip { table, entry: &whole, alone, right: right.clone(), tolerance, measured: measured.clone() }.told()
        };
        self.as_if_right(entry, is_typed).iter().find_map(told)
    }

    /// What the hand's own names of measured segments and lengths mean.
    fn measured(&self, is_of_forces: bool) -> BTreeMap<String, (Sheet, [String; 2])> {
        let own = self.done.iter().filter_map(|(_, entry)| match entry {
            Entry::Measure(measure) if super::names::segment_of(&measure.measure).is_none() => {
                let (sheet, ends) = (self.measured_on(measure)?, [measure.from.clone(), measure.to.clone()]);
                // What lies at a point of the hand's own is as right as that.
                let have_meaning =
                    is_of_forces || ends.iter().all(|end| self.judge.given().place(sheet, end).is_some());
                have_meaning.then(|| (measure.measure.clone(), (sheet, ends)))
            }
            _ => None,
        });
        own.collect()
    }

    /// The entry with the formulas of the hand's own numbers in place of their names.
    fn written_out(&self, entry: &Entry) -> Entry {
        let own = |name: &str| {
            let index = self.made.get(&(None, name.to_owned()))?;
            match self.done.iter().find(|(other, _)| other == index)? {
                (_, Entry::Compute(Compute { by: Some(by), sense: None, .. })) => Some(by.clone()),
                _ => None,
            }
        };
        // A number of one's own may be made of others, which a long drawing does without end.
        let out = |formula: &Formula| {
            (0..3).fold(formula.clone(), |formula, _| match formula.names().len() {
                0..MOST_NAMES => formula.with(&own),
                _ => formula,
            })
        };
        match entry {
            Entry::LayOff(laid) => Entry::LayOff(LayOff { size: out(&laid.size), ..laid.clone() }),
            Entry::Compute(compute) => Entry::Compute(Compute { by: compute.by.as_ref().map(out), ..compute.clone() }),
            other => other.clone(),
        }
    }

    /// What an entry may make in the scene with right inputs: a typed number was worked out from the hand's own things, right or by a usual
    /// mistake.
    fn as_if_right(&self, entry: &Entry, is_typed: bool) -> Vec<Made> {
        let mut all: Vec<Made> = self.in_the_same_ratio(entry, is_typed).into_iter().collect();
        // A number with a meaning of its own is held against what should come out.
        let has_meaning = |made: &Made| match made {
            Made::Numbers(all) => all.iter().any(|(name, _)| self.judge.given().number(name).is_some()),
            _ => false,
        };
        if is_typed && !all.iter().any(has_meaning) {
            all.extend(self.made_with_right_numbers(entry, true));
        }
        all
    }

    /// What an entry makes in the scene with right inputs; a typed number is taken in the same ratio to what should come out of the hand's
    /// own things.
    fn in_the_same_ratio(&self, entry: &Entry, is_typed: bool) -> Option<Made> {
        let table = &self.right[0];
        let alone = table.carried_out_again(entry).ok()?;
        if !is_typed {
            return Some(alone);
        }
        let given = self.judge.given();
        Some(match (alone, entry) {
            (Made::Place(sheet, name, at), Entry::LayOff(LayOff { from, .. })) => {
                let own = self.own.place(sheet, from).zip(table.place(sheet, from));
                let expected = self.causes.expected_place(&self.own, sheet, &name).zip(given.place(sheet, &name));
                // The vector may have been laid off from a wrong point.
                let arrow = given.construction().arrows(sheet).find(|arrow| arrow.to == name);
                let begins = arrow.map_or(from.as_str(), |arrow| arrow.from.as_str());
                let begins = self.own.place(sheet, begins).zip(given.place(sheet, begins)).or(own);
                let at =
                    own.zip(expected).zip(begins).map_or(at, |(((own_start, start), (expected, right)), begins)| {
                        let found = match self.own.carried_out_again(entry) {
                            Ok(Made::Place(_, _, found)) => found - own_start,
                            _ => at - start,
                        };
                        start
                            + over(complex_product(found, right - begins.1), expected - begins.0).unwrap_or(at - start)
                    });
                Made::Place(sheet, name, at)
            }
            (Made::Numbers(all), Entry::Compute(Compute { by: None, .. })) => {
                let scaled = all.into_iter().map(|(name, number)| {
                    let expected = self.causes.expected_number(&self.own, &name).zip(given.number(&name));
                    let ratio = expected.map_or(1.0, |(expected, right)| right / expected);
                    let is_near = (ratio.abs() - 1.0).abs() < 0.2;
                    (name, if is_near { number * ratio.abs() } else { number })
                });
                Made::Numbers(scaled.collect())
            }
            (alone, _) => alone,
        })
    }

    /// What an entry should make, where its name says that.
    fn meant_to_be(&self, entry: &Entry, made: &Made) -> Option<Made> {
        let given = self.judge.given();
        match made {
            Made::Place(sheet, name, _) => Some(Made::Place(*sheet, name.clone(), given.place(*sheet, name)?)),
            Made::Numbers(all) => {
                let right = |(name, _): &(String, f64)| {
                    let right = given.number(&self.meaning(entry, name)?)?;
                    Some((name.clone(), right))
                };
                all.iter().map(right).collect::<Option<_>>().map(Made::Numbers)
            }
            Made::Line(..) => None,
        }
    }

    /// Of the hand's own things on which a wrong entry hangs, the first with which it would be right, were that something that has a
    /// name, as a vector of the plan or a known number, and what that may be. Where there is only one, it is that one.
    fn culprit(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<(usize, Vec<Made>)> {
        if self.has_two_exchanged(entry, made) {
            return None;
        }
        let hangs_on = self.chain(entry);
        let with_right_numbers = |entry: &Entry| match is_typed_here(entry) {
            true => self.with_right_numbers(entry, false).into_iter().next().unwrap_or_else(|| entry.clone()),
            false => entry.clone(),
        };
        let suspects: Vec<usize> = hangs_on.iter().copied().filter(|index| self.is_unsure(*index)).collect();
        let mended = |suspect: usize| {
            let table = &self.right[0];
            let replaced = self.done.iter().find(|(index, _)| *index == suspect)?.1;
            let is_right = |instead: &Made| {
                let mut other = table.clone();
                other.put(instead.clone());
                for index in hangs_on.iter().filter(|index| **index > suspect) {
                    let (_, entry) = self.done.iter().find(|(other, _)| other == index)?;
                    let again = other.carried_out_again(&with_right_numbers(entry)).ok()?;
                    other.put(again);
                }
                let again = other.carried_out_again(&with_right_numbers(entry)).ok()?;
                self.is_meant(&again, made).then_some(())
            };
            let is_same_size = |instead: &Made| match (instead, table.carried_out_again(replaced)) {
                (Made::Numbers(instead), Ok(Made::Numbers(own))) => {
                    instead.iter().zip(&own).all(|((_, a), (_, b))| (a.abs() - b.abs()).abs() <= 1e-6 * b.abs())
                }
                _ => false,
            };
            // A size that is right with the other sign is no wrong size.
            let all = self.causes.instead_of(replaced, table).into_iter().filter(|instead| !is_same_size(instead));
            let right: Vec<Made> = all.filter(|instead| is_right(instead).is_some()).collect();
            let is_explained = || right.iter().any(|right| self.slip(replaced, right.clone(), is_typed).is_some());
            (!right.is_empty() && (self.is_unsure(suspect) || is_explained())).then_some(right)
        };
        // What has a name of its own may still be the wrong one here.
        let all = suspects.iter().chain(hangs_on.iter().filter(|index| !suspects.contains(index)));
        let mut all = all.copied().filter(|_| hangs_on.len() <= MOST_CHAINED);
        let found = all.find_map(|suspect| mended(suspect).map(|right| (suspect, right)));
        found.or_else(|| {
            // Of a sum of moments, with so many arms, the first is no more suspect than the others.
            let is_number = !matches!(entry, Entry::Line(_) | Entry::Join(_))
                && !is_of_forces(entry)
                && self.has_right_direction(entry, made);
            suspects.first().filter(|_| is_number).map(|first| (*first, Vec::new()))
        })
    }

    /// Whether a number would be right with two of its formula's names exchanged, as in a ratio that was turned over.
    fn has_two_exchanged(&self, entry: &Entry, made: &Made) -> bool {
        let Entry::Compute(compute) = entry else { return false };
        let Some(formula) = compute.by.as_ref().filter(|by| by.names().len() < MOST_NAMES) else { return false };
        let names = formula.names();
        let pairs =
            names.iter().enumerate().flat_map(|(at, one)| names[at + 1..].iter().map(move |other| [*one, *other]));
        pairs.filter(|[one, other]| one != other).any(|[one, other]| {
            let exchanged = |name: &str| match name {
                _ if name == one => Formula::read(other).ok(),
                _ if name == other => Formula::read(one).ok(),
                _ => None,
            };
            let exchanged = Compute { by: Some(formula.with(&exchanged)), ..compute.clone() };
            let again = self.right[0].carried_out_again(&Entry::Compute(exchanged));
            again.is_ok_and(|again| self.is_meant(&again, made))
        })
    }

    fn is_unsure(&self, index: usize) -> bool {
        self.unsure.values().any(|own| *own == index)
    }

    /// The entries of the hand's own things on which an entry hangs, in order.
    fn chain(&self, entry: &Entry) -> Vec<usize> {
        let mut found = BTreeSet::new();
        let mut open = reads(entry, &self.own);
        while let Some(thing) = open.pop() {
            let Some(&index) = self.made.get(&thing) else { continue };
            if found.insert(index)
                && let Some((_, entry)) = self.done.iter().find(|(other, _)| *other == index)
            {
                open.extend(reads(entry, &self.own));
            }
        }
        found.into_iter().collect()
    }

    /// Whether what was made in the scene is what its name means.
    fn is_meant(&self, found: &Made, made: &Made) -> bool {
        let given = self.judge.given();
        match (found, made) {
            (Made::Place(sheet, name, at), Made::Place(..)) => {
                given.place(*sheet, name).is_some_and(|right| (at - right).norm() <= 1e-6 * given.size(*sheet))
            }
            (Made::Numbers(all), Made::Numbers(_)) => all.iter().all(|(name, number)| {
                given.number(name).is_some_and(|right| (number.abs() - right.abs()).abs() <= 1e-6 * right.abs())
            }),
            (Made::Line(name, line), Made::Line(..)) => {
                let mut targets = self.targets.get(name).into_iter().flatten();
                targets.any(|target| {
                    let place = given.place(line.sheet, target);
                    place.is_some_and(|place| line.distance(place).abs() <= 1e-6 * given.size(line.sheet))
                })
            }
            _ => false,
        }
    }

    /// Whether what is wrong may come from a number that was read: not where a vector has a wrong direction.
    fn has_right_direction(&self, entry: &Entry, made: &Made) -> bool {
        let (Entry::LayOff(LayOff { from, .. }), Made::Place(sheet, name, _)) = (entry, made) else { return true };
        let right = &self.right[0];
        let ends = self.judge.given().place(*sheet, name).zip(right.place(*sheet, from));
        let Ok(Made::Place(_, _, end)) = right.carry_out(entry) else { return true };
        let directions = ends.and_then(|(end_right, start)| Some((unit(end_right - start)?, unit(end - start)?)));
        directions.is_none_or(|(a, b)| crate::geometry::cross(a, b).abs() < 1e-6)
    }
}

/// Whether an entry finds a force or a moment.
fn is_of_forces(entry: &Entry) -> bool {
    let is_one = |name: &str| {
        QuantityName::parse(name).is_some_and(|name| matches!(name.kind(), QuantityKind::Force | QuantityKind::Moment))
    };
    match entry {
        Entry::Compute(Compute { compute, .. }) => is_one(compute),
        Entry::Solve(solve) => solve.solve.iter().any(|name| is_one(name)),
        _ => false,
    }
}

/// Their quotient; `None` where the divisor is nothing.
fn over(a: Vector, b: Vector) -> Option<Vector> {
    let size = b.norm_squared();
    (size > 0.0).then(|| complex_product(a, Vector::new(b.x, -b.y)) / size)
}
