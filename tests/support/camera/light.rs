//! Light on the desk: how much falls where.

use super::desk::Form;

/// The light of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The brightest place of the sheet over the darkest, by the lamp or window alone.
    pub ratio: f64,
    /// The direction on the page from which it comes, in radians.
    pub from: f64,
    /// Colour, as factors of red, green and blue.
    pub cast: [f32; 3],
    /// What a perfectly white place in the brightest part gives, as part of the largest value; more than 1 is lost.
    pub exposure: f64,
    /// Loss at the picture's corners, as part.
    pub vignette: f64,
    pub shadows: Vec<Shadow>,
    /// Shine: place in mm, radius in mm, strength as part of white.
    pub glare: Option<([f64; 2], f64, f64)>,
}

/// A soft shadow.
#[derive(Clone, Debug, PartialEq)]
pub struct Shadow {
    pub forms: Vec<Form>,
    /// The width of its edge in mm.
    pub soft: f64,
    /// The light that it takes, as part.
    pub depth: f64,
}

impl Light {
    /// The light at a place in mm of a page of this size: a factor, and what shine adds.
    pub fn at(&self, place: [f32; 2], page: [f64; 2]) -> (f32, f32) {
        let (sin, cos) = libm::sincosf(self.from as f32);
        let half = [page[0] as f32 / 2.0, page[1] as f32 / 2.0];
        let along = cos * (place[0] - half[0]) + sin * (place[1] - half[1]);
        let reach = (cos * half[0]).abs() + (sin * half[1]).abs();
        // From 0 at the dark end to 1 at the bright one; not quite evenly, as a near lamp does it.
        let t = (0.5 + 0.5 * along / reach).clamp(-0.35, 1.35);
        let dark = 1.0 / self.ratio as f32;
        let mut light = dark + (1.0 - dark) * (0.65 * t + 0.35 * t * t.abs());
        for shadow in &self.shadows {
            let distances = shadow.forms.iter().map(|form| form.distance(place));
            let distance = distances.fold(f32::INFINITY, f32::min);
            let t = (0.5 - distance / shadow.soft as f32).clamp(0.0, 1.0);
            light *= 1.0 - shadow.depth as f32 * t * t * (3.0 - 2.0 * t);
        }
        let shine = self.glare.map_or(0.0, |(middle, radius, strength)| {
            let d = [0, 1].map(|i| (place[i] - middle[i] as f32) / radius as f32);
            strength as f32 * libm::expf(-(d[0] * d[0] + d[1] * d[1]))
        });
        (light.max(0.02), shine)
    }
}
