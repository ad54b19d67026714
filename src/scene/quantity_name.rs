//! The name of a quantity taken apart, as `vplan(b,s3)/mu`: what it asks for, of which links, sliders and points, and of
//! what kind its value is. It is read here and nowhere else; whether the scene has these links and points, `quantity` knows.

use self::Argument::{Link, Load, Point, Slider};
use self::Form::{Against, Alone, Both, One, Two};
use super::units::{ForceUnit, Units};
use crate::sheet::{QuantityKind, Sheet};
use std::fmt;

/// A quantity's name, well formed.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct QuantityName {
    /// What is asked for.
    pub head: Head,
    /// Of what: a link, a slider as `3/2`, or one or two points.
    pub arguments: Vec<String>,
    /// The number of a vector that is asked for, if any.
    pub component: Option<Component>,
    /// Whether it is a length on paper, in millimetres: with `/mu` behind it.
    pub on_paper: bool,
}

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

/// What stands between a name's parentheses, one argument or two.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
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
}

impl Form {
    /// What separates two arguments; `None` where there is one.
    fn separator(self) -> Option<&'static str> {
        match self {
            Form::Alone | Form::One(_) => None,
            Form::Against(_) | Form::Both(_) => Some("/"),
            Form::Two(..) => Some(","),
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
    const TAILS: [(Component, &'static str); 4] =
        [(Component::X, ".x"), (Component::Y, ".y"), (Component::Size, ".size"), (Component::Angle, ".angle")];

    /// What stands behind a name for it.
    fn tail(self) -> &'static str {
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
        (Head::Load, "load", One(Load), QuantityKind::Force),
        (Head::Power, "power", One(Load), QuantityKind::Power),
        (Head::Shaking, "shaking", Alone, QuantityKind::Force),
        (Head::ShakingMoment, "shaking", One(Point), QuantityKind::Moment),
    ];

    /// The head of a word that has arguments behind it, or none.
    fn of_word(word: &str, has_arguments: bool) -> Option<Head> {
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

    fn form(self) -> Form {
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
            Form::Two(_, second) if index == 1 => second,
            Form::One(argument) | Form::Against(argument) | Form::Both(argument) | Form::Two(argument, _) => argument,
        }
    }

    /// The kind of its value; of a vector that of its size.
    #[must_use]
    pub fn kind(self) -> QuantityKind {
        self.facts().2
    }

    /// Its arguments, from what stands between a name's parentheses; `None` where a second one is missing.
    fn split(self, inner: &str) -> Option<Vec<&str>> {
        let form = self.form();
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

impl QuantityName {
    /// Takes a name apart; white space has no meaning in it. `None` if it has none of the known forms.
    #[must_use]
    pub fn parse(name: &str) -> Option<QuantityName> {
        let compact: String = name.chars().filter(|c| !c.is_whitespace()).collect();
        let (head, inner, tail) = match compact.split_once('(') {
            Some((word, rest)) => {
                let (inner, tail) = rest.rsplit_once(')')?;
                (Head::of_word(word, true)?, Some(inner), tail)
            }
            None => {
                let (word, tail) = compact.split_at(compact.find('.').unwrap_or(compact.len()));
                (Head::of_word(word, false)?, None, tail)
            }
        };
        let (component, on_paper) = match tail {
            "" => (None, false),
            "/mu" if matches!(head, Head::Between(_)) => (None, true),
            _ => (Some(Component::TAILS.into_iter().find(|(_, own)| *own == tail)?.0), false),
        };
        let arguments = match inner {
            Some(inner) => head.split(inner)?.into_iter().map(str::to_owned).collect(),
            None => Vec::new(),
        };
        Some(QuantityName { head, arguments, component, on_paper })
    }

    /// The link whose angle the name asks for: `3` for `angle(3)`, written as in the keys of `near`, without spaces.
    #[must_use]
    pub fn link_of_angle(key: &str) -> Option<&str> {
        key.strip_prefix(Head::Angle.word())?.strip_prefix('(')?.strip_suffix(')')
    }

    /// The name of the segment whose direction a name asks for: `vplan(p,b)` for `vplan(p,b).angle`.
    #[must_use]
    pub fn of_direction(name: &str) -> Option<&str> {
        name.strip_suffix(".angle")
    }

    /// The kind of its value; a vector's size and components are of the vector's kind, its angle is an angle.
    #[must_use]
    pub fn kind(&self) -> QuantityKind {
        if self.component == Some(Component::Angle) { QuantityKind::Angle } else { self.head.kind() }
    }

    /// Whether accelerations have to be known for it.
    #[must_use]
    pub fn needs_accelerations(&self) -> bool {
        let is_of_accelerations = match self.head {
            Head::InflectionPole
            | Head::InflectionDiameter
            | Head::AccelerationPole
            | Head::PathRadius
            | Head::GuideOffset => true,
            // Forces hang on inertia.
            _ => matches!(
                self.head.kind(),
                QuantityKind::Acceleration
                    | QuantityKind::AngularAcceleration
                    | QuantityKind::Force
                    | QuantityKind::Moment
                    | QuantityKind::Power
            ),
        };
        is_of_accelerations
            || self.arguments.iter().filter_map(|name| QuantityName::parse(name)).any(|pole| pole.needs_accelerations())
    }

    /// Whether it has neither a component nor `/mu` behind it.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.component.is_none() && !self.on_paper
    }

    /// What stands between its parentheses, as `4` of `omega(4)` and `alpha(4)`.
    #[must_use]
    pub fn subject(&self) -> String {
        self.arguments.join(self.head.form().separator().unwrap_or_default())
    }

    /// What stands behind its parentheses, as `.size` or `/mu`.
    #[must_use]
    pub fn tail(&self) -> &'static str {
        match self.component {
            Some(component) => component.tail(),
            None if self.on_paper => "/mu",
            None => "",
        }
    }

    /// This name with other arguments.
    #[must_use]
    pub fn with_arguments(&self, arguments: Vec<String>) -> QuantityName {
        QuantityName { arguments, ..self.clone() }
    }

    /// This name with its two points in the other order.
    #[must_use]
    pub fn reversed(&self) -> QuantityName {
        self.with_arguments(self.arguments.iter().rev().cloned().collect())
    }

    /// A written name with other arguments and the white space that it had; `None` where `other` has no other argument,
    /// or where it is no name.
    #[must_use]
    pub fn reworded(written: &str, other: impl Fn(Argument, &str) -> Option<String>) -> Option<String> {
        QuantityName::reworded_by(written, &other)
    }

    fn reworded_by(written: &str, other: &dyn Fn(Argument, &str) -> Option<String>) -> Option<String> {
        let head = QuantityName::parse(written)?.head;
        let (before, rest) = written.split_once('(')?;
        let (inner, tail) = rest.rsplit_once(')')?;
        let mut is_other = false;
        let reworded = head.split(inner)?.into_iter().enumerate().map(|(index, part)| {
            let name = part.trim();
            // A pole, as in `L(P(2,ground),B)`, is a name itself.
            let new = match QuantityName::parse(name) {
                Some(_) => QuantityName::reworded_by(name, other),
                None => other(head.argument(index), name),
            };
            is_other |= new.is_some();
            new.map_or_else(|| part.to_owned(), |new| part.replacen(name, &new, 1))
        });
        let inner = reworded.collect::<Vec<_>>().join(head.form().separator().unwrap_or_default());
        is_other.then(|| format!("{before}({inner}){tail}"))
    }
}

impl fmt::Display for QuantityName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.head.form() {
            Form::Alone => write!(f, "{}{}", self.head.word(), self.tail()),
            _ => write!(f, "{}({}){}", self.head.word(), self.subject(), self.tail()),
        }
    }
}

impl QuantityKind {
    /// Its unit, as in `rad/s²`.
    #[must_use]
    pub fn unit(self, units: Units) -> String {
        let (length, time) = (units.length.as_str(), units.time.as_str());
        let force = units.force.map_or("", ForceUnit::as_str);
        match self {
            QuantityKind::Angle => "°".to_owned(),
            QuantityKind::AngularVelocity => format!("rad/{time}"),
            QuantityKind::AngularAcceleration => format!("rad/{time}²"),
            QuantityKind::RotationalSpeed => "rpm".to_owned(),
            QuantityKind::SpeedRatio => String::new(),
            QuantityKind::Position | QuantityKind::Length => length.to_owned(),
            QuantityKind::Velocity => format!("{length}/{time}"),
            QuantityKind::Acceleration => format!("{length}/{time}²"),
            QuantityKind::Force => force.to_owned(),
            QuantityKind::Moment => format!("{force} {length}"),
            QuantityKind::Power => format!("{force} {length}/{time}"),
        }
    }

    /// Whether it is a rate, whose zero means rest; the zero of a place or an angle is arbitrary.
    #[must_use]
    pub fn is_rate(self) -> bool {
        !matches!(self, QuantityKind::Angle | QuantityKind::Position | QuantityKind::Length)
    }
}
