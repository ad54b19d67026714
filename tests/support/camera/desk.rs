//! What lies under, beside and on the sheet.

use super::noise::Noise;
use crate::random::Random;

/// A colour as light that is sent back, from 0 to 1 each of red, green and blue; linear.
pub type Colour = [f32; 3];

/// The desk's top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Top {
    Wood,
    Plain,
    Cloth,
}

/// A desk.
#[derive(Clone, Debug, PartialEq)]
pub struct Desk {
    pub top: Top,
    pub colour: Colour,
    /// The direction of the grain, in radians.
    pub grain: f64,
    pub things: Vec<Thing>,
}

/// Something on the desk or on the sheet; places in mm of the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing {
    pub form: Form,
    pub colour: Colour,
    /// It lies on the sheet, and covers it; else under it.
    pub is_above: bool,
    /// Lit as something round.
    pub is_round: bool,
}

/// The outline of a thing.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// All that is nearer to a line than this.
    Rod { ends: [[f64; 2]; 2], radius: f64 },
    /// A rectangle by its middle, half its sides and its direction.
    Plate { middle: [f64; 2], half: [f64; 2], turn: f64 },
}

impl Form {
    /// How far outside of the thing a place is, in mm; inside it is less than 0.
    pub fn distance(&self, [x, y]: [f32; 2]) -> f32 {
        match self {
            Form::Rod { ends: [a, b], radius } => {
                let d = [0, 1].map(|i| (b[i] - a[i]) as f32);
                let p = [x - a[0] as f32, y - a[1] as f32];
                let t = ((p[0] * d[0] + p[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]).max(1e-6)).clamp(0.0, 1.0);
                let off = [p[0] - t * d[0], p[1] - t * d[1]];
                (off[0] * off[0] + off[1] * off[1]).sqrt() - *radius as f32
            }
            Form::Plate { middle, half, turn } => {
                let (sin, cos) = libm::sincosf(*turn as f32);
                let p = [x - middle[0] as f32, y - middle[1] as f32];
                let u = (cos * p[0] + sin * p[1]).abs() - half[0] as f32;
                let v = (cos * p[1] - sin * p[0]).abs() - half[1] as f32;
                let out = [u.max(0.0), v.max(0.0)];
                (out[0] * out[0] + out[1] * out[1]).sqrt() + u.max(v).min(0.0)
            }
        }
    }

    fn size(&self) -> f32 {
        match self {
            Form::Rod { radius, .. } => *radius as f32,
            Form::Plate { half, .. } => half[0].min(half[1]) as f32,
        }
    }
}

impl Thing {
    /// How much of a pixel it covers, at a place and with so many pixels per mm, its brightness there, and the light
    /// that its shadow leaves beside it.
    pub fn seen(&self, place: [f32; 2], per_mm: f32) -> (f32, f32, f32) {
        let distance = self.form.distance(place);
        let covers = (0.5 - distance * per_mm).clamp(0.0, 1.0);
        let light = match self.is_round {
            true => {
                let depth = (-distance / self.form.size()).clamp(0.0, 1.0);
                0.35 + 0.65 * (depth * (2.0 - depth)).sqrt()
            }
            false => 1.0,
        };
        let soft = if self.is_round { 0.6 * self.form.size().min(5.0) } else { 0.8 };
        let is_thick = self.form.size() > 1.0;
        let shade = if is_thick { 1.0 - 0.4 * libm::expf(-distance.max(0.0) / soft) } else { 1.0 };
        (covers, light, shade)
    }
}

/// A desk that can be looked at.
pub struct Surroundings<'a> {
    pub desk: &'a Desk,
    coarse: Noise,
    fine: Noise,
}

impl<'a> Surroundings<'a> {
    pub fn new(desk: &'a Desk, seed: u64) -> Surroundings<'a> {
        let mut random = Random(seed);
        let coarse = Noise::new(&mut random, 3);
        let fine = Noise::new(&mut random, 2);
        Surroundings { desk, coarse, fine }
    }

    /// The brightness of the desk's top at a place in mm, as part of its colour.
    pub fn top(&self, [x, y]: [f32; 2]) -> f32 {
        let (sin, cos) = libm::sincosf(self.desk.grain as f32);
        let (u, v) = (cos * x + sin * y, cos * y - sin * x);
        match self.desk.top {
            Top::Wood => {
                let bend = 6.0 * self.coarse.at(u / 90.0, v / 60.0);
                let rings = self.coarse.at(u / 160.0 + 40.0, (v + bend) / 5.0);
                let veins = self.fine.at(u / 14.0, (v + 0.4 * bend) / 0.7);
                let pores = self.fine.at(u / 5.0 + 90.0, v / 0.25);
                0.62 + 0.36 * rings + 0.18 * veins - if pores > 0.82 { 0.18 } else { 0.0 }
            }
            Top::Plain => 0.93 + 0.08 * self.coarse.at(u / 40.0, v / 40.0) + 0.03 * self.fine.at(u / 0.5, v / 0.5),
            Top::Cloth => {
                let weave = self.fine.at(u / 0.9, v / 3.0) + self.fine.at(u / 3.0 + 17.0, v / 0.9);
                0.5 + 0.5 * weave + 0.2 * self.coarse.at(u / 30.0, v / 30.0)
            }
        }
    }
}
