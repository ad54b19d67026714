//! What a quantity's name asks for: the word before its parenthesis, what stands between, and of what kind the value is. One table says
//! all three.

use self::Argument::{Link, Load, Point, Slider};
use self::Form::{About, Against, Alone, Both, One, Two};
use crate::sheet::{QuantityKind, Sheet};

/// What a quantity's name asks for: the word before its parenthesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Head {
    /// Angular velocity of a link, or relative to a second one.
    Omega,
    /// Angular acceleration of a link, or relative to a second one.
    Alpha,
    /// The angular velocity of a link over that of a second one.
    SpeedRatio,
    /// Angular velocity of a link in revolutions a minute.
    Rpm,
    /// Angle of a link's axis from +x.
    Angle,
    /// Position of a slider along its guide.
    SlidePosition,
    /// Velocity of a slider along its guide.
    SlideVelocity,
    /// Acceleration of a slider along its guide.
    SlideAcceleration,
    /// Coriolis acceleration of a slider.
    Coriolis,
    /// A point's coordinate along x.
    X,
    /// A point's coordinate along y.
    Y,
    /// Velocity of a point, or relative to a second one.
    Velocity,
    /// Acceleration of a point, or relative to a second one.
    Acceleration,
    /// Normal part of an acceleration relative to a second point.
    Normal,
    /// Tangential part of an acceleration relative to a second point.
    Tangential,
    /// The distance of two points of a sheet: a length of the scheme, a segment of a plan.
    Between(Sheet),
    /// The instant centre of two links.
    Center,
    /// The inflection pole of a link.
    InflectionPole,
    /// The diameter of a link's inflection circle.
    InflectionDiameter,
    /// The pole of accelerations of a link.
    AccelerationPole,
    /// The radius of curvature of a point's path.
    PathRadius,
    /// The force on a link at a pin.
    Reaction,
    /// The force on a sliding link across its guide.
    GuideForce,
    /// The couple on a sliding link from its guide.
    GuideCouple,
    /// The torque of a link's drive.
    Torque,
    /// The force of a slider's drive.
    Push,
    /// The part of the force on a link at a pin along the line of the link's two joints.
    ReactionAlong,
    /// The part across that line.
    ReactionAcross,
    /// How far from the slider's point the line of its guide's force runs.
    GuideOffset,
    /// The inertia force of a link.
    InertiaForce,
    /// The inertia couple of a link.
    InertiaCouple,
    /// The friction on a sliding link along its guide.
    FrictionForce,
    /// The couple of friction on a link at a pin.
    FrictionCouple,
    /// The acceleration of a link's centre of mass.
    CenterAcceleration,
    /// The moment of a load about a point.
    LoadMoment,
    /// The arm of a force about a point, or about the crossing of the lines of two forces.
    Arm,
    /// The force of a load.
    Load,
    /// The power of a load.
    Power,
    /// The shaking force: what the links do to the frame.
    Shaking,
    /// The moment of that about a point.
    ShakingMoment,
}

/// What stands between a name's parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// A link.
    Link,
    /// A slider, as `3/2`.
    Slider,
    /// A point, of the scheme or of a plan.
    Point,
    /// A load, as a force's name, `weight(2)`, `inertia(2)`, a spring's name with its link in parentheses, `friction(3/2)` or `friction(B,2)`.
    Load,
    /// None: the name has no parentheses.
    Nothing,
}

/// What stands between a name's parentheses.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// None: the name has no parentheses.
    Alone,
    /// One, as in `x(D)`.
    One(Argument),
    /// One against the frame, or two, as in `v(A)` and `v(A/B)`.
    Against(Argument),
    /// Always two with a stroke, as in `a_n(A/B)`.
    Both(Argument),
    /// Two with a comma, as in `R(B,2)`.
    Two(Argument, Argument),
    /// Two with a comma, or three: of a force about a point, or about the crossing of the lines of two others.
    About(Argument, Argument),
}

impl Form {
    /// What separates two arguments; `None` where there is one.
    pub(super) fn separator(self) -> Option<&'static str> {
        match self {
            Form::Alone | Form::One(_) => None,
            Form::Against(_) | Form::Both(_) => Some("/"),
            Form::Two(..) | Form::About(..) => Some(","),
        }
    }
}

/// A number of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Its magnitude.
    Size,
    /// Its direction from +x, in degrees.
    Angle,
}

impl Component {
    /// What stands behind a name for each.
    pub(super) const TAILS: [(Component, &'static str); 4] =
        [(Component::X, ".x"), (Component::Y, ".y"), (Component::Size, ".size"), (Component::Angle, ".angle")];

    /// What stands behind a name for it.
    pub(super) fn tail(self) -> &'static str {
        Component::TAILS.into_iter().find(|(own, _)| *own == self).map_or("", |(_, tail)| tail)
    }
}

impl Head {
    /// The heads that are not the distance of two points: the word for each, what stands between its parentheses, and the kind of its value.
    const KNOWN: &'static [(Head, &'static str, Form, QuantityKind)] = &[
        (Head::Omega, "omega", Against(Link), QuantityKind::AngularVelocity),
        (Head::Alpha, "alpha", Against(Link), QuantityKind::AngularAcceleration),
        (Head::SpeedRatio, "i", Two(Link, Link), QuantityKind::SpeedRatio),
        (Head::Rpm, "rpm", One(Link), QuantityKind::RotationalSpeed),
        (Head::Angle, "angle", One(Link), QuantityKind::Angle),
        (Head::SlidePosition, "position", One(Slider), QuantityKind::Position),
        (Head::SlideVelocity, "v_r", One(Slider), QuantityKind::Velocity),
        (Head::SlideAcceleration, "a_r", One(Slider), QuantityKind::Acceleration),
        (Head::Coriolis, "a_c", One(Slider), QuantityKind::Acceleration),
        (Head::X, "x", One(Point), QuantityKind::Position),
        (Head::Y, "y", One(Point), QuantityKind::Position),
        (Head::Velocity, "v", Against(Point), QuantityKind::Velocity),
        (Head::Acceleration, "a", Against(Point), QuantityKind::Acceleration),
        (Head::Normal, "a_n", Both(Point), QuantityKind::Acceleration),
        (Head::Tangential, "a_t", Both(Point), QuantityKind::Acceleration),
        (Head::Center, "P", Two(Link, Link), QuantityKind::Position),
        (Head::InflectionPole, "W", One(Link), QuantityKind::Position),
        (Head::InflectionDiameter, "d_i", One(Link), QuantityKind::Length),
        (Head::AccelerationPole, "G", One(Link), QuantityKind::Position),
        (Head::PathRadius, "rho", One(Point), QuantityKind::Length),
        (Head::Reaction, "R", Two(Point, Link), QuantityKind::Force),
        (Head::GuideForce, "N", One(Slider), QuantityKind::Force),
        (Head::GuideCouple, "M", One(Slider), QuantityKind::Moment),
        (Head::Torque, "T", One(Link), QuantityKind::Moment),
        (Head::Push, "F", One(Slider), QuantityKind::Force),
        (Head::ReactionAlong, "R_n", Two(Point, Link), QuantityKind::Force),
        (Head::ReactionAcross, "R_t", Two(Point, Link), QuantityKind::Force),
        (Head::GuideOffset, "h", One(Slider), QuantityKind::Position),
        (Head::InertiaForce, "F_i", One(Link), QuantityKind::Force),
        (Head::InertiaCouple, "M_i", One(Link), QuantityKind::Moment),
        (Head::FrictionForce, "F_f", One(Slider), QuantityKind::Force),
        (Head::FrictionCouple, "M_f", Two(Point, Link), QuantityKind::Moment),
        (Head::CenterAcceleration, "a_cm", One(Link), QuantityKind::Acceleration),
        (Head::LoadMoment, "moment", Two(Load, Point), QuantityKind::Moment),
        (Head::Arm, "arm", About(Load, Point), QuantityKind::Length),
        (Head::Load, "load", One(Load), QuantityKind::Force),
        (Head::Power, "power", One(Load), QuantityKind::Power),
        (Head::Shaking, "shaking", Alone, QuantityKind::Force),
        (Head::ShakingMoment, "shaking", One(Point), QuantityKind::Moment),
    ];

    /// The head of a word that has arguments behind it, or none.
    pub(super) fn of_word(word: &str, has_arguments: bool) -> Option<Head> {
        let between = || Sheet::ALL.into_iter().find(|sheet| sheet.facts().segment == word).map(Head::Between);
        let is_it = |own: &str, form| own == word && (form != Form::Alone) == has_arguments;
        let known = Head::KNOWN.iter().find(|(_, own, form, _)| is_it(own, *form));
        known.map(|(head, ..)| *head).or_else(|| between().filter(|_| has_arguments))
    }

    /// The word for it, what stands between its parentheses, and the kind of its value.
    fn facts(self) -> (&'static str, Form, QuantityKind) {
        let known = || Head::KNOWN.iter().find(|(head, ..)| *head == self).expect("every other head is listed");
        match self {
            Head::Between(sheet) => (sheet.facts().segment, Two(Point, Point), sheet.facts().drawn),
            _ => (known().1, known().2, known().3),
        }
    }

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        self.facts().0
    }

    pub(super) fn form(self) -> Form {
        self.facts().1
    }

    /// The name of this quantity of a link, a slider or a point.
    #[must_use]
    pub fn of(self, argument: &str) -> String {
        format!("{}({argument})", self.word())
    }

    /// The name of this quantity of two links or points, or of a point and a link.
    #[must_use]
    pub fn of_two(self, first: &str, second: &str) -> String {
        self.of(&[first, second].join(self.form().separator().unwrap_or_default()))
    }

    /// The name of a number of this vector.
    #[must_use]
    pub fn number_of(self, argument: &str, component: Component) -> String {
        self.of(argument) + component.tail()
    }

    /// Whether a name begins with its word and a parenthesis.
    #[must_use]
    pub fn begins(self, name: &str) -> bool {
        name.strip_prefix(self.word()).is_some_and(|rest| rest.starts_with('('))
    }

    /// What its argument of this index is.
    #[must_use]
    pub fn argument(self, index: usize) -> Argument {
        match self.form() {
            Form::Alone => Argument::Nothing,
            Form::Two(_, second) | Form::About(_, second) if index == 1 => second,
            Form::One(first)
            | Form::Against(first)
            | Form::Both(first)
            | Form::Two(first, _)
            | Form::About(first, _) => first,
        }
    }

    /// The kind of its value; of a vector that of its size.
    #[must_use]
    pub fn kind(self) -> QuantityKind {
        self.facts().2
    }

    /// Its arguments, from what stands between a name's parentheses; `None` where a second one is missing.
    pub(super) fn split(self, inner: &str) -> Option<Vec<&str>> {
        let form = self.form();
        if let Form::About(..) = form {
            return several_outside(inner, ",").filter(|parts| matches!(parts.len(), 2 | 3));
        }
        match form.separator().and_then(|by| split_outside(inner, by)) {
            Some((first, second)) => Some(vec![first, second]),
            None => matches!(form, Form::One(_) | Form::Against(_)).then(|| vec![inner]),
        }
    }
}

/// Splits at the first separator that stands in no parentheses: `P(2,ground),B` between its two points.
fn split_outside<'t>(inner: &'t str, by: &str) -> Option<(&'t str, &'t str)> {
    let is_outside = |at: &usize| inner[..*at].matches('(').count() == inner[..*at].matches(')').count();
    let at = inner.match_indices(by).map(|(at, _)| at).find(is_outside)?;
    Some((&inner[..at], &inner[at + by.len()..]))
}

/// Splits at all separators that stand in no parentheses: `P,R_n(B,2),R_n(D,4)` into three.
fn several_outside<'t>(inner: &'t str, by: &str) -> Option<Vec<&'t str>> {
    let (mut parts, mut rest) = (Vec::new(), inner);
    while let Some((part, others)) = split_outside(rest, by) {
        parts.push(part);
        rest = others;
    }
    parts.push(rest);
    parts.iter().all(|part| !part.is_empty()).then_some(parts)
}
