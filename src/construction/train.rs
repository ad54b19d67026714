//! Wheels that mesh: their angular velocities by the velocities of pitch points, their angular accelerations by the meshes' equations.
//!
//! Where two wheels touch they have one velocity, so that the image of a pitch point belongs to both. A wheel of which two
//! points have images, its centre and a pitch point or two pitch points, turns with their relative velocity over their distance: their images
//! and that of every point between lie on the velocity line. What no two points lead to, and all accelerations, follow from the equations
//! z₁ ω₁ + z₂ ω₂ = (z₁ + z₂) ω_carrier (Willis, 1841): at a pitch point only the tangential parts of accelerations are equal.

use super::name::{image_name, point_on};
use super::number::{End, Equation, NumberId, NumberKind, Product, ProductKind, Rate};
use super::operation::{Along, MeasuredAs, OperationRole, PlaceId};
use super::step::{Action, Arrow, PointRole, RateEquation, VectorOf, VectorPart, WheelEquation};
use super::writer::Writer;
use crate::mechanism::{BodyId, GROUND, Group, Joint, JointId, LoopEquations, Mechanism, PointId};
use crate::sheet::{Order, Sheet};

/// Most equations that are solved together by hand.
const MOST_EQUATIONS: usize = 4;

/// A point of a body with a velocity that another body gives.
#[derive(Clone, Copy, PartialEq)]
struct Spot {
    at: At,
    /// The body whose velocity it has there.
    by: BodyId,
}

#[derive(Clone, Copy, PartialEq)]
enum At {
    Pin(PointId),
    Pitch(JointId),
}

/// A wheel whose angular velocity follows from two of its points.
struct Turned {
    wheel: BodyId,
    spots: [Spot; 2],
}

/// The rim of a wheel in a mesh.
struct Rim {
    joint: JointId,
    /// The wheel's centre and that of the other wheel.
    center: PointId,
    other: PointId,
    /// Numbers of teeth of the wheel and of both together, signed.
    teeth: i32,
    sum: i32,
}

impl Rim {
    fn of(mechanism: &Mechanism, joint: JointId, wheel: BodyId) -> Option<Rim> {
        let (own, pitch) = (mechanism.joint(joint), mechanism.joint(joint).pitch?);
        let side = own.bodies.iter().position(|body| *body == wheel)?;
        let sum = pitch.teeth[0] + pitch.teeth[1];
        Some(Rim { joint, center: pitch.centers[side], other: pitch.centers[1 - side], teeth: pitch.teeth[side], sum })
    }

    /// Where the pitch point lies from the wheel's centre: +1 towards the other centre, −1 away from it.
    fn sign(&self) -> f64 {
        f64::from((self.teeth * self.sum).signum())
    }
}

/// The pitch points of a mechanism with their names.
pub(super) fn pitch_points(mechanism: &Mechanism) -> impl Iterator<Item = (JointId, String)> {
    let pairs = mechanism.joints.iter().enumerate().filter(|(_, joint)| joint.pitch.is_some());
    pairs.map(|(index, _)| (JointId(index), pitch_name(mechanism, JointId(index))))
}

/// The name of the pitch point of a mesh by its wheels, as P23, the frame's being 0; of wheels with longer names by the number of the mesh.
fn pitch_name(mechanism: &Mechanism, joint: JointId) -> String {
    let mut wheels = mechanism.joint(joint).bodies;
    wheels.sort_unstable_by_key(|body| (*body == GROUND, mechanism.body(*body).name.as_str()));
    let is_pitch = |id: &usize| mechanism.joints[*id].pitch.is_some();
    name_by_wheels(mechanism, ("P", wheels), || (0..=joint.0).filter(is_pitch).count())
}

/// The name of where the first or the second wheel of a pair touches: the pitch point of a mesh, or of a wheel and its rack, as P23, or the rim of
/// a wheel with a belt, as R23 on wheel 2 and R32 on wheel 3.
pub(super) fn name_of_touch(mechanism: &Mechanism, joint: JointId, side: usize) -> String {
    let own = mechanism.joint(joint);
    let count = |is: fn(&Joint) -> bool, to: usize| mechanism.joints[..to].iter().filter(|joint| is(joint)).count();
    match (own.rack, own.belt) {
        (Some(_), _) => {
            let all = count(|joint| joint.pitch.is_some(), mechanism.joints.len());
            let mut wheels = own.bodies;
            wheels.sort_unstable_by_key(|body| (*body == GROUND, mechanism.body(*body).name.as_str()));
            name_by_wheels(mechanism, ("P", wheels), || all + count(|joint| joint.rack.is_some(), joint.0 + 1))
        }
        (_, Some(_)) => {
            let wheels = [own.bodies[side], own.bodies[1 - side]];
            let number = || 2 * count(|joint| joint.belt.is_some(), joint.0) + side + 1;
            name_by_wheels(mechanism, ("R", wheels), number)
        }
        _ => pitch_name(mechanism, joint),
    }
}

/// A letter with the names of two wheels, the frame's being 0; with a number where one has a longer name.
fn name_by_wheels(mechanism: &Mechanism, (letter, wheels): (&str, [BodyId; 2]), number: impl Fn() -> usize) -> String {
    let wheels = wheels.map(|body| if body == GROUND { "0" } else { mechanism.body(body).name.as_str() });
    let mut told = match wheels.iter().all(|name| name.chars().count() == 1) {
        true => format!("{letter}{}", wheels.concat()),
        false => format!("{letter}{}", number()),
    };
    while mechanism.point(&told).is_some() {
        told.push('\'');
    }
    told
}

impl Writer<'_> {
    /// Whether a group is wheels and arms whose meshes alone tell how they turn.
    pub(super) fn is_train(&self, group: &Group, equations: &LoopEquations) -> bool {
        let relations = group.joints.iter().map(|&joint| self.mechanism.joint(joint));
        let mut relations = relations.filter(|j| j.angular.as_ref().is_some_and(|a| a.as_fixed_angle().is_none()));
        group.loops.is_empty()
            && !equations.angular.is_empty()
            && equations.slides.is_empty()
            && relations.all(|joint| joint.pitch.is_some())
    }

    /// The rates of a train; `None` where there are too many equations to be solved by hand.
    pub(super) fn train(&mut self, group: &Group, equations: &LoopEquations) -> Option<()> {
        for &order in self.orders() {
            match self.turned(group).filter(|_| order == Order::Velocity) {
                Some(turned) => turned.iter().try_for_each(|next| self.turn(group, equations, next))?,
                None => self.by_meshes(order, group, equations)?,
            }
            if order == Order::Velocity {
                self.note_anchors(group);
            }
        }
        Some(())
    }

    /// The wheels and arms of a group in an order in which each has two points of known velocity; `None` where that leads not to all of them.
    fn turned(&self, group: &Group) -> Option<Vec<Turned>> {
        let mut found: Vec<Turned> = Vec::new();
        let is_found = |found: &[Turned], body| found.iter().any(|turned| turned.wheel == body);
        loop {
            let left = group.links.iter().filter(|body| !is_found(&found, **body));
            let next = left.clone().find_map(|&wheel| {
                let known = |body: BodyId| is_found(&found, body) || self.construction.angular_rates[body.0].is_some();
                let spots = self.two_spots(wheel, &known)?;
                Some(Turned { wheel, spots })
            });
            match next {
                Some(turned) => found.push(turned),
                None => return left.count().eq(&0).then_some(found),
            }
        }
    }

    /// Two points of a body with velocities that known bodies give, on one line through its centre.
    fn two_spots(&self, wheel: BodyId, known: &impl Fn(BodyId) -> bool) -> Option<[Spot; 2]> {
        let mechanism = self.mechanism;
        let mut spots: Vec<Spot> = Vec::new();
        for (index, joint) in mechanism.joints.iter().enumerate() {
            let by = match joint.bodies {
                [a, b] if a == wheel => b,
                [a, b] if b == wheel => a,
                _ => continue,
            };
            let at = joint.pin.map(At::Pin).or(joint.pitch.map(|_| At::Pitch(JointId(index))));
            if let (Some(at), true) = (at, known(by)) {
                spots.push(Spot { at, by });
            }
        }
        // What rests goes first.
        spots.sort_by_key(|spot| (matches!(spot.at, At::Pitch(_)), spot.by != GROUND));
        let pairs = spots.iter().enumerate().flat_map(|(i, &a)| spots[i + 1..].iter().map(move |&b| [a, b]));
        pairs.into_iter().find(|pair| self.distance_on(wheel, pair.map(|spot| spot.at)).is_some())
    }

    /// How far the second place is from the first along a line of the scheme, which is given by its ends; `None` for places that coincide or
    /// have no line in common.
    fn distance_on(&self, wheel: BodyId, ends: [At; 2]) -> Option<([PointId; 2], f64)> {
        let (mechanism, pose) = (self.mechanism, self.pose);
        let rim = |joint| Rim::of(mechanism, joint, wheel);
        let is_one = |a: PointId, b: PointId| pose.arm(a, b).norm() <= self.near;
        let from_center =
            |rim: &Rim| pose.arm(rim.center, rim.other).norm() * f64::from(rim.teeth) / f64::from(rim.sum);
        let (line, distance) = match ends {
            [At::Pin(a), At::Pin(b)] => ([a, b], pose.arm(a, b).norm()),
            [At::Pin(center), At::Pitch(joint)] => {
                let rim = rim(joint).filter(|rim| is_one(rim.center, center))?;
                ([rim.center, rim.other], from_center(&rim))
            }
            [At::Pitch(a), At::Pitch(b)] => {
                let [a, b] = [rim(a)?, rim(b)?];
                if !is_one(a.center, b.center) || !is_one(a.other, b.other) {
                    return None;
                }
                ([a.center, a.other], from_center(&b) - from_center(&a))
            }
            [At::Pitch(_), At::Pin(_)] => return None,
        };
        (distance.abs() > self.near).then_some((line, distance))
    }

    /// Finds the angular velocity of a wheel or an arm from the images of two of its points.
    fn turn(&mut self, group: &Group, equations: &LoopEquations, turned: &Turned) -> Option<()> {
        let order = Order::Velocity;
        let &Turned { wheel, spots } = turned;
        let [(from, start), (to, end)] = [self.image_of(wheel, spots[0])?, self.image_of(wheel, spots[1])?];
        let (line, distance) = self.distance_on(wheel, spots.map(|spot| spot.at))?;
        let line = self.join(line[0], line[1]);
        let length = self.distance(wheel, spots.map(|spot| spot.at), distance)?;
        let step = self.begin(order);
        let ray = self.draw(order, OperationRole::Line, start, Along::line(line).turned(1));
        let kind = NumberKind::Segment(order, [from.clone(), to.clone()]);
        let segment = self.measure(order, kind, [start, end], MeasuredAs::Along(ray));
        let value = self.construction.record.exact.numbers[segment.0].high;
        self.finish(step, Action::Measure { from: from.clone(), to: to.clone(), value: value.abs() });
        let (unknown, rate) = (equations.angular_unknown(wheel)?, Rate::Angular(order, wheel));
        let left = vec![(0, Product::new(ProductKind::Turning, distance.signum(), &[length]))];
        let step = self.begin(order);
        let row = Equation { left, right: vec![Product::plain(segment)] };
        let numbers = self.solve(order, vec![NumberKind::Rate(rate)], vec![row])?;
        let alike = |link: &&BodyId| equations.angular_unknown(**link) == Some(unknown);
        for &link in group.bodies.iter().filter(alike) {
            self.construction.set_rate(Rate::Angular(order, link), numbers[0]);
        }
        let names = spots.map(|spot| self.spot_name(wheel, spot.at));
        let own =
            WheelEquation { link: wheel, ends: names, from: from.clone(), to, segment: value * distance.signum() };
        let mut told = vec![RateEquation::Wheel(own)];
        told.extend(self.meshes_told_with(wheel).map(|joint| RateEquation::Mesh(order, joint)));
        let value = self.motion.body(wheel).omega;
        self.finish(step, Action::Solve { equations: told, unknowns: vec![(rate.name(self.mechanism), value)] });
        for (spot, place) in spots.into_iter().zip([start, end]) {
            if let At::Pin(point) = spot.at {
                self.construction.record.note_motion(order, wheel, point, place);
            }
        }
        if let [At::Pitch(joint), At::Pitch(_)] = spots.map(|spot| spot.at) {
            self.lay_off_center(wheel, joint, (from, start));
        }
        Some(())
    }

    /// The meshes of a wheel or an arm of which all rates are known now.
    fn meshes_told_with(&self, body: BodyId) -> impl Iterator<Item = JointId> {
        let is_known = |body: &BodyId| self.construction.angular_rates[body.0].is_some();
        let joints = self.mechanism.joints.iter().enumerate();
        let told = joints.filter(move |(_, joint)| {
            let bodies: Vec<BodyId> = joint.related_bodies().collect();
            joint.pitch.is_some() && bodies.contains(&body) && bodies.iter().all(is_known)
        });
        told.map(|(index, _)| JointId(index)).collect::<Vec<_>>().into_iter()
    }

    /// Name and place of the image of a point that has the velocity of another body.
    fn image_of(&mut self, wheel: BodyId, Spot { at, by }: Spot) -> Option<(String, PlaceId)> {
        let order = Order::Velocity;
        match at {
            At::Pin(_) if by == GROUND => Some((order.pole().to_owned(), self.pole_of(order)?)),
            At::Pin(point) => {
                if self.mechanism.is_known(by) {
                    self.known_vector(order, by, point);
                } else {
                    self.relative_image(order, by, point);
                }
                Some((image_name(&point_on(self.mechanism, by, point)), self.motion(order, by, point)))
            }
            At::Pitch(joint) => self.pitch_image(joint, by).filter(|_| by != wheel),
        }
    }

    /// Lays off the velocity of a pitch point as that of a point of the wheel.
    fn pitch_image(&mut self, joint: JointId, wheel: BodyId) -> Option<(String, PlaceId)> {
        let order = Order::Velocity;
        let name = self.construction.pitch_name(joint).to_owned();
        let image = image_name(&name);
        if let Some(place) = self.construction.place(order, &image) {
            let pole = self.pole_of(order).filter(|pole| *pole == place);
            return Some((pole.map_or(image, |_| order.pole().to_owned()), place));
        }
        if wheel == GROUND {
            let (step, pole) = (self.begin(order), self.pole_of(order)?);
            self.show(order, &image, pole, PointRole::Pole);
            let with = order.pole().to_owned();
            self.finish(step, Action::Coincide { point: image.clone(), with, link: wheel });
            return Some((order.pole().to_owned(), pole));
        }
        let rim = Rim::of(self.mechanism, joint, wheel)?;
        let carrier = self.mechanism.joint(joint).related_bodies().nth(2)?;
        let by = if self.place_of_motion(order, wheel, rim.center).is_some() { wheel } else { carrier };
        let by = if self.mechanism.body(GROUND).has(rim.center) { GROUND } else { by };
        let (from, start) = self.image_of(wheel, Spot { at: At::Pin(rim.center), by })?;
        let Some(omega) = self.construction.angular_rates[wheel.0]?[order] else {
            let step = self.begin(order);
            self.show(order, &image, start, PointRole::Image);
            self.finish(step, Action::Coincide { point: image.clone(), with: from, link: wheel });
            return Some((image, start));
        };
        let center = self.mechanism.point_name(rim.center).to_owned();
        let of = VectorOf::Relative { link: wheel, from: center, to: name, part: VectorPart::Relative };
        let radius = self.radius(&rim)?;
        let along = Along::line(self.join(rim.center, rim.other)).turned(1);
        let step = self.begin(order);
        let size = vec![Product::new(ProductKind::Turning, rim.sign(), &[omega, radius])];
        let place = self.lay_off(order, start, size, along);
        self.show(order, &image, place, PointRole::Image);
        self.finish(step, Action::LayOff(Arrow { order, from, to: image.clone(), of }));
        Some((image, place))
    }

    /// Lays off the velocity of a wheel's centre from the image of its pitch point.
    fn lay_off_center(&mut self, wheel: BodyId, joint: JointId, (at, start): (String, PlaceId)) -> Option<()> {
        let order = Order::Velocity;
        let rim = Rim::of(self.mechanism, joint, wheel)?;
        let from = self.construction.pitch_name(joint).to_owned();
        let center = self.mechanism.point_name(rim.center).to_owned();
        let image = image_name(&center);
        let of = VectorOf::Relative { link: wheel, from, to: center, part: VectorPart::Relative };
        let (omega, radius) = (self.construction.angular_rates[wheel.0]?[order]?, self.radius(&rim)?);
        let along = Along::line(self.join(rim.center, rim.other)).turned(1);
        let step = self.begin(order);
        let size = vec![Product::new(ProductKind::Turning, -rim.sign(), &[omega, radius])];
        let place = self.lay_off(order, start, size, along);
        self.show(order, &image, place, PointRole::Image);
        self.finish(step, Action::LayOff(Arrow { order, from: at, to: image, of }));
        for body in self.mechanism.body_ids() {
            if self.mechanism.body(body).has(rim.center) {
                self.construction.record.note_motion(order, body, rim.center, place);
            }
        }
        Some(())
    }

    /// The pitch radius of a wheel: (z₁ + z₂) r₁ = z₁ L with the distance L of the centres.
    fn radius(&mut self, rim: &Rim) -> Option<NumberId> {
        if let Some(&number) = self.construction.record.radii.get(&(rim.joint, rim.center)) {
            return Some(number);
        }
        let length = self.length(rim.center, rim.other);
        let plain = |factor: i32, of: &[NumberId]| Product::new(ProductKind::Plain, f64::from(factor.abs()), of);
        let row = Equation { left: vec![(0, plain(rim.sum, &[]))], right: vec![plain(rim.teeth, &[length])] };
        let kind = NumberKind::Length([End::Joint(rim.center), End::Pitch(rim.joint)]);
        let number = *self.solve(Sheet::Scheme, vec![kind], vec![row])?.first()?;
        self.construction.record.radii.insert((rim.joint, rim.center), number);
        Some(number)
    }

    /// The distance of two points of a body between which it is this, signed.
    fn distance(&mut self, wheel: BodyId, ends: [At; 2], signed: f64) -> Option<NumberId> {
        match ends {
            [At::Pin(a), At::Pin(b)] => Some(self.length(a, b)),
            [At::Pin(_), At::Pitch(joint)] => self.radius(&Rim::of(self.mechanism, joint, wheel)?),
            [At::Pitch(a), At::Pitch(b)] => {
                let [own, other] = [Rim::of(self.mechanism, a, wheel)?, Rim::of(self.mechanism, b, wheel)?];
                let sum = vec![
                    Product::new(ProductKind::Plain, other.sign() * signed.signum(), &[self.radius(&other)?]),
                    Product::new(ProductKind::Plain, -own.sign() * signed.signum(), &[self.radius(&own)?]),
                ];
                Some(self.compute(Sheet::Scheme, NumberKind::Length([End::Pitch(a), End::Pitch(b)]), sum))
            }
            [At::Pitch(_), At::Pin(_)] => None,
        }
    }

    fn spot_name(&self, wheel: BodyId, at: At) -> String {
        match at {
            At::Pin(point) => point_on(self.mechanism, wheel, point),
            At::Pitch(joint) => self.construction.pitch_name(joint).to_owned(),
        }
    }

    /// Solves the equations of the meshes. Without any angular acceleration that is given there is none.
    fn by_meshes(&mut self, order: Order, group: &Group, equations: &LoopEquations) -> Option<()> {
        let rows: Vec<Equation> =
            equations.angular.iter().map(|terms| self.angular_equation(order, terms)).collect::<Option<_>>()?;
        let unknown = self.unknown_rates(order, group, equations);
        if rows.iter().all(|row| row.right.is_empty()) {
            for link in unknown.iter().filter_map(|(_, rate)| rate.link()) {
                self.construction.angular_rates[link.0].get_or_insert_default();
            }
            return Some(());
        }
        if rows.len() > MOST_EQUATIONS {
            return None;
        }
        let step = self.begin(order);
        let mut kinds = vec![NumberKind::Rate(Rate::Angular(order, GROUND)); rows.len()];
        unknown.iter().for_each(|&(index, rate)| kinds[index] = NumberKind::Rate(rate));
        let numbers = self.solve(order, kinds, rows)?;
        let meshes = group.joints.iter().copied().filter(|&joint| self.mechanism.joint(joint).pitch.is_some());
        let told = meshes.map(|joint| RateEquation::Mesh(order, joint)).collect();
        let solved = unknown.iter().map(|&(_, rate)| (rate.name(self.mechanism), self.computed_rate(rate)[0]));
        self.finish(step, Action::Solve { equations: told, unknowns: solved.collect() });
        self.note_rates(&unknown, &numbers);
        Some(())
    }
}
