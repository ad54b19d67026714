//! The students of `tests/support/students`: their exact drawings are right, and the check is right about their mistakes.

use kinegon::exercise::{Exercise, Exercises};
use kinegon::quantity::Quantity;
use std::sync::OnceLock;
use support::files;
use support::stages::solved;
use support::students::hand::{Hand, RIGHT};
use support::students::judge::Class;
use support::students::scheme::Scheme;
use support::students::script::{draw, kinds, place_specials};
use support::students::survey::{Outcome, bins, calibration, classes, honest, survey};
use support::students::task::Task;
use support::survey::{KINDS, RIGHT_EXERCISES, SHEETS, WRONG_EXERCISES};

/// Of 100 sheets with mistakes, so many may be told something false with a probability of ½ or more.
const WRONG: f64 = 6.0;
/// Of 100 honest sheets, so many may be told of a mistake.
const ACCUSED: f64 = 1.0;
/// By how much the probabilities that are told may be too large on average.
const TOO_SURE: f64 = 0.03;
/// How far a sample may be off besides, in standard deviations.
const SPREAD: f64 = 2.5;

/// The first exercises of a kind.
fn first(kind: &'static str) -> (&'static str, Vec<Exercise>) {
    let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
    let text = files::read(&format!("{folder}/{kind}.json"));
    let base = solved(&text).expect("a good scene");
    let exercises = Exercises::new(&base, None, 7);
    let mut exercises = exercises.expect("it can vary");
    let count = RIGHT_EXERCISES.now().max(WRONG_EXERCISES.now());
    (kind, (0..count).map(|_| exercises.next().expect("one can be found")).collect())
}

/// The first exercises of every kind, looked for once for all tests.
fn exercises() -> &'static [(&'static str, Vec<Exercise>)] {
    static FOUND: OnceLock<Vec<(&'static str, Vec<Exercise>)>> = OnceLock::new();
    FOUND.get_or_init(|| kinds().map(first).collect())
}

fn tasks() -> Vec<Task> {
    let of = |(kind, exercises): &(&'static str, Vec<Exercise>)| {
        let some = exercises[..WRONG_EXERCISES.now()].iter();
        some.map(|exercise| Task::new(kind, &exercise.text).expect("a scene")).collect::<Vec<_>>()
    };
    exercises().iter().flat_map(of).collect()
}

/// What this construction and the one of the library have in common is the scene and the names.
#[test]
fn exact_drawings_agree_with_the_solution() {
    let mut failures = Vec::new();
    let mut drawn = 0;
    for (kind, exercises) in exercises().iter().step_by(KINDS.now()) {
        for exercise in &exercises[..RIGHT_EXERCISES.now()] {
            let (mut scheme, solution) = Scheme::new(&exercise.text).expect("a scene");
            place_specials(kind, &mut scheme);
            let mut sheet = draw(kind, &scheme, Hand::new(RIGHT, 1), &[]);
            for name in scheme.form.clone() {
                let Ok(Quantity::Number(right)) = solution.quantity(&name) else {
                    panic!("{name} is no number");
                };
                drawn += 1;
                let is_near = |value: f64| (value - right).abs() <= 1e-6 * right.abs() + 1e-9;
                match sheet.write(&name) {
                    Some(value) if is_near(value) => {}
                    other => failures.push(format!("{kind} {name}: {other:?}, not {right}")),
                }
            }
        }
    }
    assert!(drawn * KINDS.now() > 400, "only {drawn} values");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// So much of a share of `of` is chance.
fn spread(share: f64, of: usize) -> f64 {
    SPREAD * libm::sqrt(share * (1.0 - share) / of.max(1) as f64)
}

#[test]
fn mistakes_are_rarely_told_falsely_and_never_too_surely() {
    let outcomes = survey(&tasks(), SHEETS.now(), false, 11);
    println!("{}\n{}", calibration(&outcomes), classes(&outcomes));
    let wrong = outcomes.iter().filter(|outcome| outcome.class == Some(Class::Wrong)).count();
    let share = WRONG / 100.0;
    let allowed = share + spread(share, outcomes.len());
    assert!(wrong as f64 <= allowed * outcomes.len() as f64, "{wrong} of {} are told falsely", outcomes.len());
    let told: Vec<_> = bins(outcomes.iter()).into_iter().collect();
    let count: usize = told.iter().map(|bin| bin.count).sum();
    let stated = told.iter().map(|bin| bin.stated).sum::<f64>() / count as f64;
    let right = told.iter().map(|bin| bin.right).sum::<usize>() as f64 / count as f64;
    let allowed = TOO_SURE + spread(stated, count);
    assert!(stated - right <= allowed, "of {count} told with {stated:.2} on average, {right:.2} are right");
}

#[test]
fn honest_sheets_are_rarely_accused() {
    let outcomes = survey(&tasks(), SHEETS.now(), true, 12);
    println!("{}", honest(&outcomes));
    let is_accused = |outcome: &&Outcome| !outcome.told.is_empty();
    let accused: Vec<&Outcome> = outcomes.iter().filter(is_accused).collect();
    let share = ACCUSED / 100.0;
    let allowed = share + spread(share, outcomes.len());
    assert!(accused.len() as f64 <= allowed * outcomes.len() as f64, "{} of {}", accused.len(), outcomes.len());
}
