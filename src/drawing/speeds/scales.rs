//! Where things are in the panel of the speed diagram, and its scales of velocities and angular velocities.

use crate::construction::{SpeedDiagram, SpeedLine};
use crate::geometry::Point;

/// Largest velocity and largest angular velocity, and largest distance of the base from the pole, in parts of the height of the train.
const LARGEST: f64 = 0.6;
const LOWEST: f64 = 0.42;
/// White between the train and the velocities, and between these and the pole, in parts of that height.
const BESIDE: f64 = 0.1;
const BELOW: f64 = 0.1;
/// While a mechanism moves, velocities that are more than so many times as large as usual are not seen whole.
const RUNS_OFF: f64 = 3.0;

/// What stands still while a mechanism moves.
#[derive(Clone, Copy, Debug)]
pub(in crate::drawing) struct SpeedScales {
    /// Where velocities begin, to the right of the line of centres.
    zero: f64,
    /// How long a unit of velocity is.
    pub velocity: f64,
    /// How long a unit of angular velocity is on the base.
    pub rate: f64,
}

impl SpeedScales {
    /// Those of a diagram in some positions; none without one.
    pub(in crate::drawing) fn of<'a>(diagrams: impl Iterator<Item = &'a SpeedDiagram>) -> Option<SpeedScales> {
        let diagrams: Vec<&SpeedDiagram> = diagrams.collect();
        let own = diagrams.first()?;
        let [low, high] = heights(own);
        let height = high - low;
        let largest = |of: fn(&SpeedDiagram) -> f64| usual(diagrams.iter().map(|diagram| of(diagram)).collect());
        let fastest = largest(|diagram| diagram.spots.iter().map(|spot| spot.velocity.abs()).fold(0.0, f64::max));
        let turning = largest(|diagram| rates(diagram).map(f64::abs).fold(0.0, f64::max));
        let velocity = round_below(LARGEST * height / fastest);
        let per_radian = own.turns.unwrap_or(1.0);
        let rate = round_below((LARGEST * height / turning).min(LOWEST * height * velocity / per_radian));
        let widest = own.circles.iter().map(|circle| circle.radius).fold(0.0, f64::max);
        let leftmost = |diagram: &SpeedDiagram| {
            let velocities = diagram.spots.iter().map(|spot| spot.velocity * velocity);
            velocities.chain(rates(diagram).map(|own| own * rate)).fold(0.0, f64::min)
        };
        let leftmost = usual(diagrams.iter().map(|diagram| -leftmost(diagram)).collect());
        Some(SpeedScales { zero: widest + BESIDE * height + leftmost, velocity, rate })
    }
}

/// The angular velocities of the lines that turn.
fn rates(diagram: &SpeedDiagram) -> impl Iterator<Item = f64> {
    diagram.lines.iter().filter(|line| !line.slides).map(|line| diagram.rate(line))
}

/// The largest of some sizes, but for those that run off.
fn usual(mut sizes: Vec<f64>) -> f64 {
    sizes.sort_by(f64::total_cmp);
    let most = RUNS_OFF * sizes.get(sizes.len() / 2).copied().unwrap_or_default();
    sizes.into_iter().take_while(|size| *size <= most).fold(0.0, f64::max)
}

/// The lowest and the highest place of the train.
fn heights(diagram: &SpeedDiagram) -> [f64; 2] {
    let reach = |side: f64| diagram.circles.iter().map(move |own| own.center + side * own.radius);
    let high = reach(1.0).chain(diagram.spots.iter().map(|spot| spot.height)).fold(0.0, f64::max);
    [reach(-1.0).fold(0.0, f64::min), high]
}

/// The largest of 1, 2, 2.5, 4, 5 · 10^k that is not larger; 1 where anything fits.
fn round_below(most: f64) -> f64 {
    if !(most > 0.0 && most.is_finite()) {
        return 1.0;
    }
    let decade = libm::pow(10.0, libm::floor(libm::log10(most)));
    [5.0, 4.0, 2.5, 2.0].into_iter().map(|part| part * decade).find(|value| *value <= most).unwrap_or(decade)
}

/// Where things are in the panel, in units of length: the line of centres is upright at x = 0.
pub(super) struct Layout<'a> {
    pub diagram: &'a SpeedDiagram,
    pub scales: SpeedScales,
    /// Where velocities begin.
    pub zero: f64,
    /// The height of the point through which parallels are drawn, and that of the base.
    pub pole: f64,
    pub base: f64,
}

impl<'a> Layout<'a> {
    /// The layout at these scales, or at its own.
    pub(super) fn of(diagram: &'a SpeedDiagram, held: Option<SpeedScales>) -> Option<Layout<'a>> {
        let scales = held.or_else(|| SpeedScales::of(std::iter::once(diagram)))?;
        let [low, high] = heights(diagram);
        let pole = -BELOW * (high - low);
        // A parallel to a line with ω is ω · velocity wide for each unit of height.
        let base = pole - scales.rate * diagram.turns.unwrap_or(1.0) / scales.velocity;
        Some(Layout { diagram, scales, zero: scales.zero, pole, base })
    }

    pub(super) fn tip(&self, spot: usize) -> Point {
        let spot = &self.diagram.spots[spot];
        Point::new(self.zero + spot.velocity * self.scales.velocity, spot.height)
    }

    pub(super) fn cut(&self, line: &SpeedLine) -> Point {
        Point::new(self.zero + self.diagram.rate(line) * self.scales.rate, self.base)
    }

    /// What part of the content lies below the base.
    pub(super) fn below_base(&self) -> f64 {
        let [low, high] = heights(self.diagram);
        (self.base - low).max(0.0) / (high - low.min(self.base))
    }
}
