use super::frames::{Frames, pinned};
use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, span};
use crate::kernel::{Kernel, Single};
use crate::mechanism::{BodyId, Group, Mechanism};

/// Most Newton steps: from a simple root of a polynomial two or three are needed, from a double root ten.
const STEPS: usize = 16;

/// A group's assembly, approximate or closed: orientations of its links and positions of its sliders.
#[derive(Clone, Debug)]
pub(super) struct Assembled {
    /// Frames of all bodies, the group's included.
    pub frames: Frames,
    /// By slider: its position along the guide.
    pub slides: Vec<f64>,
    /// The largest gap of the loops, relative to the mechanism's size, or of the ties, in radians.
    pub gap: f64,
}

/// Closes the loops of a group from approximate starts, by Newton's method on the loop equations.
///
/// The matrix is that of the velocity equations, the right side the gaps; so a pose is as exact as the condition of its
/// velocities allows.
pub(super) struct Closer<'a> {
    mechanism: &'a Mechanism,
    group: &'a Group,
    index: usize,
    kernel: Kernel,
    block: Single,
}

impl<'a> Closer<'a> {
    /// For group `index` of a mechanism given by lengths.
    pub(super) fn new(mechanism: &'a Mechanism, index: usize) -> Closer<'a> {
        let kernel = Kernel::new(mechanism);
        let kernel = kernel.expect("only a mechanism given by lengths is put together");
        Closer { mechanism, group: &mechanism.groups[index], index, block: Single::new(&kernel), kernel }
    }

    /// The assembly with the smallest gap among the Newton steps from `start`.
    pub(super) fn closed(&mut self, start: Assembled) -> Assembled {
        self.load(&start);
        let mut best = (f64::INFINITY, self.state());
        for _ in 0..STEPS {
            let state = self.state();
            let points = self.block.points[..self.mechanism.points.len()].iter();
            let size = span(points.map(|[[x], [y]]| Point::new(*x, *y)));
            let [gap, turn] = self.kernel.step(&mut self.block, self.index);
            let gap = gap / size;
            if !(gap.is_finite() && turn.is_finite()) {
                break;
            }
            let gap = gap.max(turn);
            let better = gap < best.0;
            if better {
                best = (gap, state);
            }
            // Below rounding a further step changes nothing; a gap that grows near it is rounding, too.
            if gap <= UNIT_ROUNDOFF || (!better && gap < 1e-12) {
                break;
            }
            self.kernel.place(&mut self.block, self.index);
        }
        let (gap, (turns, slides)) = best;
        (self.block.turns, self.block.slides) = (turns, slides);
        self.kernel.place(&mut self.block, self.index);
        self.unload(start.frames, gap)
    }

    fn state(&self) -> (Vec<[[f64; 1]; 2]>, Vec<[f64; 1]>) {
        (self.block.turns.clone(), self.block.slides.clone())
    }

    /// Sets the block to the known bodies and to the start of the group's links.
    fn load(&mut self, start: &Assembled) {
        let pair = |v: Vector| [[v.x], [v.y]];
        for (slide, position) in self.block.slides.iter_mut().zip(&start.slides) {
            *slide = [*position];
        }
        for (id, body) in self.mechanism.bodies.iter().enumerate() {
            let id = BodyId(id);
            let Some(frame) = start.frames.of(id) else {
                continue;
            };
            let seat = self.kernel.seat(id);
            let turn = frame.rotation * seat.turn.inverse();
            self.block.turns[seat.class] = pair(Vector::new(turn.re, turn.im));
            if self.group.bodies.contains(&id) {
                continue;
            }
            self.block.points[seat.slot] = pair((frame * seat.local).coords - self.kernel.origin);
            for (point, local) in body.points.iter().zip(&body.local) {
                self.block.points[point.0] = pair((frame * local).coords - self.kernel.origin);
            }
        }
        self.kernel.place(&mut self.block, self.index);
    }

    fn unload(&self, mut frames: Frames, gap: f64) -> Assembled {
        for &link in &self.group.bodies {
            let seat = self.kernel.seat(link);
            let turn = self.block.turn(seat.class, 0) * seat.turn;
            let place = self.block.place(seat.slot, 0) + self.kernel.origin;
            frames.set(link, pinned(turn, seat.local, place));
        }
        Assembled { frames, slides: self.block.slides.iter().map(|[s]| *s).collect(), gap }
    }
}

/// Places of all points and unit directions of all guides; points of bodies without a frame are at the origin.
pub(super) fn places(mechanism: &Mechanism, frames: &Frames) -> (Vec<Point>, Vec<Vector>) {
    let mut points: Vec<Point> = mechanism.given.iter().map(|p| p.unwrap_or_else(Point::origin)).collect();
    // Known bodies are written last: they decide the places of shared points.
    let bodies = (0..mechanism.bodies.len()).map(BodyId);
    let (known, members): (Vec<BodyId>, Vec<BodyId>) = bodies.partition(|&b| mechanism.is_known(b));
    for id in members.into_iter().rev().chain(known.into_iter().rev()) {
        let body = mechanism.body(id);
        let Some(frame) = frames.of(id) else { continue };
        for (point, local) in body.points.iter().zip(&body.local) {
            points[point.0] = frame * local;
        }
    }
    let guides = mechanism.sliders.iter().map(|slider| {
        let (_, direction) = slider.line();
        // Products of several rotations differ from length 1 by a few roundings.
        frames.of(slider.on).map_or(direction, |frame| (frame.rotation * direction).normalize())
    });
    (points, guides.collect())
}
