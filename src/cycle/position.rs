use super::CycleError;
use super::drive::stands;
use crate::construction::{Construction, Extent, construct};
use crate::geometry::{Point, Row, Turn, Vector, quarter_turn};
use crate::kernel::{Block, Kernel, Single, Unknown, vector};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, Role, SliderId};
use crate::motion::{motion, standing_of};
use crate::position::Pose;
use crate::quantity::{KeptForces, State};
use crate::sheet::Order;

/// Squared Hadamard ratio of a group's equations below which a position is singular.
const SINGULAR: f64 = 1e-18;

/// One position of a block, from which quantities can be read.
#[derive(Clone, Debug)]
pub struct Position<'a, R: Row = [f64; 1]> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) kernel: &'a Kernel,
    pub(super) block: &'a Block<R>,
    lane: usize,
    forces: KeptForces,
}

impl<'a, R: Row> Position<'a, R> {
    pub(super) fn new(mechanism: &'a Mechanism, kernel: &'a Kernel, block: &'a Block<R>, lane: usize) -> Self {
        Position { mechanism, kernel, block, lane, forces: KeptForces::default() }
    }
}

impl<R: Row> Position<'_, R> {
    /// The rotation of a body's frame.
    fn turn(&self, body: BodyId) -> Turn {
        self.block.turn(self.kernel.seat(body).class, self.lane) * self.block.turn_in_class(body, self.lane)
    }

    /// The direction of a body's own x axis.
    fn direction(&self, body: BodyId) -> Vector {
        self.turn(body) * Vector::x()
    }

    /// The position as a pose of the mechanism, for the stages that take one.
    #[must_use]
    pub fn pose(&self) -> Pose {
        let mechanism = self.mechanism;
        let sliders = || mechanism.slider_ids();
        let moves = |id: usize| mechanism.bodies[id].role != Role::Ground;
        let axis = |id: usize| moves(id).then(|| self.direction(BodyId(id)));
        Pose {
            points: (0..mechanism.points.len()).map(|p| self.place(PointId(p))).collect(),
            guides: sliders().map(|s| self.guide(s)).collect(),
            slides: sliders().map(|s| self.slide_position(s)).collect(),
            axes: (0..mechanism.bodies.len()).map(axis).collect(),
            assemblies: vec![None; mechanism.groups.len()],
            warnings: Vec::new(),
        }
    }

    /// The construction at this position; `None` where it is singular.
    pub(super) fn construction(&self) -> Option<Construction> {
        let (mechanism, pose) = (self.mechanism, self.pose());
        let motion = motion(mechanism, &pose, Order::Acceleration).ok()?;
        Some(construct(mechanism, &pose, &motion, Extent::Points))
    }
}

impl<R: Row> State for Position<'_, R> {
    fn has_accelerations(&self) -> bool {
        true
    }

    fn kept_forces(&self) -> Option<&KeptForces> {
        Some(&self.forces)
    }

    fn place(&self, point: PointId) -> Point {
        self.block.place(point.0, self.lane) + self.block.origin(self.lane)
    }

    fn axis(&self, link: BodyId) -> Option<Vector> {
        (link != GROUND).then(|| self.direction(link))
    }

    fn guide(&self, slider: SliderId) -> Vector {
        let slider = self.mechanism.slider(slider);
        let (_, along) = slider.line();
        self.turn(slider.on) * along
    }

    fn slide_position(&self, slider: SliderId) -> Option<f64> {
        Some(self.block.slides[slider.0][self.lane])
    }

    fn slide_rates(&self, slider: SliderId) -> [f64; 2] {
        let (speeds, seconds) = (&self.block.speeds, &self.block.accelerations);
        [speeds, seconds].map(|rates| rates[slider.0][self.lane])
    }

    fn angular_rates(&self, body: BodyId) -> [f64; 2] {
        let class = self.kernel.seat(body).class;
        [&self.block.omegas, &self.block.alphas].map(|rates| rates[class][self.lane])
    }

    fn motion_at(&self, body: BodyId, place: Point) -> [Vector; 2] {
        let slot = self.kernel.seat(body).slot;
        let [omega, alpha] = self.angular_rates(body);
        let arm = place - (self.block.place(slot, self.lane) + self.block.origin(self.lane));
        let velocity = vector(&self.block.point_velocities[slot], self.lane);
        let acceleration = vector(&self.block.point_accelerations[slot], self.lane);
        [velocity + quarter_turn(arm) * omega, acceleration + quarter_turn(arm) * alpha - arm * (omega * omega)]
    }
}

/// A block in the position of `pose`, with the drives' values; the caller sets their rates.
pub(super) fn start(kernel: &Kernel, mechanism: &Mechanism, pose: &Pose) -> Single {
    let mut block = Block::new(kernel);
    for (index, input) in kernel.inputs.iter().enumerate() {
        kernel.set_input(&mut block, index, &[stands(input, pose)]);
    }
    for unknown in kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Slide(slider) => block.slides[slider] = [pose.slides[slider].unwrap_or(0.0)],
            Unknown::Spin(class) => {
                let mut links = mechanism.links().filter(|(id, _)| kernel.seat(*id).class == class);
                let turn = links.find_map(|(id, _)| {
                    let axis = pose.axes[id.0]?.normalize();
                    Some(block.turn_in_class(id, 0).inverse() * Turn::from_cos_sin_unchecked(axis.x, axis.y))
                });
                let turn = turn.unwrap_or_else(Turn::identity);
                block.turns[class] = [[turn.re], [turn.im]];
            }
        }
    }
    block
}

/// As [`start`], with all loops closed.
///
/// # Errors
/// The position is singular; `at` says where the drives stand.
pub(super) fn regular_start(
    kernel: &Kernel,
    mechanism: &Mechanism,
    pose: &Pose,
    at: impl FnOnce() -> String,
) -> Result<Single, CycleError> {
    let mut block = start(kernel, mechanism, pose);
    let closed = kernel.assemble(&mut block, 0.0).closed;
    let mut determinants = kernel.determinants(&block).into_iter();
    match determinants.position(|[_, squared_ratio]| !closed || squared_ratio < SINGULAR) {
        Some(group) => Err(CycleError::Singular {
            links: mechanism.groups[group].link_names(mechanism),
            at: at(),
            standing: standing_of(mechanism, pose, group),
        }),
        None => Ok(block),
    }
}
