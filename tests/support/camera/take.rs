//! The light that reaches each pixel.

use super::desk::{Surroundings, Thing};
use super::lens::View;
use super::light::Light;
use super::page::{Page, Sampler};

/// Between knots the places of the page are taken as even, in pixels.
pub const CELL: usize = 4;
/// Samples along a pixel's edge; the page has at most three pixels on it.
const SAMPLES: usize = 4;
/// So far from a thing its shadow is seen, in mm.
const SHADE: f32 = 12.0;
/// So far outside of the sheet its surface is still followed, in mm.
const NEAR: f64 = 30.0;

/// The light of a picture: brightness for each pixel, colour for each cell.
pub struct Exposure {
    pub size: [usize; 2],
    pub light: Vec<f32>,
    /// Cells in a row, and factors of red, green and blue.
    pub columns: usize,
    pub colours: Vec<[f32; 3]>,
}

/// What is seen at a knot of the grid.
#[derive(Clone, Copy)]
struct Knot {
    desk: [f32; 2],
    /// Of the sheet's surface, where that is near.
    page: Option<[f32; 2]>,
    light: f32,
    shine: f32,
}

/// What the picture is taken of.
pub struct Scene<'a> {
    pub view: &'a View,
    pub page: Option<&'a Page>,
    pub mm: [f64; 2],
    pub around: &'a Surroundings<'a>,
    pub light: &'a Light,
    /// The paper's colour.
    pub paper: [f32; 3],
}

impl Scene<'_> {
    /// Takes the picture.
    pub fn expose(&self) -> Exposure {
        let [width, height] = self.view.size;
        let columns = width.div_ceil(CELL);
        let mut exposure =
            Exposure { size: [width, height], light: vec![0.0; width * height], columns, colours: Vec::new() };
        // One for the whole picture: between two, edges would jump.
        let sampler = self.page.map(|page| page.sampler(self.largest_step()));
        let mut above = self.knots(0, columns);
        for row in 0..height.div_ceil(CELL) {
            let below = self.knots((row + 1) * CELL, columns);
            for column in 0..columns {
                let corners = [above[column], above[column + 1], below[column], below[column + 1]];
                let colour = self.cell(&corners, [column * CELL, row * CELL], sampler, &mut exposure);
                exposure.colours.push(colour);
            }
            above = below;
        }
        exposure
    }

    /// How far the page goes on from a pixel to the next, at most, in mm.
    fn largest_step(&self) -> f64 {
        let steps = (0..81).map(|k| {
            let mm = [k % 9, k / 9].map(|n| f64::from(n) / 8.0);
            let [a, b, c, d] = inverse(self.view, [0, 1].map(|i| mm[i] * self.mm[i]));
            libm::hypot(a, c).max(libm::hypot(b, d))
        });
        steps.fold(0.0, f64::max)
    }

    fn knots(&self, y: usize, columns: usize) -> Vec<Knot> {
        let mut knots = Vec::with_capacity(columns + 1);
        let mut jacobian: Option<[f64; 4]> = None;
        // From the desk's place under a pixel to the sheet's, as at the knot before.
        let mut off = [0.0; 2];
        let [width, height] = self.view.size.map(|n| n as f64);
        for k in 0..=columns {
            let pixel = [(k * CELL) as f64, y as f64];
            let desk = self.view.desk(pixel);
            let is_near = (0..2).all(|i| desk[i] > -NEAR && desk[i] < self.mm[i] + NEAR);
            if !is_near {
                jacobian = None;
            } else if jacobian.is_none() || k % 16 == 0 {
                jacobian = Some(inverse(self.view, desk));
            }
            let first = [desk[0] + off[0], desk[1] + off[1]];
            let page = jacobian.map(|j| followed(self.view, pixel, first, j));
            off = page.map_or([0.0; 2], |page| [page[0] - desk[0], page[1] - desk[1]]);
            let page = page.map(|page| page.map(|x| x as f32));
            let desk = desk.map(|x| x as f32);
            let (light, shine) = self.light.at(page.unwrap_or(desk), self.mm);
            let from_middle = [0, 1].map(|i| pixel[i] / [width, height][i] - 0.5);
            let corner = 2.0 * (from_middle[0] * from_middle[0] + from_middle[1] * from_middle[1]);
            let light = light * (1.0 - self.light.vignette * corner) as f32;
            knots.push(Knot { desk, page, light, shine });
        }
        knots
    }

    /// The pixels of a cell; its colour.
    fn cell(
        &self,
        corners: &[Knot; 4],
        at: [usize; 2],
        sampler: Option<Sampler<'_>>,
        exposure: &mut Exposure,
    ) -> [f32; 3] {
        let [width, height] = exposure.size;
        let step = 1.0 / CELL as f32;
        let places = [corners[0].desk, corners[1].desk, corners[2].desk, corners[3].desk];
        let spread = (places[1][0] - places[0][0]).hypot(places[1][1] - places[0][1]).max(1e-6);
        let per_mm = CELL as f32 / spread;
        let middle = mixed(&places, 0.5, 0.5);
        let near: Vec<&Thing> = self.things_near(middle, 1.5 * spread + SHADE).collect();
        let sheet = self.sheet_corners(corners);
        let is_whole = sheet.is_some_and(|pages| pages.iter().all(|p| self.inside(*p)));
        let sheet = sampler.zip(sheet);
        let needs_desk = !is_whole || !near.is_empty();
        let gap = -self.outside(middle);
        let under = match self.page {
            Some(_) if gap < 0.0 => 1.0 - 0.45 * libm::expf(gap / 2.5),
            Some(_) => 0.55,
            None => 1.0,
        };
        let mut colour = [0.0_f32; 3];
        for y in at[1]..(at[1] + CELL).min(height) {
            let t = (y - at[1]) as f32 * step;
            for x in at[0]..(at[0] + CELL).min(width) {
                let s = (x - at[0]) as f32 * step;
                let (sheet_light, alpha) = match &sheet {
                    Some((sampler, pages)) => self.sheet(*sampler, pages, [s, t], is_whole),
                    None => (0.0, 0.0),
                };
                let mut rgb = self.paper.map(|part| part * sheet_light);
                let place = mixed(&places, s + 0.5 * step, t + 0.5 * step);
                if needs_desk {
                    if alpha < 1.0 {
                        let top = self.around.top(place) * under;
                        let mut back = self.around.desk.colour.map(|part| part * top);
                        cover(&mut back, near.iter().filter(|thing| !thing.is_above), place, per_mm);
                        rgb.iter_mut().zip(back).for_each(|(part, back)| *part += (1.0 - alpha) * back);
                    }
                    cover(&mut rgb, near.iter().filter(|thing| thing.is_above), place, per_mm);
                }
                let [light, shine] = light(corners, s + 0.5 * step, t + 0.5 * step);
                let value = 0.25 * rgb[0] + 0.6 * rgb[1] + 0.15 * rgb[2];
                exposure.light[y * width + x] = value * light + shine;
                colour.iter_mut().zip(rgb).for_each(|(sum, part)| *sum += part);
            }
        }
        let sum = (0.25 * colour[0] + 0.6 * colour[1] + 0.15 * colour[2]).max(1e-6);
        colour.map(|part| part / sum)
    }

    fn things_near(&self, place: [f32; 2], reach: f32) -> impl Iterator<Item = &Thing> {
        self.around.desk.things.iter().filter(move |thing| thing.form.distance(place) < reach)
    }

    /// The corners' places on the page, where the sheet may be seen.
    fn sheet_corners(&self, corners: &[Knot; 4]) -> Option<[[f32; 2]; 4]> {
        self.page?;
        let pages = [corners[0].page?, corners[1].page?, corners[2].page?, corners[3].page?];
        let is_beside = |i: usize| pages.iter().all(|p| p[i] < 0.0) || pages.iter().all(|p| p[i] > self.mm[i] as f32);
        (!is_beside(0) && !is_beside(1)).then_some(pages)
    }

    fn inside(&self, p: [f32; 2]) -> bool {
        (0..2).all(|i| p[i] >= 0.0 && p[i] <= self.mm[i] as f32)
    }

    /// How far a place lies outside of the page, in mm.
    fn outside(&self, p: [f32; 2]) -> f32 {
        let d = [0, 1].map(|i| (-p[i]).max(p[i] - self.mm[i] as f32));
        let out = d.map(|x| x.max(0.0));
        (out[0] * out[0] + out[1] * out[1]).sqrt() + d[0].max(d[1]).min(0.0)
    }

    /// The mean over a pixel's area of what the sheet sends back, and how much of the pixel it takes.
    fn sheet(&self, sampler: Sampler<'_>, pages: &[[f32; 2]; 4], [s, t]: [f32; 2], is_whole: bool) -> (f32, f32) {
        let step = 1.0 / (CELL * SAMPLES) as f32;
        let (mut sum, mut count) = (0.0, 0_u32);
        for j in 0..SAMPLES {
            let t = t + (j as f32 + 0.5) * step;
            for i in 0..SAMPLES {
                let p = mixed(pages, s + (i as f32 + 0.5) * step, t);
                if is_whole || self.inside(p) {
                    sum += sampler.at(p[0], p[1]);
                    count += 1;
                }
            }
        }
        let all = (SAMPLES * SAMPLES) as f32;
        (sum / (255.0 * all), count as f32 / all)
    }
}

/// Between the corners of a cell.
#[inline]
fn mixed(corners: &[[f32; 2]; 4], s: f32, t: f32) -> [f32; 2] {
    let [a, b, c, d] = corners;
    [0, 1].map(|i| {
        let (above, below) = (a[i] + (b[i] - a[i]) * s, c[i] + (d[i] - c[i]) * s);
        above + (below - above) * t
    })
}

fn light(corners: &[Knot; 4], s: f32, t: f32) -> [f32; 2] {
    mixed(&corners.map(|knot| [knot.light, knot.shine]), s, t)
}

/// Lays things over a colour.
fn cover<'a>(rgb: &mut [f32; 3], things: impl Iterator<Item = &'a &'a Thing>, place: [f32; 2], per_mm: f32) {
    for thing in things {
        let (covers, light, shade) = thing.seen(place, per_mm);
        rgb.iter_mut().for_each(|part| *part *= shade);
        rgb.iter_mut().zip(thing.colour).for_each(|(part, own)| *part += covers * (own * light - *part));
    }
}

/// The inverse of how pixels follow places of the page, near one of them: four numbers by rows.
fn inverse(view: &View, mm: [f64; 2]) -> [f64; 4] {
    let step = 0.05;
    let at = view.pixel(mm);
    let right = view.pixel([mm[0] + step, mm[1]]);
    let down = view.pixel([mm[0], mm[1] + step]);
    let [a, c] = [0, 1].map(|i| (right[i] - at[i]) / step);
    let [b, d] = [0, 1].map(|i| (down[i] - at[i]) / step);
    let det = a * d - b * c;
    [d / det, -b / det, -c / det, a / det]
}

/// The place of the page that is seen at a pixel: from a first guess on.
fn followed(view: &View, pixel: [f64; 2], first: [f64; 2], [a, b, c, d]: [f64; 4]) -> [f64; 2] {
    let mut mm = first;
    for _ in 0..12 {
        let at = view.pixel(mm);
        let off = [pixel[0] - at[0], pixel[1] - at[1]];
        if off[0] * off[0] + off[1] * off[1] < 1e-8 {
            break;
        }
        mm = [mm[0] + a * off[0] + b * off[1], mm[1] + c * off[0] + d * off[1]];
    }
    mm
}
