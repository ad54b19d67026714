//! Nothing is ever proved of a mechanism that is singular: at a limit or a change point from lengths, with the lines of a group of class II, III or IV
//! through one point as drawn. All coordinates are small whole numbers (parts of Pythagorean triples), so each of these is singular exactly, not nearly;
//! with one number changed it is not, and then all is proved.

use kinegon::Error;
use kinegon::format::ResultFile;
use kinegon::motion::MotionError;
use serde_json::{Value, json};
use support::groups::{Base, Group, Pair, add, times};
use support::random::Random;
use support::stages::solved;

/// Mechanisms of each family.
const COUNT: usize = 150;

/// Directions of whole numbers whose length is a whole number, with that length.
const DIRECTIONS: [([f64; 2], f64); 6] = [
    ([3.0, 4.0], 5.0),
    ([5.0, 12.0], 13.0),
    ([8.0, 15.0], 17.0),
    ([7.0, 24.0], 25.0),
    ([20.0, 21.0], 29.0),
    ([1.0, 0.0], 1.0),
];

/// One of the directions in one of the eight ways that whole numbers can be turned and mirrored.
fn direction(dice: &mut Random) -> ([f64; 2], f64) {
    let ([x, y], size) = DIRECTIONS[dice.below(DIRECTIONS.len())];
    let [x, y] = [[x, y], [y, x]][dice.below(2)];
    ([x * sign(dice), y * sign(dice)], size)
}

fn sign(dice: &mut Random) -> f64 {
    [1.0, -1.0][dice.below(2)]
}

fn whole(dice: &mut Random, most: usize) -> f64 {
    1.0 + dice.below(most) as f64
}

/// The crank's pin at a quarter of the turn, which the angle's cosine and sine give exactly.
fn crank(dice: &mut Random) -> (Value, Pair) {
    let (quarter, radius) = (dice.below(4), 20.0 + whole(dice, 80));
    let pin = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][quarter];
    let drive = json!({ "angle": 90 * quarter, "omega": 3, "alpha": 0.5 });
    (json!({ "points": ["A", "B"], "lengths": { "AB": radius }, "drive": drive }), times(pin, radius))
}

fn scene(parts: Value) -> Value {
    let mut scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" } });
    for (key, value) in parts.as_object().expect("an object") {
        scene[key] = value.clone();
    }
    scene
}

/// Coupler and rocker in one line, stretched or folded; `longer` by which the coupler is longer than that.
fn flat_dyad(dice: &mut Random, longer: f64) -> Value {
    let (crank, b) = crank(dice);
    let (along, unit) = direction(dice);
    let (first, second) = (10.0 + whole(dice, 9), sign(dice) * whole(dice, 9));
    let (c, d) = (add(b, times(along, first)), add(b, times(along, first + second)));
    scene(json!({
        "ground": { "A": [0, 0], "D": d },
        "links": { "1": crank, "2": { "points": ["B", "C"], "lengths": { "BC": first * unit + longer * second.signum() } },
                   "3": { "points": ["C", "D"], "lengths": { "CD": second.abs() * unit } } },
        "near": { "C": add(c, [0.5, -0.25]) }
    }))
}

/// A connecting rod normal to its guide.
fn normal_rod(dice: &mut Random, longer: f64) -> Value {
    let (crank, b) = crank(dice);
    let (along, unit) = direction(dice);
    let (times_normal, times_along) = (whole(dice, 5), sign(dice) * whole(dice, 5));
    let c = add(b, times([-along[1], along[0]], times_normal));
    scene(json!({
        "ground": { "A": [0, 0] },
        "links": { "1": crank, "2": { "points": ["B", "C"], "lengths": { "BC": times_normal * unit + longer } }, "3": ["C"] },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": add(c, times(along, times_along)), "along": along }],
        "near": { "C": add(c, times(along, 0.01)) }
    }))
}

/// A parallelogram on its change point.
fn flat_parallelogram(dice: &mut Random, longer: f64) -> Value {
    let (mut crank, b) = crank(dice);
    let size = whole(dice, 100) + 110.0;
    crank["drive"]["angle"] = json!(0);
    let radius = b[0].abs() + b[1].abs();
    scene(json!({
        "ground": { "A": [0, 0], "D": [size, 0] },
        "links": { "1": crank, "2": { "points": ["B", "C"], "lengths": { "BC": size + longer } },
                   "3": { "points": ["C", "D"], "lengths": { "CD": radius } } },
        "near": { "C": [size + radius, 0.5] }
    }))
}

fn known(dice: &mut Random) -> Value {
    json!({ "velocity": dice.pair(), "acceleration": dice.pair() })
}

/// A dyad as drawn, its three pins on a line but for `away`.
fn drawn_dyad(dice: &mut Random, away: f64) -> Value {
    let (along, _) = direction(dice);
    let start = [whole(dice, 50), whole(dice, 50)];
    let at = |t: f64| add(start, times(along, t));
    let [c, d] = [at(whole(dice, 9)), at(10.0 + whole(dice, 9))];
    scene(json!({
        "points": { "B": start, "C": add(c, [-along[1] * away, along[0] * away]), "D": d },
        "known": { "B": known(dice), "D": known(dice) },
        "links": { "2": ["B", "C"], "3": ["C", "D"] }
    }))
}

/// A group of class III as drawn: its legs through one point, or parallel; the last leg's inner joint is `away` from that.
fn drawn_triad(dice: &mut Random, away: f64) -> Value {
    let meeting = [whole(dice, 50), whole(dice, 50)];
    let parallel = dice.below(3) == 0;
    let (common, _) = direction(dice);
    let mut points = serde_json::Map::new();
    let rays = [[4.0, 1.0], [-3.0, 5.0], [-1.0, -6.0]];
    for (leg, [outer, inner]) in [["B", "E"], ["C", "F"], ["D", "G"]].into_iter().enumerate() {
        let (from, along) = match parallel {
            true => (add(meeting, times(rays[leg], 7.0)), common),
            false => (meeting, rays[leg]),
        };
        let (near, far) = (whole(dice, 8), 10.0 + whole(dice, 8));
        let across = if leg == 2 { away } else { 0.0 };
        points.insert(outer.to_owned(), json!(add(from, times(along, far))));
        points.insert(
            inner.to_owned(),
            json!(add(add(from, times(along, near)), [-along[1] * across, along[0] * across])),
        );
    }
    scene(json!({
        "points": points,
        "known": { "B": known(dice), "C": known(dice), "D": known(dice) },
        "links": { "2": ["B", "E"], "3": ["C", "F"], "4": ["D", "G"], "5": ["E", "F", "G"] }
    }))
}

/// A group of class IV as drawn: CD, GF and BE through one point, but for `away`.
fn drawn_tetrad(dice: &mut Random, away: f64) -> Value {
    let meeting = [whole(dice, 50), whole(dice, 50)];
    let mut on = |ray: Pair, far: bool| {
        let t = whole(dice, 8) + if far { 10.0 } else { 0.0 };
        add(meeting, times(ray, t))
    };
    let [closure, other, outer] = [[4.0, 1.0], [-3.0, 5.0], [-1.0, -6.0]];
    let places = [
        on(outer, false),
        on(closure, false),
        add(on(closure, true), [away, -3.0 * away]),
        on(outer, true),
        on(other, true),
        on(other, false),
    ];
    let bases = std::array::from_fn(|_| Base { velocity: dice.pair(), acceleration: dice.pair(), spin: None });
    Group { places, guides: [None; 6], bases }.scene()
}

/// What a mechanism came to.
#[derive(Debug, Default)]
struct Seen {
    refused: usize,
    unproved: usize,
    proved: usize,
}

/// Holds a result to what it says of itself: `proved` if and only if every error of its last group is stated.
fn see(seen: &mut Seen, scene: &Value) -> Option<ResultFile> {
    let result = match solved(&scene.to_string()) {
        Ok(solution) => solution.result(),
        Err(Error::Motion(MotionError::Singular { .. })) => {
            seen.refused += 1;
            return None;
        }
        Err(other) => panic!("{other}\n{scene}"),
    };
    let last = result.groups.last().expect("a group");
    assert_eq!(result.proved, result.groups.iter().all(|group| group.proved));
    *(if last.proved { &mut seen.proved } else { &mut seen.unproved }) += 1;
    Some(result)
}

type Family = (&'static str, fn(&mut Random, f64) -> Value, f64);

/// The families, and the change after which their mechanisms are regular.
const FAMILIES: [Family; 6] = [
    ("flat dyads", flat_dyad, 0.25),
    ("rods normal to their guides", normal_rod, 0.25),
    ("flat parallelograms", flat_parallelogram, -0.25),
    ("drawn dyads", drawn_dyad, 0.25),
    ("drawn groups of class III", drawn_triad, 0.25),
    ("drawn groups of class IV", drawn_tetrad, 0.25),
];

#[test]
fn nothing_is_proved_of_what_is_singular() {
    for (name, make, change) in FAMILIES {
        let (mut singular, mut regular) = (Seen::default(), Seen::default());
        for seed in 0..COUNT as u64 {
            let own = make(&mut Random(seed), 0.0);
            if let Some(result) = see(&mut singular, &own) {
                let last = result.groups.last().expect("a group");
                assert!(!last.proved, "{name}: proved\n{own}");
                for link in &last.links {
                    let link = &result.links[link.as_str()];
                    // A block on the frame cannot turn, whatever else is singular.
                    assert!(
                        link.omega == 0.0 || !link.omega_error.is_finite(),
                        "{name}: {:e}\n{own}",
                        link.omega_error
                    );
                }
            }
            see(&mut regular, &make(&mut Random(seed), change));
        }
        println!("{name}: singular {singular:?}, changed {regular:?}");
        assert_eq!(singular.proved, 0);
        assert!(10 * regular.proved >= 9 * COUNT, "{name}: of regular ones too little is proved: {regular:?}");
    }
}
