//! A scene taken through all stages.

use kinegon::check::{AnswerKey, LENIENCY};
use kinegon::construction::Tolerance;
use kinegon::drawing::{Drawing, HeldLayout, Steps};
use kinegon::{Error, Scene, Solution, solve};

/// A scene's text, solved.
pub fn solved(text: &str) -> Result<Solution, Error> {
    solve(&Scene::read(text)?)
}

/// What a student's values are held against; so many mistakes at once are looked for.
pub fn answer_key(solution: &Solution, depth: usize) -> AnswerKey<'_> {
    AnswerKey { solution, scales: solution.scales(), tolerance: Tolerance::default(), leniency: LENIENCY, depth }
}

/// The stepwise figures of positions on one stage, that of the position of an index.
pub fn staged(positions: &[Solution], own: usize) -> Vec<Drawing> {
    let stage = HeldLayout::of_figure(&positions[own], Some(Steps::Fine), None);
    positions.iter().map(|position| stage.draw(position, None)).collect()
}
