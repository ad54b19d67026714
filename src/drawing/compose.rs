//! Composition of a sheet: a title, panels in their places, items beside and below them; and of further sheets with the
//! table that has no room on it.

use super::canvas::Held;
use super::context::SheetContext;
use super::dims::{Dims, MARGIN, TITLE};
use super::layout::{Item, Layout, Needs, Placed, layout};
use super::lines;
use super::markers::{SheetCode, draw_markers};
use super::panel::Panel;
use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen, Unlabelled};
use super::style::Style;
use super::table::Table;
use super::text::{PlacedText, RichText};
use crate::scene::Figure;
use crate::sheet::Scales;
use crate::text::Untrusted;
use crate::words::Wording;
use kurbo::{Point, Rect};

/// Size of the title, in mm of one em.
pub(super) const TITLE_SIZE: f64 = 5.2;
/// Smallest size of a title on one line beside a marker, in mm of one em.
const SMALL_TITLE: f64 = 4.7;
/// Baselines of a title on two lines, in mm from the upper edge.
const TITLE_LINES: [f64; 2] = [MARGIN + 2.6, MARGIN + 7.2];
/// Baseline of the title, in mm from the upper edge.
pub(super) const TITLE_LINE: f64 = MARGIN + 5.6;

/// Width over height from which a sheet is a slide.
const SLIDE: f64 = 1.6;
/// White between words and the table below them, in mm.
const WORDS_GAP: f64 = 4.0;
/// White above words in their frame, in mm.
const WORDS_TOP: f64 = 1.4;

/// The contents of a sheet, before layout.
pub(super) struct Composition<'a> {
    pub context: &'a SheetContext<'a>,
    pub title: Untrusted,
    /// One sentence about the figure, for readers who cannot see it.
    pub description: String,
    /// Captions of the construction's steps.
    pub steps: Vec<String>,
    /// Whether the sheet is shown step by step; else marks that later ones replace are left out.
    pub is_stepwise: bool,
    pub panels: Vec<Panel<'a>>,
    /// Items beside and below the panels, in drawing order.
    pub items: Vec<Box<dyn Item + 'a>>,
    /// What its small code says, without the panels, on a sheet with markers.
    pub code: Option<SheetCode>,
}

impl<'a> Composition<'a> {
    /// A sheet with these panels alone.
    pub(super) fn new(context: &'a SheetContext<'a>, panels: Vec<Panel<'a>>) -> Self {
        Composition {
            context,
            title: context.title(),
            description: String::new(),
            steps: Vec::new(),
            is_stepwise: false,
            panels,
            items: Vec::new(),
            code: None,
        }
    }

    /// The sheet with an item more, drawn after the others.
    pub(super) fn with(self, item: impl Item + 'a) -> Self {
        self.with_optional(Some(item))
    }

    /// The sheet with an item more, if there is one.
    pub(super) fn with_optional(mut self, item: Option<impl Item + 'a>) -> Self {
        self.items.extend(item.map(|item| Box::new(item) as Box<dyn Item + 'a>));
        self
    }

    /// The sheet with a code of its number in its set and a name, if it has markers.
    pub(super) fn with_code(mut self, number: u16, name: &str) -> Self {
        let Self { context, .. } = self;
        let (page, name) = (context.surface.page, name.to_owned());
        let code = || SheetCode { page, number, scene: context.solution.scene.fingerprint(), panels: Vec::new(), name };
        self.code = context.surface.dims.free.has_markers().then(code);
        self
    }

    /// Height that the items need below the panels, in mm.
    pub(super) fn height_below(&self) -> f64 {
        self.items.iter().map(|item| item.height()).fold(0.0, f64::max)
    }

    /// The layout of the sheet.
    pub(super) fn layout(&self) -> Layout {
        self.layout_above(self.height_below())
    }

    /// The layout with `below` mm of height below the panels.
    pub(super) fn layout_above(&self, below: f64) -> Layout {
        self.layout_for(&self.panels.iter().map(|panel| panel.needs).collect::<Vec<_>>(), below)
    }

    /// The layout with scales by panel.
    pub(super) fn layout_at(&self, scales: &Scales) -> Layout {
        let needs = self.panels.iter().map(|panel| {
            let (Needs { sheet, extent, .. }, mu) = (panel.needs, scales[panel.needs.sheet]);
            let scale = panel.frame.as_ref().map(|frame| frame.scale_width(self.context, (sheet, extent), mu));
            Needs { mu, scale: scale.unwrap_or(panel.needs.scale), ..panel.needs }
        });
        self.layout_for(&needs.collect::<Vec<_>>(), self.height_below())
    }

    fn layout_for(&self, needs: &[Needs], below: f64) -> Layout {
        let surface = &self.context.surface;
        layout(&surface.dims, surface.series, needs, below, &self.items)
    }

    /// Draws the sheet as it is laid out.
    pub(super) fn draw(&self, layout: &Layout) -> Drawing {
        self.draw_panels(layout, |panel, placed, drawing| self.draw_panel(panel, placed, drawing, None))
    }

    /// Draws the sheet with labels where they were held in the picture before, if they can be there.
    pub(super) fn draw_holding(&self, layout: &Layout, held: &mut Held) -> Drawing {
        held.before = std::mem::take(&mut held.now);
        self.draw_panels(layout, |panel, placed, drawing| self.draw_panel(panel, placed, drawing, Some(held)))
    }

    /// Draws the sheet again in another layout: panels that have been drawn in the same places are not drawn anew.
    pub(super) fn draw_again(&self, layout: &Layout, known: &mut Vec<DrawnPanel>) -> Drawing {
        let before = std::mem::take(known);
        self.draw_panels(layout, |panel, placed, drawing| {
            let (first, told) = (drawing.marks.len(), drawing.unlabelled.len());
            match before.iter().find(|drawn| drawn.placed.looks_like(placed)) {
                Some(drawn) => {
                    drawing.panels.push((panel.name.clone(), placed.frame));
                    drawing.marks.extend(drawn.marks.iter().cloned());
                    drawing.unlabelled.extend(drawn.unlabelled.iter().cloned());
                }
                None => self.draw_panel(panel, placed, drawing, None),
            }
            let (marks, unlabelled) = (drawing.marks[first..].to_vec(), drawing.unlabelled[told..].to_vec());
            known.push(DrawnPanel { placed: *placed, marks, unlabelled });
        })
    }

    fn draw_panel(&self, panel: &Panel<'_>, placed: &Placed, drawing: &mut Drawing, held: Option<&mut Held>) {
        panel.draw(drawing, placed, &self.context.figure().labels, &self.context.surface.dims, held);
    }

    fn draw_panels(&self, layout: &Layout, mut draw: impl FnMut(&Panel<'_>, &Placed, &mut Drawing)) -> Drawing {
        let (figure, dims) = (self.context.figure(), &self.context.surface.dims);
        let mut drawing = titled(figure, dims, self.title.clone());
        (drawing.description, drawing.steps) = (self.description.clone(), self.steps.clone());
        for (panel, placed) in self.panels.iter().zip(&layout.panels) {
            draw(panel, placed, &mut drawing);
        }
        if layout.below.height() > 0.0 && self.height_below() > 0.0 {
            drawing.draw(Pen::Frame, Shape::rectangle(layout.below));
        }
        // First what stands below the panels, in the frame that is drawn for it.
        let (below, beside): (Vec<_>, Vec<_>) =
            self.items.iter().enumerate().partition(|(_, item)| item.height() > 0.0);
        for (index, item) in below.into_iter().chain(beside) {
            item.draw(&mut drawing, layout, layout.asides.get(index).copied().flatten());
        }
        if !self.is_stepwise {
            drawing.marks.retain(|mark| mark.until.is_none());
        }
        let mut drawing = drawing.enlarged(dims.unit);
        if let Some(code) = self.code.clone() {
            let panels = self.panels.iter().zip(&layout.panels);
            let panels = panels.map(|(panel, placed)| placed.on_paper(panel.content)).collect();
            draw_markers(&mut drawing, SheetCode { panels, ..code });
        }
        drawing
    }
}

/// A panel as it has been drawn in its place.
pub(super) struct DrawnPanel {
    placed: Placed,
    marks: Vec<Mark>,
    unlabelled: Vec<Unlabelled>,
}

/// An empty sheet in the style and the language of a figure.
pub(super) fn blank(figure: &Figure, [width, height]: [f64; 2], title: Untrusted) -> Drawing {
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(figure.style);
    drawing.language = Wording::of(figure).language.code();
    drawing.title = title;
    drawing
}

/// An empty sheet of a figure with its title, in units of the layout.
pub(super) fn titled(figure: &Figure, dims: &Dims, title: Untrusted) -> Drawing {
    let mut drawing = blank(figure, dims.page, title);
    if dims.has_title() {
        draw_title(&mut drawing, dims.title_line(), dims.free.has_markers());
    }
    drawing
}

/// Writes the title above the panels between two ends of its line, in a smaller size if it is too wide. Beside a marker it
/// is on two lines instead where it is too wide for one, and cut off where it is too long for two; the file has all of it.
fn draw_title(drawing: &mut Drawing, [from, to]: [f64; 2], is_beside_marker: bool) {
    let text = drawing.title.for_comparing().to_owned();
    let fits = |text: &str| RichText::verbatim(text).width(SMALL_TITLE) <= to - from;
    let lines = if is_beside_marker && !fits(&text) {
        let lines = two_lines(&text, fits).map(|line| RichText::verbatim(line.as_str()));
        lines.into_iter().zip(TITLE_LINES).map(|(line, baseline)| (line, SMALL_TITLE, baseline)).collect()
    } else {
        let title = RichText::verbatim(&drawing.title);
        let size = TITLE_SIZE * ((to - from) / title.width(TITLE_SIZE)).min(1.0);
        vec![(title, size, TITLE_LINE)]
    };
    for (line, size, baseline) in lines.into_iter().filter(|(line, ..)| !line.is_empty()) {
        drawing.draw(Pen::Heading, Shape::Text(PlacedText::new(line, size, Point::new(from, baseline))));
    }
}

/// A text in two lines of about the same length, if they fit; else the first as full as it may be, and dots where the second is cut off.
fn two_lines(text: &str, fits: impl Fn(&str) -> bool) -> [String; 2] {
    let spaces = || text.match_indices(' ').map(|(at, _)| at);
    let parted = |at: usize| [&text[..at], &text[at + 1..]];
    let middle = spaces().min_by_key(|at| at.abs_diff(text.len() / 2));
    if let Some(halves) = middle.map(parted).filter(|halves| halves.iter().all(|half| fits(half))) {
        return halves.map(str::to_owned);
    }
    let spaces: Vec<usize> = spaces().collect();
    match spaces[..last_fitting(&spaces, |at| fits(&text[..at]))].last().copied().map(parted) {
        Some([first, second]) => [first.to_owned(), cut_off(second, fits)],
        None => [cut_off(text, fits), String::new()],
    }
}

/// A text, with dots for its end where it does not fit.
fn cut_off(text: &str, fits: impl Fn(&str) -> bool) -> String {
    if fits(text) {
        return text.to_owned();
    }
    let shortened = |at: usize| format!("{}…", text[..at].trim_end());
    let ends: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
    ends[..last_fitting(&ends, |at| fits(&shortened(at)))].last().map_or_else(String::new, |&at| shortened(at))
}

/// How many of the ends of a text, in rising order, fit. Of a long text only a few are tried: more of it is not narrower.
fn last_fitting(ends: &[usize], fits: impl Fn(usize) -> bool) -> usize {
    ends.partition_point(|&at| fits(at))
}

/// Sheets with the figure's title, the lines of words for a sheet of their size, and the table, as many as its rows
/// need; none without words and rows. Portrait unless the rows are too wide.
pub(super) fn further_sheets(
    figure: &Drawing,
    unit: f64,
    words: impl Fn([f64; 2]) -> Vec<RichText>,
    mut table: Table,
) -> Vec<Drawing> {
    let [across, down] = [figure.width, figure.height].map(|side| side / unit);
    let narrow = across.min(down);
    // A slide lies as the others do.
    let is_slide = across > SLIDE * down;
    let [width, height] = match table.column() <= narrow - 2.0 * MARGIN && !is_slide {
        true => [narrow, across.max(down)],
        false => [across, down],
    };
    let area = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN);
    let mut words = words([width, height]);
    let mut sheets = Vec::new();
    while !(table.rows.is_empty() && words.is_empty()) {
        let mut drawing = Drawing::new(width, height);
        (drawing.style, drawing.language) = (figure.style.clone(), figure.language);
        drawing.title.clone_from(&figure.title);
        draw_title(&mut drawing, [MARGIN, width - MARGIN], false);
        let mut left = area;
        if !words.is_empty() {
            let room = Rect { y1: left.y0 + WORDS_TOP + lines::height(words.len()), ..left };
            drawing.draw(Pen::Frame, Shape::rectangle(room));
            lines::draw(&mut drawing, Rect { y0: room.y0 + WORDS_TOP, ..room }, 0, &std::mem::take(&mut words));
            left.y0 = room.y1 + WORDS_GAP;
        }
        if !table.rows.is_empty() {
            let later = table.rows.split_off(table.capacity(left).clamp(1, table.rows.len()));
            table.draw_in(&mut drawing, table.needed(left));
            table.rows = later;
        }
        sheets.push(drawing.enlarged(unit));
    }
    sheets
}
