//! Guides that go on through the joints that slide on them.

use super::Change;
use super::held::{can_be_placed, is_through};
use crate::editing::drive::{near_to, position_of};
use crate::editing::measure::{Decimals, json};
use crate::geometry::{Placement, degrees_of};
use crate::mechanism::GROUND;
use crate::scene::{Along, At, On, Slider};

impl Change<'_> {
    /// The places of guides that the joint slides on or that go through it, and positions on them that are given.
    pub fn add_guides(&mut self) {
        let solved = self.solved;
        let name = solved.mechanism.point_name(self.point);
        for (index, slider) in solved.scene.sliders.iter().enumerate() {
            let slides = [&slider.at, &slider.pin].into_iter().flatten().any(|at| at == name);
            let is_through = is_through(solved, slider, name);
            let turns = self.levers.iter().any(|lever| lever.slider.0 == index);
            if (slides || is_through) && !turns {
                self.add_guide(index, slider, slides, is_through);
            }
        }
    }

    fn add_guide(&mut self, index: usize, slider: &Slider, slides: bool, is_through: bool) {
        let Some(placement) = self.carrier(index) else { return };
        let given = &self.solved.mechanism.sliders[index];
        let (local, direction) = given.line();
        let along = placement * direction;
        let names_end = matches!(&slider.along, Along::Points(..));
        let mut through = placement * local;
        let at = self.pose.point(given.at);
        let number = index.to_string();
        if slides && (slider.on == On::Ground || matches!(slider.through, Some(At::Place(_)))) {
            let off = (at - through) - along * along.dot(&(at - through));
            if off.norm() > 0.5 * self.decimals.step() {
                let moved = self.decimals.place(placement.inverse() * (through + off));
                through = placement * moved;
                self.put(&["sliders", &number, "through"], self.decimals.place_json(moved));
            }
        } else if is_through && !names_end && can_be_placed(self.solved, slider) {
            // The guide stays where it is.
            let place = [local.x, local.y].map(json);
            self.put(&["sliders", &number, "through"], place.to_vec().into());
        } else if is_through {
            through = self.pose.point(self.point);
        }
        if let Some(path) = position_of(self.json, index).filter(|_| given.drive.is_some()) {
            self.values.push((path, self.decimals.json(along.dot(&(at - through)))));
        }
    }

    /// Where the carrier of a guide is in the present position.
    fn carrier(&self, slider: usize) -> Option<Placement> {
        match self.solved.mechanism.sliders.get(slider)?.on {
            GROUND => Some(Placement::identity()),
            link => self.solved.placement(link),
        }
    }

    /// Turns what counts from the axis of a link, which is now at `axis` degrees: guides on it keep their directions, and so does the
    /// link on its guide.
    pub fn turn_guides(&mut self, link: &str, axis: f64) {
        let solved = self.solved;
        for (index, slider) in solved.scene.sliders.iter().enumerate() {
            let number = index.to_string();
            let guide = degrees_of(solved.pose.guides[index]);
            if slider.on == On::Link(link.to_owned()) && !matches!(slider.along, Along::Points(..)) {
                let old = self.json["sliders"][index]["along"].as_f64().unwrap_or(0.0);
                self.put(&["sliders", &number, "along"], Decimals::ANGLE.json(near_to(guide - axis, old)));
            }
            if slider.link.as_deref() == Some(link) {
                let turned = near_to(axis - guide, slider.turned_deg);
                let is_new = (turned - slider.turned_deg).abs() > 0.5 * Decimals::ANGLE.step();
                if is_new {
                    self.put(&["sliders", &number, "turned"], Decimals::ANGLE.json(turned));
                }
            }
        }
    }
}
