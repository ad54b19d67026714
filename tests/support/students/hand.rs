//! Hands that err: by how much each elementary act is off.

use super::plane::{DEGREE, Place, along, size};
use crate::random::Random;

/// Of a vector that lies less than 6° off the link nobody can say in which sense it turns it.
const ACROSS: f64 = 0.1;

/// How well somebody draws, measures and computes; errors are uniform between limits.
#[derive(Clone, Copy, Debug)]
pub struct Skill {
    pub name: &'static str,
    /// Limit of the error of a place or a length, in mm of paper.
    pub mm: f64,
    /// Limit of the error of a direction, in degrees.
    pub degrees: f64,
    /// What a ruler is read to, in mm; 0: no rounding.
    pub read_mm: f64,
    /// What a protractor is read to, in degrees; 0: no rounding.
    pub read_degrees: f64,
    /// Limit of the relative error of a computed number.
    pub slip: f64,
    /// Significant digits of computed and written numbers; 0: all.
    pub digits: usize,
}

/// A hand without any error.
pub const RIGHT: Skill =
    Skill { name: "right", mm: 0.0, degrees: 0.0, read_mm: 0.0, read_degrees: 0.0, slip: 0.0, digits: 0 };

/// From a drawing program to somebody who does not care.
pub const SKILLS: [Skill; 6] = [
    Skill { name: "exact, 5 digits", digits: 5, ..RIGHT },
    Skill { name: "±0.2 mm, ±0.2°", mm: 0.2, degrees: 0.2, read_mm: 0.1, digits: 3, ..RIGHT },
    Skill { name: "±0.25 mm, ±0.25°, read to 0.5 mm", mm: 0.25, degrees: 0.25, read_mm: 0.5, digits: 4, ..RIGHT },
    Skill { name: "±0.5 mm, ±0.5°", mm: 0.5, degrees: 0.5, read_mm: 0.5, digits: 3, ..RIGHT },
    Skill { name: "±1 mm, ±1°", mm: 1.0, degrees: 1.0, read_mm: 0.5, digits: 3, ..RIGHT },
    Skill {
        name: "rounded to 0.5 mm, 0.5°, slips of 1 %",
        read_mm: 0.5,
        read_degrees: 0.5,
        slip: 0.01,
        digits: 3,
        ..RIGHT
    },
];

/// Somebody who draws a sheet.
pub struct Hand {
    pub skill: Skill,
    random: Random,
}

impl Hand {
    pub fn new(skill: Skill, seed: u64) -> Hand {
        Hand { skill, random: Random(seed) }
    }

    /// The direction of a line that is drawn in a direction.
    pub fn drawn(&mut self, angle: f64) -> f64 {
        to_marks(angle / DEGREE + self.random.within(self.skill.degrees), self.skill.read_degrees) * DEGREE
    }

    /// The length of a segment that is laid off, in mm.
    pub fn laid_off(&mut self, mm: f64) -> f64 {
        to_marks(mm + self.random.within(self.skill.mm), self.skill.read_mm)
    }

    /// Where a point is marked that lies at a place, in mm.
    pub fn placed(&mut self, place: Place) -> Place {
        let [x, y] = [(); 2].map(|()| self.random.within(self.skill.mm) * std::f64::consts::FRAC_1_SQRT_2);
        place + Place::new(x, y)
    }

    /// The length that is read off a segment, in mm.
    pub fn measured(&mut self, vector: Place) -> f64 {
        self.laid_off(size(vector)).max(0.0)
    }

    /// A number from the pocket calculator.
    pub fn computed(&mut self, number: f64) -> f64 {
        rounded(number * (1.0 + self.random.within(self.skill.slip)), self.skill.digits)
    }

    /// An error of a ratio that is transferred over about 100 mm.
    pub fn stretch(&mut self) -> f64 {
        1.0 + self.random.within(self.skill.mm) / 100.0
    }

    /// +1 where a vector points along a direction, −1 where it points against it; a guess where it lies across.
    pub fn sense(&mut self, vector: Place, towards: f64) -> f64 {
        let part = along(vector, towards);
        match part.abs() < ACROSS * size(vector) {
            true => [1.0, -1.0][self.random.below(2)],
            false => part.signum(),
        }
    }
}

/// To the nearest mark of a scale; 0: as it is.
fn to_marks(value: f64, mark: f64) -> f64 {
    if mark == 0.0 { value } else { libm::round(value / mark) * mark }
}

/// To so many significant digits; 0: as it is.
pub fn rounded(number: f64, digits: usize) -> f64 {
    match digits {
        0 => number,
        _ => format!("{number:.*e}", digits - 1).parse().unwrap_or(number),
    }
}
