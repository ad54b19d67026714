//! A drawing on the judge's bench: entry by entry the verdict, with the right things beside the hand's own.

use super::cause::Causes;
use super::file::{Compute, Cross, Direction, Entry, HandDrawing, LayOff, Line, Measure, Solve};
use super::formula::Formula;
use super::given::{Given, usual};
use super::judge::{BoardError, Judge, JudgedDrawing, Verdict, Wrong, standing};
use super::reads::reads;
use super::says;
use super::table::{DrawnLine, Made, Table};
use crate::geometry::unit;
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
    /// Points and numbers of the hand's own that are not known to be right, with the entries that made them: those of one's own that they
    /// hang on are among them.
    unsure: BTreeMap<Thing, usize>,
    /// Things of the hand's own in which there are numbers or angles that somebody typed.
    typed: BTreeSet<Thing>,
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
            unsure: BTreeMap::new(),
            typed: BTreeSet::new(),
            tainted: BTreeSet::new(),
            done: Vec::new(),
            causes: Causes::new(judge),
        }
    }

    pub fn judged(mut self, drawing: &'j HandDrawing) -> Result<JudgedDrawing, BoardError> {
        let mut verdicts = vec![Verdict::Undone; drawing.did.len()];
        let used = used(drawing, &self.own)?;
        for (index, entry) in standing(drawing) {
            let made = self.own.carry_out_by_hand(entry).map_err(|message| BoardError { entry: index, message })?;
            let reads = reads(entry, &self.own);
            let is_typed = is_typed(entry) || reads.iter().any(|read| self.typed.contains(read));
            let found = self.found(entry, &made, is_typed);
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

    /// The verdict on a wrong entry: it is wrong itself, or follows from something of the hand's own that nothing else has judged.
    fn blamed(&self, entry: &Entry, made: &Made, is_typed: bool, what: Message, verdicts: &mut [Verdict]) -> Verdict {
        let mistake = self.cause(entry, made, is_typed);
        if mistake.is_none()
            && let Some(earlier) = self.culprit(entry, made)
        {
            let name = things(made).into_iter().next().map_or_else(String::new, |(_, name)| name);
            verdicts[earlier] = Verdict::Wrong(Wrong { what: says::leads_wrong(name), mistake: None });
            return Verdict::Follows;
        }
        Verdict::Wrong(Wrong { what, mistake })
    }

    /// The mistake of the catalogue that does the same; of a free line whatever it may have meant.
    fn cause(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<crate::check::Told> {
        let of = |entry: &Entry| self.causes.of(entry, made, &self.right, is_typed).map(|cause| cause.told);
        match entry {
            Entry::Line(line) => self.meant(line).iter().find_map(of),
            _ => of(entry),
        }
    }

    /// Of the hand's own things on which a wrong entry hangs, the first with which it would be right, were that something that has a
    /// name: a vector of the plan, a known number. Where there is only one, it is that one.
    fn culprit(&self, entry: &Entry, made: &Made) -> Option<usize> {
        let hangs_on = self.chain(entry);
        let suspects: Vec<usize> = hangs_on.iter().copied().filter(|index| self.is_unsure(*index)).collect();
        let would_be_right = |suspect: &usize| {
            let table = &self.right[0];
            let replaced = self.done.iter().find(|(index, _)| index == suspect)?.1;
            let instead = self.causes.instead_of(replaced, table);
            let is_right = |instead: &Made| {
                let mut other = table.clone();
                other.put(instead.clone());
                for index in hangs_on.iter().filter(|index| *index > suspect) {
                    let (_, entry) = self.done.iter().find(|(other, _)| other == index)?;
                    let again = other.carried_out_again(entry).ok()?;
                    other.put(again);
                }
                let again = other.carried_out_again(entry).ok()?;
                self.is_meant(&again, made).then_some(())
            };
            instead.iter().find_map(is_right)
        };
        suspects.iter().copied().find(|suspect| would_be_right(suspect).is_some()).or_else(|| {
            let is_number = !matches!(entry, Entry::Line(_) | Entry::Join(_)) && self.has_right_direction(entry, made);
            suspects.first().copied().filter(|_| is_number)
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
            let Some(&index) = self.unsure.get(&thing) else { continue };
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
        let turned = self.is_turned(entry);
        let meant = self.right_meaning(entry);
        let entry = meant.as_ref().unwrap_or(entry);
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
                        let right = right.map(|right| if turned { -right } else { right });
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
            if !is_sure {
                self.unsure.extend(things.iter().map(|thing| (thing.clone(), index)));
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

    /// Whether a rate of a link is right but for its sign, which the entry does not state: then its size is meant.
    fn is_turned(&self, entry: &Entry) -> bool {
        let Entry::Compute(Compute { compute, sense: None, by, value }) = entry else { return false };
        let Some(right) = self.judge.given().number(compute).filter(|_| turns(compute)) else { return false };
        let found = match by {
            Some(_) => match self.right[0].carry_out(entry) {
                Ok(Made::Numbers(all)) => all.first().map_or(0.0, |(_, number)| *number),
                _ => 0.0,
            },
            None => value.unwrap_or(0.0),
        };
        found > 0.0 && right < 0.0
    }
}

/// Whether a quantity is a rate of rotation, of which a size may stand without a sense.
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

/// All things that entries read.
fn used(drawing: &HandDrawing, empty: &Table<'_>) -> Result<BTreeSet<Thing>, BoardError> {
    let (mut table, mut used) = (empty.clone(), BTreeSet::new());
    for (entry, act) in standing(drawing) {
        let made = table.carry_out_by_hand(act).map_err(|message| BoardError { entry, message })?;
        used.extend(reads(act, &table));
        table.put(made);
    }
    Ok(used)
}
