//! The ways from lengths to rates as a picture: error against time, a colour for each class.

use kinegon::drawing::{Drawing, Pen, PlacedText, Point, Rect, RichText, Shape};
use support::speed_vs_error::routes::{CLASSES, Hardness, Route, Routes};

/// Size of the sheet in mm: that of a slide, 16 to 9.
const SHEET: [f64; 2] = [208.0, 117.0];
/// Where the marks are.
const FRAME: Rect = Rect::new(26.0, 11.0, 198.0, 92.0);
/// Size of text: mm of one em.
const TEXT: f64 = 4.2;
/// Radii of the marks of ordinary mechanisms and of hard ones.
const RADII: [f64; 2] = [1.5, 1.0];

/// Decades of time, in nanoseconds, and of errors; what is smaller stands at the lower edge.
const TIMES: [f64; 2] = [1.0, 8.0];
const ERRORS: [f64; 2] = [-17.0, 0.0];
const BELOW: f64 = -19.0;

fn across(nanoseconds: f64) -> f64 {
    let share = (libm::log10(nanoseconds) - TIMES[0]) / (TIMES[1] - TIMES[0]);
    FRAME.x0 + share * FRAME.width()
}

fn height(decades: f64) -> f64 {
    let share = (decades - (BELOW - 0.8)) / (ERRORS[1] - (BELOW - 0.8));
    FRAME.y1 - share * FRAME.height()
}

fn height_of(error: f64) -> f64 {
    if error > 0.0 { height(libm::log10(error).clamp(ERRORS[0], ERRORS[1])) } else { height(ERRORS[0]) }
}

/// The picture.
pub fn picture(routes: &Routes) -> Drawing {
    let mut drawing = Drawing::new(SHEET[0], SHEET[1]);
    drawing.title = "Error against time, by class and way".into();
    drawing.description = "Largest error of angular velocities and accelerations against the time of one position, \
                           both logarithmic, for tables in f64, one position with a bound, with a proof, and 256 bits."
        .to_owned();
    axes(&mut drawing);
    for route in Route::ALL {
        for (number, class) in CLASSES.into_iter().enumerate() {
            let x = across(routes.times[number][route as usize]);
            for hardness in Hardness::ALL.into_iter().rev() {
                let cells = routes.of(class, hardness).filter(|cell| cell.solved > 0);
                let worst = cells.map(|cell| cell.errors_of((route as usize).min(2))[1]).reduce(f64::max);
                let Some(worst) = worst else { continue };
                let y = if route == Route::Reference { height(BELOW) } else { height_of(worst) };
                mark(&mut drawing, number, Point::new(x, y), hardness == Hardness::Ordinary);
            }
        }
    }
    remarks(&mut drawing, routes);
    legend(&mut drawing);
    drawing
}

fn axes(drawing: &mut Drawing) {
    let (left, right) = (FRAME.x0, FRAME.x1);
    let mut decade = -16.0;
    while decade <= ERRORS[1] {
        let y = height(decade);
        drawing.draw(Pen::Grid, Shape::Line(Point::new(left, y), Point::new(right, y)));
        let number = if decade == 0.0 { "1".to_owned() } else { format!("10^{{{decade}}}").replace('-', "−") };
        ending(drawing, &number, Point::new(left - 1.5, y + 0.33 * TEXT));
        decade += 4.0;
    }
    let y = height(BELOW);
    ending(drawing, "10^{−60}", Point::new(left - 1.5, y + 0.33 * TEXT));
    for power in TIMES[0] as i32..=TIMES[1] as i32 {
        let x = across(libm::exp10(f64::from(power)));
        drawing.draw(Pen::Frame, Shape::Line(Point::new(x, FRAME.y1), Point::new(x, FRAME.y1 + 1.2)));
        let number = ["1", "10", "100"][(power % 3) as usize];
        let label = RichText::plain(&format!("{number} {}", ["ns", "µs", "ms"][(power / 3) as usize]));
        let origin = Point::new(x - 0.5 * label.width(TEXT), FRAME.y1 + 2.0 + TEXT);
        drawing.draw(Pen::Caption, Shape::Text(PlacedText::new(label, TEXT, origin)));
    }
    let Rect { x0, y0, x1, y1 } = FRAME;
    drawing.draw(Pen::Frame, Shape::Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(Point::from).to_vec()));
    let heading = "Largest error of ω and α, as part of the largest, against the time of one position";
    text(drawing, Pen::Heading, heading, Point::new(left - 20.0, 5.6));
}

/// Full for ordinary mechanisms, hollow for hard ones.
fn mark(drawing: &mut Drawing, style: usize, center: Point, ordinary: bool) {
    let (pen, radius) = if ordinary { (Pen::Curve, RADII[0]) } else { (Pen::Dead, RADII[1]) };
    drawing.draw(pen, Shape::Circle { center, radius }).number = Some(style);
}

/// What the marks of a way are and what it is for, over a line as long as classes II to IV take.
fn remarks(drawing: &mut Drawing, routes: &Routes) {
    for route in Route::ALL {
        let says = [
            "f64: curves, films, studies",
            "with a bound of its own rounding",
            "stated bound, proved: all that is printed",
            "256 bits: tests only",
        ][route as usize];
        let y = height([-5.5, -3.4, -5.5, -17.6][route as usize]);
        let times = || routes.times[..3].iter().map(|times| across(times[route as usize])).filter(|x| x.is_finite());
        let (left, right) = (times().fold(f64::INFINITY, f64::min), times().fold(0.0, f64::max));
        drawing.draw(Pen::Construction, Shape::Line(Point::new(left, y), Point::new(right, y)));
        let label = RichText::plain(says);
        let start = left.min(FRAME.x1 - 2.0 - label.width(TEXT));
        drawing.draw(Pen::Label, Shape::Text(PlacedText::new(label, TEXT, Point::new(start, y - 1.6))));
    }
}

fn legend(drawing: &mut Drawing) {
    let y = FRAME.y1 + 13.5;
    for (index, class) in CLASSES.into_iter().enumerate() {
        let x = FRAME.x0 + 34.0 * index as f64;
        mark(drawing, index, Point::new(x, y - 0.33 * TEXT), true);
        let says = if class == "higher" { "higher class".to_owned() } else { format!("class {class}") };
        text(drawing, Pen::Caption, &says, Point::new(x + 3.0, y));
    }
    let key = "full: ordinary mechanisms; hollow: hard for one reason each; each at its worst";
    text(drawing, Pen::Caption, key, Point::new(FRAME.x0 + 3.0, y + 5.8));
}

fn text(drawing: &mut Drawing, pen: Pen, says: &str, origin: Point) {
    let says = RichText::plain(says);
    drawing.draw(pen, Shape::Text(PlacedText::new(says, TEXT, origin)));
}

fn ending(drawing: &mut Drawing, says: &str, end: Point) {
    let says = PlacedText::ending_at(RichText::plain(says), TEXT, end);
    drawing.draw(Pen::Caption, Shape::Text(says));
}
