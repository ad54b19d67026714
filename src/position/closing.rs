use super::frames::{Frames, pinned};
use crate::geometry::{BoundingBox, Point, UNIT_ROUNDOFF, Vector, span};
use crate::kernel::{Kernel, Single, Unknown, vector};
use crate::mechanism::{AngularConstraint, BodyId, GROUND, Joint, Mechanism, PointId, SliderId};

/// Most Newton steps: from a simple root of a polynomial two or three are needed, from a double root ten.
const STEPS: usize = 16;

/// A group's assembly, approximate or closed: orientations of its links and positions of its sliders.
#[derive(Clone, Debug)]
pub(super) struct Assembled {
    /// Frames of all bodies, the group's included.
    pub frames: Frames,
    /// By slider: its position along the guide.
    pub slides: Vec<f64>,
    /// The largest gap of the loops, relative to the mechanism's size, or of the relations between angles, in radians.
    pub gap: f64,
}

/// Closes the loops of groups from approximate starts, by Newton's method on the loop equations.
///
/// The matrix is that of the velocity equations, the right side the gaps; so a pose is as exact as the condition of its
/// velocities allows.
pub(super) struct Closer<'a> {
    mechanism: &'a Mechanism,
    kernel: Kernel,
    block: Single,
    /// The points of the bodies of known position, relative to the kernel's origin.
    known: BoundingBox,
    surroundings: Vec<Surroundings>,
}

/// What is around the links of a group.
struct Surroundings {
    /// Its bodies, and those of other groups or of known position that touch them.
    bodies: Vec<BodyId>,
    /// The points of its links.
    points: Vec<PointId>,
    /// The lengths that its loops add up: the spans of its bodies, and the distances of the zeros of their guides from their origins.
    lengths: f64,
    /// The length of its shortest link that has one.
    shortest: f64,
    sliders: Vec<SliderId>,
    /// Of the equations by which gears, or the like, relate its rotations: the largest sum of weights, as numbers of teeth. Zero without such.
    weights: f64,
}

impl<'a> Closer<'a> {
    /// For a mechanism given by lengths; `known` are the frames of the bodies that no group holds.
    pub(super) fn new(mechanism: &'a Mechanism, known: &Frames) -> Closer<'a> {
        let kernel = Kernel::new(mechanism);
        let kernel = kernel.expect("only a mechanism given by lengths is put together");
        let places = known.places(mechanism, mechanism.body_ids());
        let block = Single::new(&kernel);
        let origin = block.origin(0);
        Closer {
            mechanism,
            block,
            known: BoundingBox::of(places.map(|(_, place)| place - origin)),
            surroundings: surroundings(mechanism, origin),
            kernel,
        }
    }

    /// The assembly of a group with the smallest gap among the Newton steps from `start`.
    pub(super) fn closed(&mut self, group: usize, start: Assembled) -> Assembled {
        self.load(group, &start);
        let mut best = (f64::INFINITY, self.state(group));
        for _ in 0..STEPS {
            let state = self.state(group);
            let size = self.size(group);
            let [gap, turn] = self.kernel.step(&mut self.block, group);
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
            self.kernel.place(&mut self.block, group);
        }
        let (gap, state) = best;
        self.restore(group, state);
        self.kernel.place(&mut self.block, group);
        self.unload(group, start, gap)
    }

    /// The size of the group with the bodies of known position.
    fn size(&self, group: usize) -> f64 {
        let points = self.surroundings[group].points.iter();
        self.known.with(points.map(|point| self.block.place(point.0, 0))).size()
    }

    /// One rounding in the gap of an assembly of the group, in the same measure as the assembly's: a part of all lengths
    /// and coordinates that its loops add up.
    pub(super) fn rounding(&self, group: usize, assembled: &Assembled) -> f64 {
        let Surroundings { lengths, sliders, weights, .. } = &self.surroundings[group];
        if *weights > 0.0 {
            return f64::INFINITY;
        }
        let members = self.mechanism.groups[group].bodies.iter().copied();
        let places = assembled.frames.places(self.mechanism, members);
        let own = BoundingBox::of(places.map(|(_, place)| place - self.block.origin(0)));
        let slides: f64 = sliders.iter().map(|id| assembled.slides[id.0].abs()).sum();
        // Coordinates far from either origin are rounded by more.
        let origins = [Point::origin(), Point::from(-self.block.origin(0))];
        let sum = own.with(origins).size() + lengths + slides;
        UNIT_ROUNDOFF * sum / self.known.joined(own).size()
    }

    /// What rounding may leave of a gap between the angles of a group's wheels: each is taken as many times as a wheel has teeth.
    pub(super) fn rounding_of_wheels(&self, group: usize) -> f64 {
        UNIT_ROUNDOFF * self.surroundings[group].weights
    }

    /// The length of a group's shortest link that has one; else infinite.
    pub(super) fn shortest(&self, group: usize) -> f64 {
        self.surroundings[group].shortest
    }

    /// The next Newton step from an assembly of a group: radians, of sliders parts of the shortest link. Infinite where the
    /// equations are singular.
    pub(super) fn next_step(&mut self, group: usize, assembled: &Assembled) -> f64 {
        self.load(group, assembled);
        let before = self.state(group);
        let [gap, turn] = self.kernel.step(&mut self.block, group);
        if !(gap.is_finite() && turn.is_finite()) {
            return f64::INFINITY;
        }
        let shortest = self.shortest(group);
        let after = self.state(group);
        let unknowns = self.kernel.unknowns[group].iter().zip(before.iter().zip(&after));
        let steps = unknowns.map(|(unknown, (before, after))| match unknown {
            Unknown::Spin(_) => (after - before).norm(),
            Unknown::Slide(_) => (after - before).norm() / shortest,
        });
        steps.fold(0.0, f64::max)
    }

    /// The gap of a group between two of its assemblies, not quite half-way: just there the equations of a double root
    /// are singular.
    pub(super) fn gap_between(&mut self, group: usize, [a, b]: [&Assembled; 2]) -> f64 {
        self.load(group, a);
        let first = self.state(group);
        self.load(group, b);
        let second = self.state(group);
        let between = first.iter().zip(&second).map(|(p, q)| p * 0.6 + q * 0.4).collect();
        self.restore(group, between);
        for unknown in &self.kernel.unknowns[group] {
            if let Unknown::Spin(class) = *unknown {
                let turn = vector(&self.block.turns[class], 0).normalize();
                self.block.turns[class] = [[turn.x], [turn.y]];
            }
        }
        self.kernel.place(&mut self.block, group);
        let size = self.size(group);
        let [gap, turn] = self.kernel.step(&mut self.block, group);
        (gap / size).max(turn)
    }

    /// The unknowns of the group, which Newton's steps change: cosine and sine of angles, and slides.
    fn state(&self, group: usize) -> Vec<Vector> {
        let unknowns = self.kernel.unknowns[group].iter();
        let value = |unknown: &Unknown| match *unknown {
            Unknown::Spin(class) => vector(&self.block.turns[class], 0),
            Unknown::Slide(slider) => Vector::new(self.block.slides[slider][0], 0.0),
        };
        unknowns.map(value).collect()
    }

    fn restore(&mut self, group: usize, state: Vec<Vector>) {
        for (unknown, value) in self.kernel.unknowns[group].iter().zip(state) {
            match *unknown {
                Unknown::Spin(class) => self.block.turns[class] = [[value.x], [value.y]],
                Unknown::Slide(slider) => self.block.slides[slider] = [value.x],
            }
        }
    }

    /// Sets the block to the bodies around the group and to the start of its links.
    fn load(&mut self, group: usize, start: &Assembled) {
        let pair = |v: Vector| [[v.x], [v.y]];
        for (slide, position) in self.block.slides.iter_mut().zip(&start.slides) {
            *slide = [*position];
        }
        let members = &self.mechanism.groups[group].bodies;
        for &id in &self.surroundings[group].bodies {
            let Some(frame) = start.frames.of(id) else {
                continue;
            };
            let seat = self.kernel.seat(id);
            let turn = frame.rotation * self.block.turn_in_class(id, 0).inverse();
            self.block.turns[seat.class] = pair(Vector::new(turn.re, turn.im));
            // The ground, which may have thousands of points, is where it was.
            if members.contains(&id) || id == GROUND {
                continue;
            }
            self.block.points[seat.slot] =
                pair((frame * self.kernel.first_place(self.mechanism, id)).coords - self.block.origin(0));
            let body = self.mechanism.body(id);
            for (point, local) in body.points.iter().zip(&body.local) {
                self.block.points[point.0] = pair((frame * local).coords - self.block.origin(0));
            }
        }
        self.kernel.place(&mut self.block, group);
    }

    fn unload(&self, group: usize, start: Assembled, gap: f64) -> Assembled {
        let Assembled { mut frames, mut slides, .. } = start;
        for &link in &self.mechanism.groups[group].bodies {
            let seat = self.kernel.seat(link);
            let turn = self.block.turn(seat.class, 0) * self.block.turn_in_class(link, 0);
            let place = self.block.place(seat.slot, 0) + self.block.origin(0);
            frames.set(link, pinned(turn, self.kernel.first_place(self.mechanism, link), place));
        }
        for (slide, [position]) in slides.iter_mut().zip(&self.block.slides) {
            *slide = *position;
        }
        Assembled { frames, slides, gap }
    }
}

/// By group: what is around its links.
fn surroundings(mechanism: &Mechanism, origin: Vector) -> Vec<Surroundings> {
    let holders = mechanism.holders();
    let around = mechanism.groups.iter().map(|group| {
        let mut points: Vec<PointId> =
            group.bodies.iter().flat_map(|&link| mechanism.body(link).points.iter().copied()).collect();
        points.sort_unstable();
        points.dedup();
        let joints = group.joints.iter().map(|&joint| mechanism.joint(joint));
        let joined = joints.clone().flat_map(|joint| joint.bodies);
        let related = joints.flat_map(Joint::related_bodies);
        let holding = points.iter().flat_map(|point| holders[point.0].iter().copied());
        // A joint on one link of a compound link depends on all of them.
        let all = joined.chain(related).chain(holding).flat_map(|body| mechanism.compound(mechanism.root(body)));
        let mut bodies: Vec<BodyId> = all.chain(group.bodies.iter().copied()).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let sliders: Vec<SliderId> = group.joints.iter().filter_map(|&joint| mechanism.joint(joint).slider).collect();
        let zero = |id: &SliderId| {
            let slider = mechanism.slider(*id);
            let from = if slider.on == GROUND { origin } else { Vector::zeros() };
            (slider.line().0.coords - from).norm()
        };
        let spans = group.bodies.iter().map(|&body| span(mechanism.body(body).local.iter().copied()));
        Surroundings {
            bodies,
            points,
            shortest: spans.clone().filter(|&length| length > 0.0).fold(f64::INFINITY, f64::min),
            lengths: spans.sum::<f64>() + sliders.iter().map(zero).sum::<f64>(),
            sliders,
            weights: group.gears(mechanism).map(weights).fold(0.0, f64::max),
        }
    });
    around.collect()
}

fn weights(relation: &AngularConstraint) -> f64 {
    relation.terms.iter().map(|(_, weight)| f64::from(*weight).abs()).sum()
}

/// Places of all points and unit directions of all guides; points of bodies without a frame are at the origin.
pub(super) fn places(mechanism: &Mechanism, frames: &Frames) -> (Vec<Point>, Vec<Vector>) {
    let mut points: Vec<Point> = mechanism.given.iter().map(|p| p.unwrap_or_else(Point::origin)).collect();
    // Known bodies are written last: they decide the places of shared points.
    let (known, members): (Vec<BodyId>, Vec<BodyId>) = mechanism.body_ids().partition(|&b| mechanism.is_known(b));
    let order = members.into_iter().rev().chain(known.into_iter().rev());
    for (point, place) in frames.places(mechanism, order) {
        points[point.0] = place;
    }
    let guides = mechanism.sliders.iter().map(|slider| {
        let (_, direction) = slider.line();
        // Products of several rotations differ from length 1 by a few roundings.
        frames.of(slider.on).map_or(direction, |frame| (frame.rotation * direction).normalize())
    });
    (points, guides.collect())
}
