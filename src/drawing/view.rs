use super::grid::Grid;
use super::shape::around;
use crate::geometry;
use kurbo::{Point, Rect, Vec2};

/// Extent of a panel's content in its own units, x right, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Lower left corner.
    pub low: geometry::Point,
    /// Upper right corner.
    pub high: geometry::Point,
}

impl Extent {
    /// The bounding box of some points; the origin for none.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = geometry::Point>) -> Extent {
        let [low, high] = geometry::BoundingBox::of(points).corners.unwrap_or([geometry::Point::origin(); 2]);
        Extent { low, high }
    }

    /// The extent of this content and a place.
    pub(super) fn with(self, place: geometry::Point) -> Extent {
        Extent::of([self.low, self.high, place])
    }

    /// The extent of this content and of those others that are at most so many times as large as half of them are.
    pub(super) fn with_usual(self, times: f64, others: impl Iterator<Item = Extent>) -> Extent {
        let mut others: Vec<Extent> = others.collect();
        let size = |extent: &Extent| extent.size().norm();
        others.sort_by(|a, b| size(a).total_cmp(&size(b)));
        let most = times * others.get(others.len() / 2).map_or(0.0, size);
        self.with_all(others.into_iter().take_while(|other| size(other) <= most))
    }

    /// The extent of this content and all others.
    pub(super) fn with_all(self, others: impl Iterator<Item = Extent>) -> Extent {
        Extent::of(std::iter::once(self).chain(others).flat_map(|e| [e.low, e.high]))
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> geometry::Vector {
        self.high - self.low
    }
}

/// Largest size on a sheet, in mm: far beyond all edges, and near enough that places are not lost in rounding.
const LARGEST: f64 = 1e9;

/// Transformation from mechanism or plan (own units, y up) to the sheet (mm, y down): scale and translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    mu: f64,
    origin: geometry::Point,
    centre: Point,
}

impl View {
    /// Shows the centre of `extent` at the centre of `area`, at `mu` units per millimetre; of what would be larger than
    /// a thousand kilometres all that is seen is how it leaves the area, and so is it at that size.
    #[must_use]
    pub fn new(mu: f64, extent: &Extent, area: Rect) -> View {
        let mu = mu.max(extent.size().norm() / LARGEST);
        View { mu, origin: nalgebra::center(&extent.low, &extent.high), centre: area.center() }
    }

    /// This view, moved as little as possible so that a place is within an area.
    pub(super) fn holding(mut self, place: geometry::Point, area: Rect) -> View {
        let at = self.at(place);
        // Of an area without room its middle.
        let within = |x: f64, low: f64, high: f64| if low < high { x.clamp(low, high) } else { 0.5 * (low + high) };
        let held = Point::new(within(at.x, area.x0, area.x1), within(at.y, area.y0, area.y1));
        self.centre += held - at;
        self
    }

    /// The place on the sheet, in mm.
    #[must_use]
    pub fn at(&self, p: geometry::Point) -> Point {
        self.centre + self.along(p - self.origin)
    }

    /// What is at a place of the sheet, in own units.
    #[must_use]
    pub fn under(&self, at: Point) -> geometry::Point {
        let offset = at - self.centre;
        self.origin + geometry::Vector::new(offset.x * self.mu, -offset.y * self.mu)
    }

    /// Units per millimetre.
    #[must_use]
    pub fn mu(&self) -> f64 {
        self.mu
    }

    /// A displacement on the sheet, in mm.
    #[must_use]
    pub fn along(&self, v: geometry::Vector) -> Vec2 {
        Vec2::new(v.x / self.mu, -v.y / self.mu)
    }
}

/// A direction on the sheet, y down, of the same length.
#[must_use]
pub fn on_sheet(direction: geometry::Vector) -> Vec2 {
    Vec2::new(direction.x, -direction.y)
}

/// The unit vector from one place of the sheet to another; `otherwise` where they coincide.
#[must_use]
pub fn towards(from: Point, to: Point, otherwise: Vec2) -> Vec2 {
    let run = to - from;
    if run.hypot() > 0.0 { run.normalize() } else { otherwise }
}

/// Places closer than this part of the size of all of them are one: numbers differ by more, unless by their errors.
pub(super) const ONE_PLACE: f64 = 1e-9;

/// Things at places of the sheet, those together that stand less than `apart` mm from the first of them.
pub(super) fn together<T>(things: impl Iterator<Item = (Point, T)>, apart: f64) -> Vec<(Point, Vec<T>)> {
    together_where(things, apart, |_, _| true)
}

/// Those together that stand so close to the first of them and are in one place with it, as `is_one` says: what is only near on paper must not
/// read as equal.
pub(super) fn together_where<T>(
    things: impl Iterator<Item = (Point, T)>,
    apart: f64,
    is_one: impl Fn(&T, &T) -> bool,
) -> Vec<(Point, Vec<T>)> {
    let things: Vec<(Point, T)> = things.collect();
    let mut grid = Grid::new(around(&things.iter().map(|(at, _)| *at).collect::<Vec<_>>()));
    let mut places: Vec<(Point, Vec<T>)> = Vec::new();
    for (at, thing) in things {
        let near = grid.near(Rect::from_center_size(at, (2.0 * apart, 2.0 * apart)));
        let is_its = |place: &usize| (places[*place].0 - at).hypot() < apart && is_one(&places[*place].1[0], &thing);
        match near.into_iter().find(is_its) {
            Some(place) => places[place].1.push(thing),
            None => {
                grid.add(places.len(), Rect::from_points(at, at));
                places.push((at, vec![thing]));
            }
        }
    }
    places
}

/// The smallest scale of the series 1, 2, 2.5, 5 × 10^k (units per mm) at which `extent` fits into `area`.
#[must_use]
pub fn fitting_scale(extent: &Extent, area: Rect) -> f64 {
    Series::Hand.fitting(extent, area)
}

/// The smallest scale of the series 1, 2, 2.5, 5 × 10^k that is not below `least`, which must be positive.
#[must_use]
pub fn next_scale(least: f64) -> f64 {
    Series::Hand.next(least)
}

/// From which scales that of a panel is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Series {
    /// 1, 2, 2.5, 5 × 10^k, with which a hand calculates: on work sheets, exercises and keys.
    Hand,
    /// Those between them, too, that a ruler reads easily: in figures on paper.
    Ruler,
    /// All, to three digits: where nobody measures, and a bar says how long a value is.
    Any,
}

impl Series {
    /// The scales from 1 to below 10; none where there are too many.
    fn steps(self) -> Option<&'static [f64]> {
        match self {
            Series::Hand => Some(&[1.0, 2.0, 2.5, 5.0]),
            Series::Ruler => Some(&[1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]),
            Series::Any => None,
        }
    }

    /// The scale from 1 to below 10 with most digits.
    pub(super) fn longest(self) -> f64 {
        match self {
            Series::Hand => 2.5,
            Series::Ruler => 1.25,
            Series::Any => 1.11,
        }
    }

    /// The smallest scale that is not below `least`, which must be positive.
    pub(super) fn next(self, least: f64) -> f64 {
        match self.steps() {
            Some(steps) => next_of(steps, least),
            None => {
                let last_digit = decade(least) - 2;
                scaled(libm::ceil(least / scaled(1.0, last_digit) - 1e-9), last_digit)
            }
        }
    }

    /// The smallest scale (units per mm) at which `extent` fits into `area`.
    pub(super) fn fitting(self, extent: &Extent, area: Rect) -> f64 {
        let size = extent.size();
        let least = (size.x / area.width()).max(size.y / area.height());
        if least > 0.0 && least.is_finite() { self.next(least) } else { 1.0 }
    }

    /// A scale below another, the next one if there are steps; positive.
    pub(super) fn finer(self, than: f64) -> f64 {
        let Some(steps) = self.steps() else { return self.next(0.98 * than) };
        let decade = decade(than);
        let near = [decade - 1, decade].into_iter().flat_map(|at| steps.iter().map(move |step| scaled(*step, at)));
        near.filter(|mu| *mu < 0.999 * than).fold(scaled(1.0, decade - 1), f64::max)
    }
}

/// The smallest number not below `least` that is a power of ten times an element of `series`, which has numbers from 1
/// to below 10. `least` must be positive.
pub(super) fn next_of(series: &[f64], least: f64) -> f64 {
    let decade = decade(least);
    let steps = [decade, decade + 1].into_iter().flat_map(|at| series.iter().map(move |step| scaled(*step, at)));
    steps.into_iter().find(|scale| *scale >= least).unwrap_or(least)
}

/// The exponent of the largest power of ten that is not above a positive number.
fn decade(number: f64) -> i32 {
    // That from the binary exponent is fast to compute and at most one too low.
    let binary = (number.to_bits() >> 52) as i32 - 1023;
    let decade = (f64::from(binary) * std::f64::consts::LOG10_2).floor() as i32;
    if scaled(1.0, decade + 1) <= number { decade + 1 } else { decade }
}

/// A number times an integral power of ten.
fn scaled(step: f64, exponent: i32) -> f64 {
    // Division by a power of ten keeps 0.25 and the like exact to the last digit.
    if exponent < 0 { step / power_of_ten(-exponent) } else { step * power_of_ten(exponent) }
}

/// 10 to an integral power, exact as far as f64 allows.
fn power_of_ten(exponent: i32) -> f64 {
    if exponent <= 22 { (0..exponent).fold(1.0, |power, _| power * 10.0) } else { libm::pow(10.0, f64::from(exponent)) }
}
