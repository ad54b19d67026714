//! What stands on the line of centres, and at which heights.
//!
//! The line is that with most meshes. Wheels whose centres lie elsewhere are turned onto it where that changes no speed. With all centres on the
//! frame a wheel and all that follows it may be turned about the centre of a wheel with which it meshes: distances, radii and rim speeds
//! stay. On a carrier that turns about a fixed point a centre may be turned about that point, if the centres of the mesh lie on one line
//! with it: velocities turn along.

use super::{BeltLine, PitchCircle, PitchLine, SpeedDiagram, SpeedSpot, SpotName};
use crate::construction::train::name_of_touch;
use crate::construction::writer::Writer;
use crate::geometry::{Point, Vector, quarter_turn, span, unit};
use crate::mechanism::{BodyId, GROUND, Joint, JointId, PointId};

/// How far a centre may lie off a line of centres, in parts of the size of the mechanism: places of drawn scenes are rounded.
const OFF_LINE: f64 = 1e-6;

/// Wheels that mesh, a wheel and its rack, or wheels with a belt.
#[derive(Clone, Copy)]
pub(super) struct Pair<'a> {
    pub id: JointId,
    pub joint: &'a Joint,
    pub carrier: BodyId,
}

impl Pair<'_> {
    /// The centres of its wheels: two, or one of a wheel on a rack.
    fn centers(&self) -> Vec<PointId> {
        let both = self.joint.pitch.map(|pitch| pitch.centers).or(self.joint.belt.map(|belt| belt.centers));
        both.map_or_else(|| self.joint.rack.iter().map(|rack| rack.center).collect(), |both| both.to_vec())
    }

    /// The bodies with the spots of each on the line.
    pub(super) fn spots_of_bodies(&self) -> Vec<(BodyId, Vec<SpotName>)> {
        let centers: Vec<SpotName> = self.centers().into_iter().map(SpotName::Center).collect();
        let touch = |side: usize| match self.joint.belt {
            Some(_) => SpotName::Rim(self.id, side),
            None => SpotName::Pitch(self.id),
        };
        let is_rack = |side: usize| self.joint.rack.is_some_and(|rack| rack.wheel != side);
        let of_side = |side: usize| {
            let center = if is_rack(side) { None } else { centers.get(side).or(centers.first()) };
            (self.joint.bodies[side], center.copied().into_iter().chain([touch(side)]).collect())
        };
        vec![of_side(0), of_side(1), (self.carrier, centers.clone())]
    }
}

/// A centre on the line.
#[derive(Clone, Copy)]
struct Laid {
    center: PointId,
    height: f64,
    /// The part of its velocity to the right.
    velocity: f64,
    is_turned: bool,
}

/// A line of centres with what stands on it.
struct Line {
    /// A place on it, and the direction upwards.
    from: Point,
    along: Vector,
    /// How far off it a centre may be.
    most: f64,
    laid: Vec<Laid>,
    /// Of racks and first wheels of belts: how far above the centre the wheel touches.
    touches: Vec<(JointId, f64)>,
}

impl Line {
    fn laid(&self, center: PointId) -> Option<&Laid> {
        self.laid.iter().find(|laid| laid.center == center)
    }

    fn height(&self, center: PointId) -> Option<f64> {
        self.laid(center).map(|laid| laid.height)
    }

    fn lay(&mut self, laid: Laid) {
        if self.laid(laid.center).is_none() {
            self.laid.push(laid);
        }
    }

    /// The side on which fewer centres lie, seen from a height: +1 above, −1 below.
    fn free_side(&self, height: f64) -> f64 {
        let count = |is_there: &dyn Fn(f64) -> bool| self.laid.iter().filter(|laid| is_there(laid.height)).count();
        let [above, below] = [count(&|own| own > height + self.most), count(&|own| own < height - self.most)];
        if above <= below { 1.0 } else { -1.0 }
    }

    /// How far above the centre of its wheel something touches.
    fn touch(&self, joint: JointId) -> f64 {
        self.touches.iter().find(|(own, _)| *own == joint).map_or(0.0, |(_, touch)| *touch)
    }
}

impl Writer<'_> {
    pub(super) fn speed_diagram(&self) -> Option<SpeedDiagram> {
        let pairs = self.pairs();
        let lines = pairs.iter().filter_map(|pair| self.line_of(pair));
        let count = |line: &Line| pairs.iter().filter(|pair| self.is_on(line, pair)).count();
        // The line with most pairs; of these that onto which most others can be turned; the first of these.
        let filled = lines.rev().map(|line| (count(&line), self.filled(line, &pairs)));
        let (_, (line, own)) = filled.max_by_key(|(straight, (_, own))| (*straight, own.len()))?;
        let (own, rest): (Vec<Pair<'_>>, Vec<Pair<'_>>) = pairs.into_iter().partition(|pair| own.contains(&pair.id));
        let [upwards, downwards] = [1.0, -1.0].map(|way| self.diagram_along(&line, &own, way));
        // Parallels have room below, where circles reach farther.
        let mut diagram = if downwards.room_below() > upwards.room_below() { downwards } else { upwards };
        diagram.left_out = rest.iter().map(|pair| name_of_touch(self.mechanism, pair.id, 0)).collect();
        self.order_lines(&mut diagram, &own);
        Some(diagram)
    }

    /// A line with all pairs that are on it or can be turned onto it.
    fn filled(&self, mut line: Line, pairs: &[Pair<'_>]) -> (Line, Vec<JointId>) {
        let mut own: Vec<JointId> = Vec::new();
        for pair in pairs {
            if self.is_on(&line, pair) {
                self.lay_own(&mut line, pair);
                own.push(pair.id);
            }
        }
        let mut before = 0;
        while before < own.len() {
            before = own.len();
            for pair in pairs {
                if !own.contains(&pair.id) && self.turn_onto(&mut line, pair) {
                    own.push(pair.id);
                }
            }
        }
        (line, own)
    }

    /// The pairs of wheels with pitch points, and racks that slide without turning and belts on the frame whose size is known.
    fn pairs(&self) -> Vec<Pair<'_>> {
        let joints = self.mechanism.joints.iter().enumerate();
        let pair = |(index, joint): (usize, _)| {
            let joint: &Joint = joint;
            let carrier = joint.related_bodies().find(|body| !joint.bodies.contains(body))?;
            let is_known = match (joint.rack, joint.belt) {
                (Some(rack), _) => [joint.bodies[1 - rack.wheel], carrier].iter().all(|body| self.is_straight(*body)),
                (_, Some(belt)) => belt.is_sized && carrier == GROUND,
                _ => joint.pitch.is_some(),
            };
            is_known.then_some(Pair { id: JointId(index), joint, carrier })
        };
        joints.filter_map(pair).collect()
    }

    fn is_straight(&self, body: BodyId) -> bool {
        self.motion.body(body).omega == 0.0
    }

    /// The line of the centres of a pair, or that through a wheel's centre normal to its rack.
    fn line_of(&self, pair: &Pair<'_>) -> Option<Line> {
        let (from, way) = match pair.joint.rack {
            Some(rack) => {
                let way = self.to_rack(pair)?;
                // What is above in the mechanism is above in the diagram.
                let is_down = way.y < 0.0 || (way.y == 0.0 && way.x < 0.0);
                (self.pose.point(rack.center), if is_down { -way } else { way })
            }
            None => {
                let centers = pair.centers();
                let [from, to] = [self.pose.point(centers[0]), self.pose.point(*centers.get(1)?)];
                (from, to - from)
            }
        };
        let along = unit(way).filter(|_| way.norm() > self.near)?;
        let most = OFF_LINE * span(self.pose.points.iter().copied()).max(way.norm());
        Some(Line { from, along, most, laid: Vec::new(), touches: Vec::new() })
    }

    /// From the centre of a wheel to where it touches its rack.
    fn to_rack(&self, pair: &Pair<'_>) -> Option<Vector> {
        let rack = pair.joint.rack?;
        Some(quarter_turn(self.pose.guide(rack.slider)) * (-rack.side * rack.radius))
    }

    /// Whether the centres of a pair lie on a line, and a rack is normal to it.
    fn is_on(&self, line: &Line, pair: &Pair<'_>) -> bool {
        let off = |way: Vector| way.perp(&line.along).abs();
        let is_normal = self.to_rack(pair).is_none_or(|way| off(way) <= line.most);
        let has_line = self.line_of(pair).is_some();
        is_normal && has_line && pair.centers().iter().all(|&at| off(self.pose.point(at) - line.from) <= line.most)
    }

    /// Lays the centres of a pair that is on the line.
    fn lay_own(&self, line: &mut Line, pair: &Pair<'_>) {
        let right = -quarter_turn(line.along);
        for center in pair.centers() {
            let place = self.pose.point(center);
            let velocity = self.motion.body(pair.carrier).velocity_at(place).dot(&right);
            line.lay(Laid { center, height: (place - line.from).dot(&line.along), velocity, is_turned: false });
        }
        if let Some(way) = self.to_rack(pair) {
            line.touches.push((pair.id, way.dot(&line.along)));
        }
        self.touch_belt(line, pair);
    }

    /// The first wheel of a belt has its rim's velocity where that faces the second one, if the belt is crossed, else above.
    fn touch_belt(&self, line: &mut Line, pair: &Pair<'_>) {
        let Some(belt) = pair.joint.belt else { return };
        let [first, second] = belt.centers.map(|center| line.height(center).unwrap_or_default());
        let is_below = belt.is_crossed && second < first;
        line.touches.push((pair.id, if is_below { -belt.radii[0] } else { belt.radii[0] }));
    }

    /// Turns the centres of a pair onto the line; false where that would change a speed.
    fn turn_onto(&self, line: &mut Line, pair: &Pair<'_>) -> bool {
        let is_turned = match (pair.carrier, pair.joint.rack) {
            (GROUND, Some(rack)) => {
                let height = line.height(rack.center);
                let touches = height.map(|height| (pair.id, line.free_side(height) * rack.radius));
                line.touches.extend(touches);
                height.is_some()
            }
            (_, Some(_)) => false,
            (GROUND, None) => self.turn_on_frame(line, pair),
            (carrier, None) => self.turn_on_carrier(line, pair, carrier),
        };
        if is_turned {
            self.touch_belt(line, pair);
        }
        is_turned
    }

    fn turn_on_frame(&self, line: &mut Line, pair: &Pair<'_>) -> bool {
        let &[first, second] = pair.centers().as_slice() else { return false };
        let distance = self.pose.arm(first, second).norm();
        let on_line = [first, second].map(|center| line.height(center));
        let (center, height) = match on_line {
            [Some(a), Some(b)] => return ((b - a).abs() - distance).abs() <= line.most,
            [Some(height), None] => (second, height),
            [None, Some(height)] => (first, height),
            [None, None] => return false,
        };
        let height = height + line.free_side(height) * distance;
        line.lay(Laid { center, height, velocity: 0.0, is_turned: true });
        true
    }

    /// The centres must lie on one line with the fixed point about which the carrier turns.
    fn turn_on_carrier(&self, line: &mut Line, pair: &Pair<'_>, carrier: BodyId) -> bool {
        let of_carrier = &self.mechanism.body(carrier).points;
        let Some(&pivot) = of_carrier.iter().find(|point| self.mechanism.body(GROUND).has(**point)) else {
            return false;
        };
        let centers = pair.centers();
        let arms: Vec<Vector> = centers.iter().map(|&center| self.pose.arm(pivot, center)).collect();
        let farthest = arms.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let (Some(low), Some(ray)) = (line.height(pivot), farthest.and_then(unit)) else { return false };
        if arms.iter().any(|arm| arm.perp(&ray).abs() > line.most) {
            return false;
        }
        let lengths: Vec<f64> = arms.iter().map(|arm| arm.dot(&ray)).collect();
        let of_known = centers.iter().zip(&lengths).find_map(|(&center, length)| {
            let height = line.height(center)? - low;
            (length.abs() > line.most).then(|| (height * length).signum())
        });
        let side = of_known.unwrap_or_else(|| line.free_side(low));
        let heights: Vec<f64> = lengths.iter().map(|length| low + side * length).collect();
        let is_apart = |(&center, height): (&PointId, &f64)| {
            line.height(center).is_some_and(|own| (own - height).abs() > line.most)
        };
        if centers.iter().zip(&heights).any(is_apart) {
            return false;
        }
        let omega = self.motion.body(carrier).omega;
        for (center, height) in centers.into_iter().zip(heights) {
            line.lay(Laid { center, height, velocity: -omega * (height - low), is_turned: true });
        }
        true
    }

    /// The spots and circles of some pairs along a line, upwards (+1) or downwards (−1).
    fn diagram_along(&self, line: &Line, pairs: &[Pair<'_>], way: f64) -> SpeedDiagram {
        let mut diagram = SpeedDiagram {
            along: line.along * way,
            spots: Vec::new(),
            lines: Vec::new(),
            circles: Vec::new(),
            racks: Vec::new(),
            belts: Vec::new(),
            steps: Vec::new(),
            turned: line.laid.iter().filter(|laid| laid.is_turned).map(|laid| laid.center).collect(),
            left_out: Vec::new(),
            turns: None,
        };
        for pair in pairs {
            self.add_pair(&mut diagram, line, pair, way);
        }
        diagram.spots.sort_by(|a, b| a.height.total_cmp(&b.height));
        diagram.count_from_lowest();
        for (belt, pair) in diagram.belts.iter_mut().zip(pairs.iter().filter(|pair| pair.joint.belt.is_some())) {
            let rim = |side| diagram.spots.iter().position(|spot| spot.at == SpotName::Rim(pair.id, side));
            belt.rims = [0, 1].map(|side| rim(side).unwrap_or_default());
        }
        diagram
    }

    fn add_pair(&self, diagram: &mut SpeedDiagram, line: &Line, pair: &Pair<'_>, way: f64) {
        let laid: Vec<Laid> = pair.centers().iter().filter_map(|&center| line.laid(center).copied()).collect();
        let Some(&first) = laid.first() else { return };
        let wheels: Vec<Laid> = vec![first, laid.get(1).copied().unwrap_or(first)];
        let heights = [0, 1].map(|side| way * wheels[side].height);
        let touches = match (pair.joint.pitch, pair.joint.belt) {
            (Some(pitch), _) => [heights[0] + (heights[1] - heights[0]) * pitch.share::<f64>(); 2],
            (_, Some(belt)) => {
                let up = way * line.touch(pair.id);
                let other = if belt.is_crossed { -up.signum() } else { up.signum() };
                [heights[0] + up, heights[1] + other * belt.radii[1]]
            }
            _ => [heights[0] + way * line.touch(pair.id); 2],
        };
        for laid in &laid {
            let name = self.mechanism.point_name(laid.center).to_owned();
            let (height, velocity) = (way * laid.height, way * laid.velocity);
            diagram.add(SpeedSpot { at: SpotName::Center(laid.center), name, height, velocity });
        }
        let is_wheel = |side: &usize| pair.joint.rack.is_none_or(|rack| rack.wheel == *side);
        for side in [0, 1].into_iter().filter(is_wheel) {
            let link = pair.joint.bodies[side];
            let (center, touch) = (heights[side], touches[side]);
            let at = if pair.joint.belt.is_some() { SpotName::Rim(pair.id, side) } else { SpotName::Pitch(pair.id) };
            let velocity = way * wheels[side].velocity - self.motion.body(link).omega * (touch - center);
            let name = name_of_touch(self.mechanism, pair.id, side);
            diagram.add(SpeedSpot { at, name, height: touch, velocity });
            let is_ring = pair.joint.pitch.is_some_and(|pitch| pitch.teeth[side] < 0);
            diagram.circles.push(PitchCircle { link, center, radius: (touch - center).abs(), touch, is_ring });
        }
        if let Some(rack) = pair.joint.rack {
            let link = pair.joint.bodies[1 - rack.wheel];
            diagram.racks.push(PitchLine { link, height: touches[0], wheel: [heights[0], rack.radius] });
        }
        if let Some(belt) = pair.joint.belt {
            let (radii, is_crossed) = (belt.radii, belt.is_crossed);
            diagram.belts.push(BeltLine { centers: heights, radii, is_crossed, rims: [0; 2] });
        }
    }
}

impl SpeedDiagram {
    fn add(&mut self, spot: SpeedSpot) {
        if !self.spots.iter().any(|own| own.at == spot.at) {
            self.spots.push(spot);
        }
    }

    /// Makes the lowest spot that from which heights count.
    fn count_from_lowest(&mut self) {
        let lowest = self.spots.first().map_or(0.0, |spot| spot.height);
        self.spots.iter_mut().for_each(|spot| spot.height -= lowest);
        for circle in &mut self.circles {
            circle.center -= lowest;
            circle.touch -= lowest;
        }
        for rack in &mut self.racks {
            rack.height -= lowest;
            rack.wheel[0] -= lowest;
        }
        self.belts.iter_mut().flat_map(|belt| &mut belt.centers).for_each(|height| *height -= lowest);
    }
}
