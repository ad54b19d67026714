//! Random groups in a known position, written down by lengths.

use super::random::Random;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::fmt::Write;

const DYADS: [&str; 7] = ["RRR", "RRP", "PRR", "RPR", "PRP", "RPP", "PPR"];

/// Bodies from 0; the frame or the crank, as it falls.
pub const KNOWN: usize = usize::MAX;

/// Kinds of the joints of a group of this class, and which bodies each joins.
pub fn pattern(random: &mut Random, class: &str) -> (String, Vec<(usize, usize)>) {
    match class {
        "II" => {
            let kinds = DYADS[random.below(DYADS.len())];
            (kinds.to_owned(), vec![(0, KNOWN), (0, 1), (1, KNOWN)])
        }
        "III" => {
            let leg = |random: &mut Random| ["RR", "RP", "PR", "PP"][random.below(4)];
            let kinds: String = (0..3).map(|_| leg(random)).collect();
            let joints = (1..4).flat_map(|leg| [(leg, KNOWN), (leg, 0)]);
            (kinds, joints.collect())
        }
        _ => {
            let kind = |random: &mut Random| if random.below(3) == 0 { 'P' } else { 'R' };
            let kinds = (0..6).map(|_| kind(random)).collect();
            // B C D E F G: link 0 with B, C, E; link 1 with D, F, G; links 2 and 3 between them.
            let joints = vec![(0, KNOWN), (0, 2), (2, 1), (0, 3), (3, 1), (1, KNOWN)];
            (kinds, joints)
        }
    }
}

pub type Pair = [f64; 2];

/// A body where it was planted.
pub struct Body {
    angle: f64,
    origin: Pair,
    /// Names and places in the plane.
    points: Vec<(String, Pair)>,
}

impl Body {
    fn own(&self, place: Pair) -> Pair {
        let (sin, cos) = libm::sincos(self.angle);
        let [x, y] = [place[0] - self.origin[0], place[1] - self.origin[1]];
        [cos * x + sin * y, cos * y - sin * x]
    }
}

/// A prismatic joint where it was planted.
pub struct Slider {
    link: usize,
    at: String,
    on: usize,
    through: Pair,
    /// The guide's angle.
    along: f64,
    /// Position along the guide and speed, where it is driven.
    drive: Option<Pair>,
}

/// A group with its surroundings in a known position: body 0 is the frame, body 1 a crank, the others are the group.
pub struct Planted {
    pub bodies: Vec<Body>,
    sliders: Vec<Slider>,
    /// Two bodies, and the place of a pin or the angle of a guide.
    joints: Vec<(usize, usize, Pair, Option<f64>)>,
    /// For a link cut in two by a driven slider: the link, for each joint whether the piece cut off has it, and the velocity of
    /// that piece against the other.
    pub piece: Option<(usize, Vec<bool>, Pair)>,
    pub scale: f64,
}

impl Planted {
    pub fn new(random: &mut Random, kinds: &str, joints: &[(usize, usize)]) -> Planted {
        let links = 1 + joints.iter().map(|j| j.0.max(if j.1 == KNOWN { 0 } else { j.1 })).max().unwrap_or(0);
        let mut bodies: Vec<Body> = (0..links + 2)
            .map(|body| Body {
                angle: if body == 0 { 0.0 } else { random.angle() },
                origin: if body == 0 { [0.0, 0.0] } else { random.place() },
                points: Vec::new(),
            })
            .collect();
        // A point of each link's own shows how the link lies.
        for (index, body) in bodies.iter_mut().enumerate().skip(1) {
            body.points.push((format!("T{index}"), random.place()));
        }
        let pivot = ("O".to_owned(), random.place());
        bodies[0].points.push(pivot.clone());
        bodies[1].points.push(pivot);
        let mut planted = Planted {
            bodies,
            sliders: Vec::new(),
            joints: Vec::new(),
            piece: None,
            scale: libm::pow(10.0, 5.0 * random.unit() - 2.0),
        };
        // Pins first, so that a slider can sit on one.
        let joined = joints.iter().zip(kinds.chars()).enumerate();
        let (pins, guides): (Vec<_>, Vec<_>) = joined.partition(|(_, (_, kind))| *kind == 'R');
        for (index, (&(a, b), kind)) in pins.into_iter().chain(guides) {
            let a = a + 2;
            let b = if b == KNOWN { random.below(2) } else { b + 2 };
            let name = format!("J{index}");
            if kind == 'R' {
                let place = random.place();
                for body in [a, b] {
                    planted.bodies[body].points.push((name.clone(), place));
                }
                planted.joints.push((a, b, place, None));
                continue;
            }
            // The frame and the crank carry guides; between two links either does.
            let (link, on) = if b >= 2 && random.below(2) == 0 { (b, a) } else { (a, b) };
            let own = &mut planted.bodies[link].points;
            let (at, place) = if own.len() > 1 && random.below(2) == 0 {
                own[1 + random.below(own.len() - 1)].clone()
            } else {
                let point = (name, random.place());
                own.push(point.clone());
                point
            };
            let along = random.angle();
            let (sin, cos) = libm::sincos(along);
            let t = random.within(1.0);
            let through = [place[0] + t * cos, place[1] + t * sin];
            planted.joints.push((link, on, place, Some(along)));
            planted.sliders.push(Slider { link, at, on, through, along, drive: None });
        }
        planted
    }

    /// Puts all joints of a link so many times as near to its first: the others' links reach to where they are then.
    pub fn shrink(&mut self, link: usize, by: f64) {
        let of_link = |joint: &&mut (usize, usize, Pair, Option<f64>)| joint.0 == link || joint.1 == link;
        let mut center = None;
        for joint in self.joints.iter_mut().filter(of_link) {
            let [x, y] = *center.get_or_insert(joint.2);
            let old = joint.2;
            let new = [x + by * (old[0] - x), y + by * (old[1] - y)];
            joint.2 = new;
            let points = self.bodies.iter_mut().flat_map(|body| &mut body.points);
            points.filter(|(_, place)| *place == old).for_each(|(_, place)| *place = new);
            let points = self.bodies.iter().flat_map(|body| &body.points);
            let moved: Vec<&str> = points.filter(|(_, place)| *place == new).map(|(name, _)| name.as_str()).collect();
            for slider in self.sliders.iter_mut().filter(|slider| moved.contains(&slider.at.as_str())) {
                slider.through = [0, 1].map(|axis| slider.through[axis] + new[axis] - old[axis]);
            }
        }
    }

    /// Puts all of it elsewhere in the plane.
    pub fn shift(&mut self, by: Pair) {
        let add = |place: &mut Pair| *place = [place[0] + by[0], place[1] + by[1]];
        for body in &mut self.bodies {
            body.points.iter_mut().for_each(|(_, place)| add(place));
            if body.origin != [0.0, 0.0] {
                add(&mut body.origin);
            }
        }
        self.sliders.iter_mut().for_each(|slider| add(&mut slider.through));
        self.joints.iter_mut().for_each(|joint| add(&mut joint.2));
    }

    /// Cuts a link of the group in two, which share its joints and which a driven slider joins.
    pub fn cut(&mut self, random: &mut Random) {
        let (link, piece) = (2 + random.below(self.bodies.len() - 2), self.bodies.len());
        let mut points = vec![(format!("T{piece}"), random.place())];
        // The sliding link's points move with the joints that they are in.
        let mut moved = Vec::new();
        let own: Vec<(String, Pair)> = self.bodies[link].points.split_off(1);
        for point in own {
            let goes = random.below(2) == 0;
            moved.push((point.1, goes));
            let to = if goes { &mut points } else { &mut self.bodies[link].points };
            to.push(point);
        }
        let goes = |place: Pair| moved.iter().any(|(at, goes)| *at == place && *goes);
        let mut on_piece = Vec::new();
        let mut sliders = self.sliders.iter_mut();
        for &(a, b, place, guide) in &self.joints {
            let slider = guide.and_then(|_| sliders.next());
            on_piece.push(match slider {
                None => (a == link || b == link) && goes(place),
                Some(slider) if slider.link == link && goes(place) => {
                    slider.link = piece;
                    true
                }
                Some(slider) if slider.on == link && random.below(2) == 0 => {
                    slider.on = piece;
                    true
                }
                Some(_) => false,
            });
        }
        self.bodies.push(Body { angle: random.angle(), origin: random.place(), points });
        let (along, speed) = (random.angle(), random.within(1.0));
        let (sin, cos) = libm::sincos(along);
        let position = random.within(1.0);
        let (slides, on) = if random.below(2) == 0 { (piece, link) } else { (link, piece) };
        let (at, place) = self.bodies[slides].points[0].clone();
        self.sliders.push(Slider {
            link: slides,
            at,
            on,
            through: [place[0] - position * cos, place[1] - position * sin],
            along,
            drive: Some([position, speed]),
        });
        let sense = if slides == piece { speed } else { -speed };
        self.piece = Some((link, on_piece, [sense * cos, sense * sin]));
    }

    /// The condition number of the velocities of all links under all joints.
    pub fn condition(&self) -> f64 {
        let values = self.jacobian().0.singular_values();
        values.max() / values.min()
    }

    /// The equations of the velocities of all links under all joints, and their right sides with the crank turning at 1.
    pub fn jacobian(&self) -> (DMatrix<f64>, DVector<f64>) {
        let size = 2 * self.joints.len();
        let mut matrix = DMatrix::<f64>::zeros(size, size);
        let mut right = DVector::<f64>::zeros(size);
        let pivot = self.bodies[0].points[0].1;
        for (index, &(a, b, place, guide)) in self.joints.iter().enumerate() {
            for (body, sign) in [(a, 1.0), (b, -1.0)] {
                let origin = if body == 1 { pivot } else { self.bodies[body].origin };
                let [x, y] = [place[0] - origin[0], place[1] - origin[1]];
                let rows = match guide {
                    None => [[1.0, 0.0, -y], [0.0, 1.0, x]],
                    Some(along) => {
                        let (sin, cos) = libm::sincos(along);
                        [[-sin, cos, cos * x + sin * y], [0.0, 0.0, 1.0]]
                    }
                };
                // What moves the body's point besides the unknown rates: the crank, or the slider of a link cut in two.
                let known = match &self.piece {
                    _ if body == 1 => [0.0, 0.0, 1.0],
                    Some((link, on_piece, [x, y])) if body == *link && on_piece[index] => [*x, *y, 0.0],
                    _ => [0.0; 3],
                };
                for (row, values) in rows.into_iter().enumerate() {
                    for (k, value) in values.into_iter().enumerate() {
                        right[2 * index + row] -= sign * value * known[k];
                        if body >= 2 {
                            matrix[(2 * index + row, 3 * (body - 2) + k)] = sign * value;
                        }
                    }
                }
            }
        }
        (matrix, right)
    }

    pub fn scene(&self) -> String {
        let pair = |[x, y]: Pair| format!("[{:?}, {:?}]", self.scale * x, self.scale * y);
        let ground: Vec<String> =
            self.bodies[0].points.iter().map(|(name, place)| format!("\"{name}\": {}", pair(*place))).collect();
        let mut text = format!(
            "{{ \"kinegon\": 1, \"units\": {{ \"length\": \"mm\", \"time\": \"s\" }},\n  \"ground\": {{ {} }},\n  \"links\": {{",
            ground.join(", ")
        );
        for (index, body) in self.bodies.iter().enumerate().skip(1) {
            let shape: Vec<String> =
                body.points.iter().map(|(name, place)| format!("\"{name}\": {}", pair(body.own(*place)))).collect();
            let drive = match index {
                1 => format!(", \"drive\": {{ \"angle\": {:?}, \"omega\": 1 }}", body.angle.to_degrees()),
                _ => String::new(),
            };
            let comma = if index == 1 { "" } else { "," };
            let shape = shape.join(", ");
            let _ = write!(text, "{comma}\n    \"b{index}\": {{ \"shape\": {{ {shape} }}{drive} }}");
        }
        text.push_str(" },\n  \"sliders\": [");
        for (index, slider) in self.sliders.iter().enumerate() {
            let on = &self.bodies[slider.on];
            let name = match slider.on {
                0 => "ground".to_owned(),
                body => format!("b{body}"),
            };
            let (sin, cos) = libm::sincos(slider.along - on.angle);
            let turned = (self.bodies[slider.link].angle - slider.along).to_degrees();
            let comma = if index == 0 { "" } else { "," };
            let drive = slider.drive.map_or_else(String::new, |drive| {
                let [position, speed] = drive.map(|x| self.scale * x);
                format!(", \"drive\": {{ \"position\": {position:?}, \"speed\": {speed:?} }}")
            });
            let _ = write!(
                text,
                "{comma}\n    {{ \"link\": \"b{}\", \"at\": \"{}\", \"on\": \"{name}\", \"through\": {}, \
                 \"along\": [{cos:?}, {sin:?}], \"turned\": {turned:?}{drive} }}",
                slider.link,
                slider.at,
                pair(on.own(slider.through)),
            );
        }
        let near: Vec<String> = self.inner().map(|(name, place)| format!("\"{name}\": {}", pair(place))).collect();
        let _ = write!(text, " ],\n  \"near\": {{ {} }} }}", near.join(", "));
        text
    }

    /// The points of the group.
    pub fn inner(&self) -> impl Iterator<Item = (&str, Pair)> {
        let points: BTreeMap<&str, Pair> =
            self.bodies[2..].iter().flat_map(|body| body.points.iter().map(|(n, p)| (n.as_str(), *p))).collect();
        let known = self.bodies[..2].iter().flat_map(|body| &body.points);
        let known: Vec<&str> = known.map(|(n, _)| n.as_str()).collect();
        points.into_iter().filter(move |(n, _)| !known.contains(n))
    }
}
