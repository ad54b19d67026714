use super::name::normal_name;
use super::state::{Snapshot, State};
use super::step::{Action, PlanKind};
use super::write::Construction;
use crate::geometry::{Point, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use crate::motion::Motion;
use crate::position::Pose;

/// The value of a named quantity, in the scene's units; angles in degrees, rates in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector in the fixed frame.
    Vector(Vector),
}

/// Why a quantity has no value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// The name is not one of the known forms.
    #[error(
        "`{0}` is no quantity; known forms: omega(2) alpha(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) \
         a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3); vectors also with .x .y .size .angle, \
         plan segments with /mu"
    )]
    Form(String),
    /// It names something that this scene does not have.
    #[error("`{quantity}`: there is no {what} `{name}` here{hint}")]
    Unknown {
        /// The whole name.
        quantity: String,
        /// What was looked for.
        what: &'static str,
        /// The name that is missing.
        name: String,
        /// A similar name, in words, or nothing.
        hint: String,
    },
    /// It lies at infinity, or is an acceleration where only velocities were asked for.
    #[error("`{0}` has no value here: {1}")]
    NoValue(String, &'static str),
}

/// The scales of a figure: units of the scene per millimetre of paper; none for a panel that it does not have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// Length per mm.
    pub length: Option<f64>,
    /// Velocity per mm.
    pub velocity: Option<f64>,
    /// Acceleration per mm.
    pub acceleration: Option<f64>,
}

/// The value of the quantity of that name, as in `omega(2)`, `a_n(D/G)` or `vplan(b,s3)/mu`.
///
/// # Errors
/// Says what the name should be, or why there is no value. For many positions look the name up once: [`Asked`].
pub fn quantity(
    name: &str,
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &Motion,
    construction: &Construction,
    scales: Option<&Scales>,
) -> Result<Quantity, QuantityError> {
    let asked = Asked::new(name, mechanism)?;
    asked.value(&Snapshot { pose, motion }, Some(construction), scales)
}

/// Whether a quantity of that name needs accelerations.
#[must_use]
pub fn is_acceleration(name: &str) -> bool {
    let head = name.split('(').next().unwrap_or_default().trim();
    head.starts_with('a') && head != "angle"
}

/// Names of everything that the construction measures, in its order.
#[must_use]
pub fn measured_names(construction: &Construction) -> Vec<String> {
    let lengths = construction.scheme.iter().filter_map(|s| match &s.action {
        Action::MeasureLength { from, to, .. } => Some(format!("L({from},{to})")),
        _ => None,
    });
    let segments = construction.plans().flat_map(|plan| {
        plan.steps.iter().filter_map(move |s| match &s.action {
            Action::Measure { from, to, .. } => Some(plan.kind.segment_name(from, to)),
            _ => None,
        })
    });
    lengths.chain(segments).collect()
}

/// Names of everything that stands in the construction's steps with a value, in their order.
#[must_use]
pub fn step_names(construction: &Construction) -> Vec<String> {
    let mut names = measured_names(construction);
    for plan in construction.plans() {
        for step in &plan.steps {
            match &step.action {
                Action::LayOff(arrow) => names.push(plan.kind.segment_name(&arrow.from, &arrow.to)),
                Action::Cross { point, .. } => {
                    names.push(plan.kind.segment_name(plan.kind.pole(), point));
                }
                Action::Solve { unknowns, .. } => names.extend(unknowns.iter().map(|u| u.0.clone())),
                _ => {}
            }
        }
    }
    names
}

/// A quantity by its name, looked up in a mechanism once.
///
/// `v(A/B)` is the velocity of A minus that of B. `a_n` and `a_t` split the relative acceleration of two points of one
/// link (of links that driven sliders join, without what the sliders add), or of a special point and the outer joint of one of its legs (there along and across the cut line). `x(D)` and `y(D)` are
/// a point's coordinates, `position(3/2)` a slider's. A vector's `.x`, `.y`, `.size` and `.angle` (degrees) are numbers.
#[derive(Clone, Debug)]
pub struct Asked {
    name: String,
    /// Whether it takes accelerations.
    accelerates: bool,
    pub(super) what: What,
    pub(super) component: Option<Component>,
}

/// What a name asks for.
#[derive(Clone, Debug)]
pub enum What {
    /// Angular velocity.
    Omega(BodyId),
    /// Angular acceleration.
    Alpha(BodyId),
    /// Angle of the axis.
    Angle(BodyId),
    /// Position along the guide.
    SlidePosition(SliderId),
    /// Velocity along the guide.
    SlideVelocity(SliderId),
    /// Acceleration along the guide.
    SlideAcceleration(SliderId),
    /// Coriolis acceleration, and the body that carries the guide.
    Coriolis(SliderId, BodyId),
    /// A coordinate: axis 0 or 1.
    Coordinate(usize, Spot),
    /// A distance.
    Length(Spot, Spot),
    /// Velocity, relative to a second place where there is one.
    Velocity(Spot, Option<Spot>),
    /// Acceleration, relative to a second place where there is one.
    Acceleration(Spot, Option<Spot>),
    /// Normal or tangential part of the acceleration of the first, relative to the second; the link to which both belong.
    Part(Normality, Spot, Spot, Option<BodyId>),
    /// A segment of a plan.
    Segment {
        /// Which plan.
        kind: PlanKind,
        /// From this plan point …
        from: String,
        /// … to this one.
        to: String,
        /// Whether it is asked for in millimetres of paper.
        on_paper: bool,
    },
}

/// Which part of an acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normality {
    /// Towards the other place.
    Normal,
    /// Across that.
    Tangential,
}

/// A named place of a body.
#[derive(Clone, Debug)]
pub enum Spot {
    /// Where this point is, as a place of this body.
    Point(BodyId, PointId, String),
    /// A special point by its name.
    Special(String),
}

impl Spot {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Spot::Point(_, _, name) | Spot::Special(name) => name,
        }
    }
}

/// A number of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Its length.
    Size,
    /// Its direction in degrees.
    Angle,
}

impl Asked {
    /// The quantity of that name. Plan points are looked up later, in the construction.
    ///
    /// # Errors
    /// [`QuantityError::Form`] and [`QuantityError::Unknown`].
    pub fn new(name: &str, mechanism: &Mechanism) -> Result<Asked, QuantityError> {
        let compact: String = name.chars().filter(|c| !c.is_whitespace()).collect();
        let finder = Finder { name, mechanism };
        let (head, rest) = compact.split_once('(').ok_or_else(|| finder.form())?;
        let (argument, tail) = rest.rsplit_once(')').ok_or_else(|| finder.form())?;
        let (component, on_paper) = match tail {
            "" => (None, false),
            ".x" => (Some(Component::X), false),
            ".y" => (Some(Component::Y), false),
            ".size" => (Some(Component::Size), false),
            ".angle" => (Some(Component::Angle), false),
            "/mu" if head.ends_with("plan") => (None, true),
            _ => return Err(finder.form()),
        };
        let what = finder.what(head, argument, on_paper)?;
        let asked = Asked { name: name.to_owned(), accelerates: is_acceleration(name), what, component };
        if component.is_some() && !asked.is_of_vectors() {
            return Err(finder.form());
        }
        Ok(asked)
    }

    /// Its name as it was asked for.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What it asks for.
    #[must_use]
    pub fn what(&self) -> &What {
        &self.what
    }

    /// Which number of a vector it asks for, if one.
    #[must_use]
    pub fn component(&self) -> Option<Component> {
        self.component
    }

    /// Whether its value is a vector.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        self.component.is_none() && self.is_of_vectors()
    }

    /// Whether it is a length on paper, in millimetres.
    #[must_use]
    pub fn is_on_paper(&self) -> bool {
        matches!(self.what, What::Segment { on_paper: true, .. })
    }

    fn is_of_vectors(&self) -> bool {
        matches!(self.what, What::Coriolis(..) | What::Velocity(..) | What::Acceleration(..) | What::Part(..))
    }

    /// Whether it can be read without the places and motions of points.
    #[must_use]
    pub fn is_of_links_alone(&self) -> bool {
        matches!(
            self.what,
            What::Omega(_)
                | What::Alpha(_)
                | What::Angle(_)
                | What::Coriolis(..)
                | What::SlidePosition(_)
                | What::SlideVelocity(_)
                | What::SlideAcceleration(_)
        )
    }

    /// Whether special points or plans are needed for it.
    #[must_use]
    pub fn needs_construction(&self) -> bool {
        let special = |spot: &Spot| matches!(spot, Spot::Special(_));
        match &self.what {
            What::Segment { .. } => true,
            What::Coordinate(_, spot) => special(spot),
            What::Length(a, b) | What::Part(_, a, b, _) => special(a) || special(b),
            What::Velocity(a, b) | What::Acceleration(a, b) => special(a) || b.as_ref().is_some_and(special),
            _ => false,
        }
    }

    /// Its value; `scales` only for lengths on paper, `construction` only where [`Self::needs_construction`].
    ///
    /// # Errors
    /// [`QuantityError::NoValue`], and [`QuantityError::Unknown`] for a point that the plan does not have.
    pub fn value(
        &self,
        state: &impl State,
        construction: Option<&Construction>,
        scales: Option<&Scales>,
    ) -> Result<Quantity, QuantityError> {
        use Quantity::{Number, Vector};
        if self.accelerates && !state.has_accelerations() {
            return Err(self.none("accelerations were not asked for"));
        }
        let reader = Reader { asked: self, state, construction };
        let value = match &self.what {
            What::Omega(link) => Number(state.spin(*link)[0]),
            What::Alpha(link) => Number(state.spin(*link)[1]),
            What::Angle(link) => {
                let axis = state.axis(*link);
                Number(degrees_of(axis.ok_or_else(|| self.none("the link has no axis"))?))
            }
            What::SlidePosition(id) => {
                let position = state.slide_position(*id);
                let why = "the guide has no point to count from";
                Number(position.ok_or_else(|| self.none(why))?)
            }
            What::SlideVelocity(id) => Number(state.slide_rates(*id)[0]),
            What::SlideAcceleration(id) => Number(state.slide_rates(*id)[1]),
            What::Coriolis(id, on) => {
                let twice = 2.0 * state.spin(*on)[0] * state.slide_rates(*id)[0];
                Vector(quarter_turn(state.guide(*id)) * twice)
            }
            What::Coordinate(axis, spot) => Number(reader.place(spot)?.1[*axis]),
            What::Length(a, b) => Number((reader.place(b)?.1 - reader.place(a)?.1).norm()),
            What::Velocity(a, b) => Vector(reader.difference(0, a, b.as_ref())?),
            What::Acceleration(a, b) => Vector(reader.difference(1, a, b.as_ref())?),
            What::Part(part, a, b, link) => {
                let [normal, tangential] = reader.parts(a, b, *link)?;
                Vector(match part {
                    Normality::Normal => normal,
                    Normality::Tangential => tangential,
                })
            }
            What::Segment { kind, from, to, on_paper } => {
                Number(reader.segment(*kind, from, to, on_paper.then_some(scales))?)
            }
        };
        Ok(match (value, self.component) {
            (Vector(v), Some(component)) => Number(match component {
                Component::X => v.x,
                Component::Y => v.y,
                Component::Size => v.norm(),
                Component::Angle => degrees_of(v),
            }),
            (value, _) => value,
        })
    }

    fn none(&self, why: &'static str) -> QuantityError {
        QuantityError::NoValue(self.name.clone(), why)
    }
}

fn unknown<'n>(quantity: &str, what: &'static str, name: &str, known: impl Iterator<Item = &'n str>) -> QuantityError {
    let nearest = crate::scene::nearest_within(name, known, 2);
    QuantityError::Unknown {
        quantity: quantity.to_owned(),
        what,
        name: name.to_owned(),
        hint: nearest.map_or_else(String::new, |k| format!("; did you mean `{k}`?")),
    }
}

/// Looks names up in a mechanism.
struct Finder<'a> {
    name: &'a str,
    mechanism: &'a Mechanism,
}

impl Finder<'_> {
    fn form(&self) -> QuantityError {
        QuantityError::Form(self.name.to_owned())
    }

    fn what(&self, head: &str, argument: &str, on_paper: bool) -> Result<What, QuantityError> {
        let pair = |by: char| argument.split_once(by).ok_or_else(|| self.form());
        let relative = || -> Result<(Spot, Option<Spot>), QuantityError> {
            match argument.split_once('/') {
                Some((a, b)) => Ok((self.spot(a)?, Some(self.spot(b)?))),
                None => Ok((self.spot(argument)?, None)),
            }
        };
        Ok(match head {
            "omega" => What::Omega(self.link(argument)?),
            "alpha" => What::Alpha(self.link(argument)?),
            "angle" => What::Angle(self.link(argument)?),
            "position" => What::SlidePosition(self.slider(argument)?),
            "v_r" => What::SlideVelocity(self.slider(argument)?),
            "a_r" => What::SlideAcceleration(self.slider(argument)?),
            "a_c" => {
                let id = self.slider(argument)?;
                What::Coriolis(id, self.mechanism.slider(id).on)
            }
            "x" => What::Coordinate(0, self.spot(argument)?),
            "y" => What::Coordinate(1, self.spot(argument)?),
            "L" => {
                let (a, b) = pair(',')?;
                What::Length(self.spot(a)?, self.spot(b)?)
            }
            "v" => {
                let (a, b) = relative()?;
                What::Velocity(a, b)
            }
            "a" => {
                let (a, b) = relative()?;
                What::Acceleration(a, b)
            }
            "a_n" | "a_t" => {
                let part = match head {
                    "a_n" => Normality::Normal,
                    _ => Normality::Tangential,
                };
                let (a, b) = pair('/')?;
                let (a, b) = (self.spot(a)?, self.spot(b)?);
                let link = self.common_link(&a, &b);
                What::Part(part, a, b, link)
            }
            "vplan" | "aplan" => {
                let kind = match head {
                    "vplan" => PlanKind::Velocity,
                    _ => PlanKind::Acceleration,
                };
                let (from, to) = pair(',')?;
                let (from, to) = (from.to_owned(), to.to_owned());
                What::Segment { kind, from, to, on_paper }
            }
            _ => return Err(self.form()),
        })
    }

    fn link(&self, name: &str) -> Result<BodyId, QuantityError> {
        let links = || self.mechanism.links().map(|(_, b)| b.name.as_str());
        let found = self.mechanism.link(name);
        found.ok_or_else(|| unknown(self.name, "link", name, links()))
    }

    fn slider(&self, name: &str) -> Result<SliderId, QuantityError> {
        let ids = (0..self.mechanism.sliders.len()).map(SliderId);
        let names: Vec<String> = ids.map(|id| self.mechanism.slider_name(id)).collect();
        let found = names.iter().position(|n| n == name).map(SliderId);
        let known = || names.iter().map(String::as_str);
        found.ok_or_else(|| unknown(self.name, "slider", name, known()))
    }

    /// The names of special points, with the links to which they belong.
    fn special(&self) -> impl Iterator<Item = (&str, BodyId)> {
        let points = self.mechanism.groups.iter().flat_map(|g| &g.special);
        points.filter(|s| s.target.is_none()).map(|s| (s.name.as_str(), s.link))
    }

    /// The place that a name means: a joint, a special point, or `D_2`.
    fn spot(&self, name: &str) -> Result<Spot, QuantityError> {
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
        Err(unknown(self.name, "point", name, known))
    }

    /// A link to which both belong, or that of the first where driven sliders join it to one of the second.
    fn common_link(&self, a: &Spot, b: &Spot) -> Option<BodyId> {
        let holds = |link: BodyId, spot: &Spot| match spot {
            Spot::Special(name) => self.special().any(|s| s == (name.as_str(), link)),
            Spot::Point(body, point, _) => *body == link || self.mechanism.body(link).points.contains(point),
        };
        let links = || self.mechanism.links().map(|(id, _)| id);
        let joined = |link: BodyId| {
            let root = self.mechanism.root(link);
            links().any(|other| self.mechanism.root(other) == root && holds(other, b))
        };
        let own = |link: &BodyId| holds(*link, a);
        let common = links().filter(own).find(|&link| holds(link, b));
        common.or_else(|| links().filter(own).find(|&link| joined(link)))
    }
}

/// Reads a quantity from a position.
struct Reader<'a, S: State> {
    asked: &'a Asked,
    state: &'a S,
    construction: Option<&'a Construction>,
}

impl<S: State> Reader<'_, S> {
    fn none(&self, why: &'static str) -> QuantityError {
        self.asked.none(why)
    }

    /// The body to which a named place belongs, and where it is.
    fn place(&self, spot: &Spot) -> Result<(BodyId, Point), QuantityError> {
        match spot {
            Spot::Point(body, point, _) => Ok((*body, self.state.place(*point))),
            Spot::Special(name) => {
                let special = self.construction.and_then(|c| c.special_point(name));
                let special = special.ok_or_else(|| self.none("there is no construction"))?;
                let place = special.place.finite();
                let place = place.ok_or_else(|| self.none("the special point lies at infinity"))?;
                Ok((special.link, place))
            }
        }
    }

    /// Velocity (order 0) or acceleration (order 1) of one place, less that of another.
    fn difference(&self, order: usize, a: &Spot, b: Option<&Spot>) -> Result<Vector, QuantityError> {
        let of = |spot: &Spot| -> Result<Vector, QuantityError> {
            let (body, place) = self.place(spot)?;
            Ok(self.state.motion_at(body, place)[order])
        };
        Ok(of(a)? - b.map_or(Ok(Vector::zeros()), of)?)
    }

    /// Normal and tangential part of the acceleration of `a` relative to `b`.
    fn parts(&self, a: &Spot, b: &Spot, link: Option<BodyId>) -> Result<[Vector; 2], QuantityError> {
        let plan = self.construction.and_then(|c| c.acceleration.as_ref());
        if let (Spot::Special(special), Some(plan)) = (a, plan) {
            let normal = normal_name(b.name(), special);
            let image = super::name::image_name;
            // It starts at the image of `b`, or where driven sliders have led from there.
            let laid = plan.arrows().find(|arrow| arrow.to == normal);
            let parts =
                laid.and_then(|laid| plan.segment(&laid.from, &normal)).zip(plan.segment(&normal, &image(special)));
            if let Some((normal, tangential)) = parts {
                return Ok([normal, tangential]);
            }
        }
        let arm = self.place(a)?.1 - self.place(b)?.1;
        let link = link.ok_or_else(|| self.none("the two points are not on one link"))?;
        let [omega, alpha] = self.state.spin(link);
        Ok([arm * -(omega * omega), quarter_turn(arm) * alpha])
    }

    /// The length of a plan segment; `scales` asks for millimetres of paper.
    fn segment(
        &self,
        kind: PlanKind,
        from: &str,
        to: &str,
        scales: Option<Option<&Scales>>,
    ) -> Result<f64, QuantityError> {
        let construction = self.construction.ok_or_else(|| self.none("there is no construction"))?;
        let mut plans = construction.plans();
        let plan = plans.find(|plan| plan.kind == kind);
        let plan = plan.ok_or_else(|| self.none("there is no such plan"))?;
        for name in [from, to] {
            if !plan.points.contains_key(name) {
                let known = plan.points.keys().map(String::as_str);
                return Err(unknown(&self.asked.name, "plan point", name, known));
            }
        }
        let length = plan.segment(from, to).map_or(0.0, |v| v.norm());
        let Some(scales) = scales else {
            return Ok(length);
        };
        let mu = scales.and_then(|s| match kind {
            PlanKind::Velocity => s.velocity,
            PlanKind::Acceleration => s.acceleration,
        });
        let mu = mu.ok_or_else(|| self.none("the figure has no such plan, so no scale"))?;
        Ok(length / mu)
    }
}
