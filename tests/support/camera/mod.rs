//! A camera for tests: photographs of sheets on a desk, and where each point of the page is in them.
//!
//! It shares nothing with the reader of photographs. In reading order: `page` is what is printed, `pencil` draws on it,
//! `surface` bends it, `lens` says where its points are seen, `desk` and `light` surround it, `take` gives each pixel
//! its light, `develop` is the sensor and its software, `file` the JPEG; `chance` makes pictures of a kind by lot.
//! `letters` and `sketch` are a hand that draws plans, `sheet` a page with markers, `wrong` are pictures of other things.

pub mod chance;
pub mod desk;
pub mod develop;
pub mod drawn;
pub mod file;
pub mod lens;
pub mod letters;
pub mod light;
mod noise;
pub mod page;
pub mod pencil;
pub mod sheet;
pub mod sketch;
pub mod surface;
pub mod take;
pub mod wrong;

use desk::{Desk, Surroundings};
use develop::Sensor;
use file::Storage;
use lens::{Lens, Pose, View};
use light::Light;
use page::Page;
use surface::Shape;
use take::Scene;

/// All that decides about a picture, beside the page itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Photograph {
    pub seed: u64,
    /// Width and height of the upright picture in pixels.
    pub size: [usize; 2],
    /// Width and height of the page in mm.
    pub page_mm: [f64; 2],
    /// What the paper sends back of red, green and blue.
    pub paper: [f32; 3],
    pub shape: Shape,
    pub pose: Pose,
    pub lens: Lens,
    pub desk: Desk,
    pub light: Light,
    pub sensor: Sensor,
    pub storage: Storage,
}

/// A picture, and the truth about it.
pub struct Shot {
    /// The file.
    pub jpeg: Vec<u8>,
    /// Red, green and blue of the upright picture before it became a JPEG, row by row.
    pub pixels: Vec<u8>,
    pub truth: Truth,
}

/// Where the page is in a picture.
pub struct Truth {
    pub view: View,
    covers: Vec<desk::Form>,
    page_mm: [f64; 2],
}

impl Photograph {
    /// The picture as it would be with so many pixels along its longer edge; blur keeps its share of the picture, and noise falls
    /// as pixels grow.
    pub fn with_edge(mut self, pixels: usize) -> Photograph {
        let longer = self.size[0].max(self.size[1]);
        let ratio = pixels as f64 / longer as f64;
        self.size = self.size.map(|n| ((n as f64 * ratio / 2.0).round() as usize) * 2);
        let sensor = &mut self.sensor;
        sensor.defocus *= ratio;
        sensor.motion[0] *= ratio;
        sensor.read_noise *= ratio.min(1.0);
        sensor.shot_noise *= ratio.min(1.0) * ratio.min(1.0);
        self
    }

    pub fn truth(&self) -> Truth {
        let covers = self.desk.things.iter().filter(|thing| thing.is_above).map(|thing| thing.form.clone());
        Truth {
            view: View::new(self.page_mm, &self.shape, &self.pose, &self.lens, self.size),
            covers: covers.collect(),
            page_mm: self.page_mm,
        }
    }

    /// Takes the picture of a page; none: the desk alone.
    pub fn take(&self, page: Option<&Page>) -> Shot {
        let truth = self.truth();
        let around = Surroundings::new(&self.desk, self.seed);
        let scene =
            Scene { view: &truth.view, page, mm: self.page_mm, around: &around, light: &self.light, paper: self.paper };
        let exposure = scene.expose();
        let white = self.light.exposure as f32;
        let pixels = develop::develop(exposure, &self.sensor, self.light.cast, white, self.seed ^ 0x5eed);
        Shot { jpeg: file::jpeg(&pixels, self.size, self.storage), pixels, truth }
    }
}

impl Truth {
    /// Where a point of the page (mm) is in the upright picture; the first pixel's centre is (0.5, 0.5).
    pub fn pixel(&self, mm: [f64; 2]) -> [f64; 2] {
        self.view.pixel(mm)
    }

    /// Whether a point of the page is in the picture and nothing lies on it.
    pub fn sees(&self, mm: [f64; 2]) -> bool {
        let pixel = self.pixel(mm);
        let is_inside = (0..2).all(|i| pixel[i] >= 0.0 && pixel[i] <= self.view.size[i] as f64);
        let on_desk = self.view.desk(pixel).map(|x| x as f32);
        is_inside && self.covers.iter().all(|form| form.distance(on_desk) > 0.2)
    }

    /// Whether all of a square of the page is seen: its corner and its side in mm.
    pub fn sees_square(&self, corner: [f64; 2], side: f64) -> bool {
        let steps = 0..=10;
        steps.clone().all(|i| {
            steps
                .clone()
                .all(|j| self.sees([corner[0] + side * f64::from(i) / 10.0, corner[1] + side * f64::from(j) / 10.0]))
        })
    }

    /// Which of the eight markers are seen wholly.
    pub fn markers(&self) -> [bool; 8] {
        sheet::marker_corners(self.page_mm).map(|corner| self.sees_square(corner, sheet::SIDE))
    }
}
