//! The name of a quantity taken apart, as `vplan(b,s3)/mu`: what it asks for, of which links, sliders and points, and of
//! what kind its value is (`head`). It is read here and nowhere else; whether the scene has these links and points, `quantity` knows.

use super::head::{Argument, Component, Form, Head};
use super::units::{ForceUnit, Units};
use crate::sheet::QuantityKind;
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
            | Head::GuideOffset
            | Head::Arm => true,
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
