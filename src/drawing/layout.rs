use super::view::{Extent, fitting_scale, next_scale};
use crate::scene::Panel;
use kurbo::Rect;

/// Blank paper around everything, in mm.
pub(super) const MARGIN: f64 = 8.0;
/// Room for the title above the panels.
pub(super) const TITLE: f64 = 9.0;
/// Between panels.
const GAP: f64 = 4.0;
/// Inside a panel, kept free for labels and its heading.
const PADDING: f64 = 7.0;
/// Height of a panel's heading.
pub(super) const HEADING: f64 = 7.2;
/// Rounding of sizes on paper, in mm.
const ROUNDING: f64 = 1e-6;
/// No panel's content gets less than this, in mm, either way.
const LEAST: f64 = 20.0;

/// What a panel is to show.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    pub panel: Panel,
    pub extent: Extent,
    /// Width that its heading needs.
    pub heading: f64,
    /// The scale that the scene asks for.
    pub mu: Option<f64>,
}

/// A panel's place and scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub panel: Panel,
    pub frame: Rect,
    /// Where its content goes.
    pub area: Rect,
    pub mu: f64,
}

/// Paper that is kept free of panels, for a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aside {
    Nothing,
    /// This high, between panels and legend.
    Below(f64),
    /// This wide, to the right of the panels.
    Right(f64),
}

/// The sheet divided up.
pub(super) struct Layout {
    pub title: Rect,
    pub legend: Rect,
    /// Height of the legend's upper part, which the scales take, and in how many columns they stand.
    pub scales: f64,
    pub columns: usize,
    pub table: Option<Rect>,
    pub panels: Vec<Placed>,
    /// How good it is, what counts first before the rest.
    pub worth: [f64; 3],
}

/// The room above a legend of some height, for panels and a table.
pub(super) fn room([width, height]: [f64; 2], legend: f64) -> Rect {
    let bottom = height - MARGIN - legend - GAP;
    Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, bottom)
}

/// A way to divide a sheet: the table's area and the panels.
type Way = (Option<Rect>, Vec<Placed>);

/// Divides a sheet so that the panels' contents come out largest at round scales.
///
/// All of a few arrangements are tried: side by side, one beside two, one above two, each with every way to keep room `aside`. Those
/// come first in which contents of given scales fit into their panels; then the one wins in which the contents come out largest, their
/// sizes multiplied. The legend has a part for the scales and one `below` it.
pub(super) fn layout(
    page: [f64; 2],
    wanted: &[Wanted],
    [scales, below]: [f64; 2],
    columns: usize,
    asides: impl Fn(Rect) -> Vec<Aside>,
) -> Layout {
    let whole = room(page, scales + below);
    let mut best: Option<([f64; 3], Way)> = None;
    for aside in asides(whole) {
        let (room, table) = cut_off(whole, aside);
        for frames in arrangements(room, wanted) {
            let placed = wanted.iter().zip(frames).map(|(w, f)| place(w, f));
            let placed: Vec<Placed> = placed.collect();
            let worth = worth(wanted, &placed);
            if best.as_ref().is_none_or(|(most, _)| worth > *most) {
                best = Some((worth, (table, placed)));
            }
        }
    }
    let (worth, (table, panels)) = best.unwrap_or_default();
    let [_, height] = page;
    Layout {
        title: Rect::new(whole.x0, MARGIN, whole.x1, whole.y0),
        legend: Rect::new(whole.x0, whole.y1 + GAP, whole.x1, height - MARGIN),
        scales,
        columns,
        table,
        panels,
        worth,
    }
}

/// What is left of a room, and what is kept aside.
fn cut_off(room: Rect, aside: Aside) -> (Rect, Option<Rect>) {
    let (mut left, mut table) = (room, room);
    match aside {
        Aside::Nothing => return (room, None),
        Aside::Below(height) => {
            table.y0 = room.y1 - height;
            left.y1 = table.y0 - GAP;
        }
        Aside::Right(width) => {
            table.x0 = room.x1 - width;
            left.x1 = table.x0 - GAP;
        }
    }
    (left, Some(table))
}

/// How good an arrangement is, by what counts first: no panel is a mere strip, contents fit, and they come out large.
fn worth(wanted: &[Wanted], placed: &[Placed]) -> [f64; 3] {
    let all = || wanted.iter().zip(placed);
    // How large a content comes out on paper.
    let drawn = |(w, p): (&Wanted, &Placed)| w.extent.size() / p.mu;
    let roomy =
        |(w, p): (&Wanted, &Placed)| p.area.width().min(p.area.height()) >= LEAST && p.frame.width() >= w.heading;
    let fits = |pair: (&Wanted, &Placed)| {
        let (size, area) = (drawn(pair), pair.1.area.inflate(ROUNDING, ROUNDING));
        size.x <= area.width() && size.y <= area.height()
    };
    let yes = |is: bool| f64::from(u8::from(is));
    [
        yes(all().all(roomy)),
        all().filter(|pair| fits(*pair)).count() as f64,
        // The product of the diagonals: no content is made large at a greater loss of another.
        all().map(|pair| drawn(pair).norm()).product(),
    ]
}

fn place(wanted: &Wanted, frame: Rect) -> Placed {
    let mut area = frame.inset(-PADDING);
    area.y0 += HEADING - 2.0;
    Placed { panel: wanted.panel, frame, area, mu: wanted.mu.unwrap_or_else(|| fitting_scale(&wanted.extent, area)) }
}

/// Ways to divide `room` among one, two or three panels.
fn arrangements(room: Rect, wanted: &[Wanted]) -> Vec<Vec<Rect>> {
    let mut ways = Vec::new();
    match wanted {
        [] | [_] => ways.push(vec![room; wanted.len()]),
        [a, b] => {
            for down in [false, true] {
                for (a, b) in splits(room, down, &[*a], &[*b]) {
                    ways.push(vec![a, b]);
                }
            }
        }
        [a, others @ ..] => {
            for (down, then) in [(false, true), (false, false), (true, false)] {
                // Beside each other two panels share a width; one above the other each has it all.
                let second = if down == then { &others[..0] } else { others };
                for (first, rest) in splits(room, down, &[*a], second) {
                    for (b, c) in splits(rest, then, &others[..1], &others[1..]) {
                        ways.push(vec![first, b, c]);
                    }
                }
            }
        }
    }
    ways
}

/// Ways to cut `room` in two: in the middle, and where the content on either side just fits at a round scale.
fn splits(room: Rect, down: bool, first: &[Wanted], second: &[Wanted]) -> Vec<(Rect, Rect)> {
    let whole = if down { room.height() } else { room.width() } - GAP;
    let needs = |w: &Wanted| {
        let size = w.extent.size();
        let (size, extra) = if down { (size.y, HEADING - 2.0) } else { (size.x, 0.0) };
        let least = if down { 0.0 } else { w.heading };
        let at = move |mu: f64| (size / mu + 2.0 * PADDING + extra).max(least) + ROUNDING;
        // The scale that fits the whole room, and the next coarser ones.
        let mut mu = w.mu.unwrap_or_else(|| place(w, room).mu);
        std::array::from_fn::<f64, 2, _>(|_| {
            let need = at(mu);
            if w.mu.is_none() {
                mu = next_scale(1.01 * mu);
            }
            need
        })
    };
    let mut cuts = vec![0.5 * whole];
    cuts.extend(first.iter().flat_map(needs));
    cuts.extend(second.iter().flat_map(needs).map(|need| whole - need));
    cuts.retain(|cut| (0.2..=0.8).contains(&(cut / whole)));
    let cut_at = |cut: f64| {
        let (mut a, mut b) = (room, room);
        if down {
            (a.y1, b.y0) = (room.y0 + cut, room.y0 + cut + GAP);
        } else {
            (a.x1, b.x0) = (room.x0 + cut, room.x0 + cut + GAP);
        }
        (a, b)
    };
    cuts.into_iter().map(cut_at).collect()
}
