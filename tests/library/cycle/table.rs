//! Paths read at equal steps.

use super::changes::parallelogram;
use super::{followed, path, posed, scenes};
use kinegon::cycle::{CycleError, Path, Steps, Sweep};
use kinegon::format;
use kinegon::quantity::{QuantityError, State};
use kinegon::scene::Scene;

const FIGURE_2: &str = include_str!("../../../examples/figure-2.json");

fn values(steps: &Steps) -> Vec<f64> {
    (0..steps.count()).map(|k| steps.value(k)).collect()
}

fn steps(from: f64, to: f64, step: f64) -> Steps {
    Steps::new(from, to, step).expect("a good range")
}

#[test]
fn steps_are_decimals() {
    assert_eq!(values(&steps(0.0, 0.3, 0.1)), [0.0, 0.1, 0.2, 0.3]);
    assert_eq!(values(&steps(0.7, 0.1, 0.2)), [0.7, 0.5, 0.3, 0.1]);
    assert_eq!(values(&steps(0.7, 0.1, -0.2)), [0.7, 0.5, 0.3, 0.1]);
    assert_eq!(values(&steps(-1.5, 2.0, 1.5)), [-1.5, 0.0, 1.5]);
    // Every tenth of a degree is the number that one would write.
    let tenths = steps(-180.0, 180.0, 0.1);
    assert_eq!(tenths.count(), 3601);
    for (k, value) in values(&tenths).into_iter().enumerate() {
        let tenth = k as i64 - 1800;
        let text = format!("{}{}.{}", if tenth < 0 { "-" } else { "" }, tenth.abs() / 10, tenth.abs() % 10);
        assert_eq!(value, text.parse::<f64>().expect("a number"));
    }
    // What is no short decimal is added up.
    let thirds = values(&steps(0.0, 1.0, 1.0 / 3.0));
    assert_eq!(thirds, [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]);
    let odd = steps(0.1 + 0.2, 7.0, core::f64::consts::LN_2);
    assert_eq!((odd.count(), odd.value(0)), (10, 0.1 + 0.2));
}

#[test]
fn steps_at_the_edges() {
    assert_eq!(values(&steps(70.0, 70.0, 1.0)), [70.0]);
    assert_eq!(values(&steps(70.0, 71.0, 5.0)), [70.0]);
    assert_eq!(values(&steps(70.0, 69.0, 5.0)), [70.0]);
    let many = steps(0.0, 360.0, 1e-9);
    assert_eq!(many.count(), 360_000_000_001);
    assert_eq!(many.value(360_000_000_000), 360.0);
    let inf = f64::INFINITY;
    for [from, to, step] in [
        [f64::NAN, 1.0, 1.0],
        [0.0, inf, 1.0],
        [-inf, inf, 1.0],
        [0.0, 1.0, 0.0],
        [0.0, 1.0, -0.0],
        [0.0, 1.0, f64::NAN],
        [0.0, 1.0, inf],
        [0.0, 1.0, -0.5],
        [0.0, 1.0, 1e-13],
        [0.0, 1.0, 5e-324],
        [-1e308, 1e308, 1.0],
    ] {
        let refused = Steps::new(from, to, step);
        assert!(matches!(refused, Err(CycleError::Range(_))), "{from} {to} {step}: {refused:?}");
    }
}

#[test]
fn multiples_lie_within() {
    let multiples = |low, high, step| Steps::multiples(low, high, step).expect("a good range");
    let tenths = multiples(-137.582_082, 137.582_082, 0.1);
    assert_eq!((tenths.count(), tenths.value(0), tenths.value(2750)), (2751, -137.5, 137.5));
    assert_eq!(values(&multiples(-0.05, 0.05, 0.1)), [0.0]);
    assert_eq!(values(&multiples(0.3, 0.6, 0.1)), [0.3, 0.4, 0.5, 0.6]);
    assert_eq!(multiples(0.31, 0.39, 0.1).count(), 0);
    assert!(Steps::multiples(0.0, 1.0, -1.0).is_err());
}

/// The sweep over a range, which the path has been asked to reach.
fn sweep<'a>(path: &'a Path<'a>, steps: Steps, names: &[&str]) -> Sweep<'a> {
    let names: Vec<String> = names.iter().map(|n| (*n).to_owned()).collect();
    Sweep::new(path, steps, Some(&names)).expect("known quantities")
}

/// Numbers of the paper's mechanism at 70°, where the scene stands, and at the last row.
#[test]
fn the_last_row_is_there() {
    let (mechanism, pose) = posed(FIGURE_2);
    let mut path = path(&mechanism, &pose);
    path.cover(Some(69.7), Some(70.0)).expect("it can be followed");
    let names = ["L(B,S3)", "vplan(b,s3)", "position(3/2)", "v_r(3/2)", "a(D).size"];
    let sweep = sweep(&path, steps(69.7, 70.0, 0.1), &names);
    let numbers = sweep.rows(0..sweep.steps.count());
    assert_eq!(numbers.len(), 4 * 6);
    assert!(numbers.iter().all(Option::is_some));
    // `FACTS` of the paper, to 12 digits.
    let expected = [70.0, 370.964_757_433_2, 59.407_646_430_3, 307.739_262_481_6, 62.600_851_289_6];
    for (got, expected) in numbers[18..].iter().flatten().zip(expected) {
        assert!((got - expected).abs() < 1e-9, "{numbers:?}");
    }
}

/// Cells without a number are empty, in both forms; names with commas are quoted; each name comes once.
#[test]
fn blanks_are_no_numbers() {
    let (mechanism, pose) = posed(&parallelogram());
    let mut path = path(&mechanism, &pose);
    path.cover(Some(178.0), Some(182.0)).expect("it can be followed");
    let names = ["omega(3)", "angle(1)", "v(C)", "L(A,C)", "omega(3)"];
    let sweep = sweep(&path, steps(178.0, 182.0, 1.0), &names);
    let numbers = sweep.rows(0..5);
    let columns = format::columns_of(&sweep);
    let csv = format::csv_header(&columns) + &format::csv_rows(&columns, &numbers);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "angle(1),omega(3),v(C).x,v(C).y,\"L(A,C)\"");
    assert_eq!(lines[3], "180.0,,,,");
    assert!(!csv.contains("NaN") && !csv.contains("inf"));
    assert_eq!(csv.matches(",,").count(), 2);
    let json = format::json_lines(&sweep, &numbers);
    let rows: Vec<serde_json::Value> = json.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    let blank = serde_json::json!({ "angle(1)": 180.0, "omega(3)": null, "v(C)": [null, null], "L(A,C)": null });
    assert_eq!(rows[2], blank);
    assert_eq!(rows[0].as_object().expect("an object").len(), 4);
    assert!((rows[0]["omega(3)"].as_f64().expect("a number") - 1.0).abs() < 1e-11);
}

/// Rows are what a walker says, whether they are read together, in pieces or on all cores; outside of the path there are none.
#[test]
fn rows_are_positions() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        let [low, high] = [path.low(), path.high()];
        let wide = high - low;
        let all = steps(low - 0.1 * wide, high + 0.1 * wide, wide / 1000.0);
        let table = Sweep::new(&path, all, None).expect("all quantities");
        let count = table.steps.count();
        assert!((999..=1001).contains(&count), "{name} {count}");
        let width = table.header().len();
        let numbers = table.rows(0..count);
        assert_eq!(numbers.len(), count * width);
        assert_eq!(table.rows_on_all_cores(0..count), numbers);
        let pieces: Vec<_> = (0..count).step_by(704).flat_map(|k| table.rows(k..(k + 704).min(count))).collect();
        assert_eq!(pieces, numbers);
        let mut walker = path.walker();
        for row in numbers.chunks(width).step_by(7) {
            let value = row[0].expect("the drive's value");
            let position = walker.position(value).expect("within the path");
            for (header, number) in table.header().iter().zip(row).skip(1) {
                let number = number.expect("it is regular");
                let link = |head: &str| {
                    let name = header.strip_prefix(head)?.strip_suffix(')')?;
                    mechanism.link(name)
                };
                let expected = match (link("omega("), link("alpha(")) {
                    (Some(link), _) => position.angular_rates(link)[0],
                    (_, Some(link)) => position.angular_rates(link)[1],
                    _ => continue,
                };
                // Rows that are read together are rounded otherwise. At a part d of the range from a limit rates go like 1/√d, and
                // places, known to u / √d there, are the square root of d: of a rate u / d is left open. The path ends at d = 1e-11.
                let away = (value - low).min(high - value) / wide;
                let scale = (1.0 + expected.abs()) * (1.0 + 1e-7 / away.max(1e-11));
                assert!((number - expected).abs() < 1e-9 * scale, "{name} {value} {header}: {number} {expected}");
            }
        }
    }
}

/// With errors every quantity is followed by a bound that holds, next to a change point too; not so small as to be chance.
#[test]
fn errors_are_bounded() {
    let text = parallelogram();
    let (mechanism, pose) = posed(&text);
    let scene = Scene::read(&text).expect("a good scene");
    let mut path = path(&mechanism, &pose);
    path.cover(Some(-5.0), Some(175.0)).expect("it can be followed");
    let names = ["angle(3)", "omega(3)", "alpha(3)", "v(C)", "x(C)", "a(C).size", "vplan(b,c)"];
    let table = sweep(&path, steps(0.05, 170.0, 0.05), &names).with_errors(&scene);
    let header = "angle(1),angle(3),angle(3)_error,omega(3),omega(3)_error,alpha(3),alpha(3)_error,v(C).x,v(C).y,v(C)_error,\
                  x(C),x(C)_error,a(C).size,a(C).size_error,\"vplan(b,c)\",\"vplan(b,c)_error\"\n";
    assert_eq!(format::csv_header(&format::columns_of(&table)), header);
    let numbers = table.rows(0..table.steps.count());
    let mut shares: Vec<f64> = Vec::new();
    for row in numbers.chunks(table.header().len()) {
        let number = |k: usize| row[k].expect("a number");
        let value = number(0);
        let (sine, cosine) = libm::sincos(value.to_radians());
        // Crank and rocker 30 long turn with 1 rad/s, 80 apart.
        let pairs = [
            (number(1) - value, 2),
            (number(3) - 1.0, 4),
            (number(5), 6),
            (number(7) + 30.0 * sine, 9),
            (number(8) - 30.0 * cosine, 9),
            (number(10) - 80.0 - 30.0 * cosine, 11),
            (number(12) - 30.0, 13),
            // The coupler does not turn.
            (number(14), 15),
        ];
        for (off, bound) in pairs {
            // The truth itself is rounded.
            assert!(off.abs() <= number(bound) + 64.0 * f64::EPSILON, "{value}: {off:e} {:e}", number(bound));
        }
        shares.push(number(6) * sine * sine * sine / f64::EPSILON);
    }
    shares.sort_by(f64::total_cmp);
    // The bound of α₃ is that of its own error, which the distance from the change point does not tell.
    assert!(shares[shares.len() / 2] < 1e3, "{:e}", shares[shares.len() / 2]);
    let json = format::json_lines(&table, &numbers);
    let first: serde_json::Value = json.lines().next().and_then(|l| serde_json::from_str(l).ok()).expect("JSON");
    assert!(first["v(C)"].is_array() && first["v(C)_error"].is_number(), "{first}");
    assert_eq!(first.as_object().expect("an object").len(), 1 + 2 * 7);
}

/// What lies beyond a limit may be reached the other way round.
#[test]
fn the_other_way_round() {
    // The crank stops where the pins of coupler and rocker are 40 apart: cos θ = (50² + 40² − 40²) / (2 · 50 · 40).
    let bar = super::four_bars::FourBar { crank: 40.0, coupler: 70.0, rocker: 30.0, ground: 50.0 };
    let limit = libm::acos(0.625).to_degrees();
    let (place, _) = bar.joint(100.0, 1.0).expect("it can be assembled");
    let (mechanism, pose) = posed(&bar.scene(100.0, place));
    let detour = |from: f64, to: f64| {
        let mut path = path(&mechanism, &pose);
        path.cover(Some(from), Some(to)).expect("it can be followed");
        path.other_way_round([from, to])
    };
    for (range, part, asked) in [
        ([-180.0, 180.0], [180.0, 360.0 - limit], [-180.0, -limit]),
        ([-90.0, 120.0], [270.0, 360.0 - limit], [-90.0, -limit]),
        ([180.0, 400.0 + limit], [limit, 40.0 + limit], [360.0 + limit, 400.0 + limit]),
    ] {
        let found = detour(range[0], range[1]).expect("it can be reached");
        for k in 0..2 {
            assert!((found.part[k] - part[k]).abs() < 1e-6, "{range:?} {found:?}");
            assert!((found.asked[k] - asked[k]).abs() < 1e-6, "{range:?} {found:?}");
        }
    }
    assert_eq!(detour(0.0, 300.0), None);
    assert_eq!(detour(60.0, 400.0), None);
}

#[test]
fn unknown_quantities_are_refused() {
    let (mechanism, pose) = posed(FIGURE_2);
    let path = followed(&mechanism, &pose);
    let refused = |name: &str| {
        let names = [name.to_owned()];
        Sweep::new(&path, steps(0.0, 10.0, 1.0), Some(&names)).expect_err("it cannot be known")
    };
    assert!(matches!(refused("speed(4)"), QuantityError::Form(_)));
    assert!(matches!(refused("omega(6)"), QuantityError::Unknown { .. }));
    assert!(matches!(refused("vplan(b,s9)"), QuantityError::Unknown { .. }));
    assert!(matches!(refused("vplan(b,s3)/mu"), QuantityError::NoValue(..)));
}

/// A range is asked for in any turn; what is not on the branch is refused, and what lies on it in part is kept in part.
#[test]
fn ranges() {
    let (mechanism, pose) = posed(FIGURE_2);
    let cover = |from: f64, to: f64| {
        let mut path = path(&mechanism, &pose);
        let covered = path.cover(Some(from), Some(to));
        (covered, [path.low(), path.high()])
    };
    let limit = 137.582_082_139_174;
    let (covered, reached) = cover(100.0, -170.0);
    assert_eq!(covered, Ok([100.0, -170.0]));
    assert!((reached[0] + limit).abs() < 1e-7 && reached[1] >= 100.0);
    // −60° to 60°, a turn on.
    let (covered, reached) = cover(300.0, 420.0);
    assert_eq!(covered, Ok([300.0, 420.0]));
    assert!(reached[0] <= 300.0 && reached[1] >= 420.0 && reached[1] < 360.0 + limit);
    let (covered, reached) = cover(-900.0, -760.0);
    assert_eq!(covered, Ok([-900.0, -760.0]));
    assert!((reached[0] + 720.0 + limit).abs() < 1e-7 && reached[1] >= -760.0);
    for [from, to] in [[138.0, 222.0], [221.0, 138.0], [-222.0, -138.0], [498.0, 582.0]] {
        let (covered, _) = cover(from, to);
        assert!(matches!(covered, Err(CycleError::OutOfReach { .. })), "{from} {covered:?}");
    }
    for [from, to] in [[0.0, 1e9], [f64::NAN, 0.0], [0.0, f64::NEG_INFINITY], [-36_000.0, 0.0]] {
        let (covered, _) = cover(from, to);
        assert!(matches!(covered, Err(CycleError::Range(_))), "{from} {covered:?}");
    }
}
