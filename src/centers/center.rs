use super::poles::Moved;
use crate::geometry::{Ball, Number, Pair, Point, UNIT_ROUNDOFF, Vector, degrees_of, unit};
use crate::motion::BoundedMotion;

/// Where the instant centre of two links lies, as far as it is certain; a point of the plane with those at infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Center {
    /// At a place.
    At {
        /// The place.
        place: Point,
        /// Bound of the error of each coordinate.
        error: f64,
    },
    /// The links turn alike, as far as it is certain: the centre lies at infinity.
    AtInfinity {
        /// The direction in which it lies, of length 1 and to the right, or straight up: normal to the links' relative velocity.
        direction: Vector,
        /// Bound of the error of that direction, in degrees.
        error: f64,
        /// The centre is at least so far away: infinite where joints make the links turn alike, else as far as the bounds of the rates can tell.
        beyond: f64,
    },
    /// The links rest on one another, as far as it is certain, and no joint says where they would turn.
    AtRest,
}

/// The same in numbers that have all digits and bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TrueCenter {
    At(Pair<Ball>),
    AtInfinity { along: Pair<Ball>, beyond: f64 },
    AtRest,
}

impl TrueCenter {
    /// The centre by the motions of both links; `alike` says that joints make them turn alike. `None` where no rate has a bound.
    pub fn of_motions(a: &BoundedMotion, b: &BoundedMotion, alike: bool) -> Option<TrueCenter> {
        let a = a.referred_to(b.at);
        let velocity = b.velocity - a.velocity;
        let omega = if alike { Ball::default() } else { b.omega - a.omega };
        if ![velocity.x, velocity.y, omega].into_iter().all(Ball::is_known) {
            return None;
        }
        if omega.smallest() > 0.0 {
            let place = Moved { velocity, omega, ..Moved::from(b) }.pole();
            return (place.x.is_known() && place.y.is_known()).then_some(TrueCenter::At(place));
        }
        let slowest = velocity.dot(velocity).sqrt().smallest();
        if slowest == 0.0 {
            return Some(TrueCenter::AtRest);
        }
        let beyond = if alike { f64::INFINITY } else { slowest / omega.largest() };
        Some(TrueCenter::AtInfinity { along: velocity.quarter_turn(), beyond })
    }

    /// The direction of a centre at infinity, and the bound of its error in degrees; `None` of the zero vector.
    pub fn direction(along: Pair<Ball>) -> Option<(Vector, f64)> {
        let rounded = along.rounded();
        let direction = to_the_right(rounded)?;
        let along = if rounded.dot(&direction) < 0.0 { -along } else { along };
        // The direction is printed by its components, and as an angle.
        let across = along.cross(Pair::within(direction, 0.0)).largest() / along.dot(along).sqrt().smallest();
        Some((
            direction,
            along.degrees_from(degrees_of(direction)).max(across.to_degrees() * (1.0 + 4.0 * UNIT_ROUNDOFF)),
        ))
    }
}

impl From<&BoundedMotion> for Moved<Ball> {
    fn from(motion: &BoundedMotion) -> Self {
        let &BoundedMotion { at, velocity, acceleration, omega, alpha } = motion;
        Moved { at, velocity, acceleration, omega, alpha }
    }
}

/// The one of both senses of a direction that points to the right, or straight up, of length 1; `None` of the zero vector.
pub(crate) fn to_the_right(along: Vector) -> Option<Vector> {
    let unit = unit(along)?;
    let right = if unit.x < 0.0 || unit.x == 0.0 && unit.y < 0.0 { -unit } else { unit };
    // No zero is negative.
    Some(right + Vector::zeros())
}
