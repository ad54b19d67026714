//! What a work sheet has besides the panels: a table of the lengths that a person measures on it, in the order of the construction,
//! and a ruler that shows whether it was printed at 100 %.

use super::canvas::CAPTION;
use super::layout::{Aside, Placed};
use super::legend;
use super::plan_panel::is_hidden;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen};
use super::stages::numbered;
use super::text::{PlacedText, RichText};
use super::view::Extent;
use super::words::significant;
use crate::plan::{Action, Kind, Plan, PlanKind};
use crate::scene::{Panel, Units};
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Height of a row of the table, in mm.
const ROW: f64 = 6.2;
/// Height of the row with what the columns show.
const HEAD: f64 = 7.6;
/// White inside the frame.
const PAD: f64 = 3.0;
/// White between the cells of a row.
pub(super) const GUTTER: f64 = 3.2;
/// Length of the ruler.
const RULER: f64 = 50.0;
/// Room for the ruler with its numbers and words.
const RULER_ROOM: [f64; 2] = [64.0, 18.6];
/// Rows that this takes.
const RULER_ROWS: usize = 3;
/// Rows are not set smaller than this part of their size.
const SMALLEST: f64 = 0.1;
/// The table takes no more than this part of the sheet.
const MOST: f64 = 0.6;

/// A table of measured lengths and a ruler, not yet placed.
pub(super) struct Worksheet {
    pub(super) rows: Vec<Row>,
    pub(super) head: [RichText; CELLS],
    pub(super) ruler: &'static str,
    /// Width of each cell of a row, in mm.
    pub(super) widths: [f64; CELLS],
    /// Whether millimetres and values are left to be filled in.
    pub(super) is_blank: bool,
}

/// Name, millimetres, scale, value, unit.
const CELLS: usize = 5;
/// Which of them end in one line; the others begin in one.
const ENDING: [bool; CELLS] = [false, true, false, true, false];

/// A measured length; on a blank sheet any quantity.
pub(super) struct Row {
    /// The step that measures it.
    pub(super) step: u16,
    pub(super) panel: Panel,
    pub(super) value: f64,
    pub(super) name: RichText,
    pub(super) scale: &'static str,
    pub(super) written: RichText,
    pub(super) unit: RichText,
}

/// How rows stand: in how many columns, how many in each and in the last, and by how much smaller than they should be.
struct Grid {
    columns: usize,
    depth: usize,
    last: usize,
    small: f64,
}

impl Worksheet {
    /// The table for the panels of a figure on a page of this size.
    pub(super) fn new(
        scheme: &Scheme<'_>,
        units: Units,
        extents: &[(Panel, Extent)],
        page: [f64; 2],
    ) -> Self {
        let language = scheme.words.language;
        let rows: Vec<Row> = rows(scheme, units)
            .filter(|row| extents.iter().any(|(panel, _)| *panel == row.panel))
            .collect();
        let plain = RichText::plain;
        let head = [
            plain(language.segment),
            plain("mm"),
            plain("μ"),
            plain(language.value),
            plain(""),
        ];
        let figure = scheme.figure;
        // No panel is larger than the page, so its scale is at least this one.
        let least = |panel: Panel| {
            let given = figure.mu(panel);
            let extent = extents.iter().find(|(p, _)| *p == panel);
            let size = extent.map_or(nalgebra::zero(), |(_, extent)| extent.size());
            given.unwrap_or((size.x / page[0]).max(size.y / page[1]))
        };
        let widest = |row: &Row| {
            let most = millimetres(&scheme.words, row.value, least(row.panel));
            let texts = [
                &row.name,
                &most,
                &symbol(row.scale),
                &row.written,
                &row.unit,
            ];
            texts.map(|text| text.width(CAPTION))
        };
        let mut widths = head.each_ref().map(|text| text.width(CAPTION));
        for row in &rows {
            for (width, own) in widths.iter_mut().zip(widest(row)) {
                *width = width.max(own);
            }
        }
        Self {
            rows,
            head,
            ruler: language.ruler,
            widths,
            is_blank: false,
        }
    }

    /// Width of a row with white on both sides.
    fn column(&self) -> f64 {
        let cells: f64 = self.widths.iter().sum();
        let row = cells + GUTTER * (CELLS - 1) as f64;
        row.max(RULER_ROOM[0]) + 2.0 * PAD
    }

    /// How many columns of rows a width holds, at least one.
    fn columns(&self, width: f64) -> usize {
        let fitting = ((width + 1e-6) / self.column()) as usize;
        fitting.clamp(1, self.rows.len().max(1))
    }

    /// How many rows each of some columns has, where the ruler stands below the last one's.
    fn depth(&self, columns: usize) -> usize {
        (self.rows.len() + RULER_ROWS)
            .div_ceil(columns)
            .max(RULER_ROWS)
    }

    fn height(&self, columns: usize) -> f64 {
        HEAD + ROW * self.depth(columns) as f64 + 2.0 * PAD
    }

    /// The parts of a room that it may take: below everything, or to the right.
    pub(super) fn asides(&self, room: Rect) -> Vec<Aside> {
        let below = self.height(self.columns(room.width()));
        let mut asides = vec![Aside::Below(below.min(MOST * room.height()))];
        let mut columns = 1;
        while columns as f64 * self.column() < MOST * room.width() {
            if self.height(columns) <= room.height() {
                asides.push(Aside::Right(columns as f64 * self.column()));
                break;
            }
            columns += 1;
        }
        asides
    }

    /// How the rows stand in an area: as large as they fit; only far more rows than a sheet has room for are set smaller.
    fn grid(&self, area: Rect) -> Grid {
        let mut small = 1.0;
        loop {
            let columns = self.columns(area.width() / small);
            let rows_in = |height: f64| {
                let rows = (height - 2.0 * PAD - HEAD * small) / (ROW * small) + 1e-6;
                rows.max(0.0) as usize
            };
            let depth = rows_in(area.height());
            let last = rows_in(area.height() - RULER_ROOM[1]).min(depth);
            let fits = depth * (columns - 1) + last >= self.rows.len();
            if fits || small < SMALLEST {
                // The last column has what the others leave, but no column is filled more than need be.
                let even = (self.rows.len() + depth - last).div_ceil(columns);
                let depth = even.min(depth);
                return Grid {
                    columns,
                    depth,
                    last: self.rows.len().saturating_sub(depth * (columns - 1)),
                    small,
                };
            }
            small *= 0.97;
        }
    }

    /// Draws the table in its area, beside these panels.
    pub(super) fn draw(
        &self,
        drawing: &mut Drawing,
        area: Rect,
        panels: &[Placed],
        words: &Wording,
    ) {
        drawing.draw(Pen::Frame, Shape::Polygon(legend::corners(area)));
        let Grid {
            columns,
            depth,
            last,
            small,
        } = self.grid(area);
        let pitch = area.width() / columns as f64;
        let mut left = self.rows.as_slice();
        let mut index = 0;
        for column in 0..columns {
            let x = area.x0 + pitch * column as f64;
            if column > 0 {
                let ends = [area.y0, area.y1].map(|y| Point::new(x, y));
                drawing.draw(Pen::Frame, Shape::Line(ends[0], ends[1]));
            }
            let room = if column + 1 < columns { depth } else { last };
            let (own, later) = left.split_at(room.min(left.len()));
            left = later;
            if own.is_empty() {
                continue;
            }
            let head = Point::new(x + PAD * small, area.y0 + (PAD + 4.2) * small);
            self.row(drawing, head, small, None, self.head.each_ref());
            let y = area.y0 + (PAD + HEAD - 1.6) * small;
            let ends = [x + PAD * small, x + pitch - PAD * small].map(|x| Point::new(x, y));
            drawing.draw(Pen::Grid, Shape::Line(ends[0], ends[1]));
            for (line, row) in own.iter().enumerate() {
                index += 1;
                let below = PAD + HEAD + ROW * line as f64 + 4.0;
                let at = Point::new(head.x, area.y0 + below * small);
                let mu = panels.iter().find(|p| p.panel == row.panel).map(|p| p.mu);
                let mm = match (self.is_blank, mu) {
                    (true, _) => RichText::plain(""),
                    (false, None) => RichText::plain("–"),
                    (false, Some(mu)) => millimetres(words, row.value, mu),
                };
                let cells = [&row.name, &mm, &symbol(row.scale), &row.written, &row.unit];
                self.row(drawing, at, small, Some((index, row)), cells);
                if self.is_blank {
                    self.boxes(drawing, at, small, (index, row));
                }
            }
        }
        let last_column = area.x1 - pitch;
        let from = Point::new(last_column + PAD + 2.0, area.y1 - PAD - RULER_ROOM[1]);
        ruler(drawing, from, self.ruler);
    }

    /// Writes a row from the left end of its baseline; of a measured length with names for its cells and the step that measures it.
    fn row(
        &self,
        drawing: &mut Drawing,
        from: Point,
        small: f64,
        measured: Option<(usize, &Row)>,
        cells: [&RichText; CELLS],
    ) {
        const NAMES: [&str; CELLS] = ["name", "mm", "scale", "value", "unit"];
        let size = CAPTION * small;
        let mut x = from.x;
        for (cell, text) in cells.into_iter().enumerate() {
            let width = self.widths[cell] * small;
            let start = if ENDING[cell] {
                x + width - text.width(size)
            } else {
                x
            };
            x += width + GUTTER * small;
            if text.is_empty() {
                continue;
            }
            let text = PlacedText::new(text.clone(), size, Point::new(start, from.y));
            drawing.add(Mark {
                id: measured.map(|(index, _)| format!("measured-{index}-{}", NAMES[cell])),
                since: measured.map_or(0, |(_, row)| row.step),
                ..Mark::new(Pen::Caption, Shape::Text(text))
            });
        }
    }
}

pub(super) fn symbol(scale: &str) -> RichText {
    RichText::math(scale)
}

/// A value in millimetres of paper at a scale.
fn millimetres(words: &Wording, value: f64, mu: f64) -> RichText {
    let mm = if mu > 0.0 { value / mu } else { 0.0 };
    RichText::plain(&words.number(format!("{mm:.2}")))
}

/// What is measured, and visible, in the order of the construction.
fn rows<'a>(scheme: &'a Scheme<'_>, units: Units) -> impl Iterator<Item = Row> + 'a {
    let figure = scheme.figure;
    let hidden = move |plan: Option<&Plan>, name: &str| match plan {
        Some(plan) => is_hidden(figure, plan, name),
        None => !figure.special_points && scheme.construction.special_point(name).is_some(),
    };
    let row = move |(step, plan, action): (u16, Option<&'a Plan>, &'a Action)| {
        let (from, to, value) = match action {
            Action::MeasureLength { from, to, value } | Action::Measure { from, to, value } => {
                (from, to, *value)
            }
            _ => return None,
        };
        if hidden(plan, from) || hidden(plan, to) {
            return None;
        }
        let (panel, kind, scale) = match plan.map(|plan| plan.kind) {
            None => (Panel::Scheme, Kind::Length, "μ_l"),
            Some(own @ PlanKind::Velocity) => (Panel::Velocity, Kind::Velocity, own.scale_name()),
            Some(own) => (Panel::Acceleration, Kind::Acceleration, own.scale_name()),
        };
        let name = |name: &str| scheme.shown(name, plan);
        let written = scheme.words.number(significant(value));
        Some(Row {
            step,
            panel,
            value,
            name: RichText::math(&format!("{} {}", name(from), name(to))),
            scale,
            written: RichText::plain(&written),
            unit: RichText::plain(&kind.unit(units)),
        })
    };
    let steps = numbered(scheme.construction);
    steps.filter_map(move |(number, plan, step)| row((number, plan, &step.action)))
}

/// A ruler with a stroke for each millimetre, below the words.
fn ruler(drawing: &mut Drawing, from: Point, words: &str) {
    let text = PlacedText::new(RichText::plain(words), CAPTION, from + Vec2::new(0.0, 4.2));
    drawing.draw(Pen::Caption, Shape::Text(text));
    let at = |mm: f64| Point::new(from.x + mm, from.y + 7.4);
    let line = Shape::Line(at(0.0), at(RULER));
    drawing.draw_named("ruler", Pen::Ground, line);
    for mm in 0..=RULER as u32 {
        let long = match mm {
            _ if mm % 10 == 0 => 3.6,
            _ if mm % 5 == 0 => 2.6,
            _ => 1.7,
        };
        let top = at(f64::from(mm));
        let stroke = Shape::Line(top, top + Vec2::new(0.0, long));
        drawing.draw_named(format!("ruler-{mm}"), Pen::Ground, stroke);
        if mm % 10 == 0 {
            let number = RichText::plain(&mm.to_string());
            let x = top.x - 0.5 * number.width(CAPTION);
            let unit = if f64::from(mm) == RULER { " mm" } else { "" };
            let text = RichText::plain(&format!("{mm}{unit}"));
            let place = Point::new(x, top.y + 3.6 + 4.4);
            drawing.draw(
                Pen::Caption,
                Shape::Text(PlacedText::new(text, CAPTION, place)),
            );
        }
    }
}
