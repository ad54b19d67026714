//! A drawing on the judge's bench: entry by entry the verdict, with the right things beside the hand's own.

use super::cause::Causes;
use super::file::{Compute, Cross, Direction, Entry, HandDrawing, LayOff, Line, Measure, Solve};
use super::formula::Formula;
use super::given::{Given, usual};
use super::judge::{BoardError, Judge, JudgedDrawing, Verdict, Wrong, standing};
use super::reads::reads;
use super::says;
use super::slips::Slip;
use super::table::{DrawnLine, Made, Table};
use crate::check::{Mistake, Told, tell};
use crate::geometry::{Vector, unit};
use crate::message::Message;
use crate::sheet::Sheet;
use std::collections::{BTreeMap, BTreeSet};

/// A drawing while it is judged.
pub(super) struct Bench<'j> {
    pub judge: &'j Judge,
    /// The hand's own things.
    pub own: Table<'j>,
    /// The right things: in the scene, then in the others.
    pub right: Vec<Table<'j>>,
    /// By line: the points at whose crossings it is used, in order.
    pub targets: BTreeMap<String, Vec<String>>,
    /// By line: how many entries use it.
    pub uses: BTreeMap<String, usize>,
    /// Points and numbers of the hand's own that are not known to be right, with the entries that made them: those of one's own that they
    /// hang on are among them.
    unsure: BTreeMap<Thing, usize>,
    /// All points and numbers of the hand's own, with the entries that made them.
    made: BTreeMap<Thing, usize>,
    /// Things of the hand's own in which there are numbers or angles that somebody typed.
    typed: BTreeSet<Thing>,
    /// Things of the hand's own in which there are any numbers at all.
    numbered: BTreeSet<Thing>,
    /// Things that hang on something wrong.
    tainted: BTreeSet<Thing>,
    /// The entries that have been judged.
    done: Vec<(usize, &'j Entry)>,
    pub causes: Causes<'j>,
}

/// A thing by its sheet, where it has one, and its name.
pub(super) type Thing = (Option<Sheet>, String);

/// What an entry comes to when it is carried out with right inputs.
pub(super) enum Found {
    Right,
    /// What is wrong.
    Wrong(Message),
    /// It has a name of its own, and is neither.
    Own,
}

impl<'j> Bench<'j> {
    pub fn new(judge: &'j Judge, drawing: &HandDrawing) -> Bench<'j> {
        let scales = judge.scales(drawing);
        let all = std::iter::once(judge.given()).chain(judge.others());
        let mut targets: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (_, entry) in standing(drawing) {
            if let Entry::Cross(Cross { cross, of, .. }) = entry {
                of.iter().for_each(|line| targets.entry(line.clone()).or_default().push(cross.clone()));
            }
        }
        Bench {
            judge,
            own: Table::new(judge.given(), scales),
            right: all.map(|given| Table::new(given, scales)).collect(),
            targets,
            uses: BTreeMap::new(),
            unsure: BTreeMap::new(),
            made: BTreeMap::new(),
            typed: BTreeSet::new(),
            numbered: BTreeSet::new(),
            tainted: BTreeSet::new(),
            done: Vec::new(),
            causes: Causes::new(judge),
        }
    }

    pub fn judged(mut self, drawing: &'j HandDrawing) -> Result<JudgedDrawing, BoardError> {
        let mut verdicts = vec![Verdict::Undone; drawing.did.len()];
        let used = used(drawing, &self.own)?;
        for (_, name) in used.iter().filter(|(sheet, _)| sheet.is_none()) {
            *self.uses.entry(name.clone()).or_default() += 1;
        }
        for (index, entry) in standing(drawing) {
            let made = self.own.carry_out_by_hand(entry).map_err(|message| BoardError { entry: index, message })?;
            // Of a free line what it means, where that is right.
            let meant = self.right_meaning(entry);
            let reads = reads(meant.as_ref().unwrap_or(entry), &self.own);
            let is_typed = is_typed(entry) || reads.iter().any(|read| self.typed.contains(read));
            let mut found = self.found(entry, &made, is_typed);
            // A factor of 2 may be a rate that somebody typed.
            let may_be = has_numbers(entry) || reads.iter().any(|read| self.numbered.contains(read));
            let is_typed = is_typed || matches!(found, Found::Wrong(_)) && may_be;
            if matches!(found, Found::Wrong(_)) && is_typed {
                found = self.found(entry, &made, true);
            }
            let things = things(&made);
            let follows = reads.iter().any(|read| self.tainted.contains(read));
            verdicts[index] = match found {
                Found::Own if !things.iter().any(|thing| used.contains(thing)) => Verdict::Unused,
                Found::Right | Found::Own if follows => Verdict::Follows,
                Found::Right | Found::Own => Verdict::Right,
                Found::Wrong(what) => self.blamed(entry, &made, is_typed, what, &mut verdicts),
            };
            if matches!(verdicts[index], Verdict::Wrong(_) | Verdict::Follows) {
                self.tainted.extend(things.iter().cloned());
            }
            self.put_right(index, entry, &made, is_typed, &verdicts[index]);
            self.own.put(made);
            self.done.push((index, entry));
        }
        Ok(JudgedDrawing { verdicts })
    }

    /// Whether it uses something of the hand's own in which there are typed numbers.
    pub fn reads_typed(&self, entry: &Entry) -> bool {
        reads(entry, &self.own).iter().any(|read| self.typed.contains(read))
    }

    /// The verdict on a wrong entry: it is wrong itself, or follows from something of the hand's own that nothing else has judged.
    fn blamed(&self, entry: &Entry, made: &Made, is_typed: bool, what: Message, verdicts: &mut [Verdict]) -> Verdict {
        let mistake = self.cause(entry, made, is_typed);
        if mistake.is_none()
            && let Some((earlier, right)) = self.culprit(entry, made)
        {
            let name = things(made).into_iter().next().map_or_else(String::new, |(_, name)| name);
            let own = self.done.iter().find(|(index, _)| *index == earlier);
            let mistake = own.zip(right).and_then(|((_, own), right)| self.slip(own, right, is_typed));
            verdicts[earlier] = Verdict::Wrong(Wrong { what: says::leads_wrong(name), mistake });
            return Verdict::Follows;
        }
        Verdict::Wrong(Wrong { what, mistake })
    }

    /// The mistake of the catalogue that does the same, or a slip that explains it; of a free line whatever it may have meant.
    fn cause(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<Told> {
        let slip = || self.meant_to_be(entry, made).and_then(|right| self.slip(entry, right, is_typed));
        let of = |entry: &Entry| {
            let typed = if is_typed { self.as_if_right(entry, true) } else { None };
            self.causes.of(entry, made, &self.right, typed.as_ref()).map(|cause| cause.told)
        };
        match entry {
            Entry::Line(line) => {
                let meant = self.meant(line);
                meant.iter().find_map(of).or_else(|| meant.iter().find_map(|meant| self.turned_over(meant)))
            }
            // A vector has its classical mistakes; another length is a slip like others.
            Entry::LayOff(_) => match of(entry) {
                Some(told) if told.mistake != Mistake::WrongLength => Some(told),
                other => slip().or(other),
            },
            // In equations signs are wrong, too, which the catalogue takes for something else.
            Entry::Solve(_) => slip(),
            Entry::Measure(Measure { read: Some(read), .. }) => {
                slip().or_else(|| self.misreading(entry, *read)).or_else(|| of(entry))
            }
            _ => slip().or_else(|| of(entry)),
        }
    }

    /// A ray at the angle of a link's triangle that was laid off to the wrong side.
    fn turned_over(&self, entry: &Entry) -> Option<Told> {
        let Entry::Line(line) = entry else { return None };
        let Some(Direction::Turned { turned: [from, to], base }) = &line.along else { return None };
        let turned = [to.clone(), from.clone()];
        let other = Line { along: Some(Direction::Turned { turned, base: base.clone() }), ..line.clone() };
        let is_right = matches!(self.holds(&Entry::Line(other), &line.line, false), super::alone::Held::All);
        let target = self.targets.get(&line.line)?.first()?;
        let through = line.through.as_deref()?;
        let end = base.split(',').map(str::trim).find(|end| *end != through)?;
        is_right.then(|| tell::mirrored_image(through.into(), target.as_str().into(), end.into()))
    }

    fn misreading(&self, entry: &Entry, read: f64) -> Option<Told> {
        let Entry::Measure(measure) = entry else { return None };
        Slip::misread(&self.own, measure, self.measured_on(measure)?, read)
    }

    /// The slip that explains how an entry makes something else than it should.
    fn slip(&self, entry: &Entry, right: Made, is_typed: bool) -> Option<Told> {
        let table = &self.right[0];
        let alone = self.as_if_right(entry, is_typed)?;
        let tolerance = if is_typed || has_numbers(entry) { 0.012 } else { 1e-6 };
        Slip { table, entry, alone: &alone, right, tolerance }.told()
    }

    /// What an entry makes in the scene with right inputs. A typed number was worked out from the hand's own things: it is taken in the
    /// same ratio to what should come out of these.
    fn as_if_right(&self, entry: &Entry, is_typed: bool) -> Option<Made> {
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
                let at = own.zip(expected).map_or(at, |((own_start, start), (expected, right))| {
                    let found = match self.own.carried_out_again(entry) {
                        Ok(Made::Place(_, _, found)) => found - own_start,
                        _ => at - start,
                    };
                    start + over(times(found, right - start), expected - own_start).unwrap_or(at - start)
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
                    let right = given.number(name).or_else(|| written_together(given, entry, name))?;
                    Some((name.clone(), right))
                };
                all.iter().map(right).collect::<Option<_>>().map(Made::Numbers)
            }
            Made::Line(..) => None,
        }
    }

    /// Of the hand's own things on which a wrong entry hangs, the first with which it would be right, were that something that has a
    /// name, as a vector of the plan or a known number, and what that is. Where there is only one, it is that one.
    fn culprit(&self, entry: &Entry, made: &Made) -> Option<(usize, Option<Made>)> {
        let hangs_on = self.chain(entry);
        let suspects: Vec<usize> = hangs_on.iter().copied().filter(|index| self.is_unsure(*index)).collect();
        let mended = |suspect: usize| {
            let table = &self.right[0];
            let replaced = self.done.iter().find(|(index, _)| *index == suspect)?.1;
            let is_right = |instead: &Made| {
                let mut other = table.clone();
                other.put(instead.clone());
                for index in hangs_on.iter().filter(|index| **index > suspect) {
                    let (_, entry) = self.done.iter().find(|(other, _)| other == index)?;
                    let again = other.carried_out_again(entry).ok()?;
                    other.put(again);
                }
                let again = other.carried_out_again(entry).ok()?;
                self.is_meant(&again, made).then_some(())
            };
            self.causes.instead_of(replaced, table).into_iter().find(|instead| is_right(instead).is_some())
        };
        // What has a name of its own may still be the wrong one here.
        let all = suspects.iter().chain(hangs_on.iter().filter(|index| !suspects.contains(index)));
        let found = all.copied().find_map(|suspect| mended(suspect).map(|right| (suspect, Some(right))));
        found.or_else(|| {
            let is_number = !matches!(entry, Entry::Line(_) | Entry::Join(_)) && self.has_right_direction(entry, made);
            suspects.first().filter(|_| is_number).map(|first| (*first, None))
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

    /// Puts the right things down in all scenes.
    fn put_right(&mut self, index: usize, entry: &Entry, made: &Made, is_typed: bool, verdict: &Verdict) {
        let is_wrong = matches!(verdict, Verdict::Wrong(_));
        let meant = self.right_meaning(entry);
        let entry = meant.as_ref().unwrap_or(entry);
        let is_typed = is_typed || self.reads_typed(entry);
        let is_sure = self.is_sure(entry, made);
        let mut is_own = false;
        for table in &mut self.right {
            let alone = table.carry_out(entry).unwrap_or_else(|_| made.clone());
            let right = match alone {
                Made::Place(sheet, name, at) => {
                    let right = table.given.place(sheet, &name);
                    is_own |= right.is_none();
                    Made::Place(sheet, name, right.unwrap_or(at))
                }
                Made::Line(name, line) if is_wrong => {
                    let targets = self.targets.get(&name).into_iter().flatten();
                    let target = targets.filter_map(|target| table.given.place(line.sheet, target)).next();
                    let along = target.and_then(|target| unit(target - line.at)).unwrap_or(line.along);
                    Made::Line(name, DrawnLine { along, ..line })
                }
                Made::Numbers(all) => {
                    let right = all.into_iter().map(|(name, number)| {
                        let right = table.given.number(&name).or_else(|| written_together(table.given, entry, &name));
                        is_own |= right.is_none();
                        (name, right.unwrap_or(number))
                    });
                    Made::Numbers(right.collect())
                }
                line => line,
            };
            table.put(right);
        }
        if is_own {
            let things = things(made);
            self.made.extend(things.iter().map(|thing| (thing.clone(), index)));
            if !is_sure {
                self.unsure.extend(things.iter().map(|thing| (thing.clone(), index)));
            }
            if has_numbers(entry) || reads(entry, &self.own).iter().any(|read| self.numbered.contains(read)) {
                self.numbered.extend(things.iter().cloned());
            }
            if is_typed {
                self.typed.extend(things);
            }
        } else if matches!(made, Made::Line(..)) && is_typed {
            self.typed.extend(things(made));
        }
    }

    fn is_sure(&self, entry: &Entry, made: &Made) -> bool {
        match made {
            Made::Place(sheet, ..) => self.is_known_vector(entry, *sheet),
            Made::Numbers(_) => self.is_known_number(entry),
            Made::Line(..) => true,
        }
    }
}

/// The product of two vectors as complex numbers.
fn times(a: Vector, b: Vector) -> Vector {
    Vector::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// Their quotient; `None` where the divisor is nothing.
fn over(a: Vector, b: Vector) -> Option<Vector> {
    let size = b.norm_squared();
    (size > 0.0).then(|| times(a, Vector::new(b.x, -b.y)) / size)
}

/// Whether a quantity is a rate of rotation.
pub(super) fn turns(name: &str) -> bool {
    use crate::scene::{Head, QuantityName};
    QuantityName::parse(name).is_some_and(|name| matches!(name.head, Head::Omega | Head::Alpha))
}

/// Whether an entry has numbers or angles in it that somebody typed: in other scenes they would be others.
fn is_typed(entry: &Entry) -> bool {
    let is_angle = |along: &Direction| matches!(along, Direction::Angle { .. });
    match entry {
        Entry::LayOff(LayOff { size, along, .. }) => size.has_constants() || is_angle(along),
        Entry::Line(Line { along, .. }) => along.as_ref().is_some_and(is_angle),
        Entry::Compute(Compute { by, .. }) => by.as_ref().is_none_or(Formula::has_constants),
        Entry::Solve(Solve { equations, .. }) => {
            let mut sides = equations.iter().filter_map(|text| Formula::sides(text).ok()).flatten();
            sides.any(|side| side.has_constants())
        }
        _ => false,
    }
}

/// Whether there are any numbers in an entry, but for exponents.
fn has_numbers(entry: &Entry) -> bool {
    match entry {
        Entry::LayOff(LayOff { size, .. }) => size.has_numbers(),
        Entry::Compute(Compute { by, .. }) => by.as_ref().is_some_and(Formula::has_numbers),
        Entry::Solve(Solve { equations, .. }) => {
            let mut sides = equations.iter().filter_map(|text| Formula::sides(text).ok()).flatten();
            sides.any(|side| side.has_numbers())
        }
        _ => false,
    }
}

/// The value of a measured segment whose name is that of its ends written together.
fn written_together(given: &Given, entry: &Entry, name: &str) -> Option<f64> {
    let Entry::Measure(Measure { on, from, to, .. }) = entry else { return None };
    if *name != format!("{from}{to}") {
        return None;
    }
    let has = |sheet: &Sheet| given.place(*sheet, from).is_some() && given.place(*sheet, to).is_some();
    let sheet = on.or_else(|| Sheet::ALL.into_iter().find(has))?;
    Some((given.place(sheet, to)? - given.place(sheet, from)?).norm())
}

/// The things that are made.
pub(super) fn things(made: &Made) -> Vec<Thing> {
    match made {
        Made::Place(sheet, name, _) => vec![(Some(*sheet), usual(*sheet, name).to_owned())],
        Made::Line(name, _) => vec![(None, name.clone())],
        Made::Numbers(all) => all.iter().map(|(name, _)| (None, name.clone())).collect(),
    }
}

/// All things that entries read, as often as they do.
fn used(drawing: &HandDrawing, empty: &Table<'_>) -> Result<Vec<Thing>, BoardError> {
    let (mut table, mut used) = (empty.clone(), Vec::new());
    for (entry, act) in standing(drawing) {
        let made = table.carry_out_by_hand(act).map_err(|message| BoardError { entry, message })?;
        used.extend(reads(act, &table));
        table.put(made);
    }
    Ok(used)
}
