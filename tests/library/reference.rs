//! Every scene of `tests/reference` against its true motion (20 digits; `tests/reference/README.md` says where it comes from).
//!
//! The error of a number is |x − true| / max(|true|, scale), where scale is the largest magnitude of that kind of quantity in
//! the case; kinds are ω, α, and the components of positions, velocities and accelerations. It is counted in units u·cond:
//! u = 2^−53, cond the condition number of the velocity equations, at least 1. Differences are taken in exact arithmetic.

use kinegon::Error;
use kinegon::format::ResultFile;
use kinegon::geometry::degrees_of;
use kinegon::mechanism::mechanism;
use kinegon::motion::MotionError;
use kinegon::position::{AssemblyError, pose};
use kinegon::scene::Scene;
use serde_json::Value;
use support::comparison::{Comparison, angle_error, decimal, entries, size, slider_name};
use support::exact::{exactly_written, exceeds, minus};
use support::files;
use support::stages::solved;

const U: f64 = f64::EPSILON / 2.0;

/// Errors allowed where positions are given, in units u·cond.
const DRAWN_BOUND: f64 = 1.0;

/// How far a number of 20 digits may be from the true one.
const PUBLISHED: f64 = 5e-20;

/// Errors allowed where positions come from lengths, in units cond: the way from lengths to places has a condition of its own.
const LENGTHS_BOUND: f64 = 1e-11;

/// Stated bounds must not be this many times the true error in the middle of all numbers: they would say nothing.
const WASTEFUL: f64 = 100.0;

/// From this condition on a scene may be refused as singular: two digits of its rates are certain at best.
const MAY_BE_REFUSED: f64 = 1e14;

/// The same for small groups, whose families reach the singular position in fewer steps.
const SMALL_MAY_BE_REFUSED: f64 = 1e13;

/// Errors allowed in the places and angles of assembly modes, relative to the size of the mechanism.
const MODE_BOUND: f64 = 1e-10;

#[test]
fn revolute_groups() {
    Report::of_set("class4").demand(25, 0);
}

#[test]
fn groups_with_prismatic_joints() {
    Report::of_set("class4_prismatic").demand(43, 0);
}

#[test]
fn hard_groups() {
    Report::of_set("hard").demand(258, 3);
}

#[test]
fn dyads() {
    Report::of_set("dyads").demand(20, 0);
}

#[test]
fn triads() {
    Report::of_set("triads").demand(15, 0);
}

#[test]
fn hard_dyads_and_triads() {
    Report::of_set("hard_dyads_triads").demand(54, 4);
}

#[test]
fn the_papers_mechanism_as_drawn() {
    Report::of_set("paper_drawn").demand(72, 0);
}

#[test]
fn the_papers_mechanism_from_lengths() {
    Report::of_set("paper").demand(72, 0);
}

/// Every assembly mode of 30 mechanisms: that `near` finds it, that none is counted twice or left out, and that a mechanism
/// that cannot be assembled is told so.
#[test]
fn assembly_modes() {
    let text = files::read("tests/reference/modes.jsonl");
    let (mut found, mut counted, mut impossible) = (0, 0, 0);
    let mut worst = (0.0, String::new());
    let mut failures = Vec::new();
    for line in text.lines() {
        let case: Value = serde_json::from_str(line).expect("a line is JSON");
        let name = case["name"].as_str().expect("a case has a name");
        let (_, which) = name.rsplit_once('/').expect("a case of a mechanism");
        let scene = Scene::read(files::scene_text(line)).expect("a good scene");
        let mechanism = mechanism(&scene).expect("a mechanism");
        let pose = pose(&mechanism, &scene.near);
        if which == "none" {
            impossible += 1;
            if !matches!(pose, Err(AssemblyError::NoMode { .. })) {
                failures.push(format!("{name}: not refused: {:?}", pose.err()));
            }
            continue;
        }
        let pose = match pose {
            Ok(pose) => pose,
            Err(error) => {
                failures.push(format!("{name}: {error}"));
                continue;
            }
        };
        let expect = &case["expect"];
        // The group in question: the one that the scene is about is the last to be assembled.
        let [.., Some(assembly)] = pose.assemblies[..] else { panic!("{name} has a group with modes") };
        if Some(assembly.modes as u64) != expect["modes"].as_u64() {
            let (got, want) = (assembly.modes, &expect["modes"]);
            failures.push(format!("{name}: {got} modes in place of {want}"));
        }
        if which == "any" {
            counted += 1;
            continue;
        }
        found += 1;
        if !pose.warnings.is_empty() {
            failures.push(format!("{name}: {:?}", pose.warnings));
        }
        let size = size(expect);
        let mut errors = Vec::new();
        for (point, truth) in entries(&expect["points"]) {
            let id = mechanism.point(point).expect("a point of the scene");
            let place = pose.point(id);
            for (axis, x) in [place.x, place.y].into_iter().enumerate() {
                let error = minus(x, decimal(&truth["position"][axis])).abs() / size;
                errors.push((error, format!("{name}: position of {point}")));
            }
        }
        for (link, truth) in entries(&expect["links"]) {
            let id = mechanism.link(link).expect("a link of the scene");
            let axis = pose.axes[id.0].expect("it has an axis");
            let error = angle_error(degrees_of(axis), decimal(&truth["angle"]));
            errors.push((error / 180.0, format!("{name}: angle of {link}")));
        }
        for (error, what) in errors {
            if exceeds(error, MODE_BOUND) {
                failures.push(format!("{what} is wrong by {error:.3e}"));
            }
            if exceeds(error, worst.0) {
                worst = (error, what);
            }
        }
    }
    let (error, what) = worst;
    println!("modes: {found} found, largest error {error:.3e} ({what})");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert_eq!((found, counted, impossible), (90, 27, 3));
}

/// What a set of cases gave.
struct Report {
    set: &'static str,
    cases: usize,
    singular: usize,
    refused: usize,
    /// Largest error in units u·cond, and where.
    worst: (f64, String),
    /// Stated bound over true error, where there is an error.
    bound_ratios: Vec<f64>,
    /// In how many groups there are two routes.
    two_routes: usize,
    /// Stated difference of the two routes over the allowed one.
    largest_disagreement: f64,
    failures: Vec<String>,
}

impl Report {
    fn of_set(set: &'static str) -> Report {
        let text = files::read(&format!("tests/reference/{set}.jsonl"));
        let mut report = Report {
            set,
            cases: 0,
            singular: 0,
            refused: 0,
            worst: (0.0, String::new()),
            bound_ratios: Vec::new(),
            two_routes: 0,
            largest_disagreement: 0.0,
            failures: Vec::new(),
        };
        for line in text.lines() {
            report.case(line);
        }
        report
    }

    fn may_be_refused(&self) -> f64 {
        match self.set {
            "hard_dyads_triads" => SMALL_MAY_BE_REFUSED,
            _ => MAY_BE_REFUSED,
        }
    }

    fn demand(mut self, cases: usize, singular: usize) {
        println!(
            "{}: {} cases, {} singular, {} refused near singularity; largest error {:.3} u·cond ({}); \
             in {} groups two routes, which differ by at most {:.3} of what is allowed",
            self.set,
            self.cases,
            self.singular,
            self.refused,
            self.worst.0,
            self.worst.1,
            self.two_routes,
            self.largest_disagreement,
        );
        self.bound_ratios.sort_by(f64::total_cmp);
        if let [least, ..] = self.bound_ratios.as_slice() {
            let middle = self.bound_ratios[self.bound_ratios.len() / 2];
            assert!(middle < WASTEFUL, "the stated bounds say too little: {middle:.0}");
            println!("{}: stated bound / error: median {middle:.1}, least {least:.2}", self.set);
        }
        let count = self.failures.len();
        self.failures.truncate(20);
        assert!(count == 0, "{count} failures:\n{}", self.failures.join("\n"));
        assert_eq!((self.cases, self.singular), (cases, singular));
    }

    fn case(&mut self, line: &str) {
        let case: Value = serde_json::from_str(line).expect("a line is JSON");
        let name = case["name"].as_str().expect("a case has a name");
        self.cases += 1;
        let scene = files::scene_text(line);
        // Numbers of the paper are decimals; all others mean their f64.
        let scene = if self.set.starts_with("paper") { scene.to_owned() } else { exactly_written(scene) };
        let solved = solved(&scene).map(|solution| solution.result());
        if case["expect"]["singular"] == true {
            self.singular += 1;
            if !matches!(solved, Err(Error::Motion(MotionError::Singular { .. }))) {
                let what = solved.map(|_| "solved");
                self.failures.push(format!("{name}: singular, but {what:?}"));
            }
            return;
        }
        let condition = case["cond"].as_f64().expect("a case has a condition").max(1.0);
        let result = match solved {
            Ok(result) => result,
            Err(Error::Motion(MotionError::Singular { .. })) if condition > self.may_be_refused() => {
                self.refused += 1;
                return;
            }
            Err(other) => {
                self.failures.push(format!("{name}: {other}"));
                return;
            }
        };
        self.finite(name, &result);
        let mut comparison = Comparison::new(&case["expect"], &case["scene"], &result);
        comparison.all();
        for problem in comparison.problems {
            self.failures.push(format!("{name}: {problem}"));
        }
        let bound = match self.set {
            "paper" => LENGTHS_BOUND / U,
            _ => DRAWN_BOUND,
        };
        for (error, what) in comparison.errors {
            let error = error / (U * condition);
            if exceeds(error, bound) {
                self.failures.push(format!("{name}: {what} is wrong by {error:.3e} u·cond"));
            }
            if exceeds(error, self.worst.0) {
                self.worst = (error, format!("{name}: {what}"));
            }
        }
        // The stated bounds speak of given positions; those of the paper's sets are rounded.
        if !self.set.starts_with("paper") {
            self.stated_bounds(name, &case["expect"], &result);
        }
        self.disagreement(name, &result);
    }

    /// A NaN or an infinity never leaves the library.
    fn finite(&mut self, name: &str, result: &ResultFile) {
        // serde_json writes what is no number as null; an absent option is not written at all, but for these two.
        let mut json = serde_json::to_value(result).expect("a result can be written");
        for group in json["groups"].as_array_mut().into_iter().flatten() {
            for key in ["disagreement", "disagreement_allowed"] {
                if result.groups.iter().all(|g| g.disagreement.is_none()) {
                    group[key] = Value::Bool(true);
                }
            }
        }
        if holds_null(&json) {
            self.failures.push(format!("{name}: a NaN or an infinity in {json}"));
        }
    }

    fn stated_bounds(&mut self, name: &str, expect: &Value, result: &ResultFile) {
        let mut check = |what: String, value: f64, truth: &Value, bound: f64| {
            let error = minus(value, decimal(truth)).abs();
            let published = PUBLISHED * value.abs();
            if exceeds(error, bound + published) {
                self.failures.push(format!("{name}: {what} is wrong by {error:e}, stated is {bound:e}"));
            }
            if error > published {
                self.bound_ratios.push(bound / error);
            }
        };
        for (link, truth) in entries(&expect["links"]) {
            let got = &result.links[link];
            check(format!("omega({link})"), got.omega, &truth["omega"], got.omega_error);
            let (alpha, bound) = (got.alpha.expect("asked for"), got.alpha_error.expect("asked for"));
            check(format!("alpha({link})"), alpha, &truth["alpha"], bound);
        }
        for (link, truth) in entries(&expect["sliders"]) {
            let name = slider_name(link, truth);
            let got = &result.sliders[&name];
            check(format!("v_r({name})"), got.velocity, &truth["velocity"], got.velocity_error);
            let (second, bound) = (got.acceleration.expect("asked for"), got.acceleration_error.expect("asked for"));
            check(format!("a_r({name})"), second, &truth["acceleration"], bound);
        }
    }

    fn disagreement(&mut self, name: &str, result: &ResultFile) {
        for group in &result.groups {
            let at_infinity = group.special_points.iter().any(|s| result.points[s].at_infinity.is_some());
            match (group.disagreement, group.disagreement_allowed) {
                (Some(difference), Some(allowed)) => {
                    self.largest_disagreement =
                        self.largest_disagreement.max(difference / allowed.max(f64::MIN_POSITIVE));
                    self.two_routes += 1;
                    if exceeds(difference, allowed) {
                        self.failures
                            .push(format!("{name}: the routes differ by {difference:e}, allowed is {allowed:e}"));
                    }
                }
                (None, None) if at_infinity => {}
                other => self.failures.push(format!("{name}: the second route says {other:?}")),
            }
        }
    }
}

fn holds_null(json: &Value) -> bool {
    match json {
        Value::Null => true,
        Value::Array(items) => items.iter().any(holds_null),
        Value::Object(items) => items.values().any(holds_null),
        _ => false,
    }
}
