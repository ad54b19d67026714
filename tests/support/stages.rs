//! A scene taken through all stages.

use kinegon::check::{AnswerKey, LATITUDE};
use kinegon::construction::Tolerance;
use kinegon::{Error, Scene, Solution, solve};

/// A scene's text, solved.
pub fn solved(text: &str) -> Result<Solution, Error> {
    solve(&Scene::read(text)?)
}

/// What a student's values are held against; so many mistakes at once are looked for.
pub fn answer_key(solution: &Solution, depth: usize) -> AnswerKey<'_> {
    AnswerKey { solution, scales: solution.scales(), tolerance: Tolerance::default(), latitude: LATITUDE, depth }
}
