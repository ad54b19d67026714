//! Slotted levers that turn when the pin in their slot or their pivot is pulled: nothing else hangs on them.

use super::{Change, Pins};
use crate::editing::measure::Decimals;
use crate::editing::present::Solved;
use crate::geometry::{Turn, degrees_of, unit};
use crate::mechanism::{BodyId, PointId, Role, SliderId};
use crate::position::Pose;
use crate::scene::{Along, GivenBy, On, Slider};

/// A link with a slot through one of its points, whose other points are joints of nothing else.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever {
    pub slider: SliderId,
    pub link: BodyId,
    pivot: PointId,
    /// What slides in its slot.
    pin: PointId,
}

impl Lever {
    /// The lever of a slider, if `pulled` is its pivot or the pin in its slot, and it can turn as these ask.
    pub fn of(solved: &Solved, pulled: PointId, id: SliderId, slider: &Slider, pins: &Pins) -> Option<Lever> {
        let mechanism = &solved.mechanism;
        let given = mechanism.slider(id);
        let On::Link(name) = &slider.on else { return None };
        let link = solved.scene.links.get(name)?;
        let touches = |body: BodyId| mechanism.sliders.iter().filter(|s| s.on == body || s.link == body).count();
        let is_free = solved.scene.given_by == GivenBy::Lengths
            && slider.drive.is_none()
            && link.angle_deg.is_none()
            && mechanism.body(given.on).role == Role::Member
            && touches(given.on) == 1
            && mechanism.body(given.link).points.len() == 1;
        let through = slider.counted_from(link.points.first());
        // Either point that gives the direction is on the slot, if one of them is.
        let ends = match &slider.along {
            Along::Points(a, b) if through == Some(a) || through == Some(b) => [Some(a), Some(b)],
            _ => [None; 2],
        };
        let on_slot = through.into_iter().chain(ends.into_iter().flatten());
        let pivots = on_slot.filter_map(|point| mechanism.point(point)).filter(|_| is_free);
        let holders = mechanism.holders();
        let turns_freely = |pivot: &PointId| {
            let others = mechanism.body(given.on).points.iter().filter(|point| *point != pivot);
            let is_idle = |point: &PointId| {
                let is_pinned = pins.points.iter().any(|pinned| pinned == mechanism.point_name(*point));
                holders[point.0].len() == 1 && *point != pulled && !is_pinned
            };
            (pulled == *pivot || pulled == given.at) && others.into_iter().all(is_idle)
        };
        let pivot = pivots.into_iter().find(turns_freely)?;
        Some(Lever { slider: id, link: given.on, pivot, pin: given.at })
    }

    /// Turns the lever in a position in which pivot and pin are where they are wanted.
    pub fn turn(self, solved: &Solved, wanted: &mut Pose) {
        let before = &solved.pose;
        let ends = [before.arm(self.pivot, self.pin), wanted.arm(self.pivot, self.pin)].map(unit);
        let [Some(old), Some(new)] = ends else { return };
        let turn = Turn::from_cos_sin_unchecked(old.dot(&new), old.perp(&new));
        let pivot = wanted.point(self.pivot);
        for point in solved.mechanism.body(self.link).points.iter().filter(|point| **point != self.pivot) {
            wanted.points[point.0] = pivot + turn * before.arm(self.pivot, *point);
        }
        wanted.guides[self.slider.0] = turn * before.guides[self.slider.0];
        for body in [self.link, solved.mechanism.slider(self.slider).link] {
            wanted.axes[body.0] = before.axes[body.0].map(|axis| turn * axis);
        }
    }
}

impl Change<'_> {
    /// Rough places and angles of levers that turn.
    pub fn add_levers(&mut self) {
        let solved = self.solved;
        for lever in self.levers {
            let body = solved.mechanism.body(lever.link);
            let pulled = self.point;
            for point in body.points.iter().filter(|point| **point != pulled) {
                let name = solved.mechanism.point_name(*point);
                if self.json["near"].get(name).is_some() {
                    self.put(&["near", name], self.decimals.place_json(self.pose.point(*point)));
                }
            }
            let rough = format!("angle({})", body.name);
            if let Some(axis) = self.pose.axes[lever.link.0].filter(|_| self.json["near"].get(&rough).is_some()) {
                self.put(&["near", &rough], Decimals::ANGLE.json(degrees_of(axis)));
            }
        }
    }
}
