//! What must not depend on how a scene is looked at: random fourth-class groups, turned, mirrored, scaled, shifted, renamed and
//! reordered. Every change is exact in binary, so the two results may differ by the rounding of the solution alone.
//!
//! Half of the scenes are hard: near-parallel legs, nearly singular, nearly dead, extreme ratios, large common velocities.

mod random;
mod stages;

use kinegon::Error;
use kinegon::format::{PointResult, ResultFile};
use kinegon::geometry::{Point, Vector, cross};
use kinegon::mechanism::{LoopEquations, StructureError, mechanism};
use kinegon::motion::{ClosedForm, RightSide};
use kinegon::plan::{coincident_name, image_name};
use kinegon::scene::Scene;
use random::Random;
use serde_json::{Map, Value, json};
use stages::Stages;

const U: f64 = f64::EPSILON / 2.0;

/// How far velocities and places of two results may be apart, in units u·cond: each may err by 8. Rates of single links and sliders are
/// held to what the results state of their errors instead: a very short link turns with the errors of its neighbours enlarged.
const BOUND: f64 = 16.0;

/// The same for accelerations. They inherit the errors of the velocities, which their own equations amplify once more.
const ACCELERATION_BOUND: f64 = 64.0;

/// The joints in the order of the patterns' letters, and the links that each joins.
const JOINTS: [&str; 6] = ["B", "C", "D", "E", "F", "G"];

impl Random {
    /// A multiple of 1/16 in (−8, 8): few bits, so that later changes stay exact.
    fn coarse(&mut self) -> f64 {
        (self.below(255) as f64 - 127.0) / 16.0
    }

    fn pair(&mut self) -> [f64; 2] {
        [self.coarse(), self.coarse()]
    }

    /// A power of two from 2^−1 to 2^−`least`.
    fn small(&mut self, least: usize) -> f64 {
        let exponent = 1 + self.below(least);
        1.0 / (1_u64 << exponent) as f64
    }
}

type Pair = [f64; 2];

fn add([a, b]: Pair, [c, d]: Pair) -> Pair {
    [a + c, b + d]
}

fn times([a, b]: Pair, s: f64) -> Pair {
    [a * s, b * s]
}

/// A known body at B or E: `None` where a pin is given its motion, its rotation where it carries a guide.
#[derive(Clone, Debug)]
struct Base {
    velocity: Pair,
    acceleration: Pair,
    spin: Option<Pair>,
}

/// A drawn fourth-class group with joints B C D E F G.
#[derive(Clone, Debug)]
struct Group {
    places: [Pair; 6],
    /// For each joint: the guide's direction where it is prismatic.
    guides: [Option<Pair>; 6],
    bases: [Base; 2],
}

impl Group {
    /// A group without any special relation between its joints.
    fn plain(dice: &mut Random, pattern: &str) -> Group {
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
        Group {
            places,
            guides,
            bases,
        }
    }

    /// A group with something difficult about it. Its coordinates are multiples of 2^−`bits`, below 2^5.
    fn hard(dice: &mut Random, pattern: &str, bits: usize) -> Group {
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
                let (along, across) = (
                    [c[0] - center[0], c[1] - center[1]],
                    [g[0] - center[0], g[1] - center[1]],
                );
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
    fn any(dice: &mut Random, bits: usize) -> Group {
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
    fn map(
        &self,
        place: impl Fn(Pair) -> Pair,
        vector: impl Fn(Pair) -> Pair,
        order: [f64; 2],
        turn: f64,
    ) -> Group {
        let bases = self.bases.clone().map(|base| Base {
            velocity: times(vector(base.velocity), order[0]),
            acceleration: times(vector(base.acceleration), order[1]),
            spin: base
                .spin
                .map(|[omega, alpha]| [turn * omega * order[0], turn * alpha * order[1]]),
        });
        Group {
            places: self.places.map(place),
            guides: self.guides.map(|g| g.map(&vector)),
            bases,
        }
    }

    fn scene(&self) -> Value {
        self.scene_as(&Names::default())
    }

    /// The scene file of the group.
    fn scene_as(&self, names: &Names) -> Value {
        // The two sides of each joint: links 2, 3, 4, 5 are 0 to 3, the known bodies 6 and 7. The second side slides and keeps the
        // point; so every link keeps at least one.
        const SIDES: [[usize; 2]; 6] = [[6, 0], [1, 0], [2, 1], [7, 2], [2, 3], [3, 0]];
        let link_name = |link: usize| match link {
            6 | 7 => names.point(["iB", "iE"][link - 6]),
            _ => names.link(["2", "3", "4", "5"][link]),
        };
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
                    carriers.insert(
                        link_name(guide_side),
                        json!({ "points": [own], "motion": motion }),
                    );
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
                link.as_array_mut()
                    .into_iter()
                    .for_each(|points| points.reverse());
            }
        }
        let links: Map<String, Value> = links.into_iter().collect();
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "points": points, "known": known, "links": links, "sliders": sliders })
    }
}

fn distance(a: Pair, b: Pair) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// How the things of a scene are called and ordered.
#[derive(Default)]
struct Names {
    renamed: bool,
    reversed: bool,
}

impl Names {
    fn point(&self, name: &str) -> String {
        if self.renamed {
            format!("X{name}'")
        } else {
            name.to_owned()
        }
    }

    fn link(&self, name: &str) -> String {
        if self.renamed {
            format!("rod{name}")
        } else {
            name.to_owned()
        }
    }
}

/// A pattern is singular in every position where two of the lines CD, GF, BE lie at infinity.
fn is_singular(pattern: &str) -> bool {
    let prismatic = |joint: usize| pattern.as_bytes()[joint] == b'P';
    let at_infinity = [[1, 2], [5, 4], [0, 3]]
        .into_iter()
        .filter(|pair| pair.iter().all(|&j| prismatic(j)));
    at_infinity.count() >= 2
}

fn patterns() -> Vec<String> {
    let letter = |n: u32, joint: u32| if n >> joint & 1 == 1 { 'P' } else { 'R' };
    (0..64)
        .map(|n| (0..6).map(|joint| letter(n, joint)).collect())
        .collect()
}

fn regular_patterns() -> Vec<String> {
    patterns().into_iter().filter(|p| !is_singular(p)).collect()
}

/// All that the library says of a scene.
struct Solution {
    stages: Stages,
    result: ResultFile,
}

impl Solution {
    /// `None` where the motion is refused as singular.
    fn new(scene: &Value) -> Option<Solution> {
        let text = scene.to_string();
        match Stages::of(&text) {
            Ok(stages) => Some(Solution {
                result: stages.result(),
                stages,
            }),
            Err(Error::Motion(_)) => None,
            Err(error) => panic!("{error}\n{text}"),
        }
    }

    fn condition(&self) -> f64 {
        self.result.groups[0].condition
    }
}

/// How a result must change.
struct Change<'a> {
    place: &'a dyn Fn(Pair) -> Pair,
    vector: &'a dyn Fn(Pair) -> Pair,
    /// What a length becomes, in lengths.
    length: f64,
    /// What velocities and accelerations are multiplied with besides.
    order: [f64; 2],
    /// +1, or −1 for a mirror image.
    turn: f64,
    names: Names,
}

impl Default for Change<'_> {
    fn default() -> Self {
        Change {
            place: &|p| p,
            vector: &|v| v,
            length: 1.0,
            order: [1.0, 1.0],
            turn: 1.0,
            names: Names::default(),
        }
    }
}

/// The largest magnitude of each kind of quantity.
struct Sizes {
    omega: f64,
    alpha: f64,
    length: f64,
    velocity: f64,
    acceleration: f64,
}

impl Sizes {
    fn of(result: &ResultFile) -> Sizes {
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |m: f64, x| m.max(x.abs()));
        let named = || {
            result
                .points
                .iter()
                .filter(|(_, p)| p.on.is_none())
                .map(|(_, p)| p)
        };
        let places: Vec<Pair> = named().filter_map(|p| p.position).collect();
        let spread = |axis: usize| {
            let (low, high) = places.iter().fold((f64::MAX, f64::MIN), |(l, h), p| {
                (l.min(p[axis]), h.max(p[axis]))
            });
            high - low
        };
        let omega = largest(&mut result.links.values().map(|l| l.omega));
        let alpha = largest(&mut result.links.values().filter_map(|l| l.alpha));
        let length = spread(0).max(spread(1));
        let velocity = largest(
            &mut named()
                .filter_map(|p| p.velocity)
                .flatten()
                .chain(result.sliders.values().map(|s| s.velocity)),
        );
        let acceleration = largest(
            &mut named()
                .filter_map(|p| p.acceleration)
                .flatten()
                .chain(result.sliders.values().filter_map(|s| s.acceleration)),
        );
        Sizes {
            omega,
            alpha,
            length,
            velocity,
            acceleration,
        }
    }
}

/// The largest differences between a changed scene's result and the changed result.
#[derive(Default)]
struct Differences {
    /// One unit, u·cond.
    unit: f64,
    /// Of positions and velocities, in that unit, and where.
    velocity: (f64, String),
    /// Of accelerations.
    acceleration: (f64, String),
    /// Of rates, in units of what the two results state as bounds of their errors.
    stated: (f64, String),
}

impl Differences {
    fn see(&mut self, what: &str, difference: f64, scale: f64) {
        let measured = ratio(difference, scale * self.unit);
        let accelerates = what.starts_with('a');
        let worst = if accelerates {
            &mut self.acceleration
        } else {
            &mut self.velocity
        };
        keep_worst(worst, measured, what);
    }

    fn see_pair(&mut self, what: &str, got: Option<Pair>, want: Option<Pair>, scale: f64) {
        match (got, want) {
            (Some(g), Some(w)) => self.see(what, libm::hypot(g[0] - w[0], g[1] - w[1]), scale),
            (None, None) => {}
            _ => self.see(what, f64::INFINITY, 1.0),
        }
    }

    /// A rate with its bound, and what it should be with its bound.
    fn see_rate(&mut self, what: &str, got: (f64, f64), want: (f64, f64)) {
        let difference = got.0 - want.0;
        // The changes of a result round once themselves.
        let rounding = 2.0 * U * want.0.abs();
        keep_worst(
            &mut self.stated,
            ratio(difference, got.1 + want.1 + rounding),
            what,
        );
    }

    fn merge(&mut self, other: Differences) {
        keep_worst(&mut self.velocity, other.velocity.0, &other.velocity.1);
        keep_worst(
            &mut self.acceleration,
            other.acceleration.0,
            &other.acceleration.1,
        );
        keep_worst(&mut self.stated, other.stated.0, &other.stated.1);
    }

    fn small(&self) -> bool {
        self.velocity.0 <= BOUND
            && self.acceleration.0 <= ACCELERATION_BOUND
            && self.stated.0 <= 1.0
    }
}

impl std::fmt::Display for Differences {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [v, a, s] = [&self.velocity, &self.acceleration, &self.stated];
        write!(
            f,
            "velocities {:.3} u·cond ({}), accelerations {:.3} u·cond ({}), {:.3} of the stated bounds ({})",
            v.0, v.1, a.0, a.1, s.0, s.1
        )
    }
}

fn ratio(difference: f64, to: f64) -> f64 {
    if difference == 0.0 {
        0.0
    } else {
        difference.abs() / to
    }
}

/// Keeps the larger one with its name; a NaN is the worst of all.
fn keep_worst(worst: &mut (f64, String), measured: f64, what: &str) {
    if measured.is_nan() || measured > worst.0 {
        *worst = (measured, what.to_owned());
    }
}

fn compare(before: &ResultFile, after: &ResultFile, change: &Change<'_>, unit: f64) -> Differences {
    let mut seen = Differences {
        unit,
        ..Differences::default()
    };
    let sizes = Sizes::of(after);
    let names = &change.names;
    let [first, second] = change.order;
    let option = |x: Option<f64>| x.expect("accelerations were asked for");
    let body = |name: &str| {
        if name.starts_with('i') {
            names.point(name)
        } else {
            names.link(name)
        }
    };
    for (name, link) in &before.links {
        let got = &after.links[&body(name)];
        let by = first * change.turn;
        let want = (link.omega * by, link.omega_error * first);
        seen.see_rate(
            &format!("omega({name})"),
            (got.omega, got.omega_error),
            want,
        );
        let by = second * change.turn;
        let want = (option(link.alpha) * by, option(link.alpha_error) * second);
        let got = (option(got.alpha), option(got.alpha_error));
        seen.see_rate(&format!("alpha({name})"), got, want);
    }
    for (name, slider) in &before.sliders {
        let (link, on) = name.split_once('/').expect("the name of a slider");
        let after = &after.sliders[&format!("{}/{}", body(link), body(on))];
        let by = first * change.length;
        let want = (slider.velocity * by, slider.velocity_error * by);
        let got = (after.velocity, after.velocity_error);
        seen.see_rate(&format!("v_r({name})"), got, want);
        let by = second * change.length;
        let want = (
            option(slider.acceleration) * by,
            option(slider.acceleration_error) * by,
        );
        let got = (option(after.acceleration), option(after.acceleration_error));
        seen.see_rate(&format!("a_r({name})"), got, want);
        let coriolis = slider.coriolis.map(|c| times((change.vector)(c), second));
        seen.see_pair(
            &format!("a_c({name})"),
            after.coriolis,
            coriolis,
            sizes.acceleration,
        );
    }
    for (name, point) in &before.points {
        let new_name = match (name.strip_prefix('S'), name.split_once('_')) {
            (Some(link), _) => format!("S{}", names.link(link)),
            (_, Some((point, on))) => format!("{}_{}", names.point(point), body(on)),
            _ => names.point(name),
        };
        let got = &after.points[&new_name];
        if let Some(link) = name.strip_prefix('S') {
            // Link 3 always has point D, link 5 always F.
            let home = &after.points[&names.point(if link == "3" { "D" } else { "F" })];
            special(&mut seen, name, [point, got], home, change, &sizes);
            continue;
        }
        let motion = |value: Option<Pair>, by: f64| value.map(|v| times((change.vector)(v), by));
        // Places are given; a far origin leaves them exact too.
        seen.see_pair(
            &format!("place of {name}"),
            got.position,
            point.position.map(|p| (change.place)(p)),
            sizes.length,
        );
        seen.see_pair(
            &format!("v({name})"),
            got.velocity,
            motion(point.velocity, first),
            sizes.velocity,
        );
        seen.see_pair(
            &format!("a({name})"),
            got.acceleration,
            motion(point.acceleration, second),
            sizes.acceleration,
        );
    }
    seen
}

/// A special point's error grows with the square of its distance; very far away it may turn into a direction.
fn special(
    seen: &mut Differences,
    name: &str,
    [before, got]: [&PointResult; 2],
    home: &PointResult,
    change: &Change<'_>,
    sizes: &Sizes,
) {
    let home = home.position.expect("a joint has a place");
    let far = |place: Pair| distance(place, home) / sizes.length;
    let expected = before.position.map(|p| (change.place)(p));
    let (Some(want), Some(place)) = (expected, got.position) else {
        if let Some(place) = expected.or(got.position) {
            seen.see(
                &format!("{name} at infinity"),
                if far(place) > 1e8 { 0.0 } else { f64::INFINITY },
                1.0,
            );
        }
        return;
    };
    let far = far(want).max(1.0);
    let origin = libm::hypot(want[0], want[1]);
    let blur = (sizes.length * far * far).max(origin);
    seen.see_pair(&format!("place of {name}"), Some(place), Some(want), blur);
    let [first, second] = change.order;
    let motion = |value: Option<Pair>, by: f64| value.map(|v| times((change.vector)(v), by));
    // It is the motion of the link there, so a blurred place blurs it.
    let omega = sizes.omega;
    let rates = [
        sizes.velocity.max(blur * omega),
        sizes
            .acceleration
            .max(blur * sizes.alpha.max(omega * omega)),
    ];
    seen.see_pair(
        &format!("v({name})"),
        got.velocity,
        motion(before.velocity, first),
        rates[0],
    );
    seen.see_pair(
        &format!("a({name})"),
        got.acceleration,
        motion(before.acceleration, second),
        rates[1],
    );
}

/// Random groups, each changed by `changed` to a group that is solved again; prints and bounds the largest difference.
fn unchanged_but_for(
    what: &str,
    seed: u64,
    bits: usize,
    change: impl Fn() -> Change<'static>,
    changed: impl Fn(&Group, &Change<'_>) -> Group,
) {
    let mut dice = Random(seed);
    let (mut worst, mut hardest, mut refused) = (Differences::default(), 1.0_f64, 0);
    for _ in 0..SCENES {
        let group = Group::any(&mut dice, bits);
        let change = change();
        let scene = group.scene();
        let other = changed(&group, &change).scene_as(&change.names);
        let (before, after) = match (Solution::new(&scene), Solution::new(&other)) {
            (Some(before), Some(after)) => (before, after),
            (None, None) => {
                refused += 1;
                continue;
            }
            (one, two) => {
                let condition = one.or(two).map_or(f64::INFINITY, |s| s.condition());
                assert!(
                    condition > 1e13,
                    "{what}: only one of two is refused, condition {condition:e}\n{scene}\n{other}"
                );
                refused += 1;
                continue;
            }
        };
        let condition = before.condition().max(after.condition());
        hardest = hardest.max(condition);
        let seen = compare(&before.result, &after.result, &change, U * condition);
        if !seen.small() {
            println!("{what}: {seen}; condition {condition:.1e}\n{scene}");
        }
        worst.merge(seen);
    }
    println!("{what}: {worst}; conditions up to {hardest:.1e}, {refused} of {SCENES} singular");
    assert!(worst.small() && refused < SCENES / 20);
    assert!(
        hardest > 1e5,
        "the scenes have become too easy: conditions up to {hardest:e} only"
    );
}

/// Scenes for each change.
const SCENES: u32 = 250;

/// Coordinates are multiples of 2^−40: changes by small whole numbers leave them exact.
const FINE: usize = 40;

/// Coordinates are multiples of 2^−20: they stay exact beside an origin 2^31 away.
const FAR: usize = 20;

fn mapped(group: &Group, change: &Change<'_>) -> Group {
    group.map(change.place, change.vector, change.order, change.turn)
}

#[test]
fn turning_the_plane_turns_the_result() {
    // Times 3 + 4i: turned by 53.13° and 5 times as large, without rounding.
    fn turned([x, y]: Pair) -> Pair {
        [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y]
    }
    let change = || Change {
        place: &turned,
        vector: &turned,
        length: 5.0,
        ..Change::default()
    };
    unchanged_but_for("turned by 53°", 1, FINE, change, mapped);
    fn upright([x, y]: Pair) -> Pair {
        [-y, x]
    }
    let change = || Change {
        place: &upright,
        vector: &upright,
        ..Change::default()
    };
    unchanged_but_for("turned by 90°", 2, FINE, change, mapped);
}

#[test]
fn a_mirror_image_turns_the_other_way() {
    fn mirrored([x, y]: Pair) -> Pair {
        [x, -y]
    }
    let change = || Change {
        place: &mirrored,
        vector: &mirrored,
        turn: -1.0,
        ..Change::default()
    };
    unchanged_but_for("mirrored", 3, FINE, change, mapped);
}

#[test]
fn units_of_length_do_not_matter() {
    fn thrice(v: Pair) -> Pair {
        times(v, 3.0)
    }
    let change = || Change {
        place: &thrice,
        vector: &thrice,
        length: 3.0,
        ..Change::default()
    };
    unchanged_but_for("lengths times 3", 4, FINE, change, mapped);
    // 2^−500: squares of lengths are no longer representable.
    const TINY: f64 = 3.054_936_363_499_605e-151;
    fn tiny(v: Pair) -> Pair {
        times(v, TINY)
    }
    let change = || Change {
        place: &tiny,
        vector: &tiny,
        length: TINY,
        ..Change::default()
    };
    unchanged_but_for("lengths times 2^-500", 5, FINE, change, mapped);
    fn huge(v: Pair) -> Pair {
        times(v, 1.0 / TINY)
    }
    let change = || Change {
        place: &huge,
        vector: &huge,
        length: 1.0 / TINY,
        ..Change::default()
    };
    unchanged_but_for("lengths times 2^500", 15, FINE, change, mapped);
}

#[test]
fn units_of_time_do_not_matter() {
    let change = || Change {
        order: [3.0, 9.0],
        ..Change::default()
    };
    unchanged_but_for("time in thirds", 6, FINE, change, mapped);
    let change = || Change {
        order: [1.0 / 1024.0, 1.0 / 1_048_576.0],
        ..Change::default()
    };
    unchanged_but_for("time times 2^10", 7, FINE, change, mapped);
}

#[test]
fn the_origin_does_not_matter() {
    // A hundred million times the size of the group, which is about 16.
    fn shifted(p: Pair) -> Pair {
        add(p, [1_610_612_736.0, -1_073_741_824.0])
    }
    let change = || Change {
        place: &shifted,
        ..Change::default()
    };
    unchanged_but_for("origin far away", 8, FAR, change, mapped);
}

#[test]
fn names_do_not_matter() {
    let renamed = || Change {
        names: Names {
            renamed: true,
            reversed: false,
        },
        ..Change::default()
    };
    unchanged_but_for("renamed", 9, FINE, renamed, |group, _| group.clone());
    let mut dice = Random(10);
    for _ in 0..SCENES {
        // Not a bit changes: no name takes part in a computation.
        let group = Group::any(&mut dice, FINE);
        let change = renamed();
        let other = group.scene_as(&change.names);
        if let (Some(before), Some(after)) = (Solution::new(&group.scene()), Solution::new(&other))
        {
            let seen = compare(&before.result, &after.result, &change, U);
            let largest = seen.velocity.0.max(seen.acceleration.0);
            assert!(largest == 0.0, "{seen}\n{other}");
        }
    }
}

#[test]
fn the_order_of_links_does_not_matter() {
    let reversed = || Change {
        names: Names {
            renamed: false,
            reversed: true,
        },
        ..Change::default()
    };
    unchanged_but_for("reversed", 11, FINE, reversed, |group, _| group.clone());
}

/// A point of a link and its image in the velocity plan.
struct Imaged {
    name: String,
    place: Point,
    image: Vector,
}

/// The points of each link that have images.
fn images(solution: &Solution) -> Vec<(String, Vec<Imaged>)> {
    let Stages {
        mechanism,
        pose,
        construction,
        ..
    } = &solution.stages;
    let plan = &construction.velocity;
    let mut links = Vec::new();
    for (id, body) in mechanism.links() {
        let mut points = Vec::new();
        let mut see = |name: &str, place: Point| {
            if let Some(point) = plan.points.get(&image_name(name)) {
                points.push(Imaged {
                    name: name.to_owned(),
                    place,
                    image: point.vector,
                });
            }
        };
        for &point in &body.points {
            see(mechanism.point_name(point), pose.point(point));
        }
        for slider in mechanism.sliders.iter().filter(|s| s.on == id) {
            see(
                &coincident_name(mechanism.point_name(slider.at), &body.name),
                pose.point(slider.at),
            );
        }
        for special in construction
            .special
            .iter()
            .flatten()
            .filter(|s| s.link == id)
        {
            if let Some(place) = special.place.finite() {
                see(&special.name, place);
            }
        }
        links.push((body.name.clone(), points));
    }
    links
}

#[test]
fn a_links_image_in_the_velocity_plan_is_similar_to_it() {
    let mut dice = Random(12);
    let (mut triples, mut worst) = (0, (0.0, String::new()));
    for _ in 0..SCENES {
        let scene = Group::any(&mut dice, FINE).scene();
        let Some(solution) = Solution::new(&scene) else {
            continue;
        };
        let sizes = Sizes::of(&solution.result);
        for (link, points) in images(&solution) {
            for (i, p) in points.iter().enumerate() {
                for q in &points[..i] {
                    for r in &points {
                        // Mechanism and plan: (q − p) : (r − p) is the same ratio of complex numbers in both.
                        let (side, other) = (q.place - p.place, r.place - p.place);
                        let (side_image, other_image) = (q.image - p.image, r.image - p.image);
                        let product = |a: Vector, b: Vector| {
                            Vector::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
                        };
                        let gap = product(side, other_image) - product(other, side_image);
                        // Joints have exact places. A special point's errs with the square of its distance.
                        let reach = side.norm().max(other.norm());
                        let blur = if [p, q, r].iter().any(|x| x.name.starts_with('S')) {
                            sizes.length * (reach / sizes.length).max(1.0).powi(2)
                        } else {
                            0.0
                        };
                        let speed = sizes.velocity + 2.0 * sizes.omega * blur;
                        let gap = ratio(gap.norm(), reach * speed * U * solution.condition());
                        triples += 1;
                        if gap.is_nan() || gap > worst.0 {
                            worst = (gap, format!("link {link}, {}: {scene}", r.name));
                        }
                    }
                }
            }
        }
    }
    println!(
        "similarity: {triples} triples, at most {:.3} u·cond",
        worst.0
    );
    assert!(
        triples > 10 * SCENES && worst.0 <= BOUND,
        "{} u·cond in {}",
        worst.0,
        worst.1
    );
}

#[test]
fn the_closed_form_agrees_with_the_whole_system() {
    let mut dice = Random(13);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for round in 0..SCENES {
        let group = match round % 3 {
            0 => Group::plain(&mut dice, "RRRRRR"),
            _ => Group::hard(&mut dice, "RRRRRR", FINE),
        };
        let scene = group.scene();
        let Some(solution) = Solution::new(&scene) else {
            continue;
        };
        let Stages {
            mechanism,
            pose,
            motion,
            ..
        } = &solution.stages;
        let links = &mechanism.groups[0].links;
        let equations = LoopEquations::new(mechanism, &mechanism.groups[0]);
        let system = equations
            .factored(&pose.points, &pose.guides)
            .expect("it was solved");
        let matrix = equations.matrix(&pose.points, &pose.guides);
        let Some(form) = ClosedForm::new(&equations, &pose.points, &pose.guides) else {
            continue;
        };
        let side = RightSide::velocity(&equations, pose, &motion.bodies);
        let closed = form.solve_all(&side.value);
        let closed: [f64; 4] =
            std::array::from_fn(|i| equations.spin(links[i], &closed, |_| f64::NAN));
        let whole = system.solve(&side.value);
        let rates: [f64; 4] =
            std::array::from_fn(|i| equations.spin(links[i], &whole, |_| f64::NAN));
        // Every rate counts with the length of its arm, as it stands in the equations.
        let arms: [f64; 4] = std::array::from_fn(|i| {
            let unknown = equations.spin_unknown(links[i]).expect("all pins");
            matrix.column(unknown).amax()
        });
        let scale = (0..4).fold(0.0, |m: f64, i| m.max(rates[i].abs() * arms[i]));
        for ((a, b), arm) in closed.iter().zip(&rates).zip(&arms) {
            let difference = ratio((a - b) * arm, scale * U * system.condition());
            assert!(
                difference <= BOUND,
                "{difference} u·cond: {closed:?} {rates:?}\n{scene}"
            );
            worst = worst.max(difference);
        }
        compared += 1;
    }
    println!("closed form: {compared} scenes, at most {worst:.3} u·cond apart");
    assert!(compared > SCENES / 2);
}

#[test]
fn the_patterns_that_are_singular_by_structure_are_refused() {
    let mut dice = Random(14);
    let mut refused = 0;
    for pattern in patterns() {
        for _ in 0..8 {
            let scene = Group::plain(&mut dice, &pattern).scene();
            let read = Scene::read(&scene.to_string())
                .unwrap_or_else(|e| panic!("{pattern}: {e}\n{scene}"));
            match mechanism(&read) {
                Err(StructureError::Singular {
                    pattern: named,
                    links,
                    ..
                }) => {
                    assert!(is_singular(&pattern), "{pattern} is refused as {named}");
                    assert_eq!(named.replace('R', "").len(), pattern.replace('R', "").len());
                    assert_eq!(links, "2, 3, 4, 5");
                    refused += 1;
                }
                Err(other) => panic!("{pattern}: {other}\n{scene}"),
                Ok(mechanism) => {
                    assert!(!is_singular(&pattern), "{pattern} is not refused");
                    assert_eq!(mechanism.groups[0].pattern(&mechanism), pattern);
                    let solution = Solution::new(&scene)
                        .unwrap_or_else(|| panic!("{pattern}: singular\n{scene}"));
                    assert!(
                        solution.condition() < 1e6,
                        "{pattern}: condition {:e}\n{scene}",
                        solution.condition()
                    );
                }
            }
        }
    }
    assert_eq!(refused, 10 * 8);
}

/// The three lines' determinant for revolute groups: the generator's nearly singular scenes are what they are meant to be.
#[test]
fn conditions_grow_as_the_lines_concur() {
    let group = |shift: f64| Group {
        places: [
            [0.0, 0.0],
            [1.0, 2.0],
            [3.0, 2.5 + shift],
            [4.0, 0.5],
            [3.25, -1.5],
            [1.0, -1.0],
        ],
        guides: [None; 6],
        bases: std::array::from_fn(|i| Base {
            velocity: [1.5, i as f64],
            acceleration: [-1.0, 0.5],
            spin: None,
        }),
    };
    let lines = |g: &Group| {
        let [b, c, d, e, f, g] = g.places.map(Point::from);
        let line = |p: Point, q: Point| {
            nalgebra::Vector3::new(p.y - q.y, q.x - p.x, cross(p.coords, q.coords))
        };
        line(c, d).cross(&line(g, f)).dot(&line(b, e))
    };
    // The shift at which the lines concur, by linear interpolation: the determinant is linear in it.
    let (at_zero, at_one) = (lines(&group(0.0)), lines(&group(1.0)));
    let singular = at_zero / (at_zero - at_one);
    let condition = |away: f64| {
        Solution::new(&group(singular + away).scene()).map_or(f64::INFINITY, |s| s.condition())
    };
    let far = condition(1e-2);
    for exponent in 4..12 {
        let close = condition(10_f64.powi(-exponent)) / far * 10_f64.powi(2 - exponent);
        assert!(
            (0.2..5.0).contains(&close),
            "condition at 1e-{exponent} is {close} of 1/distance"
        );
    }
    assert!(condition(0.0) > 1e14);
}
