//! What is known of a student's drawing.

use crate::drawing::view::Extent;
use crate::geometry;
use crate::scene::PanelName;

/// A panel grows for the student's points up to so many times the size of its own content: where its scale follows its
/// size, and where the scale is given.
const REACH: [f64; 2] = [1.6, 4.0];
/// What a student's drawing has elsewhere than the right one, and what is to be said of it.
#[derive(Clone, Debug, Default)]
pub struct Overlay {
    /// Whose drawing it is.
    pub name: Option<String>,
    /// Points, marked with crosses.
    pub points: Vec<OwnPoint>,
    /// Lines and vectors.
    pub lines: Vec<OwnLine>,
    /// Steps at which something went wrong, the first one first.
    pub steps: Vec<WrongStep>,
    /// What is said below the panels, a paragraph each.
    pub words: Vec<String>,
    /// What the columns of the table of values show.
    pub head: [String; 6],
    /// The student's values.
    pub values: Vec<OwnValue>,
}

/// A point on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnPoint {
    /// Where it is drawn.
    pub panel: PanelName,
    /// The name of the right point that it stands for.
    pub name: String,
    /// Its place, in units of the panel.
    pub at: geometry::Point,
    /// Whether its name is written beside it: not where it lies on the right point.
    pub is_named: bool,
}

/// A line on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnLine {
    /// Where it is drawn.
    pub panel: PanelName,
    /// The point to which it leads.
    pub leads_to: String,
    /// Its ends, in units of the panel.
    pub ends: [geometry::Point; 2],
    /// What it is.
    pub kind: OwnKind,
    /// What is written beside it.
    pub label: Option<String>,
}

/// What a line on a student's sheet is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OwnKind {
    /// A straight line, without a head.
    Line,
    /// A vector.
    Vector,
    /// Not drawn by the student: it shows what another line has to do with the right drawing.
    Helper,
}

/// A step at which something went wrong.
#[derive(Clone, Debug)]
pub struct WrongStep {
    /// Its number, from 1.
    pub step: usize,
    /// The panel in which it is named.
    pub panel: PanelName,
    /// What is written there.
    pub label: String,
    /// Of a step that solves for several rates the link whose rate is wrong; an empty name for a slide, which has no
    /// mark.
    pub link: Option<String>,
}

/// A row of the table of values.
#[derive(Clone, Debug)]
pub struct OwnValue {
    /// What stands in its cells.
    pub cells: [String; 6],
    /// Whether the value is off.
    pub is_off: bool,
}

impl Overlay {
    /// A panel's extent with the student's points where that does not make everything else small, at a scale that is
    /// given or not.
    pub(in crate::drawing) fn extended(&self, panel: PanelName, own: Extent, is_given: bool) -> Extent {
        let reach = REACH[usize::from(is_given)];
        let points = self.points.iter().filter(|p| p.panel == panel);
        let ends = self.lines.iter().filter(|l| l.panel == panel).flat_map(|l| l.ends);
        let mut extent = own;
        for place in points.map(|p| p.at).chain(ends) {
            let all = Extent::of([extent.low, extent.high, place]);
            if all.size().norm() <= reach * own.size().norm() {
                extent = all;
            }
        }
        extent
    }
}
