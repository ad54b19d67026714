use super::name::normal_name;
use super::step::{Action, Plan, PlanKind};
use super::write::Construction;
use crate::geometry::{Point, Vector, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, Mechanism, SliderId};
use crate::motion::{Motion, Order};
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
        "`{0}` is no quantity; known forms: omega(2) alpha(2) angle(2) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) \
         a_c(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3), plan segments also with /mu"
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
/// `v(A/B)` is the velocity of A minus that of B. `a_n` and `a_t` split the relative acceleration of two points of one
/// link, or of a special point and the outer joint of one of its legs (there along and across the cut line).
///
/// # Errors
/// Says what the name should be, or why there is no value.
pub fn quantity(
    name: &str,
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &Motion,
    construction: &Construction,
    scales: Option<&Scales>,
) -> Result<Quantity, QuantityError> {
    let looker = Looker {
        name,
        mechanism,
        pose,
        motion,
        construction,
        scales,
    };
    looker.value()
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
        let head = match plan.kind {
            PlanKind::Velocity => "vplan",
            PlanKind::Acceleration => "aplan",
        };
        plan.steps.iter().filter_map(move |s| match &s.action {
            Action::Measure { from, to, .. } => Some(format!("{head}({from},{to})")),
            _ => None,
        })
    });
    lengths.chain(segments).collect()
}

struct Looker<'a> {
    name: &'a str,
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    construction: &'a Construction,
    scales: Option<&'a Scales>,
}

impl Looker<'_> {
    fn value(&self) -> Result<Quantity, QuantityError> {
        use Quantity::{Number, Vector};
        let form = || QuantityError::Form(self.name.to_owned());
        let compact: String = self.name.chars().filter(|c| !c.is_whitespace()).collect();
        let (head, rest) = compact.split_once('(').ok_or_else(form)?;
        let (argument, tail) = rest.rsplit_once(')').ok_or_else(form)?;
        let on_paper = match tail {
            "" => false,
            "/mu" if head.ends_with("plan") => true,
            _ => return Err(form()),
        };
        if is_acceleration(head) && self.motion.order == Order::Velocity {
            return Err(self.none("accelerations were not asked for"));
        }
        let pair = |by: char| argument.split_once(by).ok_or_else(form);
        match head {
            "omega" => Ok(Number(self.motion.body(self.link(argument)?).omega)),
            "alpha" => Ok(Number(self.motion.body(self.link(argument)?).alpha)),
            "angle" => {
                let axis = self.pose.axes[self.link(argument)?.0];
                let axis = axis.ok_or_else(|| self.none("the link has no axis"))?;
                Ok(Number(degrees_of(axis)))
            }
            "v_r" => Ok(Number(self.motion.slide(self.slider(argument)?).velocity)),
            "a_r" => Ok(Number(
                self.motion.slide(self.slider(argument)?).acceleration,
            )),
            "a_c" => {
                let id = self.slider(argument)?;
                let on = self.mechanism.slider(id).on;
                Ok(Vector(self.motion.coriolis(self.pose, id, on)))
            }
            "L" => {
                let (a, b) = pair(',')?;
                Ok(Number((self.place(b)?.1 - self.place(a)?.1).norm()))
            }
            "v" | "a" => Ok(Vector(match argument.split_once('/') {
                Some((a, b)) => self.absolute(head, a)? - self.absolute(head, b)?,
                None => self.absolute(head, argument)?,
            })),
            "a_n" | "a_t" => {
                let (a, b) = pair('/')?;
                let (normal, tangential) = self.parts(a, b)?;
                Ok(Vector(if head == "a_n" { normal } else { tangential }))
            }
            "vplan" => {
                let mu = on_paper.then_some(self.scales.and_then(|s| s.velocity));
                self.segment(&self.construction.velocity, pair(',')?, mu)
            }
            "aplan" => {
                let plan = self.construction.acceleration.as_ref();
                let plan = plan.ok_or_else(|| self.none("there is no acceleration plan"))?;
                let mu = on_paper.then_some(self.scales.and_then(|s| s.acceleration));
                self.segment(plan, pair(',')?, mu)
            }
            _ => Err(form()),
        }
    }

    fn none(&self, why: &'static str) -> QuantityError {
        QuantityError::NoValue(self.name.to_owned(), why)
    }

    fn unknown<'n>(
        &self,
        what: &'static str,
        name: &str,
        known: impl Iterator<Item = &'n str>,
    ) -> QuantityError {
        let distance =
            |k: &str| strsim::damerau_levenshtein(&k.to_lowercase(), &name.to_lowercase());
        let nearest = known.map(|k| (distance(k), k)).min();
        let hint = nearest.filter(|(d, _)| *d <= 2);
        QuantityError::Unknown {
            quantity: self.name.to_owned(),
            what,
            name: name.to_owned(),
            hint: hint.map_or_else(String::new, |(_, k)| format!("; did you mean `{k}`?")),
        }
    }

    fn link(&self, name: &str) -> Result<BodyId, QuantityError> {
        let links = || self.mechanism.links().map(|(_, b)| b.name.as_str());
        self.mechanism
            .link(name)
            .ok_or_else(|| self.unknown("link", name, links()))
    }

    fn slider(&self, name: &str) -> Result<SliderId, QuantityError> {
        let ids = (0..self.mechanism.sliders.len()).map(SliderId);
        let names: Vec<String> = ids.map(|id| self.mechanism.slider_name(id)).collect();
        let found = names.iter().position(|n| n == name).map(SliderId);
        found.ok_or_else(|| self.unknown("slider", name, names.iter().map(String::as_str)))
    }

    /// The body to which a named point belongs, and its place: a joint, a special point, or `D_2`.
    fn place(&self, name: &str) -> Result<(BodyId, Point), QuantityError> {
        if let Some(special) = self.construction.special_point(name) {
            let place = special.place.finite();
            let place = place.ok_or_else(|| self.none("the special point lies at infinity"))?;
            return Ok((special.link, place));
        }
        if let Some(point) = self.mechanism.point(name) {
            let mut bodies = self.mechanism.bodies.iter().enumerate();
            let body = bodies.find(|(_, b)| b.points.contains(&point));
            let body = body.map_or(BodyId(0), |(i, _)| BodyId(i));
            return Ok((body, self.pose.point(point)));
        }
        if let Some((point, body)) = name.split_once('_') {
            let under = self.mechanism.point(point).zip(self.mechanism.link(body));
            if let Some((point, body)) = under {
                return Ok((body, self.pose.point(point)));
            }
        }
        let points = self.mechanism.points.iter().map(String::as_str);
        let special = self.construction.special.iter().flatten();
        let known = points.chain(special.map(|s| s.name.as_str()));
        Err(self.unknown("point", name, known))
    }

    fn absolute(&self, head: &str, name: &str) -> Result<Vector, QuantityError> {
        let (body, place) = self.place(name)?;
        let motion = self.motion.body(body);
        Ok(match head {
            "v" => motion.velocity_at(place),
            _ => motion.acceleration_at(place),
        })
    }

    /// Normal and tangential part of the acceleration of `a` relative to `b`.
    fn parts(&self, a: &str, b: &str) -> Result<(Vector, Vector), QuantityError> {
        if let (Some(special), Some(plan)) = (
            self.construction.special_point(a),
            &self.construction.acceleration,
        ) {
            let normal = normal_name(b, &special.name);
            let image = super::name::image_name;
            let parts = plan
                .segment(&image(b), &normal)
                .zip(plan.segment(&normal, &image(a)));
            if let Some(parts) = parts {
                return Ok(parts);
            }
        }
        let ((_, to), (_, from)) = (self.place(a)?, self.place(b)?);
        let own = |name: &str| {
            let point = self.mechanism.point(name);
            let special = self.construction.special_point(name).map(|s| s.link);
            self.mechanism.links().filter(move |(id, body)| {
                special == Some(*id) || point.is_some_and(|p| body.points.contains(&p))
            })
        };
        let common = own(a).find(|(id, _)| own(b).any(|(other, _)| other == *id));
        let (link, _) = common.ok_or_else(|| self.none("the two points are not on one link"))?;
        let (body, arm) = (self.motion.body(link), to - from);
        Ok((
            arm * -(body.omega * body.omega),
            quarter_turn(arm) * body.alpha,
        ))
    }

    /// The length of a plan segment; `mu` asks for millimetres of paper.
    fn segment(
        &self,
        plan: &Plan,
        (from, to): (&str, &str),
        mu: Option<Option<f64>>,
    ) -> Result<Quantity, QuantityError> {
        let names = || plan.points.keys().map(String::as_str);
        for name in [from, to] {
            if !plan.points.contains_key(name) {
                return Err(self.unknown("plan point", name, names()));
            }
        }
        let length = plan.segment(from, to).map_or(0.0, |v| v.norm());
        match mu {
            None => Ok(Quantity::Number(length)),
            Some(Some(mu)) => Ok(Quantity::Number(length / mu)),
            Some(None) => Err(self.none("the figure has no such plan, so no scale")),
        }
    }
}
