//! Trains: wheels that mesh on one carrier, and how fast each turns against it, in whole numbers of teeth.

use crate::mechanism::{BodyId, Joint, Mechanism};

/// Wheels that mesh, or have a common belt, on one carrier.
///
/// Against the carrier they turn as numbers of teeth say, whatever the carrier does: with ω_c its angular velocity, ω_i − ω_c is `turns` times
/// that of the first wheel (Willis, 1841). So the angular velocity of each is a sum of two motions: all turn with the
/// carrier, and with the carrier held the first wheel turns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Train {
    /// What carries the wheels: an arm, or the frame.
    pub carrier: BodyId,
    /// The wheels, in the order in which meshes lead from one to the next.
    pub wheels: Vec<TrainWheel>,
}

/// A wheel of a train.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TrainWheel {
    /// The wheel; the frame where it is fixed.
    pub body: BodyId,
    /// How often it turns against the carrier while the first wheel turns once, as a fraction in lowest terms whose
    /// denominator is positive.
    pub turns: [i128; 2],
}

impl TrainWheel {
    /// The same as a number.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.turns[0] as f64 / self.turns[1] as f64
    }
}

impl Train {
    /// The trains of a mechanism, in the order of their meshes. A wheel whose fraction has numbers of more than 38 digits is left out.
    #[must_use]
    pub fn all(mechanism: &Mechanism) -> Vec<Train> {
        let mut meshes: Vec<Mesh> = mechanism.joints.iter().filter_map(Mesh::of).collect();
        let mut trains = Vec::new();
        while let Some(first) = meshes.first().copied() {
            let mut train =
                Train { carrier: first.carrier, wheels: vec![TrainWheel { body: first.wheels[0], turns: [1, 1] }] };
            // From wheel to wheel, until no mesh leads on.
            loop {
                let before = meshes.len();
                meshes.retain(|mesh| !train.takes(mesh));
                if meshes.len() == before {
                    break;
                }
            }
            trains.push(train);
        }
        trains
    }

    /// Whether a mesh has a wheel of this train; its other wheel is then one, too.
    fn takes(&mut self, mesh: &Mesh) -> bool {
        let turns = |wheel: BodyId| self.wheels.iter().find(|own| own.body == wheel).map(|own| own.turns);
        let (from, side) = match mesh.wheels.map(turns) {
            _ if mesh.carrier != self.carrier => return false,
            [Some(_), Some(_)] => return true,
            [Some(turns), None] => (turns, 0),
            [None, Some(turns)] => (turns, 1),
            [None, None] => return false,
        };
        let [own, other] = [mesh.teeth[side], mesh.teeth[1 - side]].map(i128::from);
        let turns = from[0].checked_mul(-own).zip(from[1].checked_mul(other));
        let body = mesh.wheels[1 - side];
        self.wheels.extend(turns.map(|(over, under)| TrainWheel { body, turns: lowest(over, under) }));
        true
    }
}

/// Two wheels that turn against their carrier with z₁ Δω₁ + z₂ Δω₂ = 0.
#[derive(Clone, Copy)]
struct Mesh {
    carrier: BodyId,
    wheels: [BodyId; 2],
    teeth: [i32; 2],
}

impl Mesh {
    fn of(joint: &Joint) -> Option<Mesh> {
        let teeth = joint.pitch.map(|pitch| pitch.teeth).or(joint.belt.map(|belt| belt.teeth))?;
        let mut bodies = joint.angular.as_ref()?.terms.iter().map(|(body, _)| *body);
        let carrier = bodies.find(|body| !joint.bodies.contains(body))?;
        Some(Mesh { carrier, wheels: joint.bodies, teeth })
    }
}

/// A fraction in lowest terms with a positive denominator.
fn lowest(over: i128, under: i128) -> [i128; 2] {
    let (mut a, mut b) = (over.unsigned_abs(), under.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let common = i128::try_from(a.max(1)).unwrap_or(1) * under.signum();
    [over / common, under / common]
}
