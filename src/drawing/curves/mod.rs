//! In: quantities over a cycle, sampled. Out: a sheet with a panel for each kind of quantity, one above the other over the drive's axis.
//! Greatest and least values, dead centres, limits and the scene's own position are marked; every curve bears its name.
//! Nothing of the motion is computed here.

mod axis;
mod hodograph;
mod lines;
mod names;
mod panel;
mod words;

use super::canvas::CAPTION;
use super::labels::{LabelRequest, Obstacles, place};
use super::layout::{HEADING, MARGIN, TITLE};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::style::Style;
use super::text::{Anchor, PlacedText, RichText};
use crate::cycle::{Curves, Happening};
use crate::quantity::Kind;
use crate::scene::Scene;
use crate::words::Wording;
use axis::{Axis, significant};
pub use hodograph::hodographs;
use kurbo::{Point, Rect, Vec2};
use panel::Panel;

/// Height of the row above the panels in which vertical lines are named.
const BAND: f64 = 6.6;
/// Room below the panels: numbers of the drive's axis, what it shows, what the marks are.
const FOOT: f64 = 14.5;
/// White between numbers and their axis.
pub(super) const BESIDE: f64 = 1.6;
/// Between a panel and the heading of the next.
const GAP: f64 = 2.0;
/// No panel's area is lower than this.
const LOWEST: f64 = 27.0;
/// Nor higher than this part of its width.
const SLENDER: f64 = 0.62;
/// Least distance of round values on the drive's axis, in mm.
const APART: f64 = 16.0;
/// The part of the range that is added beyond a limit, so that its line stands off the panel's border.
const BEYOND: f64 = 0.02;

/// How many curves in one panel every style tells apart.
const MOST_CURVES: usize = 12;

/// Why curves do not fit on a sheet.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CurvesError {
    /// More panels than the sheet has room for.
    #[error(
        "{wanted} kinds of quantities need {wanted} panels, and the sheet has room for {room}\n  \
         try: fewer quantities at a time, or another `page` in the scene's figure, as \"a4-portrait\""
    )]
    Panels {
        /// How many there should be.
        wanted: usize,
        /// How many there can be.
        room: usize,
    },
    /// More curves in a panel than can be told apart.
    #[error(
        "{wanted} curves in one panel are more than can be told apart, which is {MOST_CURVES}\n  \
         try: fewer quantities at a time"
    )]
    Crowd {
        /// How many there should be.
        wanted: usize,
    },
}

/// The figure of some curves, on the scene's page.
///
/// # Errors
/// They are too many for a sheet.
pub fn curves(scene: &Scene, curves: &Curves) -> Result<Drawing, CurvesError> {
    let mut kinds: Vec<(Kind, Vec<usize>)> = Vec::new();
    for (index, curve) in curves.curves.iter().enumerate() {
        match kinds.iter_mut().find(|(kind, _)| *kind == curve.kind()) {
            Some((_, members)) => members.push(index),
            None => kinds.push((curve.kind(), vec![index])),
        }
    }
    if let Some((_, members)) = kinds.iter().find(|(_, m)| m.len() > MOST_CURVES) {
        let wanted = members.len();
        return Err(CurvesError::Crowd { wanted });
    }
    let [width, height] = scene.figure.page.size_mm();
    let top = MARGIN + TITLE + BAND;
    let bottom = height - MARGIN - FOOT;
    let room = ((bottom - top + GAP) / (HEADING + LOWEST + GAP)) as usize;
    if kinds.len() > room {
        let wanted = kinds.len();
        return Err(CurvesError::Panels { wanted, room });
    }
    let each = (bottom - top + GAP) / kinds.len() as f64 - HEADING - GAP;
    let each = each.min(SLENDER * (width - 2.0 * MARGIN));
    let sheet = Sheet { scene, words: Wording::of(&scene.figure), curves, numbers: numbers(curves, &kinds) };
    // The first panel's heading stands above the row of the vertical lines' names.
    let mut y = top - BAND;
    let mut panels: Vec<Panel> = Vec::new();
    for (index, (kind, members)) in kinds.into_iter().enumerate() {
        let head = HEADING + if index == 0 { BAND } else { 0.0 };
        let rows = [y, y + head, y + head + each];
        panels.push(Panel::new(&sheet, index, kind, members, rows));
        y = rows[2] + GAP;
    }
    let numbers = panels.iter().map(Panel::widest_number).fold(0.0, f64::max);
    let across = [MARGIN + numbers + BESIDE, width - MARGIN - 0.5];
    let drive = sheet.drive_axis(across);
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(scene.figure.style);
    sheet.title(&mut drawing, across);
    for panel in &panels {
        panel.draw(&sheet, &mut drawing, &drive);
    }
    if let (Some(first), Some(last)) = (panels.first(), panels.last()) {
        sheet.name_verticals(&mut drawing, first.rows[1], &drive);
        sheet.foot(&mut drawing, last.rows[2], &drive);
    }
    drawing.description = words::description(&sheet, &panels);
    Ok(drawing)
}

/// What is drawn, and by which number each curve looks.
pub(super) struct Sheet<'a> {
    scene: &'a Scene,
    words: Wording,
    curves: &'a Curves<'a>,
    /// By curve.
    numbers: Vec<usize>,
}

/// Numbers of the curves' looks: those of one link or point look the same in all panels, those in one panel differ.
fn numbers(curves: &Curves, kinds: &[(Kind, Vec<usize>)]) -> Vec<usize> {
    let subject = |index: &usize| curves.curves[*index].asked[0].subject();
    // The subjects that are in more than one panel.
    let mut shared: Vec<&str> = Vec::new();
    for (number, (_, members)) in kinds.iter().enumerate() {
        for own in members.iter().map(subject) {
            let mut others = kinds[number + 1..].iter();
            let again = others.any(|(_, other)| other.iter().any(|i| subject(i) == own));
            if again && !shared.contains(&own) {
                shared.push(own);
            }
        }
    }
    let mut numbers = vec![0; curves.curves.len()];
    for (_, members) in kinds {
        let mut free: Vec<usize> = (0..MOST_CURVES).collect();
        let mut later = Vec::new();
        let mut take = |free: &mut Vec<usize>, index: usize, place: usize| {
            numbers[index] = free.remove(place);
        };
        for &index in members {
            let own = shared.iter().position(|s| *s == subject(&index));
            match free.iter().position(|number| Some(*number) == own) {
                Some(place) => take(&mut free, index, place),
                None => later.push(index),
            }
        }
        // Others keep off the shared numbers while there are more.
        for index in later {
            let own = free.iter().position(|number| *number >= shared.len());
            take(&mut free, index, own.unwrap_or(0));
        }
    }
    numbers
}

impl Sheet<'_> {
    /// The text that a name is shown by.
    fn shown(&self, name: &str) -> String {
        let renamed = self.scene.figure.labels.get(name);
        renamed.map_or_else(|| crate::construction::display(name), Clone::clone)
    }

    /// A number with that many digits.
    fn number(&self, value: f64, count: usize) -> String {
        self.words.write(value, significant(count))
    }

    /// The axis of the drive's values.
    fn drive_axis(&self, across: [f64; 2]) -> Axis {
        let [low, high] = self.curves.range;
        let margin = BEYOND * (high - low);
        let beside = |at: f64| {
            let mut verticals = self.verticals().into_iter();
            verticals.any(|(pen, x)| pen == Pen::Limit && (x - at).abs() < margin)
        };
        let end = |at: f64, beyond: f64| if beside(at) { at + beyond } else { at };
        let ends = [end(low, -margin), end(high, margin)];
        let turns = self.curves.path.drive.is_angle();
        Axis::new(self.words, ends, across, APART, turns)
    }

    /// The values of the drive that are marked by vertical lines.
    fn verticals(&self) -> Vec<(Pen, f64)> {
        let curves = self.curves;
        let events = curves.events.iter().filter_map(|event| match event.what {
            Happening::Limit { .. } | Happening::Singular { .. } => Some((Pen::Limit, event.at)),
            Happening::Change { .. } => Some((Pen::Change, event.at)),
            _ => None,
        });
        let [low, high] = curves.range;
        let start = curves.path.start();
        let stand = (low..=high).contains(&start).then_some((Pen::Stand, start));
        stand.into_iter().chain(events).collect()
    }

    /// Names the vertical lines above the first panel, as far as there is room.
    fn name_verticals(&self, drawing: &mut Drawing, y: f64, drive: &Axis) {
        const SIZE: f64 = CAPTION;
        let unit = if self.curves.path.drive.is_angle() { "°" } else { "" };
        let language = self.words.language;
        let request = |(pen, value): (Pen, f64)| {
            let word = match pen {
                Pen::Limit => language.limit(),
                Pen::Change => language.change(),
                _ => language.scene(),
            };
            let value_shown = self.number(value, 5);
            LabelRequest {
                text: RichText::plain(&format!("{word} {value_shown}{unit}")),
                size: SIZE,
                anchor: Point::new(drive.at(value), y),
                clearance: 0.7,
                prefer: Some(Vec2::new(0.0, -1.0)),
                priority: 1,
            }
        };
        let requests: Vec<LabelRequest> = self.verticals().into_iter().map(request).collect();
        // One row of letters, all on one line.
        let row = Rect::new(MARGIN, y - 0.7 - SIZE, drawing.width - MARGIN, y);
        let obstacles = Obstacles { boxes: Vec::new(), lines: Vec::new(), bounds: row };
        for label in place(&requests, &obstacles) {
            if !label.crowded {
                let mut text = label.text;
                text.origin.y = y - 1.4;
                drawing.draw(Pen::Caption, Shape::Text(text));
            }
        }
    }

    /// The numbers of the drive's axis, what it shows, and what the marks are.
    fn foot(&self, drawing: &mut Drawing, y: f64, drive: &Axis) {
        for tick in &drive.ticks {
            let text = RichText::plain(&drive.tick(*tick));
            let x = drive.at(*tick) - 0.5 * text.width(CAPTION);
            let text = PlacedText::new(text, CAPTION, Point::new(x, y + BESIDE + 3.2)).anchored(Anchor::Middle);
            drawing.draw(Pen::Caption, Shape::Text(text));
        }
        let baseline = y + FOOT - 1.8;
        // From right to left.
        let mut x = drive.places[1];
        let mut explain = |pen: Pen, radius: f64, what: &str| {
            let text = RichText::plain(what);
            x -= text.width(CAPTION);
            let text = PlacedText::new(text, CAPTION, Point::new(x, baseline));
            drawing.draw(Pen::Caption, Shape::Text(text));
            let center = Point::new(x - 1.8, baseline - 1.3);
            drawing.draw(pen, Shape::Circle { center, radius });
            x -= 7.0;
        };
        let curves = &self.curves.curves;
        if curves.iter().any(|c| !c.dead.is_empty()) {
            explain(Pen::Joint, panel::DEAD, self.words.language.dead_centre());
        }
        if curves.iter().any(|c| !c.extremes.is_empty()) {
            explain(Pen::Pole, panel::DOT, self.words.language.extremes());
        }
        // In the middle, or as far to the left as the marks' words ask.
        let line = words::drive(self);
        let half = 0.5 * line.width(CAPTION);
        let centre = 0.5 * (drive.places[0] + drive.places[1]);
        let centre = centre.min(x - half).max(MARGIN + half);
        line.centred(drawing, Point::new(centre, baseline), CAPTION);
    }

    /// What the figure is called, and how the drives run.
    fn title(&self, drawing: &mut Drawing, across: [f64; 2]) {
        let title = self.scene.title.as_deref().unwrap_or(self.words.language.curves());
        drawing.title = title.to_owned();
        drawing.language = self.words.language.code;
        let y = MARGIN + 5.6;
        let heading = PlacedText::new(RichText::verbatim(title), 5.2, Point::new(MARGIN, y));
        let free = across[1] - heading.text.width(heading.size) - MARGIN - 6.0;
        drawing.draw(Pen::Heading, Shape::Text(heading));
        let speeds = words::speeds(self);
        if speeds.width(CAPTION) <= free {
            speeds.ending(drawing, Point::new(across[1], y), CAPTION);
        }
    }
}
