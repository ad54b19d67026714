//! The judge of drawings, and what it finds.

use super::entry::{Cross, Entry};
use super::file::HandDrawing;
use super::given::Given;
use super::others::others;
use super::says;
use super::table::{Made, Table};
use crate::check::{AnswerKey, Told};
use crate::construction::Tolerance;
use crate::drawing::HandPaper;
use crate::message::Message;
use crate::scene::{Head, QuantityName, SceneError, SceneTree};
use crate::sheet::{PerSheet, Sheet};
use crate::words::sheet_told;

/// What is found of an entry.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Verdict {
    /// It is right.
    Right,
    /// It is wrong by itself.
    Wrong(Wrong),
    /// It is right by itself, but hangs on something that is wrong.
    Follows,
    /// Nothing uses it, and its name means nothing.
    Unused,
    /// It was taken back, or takes back.
    Undone,
}

/// What is wrong with an entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// What is to be seen: `c` does not lie on this line.
    pub what: Message,
    /// What was probably done, and what should be, where the catalogue of mistakes has it.
    pub mistake: Option<Told>,
}

/// A judged drawing.
#[derive(Clone, Debug)]
pub struct JudgedDrawing {
    /// By entry.
    pub verdicts: Vec<Verdict>,
    /// Quantities that were typed and to which nothing that is drawn leads: they are no findings, right or wrong.
    pub(super) unfounded: Vec<String>,
}

impl JudgedDrawing {
    /// The index of the first entry that is wrong.
    #[must_use]
    pub fn first_wrong(&self) -> Option<usize> {
        self.verdicts.iter().position(|verdict| matches!(verdict, Verdict::Wrong(_)))
    }
}

/// Why a drawing cannot be carried out: at which entry, and what is wrong with it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("entry {}: {message}", entry + 1)]
pub struct BoardError {
    /// The index of the entry.
    pub entry: usize,
    /// What is wrong.
    pub message: Message,
}

/// A judge of drawings of one scene; may judge many.
#[derive(Debug)]
pub struct Judge {
    given: Given,
    others: Vec<Given>,
    tolerance: Tolerance,
    scales: PerSheet<f64>,
}

/// Size of a plan in millimetres where neither drawing nor scene has a scale for it.
const USUAL_SIZE: f64 = 150.0;

impl Judge {
    /// A judge for the scene of an answer key.
    #[must_use]
    pub fn new(key: &AnswerKey<'_>) -> Judge {
        let given = Given::new(key.solution);
        let others = others(&given);
        let fitting = |sheet| if given.size(sheet) > 0.0 { given.size(sheet) / USUAL_SIZE } else { 1.0 };
        let scales = PerSheet::from_fn(|sheet| key.scales[sheet].unwrap_or_else(|| fitting(sheet)));
        Judge { given, others, tolerance: key.tolerance, scales }
    }

    /// What the scene gives and means.
    #[must_use]
    pub fn given(&self) -> &Given {
        &self.given
    }

    /// The scenes like it.
    pub(super) fn others(&self) -> &[Given] {
        &self.others
    }

    /// Limits of the errors of an honest hand.
    pub(super) fn tolerance(&self) -> &Tolerance {
        &self.tolerance
    }

    /// The scales of sheets of which a drawing says nothing.
    pub(super) fn usual_scales(&self) -> PerSheet<f64> {
        self.scales
    }

    /// The scales of a drawing's sheets, in units of the scene per millimetre.
    #[must_use]
    pub fn scales(&self, drawing: &HandDrawing) -> PerSheet<f64> {
        PerSheet::from_fn(|sheet| drawing.mu[sheet].unwrap_or(self.scales[sheet]))
    }

    /// The drawing of a text, at scales at which paper is large enough for the sheets.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read(&self, text: &str) -> Result<HandDrawing, SceneError> {
        let drawing = HandDrawing::read(text)?;
        let solution = &self.given.solution;
        let is_there = |sheet: Sheet| sheet == Sheet::Scheme || self.given.has_sheet(sheet);
        let is_too_large =
            |(sheet, mu): &(Sheet, f64)| is_there(*sheet) && HandPaper::of(solution, *sheet, *mu, []).is_none();
        let too_large = drawing.mu.given().find(is_too_large);
        match too_large {
            None => Ok(drawing),
            Some((sheet, mu)) => {
                let (key, metres) = (sheet.facts().scale_key, self.given.size(sheet) / mu * 1e-3);
                let most = HandPaper::LONGEST * 1e-3;
                let message = says::sheet_too_large(mu, sheet_told(sheet), format!("{metres:.0}"), most);
                let hint = says::other_scale(significant(self.scales[sheet]), key);
                Err(SceneTree::error(text, &[key], message, Some(hint)))
            }
        }
    }

    /// The sheets as the hand drew them, up to the first entry that cannot be carried out.
    #[must_use]
    pub fn drawn(&self, drawing: &HandDrawing) -> (Table<'_>, Option<BoardError>) {
        let mut table = Table::new(&self.given, self.scales(drawing));
        for (entry, act) in standing(drawing) {
            match table.carry_out_by_hand(act) {
                Ok(made) => table.put(made),
                Err(message) => return (table, Some(BoardError { entry, message })),
            }
        }
        (table, None)
    }

    /// By entry: the step of Kinegon's construction that finds what it makes, or for which its line is crossed; 0 where none does.
    #[must_use]
    pub fn steps(&self, drawing: &HandDrawing) -> Vec<usize> {
        let construction = self.given.construction();
        let steps = construction.steps_of_quantities();
        let of_point = |sheet: Sheet, name: &str| {
            let Some(order) = sheet.order() else { return steps.get(&format!("{name}.x")) };
            // A vector is the segment from where it begins.
            let ends_there = |quantity: &str| {
                QuantityName::parse(quantity).is_some_and(|quantity| {
                    quantity.head == Head::Between(sheet) && quantity.arguments.last().is_some_and(|end| end == name)
                })
            };
            let vector = || steps.iter().find(|(quantity, _)| ends_there(quantity)).map(|(_, step)| step);
            steps.get(&sheet.segment_name(order.pole(), name)).or_else(vector)
        };
        let mut found = vec![0; drawing.did.len()];
        let mut table = Table::new(&self.given, self.scales(drawing));
        let crossed = |line: &str| {
            standing(drawing).find_map(|(_, entry)| match entry {
                Entry::Cross(Cross { cross, of, .. }) if of.iter().any(|own| own == line) => Some(cross.as_str()),
                _ => None,
            })
        };
        for (index, entry) in standing(drawing) {
            let Ok(made) = table.carry_out_by_hand(entry) else { break };
            let step = match &made {
                Made::Place(sheet, name, _) => of_point(*sheet, name),
                Made::Line(name, line) => crossed(name).and_then(|point| of_point(line.sheet, point)),
                Made::Numbers(all) => all.first().and_then(|(name, _)| steps.get(name)),
            };
            found[index] = step.map_or(0, |step| construction.step_number(*step));
            table.put(made);
        }
        found
    }
}

/// A number to three digits.
fn significant(x: f64) -> String {
    let places = (2.0 - libm::floor(libm::log10(x))).clamp(0.0, 9.0);
    let text = format!("{x:.*}", places as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// The entries that stand, with their indices.
pub(super) fn standing(drawing: &HandDrawing) -> impl Iterator<Item = (usize, &Entry)> {
    let stands = drawing.standing();
    drawing.did.iter().enumerate().filter(move |(index, _)| stands[*index])
}
