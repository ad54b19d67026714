//! True places of a mechanism near a pose, with bounds of their errors.
//!
//! From lengths, Newton's method continues from the pose's angles and slides with twice the digits of f64, until only
//! the errors of what the scene gives are left. Krawczyk's test then proves that one and only one assembly lies in a box
//! about them, and |A⁻¹| says how far from its middle. As drawn, the places are those of the scene.

use super::certificate::{Near, sizes};
use super::given::{Frame, Given, Vector};
use super::locals::Locals;
use super::places::PlacesOf;
use crate::geometry::{Ball, Numbers, Pair, RADIANS_PER_TURN};
use crate::mechanism::{AngularRate, BodyId, Constant, Group, JointId, LoopEquations, PointId, Role, SliderId, Travel};
use crate::motion::Places;
use crate::position::{Pose, principal_degrees};
use crate::scene::GivenBy;

/// Most Newton steps: from a pose that is right to rounding one or two are needed, near a limit some more.
const STEPS: usize = 12;

/// An assembly whose links have turned further than this from the pose, in radians, may be another than the one that the pose rounds: f64 has lost it.
const ELSEWHERE: f64 = 0.05;

/// The last correction of an angle is at most so large: see [`Pair::turned_slightly`].
const SLIGHT: f64 = 1e-4;

/// Half a turn in degrees, less what sums of bounds may have been rounded down.
const HALF_TURN: f64 = 179.9;

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
        let points = given.places();
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
    given: Given<'a>,
    pose: &'a Pose,
    locals: Locals<'a>,
    /// By body: the sliders on it and of it.
    sliders: Vec<Vec<SliderId>>,
    /// By slider: its guide in the frame of its body.
    lines: Vec<[Vector; 2]>,
    /// By body: its placement, as far as it is found.
    frames: Vec<Option<Frame>>,
    /// By body: cosine and sine of its angle, as far as it is found.
    turns: Vec<Option<Vector>>,
    /// By body: its angle in degrees with its whole turns, of drives and of what meshes alone turn.
    counted: Vec<Option<Ball>>,
    slides: Vec<Ball>,
    /// By body: how far its points and those that slide on it are from each other, at most.
    sizes: Vec<f64>,
    /// By slider: the turn from its guide to its link's axis.
    turned: Vec<Vector>,
    /// By point, as far as they are found.
    points: Vec<Vector>,
    /// By point: whether known bodies or former groups have it.
    is_placed: Vec<bool>,
    /// By slider: the direction of its guide, as far as it is found.
    guides: Vec<Vector>,
}

impl<'a> Finder<'a> {
    fn new(given: Given<'a>, pose: &'a Pose) -> Finder<'a> {
        let mechanism = given.mechanism;
        let locals = Locals::new(given);
        let line = |id: SliderId| {
            let on = mechanism.slider(id).on;
            given.line(id, |point| locals.place(on, point))
        };
        let mut sliders = vec![Vec::new(); mechanism.bodies.len()];
        for id in mechanism.slider_ids() {
            let slider = mechanism.slider(id);
            [slider.on, slider.link].iter().for_each(|body| sliders[body.0].push(id));
        }
        let slide = |id: SliderId| {
            let position = mechanism.slider(id).drive.and_then(|drive| drive.position);
            // Where to begin: any place will do.
            let found = || Ball::within(pose.slides.get(id.0).copied().flatten().unwrap_or(0.0), 0.0);
            position.map_or_else(found, |position| given.driven_slide(position))
        };
        let points = given.places();
        let lines: Vec<[Vector; 2]> = mechanism.slider_ids().map(line).collect();
        let slides: Vec<Ball> = mechanism.slider_ids().map(slide).collect();
        Finder {
            sizes: sizes(mechanism, &locals, &lines, &slides),
            turned: mechanism.sliders.iter().map(|slider| given.direction(slider.turned)).collect(),
            frames: vec![None; mechanism.bodies.len()],
            turns: vec![None; mechanism.bodies.len()],
            counted: vec![None; mechanism.bodies.len()],
            points,
            is_placed: vec![false; mechanism.points.len()],
            guides: lines.iter().map(|[_, along]| *along).collect(),
            lines,
            slides,
            given,
            pose,
            locals,
            sliders,
        }
    }

    fn placed(mut self) -> Option<TruePlaces> {
        let mechanism = self.given.mechanism;
        for id in mechanism.body_ids() {
            let frame = match mechanism.body(id).role {
                Role::Ground => Frame::identity(),
                Role::Driver { pivot, angle, .. } => {
                    let angle = self.given.driven_angle(angle?);
                    self.counted[id.0] = Some(angle);
                    let turn = Pair::direction_of_degrees(angle);
                    Frame::pinned(turn, self.local(id, pivot)?, self.given.vector(mechanism.given[pivot.0]?))
                }
                _ => continue,
            };
            self.settle((id, frame), id, &mut Vec::new());
        }
        for (point, place) in mechanism.given.iter().enumerate() {
            self.is_placed[point] = place.is_some();
        }
        let known: Vec<BodyId> = mechanism.body_ids().filter(|body| self.frames[body.0].is_some()).collect();
        self.place_points(&known);
        self.points_are_placed(&known);
        for group in &mechanism.groups {
            if self.find(group).is_none() {
                self.give_up(group);
            }
            self.place_points(&group.bodies);
            self.points_are_placed(&group.bodies);
        }
        Some(TruePlaces {
            guides: mechanism.slider_ids().map(|id| self.guide(id)).collect(),
            slides: self.slides.iter().copied().map(Some).collect(),
            turns: self.frames.iter().map(|frame| frame.map(|f| f.turn)).collect(),
            points: self.points,
        })
    }

    fn local(&self, body: BodyId, point: PointId) -> Option<Vector> {
        self.locals.place(body, point)
    }

    /// Puts the points of bodies where these are, unless other bodies have placed them before.
    fn place_points(&mut self, bodies: &[BodyId]) {
        for body in bodies {
            let Some(frame) = self.frames[body.0] else { continue };
            for (point, &local) in self.given.mechanism.body(*body).points.iter().zip(self.locals.of(*body)) {
                if !self.is_placed[point.0] {
                    self.points[point.0] = frame.place(local);
                }
            }
        }
    }

    fn points_are_placed(&mut self, bodies: &[BodyId]) {
        for point in bodies.iter().flat_map(|body| &self.given.mechanism.body(*body).points) {
            self.is_placed[point.0] = true;
        }
    }

    /// Puts the guides of a group's loops where their bodies are.
    fn place_guides(&mut self, equations: &LoopEquations) {
        for slide in equations.loops.iter().flat_map(|terms| &terms.slides) {
            self.guides[slide.slider.0] = self.guide(slide.slider);
        }
    }

    fn places(&self) -> PlacesOf<'_> {
        PlacesOf { given: self.given, points: &self.points, guides: &self.guides }
    }

    /// The direction of a slider's guide; that in its own frame while its body is not placed.
    fn guide(&self, id: SliderId) -> Vector {
        let [_, along] = self.lines[id.0];
        self.frames[self.given.mechanism.slider(id).on.0].map_or(along, |frame| frame.turn.turn(along))
    }

    /// The placement of the body on the other side of a slider, seen from that of `from`.
    fn across(&self, id: SliderId, from: BodyId) -> Frame {
        let slider = self.given.mechanism.slider(id);
        let at = self.local(slider.link, slider.at).unwrap_or_default();
        let [through, along] = self.lines[id.0];
        let turn = along.turn(self.turned[id.0]);
        let forward = Frame::pinned(turn, at, through + along * self.slides[id.0]);
        if slider.on == from { forward } else { forward.inverse() }
    }

    /// Finds a group's angles and slides and places its links; `None` where nothing is proved of them.
    fn find(&mut self, group: &Group) -> Option<()> {
        let equations = LoopEquations::new(self.given.mechanism, group);
        // Cosine and sine of an unknown angle in the pose; none for a slide.
        let in_pose = |unknown: usize| {
            let axis = self.pose.axes.get(equations.link_of(unknown)?.0).copied().flatten()?;
            Some(Vector::within(axis, 0.0).unit())
        };
        let mut angles: Vec<Option<Vector>> = (0..equations.unknowns).map(in_pose).collect();
        let mut before = f64::INFINITY;
        let mut turned = 0.0;
        for _ in 0..STEPS {
            let gaps = self.gaps(group, &equations, &angles)?;
            self.place_points(&group.bodies);
            self.place_guides(&equations);
            let places = self.places();
            let system = equations
                .factored_of(|from, to| places.rounded_arm(from, to), |slider| places.rounded_guide(slider))?;
            let right: Numbers = gaps.iter().map(|gap| gap.high).collect();
            let correction = system.solve(&right);
            let change = system.size(correction.iter().copied());
            if !change.is_finite() {
                return None;
            }
            let by = correction.iter().zip(&angles).filter(|(_, angle)| angle.is_some());
            turned += by.map(|(x, _)| x.abs()).fold(0.0, f64::max);
            if turned > ELSEWHERE {
                return None;
            }
            let goes_on = change < 0.5 * before;
            let is_slight = correction.iter().zip(&angles).all(|(x, angle)| angle.is_none() || x.abs() <= SLIGHT);
            let near = Near { group, equations: &equations, system: &system, places, sizes: &self.sizes };
            let found = if is_slight { near.enclosed(&gaps, &correction) } else { None };
            match found {
                Some((errors, is_sharp)) if is_sharp || !goes_on => {
                    self.move_to(&equations, &mut angles, &correction, &errors);
                    self.gaps(group, &equations, &angles)?;
                    return if group.loops.is_empty() { self.count_turns(group, &equations) } else { Some(()) };
                }
                None if !goes_on => return None,
                _ => self.correct(&equations, &mut angles, &correction),
            }
            before = change;
        }
        None
    }

    /// Leaves a group, and all that hangs on it, without bounds.
    fn give_up(&mut self, group: &Group) {
        let equations = LoopEquations::new(self.given.mechanism, group);
        let unknown = Pair::default().widened(f64::INFINITY);
        for body in &group.bodies {
            self.frames[body.0] = Some(Frame { turn: unknown, origin: unknown });
            self.turns[body.0] = Some(unknown);
            self.counted[body.0] = None;
        }
        for (id, _) in equations.slides {
            self.slides[id.0] = self.slides[id.0].widened(f64::INFINITY);
        }
    }

    /// Goes on to the middle of what a correction gives.
    fn correct(&mut self, equations: &LoopEquations, angles: &mut [Option<Vector>], correction: &[f64]) {
        for (angle, &step) in angles.iter_mut().zip(correction) {
            // The rotation by the arctangent of the correction.
            *angle = angle.map(|turn| (turn + turn.quarter_turn() * Ball::within(step, 0.0)).middle().unit());
        }
        for &(id, unknown) in &equations.slides {
            self.slides[id.0] = (self.slides[id.0] + Ball::within(correction[unknown], 0.0)).middle();
            self.slid(id, correction[unknown]);
        }
    }

    /// Goes on to what a correction gives, with its errors.
    fn move_to(
        &mut self,
        equations: &LoopEquations,
        angles: &mut [Option<Vector>],
        correction: &[f64],
        errors: &[f64],
    ) {
        for ((angle, &step), &error) in angles.iter_mut().zip(correction).zip(errors) {
            *angle = angle.map(|turn| turn.turned_slightly(step).widened(error));
        }
        for &(id, unknown) in &equations.slides {
            self.slides[id.0] = self.slides[id.0] + Ball::within(correction[unknown], errors[unknown]);
        }
    }

    /// Bodies joined by a slider reach as much farther as it has moved.
    fn slid(&mut self, id: SliderId, step: f64) {
        let slider = self.given.mechanism.slider(id);
        for body in [slider.on, slider.link] {
            self.sizes[body.0] += 2.0 * step.abs();
        }
    }

    /// Places the group's links by its angles and slides; the gaps left in its loops and in the relations between its angles, in the order of the
    /// equations. `None` where a link has no angle.
    fn gaps(&mut self, group: &Group, equations: &LoopEquations, angles: &[Option<Vector>]) -> Option<Vec<Ball>> {
        self.turn_group(group, equations, angles);
        let mut placed: Vec<BodyId> = Vec::new();
        let mut gaps = vec![Ball::default(); 2 * group.loops.len()];
        let mut waiting: Vec<_> = group.loops.iter().enumerate().collect();
        // A loop that closes on a link of the group needs that link's place first.
        while let Some(next) = waiting.iter().position(|(_, c)| !c.closed || placed.contains(&c.bodies[0])) {
            let (index, chain) = waiting.remove(next);
            let last = chain.joints.len() - 1;
            // Each loop is followed by itself, also over links that another loop has placed.
            let start = self.given.mechanism.side(chain.joints[0], chain.bodies[0]);
            let mut at = (start, self.frames[start.0]?);
            for (&joint, &link) in chain.joints[..last].iter().zip(&chain.bodies[1..]) {
                at = self.over(joint, at, link)?;
                self.settle(at, link, &mut placed);
            }
            let joint = chain.joints[last];
            let reached =
                self.joint_place(joint, self.within(at, self.given.mechanism.side(joint, chain.bodies[last])));
            let end = self.given.mechanism.side(joint, chain.bodies[last + 1]);
            let gap = self.joint_place(joint, (end, self.frames[end.0]?)) - reached;
            [gaps[2 * index], gaps[2 * index + 1]] = [gap.x, gap.y];
        }
        for (joint, from, to) in group.hanging(self.given.mechanism) {
            let base = self.given.mechanism.side(joint, from);
            let at = self.over(joint, (base, self.frames[base.0]?), to)?;
            self.settle(at, to, &mut placed);
        }
        for angular in group.gears(self.given.mechanism) {
            // Bodies that turn alike need no equation.
            let Constant::Phase { times, degrees } = angular.constant else { return None };
            let mut left = Pair::direction_of_degrees(self.given.number(degrees) * times.into());
            for &(body, weight) in &angular.terms {
                let turn = self.turns[body.0].or(self.frames[body.0].map(|f| f.turn))?;
                let back = if weight > 0 { turn.reversed() } else { turn };
                left = left.turn(back.times(weight.unsigned_abs()));
            }
            if let Some(travel) = &angular.travel {
                left = left.turn(Pair::direction_of_degrees(self.travelled(travel)));
            }
            // The angle's sine, as large as the angle up to its third power.
            gaps.push(if left.x.high < 0.0 { Ball { radius: f64::INFINITY, ..left.y } } else { left.y });
        }
        Some(gaps)
    }

    /// Counts the whole turns of wheels that meshes alone turn; `None` where they stand elsewhere than these say.
    ///
    /// As directions, meshes hold for each tooth by which a wheel may be shifted, and a pose rounded to f64 may be nearer to one that is not
    /// meant. As numbers they have one solution. What was found solves the meshes up to whole turns: where its distance from that solution
    /// adds up to less than half a turn in each mesh, it is that solution.
    fn count_turns(&mut self, group: &Group, equations: &LoopEquations) -> Option<()> {
        let mechanism = self.given.mechanism;
        let mut rows = Vec::new();
        for (relation, own) in group.gears(mechanism).zip(&equations.angular) {
            let Constant::Phase { times, degrees } = relation.constant else { return None };
            let (mut row, mut right) =
                (vec![Ball::default(); equations.unknowns], self.given.number(degrees) * times.into());
            for &(body, weight) in &relation.terms {
                let weight = Ball::from(weight);
                match equations.angular_rate_of(body) {
                    AngularRate::Unknown(unknown) => {
                        let first = equations.link_of(unknown)?;
                        row[unknown] = row[unknown] + weight;
                        right = right - weight * principal(self.within((first, Frame::identity()), body).1.turn);
                    }
                    AngularRate::Known(other) => {
                        let of_frame = || Some(principal(self.frames[other.0]?.turn));
                        right = right - weight * self.counted[other.0].or_else(of_frame)?;
                    }
                }
            }
            if let (Some(travel), Some(terms)) = (&relation.travel, &own.travel) {
                let degrees = self.degrees_of_travel(travel);
                right = right - self.given.number(travel.start) * degrees;
                for slide in &terms.slides {
                    match slide.unknown {
                        Some(unknown) => row[unknown] = row[unknown] - degrees.signed(slide.sign),
                        None => right = right + (self.slides[slide.slider.0] * degrees).signed(slide.sign),
                    }
                }
            }
            row.push(right);
            rows.push(row);
        }
        let found = solved(rows.clone())?;
        let mut apart = vec![0.0; equations.unknowns];
        for (unknown, angle) in found.iter().enumerate() {
            if let Some(link) = equations.link_of(unknown) {
                apart[unknown] = self.turns[link.0]?.degrees_from(angle.high) + angle.error();
                self.counted[link.0] = Some(*angle);
            }
        }
        for &(slider, unknown) in &equations.slides {
            apart[unknown] = (self.slides[slider.0] - found[unknown]).largest();
        }
        let in_mesh = |row: &Vec<Ball>| row.iter().zip(&apart).map(|(x, apart)| x.largest() * apart).sum::<f64>();
        rows.iter().all(|row| in_mesh(row) < HALF_TURN).then_some(())
    }

    /// The angle, in degrees, by which a wheel turns where something slides by one unit of length.
    fn degrees_of_travel(&self, travel: &Travel) -> Ball {
        Ball::from(360) / (self.given.number(travel.radius) * RADIANS_PER_TURN)
    }

    /// The angle, in degrees, by which what has slid turns a wheel.
    fn travelled(&self, travel: &Travel) -> Ball {
        let slides = travel.slides.iter();
        let way =
            slides.fold(-self.given.number(travel.start), |way, &(id, sign)| way + self.slides[id.0].signed(sign));
        way * self.degrees_of_travel(travel)
    }

    /// Turns the bodies of the group: by unknown angles, and by what sliders make turn alike.
    fn turn_group(&mut self, group: &Group, equations: &LoopEquations, angles: &[Option<Vector>]) {
        for body in &group.bodies {
            self.turns[body.0] = None;
        }
        for (unknown, angle) in angles.iter().enumerate() {
            if let (Some(link), Some(turn)) = (equations.link_of(unknown), angle) {
                self.turns[link.0] = Some(*turn);
            }
        }
        let mut sliders: Vec<SliderId> =
            group.bodies.iter().flat_map(|body| self.sliders[body.0].iter().copied()).collect();
        sliders.sort_unstable_by_key(|id| id.0);
        sliders.dedup();
        loop {
            let mut found = false;
            for &id in &sliders {
                let slider = self.given.mechanism.slider(id);
                for (from, to) in [(slider.on, slider.link), (slider.link, slider.on)] {
                    if let (Some(turn), None, true) = (self.turns[from.0], self.turns[to.0], group.bodies.contains(&to))
                    {
                        self.turns[to.0] = Some(turn.turn(self.across(id, from).turn));
                        found = true;
                    }
                }
            }
            if !found {
                return;
            }
        }
    }

    /// Over a joint from a placed body of a compound link to link `to`: the body that is entered, placed.
    fn over(&self, joint: JointId, from: (BodyId, Frame), to: BodyId) -> Option<(BodyId, Frame)> {
        let lead = self.given.mechanism.lead(from.0);
        let (base, frame) = self.within(from, self.given.mechanism.side(joint, lead));
        let entered = self.given.mechanism.side(joint, to);
        let placed = match self.given.mechanism.joint(joint).slider {
            Some(slider) => frame.of(&self.across(slider, base)),
            None => {
                let pin = self.given.mechanism.joint_point(joint);
                Frame::pinned(self.turns[entered.0]?, self.local(entered, pin)?, frame.place(self.local(base, pin)?))
            }
        };
        Some((entered, placed))
    }

    /// Another body of the same compound link, placed from the one that is.
    fn within(&self, (from, frame): (BodyId, Frame), to: BodyId) -> (BodyId, Frame) {
        let slides = self.given.mechanism.slides_between(from, to).into_iter();
        (to, slides.fold(frame, |frame, slide| frame.of(&self.across(slide.slider, slide.from))))
    }

    /// Keeps the places of link `link` and its compound link, unless they are there.
    fn settle(&mut self, at: (BodyId, Frame), link: BodyId, placed: &mut Vec<BodyId>) {
        if placed.contains(&link) {
            return;
        }
        placed.push(link);
        for body in self.given.mechanism.compound(link) {
            let frame = self.within(at, body).1;
            self.frames[body.0] = Some(frame);
            self.turns[body.0] = Some(frame.turn);
        }
    }

    /// The place of a joint on one of its bodies: the pin or the sliding point; on the guide's body the place of the
    /// guide at the slider's position.
    fn joint_place(&self, joint: JointId, (body, frame): (BodyId, Frame)) -> Vector {
        let on_guide =
            self.given.mechanism.joint(joint).slider.filter(|&id| self.given.mechanism.slider(id).on == body);
        let local = match on_guide {
            Some(id) => {
                let [through, along] = self.lines[id.0];
                through + along * self.slides[id.0]
            }
            // The carriage of a given angle has no point of its own: its origin slides.
            None => self.local(body, self.given.mechanism.joint_point(joint)).unwrap_or_default(),
        };
        frame.place(local)
    }
}

/// An angle by its cosine and sine, in degrees from −180 to 180, at the ends as a pose has it.
fn principal(turn: Vector) -> Ball {
    let degrees = principal_degrees(turn.rounded());
    Ball::within(degrees, turn.degrees_from(degrees))
}

/// The solution of linear equations, each with its right side at its end, by elimination; `None` where a pivot may be zero.
fn solved(mut rows: Vec<Vec<Ball>>) -> Option<Vec<Ball>> {
    let unknowns = rows.len();
    for at in 0..unknowns {
        let size = |row: &usize| rows[*row][at].smallest();
        let pivot = (at..unknowns).max_by(|a, b| size(a).total_cmp(&size(b))).filter(|row| size(row) > 0.0)?;
        rows.swap(at, pivot);
        let first = rows[at].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, row)| *other != at && row[at] != Ball::default()) {
            let part = row[at] / first[at];
            row.iter_mut().zip(&first).skip(at).for_each(|(x, pivot)| *x = *x - part * *pivot);
        }
    }
    rows.iter().enumerate().map(|(at, row)| Some(*row.last()? / row[at])).collect()
}
