//! Names of quantities, and the quantities they name.

use super::error::{Part, QuantityError, unknown};
use super::force_name::ForceOf;
use super::ways::Corners;
use crate::centers::{LinkPair, Permanent};
use crate::construction::Rate;
use crate::forces::Compiled;
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, Rolling, SliderId};
use crate::scene::{Component, Head, QuantityName, TimeUnit};
use crate::sheet::{Order, Sheet};
use crate::text::shown;
use std::sync::Arc;

/// A quantity by its name, looked up in a mechanism once.
///
/// `v(A/B)` is the velocity of A minus that of B, `omega(2/1)` the angular velocity of link 2 minus that of link 1. `i(3,1)` is
/// ω of link 3 over that of link 1, negative where they turn in opposite senses; `rpm(2)` is ω of link 2 in revolutions a minute. `a_n` and `a_t` are the normal and the tangential part of the
/// relative acceleration of two points of one link; of two links that driven sliders join, without the sliding and
/// Coriolis parts; of a special point and the outer joint of one of its legs, along and across the cut line. `x(D)` and
/// `y(D)` are a point's coordinates, `position(3/2)` a slider's. A vector's `.x`, `.y`, `.size` and `.angle` (degrees)
/// are numbers; so is a segment's `.angle`, from its first end to its second.
#[derive(Clone, Debug)]
pub struct QuantityRequest {
    pub(super) name: String,
    /// Its name, taken apart.
    pub written: QuantityName,
    /// The quantity that it asks for.
    pub what: What,
    /// Whether accelerations have to be known for it: each of many positions asks.
    pub(super) needs_accelerations: bool,
}

/// The quantity that a name asks for.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum What {
    /// A rate of a link or of a slider.
    Rate(Rate),
    /// An angular rate of the first link less that of the second.
    RelativeRate(Order, [BodyId; 2]),
    /// The angular velocity of the first link over that of the second.
    SpeedRatio([BodyId; 2]),
    /// The angular velocity of a link in revolutions a minute, from one in radians per this unit of time.
    Rpm(BodyId, TimeUnit),
    /// Angle of a link's axis from +x.
    Angle(BodyId),
    /// Position of a slider along its guide.
    SlidePosition(SliderId),
    /// Coriolis acceleration of a slider, and the body that carries its guide.
    Coriolis(SliderId, BodyId),
    /// A coordinate of a place: axis 0 for x, 1 for y.
    Coordinate(usize, Spot),
    /// Distance of two places.
    Length(Spot, Spot),
    /// The velocity or the acceleration of a place, relative to the second place if there is one.
    Motion(Order, Spot, Option<Spot>),
    /// Normal or tangential part of the acceleration of the first place relative to the second; the link to which both
    /// belong.
    Part(AccelerationPart, Spot, Spot, Option<BodyId>),
    /// A segment of the plan of velocities or of accelerations, by the names of its ends.
    Segment(Order, [String; 2]),
    /// What lies between two corners of a force polygon.
    Corners(Corners),
    /// The place of a pole of the motion.
    Pole(Pole),
    /// The diameter of the inflection circle of a link, by its inflection pole.
    InflectionDiameter(Pole),
    /// The radius of curvature of the path of a place.
    PathRadius(Spot),
    /// What a joint carries or a drive needs, in this mechanism.
    Force(ForceOf, Arc<Compiled>),
}

/// A pole of the motion: a point that the motion of links makes, and no joint has to.
#[derive(Clone, Debug)]
pub struct Pole {
    /// Its name, as in `P(1,3)`.
    pub name: String,
    /// What it is.
    pub of: PoleOf,
    /// A point of the mechanism, from which it is found.
    pub near: PointId,
    /// Of wheels that mesh, and of a wheel and a rack: how they roll on each other.
    pub rolling: Option<Rolling>,
    /// How many points the mechanism has.
    pub points: usize,
}

/// What a pole of the motion is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PoleOf {
    /// The instant centre of two links, and what joints say of it.
    Center(LinkPair, Option<Permanent>),
    /// The inflection pole of a link's motion against the frame.
    Inflection(BodyId),
    /// The pole of accelerations of that motion.
    Acceleration(BodyId),
}

/// Normal or tangential part of an acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationPart {
    /// Along the line to the other place.
    Normal,
    /// Across that line.
    Tangential,
}

/// A named place of a body.
#[derive(Clone, Debug)]
pub enum Spot {
    /// The place of this point, as a place of this body, and the name as written.
    Point(BodyId, PointId, String),
    /// A special point by its name.
    Special(String),
    /// A pole of the motion: only lengths are measured to it.
    Pole(Pole),
}

impl Spot {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Spot::Point(_, _, name) | Spot::Special(name) | Spot::Pole(Pole { name, .. }) => name,
        }
    }
}

impl QuantityRequest {
    /// The quantity of that name. Plan points are looked up only when it is evaluated.
    ///
    /// # Errors
    /// [`QuantityError::Form`] and [`QuantityError::Unknown`].
    pub fn new(name: &str, mechanism: &Mechanism) -> Result<QuantityRequest, QuantityError> {
        let finder = Finder { name, mechanism };
        let written = QuantityName::parse(name).ok_or_else(|| finder.form())?;
        let what = finder.what(&written)?;
        // White space is a space: tables and results have the name on one line.
        let name: String = name.chars().map(|c| if c.is_whitespace() { ' ' } else { c }).collect();
        let needs_accelerations = written.needs_accelerations();
        let asked = QuantityRequest { name, written, what, needs_accelerations };
        let has_component = match asked.written.component {
            None => true,
            // A place has no size, and a direction only at infinity, where a centre may lie.
            Some(Component::Size) if asked.is_place() => false,
            Some(Component::Angle) if asked.is_place() => matches!(asked.written.head, Head::Center),
            // A segment's length stands without a component.
            Some(Component::Angle) => {
                asked.is_of_vectors() || matches!(asked.what, What::Segment(..) | What::Corners(_))
            }
            // Plans have poles, from which a point has coordinates; polygons have corners.
            Some(Component::X | Component::Y) if matches!(asked.what, What::Corners(_)) => true,
            Some(_) => asked.is_of_vectors(),
        };
        if !has_component {
            return Err(finder.form());
        }
        Ok(asked)
    }

    /// Refuses a place where one number is needed: of a vector its size would be taken.
    pub(crate) fn check_size(&self) -> Result<(), QuantityError> {
        if self.is_place() && self.written.component.is_none() {
            return Err(QuantityError::NoSize(self.name.clone()));
        }
        Ok(())
    }

    /// Its name as it was asked for.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

/// Looks up the parts of a quantity's name in a mechanism.
pub(super) struct Finder<'a> {
    pub name: &'a str,
    pub mechanism: &'a Mechanism,
}

impl Finder<'_> {
    pub(super) fn form(&self) -> QuantityError {
        QuantityError::Form(shown(self.name))
    }

    fn what(&self, QuantityName { head, arguments, on_paper, .. }: &QuantityName) -> Result<What, QuantityError> {
        let (first, second) = (arguments.first().map_or("", String::as_str), arguments.get(1).map(String::as_str));
        let motion =
            |order| Ok(What::Motion(order, self.spot(first)?, second.map(|name| self.spot(name)).transpose()?));
        let both = || Ok([first, second.ok_or_else(|| self.form())?]);
        let turning = |order| {
            Ok(match second {
                None => What::Rate(Rate::Angular(order, self.link(first)?)),
                Some(second) => What::RelativeRate(order, [self.link(first)?, self.link(second)?]),
            })
        };
        Ok(match *head {
            Head::Omega => return turning(Order::Velocity),
            Head::Alpha => return turning(Order::Acceleration),
            Head::SpeedRatio => {
                let [own, other] = both()?;
                What::SpeedRatio([self.link(own)?, self.link(other)?])
            }
            Head::Rpm => What::Rpm(self.link(first)?, self.mechanism.time),
            Head::Angle => What::Angle(self.link(first)?),
            Head::SlidePosition => What::SlidePosition(self.slider(first)?),
            Head::SlideVelocity => What::Rate(Rate::Slide(Order::Velocity, self.slider(first)?)),
            Head::SlideAcceleration => What::Rate(Rate::Slide(Order::Acceleration, self.slider(first)?)),
            Head::Coriolis => {
                let id = self.slider(first)?;
                What::Coriolis(id, self.mechanism.slider(id).on)
            }
            Head::X => What::Coordinate(0, self.spot(first)?),
            Head::Y => What::Coordinate(1, self.spot(first)?),
            Head::Velocity => return motion(Order::Velocity),
            Head::Acceleration => return motion(Order::Acceleration),
            Head::Normal | Head::Tangential => {
                let part = if *head == Head::Normal { AccelerationPart::Normal } else { AccelerationPart::Tangential };
                let [a, b] = both()?;
                let (a, b) = (self.spot(a)?, self.spot(b)?);
                let link = self.common_link(&a, &b);
                What::Part(part, a, b, link)
            }
            Head::Between(sheet) => match sheet.order() {
                Some(order) => What::Segment(order, both()?.map(str::to_owned)),
                None if sheet == Sheet::Forces => What::Corners(Corners::new(both()?.map(str::to_owned))),
                // Only segments of plans are known in millimetres of paper.
                None if sheet == Sheet::Scheme && !on_paper => {
                    let [from, to] = both()?;
                    What::Length(self.spot_or_pole(from)?, self.spot_or_pole(to)?)
                }
                None => return Err(self.form()),
            },
            Head::Center | Head::InflectionPole | Head::AccelerationPole => {
                What::Pole(self.pole(self.name, *head, arguments)?)
            }
            Head::InflectionDiameter => {
                What::InflectionDiameter(self.pole(self.name, Head::InflectionPole, arguments)?)
            }
            Head::PathRadius => What::PathRadius(self.spot(first)?),
            Head::Reaction
            | Head::ReactionAlong
            | Head::ReactionAcross
            | Head::GuideForce
            | Head::GuideCouple
            | Head::GuideOffset
            | Head::Torque
            | Head::Push
            | Head::InertiaForce
            | Head::InertiaCouple
            | Head::FrictionForce
            | Head::FrictionCouple
            | Head::CenterAcceleration
            | Head::LoadMoment
            | Head::Arm
            | Head::Load
            | Head::Power
            | Head::Shaking
            | Head::ShakingMoment => {
                What::Force(self.force(*head, arguments)?, Arc::new(Compiled::new(self.mechanism)))
            }
        })
    }

    pub(super) fn link(&self, name: &str) -> Result<BodyId, QuantityError> {
        let links = || self.mechanism.links().map(|(_, b)| b.name.as_str());
        let found = self.mechanism.link(name);
        found.ok_or_else(|| unknown(self.name, Part::Link, name, links()))
    }

    /// A link of a name, but not the frame, which has no poles.
    fn moving_link(&self, name: &str) -> Result<BodyId, QuantityError> {
        self.link(name).and_then(|link| if link == GROUND { Err(self.form()) } else { Ok(link) })
    }

    /// The pole of that name, whose parts are these.
    fn pole(&self, name: &str, head: Head, arguments: &[String]) -> Result<Pole, QuantityError> {
        let first = arguments.first().map_or("", String::as_str);
        let (of, link) = match (head, arguments) {
            (Head::Center, [a, b]) => {
                let [a, b] = [self.link(a)?, self.link(b)?];
                let pair = LinkPair::new(a, b).ok_or_else(|| self.form())?;
                (PoleOf::Center(pair, Permanent::of(pair, self.mechanism)), pair.links()[0])
            }
            (Head::InflectionPole, _) => self.moving_link(first).map(|link| (PoleOf::Inflection(link), link))?,
            (Head::AccelerationPole, _) => self.moving_link(first).map(|link| (PoleOf::Acceleration(link), link))?,
            _ => return Err(self.form()),
        };
        let near = self.mechanism.body(link).points.first().copied().unwrap_or(PointId(0));
        let rolling = match of {
            PoleOf::Center(_, Some(Permanent::Mesh(mesh))) => self.mechanism.joint(mesh).rolling(),
            _ => None,
        };
        Ok(Pole { name: name.to_owned(), of, near, rolling, points: self.mechanism.points.len() })
    }

    /// The place of a name, which may be a pole.
    fn spot_or_pole(&self, name: &str) -> Result<Spot, QuantityError> {
        match QuantityName::parse(name).filter(QuantityName::is_plain) {
            Some(pole) => self.pole(name, pole.head, &pole.arguments).map(Spot::Pole),
            None => self.spot(name),
        }
    }

    pub(super) fn slider(&self, name: &str) -> Result<SliderId, QuantityError> {
        self.mechanism.slider_named(name).ok_or_else(|| {
            let names: Vec<String> = self.mechanism.slider_ids().map(|id| self.mechanism.slider_name(id)).collect();
            unknown(self.name, Part::Slider, name, names.iter().map(String::as_str))
        })
    }

    /// The names of special points, each with the link to which it belongs.
    fn special(&self) -> impl Iterator<Item = (&str, BodyId)> {
        let points = self.mechanism.groups.iter().flat_map(|g| &g.special);
        points.filter(|s| s.target.is_none()).map(|s| (s.name.as_str(), s.link))
    }

    /// The place of a name: a joint, a special point, or, as `D_2`, the point of link 2 that coincides with D.
    pub(super) fn spot(&self, name: &str) -> Result<Spot, QuantityError> {
        if self.special().any(|(special, _)| special == name) {
            return Ok(Spot::Special(name.to_owned()));
        }
        if let Some(point) = self.mechanism.point(name) {
            let mut bodies = self.mechanism.bodies.iter().enumerate();
            let body = bodies.find(|(_, b)| b.points.contains(&point));
            let body = body.map_or(BodyId(0), |(i, _)| BodyId(i));
            return Ok(Spot::Point(body, point, name.to_owned()));
        }
        if let Some((point, body)) = name.split_once('_') {
            let under = self.mechanism.point(point).zip(self.mechanism.link(body));
            if let Some((point, body)) = under {
                return Ok(Spot::Point(body, point, name.to_owned()));
            }
        }
        let points = self.mechanism.points.iter().map(String::as_str);
        let known = points.chain(self.special().map(|(name, _)| name));
        Err(unknown(self.name, Part::Point, name, known))
    }

    /// The link to which both places belong; else a link of the first place that driven sliders join to one of the
    /// second.
    fn common_link(&self, a: &Spot, b: &Spot) -> Option<BodyId> {
        let holds = |link: BodyId, spot: &Spot| match spot {
            Spot::Special(name) => self.special().any(|s| s == (name.as_str(), link)),
            Spot::Pole(_) => false,
            Spot::Point(body, point, _) => *body == link || self.mechanism.body(link).points.contains(point),
        };
        let links = || self.mechanism.links().map(|(id, _)| id);
        let is_joined = |link: BodyId| {
            let root = self.mechanism.root(link);
            links().any(|other| self.mechanism.root(other) == root && holds(other, b))
        };
        let holds_first = |link: &BodyId| holds(*link, a);
        let common = links().filter(holds_first).find(|&link| holds(link, b));
        common.or_else(|| links().filter(holds_first).find(|&link| is_joined(link)))
    }
}
