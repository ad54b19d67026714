//! A drawing as a board on a screen shows it: its sheets, what can be pointed at, the numbers beside them, names to choose from.
//! Places are in millimetres of a sheet from its upper left corner, y down, as in its picture.

use super::entry::Entry;
use super::file::{HandDrawing, Snap};
use super::free_hand::FREE;
use super::judge::{BoardError, Judge};
use super::reads::reads;
use super::shown::{Board, BoardEntry, BoardName, BoardRefused, BoardSheet, BoardThing, NUMBERS, NameKind, ThingKind};
use super::table::{DrawnLine, Made, Table, things};
use super::writes::own_drawing;
use crate::construction::Rate;
use crate::drawing::{HandPaper, RichText, SheetLabels};
use crate::format::html_text;
use crate::geometry::Vector;
use crate::mechanism::{GROUND, Mechanism};
use crate::quantity::{QuantityRequest, Spot, What, readable_names, step_names};
use crate::scene::QuantityName;
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::words::{Medium, Wording};
use indexmap::IndexSet;
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;

/// A judge with the papers on which drawings of its scene are shown.
#[derive(Debug)]
pub struct Screen {
    /// The judge.
    pub judge: Judge,
    words: Wording,
    /// Kinegon's own construction, once it is asked for.
    own: OnceCell<Option<HandDrawing>>,
    /// The papers that were asked for last: a hand that moves over a sheet asks again and again.
    papers: RefCell<PerSheet<Option<HandPaper>>>,
}

impl Screen {
    /// A board for the scene of a judge; what it says is in the language of `words`.
    #[must_use]
    pub fn new(judge: Judge, words: Wording) -> Screen {
        Screen { judge, words, own: OnceCell::new(), papers: RefCell::new(PerSheet::from_fn(|_| None)) }
    }

    /// The text of an empty drawing of the scene.
    #[must_use]
    pub fn empty(&self) -> String {
        let scales = self.judge.usual_scales();
        let mut head = serde_json::Map::new();
        head.insert("kinegon_drawing".to_owned(), 1.into());
        for (sheet, mu) in scales.iter().filter(|(sheet, _)| self.shows(*sheet)) {
            head.insert(sheet.facts().scale_key.to_owned(), (*mu).into());
        }
        head.insert("did".to_owned(), serde_json::Value::Array(Vec::new()));
        serde_json::Value::Object(head).to_string() + "\n"
    }

    pub(super) fn language(&self) -> &'static crate::words::Language {
        self.words.language
    }

    /// The language and the notation of what it says.
    #[must_use]
    pub fn words(&self) -> Wording {
        self.words
    }

    /// Kinegon's own construction as a drawing.
    pub(super) fn own(&self) -> Option<&HandDrawing> {
        let write = || HandDrawing::read(&own_drawing(self.judge.given(), &Scales::default())).ok();
        self.own.get_or_init(write).as_ref()
    }

    pub(super) fn shows(&self, sheet: Sheet) -> bool {
        let given = self.judge.given();
        let is_drawn = || given.construction().by_hand.contains(&sheet) && given.has_sheet(sheet);
        sheet == Sheet::Scheme || is_drawn()
    }

    /// The paper of a sheet.
    #[must_use]
    pub fn paper(&self, sheet: Sheet, scales: PerSheet<f64>) -> Option<HandPaper> {
        if !self.shows(sheet) {
            return None;
        }
        let known = self.papers.borrow()[sheet].filter(|paper| paper.mu == scales[sheet]);
        known.or_else(|| {
            // Helping points of the construction have room, too.
            let own = self.own().map(|own| self.judge.drawn(own).0);
            let places: Vec<Vector> = own.iter().flat_map(|table| table.places(sheet)).map(|(_, at)| at).collect();
            let paper = HandPaper::of(&self.judge.given().solution, sheet, scales[sheet], places)?;
            self.papers.borrow_mut()[sheet] = Some(paper);
            Some(paper)
        })
    }

    /// All that a board shows of a drawing; `text` is that of the drawing.
    #[must_use]
    pub fn board(&self, text: String, drawing: &HandDrawing) -> Board {
        let scales = self.judge.scales(drawing);
        let (table, refused) = self.judge.drawn(drawing);
        let makers = self.makers(drawing);
        let papers: Vec<(Sheet, HandPaper)> =
            Sheet::ALL.into_iter().filter_map(|sheet| Some((sheet, self.paper(sheet, scales)?))).collect();
        let labels = SheetLabels::of(&self.judge.given().solution);
        let [given, all] = self.numbers(drawing, &table, &labels, &makers);
        Board {
            drawing: text,
            given,
            sheets: papers.iter().map(|(sheet, paper)| self.sheet(*sheet, paper)).collect(),
            things: self.things(&table, &papers, &makers, &labels),
            numbers: all,
            names: self.names(&table, &labels),
            hand: self.free_hand(drawing),
            free: Screen::free_names(&table),
            did: self.entries(drawing, refused.as_ref()),
            refused: refused.map(|BoardError { entry, message }| BoardRefused {
                entry,
                message: self.words.language.says(&message),
            }),
        }
    }

    fn sheet(&self, sheet: Sheet, paper: &HandPaper) -> BoardSheet {
        let units = self.judge.given().solution.scene.units;
        let mu = self.words.write(paper.mu, NUMBERS);
        let unit = sheet.facts().drawn.unit(units);
        BoardSheet {
            sheet,
            width: paper.size[0],
            height: paper.size[1],
            pole: sheet.order().map(|_| paper.origin),
            scale: format!("1 mm = {mu} {unit}"),
        }
    }

    /// By thing: the entry that made it.
    fn makers(&self, drawing: &HandDrawing) -> BTreeMap<(Option<Sheet>, String), usize> {
        let mut table = Table::new(self.judge.given(), self.judge.scales(drawing));
        let mut makers = BTreeMap::new();
        for (index, stands) in drawing.standing().into_iter().enumerate() {
            if let (true, Ok(made)) = (stands, table.carry_out_by_hand(&drawing.did[index])) {
                things(&made).into_iter().for_each(|thing| {
                    makers.insert(thing, index);
                });
                table.put(made);
            }
        }
        makers
    }

    fn things(
        &self,
        table: &Table<'_>,
        papers: &[(Sheet, HandPaper)],
        makers: &BTreeMap<(Option<Sheet>, String), usize>,
        labels: &SheetLabels<'_>,
    ) -> Vec<BoardThing> {
        let mut all = Vec::new();
        for (sheet, paper) in papers {
            let given = self.judge.given();
            for (name, place) in table.places(*sheet).filter(|(name, _)| !given.is_second_name(*sheet, name)) {
                all.push(BoardThing {
                    sheet: *sheet,
                    kind: ThingKind::Point,
                    name: name.to_owned(),
                    label: self.point_label(*sheet, name, labels),
                    words: name.to_owned(),
                    path: String::new(),
                    at: paper.at(place),
                    entry: makers.get(&(Some(*sheet), name.to_owned())).copied(),
                });
            }
            for (name, line) in table.lines().filter(|(_, line)| line.sheet == *sheet) {
                let ends = across(line, paper);
                all.push(BoardThing {
                    sheet: *sheet,
                    kind: ThingKind::Line,
                    name: name.to_owned(),
                    label: html_text(&RichText::math(&crate::construction::display(name))),
                    words: self.words.language.says(&super::says::drawn_line(name)),
                    path: path(&ends),
                    at: middle(&ends),
                    entry: makers.get(&(None, name.to_owned())).copied(),
                });
            }
        }
        for (sheet, paper) in papers.iter().filter(|(sheet, _)| matches!(sheet, Sheet::Scheme | Sheet::Forces)) {
            let references = if *sheet == Sheet::Scheme { self.references(table) } else { self.corners(table) };
            all.extend(references.into_iter().map(|reference| {
                let ends = reference.ends.map(|end| paper.at(end));
                BoardThing {
                    sheet: *sheet,
                    kind: reference.kind,
                    label: html_text(&RichText::plain(&reference.name.replace(',', ""))),
                    words: self.words.language.says(&reference.words),
                    name: reference.name,
                    path: path(&ends),
                    at: middle(&ends),
                    entry: None,
                }
            }));
        }
        all
    }

    pub(super) fn point_label(&self, sheet: Sheet, name: &str, labels: &SheetLabels<'_>) -> String {
        let mechanism = self.judge.given().mechanism();
        match sheet {
            Sheet::Scheme => html_text(&RichText::math(&crate::construction::display(name))),
            // A joint with the centres that it is.
            Sheet::Centers => {
                let centers =
                    self.judge.given().centers_at(name).map(|pair| labels.place(sheet, &pair.name(mechanism)));
                let centers: Vec<String> = centers.map(|label| html_text(&label)).collect();
                let own = html_text(&labels.place(sheet, name));
                if centers.is_empty() { own } else { format!("{own} = {}", centers.join(", ")) }
            }
            _ => html_text(&labels.place(sheet, name)),
        }
    }

    fn names(&self, table: &Table<'_>, labels: &SheetLabels<'_>) -> Vec<BoardName> {
        let given = self.judge.given();
        let mut all = Vec::new();
        for sheet in Sheet::ALL.into_iter().filter(|sheet| self.shows(*sheet)) {
            for (name, _) in given.places(sheet) {
                let is_made = table.place(sheet, name).is_some();
                let label = self.point_label(sheet, name, labels);
                all.push(BoardName {
                    sheet: Some(sheet),
                    kind: NameKind::Point,
                    name: name.to_owned(),
                    label,
                    is_made,
                    is_turning: false,
                });
            }
        }
        let made: Vec<&str> = table.numbers().map(|(name, _)| name).collect();
        // Where forces are drawn without plans, nobody asks for velocities.
        let construction = given.construction();
        let mut found = if given.polygons.is_empty() { Vec::new() } else { step_names(construction) };
        if given.polygons.is_empty() || construction.draws_plans() {
            found.extend(readable_names(&given.solution));
        }
        let found: IndexSet<String> = found.into_iter().collect();
        for name in found {
            let name = name.trim_end_matches(".size").to_owned();
            let Some(quantity) = QuantityName::parse(&name) else { continue };
            if quantity.component.is_some() || given.given_number(&name).is_some() {
                continue;
            }
            let Ok(asked) = QuantityRequest::new(&name, given.mechanism()) else { continue };
            if is_at_rest(&asked, given.mechanism()) {
                continue;
            }
            let is_made = made.contains(&name.as_str());
            let label = html_text(&labels.quantity(&asked));
            let is_turning = matches!(asked.what, What::Rate(Rate::Angular(..)));
            all.push(BoardName { sheet: None, kind: NameKind::Number, name, label, is_made, is_turning });
        }
        all
    }

    fn entries(&self, drawing: &HandDrawing, refused: Option<&BoardError>) -> Vec<BoardEntry> {
        let stands = drawing.standing();
        let mut table = Table::new(self.judge.given(), self.judge.scales(drawing));
        let language = self.words.language;
        let mut makers = BTreeMap::new();
        let told = |(index, entry): (usize, &Entry)| {
            let mut words = language.says(&entry.told(&self.judge, Medium::Figure));
            let (mut sheet, mut needs) = (None, Vec::new());
            let is_carried_out = stands[index] && refused.is_none_or(|refused| index < refused.entry);
            if let (true, Ok(made)) = (is_carried_out, table.carry_out_by_hand(entry)) {
                match &made {
                    Made::Place(on, ..) => sheet = Some(*on),
                    Made::Line(_, line) => sheet = Some(line.sheet),
                    Made::Numbers(all) => {
                        let unit = |name: &str| self.unit_of(name, Some(entry), &table);
                        let values = all.iter().map(|(name, number)| self.value(*number, &unit(name)));
                        let values: Vec<String> = values.collect();
                        words = format!("{words}: {}", values.join("; "));
                    }
                }
                needs.extend(reads(entry, &table).iter().filter_map(|thing| makers.get(thing).copied()));
                needs.sort_unstable();
                needs.dedup();
                makers.extend(things(&made).into_iter().map(|thing| (thing, index)));
                table.put(made);
            }
            BoardEntry { words, sheet, stands: stands[index], needs }
        };
        drawing.did.iter().enumerate().map(told).collect()
    }

    /// A number as it stands beside the sheets.
    pub(super) fn figures(&self, number: f64) -> String {
        self.words.write(number, NUMBERS).replace('-', "−")
    }

    /// A number with its unit.
    fn value(&self, number: f64, unit: &str) -> String {
        format!("{} {unit}", self.figures(number)).trim_end().to_owned()
    }

    /// The unit of a number by its name; one of the hand's own has that of the sheet on which it was measured, or none.
    pub(super) fn unit_of(&self, name: &str, made_by: Option<&Entry>, table: &Table<'_>) -> String {
        let units = self.judge.given().solution.scene.units;
        match (QuantityName::parse(name), made_by) {
            (Some(name), _) => name.head.kind().unit(units),
            (None, Some(Entry::Measure(measure))) => {
                table.measured_on(measure).map_or_else(|_| String::new(), |sheet| sheet.facts().drawn.unit(units))
            }
            (None, _) => String::new(),
        }
    }

    /// How near a free hand has to be, in words; none where what it draws is exact.
    pub(super) fn free_hand(&self, drawing: &HandDrawing) -> Option<String> {
        let limit = self.judge.tolerance();
        let [mm, degrees] = [limit.mm, limit.degrees].map(|limit| self.words.write(FREE * limit, NUMBERS));
        (drawing.snap != Snap::All).then(|| self.words.language.says(&super::says::free_hand(mm, degrees)))
    }
}

/// Whether a quantity is the motion of a place of the ground, which nobody has to find.
fn is_at_rest(asked: &QuantityRequest, mechanism: &Mechanism) -> bool {
    let What::Motion(_, Spot::Point(body, point, _), None) = &asked.what else { return false };
    [*body, GROUND].iter().all(|fixed| mechanism.body(*fixed).points.contains(point)) || *body == GROUND
}

/// Where a line enters and leaves its sheet, or goes on beyond where it misses it.
pub(super) fn across(line: &DrawnLine, paper: &HandPaper) -> [[f64; 2]; 2] {
    let [x, y] = paper.at(line.at);
    let along = kurbo::Vec2::new(line.along.x, -line.along.y);
    let (at, reach) = (kurbo::Point::new(x, y), 2.0 * (paper.size[0] + paper.size[1]) + x.abs() + y.abs());
    let room = kurbo::Rect::new(0.0, 0.0, paper.size[0], paper.size[1]);
    let clipped = crate::drawing::clip::clipped_segment(room, at - along * reach, at + along * reach);
    let (a, b) = clipped.unwrap_or((at - along, at + along));
    [[a.x, a.y], [b.x, b.y]]
}

/// A straight line as the path of an SVG.
pub(super) fn path(ends: &[[f64; 2]; 2]) -> String {
    let [[a, b], [c, d]] = ends.map(|end| end.map(|mm| libm::round(mm * 100.0) / 100.0));
    format!("M{a} {b}L{c} {d}")
}

pub(super) fn middle([a, b]: &[[f64; 2]; 2]) -> [f64; 2] {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}
