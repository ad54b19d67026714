//! Hints by stages: where, what, and what would be drawn.

use super::centers::{is_found, needed};
use super::entry::{Entry, Measure};
use super::file::HandDrawing;
use super::judge::{JudgedDrawing, Verdict};
use super::says;
use super::screen::{Screen, across, path};
use super::shown::{Ghost, GhostKind};
use super::table::{Made, Table};
use crate::geometry::cross;
use crate::sheet::Sheet;
use crate::words::Medium;
use serde::Serialize;

/// A hint.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardHint {
    /// What is said.
    pub words: String,
    /// The sheet that it is about; none for a computation, and where nothing is left to do.
    pub sheet: Option<Sheet>,
    /// What would be drawn, from the third stage on.
    pub ghost: Vec<Ghost>,
    /// The index of the entry that is wrong; none where the hint is about the next one.
    pub entry: Option<usize>,
}

/// Stages of hints.
pub const STAGES: u8 = 3;

impl Screen {
    /// A hint of a stage: about the first wrong entry, or about what comes next in Kinegon's own construction.
    #[must_use]
    pub fn hint(&self, drawing: &HandDrawing, judged: Option<&JudgedDrawing>, stage: u8) -> BoardHint {
        let language = self.language();
        if let Some((index, Verdict::Wrong(wrong))) =
            judged.and_then(|judged| judged.first_wrong().map(|index| (index, &judged.verdicts[index])))
        {
            let should = wrong.mistake.as_ref().map(|mistake| mistake.sentences(&self.words()));
            let words = match (stage, should) {
                (..=1, _) => language.says(&says::first_wrong(index + 1)),
                (2, Some([done, _])) => done,
                (3.., Some([_, should])) => language.says(&says::should(should)),
                _ => language.says(&wrong.what),
            };
            return BoardHint { words, sheet: None, ghost: Vec::new(), entry: Some(index) };
        }
        let (table, _) = self.judge.drawn(drawing);
        let Some((entry, made)) = self.next(&table) else {
            return BoardHint { words: language.says(&says::all_there()), sheet: None, ghost: Vec::new(), entry: None };
        };
        let sheet = match &made {
            Made::Place(sheet, ..) => Some(*sheet),
            Made::Line(_, line) => Some(line.sheet),
            Made::Numbers(_) => None,
        };
        let names = super::table::things(&made).into_iter().map(|(_, name)| self.judge.given().shown(&name));
        let what = names.collect::<Vec<_>>().join(", ");
        let words = match stage {
            ..=1 => match (&made, sheet) {
                (Made::Line(..), Some(sheet)) => says::next_line(crate::words::sheet_told(sheet)),
                (_, Some(sheet)) => says::next_point(what, crate::words::sheet_told(sheet)),
                (_, None) => says::next_number(what),
            },
            _ => entry.told(&self.judge, Medium::Figure),
        };
        let ghost = if stage >= STAGES { self.ghost_of(drawing, &entry, &made, &table) } else { Vec::new() };
        BoardHint { words: language.says(&words), sheet, ghost, entry: None }
    }

    /// The next entry of Kinegon's own construction of which the result is not there yet.
    fn next(&self, table: &Table<'_>) -> Option<(Entry, Made)> {
        let given = self.judge.given();
        let own = self.own()?;
        // The own construction goes on with the hand's own things where they are there.
        let mut ahead = table.clone();
        let has_ways = given.construction().centers.is_some() || !given.polygons.is_empty();
        let needed = if has_ways { needed(given, &own.did, table) } else { vec![true; own.did.len()] };
        let (by_itself, _) = self.judge.drawn(own);
        for (index, entry) in own.did.iter().enumerate() {
            let is_line = matches!(entry, Entry::Line(_) | Entry::Join(_));
            let Ok(made) = ahead.carry_out(entry) else {
                // Where the hand's polygons have other corners, numbers are found from these.
                let names = entry.made();
                let is_missing = needed[index] && names.iter().all(|name| given.number(name).is_some());
                let found = names.iter().map(|name| Some(((*name).to_owned(), by_itself.known(name)?)));
                match found.collect::<Option<Vec<_>>>() {
                    Some(found) if is_missing && !given.polygons.is_empty() => {
                        return Some((entry.clone(), Made::Numbers(found)));
                    }
                    _ => continue,
                }
            };
            let is_there = match &made {
                // A corner of a polygon has whatever name the hand has given it.
                Made::Place(Sheet::Forces, _, at) => {
                    let near = 0.02 * given.size(Sheet::Forces);
                    let is_there = table.places(Sheet::Forces).any(|(_, own)| (own - at).norm() <= near);
                    if is_there {
                        ahead.put(made.clone());
                    }
                    is_there
                }
                Made::Place(sheet, name, _) => table.place(*sheet, name).is_some(),
                Made::Numbers(all) => {
                    let is_of_forces = matches!(entry, Entry::Measure(Measure { on: Some(Sheet::Forces), .. }));
                    let is_measured = matches!(entry, Entry::Measure(_)) && !is_of_forces;
                    is_measured || all.iter().all(|(name, _)| is_found(table, name))
                }
                Made::Line(name, line) => {
                    let leads_to = own.did[index..].iter().find_map(|later| match later {
                        Entry::Cross(cross) if cross.of.contains(name) => Some(&cross.cross),
                        _ => None,
                    });
                    let is_crossed = leads_to.is_some_and(|point| table.place(line.sheet, point).is_some());
                    let near = 1e-6 * given.size(line.sheet);
                    let is_drawn = table.lines().any(|(_, other)| {
                        other.sheet == line.sheet
                            && cross(other.along, line.along).abs() < 1e-6
                            && other.distance(line.at).abs() <= near
                    });
                    is_crossed || is_drawn
                }
            };
            if !is_there && needed[index] {
                return Some((entry.clone(), made));
            }
            if is_line || !matches!(made, Made::Place(..)) {
                ahead.put(made);
            }
        }
        None
    }

    fn ghost_of(&self, drawing: &HandDrawing, entry: &Entry, made: &Made, table: &Table<'_>) -> Vec<Ghost> {
        let scales = self.judge.scales(drawing);
        match made {
            Made::Place(sheet, _, at) => {
                let Some(paper) = self.paper(*sheet, scales) else { return Vec::new() };
                let end = paper.at(*at);
                let from = match entry {
                    Entry::LayOff(laid) => table.place(*sheet, &laid.from),
                    _ => None,
                };
                let arrow = from.map(|from| Ghost { kind: GhostKind::Arrow, path: path(&[paper.at(from), end]) });
                let dot = Ghost { kind: GhostKind::Point, path: format!("M{:.2} {:.2}h0", end[0], end[1]) };
                arrow.into_iter().chain([dot]).collect()
            }
            Made::Line(_, line) => {
                let paper = self.paper(line.sheet, scales);
                let ghost = paper.map(|paper| Ghost { kind: GhostKind::Line, path: path(&across(line, &paper)) });
                ghost.into_iter().collect()
            }
            Made::Numbers(_) => Vec::new(),
        }
    }
}
