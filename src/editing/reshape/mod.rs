//! A joint pulled to another place: lengths, shapes, fixed points and guides change so that all other joints stay where
//! they are in the present position.

mod change;
#[doc(hidden)] // for tests
pub mod held;

use serde::{Deserialize, Serialize};

use super::document::Document;
use super::measure::Decimals;
use super::position::{MOVED, distance, settle};
use super::present::Solved;
use super::says;
use crate::geometry::{Point, span};
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::message::Message;
use crate::position::Pose;
use crate::scene::{Scene, SceneError};
use change::Change;
use held::{Held, allowed};

/// What stays when a joint is pulled.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Pins {
    /// Points that stay where they are.
    pub points: Vec<String>,
    /// Lengths that stay, as `2.BC`: link and length; or a link's angle, as `1.angle`.
    pub lengths: Vec<String>,
}

/// A joint that is being pulled.
///
/// ```
/// use kinegon::editing::{Pins, Reshape};
///
/// let text = include_str!("../../../templates/four-bar.json");
/// let pull = Reshape::new(text, "C", &Pins::default())?;
/// let reshaped = pull.to([150.0, 120.0])?;
/// assert!(reshaped.text.contains(r#""lengths": { "CD": 120.42 }"#), "{}", reshaped.text);
/// # Ok::<(), kinegon::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Reshape {
    text: String,
    before: Solved,
    point: PointId,
    held: Held,
    /// Of the joint's places.
    decimals: Decimals,
}

/// A scene after a pull, in the assembly that it had.
#[derive(Clone, Debug)]
pub struct Reshaped {
    /// Its text.
    pub text: String,
    /// The scene of the text.
    pub scene: Scene,
    /// Its mechanism.
    pub mechanism: Mechanism,
    /// Its position.
    pub pose: Pose,
    /// Why the joint may not be where it was pulled to; `None` where nothing holds it.
    pub note: Option<Message>,
}

/// Numbers of further decimals of lengths that are tried, where rounded ones do not go together.
const FURTHER: [i32; 3] = [1, 3, 6];

/// Largest distance of a point from where it belongs, in parts of the mechanism's size, that is surely rounding.
const ROUNDING: f64 = 0.002;

impl Reshape {
    /// Takes hold of a point of a scene in the position of its text.
    ///
    /// # Errors
    /// The text is no scene, cannot be assembled, or has no such point.
    pub fn new(text: &str, point: &str, pins: &Pins) -> Result<Reshape, SceneError> {
        let before = Solved::of(text)?;
        let Some(id) = before.mechanism.point(point) else {
            return Err(before.scene.error_at(&[], says::no_point(crate::text::shown(point)), None));
        };
        let decimals = Decimals::of_size(span(before.pose.points.iter().copied()));
        let held = Held::new(&before, id, pins);
        Ok(Reshape { text: text.to_owned(), before, point: id, held, decimals })
    }

    /// The scene with the joint at a place of the fixed frame, in units of length; where something holds it, at the
    /// nearest place that it can go to. Places are rounded to a thousandth of the mechanism's size or finer, lengths to a
    /// tenth of that.
    ///
    /// # Errors
    /// There is no such mechanism, as when two joints would be in one place.
    pub fn to(&self, place: [f64; 2]) -> Result<Reshaped, SceneError> {
        let wanted = Point::from(place);
        let now = self.before.pose.point(self.point);
        if !wanted.coords.iter().all(|x| x.is_finite()) {
            return Err(self.before.scene.error_at(&[], says::no_place(), None));
        }
        if self.held.is_fast() {
            return Ok(self.unchanged());
        }
        let allowed = allowed(now, &self.held.rules, wanted);
        let place = if self.held.rules.is_empty() { self.decimals } else { self.decimals.finer(1) }.place(allowed);
        if (place - now).norm() < self.decimals.finer(1).step() {
            return Ok(self.unchanged());
        }
        self.check_apart(place)?;
        let mut failure = None;
        for further in FURTHER {
            match self.with_joint(place, self.decimals.finer(further)) {
                Ok((text, solved)) => return Ok(self.reshaped(text, solved)),
                Err(error) => failure = Some(error),
            }
        }
        Err(failure.unwrap_or_else(|| self.error(says::held_nowhere())))
    }

    fn unchanged(&self) -> Reshaped {
        self.reshaped(self.text.clone(), self.before.clone())
    }

    fn reshaped(&self, text: String, Solved { scene, mechanism, pose }: Solved) -> Reshaped {
        Reshaped { text, scene, mechanism, pose, note: self.held.note.clone() }
    }

    /// Why the joint cannot go where it is pulled.
    fn error(&self, message: Message) -> SceneError {
        self.before.scene.error_at(&["links"], message, Some(says::held_try()))
    }

    /// Refuses a place at another point of one of the joint's links.
    fn check_apart(&self, place: Point) -> Result<(), SceneError> {
        let Solved { mechanism, pose, .. } = &self.before;
        let turns = |link: BodyId| self.held.levers.iter().any(|lever| lever.link == link);
        for (_, body) in mechanism.links().filter(|(id, body)| body.has(self.point) && !turns(*id)) {
            let others = body.points.iter().filter(|point| **point != self.point);
            let near = |point: &&PointId| (pose.point(**point) - place).norm() < self.decimals.step();
            if let Some(other) = others.into_iter().find(near) {
                let [point, other] = [self.point, *other].map(|point| mechanism.point_name(point));
                return Err(self.error(says::in_one_place(&body.name, point, other)));
            }
        }
        Ok(())
    }

    /// The text with the joint at a place, and its solution; lengths have so many decimals.
    fn with_joint(&self, place: Point, decimals: Decimals) -> Result<(String, Solved), SceneError> {
        let mut document = Document::new(&self.text)?;
        let json = document.json();
        let mut wanted = self.before.pose.clone();
        wanted.points[self.point.0] = place;
        self.held.levers.iter().for_each(|lever| lever.turn(&self.before, &mut wanted));
        let mut change = Change {
            solved: &self.before,
            json: &json,
            point: self.point,
            decimals,
            pose: &wanted,
            levers: &self.held.levers,
            values: Vec::new(),
        };
        change.add_all();
        let values = change.values;
        document.set_all(&values)?;
        let text = document.text();
        if let Ok(solved) = Solved::of(&text)
            && distance(&wanted, &solved.pose) <= ROUNDING
        {
            return Ok((text, solved));
        }
        let solved = settle(&mut document, &wanted)?;
        match distance(&wanted, &solved.pose) <= MOVED {
            true => Ok((document.text(), solved)),
            false => Err(self.error(says::held_rounded())),
        }
    }
}
