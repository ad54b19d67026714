use super::closing::Assembled;
use super::frames::{Frames, fitted, local, pinned, within};
use super::rough::Rough;
use crate::geometry::{Placement, Point, Random, Turn, span};
use crate::mechanism::{BodyId, Group, Mechanism, SliderId, Tie};
use std::f64::consts::TAU;

/// Starts that take what the rough places say of the links; what they do not say is drawn by lot each time.
const GUIDED: usize = 16;

/// Starts by lot at least. Of 300 random groups of six links, 295 have as many modes with these as with ten times as many.
const FEWEST: usize = 1000;

/// Starts by lot at most, for the smallest of these groups, of three loops; fewer, but never fewer than those, for larger ones, of which
/// each start costs more.
const MOST: usize = 20_000;

/// Starting positions of a group for which no polynomial gives the assembly modes, one of a higher class.
///
/// The first ones are near the rough places, the others have every angle and slide by lot: from everywhere, so that each mode is reached
/// from its own surroundings. The lots are the same each time. A list of modes found so may not be complete.
pub(super) struct Search<'a> {
    mechanism: &'a Mechanism,
    group: &'a Group,
    /// All known bodies, and the group's links as far as their frames are near the rough places.
    guide: Frames,
    known: &'a Frames,
    slides: &'a [f64],
    /// Size of the mechanism, from its given places and lengths: slides are up to about so long.
    pub reach: f64,
    random: Random,
    /// Starts by lot at most.
    most: usize,
    /// How many starts were made, and how many of those by lot have closed.
    pub starts: usize,
    closed: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        mechanism: &'a Mechanism,
        group: &'a Group,
        known: &'a Frames,
        slides: &'a [f64],
        rough: &Rough,
    ) -> Search<'a> {
        let mut guide = known.clone();
        for &link in &group.links {
            if let Some(frame) = rough_frame(mechanism, link, known, rough) {
                guide.set_compound(mechanism, link, frame);
            }
        }
        let body = |link: &BodyId| span(mechanism.body(*link).local.iter().copied());
        let places = mechanism.given.iter().flatten().copied();
        let reach = span(places) + group.bodies.iter().map(body).sum::<f64>();
        let loops = group.loops.len().max(3);
        Search {
            mechanism,
            group,
            guide,
            known,
            slides,
            reach,
            random: Random(0x6b69_6e65_676f_6e31),
            most: (9 * MOST / (loops * loops)).max(FEWEST),
            starts: 0,
            closed: 0,
        }
    }

    /// Counts a start that has closed, of which `modes` different ones are known now.
    pub(super) fn count_closed(&mut self) {
        self.closed += usize::from(self.starts > GUIDED);
    }

    /// Whether it is time to stop, with `modes` found.
    ///
    /// If every mode were as easily reached as any other, fewer than half a mode would be expected to be missing once 2 w² + 3 w + 2
    /// starts have closed, w the modes found (C. G. E. Boender, A. H. G. Rinnooy Kan, "Bayesian stopping rules for multistart global
    /// optimization methods", Mathematical Programming 37, 1987). They are not, so this is a rule and no proof. Several modes none of
    /// which is `firm`, in none of which the group's rates are definite, are a few of infinitely many: the group can move. With so many
    /// modes that more starts than there may be would have to close, more starts do not complete the list either.
    pub(super) fn is_over(&self, modes: usize, firm: bool) -> bool {
        let by_lot = self.starts.saturating_sub(GUIDED);
        let needed = 2 * modes * modes + 3 * modes + 2;
        let enough = modes == 0 || self.closed >= needed || needed > self.most || (modes > 1 && !firm);
        by_lot >= self.most || (by_lot >= FEWEST && enough)
    }

    /// The next start.
    pub(super) fn start(&mut self) -> Assembled {
        let guided = self.starts < GUIDED;
        self.starts += 1;
        let mut frames = self.known.clone();
        self.carry_turns(&mut frames);
        if guided {
            for &link in &self.group.links {
                self.turn(&mut frames, link, self.guide.of(link).map(|f| f.rotation));
            }
        }
        for &link in &self.group.links {
            let (sine, cosine) = libm::sincos(self.random.unit() * TAU);
            let lot = Turn::from_cos_sin_unchecked(cosine, sine);
            self.turn(&mut frames, link, Some(lot));
        }
        let mut slides = self.slides.to_vec();
        for &joint in &self.group.joints {
            if let Some(id) = self.mechanism.joint(joint).slider {
                let lot = (self.random.unit() - 0.5) * self.reach;
                let near = self.near_slide(id).filter(|_| guided);
                slides[id.0] = near.unwrap_or(lot);
            }
        }
        Assembled { frames, slides, gap: f64::INFINITY }
    }

    /// Turns a link that is not turned yet, and those that are tied to it.
    fn turn(&self, frames: &mut Frames, link: BodyId, turn: Option<Turn>) {
        if let (None, Some(turn)) = (frames.of(link), turn) {
            let turned = pinned(turn, Point::origin(), Point::origin());
            frames.set_compound(self.mechanism, link, turned);
            self.carry_turns(frames);
        }
    }

    /// Turns the links that turn alike with links whose turn is known. Where they are is found by walking the loops.
    fn carry_turns(&self, frames: &mut Frames) {
        let mut carried = true;
        while carried {
            carried = false;
            for &joint in &self.group.joints {
                let Some(([a, b], apart)) = self.mechanism.joint(joint).tie.as_ref().and_then(Tie::as_alike) else {
                    continue;
                };
                for (from, to, turn) in [(a, b, apart), (b, a, apart.inverse())] {
                    if let (Some(frame), None) = (frames.of(from), frames.of(to)) {
                        let turned = pinned(frame.rotation * turn, Point::origin(), Point::origin());
                        frames.set_compound(self.mechanism, to, turned);
                        carried = true;
                    }
                }
            }
        }
    }

    /// Where a slider stands on its guide if both are near the rough places.
    fn near_slide(&self, id: SliderId) -> Option<f64> {
        let slider = self.mechanism.slider(id);
        let (on, link) = (self.guide.of(slider.on)?, self.guide.of(slider.link)?);
        let (through, direction) = slider.line();
        let at = link * local(self.mechanism, slider.link, slider.at);
        Some((on.inverse() * at - through).dot(&direction))
    }
}

/// A link's frame from the rough or known places of its points, or from its rough angle; of a compound link, from those of all its links.
fn rough_frame(mechanism: &Mechanism, link: BodyId, known: &Frames, rough: &Rough) -> Option<Placement> {
    let placed = |point| {
        let mut bodies = (0..mechanism.bodies.len()).map(BodyId);
        bodies.find_map(|b| known.place(mechanism, b, point)).or_else(|| rough.place(point))
    };
    let mut pairs = Vec::new();
    let mut angle = None;
    for other in mechanism.compound(link) {
        let (body, frame) = (mechanism.body(other), within(mechanism, link, other));
        let own = body.points.iter().zip(&body.local);
        pairs.extend(own.filter_map(|(&p, own)| Some((frame * own, placed(p)?))));
        let turned = rough.angle(other).map(|turn| turn * frame.rotation.inverse());
        angle = angle.or(turned);
    }
    match (angle, pairs.first()) {
        (Some(turn), Some(&(own, place))) => Some(pinned(turn, own, place)),
        (Some(turn), None) => Some(pinned(turn, Point::origin(), Point::origin())),
        (None, _) => fitted(&pairs),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanism::mechanism;
    use crate::scene::Scene;

    /// Shapes in the coordinates of the fixed frame: where the rough places are true, no link is turned.
    #[test]
    fn the_first_starts_are_near_the_rough_places() {
        let scene = Scene::read(
            r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [100, -10] },
            "links": {
                "1": { "shape": { "A": [0, 0], "B": [30, 25] }, "drive": { "angle": 0, "omega": 1 } },
                "2": { "shape": { "B": [30, 25], "J": [40, 60], "K": [75, 90] } },
                "3": { "shape": { "K": [75, 90], "L": [95, 70] } },
                "4": { "shape": { "L": [95, 70], "C": [110, 50] } },
                "5": { "shape": { "C": [110, 50], "D": [100, -10] } } },
            "sliders": [{ "link": "4", "at": "L", "on": "2", "through": [40, 60], "along": [55, 10], "turned": -10.304846468766033 }],
            "near": { "J": [40, 60], "K": [75, 90], "angle(3)": 0, "C": [110, 50] } }"#,
        )
        .expect("a scene");
        let mechanism = mechanism(&scene).expect("a mechanism");
        let known = Frames::known(&mechanism);
        let rough = Rough::new(&mechanism, &scene.near);
        let mut search = Search::new(&mechanism, &mechanism.groups[0], &known, &[0.0], &rough);
        let angle = |start: &Assembled, link: &BodyId| start.frames.of(*link).map(|f| f.rotation.angle());
        let links = mechanism.groups[0].links.clone();
        for _ in 0..GUIDED {
            let start = search.start();
            for link in &links {
                let angle = angle(&start, link).expect("all links are placed");
                assert!(angle.abs() < 1e-12, "{link:?} is turned by {angle}");
            }
        }
        let by_lot = search.start();
        assert!(links.iter().any(|link| angle(&by_lot, link).is_some_and(|a| a.abs() > 0.1)));
    }
}
