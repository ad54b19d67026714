//! How quantities are read from a hand drawing: `rates`, `vectors` and `centers` of the motion, `forces`; `needed` leaves out what nobody
//! draws for them.

mod centers;
mod forces;
mod needed;
mod rates;
mod vectors;

use self::needed::keep_drawn;
use super::name::{QuantityRequest, Spot, What};
use crate::construction::{
    Construction, End, MeasuredAs, NumberId, NumberKind, OperationKind, PlaceId, Product, ProductKind, Rate, Solution,
    SpecialId, StepId, Writer,
};
use crate::mechanism::{BodyId, SliderId};
use crate::scene::{Component, QuantityName};
use crate::sheet::{Order, Sheet};
use core::f64::consts::TAU;
use indexmap::IndexMap;

/// How a quantity is read: a number of the construction, and the meaning of its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The number.
    pub number: NumberId,
    /// The meaning of its sign.
    pub sense: Sense,
    /// The last sheet that is needed for it.
    pub sheet: Sheet,
}

/// The meaning of the sign of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// The sign belongs to the quantity.
    Signed,
    /// The quantity is the magnitude, although the construction continues with the sign.
    Magnitude,
    /// The number is an angle, of period 360°.
    Angle,
    /// The number is the direction of a line, an angle of period 180°.
    Line,
    /// The number is the distance of two places, which is read as positive on the sheet.
    Distance,
}

impl Reading {
    /// Whether it is written without a sign.
    #[must_use]
    pub fn is_size(&self) -> bool {
        matches!(self.sense, Sense::Magnitude | Sense::Distance)
    }
}

/// Why a quantity is not read from a hand drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unread {
    /// The scene gives it.
    #[error("the scene gives it")]
    Given,
    /// It depends on a group without a construction.
    #[error("it depends on a group without a construction (a special point at infinity, or a higher class)")]
    NoConstruction,
    /// It is a vector, and only single numbers of a vector have bands.
    #[error("a vector: its `.size` and `.angle` have bands")]
    Vector,
    /// The drawing does not show it.
    #[error("the drawing does not show it")]
    NotDrawn,
    /// Errors of this size make lines parallel that should cross.
    #[error("errors of this size take the construction apart")]
    Apart,
    /// The figure lacks the panel from which it is read.
    #[error("the figure has no {}, so no scale", .0.name())]
    NoSheet(Sheet),
}

/// The construction of a solved scene as far as a hand can carry it out, followed by the operations that read the
/// quantities `asked` for; and for each quantity how it is read, or why it is not.
///
/// A quantity that the construction measures or solves for is taken from there. A segment or a vector of a plan, a
/// direction and a length are measured once more, with errors of their own.
#[must_use]
pub fn read_by_hand(solution: &Solution, asked: &[QuantityRequest]) -> (Construction, Vec<Result<Reading, Unread>>) {
    let Solution { mechanism, pose, motion, construction, .. } = solution;
    let mut reader = Reader { steps: None, writer: Writer::continued(mechanism, pose, motion, construction.clone()) };
    let readings: Vec<_> = asked.iter().map(|asked| reader.reading(asked)).collect();
    let mut construction = reader.writer.construction;
    construction.operations.retain(|operation| operation.by_hand);
    if construction.by_hand != Sheet::USUAL {
        keep_drawn(&mut construction, readings.iter().flatten().map(|reading| reading.number));
    }
    (construction, readings)
}

struct Reader<'a> {
    writer: Writer<'a>,
    /// The step that gives each quantity, by its name; once it has been asked for.
    steps: Option<IndexMap<String, StepId>>,
}

impl Reader<'_> {
    fn reading(&mut self, asked: &QuantityRequest) -> Result<Reading, Unread> {
        let (number, sense) = self.number(asked)?;
        let sheet = asked.sheet_by_hand(&self.writer.construction);
        match self.writer.is_by_hand(number) {
            false => Err(Unread::NoConstruction),
            true => Ok(Reading { number, sense, sheet }),
        }
    }

    fn number(&mut self, asked: &QuantityRequest) -> Result<(NumberId, Sense), Unread> {
        let name = asked.name();
        let number = match &asked.what {
            What::Rate(rate) => self.rate(*rate)?,
            What::RelativeRate(order, links) => self.relative_rate(asked, *order, *links)?,
            What::SpeedRatio(links) => self.speed_ratio(asked, *links)?,
            What::Rpm(link, time) => {
                let omega = self.rate(Rate::Angular(Order::Velocity, *link))?;
                let product = Product::new(ProductKind::Plain, time.in_a_minute() / TAU, &[omega]);
                self.computed(asked, vec![product])
            }
            What::Angle(link) => return Ok((self.axis(name, *link)?, Sense::Angle)),
            What::SlidePosition(id) => self.slide_position(name, *id)?,
            What::Coordinate(axis, spot) => self.coordinate(name, [MeasuredAs::X, MeasuredAs::Y][*axis], spot)?,
            What::Length(a, b) => return self.length(name, a, b),
            What::Pole(pole) => return self.center(asked, pole),
            What::Force(of, _) => return self.force(asked, of),
            What::InflectionDiameter(_) => {
                let number = self.measured(&NumberKind::Reading(name.to_owned())).ok_or(Unread::NotDrawn)?;
                return Ok((number, Sense::Distance));
            }
            What::PathRadius(_) => {
                return Err(Unread::NotDrawn);
            }
            What::Corners(corners) => return self.corners(asked, &corners.ends),
            What::Segment(order, _) if !self.draws(*order) => return Err(Unread::NoSheet(order.sheet())),
            What::Segment(order, ends) if asked.written.component.is_some() => {
                return self.direction(*order, ends, name);
            }
            What::Segment(order, ends) => return self.segment(*order, ends),
            What::Motion(Order::Velocity, Spot::Point(_, point, _), None) if !self.draws(Order::Velocity) => {
                return self.by_centers(asked, *point);
            }
            What::Motion(order, a, b) => {
                self.needs(*order)?;
                let drawn = self.vector(*order, a, b.as_ref())?;
                return self.component(asked, drawn);
            }
            What::Coriolis(id, on) => {
                self.needs(Order::Acceleration)?;
                let drawn = self.coriolis(*id, *on)?;
                return self.component(asked, drawn);
            }
            What::Part(part, a, b, link) => {
                self.needs(Order::Acceleration)?;
                let drawn = self.part(name, *part, a, b, *link)?;
                return self.component(asked, drawn);
            }
        };
        Ok((number, Sense::Signed))
    }

    /// Whether a hand draws the plan.
    fn draws(&self, order: Order) -> bool {
        self.writer.construction.by_hand.contains(&order.sheet())
    }

    fn needs(&self, order: Order) -> Result<(), Unread> {
        if self.draws(order) { Ok(()) } else { Err(Unread::NoSheet(order.sheet())) }
    }

    /// The ends of a segment that a hand can draw. One of zero length, as of a point at rest, is not measured.
    fn drawn(&self, ends: [PlaceId; 2]) -> Result<[PlaceId; 2], Unread> {
        match ends {
            _ if !ends.iter().all(|&end| self.writer.is_place_by_hand(end)) => Err(Unread::NoConstruction),
            [from, to] if from == to => Err(Unread::Given),
            _ => Ok(ends),
        }
    }

    /// Measures a number with errors of its own, as part of the step that gives the quantity `name`, or the length of the segment
    /// whose direction it is.
    fn measure(&mut self, sheet: impl Into<Sheet>, name: &str, ends: [PlaceId; 2], how: MeasuredAs) -> NumberId {
        let sheet = sheet.into();
        let number = self.writer.measure(sheet, NumberKind::Reading(name.to_owned()), ends, how);
        self.put_in_step(sheet, name);
        number
    }

    /// Puts the last operation into the step of the sheet that gives the quantity `name`, if there is one.
    fn put_in_step(&mut self, sheet: Sheet, name: &str) {
        let construction = &self.writer.construction;
        let steps = self.steps.get_or_insert_with(|| construction.steps_of_quantities());
        let step = steps.get(name).or_else(|| steps.get(QuantityName::of_direction(name)?)).copied();
        if let Some(operation) = self.writer.construction.operations.last_mut() {
            operation.step = step.filter(|step| step.sheet == sheet);
        }
    }

    /// The direction of a link's axis, measured from its first to its second point.
    fn axis(&mut self, name: &str, link: BodyId) -> Result<NumberId, Unread> {
        let (mechanism, pose) = (self.writer.mechanism, self.writer.pose);
        let axis = pose.axes[link.0].ok_or(Unread::NotDrawn)?;
        let &[from, to, ..] = mechanism.body(link).points.as_slice() else {
            return Err(Unread::NotDrawn);
        };
        let arm = pose.arm(from, to);
        // The axis of a link with a shape of its own need not pass through these points.
        let apart = crate::geometry::cross(axis.normalize(), arm).abs();
        if arm.norm() == 0.0 || arm.dot(&axis) < 0.0 || apart > 1e-9 * arm.norm() {
            return Err(Unread::NotDrawn);
        }
        let ends = [self.writer.plot(from), self.writer.plot(to)];
        Ok(self.measure(Sheet::Scheme, name, ends, MeasuredAs::Direction))
    }

    /// The position along a guide, if a point of the guide's body lies at the place from which it counts.
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
        let how = MeasuredAs::Along(self.writer.guide(id));
        let ends = [self.writer.plot(from), self.writer.plot(slider.at)];
        Ok(self.measure(Sheet::Scheme, name, ends, how))
    }

    fn coordinate(&mut self, name: &str, how: MeasuredAs, spot: &Spot) -> Result<NumberId, Unread> {
        let place = self.scheme_point(spot)?;
        let origin = -self.writer.construction.origin.coords;
        let zero = self.writer.pole(Sheet::Scheme, "origin", origin);
        Ok(self.measure(Sheet::Scheme, name, [zero, place], how))
    }

    /// The distance of two places: the length that the construction measures, else one measured for this reading.
    fn length(&mut self, name: &str, a: &Spot, b: &Spot) -> Result<(NumberId, Sense), Unread> {
        if let (Some(a), Some(b)) = (self.end(a), self.end(b))
            && let Some(number) = self.measured(&NumberKind::Length([a, b]))
        {
            return Ok((number, Sense::Magnitude));
        }
        let sheet = match [a, b].iter().any(|spot| matches!(spot, Spot::Pole(_))) {
            true => Sheet::Centers,
            false => Sheet::Scheme,
        };
        let ends = [self.point_on(sheet, a)?, self.point_on(sheet, b)?];
        Ok((self.measure(sheet, name, ends, MeasuredAs::Size), Sense::Distance))
    }

    /// The number of this kind that the construction measures.
    fn measured(&self, kind: &NumberKind) -> Option<NumberId> {
        let construction = &self.writer.construction;
        construction.operations.iter().find_map(|operation| match operation.kind {
            OperationKind::Measure { number, .. } if construction.numbers[number.0] == *kind => Some(number),
            _ => None,
        })
    }

    /// A place as the end of a measured length; `None` if no measured length ends there.
    fn end(&self, spot: &Spot) -> Option<End> {
        match spot {
            Spot::Point(_, point, name) => {
                (self.writer.mechanism.point_name(*point) == name).then_some(End::Joint(*point))
            }
            Spot::Pole(pole) => self.drawn_center(pole).ok().map(End::Center),
            Spot::Special(name) => {
                let mut special = self.writer.construction.special.iter();
                special.position(|s| s.name == *name).map(|index| End::Special(SpecialId(index)))
            }
        }
    }

    /// A point of a sheet that shows the mechanism.
    fn point_on(&mut self, sheet: Sheet, spot: &Spot) -> Result<PlaceId, Unread> {
        match spot {
            Spot::Pole(pole) => self.place_of_center(pole),
            Spot::Point(_, point, _) if sheet == Sheet::Centers => Ok(self.writer.plot_on(sheet, *point)),
            _ if sheet == Sheet::Centers => Err(Unread::NotDrawn),
            _ => self.scheme_point(spot),
        }
    }

    fn scheme_point(&mut self, spot: &Spot) -> Result<PlaceId, Unread> {
        match spot {
            Spot::Point(_, point, _) => Ok(self.writer.plot(*point)),
            Spot::Special(name) => self.writer.construction.place(Sheet::Scheme, name).ok_or(Unread::NoConstruction),
            Spot::Pole(_) => Err(Unread::NotDrawn),
        }
    }
}

/// How a number of a vector is measured between its ends, and the meaning of its sign.
fn measured_as(component: Component) -> (MeasuredAs, Sense) {
    match component {
        Component::X => (MeasuredAs::X, Sense::Signed),
        Component::Y => (MeasuredAs::Y, Sense::Signed),
        Component::Size => (MeasuredAs::Size, Sense::Distance),
        Component::Angle => (MeasuredAs::Direction, Sense::Angle),
    }
}
