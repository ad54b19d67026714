//! Directions of plan points: a four-bar's plans by closed forms, which share nothing with the construction, with vectors laid off the wrong
//! way. Lengths alone do not show some of them.

use kinegon::check::{AnswerKey, Checked, Measured, Mistake, PointsOf, Verdict, check, report, report_parts};
use kinegon::{Order, Solution};
use support::files;
use support::stages::{answer_key, solved};

type Pair = [f64; 2];

fn sum(a: Pair, b: Pair) -> Pair {
    [a[0] + b[0], a[1] + b[1]]
}

fn less(a: Pair, b: Pair) -> Pair {
    [a[0] - b[0], a[1] - b[1]]
}

fn times(k: f64, a: Pair) -> Pair {
    [k * a[0], k * a[1]]
}

fn across([x, y]: Pair) -> Pair {
    [-y, x]
}

fn cross(a: Pair, b: Pair) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn size([x, y]: Pair) -> f64 {
    libm::hypot(x, y)
}

/// Where the line through `p` along `u` meets that through `q` along `v`.
fn meeting(p: Pair, u: Pair, q: Pair, v: Pair) -> Pair {
    sum(p, times(cross(less(q, p), v) / cross(u, v), u))
}

/// How somebody draws the plans.
#[derive(Clone, Copy, Default)]
struct Drawn {
    /// The velocity of B laid off the wrong way.
    is_turned_round: bool,
    /// The normal part of C against B outward.
    is_outward: bool,
    /// Both sheets turned, in degrees.
    turned: f64,
    is_mirrored: bool,
    is_upright: bool,
}

/// The places of the plan points of the template `four-bar` at its scales, as somebody draws them.
fn drawn(solution: &Solution, how: Drawn) -> Measured {
    let (ab, ad, bc, cd, omega) = (60.0, 160.0, 140.0, 110.0, 10.0);
    let b = [ab * 0.5, ab * 0.75_f64.sqrt()];
    let d = [ad, 0.0];
    // C is where circles about B and D meet, the one above.
    let bd = less(d, b);
    let along = (bc * bc - cd * cd + size(bd) * size(bd)) / (2.0 * size(bd));
    let height = (bc * bc - along * along).sqrt();
    let unit = times(1.0 / size(bd), bd);
    let c = sum(b, sum(times(along, unit), times(height, across(unit))));
    let (cb, dc) = (less(c, b), less(c, d));
    let v_b = times(if how.is_turned_round { -omega } else { omega }, across(b));
    let v_c = meeting(v_b, across(cb), [0.0; 2], across(dc));
    let [omega_2, omega_3] = [size(less(v_c, v_b)) / bc, size(v_c) / cd];
    let a_b = times(-omega * omega, b);
    let inward = if how.is_outward { 1.0 } else { -1.0 };
    let [end_b, end_d] = [sum(a_b, times(inward * omega_2 * omega_2, cb)), times(-omega_3 * omega_3, dc)];
    let a_c = meeting(end_b, across(cb), end_d, across(dc));
    let plans = [
        (Order::Velocity, vec![("p", [0.0; 2]), ("b", v_b), ("c", v_c)]),
        (Order::Acceleration, vec![("π", [0.0; 2]), ("b", a_b), ("n_bC", end_b), ("n_dC", end_d), ("c", a_c)]),
    ];
    let mut measured = Measured { mu: solution.scales(), upright: how.is_upright, ..Measured::default() };
    let (sine, cosine) = (libm::sin(how.turned.to_radians()), libm::cos(how.turned.to_radians()));
    for (order, points) in plans {
        let mu = measured.mu[order.sheet()].expect("the figure has its scale");
        let mut places = PointsOf::new(order);
        for (name, at) in points {
            let [x, y] = times(1.0 / mu, at);
            let y = if how.is_mirrored { -y } else { y };
            places.put(name, [31.0 + cosine * x - sine * y, 17.0 + sine * x + cosine * y], None);
        }
        measured.points.push(places);
    }
    measured
}

fn checked<T>(how: Drawn, tell: impl FnOnce(&Checked, &AnswerKey<'_>) -> T) -> T {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    tell(&check(&drawn(&solution, how), &key).expect("places that are understood"), &key)
}

fn mistakes(checked: &Checked) -> Vec<Mistake> {
    checked.diagnosis.best.findings.iter().map(|finding| finding.candidate.mistake()).collect()
}

#[test]
fn right_plans_have_right_directions_however_their_sheet_lies() {
    for turned in [0.0, 1.0, -90.0, 137.0] {
        checked(Drawn { turned, ..Drawn::default() }, |found, key| {
            // Rates are asked for, too, and no place tells them.
            assert!(found.is_nothing_off(), "{turned}: {}", report(found, key));
            assert_eq!(found.missing, ["omega(2)", "omega(3)", "alpha(2)", "alpha(3)"]);
            let directions = found.values.iter().filter(|value| value.entry.asked.name().ends_with(".angle"));
            assert_eq!(directions.count(), 10);
            let told: Vec<f64> = found.turned.iter().map(|plan| plan.degrees).collect();
            let asked = if turned == 1.0 || turned == 0.0 { vec![] } else { vec![turned, turned] };
            assert_eq!(told.len(), asked.len(), "{told:?}");
            assert!(told.iter().zip(asked).all(|(a, b)| (a - b).abs() < 1e-6), "{told:?}");
        });
    }
}

#[test]
fn a_vector_of_the_right_length_that_points_the_wrong_way_is_off() {
    // All lengths of the velocity plan are right.
    let upright = Drawn { is_turned_round: true, is_upright: true, ..Drawn::default() };
    checked(upright, |found, key| {
        let off = found.values.iter().filter(|value| value.verdict == Verdict::Off);
        let off: Vec<&str> = off.map(|value| value.entry.asked.name()).collect();
        assert_eq!(off, ["vplan(p,b).angle", "vplan(p,c).angle", "vplan(b,c).angle"]);
        assert_eq!(mistakes(found), [Mistake::WrongSense]);
        assert!(report(found, key).contains("OFF: turned by 180°"));
    });
    // Of a sheet that may lie turned it cannot be known, and is told.
    checked(Drawn { is_upright: false, ..upright }, |found, key| {
        assert!(found.is_nothing_off());
        let told = report(found, key);
        assert!(told.contains("velocity plan lies turned") && told.contains("by 180°"), "{told}");
    });
}

#[test]
fn the_cause_of_a_wrong_direction_is_told_and_teaches() {
    for turned in [0.0, 40.0] {
        checked(Drawn { is_outward: true, turned, ..Drawn::default() }, |found, key| {
            assert_eq!(mistakes(found), [Mistake::NormalOutward], "{}", report(found, key));
            let [cause] = report_parts(found, key).causes.try_into().expect("one cause");
            // The form has no ω_2, and that of the key is not told.
            assert!(cause.worked.is_empty(), "{:?}", cause.worked);
            let redo = cause.redo.expect("steps");
            // The ray through n_dC and all velocities stay.
            assert!(redo.contains("11–12, 15–18"), "{redo}");
            assert_eq!(cause.step, 11);
        });
    }
}

#[test]
fn a_mirrored_plan_is_told_once() {
    checked(Drawn { is_mirrored: true, ..Drawn::default() }, |found, _| {
        assert_eq!(found.mirrored.len(), 2);
        assert!(found.values.iter().all(|value| !value.entry.asked.name().ends_with(".angle")));
        assert!(!found.is_passed());
    });
}

#[test]
fn a_form_says_whether_its_sheets_lie_upright() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a sound scene");
    for is_upright in [false, true] {
        let measured = drawn(&solution, Drawn { is_upright, ..Drawn::default() });
        let [json, csv] = [measured.json(&solution), measured.csv(&solution)];
        assert_eq!(Measured::read_json(&json).expect("a form").upright, is_upright, "{json}");
        assert_eq!(Measured::read_csv(&csv).expect("a table").upright, is_upright, "{csv}");
    }
    let unclear = Measured::read_csv("quantity,value\nupright,perhaps\n").expect("a table");
    assert_eq!(unclear.faults.len(), 1);
}
