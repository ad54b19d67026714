//! How a hand reads vectors and segments of a plan.

use super::{Reader, Sense, Unread, measured_as};
use crate::construction::{
    Along, MeasuredAs, NumberId, NumberKind, OperationRole, PlaceId, Product, ProductKind, Rate, image_name,
    normal_name,
};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::quantity::name::{AccelerationPart, QuantityRequest, Spot};
use crate::scene::Component;
use crate::sheet::{Order, Sheet};

/// A vector as a segment of a plan, or by its computed size along a line.
pub(super) enum VectorSource {
    Segment([PlaceId; 2]),
    Computed(NumberId, Along),
}

impl Reader<'_> {
    /// One number of a vector: measured from the segment, or computed.
    pub(super) fn component(
        &mut self,
        asked: &QuantityRequest,
        drawn: VectorSource,
    ) -> Result<(NumberId, Sense), Unread> {
        let (Some(component), Some(order)) = (asked.written.component, asked.order()) else {
            return Err(Unread::Vector);
        };
        let ends = match (drawn, component) {
            (VectorSource::Segment(ends), _) => self.drawn(ends)?,
            (VectorSource::Computed(size, _), Component::Size) => return Ok((size, Sense::Magnitude)),
            // Its direction and components are measured after it has been laid off.
            (VectorSource::Computed(size, along), _) => {
                let pole = self.writer.pole_of(order).ok_or(Unread::NotDrawn)?;
                [pole, self.writer.lay_off(order, pole, vec![Product::plain(size)], along)]
            }
        };
        let (how, sense) = measured_as(component);
        Ok((self.measure(order, asked.name(), ends, how), sense))
    }

    /// The vector of a place in a plan, relative to another place if there is one.
    pub(super) fn vector(&mut self, order: Order, a: &Spot, b: Option<&Spot>) -> Result<VectorSource, Unread> {
        let to = self.plan_point(order, a)?;
        let from = match b {
            Some(b) => self.plan_point(order, b)?,
            None => self.writer.pole_of(order).ok_or(Unread::NotDrawn)?,
        };
        Ok(VectorSource::Segment([from, to]))
    }

    pub(super) fn coriolis(&mut self, id: SliderId, on: BodyId) -> Result<VectorSource, Unread> {
        let omega = self.rate_or_given(Rate::Angular(Order::Velocity, on))?;
        let velocity = self.rate_or_given(Rate::Slide(Order::Velocity, id))?;
        let (Some(omega), Some(velocity)) = (omega, velocity) else {
            return Err(Unread::Given);
        };
        let product = Product::new(ProductKind::Coriolis, 2.0, &[omega, velocity]);
        let size = self.writer.compute(Order::Acceleration, NumberKind::Size, vec![product]);
        Ok(VectorSource::Computed(size, Along::line(self.writer.guide(id)).turned(1)))
    }

    /// A part of a relative acceleration: a segment if the construction lays it off, else computed.
    pub(super) fn part(
        &mut self,
        name: &str,
        part: AccelerationPart,
        a: &Spot,
        b: &Spot,
        link: Option<BodyId>,
    ) -> Result<VectorSource, Unread> {
        let order = Order::Acceleration;
        if let Spot::Special(special) = a {
            let construction = &self.writer.construction;
            if let Some([start, end]) = construction.known_parts.get(&normal_name(b.name(), special)) {
                let image = image_name(special);
                let [from, to] = match part {
                    AccelerationPart::Normal => [start, end],
                    AccelerationPart::Tangential => [end, &image],
                };
                let place = |name: &str| construction.place(order, name);
                let ends = place(from).zip(place(to)).ok_or(Unread::NoConstruction)?;
                return Ok(VectorSource::Segment([ends.0, ends.1]));
            }
        }
        let link = link.ok_or(Unread::NotDrawn)?;
        let of_rate = if part == AccelerationPart::Tangential { Order::Acceleration } else { Order::Velocity };
        let rate = self.rate_or_given(Rate::Angular(of_rate, link))?.ok_or(Unread::Given)?;
        let (from, to) = (self.scheme_point(b)?, self.scheme_point(a)?);
        let line = self.writer.join_places(Sheet::Scheme, OperationRole::Line, [from, to]);
        let length = self.measure(Sheet::Scheme, name, [from, to], MeasuredAs::Along(line));
        let (product, turns) = match part {
            AccelerationPart::Normal => (Product::new(ProductKind::Normal, -1.0, &[rate, rate, length]), 0),
            AccelerationPart::Tangential => (Product::new(ProductKind::Turning, 1.0, &[rate, length]), 1),
        };
        let size = self.writer.compute(order, NumberKind::Size, vec![product]);
        Ok(VectorSource::Computed(size, Along::line(line).turned(turns)))
    }

    /// The length of a segment of a plan: the one that the construction measures, else one measured for this reading.
    pub(super) fn segment(&mut self, order: Order, ends: &[String; 2]) -> Result<(NumberId, Sense), Unread> {
        let construction = &self.writer.construction;
        let [from, to] = ends.each_ref().map(|name| construction.plan_name(order, name).to_owned());
        if let Some(number) = self.measured(&NumberKind::Segment(order, [from.clone(), to.clone()])) {
            return Ok((number, Sense::Magnitude));
        }
        let ends = self.ends(order, &from, &to)?;
        Ok((self.measure(order, &order.sheet().segment_name(&from, &to), ends, MeasuredAs::Size), Sense::Distance))
    }

    /// The direction of a segment, as part of the step that gives its length.
    pub(super) fn direction(
        &mut self,
        order: Order,
        ends: &[String; 2],
        name: &str,
    ) -> Result<(NumberId, Sense), Unread> {
        let [from, to] = ends.each_ref().map(|name| self.writer.construction.plan_name(order, name));
        let ends = self.ends(order, from, to)?;
        Ok((self.measure(order, name, ends, MeasuredAs::Direction), Sense::Angle))
    }

    /// The ends of a segment of a plan that a hand can draw.
    fn ends(&self, order: Order, from: &str, to: &str) -> Result<[PlaceId; 2], Unread> {
        let place = |name: &str| self.writer.construction.place(order, name).ok_or(Unread::NoConstruction);
        self.drawn([place(from)?, place(to)?])
    }

    /// The end of a place's vector in a plan: the image that the construction has found, else one laid off.
    fn plan_point(&mut self, order: Order, spot: &Spot) -> Result<PlaceId, Unread> {
        let named = self.writer.construction.place(order, &image_name(spot.name()));
        match (named.filter(|&place| self.writer.is_place_by_hand(place)), spot) {
            (Some(place), _) => Ok(place),
            (None, Spot::Point(body, point, _)) => {
                let holder = self.holder(order, *body, *point);
                Ok(self.writer.motion(order, holder, *point))
            }
            (None, Spot::Special(_)) => Err(Unread::NoConstruction),
            (None, Spot::Pole(_)) => Err(Unread::NotDrawn),
        }
    }

    /// The body with which a point's vector is laid off: one of known motion, else one whose point is found already,
    /// else `body`.
    fn holder(&self, order: Order, body: BodyId, point: PointId) -> BodyId {
        let mechanism = self.writer.mechanism;
        let is_on_body = mechanism.body(body).points.contains(&point);
        let holders = || mechanism.body_ids().filter(|&b| is_on_body && mechanism.body(b).points.contains(&point));
        let known = holders().find(|&b| mechanism.is_known(b));
        known.or_else(|| holders().find(|&b| self.writer.place_of_motion(order, b, point).is_some())).unwrap_or(body)
    }
}
