use super::closing::{Assembled, Closer, places};
use super::frames::{Frames, pinned};
use super::number::most_modes;
use super::paths::Paths;
use super::platform::Platform;
use super::says;
use super::search::{GUIDED, Rough, Search};
use super::wheels;
use crate::geometry::{BoundingBox, Point, Random, Turn, Vector, cross, degrees_of, turn_of_degrees};
use crate::mechanism::{BodyId, Class, Group, LoopEquations, Mechanism, SliderId};
use crate::message::Message;
use std::cell::OnceCell;
use std::cmp::Ordering;

/// Largest gap of a closed loop, relative to the mechanism's size: far more than the rounding that Newton's method
/// leaves, less than the gap a billionth of a degree beyond a limit position.
const CLOSED: f64 = 1e-12;

/// Roundings that the gap of a closed loop holds at most.
const ROUNDINGS: f64 = 8.0;

/// Roundings from which on a gap between two assemblies is one.
const SEEN: f64 = 4.0;

/// Largest ratio of the square of the next Newton step, in radians, and a gap that rounding does not explain, in parts of
/// the group's shortest link. At a root it is much less; where loops miss each other by a little, as beyond a limit
/// position, it is about 1 at least.
const QUADRATIC: f64 = 1e-2;

/// Two assemblies are the same mode if their points differ by less than this part of the mechanism's size and their
/// one-point links by less than [`SAME_TURN`].
const SAME: f64 = 1e-8;

/// Two assemblies whose points differ by less than this part of the size may be one double root: they are if what lies
/// between them closes, too, as far as rounding can tell.
const NEIGHBOURS: f64 = 1e-4;

/// Largest difference of angles, in radians, of assemblies that are one mode; at a double root angles are only as exact as the square root of a rounding.
const SAME_TURN: f64 = 1e-6;

/// Largest difference of angles, in radians, of assemblies that may be one double root.
const NEAR_TURN: f64 = 1e-3;

/// Condition number above which the group counts as movable at fixed drives: with gaps of [`CLOSED`] a movable group
/// exceeds it, two modes that nearly coincide do not.
const MOVABLE: f64 = 1e10;

/// How far a singular assembly is pushed, in degrees and in hundredths of the size, to see whether it moves; and how often.
const PUSH: f64 = 0.5;
const PUSHES: usize = 4;

/// Most complex modes of a group whose modes are found by paths from those of other lengths; of more a search is quicker.
const MOST_PATHS: u64 = 400;

/// The work of a path, in closings of loops.
const PATH: usize = 5;

/// Most bodies that count in the work of closing a group: what is far from it costs nothing.
const MOST_COUNTED: usize = 40;

/// Reasons why a group has no assembly mode.
pub(super) enum NoMode {
    /// There is none: the distance by which its links fail to meet.
    Apart(Message),
    /// The guides of a link's two sliders are parallel: its name.
    Parallel(String),
    /// The search found none: number of starts and smallest gap.
    NotFound(Message),
    /// All that were found may move at fixed drives.
    Moves,
}

/// The assembly modes of a group.
pub(super) struct GroupModes {
    /// Those that stand, in order.
    pub modes: Vec<Assembled>,
    /// One of the assemblies in which the group may move at fixed drives, if it has any.
    pub moving: Option<Assembled>,
    /// How many modes there can be at most, as far as that is known.
    pub at_most: Option<u64>,
}

/// Finds the assembly modes of one group after another, over and over, for all assemblies of the groups before.
pub(super) struct Assembler<'a> {
    mechanism: &'a Mechanism,
    /// Chooses among the modes, and where a search starts.
    pub rough: Rough,
    closer: Closer<'a>,
    groups: Vec<Prepared>,
    /// The points of the bodies of known position.
    known: BoundingBox,
    /// The work done so far: starts from which loops have been closed, times bodies of the mechanism or [`MOST_COUNTED`].
    pub work: usize,
}

/// What all assemblies of a group have in common.
struct Prepared {
    equations: LoopEquations,
    levers: Vec<Lever>,
    /// How many modes there can be at most, once it has been asked for.
    at_most: OnceCell<Option<u64>>,
}

impl<'a> Assembler<'a> {
    /// `known` are the frames of the bodies that no group holds.
    pub(super) fn new(mechanism: &'a Mechanism, known: &Frames, rough: Rough) -> Assembler<'a> {
        let prepared = |group: &Group| {
            let equations = LoopEquations::new(mechanism, group);
            Prepared { levers: Lever::all(mechanism, group, &equations), equations, at_most: OnceCell::new() }
        };
        let places = known.places(mechanism, mechanism.body_ids());
        Assembler {
            mechanism,
            rough,
            closer: Closer::new(mechanism, known),
            groups: mechanism.groups.iter().map(prepared).collect(),
            known: BoundingBox::of(places.map(|(_, place)| place)),
            work: 0,
        }
    }

    /// Every real assembly mode of a group; of a group of higher class those that a search finds.
    ///
    /// They are ordered by the angle of the group's first rotating link, counter-clockwise from +x; where none rotates,
    /// by the positions of its sliders. A slotted lever with one point has its slider on the positive side; where
    /// `near` gives its angle, both orientations are modes.
    ///
    /// A group of higher class is put together near the rough places first. Where it has only pins, paths from other lengths then lead to all its modes,
    /// whatever its links are called and wherever it lies; where it has sliders, or some of its modes do not stand by themselves, random starts follow.
    pub(super) fn modes(&mut self, index: usize, known: &Frames, slides: &[f64]) -> Result<GroupModes, NoMode> {
        let (mechanism, group) = (self.mechanism, &self.mechanism.groups[index]);
        let at_most = *self.groups[index].at_most.get_or_init(|| most_modes(mechanism, group));
        let mut modes = Modes {
            assembler: self,
            index,
            group,
            found: Vec::new(),
            points: Vec::new(),
            moving: None,
            at_most,
            is_regular: false,
            smallest_gap: f64::INFINITY,
        };
        if let Some(platform) = Platform::new(mechanism, group, known) {
            for start in platform.starts(known, slides) {
                modes.close(start, f64::INFINITY);
            }
            if modes.found.is_empty() {
                let parallel = platform.on_parallel_guides().map(|link| mechanism.body(link).name.clone());
                return Err(parallel.map_or_else(|| NoMode::Apart(platform.miss()), NoMode::Parallel));
            }
        } else if let Some(start) =
            wheels::start(mechanism, group, &modes.assembler.groups[index].equations, known, slides)
        {
            modes.close(start, f64::INFINITY);
            if modes.found.is_empty() {
                return Err(NoMode::NotFound(says::none_closes(1_usize)));
            }
        } else {
            let mut search = Search::new(mechanism, group, known, slides, &modes.assembler.rough);
            let mut are_all = false;
            while !are_all && !search.is_over(modes.found.len(), modes.is_regular) {
                let start = search.start();
                if modes.close(start, search.size) {
                    search.count_closed();
                }
                if search.starts == GUIDED {
                    are_all = modes.follow_paths(known, slides, &mut search);
                }
            }
            modes.leave_out_surplus();
            if modes.found.is_empty() && modes.moving.is_none() {
                let (starts, gap) = (search.starts, modes.smallest_gap);
                let tried = match gap.is_finite() {
                    true => says::none_closes_but(starts, format!("{gap:.1e}")),
                    false => says::none_closes(starts),
                };
                return Err(NoMode::NotFound(tried));
            }
        }
        Ok(modes.sorted())
    }
}

/// The modes of a group found so far.
struct Modes<'s, 'a> {
    assembler: &'s mut Assembler<'a>,
    index: usize,
    group: &'a Group,
    found: Vec<Assembled>,
    /// By mode: the places of the group's points.
    points: Vec<Vec<Point>>,
    /// The first assembly in which the group may move at fixed drives; of a whole curve no other is kept.
    moving: Option<Assembled>,
    /// How many modes there can be at most, as far as that is known.
    at_most: Option<u64>,
    /// Whether the loop equations are regular in at least one mode, so that the group cannot move at fixed drives.
    is_regular: bool,
    smallest_gap: f64,
}

impl Modes<'_, '_> {
    /// Closes the loops from `start` and keeps the assembly if it is a new mode; whether they close.
    ///
    /// A slider that has moved far away enlarges the mechanism and makes any relative gap small: gaps are taken
    /// relative to a size of at most `reach`.
    fn close(&mut self, start: Assembled, reach: f64) -> bool {
        let (mechanism, group) = (self.assembler.mechanism, self.group);
        self.assembler.work += mechanism.bodies.len().min(MOST_COUNTED);
        let mut assembled = self.assembler.closer.closed(self.index, start);
        let size = self.size(&self.places(&assembled));
        let gap = assembled.gap * (size / reach).max(1.0);
        self.smallest_gap = self.smallest_gap.min(gap);
        if gap.is_nan() || gap > CLOSED.max(ROUNDINGS * self.assembler.closer.rounding_of_wheels(self.index)) {
            return false;
        }
        if group.class == Class::Higher {
            // The steps from a distant start may have ended before full accuracy.
            assembled = self.assembler.closer.closed(self.index, assembled);
        } else if !self.is_root(&assembled, gap, size) {
            return false;
        }
        for lever in &self.assembler.groups[self.index].levers {
            assembled = lever.positive(mechanism, assembled);
        }
        let points = self.places(&assembled);
        let size = self.size(&points);
        let is_known = (0..self.found.len()).any(|other| self.is_same(other, &assembled, &points, size));
        if !is_known {
            if group.class == Class::Higher {
                let is_regular = self.condition(&assembled) < MOVABLE;
                // Only a search stops by it.
                self.is_regular |= is_regular;
                if !is_regular && (self.moving.is_some() || self.moves(&assembled, &points, size)) {
                    self.moving.get_or_insert(assembled);
                    return true;
                }
            }
            self.found.push(assembled);
            self.points.push(points);
        }
        true
    }

    /// Closes the loops from where paths from other lengths lead, if the group has only pins; whether these are all modes.
    fn follow_paths(&mut self, known: &Frames, slides: &[f64], search: &mut Search<'_>) -> bool {
        let number = self.at_most.filter(|&most| most <= MOST_PATHS);
        let Some((number, mut paths)) = number.zip(Paths::new(self.assembler.mechanism, self.group, known, slides))
        else {
            return false;
        };
        let (starts, are_all) = paths.starts(number as usize);
        self.assembler.work += PATH * paths.followed * self.assembler.mechanism.bodies.len().min(MOST_COUNTED);
        for start in starts {
            self.close(start, search.size);
        }
        let are_all = are_all && self.moving.is_none();
        search.starts += if are_all { paths.followed } else { 0 };
        are_all
    }

    /// Leaves out what is more than there can be: such assemblies are parts of a curve, as well as rounding can tell.
    fn leave_out_surplus(&mut self) {
        let Some(most) = self.at_most.filter(|&most| self.found.len() as u64 > most) else {
            return;
        };
        let mut found: Vec<(f64, Assembled)> =
            std::mem::take(&mut self.found).into_iter().map(|a| (self.condition(&a), a)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let surplus = found.split_off(most as usize).into_iter().map(|(_, assembled)| assembled).next();
        self.moving = self.moving.take().or(surplus);
        self.found = found.into_iter().map(|(_, assembled)| assembled).collect();
    }

    /// Whether the group moves from a singular assembly at fixed drives: pushed a little, it closes elsewhere, and is singular there, too.
    fn moves(&mut self, assembled: &Assembled, points: &[Point], size: f64) -> bool {
        let (mechanism, group) = (self.assembler.mechanism, self.group);
        let mut random = Random(0x7075_7368);
        (0..PUSHES).any(|_| {
            let mut pushed = assembled.clone();
            for &link in &group.links {
                if let Some(frame) = assembled.frames.of(link) {
                    let turn = turn_of_degrees(PUSH * random.within()) * frame.rotation;
                    pushed.frames.set_compound(mechanism, link, pinned(turn, Point::origin(), Point::origin()));
                }
            }
            for &joint in &group.joints {
                if let Some(id) = mechanism.joint(joint).slider {
                    pushed.slides[id.0] += 0.01 * PUSH * random.within() * size;
                }
            }
            let closer = &mut self.assembler.closer;
            let first = closer.closed(self.index, pushed);
            let closed = closer.closed(self.index, first);
            let there = self.places(&closed);
            let apart = there.iter().zip(points).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max);
            closed.gap <= CLOSED && apart > NEIGHBOURS * size && self.condition(&closed) >= MOVABLE
        })
    }

    /// Whether an assembly of that size with a small gap closes, and does not only come near it.
    fn is_root(&mut self, assembled: &Assembled, gap: f64, size: f64) -> bool {
        let Assembler { closer, .. } = &mut *self.assembler;
        gap <= ROUNDINGS * closer.rounding(self.index, assembled) || {
            let missed = gap * (size / closer.shortest(self.index)).max(1.0);
            closer.next_step(self.index, assembled).powi(2) <= QUADRATIC * missed
        }
    }

    /// Whether an assembly with its points at `points` is one that was found before.
    fn is_same(&mut self, other: usize, assembled: &Assembled, points: &[Point], size: f64) -> bool {
        let group = self.group;
        let pairs = self.points[other].iter().zip(points);
        let apart = pairs.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max);
        let found = &self.found[other];
        let Assembler { mechanism, closer, .. } = &mut *self.assembler;
        if apart <= SAME * size && same_turns(mechanism, group, found, assembled, SAME_TURN) {
            return true;
        }
        let is_near = apart <= NEIGHBOURS * size && same_turns(mechanism, group, found, assembled, NEAR_TURN);
        is_near && {
            let least = SEEN * closer.rounding(self.index, assembled);
            closer.gap_between(self.index, [found, assembled]) <= least.min(CLOSED)
        }
    }

    /// The places of the group's points.
    fn places(&self, assembled: &Assembled) -> Vec<Point> {
        let bodies = self.group.bodies.iter().copied();
        let places = assembled.frames.places(self.assembler.mechanism, bodies);
        places.map(|(_, place)| place).collect()
    }

    /// The size of these points with the bodies of known position.
    fn size(&self, points: &[Point]) -> f64 {
        self.assembler.known.with(points.iter().copied()).size()
    }

    /// The condition number of the loop equations.
    fn condition(&self, assembled: &Assembled) -> f64 {
        let (points, guides) = places(self.assembler.mechanism, &assembled.frames);
        let system = self.assembler.groups[self.index].equations.factored(&points, &guides);
        system.map_or(f64::INFINITY, |system| system.condition())
    }

    /// All modes in order. A lever whose angle `near` gives is listed in both orientations.
    fn sorted(self) -> GroupModes {
        let Prepared { equations, levers, .. } = &self.assembler.groups[self.index];
        let (mut found, mut at_most) = (self.found, self.at_most);
        for lever in levers {
            if lever.links.iter().any(|&link| self.assembler.rough.angle(link).is_some()) {
                let reversed = found.iter().map(|a| lever.reversed(self.assembler.mechanism, a));
                found.extend(reversed.collect::<Vec<_>>());
                at_most = at_most.map(|most| 2 * most);
            }
        }
        let mut links = self.group.links.iter();
        let turning = links.find(|&&link| equations.angular_unknown(link).is_some());
        let angle = |a: &Assembled| {
            let frame = turning.and_then(|&link| a.frames.of(link));
            frame.map_or(0.0, |f| degrees_of(f.rotation * Vector::x()).rem_euclid(360.0))
        };
        found.sort_by(|a, b| {
            let slides = a.slides.iter().zip(&b.slides);
            let slides = slides.map(|(a, b)| a.total_cmp(b));
            slides.fold(angle(a).total_cmp(&angle(b)), Ordering::then)
        });
        GroupModes { modes: found, moving: self.moving, at_most }
    }
}

/// Whether the one-point links of two assemblies have the same angles to `most` radians.
fn same_turns(mechanism: &Mechanism, group: &Group, a: &Assembled, b: &Assembled, most: f64) -> bool {
    let mut one_point = group.bodies.iter().filter(|&&link| mechanism.body(link).points.len() == 1);
    one_point.all(|&link| {
        let rotation = |assembled: &Assembled| assembled.frames.of(link).map(|f| f.rotation);
        rotation(a).zip(rotation(b)).is_none_or(|(a, b)| {
            let (along, across) = (a.re - b.re, a.im - b.im);
            along * along + across * across <= most * most
        })
    })
}

/// A slotted lever with one point, on the line of its slot, with the one-point blocks that slide in it.
///
/// Turned by 180° about their points together, they have the same places: only the axes and the signs of the slides
/// change.
#[derive(Debug)]
struct Lever {
    /// The lever and its blocks.
    links: Vec<BodyId>,
    /// The sliders on the lever.
    sliders: Vec<SliderId>,
}

impl Lever {
    /// The levers of a group.
    fn all(mechanism: &Mechanism, group: &Group, equations: &LoopEquations) -> Vec<Lever> {
        let mut levers: Vec<Lever> = Vec::new();
        let unknowns = 0..equations.unknowns;
        for unknown in unknowns {
            let turns = |link: &&BodyId| equations.angular_unknown(**link) == Some(unknown);
            let links: Vec<BodyId> = group.bodies.iter().filter(turns).copied().collect();
            let sliders: Vec<SliderId> =
                mechanism.slider_ids().filter(|&id| links.contains(&mechanism.slider(id).on)).collect();
            let lever = Lever { links, sliders };
            if lever.is_symmetric(mechanism) {
                levers.push(lever);
            }
        }
        levers
    }

    fn is_symmetric(&self, mechanism: &Mechanism) -> bool {
        let one_point = |&link: &BodyId| mechanism.body(link).points.len() == 1;
        // A given position of a slider distinguishes the two orientations.
        let driven = |&id: &SliderId| mechanism.slider(id).drive.is_some();
        let is_through_point = |&id: &SliderId| {
            let slider = mechanism.slider(id);
            let point = only_point(mechanism, slider.on);
            let (through, direction) = slider.line();
            // Exact comparison: these are the scene's own coordinates.
            cross(through - point, direction) == 0.0
        };
        !self.sliders.is_empty()
            && !self.sliders.iter().any(driven)
            && self.links.iter().all(one_point)
            && self.sliders.iter().all(is_through_point)
    }

    /// An assembly with the lever turned by 180°.
    fn reversed(&self, mechanism: &Mechanism, assembled: &Assembled) -> Assembled {
        let mut reversed = assembled.clone();
        for &link in &self.links {
            let point = only_point(mechanism, link);
            if let Some(&frame) = assembled.frames.of(link) {
                let turn = Turn::from_cos_sin_unchecked(-frame.rotation.re, -frame.rotation.im);
                reversed.frames.set(link, pinned(turn, point, frame * point));
            }
        }
        for &id in &self.sliders {
            // Slides count from `through`, which need not be the lever's point.
            let slider = mechanism.slider(id);
            let point = only_point(mechanism, slider.on);
            let (through, direction) = slider.line();
            let offset = (through - point).dot(&direction);
            reversed.slides[id.0] = -assembled.slides[id.0] - 2.0 * offset;
        }
        reversed
    }

    /// The assembly with the lever in the orientation in which its first slider has the larger position.
    fn positive(&self, mechanism: &Mechanism, assembled: Assembled) -> Assembled {
        let reversed = self.reversed(mechanism, &assembled);
        let first = self.sliders[0].0;
        if reversed.slides[first] > assembled.slides[first] { reversed } else { assembled }
    }
}

/// The point of a one-point link, in its frame.
fn only_point(mechanism: &Mechanism, link: BodyId) -> Point {
    mechanism.local(link, mechanism.body(link).points[0])
}
