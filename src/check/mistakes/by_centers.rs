//! Mistakes with what follows from instant centres: ratios of distances, senses, velocities.

use super::site::{Candidate, Reinterpretation, Site, instead, times};
use super::told::{Blank, tell};
use crate::construction::{Along, Disturbance, Equation, NumberId, NumberKind, OperationKind, PlaceId};
use crate::geometry::{quarter_turn, unit};

/// The equation by which an angular velocity is found from distances of centres: operation, rate, its link's own distance and the driven link's.
fn ratios<'s>(site: &'s Site<'_>) -> impl Iterator<Item = (usize, NumberId, [NumberId; 2], &'s Equation)> {
    site.operations().filter_map(|(index, operation)| {
        let OperationKind::Solve { unknowns, equations } = &operation.kind else { return None };
        let ([rate], [equation]) = (unknowns.as_slice(), equations.as_slice()) else { return None };
        let is_by_centers = matches!(site.number_kind(*rate), NumberKind::RateByCenters(_));
        let own = equation.left.first()?.1.of.first()?;
        let driven = equation.right.first()?.of.last()?;
        is_by_centers.then_some((index, *rate, [*own, *driven], equation))
    })
}

/// The ratio of two distances taken upside down.
pub(super) fn ratio_inverted(site: &Site<'_>) -> Vec<Candidate> {
    let inverted = ratios(site).map(|(index, rate, [own, driven], equation)| {
        let mut equation = equation.clone();
        let exchanged = |number: &mut NumberId| match *number {
            n if n == own => *number = driven,
            n if n == driven => *number = own,
            _ => {}
        };
        equation.left.iter_mut().flat_map(|(_, product)| &mut product.of).for_each(exchanged);
        equation.right.iter_mut().flat_map(|product| &mut product.of).for_each(exchanged);
        let told = tell::ratio_inverted(site.symbol(rate), site.quantity(driven), site.quantity(own));
        let kind = OperationKind::Solve { unknowns: vec![rate], equations: vec![equation] };
        site.candidate(told, instead(index, kind))
    });
    inverted.collect()
}

/// The sense of an angular velocity by centres, or of a velocity, reversed: in all that follows, or only as it is written.
pub(super) fn sense_by_center(site: &Site<'_>) -> Vec<Candidate> {
    let mut all = Vec::new();
    for (index, rate, ..) in ratios(site) {
        let told = || tell::sense_by_center(site.symbol(rate));
        all.push(site.candidate(told(), times(index, rate, -1.0)));
        let reads = |entry: &usize| site.model.readings[*entry].is_ok_and(|reading| reading.number == rate);
        for entry in (0..site.entries.len()).filter(reads).filter(|entry| !site.entries[*entry].is_magnitude) {
            let written = &site.entries[entry];
            let meant = Reinterpretation { entry, value: -written.value, rounding: written.rounding };
            all.push(Candidate { reinterpreted: vec![meant], ..Candidate::at(told(), written.step) });
        }
    }
    all.extend(
        velocities(site)
            .map(|velocity| site.candidate(tell::velocity_reversed(velocity.quantity()), velocity.turned(2))),
    );
    all
}

/// A velocity by centres laid off along its ray.
pub(super) fn velocity_along_ray(site: &Site<'_>) -> Vec<Candidate> {
    let along = velocities(site).flat_map(|velocity| {
        let told = tell::velocity_along_ray(velocity.quantity());
        [1, 3].map(|turns| site.candidate(told.clone(), velocity.turned(turns)))
    });
    along.collect()
}

/// A velocity that is laid off on the figure of centres.
struct Velocity<'s> {
    site: &'s Site<'s>,
    operation: usize,
    place: PlaceId,
    from: PlaceId,
    size: NumberId,
    along: Along,
    /// Its own size, in units of velocity.
    speed: NumberId,
}

fn velocities<'s>(site: &'s Site<'_>) -> impl Iterator<Item = Velocity<'s>> {
    site.operations().filter_map(move |(operation, done)| {
        let OperationKind::LayOff { place, from, size, along } = done.kind else { return None };
        let OperationKind::Compute { sum, .. } = &site.operation(site.model.makers[size.0]?).kind else { return None };
        let speed = *sum.first()?.of.first()?;
        let is_by_centers = matches!(site.number_kind(speed), NumberKind::SpeedByCenters(_));
        is_by_centers.then_some(Velocity { site, operation, place, from, size, along, speed })
    })
}

impl Velocity<'_> {
    fn quantity(&self) -> Blank {
        self.site.quantity(self.speed)
    }

    /// The distance that is multiplied.
    fn arm(&self) -> Option<NumberId> {
        match &self.site.operation(self.site.model.makers[self.speed.0]?).kind {
            OperationKind::Compute { sum, .. } => sum.first()?.of.last().copied(),
            _ => None,
        }
    }

    fn laid(&self, along: Along) -> Disturbance {
        let &Velocity { place, from, size, .. } = self;
        instead(self.operation, OperationKind::LayOff { place, from, size, along })
    }

    fn turned(&self, quarter_turns: u8) -> Disturbance {
        self.laid(self.along.turned(quarter_turns))
    }
}

/// A velocity with the distance from another centre, normal to the ray from there: the distance alone is `lengths::wrong_distance`.
pub(super) fn from_wrong_center(site: &Site<'_>) -> Vec<Candidate> {
    let distances = super::lengths::wrong_distance(site);
    let mut all = distances.clone();
    for velocity in velocities(site) {
        let Some(arm) = velocity.arm() else { continue };
        let Some(maker) = site.model.makers[arm.0] else { continue };
        let OperationKind::Measure { from, to, .. } = site.operation(maker).kind else { continue };
        for mut candidate in distances.iter().cloned() {
            let Some(&OperationKind::Measure { from: own, to: end, .. }) = candidate.instead_of(maker) else {
                continue;
            };
            let ray = site.model.exact.place(end) - site.model.exact.place(own);
            let Some(normal) = unit(quarter_turn(ray)).filter(|_| own != from && end == to) else { continue };
            candidate.edits.push(velocity.laid(Along::given(normal)));
            all.push(candidate);
        }
    }
    all
}
