//! The sheet of curves: a graph for each kind of quantity, one above the other on a common axis of the drive.

use super::context::{Axis, CurveContext, CurvesError, MOST_CURVES};
use super::graph::{self, BESIDE, Graph};
use crate::cycle::{CertainExtreme, Curve, Curves};
use crate::drawing::grid::Obstacles;
use crate::drawing::held_layout::Pane;
use crate::drawing::labels::{LabelRequest, place};
use crate::drawing::layout::HEADING;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{Anchor, CAPTION, PlacedText, RichText};
use crate::quantity::QuantityKind;
use crate::scene::Scene;
use crate::words::Language;
use kurbo::{Point, Rect, Vec2};

/// Height of the row above the panels with the names of vertical lines, in mm.
const BAND: f64 = 6.6;
/// Height below the panels for the numbers and the name of the drive's axis and the key of the marks, in mm.
const FOOT: f64 = 14.5;
/// White between a panel and the heading of the next, in mm.
const GAP: f64 = 2.0;
/// White beside the graphs for half of the last number of the drive's axis, in mm.
const END: f64 = 5.0;
/// Smallest height of a panel's area, in mm: on paper, and on a part of a screen.
const LOWEST: [f64; 2] = [27.0, 12.0];
/// Largest height, in parts of its width.
const SLENDER: f64 = 0.62;
/// Smallest distance of round values on the drive's axis, in mm.
const APART: f64 = 16.0;
/// Part of the range added beyond a limit, so that its line is off the panel's border.
const BEYOND: f64 = 0.02;

/// The figure of curves over a drive, on the scene's page or on a part of a screen.
///
/// # Errors
/// There are too many panels for a sheet, or too many curves in one panel.
pub fn curves(scene: &Scene, curves: &Curves, pane: Option<Pane>) -> Result<Drawing, CurvesError> {
    let context = CurveContext::new(scene, curves, pane);
    let all = &curves.curves;
    let graphs = graphs(&context, curves)?;
    let numbers = graphs.iter().map(Graph::widest_number).fold(0.0, f64::max);
    let ([width, _], edge) = (context.dims.page, context.dims.free.edge);
    let across = [edge + numbers + BESIDE, width - edge.max(END) - 0.5];
    let drive = Axis::new(context.words, shown_range(&context), across, APART, context.path.drive.is_angle);
    let mut drawing = context.titled(across[1]);
    for (index, graph) in graphs.iter().enumerate() {
        graph.draw(&mut drawing, index, &context, &drive);
    }
    if let (Some(first), Some(last)) = (graphs.first(), graphs.last()) {
        name_verticals(&mut drawing, &context, first.rows[1], &drive);
        foot(&mut drawing, &context, all, last.rows[2], &drive);
    }
    drawing.description = description(&context, &graphs);
    Ok(drawing.enlarged(context.dims.unit))
}

/// The values of the drive at the left and right edges of the graphs that [`curves`] draws.
#[must_use]
pub fn drive_ends(scene: &Scene, curves: &Curves) -> [f64; 2] {
    shown_range(&CurveContext::new(scene, curves, None))
}

/// A graph for each kind of quantity, with its place on the sheet.
fn graphs<'a>(context: &CurveContext<'_>, curves: &'a Curves) -> Result<Vec<Graph<'a>>, CurvesError> {
    let mut kinds: Vec<(QuantityKind, Vec<usize>)> = Vec::new();
    for (index, curve) in curves.curves.iter().enumerate() {
        match kinds.iter_mut().find(|(kind, _)| *kind == curve.kind()) {
            Some((_, members)) => members.push(index),
            None => kinds.push((curve.kind(), vec![index])),
        }
    }
    if let Some((_, members)) = kinds.iter().find(|(_, members)| members.len() > MOST_CURVES) {
        return Err(CurvesError::Crowd { wanted: members.len() });
    }
    let ([width, height], free) = (context.dims.page, context.dims.free);
    let (top, bottom) = (free.top + BAND, height - free.edge - FOOT);
    let lowest = LOWEST[usize::from(!context.dims.has_title())];
    let room = ((bottom - top + GAP) / (HEADING + lowest + GAP)).max(0.0) as usize;
    if kinds.len() > room {
        return Err(CurvesError::Panels { wanted: kinds.len(), room });
    }
    let each = (bottom - top + GAP) / kinds.len() as f64 - HEADING - GAP;
    let each = each.min(SLENDER * (width - 2.0 * free.edge));
    let looks = looks(curves, &kinds);
    // The first panel's heading is above the row of the vertical lines' names.
    let mut y = top - BAND;
    let mut graphs = Vec::new();
    for (index, (kind, members)) in kinds.into_iter().enumerate() {
        let head = HEADING + if index == 0 { BAND } else { 0.0 };
        let rows = [y, y + head, y + head + each];
        let extremes = members.iter().map(|&member| curves.certain_extremes(context.scene, &curves.curves[member]));
        let extremes = extremes.collect();
        let graph_curves = members.into_iter().map(|member| (&curves.curves[member], looks[member]));
        graphs.push(Graph::new(context.words, kind, graph_curves.collect(), extremes, rows));
        y = rows[2] + GAP;
    }
    Ok(graphs)
}

/// By curve: the number of its colour and dash. Curves of one link or point have the same number in all panels, curves
/// of one panel different ones.
fn looks(curves: &Curves, kinds: &[(QuantityKind, Vec<usize>)]) -> Vec<usize> {
    let subject = |index: &usize| curves.curves[*index].asked[0].written.subject();
    // The links and points with curves in more than one panel.
    let mut shared: Vec<String> = Vec::new();
    for (number, (_, members)) in kinds.iter().enumerate() {
        for named in members.iter().map(subject) {
            let again = kinds[number + 1..].iter().any(|(_, other)| other.iter().any(|index| subject(index) == named));
            if again && !shared.contains(&named) {
                shared.push(named);
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
            let wanted = shared.iter().position(|s| *s == subject(&index));
            match free.iter().position(|number| Some(*number) == wanted) {
                Some(place) => take(&mut free, index, place),
                None => later.push(index),
            }
        }
        // Other curves take numbers that are not shared, while there are any.
        for index in later {
            let unshared = free.iter().position(|number| *number >= shared.len());
            take(&mut free, index, unshared.unwrap_or(0));
        }
    }
    numbers
}

/// The range of the motion, with some room beyond limits.
fn shown_range(context: &CurveContext<'_>) -> [f64; 2] {
    let [low, high] = context.range;
    let margin = BEYOND * (high - low);
    let beside = |at: f64| context.verticals().iter().any(|(pen, x)| *pen == Pen::Limit && (x - at).abs() < margin);
    let end = |at: f64, beyond: f64| if beside(at) { at + beyond } else { at };
    [end(low, -margin), end(high, margin)]
}

/// Names the vertical lines above the first panel, where there is room.
fn name_verticals(drawing: &mut Drawing, context: &CurveContext<'_>, y: f64, drive: &Axis) {
    let language = context.words.language;
    let request = |(pen, value): (Pen, f64)| {
        let word = match pen {
            Pen::Limit => language.limit(),
            Pen::Change => language.change(),
            _ => language.scene(),
        };
        let text = RichText::plain(&format!("{word} {}", context.drive_value(value)));
        let (anchor, prefer) = (Point::new(drive.at(value), y), Some(Vec2::new(0.0, -1.0)));
        let request = LabelRequest::new(text, anchor, 0.7, prefer, 1);
        LabelRequest { size: CAPTION, may_stand_apart: false, ..request }
    };
    let requests: Vec<LabelRequest> = context.verticals().into_iter().map(request).collect();
    // All names are on one baseline.
    let edge = context.dims.free.edge;
    let row = Rect::new(edge, y - 0.7 - CAPTION, drawing.width - edge, y);
    for label in place(&requests, &Obstacles::new(row), None).into_iter().flatten() {
        let mut text = label.text;
        text.origin.y = y - 1.4;
        drawing.draw(Pen::Caption, Shape::Text(text));
    }
}

/// Draws numbers and name of the drive's axis, and the key of the marks.
fn foot(drawing: &mut Drawing, context: &CurveContext<'_>, curves: &[Curve], y: f64, drive: &Axis) {
    for (x, number) in drive.numbers() {
        let from = Point::new(x - 0.5 * number.width(CAPTION), y + BESIDE + 3.2);
        let number = PlacedText::new(number, CAPTION, from).anchored(Anchor::Middle);
        drawing.draw(Pen::Caption, Shape::Text(number));
    }
    let baseline = y + FOOT - 1.8;
    // From right to left.
    let mut x = drive.places[1];
    let mut explain = |pen: Pen, radius: f64, what: &str| {
        let text = RichText::plain(what);
        x -= text.width(CAPTION);
        drawing.caption(text, Point::new(x, baseline));
        let center = Point::new(x - 1.8, baseline - 1.3);
        drawing.draw(pen, Shape::Circle { center, radius });
        x -= 7.0;
    };
    if curves.iter().any(|c| !c.dead.is_empty()) {
        explain(Pen::Joint, graph::DEAD, context.words.language.dead_centre());
    }
    if curves.iter().any(|c| !c.extremes.is_empty()) {
        explain(Pen::Pole, graph::DOT, context.words.language.extremes());
    }
    // Centred, or further to the left beside the key.
    let line = context.drive();
    let half = 0.5 * line.width(CAPTION);
    let centre = 0.5 * (drive.places[0] + drive.places[1]);
    let centre = centre.min(x - half).max(context.dims.free.edge + half);
    line.caption(drawing, Point::new(centre, baseline), 0.5);
}

/// Sentences about the figure for readers who cannot see it.
fn description(context: &CurveContext<'_>, graphs: &[Graph<'_>]) -> String {
    let (units, language, drive) = (context.scene.units, context.words.language, &context.path.drive);
    let [from, to] = context.range.map(|value| context.words.number(drive.amount(value)));
    let mut text = language.over(&drive.quantity, &from, &to);
    for graph in graphs {
        let unit = graph.kind.unit(units);
        let value = |found: &CertainExtreme| {
            format!("{} {unit}", context.number(found.value, found.digits(6))).trim_end().to_owned()
        };
        for ((curve, _), extremes) in graph.curves.iter().zip(&graph.extremes) {
            let names = curve.asked.iter().map(|asked| asked.name()).collect::<Vec<_>>().join(" = ");
            if let (Some(_), [Some(constant), _]) = (curve.constant, extremes) {
                let sentence = language.is_constant(&names, &value(constant));
                text.push_str(&format!(" {sentence};"));
                continue;
            }
            let extreme = |greatest: bool, sentence: fn(&Language, &str, &str) -> String, none: &str| match &extremes
                [usize::from(greatest)]
            {
                Some(found) => {
                    let place = drive.amount_within((found.at * 1e4).round() / 1e4, found.within);
                    sentence(language, &value(found), &context.words.number(place))
                }
                None => none.to_owned(),
            };
            let least = extreme(false, Language::least, language.no_least());
            let greatest = extreme(true, Language::greatest, language.no_greatest());
            text.push_str(&format!(" {names}, {least}, {greatest};"));
        }
    }
    text.pop();
    text.push('.');
    text
}
