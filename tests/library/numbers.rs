//! Numbers on their way from the text of a scene to a stated error: decimals of thirty digits, vectors by size and angle, links that
//! are nearly straight, short links, huge angles, far origins, long chains.
//!
//! The true numbers are those of `tests/numbers`, which finds them with 70 digits from distances alone and tries thousands more
//! (CONTRIBUTING.md).

use kinegon::Solution;
use kinegon::format::ResultFile;
use kinegon::geometry::LinearSystem;
use nalgebra::DMatrix;
use serde_json::Value;
use support::exact::minus;
use support::files;
use support::random::Random;
use support::stages::solved;
use support::whole_errors::truth::{self, Real};

/// The number of that name in a result, with its bound.
fn number(result: &ResultFile, name: &str) -> (f64, f64) {
    let (head, rest) = name.split_once('(').expect("a name has its argument");
    let (of, axis) = rest.split_once(')').expect("a name has its argument");
    let axis = usize::from(axis == ".y");
    let vector = |v: Option<[f64; 2]>, bound: Option<f64>| (v.expect("a vector")[axis], bound.expect("its bound"));
    match head {
        "omega" => (result.links[of].omega, result.links[of].omega_error),
        "alpha" => (result.links[of].alpha.expect("α"), result.links[of].alpha_error.expect("its bound")),
        "place" => vector(result.points[of].position, result.points[of].position_error),
        "v" => vector(result.points[of].velocity, result.points[of].velocity_error),
        _ => vector(result.points[of].acceleration, result.points[of].acceleration_error),
    }
}

/// What of these numbers is off by more than is stated.
fn exceeded(result: &ResultFile, expect: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    for (name, truth) in expect.as_object().expect("numbers by name") {
        let (value, bound) = number(result, name);
        let off = minus(value, truth.as_str().expect("a decimal")).abs();
        // A number that the scene gives is printed as it is written.
        let allowed = if bound == 0.0 { 0.5 * f64::EPSILON * value.abs() } else { bound };
        if bound.is_finite() && off > allowed + 1e-34 * value.abs() + 1e-40 {
            faults.push(format!("{name} = {value:e}: error {off:e}, stated {bound:e}"));
        }
    }
    faults
}

#[test]
fn no_error_is_larger_than_stated() {
    let (mut faults, mut cases, mut proved) = (Vec::new(), 0, 0);
    for line in files::read("tests/files/numbers.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("a line is JSON");
        let text = case["scene"].as_str().expect("a scene");
        let result = solved(text).map(|solution| solution.result()).expect("it can be solved");
        cases += 1;
        proved += usize::from(result.proved);
        // Where a link is straight by its lengths but for a little, both sides may be meant.
        let all: Vec<Vec<String>> =
            case["expect"].as_array().expect("a list").iter().map(|expect| exceeded(&result, expect)).collect();
        if all.iter().all(|faults| !faults.is_empty()) {
            faults.push(format!("{}: {}\n{text}", case["family"], all[0].join("; ")));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(cases >= 48 && proved * 10 >= cases * 9, "{proved} of {cases} proved");
}

fn four_bar(angle: &str, digits: &str) -> Solution {
    let text = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [150, 0] }},
        "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 60 }}, "drive": {{ "angle": {angle}, "omega": 10 }} }},
                   "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 140{digits} }} }},
                   "3": {{ "points": ["D", "C"], "lengths": {{ "DC": 110 }} }} }},
        "near": {{ "C": [150, 110] }} }}"#
    );
    solved(&text).expect("it can be solved")
}

#[test]
fn digits_that_f64_does_not_keep_count() {
    // dω/dBC is some 0.05 here: a length that is 10⁻¹⁵ longer moves no f64, but what is stated of them.
    let [plain, longer] = ["", ".00000000000001"].map(|digits| four_bar("60", digits));
    assert_eq!(plain.motion.body(plain.mechanism.link("3").expect("a link")).omega.to_bits(), {
        longer.motion.body(longer.mechanism.link("3").expect("a link")).omega.to_bits()
    });
    let [plain, longer] = [&plain, &longer].map(|solution| solution.result().links["3"].omega_error);
    assert!(plain != longer, "{plain:e} {longer:e}");
}

#[test]
fn angles_of_any_size_are_reduced_by_whole_turns() {
    // 10²³ leaves 280 of 360, though no f64 is 10²³; the other has 17 digits before its point.
    for (huge, small) in [("1e23", "280"), ("-1E+23", "-280"), ("36000000000000060.25", "60.25"), ("1e100", "280")] {
        let [huge, small] = [huge, small].map(|angle| four_bar(angle, "").result());
        assert!(huge.proved);
        assert_eq!(serde_json::to_string(&huge.links).ok(), serde_json::to_string(&small.links).ok());
    }
}

#[test]
fn an_origin_that_leaves_no_digits_is_told() {
    let at = |far: &str| {
        let text = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [{far}0, 0], "D": [{far}9, 0] }},
            "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 3 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                       "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 8 }} }},
                       "3": {{ "points": ["D", "C"], "lengths": {{ "DC": 7 }} }} }} }}"#
        );
        solved(&text).map_or_else(|error| vec![error.to_string()], |solution| solution.warnings().collect())
    };
    assert!(at("1000").iter().all(|warning| !warning.contains("origin")));
    assert!(at("10000000000").iter().any(|warning| warning.contains("origin")));
}

/// x² = 1 + e at x₀ = 1: the gap is e, the derivative anywhere within r of 1 is 2 ± 2 r.
fn root_is_proved(e: f64, least: f64) -> bool {
    let system = LinearSystem::new(DMatrix::from_element(1, 1, 2.0)).expect("regular");
    system.verified_near(&[e.abs()], &[least], |reach| [2.0 * reach[0]].as_slice().into()).is_some()
}

/// The box reaches r = |e|, twice as far as the first step; its image is |e| / 2 + r · r and lies inside for |e| < ½. Were the box twice
/// as large, that would hold for |e| < ⅜; were it so without the derivatives knowing, for |e| < ¾.
#[test]
fn a_box_is_proved_only_if_its_image_lies_inside() {
    assert!(root_is_proved(0.499, 0.0) && root_is_proved(-0.499, 0.0));
    assert!(!root_is_proved(0.5, 0.0) && !root_is_proved(0.501, 0.0) && !root_is_proved(-0.501, 0.0));
    // In a box of r ≥ 1 there is another root, or may be; in one of r = ½ the image is |e| / 2 + ¼.
    assert!(!root_is_proved(0.17, 1.0) && root_is_proved(0.17, 0.5) && root_is_proved(0.0, 1e-30));
}

#[test]
fn bounds_hold_for_every_matrix_that_is_meant() {
    // (1 + d) x = 1 has x = 1 / (1 + d): for |d| ≤ ½ it is up to 1 from 1, for |d| ≤ 1 there may be none.
    let system = LinearSystem::new(DMatrix::from_element(1, 1, 1.0)).expect("regular");
    let bound = |off: f64| system.verified(&[off]).error_bound(&[1.0], &[1.0], &[0.0])[0];
    assert!(bound(0.5) >= 1.0 && bound(0.5) < 1.001, "{}", bound(0.5));
    assert!(bound(0.9) >= 9.0 && bound(1.0).is_infinite());
    // Two equations that are nearly one: 1/d times as uncertain, and none where d is within what they may be off.
    let nearly = LinearSystem::new(DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 1.0, 1.0 + 1e-8])).expect("regular");
    let bound = |off: f64| nearly.verified(&[off; 4]).error_bound(&[1.0, 0.0], &[1.0, 1.0], &[0.0; 2])[0];
    assert!(bound(1e-12) > 1e-4 && bound(1e-12) < 1e-3, "{}", bound(1e-12));
    assert!(bound(1e-8).is_infinite());
}

/// A dyad that is nearly straight is as near to its limit along the x axis as in any other direction: what the condition says of it
/// does not depend on the frame.
#[test]
fn the_condition_is_that_of_every_frame() {
    let of = |turn: [f64; 2]| {
        let [cosine, sine] = turn;
        let places = [("A", [-30.0, 40.0]), ("B", [0.0, 0.0]), ("C", [50.0, 1e-7]), ("D", [100.0, 0.0])];
        let points: Vec<String> = places
            .iter()
            .map(|(name, [x, y])| format!("\"{name}\": [{:e}, {:e}]", cosine * x - sine * y, sine * x + cosine * y))
            .collect();
        let text = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "points": {{ {} }}, "ground": ["A", "D"],
               "links": {{ "1": {{ "points": ["A", "B"], "drive": {{ "omega": 1 }} }}, "2": ["B", "C"], "3": ["C", "D"] }} }}"#,
            points.join(", ")
        );
        solved(&text).expect("it is not singular").result().groups[0].condition
    };
    let [along, upright, turned] = [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]].map(of);
    assert!(along > 1e8 && upright > 1e8 && turned > 1e8, "{along:e} {upright:e} {turned:e}");
    assert!((turned / along).max(along / turned) < 4.0 && along == upright, "{along:e} {upright:e} {turned:e}");
}

/// What the condition promises: errors of the vectors between joints, each in parts of itself, move the rates, each counted with
/// the size of its link, by hardly more than the condition times as much of the largest. Short links are no exception.
#[test]
fn the_condition_bounds_what_errors_of_vectors_do() {
    let dice = &mut Random(77);
    let mut most: f64 = 0.0;
    for case in 0..200 {
        // A four-bar as drawn, in some of them with a link down to 1e-9 of the others.
        let mut within = |size: f64| dice.within(0.5 * size);
        let short = if case % 2 == 0 { 1.0 } else { libm::pow(10.0, -1.0 - (case % 9) as f64) };
        let [crank, coupler, rocker] = [
            [within(80.0), 40.0 + within(40.0)],
            [60.0 + within(60.0), within(60.0)],
            [within(40.0) * short, -50.0 * short],
        ];
        let rates = |coupler: [f64; 2], rocker: [f64; 2]| {
            // Each vector by itself, so that a short one keeps its digits.
            let determinant = coupler[0] * rocker[1] - coupler[1] * rocker[0];
            // ω₁ J r₁ + ω₂ J r₂ + ω₃ J r₃ = 0, by Cramer's rule.
            let of = |a: [f64; 2], b: [f64; 2]| (a[1] * b[0] - a[0] * b[1]) / determinant;
            [of(crank, rocker), of(coupler, crank)]
        };
        let size = |v: [f64; 2]| libm::hypot(v[0], v[1]);
        let condition = {
            let matrix = DMatrix::from_row_slice(2, 2, &[-coupler[1], -rocker[1], coupler[0], rocker[0]]);
            LinearSystem::of_vectors(matrix, 1).expect("regular").condition()
        };
        let exact = rates(coupler, rocker);
        let largest = (exact[0].abs() * size(coupler)).max(exact[1].abs() * size(rocker));
        let part = 1e-9;
        for _ in 0..20 {
            let mut off = |v: [f64; 2]| {
                let (sine, cosine) = libm::sincos(6.3 * dice.unit());
                [v[0] + part * size(v) * cosine, v[1] + part * size(v) * sine]
            };
            let (coupler, rocker) = (off(coupler), off(rocker));
            let found = rates(coupler, rocker);
            let moved = ((found[0] - exact[0]).abs() * size(coupler)).max((found[1] - exact[1]).abs() * size(rocker));
            most = most.max(moved / (part * largest * condition));
        }
    }
    assert!(most > 0.1 && most < 6.0, "errors grow by {most} times the condition");
}

/// Where nothing is rounded, as in line at 0°, a position is proved as well.
#[test]
fn what_is_exact_is_proved() {
    let text = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 0, "omega": 3 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["C"] } },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }], "near": { "C": [200, 0] } }"#;
    let result = solved(text).expect("it is not singular").result();
    let link = &result.links["2"];
    assert!(result.proved && (link.omega + 1.0).abs() <= link.omega_error && link.omega_error < 1e-15, "{link:?}");
    assert_eq!(result.notes, ["extreme position at angle(1) = 0°: slider 3/ground stops at 200 and slides back"]);
}

/// A dyad on BD = 240 with BC = 120 and CD = 120 + d: its two assemblies are 2 h apart, h² = (d/2 + d²/480) (240 − d/2 − d²/480). From 1e-9 apart
/// (d = 1e-20) on each is either told as one with the other, where nothing is proved, or bounds hold it and not the other.
#[test]
fn two_assemblies_are_separated_or_nothing_is_proved() {
    let (mut separated, mut refused) = (0, 0);
    for power in 1..=20 {
        let decimals = format!("{}1", "0".repeat(power - 1));
        let d = format!("0.{decimals}").parse::<f64>().expect("a decimal");
        let h = ((0.5 * d + d * d / 480.0) * (240.0 - 0.5 * d - d * d / 480.0)).sqrt();
        let text = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [300, 0] }},
               "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 60 }}, "drive": {{ "angle": 0, "omega": 1 }} }},
                          "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 120 }} }},
                          "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 120.{decimals} }} }} }},
               "near": {{ "C": [180, 1] }} }}"#
        );
        let Ok(solution) = solved(&text) else {
            refused += 1;
            continue;
        };
        let result = solution.result();
        if !result.proved {
            refused += 1;
            continue;
        }
        let (y, error) = number(&result, "place(C).y");
        assert!((y - h).abs() <= error + 1e-15 * h, "1e-{power}: {y} ± {error}, in place of {h}");
        assert!(error < h, "1e-{power}: ± {error} has the other assembly, too, {h} on the other side");
        separated += 1;
    }
    println!("{separated} separated, {refused} with nothing proved");
    assert!(separated >= 8 && refused >= 3, "{separated} separated, {refused} with nothing proved");
}

/// Digits of an angle or a radius that f64 does not keep move what is read from it by more than the last digit: stated errors count them.
#[test]
fn long_digits_of_wheels_and_friction_count() {
    let solution = |scene: String| solved(&scene).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    // Half a unit in the last place of 32 less a little: f64 has 32 itself.
    let degrees = "32.0000000000000035";
    let [cosine, sine] = truth::direction_of(&truth::decimal(degrees));
    let tangent = sine / cosine;
    let mut compared = 0;
    let mut hold = |what: &str, value: f64, bound: f64, truth: &Real| {
        let off = truth::error(value, truth);
        assert!(off <= bound, "{what} is {value:e}, off by {off:e}, stated {bound:e}");
        compared += 1;
    };
    for times in 1..40 {
        // The teeth push with so much along the tangent, 60 mm from the axis, and by the tangent of the pressure angle across.
        let scene = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s", "force": "N" }}, "ground": {{ "A": [0, 0], "B": [100, 0] }},
            "links": {{ "1": {{ "points": ["A"], "drive": {{ "angle": 0, "omega": 3 }} }}, "2": {{ "points": ["B"] }} }},
            "gears": [{{ "mesh": ["1", "2"], "teeth": [20, 30], "on": "ground", "pressure": {degrees} }}],
            "forces": [{{ "on": "2", "couple": {} }}] }}"#,
            60 * times
        );
        let result = solution(scene).result();
        let found = &result.forces.as_ref().expect("forces").reactions["B"]["2"];
        hold("R(B,2).x", found.force[0], found.force_error, &(truth::exactly(-f64::from(times)) * &tangent));
        // A slider that is pressed on its guide and pushed along it.
        let scene = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s", "force": "N" }}, "ground": {{ "D": [0, 0] }},
            "links": {{ "1": {{ "points": ["F"], "drive": {{ "position": 5, "speed": 40 }} }}, "2": {{ "points": ["D", "C"], "lengths": {{ "CD": 50 }} }} }},
            "sliders": [{{ "link": "1", "at": "F", "on": "ground", "through": [0, -71], "along": 0 }}],
            "gears": [{{ "mesh": ["2", "1"], "teeth": [28, "rack"], "radius": 71, "on": "ground" }}],
            "forces": [{{ "on": "1", "at": "F", "force": [0, -{times}] }}], "friction": [{{ "guide": "1/ground", "angle": {degrees} }}] }}"#
        );
        let result = solution(scene).result();
        let found = &result.forces.as_ref().expect("forces").drives["1"];
        hold("F(1)", found.force.expect("a force"), found.error, &(truth::exactly(f64::from(times)) * &tangent));
    }
    // The pitch point of a wheel on a rack is below its axis by the radius.
    let radius = "70.0000000000000066";
    let scene = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "D": [0, 0] }},
        "links": {{ "1": {{ "points": ["F"], "drive": {{ "position": 5, "speed": 40 }} }}, "2": {{ "points": ["D", "C"], "lengths": {{ "CD": 50 }} }} }},
        "sliders": [{{ "link": "1", "at": "F", "on": "ground", "through": [0, -71], "along": 0 }}],
        "gears": [{{ "mesh": ["2", "1"], "teeth": [28, "rack"], "radius": {radius}, "on": "ground" }}], "want": ["P(1,2)"] }}"#
    );
    let result = solution(scene).whole_result().expect("it has values");
    let result = serde_json::to_value(result).expect("a result is JSON");
    let found = &result["centers"]["P(1,2)"];
    let (value, bound) = (found["position"][1].as_f64().expect("a place"), found["error"].as_f64().expect("its bound"));
    hold("P(1,2).y", value, bound, &-truth::decimal(radius));
    assert_eq!(compared, 79);
}
