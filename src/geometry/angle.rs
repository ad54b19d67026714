use super::{Turn, Vector};

/// The unit vector at `degrees` from +x, counter-clockwise; exact at whole quarter turns.
///
/// The whole quarter turns are taken off in degrees, where that is exact, so 90° gives (0, 1) and a
/// large angle loses nothing. Trigonometry is libm's: the same bits on every platform.
#[must_use]
pub fn direction_of_degrees(degrees: f64) -> Vector {
    let quarters = (degrees / 90.0).round();
    let rest = (degrees - 90.0 * quarters).to_radians();
    let (sine, cosine) = (libm::sin(rest), libm::cos(rest));
    match quarters.rem_euclid(4.0) as u8 {
        0 => Vector::new(cosine, sine),
        1 => Vector::new(-sine, cosine),
        2 => Vector::new(-cosine, -sine),
        _ => Vector::new(sine, -cosine),
    }
}

/// The rotation by `degrees`, counter-clockwise.
#[must_use]
pub fn turn_of_degrees(degrees: f64) -> Turn {
    let d = direction_of_degrees(degrees);
    Turn::from_cos_sin_unchecked(d.x, d.y)
}

/// The angle of `v` from +x in degrees, in (−180, 180]; zero for the zero vector.
#[must_use]
pub fn degrees_of(v: Vector) -> f64 {
    let degrees = libm::atan2(v.y, v.x).to_degrees();
    if degrees <= -180.0 { 180.0 } else { degrees }
}
