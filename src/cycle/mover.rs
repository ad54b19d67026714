use super::drive::{in_radians, moving, stands};
use super::position::regular_start;
use super::segment::rates;
use super::{CycleError, Position};
use crate::geometry::{Pair, UNIT_ROUNDOFF};
use crate::kernel::{InputKind, Kernel, Single, Unknown};
use crate::mechanism::Mechanism;
use crate::position::Pose;

/// Largest first correction of a position carried on from the one before, in radians or parts of the group's size.
const OFF: f64 = 0.1;

/// Numbers of pieces into which a move is cut, one after the other, until each piece succeeds.
const PIECES: [u32; 5] = [1, 4, 16, 64, 256];

/// A mechanism at its present position, which goes from there wherever its drives go: for a page that follows the mouse.
///
/// [`Self::move_to`] gives position, velocities and accelerations at the drives' new values, from the mechanism's
/// position before. It allocates nothing, but for groups of higher class. For many positions along one drive a [`Path`](super::Path) is quicker, and
/// knows limits and change points.
///
/// ```
/// use kinegon::cycle::Mover;
/// use kinegon::quantity::State;
///
/// let scene = kinegon::Scene::read(include_str!("../../examples/figure-2.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let mechanism = &solution.mechanism;
/// let link = mechanism.link("4").expect("the scene has a link 4");
/// let mut mover = Mover::new(mechanism, &solution.pose)?;
/// for degrees in 70..=75 {
///     let position = mover.move_to(&[f64::from(degrees)]).ok_or("the crank cannot go there")?;
///     let [omega, alpha] = position.angular_rates(link);
///     println!("{degrees}°: {omega} rad/s, {alpha} rad/s²");
/// }
/// // Beyond the limit at 137.58° the mechanism stays where it was.
/// assert!(mover.move_to(&[150.0]).is_none());
/// assert_eq!(mover.drives(), [75.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Mover<'a> {
    mechanism: &'a Mechanism,
    kernel: Kernel,
    block: Single,
    /// The drives' values at the present position.
    drives: Vec<f64>,
    /// Directions of classes and positions of sliders at the start of a move.
    turns: Vec<[[f64; 1]; 2]>,
    slides: Vec<[f64; 1]>,
    /// Second derivatives of the unknowns by time at the step before, and that step's time; zero if there was none.
    seconds: Vec<f64>,
    time: f64,
    /// By group: the determinant for which `sure` holds.
    determinants: Vec<f64>,
    /// Largest correction after which a Newton step leaves only rounding.
    sure: f64,
}

impl<'a> Mover<'a> {
    /// The mechanism in a position, with the rates that its drives have in the scene.
    ///
    /// # Errors
    /// The configuration is drawn, or the position is singular.
    pub fn new(mechanism: &'a Mechanism, pose: &Pose) -> Result<Self, CycleError> {
        let kernel = moving(mechanism)?;
        let drives: Vec<f64> = kernel.inputs.iter().map(|input| stands(input, pose)).collect();
        let block = regular_start(&kernel, mechanism, pose, || {
            let names = mechanism.drive_names();
            let at: Vec<String> = names.iter().zip(&drives).map(|(name, value)| format!("{name} = {value}")).collect();
            at.join(", ")
        })?;
        let mut mover = Mover {
            mechanism,
            drives,
            turns: block.turns.clone(),
            slides: block.slides.clone(),
            seconds: vec![0.0; kernel.unknowns.iter().flatten().count()],
            time: 0.0,
            determinants: vec![f64::NAN; kernel.unknowns.len()],
            sure: 0.0,
            block,
            kernel,
        };
        for (index, input) in mover.kernel.inputs.iter().enumerate() {
            mover.kernel.set_rates(&mut mover.block, index, input.rate, input.second);
        }
        mover.kernel.rates(&mut mover.block);
        mover.refresh();
        Ok(mover)
    }

    /// The drives' present values: angles in degrees, or positions along guides, in the order of
    /// [`Mechanism::drive_names`].
    #[must_use]
    pub fn drives(&self) -> &[f64] {
        &self.drives
    }

    /// The present position, with velocities and accelerations for the drives running as the scene says.
    #[must_use]
    pub fn position(&self) -> Position<'_> {
        Position::new(self.mechanism, &self.kernel, &self.block, 0)
    }

    /// Moves the drives to these values, all in proportion, and gives the position there as [`Self::position`] does.
    ///
    /// A crank goes the shorter way round, or if that is barred the other one, as the numbers say. `None` where the way
    /// leads through a singular position (a limit or a change point) or nearer to one than can be told, or where a
    /// value is no number: the mechanism then stays where it was.
    ///
    /// # Panics
    /// There are not as many values as drives.
    #[inline]
    pub fn move_to(&mut self, values: &[f64]) -> Option<Position<'_>> {
        assert_eq!(values.len(), self.drives.len(), "each drive needs its value");
        self.turns.copy_from_slice(&self.block.turns);
        self.slides.copy_from_slice(&self.block.slides);
        let reached = PIECES.into_iter().any(|pieces| self.go(values, pieces, shorter))
            || PIECES.into_iter().any(|pieces| self.go(values, pieces, |degrees| degrees));
        if !reached {
            return None;
        }
        for (drive, value) in self.drives.iter_mut().zip(values) {
            *drive = *value;
        }
        Some(self.position())
    }

    /// Goes to these values in so many pieces, cranks by the angles that `turn` makes of differences; if a piece fails,
    /// back to the start of the move.
    #[inline]
    fn go(&mut self, values: &[f64], pieces: u32, turn: impl Fn(f64) -> f64) -> bool {
        for piece in 1..=pieces {
            let part = f64::from(piece) / f64::from(pieces);
            let mut last = 0.0;
            for (drive, value) in values.iter().enumerate() {
                let from = self.drives[drive];
                let whole = match self.kernel.inputs[drive].kind {
                    InputKind::Turning { .. } => turn(value - from),
                    InputKind::Sliding { .. } => value - from,
                };
                last = whole / f64::from(pieces);
                let now = if piece == pieces { *value } else { from + part * whole };
                self.kernel.set_input(&mut self.block, drive, &[now]);
            }
            if !self.step(last) || self.mechanism.off_guide(|id| Some(self.block.slides[id.0][0])).is_some() {
                self.go_back();
                return false;
            }
        }
        true
    }

    /// One step to where the drives have been set, of which the last has changed by so much; no group may come to another
    /// branch.
    #[inline]
    fn step(&mut self, change: f64) -> bool {
        self.carry_on(change);
        let found = self.kernel.motions(&mut self.block, self.sure);
        if !(found.closed && found.first <= OFF) {
            return false;
        }
        // All determinants have the signs that they had.
        let is_on_branch = self.ratios().all(|ratio| ratio > 0.0);
        let is_near = self.ratios().all(|ratio| (0.5..=2.0).contains(&ratio));
        if is_on_branch && !is_near {
            // Nearer to a singular position the last correction must be smaller: `sure` may not hold any more.
            self.refresh();
            return self.kernel.motions(&mut self.block, self.sure).closed;
        }
        is_on_branch
    }

    /// Carries the unknowns on by their rates, to third order in the time that the drive takes at its speed in the scene:
    /// the third derivative is the second one's difference since the step before. So small steps along one way need a
    /// single Newton step. Only where a single drive moves in the scene; else Newton's method starts at the present
    /// position.
    #[inline]
    fn carry_on(&mut self, change: f64) {
        let [input] = &self.kernel.inputs[..] else { return };
        if input.rate == 0.0 {
            return;
        }
        let (time, lag) = (in_radians(input.kind, change) / input.rate, input.second / input.rate);
        // After a step that was much shorter the difference would be rounding.
        let is_like = self.time != 0.0 && time.abs() <= 4.0 * self.time.abs();
        let third = if is_like { time / (3.0 * self.time) } else { 0.0 };
        self.time = time;
        let block = &mut self.block;
        let unknowns = self.kernel.unknowns.iter().flatten();
        for (unknown, before) in unknowns.zip(&mut self.seconds) {
            let [rate, second] = rates(block, *unknown);
            // As for a drive without acceleration.
            let second = second - rate * lag;
            let step = time * (rate + 0.5 * time * (second + third * (second - *before)));
            *before = second;
            match *unknown {
                Unknown::Spin(class) => {
                    let [[x], [y]] = block.turns[class];
                    // The tangent, to third order.
                    let tangent = step * (1.0 + step * step / 3.0);
                    let turned = Pair { x, y }.plus_turned(Pair { x, y }, tangent);
                    let turned = turned * (1.0 / turned.dot(turned).sqrt());
                    block.turns[class] = [[turned.x], [turned.y]];
                }
                Unknown::Slide(slider) => block.slides[slider][0] += step,
            }
        }
    }

    /// By group: the determinant before over that now.
    #[inline]
    fn ratios(&self) -> impl Iterator<Item = f64> {
        let groups = self.determinants.iter().enumerate();
        groups.map(|(group, before)| before * self.kernel.inverse_determinant(&self.block, group, 0))
    }

    /// Finds how small a last correction must be. As for a segment of a path: a Newton step leaves an error of its square
    /// over the Hadamard ratio, which is hardly less than a quarter of this until determinants have changed much.
    #[cold]
    fn refresh(&mut self) {
        let mut least: f64 = 1.0;
        for (group, old) in self.determinants.iter_mut().enumerate() {
            let [determinant, squared_ratio] = self.kernel.determinant(&self.block, group);
            *old = determinant;
            least = least.min(squared_ratio.sqrt());
        }
        self.sure = 0.6 * (UNIT_ROUNDOFF * least / 4.0).sqrt();
    }

    /// Goes back to the start of the move.
    #[cold]
    fn go_back(&mut self) {
        for (input, value) in self.drives.iter().enumerate() {
            self.kernel.set_input(&mut self.block, input, &[*value]);
        }
        self.block.turns.copy_from_slice(&self.turns);
        self.block.slides.copy_from_slice(&self.slides);
        self.time = 0.0;
        self.kernel.assemble(&mut self.block, 0.0);
        self.kernel.rates(&mut self.block);
        self.refresh();
    }
}

/// A rotation taken the shorter way round, in degrees.
#[inline]
fn shorter(degrees: f64) -> f64 {
    if degrees.abs() <= 180.0 { degrees } else { degrees - 360.0 * (degrees / 360.0).round() }
}
