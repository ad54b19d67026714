//! Relations between angles that are no part of a slider, through all stages: wheels that mesh, against closed forms and
//! differences.

use kinegon::Order;
use kinegon::Solution;
use kinegon::accuracy::bounds;
use kinegon::cycle::{Drive, Path};
use kinegon::geometry::{Point, Vector, turn_of_degrees};
use kinegon::mechanism::{AngularConstraint, GROUND, Joint, Mechanism, mechanism_with};
use kinegon::position::{pose, poses};
use kinegon::scene::Scene;

/// Two cranks about A and E, the first driven at `angle`, with a dyad between their ends.
fn five_bar(angle: f64) -> Scene {
    let text = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [10, 20], "E": [90, 20] }},
        "links": {{
            "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 25 }}, "drive": {{ "angle": {angle}, "omega": 2, "alpha": -3 }} }},
            "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 80 }} }},
            "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 70 }} }},
            "4": {{ "points": ["E", "D"], "lengths": {{ "DE": 20 }} }} }},
        "near": {{ "C": [50, 90] }} }}"#
    );
    Scene::read(&text).expect("a good scene")
}

/// Gears between links by name (and the ground): their angles times these weights add up to `constant` degrees.
fn geared(scene: &Scene, weights: &[(&str, i32)], constant: f64) -> Mechanism {
    let add = |mechanism: &mut Mechanism| {
        let terms = weights.iter().map(|&(name, weight)| (mechanism.link(name).unwrap_or(GROUND), weight)).collect();
        let angular = AngularConstraint::phased(terms, 1, constant);
        let bodies = [angular.terms[0].0, angular.terms[1].0];
        mechanism.joints.push(Joint {
            letter: 'G',
            bodies,
            pin: None,
            slider: None,
            angular: Some(angular),
            pitch: None,
            rack: None,
            belt: None,
            marks: Default::default(),
        });
    };
    mechanism_with(scene, &[], add).expect("a mechanism")
}

/// Where C of the five-bar is with its cranks at these angles in degrees: above the line from B to D.
fn apex(first: f64, second: f64) -> Point {
    let b = Point::new(10.0, 20.0) + turn_of_degrees(first) * Vector::new(25.0, 0.0);
    let d = Point::new(90.0, 20.0) + turn_of_degrees(second) * Vector::new(20.0, 0.0);
    let base = (d - b).norm();
    let along = (base * base + 80.0 * 80.0 - 70.0 * 70.0) / (2.0 * base);
    let across = (80.0 * 80.0 - along * along).sqrt();
    let u = (d - b) / base;
    b + u * along + Vector::new(-u.y, u.x) * across
}

/// The first two derivatives of a function of time by differences of the fourth order.
fn derivatives(f: impl Fn(f64) -> Vector) -> [Vector; 2] {
    const H: f64 = 1e-3;
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| f(k * H));
    [((d - b) * 8.0 - (e - a)) / (12.0 * H), ((d + b) * 16.0 - (e + a) - c * 30.0) / (12.0 * H * H)]
}

fn solved(scene: &Scene, mechanism: Mechanism) -> Solution {
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    Solution::new(scene.clone(), mechanism, pose, Order::Acceleration).expect("it is not singular")
}

fn number(solution: &Solution, name: &str) -> f64 {
    match solution.quantity(name).expect("a quantity") {
        kinegon::quantity::Quantity::Number(number) => number,
        other => panic!("{name} is {other:?}"),
    }
}

#[test]
fn a_geared_five_bar_is_where_its_lengths_and_wheels_put_it() {
    for angle in [-200.0, -35.0, 0.0, 70.0, 140.0] {
        let scene = five_bar(angle);
        // Wheels of 20 teeth on link 1 and 10 on link 4: it turns twice as fast the other way, from 30 degrees.
        let s = solved(&scene, geared(&scene, &[("4", 1), ("1", 2), ("ground", -3)], 30.0));
        let second = |first: f64| 30.0 - 2.0 * first;
        let time = |t: f64| angle + (2.0 * t - 1.5 * t * t).to_degrees();
        let at = |t: f64| apex(time(t), second(time(t)));
        let c = s.mechanism.point("C").expect("C");
        assert!((s.pose.point(c) - at(0.0)).norm() < 1e-12, "at {angle}");
        let [velocity, acceleration] = derivatives(|t| at(t).coords);
        let link = s.mechanism.link("3").expect("3");
        let motion = s.motion.body(link);
        assert!((motion.velocity_at(s.pose.point(c)) - velocity).norm() < 1e-8 * velocity.norm(), "at {angle}");
        assert!((motion.acceleration_at(s.pose.point(c)) - acceleration).norm() < 1e-6 * acceleration.norm());
        assert!((number(&s, "omega(4)") + 4.0).abs() < 1e-15 && (number(&s, "alpha(4)") - 6.0).abs() < 1e-15);
        // The wheel's group, then the dyad; both plans and rates come out of the construction too.
        let links: Vec<String> = s.mechanism.groups.iter().map(|g| g.link_names(&s.mechanism)).collect();
        assert_eq!(links, ["4", "2, 3"]);
        let bounds = bounds(&s.scene, &s.mechanism, &s.pose, &s.motion);
        let [omega, alpha] = bounds.angular_rates(s.mechanism.link("2").expect("2"));
        assert!(omega > 0.0 && omega < 1e-12 && alpha > omega && alpha < 1e-11, "{omega} {alpha}");
        for agreement in &s.construction.agreement {
            let agreement = agreement.expect("there is a construction");
            assert!(agreement.difference <= agreement.allowed && agreement.allowed < 1e-12, "{agreement:?}");
        }
        let drawn = s.construction.plans[kinegon::Order::Acceleration].points["c"].vector;
        assert!((drawn - acceleration).norm() < 1e-6 * acceleration.norm());
    }
}

#[test]
fn a_geared_five_bar_goes_round() {
    let scene = five_bar(70.0);
    let mechanism = geared(&scene, &[("4", 1), ("1", 2), ("ground", -3)], 30.0);
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a drive")).expect("not singular");
    path.cover(None, None).expect("it goes round");
    let mut walker = path.walker();
    let c = mechanism.point("C").expect("C");
    // In no order.
    for step in 0..360 {
        let angle = 70.0 + f64::from(step * 7 % 360);
        let place = walker.position(angle).expect("it is there").pose().point(c);
        assert!((place - apex(angle, 30.0 - 2.0 * angle)).norm() < 1e-11, "at {angle}: {place}");
    }
}

/// A wheel of twice as many teeth could mesh in two ways, as half a turn of it is a turn of the other: the constant's whole turns say which.
#[test]
fn a_slower_wheel_stands_where_the_constant_puts_it() {
    let scene = five_bar(70.0);
    for (constant, expected) in [(0.0, 325.0), (360.0, 145.0), (-360.0, 145.0), (720.0, 325.0)] {
        let mechanism = geared(&scene, &[("4", 2), ("1", 1), ("ground", -3)], constant);
        let link = mechanism.link("4").expect("4");
        let mut angles: Vec<f64> = Vec::new();
        for pose in poses(&mechanism, &scene.near).expect("it can be assembled") {
            let axis = pose.axes[link.0].expect("an axis");
            angles.push(kinegon::geometry::degrees_of(axis).rem_euclid(360.0));
        }
        // Two ways to put the dyad together.
        assert_eq!(angles.len(), 2);
        assert!(angles.iter().all(|found| (found - expected).abs() < 1e-12), "{angles:?}");
    }
}

/// Given the angle of the coupler in place of the drive's, both wheels are looked for at once.
#[test]
fn wheels_within_one_group_are_found_together() {
    let driven = five_bar(70.0);
    let weights = [("4", 1), ("1", 2), ("ground", -3)];
    let coupler = number(&solved(&driven, geared(&driven, &weights, 30.0)), "angle(2)");
    let mut scene = driven.clone();
    scene.links["1"].drive.as_mut().expect("a drive").angle_deg = None;
    scene.links["2"].angle_deg = Some(coupler);
    let near = [("B", [18.0, 43.0]), ("C", [50.0, 90.0])];
    scene.near.points = near.into_iter().map(|(name, place)| (name.to_owned(), place)).collect();
    let mechanism = geared(&scene, &weights, 30.0);
    assert_eq!(mechanism.for_positions().groups.len(), 1);
    let found = number(&solved(&scene, mechanism), "angle(1)");
    assert!((found - 70.0).abs() < 1e-9, "{found}");
}

/// The wheel on a driven arm that rolls about a fixed one, and a point of its rim.
#[test]
fn a_planet_turns_with_the_arm_and_about_the_sun() {
    let scene = Scene::read(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "P"], "lengths": { "AP": 60 }, "drive": { "angle": 25, "omega": 1.5, "alpha": 4 } },
            "2": { "points": ["P", "Q"], "lengths": { "PQ": 20 } } } }"#,
    );
    let scene = scene.expect("a good scene");
    // 40 teeth on the ground, 20 on the wheel.
    let s = solved(&scene, geared(&scene, &[("2", 1), ("ground", 2), ("1", -3)], -10.0));
    let at = |t: f64| {
        let arm = 25.0 + (1.5 * t + 2.0 * t * t).to_degrees();
        let wheel = 3.0 * arm - 10.0;
        turn_of_degrees(arm) * Vector::new(60.0, 0.0) + turn_of_degrees(wheel) * Vector::new(20.0, 0.0)
    };
    let (q, wheel) = (s.mechanism.point("Q").expect("Q"), s.mechanism.link("2").expect("2"));
    let place = s.pose.point(q);
    let [velocity, acceleration] = derivatives(at);
    assert!((place.coords - at(0.0)).norm() < 1e-13);
    assert!((s.motion.body(wheel).velocity_at(place) - velocity).norm() < 1e-9 * velocity.norm());
    assert!((s.motion.body(wheel).acceleration_at(place) - acceleration).norm() < 1e-7 * acceleration.norm());
    assert_eq!([number(&s, "omega(2)"), number(&s, "alpha(2)")], [4.5, 12.0]);
}
