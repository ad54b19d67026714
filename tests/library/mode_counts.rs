//! Groups of pins: how many complex assembly modes they have, held to tables that were counted another way; published mechanisms, held to their published
//! roots; and random groups of six to ten links, which have the same modes whatever their links are called and however they are turned.
//!
//! What stands in `tests/modes`:
//!
//! - `trusses.txt`: all Baranov trusses of 7, 9 and 11 links as graph6 (vertices are links, edges joints), and their numbers of complex modes: realizations of the graph
//!   of bars between the joints of each link, by the recursion of Capco, Gallet, Grasegger, Koutschan, Lubbes and Schicho (2018), halved for each joint of a link beyond
//!   two. The library counts on links.
//! - `losch44.json`: Lösch 1995, group (4.4), from PHCpack's demo `assur44`: 10 of 56 roots are real.
//! - `seven.json`: Innocenti 1995, numbers of PHCpack's `sevenbartut`: 8 of 18 are real.
//! - `prism6.json`: the three-prism of 24 real realizations (Capco et al.): 6 with the platform as it is.
//! - `roberts7.json`: a Roberts cognate (Sommese, Verschelde, Wampler 2001): a curve of positions and 6 others, 2 of them real.
//! - `eight_links.json`: a group of which a search from random places lost a mode.

use kinegon::geometry::{Point, turn_of_degrees};
use kinegon::mechanism::mechanism;
use kinegon::position::number::complex_modes;
use kinegon::position::{Assembly, counted_poses};
use kinegon::scene::{Near, Scene};
use serde_json::{Map, Value, json};
use support::files;
use support::random::Random;
use support::stages::solved;
use support::survey::{COUNTED_TRUSSES, LOST_TURNS, TURNED_GROUPS};

/// The trusses of the table: how many links each has, which links each of its joints joins, and its number of complex modes.
fn trusses() -> Vec<(usize, Vec<[usize; 2]>, u64)> {
    let table = files::read("tests/modes/trusses.txt");
    let truss = |line: &str| {
        let (graph, number) = line.split_once(' ').expect("a graph and its number");
        let bytes: Vec<u8> = graph.bytes().map(|byte| byte - 63).collect();
        let links = usize::from(bytes[0]);
        let pairs = (1..links).flat_map(|b| (0..b).map(move |a| [a, b]));
        let is_joint = |index: usize| bytes[1 + index / 6] >> (5 - index % 6) & 1 == 1;
        let joints = pairs.enumerate().filter(|(index, _)| is_joint(*index)).map(|(_, pair)| pair).collect();
        (links, joints, number.parse().expect("a number"))
    };
    table.lines().map(truss).collect()
}

#[test]
fn complex_modes_are_those_of_the_table() {
    let every = COUNTED_TRUSSES.now();
    let trusses = trusses();
    assert_eq!([7, 9, 11].map(|links| trusses.iter().filter(|truss| truss.0 == links).count()), [3, 28, 562]);
    for (index, (links, joints, number)) in trusses.iter().enumerate() {
        if *links < 9 || index % every == 0 {
            let pins: Vec<Vec<usize>> = joints.iter().map(|pair| pair.to_vec()).collect();
            assert_eq!(complex_modes(*links, &pins), Some(*number), "{joints:?}");
        }
    }
    // A dyad and a group of class III, each with the frame.
    assert_eq!(complex_modes(3, &[vec![0, 1], vec![1, 2], vec![0, 2]]), Some(2));
    let platform: Vec<Vec<usize>> = (0..3).flat_map(|leg| [vec![leg, 3], vec![leg, 4]]).collect();
    assert_eq!(complex_modes(5, &platform), Some(6));
}

/// A link with three pins is three bars, but for the side on which its third pin lies. So pins of several links are counted rightly, too: bars have no others.
#[test]
fn links_are_bars_but_for_their_sides() {
    // The Roberts cognate, with two links at one pin of the frame; and two dyads at a pin of three links.
    let cognate: &[&[usize]] = &[&[0, 1], &[0, 2, 3], &[0, 4], &[1, 5], &[2, 5], &[5, 6], &[3, 6], &[4, 6]];
    let dyads: &[&[usize]] = &[&[0, 1], &[0, 2], &[0, 3], &[1, 2, 4], &[3, 4]];
    for (links, pins) in [(7, cognate), (5, dyads)] {
        let at: Vec<Vec<usize>> =
            (0..links).map(|link| (0..pins.len()).filter(|&pin| pins[pin].contains(&link)).collect()).collect();
        let mut bars: Vec<[usize; 2]> = Vec::new();
        let mut sides = 0;
        for pins in &at {
            bars.push([pins[0], pins[1]]);
            for &further in &pins[2..] {
                bars.extend([[pins[0], further], [pins[1], further]]);
                sides += 1;
            }
        }
        let ends: Vec<Vec<usize>> =
            (0..pins.len()).map(|pin| (0..bars.len()).filter(|&bar| bars[bar].contains(&pin)).collect()).collect();
        let pins: Vec<Vec<usize>> = pins.iter().map(|pin| pin.to_vec()).collect();
        let [of_links, of_bars] = [complex_modes(links, &pins), complex_modes(bars.len(), &ends)];
        assert_eq!(of_links.map(|number| number << sides), of_bars);
        assert!(of_links.is_some());
    }
}

/// What is listed of a scene without rough places, the modes of its last group, and the text of `kinegon modes`.
fn listed(text: &str) -> (Vec<Assembly>, Vec<f64>, String) {
    let scene = Scene::read(text).expect("a scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let listed = counted_poses(&mechanism, &Near::default()).expect("it can be assembled");
    let first = mechanism.link("1").expect("a link");
    let angle = |axis: kinegon::geometry::Vector| libm::atan2(axis.y, axis.x).to_degrees();
    let angles = listed.poses.iter().map(|pose| angle(pose.axes[first.0].expect("an axis"))).collect();
    let assemblies = listed.poses.iter().map(|pose| *pose.assemblies.last().expect("a group")).map(Option::unwrap);
    (assemblies.collect(), angles, kinegon::format::listed_modes(&scene, &mechanism, &listed))
}

/// Holds the angles of link 1 in all modes to published ones.
fn held(name: &str, at_most: u64, published: &[f64]) -> String {
    let (assemblies, mut angles, text) = listed(&files::read(&format!("tests/modes/{name}.json")));
    angles.sort_by(f64::total_cmp);
    assert_eq!(angles.len(), published.len(), "{name}: {text}");
    for (found, published) in angles.iter().zip(published) {
        assert!((found - published).abs() < 1e-6, "{name}: {found} in place of {published}");
    }
    assert!(assemblies.iter().all(|assembly| assembly.at_most == Some(at_most)), "{name}: {assemblies:?}");
    text
}

#[test]
fn published_groups_have_their_published_modes() {
    let losch = [
        -167.921117,
        -92.46453,
        -73.490123,
        58.081902,
        68.986021,
        79.419109,
        141.205665,
        168.411024,
        169.317474,
        179.876205,
    ];
    let text = held("losch44", 56, &losch);
    assert!(text.contains("10 of its assembly modes") && text.contains("56 at most"), "{text}");
    let seven = [-84.733858, -66.483405, -24.153603, -16.7259, 50.80279, 51.354746, 106.783239, 130.189201];
    assert!(held("seven", 18, &seven).contains("18 at most"));
    let (assemblies, _, text) = listed(&files::read("tests/modes/prism6.json"));
    assert_eq!((assemblies.len(), assemblies[0].at_most), (6, Some(6)));
    assert!(text.contains("6 found, 6 at most"), "{text}");
}

/// A curve of positions is no list of modes. The two links at one pin of the frame leave 16 complex modes of the 18 of the general truss.
#[test]
fn a_group_that_moves_says_so() {
    let text = files::read("tests/modes/roberts7.json");
    let (assemblies, mut angles, said) = listed(&text);
    angles.sort_by(f64::total_cmp);
    assert_eq!(angles.len(), 2, "{said}");
    for (found, published) in angles.iter().zip([-123.0535, -73.6898]) {
        assert!((found - published).abs() < 5e-5, "{found} in place of {published}");
    }
    assert!(assemblies.iter().all(|assembly| assembly.may_move && assembly.at_most == Some(16)), "{assemblies:?}");
    assert!(said.contains("may move"), "{said}");
    // Rough places choose a mode, whose numbers are told with the warning.
    let result = solved(&text).expect("a mode").whole_result().expect("numbers");
    assert!(result.groups[0].may_move && result.warnings.iter().any(|warning| warning.contains("may move")));
}

/// A random group: a truss of the table with one of its links as the frame, pins anywhere in a square.
struct Truss {
    links: usize,
    joints: Vec<[usize; 2]>,
    frame: usize,
    pins: Vec<Point>,
    number: u64,
}

impl Truss {
    fn random(random: &mut Random, links: usize, kinds: &[(usize, Vec<[usize; 2]>, u64)]) -> Truss {
        let kinds: Vec<_> = kinds.iter().filter(|kind| kind.0 == links).collect();
        let (_, joints, number) = kinds[random.below(kinds.len())];
        let pins = joints.iter().map(|_| Point::new(random.between(0.0, 100.0), random.between(0.0, 100.0))).collect();
        Truss { links, joints: joints.clone(), frame: random.below(links), pins, number: *number }
    }

    /// Its scene with links and pins in another order, turned by so many degrees.
    fn scene(&self, random: &mut Random, turned: f64) -> (String, Vec<usize>) {
        let names = shuffled(self.links, random);
        let pin_names = shuffled(self.pins.len(), random);
        let turn = turn_of_degrees(turned);
        let name = |pin: usize| format!("J{}", pin_names[pin]);
        let pins_of = |link: usize| (0..self.pins.len()).filter(move |&pin| self.joints[pin].contains(&link));
        let mut ground = Map::new();
        let mut links = Map::new();
        // The drive holds one pin of the frame.
        for (index, pin) in pins_of(self.frame).enumerate() {
            let at = turn * self.pins[pin];
            if index > 0 {
                ground.insert(name(pin), json!([at.x, at.y]));
                continue;
            }
            let pivot = at - turn * kinegon::geometry::Vector::x();
            ground.insert("O".into(), json!([pivot.x, pivot.y]));
            let drive = json!({ "angle": turned, "omega": 1 });
            links.insert(
                "c".into(),
                json!({ "points": ["O", name(pin)], "lengths": { format!("O-{}", name(pin)): 1 }, "drive": drive }),
            );
        }
        let mut order: Vec<usize> = (0..self.links).filter(|&link| link != self.frame).collect();
        order.sort_by_key(|&link| names[link]);
        for link in order {
            let points: Vec<String> = pins_of(link).map(name).collect();
            let shape: Map<String, Value> =
                pins_of(link).map(|pin| (name(pin), json!([self.pins[pin].x, self.pins[pin].y]))).collect();
            links.insert(format!("L{}", names[link]), json!({ "points": points, "shape": shape }));
        }
        let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ground, "links": links });
        (scene.to_string(), pin_names)
    }

    /// The places of its pins in all modes, turned back, and how many modes there can be.
    fn modes(&self, random: &mut Random, turned: f64) -> (Vec<Vec<Point>>, Option<u64>) {
        let (text, names) = self.scene(random, turned);
        let scene = Scene::read(&text).expect("a scene");
        let mechanism = mechanism(&scene).expect("a mechanism");
        // What is not found counts as lost.
        let poses = counted_poses(&mechanism, &Near::default()).map_or_else(|_| Vec::new(), |listed| listed.poses);
        let back = turn_of_degrees(-turned);
        let place = |pose: &kinegon::position::Pose, name: usize| {
            back * pose.point(mechanism.point(&format!("J{name}")).expect("a point"))
        };
        let modes = poses.iter().map(|pose| names.iter().map(|&name| place(pose, name)).collect());
        let at_most = poses.first().map(|pose| pose.assemblies[0].expect("a mode").at_most);
        (modes.collect(), at_most.unwrap_or(Some(self.number)))
    }
}

fn shuffled(count: usize, random: &mut Random) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    (1..count).rev().for_each(|last| order.swap(last, random.below(last + 1)));
    order
}

/// Whether two modes have their pins in the same places.
fn is_same(a: &[Point], b: &[Point]) -> bool {
    a.iter().zip(b).all(|(p, q)| (p - q).norm() < 1e-4)
}

/// Three orders and turns of a group: the same modes, the one by which it was made among them, and no more than there can be; else how many each has.
fn disagreement(truss: &Truss, random: &mut Random) -> Option<Vec<usize>> {
    let turns = [0.0, 1.0, 1.0].map(|turned| turned * random.between(-180.0, 180.0));
    let copies = turns.map(|turned| truss.modes(random, turned));
    let first = &copies[0].0;
    let counts = || copies.iter().map(|(modes, _)| modes.len()).collect::<Vec<_>>();
    for (modes, at_most) in &copies {
        assert_eq!(*at_most, Some(truss.number));
        assert!(modes.len() as u64 <= truss.number, "{:?} of {}", counts(), truss.number);
    }
    let is_among = |mode: &Vec<Point>, modes: &[Vec<Point>]| modes.iter().any(|other| is_same(mode, other));
    let agree = |modes: &Vec<Vec<Point>>| modes.len() == first.len() && modes.iter().all(|mode| is_among(mode, first));
    let are_same = copies.iter().all(|(modes, _)| agree(modes)) && is_among(&truss.pins, first);
    (!are_same).then(counts)
}

#[test]
fn modes_hang_on_no_name_and_no_turn() {
    let groups = TURNED_GROUPS.now();
    let kinds = trusses();
    let seen = support::survey::on_all_cores(groups, |number, seen: &mut Vec<String>| {
        let mut random = Random(0x7475_726e + 977 * number);
        let truss = Truss::random(&mut random, [7, 9, 11][number as usize % 3], &kinds);
        if let Some(counts) = disagreement(&truss, &mut random) {
            seen.push(format!("group {number}: {} links, {} complex modes, {counts:?}", truss.links - 1, truss.number));
            println!("{seen:?}");
        }
    });
    let disagreements: Vec<String> = seen.into_iter().flatten().collect();
    println!("{} of {groups} disagree: {disagreements:#?}", disagreements.len());
    assert!(disagreements.len() as u64 <= groups / 3000, "{disagreements:?}");
}

/// The group of which a search lost a mode.
#[test]
fn a_mode_once_lost_is_found_in_every_turn() {
    let scene: Value = serde_json::from_str(&files::read("tests/modes/eight_links.json")).expect("JSON");
    let links: Vec<&Value> =
        scene["links"].as_object().expect("links").values().filter(|link| link["shape"].is_object()).collect();
    let at = |pin: usize| {
        let name = format!("J{pin}");
        let joined: Vec<usize> = (0..links.len()).filter(|&link| links[link]["shape"].get(&name).is_some()).collect();
        let place = &links[joined[0]]["shape"][&name];
        let place = Point::new(place[0].as_f64().expect("x"), place[1].as_f64().expect("y"));
        ([joined[0], joined.get(1).copied().unwrap_or(links.len())], place)
    };
    let (joints, pins) = (0..12).map(at).unzip();
    let truss = Truss { links: links.len() + 1, joints, frame: links.len(), pins, number: 56 };
    let mut random = Random(0x6c6f_7374);
    for _ in 0..LOST_TURNS.now() {
        assert_eq!(disagreement(&truss, &mut random), None);
    }
}
