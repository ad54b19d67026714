//! What must not depend on how a scene is looked at: random fourth-class groups, turned, mirrored, scaled, shifted, renamed and
//! reordered. Every change is exact in binary, so the two results may differ by the rounding of the solution alone.
//!
//! Half of the scenes are hard: near-parallel legs, nearly singular, nearly dead, extreme ratios, large common velocities.

use kinegon::geometry::{Point, cross};
use kinegon::mechanism::{LoopEquations, StructureError, mechanism};
use kinegon::motion::ClosedForm;
use kinegon::scene::Scene;
use kinegon::{Error, Solution};
use nalgebra::DVector;
use serde_json::Value;
use support::changes::{BOUND, Change, Differences, U, compare, keep_worst, ratio};
use support::exact::exactly_written;
use support::groups::{Base, Group, Names, Pair, add, is_singular, patterns, times};
use support::images::dissimilarity;
use support::random::Random;
use support::stages::solved;

/// All that the library says of a scene; `None` where the motion is refused as singular.
fn moved(scene: &Value) -> Option<Solution> {
    let text = exactly_written(&scene.to_string());
    match solved(&text) {
        Ok(solution) => Some(solution),
        Err(Error::Motion(_)) => None,
        Err(error) => panic!("{error}\n{text}"),
    }
}

fn condition(solution: &Solution) -> f64 {
    solution.motion.conditions[0]
}

/// Random groups, each changed by `changed` to a group that is solved again; prints and bounds the largest difference.
fn unchanged_but_for(
    what: &str,
    seed: u64,
    bits: usize,
    change: impl Fn() -> Change<'static>,
    changed: impl Fn(&Group, &Change<'_>) -> Group,
) {
    let mut dice = Random(seed);
    let (mut worst, mut hardest, mut refused) = (Differences::default(), 1.0_f64, 0);
    for _ in 0..SCENES {
        let group = Group::any(&mut dice, bits);
        let change = change();
        let scene = group.scene();
        let other = changed(&group, &change).scene_as(&change.names);
        let (before, after) = match (moved(&scene), moved(&other)) {
            (Some(before), Some(after)) => (before, after),
            (None, None) => {
                refused += 1;
                continue;
            }
            (one, two) => {
                let condition = one.or(two).map_or(f64::INFINITY, |s| condition(&s));
                assert!(
                    condition > 1e13,
                    "{what}: only one of two is refused, condition {condition:e}\n{scene}\n{other}"
                );
                refused += 1;
                continue;
            }
        };
        let condition = condition(&before).max(condition(&after));
        hardest = hardest.max(condition);
        let seen = compare(&before.result(), &after.result(), &change, U * condition, 0.0);
        if !seen.small() {
            println!("{what}: {seen}; condition {condition:.1e}\n{scene}");
        }
        worst.merge(seen);
    }
    println!("{what}: {worst}; conditions up to {hardest:.1e}, {refused} of {SCENES} singular");
    assert!(worst.small() && refused < SCENES / 20);
    assert!(hardest > 1e5, "the scenes have become too easy: conditions up to {hardest:e} only");
}

/// Scenes for each change.
const SCENES: u32 = 250;

/// Coordinates are multiples of 2^−40: changes by small whole numbers leave them exact.
const FINE: usize = 40;

/// Coordinates are multiples of 2^−20: they stay exact beside an origin 2^31 away.
const FAR: usize = 20;

fn mapped(group: &Group, change: &Change<'_>) -> Group {
    group.map(change.place, change.vector, change.order, change.turn)
}

#[test]
fn turning_the_plane_turns_the_result() {
    // Times 3 + 4i: turned by 53.13° and 5 times as large, without rounding.
    fn turned([x, y]: Pair) -> Pair {
        [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y]
    }
    let change = || Change { place: &turned, vector: &turned, length: 5.0, ..Change::default() };
    unchanged_but_for("turned by 53°", 1, FINE, change, mapped);
    fn upright([x, y]: Pair) -> Pair {
        [-y, x]
    }
    let change = || Change { place: &upright, vector: &upright, ..Change::default() };
    unchanged_but_for("turned by 90°", 2, FINE, change, mapped);
}

#[test]
fn a_mirror_image_turns_the_other_way() {
    fn mirrored([x, y]: Pair) -> Pair {
        [x, -y]
    }
    let change = || Change { place: &mirrored, vector: &mirrored, turn: -1.0, ..Change::default() };
    unchanged_but_for("mirrored", 3, FINE, change, mapped);
}

#[test]
fn units_of_length_do_not_matter() {
    fn thrice(v: Pair) -> Pair {
        times(v, 3.0)
    }
    let change = || Change { place: &thrice, vector: &thrice, length: 3.0, ..Change::default() };
    unchanged_but_for("lengths times 3", 4, FINE, change, mapped);
    // Powers of two at which products of two, three or four lengths are no longer representable.
    length_units::<-500>("lengths times 2^-500", 5);
    length_units::<-300>("lengths times 2^-300", 15);
    length_units::<300>("lengths times 2^300", 16);
}

fn length_units<const POWER: i32>(what: &str, seed: u64) {
    fn scaled<const POWER: i32>(v: Pair) -> Pair {
        times(v, 2_f64.powi(POWER))
    }
    let change =
        || Change { place: &scaled::<POWER>, vector: &scaled::<POWER>, length: 2_f64.powi(POWER), ..Change::default() };
    unchanged_but_for(what, seed, FINE, change, mapped);
}

#[test]
fn units_of_time_do_not_matter() {
    let change = || Change { order: [3.0, 9.0], ..Change::default() };
    unchanged_but_for("time in thirds", 6, FINE, change, mapped);
    let change = || Change { order: [1.0 / 1024.0, 1.0 / 1_048_576.0], ..Change::default() };
    unchanged_but_for("time times 2^10", 7, FINE, change, mapped);
}

#[test]
fn the_origin_does_not_matter() {
    // A hundred million times the size of the group, which is about 16.
    fn shifted(p: Pair) -> Pair {
        add(p, [1_610_612_736.0, -1_073_741_824.0])
    }
    let change = || Change { place: &shifted, ..Change::default() };
    unchanged_but_for("origin far away", 8, FAR, change, mapped);
}

#[test]
fn names_do_not_matter() {
    let renamed = || Change { names: Names { renamed: true, reversed: false }, ..Change::default() };
    unchanged_but_for("renamed", 9, FINE, renamed, |group, _| group.clone());
    let mut dice = Random(10);
    for _ in 0..SCENES {
        // Not a bit changes: no name takes part in a computation.
        let group = Group::any(&mut dice, FINE);
        let change = renamed();
        let other = group.scene_as(&change.names);
        if let (Some(before), Some(after)) = (moved(&group.scene()), moved(&other)) {
            let seen = compare(&before.result(), &after.result(), &change, U, 0.0);
            let largest = seen.velocity.0.max(seen.acceleration.0);
            assert!(largest == 0.0, "{seen}\n{other}");
        }
    }
}

#[test]
fn the_order_of_links_does_not_matter() {
    let reversed = || Change { names: Names { renamed: false, reversed: true }, ..Change::default() };
    unchanged_but_for("reversed", 11, FINE, reversed, |group, _| group.clone());
}

#[test]
fn links_images_in_both_plans_are_similar_to_them() {
    let mut dice = Random(12);
    let (mut pairs, mut worst) = (0, (0.0, String::new()));
    for _ in 0..SCENES {
        let scene = Group::any(&mut dice, FINE).scene();
        let Some(solution) = moved(&scene) else {
            continue;
        };
        let (seen, part, what) = dissimilarity(&solution, &solution.result(), condition(&solution));
        pairs += seen;
        keep_worst(&mut worst, part, &format!("{what}: {scene}"));
    }
    println!("similarity: {pairs} pairs, at most {:.3} of what is allowed", worst.0);
    assert!(pairs > 10 * SCENES as usize && worst.0 <= 1.0, "{worst:?}");
}

#[test]
fn the_closed_form_agrees_with_the_whole_system() {
    let mut dice = Random(13);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for round in 0..SCENES {
        let group = match round % 3 {
            0 => Group::plain(&mut dice, "RRRRRR"),
            _ => Group::hard(&mut dice, "RRRRRR", FINE),
        };
        let scene = group.scene();
        let Some(solution) = moved(&scene) else {
            continue;
        };
        let Solution { mechanism, pose, motion, .. } = &solution;
        let links = &mechanism.groups[0].links;
        let equations = LoopEquations::new(mechanism, &mechanism.groups[0]);
        let system = equations.factored(&pose.points, &pose.guides).expect("it was solved");
        let matrix = equations.matrix(&pose.points, &pose.guides);
        let Some(form) = ClosedForm::new(&equations, &pose.points, &pose.guides) else {
            continue;
        };
        // The right side that belongs to this motion.
        let rates = DVector::from_fn(equations.unknowns, |unknown, _| {
            let link = equations.link_of(unknown).expect("all pins");
            motion.body(link).omega
        });
        let side = &matrix * rates;
        let rate = |i: usize, x: &[f64]| equations.angular_unknown(links[i]).map_or(f64::NAN, |unknown| x[unknown]);
        let closed = form.solve_all(side.as_slice());
        let closed: [f64; 4] = std::array::from_fn(|i| rate(i, &closed));
        let whole = system.solve(side.as_slice());
        let rates: [f64; 4] = std::array::from_fn(|i| rate(i, &whole));
        // Every rate counts with the length of its arm, as it stands in the equations.
        let arms: [f64; 4] = std::array::from_fn(|i| {
            let unknown = equations.angular_unknown(links[i]).expect("all pins");
            matrix.column(unknown).amax()
        });
        let scale = (0..4).fold(0.0, |m: f64, i| m.max(rates[i].abs() * arms[i]));
        for ((a, b), arm) in closed.iter().zip(&rates).zip(&arms) {
            let difference = ratio((a - b) * arm, scale * U * system.condition());
            assert!(difference <= BOUND, "{difference} u·cond: {closed:?} {rates:?}\n{scene}");
            worst = worst.max(difference);
        }
        compared += 1;
    }
    println!("closed form: {compared} scenes, at most {worst:.3} u·cond apart");
    assert!(compared > SCENES / 2);
}

#[test]
fn the_patterns_that_are_singular_by_structure_are_refused() {
    let mut dice = Random(14);
    let mut refused = 0;
    for pattern in patterns() {
        for _ in 0..8 {
            let scene = Group::plain(&mut dice, &pattern).scene();
            let read = Scene::read(&scene.to_string()).unwrap_or_else(|e| panic!("{pattern}: {e}\n{scene}"));
            match mechanism(&read) {
                Err(StructureError::Singular { pattern: named, links, .. }) => {
                    assert!(is_singular(&pattern), "{pattern} is refused as {named}");
                    assert_eq!(named.replace('R', "").len(), pattern.replace('R', "").len());
                    assert_eq!(links, "2, 3, 4, 5");
                    refused += 1;
                }
                Err(other) => panic!("{pattern}: {other}\n{scene}"),
                Ok(mechanism) => {
                    assert!(!is_singular(&pattern), "{pattern} is not refused");
                    assert_eq!(mechanism.groups[0].pattern(&mechanism), pattern);
                    let solution = moved(&scene).unwrap_or_else(|| panic!("{pattern}: singular\n{scene}"));
                    assert!(condition(&solution) < 1e6, "{pattern}: condition {:e}\n{scene}", condition(&solution));
                }
            }
        }
    }
    assert_eq!(refused, 10 * 8);
}

/// The three lines' determinant for revolute groups: the generator's nearly singular scenes are what they are meant to be.
#[test]
fn conditions_grow_as_the_lines_concur() {
    let group = |shift: f64| Group {
        places: [[0.0, 0.0], [1.0, 2.0], [3.0, 2.5 + shift], [4.0, 0.5], [3.25, -1.5], [1.0, -1.0]],
        guides: [None; 6],
        bases: std::array::from_fn(|i| Base { velocity: [1.5, i as f64], acceleration: [-1.0, 0.5], spin: None }),
    };
    let lines = |g: &Group| {
        let [b, c, d, e, f, g] = g.places.map(Point::from);
        let line = |p: Point, q: Point| nalgebra::Vector3::new(p.y - q.y, q.x - p.x, cross(p.coords, q.coords));
        line(c, d).cross(&line(g, f)).dot(&line(b, e))
    };
    // The shift at which the lines concur, by linear interpolation: the determinant is linear in it.
    let (at_zero, at_one) = (lines(&group(0.0)), lines(&group(1.0)));
    let singular = at_zero / (at_zero - at_one);
    let condition = |away: f64| moved(&group(singular + away).scene()).map_or(f64::INFINITY, |s| condition(&s));
    let far = condition(1e-2);
    for exponent in 4..12 {
        let close = condition(10_f64.powi(-exponent)) / far * 10_f64.powi(2 - exponent);
        assert!((0.2..5.0).contains(&close), "condition at 1e-{exponent} is {close} of 1/distance");
    }
    assert!(condition(0.0) > 1e14);
}
