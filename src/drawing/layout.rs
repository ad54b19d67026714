use super::dims::Dims;
use super::sheet::Drawing;
use super::view::{Extent, fitting_scale, next_scale};
use crate::geometry;
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::{Affine, Rect};

/// White between panels, in mm.
const GAP: f64 = 4.0;
/// White inside a panel around its content, for labels, in mm.
const WHITE: f64 = 7.0;
/// That white where contents need the room at given scales: around a plan, and around the scheme, where the feet of pivots
/// stand in it.
pub(super) const LEAST_WHITE: [f64; 2] = [4.8, 6.4];
/// Height of a panel's heading, in mm.
pub(super) const HEADING: f64 = 7.2;
/// Rounding of sizes on paper, in mm.
const ROUNDING: f64 = 1e-6;
/// Parts of the room that a companion of the panel in focus may have.
const COMPANION: [f64; 4] = [0.24, 0.28, 0.32, 0.36];
/// Smallest width and height of a panel's content area, in mm.
const LEAST: f64 = 20.0;

/// The room that a panel needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Needs {
    /// The sheet of the construction that it shows.
    pub sheet: Sheet,
    /// Extent of the content, in units of what is drawn on that sheet.
    pub extent: Extent,
    /// Width of its heading, in mm.
    pub heading: f64,
    /// Further white between heading and content, in mm.
    pub above: f64,
    /// The scale that is given, in units per mm of paper.
    pub mu: Option<f64>,
    /// White around its content inside the panel, for labels, in mm.
    pub white: f64,
    /// Exponent of its content's size in the quality of a layout: how much it counts among the panels.
    pub weight: f64,
}

impl Needs {
    /// Those of a panel with the usual white, at a scale that fits.
    pub(super) fn usual(sheet: Sheet, extent: Extent, heading: f64) -> Needs {
        Needs { sheet, extent, heading, above: 0.0, mu: None, white: WHITE, weight: 1.0 }
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
    /// A panel in a frame, at its scale or else at the finest at which its content fits.
    fn new(needs: &Needs, frame: Rect, unit: f64) -> Placed {
        let mut area = frame.inset(-needs.white);
        area.y0 += HEADING - 2.0 + needs.above;
        Placed::with_area(needs, frame, area, unit)
    }

    /// A panel in a frame with this area for its content.
    pub(super) fn with_area(needs: &Needs, frame: Rect, area: Rect, unit: f64) -> Placed {
        let on_paper = Affine::scale(unit).transform_rect_bbox(area);
        let mu = needs.mu.unwrap_or_else(|| fitting_scale(&needs.extent, on_paper));
        Placed { needs: *needs, frame, area, mu, unit }
    }

    /// Width and height of something in the panel, in units of the layout.
    pub(super) fn shown(&self, extent: &Extent) -> geometry::Vector {
        extent.size() / (self.mu * self.unit)
    }

    /// Whether something fits into the area of the panel's content.
    pub(super) fn holds(&self, extent: &Extent) -> bool {
        self.holds_in(self.area, extent)
    }

    /// Whether something fits into an area at the panel's scale.
    pub(super) fn holds_in(&self, area: Rect, extent: &Extent) -> bool {
        let (size, area) = (self.shown(extent), area.inflate(ROUNDING, ROUNDING));
        size.x <= area.width() && size.y <= area.height()
    }

    /// Size of the content on paper, whether it fits or not.
    pub(super) fn size(&self) -> f64 {
        self.shown(&self.needs.extent).norm()
    }
}

/// An area of the sheet without panels, for a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aside {
    /// Between panels and legend, of this height in mm.
    Below(f64),
    /// To the right of the panels, of this width in mm.
    Right(f64),
}

/// Something on a sheet beside or below its panels.
pub(super) trait Item {
    /// Height that it needs below the scales, in mm.
    fn height(&self) -> f64 {
        0.0
    }

    /// The areas beside the panels that it can be drawn in.
    fn asides(&self, _room: Rect) -> Vec<Aside> {
        Vec::new()
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout);
}

/// Frames of all parts of a sheet.
#[derive(Clone)]
pub(super) struct Layout {
    pub legend: Rect,
    /// Height of the legend's upper part with the scales, and their number of columns.
    pub scales: f64,
    pub columns: usize,
    /// The area without panels.
    pub aside: Option<Rect>,
    pub panels: Vec<Placed>,
    /// Its quality, compared element by element.
    pub worth: [f64; 4],
}

impl Layout {
    /// Whether all panels have room for their contents.
    pub(super) fn holds_all(&self) -> bool {
        self.worth[1] as usize == self.panels.len()
    }

    /// Whether they are wide enough for their headings and for a content, too.
    pub(super) fn shows_all(&self) -> bool {
        self.worth[0] > 0.0 && self.holds_all()
    }

    /// The legend's lower part.
    pub(super) fn below(&self) -> Rect {
        Rect { y0: self.legend.y0 + self.scales, ..self.legend }
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

/// The area above a legend of some height, for panels and a table.
pub(super) fn room(dims: &Dims, legend: f64) -> Rect {
    let ([width, height], free) = (dims.page, dims.free);
    let bottom = height - free.edge - legend - GAP;
    Rect::new(free.edge, free.top, width - free.edge, bottom)
}

/// Divides a room among panels, with a unit of the layout in mm.
type Arrange = fn(Rect, &[Needs], f64) -> Vec<Vec<Rect>>;

/// Divides a sheet so that the panels' contents are largest at round scales.
///
/// A few arrangements are tried: side by side, one beside two, one above two, and two before one, each with every area
/// of `asides`. The best has most contents within their panels, then the largest product of the contents' sizes. The
/// legend has a part for the scales and one `below` it.
pub(super) fn layout(
    dims: &Dims,
    needs: &[Needs],
    [scales, below]: [f64; 2],
    columns: usize,
    asides: impl Fn(Rect) -> Vec<Aside>,
) -> Layout {
    let whole = room(dims, (scales + below).max(dims.free.corner));
    let asides: Vec<Aside> = asides(whole);
    let rooms = match asides.is_empty() {
        true => vec![(whole, None)],
        false => asides.into_iter().map(|aside| cut_off(whole, aside)).collect(),
    };
    // Its quality, the area without panels, and the panels.
    let mut best: Option<([f64; 4], Option<Rect>, Vec<Placed>)> = None;
    let passes: [(Arrange, bool); 3] = [(arrangements, false), (paired, false), (by_headings, true)];
    for (arrange, is_last_resort) in passes {
        if is_last_resort && best.as_ref().is_some_and(|(worth, ..)| worth[0] > 0.0) {
            break;
        }
        // Two panels that share a column must not make the smallest content smaller.
        let least = best.as_ref().map_or(0.0, |(.., placed)| smallest(placed));
        for &(room, aside) in &rooms {
            for frames in arrange(room, needs, dims.unit) {
                let placed = needs.iter().zip(frames).map(|(needs, frame)| Placed::new(needs, frame, dims.unit));
                let placed: Vec<Placed> = placed.collect();
                let worth = worth(&placed);
                let is_better = best.as_ref().is_none_or(|(most, ..)| worth > *most);
                // Headings come before all else.
                let is_first = best.as_ref().is_some_and(|(most, ..)| most[0] == 0.0) && worth[0] > 0.0;
                if is_first || (is_better && smallest(&placed) >= least - ROUNDING) {
                    best = Some((worth, aside, placed));
                }
            }
        }
    }
    let (worth, aside, panels) = best.unwrap_or_default();
    let [_, height] = dims.page;
    Layout {
        legend: Rect::new(whole.x0, whole.y1 + GAP, whole.x1 - dims.beside_code(), height - dims.free.edge),
        scales,
        columns,
        aside,
        panels,
        worth,
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

/// Quality of an arrangement: first whether no panel is too narrow, then how many contents fit, then their sizes, then
/// at given scales, how much room the panel with least has for its content, or how large the panel in focus is.
fn worth(panels: &[Placed]) -> [f64; 4] {
    let is_wide = |placed: &Placed| {
        placed.area.width().min(placed.area.height()) >= LEAST && placed.frame.width() >= placed.needs.heading
    };
    // The size of what is not cut off.
    let seen = |placed: &Placed| {
        let (size, area) = (placed.shown(&placed.needs.extent), placed.area);
        geometry::Vector::new(size.x.min(area.width()), size.y.min(area.height())).norm()
    };
    let weighed = |placed: &Placed| match placed.needs.weight {
        1.0 => seen(placed),
        weight => libm::pow(seen(placed), weight),
    };
    let room = |placed: &Placed| {
        let (size, area) = (placed.shown(&placed.needs.extent), placed.area);
        (area.width() / size.x).min(area.height() / size.y)
    };
    let has_companion = panels.iter().any(|placed| placed.needs.weight < 1.0);
    let focus = panels.iter().find(|placed| has_companion && placed.needs.weight == 1.0);
    [
        f64::from(u8::from(panels.iter().all(is_wide))),
        panels.iter().filter(|placed| placed.holds(&placed.needs.extent)).count() as f64,
        // The product of the diagonals: enlarging one content must not reduce another by a larger factor.
        panels.iter().map(weighed).product(),
        match (panels.iter().all(|placed| placed.needs.mu.is_some()), focus) {
            (_, Some(panel)) => panel.frame.area(),
            (true, None) => panels.iter().map(room).fold(f64::INFINITY, f64::min),
            (false, None) => 0.0,
        },
    ]
}

/// The size of the smallest content.
fn smallest(panels: &[Placed]) -> f64 {
    panels.iter().map(Placed::size).fold(f64::INFINITY, f64::min)
}

/// Divisions of `room` among panels: of two and three in every way, of more the first beside or above the others.
fn arrangements(room: Rect, needs: &[Needs], unit: f64) -> Vec<Vec<Rect>> {
    let mut divisions = Vec::new();
    match needs {
        [] | [_] => divisions.push(vec![room; needs.len()]),
        // A companion is as small as its content allows.
        [a, b] if a.weight < b.weight => {
            for down in [false, true] {
                let whole = if down { room.height() } else { room.width() } - GAP;
                divisions.extend(COMPANION.map(|share| divided(room, down, share * whole).to_vec()));
            }
        }
        [a, b] => {
            for down in [false, true] {
                divisions.extend(splits(room, down, [&[*a], &[*b]], unit).into_iter().map(|both| both.to_vec()));
            }
        }
        [a, others @ ..] if others.len() > 2 => {
            for down in [false, true] {
                for [first, rest] in splits(room, down, [&[*a], &[]], unit) {
                    let frames = arrangements(rest, others, unit).into_iter();
                    divisions.extend(frames.map(|others| [vec![first], others].concat()));
                }
            }
        }
        [a, others @ ..] => {
            for (down, then) in [(false, true), (false, false), (true, false)] {
                // Two panels side by side share the width; one above the other both have all of it.
                let second = if down == then { &others[..0] } else { others };
                for [first, rest] in splits(room, down, [&[*a], second], unit) {
                    for [b, c] in splits(rest, then, [&others[..1], &others[1..]], unit) {
                        divisions.push(vec![first, b, c]);
                    }
                }
            }
        }
    }
    divisions
}

/// Divisions of `room` among three panels of which the first two share a column or a row.
fn paired(room: Rect, needs: &[Needs], unit: f64) -> Vec<Vec<Rect>> {
    let [a, b, c] = needs else { return Vec::new() };
    let mut divisions = Vec::new();
    for down in [false, true] {
        let both: &[Needs] = if down { &[] } else { &[*a, *b] };
        for [both, third] in splits(room, down, [both, &[*c]], unit) {
            let halves = splits(both, !down, [&[*a], &[*b]], unit);
            divisions.extend(halves.into_iter().map(|[a, b]| vec![a, b, third]));
        }
    }
    divisions
}

/// Divisions of `room` so that headings fit: two panels as narrow as theirs beside a third, or all three so.
fn by_headings(room: Rect, needs: &[Needs], _: f64) -> Vec<Vec<Rect>> {
    let [a, b, c] = needs else { return Vec::new() };
    let [a, b, c] = [a, b, c].map(|needs| needs.heading + ROUNDING);
    let all = room.width() - 2.0 * GAP;
    let spare = all - a - b - c;
    if spare < 0.0 {
        return Vec::new();
    }
    let row = |widths: [f64; 3]| {
        let [first, rest] = divided(room, false, widths[0]);
        let [second, third] = divided(rest, false, widths[1]);
        vec![first, second, third]
    };
    let third = spare / 3.0;
    vec![row([a + spare, b, c]), row([a, b + spare, c]), row([a, b, c + spare]), row([a + third, b + third, c + third])]
}

/// Divisions of `room` into two: at the middle, and where the content of either side just fits at a round scale.
fn splits(room: Rect, down: bool, [first, second]: [&[Needs]; 2], unit: f64) -> Vec<[Rect; 2]> {
    let whole = if down { room.height() } else { room.width() } - GAP;
    let widths = |w: &Needs| {
        let size = w.extent.size();
        let (size, extra) = if down { (size.y, HEADING - 2.0 + w.above) } else { (size.x, 0.0) };
        let least = if down { 0.0 } else { w.heading };
        let at = move |mu: f64| (size / (mu * unit) + 2.0 * w.white + extra).max(least) + ROUNDING;
        // The scale that fits the whole room, and the next larger one.
        let mut mu = w.mu.unwrap_or_else(|| Placed::new(w, room, unit).mu);
        std::array::from_fn::<f64, 2, _>(|_| {
            let need = at(mu);
            if w.mu.is_none() {
                mu = next_scale(1.01 * mu);
            }
            need
        })
    };
    let mut cuts = vec![0.5 * whole];
    cuts.extend(first.iter().flat_map(widths));
    cuts.extend(second.iter().flat_map(widths).map(|need| whole - need));
    cuts.retain(|cut| (0.2..=0.8).contains(&(cut / whole)));
    cuts.into_iter().map(|cut| divided(room, down, cut)).collect()
}

/// A room divided after `cut` mm, from the left or from above.
fn divided(room: Rect, down: bool, cut: f64) -> [Rect; 2] {
    let (mut a, mut b) = (room, room);
    if down {
        (a.y1, b.y0) = (room.y0 + cut, room.y0 + cut + GAP);
    } else {
        (a.x1, b.x0) = (room.x0 + cut, room.x0 + cut + GAP);
    }
    [a, b]
}
