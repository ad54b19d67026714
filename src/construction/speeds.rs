//! Kutzbach's speed diagram of a train: the velocities along a line of centres, and the angular velocities that follow from them.
//!
//! On the line of the centres of wheels that mesh, the velocities of the points of each wheel, laid off normal to it, end on one straight line,
//! and two wheels that mesh have one such velocity at their pitch point. The steeper the line, the faster the wheel turns: parallels to all of
//! them through one point cut lengths off a base that are in proportion to the angular velocities (K. Kutzbach, *Mehrgliedrige
//! Radgetriebe und ihre Gesetze*, Maschinenbau, 1927). Of velocities along the line of centres nothing is drawn: they are the same for all points.

use super::markup::{Formula, marked, rate_symbol};
use super::number::Rate;
use super::sentence::Teller;
use super::step::Action;
use super::writer::Writer;
use crate::geometry::{Point, Vector, span, unit};
use crate::mechanism::{BodyId, GROUND, JointId, PointId};
use crate::scene::Scene;
use crate::sheet::{Order, QuantityKind, Sheet};
use std::f64::consts::TAU;

/// How far a centre may lie off a line of centres, in parts of the size of the mechanism: places of drawn scenes are rounded.
const OFF_LINE: f64 = 1e-6;

/// The diagram. Heights are distances along the line of centres from its lowest place, in units of length.
#[derive(Clone, Debug)]
pub struct SpeedDiagram {
    /// The direction in the mechanism that is upwards in the diagram.
    pub along: Vector,
    /// Centres and pitch points on the line of centres, the lowest first.
    pub spots: Vec<SpeedSpot>,
    /// The wheels and carriers, in the order in which their lines are drawn.
    pub lines: Vec<SpeedLine>,
    /// The pitch circles.
    pub circles: Vec<PitchCircle>,
    /// Meshes whose centres lie on another line.
    pub left_out: Vec<JointId>,
    /// What an angular velocity is multiplied by to give turns a minute, where a drive of the scene is given in these.
    pub turns: Option<f64>,
}

/// A centre or a pitch point.
#[derive(Clone, Copy, Debug)]
pub struct SpeedSpot {
    /// Which it is.
    pub at: SpotName,
    /// Its height.
    pub height: f64,
    /// The part of its velocity to the right of the line of centres, which points upwards.
    pub velocity: f64,
}

/// What has a velocity in the diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpotName {
    /// A centre.
    Center(PointId),
    /// The pitch point of a mesh.
    Pitch(JointId),
}

/// A wheel or a carrier with the line on which its velocities end.
#[derive(Clone, Debug)]
pub struct SpeedLine {
    /// The link.
    pub link: BodyId,
    /// The spots on it, the lowest first.
    pub spots: Vec<usize>,
    /// The two of them through whose velocities the line is drawn.
    pub through: [usize; 2],
    /// Whether these follow from lines that are there; else its motion is given, or found with that of others.
    pub follows: bool,
    /// Its angular velocity.
    pub omega: f64,
}

/// A pitch circle.
#[derive(Clone, Copy, Debug)]
pub struct PitchCircle {
    /// The wheel.
    pub link: BodyId,
    /// The height of its centre.
    pub center: f64,
    /// Its radius.
    pub radius: f64,
    /// The height where it touches the other wheel.
    pub touch: f64,
    /// Whether its teeth are inside.
    pub is_ring: bool,
}

/// What is done in a step of the diagram; lines by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedStep {
    /// Draw the line of centres.
    Train,
    /// Draw the line of a link.
    Line(usize),
    /// Choose the point through which parallels are drawn.
    Pole,
    /// Draw the parallel to the line of a link.
    Ray(usize),
}

/// A line of centres: a place on it and its direction.
type CenterLine = (Point, Vector);

impl Writer<'_> {
    /// Draws the diagram, if there are wheels that mesh.
    pub(super) fn speeds(&mut self, scene: &Scene) {
        let Some(mut diagram) = self.speed_diagram() else { return };
        let is_in_turns = scene.links.values().any(|link| link.drive.is_some_and(|drive| drive.rpm.is_some()));
        diagram.turns = is_in_turns.then(|| scene.units.time.in_a_minute() / TAU);
        let lines = (0..diagram.lines.len()).map(SpeedStep::Line);
        let rays = (0..diagram.lines.len()).map(SpeedStep::Ray);
        for step in [SpeedStep::Train].into_iter().chain(lines).chain([SpeedStep::Pole]).chain(rays) {
            let begun = self.begin(Sheet::Speeds);
            self.finish(begun, Action::Speeds(step));
        }
        self.construction.speeds = Some(diagram);
    }

    fn speed_diagram(&self) -> Option<SpeedDiagram> {
        let meshes = self.meshes();
        let lines = meshes.iter().filter_map(|&joint| self.line_of_centers(joint));
        // The line with most meshes, the first of these.
        let count = |line: &CenterLine| meshes.iter().filter(|&&joint| self.is_on(line, joint)).count();
        let line = lines.rev().max_by_key(count)?;
        let own: Vec<JointId> = meshes.iter().copied().filter(|&joint| self.is_on(&line, joint)).collect();
        let upwards = self.diagram_along(line, &own);
        let downwards = self.diagram_along((line.0, -line.1), &own);
        // Parallels have room below, where circles reach farther.
        let mut diagram = if downwards.room_below() > upwards.room_below() { downwards } else { upwards };
        diagram.left_out = meshes.into_iter().filter(|joint| !own.contains(joint)).collect();
        diagram.lines = self.speed_lines(&diagram, &own);
        Some(diagram)
    }

    /// The pairs of wheels with pitch points.
    fn meshes(&self) -> Vec<JointId> {
        let joints = self.mechanism.joints.iter().enumerate();
        joints.filter(|(_, joint)| joint.pitch.is_some()).map(|(index, _)| JointId(index)).collect()
    }

    fn line_of_centers(&self, joint: JointId) -> Option<CenterLine> {
        let [from, to] = self.mechanism.joint(joint).pitch?.centers.map(|center| self.pose.point(center));
        Some((from, unit(to - from).filter(|_| (to - from).norm() > self.near)?))
    }

    /// Whether both centres of a mesh lie on a line.
    fn is_on(&self, (from, along): &CenterLine, joint: JointId) -> bool {
        let most = OFF_LINE * span(self.pose.points.iter().copied());
        let Some(pitch) = self.mechanism.joint(joint).pitch else { return false };
        let off = |center: PointId| (self.pose.point(center) - from).perp(along).abs();
        self.line_of_centers(joint).is_some() && pitch.centers.into_iter().all(|center| off(center) <= most)
    }

    /// The spots and circles of some meshes along their line.
    fn diagram_along(&self, (from, along): CenterLine, meshes: &[JointId]) -> SpeedDiagram {
        let height = |at: Point| (at - from).dot(&along);
        let right = |v: Vector| v.dot(&Vector::new(along.y, -along.x));
        let (mut spots, mut circles): (Vec<SpeedSpot>, Vec<PitchCircle>) = (Vec::new(), Vec::new());
        for &joint in meshes {
            let own = self.mechanism.joint(joint);
            let (Some(pitch), Some(carrier)) = (own.pitch, own.related_bodies().nth(2)) else { continue };
            let centers = pitch.centers.map(|center| self.pose.point(center));
            let touch = centers[0] + (centers[1] - centers[0]) * pitch.share::<f64>();
            let of_center = |center: PointId| (SpotName::Center(center), self.pose.point(center), carrier);
            let found =
                pitch.centers.map(of_center).into_iter().chain([(SpotName::Pitch(joint), touch, own.bodies[0])]);
            for (at, place, body) in found {
                let velocity = right(self.motion.body(body).velocity_at(place));
                if !spots.iter().any(|spot| spot.at == at) {
                    spots.push(SpeedSpot { at, height: height(place), velocity });
                }
            }
            for (side, link) in own.bodies.into_iter().enumerate() {
                let radius = (touch - centers[side]).norm();
                let (center, touch) = (height(centers[side]), height(touch));
                circles.push(PitchCircle { link, center, radius, touch, is_ring: pitch.teeth[side] < 0 });
            }
        }
        spots.sort_by(|a, b| a.height.total_cmp(&b.height));
        let lowest = spots.first().map_or(0.0, |spot| spot.height);
        spots.iter_mut().for_each(|spot| spot.height -= lowest);
        for circle in &mut circles {
            circle.center -= lowest;
            circle.touch -= lowest;
        }
        SpeedDiagram { along, spots, lines: Vec::new(), circles, left_out: Vec::new(), turns: None }
    }

    /// The lines of all wheels and carriers that move, in an order in which each but those that are given goes through two velocities that are
    /// there, as far as there is one.
    fn speed_lines(&self, diagram: &SpeedDiagram, meshes: &[JointId]) -> Vec<SpeedLine> {
        let mut left: Vec<(BodyId, Vec<usize>)> = Vec::new();
        let mut is_there = vec![false; diagram.spots.len()];
        for &joint in meshes {
            let own = self.mechanism.joint(joint);
            let (Some(pitch), Some(carrier)) = (own.pitch, own.related_bodies().nth(2)) else { continue };
            let center = |side: usize| SpotName::Center(pitch.centers[side]);
            let at = SpotName::Pitch(joint);
            let on =
                [(own.bodies[0], [center(0), at]), (own.bodies[1], [center(1), at]), (carrier, [center(0), center(1)])];
            for (body, names) in on {
                for index in names.into_iter().filter_map(|name| diagram.spots.iter().position(|spot| spot.at == name))
                {
                    if body == GROUND {
                        is_there[index] = true;
                    } else if let Some((_, spots)) = left.iter_mut().find(|(other, _)| *other == body) {
                        if !spots.contains(&index) {
                            spots.push(index);
                        }
                    } else {
                        left.push((body, vec![index]));
                    }
                }
            }
        }
        left.iter_mut().for_each(|(_, spots)| spots.sort_unstable());
        let mut lines: Vec<SpeedLine> = Vec::new();
        while !left.is_empty() {
            let there = |spots: &[usize]| -> Option<[usize; 2]> {
                let known: Vec<usize> = spots.iter().copied().filter(|&spot| is_there[spot]).collect();
                let ends = [*known.first()?, *known.last()?];
                let apart = diagram.spots[ends[1]].height - diagram.spots[ends[0]].height;
                (apart > self.near).then_some(ends)
            };
            let following = left.iter().position(|(_, spots)| there(spots).is_some());
            let given = left.iter().position(|(body, _)| self.mechanism.is_known(*body));
            let (link, spots) = left.remove(given.or(following).unwrap_or(0));
            let follows = given.is_none() && following.is_some();
            let ends = [spots[0], spots[spots.len() - 1]];
            let through = there(&spots).filter(|_| follows).unwrap_or(ends);
            spots.iter().for_each(|&spot| is_there[spot] = true);
            lines.push(SpeedLine { link, spots, through, follows, omega: self.motion.body(link).omega });
        }
        lines
    }
}

impl SpeedDiagram {
    /// How far circles reach below the lowest spot.
    fn room_below(&self) -> f64 {
        self.circles.iter().map(|circle| circle.radius - circle.center).fold(0.0, f64::max)
    }

    /// The angular velocity of a line in the unit of the diagram.
    #[must_use]
    pub fn rate(&self, line: &SpeedLine) -> f64 {
        line.omega * self.turns.unwrap_or(1.0)
    }

    /// What kind of number that is.
    #[must_use]
    pub fn kind(&self) -> QuantityKind {
        if self.turns.is_some() { QuantityKind::RotationalSpeed } else { QuantityKind::AngularVelocity }
    }
}

impl Teller<'_> {
    /// The symbol of a link's angular velocity on the diagram, or of its speed in turns a minute.
    #[must_use]
    pub fn speed_symbol(&self, link: BodyId) -> String {
        let symbol = rate_symbol(&Rate::Angular(Order::Velocity, link).name(self.mechanism));
        let is_in_turns = self.construction.speeds.as_ref().is_some_and(|diagram| diagram.turns.is_some());
        if is_in_turns { symbol.replacen('ω', "n", 1) } else { symbol }
    }

    /// The name of a centre or a pitch point.
    #[must_use]
    pub fn spot_of_speed(&self, at: SpotName) -> &str {
        match at {
            SpotName::Center(point) => self.mechanism.point_name(point),
            SpotName::Pitch(joint) => self.construction.pitch_name(joint),
        }
    }

    fn speed_step(&self, action: &Action) -> Option<(&SpeedDiagram, SpeedStep)> {
        let Action::Speeds(step) = action else { return None };
        Some((self.construction.speeds.as_ref()?, *step))
    }

    /// The caption of a step of the diagram; none for other steps.
    pub(super) fn caption_of_speeds(&self, action: &Action) -> Option<String> {
        let (diagram, step) = self.speed_step(action)?;
        let language = self.words.language;
        Some(match step {
            SpeedStep::Train => language.speeds_train().to_owned(),
            SpeedStep::Pole => language.speeds_pole().to_owned(),
            SpeedStep::Line(index) => {
                let line = diagram.lines.get(index)?;
                let [from, to] = line.through.map(|spot| marked(self.spot_of_speed(diagram.spots[spot].at)));
                let link = &self.mechanism.body(line.link).name;
                if line.follows {
                    language.speeds_line(link, &from, &to)
                } else {
                    language.speeds_given(link, &from, &to)
                }
            }
            SpeedStep::Ray(index) => {
                let link = diagram.lines.get(index)?.link;
                language.speeds_ray(&self.mechanism.body(link).name, &self.speed_symbol(link))
            }
        })
    }

    /// The symbol of what such a step finds.
    pub(super) fn formula_of_speeds(&self, action: &Action) -> Option<Formula> {
        let (diagram, SpeedStep::Ray(index)) = self.speed_step(action)? else { return None };
        Some(self.speed_symbol(diagram.lines.get(index)?.link).into())
    }

    /// The number that such a step finds, and its kind.
    pub(super) fn value_of_speeds(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        let (diagram, SpeedStep::Ray(index)) = self.speed_step(action)? else { return None };
        Some((diagram.rate(diagram.lines.get(index)?), diagram.kind()))
    }

    /// What is said of a figure whose diagram lacks meshes.
    pub(super) fn missing_of_speeds(&self, is_asked: bool) -> Option<String> {
        let language = self.words.language;
        let Some(diagram) = &self.construction.speeds else {
            return is_asked.then(|| language.speeds_none().to_owned());
        };
        let names: Vec<String> =
            diagram.left_out.iter().map(|&joint| marked(self.construction.pitch_name(joint))).collect();
        let centers = diagram.spots.iter().filter(|spot| matches!(spot.at, SpotName::Center(_)));
        let line: Vec<String> = centers.map(|spot| marked(self.spot_of_speed(spot.at))).collect();
        (!names.is_empty()).then(|| language.speeds_left_out(&names.join(", "), &line.join(", ")))
    }
}
