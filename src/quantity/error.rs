//! Why a quantity has no value.

use super::says;
use crate::Problem;
use crate::message::Message;
use crate::text::shown;

/// Why a quantity has no value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.problem().message)]
#[non_exhaustive]
pub enum QuantityError {
    /// The name has none of the known forms.
    Form(String),
    /// The name contains a link, slider or point that this scene does not have.
    Unknown {
        /// The whole name.
        quantity: String,
        /// The kind of what is missing.
        what: Part,
        /// Its name.
        name: String,
        /// A similar name, if there is one.
        nearest: Option<String>,
    },
    /// The quantity lies at infinity, has no zero to count from, or needs what was not computed.
    NoValue(String, Message),
    /// A length on paper has no curve.
    OnPaper(String),
    /// A place has no size, which a curve could show.
    NoSize(String),
}

/// What the name of a quantity has in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Part {
    /// A link.
    Link,
    /// A slider.
    Slider,
    /// A point.
    Point,
    /// A point of a plan.
    PlanPoint,
    /// A load.
    Load,
}

impl QuantityError {
    /// What is wrong, and what to try. A similar name stands in the message, as it belongs to one of its names.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            QuantityError::Form(name) => says::no_quantity(name).into(),
            QuantityError::Unknown { quantity, what, name, nearest } => {
                let message = match what {
                    Part::Link => says::no_link(quantity, name),
                    Part::Slider => says::no_slider(quantity, name),
                    Part::Point => says::no_point(quantity, name),
                    Part::PlanPoint => says::no_plan_point(quantity, name),
                    Part::Load => says::no_load(quantity, name),
                };
                match nearest {
                    Some(near) => says::did_you_mean(message, near).into(),
                    None => message.into(),
                }
            }
            QuantityError::NoValue(name, why) => says::no_value(name, why.clone()).into(),
            QuantityError::OnPaper(name) => {
                Problem::new(says::no_value(name, says::on_paper())).hint(says::without_mu())
            }
            QuantityError::NoSize(name) => says::place_has_no_size(shown(name)).into(),
        }
    }
}

pub(super) fn unknown<'n>(
    quantity: &str,
    what: Part,
    name: &str,
    known: impl Iterator<Item = &'n str>,
) -> QuantityError {
    let nearest = crate::scene::nearest_within(name, known, 2);
    QuantityError::Unknown { quantity: shown(quantity), what, name: shown(name), nearest: nearest.map(str::to_owned) }
}
