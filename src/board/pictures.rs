//! What a hand has drawn, as pictures and as sheets of paper.

use super::entry::{Entry, LayOff};
use super::file::HandDrawing;
use super::judge::{JudgedDrawing, Verdict};
use super::screen::Screen;
use super::table::{Made, Table};
use crate::drawing::{Drawing, HandLine, HandLook, HandPoint, HandSheet, HandVector, hand_sheet, hand_sheets};
use crate::sheet::Sheet;

impl Screen {
    /// What a hand has drawn on a sheet by the first `until` entries, with what a judge has found.
    #[must_use]
    pub fn hand(
        &self,
        drawing: &HandDrawing,
        sheet: Sheet,
        until: Option<usize>,
        judged: Option<&JudgedDrawing>,
    ) -> HandSheet {
        let mut hand = HandSheet { sheet, lines: Vec::new(), vectors: Vec::new(), points: Vec::new() };
        let mut shown = drawing.clone();
        shown.did.truncate(until.unwrap_or(drawing.did.len()));
        let stands = shown.standing();
        let mut table = Table::new(self.judge.given(), self.judge.scales(drawing));
        for (index, entry) in shown.did.iter().enumerate().filter(|(index, _)| stands[*index]) {
            let Ok(made) = table.carry_out_by_hand(entry) else { break };
            let look = judged.map_or(HandLook::Drawn, |judged| look(&judged.verdicts[index]));
            match (&made, entry) {
                (Made::Place(on, name, at), entry) if *on == sheet => {
                    if let Entry::LayOff(LayOff { from, .. }) = entry
                        && let Some(from) = table.place(sheet, from)
                    {
                        hand.vectors.push(HandVector { from, to: *at, look });
                    }
                    hand.points.push(HandPoint { name: name.clone(), at: *at, look });
                }
                (Made::Line(name, line), _) if line.sheet == sheet => {
                    hand.lines.push(HandLine { name: name.clone(), at: line.at, along: line.along, look });
                }
                _ => {}
            }
            table.put(made);
        }
        hand
    }

    /// The picture of a sheet; `letters` is their height in millimetres.
    #[must_use]
    pub fn picture(
        &self,
        drawing: &HandDrawing,
        sheet: Sheet,
        until: Option<usize>,
        letters: f64,
        judged: Option<&JudgedDrawing>,
    ) -> Option<Drawing> {
        let paper = self.paper(sheet, self.judge.scales(drawing))?;
        let hand = self.hand(drawing, sheet, until, judged);
        Some(hand_sheet(&self.judge.given().solution, &hand, &paper, letters))
    }

    /// The plans on sheets of paper, as those of an exercise; `name` stands in their codes.
    #[must_use]
    pub fn sheets(&self, drawing: &HandDrawing, judged: Option<&JudgedDrawing>, name: &str) -> Vec<Drawing> {
        let scales = self.judge.scales(drawing);
        let plans = Sheet::ALL.into_iter().filter(|sheet| sheet.has_places() && self.shows(*sheet));
        let hands: Vec<HandSheet> = plans.map(|sheet| self.hand(drawing, sheet, None, judged)).collect();
        let note = self.free_hand(drawing);
        hand_sheets(&self.judge.given().solution, &hands, &scales.map(Some), name, note.as_deref())
    }
}

fn look(verdict: &Verdict) -> HandLook {
    match verdict {
        Verdict::Wrong(_) => HandLook::Wrong,
        Verdict::Follows => HandLook::Following,
        Verdict::Right | Verdict::Unused | Verdict::Undone => HandLook::Drawn,
    }
}
