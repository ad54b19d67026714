//! The table of a work sheet with boxes to be filled in.

use super::context::{Purpose, SheetContext};
use super::legend::symbol;
use super::table::Cells;
use super::text::RichText;
use super::worksheet::{CELLS, TablePlace, Worksheet, table};
use crate::construction::{Plan, Solution};
use crate::quantity::{Asked, What};

/// Widths of the boxes for millimetres and values, in mm.
const BOXES: [f64; 2] = [15.0, 21.0];

impl Worksheet {
    /// A table with boxes for the quantities to be found.
    pub(super) fn blank(context: &SheetContext<'_>, asked: &[Asked]) -> Self {
        let language = context.words.language;
        let rows = asked.iter().zip(1..).map(|(asked, number)| blank_row(context, asked, number)).collect();
        let mut table = table(language.exercise_quantity(), language.value(), rows);
        [table.widths[1], table.widths[3]] = BOXES;
        Self {
            table,
            lengths: Vec::new(),
            words: context.words,
            dims: context.surface.dims,
            place: TablePlace::Anywhere,
        }
    }
}

/// The row of a quantity to be found. Only lengths on paper have a scale.
fn blank_row(context: &SheetContext<'_>, asked: &Asked, number: usize) -> Cells<CELLS> {
    let name = context.quantity(asked);
    let is_length = matches!(asked.what(), What::Segment { .. } | What::Length(..));
    let scale = if is_length { symbol(asked.kind()) } else { "" };
    Cells {
        texts: [
            RichText::math(&name),
            RichText::plain(""),
            RichText::math(scale),
            RichText::plain(""),
            RichText::plain(&asked.kind().unit(context.scene().units)),
        ],
        id: Some(format!("box-{number}")),
        since: 0,
        stands_out: false,
        boxes: [false, is_length, false, true, false],
    }
}

/// How the sheets of a scene write quantities and plan points.
pub struct SheetLabels<'a>(SheetContext<'a>);

impl<'a> SheetLabels<'a> {
    /// The labels of a scene.
    #[must_use]
    pub fn of(solution: &'a Solution) -> SheetLabels<'a> {
        SheetLabels(SheetContext::new(solution, Purpose::Drawing))
    }

    /// A quantity: a segment or length by its ends, a rate by its symbol.
    #[must_use]
    pub fn quantity(&self, asked: &Asked) -> RichText {
        RichText::math(&self.0.quantity(asked))
    }

    /// Which sense is positive, and what the auxiliary points are that the quantities name.
    #[must_use]
    pub fn notes(&self, asked: &[Asked]) -> Vec<RichText> {
        self.0.notes(asked).iter().map(|note| RichText::plain(note)).collect()
    }

    /// A point of a plan.
    #[must_use]
    pub fn plan_point(&self, plan: &Plan, name: &str) -> RichText {
        RichText::math(&self.0.shown(name, Some(plan)))
    }
}

impl SheetContext<'_> {
    /// How a quantity is written on the sheets, in markup: a segment or length by its ends, a rate by its symbol.
    pub(super) fn quantity(&self, asked: &Asked) -> String {
        let plan = match asked.what() {
            What::Segment { kind, .. } => self.construction().plans().find(|plan| plan.kind == *kind),
            _ => None,
        };
        let between = |from: &str, to: &str| format!("{} {}", self.shown(from, plan), self.shown(to, plan));
        match asked.what() {
            What::Segment { from, to, .. } => between(from, to),
            What::Length(from, to) => between(from.name(), to.name()),
            _ => asked.symbol(self.mechanism(), self.words.notation, &|name| self.shown(name, None)),
        }
    }
}
