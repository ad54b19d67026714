//! How a room is divided among panels, and at which scales: so that what they show is largest.
//!
//! A division is a room cut in two, and each part again, until every panel has one; the panels keep their order. Of one
//! division the best places of the cuts are sought for scales without steps: the sum of the weighted logarithms of the
//! scales is least there, so that no content is enlarged by a factor at the cost of a larger one. Then the best of the
//! neighbouring scales of the series is taken at which all contents have room.

use super::layout::{GAP, LEAST, Needs};
use super::view::Series;
use kurbo::Rect;

/// Loss where the content of a panel at a given scale is too large by the factor e.
const CUT: f64 = 100.0;
/// Steps of the search for the place of a cut: to a hundredth of the room.
const SEARCHED: usize = 9;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A division of a room.
#[derive(Clone, Debug)]
pub(super) enum Division {
    /// All of it for the panel with this number.
    Panel(usize),
    /// In two parts, one above the other or side by side.
    Parts { down: bool, parts: Box<[Division; 2]> },
}

/// Panels that share a room.
#[derive(Clone, Copy)]
pub(super) struct Sharing<'a> {
    pub needs: &'a [Needs],
    /// A unit of the layout, in mm of paper.
    pub unit: f64,
    /// From which their scales are.
    pub series: Series,
}

/// What is found for a division.
pub(super) struct Best {
    /// The scales by panel.
    pub mu: Vec<f64>,
    /// By the bits of a number: which panels are wide enough for the scale beside the heading.
    pub wide: u32,
    pub loss: f64,
}

/// Scales by panel, and which panels are wide.
type At<'a> = (&'a [f64], u32);

impl Division {
    /// All divisions among some panels, of which there is at least one.
    pub(super) fn all(panels: usize) -> Vec<Division> {
        Division::among(0, panels, None)
    }

    /// Those among the panels from one number to before another. The first part of a division is not cut in the
    /// direction of the division itself: that is the same division as with its last part so cut.
    fn among(from: usize, to: usize, but: Option<bool>) -> Vec<Division> {
        if to - from <= 1 {
            return vec![Division::Panel(from)];
        }
        let mut all = Vec::new();
        for down in [false, true].into_iter().filter(|down| but != Some(*down)) {
            for middle in from + 1..to {
                for first in Division::among(from, middle, Some(down)) {
                    let rests = Division::among(middle, to, None).into_iter();
                    all.extend(rests.map(|rest| Division::Parts { down, parts: Box::new([first.clone(), rest]) }));
                }
            }
        }
        all
    }
}

impl Sharing<'_> {
    /// The best scales by panel for a division of a room; the coarsest of those that were tried where not all contents fit.
    pub(super) fn best(&self, division: &Division, room: [f64; 2]) -> Best {
        let mut mu: Vec<f64> = self.needs.iter().map(|needs| needs.fixed().unwrap_or_default()).collect();
        if mu.contains(&0.0) {
            self.finest(division, room, &mut mu);
        }
        let loss = |mu: &[f64]| self.needs.iter().zip(mu).map(|(needs, mu)| needs.weight * libm::log(*mu)).sum::<f64>();
        let steps: Vec<Vec<f64>> = self.needs.iter().zip(&mu).map(|(needs, mu)| self.neighbours(needs, *mu)).collect();
        let mut best: Option<Best> = None;
        let mut tried = vec![0; steps.len()];
        loop {
            let mu: Vec<f64> = tried.iter().zip(&steps).map(|(at, steps)| steps[*at]).collect();
            let loss = loss(&mu);
            if best.as_ref().is_none_or(|best| loss < best.loss)
                && let Some(wide) = self.fitting(division, &mu, room)
            {
                best = Some(Best { mu, wide, loss });
            }
            // The next set, as a counter counts.
            let Some(at) = (0..tried.len()).find(|at| tried[*at] + 1 < steps[*at].len()) else { break };
            tried[..at].fill(0);
            tried[at] += 1;
        }
        best.unwrap_or_else(|| {
            let mu: Vec<f64> = steps.iter().map(|steps| steps[steps.len() - 1]).collect();
            Best { loss: loss(&mu), mu, wide: 0 }
        })
    }

    /// Which panels are wide enough for the scale beside the heading, by the bits of a number, where all contents fit.
    fn fitting(&self, division: &Division, mu: &[f64], [width, height]: [f64; 2]) -> Option<u32> {
        (0..1 << self.needs.len()).find(|wide| {
            let [w, h] = self.least(division, (mu, *wide));
            w <= width && h <= height
        })
    }

    /// The scales of the series about one without steps, the finest first; the one that is given.
    fn neighbours(&self, needs: &Needs, mu: f64) -> Vec<f64> {
        if let Some(given) = needs.fixed() {
            return vec![given];
        }
        let next = self.series.next(mu);
        let finer = self.series.finer(next);
        vec![self.series.finer(finer), finer, next, self.series.next(1.001 * next)]
    }

    /// Finds the best scales without steps for a division of a room; returns the loss.
    fn finest(&self, division: &Division, room: [f64; 2], mu: &mut [f64]) -> f64 {
        match division {
            Division::Panel(index) => {
                let needs = &self.needs[*index];
                let fitting = needs.fitting(room) / self.unit;
                mu[*index] = needs.fixed().unwrap_or(fitting);
                match needs.fixed() {
                    Some(given) => CUT * libm::log(fitting / given).max(0.0),
                    None => needs.weight * libm::log(fitting),
                }
            }
            Division::Parts { down, parts } => {
                let [first, rest] = parts.each_ref().map(|part| self.narrowest(part, *down));
                let along = usize::from(*down);
                let whole = room[along] - GAP;
                let mut loss_at = |cut: f64| {
                    let [mut a, mut b] = [room; 2];
                    (a[along], b[along]) = (cut, whole - cut);
                    self.finest(&parts[0], a, mu) + self.finest(&parts[1], b, mu)
                };
                let (mut low, mut high) = (first, whole - rest);
                if low >= high {
                    return loss_at(whole * first / (first + rest)) + CUT;
                }
                let (mut a, mut b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
                let (mut loss_a, mut loss_b) = (loss_at(a), loss_at(b));
                for _ in 0..SEARCHED {
                    if loss_a <= loss_b {
                        (high, b, loss_b) = (b, a, loss_a);
                        a = high - GOLDEN * (high - low);
                        loss_a = loss_at(a);
                    } else {
                        (low, a, loss_a) = (a, b, loss_b);
                        b = low + GOLDEN * (high - low);
                        loss_b = loss_at(b);
                    }
                }
                loss_at(if loss_a <= loss_b { a } else { b })
            }
        }
    }

    /// Width and height that the contents need at these scales.
    fn least(&self, division: &Division, at: At<'_>) -> [f64; 2] {
        match division {
            Division::Panel(index) => self.needs[*index].frame(at.0[*index] * self.unit, at.1 & (1 << index) != 0),
            Division::Parts { down, parts } => {
                let [a, b] = parts.each_ref().map(|part| self.least(part, at));
                let along = usize::from(*down);
                let mut both = [a[0].max(b[0]), a[1].max(b[1])];
                both[along] = a[along] + GAP + b[along];
                both
            }
        }
    }

    /// Least width or, `down`, height in which headings and a small content have room.
    fn narrowest(&self, division: &Division, down: bool) -> f64 {
        match division {
            Division::Panel(index) => {
                let needs = &self.needs[*index];
                let width = needs.least_width();
                if down { needs.header(width) + LEAST + needs.white + needs.below } else { width }
            }
            Division::Parts { down: own, parts } => {
                let [a, b] = parts.each_ref().map(|part| self.narrowest(part, down));
                if *own == down { a + GAP + b } else { a.max(b) }
            }
        }
    }

    /// The largest weight of the panels of a division.
    fn weight(&self, division: &Division) -> f64 {
        match division {
            Division::Panel(index) => self.needs[*index].weight,
            Division::Parts { parts, .. } => self.weight(&parts[0]).max(self.weight(&parts[1])),
        }
    }

    /// Frames by panel: what a room has beyond the needs of the contents is shared in proportion to them and to how much the panels count; where it is too
    /// small all have too little, but headings have room first.
    pub(super) fn frames(&self, division: &Division, room: Rect, at: At<'_>, frames: &mut [Rect]) {
        match division {
            Division::Panel(index) => frames[*index] = room,
            Division::Parts { down, parts } => {
                let along = usize::from(*down);
                let whole = [room.width(), room.height()][along] - GAP;
                let [a, b] = parts.each_ref().map(|part| self.least(part, at)[along]);
                let [least_a, least_b] = parts.each_ref().map(|part| self.narrowest(part, *down));
                let cut = match () {
                    () if a + b <= whole => {
                        let [more_a, more_b] = [a * self.weight(&parts[0]), b * self.weight(&parts[1])];
                        a + (whole - a - b) * more_a / (more_a + more_b)
                    }
                    () if least_a + least_b >= whole => whole * least_a / (least_a + least_b),
                    () => {
                        let (more_a, more_b) = ((a - least_a).max(0.0), (b - least_b).max(1e-9));
                        least_a + (whole - least_a - least_b) * more_a / (more_a + more_b)
                    }
                };
                let [first, rest] = divided(room, *down, cut);
                self.frames(&parts[0], first, at, frames);
                self.frames(&parts[1], rest, at, frames);
            }
        }
    }
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
