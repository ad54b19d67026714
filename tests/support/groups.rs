//! Random fourth-class groups as drawn, half of them hard: near-parallel legs, nearly singular, nearly dead, extreme ratios,
//! large common velocities.

use super::random::Random;
use serde_json::{Map, Value, json};

/// The joints in the order of the patterns' letters, and the links that each joins.
pub const JOINTS: [&str; 6] = ["B", "C", "D", "E", "F", "G"];

impl Random {
    /// A multiple of 1/16 in (−8, 8): few bits, so that later changes stay exact.
    pub fn coarse(&mut self) -> f64 {
        (self.below(255) as f64 - 127.0) / 16.0
    }

    pub fn pair(&mut self) -> [f64; 2] {
        [self.coarse(), self.coarse()]
    }

    /// A power of two from 2^−1 to 2^−`least`.
    pub fn small(&mut self, least: usize) -> f64 {
        let exponent = 1 + self.below(least);
        1.0 / (1_u64 << exponent) as f64
    }
}

pub type Pair = [f64; 2];

pub fn add([a, b]: Pair, [c, d]: Pair) -> Pair {
    [a + c, b + d]
}

pub fn times([a, b]: Pair, s: f64) -> Pair {
    [a * s, b * s]
}

/// A known body at B or E: `None` where a pin is given its motion, its rotation where it carries a guide.
#[derive(Clone, Debug)]
pub struct Base {
    pub velocity: Pair,
    pub acceleration: Pair,
    pub spin: Option<Pair>,
}

/// A drawn fourth-class group with joints B C D E F G.
#[derive(Clone, Debug)]
pub struct Group {
    pub places: [Pair; 6],
    /// For each joint: the guide's direction where it is prismatic.
    pub guides: [Option<Pair>; 6],
    pub bases: [Base; 2],
}

impl Group {
    /// A group without any special relation between its joints.
    pub fn plain(dice: &mut Random, pattern: &str) -> Group {
        let mut places: [Pair; 6] = std::array::from_fn(|_| dice.pair());
        // Joints a good distance apart; what lies close together is made so on purpose.
        while (0..6).any(|i| (0..i).any(|j| distance(places[i], places[j]) < 1.0)) {
            places = std::array::from_fn(|_| dice.pair());
        }
        let mut letters = pattern.bytes();
        let guides = std::array::from_fn(|_| {
            let mut guide = dice.pair();
            while libm::hypot(guide[0], guide[1]) < 1.0 {
                guide = dice.pair();
            }
            (letters.next() == Some(b'P')).then_some(guide)
        });
        let bases = [guides[0], guides[3]].map(|guide| Base {
            velocity: dice.pair(),
            acceleration: dice.pair(),
            spin: guide.map(|_| dice.pair()),
        });
        Group { places, guides, bases }
    }

    /// A group with something difficult about it. Its coordinates are multiples of 2^−`bits`, below 2^5.
    pub fn hard(dice: &mut Random, pattern: &str, bits: usize) -> Group {
        let mut group = Group::plain(dice, pattern);
        let [b, c, d, e, f, g] = group.places;
        let shift = times(dice.pair(), dice.small(bits - 4));
        match dice.below(10) {
            // ED nearly parallel to BC: S3 far away.
            0 => group.places[2] = add(add(e, [c[0] - b[0], c[1] - b[1]]), shift),
            // Both special points far away.
            1 => {
                group.places[2] = add(add(e, [b[0] - c[0], b[1] - c[1]]), shift);
                group.places[4] = add(e, times([g[0] - b[0], g[1] - b[1]], 0.5));
            }
            // CD, GF and BE nearly through one point: nearly singular; the hardest, so three times as often.
            2 | 8 | 9 => {
                let center = times(add(b, e), 0.5);
                let (along, across) = ([c[0] - center[0], c[1] - center[1]], [g[0] - center[0], g[1] - center[1]]);
                group.places[2] = add(add(center, times(along, 1.5)), shift);
                group.places[4] = add(center, times(across, -0.75));
            }
            // The closure link CD very short.
            3 => group.places[2] = add(c, shift),
            // C nearly on B: the drag link's arm very short.
            4 => group.places[1] = add(b, shift),
            // S3 nearly on a joint: C close to the line ED.
            5 => group.places[1] = add(times(add(d, e), 0.5), shift),
            // A straight ternary link.
            6 => group.places[5] = add(times(add(b, c), 0.5), shift),
            // A large common velocity: only its differences matter.
            _ => {
                let common = times(dice.pair(), 65536.0);
                for base in &mut group.bases {
                    base.velocity = add(base.velocity, common);
                }
                group.places[4] = add(f, shift);
            }
        }
        group
    }

    /// Some hard, some not, of a pattern that is not singular.
    pub fn any(dice: &mut Random, bits: usize) -> Group {
        let pattern = match dice.below(3) {
            0 => regular_patterns()[dice.below(54)].clone(),
            1 => "RPRRRR".to_owned(),
            _ => "RRRRRR".to_owned(),
        };
        match dice.below(3) {
            0 => Group::plain(dice, &pattern),
            _ => Group::hard(dice, &pattern, bits),
        }
    }

    /// The group after every coordinate, guide and rate has been changed.
    pub fn map(
        &self,
        place: impl Fn(Pair) -> Pair,
        vector: impl Fn(Pair) -> Pair,
        order: [f64; 2],
        turn: f64,
    ) -> Group {
        let bases = self.bases.clone().map(|base| Base {
            velocity: times(vector(base.velocity), order[0]),
            acceleration: times(vector(base.acceleration), order[1]),
            spin: base.spin.map(|[omega, alpha]| [turn * omega * order[0], turn * alpha * order[1]]),
        });
        Group { places: self.places.map(place), guides: self.guides.map(|g| g.map(&vector)), bases }
    }

    pub fn scene(&self) -> Value {
        self.scene_as(&Names::default())
    }

    /// The scene file of the group.
    pub fn scene_as(&self, names: &Names) -> Value {
        // The two sides of each joint: links 2, 3, 4, 5 are 0 to 3, the known bodies 6 and 7. The second side slides and keeps the
        // point; so every link keeps at least one.
        const SIDES: [[usize; 2]; 6] = [[6, 0], [1, 0], [2, 1], [7, 2], [2, 3], [3, 0]];
        let link_name = |link: usize| names.link(["2", "3", "4", "5", "", "", "iB", "iE"][link]);
        let mut points = Map::new();
        let mut on: [Vec<String>; 4] = Default::default();
        let mut known = Map::new();
        let mut sliders = Vec::new();
        let mut carriers = Map::new();
        for (joint, name) in JOINTS.into_iter().enumerate() {
            points.insert(names.point(name), json!(self.places[joint]));
            let [guide_side, point_side] = SIDES[joint];
            let base = match name {
                "B" => Some(&self.bases[0]),
                "E" => Some(&self.bases[1]),
                _ => None,
            };
            on[point_side].push(names.point(name));
            match self.guides[joint] {
                Some(along) => sliders.push(json!({
                    "link": link_name(point_side), "at": names.point(name), "on": link_name(guide_side), "along": along
                })),
                None if guide_side < 4 => on[guide_side].push(names.point(name)),
                None => {}
            }
            let Some(base) = base else { continue };
            match base.spin {
                None => {
                    known.insert(
                        names.point(name),
                        json!({ "velocity": base.velocity, "acceleration": base.acceleration }),
                    );
                }
                Some([omega, alpha]) => {
                    let own = names.point(&format!("{name}i"));
                    points.insert(own.clone(), json!(self.places[joint]));
                    let motion = json!({ "at": own, "velocity": base.velocity, "acceleration": base.acceleration, "omega": omega, "alpha": alpha });
                    carriers.insert(link_name(guide_side), json!({ "points": [own], "motion": motion }));
                }
            }
        }
        let mut links: Vec<(String, Value)> = Vec::new();
        for (link, points) in on.into_iter().enumerate() {
            links.push((link_name(link), json!(points)));
        }
        links.extend(carriers);
        if names.reversed {
            links.reverse();
            sliders.reverse();
            for (_, link) in &mut links {
                link.as_array_mut().into_iter().for_each(|points| points.reverse());
            }
        }
        let links: Map<String, Value> = links.into_iter().collect();
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "points": points, "known": known, "links": links, "sliders": sliders })
    }
}

pub fn distance(a: Pair, b: Pair) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// How the things of a scene are called and ordered.
#[derive(Default)]
pub struct Names {
    pub renamed: bool,
    pub reversed: bool,
}

impl Names {
    pub fn point(&self, name: &str) -> String {
        if self.renamed { format!("X{name}'") } else { name.to_owned() }
    }

    /// A link; a known moving body, whose name begins with an i, is called as a point is.
    pub fn link(&self, name: &str) -> String {
        match name {
            "" | "ground" => name.to_owned(),
            _ if name.starts_with('i') => self.point(name),
            _ if self.renamed => format!("rod{name}"),
            _ => name.to_owned(),
        }
    }
}

/// A pattern is singular in every position where two of the lines CD, GF, BE lie at infinity.
pub fn is_singular(pattern: &str) -> bool {
    let prismatic = |joint: usize| pattern.as_bytes()[joint] == b'P';
    let at_infinity = [[1, 2], [5, 4], [0, 3]].into_iter().filter(|pair| pair.iter().all(|&j| prismatic(j)));
    at_infinity.count() >= 2
}

pub fn patterns() -> Vec<String> {
    let letter = |n: u32, joint: u32| if n >> joint & 1 == 1 { 'P' } else { 'R' };
    (0..64).map(|n| (0..6).map(|joint| letter(n, joint)).collect()).collect()
}

pub fn regular_patterns() -> Vec<String> {
    patterns().into_iter().filter(|p| !is_singular(p)).collect()
}
