use crate::geometry::{Number, Pair};

/// The motion of a body about one of its places, in numbers or in numbers with their bounds: of the place velocity and acceleration,
/// of the body ω and α.
///
/// The poles are found from the place, so that nothing is lost where the origin of coordinates is far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved<T> {
    /// The place.
    pub at: Pair<T>,
    /// Velocity of the body's point there.
    pub velocity: Pair<T>,
    /// Acceleration of that point.
    pub acceleration: Pair<T>,
    /// Angular velocity, counter-clockwise positive, rad per unit of time.
    pub omega: T,
    /// Angular acceleration.
    pub alpha: T,
}

impl<T: Number> Moved<T> {
    /// The pole of velocities, the point without velocity: at + J v / ω, J the quarter turn. Without ω it lies at infinity.
    #[must_use]
    pub fn pole(&self) -> Pair<T> {
        self.at.plus_turned(self.velocity, self.one() / self.omega)
    }

    /// The inflection pole W = P + a_P/ω², a_P the acceleration of the body's point in the pole P; from any place at + (a − v α/ω)/ω².
    ///
    /// The circle over the diameter P W is the inflection circle: the points of the body that pass an inflection of their paths, with acceleration along
    /// their velocity. Without ω there is none. O. Bottema, B. Roth, *Theoretical Kinematics*, North-Holland 1979, chapter VIII.
    #[must_use]
    pub fn inflection_pole(&self) -> Pair<T> {
        self.at + self.inflection_arm()
    }

    fn inflection_arm(&self) -> Pair<T> {
        self.acceleration.minus_scaled(self.velocity, self.alpha / self.omega)
            * (self.one() / (self.omega * self.omega))
    }

    /// The diameter of the inflection circle, |a_P|/ω².
    #[must_use]
    pub fn inflection_diameter(&self) -> T {
        let across = self.inflection_arm().minus_turned(self.velocity, self.one() / self.omega);
        across.dot(across).sqrt()
    }

    /// The pole of accelerations, the point without acceleration: at + (ω² a + α J a)/(α² + ω⁴). Without ω and α it lies at infinity.
    #[must_use]
    pub fn acceleration_pole(&self) -> Pair<T> {
        let square = self.omega * self.omega;
        let scale = self.one() / (self.alpha * self.alpha + square * square);
        let arm = (self.acceleration * square).plus_turned(self.acceleration, self.alpha);
        self.at.plus_scaled(arm, scale)
    }

    /// The radius of curvature of the path of the place, v³/|v × a|: infinite at an inflection.
    #[must_use]
    pub fn path_radius(&self) -> T {
        let square = self.velocity.dot(self.velocity);
        let across = self.velocity.cross(self.acceleration);
        square * square.sqrt() / across.larger(-across)
    }

    fn one(&self) -> T {
        self.omega.one()
    }
}
