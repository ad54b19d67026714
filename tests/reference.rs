//! Every scene of `tests/reference` against its true motion (20 digits; `tests/reference/README.md` says where it comes from).
//!
//! The error of a number is |x − true| / max(|true|, scale), where scale is the largest magnitude of that kind of quantity in
//! the case; kinds are ω, α, and the components of positions, velocities and accelerations. It is counted in units u·cond:
//! u = 2^−53, cond the condition number of the velocity equations, at least 1. Differences are taken in exact arithmetic.

mod exact;

use std::collections::BTreeMap;
use std::path::Path;

use exact::{Exact, exceeds, minus};
use kinegon::format::{self, PointResult, ResultFile, Solved};
use kinegon::mechanism::mechanism;
use kinegon::motion::{MotionError, Order, motion};
use kinegon::plan::construction;
use kinegon::position::pose;
use kinegon::scene::Scene;
use serde_json::Value;

const U: f64 = f64::EPSILON / 2.0;

/// Errors allowed where positions are given, in units u·cond; careful code stays below 2.
const DRAWN_BOUND: f64 = 8.0;

/// Errors allowed where positions come from lengths, in units cond: the way from lengths to places has a condition of its own.
const LENGTHS_BOUND: f64 = 1e-11;

/// Stated bounds must not be this many times the true error in the middle of all numbers: they would say nothing.
const WASTEFUL: f64 = 1000.0;

/// From this condition on a scene may be refused as singular: two digits of its rates are certain at best.
const MAY_BE_REFUSED: f64 = 1e14;

/// Distance of a special point, in sizes of the mechanism, from which "at infinity" is a fair answer though it is not quite there.
const NEXT_TO_INFINITY: f64 = 1e8;

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
fn the_papers_mechanism_as_drawn() {
    Report::of_set("paper_drawn").demand(72, 0);
}

#[test]
fn the_papers_mechanism_from_lengths() {
    Report::of_set("paper").demand(72, 0);
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
    /// Stated difference of the two routes over the allowed one.
    largest_disagreement: f64,
    failures: Vec<String>,
}

impl Report {
    fn of_set(set: &'static str) -> Report {
        let file =
            Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/reference/{set}.jsonl"));
        let text = std::fs::read_to_string(file).expect("the cases can be read");
        let mut report = Report {
            set,
            cases: 0,
            singular: 0,
            refused: 0,
            worst: (0.0, String::new()),
            bound_ratios: Vec::new(),
            largest_disagreement: 0.0,
            failures: Vec::new(),
        };
        for line in text.lines() {
            report.case(line);
        }
        report
    }

    fn demand(mut self, cases: usize, singular: usize) {
        println!(
            "{}: {} cases, {} singular, {} refused near singularity; largest error {:.3} u·cond ({}); \
             routes differ by at most {:.3} of what is allowed",
            self.set,
            self.cases,
            self.singular,
            self.refused,
            self.worst.0,
            self.worst.1,
            self.largest_disagreement,
        );
        self.bound_ratios.sort_by(f64::total_cmp);
        if let [least, ..] = self.bound_ratios.as_slice() {
            let middle = self.bound_ratios[self.bound_ratios.len() / 2];
            assert!(
                middle < WASTEFUL,
                "the stated bounds say too little: {middle:.0}"
            );
            println!(
                "{}: stated bound / error: median {middle:.1}, least {least:.2}",
                self.set
            );
        }
        let count = self.failures.len();
        self.failures.truncate(20);
        assert!(
            count == 0,
            "{count} failures:\n{}",
            self.failures.join("\n")
        );
        assert_eq!((self.cases, self.singular), (cases, singular));
    }

    fn case(&mut self, line: &str) {
        let case: Value = serde_json::from_str(line).expect("a line is JSON");
        let name = case["name"].as_str().expect("a case has a name");
        self.cases += 1;
        let solved = solve(scene_text(line));
        if case["expect"]["singular"] == true {
            self.singular += 1;
            if !matches!(solved, Err(Refusal::Singular)) {
                let what = solved.map(|_| "solved");
                self.failures
                    .push(format!("{name}: singular, but {what:?}"));
            }
            return;
        }
        let condition = case["cond"]
            .as_f64()
            .expect("a case has a condition")
            .max(1.0);
        let result = match solved {
            Ok(result) => result,
            Err(Refusal::Singular) if condition > MAY_BE_REFUSED => {
                self.refused += 1;
                return;
            }
            Err(other) => {
                self.failures.push(format!("{name}: {other:?}"));
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
                self.failures
                    .push(format!("{name}: {what} is wrong by {error:.3e} u·cond"));
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
            self.failures
                .push(format!("{name}: a NaN or an infinity in {json}"));
        }
    }

    fn stated_bounds(&mut self, name: &str, expect: &Value, result: &ResultFile) {
        let mut check = |what: String, value: f64, truth: &Value, bound: f64| {
            let error = minus(value, decimal(truth)).abs();
            if exceeds(error, bound) {
                self.failures.push(format!(
                    "{name}: {what} is wrong by {error:e}, stated is {bound:e}"
                ));
            }
            if error > 0.0 {
                self.bound_ratios.push(bound / error);
            }
        };
        for (link, truth) in entries(&expect["links"]) {
            let got = &result.links[link];
            check(
                format!("omega({link})"),
                got.omega,
                &truth["omega"],
                got.omega_error,
            );
            let (alpha, bound) = (
                got.alpha.expect("asked for"),
                got.alpha_error.expect("asked for"),
            );
            check(format!("alpha({link})"), alpha, &truth["alpha"], bound);
        }
        for (link, truth) in entries(&expect["sliders"]) {
            let name = slider_name(link, truth);
            let got = &result.sliders[&name];
            check(
                format!("v_r({name})"),
                got.velocity,
                &truth["velocity"],
                got.velocity_error,
            );
            let (second, bound) = (
                got.acceleration.expect("asked for"),
                got.acceleration_error.expect("asked for"),
            );
            check(
                format!("a_r({name})"),
                second,
                &truth["acceleration"],
                bound,
            );
        }
    }

    fn disagreement(&mut self, name: &str, result: &ResultFile) {
        for group in &result.groups {
            let at_infinity = group
                .special_points
                .iter()
                .any(|s| result.points[s].at_infinity.is_some());
            match (group.disagreement, group.disagreement_allowed) {
                (Some(difference), Some(allowed)) => {
                    self.largest_disagreement = self
                        .largest_disagreement
                        .max(difference / allowed.max(f64::MIN_POSITIVE));
                    if exceeds(difference, allowed) {
                        self.failures.push(format!(
                            "{name}: the routes differ by {difference:e}, allowed is {allowed:e}"
                        ));
                    }
                }
                (None, None) if at_infinity => {}
                other => self
                    .failures
                    .push(format!("{name}: the second route says {other:?}")),
            }
        }
    }
}

/// Why there is no result.
#[derive(Debug)]
enum Refusal {
    Singular,
    #[expect(dead_code, reason = "shown when a case fails")]
    Other(String),
}

fn solve(text: &str) -> Result<ResultFile, Refusal> {
    let other = |e: &dyn std::error::Error| Refusal::Other(e.to_string());
    let scene = Scene::read(text).map_err(|e| other(&e))?;
    let mechanism = mechanism(&scene).map_err(|e| other(&e))?;
    let pose = pose(&mechanism, &scene.near).map_err(|e| other(&e))?;
    let motion = motion(&mechanism, &pose, Order::Acceleration).map_err(|e| match e {
        MotionError::Singular { .. } => Refusal::Singular,
        e @ MotionError::Overflow { .. } => other(&e),
    })?;
    let construction = construction(&mechanism, &pose, &motion);
    Ok(format::result(Solved {
        units: scene.units,
        mechanism: &mechanism,
        pose: &pose,
        motion: &motion,
        construction: &construction,
    }))
}

/// The scene's own text, so that its numbers are read by the library and nobody before it.
fn scene_text(line: &str) -> &str {
    let key = "\"scene\":";
    let start = line.find(key).expect("a case has a scene") + key.len();
    let mut depth = 0;
    for (i, byte) in line.bytes().enumerate().skip(start) {
        match byte {
            b'{' => depth += 1,
            b'}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &line[start..=i];
        }
    }
    panic!("the scene ends")
}

fn holds_null(json: &Value) -> bool {
    match json {
        Value::Null => true,
        Value::Array(items) => items.iter().any(holds_null),
        Value::Object(items) => items.values().any(holds_null),
        _ => false,
    }
}

fn entries(json: &Value) -> impl Iterator<Item = (&str, &Value)> {
    json.as_object()
        .into_iter()
        .flatten()
        .map(|(k, v)| (k.as_str(), v))
}

/// As in results: the cases write the guide's body only where a link has several sliders.
fn slider_name(key: &str, truth: &Value) -> String {
    let link = key.split('/').next().unwrap_or(key);
    format!("{link}/{}", truth["on"].as_str().expect("a name"))
}

fn decimal(json: &Value) -> &str {
    json.as_str().expect("true numbers are decimal strings")
}

fn approximate(json: &Value) -> f64 {
    decimal(json).parse().expect("a decimal number")
}

/// A kind of quantity: all numbers of a kind share one scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Omega,
    Alpha,
    Position,
    Velocity,
    Acceleration,
}

const MOTIONS: [(&str, Kind); 3] = [
    ("position", Kind::Position),
    ("velocity", Kind::Velocity),
    ("acceleration", Kind::Acceleration),
];

struct Scales {
    of: BTreeMap<Kind, f64>,
    /// Size of the mechanism.
    length: f64,
}

impl Scales {
    fn new(expect: &Value) -> Scales {
        let mut of: BTreeMap<Kind, f64> = BTreeMap::new();
        let mut put = |kind: Kind, value: &Value| {
            let size = of.entry(kind).or_insert(0.0);
            *size = size.max(approximate(value).abs());
        };
        for (_, link) in entries(&expect["links"]) {
            put(Kind::Omega, &link["omega"]);
            put(Kind::Alpha, &link["alpha"]);
        }
        let points = || entries(&expect["points"]).chain(entries(&expect["coincident"]));
        for (_, point) in points() {
            for (key, kind) in MOTIONS {
                point[key]
                    .as_array()
                    .into_iter()
                    .flatten()
                    .for_each(|v| put(kind, v));
            }
        }
        for (_, slider) in entries(&expect["sliders"]) {
            for (key, kind) in MOTIONS {
                slider.get(key).into_iter().for_each(|v| put(kind, v));
            }
        }
        let mut length: f64 = 0.0;
        for axis in 0..2 {
            let places = entries(&expect["points"]).map(|(_, p)| approximate(&p["position"][axis]));
            let (low, high) = places.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
            length = length.max(high - low);
        }
        // A kind that is zero throughout takes its scale from the others.
        let get = |kind| scale_or_zero(&of, kind);
        let (omega, alpha) = (get(Kind::Omega), get(Kind::Alpha));
        let velocity = get(Kind::Velocity).max(omega * length);
        let acceleration = get(Kind::Acceleration)
            .max(alpha * length)
            .max(omega * omega * length);
        let fallback = [
            (Kind::Omega, velocity / length),
            (Kind::Velocity, velocity),
            (Kind::Alpha, acceleration / length),
            (Kind::Acceleration, acceleration),
            (Kind::Position, length),
        ];
        for (kind, value) in fallback {
            if scale_or_zero(&of, kind) == 0.0 {
                of.insert(kind, if value > 0.0 { value } else { 1.0 });
            }
        }
        Scales { of, length }
    }
}

fn scale_or_zero(of: &BTreeMap<Kind, f64>, kind: Kind) -> f64 {
    of.get(&kind).copied().unwrap_or(0.0)
}

/// One result against what is expected of it.
struct Comparison<'a> {
    expect: &'a Value,
    scene: &'a Value,
    result: &'a ResultFile,
    scales: Scales,
    errors: Vec<(f64, String)>,
    problems: Vec<String>,
}

impl<'a> Comparison<'a> {
    fn new(expect: &'a Value, scene: &'a Value, result: &'a ResultFile) -> Self {
        Comparison {
            expect,
            scene,
            result,
            scales: Scales::new(expect),
            errors: Vec::new(),
            problems: Vec::new(),
        }
    }

    fn all(&mut self) {
        let (expect, result) = (self.expect, self.result);
        for (name, truth) in entries(&expect["links"]) {
            let Some(link) = result.links.get(name) else {
                self.problems.push(format!("no link {name}"));
                continue;
            };
            self.number(
                Kind::Omega,
                format!("omega({name})"),
                Some(link.omega),
                &truth["omega"],
            );
            self.number(
                Kind::Alpha,
                format!("alpha({name})"),
                link.alpha,
                &truth["alpha"],
            );
            if let Some(angle) = truth.get("angle") {
                self.angle(format!("angle({name})"), link.angle, decimal(angle));
            }
        }
        for (name, truth) in entries(&expect["points"]) {
            self.point(name, truth);
        }
        for (link, truth) in entries(&expect["sliders"]) {
            self.slider(link, truth);
        }
        for (name, truth) in entries(&expect["coincident"]) {
            self.point(name, truth);
            let on = result.points.get(name).and_then(|p| p.on.as_deref());
            if on.is_none_or(|on| !name.ends_with(&format!("_{on}"))) {
                self.problems.push(format!("{name} is on {on:?}"));
            }
        }
        for (name, truth) in entries(&expect["special"]) {
            self.special(name, truth);
        }
    }

    fn number(&mut self, kind: Kind, what: String, got: Option<f64>, truth: &Value) {
        let Some(x) = got else {
            self.problems.push(format!("{what} is missing"));
            return;
        };
        let scale = approximate(truth).abs().max(self.scales.of[&kind]);
        self.errors
            .push((minus(x, decimal(truth)).abs() / scale, what));
    }

    fn pair(&mut self, kind: Kind, what: &str, got: Option<[f64; 2]>, truth: &Value) {
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            self.number(
                kind,
                format!("{what}.{name}"),
                got.map(|v| v[axis]),
                &truth[axis],
            );
        }
    }

    fn angle(&mut self, what: String, got: Option<f64>, truth: &str) {
        let Some(x) = got else {
            self.problems.push(format!("{what} is missing"));
            return;
        };
        if !(x > -180.0 && x <= 180.0) {
            self.problems.push(format!("{what} is {x}"));
        }
        let turned = |by: f64| {
            (Exact::from(x) + Exact::from(by) - Exact::read(truth))
                .rounded()
                .abs()
        };
        let error = [-720.0, -360.0, 0.0, 360.0, 720.0]
            .map(turned)
            .into_iter()
            .fold(f64::MAX, f64::min);
        self.errors.push((error / 180.0, what));
    }

    fn point(&mut self, name: &str, truth: &Value) {
        let Some(point) = self.result.points.get(name) else {
            self.problems.push(format!("no point {name}"));
            return;
        };
        for (key, kind) in MOTIONS {
            if let Some(truth) = truth.get(key) {
                let got = part(point, kind);
                self.pair(kind, &format!("{key} of {name}"), got, truth);
            }
        }
    }

    fn slider(&mut self, link: &str, truth: &Value) {
        let name = slider_name(link, truth);
        let Some(slider) = self.result.sliders.get(&name) else {
            self.problems.push(format!("no slider {name}"));
            return;
        };
        if truth["on"].as_str() != Some(slider.on.as_str()) {
            self.problems
                .push(format!("slider {name} is on {}", slider.on));
        }
        let values = [Some(slider.velocity), slider.acceleration, slider.position];
        let keys = [MOTIONS[1], MOTIONS[2], MOTIONS[0]];
        for ((key, kind), got) in keys.into_iter().zip(values) {
            if let Some(truth) = truth.get(key) {
                self.number(kind, format!("{key} of {name}"), got, truth);
            }
        }
        // The truth is signed along the turned guide; the result is a vector: sizes are compared.
        let coriolis = slider
            .coriolis
            .map(|[x, y]| libm::hypot(x, y).copysign(approximate(&truth["coriolis"])));
        self.number(
            Kind::Acceleration,
            format!("coriolis of {name}"),
            coriolis,
            &truth["coriolis"],
        );
    }

    /// The place, whose error grows with the square of its distance, and its motion: that of its link wherever the result puts it.
    fn special(&mut self, name: &str, truth: &Value) {
        let Some(got) = self.result.points.get(name) else {
            self.problems.push(format!("no point {name}"));
            return;
        };
        let link = truth["on"].as_str().expect("a name");
        if got.on.as_deref() != Some(link) {
            self.problems.push(format!("{name} is on {:?}", got.on));
        }
        let points = &self.scene["links"][link];
        let points = points.get("points").unwrap_or(points);
        let Some(own) = points[0].as_str().map(|p| &self.expect["points"][p]) else {
            return;
        };
        let home = read_pair(&own["position"]);
        let size = self.scales.length;
        let distance = |p: [Exact; 2]| length(differ(p, home)) / size;
        let Some(truth_place) = truth.get("position").map(read_pair) else {
            let Some(direction) = got.at_infinity else {
                let place = got.position;
                self.problems
                    .push(format!("{name} is at infinity, not at {place:?}"));
                return;
            };
            let [x, y] = read_pair(&truth["at_infinity"]);
            let across = x * direction[1].into() - y * direction[0].into();
            let sizes = length([x, y]) * libm::hypot(direction[0], direction[1]);
            let error = across.rounded().abs() / sizes;
            self.errors.push((error, format!("direction of {name}")));
            return;
        };
        let Some(place) = got.position.map(|p| p.map(Exact::from)) else {
            if !(got.at_infinity.is_some() && distance(truth_place) > NEXT_TO_INFINITY) {
                self.problems.push(format!("{name} has no place"));
            }
            return;
        };
        let far = distance(truth_place).max(1.0);
        let scale = (size * far * far).max(length(truth_place));
        self.errors.push((
            length(differ(place, truth_place)) / scale,
            format!("position of {name}"),
        ));
        self.special_motion(name, got, own, place, &self.expect["links"][link]);
    }

    fn special_motion(
        &mut self,
        name: &str,
        got: &PointResult,
        own: &Value,
        place: [Exact; 2],
        link: &Value,
    ) {
        let arm = differ(place, read_pair(&own["position"]));
        let (omega, alpha) = (
            Exact::read(decimal(&link["omega"])),
            Exact::read(decimal(&link["alpha"])),
        );
        let [v, a] = ["velocity", "acceleration"].map(|key| read_pair(&own[key]));
        let velocity = [v[0] - omega * arm[1], v[1] + omega * arm[0]];
        let square = omega * omega;
        let acceleration = [
            a[0] - alpha * arm[1] - square * arm[0],
            a[1] + alpha * arm[0] - square * arm[1],
        ];
        let reach = length(arm).max(length(place));
        let of = &self.scales.of;
        let rates = [
            of[&Kind::Omega],
            of[&Kind::Alpha].max(of[&Kind::Omega].powi(2)),
        ];
        let kinds = [Kind::Velocity, Kind::Acceleration];
        for ((kind, truth), rate) in kinds.into_iter().zip([velocity, acceleration]).zip(rates) {
            let Some(value) = part(got, kind) else {
                self.problems.push(format!("no {kind:?} of {name}"));
                continue;
            };
            let scale = self.scales.of[&kind].max(reach * rate);
            let error = length(differ(value.map(Exact::from), truth)) / scale;
            self.errors.push((error, format!("{kind:?} of {name}")));
        }
    }
}

fn part(point: &PointResult, kind: Kind) -> Option<[f64; 2]> {
    match kind {
        Kind::Velocity => point.velocity,
        Kind::Acceleration => point.acceleration,
        _ => point.position,
    }
}

fn read_pair(json: &Value) -> [Exact; 2] {
    [0, 1].map(|axis| Exact::read(decimal(&json[axis])))
}

fn differ(a: [Exact; 2], b: [Exact; 2]) -> [Exact; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn length([x, y]: [Exact; 2]) -> f64 {
    libm::hypot(x.rounded(), y.rounded())
}
