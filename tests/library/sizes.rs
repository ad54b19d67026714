//! Large scenes: everything is drawn, names that have no room are told, and time grows hardly faster than the scene.

use kinegon::drawing::{Drawing, Pen};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::time::{Duration, Instant};
use support::stages::solved;
use support::survey::{DRAWN_LINKAGES, LINKAGES};

/// A scene as drawn of many four-bar linkages in rows, each with three links.
fn four_bars(count: usize) -> String {
    let (mut points, mut ground, mut links) = (String::new(), String::new(), String::new());
    let columns = (1..).find(|n| n * n >= count).unwrap_or(1);
    for k in 0..count {
        let comma = if k == 0 { "" } else { "," };
        let (x, y) = (200 * (k % columns), 200 * (k / columns));
        let (bx, by, cx, cy) = (x + 15, y + 26, x + 95 + k % 7, y + 70);
        write!(
            points,
            r#"{comma} "A{k}": [{x}, {y}], "D{k}": [{}, {y}], "B{k}": [{bx}, {by}], "C{k}": [{cx}, {cy}]"#,
            x + 100
        )
        .expect("a string takes all");
        write!(ground, r#"{comma} "A{k}", "D{k}""#).expect("a string takes all");
        let omega = 1 + k % 3;
        write!(
            links,
            r#"{comma} "a{k}": {{ "points": ["A{k}", "B{k}"], "drive": {{ "omega": {omega} }} }}, "b{k}": ["B{k}", "C{k}"], "c{k}": ["D{k}", "C{k}"]"#
        )
        .expect("a string takes all");
    }
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": [{ground}], "points": {{ {points} }}, "links": {{ {links} }} }}"#
    )
}

fn drawn(count: usize) -> (Drawing, Duration) {
    let solution = solved(&four_bars(count)).expect("a good scene");
    let start = Instant::now();
    (solution.figure(), start.elapsed())
}

#[test]
fn a_thousand_links_are_drawn() {
    let count = DRAWN_LINKAGES.now();
    let (figure, _) = drawn(count);
    let ids: BTreeSet<&str> = figure.marks.iter().filter_map(|mark| mark.id.as_deref()).collect();
    for k in 0..count {
        for id in ["link-a", "link-b", "link-c", "point-A", "point-B", "point-C", "point-D"] {
            let id = format!("scheme-{id}{k}");
            assert!(ids.contains(id.as_str()), "{id} is not drawn");
        }
    }
    // Two rays of each dyad in both plans; images that coincide share a mark.
    for plan in ["velocity-ray-", "acceleration-ray-"] {
        assert_eq!(ids.iter().filter(|id| id.starts_with(plan)).count(), 2 * count, "{plan}");
    }
    let lines = |pen: Pen| figure.marks.iter().filter(|mark| mark.pen == pen).count();
    assert!(lines(Pen::Link) >= 3 * count, "{}", lines(Pen::Link));
    // Every name of the scheme stands there or is told as left out: 4 points, 3 links, one ω of each linkage.
    let unlabelled = &figure.unlabelled[0];
    assert_eq!(unlabelled.panel, "Scheme");
    let labels = ids.iter().filter(|id| id.starts_with("scheme-label-")).count();
    assert_eq!(labels + unlabelled.names.len(), 8 * count);
    assert!(ids.contains("scheme-unlabelled"), "the figure does not say that names are missing");
    let svg = figure.svg();
    resvg::usvg::Tree::from_str(&svg, &resvg::usvg::Options::default()).expect("the SVG can be read");
}

#[test]
fn a_small_figure_has_all_names() {
    assert!(drawn(2).0.unlabelled.is_empty());
}

#[test]
#[ignore = "takes long"]
fn time_grows_hardly_faster_than_the_scene() {
    drawn(4);
    // The best of some, on a busy machine; n² would take 16 times as long, what is bounded less than 4 times.
    let best = |count: usize| (0..2).map(|_| drawn(count).1).min().unwrap_or_default();
    let count = LINKAGES.now();
    let (small, large) = (best(count), best(4 * count));
    assert!(large < 10 * small, "{count} linkages {small:?}, 4 times as many {large:?}");
}

#[test]
fn fifty_thousand_points_are_read() {
    let mut ground = String::from(r#""A": [0, 0], "D": [160, 0]"#);
    for k in 0..50_000 {
        write!(ground, r#", "U{k}": [{}, -20]"#, k % 250).expect("a string takes all");
    }
    let scene = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ {ground} }},
            "links": {{
                "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 60 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 140 }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 110 }} }} }},
            "near": {{ "C": [155, 110] }} }}"#
    );
    let start = Instant::now();
    let solution = solved(&scene).expect("a good scene");
    // A second in a release build; comparing all with all took more than twenty.
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    assert_eq!(solution.mechanism.points.len(), 50_004);
}

#[test]
fn more_than_a_scene_may_have_is_refused() {
    let error = solved(&four_bars(3_334)).expect_err("10 002 links");
    let message = error.to_string();
    assert!(message.contains("links: a scene has at most 10000 links, and here are 10002"), "{message}");
}
