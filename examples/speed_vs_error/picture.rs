//! The survey as a picture: error against time, a mark for each method and family.

use kinegon::drawing::{Drawing, Pen, PlacedText, Point, Rect, RichText, Shape};
use support::speed_vs_error::document::duration;
use support::speed_vs_error::families::Family;
use support::speed_vs_error::methods::Method;
use support::speed_vs_error::survey::Survey;

/// Size of the sheet in mm: that of a slide, 16 to 9.
const SHEET: [f64; 2] = [208.0, 117.0];
/// Where the marks are.
const FRAME: Rect = Rect::new(30.0, 9.0, 202.0, 84.0);
/// Size of text: mm of one em.
const TEXT: f64 = 4.2;
/// Radii of the marks of random groups and of hard families.
const RADII: [f64; 2] = [1.5, 1.0];

/// Decades of time, in nanoseconds.
const TIMES: [f64; 2] = [1.0, 4.0];

/// Decades of errors, and the height of those without a number.
const ERRORS: [f64; 2] = [-2.0, 16.0];
const NO_NUMBER: f64 = 17.6;

/// Style of a method's marks.
fn style(method: Method) -> usize {
    match method {
        Method::Library | Method::Kernel => 0,
        Method::Naive => 1,
        Method::Lu => 2,
        Method::Single => 3,
        Method::Qr => 4,
        Method::Differences => 5,
    }
}

fn across(nanoseconds: f64) -> f64 {
    let share = (libm::log10(nanoseconds) - TIMES[0]) / (TIMES[1] - TIMES[0]);
    FRAME.x0 + share * FRAME.width()
}

fn height(decades: f64) -> f64 {
    let share = (decades - ERRORS[0]) / (NO_NUMBER + 0.6 - ERRORS[0]);
    FRAME.y1 - share * FRAME.height()
}

fn height_of(units: f64) -> f64 {
    match units.is_finite() {
        true => height(libm::log10(units).clamp(ERRORS[0], ERRORS[1])),
        false => height(NO_NUMBER),
    }
}

/// The picture.
pub fn picture(survey: &Survey, times: &[f64]) -> Drawing {
    let mut drawing = Drawing::new(SHEET[0], SHEET[1]);
    drawing.title = "Error against time".into();
    drawing.description =
        "Errors of velocities and accelerations of fourth-class groups against the time that they take, \
         both logarithmic: a mark for each method and each family of hard groups."
            .to_owned();
    axes(&mut drawing);
    for (method, time) in Method::ALL.into_iter().zip(times) {
        let x = across(*time);
        let errors = Family::ALL.map(|family| (family, survey.worst(family, method)));
        marks(&mut drawing, style(method), x, &errors);
    }
    remarks(&mut drawing, survey, times);
    legend(&mut drawing, times);
    drawing
}

fn axes(drawing: &mut Drawing) {
    let (left, right) = (FRAME.x0, FRAME.x1);
    let mut decade = 0.0;
    while decade <= ERRORS[1] {
        let y = height(decade);
        drawing.draw(Pen::Grid, Shape::Line(Point::new(left, y), Point::new(right, y)));
        let number = match decade as i32 {
            0 => "1".to_owned(),
            power => format!("10^{{{power}}}"),
        };
        ending(drawing, &number, Point::new(left - 1.5, y + 0.33 * TEXT));
        decade += 4.0;
    }
    let y = height(NO_NUMBER);
    drawing.draw(Pen::Construction, Shape::Line(Point::new(left, y), Point::new(right, y)));
    ending(drawing, "no number", Point::new(left - 1.5, y + 0.33 * TEXT));
    for power in TIMES[0] as i32..=TIMES[1] as i32 {
        let time = libm::exp10(f64::from(power));
        tick(drawing, across(time), &duration_tick(power));
    }
    drawing.draw(Pen::Frame, Shape::Polygon(corners()));
    let heading =
        "Largest error in units of u·condition, against the time for velocities and accelerations of one group";
    text(drawing, Pen::Heading, heading, Point::new(left - 24.0, 5.6));
}

fn duration_tick(power: i32) -> String {
    let number = ["1", "10", "100"][(power % 3) as usize];
    format!("{number} {}", ["ns", "µs", "ms"][(power / 3) as usize])
}

fn corners() -> Vec<Point> {
    let Rect { x0, y0, x1, y1 } = FRAME;
    [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(Point::from).to_vec()
}

fn tick(drawing: &mut Drawing, x: f64, label: &str) {
    let bottom = FRAME.y1;
    drawing.draw(Pen::Frame, Shape::Line(Point::new(x, bottom), Point::new(x, bottom + 1.2)));
    let label = RichText::plain(label);
    let origin = Point::new(x - 0.5 * label.width(TEXT), bottom + 2.0 + TEXT);
    drawing.draw(Pen::Caption, Shape::Text(PlacedText::new(label, TEXT, origin)));
}

/// The marks of a method: hollow for hard families, full for random groups, which stand on top.
fn marks(drawing: &mut Drawing, style: usize, x: f64, errors: &[(Family, f64)]) {
    let hard = errors.iter().filter(|(family, _)| *family != Family::Random);
    let random = errors.iter().filter(|(family, _)| *family == Family::Random);
    for (family, units) in hard.chain(random).filter(|(_, units)| !units.is_nan()) {
        let center = Point::new(x, height_of(*units));
        let (pen, radius) = match family {
            Family::Random => (Pen::Curve, RADII[0]),
            _ => (Pen::Dead, RADII[1]),
        };
        let mark = drawing.draw(pen, Shape::Circle { center, radius });
        mark.number = Some(style);
    }
}

/// What is hard for whom: to the right of the marks, or to the left.
fn remarks(drawing: &mut Drawing, survey: &Survey, times: &[f64]) {
    for (method, family, right) in [
        (Method::Naive, Family::Parallel, true),
        (Method::Naive, Family::Far, true),
        (Method::Single, Family::Units, false),
        (Method::Lu, Family::Common, true),
    ] {
        let x = across(times[method as usize]);
        let units = survey.worst(family, method);
        // Beside the mark, but below the line of those without a number.
        let drop = if units.is_finite() { 0.33 } else { 1.1 };
        let y = height_of(units) + drop * TEXT;
        let name = RichText::plain(family.name());
        let name = match right {
            true => PlacedText::new(name, TEXT, Point::new(x + 2.2, y)),
            false => PlacedText::ending_at(name, TEXT, Point::new(x - 2.2, y)),
        };
        drawing.draw(Pen::Label, Shape::Text(name));
    }
}

fn legend(drawing: &mut Drawing, times: &[f64]) {
    let time = |method: Method| duration(times[method as usize]);
    let kinegon = format!("Kinegon: {}; with condition and bounds: {}", time(Method::Kernel), time(Method::Library));
    let named = |method: Method| format!("{}: {}", method.name(), time(method));
    let entries = [
        (style(Method::Kernel), kinegon),
        (style(Method::Naive), named(Method::Naive)),
        (style(Method::Single), named(Method::Single)),
        (style(Method::Lu), named(Method::Lu)),
        (style(Method::Differences), named(Method::Differences)),
        (style(Method::Qr), named(Method::Qr)),
    ];
    for (index, (style, says)) in entries.into_iter().enumerate() {
        let x = [FRAME.x0, FRAME.x0 + 96.0][index % 2];
        let y = FRAME.y1 + 13.5 + 5.8 * (index / 2) as f64;
        let center = Point::new(x, y - 0.33 * TEXT);
        let radius = RADII[0];
        let mark = drawing.draw(Pen::Curve, Shape::Circle { center, radius });
        mark.number = Some(style);
        text(drawing, Pen::Caption, &says, Point::new(x + 3.0, y));
    }
    let y = FRAME.y1 + 13.5 + 5.8 * 3.0;
    let key = "full: random groups; hollow: families of hard ones; each at its worst; f32 in units of f64";
    text(drawing, Pen::Caption, key, Point::new(FRAME.x0 + 3.0, y));
}

fn text(drawing: &mut Drawing, pen: Pen, says: &str, origin: Point) {
    let says = RichText::plain(says);
    drawing.draw(pen, Shape::Text(PlacedText::new(says, TEXT, origin)));
}

fn ending(drawing: &mut Drawing, says: &str, end: Point) {
    let says = PlacedText::ending_at(RichText::plain(says), TEXT, end);
    drawing.draw(Pen::Caption, Shape::Text(says));
}
