//! The assemblies of many mechanisms that differ in their numbers alone, from those of one of them.

use super::Variants;
use crate::geometry::{MANY, Point};
use crate::mechanism::{Class, GROUND, Mechanism, PointId};
use crate::position::Pose;
use crate::quantity::State;

/// By how much, in parts of itself, the next assembly must be farther from the rough places than the nearest one.
const CLEARLY: f64 = 1e-9;

/// How a mechanism stands in one of its assemblies.
#[derive(Clone)]
struct Standing {
    /// By group, whether its determinant is positive; none where it did not close, or is singular.
    signs: Option<Vec<bool>>,
    /// Sum of squared distances from the rough places.
    distance: f64,
}

impl<'a> Variants<'a> {
    /// The mechanisms, each in its assembly nearest to rough places: that in which [`pose`](crate::position::pose) would find it. Every
    /// assembly of the first mechanism, `poses`, is moved to the lengths of the others. By mechanism comes whether that surely found
    /// all of its assemblies; those of which it is not sure stand anywhere.
    ///
    /// A dyad of pins, or of pins and a slider on the ground, has two assemblies at most, and its determinant has another sign in each.
    /// So a chain of such dyads has no more than one for each choice of signs, and a mechanism in which all choices are found has no
    /// other. `None` where the groups are not of that kind, or the first mechanism does not have all.
    pub(crate) fn nearest(
        mechanisms: &'a [Mechanism],
        poses: &[Pose],
        rough: &[(PointId, Point)],
    ) -> Option<(Self, Vec<bool>)> {
        let first = mechanisms.first()?;
        let has_two = first.groups.iter().all(|group| group.class == Class::Second);
        let on_ground = first.sliders.iter().all(|slider| slider.on == GROUND && slider.drive.is_none());
        let choices = 1_usize.checked_shl(first.groups.len() as u32)?;
        if !has_two || !on_ground || rough.is_empty() || poses.len() != choices {
            return None;
        }
        let mut variants = Variants::all_in(mechanisms, &poses[0])?;
        let mut found = Vec::new();
        for pose in poses {
            variants.start_all_in(pose);
            variants.compute();
            let standings = (0..mechanisms.len()).map(|mechanism| variants.standing(mechanism, rough));
            found.push((standings.collect::<Vec<Standing>>(), variants.kept()));
        }
        let of_first = |(standings, _): &(Vec<Standing>, _)| standings[0].signs.clone();
        let signs: Vec<Vec<bool>> = found.iter().map(of_first).collect::<Option<_>>()?;
        let are_distinct = (1..signs.len()).all(|index| !signs[..index].contains(&signs[index]));
        if !are_distinct {
            return None;
        }
        let nearest = |mechanism: usize| {
            let all_found = found
                .iter()
                .zip(&signs)
                .all(|((standings, _), signs)| standings[mechanism].signs.as_ref() == Some(signs));
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

    /// Where a mechanism is now, with its distance from rough places.
    fn standing(&self, mechanism: usize, rough: &[(PointId, Point)]) -> Standing {
        let Some(position) = self.position(mechanism) else {
            return Standing { signs: None, distance: f64::INFINITY };
        };
        let lane = mechanism % MANY;
        let groups = 0..position.mechanism.groups.len();
        let inverse = groups.map(|group| position.kernel.inverse_determinants(position.block, group)[lane]);
        let is_positive = |inverse: f64| (inverse != 0.0 && inverse.is_finite()).then_some(inverse > 0.0);
        let distance = rough.iter().map(|(point, place)| (position.place(*point) - place).norm_squared()).sum();
        Standing { signs: inverse.map(is_positive).collect(), distance }
    }
}
