//! Which quantity a number is that somebody typed. It was worked out from the hand's own things, so it is held against what formulas give
//! with these; what the same formula gives with right things is the right number in its place.

use super::bench::Bench;
use super::entry::{Compute, Entry, LayOff};
use super::formula::Formula;
use super::table::{Made, Table};
use crate::construction::image_name;
use crate::mechanism::{BodyId, GROUND};
use crate::scene::Head;
use crate::sheet::{Order, Sheet};

/// What a number with three digits may be off by, in parts.
const ROUNDED: f64 = 0.006;

/// How far apart the same number may come out with the hand's own things and with right ones, in parts.
const APART: f64 = 0.25;

/// Most quantities that a number may be.
const MOST: usize = 4;

/// A size with the hand's own things and with right ones.
type Both = [f64; 2];

impl Bench<'_> {
    /// The right numbers in place of one that was typed, the likeliest first; none where it is no quantity of the hand's own. `wrongly`: also
    /// what usual mistakes make of one.
    fn recognised(&self, typed: f64, wrongly: bool) -> Vec<f64> {
        let off = |[own, _]: &Both| (own.abs() - typed.abs()).abs() / own.abs();
        let is_like = |both: &Both| (both[1] / both[0]).abs().ln().abs() < APART;
        let is_it = |both: &Both| off(both) <= ROUNDED && is_like(both);
        let mut all: Vec<Both> = self.worked_out(wrongly).into_iter().filter(is_it).collect();
        all.sort_by(|one, other| off(one).total_cmp(&off(other)));
        all.truncate(MOST);
        all.into_iter().map(|[_, right]| right.abs().copysign(typed)).collect()
    }

    /// An entry with typed numbers with the right ones in their place, the likeliest first; `wrongly` as for numbers.
    pub(super) fn with_right_numbers(&self, entry: &Entry, wrongly: bool) -> Vec<Entry> {
        let typed = match entry {
            Entry::LayOff(laid) => self.own.formula(&laid.size).ok(),
            Entry::Compute(_) => match self.own.carried_out_again(entry) {
                Ok(Made::Numbers(all)) => all.first().map(|(_, number)| *number),
                _ => None,
            },
            _ => None,
        };
        let all = typed.map_or_else(Vec::new, |typed| self.recognised(typed, wrongly)).into_iter();
        let instead = |number: f64| match entry {
            Entry::LayOff(laid) => {
                Some(Entry::LayOff(LayOff { size: Formula::read(&number.to_string()).ok()?, ..laid.clone() }))
            }
            Entry::Compute(compute) => {
                Some(Entry::Compute(Compute { by: None, value: Some(number), sense: None, ..compute.clone() }))
            }
            _ => None,
        };
        all.filter_map(instead).collect()
    }

    /// What these make in the scene.
    pub(super) fn made_with_right_numbers(&self, entry: &Entry, wrongly: bool) -> Vec<Made> {
        let all = self.with_right_numbers(entry, wrongly);
        all.iter().filter_map(|entry| self.right[0].carried_out_again(entry).ok()).collect()
    }

    fn worked_out(&self, wrongly: bool) -> Vec<Both> {
        let given = self.judge.given();
        let (mechanism, motion) = (given.mechanism(), &given.solution.motion);
        let both = |of: &dyn Fn(&Table<'_>) -> Option<f64>| Some([of(&self.own)?, of(&self.right[0])?]);
        let rate = |head: Head, id: BodyId, right: f64| {
            self.own.known(&head.of(&mechanism.body(id).name)).map(|own| [own, right])
        };
        let mut all = Vec::new();
        let mut omegas = Vec::new();
        for (id, _) in mechanism.links() {
            omegas.extend(rate(Head::Omega, id, motion.body(id).omega));
        }
        for (id, _) in mechanism.links() {
            let omega = rate(Head::Omega, id, motion.body(id).omega);
            let alpha = rate(Head::Alpha, id, motion.body(id).alpha);
            all.extend([omega, alpha].into_iter().flatten());
            let points = given.points_of(id);
            for (at, [name, a]) in points.iter().enumerate() {
                for [other, b] in &points[at + 1..] {
                    let apart = |sheet: Sheet, [a, b]: [&str; 2]| {
                        both(&|table| Some((table.place(sheet, a)? - table.place(sheet, b)?).norm()))
                    };
                    let Some(length) = apart(Sheet::Scheme, [a, b]) else { continue };
                    let velocity = apart(Sheet::Velocity, [&image_name(name), &image_name(other)]);
                    let squared = |omega: Both| product(omega, product(omega, length));
                    all.extend(omega.map(squared));
                    all.extend([omega, alpha].into_iter().flatten().map(|rate| product(rate, length)));
                    let over_length = |velocity: Both| product(velocity, [0, 1].map(|k| velocity[k] / length[k]));
                    all.extend(velocity.map(over_length));
                    if wrongly {
                        all.extend(omegas.iter().map(|omega| squared(*omega)));
                        all.extend(omegas.iter().map(|omega| squared(*omega).map(|size| 2.0 * size)));
                        let absolute = [name, other]
                            .map(|point| apart(Sheet::Velocity, [&image_name(point), Order::Velocity.pole()]));
                        all.extend(absolute.into_iter().flatten().map(over_length));
                    }
                }
            }
        }
        for id in mechanism.slider_ids() {
            let slide = &motion.slides[id.0];
            let rates = [(Head::SlideVelocity, slide.velocity), (Head::SlideAcceleration, slide.acceleration)];
            let [sliding, change] =
                rates.map(|(head, right)| self.own.known(&head.of(&mechanism.slider_name(id))).map(|own| [own, right]));
            let on = mechanism.slider(id).on;
            let turning = (on != GROUND).then(|| rate(Head::Omega, on, motion.body(on).omega)).flatten();
            let coriolis = turning.zip(sliding).map(|(omega, sliding)| product(omega, sliding));
            all.extend([sliding, change, coriolis.map(|size| size.map(|size| 2.0 * size))].into_iter().flatten());
            all.extend(coriolis.filter(|_| wrongly));
        }
        // Forces that the hand has found itself.
        for (name, own) in self.own.numbers().filter(|(name, _)| super::bench::is_size_of_force(name)) {
            all.extend(self.right[0].known(name).map(|right| [own, right]));
        }
        for sheet in Sheet::ALL {
            let names: Vec<&str> = given.places(sheet).map(|(name, _)| name).collect();
            for (at, from) in names.iter().enumerate() {
                all.extend(names[at + 1..].iter().filter_map(|to| {
                    both(&|table| Some((table.place(sheet, to)? - table.place(sheet, from)?).norm()))
                }));
            }
        }
        all.retain(|both| both.iter().all(|size| size.is_finite() && *size != 0.0));
        all
    }
}

fn product(a: Both, b: Both) -> Both {
    [a[0] * b[0], a[1] * b[1]]
}
