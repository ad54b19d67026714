//! The starting scenes in `templates/`: true numbers, two routes that agree, no warnings, and velocities and accelerations
//! that are the derivatives of positions solved anew.
//!
//! `tests/templates/README.md` says where the true numbers come from. An error counts relative to the largest magnitude
//! of its kind of quantity (angles: to 180°); differences are taken in exact arithmetic.

use kinegon::Solution;
use kinegon::format::ResultFile;
use serde_json::Value;
use std::collections::BTreeMap;
use support::comparison::entries;
use support::exact::{Exact, exceeds, minus};
use support::files::{path, read, templates};
use support::later::{differences, fastest};
use support::stages::solved;

/// Largest error against the truth.
const MOST: f64 = 1e-12;

/// Central differences halve their step and must quarter their error, within this part.
const ORDER_WITHIN: f64 = 0.2;

/// Kinds whose numbers are compared with the truth.
const WITH_TRUTH: usize = 12;

/// Kinds that move from lengths.
const MOVED: usize = 24;

/// The true numbers of a template, where there are some.
fn truth(name: &str) -> Option<Value> {
    let path = path(&format!("tests/templates/{name}.expect.json"));
    let text = std::fs::read_to_string(path).ok()?;
    Some(serde_json::from_str(&text).expect("the truth is JSON"))
}

fn result(name: &str, text: &str) -> ResultFile {
    solution(name, text).result()
}

fn solution(name: &str, text: &str) -> Solution {
    solved(text).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_template_has_a_title_and_solves_without_a_warning() {
    for (name, text) in templates() {
        let solution = solution(&name, &text);
        assert!(solution.scene.title.is_some(), "{name}");
        assert!(text.contains("\"$schema\": \"scene.schema.json\""), "{name}");
        let result = solution.result();
        assert!(result.warnings.is_empty(), "{name}: {:?}", result.warnings);
    }
}

#[test]
fn both_routes_agree() {
    for (name, text) in templates() {
        for group in result(&name, &text).groups {
            let (Some(difference), Some(allowed)) = (group.disagreement, group.disagreement_allowed) else {
                panic!("{name}: the links {:?} have no second route", group.links);
            };
            assert!(
                !exceeds(difference, allowed),
                "{name}: {:?} differ by {difference:e}, allowed is {allowed:e}",
                group.links
            );
        }
    }
}

/// In a plan a ray comes from where its leg starts and ends where it crosses the other: two legs that start under one point, on
/// different links, have places of their own.
#[test]
fn every_ray_runs_through_both_its_points() {
    let mut seen = 0;
    for (name, text) in templates() {
        let construction = solution(&name, &text).construction;
        for plan in construction.plans() {
            for ray in construction.rays(plan.order) {
                let along = plan.segment(&ray.through, &ray.to).expect("both are there");
                let off = along.perp(&ray.direction) / ray.direction.norm();
                let size = plan.points.values().map(|p| p.vector.norm());
                let size = size.fold(0.0, f64::max);
                assert!(
                    off.abs() <= MOST * size,
                    "{name}: the ray through {} misses {} by {off:e}",
                    ray.through,
                    ray.to
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 50);
}

/// Errors by kind of quantity, largest true magnitudes beside them.
#[derive(Default)]
struct Errors {
    of: BTreeMap<&'static str, (f64, f64)>,
}

impl Errors {
    fn number(&mut self, kind: &'static str, got: f64, truth: &Value) {
        let truth = truth.as_str().expect("true numbers are decimal strings");
        let size: f64 = truth.parse().expect("a decimal number");
        let (error, scale) = self.of.entry(kind).or_default();
        *error = error.max(minus(got, truth).abs());
        *scale = scale.max(size.abs());
    }

    fn angle(&mut self, got: f64, truth: &Value) {
        let truth = truth.as_str().expect("true numbers are decimal strings");
        let turned = |by: f64| (Exact::from(got) + Exact::from(by) - Exact::read(truth)).rounded();
        let errors = [-360.0, 0.0, 360.0].map(|by| turned(by).abs());
        let (error, scale) = self.of.entry("angle").or_default();
        *error = error.max(errors.into_iter().fold(f64::MAX, f64::min));
        *scale = 180.0;
    }

    fn pair(&mut self, kind: &'static str, got: Option<[f64; 2]>, truth: &Value) {
        let got = got.unwrap_or_else(|| panic!("no {kind}"));
        for axis in 0..2 {
            self.number(kind, got[axis], &truth[axis]);
        }
    }
}

#[test]
fn numbers_are_true() {
    let mut seen = 0;
    for (name, text) in templates() {
        let Some(truth) = truth(&name) else { continue };
        seen += 1;
        let result = result(&name, &text);
        let mut errors = Errors::default();
        for (link, truth) in entries(&truth["links"]) {
            let got = &result.links[link];
            errors.angle(got.angle.expect("a link has an angle"), &truth["angle"]);
            errors.number("omega", got.omega, &truth["omega"]);
            errors.number("alpha", got.alpha.expect("asked for"), &truth["alpha"]);
        }
        for (point, truth) in entries(&truth["points"]).chain(entries(&truth["coincident"])) {
            let got = &result.points[point];
            errors.pair("position", got.position, &truth["position"]);
            errors.pair("velocity", got.velocity, &truth["velocity"]);
            errors.pair("acceleration", got.acceleration, &truth["acceleration"]);
        }
        for (link, truth) in entries(&truth["sliders"]) {
            let on = truth["on"].as_str().expect("a name");
            let got = &result.sliders[&format!("{link}/{on}")];
            let position = got.position.expect("it is counted from somewhere");
            errors.number("position", position, &truth["position"]);
            errors.number("velocity", got.velocity, &truth["velocity"]);
            let acceleration = got.acceleration.expect("asked for");
            errors.number("acceleration", acceleration, &truth["acceleration"]);
        }
        for (kind, (error, scale)) in &errors.of {
            assert!(!exceeds(*error, MOST * scale), "{name}: {kind} is wrong by {error:e} of {scale}");
        }
        groups_are(&name, &result, &truth["groups"]);
    }
    assert_eq!(seen, WITH_TRUTH);
}

/// Checks the groups' links and classes, and how many modes they have.
fn groups_are(name: &str, result: &ResultFile, truth: &Value) {
    let truth = truth.as_array().expect("a list");
    assert_eq!(result.groups.len(), truth.len(), "{name}");
    for expected in truth {
        let links = expected["links"].as_array().expect("a list");
        let is_it = |has: &[String]| has.len() == links.len() && links.iter().all(|l| has.iter().any(|h| l == h));
        let group = result.groups.iter().find(|group| is_it(&group.links));
        let group = group.unwrap_or_else(|| panic!("{name}: no group of the links {links:?}"));
        assert_eq!(expected["class"], *group.class, "{name}");
        if let Some(modes) = expected.get("modes") {
            assert_eq!(modes.as_u64(), group.modes.map(|modes| modes as u64), "{name}");
        }
    }
}

/// A crank pin's place follows from the drive, so it need not stand in `near` to settle a triangle's hand.
#[test]
fn a_driven_point_settles_a_triangles_hand() {
    for (kind, place) in [("stephenson-3", r#""B": [20, 35], "#), ("watt-1", r#""B": [25, 45], "#)] {
        let text = read(&format!("templates/{kind}.json"));
        let less = text.replace(place, "");
        assert_ne!(text, less, "{kind}");
        let without = result(kind, &less);
        assert!(without.warnings.is_empty(), "{kind}: {:?}", without.warnings);
        let all = result(kind, &text);
        for (point, there) in &all.points {
            assert_eq!(without.points[point].position, there.position, "{kind}: {point}");
        }
    }
}

#[test]
fn rates_are_derivatives_of_positions() {
    let mut seen = 0;
    for (name, text) in templates() {
        let scene: Value = serde_json::from_str(&text).expect("a template is JSON");
        let Some(fastest) = fastest(&scene) else {
            continue;
        };
        seen += 1;
        let now = result(&name, &text);
        // The fastest drive turns by 1°, by half and by a quarter of a degree, or is pushed by as much of its position: far above what
        // rounding adds.
        let errors = [1.0_f64, 0.5, 0.25].map(|degrees| {
            let time = degrees.to_radians() / fastest;
            differences(&scene, &now, time).unwrap_or_else(|error| panic!("{name}: {error}"))
        });
        for (what, index) in [("velocity", 0), ("acceleration", 1)] {
            let [coarse, middle, fine] = errors.map(|error| error[index]);
            for ratio in [coarse / middle, middle / fine] {
                assert!(
                    (ratio / 4.0 - 1.0).abs() < ORDER_WITHIN,
                    "{name}: {what} differs by {coarse:e}, {middle:e}, {fine:e}"
                );
            }
        }
    }
    assert_eq!(seen, MOVED);
}
