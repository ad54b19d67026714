//! How right `kinegon check` is about sheets that it has not drawn: tables of docs/mistakes.md.
//! Run with `cargo run --release --example calibration -- 2000`; the number counts the sheets with mistakes. `worst`
//! behind it lists the sheets of which something false was told.
//!
//! The students of `tests/support/students` draw random exercises of all kinds.

#[expect(dead_code, reason = "tests use more of it")]
#[path = "../tests/support"]
mod support {
    pub mod random;
    pub mod stages;
    pub mod students;
}

use kinegon::exercise::Exercises;
use support::students::judge::Class;
use support::students::script::kinds;
use support::students::survey::{Outcome, calibration, classes, honest, survey};
use support::students::task::Task;

/// Exercises of each kind.
const EXERCISES: usize = 4;

fn starting(kind: &str) -> String {
    let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
    let path = format!("{}/{folder}/{kind}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn tasks() -> Vec<Task> {
    let of = |kind: &'static str| -> Vec<Task> {
        let text = starting(kind);
        let base = support::stages::solved(&text).expect("a good scene");
        let exercises = Exercises::new(&text, &base.scene.figure, None, &base.construction, 41);
        let mut exercises = exercises.expect("it can vary");
        let next = |_| Task::new(kind, &exercises.next().expect("one can be found").text).expect("a scene");
        (0..EXERCISES).map(next).collect()
    };
    kinds().flat_map(of).collect()
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let count = words.first().and_then(|word| word.parse().ok()).unwrap_or(600);
    let tasks = tasks();
    let wrong = survey(&tasks, count, false, 5);
    let right = survey(&tasks, count / 2, true, 6);
    println!("{}\n{}\n{}", calibration(&wrong), classes(&wrong), honest(&right));
    if words.iter().any(|word| word == "worst") {
        let is_false = |outcome: &&Outcome| [Some(Class::Wrong), Some(Class::WeaklyWrong)].contains(&outcome.class);
        for outcome in wrong.iter().filter(is_false) {
            println!(
                "{} {}: {:?} at {:?}\n    {:.0} %: {:?}",
                outcome.kind,
                outcome.skill,
                outcome.mistakes,
                outcome.begins,
                100.0 * outcome.probability,
                outcome.told
            );
        }
    }
}
