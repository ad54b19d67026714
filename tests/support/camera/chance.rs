//! Pictures by lot, of several kinds.

use super::Photograph;
use super::desk::{Desk, Form, Thing, Top};
use super::develop::Sensor;
use super::file::Storage;
use super::lens::{Lens, Pose};
use super::light::{Light, Shadow};
use super::surface::Shape;
use crate::random::Random;
use std::f64::consts::{FRAC_PI_2, PI};

const DEGREE: f64 = PI / 180.0;
/// Sizes of pictures in pixels, held broadwise.
const LARGE: [usize; 2] = [4032, 3024];
const MIDDLE: [usize; 2] = [3264, 2448];
const CHAT: [usize; 2] = [1600, 1200];
const SMALL: [usize; 2] = [1280, 960];

/// What a picture is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Flat paper, seen nearly from above in decent light.
    Flat,
    /// Everything that goes wrong when students take pictures.
    Hard,
    /// As flat, but the paper is bent with a sagitta of 1 mm.
    Curl1,
    Curl3,
    Curl6,
    /// As a messenger sends it: 1600 pixels, much compressed.
    Chat1600,
    /// Out of focus and shaken.
    Blurred,
    /// One to four markers are out of the picture or under something.
    Cropped,
}

/// All kinds.
pub const KINDS: [Kind; 8] =
    [Kind::Flat, Kind::Hard, Kind::Curl1, Kind::Curl3, Kind::Curl6, Kind::Chat1600, Kind::Blurred, Kind::Cropped];

impl Photograph {
    /// A picture of a kind, of a page of this size in mm; the same for the same seed.
    pub fn random(seed: u64, kind: Kind, page_mm: [f64; 2]) -> Photograph {
        let mut random = Random(seed ^ ((kind as u64 + 1) << 40));
        random.next();
        let is_hard = kind == Kind::Hard;
        let mut picture = Photograph {
            seed,
            size: LARGE,
            page_mm,
            paper: paper(&mut random),
            shape: shape(&mut random, kind),
            pose: pose(&mut random, is_hard),
            lens: lens(&mut random, is_hard),
            desk: desk(&mut random, is_hard, page_mm),
            light: light(&mut random, is_hard, page_mm),
            sensor: sensor(&mut random, kind),
            storage: storage(&mut random, kind),
        };
        let size = match (kind, random.below(10)) {
            (Kind::Chat1600, _) | (Kind::Hard, 7 | 8) => CHAT,
            (Kind::Hard, 9) => SMALL,
            (_, 5 | 6) => MIDDLE,
            _ => LARGE,
        };
        picture = picture.with_edge(size[0]);
        // Broadwise or upright, as the sheet lies.
        let lies = libm::fabs(libm::sin(picture.pose.turn)) > 0.7;
        let is_broad = (page_mm[0] > page_mm[1]) != lies;
        let is_odd = is_hard && random.below(8) == 0;
        picture.size = if is_broad == is_odd { [size[1], size[0]] } else { size };
        if kind == Kind::Cropped {
            picture.crop(&mut random);
        }
        picture
    }

    /// Hides one to four markers.
    fn crop(&mut self, random: &mut Random) {
        let (pose, things) = (self.pose, self.desk.things.len());
        for _ in 0..200 {
            self.pose = pose;
            self.desk.things.truncate(things);
            if random.below(2) == 0 {
                self.pose.fill = random.between(0.95, 1.2);
                self.pose.shift = [random.within(1.6), random.within(1.6)];
            } else {
                for _ in 0..=random.below(2) {
                    let from = finger(random, self.page_mm);
                    self.desk.things.extend(from);
                }
            }
            let hidden = self.truth().markers().iter().filter(|seen| !**seen).count();
            if (1..=4).contains(&hidden) {
                return;
            }
        }
        panic!("seed {}: no marker can be hidden", self.seed);
    }
}

fn paper(random: &mut Random) -> [f32; 3] {
    let white = random.between(0.86, 0.97) as f32;
    let yellow = random.between(0.0, 0.09) as f32;
    [white, white * (1.0 - 0.25 * yellow), white * (1.0 - yellow)]
}

fn shape(random: &mut Random, kind: Kind) -> Shape {
    let side = f64::from(random.below(2) as u32) * FRAC_PI_2;
    let axis = if random.below(3) == 0 { random.angle() } else { side + random.within(5.0 * DEGREE) };
    let mut shape = Shape { axis, is_hollow: random.below(2) == 0, ..Shape::default() };
    shape.sagitta = match kind {
        Kind::Curl1 => 1.0,
        Kind::Curl3 => 3.0,
        Kind::Curl6 => 6.0,
        Kind::Hard if random.below(2) == 0 => random.between(0.0, 10.0),
        _ => 0.0,
    };
    if kind == Kind::Hard && random.below(5) == 0 {
        let angle = random.between(1.0, 6.0) * DEGREE;
        shape.crease = Some([random.within(40.0), if random.below(2) == 0 { angle } else { -angle }]);
    }
    if kind == Kind::Hard && random.below(5) == 0 {
        shape.ear = Some((random.below(4), random.between(8.0, 30.0), random.between(5.0, 25.0) * DEGREE));
    }
    shape
}

fn pose(random: &mut Random, is_hard: bool) -> Pose {
    let quarter = if is_hard || random.below(4) == 0 { random.below(4) } else { 0 };
    let off = if is_hard { 12.0 } else { 4.0 };
    let mut turn = quarter as f64 * FRAC_PI_2 + random.within(off * DEGREE);
    if is_hard && random.below(5) == 0 {
        turn = random.angle();
    }
    Pose {
        turn,
        tilt: random.between(0.0, if is_hard { 45.0 } else { 25.0 }) * DEGREE,
        about: random.angle(),
        fill: random.between(if is_hard { 0.5 } else { 0.75 }, 0.95),
        shift: [random.within(0.9), random.within(0.9)],
    }
}

fn lens(random: &mut Random, is_hard: bool) -> Lens {
    let worst = if is_hard { 1.0 } else { 0.5 };
    Lens {
        focal_mm: random.between(24.0, 35.0),
        off_centre: [random.within(0.01), random.within(0.01)],
        radial: [random.within(0.06 * worst), random.within(0.03 * worst)],
        tangential: [random.within(0.001 * worst), random.within(0.001 * worst)],
    }
}

fn sensor(random: &mut Random, kind: Kind) -> Sensor {
    let mut sensor = Sensor {
        defocus: random.between(0.5, 1.1),
        motion: [0.0, random.angle()],
        read_noise: random.between(0.001, 0.004),
        shot_noise: random.between(5e-5, 3e-4),
        smear: random.between(0.2, 0.7),
        sharpening: random.between(0.2, 0.9),
        contrast: random.between(0.1, 0.6),
    };
    match kind {
        Kind::Hard => {
            sensor.defocus = random.between(0.4, 3.0);
            if random.below(3) == 0 {
                sensor.motion[0] = random.between(1.0, 8.0);
            }
            sensor.read_noise = random.between(0.001, 0.012);
            sensor.shot_noise = random.between(5e-5, 1.5e-3);
            sensor.smear = random.between(0.0, 1.0);
            sensor.sharpening = random.between(0.0, 1.6);
            sensor.contrast = random.between(0.0, 1.0);
        }
        Kind::Blurred => {
            sensor.defocus = random.between(1.5, 3.0);
            sensor.motion[0] = random.between(2.0, 9.0);
        }
        // Scaling down makes edges steep again.
        Kind::Chat1600 => {
            sensor.defocus = random.between(0.8, 1.8);
            sensor.sharpening = random.between(0.2, 0.7);
        }
        _ => {}
    }
    sensor
}

fn storage(random: &mut Random, kind: Kind) -> Storage {
    let [low, high] = match kind {
        Kind::Hard => [30.0, 95.0],
        Kind::Chat1600 => [45.0, 80.0],
        _ => [80.0, 95.0],
    };
    let orientation = match random.below(10) {
        0 => None,
        1..4 => Some(1),
        4..6 => Some(6),
        6 => Some(8),
        7 => Some(3),
        _ => Some(random.below(8) as u8 + 1),
    };
    // Messengers turn the pixels and leave the word out.
    let orientation = if kind == Kind::Chat1600 { None } else { orientation };
    Storage { quality: random.between(low, high) as u8, is_subsampled: random.below(8) != 0, orientation }
}

fn light(random: &mut Random, is_hard: bool, page: [f64; 2]) -> Light {
    let warm = random.within(if is_hard { 0.16 } else { 0.06 }) as f32;
    let green = random.within(0.03) as f32;
    let mut light = Light {
        ratio: random.between(1.1, 1.6),
        from: random.angle(),
        cast: [1.0 + warm, 1.0 + green, 1.0 - warm],
        exposure: random.between(0.7, 1.0),
        vignette: random.between(0.05, 0.25),
        shadows: Vec::new(),
        glare: None,
    };
    if is_hard {
        light.ratio = random.between(1.3, 3.0);
        light.exposure = random.between(0.3, 1.35);
        light.vignette = random.between(0.1, 0.45);
        if random.below(4) == 0 {
            let place = [random.between(0.1, 0.9) * page[0], random.between(0.1, 0.9) * page[1]];
            light.glare = Some((place, random.between(15.0, 60.0), random.between(0.15, 0.7)));
        }
    }
    if random.below(if is_hard { 2 } else { 4 }) == 0 {
        light.shadows.push(shadow(random, is_hard, page));
    }
    light
}

/// The shadow of the telephone, or of the hand that holds it.
fn shadow(random: &mut Random, is_hard: bool, page: [f64; 2]) -> Shadow {
    let middle = [random.between(0.0, 1.0) * page[0], random.between(0.2, 1.2) * page[1]];
    let turn = random.angle();
    let size = random.between(1.0, 1.6);
    let mut forms = vec![Form::Plate { middle, half: [38.0 * size, 75.0 * size], turn }];
    let (sin, cos) = libm::sincos(turn);
    let at = |u: f64, v: f64| [middle[0] + cos * u - sin * v, middle[1] + sin * u + cos * v];
    let side = 38.0 * size;
    forms.push(Form::Rod { ends: [at(side, 30.0), at(side + 120.0, 320.0)], radius: 45.0 });
    for k in 0..4 {
        let v = 25.0 * f64::from(k) - 10.0;
        forms.push(Form::Rod { ends: [at(side - 8.0, v), at(side + 50.0, v + 25.0)], radius: 11.0 });
    }
    Shadow {
        forms,
        soft: random.between(if is_hard { 6.0 } else { 20.0 }, 70.0),
        depth: random.between(0.15, if is_hard { 0.65 } else { 0.4 }),
    }
}

fn desk(random: &mut Random, is_hard: bool, page: [f64; 2]) -> Desk {
    let woods = [[0.42, 0.25, 0.13], [0.55, 0.38, 0.22], [0.20, 0.11, 0.06], [0.62, 0.47, 0.30]];
    let plains = [[0.30, 0.31, 0.33], [0.08, 0.08, 0.09], [0.16, 0.20, 0.26], [0.50, 0.50, 0.48]];
    let light = [[0.72, 0.71, 0.68], [0.80, 0.79, 0.76]];
    let (top, colour) = match random.below(if is_hard { 10 } else { 8 }) {
        0..5 => (Top::Wood, woods[random.below(4)]),
        5 | 6 => (Top::Plain, plains[random.below(4)]),
        7 => (Top::Cloth, plains[random.below(3)]),
        _ => (Top::Plain, light[random.below(2)]),
    };
    let mut things = Vec::new();
    if random.below(if is_hard { 2 } else { 3 }) == 0 {
        things.extend(other_paper(random, page));
    }
    if random.below(2) == 0 {
        things.extend(pen(random, page, false));
    }
    if is_hard && random.below(4) == 0 {
        things.extend(pen(random, page, true));
    }
    if is_hard && random.below(4) == 0 {
        things.extend(finger(random, page));
    }
    Desk { top, colour, grain: random.angle(), things }
}

/// A sheet with lines of writing that sticks out from under the page.
fn other_paper(random: &mut Random, page: [f64; 2]) -> Vec<Thing> {
    let turn = random.within(0.6);
    let angle = random.angle();
    let (sin, cos) = libm::sincos(angle);
    let off = random.between(0.55, 0.95);
    let middle = [page[0] * (0.5 + off * cos), page[1] * (0.5 + off * sin)];
    let white = random.between(0.6, 0.9) as f32;
    let flat = |form, colour| Thing { form, colour, is_above: false, is_round: false };
    let mut things = vec![flat(Form::Plate { middle, half: [105.0, 148.5], turn }, [white, white, white * 0.96])];
    let (sin, cos) = libm::sincos(turn);
    let ink = [0.08, 0.09, 0.25];
    for line in 0..28 {
        let v = -130.0 + 9.3 * f64::from(line);
        let [from, to] = [-85.0, random.between(-40.0, 88.0)];
        let at = |u: f64| [middle[0] + cos * u - sin * v, middle[1] + sin * u + cos * v];
        let mut u = from;
        while u < to {
            let word = random.between(4.0, 18.0);
            things.push(flat(Form::Rod { ends: [at(u), at(u + word)], radius: 0.55 }, ink));
            u += word + 3.0;
        }
    }
    things
}

/// A pen beside or on the sheet.
fn pen(random: &mut Random, page: [f64; 2], is_above: bool) -> Vec<Thing> {
    let angle = random.angle();
    let (sin, cos) = libm::sincos(angle);
    let away = if is_above { 0.5 } else { random.between(0.62, 0.75) };
    let middle = [page[0] * (0.5 + away * cos), page[1] * (0.5 + away * sin)];
    let (sin, cos) = libm::sincos(angle + FRAC_PI_2 + random.within(0.5));
    let at = |u: f64| [middle[0] + cos * u, middle[1] + sin * u];
    let colours = [[0.02, 0.03, 0.2], [0.5, 0.03, 0.03], [0.02, 0.02, 0.02], [0.65, 0.42, 0.03]];
    let rod = |a: f64, b: f64, radius: f64, colour| Thing {
        form: Form::Rod { ends: [at(a), at(b)], radius },
        colour,
        is_above,
        is_round: true,
    };
    let colour = colours[random.below(4)];
    vec![
        rod(66.0, 72.0, 1.2, [0.75, 0.6, 0.42]),
        rod(71.0, 74.5, 0.5, [0.04, 0.04, 0.04]),
        rod(-70.0, 63.0, 3.8, colour),
        rod(-74.0, -70.0, 3.6, [0.6, 0.3, 0.3]),
    ]
}

/// A finger that holds the sheet, from beyond its edge to near a marker.
fn finger(random: &mut Random, page: [f64; 2]) -> Vec<Thing> {
    let side = random.below(4);
    let t = random.between(0.02, 0.98);
    let (edge, out) = match side {
        0 => ([t * page[0], 0.0], [0.0, -1.0]),
        1 => ([page[0], t * page[1]], [1.0, 0.0]),
        2 => ([t * page[0], page[1]], [0.0, 1.0]),
        _ => ([0.0, t * page[1]], [-1.0, 0.0]),
    };
    let lean = random.within(0.5);
    let reach = random.between(8.0, 22.0);
    let (sin, cos) = libm::sincos(lean);
    let way = [out[0] * cos - out[1] * sin, out[0] * sin + out[1] * cos];
    let at = |s: f64| [edge[0] + way[0] * s, edge[1] + way[1] * s];
    let radius = random.between(7.5, 10.0);
    let dark = random.between(0.35, 1.0) as f32;
    let skin = [0.60 * dark, 0.36 * dark, 0.25 * dark];
    let nail = [0.68 * dark, 0.45 * dark, 0.36 * dark];
    let rod = |a: f64, b: f64, radius: f64, colour| Thing {
        form: Form::Rod { ends: [at(a), at(b)], radius },
        colour,
        is_above: true,
        is_round: true,
    };
    vec![
        rod(60.0 - reach, 400.0, 3.2 * radius, skin),
        rod(-reach + radius, 90.0, radius, skin),
        Thing { is_round: false, ..rod(-reach + radius * 0.9, -reach + radius * 1.8, radius * 0.5, nail) },
    ]
}
