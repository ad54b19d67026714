//! A drawing on the judge's bench: entry by entry the verdict, with the right things beside the hand's own.

use super::cause::Causes;
use super::direction::Direction;
use super::entry::{Compute, Cross, Entry, LayOff, Line, Measure, Solve};
use super::file::HandDrawing;
use super::force_plan::{Corner, ForceLine, OnPlan};
use super::formula::Formula;
use super::given::Given;
use super::judge::{BoardError, Judge, JudgedDrawing, Verdict, Wrong, standing};
use super::reads::reads;
use super::says;
use super::table::{Made, Table, Thing, things};
use crate::message::Message;
use crate::scene::QuantityName;
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
    pub unsure: BTreeMap<Thing, usize>,
    /// All points and numbers of the hand's own, with the entries that made them.
    pub made: BTreeMap<Thing, usize>,
    /// Things of the hand's own in which there are numbers or angles that somebody typed.
    typed: BTreeSet<Thing>,
    /// Things of the hand's own in which there are any numbers at all.
    numbered: BTreeSet<Thing>,
    /// What is drawn or measured, or was worked out from such things.
    founded: BTreeSet<Thing>,
    /// Quantities that were typed and to which nothing leads that is drawn.
    pub unfounded: Vec<String>,
    /// Lines that are wrong themselves: where they cross says nothing of the crossing.
    pub wrong_lines: BTreeSet<String>,
    /// The corners of force polygons, by their names.
    pub corners: BTreeMap<String, Corner>,
    /// Directions of forces, by the names of their lines.
    pub force_lines: BTreeMap<String, ForceLine>,
    /// Things that hang on something wrong.
    pub tainted: BTreeSet<Thing>,
    /// The entries that have been judged.
    pub done: Vec<(usize, &'j Entry)>,
    pub causes: Causes<'j>,
}

/// What an entry comes to when it is carried out with right inputs.
pub(super) enum Found {
    Right,
    /// What is wrong.
    Wrong(Message),
    /// It has a name of its own, and is neither.
    Own,
}

impl Judge {
    /// The verdicts on a drawing's entries.
    ///
    /// # Errors
    /// The first entry that cannot be carried out.
    pub fn judge(&self, drawing: &HandDrawing) -> Result<JudgedDrawing, BoardError> {
        Bench::new(self, drawing).judged(drawing)
    }
}

impl<'j> Bench<'j> {
    fn new(judge: &'j Judge, drawing: &HandDrawing) -> Bench<'j> {
        let scales = judge.scales(drawing);
        let all = std::iter::once(judge.given()).chain(judge.others());
        let mut targets: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (_, entry) in standing(drawing) {
            if let Entry::Cross(Cross { cross, of, .. }) = entry {
                of.iter().for_each(|line| targets.entry(line.clone()).or_default().push(cross.clone()));
            }
        }
        let starts = judge.given().polygons.iter().enumerate();
        let corners = starts.map(|(polygon, own)| (own.start.clone(), Corner { polygon, forces: 0, is_back: false }));
        Bench {
            judge,
            corners: corners.collect(),
            force_lines: BTreeMap::new(),
            own: Table::new(judge.given(), scales),
            right: all.map(|given| Table::new(given, scales)).collect(),
            targets,
            uses: BTreeMap::new(),
            unsure: BTreeMap::new(),
            made: BTreeMap::new(),
            typed: BTreeSet::new(),
            numbered: BTreeSet::new(),
            founded: BTreeSet::new(),
            unfounded: Vec::new(),
            wrong_lines: BTreeSet::new(),
            tainted: BTreeSet::new(),
            done: Vec::new(),
            causes: Causes::new(judge),
        }
    }

    fn judged(mut self, drawing: &'j HandDrawing) -> Result<JudgedDrawing, BoardError> {
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
            if let Some(plan) = self.on_plan(entry, &made, is_typed, &reads) {
                let things = things(&made);
                let is_unused = matches!(plan.found, Found::Own) && !things.iter().any(|thing| used.contains(thing));
                let mut follows = reads.iter().any(|read| self.tainted.contains(read));
                if let (Some(_), Entry::LayOff(laid)) = (plan.reversed, entry)
                    && let Some((earlier, wrong)) = self.reversed(&laid.from)
                {
                    verdicts[earlier] = Verdict::Wrong(wrong);
                    follows = true;
                }
                verdicts[index] = if is_unused { Verdict::Unused } else { plan.verdict(follows) };
                if let (Verdict::Wrong(_), Made::Line(name, _)) = (&verdicts[index], &made) {
                    self.wrong_lines.insert(name.clone());
                }
                if matches!(verdicts[index], Verdict::Wrong(_) | Verdict::Follows) {
                    self.tainted.extend(things);
                }
                self.founded.extend(self::things(&made));
                self.put_force(entry, &made, plan);
                self.own.put(made);
                self.done.push((index, entry));
                continue;
            }
            let mut found = self.found(entry, &made, is_typed);
            // A factor of 2 may be a rate that somebody typed.
            let may_be = has_numbers(entry) || reads.iter().any(|read| self.numbered.contains(read));
            let is_typed = is_typed || matches!(found, Found::Wrong(_)) && may_be;
            if matches!(found, Found::Wrong(_)) && is_typed {
                found = self.found(entry, &made, true);
            }
            let things = things(&made);
            let is_founded = !is_typed || self.is_founded(entry, &made, &reads);
            if is_founded {
                self.founded.extend(things.iter().cloned());
            } else if let (Found::Right, Made::Numbers(all)) = (&found, &made) {
                self.unfounded.extend(all.iter().map(|(name, _)| name.clone()));
            }
            let follows = reads.iter().any(|read| self.tainted.contains(read));
            verdicts[index] = match found {
                Found::Right if !is_founded => {
                    let names = all_names(&made);
                    Verdict::Wrong(Wrong { what: says::nothing_leads_to(names), mistake: None })
                }
                Found::Own if !things.iter().any(|thing| used.contains(thing)) => Verdict::Unused,
                Found::Right | Found::Own if follows => Verdict::Follows,
                Found::Right | Found::Own => Verdict::Right,
                Found::Wrong(what) => self.blamed(entry, &made, is_typed, what, &mut verdicts),
            };
            if let (Verdict::Wrong(_), Made::Line(name, _)) = (&verdicts[index], &made) {
                self.wrong_lines.insert(name.clone());
            }
            if matches!(verdicts[index], Verdict::Wrong(_) | Verdict::Follows) {
                self.tainted.extend(things.iter().cloned());
            }
            let is_wrong = matches!(verdicts[index], Verdict::Wrong(_));
            self.put_right((index, is_wrong), entry, &made, is_typed);
            self.own.put(made);
            self.done.push((index, entry));
        }
        Ok(JudgedDrawing { verdicts, unfounded: self.unfounded })
    }

    /// What an entry on the sheet of forces comes to: where that is wrong, also with its numbers as somebody may have typed them.
    fn on_plan(&self, entry: &Entry, made: &Made, is_typed: bool, reads: &[Thing]) -> Option<OnPlan> {
        let plan = self.on_force_plan(entry, made, is_typed)?;
        let may_be = has_numbers(entry) || reads.iter().any(|read| self.numbered.contains(read));
        match plan.found {
            Found::Wrong(_) if may_be && !is_typed => self.on_force_plan(entry, made, true),
            _ => Some(plan),
        }
    }

    /// Whether it uses something of the hand's own in which there are typed numbers.
    pub fn reads_typed(&self, entry: &Entry) -> bool {
        reads(entry, &self.own).iter().any(|read| self.typed.contains(read))
    }

    /// Whether an entry with numbers that somebody typed is of the drawing: what is drawn, and numbers that are read from it, or that the
    /// construction works out from what is there.
    fn is_founded(&self, entry: &Entry, made: &Made, reads: &[Thing]) -> bool {
        let Made::Numbers(all) = made else { return true };
        matches!(entry, Entry::Measure(_))
            || reads.iter().any(|read| self.founded.contains(read))
            || all.iter().all(|(name, _)| {
                self.judge.given().number(name).is_some() && self.causes.is_worked_out(&self.own, name, &self.unfounded)
            })
    }

    /// Puts the right things down in all scenes.
    fn put_right(&mut self, (index, is_wrong): (usize, bool), entry: &Entry, made: &Made, is_typed: bool) {
        let meant = self.right_meaning(entry);
        let entry = meant.as_ref().unwrap_or(entry);
        let is_typed = is_typed || self.reads_typed(entry);
        let is_sure = self.is_sure(entry, made);
        // What was measured between other points than its name says is in the end what its name says.
        let named = match (entry, made) {
            (Entry::Measure(_), Made::Numbers(all)) => all.first().and_then(|(name, _)| self.meaning(entry, name)),
            _ => None,
        };
        let mut is_own = false;
        // A typed number is right where it follows from what the hand has.
        let mut recognised = match is_typed_here(entry) {
            true => self.made_with_right_numbers(entry, false).into_iter().next(),
            false => None,
        };
        let in_scene = match &recognised {
            Some(made) => Some(made.clone()),
            None if is_typed => self.right[0].carry_out(entry).ok().filter(|made| matches!(made, Made::Place(..))),
            None => None,
        };
        let is_sure = is_sure || in_scene.is_some_and(|made| self.is_known(entry, &made));
        // Numbers whose sense is against that of their quantity.
        let mut turned: BTreeMap<String, bool> = BTreeMap::new();
        for table in &mut self.right {
            let alone = recognised.take().map_or_else(|| table.carry_out(entry), Ok).unwrap_or_else(|_| made.clone());
            let right = match alone {
                Made::Place(sheet, name, at) => {
                    let right = table.given.place(sheet, &name);
                    is_own |= right.is_none();
                    Made::Place(sheet, name, right.unwrap_or(at))
                }
                Made::Numbers(all) => {
                    let right = all.into_iter().map(|(name, number)| {
                        let asked = named.as_ref().unwrap_or(&name);
                        let right = table.given.number(asked).or_else(|| written_together(table.given, entry, &name));
                        // What is written without a sign keeps the hand's; where it is wrong, that says nothing. In other scenes
                        // numbers that somebody has typed are others, so the sense is that of this one.
                        let keeps_sign = is_size_of_force(asked) && (!is_wrong || matches!(entry, Entry::Measure(_)));
                        let right = right.map(|right| {
                            let is_turned = keeps_sign && *turned.entry(name.clone()).or_insert(right * number < 0.0);
                            if is_turned { -right } else { right }
                        });
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

    /// Whether what a recognised number makes in the scene is something with a name: itself, or a vector of the plan.
    fn is_known(&self, entry: &Entry, made: &Made) -> bool {
        match (entry, made) {
            (Entry::LayOff(LayOff { from, .. }), Made::Place(sheet, _, end)) => {
                let (given, small) = (self.judge.given(), 1e-6 * self.judge.given().size(*sheet));
                let Some(start) = self.right[0].place(*sheet, from) else { return false };
                given.vectors(*sheet).iter().any(|known| (end - start - known).norm() <= small)
            }
            (_, Made::Numbers(_)) => true,
            _ => false,
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

/// The names of what an entry makes.
fn all_names(made: &Made) -> Message {
    Message::list(things(made).into_iter().map(|(_, name)| Message::from(name)), ", ")
}

/// Whether a quantity is a rate of rotation.
pub(super) fn turns(name: &str) -> bool {
    use crate::scene::Head;
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

/// Whether a quantity is a force of which a sheet shows the size alone: its sense is that of its arrow.
pub(super) fn is_size_of_force(name: &str) -> bool {
    use crate::scene::Head;
    QuantityName::parse(name).is_some_and(|name| {
        matches!(
            name.head,
            Head::Reaction
                | Head::ReactionAlong
                | Head::ReactionAcross
                | Head::GuideForce
                | Head::GuideOffset
                | Head::Push
                | Head::InertiaForce
                | Head::Load
        )
    })
}

/// Whether a size or a number was typed in it.
pub(super) fn is_typed_here(entry: &Entry) -> bool {
    match entry {
        Entry::LayOff(LayOff { size, .. }) => size.has_constants(),
        Entry::Compute(Compute { by, .. }) => by.as_ref().is_none_or(Formula::has_constants),
        _ => false,
    }
}

/// Whether there are any numbers in an entry, but for exponents.
pub(super) fn has_numbers(entry: &Entry) -> bool {
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
