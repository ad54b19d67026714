//! Mistakes with loads; and the force plan in which mistakes with forces are looked for.

use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::construction::{
    Along, Change, Disturbance, ForceOf, ForcePlan, LoadShown, NumberId, OperationKind, OperationRole, PlaceId,
    Product, Solution, Teller, plain_text,
};
use crate::forces::Source;
use crate::geometry::{Vector, unit};
use crate::mechanism::{BodyId, PointId};
use crate::scene::Amount;

/// The force plan of a construction in which mistakes are looked for.
pub(super) struct Drawn<'s> {
    pub site: &'s Site<'s>,
    pub plan: &'s ForcePlan,
}

/// The candidates that a function finds where there are forces.
pub(super) fn found(site: &Site<'_>, find: impl Fn(&Drawn<'_>) -> Vec<Candidate>) -> Vec<Candidate> {
    Drawn::of(site).map_or_else(Vec::new, |drawn| find(&drawn))
}

impl<'s> Drawn<'s> {
    /// None where the figure has neither a force plan nor a lever.
    fn of(site: &'s Site<'_>) -> Option<Drawn<'s>> {
        let plan = site.model.construction.forces.as_deref()?;
        Some(Drawn { site, plan })
    }

    pub fn solution(&self) -> &'s Solution {
        self.site.key.solution
    }

    /// The step that first needs a number.
    pub fn first_step(&self, number: NumberId) -> usize {
        let uses = self.uses(number).next();
        uses.map_or(0, |index| self.site.model.steps[index])
    }

    /// The operations that use a number.
    pub fn uses(&self, number: NumberId) -> impl Iterator<Item = usize> {
        let reads = move |kind: &OperationKind| {
            let mut found = false;
            kind.each_number_read(|other| found |= other == number);
            found
        };
        self.site.operations().filter(move |(_, operation)| reads(&operation.kind)).map(|(index, _)| index)
    }

    /// A number that is made, multiplied in all that follows.
    pub fn times(&self, number: NumberId, factor: f64) -> Option<Disturbance> {
        Some(times(self.site.model.makers[number.0]?, number, factor))
    }

    /// Several changes as one mistake, at a step.
    pub fn together(&self, told: Told, edits: Vec<Disturbance>, step: Option<usize>) -> Option<Candidate> {
        let first = edits.iter().map(|edit| edit.operation).min()?;
        let step = step.unwrap_or(self.site.model.steps[first]);
        Some(Candidate { edits, ..Candidate::at(told, step) })
    }

    /// Changes of numbers that are taken, at the step that first needs one of them.
    pub fn of_numbers(&self, told: Told, edits: Vec<(NumberId, Change)>) -> Option<Candidate> {
        let step = edits.iter().map(|(number, _)| self.first_step(*number)).min()?;
        let edit = |(number, change): (NumberId, Change)| {
            Some(Disturbance { operation: self.site.model.makers[number.0]?, change })
        };
        self.together(told, edits.into_iter().filter_map(edit).collect(), Some(step))
    }

    fn teller<T>(&self, tell: impl FnOnce(&Teller<'_>) -> T) -> T {
        let words = self.solution().wording();
        tell(&Teller::new(self.solution(), &words))
    }

    /// A force by its symbol.
    pub fn symbol(&self, of: ForceOf) -> Blank {
        self.teller(|teller| Blank::Words(plain_text(&teller.force_symbol(of))))
    }

    /// A load by its symbol.
    pub fn load_symbol(&self, load: &LoadShown) -> Blank {
        self.teller(|teller| Blank::Words(plain_text(&teller.load_symbol(load.source, load.body))))
    }

    fn couple_symbol(&self, load: &LoadShown) -> Blank {
        self.teller(|teller| Blank::Words(plain_text(&teller.couple_symbol(load.source, load.body))))
    }

    pub fn link(&self, body: BodyId) -> Blank {
        self.solution().mechanism.body(body).name.as_str().into()
    }

    /// The loads, with their indices.
    pub fn loads(&self) -> impl Iterator<Item = (usize, &'s LoadShown)> {
        self.plan.loads.iter().enumerate()
    }

    /// The sizes of a load's force: in polygons and moments, and on levers.
    pub fn force_numbers(&self, load: usize) -> Vec<NumberId> {
        let own = self.plan.numbers.loads.get(load).and_then(|numbers| numbers[0]);
        own.into_iter().chain(self.on_levers(load, false)).filter(|number| self.is_there(*number)).collect()
    }

    /// The sizes of a load's couple, and of the forces on levers that stand for it.
    pub fn couple_numbers(&self, load: usize) -> Vec<NumberId> {
        let own = self.plan.numbers.loads.get(load).and_then(|numbers| numbers[1]);
        own.into_iter().chain(self.on_levers(load, true)).filter(|number| self.is_there(*number)).collect()
    }

    fn on_levers(&self, load: usize, is_of_couple: bool) -> impl Iterator<Item = NumberId> {
        let forces = self.site.model.construction.levers.iter().flat_map(|lever| &lever.forces);
        forces
            .filter(move |force| force.load == load && force.is_of_couple == is_of_couple)
            .map(|force| force.numbers[0])
    }

    fn is_there(&self, number: NumberId) -> bool {
        self.site.model.makers[number.0].is_some()
    }

    /// A load's force `factor` times as large wherever it is used.
    fn force_times(&self, load: usize, factor: f64, told: Told) -> Option<Candidate> {
        let times = |number| (number, Change::Times(number, factor));
        self.of_numbers(told, self.force_numbers(load).into_iter().map(times).collect())
    }

    /// A load's couple `factor` times as large wherever it is used.
    fn couple_times(&self, load: usize, factor: f64, told: Told) -> Option<Candidate> {
        let times = |number| (number, Change::Times(number, factor));
        self.of_numbers(told, self.couple_numbers(load).into_iter().map(times).collect())
    }

    /// The sums that have a number, with its products reversed.
    fn reversed_in_sums(&self, number: NumberId) -> Vec<Disturbance> {
        let reversed = |products: &mut Vec<Product>| {
            let own = products.iter_mut().filter(|product| product.of.contains(&number));
            own.for_each(|product| product.factor = -product.factor);
        };
        let sums = self.uses(number).map(|index| {
            let mut kind = self.site.operation(index).kind.clone();
            match &mut kind {
                OperationKind::Compute { sum, .. } => reversed(sum),
                OperationKind::Solve { equations, .. } => {
                    equations.iter_mut().for_each(|equation| reversed(&mut equation.right));
                }
                _ => {}
            }
            instead(index, kind)
        });
        sums.collect()
    }

    /// Another force in place of a load's.
    fn force_instead(&self, load: usize, force: Vector, told: Told) -> Option<Candidate> {
        let shown = &self.plan.loads[load];
        let numbers = self.force_numbers(load);
        let (right, wrong) = (unit(shown.force)?, unit(force)?);
        let mut candidate = self.of_numbers(
            told,
            numbers.iter().map(|number| (*number, Change::Written(*number, force.norm()))).collect(),
        )?;
        let along = Along::given(right);
        let turned = Along::given(wrong);
        let sizes: Vec<NumberId> = self.sizes_of(&numbers);
        for (index, operation) in self.site.operations() {
            let kind = match operation.kind {
                OperationKind::LayOff { place, from, size, along: own } if own == along && sizes.contains(&size) => {
                    OperationKind::LayOff { place, from, size, along: turned }
                }
                OperationKind::Draw { line, through, along: own }
                    if own == along && operation.role == OperationRole::ForceLine && self.is_at(load, through) =>
                {
                    OperationKind::Draw { line, through, along: turned }
                }
                _ => continue,
            };
            candidate.edits.push(instead(index, kind));
        }
        Some(candidate)
    }

    /// Whether a place is that of a load: on the scheme or on a lever.
    fn is_at(&self, load: usize, place: PlaceId) -> bool {
        let mut on_levers = self.site.model.construction.levers.iter().flat_map(|lever| &lever.forces);
        if on_levers.any(|force| force.load == load && force.place == place) {
            return true;
        }
        let at = self.plan.loads[load].at - self.site.model.construction.origin;
        (self.site.model.exact.place(place) - at).norm() <= 1e-6 * at.norm().max(1.0)
    }

    /// The computed sizes of vectors that are these numbers alone.
    pub fn sizes_of(&self, numbers: &[NumberId]) -> Vec<NumberId> {
        let sizes = self.site.operations().filter_map(|(_, operation)| match &operation.kind {
            OperationKind::Compute { number, sum } => match sum.as_slice() {
                [product] if product.of.len() == 1 && numbers.contains(&product.of[0]) => Some(*number),
                _ => None,
            },
            _ => None,
        });
        sizes.collect()
    }
}

/// The forces of inertia along the accelerations.
pub(super) fn inertia_along(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let inertia = drawn.loads().filter(|(_, load)| load.source == Source::Inertia);
        let mut all: Vec<Candidate> = inertia
            .filter_map(|(index, load)| drawn.force_times(index, -1.0, tell::inertia_along_a(drawn.load_symbol(load))))
            .collect();
        all.extend(all_of(&all, first_blank, tell::inertia_along_a));
        all
    })
}

/// The same mistake with all of several loads: its first blank has the symbols of all.
pub(super) fn all_of(
    each: &[Candidate],
    blanks: impl Fn(&Told) -> Vec<Blank>,
    tell: fn(Blank) -> Told,
) -> Option<Candidate> {
    if each.len() < 2 {
        return None;
    }
    let symbols = each.iter().filter_map(|one| Some(blanks(&one.told).first()?.text().to_owned()));
    let told = tell(Blank::Words(symbols.collect::<Vec<_>>().join(", ")));
    let edits = each.iter().flat_map(|one| one.edits.iter().cloned()).collect();
    let step = each.iter().map(|one| one.step).min()?;
    Some(Candidate { edits, ..Candidate::at(told, step) })
}

pub(super) fn first_blank(told: &Told) -> Vec<Blank> {
    told.blanks.iter().map(|(_, blank)| blank.clone()).collect()
}

/// The couples of inertia in the sense of the angular acceleration.
pub(super) fn couple_along(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let inertia = drawn.loads().filter(|(_, load)| load.source == Source::Inertia);
        let mut all: Vec<Candidate> = inertia
            .filter_map(|(index, load)| {
                drawn.couple_times(index, -1.0, tell::inertia_couple_along_alpha(drawn.couple_symbol(load)))
            })
            .collect();
        all.extend(all_of(&all, first_blank, tell::inertia_couple_along_alpha));
        all
    })
}

/// The force of inertia on the wrong side of the centre: its moments have the couple the wrong way round, which is written right.
pub(super) fn percussion(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let both = drawn.loads().filter_map(|(index, load)| {
            let numbers = drawn.couple_numbers(index);
            let is_one_force = load.source == Source::Inertia && !drawn.force_numbers(index).is_empty();
            if !is_one_force || numbers.is_empty() {
                return None;
            }
            let edits = numbers.iter().flat_map(|number| drawn.reversed_in_sums(*number)).collect();
            let step = numbers.iter().map(|number| drawn.first_step(*number)).min();
            drawn.together(tell::percussion_on_wrong_side(drawn.load_symbol(load)), edits, step)
        });
        both.collect()
    })
}

/// A couple left out of the moments: of a load, or what a guide hands on.
pub(super) fn couple_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        // Friction that is left out is `friction-left-out`.
        let of_loads = drawn.loads().filter(|(_, load)| !matches!(load.source, Source::Friction(_)));
        let mut all: Vec<Candidate> = of_loads
            .filter_map(|(index, load)| {
                drawn.couple_times(index, 0.0, tell::couple_forgotten(drawn.couple_symbol(load)))
            })
            .collect();
        all.extend(all_of(&all, first_blank, tell::couple_forgotten));
        all
    })
}

/// Accelerations that somebody takes for that of a link's centre of mass.
struct Taken {
    /// The load that is the link's force of inertia.
    load: usize,
    /// The joint.
    point: PointId,
    right: Vector,
    /// That of the joint.
    of_point: Vector,
    /// That of the centre without its centripetal part about the joint.
    without: Vector,
}

impl Drawn<'_> {
    fn taken(&self) -> Vec<Taken> {
        let Solution { mechanism, pose, motion, .. } = self.solution();
        let inertia = self.loads().filter(|(_, load)| load.source == Source::Inertia);
        let all = inertia.flat_map(|(index, load)| {
            let body = motion.body(load.body);
            let right = body.acceleration_at(load.at);
            mechanism.body(load.body).points.iter().map(move |&point| {
                let at = pose.point(point);
                let without = right + (load.at - at) * (body.omega * body.omega);
                Taken { load: index, point, right, of_point: body.acceleration_at(at), without }
            })
        });
        all.collect()
    }

    /// The force of inertia by a wrong acceleration.
    fn by_acceleration(&self, taken: &Taken, wrong: Vector, told: Told) -> Option<Candidate> {
        let load = &self.plan.loads[taken.load];
        let amount = load.force.norm() / taken.right.norm();
        if !amount.is_finite() || (wrong - taken.right).norm() <= 1e-3 * taken.right.norm() {
            return None;
        }
        let force = wrong * -amount;
        match force.norm() > 1e-9 * load.force.norm() {
            true => self.force_instead(taken.load, force, told),
            false => self.force_times(taken.load, 0.0, told),
        }
    }

    fn point(&self, point: PointId) -> Blank {
        self.solution().mechanism.point_name(point).into()
    }
}

/// The acceleration of a joint in place of that of the centre of mass.
pub(super) fn joint_for_center(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let all = drawn.taken();
        let wrong = all.iter().filter_map(|taken| {
            let load = drawn.load_symbol(&drawn.plan.loads[taken.load]);
            let told = tell::a_of_joint_for_centre(load, drawn.point(taken.point));
            drawn.by_acceleration(taken, taken.of_point, told)
        });
        wrong.collect()
    })
}

/// The centripetal part left out of the acceleration of the centre of mass.
pub(super) fn centripetal_left_out(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let all = drawn.taken();
        let wrong = all.iter().filter_map(|taken| {
            let load = drawn.load_symbol(&drawn.plan.loads[taken.load]);
            let told = tell::centripetal_part_left_out(load, drawn.point(taken.point));
            drawn.by_acceleration(taken, taken.without, told)
        });
        wrong.collect()
    })
}

/// Powers of ten by which units of mass and acceleration slip.
const THOUSANDS: [f64; 2] = [1e3, 1e-3];

/// The mass taken for the weight; forces of inertia and weights in another unit.
pub(super) fn mass_for_weight(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let loads = drawn.solution().mechanism.loads.as_deref().map(|(loads, _)| loads);
        let mass = |body: BodyId| {
            let name = drawn.solution().mechanism.body(body).name.as_str();
            let mut masses = loads.into_iter().flat_map(|loads| &loads.masses);
            masses.find(|(link, _)| *link == name).and_then(|(_, mass)| match mass.amount {
                Amount::Mass(amount) => Some(amount),
                Amount::Weight(_) => None,
            })
        };
        let mut all = Vec::new();
        let mut together: Vec<Vec<Candidate>> = vec![Vec::new(); THOUSANDS.len()];
        for (index, load) in drawn.loads() {
            if load.source == Source::Weight
                && let Some(mass) = mass(load.body)
            {
                let told = tell::mass_for_weight(drawn.load_symbol(load));
                all.extend(drawn.force_times(index, mass / load.force.norm(), told));
            }
            if !matches!(load.source, Source::Weight | Source::Inertia) {
                continue;
            }
            for (place, factor) in THOUSANDS.into_iter().enumerate() {
                let told = tell::factor_of_thousand(drawn.load_symbol(load));
                let forces = drawn.force_times(index, factor, told);
                // A thousandth of a couple is as good as none: `couple_forgotten`.
                let couple = drawn.couple_times(index, factor, tell::factor_of_thousand(drawn.couple_symbol(load)));
                let couple = couple.filter(|_| factor > 1.0);
                together[place].extend(forces.iter().filter(|_| load.source == Source::Inertia).cloned());
                all.extend(forces);
                all.extend(couple);
            }
        }
        all.extend(together.iter().filter_map(|each| all_of(each, first_blank, tell::factor_of_thousand)));
        all
    })
}
