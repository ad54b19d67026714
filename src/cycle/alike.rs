//! The assemblies of many mechanisms that differ in their numbers alone, from those of one of them.

use super::Variants;
use super::position::start;
use crate::geometry::{MANY, Point};
use crate::kernel::{Kernel, Single};
use crate::mechanism::{Class, GROUND, Joint, Mechanism, PointId};
use crate::position::Pose;
use crate::quantity::State;

/// By how much, in parts of itself, the next assembly must be farther from the rough places than the nearest one.
const CLEARLY: f64 = 1e-9;

/// A mechanism with all of its assemblies, from which those of others are found that differ in their numbers alone.
///
/// A dyad of pins, or of pins and a slider on the ground, has two assemblies at most, and its determinant has another sign in each.
/// So a chain of such dyads has no more than one for each choice of signs, and a mechanism in which all choices are found has no
/// other.
#[derive(Clone, Debug)]
pub(crate) struct Assemblies {
    kernel: Kernel,
    /// The pose, the position and by group whether its determinant is positive.
    all: Vec<(Pose, Single, Vec<bool>)>,
    rough: Vec<(PointId, Point)>,
}

/// How a mechanism stands in one of its assemblies.
#[derive(Clone)]
struct Standing {
    /// By group, whether its determinant is positive; none where it did not close, or is singular.
    signs: Option<Vec<bool>>,
    /// Sum of squared distances from the rough places.
    distance: f64,
}

impl Assemblies {
    /// A mechanism with all of its assemblies, and rough places of the one that is wanted. `None` where its groups are not of that kind, or it
    /// does not have an assembly for each choice of signs.
    pub fn new(mechanism: &Mechanism, poses: Vec<Pose>, rough: Vec<(PointId, Point)>) -> Option<Self> {
        let has_two = mechanism.groups.iter().all(|group| group.class == Class::Second);
        let on_ground = mechanism.sliders.iter().all(|slider| slider.on == GROUND && slider.drive.is_none());
        let is_geared =
            |joint: &Joint| joint.angular.as_ref().is_some_and(|angular| angular.as_fixed_angle().is_none());
        let choices = 1_usize.checked_shl(mechanism.groups.len() as u32)?;
        if !has_two
            || !on_ground
            || mechanism.joints.iter().any(is_geared)
            || rough.is_empty()
            || poses.len() != choices
        {
            return None;
        }
        let kernel = Kernel::new(mechanism)?;
        let mut all: Vec<(Pose, Single, Vec<bool>)> = Vec::new();
        for pose in poses {
            let mut block = start(&kernel, mechanism, &pose);
            let is_closed = kernel.assemble(&mut block, 0.0).closed;
            let determinants = kernel.determinants(&block);
            if !is_closed || determinants.iter().any(|[determinant, _]| *determinant == 0.0) {
                return None;
            }
            let signs = determinants.iter().map(|[determinant, _]| *determinant > 0.0).collect();
            if all.iter().any(|(_, _, other)| *other == signs) {
                return None;
            }
            all.push((pose, block, signs));
        }
        Some(Assemblies { kernel, all, rough })
    }

    /// The mechanisms, each in its assembly nearest to the rough places: that in which [`pose`](crate::position::pose) would find it. Every
    /// assembly is moved to the lengths of all of them. By mechanism comes whether that surely found all of its assemblies; those of which it
    /// is not sure stand anywhere. `None` where a mechanism is of another kind.
    pub fn nearest<'a>(&self, mechanisms: &'a [Mechanism]) -> Option<(Variants<'a>, Vec<bool>)> {
        let (mut variants, is_like) = Variants::unplaced(self.kernel.clone(), mechanisms);
        if !is_like {
            return None;
        }
        let mut found = Vec::new();
        for (pose, start, _) in &self.all {
            for mechanism in 0..mechanisms.len() {
                variants.put((&start.turns, &start.slides), 0, mechanism);
                variants.start_drives(mechanism, pose);
            }
            variants.compute();
            let standings = (0..mechanisms.len()).map(|mechanism| variants.standing(mechanism, &self.rough));
            found.push((standings.collect::<Vec<Standing>>(), variants.kept()));
        }
        let nearest = |mechanism: usize| {
            let has = |((standings, _), (_, _, signs)): (&(Vec<Standing>, _), &(_, _, Vec<bool>))| {
                standings[mechanism].signs.as_ref() == Some(signs)
            };
            let all_found = found.iter().zip(&self.all).all(has);
            let mut order: Vec<usize> = (0..found.len()).collect();
            let distance = |index: usize| found[index].0[mechanism].distance;
            order.sort_by(|a, b| distance(*a).total_cmp(&distance(*b)));
            let is_clear = order.get(1).is_none_or(|next| distance(*next) > (1.0 + CLEARLY) * distance(order[0]));
            (all_found && is_clear).then_some(order[0])
        };
        let chosen: Vec<Option<usize>> = (0..mechanisms.len()).map(nearest).collect();
        for (mechanism, chosen) in chosen.iter().enumerate() {
            variants.put_back(mechanism, &found[chosen.unwrap_or_default()].1);
        }
        variants.compute();
        Some((variants, chosen.iter().map(Option::is_some).collect()))
    }
}

impl Variants<'_> {
    /// Where a mechanism is now, with its distance from rough places.
    fn standing(&self, mechanism: usize, rough: &[(PointId, Point)]) -> Standing {
        let Some(position) = self.position(mechanism) else {
            return Standing { signs: None, distance: f64::INFINITY };
        };
        let groups = 0..position.mechanism.groups.len();
        let inverse = groups.map(|group| position.kernel.inverse_determinant(position.block, group, mechanism % MANY));
        let is_positive = |inverse: f64| (inverse != 0.0 && inverse.is_finite()).then_some(inverse > 0.0);
        let distance = rough.iter().map(|(point, place)| (position.place(*point) - place).norm_squared()).sum();
        Standing { signs: inverse.map(is_positive).collect(), distance }
    }
}
