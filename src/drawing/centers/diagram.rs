//! The circle diagram: links are corners, known centres edges; full ones are permanent, dashed ones are numbered in the order in which lines give
//! them.

use super::CentersOnPaper;
use crate::construction::FigureOf;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::{Anchor, CAPTION, PlacedText, RichText};
use crate::geometry::direction_of_degrees;
use crate::mechanism::BodyId;
use kurbo::{Line, ParamCurveNearest, Point, Rect, Size, Vec2};

/// Radii of the circle that are tried, in mm: the larger ones where there are more corners than in a square, the largest where there are more than in a hexagon.
const RADII: [f64; 8] = [25.0, 21.5, 18.0, 15.5, 13.0, 11.0, 9.0, 7.5];
const FEW: usize = 4;
const MANY: usize = 6;
/// Room for the links' names around it, in mm.
const NAMES: f64 = 4.6;
/// Grid of the places that are tried, in mm.
const STEP: f64 = 2.0;
/// Size of the numbers of edges, in mm of one em.
const SIZE: f64 = 0.85 * CAPTION;

/// Draws the diagram in the free place that is nearest to a corner of the panel; nothing where there is none.
pub(super) fn draw(panel: &CentersOnPaper<'_>, canvas: &mut Canvas<'_>) {
    let links = &panel.centers.links;
    let too_large = match links.len() {
        count if count > MANY => 0,
        count if count > FEW => 2,
        _ => 4,
    };
    let radii = RADII.into_iter().skip(too_large);
    let Some((centre, radius)) =
        radii.into_iter().find_map(|radius| Some((free_place(canvas, radius + NAMES)?, radius)))
    else {
        return;
    };
    let direction = |index: usize| {
        let along = direction_of_degrees(90.0 - 360.0 * index as f64 / links.len() as f64);
        Vec2::new(along.x, -along.y)
    };
    let corner = |link: BodyId| {
        let index = links.iter().position(|other| *other == link).unwrap_or_default();
        centre + direction(index) * radius
    };
    canvas.step = 0;
    for (index, &link) in links.iter().enumerate() {
        let at = centre + direction(index) * radius;
        canvas.draw(Pen::ImagePoint, Shape::Circle { center: at, radius: canvas.dims.dot });
        let name = RichText::math(&panel.context.link_in_index(link));
        write(canvas, name, CAPTION, centre + direction(index) * (radius + 0.55 * NAMES));
    }
    let edges: Vec<[Point; 2]> = { panel.centers.all.iter() }
        .filter(|center| center.figure == FigureOf::Mechanism)
        .map(|center| center.pair.links().map(corner))
        .collect();
    let mut numbers: Vec<Rect> = Vec::new();
    let mut number = 0;
    for (index, center) in panel.centers.all.iter().enumerate() {
        if center.figure != FigureOf::Mechanism {
            continue;
        }
        let [a, b] = center.pair.links().map(corner);
        canvas.step = panel.steps.centers[index];
        if center.is_permanent() {
            canvas.draw(Pen::Frame, Shape::Line(a, b));
            continue;
        }
        number += 1;
        canvas.draw(Pen::Construction, Shape::Line(a, b));
        let text = RichText::plain(&number.to_string());
        let size = text.ink_box(SIZE).size();
        let at = place_of_number([a, b], &edges, &numbers, size);
        numbers.push(Rect::from_center_size(at, size));
        write(canvas, text, SIZE, at);
    }
    canvas.step = 0;
    let room = radius + NAMES;
    canvas.obstacles.add_boxes([Rect::from_center_size(centre, (2.0 * room, 2.0 * room))]);
}

/// The place beside an edge where a number of this size is farthest from other edges and numbers, or as far as need be.
fn place_of_number([a, b]: [Point; 2], edges: &[[Point; 2]], numbers: &[Rect], size: Size) -> Point {
    /// Distance of a number's middle from its edge and from other edges that is enough, and white between two numbers, in mm.
    const BESIDE: f64 = 1.5;
    const FROM_EDGES: f64 = 2.8;
    const FROM_NUMBERS: f64 = 0.8;
    const SHARES: [f64; 21] = [
        0.5, 0.46, 0.54, 0.42, 0.58, 0.38, 0.62, 0.34, 0.66, 0.3, 0.7, 0.26, 0.74, 0.22, 0.78, 0.18, 0.82, 0.14, 0.86,
        0.11, 0.89,
    ];
    let along = (b - a).normalize();
    let beside = Vec2::new(-along.y, along.x) * BESIDE;
    let room = |at: &Point| {
        let others = edges.iter().filter(|edge| **edge != [a, b]);
        let from_edges = others.map(|[c, d]| Line::new(*c, *d).nearest(*at, 1e-6).distance_sq.sqrt());
        let from_edges = from_edges.fold(f64::INFINITY, f64::min) / FROM_EDGES;
        // 1 where white is left beside or between them.
        let apart = |number: &Rect| {
            let (way, sizes) = (number.center() - *at, (number.size() + size) * 0.5);
            (way.x.abs() / (sizes.width + FROM_NUMBERS)).max(way.y.abs() / (sizes.height + FROM_NUMBERS))
        };
        let from_numbers = numbers.iter().map(apart).fold(f64::INFINITY, f64::min);
        // A number over another is worse than one that touches an edge.
        from_edges.min(from_numbers * from_numbers).min(1.0)
    };
    let places = SHARES.into_iter().flat_map(|share| [beside, -beside].map(|beside| a.lerp(b, share) + beside));
    let mut best = (f64::NEG_INFINITY, a.midpoint(b));
    for at in places {
        let own = room(&at);
        if own > best.0 {
            best = (own, at);
        }
    }
    best.1
}

/// Writes a text about a place.
fn write(canvas: &mut Canvas<'_>, text: RichText, size: f64, at: Point) {
    let ink = text.ink_box(size);
    let origin = at - ink.center().to_vec2();
    canvas.draw(Pen::Caption, Shape::Text(PlacedText::new(text, size, origin).anchored(Anchor::Middle)));
}

/// The middle of the free square of this half size that is nearest to a corner of the panel.
fn free_place(canvas: &Canvas<'_>, half: f64) -> Option<Point> {
    let room = canvas.room().inset(-half);
    if room.width() < 0.0 || room.height() < 0.0 {
        return None;
    }
    let corners = [(room.x1, room.y0), (room.x1, room.y1), (room.x0, room.y1), (room.x0, room.y0)];
    let corners = corners.map(|(x, y)| Point::new(x, y));
    let steps = |from: f64, to: f64| {
        let count = ((to - from) / STEP) as usize;
        (0..=count).map(move |k| from + STEP * k as f64)
    };
    let mut all: Vec<(f64, Point)> = Vec::new();
    for x in steps(room.x0, room.x1) {
        for y in steps(room.y0, room.y1) {
            let at = Point::new(x, y);
            let nearest = corners.iter().map(|corner| (*corner - at).hypot()).fold(f64::INFINITY, f64::min);
            all.push((nearest, at));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, at)| at).find(|at| canvas.is_free(*at, half))
}
