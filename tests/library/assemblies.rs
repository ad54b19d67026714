//! All assemblies of mechanisms of many groups, and the nearest among them. Chains and stars of dyads of links are counted, and their
//! nearest assembly is found, by circles alone: each joint is a crossing of two circles.

use indexmap::IndexMap;
use kinegon::geometry::Point;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::position::{Pose, counted_poses, numbered_pose, pose, poses, with_nearest_sides};
use kinegon::scene::Scene;
use serde_json::{Value, json};
use support::random::Random;

/// Dyads one behind the other: the joint of each is on circles about the joint before it and about a point of the ground.
struct Chain {
    start: Point,
    /// By dyad: the point of the ground, and the radii about the joint before it and about this point.
    dyads: Vec<(Point, f64, f64)>,
}

const CRANK: f64 = 10.0;

impl Chain {
    /// Dyads with nearly the same lengths, so that most can be assembled in both ways; and the joints of one assembly.
    fn random(dyads: usize, random: &mut Random) -> (Chain, Vec<Point>) {
        let start = Point::new(CRANK * libm::cos(1.0), CRANK * libm::sin(1.0));
        let mut chain = Chain { start, dyads: Vec::new() };
        let mut joints: Vec<Point> = Vec::new();
        for index in 0..dyads {
            let pivot = Point::new(40.0 * (index + 1) as f64, 0.0);
            let joint = pivot + kinegon::geometry::Vector::new(3.0 + random.within(1e-6), 28.0 + random.within(1e-6));
            let before = joints.last().copied().unwrap_or(start);
            chain.dyads.push((pivot, (joint - before).norm(), (joint - pivot).norm()));
            joints.push(joint);
        }
        (chain, joints)
    }

    /// Each dyad a parallelogram but for `off`, which is added to one side and taken from the next; the crank at `angle`
    /// degrees from the line on which all lie flat.
    fn parallelograms(dyads: usize, angle: f64, off: f64) -> Chain {
        let (sine, cosine) = libm::sincos(angle.to_radians());
        let pivot = |index: usize| Point::new(40.0 * (index + 1) as f64, 0.0);
        let side = |index: usize| 40.0 + if index.is_multiple_of(2) { off } else { -off };
        Chain {
            start: Point::new(CRANK * cosine, CRANK * sine),
            dyads: (0..dyads).map(|index| (pivot(index), side(index), CRANK)).collect(),
        }
    }

    fn scene(&self, angle: f64, near: &[(usize, Point)]) -> Value {
        let mut ground = serde_json::Map::from_iter([("A".to_owned(), json!([0, 0]))]);
        let mut links = serde_json::Map::new();
        links.insert(
            "crank".into(),
            json!({ "points": ["A", "P0"], "lengths": { "A-P0": CRANK }, "drive": { "angle": angle, "omega": 1 } }),
        );
        for (index, (pivot, about_joint, about_pivot)) in self.dyads.iter().enumerate() {
            let (before, joint, fixed) = (format!("P{index}"), format!("P{}", index + 1), format!("G{}", index + 1));
            let link =
                |a: &str, length: f64| json!({ "points": [a, joint], "lengths": { format!("{a}-{joint}"): length } });
            links.insert(format!("a{}", index + 1), link(&before, *about_joint));
            links.insert(format!("b{}", index + 1), link(&fixed, *about_pivot));
            ground.insert(fixed, json!([pivot.x, pivot.y]));
        }
        let near = near.iter().map(|(index, p)| (format!("P{}", index + 1), json!([p.x, p.y])));
        let near: serde_json::Map<String, Value> = near.collect();
        json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ground, "links": links, "near": near })
    }

    /// The joints of all assemblies.
    fn assemblies(&self) -> Vec<Vec<Point>> {
        let mut all = vec![Vec::new()];
        for (pivot, about_joint, about_pivot) in &self.dyads {
            let next = |joints: &Vec<Point>| {
                let before = joints.last().copied().unwrap_or(self.start);
                let crossings = crossings((before, *about_joint), (*pivot, *about_pivot));
                crossings.map(|p| joints.iter().copied().chain([p]).collect()).collect::<Vec<Vec<Point>>>()
            };
            all = all.iter().flat_map(next).collect();
        }
        all
    }
}

/// Where two circles cross.
fn crossings((a, ra): (Point, f64), (b, rb): (Point, f64)) -> impl Iterator<Item = Point> {
    let distance = (b - a).norm();
    let along = (distance * distance + (ra - rb) * (ra + rb)) / (2.0 * distance);
    let across = ra * ra - along * along;
    let way = (b - a) / distance;
    let signs = if across < 0.0 { [].as_slice() } else { [1.0, -1.0].as_slice() };
    signs.iter().map(move |sign| a + way * along + kinegon::geometry::quarter_turn(way) * (sign * across.abs().sqrt()))
}

/// The angle of the crank in the random chains.
fn one_radian() -> f64 {
    1f64.to_degrees()
}

fn read(scene: &Value) -> (Scene, Mechanism) {
    let scene = Scene::read(&scene.to_string()).expect("a scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    (scene, mechanism)
}

fn joints(mechanism: &Mechanism, pose: &Pose, dyads: usize) -> Vec<Point> {
    (1..=dyads).map(|index| pose.point(mechanism.point(&format!("P{index}")).expect("a point"))).collect()
}

fn apart(a: &[Point], b: &[Point]) -> f64 {
    a.iter().zip(b).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
}

#[test]
fn chains_have_as_many_assemblies_as_circles_cross() {
    let mut random = Random(11);
    for dyads in [1, 2, 3, 5, 7, 8, 9] {
        let (chain, _) = Chain::random(dyads, &mut random);
        let (scene, mechanism) = read(&chain.scene(one_radian(), &[]));
        let listed = counted_poses(&mechanism, &scene.near).expect("it can be assembled");
        let truth = chain.assemblies();
        assert_eq!((listed.count.number, listed.count.is_exact), (truth.len() as u64, true), "{dyads} dyads");
        assert_eq!(listed.poses.len(), truth.len());
        for pose in &listed.poses {
            let found = joints(&mechanism, pose, dyads);
            assert!(truth.iter().any(|joints| apart(joints, &found) < 1e-6), "{dyads} dyads: {found:?}");
        }
    }
}

/// More than are listed are counted all the same, and every one has its number.
#[test]
#[ignore = "takes long"]
fn more_are_counted_than_are_listed() {
    let mut random = Random(2);
    let (chain, _) = Chain::random(16, &mut random);
    let truth = chain.assemblies();
    let (scene, mechanism) = read(&chain.scene(one_radian(), &[]));
    let listed = counted_poses(&mechanism, &scene.near).expect("it can be assembled");
    assert!(truth.len() > 4096, "{}", truth.len());
    assert_eq!((listed.count.number, listed.count.is_exact), (truth.len() as u64, true));
    assert_eq!(listed.poses.len(), 4096);
    let text = kinegon::format::listed_modes(&scene, &mechanism, &listed);
    assert!(
        text.starts_with(&format!("{} assembly modes, listed are the first 4096;", truth.len())),
        "{}",
        &text[..80]
    );
    for number in [1, 2, 100, 4096] {
        let one = numbered_pose(&mechanism, &scene.near, number).expect("it has a number");
        assert_eq!(one.points, listed.poses[number - 1].points);
    }
    let last = numbered_pose(&mechanism, &scene.near, truth.len()).expect("it has a number");
    assert!(truth.iter().any(|all| apart(all, &joints(&mechanism, &last, 16)) < 1e-5));
    let error = numbered_pose(&mechanism, &scene.near, truth.len() + 1).expect_err("it does not exist").to_string();
    assert!(error.contains(&format!("there are {}", truth.len())), "{error}");
}

/// What cannot be counted is said to be at least so many.
#[test]
#[ignore = "takes long"]
fn too_many_to_count_are_at_least_so_many() {
    let mut random = Random(5);
    let (chain, _) = Chain::random(40, &mut random);
    let (scene, mechanism) = read(&chain.scene(one_radian(), &[]));
    let listed = counted_poses(&mechanism, &scene.near).expect("it can be assembled");
    assert!(!listed.count.is_exact && listed.count.number > 4096, "{:?}", listed.count);
    assert!(kinegon::format::listed_modes(&scene, &mechanism, &listed).starts_with("at least "));
}

/// Rough places of some joints: the nearest of all assemblies is taken, by brute force over all.
#[test]
fn the_nearest_of_all_assemblies_is_taken() {
    let mut random = Random(3);
    for case in 0..24 {
        let dyads = 6 + case % 5;
        let (chain, planted) = Chain::random(dyads, &mut random);
        let all = chain.assemblies();
        // The last joint only, every third, or all; near some assembly, and less and less so.
        let step = [dyads, 3, 1][case % 3];
        let goal = if case % 2 == 0 { &planted } else { &all[random.below(all.len())] };
        let noise = 2.0 * case as f64;
        let mut rough = |p: Point| Point::new(p.x + random.between(-noise, noise), p.y + random.between(-noise, noise));
        let near: Vec<(usize, Point)> =
            (0..dyads).rev().step_by(step).map(|index| (index, rough(goal[index]))).collect();
        let distance =
            |joints: &[Point]| near.iter().map(|&(index, p)| (joints[index] - p).norm_squared()).sum::<f64>();
        let least = all.iter().map(|joints| distance(joints)).fold(f64::INFINITY, f64::min);
        let (scene, mechanism) = read(&chain.scene(one_radian(), &near));
        let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
        let found = distance(&joints(&mechanism, &pose, dyads));
        assert!(found <= least + 1e-6 * (1.0 + least), "case {case}: {found} in place of {least}");
        assert!(
            !pose.warnings.iter().any(|text| text.to_string().contains("too many assemblies")),
            "{:?}",
            pose.warnings
        );
    }
}

/// The last joint alone chooses among all assemblies of sixteen dyads.
#[test]
fn the_last_joint_chooses_the_whole_chain() {
    let mut random = Random(7);
    let (chain, planted) = Chain::random(16, &mut random);
    let near = [(15, planted[15])];
    let (scene, mechanism) = read(&chain.scene(one_radian(), &near));
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    let found = joints(&mechanism, &pose, 16);
    let least = chain.assemblies().iter().map(|all| (all[15] - planted[15]).norm()).fold(f64::INFINITY, f64::min);
    assert!((found[15] - planted[15]).norm() <= least + 1e-6, "{:?}", found[15]);
}

/// Where the work ends before it is certain that the nearest assembly is taken, a warning says so.
#[test]
#[ignore = "takes long"]
fn what_is_not_proven_is_said() {
    let mut random = Random(9);
    let (chain, planted) = Chain::random(60, &mut random);
    let (scene, mechanism) = read(&chain.scene(one_radian(), &[(59, planted[59])]));
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    let found = joints(&mechanism, &pose, 60);
    let is_nearest = (found[59] - planted[59]).norm() < 1e-6;
    let said = pose.warnings.iter().any(|text| text.to_string().contains("too many assemblies"));
    assert!(said || is_nearest, "{:?}", pose.warnings);
}

/// Many parts that share nothing but the crank: each is nearest by itself, however rough the places, and their numbers of
/// assemblies multiply.
#[test]
fn parts_that_share_nothing_are_found_one_by_one() {
    const PARTS: usize = 40;
    let mut random = Random(4);
    let mut scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": 40, "omega": 1 } } }, "near": {}
    });
    let (sine, cosine) = libm::sincos(40f64.to_radians());
    let crank = Point::new(30.0 * cosine, 30.0 * sine);
    let mut expected: IndexMap<String, Point> = IndexMap::new();
    for part in 0..PARTS {
        let (pivot, joint) = (format!("G{part}"), format!("C{part}"));
        let at = Point::new(random.between(90.0, 110.0), random.between(-20.0, 20.0));
        let radii = [random.between(70.0, 90.0), random.between(60.0, 80.0)];
        let both: Vec<Point> = crossings((crank, radii[0]), (at, radii[1])).collect();
        let goal = both[random.below(2)];
        let rough = Point::new(goal.x + random.between(-30.0, 30.0), goal.y + random.between(-30.0, 30.0));
        let nearest = if (both[0] - rough).norm() < (both[1] - rough).norm() { both[0] } else { both[1] };
        scene["ground"][&pivot] = json!([at.x, at.y]);
        scene["links"][format!("a{part}")] =
            json!({ "points": ["B", joint], "lengths": { format!("B-{joint}"): radii[0] } });
        scene["links"][format!("b{part}")] =
            json!({ "points": [pivot, joint], "lengths": { format!("{pivot}-{joint}"): radii[1] } });
        scene["near"][&joint] = json!([rough.x, rough.y]);
        expected.insert(joint, nearest);
    }
    let (scene, mechanism) = read(&scene);
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    for (name, place) in expected {
        let found = pose.point(mechanism.point(&name).expect("a point"));
        assert!((found - place).norm() < 1e-9, "{name}: {found} in place of {place}");
    }
    let count = counted_poses(&mechanism, &scene.near).expect("it can be assembled").count;
    assert_eq!((count.number, count.is_exact), (1 << PARTS, true));
}

/// Chains of parallelograms near their change point: never a mode twice, none lost where circles cross clearly, and one
/// where they touch.
#[test]
fn near_parallelograms_have_each_mode_once() {
    const DYADS: usize = 6;
    for off in [0.0, 1e-14, 1e-12, 1e-9, 1e-6] {
        for angle in [1.0, 1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 0.0] {
            let chain = Chain::parallelograms(DYADS, angle, off);
            let (scene, mechanism) = read(&chain.scene(angle, &[]));
            let what = format!("off by {off}, crank at {angle}°");
            // How far the joints of the first dyad are off the line, if its circles cross.
            let height = CRANK * angle.to_radians();
            let is_clear = height > 1e-4 && height * height > 1e3 * off * CRANK;
            let Ok(all) = poses(&mechanism, &scene.near) else {
                assert!(off > 0.0 && !is_clear, "{what}: it can be assembled");
                continue;
            };
            assert!(all.len() <= 1 << DYADS, "{what}: {} modes", all.len());
            if is_clear {
                assert_eq!(all.len(), 1 << DYADS, "{what}");
            }
            if off == 0.0 && angle < 1e-6 {
                assert_eq!(all.len(), 1, "{what}");
            }
            for (index, a) in all.iter().enumerate() {
                let other = &all[..index];
                let twice =
                    other.iter().any(|b| apart(&joints(&mechanism, a, DYADS), &joints(&mechanism, b, DYADS)) < 1e-7);
                assert!(!twice, "{what}: a mode is listed twice");
            }
        }
    }
}

/// A link with three joints nearly on a line, on three legs: rough places with errors larger than its height choose the nearest
/// assembly of both its shapes, and where these are nearly equally far, that is said.
#[test]
fn a_nearly_flat_triangle_may_be_on_either_side() {
    const SIZE: f64 = 150.0;
    let mut random = Random(8);
    let (mut turned_over, mut elsewhere) = (0, 0);
    for case in 0..60 {
        let (planted, mut scene) = flat(&mut random, case);
        let noise = 0.003 * SIZE;
        for (name, p) in &planted {
            scene["near"][name] = json!([p.x + random.between(-noise, noise), p.y + random.between(-noise, noise)]);
        }
        let (scene, as_rough) = read(&scene);
        let mechanism = with_nearest_sides(&scene, as_rough.clone());
        let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
        let distance = |at: &dyn Fn(&str) -> Point| {
            let places = scene.near.points.iter();
            places.map(|(name, &rough)| (at(name) - Point::from(rough)).norm_squared()).sum::<f64>()
        };
        let at = |name: &str| pose.point(mechanism.point(name).expect("a point"));
        let (found, hidden) = (distance(&at), distance(&|name| planted[name]));
        assert!(found <= hidden * (1.0 + 1e-9), "case {case}: {found} away, {hidden} is possible");
        let side = |m: &Mechanism| m.body(m.link("3").expect("a link")).local[2].y > 0.0;
        turned_over += usize::from(side(&mechanism) != side(&as_rough));
        let off = planted.iter().map(|(name, p)| (at(name) - p).norm()).fold(0.0, f64::max);
        let said = mechanism.warnings.iter().any(|text| text.to_string().contains("nearly on a line"));
        if off > 1e-6 * SIZE {
            elsewhere += 1;
            assert!(said, "case {case}: {off} away without a word");
        }
    }
    println!("{turned_over} turned over, {elsewhere} elsewhere");
    assert!(turned_over > 5);
}

/// A crank and a triangle P Q R on three legs, of which Q is nearly between P and R; and where these are.
fn flat(random: &mut Random, case: usize) -> (IndexMap<String, Point>, Value) {
    let angle = random.between(0.0, 360.0);
    let (sine, cosine) = libm::sincos(angle.to_radians());
    let ends = [
        Point::new(30.0 * cosine, 30.0 * sine),
        Point::new(random.between(60.0, 100.0), random.between(-20.0, 20.0)),
        Point::new(random.between(100.0, 140.0), random.between(-30.0, 30.0)),
    ];
    let middle = Point::new(random.between(30.0, 90.0), random.between(30.0, 80.0));
    let turn = kinegon::geometry::turn_of_degrees(random.between(0.0, 180.0));
    let height = 80.0 * libm::pow(10.0, -1.5 - 2.0 * (case % 6) as f64 / 5.0);
    let local =
        [[-random.between(32.0, 48.0), 0.0], [random.between(-8.0, 8.0), height], [random.between(32.0, 48.0), 0.0]];
    let places = local.map(|[x, y]| middle + turn * kinegon::geometry::Vector::new(x, y));
    let length = |a: Point, b: Point| (a - b).norm();
    let [p, q, r] = places;
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "A": [0, 0], "E": [ends[1].x, ends[1].y], "F": [ends[2].x, ends[2].y] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": angle, "omega": 1 } },
            "2": { "points": ["B", "P"], "lengths": { "BP": length(ends[0], p) } },
            "3": { "points": ["P", "R", "Q"], "lengths": { "PQ": length(p, q), "QR": length(q, r), "PR": length(p, r) } },
            "4": { "points": ["E", "Q"], "lengths": { "EQ": length(ends[1], q) } },
            "5": { "points": ["F", "R"], "lengths": { "FR": length(ends[2], r) } } },
        "near": {}
    });
    (["P", "Q", "R"].map(str::to_owned).into_iter().zip(places).collect(), scene)
}

/// Where a dyad is nearly stretched, its two assemblies lie side by side. Either the mechanism is refused, or its bounds hold the one and
/// leave the other out.
#[test]
fn two_assemblies_side_by_side_are_told_apart_or_refused() {
    let (mut told, mut refused) = (0, 0);
    for power in 6..=19_usize {
        for first in [1, 3] {
            // Sides 1, 2 + e and 3: by Heron the joint stands (2/3)·√(s (s − 1)(s − 2 − e)(s − 3)) beside the line, s = 3 + e/2.
            let excess = f64::from(first) * libm::pow(10.0, -(power as f64));
            let half = 0.5 * excess;
            let height = libm::sqrt((3.0 + half) * (2.0 + half) * (1.0 - half) * half) / 1.5;
            let scene = format!(
                r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [4, 0] }},
                "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 1 }}, "drive": {{ "angle": 0, "omega": 1 }} }},
                "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 1 }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 2.{first:0>power$} }} }} }}, "near": {{ "C": [2, 0.5] }} }}"#
            );
            let Ok(solution) = support::stages::solved(&scene) else {
                refused += 1;
                continue;
            };
            let result = solution.whole_result().expect("numbers");
            let [_, y] = result.points["C"].position.expect("a place");
            let error = result.points["C"].position_error.expect("its bound");
            if !result.groups[0].proved {
                refused += 1;
                continue;
            }
            told += 1;
            // The height itself is known to some roundings.
            assert!((y - height).abs() <= error + 1e-14 * height, "{excess:e}: {y:e} ± {error:e}, truly {height:e}");
            assert!(y - error > -height, "{excess:e}: both lie within {y:e} ± {error:e}");
        }
    }
    assert!(told >= 10 && refused >= 5, "{told} told apart, {refused} refused");
}

/// Where the origin is so far away that f64 has no digits left for the shape, the pose rounds both assemblies: nothing is proved.
#[test]
fn an_assembly_that_rounding_has_lost_is_not_proved() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "A": [1000000000000000000, 333333333333333333], "D": [1000000000000000126, 333333333333333348] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 21.566 }, "drive": { "angle": -118.8, "omega": 18.7191 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 136.77336 } }, "3": { "points": ["D", "C"], "lengths": { "CD": 48.73641 } } },
        "near": { "C": [1000000000000000102.810347, 333333333333333390.8658053] } }"#;
    let solution = support::stages::solved(scene).expect("it is assembled");
    let result = solution.whole_result().expect("numbers");
    assert!(!result.groups[0].proved && result.links["2"].omega_error.is_infinite());
}

/// Where a four-bar's drive could stand that does not let it close: by the law of cosines, the crank's end is as far from the other pivot as the
/// coupler and the rocker reach together, or as near as they reach at least.
#[test]
fn a_four_bar_that_does_not_close_says_where_it_would() {
    for ([crank, coupler, rocker, ground], drive) in [
        ([100.0, 40.0, 50.0, 160.0], 90.0),
        ([100.0, 40.0, 50.0, 160.0], 200.0),
        ([60.0, 140.0, 50.0, 90.0], 10.0),
        ([100.0, 120.0, 30.0, 160.0], 0.0),
    ] {
        let scene = json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [ground, 0] },
            "links": {
                "1": { "points": ["A", "B"], "lengths": { "AB": crank }, "drive": { "angle": drive, "omega": 10 } },
                "2": { "points": ["B", "C"], "lengths": { "BC": coupler } },
                "3": { "points": ["D", "C"], "lengths": { "CD": rocker } } },
        });
        let problem =
            kinegon::solve(&Scene::read(&scene.to_string()).expect("a scene")).expect_err("it does not close");
        let hint = problem.problem().hint.expect("a hint").to_string();
        let at = |apart: f64| {
            let cosine = (crank * crank + ground * ground - apart * apart) / (2.0 * crank * ground);
            (-1.0..=1.0).contains(&cosine).then(|| libm::acos(cosine).to_degrees())
        };
        let (nearest, farthest) = (at(f64::abs(coupler - rocker)), at(coupler + rocker));
        let ranges = match (nearest, farthest) {
            (None, Some(most)) => vec![[-most, most]],
            (Some(least), None) => vec![[least, 360.0 - least]],
            (Some(least), Some(most)) => vec![[least, most], [360.0 - most, 360.0 - least]],
            (None, None) => panic!("it goes all round"),
        };
        let numbers: Vec<f64> =
            hint.split(|c: char| !(c.is_ascii_digit() || "-.−".contains(c))).filter_map(|n| n.parse().ok()).collect();
        let expected = ranges.concat();
        assert_eq!(numbers.len(), expected.len(), "{hint}");
        for (pair, range) in numbers.chunks(2).zip(&ranges) {
            assert!(
                (0.0..0.011).contains(&(pair[0] - range[0])) && (0.0..0.011).contains(&(range[1] - pair[1])),
                "{hint}: {range:?}"
            );
        }
    }
}
