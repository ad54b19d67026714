//! Fourth-class groups that are hard for one reason each, as drawn: exact coordinates in f64, known motions of B and E.
//!
//! Each family has a parameter, from 1e-1 (mild) to 1e-15, of which zero is the end where the group is still regular. The
//! joint at which something gets small stands at the origin, so that its coordinates hold small numbers too.

use super::groups::{Group, Pair, add, times};
use super::random::Random;

/// What is hard about a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Nothing: joints by lot.
    Random,
    /// The cut lines BC and ED nearly parallel: S3 far away; at zero exactly parallel.
    Parallel,
    /// Both special points far away.
    BothParallel,
    /// S3 near the joint C or B.
    OnJoint,
    /// S3 and S5 near each other and near B.
    PointsMeet,
    /// The lines CD, GF and BE nearly through one point: singular.
    Singular,
    /// The lines CD, GF and BE nearly parallel: singular.
    SingularParallel,
    /// So far from a limit position; rates grow with the square root.
    Limit,
    /// The origin far away: the parameter is the group's size over that distance.
    Far,
    /// The closure link CD so short.
    ShortClosure,
    /// The drag link 2 so short, with all its joints.
    ShortDrag,
    /// The arm BC so short.
    ShortArm,
    /// The drag link 4 longer than the others by one over the parameter.
    LongDrag,
    /// Units of length and time so much larger.
    Units,
    /// Input velocities that slow, input accelerations by the square; at zero all is at rest.
    AtRest,
    /// Nearly moving as one rigid body.
    Rigid,
    /// One over the parameter added to both input velocities.
    Common,
    /// CD nearly in line with BC.
    Stretched,
    /// B, C, G nearly in line, and E, D, F.
    Straight,
    /// The outer joints B and E that close together.
    OuterTogether,
}

/// The exponents of the parameter.
const EXPONENTS: std::ops::RangeInclusive<i32> = 1..=15;

/// Beyond this the coordinates of a far group hold too few digits for its shape.
const FARTHEST: i32 = 12;

impl Family {
    /// All of them, [`Self::Random`] first.
    pub const ALL: [Family; 20] = [
        Family::Random,
        Family::Parallel,
        Family::BothParallel,
        Family::OnJoint,
        Family::PointsMeet,
        Family::Straight,
        Family::Stretched,
        Family::Singular,
        Family::SingularParallel,
        Family::Limit,
        Family::OuterTogether,
        Family::ShortClosure,
        Family::ShortDrag,
        Family::ShortArm,
        Family::LongDrag,
        Family::Far,
        Family::Common,
        Family::Rigid,
        Family::AtRest,
        Family::Units,
    ];

    /// A few words, with what the parameter is.
    pub fn name(self) -> &'static str {
        match self {
            Family::Random => "random groups",
            Family::Parallel => "S3 to infinity",
            Family::BothParallel => "S3 and S5 to infinity",
            Family::OnJoint => "S3 onto a joint",
            Family::PointsMeet => "S3 and S5 onto B",
            Family::Straight => "straight ternary links",
            Family::Stretched => "BC and CD in line",
            Family::Singular => "singular, lines concurrent",
            Family::SingularParallel => "singular, lines parallel",
            Family::Limit => "limit position",
            Family::OuterTogether => "B and E together",
            Family::ShortClosure => "link 3 short",
            Family::ShortDrag => "link 2 short",
            Family::ShortArm => "arm BC short",
            Family::LongDrag => "link 4 long",
            Family::Far => "far from the origin",
            Family::Common => "large common velocity",
            Family::Rigid => "moving as one body",
            Family::AtRest => "almost at rest",
            Family::Units => "other units",
        }
    }

    /// Its parameters, mild ones first; a single one where it has none.
    pub fn parameters(self) -> Vec<f64> {
        let power = |exponent: i32| libm::exp10(f64::from(-exponent));
        let mut all: Vec<f64> = EXPONENTS.map(power).collect();
        match self {
            Family::Random => return vec![1.0],
            Family::Far => all.truncate(FARTHEST as usize),
            Family::Parallel
            | Family::BothParallel
            | Family::OnJoint
            | Family::PointsMeet
            | Family::Straight
            | Family::Stretched
            | Family::AtRest
            | Family::Rigid => all.push(0.0),
            _ => {}
        }
        all
    }

    /// A group of the family, joints pinned, as drawn.
    pub fn group(self, parameter: f64, dice: &mut Random) -> Group {
        let mut group = Group::plain(dice, "RRRRRR");
        let shift = |dice: &mut Random| times(unit_and_more(dice), parameter);
        match self {
            Family::Random => {
                // Coordinates of few bits are parallel too often.
                let fine = |p| add(p, times(dice.place(), 1.0 / 32.0));
                group.places = group.places.map(fine);
            }
            Family::Parallel => {
                let [b, c, _, _, _, _] = from_joint(&mut group, E);
                let along = times(from_to(b, c), ratio(dice));
                group.places[D] = add(along, shift(dice));
            }
            Family::BothParallel => {
                let [b, c, _, _, _, g] = from_joint(&mut group, E);
                // Different ratios: with the same ones the group would be singular too.
                let (k, m) = (ratio(dice), -ratio(dice));
                group.places[D] = add(times(from_to(b, c), k), shift(dice));
                group.places[F] = add(times(from_to(b, g), m), shift(dice));
            }
            Family::OnJoint => {
                let joint = [C, B][dice.below(2)];
                let places = from_joint(&mut group, joint);
                group.places[D] = add(times(places[E], -ratio(dice)), shift(dice));
            }
            Family::PointsMeet => {
                let places = from_joint(&mut group, B);
                let (k, m) = (ratio(dice), -ratio(dice));
                group.places[D] = add(times(places[E], k), shift(dice));
                group.places[F] = add(times(places[E], m), shift(dice));
            }
            Family::Straight => {
                let [_, c, ..] = from_joint(&mut group, B);
                group.places[G] = add(times(c, -ratio(dice)), shift(dice));
                let [_, _, d, e, ..] = group.places;
                let along = times(from_to(e, d), ratio(dice));
                group.places[F] = add(e, add(along, shift(dice)));
            }
            Family::Stretched => {
                let [b, ..] = from_joint(&mut group, C);
                group.places[D] = add(times(b, -ratio(dice)), shift(dice));
            }
            Family::Singular => concurrent(&mut group, shift(dice)),
            Family::SingularParallel => {
                let [b, _, _, e, _, g] = from_joint(&mut group, C);
                let (k, m) = (ratio(dice), ratio(dice));
                group.places[D] = add(times(from_to(b, e), k), shift(dice));
                group.places[F] = add(g, times(from_to(b, e), -m));
            }
            Family::Limit => at_limit(&mut group, parameter),
            Family::OuterTogether => {
                from_joint(&mut group, B);
                group.places[E] = shift(dice);
            }
            Family::ShortClosure => {
                from_joint(&mut group, C);
                group.places[D] = shift(dice);
            }
            Family::ShortDrag => {
                let [_, c, _, _, _, g] = from_joint(&mut group, B);
                group.places[C] = times(c, parameter);
                group.places[G] = times(g, parameter);
            }
            Family::ShortArm => {
                from_joint(&mut group, B);
                group.places[C] = shift(dice);
            }
            Family::LongDrag => {
                let [_, _, d, _, f, _] = from_joint(&mut group, E);
                group.places[D] = times(d, 1.0 / parameter);
                group.places[F] = times(f, 1.0 / parameter);
            }
            Family::Far => {
                let far = times(unit_and_more(dice), SIZE / parameter);
                group.places = group.places.map(|p| add(p, far));
            }
            Family::Units => {
                let smaller = |v| times(v, parameter);
                group = group.map(smaller, smaller, [parameter, parameter * parameter], 1.0);
            }
            Family::AtRest => {
                for base in &mut group.bases {
                    base.velocity = times(base.velocity, parameter);
                    base.acceleration = times(base.acceleration, parameter * parameter);
                }
            }
            Family::Rigid => {
                let [omega, alpha] = dice.pair();
                let [b, _, _, e, _, _] = group.places;
                let [x, y] = from_to(b, e);
                let square = omega * omega;
                let swing = [-omega * y, omega * x];
                let second = [-alpha * y - square * x, alpha * x - square * y];
                let [first, last] = &mut group.bases;
                last.velocity = add(add(first.velocity, swing), shift(dice));
                last.acceleration = add(add(first.acceleration, second), shift(dice));
            }
            Family::Common => {
                let common = times(unit_and_more(dice), 1.0 / parameter);
                for base in &mut group.bases {
                    base.velocity = add(base.velocity, common);
                    base.acceleration = add(base.acceleration, common);
                }
            }
        }
        group
    }
}

/// Indices of the joints.
const B: usize = 0;
const C: usize = 1;
const D: usize = 2;
const E: usize = 3;
const F: usize = 4;
const G: usize = 5;

/// About the size of a group.
const SIZE: f64 = 16.0;

/// A vector of length 1 to 8, few bits.
fn unit_and_more(dice: &mut Random) -> Pair {
    loop {
        let v = dice.pair();
        if libm::hypot(v[0], v[1]) >= 1.0 {
            return v;
        }
    }
}

/// From 0.5 to 2 but not near 1, where two joints would coincide; few bits.
fn ratio(dice: &mut Random) -> f64 {
    let below = (16 + dice.below(13)) as f64 / 32.0;
    let above = (36 + dice.below(29)) as f64 / 32.0;
    [below, above][dice.below(2)]
}

fn from_to(a: Pair, b: Pair) -> Pair {
    [b[0] - a[0], b[1] - a[1]]
}

/// Moves a joint into the origin; the places then.
fn from_joint(group: &mut Group, joint: usize) -> [Pair; 6] {
    let origin = group.places[joint];
    group.places = group.places.map(|p| from_to(origin, p));
    group.places
}

/// Brings CD, GF and BE through the origin, but for the shift of D.
fn concurrent(group: &mut Group, shift: Pair) {
    let middle = times(add(group.places[B], group.places[E]), 0.5);
    group.places = group.places.map(|p| from_to(middle, p));
    let [_, c, _, _, _, g] = group.places;
    group.places[D] = add(times(c, 1.5), shift);
    group.places[F] = times(g, -0.75);
}

/// A group that has left its limit position along its own mobility there, so far that its inputs have moved by the parameter.
///
/// With B and E held, links 2 and 4 turn about them and meet in the common point, here the origin: ω4 / ω2 follows from
/// the velocity of C along CD. The inputs change with the square of that motion.
fn at_limit(group: &mut Group, parameter: f64) {
    concurrent(group, [0.0; 2]);
    let [b, c, d, e, f, g] = group.places;
    let turned = |about: Pair, p: Pair| {
        let [x, y] = from_to(about, p);
        [-y, x]
    };
    // Velocities of C and D for unit rotations must agree along CD; D is 1.5 C, so CD is along C.
    let along = |v: Pair| v[0] * c[0] + v[1] * c[1];
    let second = along(turned(b, c)) / along(turned(e, d));
    let step = f64::sqrt(parameter) / SIZE;
    for (joint, about, rate) in [(C, b, 1.0), (G, b, 1.0), (D, e, second), (F, e, second)] {
        let p = [b, c, d, e, f, g][joint];
        group.places[joint] = add(p, times(turned(about, p), step * rate));
    }
}
