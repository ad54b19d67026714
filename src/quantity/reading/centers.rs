//! How a hand reads instant centres, and rates and velocities by them.

use super::{Reader, Sense, Unread};
use crate::construction::{Along, CenterId, MeasuredAs, NumberId, NumberKind, PlaceId, Rate, Spot as DrawnAt};
use crate::mechanism::PointId;
use crate::quantity::name::{Pole, PoleOf, QuantityRequest};
use crate::scene::{Component, Head};
use crate::sheet::{Order, Sheet};

impl Reader<'_> {
    /// A coordinate of an instant centre, measured from the origin of the scene; of one at infinity its direction.
    pub(super) fn center(&mut self, asked: &QuantityRequest, pole: &Pole) -> Result<(NumberId, Sense), Unread> {
        let how = match asked.written.component {
            Some(Component::X) => MeasuredAs::X,
            Some(Component::Y) => MeasuredAs::Y,
            Some(Component::Angle) => return self.direction_of_center(asked.name(), pole),
            _ => return Err(Unread::NotDrawn),
        };
        let place = self.place_of_center(pole)?;
        let origin = -self.writer.construction.origin.coords;
        // Without a name: nobody takes it for a point of the figure.
        let zero = self.writer.construction.place(Sheet::Centers, "");
        let zero = zero.unwrap_or_else(|| self.writer.pole(Sheet::Centers, "", origin));
        Ok((self.measure(Sheet::Centers, asked.name(), [zero, place], how), Sense::Signed))
    }

    /// The direction of a centre at infinity: that of the lines towards it.
    fn direction_of_center(&mut self, name: &str, pole: &Pole) -> Result<(NumberId, Sense), Unread> {
        let id = self.drawn_center(pole)?;
        match self.writer.construction.center(id).map(|center| center.spot) {
            Some(DrawnAt::Towards(along)) => Ok((self.read_direction(name, along), Sense::Line)),
            _ => Err(Unread::NotDrawn),
        }
    }

    /// Reads the direction of a line of the sheet of centres, as part of the step that gives the quantity `name`.
    fn read_direction(&mut self, name: &str, along: Along) -> NumberId {
        let number = self.writer.read_direction(Sheet::Centers, NumberKind::Reading(name.to_owned()), along);
        self.put_in_step(Sheet::Centers, name);
        number
    }

    /// An instant centre that is drawn.
    pub(super) fn drawn_center(&self, pole: &Pole) -> Result<CenterId, Unread> {
        let PoleOf::Center(pair, _) = pole.of else { return Err(Unread::NotDrawn) };
        self.writer.construction.centers.as_ref().and_then(|centers| centers.of(pair)).ok_or(Unread::NotDrawn)
    }

    pub(super) fn place_of_center(&self, pole: &Pole) -> Result<PlaceId, Unread> {
        if let PoleOf::Inflection(link) = pole.of {
            let name = format!("{}({})", Head::InflectionPole.word(), self.writer.mechanism.body(link).name);
            return self.writer.construction.place(Sheet::Centers, &name).ok_or(Unread::NotDrawn);
        }
        let id = self.drawn_center(pole)?;
        match self.writer.construction.center(id).map(|center| center.spot) {
            Some(DrawnAt::At(place)) => Ok(place),
            _ => Err(Unread::NotDrawn),
        }
    }

    /// The velocity of a point by centres: its size is computed, its direction measured.
    pub(super) fn by_centers(&mut self, asked: &QuantityRequest, point: PointId) -> Result<(NumberId, Sense), Unread> {
        let construction = &self.writer.construction;
        let velocities = construction.centers.as_ref().map_or(&[][..], |centers| &centers.velocities);
        let found = velocities.iter().find(|velocity| velocity.point == point);
        let end = found.and_then(|velocity| velocity.end).ok_or(Unread::NoSheet(Sheet::Velocity))?;
        let is_own = |kind: &NumberKind| *kind == NumberKind::SpeedByCenters(point);
        match asked.written.component {
            Some(Component::Size) => {
                let number = construction.numbers.iter().position(is_own).map(NumberId);
                Ok((number.ok_or(Unread::NotDrawn)?, Sense::Magnitude))
            }
            Some(Component::Angle) => {
                let at = self.writer.plot_on(Sheet::Centers, point);
                Ok((self.measure(Sheet::Centers, asked.name(), [at, end], MeasuredAs::Direction), Sense::Angle))
            }
            _ => Err(Unread::NotDrawn),
        }
    }

    /// An angular velocity that is found by distances of centres.
    pub(super) fn rate_by_centers(&self, rate: Rate) -> Result<NumberId, Unread> {
        let Rate::Angular(Order::Velocity, link) = rate else { return Err(Unread::NoSheet(rate.order().sheet())) };
        let mut numbers = self.writer.construction.numbers.iter();
        let found = numbers.position(|kind| *kind == NumberKind::RateByCenters(link));
        found.map(NumberId).ok_or(Unread::NoSheet(Sheet::Velocity))
    }
}
