//! Directions of forces and the crossings that close their polygons.

use super::alone::SAME;
use super::bench::{Bench, Found};
use super::entry::{Cross, Entry, Line, Measure};
use super::force_plan::{Corner, ForceLine, OnPlan};
use super::polygons::{Forces, GivenPolygon};
use super::says;
use super::table::{Made, Table};
use crate::check::{Blank, Told, tell};
use crate::construction::{ForceOf, ForcePart};
use crate::geometry::{cross, unit};
use crate::quantity::QuantityRequest;

/// A force below this part of the largest of its polygon is none.
const NOTHING: f64 = 1e-9;

impl Bench<'_> {
    pub(super) fn force_direction(&self, line: &Line, name: &str, is_typed: bool) -> Option<OnPlan> {
        let meant = self.meant(line);
        let begins = |one: &Entry| match one {
            Entry::Line(Line { through: Some(through), .. }) => self.corners.get(through).copied(),
            _ => None,
        };
        let known = meant.iter().filter_map(|one| Some((one, begins(one)?)));
        let mut known: Vec<(&Entry, Corner, Forces)> =
            known.map(|(one, corner)| (one, corner, self.parallel(one, corner, is_typed))).collect();
        // A direction that is missing is meant rather than one that is there.
        known.sort_by_key(|(_, corner, along)| (*along == 0, self.closing(*corner, *along) == 0));
        let (one, through, along) = known.into_iter().next()?;
        let own = ForceLine { through, along };
        if !self.targets.contains_key(name) {
            return Some(OnPlan { found: Found::Own, mistake: None, corner: None, line: Some(own), reversed: None });
        }
        if along == 0 {
            let mistake = self.wrong_direction(one, through, is_typed);
            let found = Found::Wrong(says::no_direction_of_force(name));
            return Some(OnPlan { found, mistake, corner: None, line: Some(own), reversed: None });
        }
        let found = self.line_off_hand(one, line).map_or(Found::Right, Found::Wrong);
        Some(OnPlan { found, mistake: None, corner: None, line: Some(own), reversed: None })
    }

    /// Of forces those that close a polygon.
    fn closing(&self, corner: Corner, forces: Forces) -> Forces {
        self.polygon(corner.polygon).map_or(0, |polygon| forces & polygon.closing())
    }

    /// The sine and the cosine of the angle between a line and a force, in a scene.
    fn angle(&self, table: &Table<'_>, line: &Entry, (polygon, force): (usize, usize)) -> Option<[f64; 2]> {
        let polygon = self.polygon_in(table, polygon)?;
        let own = polygon.forces.get(force)?;
        let is_nothing = own.vector.norm() <= NOTHING * polygon.size();
        // What is nothing has the direction of its guide; that of a pin has any.
        let own = if is_nothing { own.along } else { unit(own.vector) };
        let Some(own) = own else { return is_nothing.then_some([0.0, 1.0]) };
        match table.carry_out(line).ok()? {
            Made::Line(_, line) => Some([cross(line.along, own).abs(), line.along.dot(&own).abs()]),
            _ => None,
        }
    }

    /// How far a sine may be from nothing.
    fn sine(&self, is_typed: bool) -> f64 {
        if is_typed { libm::sin((6.0 * self.judge.tolerance().degrees).to_radians()) } else { SAME }
    }

    /// The forces of a polygon that a line is parallel to in all scenes.
    fn parallel(&self, line: &Entry, through: Corner, is_typed: bool) -> Forces {
        let Some(polygon) = self.polygon(through.polygon) else { return 0 };
        let is_along = |index: usize| {
            let small = self.sine(is_typed);
            self.scenes(is_typed)
                .all(|table| self.angle(table, line, (through.polygon, index)).is_none_or(|[sine, _]| sine <= small))
                && self.angle(&self.right[0], line, (through.polygon, index)).is_some()
        };
        let may_be_drawn = |index: &usize| polygon.forces[*index].may_be_found;
        (0..polygon.forces.len())
            .filter(may_be_drawn)
            .filter(|index| is_along(*index))
            .fold(0, |all, index| all | 1 << index)
    }

    /// A direction across the one that it should be.
    fn wrong_direction(&self, line: &Entry, through: Corner, is_typed: bool) -> Option<Told> {
        let polygon = self.polygon(through.polygon)?;
        let given = self.judge.given();
        let across = polygon.forces.iter().enumerate().find(|(index, force)| {
            let angle = self.angle(&self.right[0], line, (through.polygon, *index));
            force.may_be_found && angle.is_some_and(|[_, cosine]| cosine <= self.sine(is_typed))
        });
        let (_, force) = across?;
        let ForceOf::Joint { joint, part, .. } = force.of else { return None };
        let symbol = self.force_symbol(force.of);
        match given.mechanism().joint(joint).slider {
            Some(slider) if part != ForcePart::AlongGuide => {
                let guide = given.mechanism().slider_in_words(slider, &given.solution.wording());
                Some(tell::guide_reaction_along_rod(symbol, Blank::Guide(guide)))
            }
            None if matches!(part, ForcePart::Normal | ForcePart::Whole) => Some(tell::normal_across(symbol)),
            _ => None,
        }
    }

    pub(super) fn force_crossing(&self, Cross { of, cross: name, .. }: &Cross) -> Option<OnPlan> {
        let [one, two] = [self.force_lines.get(&of[0])?, self.force_lines.get(&of[1])?];
        if one.through.polygon != two.through.polygon {
            return None;
        }
        let polygon = self.polygon(one.through.polygon)?;
        let all = polygon.all();
        let each = |own: &ForceLine| {
            // Of a wrong line any of the forces that are to be found may be meant.
            if own.along == 0 { polygon.closing() } else { own.along }
        };
        let is_wrong = of.iter().any(|line| self.wrong_lines.contains(line));
        // Of the ways to close the polygon the one that lacks least.
        let mut best: Option<(u32, Forces, Corner)> = None;
        for [from, to] in [[one, two], [two, one]] {
            let end = if to.through.forces == 0 { all } else { to.through.forces };
            for first in bits(each(from)).filter(|first| from.through.forces & first == 0) {
                let corner = Corner { forces: from.through.forces | first, ..from.through };
                for last in bits(each(to)).filter(|last| corner.forces & last == 0 && end & last != 0) {
                    let there = corner.forces | last;
                    if there & !end != 0 {
                        continue;
                    }
                    let missing = end & !there;
                    // Put right it ends where the last force begins.
                    let right = Corner { forces: end & !last, is_back: false, ..corner };
                    if best.is_none_or(|(count, ..)| missing.count_ones() < count) {
                        best = Some((missing.count_ones(), missing, right));
                    }
                }
            }
        }
        Some(match best {
            Some((0, _, corner)) => OnPlan::right(corner),
            Some((_, _, corner)) if is_wrong => OnPlan::right(corner),
            None if is_wrong => OnPlan { found: Found::Right, mistake: None, corner: None, line: None, reversed: None },
            Some((_, missing, corner)) => {
                let mistake = self.missing(polygon, missing);
                let found = Found::Wrong(says::polygon_not_closed(name));
                OnPlan { found, mistake, corner: Some(corner), line: None, reversed: None }
            }
            None => {
                let found = Found::Wrong(says::polygon_not_closed(name));
                OnPlan { found, mistake: None, corner: None, line: None, reversed: None }
            }
        })
    }

    /// One force that a polygon lacks.
    fn missing(&self, polygon: &GivenPolygon, missing: Forces) -> Option<Told> {
        (missing.count_ones() == 1)
            .then(|| self.first_symbol(polygon, missing).map(tell::force_missing_in_polygon))
            .flatten()
    }

    /// A force that the polygon lacks whose last side is measured.
    pub(super) fn missing_where_measured(&self, Measure { measure, from, to, .. }: &Measure) -> Option<Told> {
        let [from, to] = [from, to].map(|end| self.corners.get(end).copied());
        let (from, to) = (from?, to?);
        let polygon = self.polygon(from.polygon).filter(|_| from.polygon == to.polygon)?;
        let given = self.judge.given();
        let asked = QuantityRequest::new(measure, given.mechanism()).ok()?;
        let named = polygon.named(&asked, given.mechanism(), self.loads());
        let between = |from: Corner, to: Corner| {
            let end = if to.forces & from.forces == from.forces && to.forces != 0 { to.forces } else { polygon.all() };
            end & !from.forces
        };
        let ways = [between(from, to), between(to, from)];
        let way = ways.into_iter().find(|way| named != 0 && way & named == named)?;
        self.missing(polygon, way & !named)
    }
}

/// The single forces among some.
fn bits(forces: Forces) -> impl Iterator<Item = Forces> {
    (0..Forces::BITS).map(|index| 1 << index).filter(move |bit| forces & bit != 0)
}
