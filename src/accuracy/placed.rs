//! True places of a mechanism near a pose, with bounds of their errors.
//!
//! From lengths, Newton's method continues from the pose's angles and slides with twice the digits of f64, until only the
//! errors of what the scene gives are left; |A⁻¹| takes these to the angles and slides (Higham, *Accuracy and Stability
//! of Numerical Algorithms*, 2002, §7.1). As drawn, the places are those of the scene.

use super::given::{Frame, Given, Vector, written};
use crate::geometry::{Ball, Numbers, Pair, Point, UNIT_ROUNDOFF, span};
use crate::mechanism::{BodyId, Group, JointId, LoopEquations, Mechanism, PointId, Role, SliderId};
use crate::position::Pose;
use crate::scene::GivenBy;

/// Most Newton steps: from a pose that is right to rounding three are needed, near a limit some more.
const STEPS: usize = 12;

/// Newton's method ends after a correction below this, in radians or parts of the mechanism's size.
const LAST_CORRECTION: f64 = UNIT_ROUNDOFF * UNIT_ROUNDOFF;

/// How much of itself the inverse of the matrix may change within the bounds, for these still to be told.
const MOST_STRETCH: f64 = 0.5;

/// The true places of points and guides, with the bounds of their errors.
#[derive(Clone, Debug)]
pub(super) struct TruePlaces {
    /// By point.
    pub points: Vec<Vector>,
    /// By slider: the unit direction of its guide.
    pub guides: Vec<Vector>,
    /// By slider: its position along the guide; of a drawn configuration, where there is a point to count from.
    pub slides: Vec<Option<Ball>>,
    /// By body: cosine and sine of its angle; none in a drawn configuration.
    pub turns: Vec<Option<Vector>>,
}

impl TruePlaces {
    /// The true places near `pose`; with infinite bounds for groups where none can be given: next to a limit position,
    /// or where numbers leave the range of f64. `None` where a drive has no position.
    pub fn new(given: &Given<'_>, pose: &Pose) -> Option<TruePlaces> {
        match given.mechanism.given_by {
            GivenBy::Lengths => Finder::new(*given, pose).placed(),
            GivenBy::Drawing => Some(TruePlaces::drawn(given)),
        }
    }

    fn drawn(given: &Given<'_>) -> TruePlaces {
        let mechanism = given.mechanism;
        let points = given_points(mechanism);
        let guides: Vec<Vector> = mechanism.slider_ids().map(|id| given.drawn_guide(id, &points)).collect();
        let slides = mechanism.sliders.iter().zip(&guides).map(|(slider, along)| {
            let from = slider.counted_from?;
            Some((points[slider.at.0] - points[from.0]).dot(*along))
        });
        TruePlaces { slides: slides.collect(), turns: vec![None; mechanism.bodies.len()], points, guides }
    }
}

/// Finds the places of one group after the other.
struct Finder<'a> {
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    /// By body: its points in its own frame.
    locals: Vec<Vec<Vector>>,
    /// By slider: its guide in the frame of its body.
    lines: Vec<[Vector; 2]>,
    /// By body: its placement, as far as it is found.
    frames: Vec<Option<Frame>>,
    slides: Vec<Ball>,
}

impl<'a> Finder<'a> {
    fn new(given: Given<'a>, pose: &'a Pose) -> Finder<'a> {
        let mechanism = given.mechanism;
        let locals: Vec<Vec<Vector>> = mechanism.body_ids().map(|id| given.locals(id)).collect();
        let line = |id: SliderId| {
            let on = mechanism.slider(id).on;
            given.line(id, |point| local(mechanism, &locals, on, point))
        };
        let slide = |id: SliderId| {
            let position = mechanism.slider(id).drive.and_then(|drive| drive.position);
            let found = || pose.slides.get(id.0).copied().flatten().unwrap_or(0.0).into();
            position.map_or_else(found, Ball::written)
        };
        Finder {
            lines: mechanism.slider_ids().map(line).collect(),
            slides: mechanism.slider_ids().map(slide).collect(),
            frames: vec![None; mechanism.bodies.len()],
            mechanism,
            pose,
            locals,
        }
    }

    fn placed(mut self) -> Option<TruePlaces> {
        for id in self.mechanism.body_ids() {
            let frame = match self.mechanism.body(id).role {
                Role::Ground => Frame::identity(),
                Role::Driver { pivot, angle, .. } => {
                    let turn = Pair::direction_of_degrees(Ball::written(angle?));
                    Frame::pinned(turn, self.local(id, pivot)?, written(self.mechanism.given[pivot.0]?))
                }
                _ => continue,
            };
            self.settle((id, frame), id, &mut Vec::new());
        }
        for group in &self.mechanism.groups {
            if self.find(group).is_none() {
                self.give_up(group);
            }
        }
        let points = self.points();
        Some(TruePlaces {
            guides: self.mechanism.slider_ids().map(|id| self.guide(id)).collect(),
            slides: self.slides.iter().copied().map(Some).collect(),
            turns: self.frames.iter().map(|frame| frame.map(|f| f.turn)).collect(),
            points,
        })
    }

    fn local(&self, body: BodyId, point: PointId) -> Option<Vector> {
        local(self.mechanism, &self.locals, body, point)
    }

    /// The places of all points whose bodies are placed; the origin for others.
    fn points(&self) -> Vec<Vector> {
        let mechanism = self.mechanism;
        let mut points = given_points(mechanism);
        // The same body decides as in a pose.
        let (known, members): (Vec<BodyId>, Vec<BodyId>) = mechanism.body_ids().partition(|&b| mechanism.is_known(b));
        for body in members.into_iter().rev().chain(known.into_iter().rev()) {
            if let Some(frame) = self.frames[body.0] {
                for (point, &local) in mechanism.body(body).points.iter().zip(&self.locals[body.0]) {
                    points[point.0] = frame.place(local);
                }
            }
        }
        points
    }

    /// The direction of a slider's guide; that in its own frame while its body is not placed.
    fn guide(&self, id: SliderId) -> Vector {
        let [_, along] = self.lines[id.0];
        self.frames[self.mechanism.slider(id).on.0].map_or(along, |frame| frame.turn.turn(along))
    }

    /// The placement of the body on the other side of a slider, seen from that of `from`.
    fn across(&self, id: SliderId, from: BodyId) -> Frame {
        let slider = self.mechanism.slider(id);
        let at = self.local(slider.link, slider.at).unwrap_or_default();
        let [through, along] = self.lines[id.0];
        let turn = along.turn(Pair::direction_of_degrees(Ball::written(slider.turned)));
        let forward = Frame::pinned(turn, at, through + along * self.slides[id.0]);
        if slider.on == from { forward } else { forward.inverse() }
    }

    /// Finds a group's angles and slides and places its links.
    fn find(&mut self, group: &Group) -> Option<()> {
        let equations = LoopEquations::new(self.mechanism, group);
        // Cosine and sine of an unknown angle in the pose; none for a slide.
        let in_pose = |unknown: usize| {
            let axis = self.pose.axes.get(equations.link_of(unknown)?.0).copied().flatten()?;
            Some(exact(Vector::from(axis).unit()))
        };
        let mut angles: Vec<Option<Vector>> = (0..equations.unknowns).map(in_pose).collect();
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            let gaps = self.gaps(group, &equations, &angles)?;
            // Rounded, and places from the first one: far origins cost no digits.
            let points = relative(&self.points());
            let guides: Vec<_> = self.mechanism.slider_ids().map(|id| self.guide(id).rounded()).collect();
            let size = span(points.iter().copied());
            let system = equations.factored(&points, &guides)?;
            let right: Numbers = gaps.iter().map(|gap| gap.high).collect();
            let correction = system.solve(&right);
            let relative = |errors: &[f64]| {
                let parts =
                    errors.iter().zip(&angles).map(|(x, angle)| x.abs() / if angle.is_some() { 1.0 } else { size });
                parts.fold(0.0, f64::max)
            };
            let change = relative(&correction);
            if !change.is_finite() {
                return None;
            }
            if change <= LAST_CORRECTION || change > 0.5 * before {
                let uncertain: Numbers = gaps.iter().map(|gap| gap.error()).collect();
                let bounds = system.error_bound(&correction, &right, &uncertain);
                let bounds: Vec<f64> = bounds.iter().zip(&correction).map(|(b, c)| b + c.abs()).collect();
                // Within the bounds the matrix turns and stretches by about as much.
                let stretch = 4.0 * system.condition() * relative(&bounds);
                if stretch.is_nan() || stretch > MOST_STRETCH {
                    return None;
                }
                let bounds: Vec<f64> = bounds.iter().map(|b| b / (1.0 - stretch)).collect();
                self.widen(&equations, &mut angles, &bounds);
                return self.gaps(group, &equations, &angles).map(|_| ());
            }
            before = change;
            self.correct(&equations, &mut angles, &correction);
        }
        None
    }

    /// Leaves a group, and all that hangs on it, without bounds.
    fn give_up(&mut self, group: &Group) {
        let equations = LoopEquations::new(self.mechanism, group);
        let unknown = Pair::default().widened(f64::INFINITY);
        for body in &group.bodies {
            self.frames[body.0] = Some(Frame { turn: unknown, origin: unknown });
        }
        for (id, _) in equations.slides {
            self.slides[id.0] = self.slides[id.0].widened(f64::INFINITY);
        }
    }

    fn correct(&mut self, equations: &LoopEquations, angles: &mut [Option<Vector>], correction: &[f64]) {
        for (angle, &step) in angles.iter_mut().zip(correction) {
            // The rotation by the arctangent of the correction.
            *angle = angle.map(|turn| exact((turn + turn.quarter_turn() * step.into()).unit()));
        }
        for &(id, unknown) in &equations.slides {
            let moved = self.slides[id.0] + correction[unknown].into();
            self.slides[id.0] = Ball { radius: 0.0, ..moved };
        }
    }

    fn widen(&mut self, equations: &LoopEquations, angles: &mut [Option<Vector>], bounds: &[f64]) {
        for (angle, &bound) in angles.iter_mut().zip(bounds) {
            *angle = angle.map(|turn| turn.unit().widened(bound));
        }
        for &(id, unknown) in &equations.slides {
            self.slides[id.0] = self.slides[id.0].widened(bounds[unknown]);
        }
    }

    /// Places the group's links by its angles and slides; the gaps left in its loops and in the relations between its angles, in the order of the
    /// equations. `None` where a link has no angle.
    fn gaps(&mut self, group: &Group, equations: &LoopEquations, angles: &[Option<Vector>]) -> Option<Vec<Ball>> {
        let turns = self.turns(group, equations, angles);
        let mut placed: Vec<BodyId> = Vec::new();
        let mut gaps = vec![Ball::default(); 2 * group.loops.len()];
        let mut waiting: Vec<_> = group.loops.iter().enumerate().collect();
        // A loop that closes on a link of the group needs that link's place first.
        while let Some(next) = waiting.iter().position(|(_, c)| !c.closed || placed.contains(&c.bodies[0])) {
            let (index, chain) = waiting.remove(next);
            let last = chain.joints.len() - 1;
            // Each loop is followed by itself, also over links that another loop has placed.
            let start = self.mechanism.side(chain.joints[0], chain.bodies[0]);
            let mut at = (start, self.frames[start.0]?);
            for (&joint, &link) in chain.joints[..last].iter().zip(&chain.bodies[1..]) {
                at = self.over(joint, at, link, &turns)?;
                self.settle(at, link, &mut placed);
            }
            let joint = chain.joints[last];
            let reached = self.joint_place(joint, self.within(at, self.mechanism.side(joint, chain.bodies[last])));
            let end = self.mechanism.side(joint, chain.bodies[last + 1]);
            let gap = self.joint_place(joint, (end, self.frames[end.0]?)) - reached;
            [gaps[2 * index], gaps[2 * index + 1]] = [gap.x, gap.y];
        }
        for (joint, from, to) in group.hanging(self.mechanism) {
            let base = self.mechanism.side(joint, from);
            let at = self.over(joint, (base, self.frames[base.0]?), to, &turns)?;
            self.settle(at, to, &mut placed);
        }
        for angular in group.gears(self.mechanism) {
            let constant = crate::geometry::Vector::new(angular.constant.re, angular.constant.im);
            let mut left = Vector::from(constant).unit();
            for &(body, weight) in &angular.terms {
                let turn = turns[body.0].or(self.frames[body.0].map(|f| f.turn))?;
                let back = if weight > 0 { turn.reversed() } else { turn };
                left = (0..weight.unsigned_abs()).fold(left, |left, _| left.turn(back));
            }
            // The angle's sine, as large as the angle up to its third power.
            gaps.push(if left.x.high < 0.0 { Ball { radius: f64::INFINITY, ..left.y } } else { left.y });
        }
        Some(gaps)
    }

    /// By body: cosine and sine of the angle, for bodies of the group: unknown angles, and what sliders make turn alike.
    fn turns(&self, group: &Group, equations: &LoopEquations, angles: &[Option<Vector>]) -> Vec<Option<Vector>> {
        let mut turns: Vec<Option<Vector>> = self.frames.iter().map(|frame| frame.map(|f| f.turn)).collect();
        for body in &group.bodies {
            turns[body.0] = None;
        }
        for (unknown, angle) in angles.iter().enumerate() {
            if let (Some(link), Some(turn)) = (equations.link_of(unknown), angle) {
                turns[link.0] = Some(*turn);
            }
        }
        loop {
            let mut found = false;
            for id in self.mechanism.slider_ids() {
                let slider = self.mechanism.slider(id);
                for (from, to) in [(slider.on, slider.link), (slider.link, slider.on)] {
                    if let (Some(turn), None, true) = (turns[from.0], turns[to.0], group.bodies.contains(&to)) {
                        turns[to.0] = Some(turn.turn(self.across(id, from).turn));
                        found = true;
                    }
                }
            }
            if !found {
                return turns;
            }
        }
    }

    /// Over a joint from a placed body of a compound link to link `to`: the body that is entered, placed.
    fn over(
        &self,
        joint: JointId,
        from: (BodyId, Frame),
        to: BodyId,
        turns: &[Option<Vector>],
    ) -> Option<(BodyId, Frame)> {
        let lead = self.mechanism.lead(from.0);
        let (base, frame) = self.within(from, self.mechanism.side(joint, lead));
        let entered = self.mechanism.side(joint, to);
        let placed = match self.mechanism.joint(joint).slider {
            Some(slider) => frame.of(&self.across(slider, base)),
            None => {
                let pin = self.mechanism.joint_point(joint);
                Frame::pinned(turns[entered.0]?, self.local(entered, pin)?, frame.place(self.local(base, pin)?))
            }
        };
        Some((entered, placed))
    }

    /// Another body of the same compound link, placed from the one that is.
    fn within(&self, (from, frame): (BodyId, Frame), to: BodyId) -> (BodyId, Frame) {
        let slides = self.mechanism.slides_between(from, to).into_iter();
        (to, slides.fold(frame, |frame, slide| frame.of(&self.across(slide.slider, slide.from))))
    }

    /// Keeps the places of link `link` and its compound link, unless they are there.
    fn settle(&mut self, at: (BodyId, Frame), link: BodyId, placed: &mut Vec<BodyId>) {
        if placed.contains(&link) {
            return;
        }
        placed.push(link);
        for body in self.mechanism.compound(link) {
            self.frames[body.0] = Some(self.within(at, body).1);
        }
    }

    /// The place of a joint on one of its bodies: the pin or the sliding point; on the guide's body the place of the
    /// guide at the slider's position.
    fn joint_place(&self, joint: JointId, (body, frame): (BodyId, Frame)) -> Vector {
        let on_guide = self.mechanism.joint(joint).slider.filter(|&id| self.mechanism.slider(id).on == body);
        let local = match on_guide {
            Some(id) => {
                let [through, along] = self.lines[id.0];
                through + along * self.slides[id.0]
            }
            // The carriage of a given angle has no point of its own: its origin slides.
            None => self.local(body, self.mechanism.joint_point(joint)).unwrap_or_default(),
        };
        frame.place(local)
    }
}

/// The places that the scene gives; the origin for other points.
fn given_points(mechanism: &Mechanism) -> Vec<Vector> {
    mechanism.given.iter().map(|place| place.map_or_else(Vector::default, written)).collect()
}

/// Places from the first one of them, rounded.
pub(super) fn relative(points: &[Vector]) -> Vec<Point> {
    let origin = points.first().copied().unwrap_or_default();
    points.iter().map(|&p| Point::from((p - origin).rounded())).collect()
}

/// The middles of both components, taken as exact.
fn exact(v: Vector) -> Vector {
    Pair { x: Ball { radius: 0.0, ..v.x }, y: Ball { radius: 0.0, ..v.y } }
}

/// The place of a body's point in the body's own frame.
fn local(mechanism: &Mechanism, locals: &[Vec<Vector>], body: BodyId, point: PointId) -> Option<Vector> {
    let index = mechanism.body(body).points.iter().position(|&p| p == point)?;
    locals[body.0].get(index).copied()
}
