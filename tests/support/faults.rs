//! What can be wrong with a drawing for its readers: something covers a label or leaves its panel, letters are too small, a file is too large.

use kinegon::drawing::{Drawing, Mark, Pen, Point, Rect, RichText, Shape};

/// Most bytes of a figure's SVG file.
pub const MOST_BYTES: usize = 120_000;
/// Rounding of coordinates on the sheet, in mm.
const ROUNDING: f64 = 1e-9;
/// Least height of small letters in names, headings and captions, in mm; what stands high or low beside them is smaller.
const LEAST_HEIGHT: f64 = 2.0;

pub fn id(mark: &Mark) -> &str {
    mark.id.as_deref().unwrap_or("")
}

/// The boxes of the panels, in drawing order, and the marks drawn in each.
pub fn panels(drawing: &Drawing) -> Vec<(Rect, &[Mark])> {
    let is_frame =
        |mark: &Mark| mark.pen == Pen::Frame && matches!(&mark.shape, Shape::Polygon(corners) if corners.len() == 4);
    let starts: Vec<usize> = (0..drawing.marks.len()).filter(|&index| is_frame(&drawing.marks[index])).collect();
    let ends = starts.iter().skip(1).copied().chain([drawing.marks.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(&start, end)| (drawing.marks[start].shape.bounds(), &drawing.marks[start + 1..end]))
        .collect()
}

fn overlap(a: Rect, b: Rect) -> bool {
    a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1
}

fn within(inner: Rect, outer: Rect) -> bool {
    inner.x0 >= outer.x0 - ROUNDING
        && inner.y0 >= outer.y0 - ROUNDING
        && inner.x1 <= outer.x1 + ROUNDING
        && inner.y1 <= outer.y1 + ROUNDING
}

/// What is wrong with a drawing, in words.
pub fn faults(drawing: &Drawing) -> Vec<String> {
    let mut faults = Vec::new();
    let sheet = Rect::new(0.0, 0.0, drawing.width, drawing.height);
    for mark in &drawing.marks {
        if !mark.shape.is_drawable() {
            faults.push(format!("{mark:?} is not finite"));
        }
        if !within(mark.shape.drawn_box(), sheet) {
            faults.push(format!("{} {:?} leaves the sheet", id(mark), mark.pen));
        }
        if let Shape::Text(text) = &mark.shape {
            let height = -RichText::plain("x").ink_box(text.size).y0;
            if height < LEAST_HEIGHT {
                faults.push(format!("small letters of {} are {height} mm high", text.text.content()));
            }
        }
        if let (Shape::Arrow { from, to, .. }, Some(head)) = (&mark.shape, mark.shape.head()) {
            let along = (*to - *from).normalize();
            let longest = head.iter().map(|&corner| (*to - corner).dot(along));
            let longest = longest.fold(0.0, f64::max);
            if longest > (*to - *from).hypot() {
                faults.push(format!("the head of {} is {longest} mm long", id(mark)));
            }
        }
    }
    let frames = panels(drawing);
    for (index, (frame, _)) in frames.iter().enumerate() {
        if frames[..index].iter().any(|(other, _)| overlap(*frame, *other)) {
            faults.push(format!("the panel {frame:?} lies on another"));
        }
    }
    for (frame, marks) in frames {
        let is_text = |mark: &&Mark| matches!(mark.shape, Shape::Text(_));
        let texts: Vec<&Mark> = marks.iter().filter(is_text).collect();
        // Markers stand along the edges of the sheet.
        for mark in marks.iter().filter(|mark| !matches!(mark.pen, Pen::Marker | Pen::MarkerWhite)) {
            if !within(mark.shape.drawn_box(), frame) {
                faults.push(format!(
                    "{} {:?} {:?} leaves its panel {frame:?}",
                    id(mark),
                    mark.pen,
                    mark.shape.drawn_box()
                ));
            }
        }
        for (index, text) in texts.iter().enumerate() {
            let ink = text.shape.bounds();
            for other in &texts[..index] {
                if overlap(ink, other.shape.bounds()) {
                    faults.push(format!("{} touches {}", id(text), id(other)));
                }
            }
            for mark in marks {
                let heading = text.pen == Pen::Heading;
                let taken = match &mark.shape {
                    Shape::Line(a, b) if heading && matches!(mark.pen, Pen::Construction | Pen::Ray) => {
                        covers(&[*a, *b], ink).then_some(ink)
                    }
                    Shape::Circle { .. } => Some(mark.shape.drawn_box()),
                    Shape::Line(..) if mark.pen == Pen::Hatch => Some(mark.shape.drawn_box()),
                    Shape::Polygon(corners) if mark.pen == Pen::Slider && covers(corners, ink) => Some(ink),
                    _ => mark.shape.head_box(),
                };
                if taken.is_some_and(|taken| overlap(ink, taken)) {
                    faults.push(format!("{} lies on {} {:?}", id(text), id(mark), mark.pen));
                }
            }
        }
    }
    let text = drawing.svg();
    if text.len() > MOST_BYTES {
        faults.push(format!("{} bytes", text.len()));
    }
    if text.contains("NaN") || text.contains("\"inf") {
        faults.push("a number is not finite".to_owned());
    }
    faults
}

/// Whether a convex area and a box have a point in common.
pub fn covers(corners: &[Point], area: Rect) -> bool {
    let box_corners = [
        Point::new(area.x0, area.y0),
        Point::new(area.x1, area.y0),
        Point::new(area.x1, area.y1),
        Point::new(area.x0, area.y1),
    ];
    meet(corners, &box_corners)
}

/// Whether two convex areas have more than an edge in common: no side of either separates them.
pub fn meet(one: &[Point], other: &[Point]) -> bool {
    let separated = |sides: &[Point]| {
        (0..sides.len()).any(|side| {
            let run = sides[(side + 1) % sides.len()] - sides[side];
            let along = |p: &Point| run.cross(*p - sides[side]);
            let span = |of: &[Point]| {
                of.iter()
                    .map(along)
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
            };
            let ((a, b), (c, d)) = (span(one), span(other));
            b <= c || d <= a
        })
    };
    !separated(one) && !separated(other)
}
