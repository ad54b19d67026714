use super::view::{Extent, fitting_scale, next_scale};
use crate::scene::Panel;
use kurbo::Rect;

/// Blank paper around everything, in mm.
pub(super) const MARGIN: f64 = 8.0;
/// Room for the title above the panels.
pub(super) const TITLE: f64 = 9.0;
/// Room for the legend below the panels.
pub(super) const LEGEND: f64 = 16.0;
/// The part of it that the scales take.
pub(super) const SCALES: f64 = 8.0;
/// Between panels.
const GAP: f64 = 4.0;
/// Inside a panel, kept free for labels and its heading.
const PADDING: f64 = 7.0;
/// Height of a panel's heading.
pub(super) const HEADING: f64 = 6.0;
/// No panel's content gets less than this, in mm, either way.
const LEAST: f64 = 20.0;

/// What a panel is to show.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    pub panel: Panel,
    pub extent: Extent,
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

/// The sheet divided up.
pub(super) struct Layout {
    pub title: Rect,
    pub legend: Rect,
    pub panels: Vec<Placed>,
}

/// Divides a sheet so that the panels' contents come out largest at round scales.
///
/// All of a few arrangements are tried: side by side, one beside two, one above two; the one in which the
/// contents come out largest, their sizes multiplied, wins.
///
/// Between panels and legend stays so much room for words.
pub(super) fn layout([width, height]: [f64; 2], wanted: &[Wanted], words: f64) -> Layout {
    let sheet = Rect::new(MARGIN, MARGIN, width - MARGIN, height - MARGIN);
    let room = Rect::new(
        sheet.x0,
        sheet.y0 + TITLE,
        sheet.x1,
        sheet.y1 - LEGEND - words - GAP,
    );
    let mut best: Option<(f64, Vec<Placed>)> = None;
    for frames in arrangements(room, wanted) {
        let placed: Vec<Placed> = wanted
            .iter()
            .zip(frames)
            .map(|(w, f)| place(w, f))
            .collect();
        // How large a content comes out: the diagonal of its box on paper.
        let drawn = |(w, p): (&Wanted, &Placed)| (w.extent.size() / p.mu).norm();
        let roomy = |p: &Placed| p.area.width().min(p.area.height()) >= LEAST;
        if !placed.iter().all(roomy) && best.is_some() {
            continue;
        }
        // Their product: no content is made large at a greater loss of another.
        let fill: f64 = wanted.iter().zip(&placed).map(drawn).product();
        if best.as_ref().is_none_or(|(most, _)| fill > *most) {
            best = Some((fill, placed));
        }
    }
    Layout {
        title: Rect::new(sheet.x0, sheet.y0, sheet.x1, sheet.y0 + TITLE),
        legend: Rect::new(sheet.x0, sheet.y1 - LEGEND - words, sheet.x1, sheet.y1),
        panels: best.map(|(_, placed)| placed).unwrap_or_default(),
    }
}

fn place(wanted: &Wanted, frame: Rect) -> Placed {
    let mut area = frame.inset(-PADDING);
    area.y0 += HEADING - 2.0;
    Placed {
        panel: wanted.panel,
        frame,
        area,
        mu: wanted
            .mu
            .unwrap_or_else(|| fitting_scale(&wanted.extent, area)),
    }
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
        let (size, extra) = if down {
            (size.y, HEADING - 2.0)
        } else {
            (size.x, 0.0)
        };
        let at = move |mu: f64| size / mu + 2.0 * PADDING + extra + 1e-6;
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
