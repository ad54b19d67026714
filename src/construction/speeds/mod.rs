//! Kutzbach's speed diagram of a train: the velocities along a line of centres, and the angular velocities that follow from them.
//!
//! On the line of the centres of wheels that mesh, the velocities of the points of each wheel, laid off normal to it, end on one straight line,
//! and two wheels that mesh have one such velocity at their pitch point. The steeper the line, the faster the wheel turns: parallels to all of
//! them through one point cut lengths off a base that are in proportion to the angular velocities (K. Kutzbach, *Mehrgliedrige
//! Radgetriebe und ihre Gesetze*, Maschinenbau, 1927). Of velocities along the line of centres nothing is drawn: they are the same for all points.
//! A rack has one velocity, that of its pitch point, and its line is normal to those velocities; a belt gives two rims one speed.
//!
//! What stands on the line and where, also of trains that bend: `line`; in which order its lines follow from one another: `order`; the sentences:
//! `told`.

mod line;
mod order;
mod told;

use super::step::Action;
use super::writer::Writer;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, JointId, PointId};
use crate::scene::Scene;
use crate::sheet::{QuantityKind, Sheet};
use std::f64::consts::TAU;

/// The diagram. Heights are distances along the line of centres from its lowest place, in units of length.
#[derive(Clone, Debug)]
pub struct SpeedDiagram {
    /// The direction in the mechanism that is upwards in the diagram.
    pub along: Vector,
    /// Centres, pitch points and rims with a belt on the line of centres, the lowest first.
    pub spots: Vec<SpeedSpot>,
    /// The wheels, racks and carriers, in the order in which their lines are drawn.
    pub lines: Vec<SpeedLine>,
    /// The pitch circles.
    pub circles: Vec<PitchCircle>,
    /// The pitch lines of racks.
    pub racks: Vec<PitchLine>,
    /// The belts.
    pub belts: Vec<BeltLine>,
    /// The steps in which all that is drawn.
    pub steps: Vec<SpeedStep>,
    /// Centres that lie elsewhere in the mechanism and are turned onto the line.
    pub turned: Vec<PointId>,
    /// Meshes, racks and belts whose centres lie on another line, by the names of where they touch.
    pub left_out: Vec<String>,
    /// What an angular velocity is multiplied by to give turns a minute, where a drive of the scene is given in these.
    pub turns: Option<f64>,
}

/// A centre, a pitch point, or a point of a rim with a belt.
#[derive(Clone, Debug)]
pub struct SpeedSpot {
    /// Which it is.
    pub at: SpotName,
    /// Its name.
    pub name: String,
    /// Its height.
    pub height: f64,
    /// The part of its velocity to the right of the line of centres, which points upwards.
    pub velocity: f64,
}

/// What has a velocity in the diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpotName {
    /// A centre.
    Center(PointId),
    /// The pitch point of a mesh, or of a wheel and its rack.
    Pitch(JointId),
    /// The point of the rim of a belt's first or second wheel.
    Rim(JointId, usize),
}

/// A wheel, a rack or a carrier with the line on which its velocities end.
#[derive(Clone, Debug)]
pub struct SpeedLine {
    /// The link.
    pub link: BodyId,
    /// The spots on it, the lowest first.
    pub spots: Vec<usize>,
    /// The two of them through whose velocities the line is drawn; of what slides one, twice.
    pub through: [usize; 2],
    /// Whether these follow from lines that are there; else its motion is given, or found with that of others.
    pub follows: bool,
    /// Whether it is a rack, or a carriage: it does not turn.
    pub slides: bool,
    /// Its angular velocity.
    pub omega: f64,
}

/// A pitch circle, or the circle of a wheel with a belt.
#[derive(Clone, Copy, Debug)]
pub struct PitchCircle {
    /// The wheel.
    pub link: BodyId,
    /// The height of its centre.
    pub center: f64,
    /// Its radius.
    pub radius: f64,
    /// The height where it touches the other wheel.
    pub touch: f64,
    /// Whether its teeth are inside.
    pub is_ring: bool,
}

/// The pitch line of a rack, normal to the line of centres.
#[derive(Clone, Copy, Debug)]
pub struct PitchLine {
    /// The rack.
    pub link: BodyId,
    /// Its height.
    pub height: f64,
    /// The height of the wheel's centre, and its radius.
    pub wheel: [f64; 2],
}

/// A belt around two wheels.
#[derive(Clone, Copy, Debug)]
pub struct BeltLine {
    /// The heights of the wheels' centres.
    pub centers: [f64; 2],
    /// Their radii.
    pub radii: [f64; 2],
    /// Whether it runs across.
    pub is_crossed: bool,
    /// The points of the rims, which have one velocity.
    pub rims: [usize; 2],
}

/// What is done in a step of the diagram; lines and belts by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedStep {
    /// Draw the line of centres.
    Train,
    /// Draw the line of a link.
    Line(usize),
    /// Take the velocity of one rim of a belt over to the other.
    Belt {
        /// The belt.
        belt: usize,
        /// The spot whose velocity is there.
        from: usize,
        /// The spot that gets it.
        to: usize,
    },
    /// Choose the point through which parallels are drawn.
    Pole,
    /// Draw the parallel to the line of a link.
    Ray(usize),
}

impl Writer<'_> {
    /// Draws the diagram, if there are wheels that mesh, a rack or a belt.
    pub(super) fn speeds(&mut self, scene: &Scene) {
        let Some(mut diagram) = self.speed_diagram() else { return };
        let is_in_turns = scene.links.values().any(|link| link.drive.is_some_and(|drive| drive.rpm.is_some()));
        diagram.turns = is_in_turns.then(|| scene.units.time.in_a_minute() / TAU);
        for &step in &diagram.steps {
            let begun = self.begin(Sheet::Speeds);
            self.finish(begun, Action::Speeds(step));
        }
        self.construction.speeds = Some(diagram);
    }
}

impl SpeedDiagram {
    /// How far circles reach below the lowest spot.
    fn room_below(&self) -> f64 {
        self.circles.iter().map(|circle| circle.radius - circle.center).fold(0.0, f64::max)
    }

    /// The angular velocity of a line in the unit of the diagram.
    #[must_use]
    pub fn rate(&self, line: &SpeedLine) -> f64 {
        line.omega * self.turns.unwrap_or(1.0)
    }

    /// What kind of number that is.
    #[must_use]
    pub fn kind(&self) -> QuantityKind {
        if self.turns.is_some() { QuantityKind::RotationalSpeed } else { QuantityKind::AngularVelocity }
    }
}
