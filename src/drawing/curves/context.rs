//! What the sheets of curves share: a range of a motion in words, and axes with round values.

use crate::Problem;
use crate::cycle::{CertainExtreme, Event, Happening, Path, Sampled};
use crate::drawing::compose::{TITLE_LINE, TITLE_SIZE, titled};
use crate::drawing::dims::Dims;
use crate::drawing::held_layout::Pane;
use crate::drawing::lines::Line;
use crate::drawing::says;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{CAPTION, RichText};
use crate::drawing::view::next_of;
use crate::mechanism::{Role, SliderId};
use crate::quantity::{QuantityKind, QuantityRequest};
use crate::scene::Scene;
use crate::sheet::Order;
use crate::text::Untrusted;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::Point;

/// Number of curves in one panel that every style distinguishes.
pub(super) const MOST_CURVES: usize = 12;

/// Reasons why curves do not fit on a sheet.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum CurvesError {
    /// More panels than the sheet holds.
    Panels {
        /// Number of panels needed.
        wanted: usize,
        /// Number of panels that the sheet holds.
        room: usize,
    },
    /// More curves in a panel than can be distinguished.
    Crowd {
        /// Number of curves in the panel.
        wanted: usize,
    },
}

impl CurvesError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            CurvesError::Panels { wanted, room } => {
                Problem::new(says::too_many_panels(*wanted, *room)).hint(says::fewer_or_page())
            }
            CurvesError::Crowd { wanted } => {
                Problem::new(says::too_many_curves(*wanted, MOST_CURVES)).hint(says::fewer_quantities())
            }
        }
    }
}

/// What the sheets of curves ask: a range of a motion with its events, the words for them, and the sheet.
pub(super) struct CurveContext<'a> {
    pub scene: &'a Scene,
    pub dims: Dims,
    pub words: Wording,
    pub path: &'a Path<'a>,
    /// Lowest and highest value of the drive.
    pub range: [f64; 2],
    pub events: &'a [Event],
}

impl<'a> CurveContext<'a> {
    /// On the scene's page, or on a part of a screen.
    pub fn new<T>(
        scene: &'a Scene,
        Sampled { path, range, events, .. }: &'a Sampled<'a, T>,
        pane: Option<Pane>,
    ) -> Self {
        let figure = &scene.figure;
        let dims = pane.map_or_else(|| Dims::of(figure), |pane| Dims::on_pane(pane, figure));
        let words = Wording::of(figure);
        Self { scene, dims, words, path, range: *range, events }
    }

    /// A sheet with its title, where it has one, and, if there is room up to `right`, the rates of the drives.
    pub fn titled(&self, right: f64) -> Drawing {
        let title = self.scene.title.clone().unwrap_or_else(|| self.words.language.curves().into());
        let mut drawing = titled(&self.scene.figure, &self.dims, title.clone());
        let free = right - RichText::verbatim(&title).width(TITLE_SIZE) - self.dims.free.edge - 6.0;
        let speeds = self.speeds();
        if self.dims.has_title() && speeds.width(CAPTION) <= free {
            speeds.caption(&mut drawing, Point::new(right, TITLE_LINE), 1.0);
        }
        drawing
    }

    /// The markup shown for a name.
    pub fn shown(&self, name: &str) -> String {
        let renamed = self.scene.figure.labels.get(name);
        renamed.map_or_else(|| crate::construction::display(name), Untrusted::for_setting)
    }

    /// The symbol of a quantity.
    pub fn symbol(&self, asked: &QuantityRequest) -> String {
        asked.symbol(&self.path.mechanism, &self.words.notation, &|name| self.shown(name))
    }

    /// The vertical lines at marked values of the drive, with their pens.
    pub fn verticals(&self) -> Vec<(Pen, f64)> {
        let events = self.events.iter().filter_map(|event| match event.what {
            Happening::Limit(_) | Happening::Singular(_) | Happening::Leaves { .. } => Some((Pen::Limit, event.at)),
            Happening::Change(_) => Some((Pen::Change, event.at)),
            _ => None,
        });
        let [low, high] = self.range;
        let start = self.path.start();
        let stand = (low..=high).contains(&start).then_some((Pen::Stand, start));
        stand.into_iter().chain(events).collect()
    }

    /// A number with `count` significant digits.
    pub fn number(&self, value: f64, count: usize) -> String {
        self.words.write(value, significant(count))
    }

    /// A value of the drive with its unit.
    pub fn drive_value(&self, value: f64) -> String {
        let unit = if self.path.drive.is_angle { "°" } else { "" };
        format!("{}{unit}", self.number(value, 5))
    }

    /// The name of the drive's axis.
    pub fn drive(&self) -> Line {
        let link = self.shown(&self.path.drive.name);
        let language = self.words.language;
        if self.path.drive.is_angle {
            Line::around(|symbol| language.drive_angle(symbol), RichText::math(&format!("φ_{{{link}}}")))
        } else {
            Line::new(vec![RichText::plain(&language.drive_position(&link, self.scene.units.length.as_str()))])
        }
    }

    /// The rates of the drives.
    fn speeds(&self) -> Line {
        let (mechanism, units) = (&self.path.mechanism, self.scene.units);
        let mut parts: Vec<[String; 2]> = Vec::new();
        let mut add = |symbol: String, value: f64, kind: QuantityKind| {
            let value = format!("= {} {}", self.number(value, 4), kind.unit(units));
            parts.push([symbol, value]);
        };
        for (_, body) in mechanism.links() {
            let name = self.shown(&body.name);
            if let Role::Driver { omega, alpha, .. } = body.role {
                add(format!("ω_{{{name}}}"), omega, QuantityKind::AngularVelocity);
                if alpha != 0.0 {
                    add(format!("α_{{{name}}}"), alpha, QuantityKind::AngularAcceleration);
                }
            }
        }
        for (index, slider) in mechanism.sliders.iter().enumerate() {
            let Some(drive) = slider.drive else { continue };
            let symbol =
                |of| mechanism.push_symbol(of, SliderId(index), &self.words.notation, &|name| self.shown(name));
            add(symbol(Order::Velocity), drive.speed, QuantityKind::Velocity);
            if drive.acceleration != 0.0 {
                add(symbol(Order::Acceleration), drive.acceleration, QuantityKind::Acceleration);
            }
        }
        let count = parts.len();
        let texts = parts.iter().enumerate().flat_map(|(index, [symbol, value])| {
            let comma = if index + 1 < count { "," } else { "" };
            [RichText::math(symbol), RichText::plain(&(value.clone() + comma))]
        });
        Line::new(texts.collect())
    }
}

/// Round steps of angles, in degrees.
const DEGREES: [f64; 17] =
    [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0, 720.0, 1800.0, 3600.0, 7200.0, 18000.0, 36000.0];

/// Tolerance for a round value at an end of the axis, in steps.
const ROUNDING: f64 = 1e-6;

/// An axis with round values.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Values at its ends.
    pub ends: [f64; 2],
    /// Coordinates of its ends on the sheet, in mm along its direction.
    pub places: [f64; 2],
    /// Round values, in rising order.
    pub ticks: Vec<f64>,
    /// Decimal exponent: numbers are shown in units of ten to this power.
    pub power: i32,
    decimals: usize,
    words: Wording,
}

impl Axis {
    /// The axis from `ends[0]` at `places[0]` to `ends[1]` at `places[1]`, with round values at least `apart` mm from
    /// each other.
    pub fn new(words: Wording, ends: [f64; 2], places: [f64; 2], apart: f64, degrees: bool) -> Axis {
        let width = ends[1] - ends[0];
        let least = width * apart / (places[1] - places[0]).abs();
        let of_degrees = DEGREES.into_iter().find(|step| *step >= least);
        let step = match of_degrees {
            Some(step) if degrees && least > 0.5 => step,
            _ => next_of(&[1.0, 2.0, 5.0], least),
        };
        let largest = ends[0].abs().max(ends[1].abs());
        let decade = libm::floor(libm::log10(largest)) as i32;
        let power = if degrees || (-2..5).contains(&decade) { 0 } else { 3 * decade.div_euclid(3) };
        // Rounding of the step must not change the number of decimals.
        let step_decade = libm::floor(libm::log10(step) + 1e-9) as i32 - power;
        let first = (ends[0] / step - ROUNDING).ceil();
        let last = (ends[1] / step + ROUNDING).floor();
        let count = (last - first) as usize;
        Axis {
            ends,
            places,
            ticks: (0..=count).map(|k| (first + k as f64) * step).collect(),
            power,
            decimals: usize::try_from(-step_decade).unwrap_or(0),
            words,
        }
    }

    /// The coordinate of a value, in mm.
    pub fn at(&self, value: f64) -> f64 {
        let share = (value - self.ends[0]) / (self.ends[1] - self.ends[0]);
        self.places[0] + share * (self.places[1] - self.places[0])
    }

    /// The round values as written beside the axis, with their coordinates in mm.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (f64, RichText)> {
        self.ticks.iter().map(|tick| (self.at(*tick), RichText::plain(&self.tick(*tick))))
    }

    /// A round value as written beside the axis.
    pub fn tick(&self, value: f64) -> String {
        let shown = value / libm::exp10(f64::from(self.power));
        self.words.write(shown + 0.0, NumberStyle::decimals(self.decimals).on(Medium::Figure))
    }

    /// A value as written beside its curve, in the axis's unit, with those of four digits that are certain.
    pub fn value(&self, found: &CertainExtreme) -> String {
        let shown = found.value / libm::exp10(f64::from(self.power));
        self.words.write(shown, significant(found.digits(4)))
    }
}

/// Number style of so many digits, without trailing zeros.
pub(super) const fn significant(digits: usize) -> NumberStyle {
    NumberStyle::significant(digits).trimmed().on(Medium::Figure)
}
