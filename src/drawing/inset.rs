//! Enlarged detail: a crowd of plan points, drawn larger in a circle beside it.

use super::canvas::{Canvas, Inset, Wanted};
use super::grid::Grid;
use super::labels::LabelRequest;
use super::shape::{Shape, around};
use super::sheet::{Mark, Pen};
use super::text::RichText;
use crate::words::{NumberStyle, Wording};
use kurbo::{Point, Rect, Vec2};
use petgraph::unionfind::UnionFind;
use std::f64::consts::PI;

/// Points closer than this, in mm, belong to one crowd: their names would cover them.
const NEAR: f64 = 2.0;
/// Fewest points of a crowd.
const CROWD: usize = 3;
/// Radii of the circle that are tried, in mm.
const RADII: [f64; 3] = [16.0, 13.0, 10.5];
/// Least white between the enlarged points and the circle round them, in mm.
const AROUND: f64 = 0.8;
/// Radius of the enlarged crowd over that of the circle; the rest is for names.
const FILLED: f64 = 0.62;
/// Factors of enlargement, in rising order.
const FACTORS: [f64; 8] = [2.0, 2.5, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0];
/// White around the circle, in mm.
const APART: f64 = 1.5;
/// Grid of the places that are tried, in mm.
const STEP: f64 = 2.0;

impl Inset {
    /// An enlarged detail for the largest crowd of `places`, in the free place nearest to it; `None` without a crowd or
    /// without room.
    pub(super) fn new(canvas: &Canvas<'_>, places: &[Point]) -> Option<Inset> {
        let places: Vec<Point> = places.iter().copied().filter(|place| canvas.frame.contains(*place)).collect();
        let (crowd, reach) = crowd(&places)?;
        let before = canvas.held.as_ref().and_then(|held| held.before.insets.get(canvas.prefix).copied());
        before.and_then(|before| before.moved(canvas, crowd, reach)).or_else(|| Self::anew(canvas, crowd, reach))
    }

    /// This detail for its crowd that has moved, if it still has its room.
    fn moved(self, canvas: &Canvas<'_>, crowd: Point, reach: f64) -> Option<Inset> {
        let Inset { radius, factor, .. } = self;
        let centre = crowd + (self.centre - self.crowd);
        let room = canvas.room().inset(-(radius + APART));
        let fits = reach * factor <= FILLED * radius && room.contains(centre);
        (fits && canvas.is_free(centre, radius + APART)).then_some(Inset { crowd, centre, ..self })
    }

    fn anew(canvas: &Canvas<'_>, crowd: Point, reach: f64) -> Option<Inset> {
        RADII.into_iter().find_map(|radius| {
            // The circle round the crowd stays within the panel.
            let within = |factor: f64| {
                let room = canvas.frame.inset(-(radius / factor + AROUND));
                Point::new(crowd.x.min(room.x1).max(room.x0), crowd.y.min(room.y1).max(room.y0))
            };
            let fits = |factor: &f64| (reach + (within(*factor) - crowd).hypot()) * factor <= FILLED * radius;
            let factor = FACTORS.into_iter().rfind(fits)?;
            let centre = free_place(canvas, crowd, radius)?;
            let inset = Inset { crowd: within(factor), centre, radius, factor };
            // The circle must not cover what it shows.
            let apart = (centre - crowd).hypot() > radius + inset.shown();
            apart.then_some(inset)
        })
    }

    /// Radius of the enlarged region, on the sheet.
    fn shown(&self) -> f64 {
        self.radius / self.factor
    }

    /// Whether a point is in the enlarged crowd.
    pub(super) fn shows(&self, place: Point) -> bool {
        (place - self.crowd).hypot() < FILLED * self.shown() * 1.001
    }

    /// The enlarged place of a point.
    pub(super) fn at(&self, place: Point) -> Point {
        self.centre + (place - self.crowd) * self.factor
    }

    /// Draws the two circles and the enlarged marks of the crowd.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, words: &Wording) {
        if let Some(held) = &mut canvas.held {
            held.now.insets.insert(canvas.prefix.to_owned(), *self);
        }
        let marks: Vec<Mark> = canvas.marks().iter().filter(|mark| !mark.passing).cloned().collect();
        for mark in &marks {
            for shape in self.enlarged(&mark.shape) {
                canvas.step = mark.since;
                canvas.draw(mark.pen, shape).number = mark.number;
            }
        }
        let first = marks
            .iter()
            .filter(|mark| matches!(mark.shape, Shape::Circle { .. }) && self.shows(mark.shape.bounds().center()));
        let since = first.map(|mark| mark.since).min();
        canvas.step = since.unwrap_or_default();
        canvas.reserve_circle(self.centre, self.radius);
        let small = self.shown().max(FILLED * self.shown() + AROUND);
        for (center, radius) in [(self.crowd, small), (self.centre, self.radius)] {
            for start in [0.0, PI] {
                let half = Shape::Arc { center, radius, start, sweep: PI };
                canvas.draw(Pen::Frame, half);
            }
        }
        let along = (self.centre - self.crowd).normalize();
        let line = Shape::Line(self.crowd + along * small, self.centre - along * self.radius);
        canvas.draw(Pen::Frame, line);
        let text = RichText::plain(&format!("{} : 1", words.write(self.factor, NumberStyle::shortest())));
        // Below the circle, or where there is room beside it.
        let request = LabelRequest::new(text, self.centre, self.radius, Some(Vec2::new(0.0, 1.0)), 1);
        canvas.request_label(Wanted::new("factor".to_owned(), request));
    }

    /// The enlarged parts of a shape in the circle.
    fn enlarged(&self, shape: &Shape) -> Vec<Shape> {
        let within = |(a, b): (Point, Point)| self.within(self.at(a), self.at(b));
        match shape {
            Shape::Line(..) | Shape::Polyline(_) | Shape::Polygon(_) => {
                shape.lines().into_iter().filter_map(within).map(|(a, b)| Shape::Line(a, b)).collect()
            }
            Shape::Arrow { from, to, head } => match within((*from, *to)) {
                Some((from, end)) if (self.at(*to) - end).hypot() < 1e-9 => {
                    vec![Shape::Arrow { from, to: end, head: *head }]
                }
                Some((a, b)) => vec![Shape::Line(a, b)],
                None => Vec::new(),
            },
            Shape::Circle { center, radius } if self.shows(*center) => {
                let (center, radius) = (self.at(*center), *radius);
                vec![Shape::Circle { center, radius }]
            }
            _ => Vec::new(),
        }
    }

    /// The part of a line within the circle.
    fn within(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (from, along) = (a - self.centre, b - a);
        let size = along.hypot2();
        if size == 0.0 {
            return None;
        }
        // Solutions of |from + t along| = radius.
        let middle = -from.dot(along) / size;
        let rest = middle * middle - (from.hypot2() - self.radius * self.radius) / size;
        let half = libm::sqrt(rest.max(0.0));
        let (start, end) = ((middle - half).max(0.0), (middle + half).min(1.0));
        (rest > 0.0 && start < end).then(|| (a + along * start, a + along * end))
    }
}

/// Centre of the largest crowd, and the largest distance of its points from it.
fn crowd(places: &[Point]) -> Option<(Point, f64)> {
    let mut joined = UnionFind::new(places.len());
    let mut grid = Grid::new(around(places));
    for (index, place) in places.iter().enumerate() {
        let near = grid.near(Rect::from_center_size(*place, (2.0 * NEAR, 2.0 * NEAR)));
        for other in near.into_iter().filter(|other| (places[*other] - *place).hypot() < NEAR) {
            joined.union(index, other);
        }
        grid.add(index, Rect::from_points(*place, *place));
    }
    let crowds = joined.into_labeling();
    let mut sizes = vec![0; places.len()];
    crowds.iter().for_each(|crowd| sizes[*crowd] += 1);
    let most = crowds.iter().max_by_key(|crowd| sizes[**crowd]).filter(|crowd| sizes[**crowd] >= CROWD)?;
    let members = places.iter().zip(&crowds).filter(|(_, crowd)| *crowd == most);
    let largest: Vec<Point> = members.map(|(place, _)| *place).collect();
    let middle = around(&largest).center();
    let reach = largest.iter().map(|p| (*p - middle).hypot());
    Some((middle, reach.fold(0.0, f64::max)))
}

/// Centre of the free circle of this radius that is nearest to a point.
fn free_place(canvas: &Canvas<'_>, near: Point, radius: f64) -> Option<Point> {
    let room = canvas.room().inset(-(radius + APART));
    if room.width() < 0.0 || room.height() < 0.0 {
        return None;
    }
    let places = |from: f64, to: f64| {
        let count = ((to - from) / STEP) as usize;
        (0..=count).map(move |k| from + STEP * k as f64)
    };
    let mut all: Vec<Point> =
        places(room.x0, room.x1).flat_map(|x| places(room.y0, room.y1).map(move |y| Point::new(x, y))).collect();
    let distance = |p: &Point| (*p - near).hypot2();
    all.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    all.into_iter().find(|p| canvas.is_free(*p, radius + APART))
}
