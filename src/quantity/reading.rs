//! How quantities are read from a hand drawing.

use super::name::{AccelerationPart, Pole, PoleOf, QuantityRequest, Spot, What};
use crate::construction::Spot as DrawnAt;
use crate::construction::{
    Along, CenterId, Construction, End, Equation, MeasuredAs, NumberId, NumberKind, Operation, OperationKind,
    OperationRole, PlaceId, Product, ProductKind, Rate, Solution, SpecialId, StepId, Writer, image_name, normal_name,
};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::scene::{Component, Head, QuantityName};
use crate::sheet::{Order, Sheet};
use core::f64::consts::TAU;
use indexmap::IndexMap;
use std::collections::BTreeSet;

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
        keep_drawn(&mut construction, &readings);
    }
    (construction, readings)
}

/// Leaves out what is done on sheets that a hand does not draw, but for the given numbers that others need; and on a scheme that is drawn for its
/// forces alone what only velocities need.
fn keep_drawn(construction: &mut Construction, readings: &[Result<Reading, Unread>]) {
    let has_plans = construction.draws_plans();
    let Construction { operations, by_hand, .. } = construction;
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    for operation in operations.iter().filter(|operation| by_hand.contains(&operation.sheet)) {
        operation.kind.each_number_read(|number| needed.extend([number.0]));
    }
    operations.retain(|operation| match &operation.kind {
        OperationKind::Take { number, .. } => needed.contains(&number.0),
        _ => by_hand.contains(&operation.sheet),
    });
    if !has_plans {
        keep_needed(operations, readings);
    }
}

/// Leaves out what is done on the scheme and needed by nothing on other sheets, but for the joints.
fn keep_needed(operations: &mut Vec<Operation>, readings: &[Result<Reading, Unread>]) {
    let (mut places, mut lines) = (BTreeSet::new(), BTreeSet::new());
    let mut numbers: BTreeSet<usize> = readings.iter().flatten().map(|reading| reading.number.0).collect();
    let mut kept: Vec<bool> = Vec::new();
    for Operation { sheet, kind, .. } in operations.iter().rev() {
        let is_needed = *sheet != Sheet::Scheme
            || matches!(kind, OperationKind::Plot { .. })
            || kind.place().is_some_and(|place| places.contains(&place.0))
            || kind.line().is_some_and(|line| lines.contains(&line.0))
            || kind.numbers().iter().any(|number| numbers.contains(&number.0));
        kept.push(is_needed);
        if is_needed {
            let (read_places, read_lines) = kind.places_and_lines_read();
            places.extend(read_places.iter().map(|place| place.0));
            lines.extend(read_lines.iter().map(|line| line.0));
            kind.each_number_read(|number| numbers.extend([number.0]));
        }
    }
    let mut kept = kept.into_iter().rev();
    operations.retain(|_| kept.next().unwrap_or(true));
}

pub(super) struct Reader<'a> {
    pub(super) writer: Writer<'a>,
    /// The step that gives each quantity, by its name; once it has been asked for.
    steps: Option<IndexMap<String, StepId>>,
}

/// A vector as a segment of a plan, or by its computed size along a line.
enum VectorSource {
    Segment([PlaceId; 2]),
    Computed(NumberId, Along),
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

    /// A coordinate of an instant centre, measured from the origin of the scene; of one at infinity its direction.
    fn center(&mut self, asked: &QuantityRequest, pole: &Pole) -> Result<(NumberId, Sense), Unread> {
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
    fn drawn_center(&self, pole: &Pole) -> Result<CenterId, Unread> {
        let PoleOf::Center(pair, _) = pole.of else { return Err(Unread::NotDrawn) };
        self.writer.construction.centers.as_ref().and_then(|centers| centers.of(pair)).ok_or(Unread::NotDrawn)
    }

    fn place_of_center(&self, pole: &Pole) -> Result<PlaceId, Unread> {
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
    fn by_centers(&mut self, asked: &QuantityRequest, point: PointId) -> Result<(NumberId, Sense), Unread> {
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

    /// One number of a vector: measured from the segment, or computed.
    fn component(&mut self, asked: &QuantityRequest, drawn: VectorSource) -> Result<(NumberId, Sense), Unread> {
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
        let (how, sense) = match component {
            Component::X => (MeasuredAs::X, Sense::Signed),
            Component::Y => (MeasuredAs::Y, Sense::Signed),
            Component::Size => (MeasuredAs::Size, Sense::Distance),
            Component::Angle => (MeasuredAs::Direction, Sense::Angle),
        };
        Ok((self.measure(order, asked.name(), ends, how), sense))
    }

    /// The ends of a segment that a hand can draw. One of zero length, as of a point at rest, is not measured.
    pub(super) fn drawn(&self, ends: [PlaceId; 2]) -> Result<[PlaceId; 2], Unread> {
        match ends {
            _ if !ends.iter().all(|&end| self.writer.is_place_by_hand(end)) => Err(Unread::NoConstruction),
            [from, to] if from == to => Err(Unread::Given),
            _ => Ok(ends),
        }
    }

    /// Measures a number with errors of its own, as part of the step that gives the quantity `name`, or the length of the segment
    /// whose direction it is.
    pub(super) fn measure(
        &mut self,
        sheet: impl Into<Sheet>,
        name: &str,
        ends: [PlaceId; 2],
        how: MeasuredAs,
    ) -> NumberId {
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

    /// The vector of a place in a plan, relative to another place if there is one.
    fn vector(&mut self, order: Order, a: &Spot, b: Option<&Spot>) -> Result<VectorSource, Unread> {
        let to = self.plan_point(order, a)?;
        let from = match b {
            Some(b) => self.plan_point(order, b)?,
            None => self.writer.pole_of(order).ok_or(Unread::NotDrawn)?,
        };
        Ok(VectorSource::Segment([from, to]))
    }

    fn coriolis(&mut self, id: SliderId, on: BodyId) -> Result<VectorSource, Unread> {
        let omega = self.rate_or_given(Rate::Angular(Order::Velocity, on))?;
        let velocity = self.rate_or_given(Rate::Slide(Order::Velocity, id))?;
        let (Some(omega), Some(velocity)) = (omega, velocity) else {
            return Err(Unread::Given);
        };
        let product = Product::new(ProductKind::Coriolis, 2.0, &[omega, velocity]);
        let size = self.writer.compute(Order::Acceleration, NumberKind::Size, vec![product]);
        Ok(VectorSource::Computed(size, Along::line(self.writer.guide(id)).turned(1)))
    }

    /// A rate that is solved for; given rates are not read.
    fn rate(&self, rate: Rate) -> Result<NumberId, Unread> {
        let is_given = match rate {
            Rate::Angular(_, link) => self.is_given(link),
            Rate::Slide(_, id) => self.writer.mechanism.slider(id).drive.is_some(),
        };
        if !is_given && !self.draws(rate.order()) {
            return self.rate_by_centers(rate);
        }
        let number = if is_given { None } else { self.rate_or_given(rate)? };
        number.ok_or(Unread::Given)
    }

    /// A rate of a link, or the one that the scene gives; `None` if it is zero.
    fn angular_or_given(&self, order: Order, link: BodyId) -> Result<Option<NumberId>, Unread> {
        let rate = Rate::Angular(order, link);
        if self.is_given(link) { self.rate_or_given(rate) } else { self.rate(rate).map(Some) }
    }

    /// The difference of two rates, of which the scene gives one at most.
    fn relative_rate(&mut self, asked: &QuantityRequest, order: Order, links: [BodyId; 2]) -> Result<NumberId, Unread> {
        self.needs_found(links)?;
        let mut sum = Vec::new();
        for (link, sign) in links.into_iter().zip([1.0, -1.0]) {
            let number = self.angular_or_given(order, link)?;
            sum.extend(number.map(|number| Product::new(ProductKind::Plain, sign, &[number])));
        }
        Ok(self.computed(asked, sum))
    }

    /// The quotient of two angular velocities, of which the scene gives one at most.
    fn speed_ratio(&mut self, asked: &QuantityRequest, links: [BodyId; 2]) -> Result<NumberId, Unread> {
        self.needs_found(links)?;
        let [own, other] = links.map(|link| self.angular_or_given(Order::Velocity, link));
        let (Some(own), Some(other)) = (own?, other?) else { return Err(Unread::Given) };
        let row = Equation { left: vec![(0, Product::plain(other))], right: vec![Product::plain(own)] };
        let sheet = asked.sheet_by_hand(&self.writer.construction);
        let kind = NumberKind::Reading(asked.name().to_owned());
        let found = self.writer.solve(sheet, vec![kind], vec![row]).ok_or(Unread::NotDrawn)?;
        found.first().copied().ok_or(Unread::NotDrawn)
    }

    /// Refuses links of which the scene gives both rates.
    fn needs_found(&self, links: [BodyId; 2]) -> Result<(), Unread> {
        if links.into_iter().all(|link| self.is_given(link)) { Err(Unread::Given) } else { Ok(()) }
    }

    /// A number that a calculator finds from others.
    fn computed(&mut self, asked: &QuantityRequest, sum: Vec<Product>) -> NumberId {
        let sheet = asked.sheet_by_hand(&self.writer.construction);
        self.writer.compute(sheet, NumberKind::Reading(asked.name().to_owned()), sum)
    }

    /// An angular velocity that is found by distances of centres.
    fn rate_by_centers(&self, rate: Rate) -> Result<NumberId, Unread> {
        let Rate::Angular(Order::Velocity, link) = rate else { return Err(Unread::NoSheet(rate.order().sheet())) };
        let mut numbers = self.writer.construction.numbers.iter();
        let found = numbers.position(|kind| *kind == NumberKind::RateByCenters(link));
        found.map(NumberId).ok_or(Unread::NoSheet(Sheet::Velocity))
    }

    /// Whether the rotation of a link is given, its own or that of a body with which sliders make it turn alike.
    fn is_given(&self, link: BodyId) -> bool {
        let mechanism = self.writer.mechanism;
        let rates = &self.writer.construction.angular_rates;
        let mut known = mechanism.body_ids().filter(|&b| mechanism.is_known(b));
        mechanism.is_known(link) || rates[link.0].is_some() && known.any(|b| rates[b.0] == rates[link.0])
    }

    /// A rate that is solved for or given; `None` if it is given as zero.
    fn rate_or_given(&self, rate: Rate) -> Result<Option<NumberId>, Unread> {
        self.writer.construction.rate(rate).ok_or(Unread::NoConstruction)
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

    /// The length of a segment of a plan: the one that the construction measures, else one measured for this reading.
    fn segment(&mut self, order: Order, ends: &[String; 2]) -> Result<(NumberId, Sense), Unread> {
        let construction = &self.writer.construction;
        let [from, to] = ends.each_ref().map(|name| construction.plan_name(order, name).to_owned());
        if let Some(number) = self.measured(&NumberKind::Segment(order, [from.clone(), to.clone()])) {
            return Ok((number, Sense::Magnitude));
        }
        let ends = self.ends(order, &from, &to)?;
        Ok((self.measure(order, &order.sheet().segment_name(&from, &to), ends, MeasuredAs::Size), Sense::Distance))
    }

    /// The direction of a segment, as part of the step that gives its length.
    fn direction(&mut self, order: Order, ends: &[String; 2], name: &str) -> Result<(NumberId, Sense), Unread> {
        let [from, to] = ends.each_ref().map(|name| self.writer.construction.plan_name(order, name));
        let ends = self.ends(order, from, to)?;
        Ok((self.measure(order, name, ends, MeasuredAs::Direction), Sense::Angle))
    }

    /// The ends of a segment of a plan that a hand can draw.
    fn ends(&self, order: Order, from: &str, to: &str) -> Result<[PlaceId; 2], Unread> {
        let place = |name: &str| self.writer.construction.place(order, name).ok_or(Unread::NoConstruction);
        self.drawn([place(from)?, place(to)?])
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

    /// A part of a relative acceleration: a segment if the construction lays it off, else computed.
    fn part(
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
}
