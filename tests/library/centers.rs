//! Instant centres, inflection poles and poles of accelerations: of 22 mechanisms against the digits of `tests/centers`, of random ones of all classes against 256 bits.
//! Every stated error holds, what is said to be at infinity is there or as far away as is said, and three centres of three links lie on a line.

use kinegon::Solution;
use kinegon::accuracy::{Bounds, bounds};
use kinegon::centers::{Center, LinkPair};
use kinegon::mechanism::{BodyId, Mechanism};
use kinegon::quantity::{Quantity, QuantityRequest};
use serde_json::Value;
use std::collections::BTreeMap;
use support::exact;
use support::files;
use support::random::Random;
use support::stages::solved;
use support::survey::{CENTERS, on_all_cores};
use support::whole_errors::grow::Grown;
use support::whole_errors::truth::{Pair, Real, Truth, dot, error, exactly, minus, plus, rounded};

/// A place is right to this part of the mechanism's size, or to its stated bound.
const RIGHT: f64 = 1e-12;

/// A stated error may be so many times the error, in the middle of all.
const WASTEFUL: f64 = 5.0;

fn text(value: &Value) -> &str {
    value.as_str().expect("digits")
}

fn asked(name: &str, solution: &Solution) -> QuantityRequest {
    QuantityRequest::new(name, &solution.mechanism).unwrap_or_else(|error| panic!("{error}"))
}

fn of(solution: &Solution) -> Bounds<'_> {
    bounds(&solution.scene, &solution.mechanism, &solution.pose, &solution.motion)
}

#[test]
fn of_known_mechanisms() {
    let (mut found, mut far) = (0, 0);
    for line in files::read("tests/centers/cases.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("a case");
        let (id, expected) = (text(&case["id"]), &case["expected"]);
        let solution = solved(&case["scene"].to_string()).unwrap_or_else(|error| panic!("{id}: {error}"));
        let bounds = of(&solution);
        let size = kinegon::geometry::span(solution.pose.points.iter().copied());
        let compare = |name: &str, values: &[f64], error: f64, truth: &[&str]| {
            for (value, truth) in values.iter().zip(truth) {
                let off = exact::minus(*value, truth).abs();
                // The f64 next to a given decimal is printed as that decimal.
                let stated = if error == 0.0 { 0.5 * f64::EPSILON * value.abs() } else { error };
                assert!(
                    off <= stated.max(1e-28 * value.abs().max(size)),
                    "{id}: {name} = {value:e}, truly {truth}: {off:e} off, stated {error:e}"
                );
                assert!(off <= RIGHT * size.max(value.abs()), "{id}: {name} is {off:e} off");
            }
        };
        for (name, truth) in expected["centers"].as_object().expect("centres") {
            let center = bounds.center(&asked(name, &solution)).unwrap_or_else(|| panic!("{id}: {name}"));
            let pin = expected["permanent"].get(name).map(|pin| &expected["points"][text(pin)]["position"]);
            let place = truth.get("at").or(pin.filter(|_| truth.is_null()));
            found += 1;
            match (center, place, truth.get("at_infinity")) {
                (Center::At { place, error }, Some(truth), _) => {
                    compare(name, place.coords.as_slice(), error, &[text(&truth[0]), text(&truth[1])]);
                }
                (Center::AtInfinity { direction, error, .. }, _, Some(truth)) => {
                    let [x, y] = [0, 1].map(|axis| text(&truth[axis]).parse::<f64>().expect("a number"));
                    let off = (direction.x * y - direction.y * x).abs();
                    assert!(off <= 1e-15 && error <= 1e-12, "{id}: {name} lies off its direction by {off:e}");
                    far += 1;
                }
                (Center::AtRest, None, None) => {}
                (center, ..) => panic!("{id}: {name} is {center:?}, not {truth}"),
            }
        }
        for (link, truth) in expected["inflection"].as_object().expect("links") {
            for (head, key) in [("W", "inflection_pole"), ("G", "acceleration_pole"), ("d_i", "diameter")] {
                let name = format!("{head}({link})");
                let (value, error) =
                    bounds.valued(&asked(&name, &solution), None).unwrap_or_else(|e| panic!("{id}: {e}"));
                match value {
                    Quantity::Number(x) => compare(&name, &[x], error, &[text(&truth[key])]),
                    Quantity::Vector(v) => {
                        compare(&name, v.as_slice(), error, &[text(&truth[key][0]), text(&truth[key][1])])
                    }
                }
            }
        }
    }
    assert_eq!((found, far), (239, 23), "centres, and those at infinity");
}

/// What a slider-crank says at 90°, where its rod only moves along: not how far away a rounded rate would put its centre.
#[test]
fn at_infinity_is_told_and_not_computed() {
    let scene = |angle: f64| {
        format!(
            r#"{{"kinegon": 1, "units": {{"length": "mm", "time": "s"}}, "ground": {{"A": [0, 0]}}, "links": {{"1": {{"points": ["A", "B"], "lengths": {{"AB": 50}}, "drive": {{"angle": {angle}, "omega": 10}}}},
            "2": {{"points": ["B", "C"], "lengths": {{"BC": 130}}}}, "3": ["C"]}}, "sliders": [{{"link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0}}],
            "near": {{"C": [120, 0]}}}}"#
        )
    };
    let center = |angle: f64, name: &str| {
        let solution = solved(&scene(angle)).expect("a slider-crank");
        of(&solution).center(&asked(name, &solution)).expect("bounds")
    };
    let Center::AtInfinity { direction, beyond, .. } = center(90.0, "P(2,ground)") else { panic!("at 90°") };
    assert_eq!((direction.x, direction.y), (0.0, 1.0));
    assert!(beyond > 1e20 && beyond.is_finite(), "{beyond}");
    let Center::AtInfinity { beyond, .. } = center(90.0, "P(3,ground)") else { panic!("the block only slides") };
    assert!(beyond.is_infinite());
    // Closed form: on the line of the crank, above C.
    for angle in [89.0f64, 89.999_999, 90.000_000_001] {
        let Center::At { place, error } = center(angle, "P(2,ground)") else { panic!("at {angle}°") };
        let (sine, cosine) = libm::sincos(angle.to_radians());
        let x = 50.0 * cosine + (130.0f64 * 130.0 - 2500.0 * sine * sine).sqrt();
        let tangent = 1.0 / libm::tan((90.0 - angle).to_radians());
        assert!((place.x - x).abs() < 1e-6 && (place.y / (x * tangent) - 1.0).abs() < 1e-4, "{place}");
        assert!(error < 1e-6 * place.y.abs(), "{error}");
    }
}

#[derive(Default)]
struct Seen {
    mechanisms: usize,
    classes: BTreeMap<String, usize>,
    numbers: usize,
    far: usize,
    unbounded: usize,
    lines: usize,
    shares: Vec<f64>,
    failures: Vec<String>,
}

#[test]
fn of_random_mechanisms() {
    let cases = on_all_cores(CENTERS.now(), see);
    let mut all = Seen::default();
    for mut seen in cases {
        all.mechanisms += seen.mechanisms;
        all.numbers += seen.numbers;
        all.far += seen.far;
        all.unbounded += seen.unbounded;
        all.lines += seen.lines;
        all.shares.append(&mut seen.shares);
        all.failures.append(&mut seen.failures);
        seen.classes.into_iter().for_each(|(class, count)| *all.classes.entry(class).or_default() += count);
    }
    all.shares.sort_by(f64::total_cmp);
    let median = all.shares[all.shares.len() / 2];
    println!(
        "{} mechanisms, groups {:?}: {} numbers, {} centres at infinity, {} without a bound, {} lines of three centres; bound / error: least {:.3}, median {median:.1}; {} failures",
        all.mechanisms,
        all.classes,
        all.numbers,
        all.far,
        all.unbounded,
        all.lines,
        all.shares[0],
        all.failures.len(),
    );
    assert!(
        all.failures.is_empty(),
        "{} failures\n{}",
        all.failures.len(),
        all.failures[..all.failures.len().min(20)].join("\n")
    );
    assert!(all.mechanisms * 10 > CENTERS.now() as usize && all.far > 0 && all.lines > 0);
    assert!(all.unbounded * 100 < all.numbers && median < WASTEFUL);
}

fn see(number: u64, seen: &mut Seen) {
    let dice = &mut Random(Random(number + 7).next());
    let grown = Grown::new(dice);
    let scene = grown.scene(dice, None);
    let Ok(solution) = solved(&scene.to_string()) else { return };
    let mechanism = &solution.mechanism;
    let points = mechanism.points.iter().zip(&solution.pose.points);
    let places: BTreeMap<String, [f64; 2]> = points.map(|(name, p)| (name.clone(), [p.x, p.y])).collect();
    let axes = mechanism.links().filter_map(|(id, body)| {
        let axis = solution.pose.axes[id.0]?;
        Some((body.name.clone(), [axis.x, axis.y]))
    });
    let Some(truth) = Truth::new(&scene, &places, &axes.collect()) else { return };
    seen.mechanisms += 1;
    for group in &mechanism.groups {
        *seen.classes.entry(group.class.numeral().to_owned()).or_default() += 1;
    }
    let case = Case { number, solution: &solution, bounds: of(&solution), truth: &truth };
    let centers: BTreeMap<LinkPair, Center> =
        LinkPair::all(mechanism).into_iter().filter_map(|pair| Some((pair, case.center(pair, seen)?))).collect();
    on_lines(number, mechanism, &centers, seen);
    mechanism.links().for_each(|(link, _)| case.poles(link, seen));
}

struct Case<'a> {
    number: u64,
    solution: &'a Solution,
    bounds: Bounds<'a>,
    truth: &'a Truth,
}

impl Case<'_> {
    /// ω, α and the motion of a link at a place; the frame rests.
    fn moved(&self, link: BodyId, at: &Pair) -> ([Real; 2], [Pair; 2]) {
        let zero = || exactly(0.0);
        match link {
            kinegon::mechanism::GROUND => ([zero(), zero()], [[zero(), zero()], [zero(), zero()]]),
            _ => {
                let name = &self.solution.mechanism.body(link).name;
                (self.truth.link(name).expect("a link").0, self.truth.point_of(name, at).expect("its motion"))
            }
        }
    }

    fn near(&self) -> Pair {
        self.truth.point(&self.solution.mechanism.points[0]).expect("a point").place
    }

    fn center(&self, pair: LinkPair, seen: &mut Seen) -> Option<Center> {
        let name = pair.name(&self.solution.mechanism);
        let Some(center) = self.bounds.center(&asked(&name, self.solution)) else {
            seen.unbounded += 1;
            return None;
        };
        let near = self.near();
        let [a, b] = pair.links().map(|link| self.moved(link, &near));
        let (omega, velocity) = (&b.0[0] - &a.0[0], minus(&b.1[0], &a.1[0]));
        let [first, second] = pair.links().map(|link| &self.solution.mechanism.body(link).points);
        match center {
            Center::At { place, error } if first.iter().any(|point| second.contains(point)) => {
                let pin = first.iter().find(|point| second.contains(point)).expect("a pin");
                let truth = self.truth.point(&self.solution.mechanism.points[pin.0]).expect("a point");
                let [a, b] = pair.links().map(|link| self.moved(link, &truth.place).1);
                let slip = minus(&b[0], &a[0]).iter().map(|x| rounded(x).abs()).fold(0.0, f64::max);
                if slip > 1e-25 {
                    seen.failures.push(format!("{}: {name} is no pin: {slip:e}", self.number));
                }
                self.number(&name, place.coords.as_slice(), error, &truth.place, seen);
            }
            Center::At { place, error } => {
                let truth = plus(&near, &[-&velocity[1] / &omega, &velocity[0] / &omega]);
                self.number(&name, place.coords.as_slice(), error, &truth, seen);
            }
            Center::AtInfinity { direction, error, beyond } => {
                seen.far += 1;
                let speed = dot(&velocity, &velocity).sqrt();
                // A guide has a direction at rest, too.
                if rounded(&speed) < 1e-25 {
                    return Some(center);
                }
                // Its distance is speed over ω, or the links turn alike.
                let off = rounded(&(&velocity[0] * exactly(direction.x) + &velocity[1] * exactly(direction.y)))
                    / rounded(&speed);
                if rounded(&omega).abs() * beyond.min(1e30) > rounded(&speed) * (1.0 + 1e-9)
                    || off.abs() > error.to_radians() * (1.0 + 1e-9) + 1e-30
                {
                    let [omega, speed] = [rounded(&omega), rounded(&speed)];
                    seen.failures
                        .push(format!("{}: {name}: {center:?}, off by {off:e}, ω {omega:e}, v {speed:e}", self.number));
                }
            }
            _ => {
                seen.far += 1;
                let rest =
                    [&velocity[0], &velocity[1], &omega].map(|x| rounded(x).abs()).into_iter().fold(0.0, f64::max);
                if rest > 1e-25 {
                    seen.failures.push(format!("{}: {name} {center:?}, but {rest:e}", self.number));
                }
            }
        }
        Some(center)
    }

    fn poles(&self, link: BodyId, seen: &mut Seen) {
        let mechanism = &self.solution.mechanism;
        let body = mechanism.body(link);
        let near = self.near();
        let ([omega, alpha], [velocity, acceleration]) = self.moved(link, &near);
        let quarter = |v: &Pair| [-v[1].clone(), v[0].clone()];
        let scaled = |v: &Pair, s: &Real| [&v[0] * s, &v[1] * s];
        let at = |place: &Pair| self.moved(link, place).1[1].clone();
        let value = |name: &str| self.bounds.valued(&asked(name, self.solution), None).ok();
        let name = |head: &str| format!("{head}({})", body.name);
        if let (Some((Quantity::Vector(w), error)), true) = (value(&name("W")), rounded(&omega) != 0.0) {
            // Another form than that of the library: from the pole of velocities.
            let pole = plus(&near, &scaled(&quarter(&velocity), &(exactly(1.0) / &omega)));
            let square = exactly(1.0) / (&omega * &omega);
            let arm = scaled(&at(&pole), &square);
            self.number(&name("W"), w.as_slice(), error, &plus(&pole, &arm), seen);
            let (Quantity::Number(diameter), error) = value(&name("d_i")).expect("with its pole") else {
                panic!("a number")
            };
            self.number(&name("d_i"), &[diameter], error, &[dot(&arm, &arm).sqrt(), exactly(0.0)], seen);
        }
        if let (Some((Quantity::Vector(g), error)), true) = (value(&name("G")), rounded(&omega) != 0.0) {
            let square = &omega * &omega;
            let sum = plus(&scaled(&acceleration, &square), &scaled(&quarter(&acceleration), &alpha));
            let pole = plus(&near, &scaled(&sum, &(exactly(1.0) / (&alpha * &alpha + &square * &square))));
            let rest = rounded(&at(&pole)[0]).abs() + rounded(&at(&pole)[1]).abs();
            assert!(rest < 1e-30 * (1.0 + rounded(&acceleration[0]).abs() + rounded(&acceleration[1]).abs()), "{rest}");
            self.number(&name("G"), g.as_slice(), error, &pole, seen);
        }
        for point in &body.points {
            let name = format!("rho({})", mechanism.points[point.0]);
            let Some((Quantity::Number(radius), error)) = value(&name) else { continue };
            let [v, a] = self.truth.point(&mechanism.points[point.0]).expect("a point").motion;
            let across = &v[0] * &a[1] - &v[1] * &a[0];
            if rounded(&across) == 0.0 {
                assert!(error.is_infinite(), "{}: {name}", self.number);
                continue;
            }
            let square = dot(&v, &v);
            let truth = &square * square.sqrt() / if across < Real::ZERO { -across } else { across };
            self.number(&name, &[radius], error, &[truth, exactly(0.0)], seen);
        }
    }

    fn number(&self, name: &str, values: &[f64], bound: f64, truth: &Pair, seen: &mut Seen) {
        for (value, truth) in values.iter().zip(truth) {
            seen.numbers += 1;
            if !bound.is_finite() {
                seen.unbounded += 1;
                continue;
            }
            let off = error(*value, truth);
            // The f64 next to a given decimal is printed as that decimal.
            let allowed = if bound == 0.0 { 0.5 * f64::EPSILON * value.abs() } else { bound };
            if off > allowed + 1e-40 {
                seen.failures.push(format!("{}: {name} = {value:e}: error {off:e}, stated {bound:e}", self.number));
            } else if off > 1e-40 && bound > 0.0 {
                seen.shares.push(bound / off);
            }
        }
    }
}

/// Of three links the three centres lie on a line (Aronhold and Kennedy), as far as their errors allow.
fn on_lines(number: u64, mechanism: &Mechanism, centers: &BTreeMap<LinkPair, Center>, seen: &mut Seen) {
    let links: Vec<BodyId> =
        std::iter::once(kinegon::mechanism::GROUND).chain(mechanism.links().map(|(id, _)| id)).collect();
    let at = |a: BodyId, b: BodyId| match centers.get(&LinkPair::new(a, b)?)? {
        Center::At { place, error } => Some((*place, *error)),
        _ => None,
    };
    let is_pinned =
        |(a, b): (BodyId, BodyId)| mechanism.body(a).points.iter().any(|&point| mechanism.body(b).has(point));
    for (i, &a) in links.iter().enumerate() {
        for (j, &b) in links.iter().enumerate().skip(i + 1) {
            for &c in &links[j + 1..] {
                let (Some(p), Some(q), Some(r)) = (at(a, b), at(b, c), at(a, c)) else { continue };
                // Three links that are pinned to each other are one body: none of them turns against another.
                if [(a, b), (b, c), (a, c)].into_iter().all(is_pinned) {
                    continue;
                }
                seen.lines += 1;
                let (u, v) = (q.0 - p.0, r.0 - p.0);
                let rounding = f64::EPSILON * [p, q, r].iter().map(|c| c.0.coords.amax()).fold(0.0, f64::max);
                let off = p.1 + q.1 + r.1 + rounding;
                let area = (u.x * v.y - u.y * v.x).abs();
                if area > 4.0 * off * (u.amax() + v.amax()) + 4.0 * f64::EPSILON * u.amax() * v.amax() {
                    seen.failures.push(format!(
                        "{number}: centres of {a:?} {b:?} {c:?} are off a line: {area:e}: {p:?} {q:?} {r:?}"
                    ));
                }
            }
        }
    }
}

/// The centrodes of the link 2 of a scene, and the scene's own places of A, B and D.
fn centrode(links: &str, near: [f64; 2]) -> (kinegon::cycle::Centrode, Solution) {
    let scene = format!(
        r#"{{"kinegon": 1, "units": {{"length": "mm", "time": "s"}}, {links}, "near": {{"C": {near:?}}}, "figure": {{"centrodes": ["2"]}}}}"#
    );
    let solution = solved(&scene).unwrap_or_else(|error| panic!("{error}"));
    let mut traces = kinegon::cycle::Traces::of(&solution);
    (traces.centrodes.remove(0), solution)
}

/// In Cardan's motion a circle of half the size rolls in a circle; a crossed parallelogram rolls ellipses on one another, or hyperbolas that run through infinity.
#[test]
fn centrodes_are_known_curves() {
    let (cardan, solution) = centrode(
        r#""ground": {"A": [0, 0]}, "links": {"1": {"points": ["A", "B"], "lengths": {"AB": 50}, "drive": {"angle": 40, "omega": 10}},
        "2": {"points": ["B", "C", "T"], "lengths": {"BC": 50, "BT": 50, "CT": 100}}, "3": ["C"]},
        "sliders": [{"link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0}]"#,
        [80.0, 0.0],
    );
    let crank = solution.pose.points[1];
    let all = |pieces: &[Vec<(f64, kinegon::geometry::Point)>]| pieces.concat();
    assert!(all(&cardan.fixed).iter().all(|(_, p)| (p.coords.norm() - 100.0).abs() < 1e-9), "no circle about A");
    assert!(all(&cardan.moving).iter().all(|(_, p)| ((p - crank).norm() - 50.0).abs() < 1e-9), "no circle about B");
    assert!(all(&cardan.fixed).len() > 100 && all(&cardan.moving).len() > 100);
    let own = cardan.own.expect("near the mechanism");
    let turn = libm::sincos(40f64.to_radians());
    assert!((own.x - 100.0 * turn.1).abs() < 1e-9 && (own.y - 100.0 * turn.0).abs() < 1e-9, "{own}");
    for (crank, frame, sign) in [(100.0, 60.0, 1.0), (60.0, 100.0, -1.0)] {
        let links = format!(
            r#""ground": {{"A": [0, 0], "D": [{frame}, 0]}}, "links": {{"1": {{"points": ["A", "B"], "lengths": {{"AB": {crank}}}, "drive": {{"angle": 70, "omega": 1}}}},
            "2": {{"points": ["B", "C"], "lengths": {{"BC": {frame}}}}}, "3": {{"points": ["D", "C"], "lengths": {{"CD": {crank}}}}}}}"#
        );
        let (rolled, solution) = centrode(&links, [frame + 20.0, -crank]);
        let [a, d] = ["A", "D"].map(|name| solution.pose.point(solution.mechanism.point(name).expect("a joint")));
        let mut seen = 0;
        for (value, p) in all(&rolled.fixed) {
            // Where both branches cross the rates are not certain.
            if libm::remainder(value, 180.0).abs() < 2.0 {
                continue;
            }
            seen += 1;
            let [near, far] = [(p - a).norm(), (p - d).norm()];
            assert!(
                ((near + sign * far).abs() - crank).abs() < 1e-7 * crank,
                "at {value}: {near} and {far} from the foci"
            );
        }
        assert!(seen > 50, "{seen} places");
        // Beyond the reach of the drawing, but not across it.
        let longest = rolled
            .fixed
            .iter()
            .flat_map(|piece| piece.windows(2))
            .map(|w| (w[1].1 - w[0].1).norm())
            .fold(0.0, f64::max);
        assert!(longest < 40.0, "a chord of {longest}");
    }
}
