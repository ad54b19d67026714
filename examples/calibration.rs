//! How right `kinegon check` is about sheets that it has not drawn: the last tables of docs/mistakes.md.
//! Run with `cargo run --release --example calibration -- 2400 >> docs/mistakes.md`; the number counts the sheets with mistakes. `worst`
//! behind it lists the sheets of which something false was told.
//!
//! The students of `tests/support/students` draw random exercises of all kinds.

use kinegon::exercise::Exercises;
use support::files;
use support::students::hand::SKILLS;
use support::students::judge::Class;
use support::students::script::kinds;
use support::students::survey::{Outcome, calibration, classes, honest, survey};
use support::students::task::Task;

/// Exercises of each kind.
const EXERCISES: usize = 4;

fn starting(kind: &str) -> String {
    let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
    files::read(&format!("{folder}/{kind}.json"))
}

fn tasks() -> Vec<Task> {
    let of = |kind: &'static str| -> Vec<Task> {
        let text = starting(kind);
        let base = support::stages::solved(&text).expect("a good scene");
        let exercises = Exercises::new(&base, None, 41);
        let mut exercises = exercises.expect("it can vary");
        let next = |_| Task::new(kind, &exercises.next().expect("one can be found").text).expect("a scene");
        (0..EXERCISES).map(next).collect()
    };
    kinds().flat_map(of).collect()
}

/// What the tables are about.
const ABOUT: &str = "\
## Students who are not of the catalogue

Written by `cargo run --release --example calibration -- COUNT >> docs/mistakes.md`. Exercises of all 19 kinds are drawn by a construction of its own
(`tests/support/students`), by six hands, with a mistake at a random place: three of five are classical ones, the others slips by a random factor, angle or
way, which no catalogue can name; one sheet in eight has two.

*named*: every mistake is told, nothing false beside it; *located*: only the value at which it begins; *honest*: values off, nothing told; *wrong*: something
false told with 50 % or more; *weakly wrong*: with less. Told with so many per cent, right so often (right: only true mistakes by their names, or `unknown`
where one begins; what the values cannot tell from it counts, too):
";

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let count = words.first().and_then(|word| word.parse().ok()).unwrap_or(600);
    let tasks = tasks();
    let wrong = survey(&tasks, count, false, 5);
    let right = survey(&tasks, count / 2, true, 6);
    println!("{ABOUT}\n{}\nSheets with mistakes, in per cent:\n\n{}", calibration(&wrong), classes(&wrong));
    println!("Sheets without mistakes:\n\n{}", honest(&right));
    if words.iter().any(|word| word == "worst") {
        let is_false = |outcome: &&Outcome| [Some(Class::Wrong), Some(Class::WeaklyWrong)].contains(&outcome.class);
        wrong.iter().filter(is_false).for_each(list);
    }
}

/// What was done and what was told of a sheet.
fn list(outcome: &Outcome) {
    println!("{}, {}: {:?}, at {:?}", outcome.kind, SKILLS[outcome.skill].name, outcome.mistakes, outcome.begins);
    println!("    told with {:.0} %:", 100.0 * outcome.probability);
    for told in &outcome.told {
        println!("    {}: {} ({})", told.id, told.sentence, told.first.as_deref().unwrap_or("no value"));
    }
}
