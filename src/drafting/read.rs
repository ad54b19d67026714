use super::act::{How, NumberId, PlaceId, Product, Reference, Sheet};
use super::writer::{Drafting, Writer, written};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::plan::{
    Asked, Component, Normality, PlanKind, Solution, Spot, What, image_name, is_acceleration, normal_name,
};

/// How a quantity is read: a number of the drafting, perhaps without its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The number.
    pub number: NumberId,
    /// Whether only its magnitude counts.
    pub is_magnitude: bool,
    /// Whether it is an angle, which comes back after 360°.
    pub is_angle: bool,
    /// Whether it is the distance of two places, of which nobody sees that it should be negative.
    pub is_distance: bool,
    /// The latest sheet that it needs.
    pub sheet: Sheet,
}

/// Why a quantity is not read from a hand drawing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unread {
    /// The scene gives it.
    #[error("the scene gives it")]
    Given,
    /// Some group has no construction, and it depends on that.
    #[error("it depends on a group without a construction (a special point at infinity, or a higher class)")]
    NoConstruction,
    /// Only one of a vector's numbers has a band.
    #[error("a vector: its `.size` and `.angle` have bands")]
    Vector,
    /// The drawing does not show it.
    #[error("the drawing does not show it")]
    NotDrawn,
    /// With such errors the construction does not hold together: lines that should cross may be parallel.
    #[error("errors of this size take the construction apart")]
    Apart,
    /// The figure has no such panel.
    #[error("the figure has no {}, so no scale", .0.name())]
    NoSheet(Sheet),
}

impl Sheet {
    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Sheet::Scheme => "scheme",
            Sheet::Velocity => "velocity plan",
            Sheet::Acceleration => "acceleration plan",
        }
    }
}

/// The construction of `mechanism` as acts, as [`drafting`](crate::drafting::drafting) gives it, and after it the acts by which quantities are
/// read off; with how each is read, or why there is nothing to read.
///
/// A quantity that the construction measures or solves for is read there. A segment or a vector of a plan, a direction and a
/// length are measured once more, with an error of their own.
#[must_use]
pub fn drafting_with(solution: &Solution, asked: &[Asked]) -> (Drafting, Vec<Result<Reading, Unread>>) {
    let mut reader = Reader { writer: written(solution) };
    let readings = asked.iter().map(|asked| reader.reading(asked)).collect();
    (reader.writer.drafting, readings)
}

struct Reader<'a> {
    writer: Writer<'a>,
}

/// Where a vector stands in a plan, or what it is computed from.
enum Drawn {
    Segment([PlaceId; 2]),
    Computed(NumberId, (Reference, u8)),
}

impl Reader<'_> {
    fn reading(&mut self, asked: &Asked) -> Result<Reading, Unread> {
        let what = asked.what();
        let sheet = match what {
            What::Segment { kind, .. } => Sheet::of(*kind),
            What::Angle(_) | What::SlidePosition(_) | What::Coordinate(..) | What::Length(..) => Sheet::Scheme,
            _ if is_acceleration(asked.name()) => Sheet::Acceleration,
            _ => Sheet::Velocity,
        };
        let of = |number| Reading { number, is_magnitude: false, is_angle: false, is_distance: false, sheet };
        let distance = |number| Reading { is_distance: true, ..of(number) };
        let magnitude = |number| Reading { is_magnitude: true, ..of(number) };
        let angle = |number| Reading { is_angle: true, ..of(number) };
        let drawn = match what {
            What::Omega(link) => return Ok(of(self.rate(*link, 0)?)),
            What::Alpha(link) => return Ok(of(self.rate(*link, 1)?)),
            What::SlideVelocity(id) => return Ok(of(self.slide_rate(*id, 0)?)),
            What::SlideAcceleration(id) => return Ok(of(self.slide_rate(*id, 1)?)),
            What::Angle(link) => return Ok(angle(self.axis(*link)?)),
            What::SlidePosition(id) => return Ok(of(self.slide_position(asked.name(), *id)?)),
            What::Coordinate(axis, spot) => {
                let how = [How::X, How::Y][*axis];
                return Ok(of(self.coordinate(asked.name(), how, spot)?));
            }
            What::Length(a, b) => {
                let (number, is_new) = self.length(asked.name(), a, b)?;
                return Ok(if is_new { distance(number) } else { magnitude(number) });
            }
            What::Segment { kind, from, to, .. } => {
                let (number, is_new) = self.segment(*kind, from, to)?;
                return Ok(if is_new { distance(number) } else { magnitude(number) });
            }
            What::Velocity(a, b) | What::Acceleration(a, b) => {
                let to = self.plan_point(sheet, a)?;
                let from = match b {
                    Some(b) => self.plan_point(sheet, b)?,
                    None => self.writer.pole_of(sheet).ok_or(Unread::NotDrawn)?,
                };
                Drawn::Segment([from, to])
            }
            What::Coriolis(id, on) => {
                let omega = self.rate_or_given(*on, 0)?;
                let velocity = self.slide_rate_or_given(*id, 0)?;
                let (Some(omega), Some(velocity)) = (omega, velocity) else {
                    return Err(Unread::Given);
                };
                let sum = vec![Product::new(2.0, &[omega, velocity])];
                let size = self.writer.compute(sheet, asked.name(), sum);
                let guide = self.writer.guide(*id);
                Drawn::Computed(size, (Reference::Line(guide), 1))
            }
            What::Part(part, a, b, link) => self.part(asked.name(), *part, a, b, *link)?,
        };
        let Some(component) = asked.component() else {
            return Err(Unread::Vector);
        };
        // Points at rest and vectors of nothing are not measured.
        if let Drawn::Segment([from, to]) = drawn
            && from == to
        {
            return Err(Unread::Given);
        }
        let ends = match (drawn, component) {
            (Drawn::Computed(size, _), Component::Size) => return Ok(magnitude(size)),
            (Drawn::Segment(ends), _) => ends,
            // Its direction and components show when it is laid off.
            (Drawn::Computed(size, along), _) => {
                let pole = self.writer.pole_of(sheet).ok_or(Unread::NotDrawn)?;
                let sum = vec![Product::new(1.0, &[size])];
                [pole, self.writer.lay_off(sheet, asked.name(), pole, sum, along)]
            }
        };
        let how = match component {
            Component::X => How::X,
            Component::Y => How::Y,
            Component::Size => How::Size,
            Component::Angle => How::Direction,
        };
        let number = self.writer.measure(sheet, asked.name(), ends, how);
        Ok(match component {
            Component::Angle => angle(number),
            Component::Size => distance(number),
            Component::X | Component::Y => of(number),
        })
    }

    /// A rate of a link that is found; given ones are not read.
    fn rate(&self, link: BodyId, order: usize) -> Result<NumberId, Unread> {
        if self.is_given(link) {
            return Err(Unread::Given);
        }
        self.rate_or_given(link, order)?.ok_or(Unread::Given)
    }

    /// Whether a link turns as the scene says: by itself, or tied by sliders to one that does.
    fn is_given(&self, link: BodyId) -> bool {
        let mechanism = self.writer.mechanism;
        let spins = &self.writer.drafting.spins;
        let bodies = || (0..mechanism.bodies.len()).map(BodyId);
        let mut known = bodies().filter(|&b| mechanism.is_known(b));
        let own = spins[link.0];
        mechanism.is_known(link) || own.is_some_and(|own| known.any(|b| spins[b.0] == Some(own)))
    }

    /// Nothing for a rate that is given as zero.
    fn rate_or_given(&self, link: BodyId, order: usize) -> Result<Option<NumberId>, Unread> {
        let rates = self.writer.drafting.spins[link.0];
        Ok(rates.ok_or(Unread::NoConstruction)?[order])
    }

    fn slide_rate(&self, id: SliderId, order: usize) -> Result<NumberId, Unread> {
        if self.writer.mechanism.slider(id).drive.is_some() {
            return Err(Unread::Given);
        }
        self.slide_rate_or_given(id, order)?.ok_or(Unread::Given)
    }

    fn slide_rate_or_given(&self, id: SliderId, order: usize) -> Result<Option<NumberId>, Unread> {
        let rates = self.writer.drafting.slides[id.0];
        Ok(rates.ok_or(Unread::NoConstruction)?[order])
    }

    /// The direction of a link's axis, from its first to its second point.
    fn axis(&mut self, link: BodyId) -> Result<NumberId, Unread> {
        let (mechanism, pose) = (self.writer.mechanism, self.writer.pose);
        let axis = pose.axes[link.0].ok_or(Unread::NotDrawn)?;
        let &[from, to, ..] = mechanism.body(link).points.as_slice() else {
            return Err(Unread::NotDrawn);
        };
        let arm = pose.arm(from, to);
        // With a shape of its own the axis may run elsewhere.
        let apart = crate::geometry::cross(axis.normalize(), arm).abs();
        if arm.norm() == 0.0 || arm.dot(&axis) < 0.0 || apart > 1e-9 * arm.norm() {
            return Err(Unread::NotDrawn);
        }
        let name = format!("angle({})", mechanism.body(link).name);
        let ends = [self.writer.plot(from), self.writer.plot(to)];
        let how = How::Direction;
        Ok(self.writer.measure(Sheet::Scheme, &name, ends, how))
    }

    /// The position along a guide, where a point of the guide's body stands at the place from which it counts.
    fn slide_position(&mut self, name: &str, id: SliderId) -> Result<NumberId, Unread> {
        let (mechanism, pose) = (self.writer.mechanism, self.writer.pose);
        let slider = mechanism.slider(id);
        if slider.drive.is_some_and(|drive| drive.position.is_some()) {
            return Err(Unread::Given);
        }
        let position = pose.slides[id.0].ok_or(Unread::NotDrawn)?;
        let start = pose.point(slider.at) - pose.guide(id) * position;
        let mut points = mechanism.body(slider.on).points.iter().copied();
        let from = points.find(|&p| (pose.point(p) - start).norm() <= self.writer.near);
        let from = from.ok_or(Unread::NotDrawn)?;
        let how = How::Along(self.writer.guide(id));
        let ends = [self.writer.plot(from), self.writer.plot(slider.at)];
        Ok(self.writer.measure(Sheet::Scheme, name, ends, how))
    }

    fn coordinate(&mut self, name: &str, how: How, spot: &Spot) -> Result<NumberId, Unread> {
        let place = self.scheme_point(spot)?;
        let origin = -self.writer.drafting.origin.coords;
        let zero = self.writer.pole(Sheet::Scheme, "origin", origin);
        Ok(self.writer.measure(Sheet::Scheme, name, [zero, place], how))
    }

    /// The number, and whether it is measured for this reading and not by the construction.
    fn length(&mut self, name: &str, a: &Spot, b: &Spot) -> Result<(NumberId, bool), Unread> {
        let compact = format!("L({},{})", a.name(), b.name());
        if let Some(number) = self.writer.drafting.number(&compact) {
            return Ok((number, false));
        }
        let ends = [self.scheme_point(a)?, self.scheme_point(b)?];
        let how = How::Size;
        Ok((self.writer.measure(Sheet::Scheme, name, ends, how), true))
    }

    /// The number, and whether it is measured for this reading and not by the construction.
    fn segment(&mut self, kind: PlanKind, from: &str, to: &str) -> Result<(NumberId, bool), Unread> {
        let sheet = Sheet::of(kind);
        let name = kind.segment_name(from, to);
        if let Some(number) = self.writer.drafting.number(&name) {
            return Ok((number, false));
        }
        let place = |name: &str| self.writer.drafting.place(sheet, name);
        let ends = place(from).zip(place(to)).ok_or(Unread::NoConstruction)?;
        if ends.0 == ends.1 {
            return Err(Unread::Given);
        }
        let ends = [ends.0, ends.1];
        Ok((self.writer.measure(sheet, &name, ends, How::Size), true))
    }

    fn scheme_point(&mut self, spot: &Spot) -> Result<PlaceId, Unread> {
        match spot {
            Spot::Point(_, point, _) => Ok(self.writer.plot(*point)),
            Spot::Special(name) => {
                let place = self.writer.drafting.place(Sheet::Scheme, name);
                place.ok_or(Unread::NoConstruction)
            }
        }
    }

    /// The end of a named place's vector: the plan's own point of that name, else laid off.
    fn plan_point(&mut self, sheet: Sheet, spot: &Spot) -> Result<PlaceId, Unread> {
        let named = self.writer.drafting.place(sheet, &image_name(spot.name()));
        let place = match (named, spot) {
            (Some(place), _) => Some(place),
            (None, Spot::Point(body, point, _)) => {
                let holder = self.holder(sheet, *body, *point);
                self.writer.motion(sheet, holder, *point)
            }
            (None, Spot::Special(_)) => None,
        };
        place.ok_or(Unread::NoConstruction)
    }

    /// The body over which a point's vector is found soonest: one where it is already, or of known motion.
    fn holder(&self, sheet: Sheet, body: BodyId, point: PointId) -> BodyId {
        let mechanism = self.writer.mechanism;
        let own = mechanism.body(body).points.contains(&point);
        let bodies = (0..mechanism.bodies.len()).map(BodyId);
        let mut holders = bodies.filter(|&b| own && mechanism.body(b).points.contains(&point));
        let found = holders.find(|&b| self.writer.moved_point(sheet, b, point).is_some() || mechanism.is_known(b));
        found.unwrap_or(body)
    }

    /// A part of a relative acceleration: between plan points where the construction lays it off, else computed.
    fn part(&mut self, name: &str, part: Normality, a: &Spot, b: &Spot, link: Option<BodyId>) -> Result<Drawn, Unread> {
        let sheet = Sheet::Acceleration;
        if let Spot::Special(special) = a {
            let normal = normal_name(b.name(), special);
            let plan = self.writer.construction.acceleration.as_ref();
            let laid = plan.and_then(|plan| plan.arrows().find(|arrow| arrow.to == normal));
            let drafting = &self.writer.drafting;
            let (from, to) = match part {
                Normality::Normal => (laid.map(|arrow| arrow.from.as_str()), normal.as_str()),
                Normality::Tangential => (laid.map(|_| normal.as_str()), &*image_name(special)),
            };
            if let Some(from) = from {
                let place = |name: &str| drafting.place(sheet, name);
                let ends = place(from).zip(place(to)).ok_or(Unread::NoConstruction)?;
                return Ok(Drawn::Segment([ends.0, ends.1]));
            }
        }
        let link = link.ok_or(Unread::NotDrawn)?;
        let order = usize::from(part == Normality::Tangential);
        let rate = self.rate_or_given(link, order)?.ok_or(Unread::Given)?;
        let (from, to) = (self.scheme_point(b)?, self.scheme_point(a)?);
        let line = self.writer.join_places(from, to);
        let how = How::Along(line);
        let length = self.writer.measure(Sheet::Scheme, name, [from, to], how);
        let (product, turns) = match part {
            Normality::Normal => (Product::new(-1.0, &[rate, rate, length]), 0),
            Normality::Tangential => (Product::new(1.0, &[rate, length]), 1),
        };
        let size = self.writer.compute(sheet, name, vec![product]);
        Ok(Drawn::Computed(size, (Reference::Line(line), turns)))
    }
}
