//! Rough places, and the starts near them and elsewhere for a group whose modes no polynomial gives.

use super::closing::Assembled;
use super::frames::{Frames, least_squares_placement, pinned, placement_in_compound};
use crate::geometry::{Placement, Point, Random, Turn, Vector, degrees_of, span, turn_of_degrees};
use crate::mechanism::{AngularConstraint, BodyId, Group, Mechanism, PointId};
use crate::scene::Near;
use std::f64::consts::TAU;

/// Starts that use the rough places; links without a rough place are random each time.
pub(super) const GUIDED: usize = 16;

/// Fewest random starts. Of 300 random groups of six links, 295 have as many modes with these as with ten times as
/// many.
const FEWEST_RANDOM: usize = 1000;

/// Most random starts of the smallest of these groups, of three loops; larger groups have fewer, at least
/// [`FEWEST_RANDOM`], because each start takes longer.
const MOST_RANDOM: usize = 20_000;

/// Starts for a group of higher class, whose assembly modes no polynomial gives.
///
/// The first starts are near the rough places, the others have random angles and slides, so that each mode can be
/// reached from its neighbourhood. The random numbers are the same in every run. A list of modes found by a search may
/// be incomplete.
pub(super) struct Search<'a> {
    mechanism: &'a Mechanism,
    group: &'a Group,
    /// The known bodies, and the group's links whose frames follow from rough places.
    guide: Frames,
    known: &'a Frames,
    slides: &'a [f64],
    /// Size of the mechanism, from its given places and lengths: the range of random slides.
    pub size: f64,
    random: Random,
    /// Most random starts of this group.
    most_random: usize,
    /// Number of starts made, and of random starts that have closed.
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
        let size = span(places) + group.bodies.iter().map(body).sum::<f64>();
        let loops = group.loops.len().max(3);
        Search {
            mechanism,
            group,
            guide,
            known,
            slides,
            size,
            random: Random(0x6b69_6e65_676f_6e31),
            most_random: (9 * MOST_RANDOM / (loops * loops)).max(FEWEST_RANDOM),
            starts: 0,
            closed: 0,
        }
    }

    /// Counts the last start as closed, if it was random.
    pub(super) fn count_closed(&mut self) {
        self.closed += usize::from(self.starts > GUIDED);
    }

    /// Whether to stop, with `modes` modes found.
    ///
    /// If all modes were reached with equal probability, the expected number of missing modes would be less than one
    /// half once 2 w² + 3 w + 2 starts have closed, w the modes found (C. G. E. Boender, A. H. G. Rinnooy Kan,
    /// "Bayesian stopping rules for multistart global optimization methods", Mathematical Programming 37, 1987). Their
    /// probabilities differ, so this is a rule and no proof. Several modes none of which is `is_regular` (with regular
    /// loop equations) belong to a group that can move, which has infinitely many. Where more starts would have to
    /// close than may be made, the least number is made: more do not complete the list.
    pub(super) fn is_over(&self, modes: usize, is_regular: bool) -> bool {
        let random_starts = self.starts.saturating_sub(GUIDED);
        let needed = 2 * modes * modes + 3 * modes + 2;
        let enough = modes == 0 || self.closed >= needed || needed > self.most_random || (modes > 1 && !is_regular);
        random_starts >= self.most_random || (random_starts >= FEWEST_RANDOM && enough)
    }

    /// The next start.
    pub(super) fn start(&mut self) -> Assembled {
        let guided = self.starts < GUIDED;
        self.starts += 1;
        let mut frames = self.known.clone();
        self.set_related_rotations(&mut frames);
        if guided {
            for &link in &self.group.links {
                self.set_rotation(&mut frames, link, self.guide.of(link).map(|f| f.rotation));
            }
        }
        for &link in &self.group.links {
            let (sine, cosine) = libm::sincos(self.random.unit() * TAU);
            let random_turn = Turn::from_cos_sin_unchecked(cosine, sine);
            self.set_rotation(&mut frames, link, Some(random_turn));
        }
        let mut slides = self.slides.to_vec();
        for &joint in &self.group.joints {
            if let Some(id) = self.mechanism.joint(joint).slider {
                let random_slide = (self.random.unit() - 0.5) * self.size;
                let near = self.guide.slide(self.mechanism, id).filter(|_| guided);
                slides[id.0] = near.unwrap_or(random_slide);
            }
        }
        Assembled { frames, slides, gap: f64::INFINITY }
    }

    /// Sets the rotation of a link that has none yet, and of those at a constant angle to it.
    fn set_rotation(&self, frames: &mut Frames, link: BodyId, turn: Option<Turn>) {
        if let (None, Some(turn)) = (frames.of(link), turn) {
            let turned = pinned(turn, Point::origin(), Point::origin());
            frames.set_compound(self.mechanism, link, turned);
            self.set_related_rotations(frames);
        }
    }

    /// Sets the rotations of links at a constant angle to links of known rotation. Their places follow along the
    /// loops.
    fn set_related_rotations(&self, frames: &mut Frames) {
        let mut changed = true;
        while changed {
            changed = false;
            for &joint in &self.group.joints {
                let Some(([a, b], apart)) =
                    self.mechanism.joint(joint).angular.as_ref().and_then(AngularConstraint::as_fixed_angle)
                else {
                    continue;
                };
                for (from, to, turn) in [(a, b, apart), (b, a, apart.inverse())] {
                    if let (Some(frame), None) = (frames.of(from), frames.of(to)) {
                        let turned = pinned(frame.rotation * turn, Point::origin(), Point::origin());
                        frames.set_compound(self.mechanism, to, turned);
                        changed = true;
                    }
                }
            }
        }
    }
}

/// A link's frame by a fit to the rough or known places of its points, or by its rough angle; of a compound link, with
/// those of all its links.
fn rough_frame(mechanism: &Mechanism, link: BodyId, known: &Frames, rough: &Rough) -> Option<Placement> {
    let placed = |point| {
        let mut bodies = mechanism.body_ids();
        bodies.find_map(|b| known.place(mechanism, b, point)).or_else(|| rough.place(point))
    };
    let mut pairs = Vec::new();
    let mut angle = None;
    for other in mechanism.compound(link) {
        let (body, frame) = (mechanism.body(other), placement_in_compound(mechanism, link, other));
        let locals = body.points.iter().zip(&body.local);
        pairs.extend(locals.filter_map(|(&p, local)| Some((frame * local, placed(p)?))));
        let turned = rough.angle(other).map(|turn| turn * frame.rotation.inverse());
        angle = angle.or(turned);
    }
    match (angle, pairs.first()) {
        (Some(turn), Some(&(local, place))) => Some(pinned(turn, local, place)),
        (Some(turn), None) => Some(pinned(turn, Point::origin(), Point::origin())),
        (None, _) => least_squares_placement(&pairs),
    }
}

/// Rough places of points and angles of links, from the scene's `near`: the nearest assembly is chosen.
pub(super) struct Rough {
    /// The points with rough places.
    pub points: Vec<(PointId, Point)>,
    /// The links with rough angles, in degrees.
    pub angles: Vec<(BodyId, f64)>,
}

/// The points with rough places among those that are sought; `None` where links have rough angles, too.
pub(crate) fn rough_places(mechanism: &Mechanism, near: &Near) -> Option<Vec<(PointId, Point)>> {
    let rough = Rough::new(mechanism, near);
    rough.angles.is_empty().then_some(rough.points)
}

impl Rough {
    pub(super) fn new(mechanism: &Mechanism, near: &Near) -> Rough {
        let member = |link: BodyId| mechanism.is_sought(link);
        let of_group = |p: PointId| {
            let mut links = mechanism.links();
            links.any(|(id, body)| member(id) && body.points.contains(&p))
        };
        let points = near.points.iter();
        let points = points.filter_map(|(name, &p)| Some((mechanism.point(name)?, Point::from(p))));
        let angles = near.angles_deg.iter();
        let angles = angles.filter_map(|(name, &angle)| Some((mechanism.link(name)?, angle)));
        let mut rough = Rough {
            points: points.filter(|(p, _)| of_group(*p)).collect(),
            angles: angles.filter(|(link, _)| member(*link)).collect(),
        };
        // Sums of distances are rounded alike in whatever order they stand in the file, so that two assemblies equally near do not change places.
        rough.points.sort_by_key(|(point, _)| *point);
        rough.angles.sort_by_key(|(link, _)| *link);
        rough
    }

    /// The rough place of a point.
    pub(super) fn place(&self, point: PointId) -> Option<Point> {
        let found = self.points.iter().find(|(p, _)| *p == point);
        found.map(|(_, place)| *place)
    }

    /// The rough angle of a link.
    pub(super) fn angle(&self, link: BodyId) -> Option<Turn> {
        let found = self.angles.iter().find(|(l, _)| *l == link);
        found.map(|(_, angle)| turn_of_degrees(*angle))
    }

    /// How many places and angles there are.
    pub(super) fn count(&self) -> usize {
        self.points.len() + self.angles.len()
    }
}

/// The chord, at radius 1, from a link's angle to a rough one in degrees.
pub(super) fn chord(frame: &Placement, angle: f64) -> f64 {
    let now = degrees_of(frame.rotation * Vector::x());
    2.0 * libm::sin(0.5 * (now - angle).to_radians())
}
