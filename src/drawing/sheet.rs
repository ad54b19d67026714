use kurbo::{Point, Rect};

use super::grid::Grid;
use super::look::Look;
pub use super::look::Pen;
use super::markers::sheet_code::SheetCode;
use super::shape::Shape;
use super::style::Style;
use super::text::{CAPTION, PlacedText, RichText};
use crate::text::Untrusted;

/// A sheet of paper and everything drawn on it; later marks cover earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// Title of the figure; written into the file, not drawn.
    pub title: Untrusted,
    /// Code of the language of its texts, as in `en`; written into the file, not drawn.
    pub language: &'static str,
    /// One sentence about the figure for readers who cannot see it; written into the file, not drawn.
    pub description: String,
    /// The looks of its marks.
    pub style: Style,
    /// The marks, in drawing order.
    pub marks: Vec<Mark>,
    /// Boxes of the panels, in order, each with its name.
    pub panels: Vec<(String, Rect)>,
    /// Captions of the steps of the construction, in plain text; [`Mark::since`] counts these steps.
    pub steps: Vec<String>,
    /// By panel: the names for which it has no room.
    pub unlabelled: Vec<Unlabelled>,
    /// What its small code says, on a sheet with markers by which a photograph of it is read.
    pub code: Option<SheetCode>,
}

impl Drawing {
    /// An empty sheet of `width` by `height` mm, in the standard style.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            title: Untrusted::default(),
            language: "en",
            description: String::new(),
            style: Style::default(),
            marks: Vec::new(),
            panels: Vec::new(),
            steps: Vec::new(),
            unlabelled: Vec::new(),
            code: None,
        }
    }

    /// Draws a mark without id on top of the others.
    pub fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.add(Mark::new(pen, shape))
    }

    /// Writes a caption from the left end of its baseline; an empty one is no mark.
    pub(super) fn caption(&mut self, text: RichText, from: Point) {
        if !text.runs().is_empty() {
            self.draw(Pen::Caption, Shape::Text(PlacedText::new(text, CAPTION, from)));
        }
    }

    /// Draws a mark with an `id` for slide programs and scripts.
    pub fn draw_named(&mut self, id: impl Into<String>, pen: Pen, shape: Shape) -> &mut Mark {
        self.add(Mark { id: Some(id.into()), ..Mark::new(pen, shape) })
    }

    /// Adds a mark on top of the others.
    pub fn add(&mut self, mark: Mark) -> &mut Mark {
        self.marks.push(mark);
        self.marks.last_mut().expect("a mark was added")
    }

    /// The look of a mark.
    #[must_use]
    pub fn look(&self, mark: &Mark) -> Look {
        let look = self.style.look(mark.pen, mark.number);
        match mark.emphasis {
            // Words are not emphasized.
            _ if matches!(mark.pen, Pen::Caption | Pen::Heading | Pen::Hint) => look,
            Emphasis::Plain => look,
            Emphasis::New => self.style.accented(look),
            Emphasis::Earlier => self.style.calmed(look),
        }
    }

    /// The sheet after a step, from 1: marks of this step in the accent colour, earlier ones paler.
    ///
    /// All marks keep their places. After the last step the figure is finished.
    #[must_use]
    pub fn after_step(&self, step: usize) -> Drawing {
        let shown = self.marks.iter().filter(|mark| mark.is_shown_after(step)).map(|mark| {
            let emphasis = match usize::from(mark.since) {
                0 => Emphasis::Plain,
                _ if step > self.steps.len() => Emphasis::Plain,
                since if since == step => Emphasis::New,
                _ => Emphasis::Earlier,
            };
            Mark { emphasis, ..mark.clone() }
        });
        let words = self.steps.get(step.wrapping_sub(1));
        let unlabelled = self.unlabelled.iter().map(|panel| panel.after_step(step));
        Drawing {
            marks: shown.collect(),
            title: self.title.clone(),
            panels: self.panels.clone(),
            description: words.cloned().unwrap_or_default(),
            style: self.style.clone(),
            steps: Vec::new(),
            unlabelled: unlabelled.filter(|panel| !panel.names.is_empty()).collect(),
            code: self.code.clone(),
            ..*self
        }
    }

    /// How many marks the sheet after a step has.
    #[must_use]
    pub fn marks_after_step(&self, step: usize) -> usize {
        self.marks.iter().filter(|mark| mark.is_shown_after(step)).count()
    }

    /// By mark: whether it is a text that needs its halo, because lines of earlier marks cross it.
    ///
    /// On blank paper a halo is invisible, and on a tinted area it would be a stain.
    pub fn halos(&self) -> Vec<bool> {
        let mut below = Grid::new(Rect::new(0.0, 0.0, self.width, self.height));
        let mut halos = Vec::with_capacity(self.marks.len());
        for (index, mark) in self.marks.iter().enumerate() {
            halos.push(self.needs_halo(mark, &below));
            if self.look(mark).stroke.is_some() {
                match &mark.shape {
                    shape @ (Shape::Line(..) | Shape::Polyline(_) | Shape::Polygon(_) | Shape::Arrow { .. }) => {
                        shape.lines().into_iter().for_each(|line| below.add_line(index, line));
                        shape.head_box().into_iter().for_each(|head| below.add(index, head));
                    }
                    shape => below.add(index, shape.bounds()),
                }
            }
        }
        halos
    }

    /// Whether a mark is a text that lines of the marks below cross.
    fn needs_halo(&self, mark: &Mark, below: &Grid) -> bool {
        let Shape::Text(text) = &mark.shape else {
            return false;
        };
        let halo = self.look(mark).halo;
        let area = text.ink_box().inflate(0.5 * halo, 0.5 * halo);
        let crosses = |shape: &Shape| shape.bounds().overlaps(area) && shape.lines_cross(area);
        halo > 0.0 && below.any(area, |other| crosses(&self.marks[other].shape))
    }
}

/// The names for which a panel has no room.
#[derive(Clone, Debug, PartialEq)]
pub struct Unlabelled {
    /// The panel's name.
    pub panel: String,
    /// The names, in the order of the steps that make them.
    pub names: Vec<UnlabelledName>,
    /// How many rows below the panel's heading their list takes.
    pub rows: usize,
    /// Whether they stand there; else the panel only says that it has no room.
    pub are_listed: bool,
}

/// A name without room.
#[derive(Clone, Debug, PartialEq)]
pub struct UnlabelledName {
    /// The name.
    pub text: RichText,
    /// What it names, on the sheet.
    pub place: Point,
    /// The step of the construction with which it appears, as of a [`Mark`].
    pub since: u16,
}

impl Unlabelled {
    /// Those of the sheet after a step.
    fn after_step(&self, step: usize) -> Unlabelled {
        let names = self.names.iter().filter(|name| usize::from(name.since) <= step);
        Unlabelled { names: names.cloned().collect(), panel: self.panel.clone(), ..*self }
    }
}

/// A mark on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// A stable name such as `point-S3`, unique in its drawing, or none.
    pub id: Option<String>,
    /// The kind of mark, which determines its look.
    pub pen: Pen,
    /// Number of its link or curve, from 0, by which a style picks its colour; none for other marks.
    pub number: Option<usize>,
    /// Its geometry.
    pub shape: Shape,
    /// The step of the construction with which it appears, from 1; 0 for marks of all steps.
    pub since: u16,
    /// Whether it is shown in that step only, as words and hints are.
    pub passing: bool,
    /// The step from which a later mark stands in its place: a name to which another of the same place is added.
    pub until: Option<u16>,
    /// Its emphasis.
    pub emphasis: Emphasis,
}

/// Emphasis of a mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Emphasis {
    /// The look of its pen.
    #[default]
    Plain,
    /// In the accent colour.
    New,
    /// Paler, so that new marks stand out.
    Earlier,
}

impl Mark {
    /// Whether it is on the sheet after a step.
    fn is_shown_after(&self, step: usize) -> bool {
        let since = usize::from(self.since);
        let is_replaced = self.until.is_some_and(|until| usize::from(until) <= step);
        since <= step && !(self.passing && since < step) && !is_replaced
    }

    /// A mark without id, of all steps.
    pub fn new(pen: Pen, shape: Shape) -> Self {
        Self { id: None, pen, number: None, shape, since: 0, passing: false, until: None, emphasis: Emphasis::Plain }
    }
}
