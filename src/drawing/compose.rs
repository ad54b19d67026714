//! How every sheet is composed: a title, panels in their places, items beside and below them.

use super::layout::{Aside, Item, Layout, MARGIN, Needs, layout};
use super::legend;
use super::panel::Panel;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::style::Style;
use super::text::{PlacedText, RichText};
use crate::scene::Scene;
use crate::words::Wording;
use kurbo::{Point, Rect};

/// Size of the title.
pub(super) const TITLE_SIZE: f64 = 5.2;
/// Where its baseline is.
pub(super) const TITLE_LINE: f64 = MARGIN + 5.6;

/// A sheet of panels true to scale, before it is laid out and drawn.
pub(super) struct Composition<'a> {
    pub scene: &'a Scene,
    pub words: Wording,
    pub title: String,
    /// What it shows, in a sentence for those who cannot see it.
    pub description: String,
    /// What is done in each step of the construction.
    pub steps: Vec<String>,
    pub panels: Vec<Panel<'a>>,
    /// What stands beside and below the panels, in drawing order.
    pub items: Vec<Box<dyn Item + 'a>>,
}

impl Composition<'_> {
    /// Height that the items need below the scales, in mm.
    pub(super) fn below(&self) -> f64 {
        self.items.iter().map(|item| item.height()).fold(0.0, f64::max)
    }

    /// The sheet divided up.
    pub(super) fn layout(&self) -> Layout {
        self.layout_above(self.below())
    }

    /// The sheet with so much room below the scales, which stand in as few rows as hold them.
    pub(super) fn layout_above(&self, below: f64) -> Layout {
        let page = self.scene.figure.page.size_mm();
        let needs: Vec<Needs> = self.panels.iter().map(|panel| panel.needs).collect();
        let asides = |room: Rect| -> Vec<Aside> { self.items.iter().flat_map(|item| item.asides(room)).collect() };
        let in_columns =
            |columns: usize| layout(page, &needs, [legend::height(needs.len(), columns), below], columns, asides);
        let fits = |layout: &Layout| legend::fits(layout, &self.words, self.scene.units);
        [3, 2].into_iter().map(in_columns).find(fits).unwrap_or_else(|| in_columns(1))
    }

    /// Draws the sheet as it is laid out.
    pub(super) fn draw(&self, layout: &Layout) -> Drawing {
        let mut drawing = titled(self.scene, &self.words, self.title.clone());
        (drawing.description, drawing.steps) = (self.description.clone(), self.steps.clone());
        for (panel, placed) in self.panels.iter().zip(&layout.panels) {
            panel.draw(&mut drawing, placed, &self.scene.figure.labels);
        }
        for item in &self.items {
            item.draw(&mut drawing, layout);
        }
        drawing
    }
}

/// A sheet of the scene's size and style with nothing but its title.
pub(super) fn titled(scene: &Scene, words: &Wording, title: String) -> Drawing {
    let [width, height] = scene.figure.page.size_mm();
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(scene.figure.style);
    drawing.language = words.language.code;
    drawing.title = title;
    draw_title(&mut drawing);
    drawing
}

/// Writes the title above the panels, smaller where it would not fit.
pub(super) fn draw_title(drawing: &mut Drawing) {
    let title = RichText::verbatim(&drawing.title);
    let room = drawing.width - MARGIN - MARGIN;
    let size = TITLE_SIZE * (room / title.width(TITLE_SIZE)).min(1.0);
    let heading = PlacedText::new(title, size, Point::new(MARGIN, TITLE_LINE));
    drawing.draw(Pen::Heading, Shape::Text(heading));
}
