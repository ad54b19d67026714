//! One result against what is expected of it, number by number.

use super::exact::{Exact, minus};
use kinegon::format::{PointResult, ResultFile};
use serde_json::Value;
use std::collections::BTreeMap;

/// Distance of a special point, in sizes of the mechanism, from which "at infinity" is a fair answer though it is not quite there.
const NEXT_TO_INFINITY: f64 = 1e8;

pub fn entries(json: &Value) -> impl Iterator<Item = (&str, &Value)> {
    json.as_object().into_iter().flatten().map(|(k, v)| (k.as_str(), v))
}

/// A slider's name as results have it: the cases write the guide's body only where a link has several sliders.
pub fn slider_name(key: &str, truth: &Value) -> String {
    let link = key.split('/').next().unwrap_or(key);
    format!("{link}/{}", truth["on"].as_str().expect("a name"))
}

pub fn decimal(json: &Value) -> &str {
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

const MOTIONS: [(&str, Kind); 3] =
    [("position", Kind::Position), ("velocity", Kind::Velocity), ("acceleration", Kind::Acceleration)];

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
                point[key].as_array().into_iter().flatten().for_each(|v| put(kind, v));
            }
        }
        for (_, slider) in entries(&expect["sliders"]) {
            for (key, kind) in MOTIONS {
                slider.get(key).into_iter().for_each(|v| put(kind, v));
            }
        }
        let length = size(expect);
        // A kind that is zero throughout takes its scale from the others.
        let get = |kind| scale_or_zero(&of, kind);
        let (omega, alpha) = (get(Kind::Omega), get(Kind::Alpha));
        let velocity = get(Kind::Velocity).max(omega * length);
        let acceleration = get(Kind::Acceleration).max(alpha * length).max(omega * omega * length);
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

/// The larger side of the box around the points.
pub fn size(expect: &Value) -> f64 {
    let mut size: f64 = 0.0;
    for axis in 0..2 {
        let places = entries(&expect["points"]).map(|(_, p)| approximate(&p["position"][axis]));
        let (low, high) = places.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
        size = size.max(high - low);
    }
    size
}

fn scale_or_zero(of: &BTreeMap<Kind, f64>, kind: Kind) -> f64 {
    of.get(&kind).copied().unwrap_or(0.0)
}

/// One result against what is expected of it.
pub struct Comparison<'a> {
    expect: &'a Value,
    scene: &'a Value,
    result: &'a ResultFile,
    scales: Scales,
    /// Errors, relative to their scales, and of what.
    pub errors: Vec<(f64, String)>,
    pub problems: Vec<String>,
}

impl<'a> Comparison<'a> {
    pub fn new(expect: &'a Value, scene: &'a Value, result: &'a ResultFile) -> Self {
        Comparison { expect, scene, result, scales: Scales::new(expect), errors: Vec::new(), problems: Vec::new() }
    }

    pub fn all(&mut self) {
        let (expect, result) = (self.expect, self.result);
        for (name, truth) in entries(&expect["links"]) {
            let Some(link) = result.links.get(name) else {
                self.problems.push(format!("no link {name}"));
                continue;
            };
            self.number(Kind::Omega, format!("omega({name})"), Some(link.omega), &truth["omega"]);
            self.number(Kind::Alpha, format!("alpha({name})"), link.alpha, &truth["alpha"]);
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
        self.errors.push((minus(x, decimal(truth)).abs() / scale, what));
    }

    fn pair(&mut self, kind: Kind, what: &str, got: Option<[f64; 2]>, truth: &Value) {
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            self.number(kind, format!("{what}.{name}"), got.map(|v| v[axis]), &truth[axis]);
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
        self.errors.push((angle_error(x, truth) / 180.0, what));
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
            self.problems.push(format!("slider {name} is on {}", slider.on));
        }
        let values = [Some(slider.velocity), slider.acceleration, slider.position];
        let keys = [MOTIONS[1], MOTIONS[2], MOTIONS[0]];
        for ((key, kind), got) in keys.into_iter().zip(values) {
            if let Some(truth) = truth.get(key) {
                self.number(kind, format!("{key} of {name}"), got, truth);
            }
        }
        // The truth is signed along the turned guide; the result is a vector: sizes are compared.
        let coriolis = slider.coriolis.map(|[x, y]| libm::hypot(x, y).copysign(approximate(&truth["coriolis"])));
        self.number(Kind::Acceleration, format!("coriolis of {name}"), coriolis, &truth["coriolis"]);
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
                self.problems.push(format!("{name} is at infinity, not at {place:?}"));
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
        self.errors.push((length(differ(place, truth_place)) / scale, format!("position of {name}")));
        self.special_motion(name, got, own, place, &self.expect["links"][link]);
    }

    fn special_motion(&mut self, name: &str, got: &PointResult, own: &Value, place: [Exact; 2], link: &Value) {
        let arm = differ(place, read_pair(&own["position"]));
        let (omega, alpha) = (Exact::read(decimal(&link["omega"])), Exact::read(decimal(&link["alpha"])));
        let [v, a] = ["velocity", "acceleration"].map(|key| read_pair(&own[key]));
        let velocity = [v[0] - omega * arm[1], v[1] + omega * arm[0]];
        let square = omega * omega;
        let acceleration = [a[0] - alpha * arm[1] - square * arm[0], a[1] + alpha * arm[0] - square * arm[1]];
        let reach = length(arm).max(length(place));
        let of = &self.scales.of;
        let rates = [of[&Kind::Omega], of[&Kind::Alpha].max(of[&Kind::Omega].powi(2))];
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

/// By how many degrees an angle is wrong, whole turns aside.
pub fn angle_error(x: f64, truth: &str) -> f64 {
    let turned = |by: f64| (Exact::from(x) + Exact::from(by) - Exact::read(truth)).rounded().abs();
    [-720.0, -360.0, 0.0, 360.0, 720.0].map(turned).into_iter().fold(f64::MAX, f64::min)
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
