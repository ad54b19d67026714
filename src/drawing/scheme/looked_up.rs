//! What the scheme asks of the mechanism again and again, looked up once.

use super::links::{Posed, is_on};
use crate::drawing::grid::Grid;
use crate::drawing::shape::around;
use crate::drawing::view::{Extent, View};
use crate::geometry;
use crate::mechanism::{BodyId, Mark, Mechanism};
use crate::position::Pose;
use kurbo::{Point, Rect};

/// Answers by link and by point.
pub(in crate::drawing) struct LookedUp {
    /// By body: its number among the links, none for the ground and for blocks without name.
    pub numbers: Vec<Option<usize>>,
    /// By point: whether it is a pin.
    pub pins: Vec<bool>,
    /// By point: whether a slider is there.
    pub slides: Vec<bool>,
    /// By point: the bodies that have it.
    pub holders: Vec<Vec<BodyId>>,
    /// The middle of all points.
    pub middle: geometry::Point,
}

impl LookedUp {
    pub(super) fn new(mechanism: &Mechanism, pose: &Pose) -> Self {
        let mut numbers = vec![None; mechanism.bodies.len()];
        for (number, (link, _)) in mechanism.links().enumerate() {
            numbers[link.0] = Some(number);
        }
        let mut pins = vec![false; mechanism.points.len()];
        for mark in mechanism.joints.iter().flat_map(|joint| &joint.marks) {
            if let Mark::Circle { center, .. } = mark {
                pins[center.0] = true;
            }
        }
        let mut slides = vec![false; mechanism.points.len()];
        mechanism.sliders.iter().for_each(|slider| slides[slider.at.0] = true);
        let extent = Extent::of(pose.points.iter().copied());
        let middle = nalgebra::center(&extent.low, &extent.high);
        Self { numbers, pins, slides, holders: mechanism.holders(), middle }
    }
}

/// The straight lines of all links as a view shows them, in the order of the links.
pub(in crate::drawing) struct LinkLines {
    pub(super) view: View,
    lines: Vec<[Point; 2]>,
    grid: Grid,
}

impl LinkLines {
    pub(super) fn new(posed: &Posed<'_>, view: &View) -> Self {
        let links = posed.mechanism.links();
        let lines: Vec<[Point; 2]> = links.flat_map(|(id, _)| posed.shape(view, id).lines()).collect();
        let ends: Vec<Point> = lines.as_flattened().to_vec();
        let mut grid = Grid::new(around(&ends));
        for (index, [from, to]) in lines.iter().enumerate() {
            grid.add_line(index, (*from, *to));
        }
        Self { view: *view, lines, grid }
    }

    /// The lines on which a point is, to the reader's eye.
    pub(super) fn at(&self, point: Point) -> Vec<[Point; 2]> {
        let area = Rect::from_center_size(point, (1.0, 1.0));
        let near = self.grid.near(area).into_iter().map(|index| self.lines[index]);
        near.filter(|ends| is_on(*ends, point)).collect()
    }
}

/// Points on the sheet, and which of them are near a place.
pub(super) struct Near {
    points: Vec<Point>,
    grid: Grid,
}

impl Near {
    /// No points yet, on the sheet around an area.
    pub(super) fn new(area: Rect) -> Self {
        Self { points: Vec::new(), grid: Grid::new(area) }
    }

    /// Adds a point.
    pub(super) fn add(&mut self, point: Point) {
        self.grid.add(self.points.len(), Rect::from_points(point, point));
        self.points.push(point);
    }

    /// The distance of the nearest point, if it is at most `most`.
    pub(super) fn distance(&self, place: Point, most: f64) -> Option<f64> {
        let area = Rect::from_center_size(place, (2.0 * most, 2.0 * most)).inflate(1e-6, 1e-6);
        let near = self.grid.near(area).into_iter().map(|index| (self.points[index] - place).hypot());
        near.filter(|distance| *distance <= most).reduce(f64::min)
    }
}
