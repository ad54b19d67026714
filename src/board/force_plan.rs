//! The force plan: a vector must be one of the forces that its polygon still lacks, a line the direction of one, a crossing must close the
//! polygon. Any order of the forces is right, and a chain may be drawn from its start backwards, too.

use super::alone::SAME;
use super::bench::{Bench, Found};
use super::entry::{Entry, LayOff};
use super::judge::{Verdict, Wrong};
use super::polygons::{Forces, GivenPolygon, MOST_FORCES};
use super::says;
use super::table::{Made, Table, things};
use crate::check::{Blank, Told, tell};
use crate::construction::{ForceOf, LoadShown, Teller, plain_text};
use crate::geometry::Vector;
use crate::quantity::QuantityRequest;
use crate::sheet::Sheet;

/// A corner of a polygon, by the forces between its start and it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub polygon: usize,
    pub forces: Forces,
    /// Whether it was reached from the start against the forces.
    pub is_back: bool,
}

/// A line that is to be the direction of a force.
#[derive(Clone, Debug)]
pub(super) struct ForceLine {
    pub through: Corner,
    /// The forces that have this direction.
    pub along: Forces,
}

/// What an entry on the sheet of forces comes to.
pub(super) struct OnPlan {
    pub found: Found,
    pub mistake: Option<Told>,
    /// Where it ends if it is put right.
    pub corner: Option<Corner>,
    pub line: Option<ForceLine>,
    /// The force that was laid off reversed before it, and where its end is with its sense right.
    pub reversed: Option<(Forces, Corner)>,
}

impl OnPlan {
    pub fn right(corner: Corner) -> OnPlan {
        OnPlan { found: Found::Right, mistake: None, corner: Some(corner), line: None, reversed: None }
    }

    pub fn verdict(&self, follows: bool) -> Verdict {
        match &self.found {
            Found::Wrong(what) => Verdict::Wrong(Wrong { what: what.clone(), mistake: self.mistake.clone() }),
            _ if follows => Verdict::Follows,
            _ => Verdict::Right,
        }
    }
}

/// Forces whose sum is a vector, and how far that is from it.
struct Sum {
    forces: Forces,
    off: f64,
}

/// How much farther, in parts of what is allowed, a single force may be from a vector than a sum of two.
const MORE: f64 = 0.3;

/// Most sums of forces that are tried for a vector.
const MOST_SUMS: usize = 8;

impl<'j> Bench<'j> {
    /// What an entry on the sheet of forces comes to; `None` of any other, and of what begins in no polygon.
    pub(super) fn on_force_plan(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<OnPlan> {
        match (entry, made) {
            (Entry::LayOff(laid), Made::Place(Sheet::Forces, name, _)) => {
                self.force_laid_off(entry, laid, name, made, is_typed)
            }
            (Entry::Line(line), Made::Line(name, drawn)) if drawn.sheet == Sheet::Forces => {
                self.force_direction(line, name, is_typed)
            }
            (Entry::Cross(cross), Made::Place(Sheet::Forces, ..)) => self.force_crossing(cross),
            _ => None,
        }
    }

    pub(super) fn polygon(&self, index: usize) -> Option<&GivenPolygon> {
        self.judge.given().polygons.get(index).filter(|polygon| polygon.forces.len() <= MOST_FORCES)
    }

    /// The same polygon in another scene, if it has the same forces there.
    pub(super) fn polygon_in<'t>(&self, table: &'t Table<'_>, index: usize) -> Option<&'t GivenPolygon> {
        let own = self.polygon(index)?;
        table.given.polygons.get(index).filter(|other| own.is_like(other))
    }

    fn force_laid_off(&self, entry: &Entry, laid: &LayOff, name: &str, made: &Made, is_typed: bool) -> Option<OnPlan> {
        let from = *self.corners.get(&laid.from)?;
        let polygon = self.polygon(from.polygon)?;
        let all = polygon.all();
        let forward = |sum: Forces| Corner { forces: normal(from.forces | sum, all), ..from };
        let back = |sum: Forces| Corner {
            forces: (if from.forces == 0 { all } else { from.forces }) & !sum,
            is_back: true,
            ..from
        };
        let behind = if from.forces == 0 { all } else { from.forces };
        let ahead = || self.as_sum(entry, from, all & !from.forces, 1.0, is_typed).filter(|_| !from.is_back);
        let may_go_back = from.is_back || from.forces == 0;
        let backwards = || self.as_sum(entry, from, behind, -1.0, is_typed).filter(|_| may_go_back);
        let ways = [ahead().map(|sum| (sum, false)), backwards().map(|sum| (sum, true))];
        let nearest = ways.into_iter().flatten().min_by(|one, other| one.0.off.total_cmp(&other.0.off));
        if let Some((Sum { forces, .. }, is_back)) = nearest {
            let corner = if is_back { back(forces) } else { forward(forces) };
            return Some(self.near_by_hand(entry, made, OnPlan::right(corner)));
        }
        // A force that goes on where the first one ran back: that one was reversed.
        if let Some((first, corner)) = self.turned_back(from, polygon)
            && let Some(sum) = self.as_sum(entry, corner, all & !corner.forces, 1.0, is_typed)
        {
            let forces = normal(corner.forces | sum.forces, all);
            let reversed = Some((first, corner));
            return Some(OnPlan { reversed, ..OnPlan::right(Corner { forces, ..corner }) });
        }
        let meant = self.meant_force(laid, from, polygon, entry);
        let twice = self.as_sum(entry, from, from.forces, 1.0, is_typed).filter(|_| !from.is_back);
        let twice = || {
            twice
                .as_ref()
                .and_then(|sum| self.first_symbol(polygon, sum.forces))
                .map(|symbol| (tell::force_twice(symbol), from))
        };
        let other = || {
            let told = self.wrong_vector(entry, made, is_typed)?;
            Some((told, forward(1 << meant?)))
        };
        // A number that somebody has typed is like many.
        let told = if is_typed { other().or_else(twice) } else { twice().or_else(other) };
        let corner =
            told.as_ref().map_or_else(|| meant.map_or(from, |meant| forward(1 << meant)), |(_, corner)| *corner);
        let mistake = told.map(|(told, _)| told);
        let what = says::no_force_of_polygon(name);
        Some(OnPlan { found: Found::Wrong(what), mistake, corner: Some(corner), line: None, reversed: None })
    }

    /// A right vector as the hand drew it, if that is near enough.
    fn near_by_hand(&self, entry: &Entry, made: &Made, right: OnPlan) -> OnPlan {
        let Made::Place(sheet, _, own) = made else { return right };
        match self.place_off_hand(entry, *sheet, *own) {
            Some(off) => OnPlan { found: Found::Wrong(off), ..right },
            None => right,
        }
    }

    /// The forces among some whose sum, times a sign, the vector of an entry is in all scenes.
    fn as_sum(&self, entry: &Entry, from: Corner, among: Forces, sign: f64, is_typed: bool) -> Option<Sum> {
        let Entry::LayOff(LayOff { from: start, .. }) = entry else { return None };
        let vector = |table: &Table<'_>, made: &Made| match made {
            Made::Place(_, _, at) => table.place(Sheet::Forces, start).map(|start| (at - start) * sign),
            _ => None,
        };
        let allowed = |table: &Table<'_>, vector: Vector| {
            let exact = SAME * table.given.polygons.get(from.polygon).map_or(0.0, GivenPolygon::size);
            if is_typed { exact + self.typed_reach(Sheet::Forces, vector.norm()) } else { exact }
        };
        // How far a sum is from the vector, in parts of what is allowed; less is likelier, and so are fewer forces.
        let off = |sum: Forces, table: &Table<'_>, made: &Made| {
            let Some(polygon) = self.polygon_in(table, from.polygon) else { return 0.0 };
            let vector = vector(table, made);
            vector.map_or(f64::INFINITY, |own| (own - polygon.sum(sum)).norm() / allowed(table, own))
        };
        // All that closes a polygon is never laid off: with it, whatever runs against its force would be the sum of all others.
        let closing = self.polygon(from.polygon)?.closing();
        let table = &self.right[0];
        let alone: Vec<Made> = table.carried_out_again(entry).into_iter().collect();
        let recognised = || self.made_with_right_numbers(entry, false);
        let all = if is_typed { [alone.clone(), recognised()].concat() } else { alone };
        for (index, made) in all.iter().enumerate() {
            let laid_off = subsets(among).filter(|sum| sum & closing != closing);
            let near = laid_off.map(|forces| (forces, off(forces, table, made))).filter(|(_, off)| *off <= 1.0);
            let more = |forces: Forces| MORE * f64::from(forces.count_ones() - 1);
            let mut sums: Vec<Sum> = near.map(|(forces, off)| Sum { forces, off: off + more(forces) }).collect();
            sums.sort_by(|one, other| one.off.total_cmp(&other.off));
            sums.truncate(MOST_SUMS);
            let holds = |sum: &Sum| {
                index > 0 || self.in_all(entry, is_typed, |table, made| off(sum.forces, table, made) <= 1.0)
            };
            if let Some(sum) = sums.into_iter().find(holds) {
                return Some(sum);
            }
        }
        None
    }

    /// The force that alone lies, against its sense, between the start and a corner; and where the corner is with its sense right.
    fn turned_back(&self, from: Corner, polygon: &GivenPolygon) -> Option<(Forces, Corner)> {
        let first = polygon.all() & !from.forces;
        (from.is_back && first.count_ones() == 1).then_some((first, Corner { forces: first, is_back: false, ..from }))
    }

    /// What is probably wrong with the vector that ends in a corner, which was reversed.
    pub(super) fn reversed(&self, point: &str) -> Option<(usize, Wrong)> {
        let is_it = |entry: &Entry| matches!(entry, Entry::LayOff(laid) if laid.lay_off == point);
        let (index, entry) = self.done.iter().find(|(_, entry)| is_it(entry))?;
        let made = self.right[0].carried_out_again(entry).ok()?;
        let mistake = self.wrong_vector(entry, &made, false).or_else(|| self.wrong_vector(entry, &made, true));
        Some((*index, Wrong { what: says::no_force_of_polygon(point), mistake }))
    }

    /// The force that a wrong vector is probably meant to be, by its index: the one that its size names, else the nearest that is missing.
    fn meant_force(&self, laid: &LayOff, from: Corner, polygon: &GivenPolygon, entry: &Entry) -> Option<usize> {
        let missing = polygon.all() & !from.forces;
        let named = |name: &str| {
            let asked = QuantityRequest::new(name, self.judge.given().mechanism()).ok()?;
            let own = polygon.named(&asked, self.judge.given().mechanism(), self.loads()) & missing;
            (own.count_ones() == 1).then(|| own.trailing_zeros() as usize)
        };
        let by_name = laid.size.names().into_iter().find_map(named);
        by_name.or_else(|| {
            let table = &self.right[0];
            let Ok(Made::Place(_, _, at)) = table.carried_out_again(entry) else { return None };
            let vector = at - table.place(Sheet::Forces, &laid.from)?;
            let off = |own: Vector| (vector - own).norm().min((vector + own).norm()) / own.norm();
            let mut all: Vec<(usize, f64)> =
                polygon.among(missing).map(|(index, force)| (index, off(force.vector))).collect();
            all.sort_by(|a, b| a.1.total_cmp(&b.1));
            all.first().map(|(index, _)| *index)
        })
    }

    fn wrong_vector(&self, entry: &Entry, made: &Made, is_typed: bool) -> Option<Told> {
        let of = |typed: Option<&Made>| self.causes.of(entry, made, &self.right, typed).map(|cause| cause.told);
        if !is_typed {
            return of(None);
        }
        let alone = self.right[0].carried_out_again(entry).ok();
        let typed = alone.into_iter().chain(self.made_with_right_numbers(entry, true));
        typed.into_iter().find_map(|typed| of(Some(&typed)))
    }

    /// Puts the right things down in all scenes.
    pub(super) fn put_force(&mut self, entry: &Entry, made: &Made, plan: OnPlan) {
        let name = things(made).into_iter().next().map_or_else(String::new, |(_, name)| name);
        let polygons: Vec<Option<Vector>> = self.right.iter().map(|table| self.place_of(table, plan.corner?)).collect();
        // Where a force was laid off reversed, right things go on from its right end.
        if let (Some((_, corner)), Entry::LayOff(LayOff { from, .. })) = (plan.reversed, entry) {
            self.corners.insert(from.clone(), corner);
            let ends: Vec<Option<Vector>> = self.right.iter().map(|table| self.place_of(table, corner)).collect();
            for (table, end) in self.right.iter_mut().zip(ends) {
                end.into_iter().for_each(|end| table.put(Made::Place(Sheet::Forces, from.clone(), end)));
            }
        }
        let meant = self.right_meaning(entry);
        let entry = meant.as_ref().unwrap_or(entry);
        for (table, place) in self.right.iter_mut().zip(polygons) {
            let right = match (place, made) {
                (Some(at), Made::Place(sheet, name, _)) => Made::Place(*sheet, name.clone(), at),
                _ => table.carry_out(entry).unwrap_or_else(|_| made.clone()),
            };
            table.put(right);
        }
        if let Some(corner) = plan.corner {
            self.corners.insert(name.clone(), corner);
        }
        if let Some(line) = plan.line {
            self.force_lines.insert(name, line);
        }
    }

    /// Where a corner is in a scene.
    fn place_of(&self, table: &Table<'_>, corner: Corner) -> Option<Vector> {
        let polygon = self.polygon_in(table, corner.polygon)?;
        Some(table.place(Sheet::Forces, &polygon.start)? + polygon.sum(corner.forces))
    }

    pub(super) fn loads(&self) -> &[LoadShown] {
        self.judge.given().construction().forces.as_deref().map_or(&[], |plan| &plan.loads)
    }

    pub(super) fn first_symbol(&self, polygon: &GivenPolygon, forces: Forces) -> Option<Blank> {
        polygon.among(forces).next().map(|(_, force)| self.force_symbol(force.of))
    }

    pub(super) fn force_symbol(&self, of: ForceOf) -> Blank {
        let solution = &self.judge.given().solution;
        let words = solution.wording();
        Blank::Words(plain_text(&Teller::new(solution, &words).force_symbol(of)))
    }
}

/// All forces are none: they lead back to the start.
fn normal(forces: Forces, all: Forces) -> Forces {
    if forces == all { 0 } else { forces }
}

/// All choices of one or more forces among some.
fn subsets(among: Forces) -> impl Iterator<Item = Forces> {
    let mut next = among;
    std::iter::from_fn(move || {
        let current = next;
        next = current.wrapping_sub(1) & among;
        (current != 0).then_some(current)
    })
}
