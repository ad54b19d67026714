//! The students of `tests/support/students`.

use crate::support::files;
use crate::support::stages::solved;
use crate::support::students::hand::{Hand, RIGHT};
use crate::support::students::scheme::Scheme;
use crate::support::students::script::{draw, kinds, place_specials};
use crate::support::survey::tried;
use kinegon::exercise::Exercises;

/// The text of a kind's starting scene.
fn starting(kind: &str) -> String {
    let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
    files::read(&format!("{folder}/{kind}.json"))
}

#[test]
fn exact_drawings_agree_with_the_solution() {
    let mut failures = Vec::new();
    for kind in kinds() {
        let text = starting(kind);
        let base = solved(&text).expect("a good scene");
        for seed in tried(1..2, 1..6) {
            let exercises = Exercises::new(&text, &base.scene.figure, None, &base.construction, seed);
            let exercise = exercises.expect("it can vary").next().expect("one can be found");
            let (mut scheme, solution) = Scheme::new(&exercise.text).expect("a scene");
            place_specials(kind, &mut scheme);
            let mut sheet = draw(kind, &scheme, Hand::new(RIGHT, 1), &[]);
            for name in scheme.form.clone() {
                let Ok(kinegon::quantity::Quantity::Number(right)) = solution.quantity(&name) else {
                    panic!("{name}");
                };
                match sheet.write(&name) {
                    Some(value) if (value - right).abs() <= 1e-6 * right.abs().max(1.0) => {}
                    other => failures.push(format!("{kind} {seed} {name}: {other:?}, not {right}")),
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
