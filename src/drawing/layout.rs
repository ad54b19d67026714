//! Division of a sheet into panels with scales, an area without panels, and one for words below.

use super::dims::Dims;
use super::division::{Best, Division, Sharing};
use super::sheet::Drawing;
use super::view::{Extent, Series};
use crate::geometry;
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::{Affine, Rect};

/// White between panels, in mm.
pub(super) const GAP: f64 = 4.0;
/// White inside a panel around its content, for labels, in mm: around a plan, and around the scheme, where the feet of
/// pivots stand in it.
const WHITE: [f64; 2] = [4.8, 6.4];
/// That white where scales have steps, which mostly leave more: heads, dots and the feet of pivots reach so far beyond
/// their points.
const LEAST_WHITE: [f64; 2] = [2.2, 6.2];
/// Height of a panel's heading, in mm.
pub(super) const HEADING: f64 = 7.2;
/// Height of a row below it, as of its scale where that is not beside it, in mm.
pub(super) const ROW: f64 = 6.0;
/// Rounding of sizes on paper, in mm.
const ROUNDING: f64 = 1e-6;
/// Smallest width and height of a panel's content area, in mm.
pub(super) const LEAST: f64 = 20.0;
/// Width and height of an area in which a content is well seen with its names, in mm.
const ROOMY: f64 = 55.0;
/// Loss where a companion stands above the panel in focus, or below it, on a sheet wider than high: more than any
/// gain, so that it does only where it has no room beside.
const STACKED: f64 = 1000.0;
/// How much coarser a scale may be for a list of results: less than what is seen at a glance.
const COST: f64 = 1.2;
/// Difference of the logarithms of scales that makes no difference to the eye.
const ALIKE: f64 = 0.02;

/// The room that a panel needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Needs {
    /// The sheet of the construction that it shows.
    pub sheet: Sheet,
    /// Extent of the content, in units of what is drawn on that sheet.
    pub extent: Extent,
    /// Width of its heading, in mm.
    pub heading: f64,
    /// Width of its scale at its narrowest, in mm; 0 where none is written.
    pub scale: f64,
    /// Further white between heading and content, in mm.
    pub above: f64,
    /// Further white below the content, in mm.
    pub below: f64,
    /// Rows below the heading for the names that have no room.
    pub rows: usize,
    /// The scale that is given, in units per mm of paper.
    pub mu: Option<f64>,
    /// White around its content inside the panel, for labels, in mm.
    pub white: f64,
    /// How much the size of its content counts among the panels.
    pub weight: f64,
    /// Whether it shows a part of a plan: what is cut off is no news, and the pole need not be in sight.
    pub is_part: bool,
}

/// How much the size of the figure of centres counts beside that of another panel.
const OF_CENTERS: f64 = 2.0;

impl Needs {
    /// Those of a panel with the usual white, at a scale that fits.
    pub(super) fn usual(sheet: Sheet, extent: Extent, heading: f64) -> Needs {
        let white = WHITE[usize::from(sheet.order().is_none())];
        let weight = Needs::weight_of(sheet);
        Needs {
            sheet,
            extent,
            heading,
            scale: 0.0,
            above: 0.0,
            below: 0.0,
            rows: 0,
            mu: None,
            white,
            weight,
            is_part: false,
        }
    }

    /// How much the size of a sheet's content counts beside that of others: the figure of centres shows what the scheme shows, with lines and names among it.
    pub(super) fn weight_of(sheet: Sheet) -> f64 {
        if sheet == Sheet::Centers { OF_CENTERS } else { 1.0 }
    }

    /// These at scales with steps, of which most leave more white than labels need.
    pub(super) fn tight(self) -> Needs {
        Needs { white: LEAST_WHITE[usize::from(self.sheet.order().is_none())], ..self }
    }

    /// Width and height of the content, in units of what is drawn.
    pub(super) fn size(&self) -> [f64; 2] {
        let Extent { low, high } = self.extent;
        [high.x - low.x, high.y - low.y]
    }

    /// The scale where the content does not ask for one: that which is given, or any for a single point.
    pub(super) fn fixed(&self) -> Option<f64> {
        let [width, height] = self.size();
        let is_nothing = !(width.max(height) > 0.0 && (width + height).is_finite());
        self.mu.or(is_nothing.then_some(1.0))
    }

    /// Least width of the frame, in mm.
    pub(super) fn least_width(&self) -> f64 {
        self.heading.max(self.scale).max(LEAST + 2.0 * self.white)
    }

    /// Whether the scale stands below the heading in a frame of some width in mm, and not beside it.
    pub(super) fn is_scale_below(&self, width: f64) -> bool {
        self.heading + self.scale > width + ROUNDING
    }

    /// Height above the content in a frame of some width, in mm: heading and scale, and white below them.
    pub(super) fn header(&self, width: f64) -> f64 {
        self.heading_height(width) + self.above + (self.white - 1.0).max(LEAST_WHITE[0])
    }

    /// Height of heading, scale and rows of names in a frame of some width, in mm.
    pub(super) fn heading_height(&self, width: f64) -> f64 {
        HEADING + ROW * (self.rows + usize::from(self.is_scale_below(width))) as f64
    }

    /// Least width and height of the frame at a scale in units per unit of the layout, in mm: as narrow as it may be, or wide
    /// enough for the scale beside the heading.
    pub(super) fn frame(&self, mu: f64, is_wide: bool) -> [f64; 2] {
        let size = self.size().map(|size| size / mu);
        let beside = if is_wide { self.heading + self.scale } else { 0.0 };
        let width = (size[0] + 2.0 * self.white).max(self.least_width()).max(beside);
        [width + ROUNDING, self.header(width) + size[1] + self.white + self.below + ROUNDING]
    }

    /// The finest scale at which the content fits into a frame, in units per unit of the layout.
    pub(super) fn fitting(&self, [width, height]: [f64; 2]) -> f64 {
        let size = self.size();
        let room =
            [width - 2.0 * self.white, height - self.header(width) - self.white - self.below].map(|room| room.max(0.1));
        (size[0] / room[0]).max(size[1] / room[1])
    }
}

/// A panel's place on a sheet of paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub needs: Needs,
    pub frame: Rect,
    /// The area of its content.
    pub area: Rect,
    /// Its scale, in units per mm of paper.
    pub mu: f64,
    /// A unit of the layout, in mm of paper.
    pub unit: f64,
}

impl Placed {
    /// Whether a panel looks the same in two places: how its scale came about does not matter.
    pub(super) fn looks_like(&self, other: &Placed) -> bool {
        let seen = |Placed { needs, frame, area, mu, unit }: Placed| {
            let heading = (needs.is_scale_below(frame.width()), needs.rows, needs.is_part);
            (needs.sheet, needs.extent, heading, frame, area, mu, unit)
        };
        seen(*self) == seen(*other)
    }

    /// A panel in a frame at a scale.
    fn new(needs: &Needs, frame: Rect, mu: f64, unit: f64) -> Placed {
        let inner = frame.inset(-needs.white);
        let area = Rect { y0: frame.y0 + needs.header(frame.width()), y1: inner.y1 - needs.below, ..inner };
        Placed { needs: *needs, frame, area, mu, unit }
    }

    /// A panel in a frame with this area for its content, at its scale or else at the finest of a series at which that fits.
    pub(super) fn with_area(needs: &Needs, [frame, area]: [Rect; 2], unit: f64, series: Series) -> Placed {
        let on_paper = Affine::scale(unit).transform_rect_bbox(area);
        let mu = needs.mu.unwrap_or_else(|| series.fitting(&needs.extent, on_paper));
        Placed { needs: *needs, frame, area, mu, unit }
    }

    /// Width and height of something in the panel, in units of the layout.
    pub(super) fn shown(&self, extent: &Extent) -> geometry::Vector {
        extent.size() / (self.mu * self.unit)
    }

    /// Whether something fits into the area of the panel's content.
    pub(super) fn holds(&self, extent: &Extent) -> bool {
        let (size, area) = (self.shown(extent), self.area.inflate(2.0 * ROUNDING, 2.0 * ROUNDING));
        size.x <= area.width() && size.y <= area.height()
    }

    /// Size of the content on paper, whether it fits or not.
    pub(super) fn size(&self) -> f64 {
        self.shown(&self.needs.extent).norm()
    }

    /// The room for its content over the size of that.
    fn ease(&self) -> f64 {
        let (size, area) = (self.shown(&self.needs.extent), self.area);
        (area.width() / size.x).min(area.height() / size.y)
    }
}

/// An area of the sheet without panels, for a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aside {
    /// Between panels and words, of this height in mm.
    Below(f64),
    /// To the right of the panels, of this width in mm.
    Right(f64),
}

/// Something on a sheet beside or below its panels.
pub(super) trait Item {
    /// Height that it needs below the panels, in mm.
    fn height(&self) -> f64 {
        0.0
    }

    /// The areas beside the panels that it can be drawn in.
    fn asides(&self, _room: Rect) -> Vec<Aside> {
        Vec::new()
    }

    /// Draws it below the panels, or in its own area beside them, if it has one.
    fn draw(&self, drawing: &mut Drawing, layout: &Layout, aside: Option<Rect>);
}

/// Frames of all parts of a sheet.
#[derive(Clone)]
pub(super) struct Layout {
    /// The area below the panels.
    pub below: Rect,
    /// By item its own area beside the panels, if it has one.
    pub asides: Vec<Option<Rect>>,
    pub panels: Vec<Placed>,
    /// Its quality, compared element by element: whether all panels have room for their headings and for a content, how
    /// many contents fit, and how large they are.
    pub worth: [f64; 3],
}

impl Layout {
    /// The area beside the panels on a sheet on which only one item can have one.
    pub(super) fn aside(&self) -> Option<Rect> {
        self.asides.iter().flatten().next().copied()
    }

    /// Whether all panels have room for their contents.
    pub(super) fn holds_all(&self) -> bool {
        self.worth[1] as usize == self.panels.len()
    }

    /// Whether they are wide enough for their headings and for a content, too.
    pub(super) fn shows_all(&self) -> bool {
        self.worth[0] > 0.0 && self.holds_all()
    }

    /// Whether the contents of all panels have room for names, and are not dots.
    pub(super) fn is_roomy(&self) -> bool {
        self.panels.iter().all(|placed| placed.area.width().min(placed.area.height()) >= ROOMY)
    }

    /// Whether no scale is much coarser than the one that is chosen for its sheet.
    pub(super) fn is_nearly_at(&self, chosen: &Scales) -> bool {
        self.costs_at_most(COST, chosen)
    }

    /// Whether no scale is more than so many times coarser than the one that is chosen for its sheet.
    pub(super) fn costs_at_most(&self, cost: f64, chosen: &Scales) -> bool {
        chosen.given().all(|(sheet, mu)| self.mu_of(sheet) <= Some(cost * mu))
    }

    /// The place of the panel of a sheet.
    pub(super) fn placed(&self, sheet: Sheet) -> Option<&Placed> {
        self.panels.iter().find(|placed| placed.needs.sheet == sheet)
    }

    /// The scale of the panel of a sheet, in units per mm.
    pub(super) fn mu_of(&self, sheet: Sheet) -> Option<f64> {
        self.placed(sheet).map(|placed| placed.mu)
    }

    /// The scales of the panels, in units per mm.
    pub(super) fn mu(&self) -> Scales {
        PerSheet::from_fn(|sheet| self.mu_of(sheet))
    }
}

/// Divides a sheet so that the panels' contents are largest at scales of a series: in every way, with each area that an item may have beside
/// them. `below` mm of height are for words below the panels.
///
/// First comes that headings have room, then how many contents fit, then how large they are; of divisions with which
/// they are alike, the one that leaves most room to the panel that has least.
pub(super) fn layout(dims: &Dims, series: Series, needs: &[Needs], below: f64, items: &[Box<dyn Item + '_>]) -> Layout {
    let words = if below > 0.0 { below + GAP } else { 0.0 };
    let ([width, height], free) = (dims.page, dims.free);
    let bottom = height - free.edge - words.max(if free.corner > 0.0 { free.corner + GAP } else { 0.0 });
    let whole = Rect::new(free.edge, free.top, width - free.edge, bottom);
    // The areas of two items are cut off one after the other, so that none is drawn in another's.
    let mut rooms: Vec<(Rect, Vec<Option<Rect>>)> = vec![(whole, Vec::new())];
    for item in items {
        let with_own = |(room, others): &(Rect, Vec<Option<Rect>>)| {
            let asides = item.asides(*room).into_iter().map(|aside| cut_off(*room, aside));
            let mut rooms: Vec<(Rect, Option<Rect>)> = asides.collect();
            if rooms.is_empty() {
                rooms.push((*room, None));
            }
            let joined = |(room, own): (Rect, Option<Rect>)| (room, others.iter().copied().chain([own]).collect());
            rooms.into_iter().map(joined).collect::<Vec<_>>()
        };
        rooms = rooms.iter().flat_map(with_own).collect();
    }
    let sharing = Sharing { needs, unit: dims.unit, series };
    let has_companion = needs.iter().any(|needs| needs.weight < 1.0);
    let divisions = if needs.is_empty() { Vec::new() } else { Division::all(needs.len()) };
    let mut best: Option<Layout> = None;
    for (room, asides) in rooms {
        for division in &divisions {
            let Best { mu, wide, mut loss } = sharing.best(division, [room.width(), room.height()]);
            let is_stacked = matches!(division, Division::Parts { down: true, .. });
            if has_companion && is_stacked && room.width() > room.height() {
                loss += STACKED;
            }
            let mut frames = vec![room; needs.len()];
            sharing.frames(division, room, (&mu, wide), &mut frames);
            let placed = needs.iter().zip(frames).zip(mu);
            let panels: Vec<Placed> =
                placed.map(|((needs, frame), mu)| Placed::new(needs, frame, mu, dims.unit)).collect();
            let worth = worth(&panels, loss);
            let found = Layout { below: Rect::ZERO, asides: asides.clone(), panels, worth };
            if best.as_ref().is_none_or(|best| found.is_better_than(best)) {
                best = Some(found);
            }
        }
    }
    let best = best.unwrap_or(Layout { below: Rect::ZERO, asides: Vec::new(), panels: Vec::new(), worth: [0.0; 3] });
    let top = height - free.edge - words.max(free.corner) + if below > 0.0 { GAP } else { 0.0 };
    let below = Rect::new(whole.x0, top.min(height - free.edge), whole.x1 - dims.beside_code(), height - free.edge);
    Layout { below, ..best }
}

impl Layout {
    /// Whether it shows more than another, or as much with more room for the panel that has least.
    fn is_better_than(&self, other: &Layout) -> bool {
        let ease = |layout: &Layout| layout.panels.iter().map(Placed::ease).fold(f64::INFINITY, f64::min);
        match (self.worth[..2].partial_cmp(&other.worth[..2]), self.worth[2] - other.worth[2]) {
            (Some(std::cmp::Ordering::Equal), more) if more.abs() <= ALIKE => ease(self) > ease(other),
            (Some(std::cmp::Ordering::Equal), more) => more > 0.0,
            (order, _) => order == Some(std::cmp::Ordering::Greater),
        }
    }
}

/// The rest of a room, and the area cut off from it.
pub(super) fn cut_off(room: Rect, aside: Aside) -> (Rect, Option<Rect>) {
    let (mut left, mut kept) = (room, room);
    match aside {
        Aside::Below(height) => {
            kept.y0 = room.y1 - height;
            left.y1 = kept.y0 - GAP;
        }
        Aside::Right(width) => {
            kept.x0 = room.x1 - width;
            left.x1 = kept.x0 - GAP;
        }
    }
    (left, Some(kept))
}

/// Quality of an arrangement with a loss: see [`Layout::worth`]. Where contents do not fit, that of which more is seen is better.
fn worth(panels: &[Placed], loss: f64) -> [f64; 3] {
    let is_wide = |placed: &Placed| {
        placed.area.width().min(placed.area.height()) >= LEAST - 2.0 * ROUNDING
            && placed.frame.width() >= placed.needs.heading
    };
    // The logarithm of the part that is seen.
    let seen = |placed: &Placed| {
        let (size, area) = (placed.shown(&placed.needs.extent), placed.area);
        let part = |size: f64, room: f64| if size > room { libm::log(room.max(0.1) / size) } else { 0.0 };
        part(size.x, area.width()) + part(size.y, area.height())
    };
    [
        f64::from(u8::from(panels.iter().all(is_wide))),
        panels.iter().filter(|placed| placed.holds(&placed.needs.extent)).count() as f64,
        panels.iter().map(seen).sum::<f64>() - loss,
    ]
}
