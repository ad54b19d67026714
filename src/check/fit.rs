//! The complete comparison of values with a construction: with the covariance that honest errors give them, for the
//! hand for which they are likeliest.

use super::covariance::{CAREFUL, Covariances, Habit, Hand, SIZES, SLIPS};
use super::mistakes::Candidate;
use super::model::{COMPUTING, LEANING, TOGETHER, drawn_on};
use super::score::{Compared, Scorer, Walk};
use crate::sheet::Sheet;

/// Difference in −2 ln of the likelihood below which two explanations fit equally well: a factor of two.
const SAME_FIT: f64 = 1.4;

/// How well values fit.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    /// The cost of the values and of the hand, without that of the mistakes.
    pub cost: f64,
    /// By datum: the value that a drawing with the mistakes should have.
    pub predicted: Vec<f64>,
    /// By datum: whether the value remains unexplained.
    pub outside: Vec<bool>,
    /// By datum: the variance that the value has given the earlier ones.
    pub given: Vec<f64>,
    /// The hand for which the values are likeliest.
    pub hand: Hand,
}

/// The search for the hand that makes the values likeliest.
pub(super) struct Hands<'a> {
    covariances: &'a Covariances,
    compared: Compared<'a>,
    walk: Walk,
    /// The best hand so far, its cost, the values that it leaves unexplained, and the variances that it leaves to all.
    hand: Hand,
    cost: f64,
    outside: Vec<bool>,
    given: Vec<f64>,
}

impl Hands<'_> {
    /// Tries a hand; whether it is the best so far.
    pub fn consider(&mut self, hand: Hand) -> bool {
        let cost = self.walk.run(self.covariances, &hand, self.compared) + hand.cost();
        let is_better = cost < self.cost;
        if is_better {
            self.cost = cost;
            self.outside.clone_from(&self.walk.outside);
            self.given.clone_from(&self.walk.given);
            self.hand = hand;
        }
        is_better
    }

    /// Tries errors of all kinds of equal size, from `start` on as long as they become likelier; the index of the best
    /// size. One size may be worse than both its neighbours.
    fn search_alike(&mut self, start: usize) -> usize {
        let mut best = start;
        self.consider(Hand::alike(SIZES[start]));
        for finer in [true, false] {
            let (mut at, mut worse) = (best, 0);
            while worse < 2 {
                at = match finer {
                    true if at + 1 < SIZES.len() => at + 1,
                    false if at > 0 => at - 1,
                    _ => break,
                };
                if self.consider(Hand::alike(SIZES[at])) {
                    (best, worse) = (at, 0);
                } else {
                    worse += 1;
                }
            }
        }
        best
    }

    /// Tries the other ways to compute with the best hand so far.
    pub fn search_computing(&mut self) {
        for habit in [Habit::Mixed, Habit::AsWritten, Habit::AllDigits] {
            if habit != self.hand.habit {
                self.consider(Hand { habit, ..self.hand });
            }
        }
        for size in SLIPS {
            if size != self.hand.errors[COMPUTING] {
                let mut hand = self.hand;
                hand.errors[COMPUTING] = size;
                self.consider(hand);
            }
        }
        if !self.covariances.groups[LEANING].is_empty() {
            let mut hand = self.hand;
            hand.errors[LEANING] = 0.0;
            self.consider(hand);
        }
    }

    /// Goes on with a size for each kind of errors; only for drawings more exact than a hand's.
    fn search_each(&mut self, level: usize) {
        let mut program = Hand::alike(SIZES[SIZES.len() - 1]);
        program.errors[TOGETHER] = SIZES[level];
        program.errors[drawn_on(Sheet::Velocity)] = SIZES[level];
        self.consider(program);
        for _ in 0..2 {
            let before = self.cost;
            for group in 0..LEANING {
                self.search_kind(group);
            }
            if self.cost > before - 1.0 {
                break;
            }
        }
    }

    /// Tries other sizes of one kind of errors.
    fn search_kind(&mut self, group: usize) {
        let mut hand = self.hand;
        let tried = hand.errors[group];
        for &size in SIZES[CAREFUL + 2..].iter().filter(|s| **s != tried) {
            hand.errors[group] = size;
            self.consider(hand);
        }
    }
}

impl Scorer<'_> {
    /// The approximate standard deviation of a value drawn by the hand of the fit.
    pub fn deviation(&self, datum: usize, fit: &Fit) -> f64 {
        let hand = fit.hand.worst();
        (hand * hand * self.variance(datum) + self.data[datum].variance()).sqrt()
    }

    /// Whether the values cannot tell two explanations apart: both fit equally well, and each value is about as far
    /// from both predictions.
    pub fn are_alike(&self, a: &Fit, b: &Fit, sets: [&[&Candidate]; 2]) -> bool {
        let [meant_a, meant_b] = sets.map(|set| self.meant(set));
        let hand = a.hand.worst();
        let same = |index: usize| {
            let (m, n) = (&meant_a[index], &meant_b[index]);
            let [p, q] = [a.predicted[index], b.predicted[index]];
            let [r, s] = [m.seen_apart(m.value, p) / m.rounding, n.seen_apart(n.value, q) / n.rounding];
            let deviation = hand * self.variance(index).sqrt() / m.rounding.max(n.rounding);
            // Where no sign is written, the explanations may differ in it.
            let same_sense = m.is_magnitude || (p * q > 0.0) == (m.value * n.value > 0.0);
            same_sense && (r - s).abs() <= 0.5 * (1.0 + deviation)
        };
        (a.cost - b.cost).abs() <= SAME_FIT && (0..self.data.len()).all(same)
    }

    /// How well values fit a drawing with these mistakes by a hand that is known. `None` where a predicted value is not finite.
    pub fn compare_by(&self, set: &[&Candidate], hand: Hand) -> Option<Fit> {
        self.compared(set, |hands| {
            hands.consider(hand);
        })
    }

    /// The complete comparison, with the covariances of a drawing with these mistakes. `like`: a hand from which the
    /// search for the best one starts. `None` where a predicted value is not finite.
    pub fn compare(&self, set: &[&Candidate], like: Option<&Hand>) -> Option<Fit> {
        let near = |like: &Hand| SIZES.iter().position(|s| *s <= like.worst()).unwrap_or(CAREFUL);
        self.compared(set, |hands| {
            let level = hands.search_alike(like.map_or(CAREFUL, near));
            hands.search_computing();
            if let Some(like) = like {
                hands.consider(*like);
            }
            if !hands.hand.is_by_hand() {
                hands.search_each(level);
            }
        })
    }

    /// A comparison by the likeliest of the hands that are tried.
    fn compared(&self, set: &[&Candidate], try_hands: impl Fn(&mut Hands<'_>)) -> Option<Fit> {
        self.compared_with(set, self.predicted(set), &self.covariances(set), try_hands)
    }

    /// The same with values and covariances that are known already.
    pub(super) fn compared_with(
        &self,
        set: &[&Candidate],
        predicted: Vec<f64>,
        covariances: &Covariances,
        try_hands: impl Fn(&mut Hands<'_>),
    ) -> Option<Fit> {
        if predicted.iter().any(|p| !p.is_finite()) {
            return None;
        }
        let meant = self.meant(set);
        let mut hands = Hands {
            covariances,
            compared: Compared { meant: &meant, predicted: &predicted, without: &self.without },
            walk: Walk::new(self.data.len()),
            hand: Hand::alike(1.0),
            cost: f64::INFINITY,
            outside: Vec::new(),
            given: Vec::new(),
        };
        try_hands(&mut hands);
        let Hands { cost, outside, given, hand, .. } = hands;
        Some(Fit { cost, predicted, outside, given, hand })
    }
}
