//! Error against condition as a picture: positions given on the left, positions from lengths on the right.

use kinegon::drawing::{Drawing, Pen, PlacedText, Point, Rect, RichText, Shape};
use support::speed_vs_error::lengths::{Lengths, WAYS};
use support::speed_vs_error::methods::Method;
use support::speed_vs_error::survey::Survey;

/// Size of the sheet in mm: that of a slide, 16 to 9.
const SHEET: [f64; 2] = [208.0, 117.0];
/// Where the marks are.
const FRAMES: [Rect; 2] = [Rect::new(19.0, 14.0, 103.0, 84.0), Rect::new(120.0, 14.0, 204.0, 84.0)];
/// Size of text: mm of one em.
const TEXT: f64 = 4.0;
const RADIUS: f64 = 0.8;

/// Decades of conditions, by panel, and of errors; no error at all stands at the lower edge, no number at the upper one.
const CONDITIONS: [f64; 2] = [15.0, 6.0];
const ERRORS: [f64; 2] = [-18.0, 2.0];

/// The methods that are shown on the left, those of the right, and their styles: what is in both panels is alike.
const GIVEN: [(Method, usize); 4] =
    [(Method::Naive, 1), (Method::Lu, 2), (Method::Differences, 4), (Method::Library, 0)];
const FROM_LENGTHS: [(usize, usize); 3] = [(2, 2), (1, 3), (0, 0)];

fn place(panel: usize, condition: f64, error: f64) -> Point {
    let frame = FRAMES[panel];
    let share = |x: f64, [low, high]: [f64; 2]| ((x - low) / (high - low)).clamp(0.0, 1.0);
    let decades = if error == 0.0 { ERRORS[0] } else { libm::log10(error.min(1e300)) };
    let across = share(libm::log10(condition), [0.0, CONDITIONS[panel]]);
    Point::new(frame.x0 + across * frame.width(), frame.y1 - share(decades, ERRORS) * frame.height())
}

/// The picture.
pub fn picture(survey: &Survey, lengths: &Lengths) -> Drawing {
    let mut drawing = Drawing::new(SHEET[0], SHEET[1]);
    drawing.title = "Error against condition".into();
    drawing.description = "Errors of velocities and accelerations against the condition number, both logarithmic: \
                           where positions are given, and where they are found from lengths."
        .to_owned();
    for (panel, says) in ["positions given", "positions from lengths"].into_iter().enumerate() {
        axes(&mut drawing, panel, says);
    }
    for (method, style) in GIVEN {
        for row in &survey.rows {
            mark(&mut drawing, style, place(0, row.condition, row.errors[method as usize]));
        }
    }
    for (way, style) in FROM_LENGTHS {
        for reading in lengths.readings() {
            mark(&mut drawing, style, place(1, reading.condition, reading.errors[way]));
        }
    }
    let named = |(method, style): &(Method, usize)| (*style, method.name());
    legend(&mut drawing, FRAMES[0], &GIVEN.iter().rev().map(named).collect::<Vec<_>>());
    let named = |(way, style): &(usize, usize)| (*style, WAYS[*way]);
    legend(&mut drawing, FRAMES[1], &FROM_LENGTHS.iter().rev().map(named).collect::<Vec<_>>());
    text(
        &mut drawing,
        Pen::Heading,
        "Error, of the largest number of its kind, against the condition",
        Point::new(4.0, 5.6),
    );
    drawing
}

fn axes(drawing: &mut Drawing, panel: usize, says: &str) {
    let (frame, most) = (FRAMES[panel], CONDITIONS[panel]);
    let power = |decade: i32| match decade {
        0 => "1".to_owned(),
        _ => format!("10^{{{}{}}}", if decade < 0 { "−" } else { "" }, decade.abs()),
    };
    for decade in [-16, -12, -8, -4, 0] {
        let y = place(panel, 1.0, libm::exp10(f64::from(decade))).y;
        drawing.draw(Pen::Grid, Shape::Line(Point::new(frame.x0, y), Point::new(frame.x1, y)));
        let label = RichText::plain(power(decade).as_str());
        let label = PlacedText::ending_at(label, TEXT, Point::new(frame.x0 - 1.2, y + 0.33 * TEXT));
        drawing.draw(Pen::Caption, Shape::Text(label));
    }
    for decade in [[0, 4, 8, 12], [0, 2, 4, 6]][panel] {
        let x = place(panel, libm::exp10(f64::from(decade)), 1.0).x;
        drawing.draw(Pen::Frame, Shape::Line(Point::new(x, frame.y1), Point::new(x, frame.y1 + 1.2)));
        let label = RichText::plain(power(decade).as_str());
        let origin = Point::new(x - 0.5 * label.width(TEXT), frame.y1 + 2.0 + TEXT);
        drawing.draw(Pen::Caption, Shape::Text(PlacedText::new(label, TEXT, origin)));
    }
    // What rounding the given numbers does, once and twice.
    for (power, name) in [(1, "u·condition"), (2, "u·condition^{2}")].into_iter().take(panel + 1) {
        let top = libm::exp10(most);
        let ends = [1.0, top].map(|condition: f64| place(panel, condition, condition.powi(power) * f64::EPSILON / 2.0));
        drawing.draw(Pen::Construction, Shape::Line(ends[0], ends[1]));
        let end = Point::new(ends[1].x - 1.0, ends[1].y - [4.0, 1.5][panel]);
        let name = PlacedText::ending_at(RichText::plain(name), TEXT, end);
        drawing.draw(Pen::Caption, Shape::Text(name));
    }
    let name = PlacedText::ending_at(RichText::plain("condition"), TEXT, Point::new(frame.x1, frame.y1 + 7.0 + TEXT));
    drawing.draw(Pen::Caption, Shape::Text(name));
    let corners = [(frame.x0, frame.y0), (frame.x1, frame.y0), (frame.x1, frame.y1), (frame.x0, frame.y1)];
    drawing.draw(Pen::Frame, Shape::Polygon(corners.map(Point::from).to_vec()));
    text(drawing, Pen::Caption, says, Point::new(frame.x0 + 1.0, frame.y0 - 1.6));
}

fn mark(drawing: &mut Drawing, style: usize, center: Point) {
    let mark = drawing.draw(Pen::Dead, Shape::Circle { center, radius: RADIUS });
    mark.number = Some(style);
}

fn legend(drawing: &mut Drawing, frame: Rect, entries: &[(usize, &str)]) {
    for (index, (style, says)) in entries.iter().enumerate() {
        let y = frame.y1 + 13.0 + 5.4 * index as f64;
        let mark = drawing.draw(
            Pen::Curve,
            Shape::Circle { center: Point::new(frame.x0 + 1.5, y - 0.33 * TEXT), radius: 1.5 * RADIUS },
        );
        mark.number = Some(*style);
        text(drawing, Pen::Caption, says, Point::new(frame.x0 + 4.5, y));
    }
}

fn text(drawing: &mut Drawing, pen: Pen, says: &str, origin: Point) {
    drawing.draw(pen, Shape::Text(PlacedText::new(RichText::plain(says), TEXT, origin)));
}
