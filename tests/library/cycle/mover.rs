//! A mechanism that goes from where it is to wherever its drives go, against its path and against the loop equations at its pose.

use super::{U, followed, posed, scenes};
use kinegon::Order;
use kinegon::cycle::{Happening, Mover, Path, Position};
use kinegon::geometry::Random;
use kinegon::mechanism::{Mechanism, SliderId};
use kinegon::motion::motion;
use kinegon::quantity::State;

/// Directions, places and rates of all links and sliders, with the power of the condition with which each kind errs.
fn numbers(position: &Position, mechanism: &Mechanism) -> Vec<(i32, Vec<f64>)> {
    let links: Vec<_> = mechanism.links().map(|(id, _)| id).collect();
    let sliders: Vec<_> = (0..mechanism.sliders.len()).map(SliderId).collect();
    let points: Vec<_> = (0..mechanism.points.len()).map(kinegon::mechanism::PointId).collect();
    let axes = links.iter().filter_map(|&link| position.axis(link)).flat_map(|axis| [axis.x, axis.y]).collect();
    let places = points.iter().flat_map(|&point| [position.place(point).x, position.place(point).y]).collect();
    let slides = sliders.iter().map(|&slider| position.slide_rates(slider));
    let (speeds, seconds) = slides.map(|[speed, second]| (speed, second)).unzip();
    let (omegas, alphas) =
        links.iter().map(|&link| position.angular_rates(link)).map(|[omega, alpha]| (omega, alpha)).unzip();
    vec![(1, axes), (1, places), (2, omegas), (2, speeds), (3, alphas), (3, seconds)]
}

fn condition(position: &Position, mechanism: &Mechanism) -> f64 {
    let solved = motion(mechanism, &position.pose(), Order::Acceleration).expect("regular");
    solved.conditions.into_iter().fold(1.0, f64::max)
}

/// Steps of all sizes, forwards and backwards, end where the path is, but for rounding.
#[test]
fn it_goes_where_the_path_goes() {
    let mut moved = 0;
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        if mechanism.drive_names().len() != 1 {
            continue;
        }
        let path = followed(&mechanism, &pose);
        if path.events().iter().any(|event| matches!(event.what, Happening::Change(_))) {
            continue;
        }
        go_about(&name, &mechanism, &path, Mover::new(&mechanism, &pose).expect("regular"));
        moved += 1;
    }
    assert!(moved > 10, "{moved}");
}

fn go_about(name: &str, mechanism: &Mechanism, path: &Path, mut mover: Mover) {
    let (low, wide) = (path.low(), path.high() - path.low());
    let mut random = Random(7);
    let mut walker = path.walker();
    for _ in 0..400 {
        let step = wide * libm::exp10(-4.0 * random.unit()) * 0.3 * random.within().signum();
        let value = (mover.drives()[0] + step).clamp(low + 0.05 * wide, low + 0.95 * wide);
        let position = mover.move_to(&[value]).unwrap_or_else(|| panic!("{name} {value}"));
        let expected = walker.position(value).expect("on the path");
        let condition = condition(&expected, mechanism);
        for (got, want) in numbers(&position, mechanism).iter().zip(numbers(&expected, mechanism)) {
            let size = want.1.iter().fold(f64::MIN_POSITIVE, |size: f64, x| size.max(x.abs()));
            for (a, b) in got.1.iter().zip(&want.1) {
                let off = (a - b).abs() / size;
                // Two computations, and groups that pass their errors on.
                let allowed = 1000.0 * U * condition.powi(want.0);
                assert!(off <= allowed, "{name} {value} {a} {b}: {off:e} > {allowed:e}");
            }
        }
    }
}

/// With all drives moved at once links keep their lengths, and rates solve the loop equations at the pose.
#[test]
fn several_drives_move_together() {
    let mut several = 0;
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let mut mover = Mover::new(&mechanism, &pose).expect("regular");
        several += usize::from(mover.drives().len() > 1);
        for k in 1..=20 {
            let values: Vec<f64> = mover.drives().iter().map(|value| value + 0.05 * f64::from(k % 7)).collect();
            let position = mover.move_to(&values).unwrap_or_else(|| panic!("{name} {values:?}"));
            let moved = position.pose();
            for body in mechanism.links().map(|(_, body)| body).filter(|body| body.points.len() > 1) {
                for (point, local) in body.points.iter().zip(&body.local).skip(1) {
                    let length = (local - body.local[0]).norm();
                    let found = (position.place(*point) - position.place(body.points[0])).norm();
                    assert!((found - length).abs() <= 1e-12 * length.max(1.0), "{name} {found} {length}");
                }
            }
            let solved = motion(&mechanism, &moved, Order::Acceleration).expect("regular");
            for (id, _) in mechanism.links() {
                let rates = solved.body(id);
                for (got, want) in position.angular_rates(id).into_iter().zip([rates.omega, rates.alpha]) {
                    assert!((got - want).abs() <= 1e-9 * (1.0 + want.abs()), "{name} {got} {want}");
                }
            }
        }
        assert_eq!(mover.drives().len(), mechanism.drive_names().len());
    }
    assert!(several > 0);
}

/// A crank that turns fully goes the shorter way from 350° to 10°, and comes to the same position after a turn.
#[test]
fn a_crank_goes_the_shorter_way() {
    let (_, text) = scenes().into_iter().find(|(name, _)| name == "four-bar").expect("a template");
    let (mechanism, pose) = posed(&text);
    let mut mover = Mover::new(&mechanism, &pose).expect("regular");
    let at = |mover: &mut Mover, degrees: f64| numbers(&mover.move_to(&[degrees]).expect("it turns fully"), &mechanism);
    at(&mut mover, 350.0);
    let across = at(&mut mover, 10.0);
    for degrees in [100.0, 190.0, 280.0] {
        at(&mut mover, degrees);
    }
    let around = at(&mut mover, 370.0);
    for (one, other) in across.iter().zip(&around) {
        for (a, b) in one.1.iter().zip(&other.1) {
            assert!((a - b).abs() <= 1e-10 * (1.0 + a.abs()), "{a} {b}");
        }
    }
}

/// Beyond a limit, and at what is no number, the mechanism stays where it was, with its rates; before the limit, however near, it comes.
#[test]
fn it_stays_where_it_cannot_go_on() {
    let text = include_str!("../../../examples/figure-2.json");
    let (mechanism, pose) = posed(text);
    let path = followed(&mechanism, &pose);
    let limit = path.high();
    let mut mover = Mover::new(&mechanism, &pose).expect("regular");
    let before = numbers(&mover.position(), &mechanism);
    for value in [limit + 1e-6, limit + 1.0, 150.0, 200.0, f64::NAN, f64::INFINITY] {
        assert!(mover.move_to(&[value]).is_none(), "{value}");
        assert_eq!(mover.drives(), [70.0]);
        for (now, then) in numbers(&mover.position(), &mechanism).iter().zip(&before) {
            for (a, b) in now.1.iter().zip(&then.1) {
                assert!((a - b).abs() <= 1e-12 * (1.0 + a.abs()), "{value} {a} {b}");
            }
        }
    }
    let mut walker = path.walker();
    for exponent in 0..7 {
        let value = limit - libm::exp10(f64::from(-exponent));
        let position = mover.move_to(&[value]).unwrap_or_else(|| panic!("{value}"));
        let expected = walker.position(value).expect("on the path");
        // On the other branch the slider would be 146 mm √δ · 2 away.
        let slider = SliderId(0);
        let [a, b] = [position.slide_position(slider), expected.slide_position(slider)].map(|s| s.expect("it has one"));
        assert!((a - b).abs() <= 1e-9 * b.abs(), "{value} {a} {b}");
    }
}
