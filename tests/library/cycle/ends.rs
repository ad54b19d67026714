//! Where motions end or turn back, in closed form.

use super::four_bars::FourBar;
use super::{TURN, followed, posed};
use kinegon::cycle::{Event, Happening};
use kinegon::words::Wording;

/// How exactly places are known, in parts of a turn or of the mechanism's size.
const LOCATED: f64 = 1e-12;

/// What happens to the mechanism of a scene once around its crank, or from end to end.
fn events(scene: &str) -> Vec<Event> {
    let (mechanism, pose) = posed(scene);
    let path = followed(&mechanism, &pose);
    let mut events = path.events();
    if path.drive.is_angle {
        events.retain(|event| event.at < path.low() + TURN);
    }
    events
}

/// The smallest distance between two angles in degrees.
pub fn apart(a: f64, b: f64) -> f64 {
    let turns = (a - b) / TURN;
    (turns - turns.round()).abs() * TURN
}

/// Checks that something happens at just these angles of the crank, whole turns aside.
fn happen(events: &[Event], what: impl Fn(&Happening) -> bool, expected: &[f64]) {
    let found: Vec<f64> = events.iter().filter(|e| what(&e.what)).map(|e| e.at).collect();
    assert_eq!(found.len(), expected.len(), "{expected:?} {events:#?}");
    for at in expected {
        let nearest = found.iter().map(|f| apart(*f, *at)).fold(f64::MAX, f64::min);
        assert!(nearest < LOCATED * TURN, "{at}: {nearest:e} from {found:?}");
    }
}

fn turns_back(link: &str) -> impl Fn(&Happening) -> bool {
    move |what| matches!(what, Happening::TurnsBack { link: l, .. } if l == link)
}

fn slides_back(what: &Happening) -> bool {
    matches!(what, Happening::SlidesBack { .. })
}

fn limit(what: &Happening) -> bool {
    matches!(what, Happening::Limit(_))
}

fn asin(x: f64) -> f64 {
    libm::asin(x).to_degrees()
}

/// The rocker turns back where crank and coupler are in line.
#[test]
fn a_rocker() {
    for [a, b, c, d] in [[60.0, 140.0, 110.0, 150.0], [20.0, 33.0, 45.0, 50.0], [1.0, 77.5, 80.0, 4.0]] {
        let bar = FourBar { crank: a, coupler: b, rocker: c, ground: d };
        let (place, _) = bar.joint(70.0, 1.0).expect("it can be assembled");
        let triangle = |side: f64| libm::acos((side * side + d * d - c * c) / (2.0 * side * d)).to_degrees();
        let expected = [triangle(a + b), 180.0 + triangle(b - a)];
        happen(&events(&bar.scene(70.0, place)), turns_back("3"), &expected);
    }
}

pub fn slider_crank(a: f64, b: f64, e: f64, drives: [&str; 2]) -> String {
    let [crank, piston] = drives;
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0] }},
          "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {a:?} }} {crank} }},
                      "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {b:?} }} }}, "3": {{ "points": ["C"] }} }},
          "sliders": [{{ "link": "3", "at": "C", "on": "ground", "through": [0, {e:?}], "along": 0 {piston} }}],
          "near": {{ "B": [{a:?}, {a:?}], "C": [{:?}, {e:?}] }} }}"#,
        a + b
    )
}

pub const TURNS: &str = r#", "drive": { "angle": 2, "omega": 1 }"#;

/// The piston slides back where crank and rod are in line; the rod turns back where the crank is normal to the guide.
#[test]
fn a_piston() {
    for [a, b, e] in [[50.0, 150.0, -20.0], [30.0, 40.0, 6.5], [10.0, 200.0, 0.0]] {
        let events = events(&slider_crank(a, b, e, [TURNS, ""]));
        happen(&events, slides_back, &[asin(e / (a + b)), 180.0 + asin(e / (b - a))]);
        happen(&events, turns_back("2"), &[90.0, 270.0]);
        happen(&events, |what| !slides_back(what) && !turns_back("2")(what), &[]);
    }
}

/// A crank that is too long stops where the rod is normal to the guide.
#[test]
fn a_crank_too_long() {
    for [a, b, e] in [[80.0, 60.0, 5.0], [100.0, 100.5, -1.0], [50.0, 3.0, 0.2]] {
        let events = events(&slider_crank(a, b, e, [TURNS, ""]));
        let high = asin((e + b) / a);
        // Where the rod reaches below the circle of the crank, the crank swings through there.
        let low = if b - e < a { asin((e - b) / a) } else { 180.0 - high };
        happen(&events, limit, &[high, low]);
    }
}

/// A pushed piston stops where crank and rod are in line.
#[test]
fn a_pushed_piston() {
    for [a, b, e] in [[50.0, 150.0, -20.0], [30.0, 40.0, 6.5]] {
        let push = format!(r#", "drive": {{ "position": {b:?}, "speed": 1 }}"#);
        let events = events(&slider_crank(a, b, e, ["", &push]));
        let ends: Vec<f64> = events.iter().filter(|e| limit(&e.what)).map(|e| e.at).collect();
        let expected = [b - a, a + b].map(|reach| ((reach - e) * (reach + e)).sqrt());
        assert_eq!(ends.len(), 2, "{events:?}");
        for (end, expected) in ends.iter().zip(expected) {
            assert!((end - expected).abs() < LOCATED * (a + b), "{end} {expected}");
        }
    }
}

/// A lever about O whose slot passes O at distance `h`, moved by a crank pin about (0, d).
fn slotted_lever(a: f64, d: f64, h: f64) -> String {
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "O": [0, 0], "A": [0, {d:?}] }},
          "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {a:?} }}, "drive": {{ "angle": 20, "omega": 1 }} }},
                      "2": {{ "points": ["B"] }}, "3": {{ "shape": {{ "O": [0, 0], "P": [10, {h:?}], "Q": [150, {h:?}] }} }} }},
          "sliders": [{{ "link": "2", "at": "B", "on": "3", "through": "P", "along": "PQ" }}], "near": {{ "Q": [30, {:?}] }} }}"#,
        d + 200.0
    )
}

/// The lever turns back where the crank is normal to its slot: with the slot through its pivot, sin θ = −a/d.
#[test]
fn a_slotted_lever() {
    for [a, d] in [[60.0, 120.0], [25.0, 26.0], [3.0, 200.0]] {
        let events = events(&slotted_lever(a, d, 0.0));
        let low = asin(-a / d);
        happen(&events, turns_back("3"), &[low, 180.0 - low]);
        // The block slides back where it is nearest and farthest.
        happen(&events, slides_back, &[90.0, 270.0]);
    }
}

/// An offset slot stops the crank where its pin comes as near to the pivot as the slot.
#[test]
fn an_offset_slot() {
    for [a, d, h] in [[60.0, 120.0, 80.0], [60.0, 50.0, 12.0], [30.0, 100.0, 70.001]] {
        let events = events(&slotted_lever(a, d, h));
        let low = asin((h * h - a * a - d * d) / (2.0 * a * d));
        happen(&events, limit, &[low, 180.0 - low]);
    }
}

/// A lever drives a slider along x = h: y = h tan θ runs off to infinity at ±90°.
#[test]
fn a_tangent() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0] },
      "links": { "1": { "points": ["O", "L"], "lengths": { "OL": 50 }, "drive": { "angle": 20, "omega": 1 } },
                 "2": { "points": ["P"] }, "3": { "points": ["P"] } },
      "sliders": [{ "link": "2", "at": "P", "on": "1", "along": "OL" },
                  { "link": "3", "at": "P", "on": "ground", "through": [70, 0], "along": 90 }],
      "near": { "P": [70, 25] } }"#;
    let events = events(scene);
    let runs_off = |what: &Happening| matches!(what, Happening::RunsOff(_));
    happen(&events, runs_off, &[90.0, -90.0]);
    happen(&events, limit, &[]);
    assert!(events[0].text("P", &Wording::default()).contains("infinity"));
}
