//! Mechanisms as a lecturer writes them (`tests/lecture`): faults that their figures and results have had.

use kinegon::Sheet;
use kinegon::Solution;
use kinegon::check::form_names;
use kinegon::construction::PlaceId;
use kinegon::cycle::{Event, Happening};
use kinegon::drawing::{Drawing, Pen, Rect, Shape};
use kinegon::words::Wording;
use std::collections::BTreeSet;
use support::faults::id;
use support::files::read;
use support::stages::solved;

fn solution(scene: &str) -> Solution {
    solved(&read(&format!("tests/lecture/{scene}.json"))).unwrap_or_else(|error| panic!("{scene}: {error}"))
}

/// Whether a line of a link runs through a box.
fn is_struck(drawing: &Drawing, area: Rect) -> bool {
    drawing.marks.iter().filter(|mark| mark.pen == Pen::Link).any(|mark| match mark.shape {
        Shape::Line(a, b) => (0..=2000).any(|k| area.contains(a.lerp(b, f64::from(k) / 2000.0))),
        _ => false,
    })
}

/// A group that stands still is measured by the mechanism that moves: its rates of 1e-17 have no measure of their own.
#[test]
fn two_routes_are_compared_by_the_mechanisms_own_measure() {
    for scene in ["scissor", "shaper", "valve", "whit", "jansen"] {
        let solution = solution(scene);
        for agreement in solution.construction.agreement.iter().flatten() {
            assert!(agreement.difference <= agreement.allowed, "{scene}: {agreement:?}");
            assert!(agreement.allowed < 1e-9, "{scene}: {agreement:?}");
        }
    }
}

#[test]
fn a_form_asks_for_each_segment_once() {
    for scene in ["shaper", "whit", "valve", "bucket", "watt"] {
        let solution = solution(scene);
        let mut seen: BTreeSet<(bool, [usize; 2])> = BTreeSet::new();
        let names = form_names(&solution.construction);
        for name in &names {
            let Some((head, rest)) = name.split_once("plan(") else { continue };
            let sheet = if head == "v" { Sheet::Velocity } else { Sheet::Acceleration };
            let (from, to) = rest.trim_end_matches(')').split_once(',').expect("two ends");
            let place = |name| solution.construction.place(sheet, name).map(|PlaceId(place)| place);
            let mut ends = [from, to].map(|end| place(end).unwrap_or_else(|| panic!("{scene}: {name}")));
            ends.sort_unstable();
            assert!(seen.insert((head == "v", ends)), "{scene}: {name} in {names:?}");
        }
    }
    let shaper = form_names(&solution("shaper").construction);
    // What goes on into the equations stands there; the other names are still quantities.
    for (kept, left_out) in [("vplan(o,a_3)", "vplan(p,a_3)"), ("vplan(d_ground,d)", "vplan(p,d)")] {
        assert!(shaper.iter().any(|n| n == kept) && !shaper.iter().any(|n| n == left_out), "{shaper:?}");
        let solution = solution("shaper");
        assert_eq!(solution.quantity(kept).expect("a value"), solution.quantity(left_out).expect("a value"));
    }
}

/// A drive that turns a slotted link with one point shows its sense.
#[test]
fn a_driven_link_with_one_point_shows_its_sense() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "O": [0, 0], "C": [0, 200] },
        "links": { "1": { "points": ["O"], "drive": { "angle": 60, "omega": 6 } }, "2": { "points": ["A"] },
                   "3": { "points": ["C", "A"], "lengths": { "CA": 120 } } },
        "sliders": [ { "link": "2", "at": "A", "on": "1", "along": 0 } ], "near": { "A": [100, 170] } }"#;
    let drawing = solved(scene).expect("sound").figure();
    let arrow = drawing.marks.iter().find(|mark| id(mark) == "scheme-omega-1").expect("an arrow");
    // Counter-clockwise is negative on the sheet, whose y points down.
    assert!(matches!(arrow.shape, Shape::ArcArrow { sweep, .. } if sweep < 0.0), "{arrow:?}");
}

/// O of the trammel carries no link: no pivot, but a point on hatched ground.
#[test]
fn a_fixed_point_without_a_link_stands_on_the_ground() {
    let drawing = solution("trammel").figure();
    let at = drawing.marks.iter().find(|mark| id(mark) == "scheme-point-O").expect("the point").shape.bounds().center();
    let here = |pen: Pen| {
        drawing.marks.iter().filter(move |mark| mark.pen == pen && (mark.shape.bounds().center() - at).hypot() < 6.0)
    };
    assert_eq!(here(Pen::Slider).count(), 0, "no triangle");
    let ground = here(Pen::Ground).next().expect("a ground line").shape.bounds();
    assert!((ground.center() - at).hypot() < 1e-9 && ground.width() > 5.0, "{ground:?} {at:?}");
    assert!(here(Pen::Hatch).count() >= 4);
}

/// A slotted lever beyond its points is drawn as a slot as wide as an eye sees, narrower than the block.
#[test]
fn a_slotted_lever_has_a_slot() {
    for scene in ["whit", "yoke"] {
        let drawing = solution(scene).figure();
        let closed = drawing.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Polyline(line) if mark.pen == Pen::Guide && line.first() == line.last() => Some(line),
            _ => None,
        });
        let widths = closed.map(|line| {
            // The first corners run round one end: from one side to the other.
            let [first, ..] = line.as_slice() else { return 0.0 };
            (line[line.len() / 2 - 1] - *first).hypot()
        });
        let widths: Vec<f64> = widths.collect();
        assert!(widths.iter().any(|width| (1.8..=3.2).contains(width)), "{scene}: {widths:?}");
    }
}

/// Two nearly coincident links run through V of the valve gear: its name stands beside them.
#[test]
fn names_of_points_are_not_struck_through() {
    let drawing = solution("valve").figure();
    for name in ["C", "D", "E", "H", "V", "W"] {
        let mark = drawing.marks.iter().find(|mark| id(mark) == format!("scheme-label-{name}")).expect("a label");
        let Shape::Text(text) = &mark.shape else { panic!("{mark:?}") };
        assert!(!is_struck(&drawing, text.ink_box()), "{name}");
    }
}

/// Zero is written as zero, not as what rounding leaves of it.
#[test]
fn what_rounding_leaves_of_zero_is_not_told() {
    let what = Happening::TurnsBack { link: "2".into(), angle: -4.646_740_09e-17 };
    let told = Event { at: 30.0, within: 0.0, what }.text("angle(1) = 30°", &Wording::default());
    assert!(told.contains("link 2 stops at 0° and turns back"), "{told}");
}
