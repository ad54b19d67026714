//! The comparison of values with a construction once more, about the errors that the values themselves tell. To first order about a drawing without errors is too far where
//! an arm is short, lines cross under small angles, or a product is written of what is off by some per cent: there a right explanation would fit worse than one whose
//! amount is fitted.
//!
//! The likeliest errors ê follow from the first comparison; about a drawing with these, f(ê), the values are f(ê) + J (e − ê): a prediction f(ê) − J ê, with the
//! covariance that J gives (Gauss and Newton; B. M. Bell and F. W. Cathey, IEEE Trans. Autom. Control 38, 1993).

use super::covariance::{Covariances, ErrorEffect, Habit, Hand, effects_of_errors};
use super::fit::Fit;
use super::mistakes::Candidate;
use super::model::{Changes, in_order};
use super::score::{Compared, Scorer, Walk};
use crate::construction::{Change, Disturbance};
use nalgebra::{DMatrix, DVector};

/// Steps towards the likeliest errors.
const STEPS: usize = 2;

/// Largest likeliest error that is believed, in standard deviations: what needs more is no honest drawing with these mistakes.
const LARGEST: f64 = 3.0;

/// The replays from which values are read, with the data of each.
type Variants = Vec<(Changes, Vec<usize>)>;

impl Scorer<'_> {
    /// A better comparison of a set that is compared already; `None` where there is none.
    pub fn nearer(&self, set: &[&Candidate], fit: &Fit) -> Option<Fit> {
        // Whoever draws with a program has errors so small that first order will do; friction comes round in no replay.
        if !fit.hand.is_by_hand() || self.rubs() {
            return None;
        }
        let (mut best, mut about) = (None::<Fit>, About::first(self, set)?);
        for _ in 0..STEPS {
            about = about.next(self, set, &fit.hand)?;
            let found = self.compared_with(set, about.predicted.clone(), &about.covariances, |hands| {
                for habit in [Habit::Mixed, Habit::AsWritten] {
                    hands.consider(Hand { habit, ..fit.hand });
                }
                hands.search_computing();
            });
            let least = best.as_ref().map_or(fit.cost, |best| best.cost);
            best = found.filter(|found| found.cost < least).or(best);
        }
        best.map(|best| Fit { predicted: fit.predicted.clone(), ..best })
    }
}

/// A drawing with mistakes and with errors, about which others are compared to first order.
struct About {
    effects: Vec<ErrorEffect>,
    covariances: Covariances,
    /// The values that it lets expect without errors.
    predicted: Vec<f64>,
}

impl About {
    /// A drawing without errors.
    fn first(scorer: &Scorer<'_>, set: &[&Candidate]) -> Option<About> {
        About::with(scorer, set, &scorer.variants(set), &[])
    }

    /// A drawing with these errors, in standard deviations.
    fn with(scorer: &Scorer<'_>, set: &[&Candidate], variants: &Variants, errors: &[f64]) -> Option<About> {
        let model = scorer.model(set);
        let effects = effects_of_errors(model, &scorer.tolerance, &scorer.data, variants);
        let mut predicted = scorer.read_from(set, variants);
        for (effect, error) in effects.iter().zip(errors).filter(|(_, error)| **error != 0.0) {
            predicted.iter_mut().zip(&effect.column).for_each(|(value, by)| *value -= by * error);
        }
        let free = Scorer::free(set);
        let covariances = Covariances::new(model, &scorer.tolerance, &scorer.data, variants, &free, None);
        predicted.iter().all(|value| value.is_finite()).then_some(About { effects, covariances, predicted })
    }

    /// The drawing with the likeliest errors, as this one tells them.
    fn next(&self, scorer: &Scorer<'_>, set: &[&Candidate], hand: &Hand) -> Option<About> {
        let meant = scorer.meant(set);
        let mut walk = Walk::new(meant.len());
        let compared = Compared { meant: &meant, predicted: &self.predicted, without: &scorer.without };
        walk.run(&self.covariances, hand, compared);
        let inside: Vec<usize> = (0..meant.len()).filter(|&index| !walk.outside[index]).collect();
        let (mut sum, mut own) = (vec![0.0; meant.len() * meant.len()], vec![1.0; meant.len()]);
        self.covariances.sum(hand, &mut sum, &mut own);
        let covariance = DMatrix::from_fn(inside.len(), inside.len(), |i, j| {
            let (row, column) = (inside[i], inside[j]);
            let rounding = if row == column { own[row].max(0.25) * meant[row].variance() } else { 0.0 };
            sum[row * meant.len() + column] + rounding
        });
        let off = DVector::from_iterator(inside.len(), inside.iter().map(|&index| walk.off[index]));
        let weights = covariance.cholesky()?.solve(&off);
        let likeliest = |effect: &ErrorEffect| {
            let size = hand.errors[effect.group];
            let told: f64 =
                inside.iter().zip(weights.iter()).map(|(&index, weight)| effect.column[index] * weight).sum();
            size * size * told
        };
        let errors: Vec<f64> = self.effects.iter().map(likeliest).collect();
        if !errors.iter().all(|error| error.abs() <= LARGEST) {
            return None;
        }
        let changes: Vec<Disturbance> = self
            .effects
            .iter()
            .zip(&errors)
            .map(|(effect, error)| {
                let change = Change::Error(effect.which, error * effect.deviation);
                Disturbance { operation: effect.operation, change }
            })
            .collect();
        let with_errors = |(own, data): (Changes, Vec<usize>)| (in_order(own.iter().chain(&changes)), data);
        let variants: Variants = scorer.variants(set).into_iter().map(with_errors).collect();
        About::with(scorer, set, &variants, &errors)
    }
}
