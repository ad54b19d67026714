//! The corners of force polygons by their names.

use super::statics::Statics;
use super::{ForceOf, ForcePart, ForcePlan, Side, SideKind};
use crate::construction::operation::PlaceId;
use crate::geometry::Vector;
use crate::mechanism::Mechanism;
use crate::sheet::Sheet;
use indexmap::IndexMap;
use std::collections::BTreeMap;

/// A corner of a force polygon.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// The index of its polygon.
    pub polygon: usize,
    /// Where it is on the sheet, in the scene's unit of force. Polygons are put side by side, so only what lies between two corners of
    /// one polygon has a meaning.
    pub at: Vector,
    pub(crate) place: PlaceId,
}

/// The name of a corner: the letters are those of the alphabet without o, which begins polygons; after the last one they are doubled.
fn corner_name(index: usize, polygon: usize) -> String {
    const LETTERS: &[u8] = b"abcdefghijklmnpqrstuvwxyz";
    let letter = char::from(LETTERS[index % LETTERS.len()]);
    let letters: String = std::iter::repeat_n(letter, index / LETTERS.len() + 1).collect();
    format!("{letters}{}", polygon + 1)
}

/// The name of the corner in which a polygon begins.
fn beginning(polygon: usize) -> String {
    format!("o{}", polygon + 1)
}

impl Statics<'_, '_> {
    /// Names the corners of all polygons: a polygon begins in `o1`, `o2`, …; the ends of its sides, as they are drawn one after another, are
    /// `a1`, `b1`, ….
    pub fn name_corners(&mut self) {
        let mut corners = IndexMap::new();
        for (index, polygon) in self.plan.polygons.iter().enumerate() {
            let Some(first) = polygon.sides.iter().find(|side| side.kind != SideKind::Diagonal) else { continue };
            let start = self.writer.construction.place(Sheet::Forces, &beginning(index)).unwrap_or(first.ends[0]);
            let mut places = vec![start];
            for place in polygon.sides.iter().flat_map(|side| side.ends) {
                if !places.contains(&place) {
                    places.push(place);
                }
            }
            for (number, place) in places.into_iter().enumerate() {
                let name = number.checked_sub(1).map_or_else(|| beginning(index), |number| corner_name(number, index));
                self.writer.name_place(Sheet::Forces, &name, place);
                corners.insert(name, Corner { polygon: index, at: self.exact(place), place });
            }
        }
        self.plan.corners = corners;
    }
}

impl ForcePlan {
    /// The corners of all polygons by their names, in the order in which they are drawn.
    pub fn named_corners(&self) -> impl Iterator<Item = (&str, &Corner)> {
        self.corners.iter().map(|(name, corner)| (name.as_str(), corner))
    }

    /// The corner of that name.
    #[must_use]
    pub fn corner(&self, name: &str) -> Option<&Corner> {
        self.corners.get(name)
    }

    /// Whether polygons and equations agree as far as both are sure.
    #[must_use]
    pub fn agrees(&self) -> bool {
        self.agreement.is_none_or(|agreement| agreement.difference <= agreement.allowed)
    }

    /// The forces from one corner to another of the same polygon: each with its sense on this way, against its side where that is
    /// false. `None` where no forces with names of their own lead there.
    pub(crate) fn way(
        &self,
        from: &Corner,
        to: &Corner,
        is_known: impl Fn(&Side) -> bool,
    ) -> Option<Vec<(Side, bool)>> {
        let sides = &self.polygons.get(from.polygon).filter(|_| from.polygon == to.polygon)?.sides;
        // By place: the side that leads there, and the place before it.
        let mut before: BTreeMap<usize, Option<(PlaceId, Side, bool)>> = BTreeMap::from([(from.place.0, None)]);
        let mut open = vec![from.place];
        while let Some(place) = open.pop() {
            for side in sides.iter().filter(|side| is_known(side)) {
                for (ends, is_along) in [(side.ends, true), ([side.ends[1], side.ends[0]], false)] {
                    if ends[0] == place && !before.contains_key(&ends[1].0) {
                        before.insert(ends[1].0, Some((place, *side, is_along)));
                        open.push(ends[1]);
                    }
                }
            }
        }
        let (mut way, mut at) = (Vec::new(), to.place);
        while let Some((place, side, is_along)) = before.get(&at.0)? {
            way.push((*side, *is_along));
            at = *place;
        }
        Some(way)
    }
}

impl ForceOf {
    /// The name of the quantity that a part of a joint's force is.
    pub(crate) fn part_name(self, mechanism: &Mechanism) -> Option<String> {
        let is_part = matches!(self, ForceOf::Joint { part, .. } if part != ForcePart::Whole);
        is_part.then(|| super::named::part_name(mechanism, self)).flatten()
    }
}
