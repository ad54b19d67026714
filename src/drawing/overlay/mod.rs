//! A student's drawing over the right figure: where it differs, it has a pen of its own; wrong steps have the accent
//! colour; all else is paler.

mod layer;
#[doc(hidden)] // for tests
pub mod notes;

pub(super) use layer::{OwnLayer, cross};
pub(super) use notes::{Notes, WordsPlace};

use crate::drawing::view::Extent;
use crate::geometry;
use crate::sheet::Sheet;
use crate::text::Untrusted;

/// Largest size of a panel with the student's points over that of its own content: where the scale follows the size,
/// and where the scale is given.
const REACH: [f64; 2] = [2.6, 4.0];

/// The differences of a student's drawing from the right one, and the words about them.
#[derive(Clone, Debug, Default)]
pub struct Overlay {
    /// The student's name.
    pub name: Option<Untrusted>,
    /// Points, marked with crosses.
    pub points: Vec<OwnPoint>,
    /// Lines and vectors.
    pub lines: Vec<OwnLine>,
    /// Wrong steps, in order.
    pub steps: Vec<WrongStep>,
    /// The words below the panels, by paragraph.
    pub words: Vec<String>,
    /// Headings of the table of values.
    pub head: [String; 6],
    /// The student's values.
    pub values: Vec<OwnValue>,
}

/// A point on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnPoint {
    /// Its panel.
    pub panel: Sheet,
    /// The name of the right point that it stands for.
    pub name: String,
    /// Its place, in units of the panel.
    pub at: geometry::Point,
    /// Whether it is labelled: not where it coincides with the right point.
    pub is_named: bool,
}

/// A line on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnLine {
    /// Its panel.
    pub panel: Sheet,
    /// The point to which it leads.
    pub leads_to: String,
    /// Its ends, in units of the panel.
    pub ends: [geometry::Point; 2],
    /// Its kind.
    pub kind: OwnKind,
    /// Its label.
    pub label: Option<String>,
}

/// Kind of a line on a student's sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OwnKind {
    /// A straight line without a head.
    Line,
    /// A vector.
    Vector,
    /// A line that the student has not drawn: it relates another line to the right drawing.
    Helper,
}

/// A wrong step.
#[derive(Clone, Debug)]
pub struct WrongStep {
    /// Its number, from 1.
    pub step: usize,
    /// The panel of its label.
    pub panel: Sheet,
    /// Its label.
    pub label: String,
    /// Of a step that solves for several rates the link with the wrong rate; an empty name for a slide rate, which has
    /// no mark.
    pub link: Option<String>,
}

/// A row of the table of values.
#[derive(Clone, Debug)]
pub struct OwnValue {
    /// Texts of its cells.
    pub cells: [String; 6],
    /// Whether the value is off.
    pub is_off: bool,
}

impl Overlay {
    /// A title with the student's name.
    #[must_use]
    pub fn titled(&self, title: &Untrusted) -> Untrusted {
        self.name.as_ref().map_or_else(|| title.clone(), |name| title.with(name))
    }

    /// A panel's extent with those of the student's points that do not enlarge it too much; `is_given` where the scene
    /// gives the panel's scale.
    pub(in crate::drawing) fn extended(&self, panel: Sheet, content: Extent, is_given: bool) -> Extent {
        let reach = REACH[usize::from(is_given)];
        let mut extent = content;
        for place in self.places(panel) {
            let all = extent.with(place);
            if all.size().norm() <= reach * content.size().norm() {
                extent = all;
            }
        }
        extent
    }

    /// How many of the student's points and ends of lines on a panel are outside of an extent.
    pub(in crate::drawing) fn outside(&self, panel: Sheet, extent: Extent) -> usize {
        self.places(panel).filter(|place| extent.with(*place) != extent).count()
    }

    /// The places of a panel at which the student has something.
    fn places(&self, panel: Sheet) -> impl Iterator<Item = geometry::Point> {
        let points = self.points.iter().filter(move |p| p.panel == panel).map(|p| p.at);
        points.chain(self.lines.iter().filter(move |l| l.panel == panel).flat_map(|l| l.ends))
    }
}
