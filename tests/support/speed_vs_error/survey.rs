//! Every method on every family: errors, the same in every run, and times.

use super::families::Family;
use super::hand;
use super::methods::{Method, Prepared};
use super::random::Random;
use super::truth::rounded;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Groups for each family and parameter, and random groups.
const GROUPS: [usize; 2] = [10, 150];

/// From this condition on f32 has no digit, as f64 has none from 0.05/u on.
const SINGULAR_FOR_SINGLE: f64 = 0.1 / f32::EPSILON as f64;

const METHODS: usize = Method::ALL.len();

/// A family with one parameter.
pub struct Row {
    pub family: Family,
    pub parameter: f64,
    /// The largest condition.
    pub condition: f64,
    /// How many groups the library refuses as singular; they are not counted.
    pub refused: usize,
    /// By method: the largest error relative to the largest number of its kind.
    pub errors: [f64; METHODS],
    /// The largest in units u·condition.
    pub units: [f64; METHODS],
    /// By pencil: errors of drawings by hand, those that can be drawn.
    pub hand: [Vec<f64>; 3],
    /// Errors of drawings by hand in units u·condition.
    pub hand_units: [Vec<f64>; 3],
}

impl Row {
    fn new(family: Family, parameter: f64) -> Row {
        let mut row = Row {
            family,
            parameter,
            condition: 1.0,
            refused: 0,
            errors: [0.0; METHODS],
            units: [0.0; METHODS],
            hand: Default::default(),
            hand_units: Default::default(),
        };
        // The same groups with another parameter, where the family lets it be.
        let mut dice = Random(100 + family as u64);
        for _ in 0..GROUPS[usize::from(family == Family::Random)] {
            let group = family.group(parameter, &mut dice);
            match Prepared::new(&group) {
                Some(prepared) => row.see(&prepared),
                None => row.refused += 1,
            }
        }
        row
    }

    /// How many groups are counted.
    pub fn counted(&self) -> usize {
        GROUPS[usize::from(self.family == Family::Random)] - self.refused
    }

    fn see(&mut self, prepared: &Prepared) {
        let case = &prepared.case;
        let Some(condition) = case.condition else {
            self.refused += 1;
            return;
        };
        self.condition = self.condition.max(condition);
        for (index, method) in Method::ALL.into_iter().enumerate() {
            if method == Method::Single && condition > SINGULAR_FOR_SINGLE {
                continue;
            }
            let rates = prepared.rates(method);
            self.errors[index] = self.errors[index].max(case.error(&rates));
            self.units[index] = self.units[index].max(case.worst_units(&rates).unwrap_or(0.0));
        }
        let truth = case.truth.clone().map(|x| rounded(&x));
        for (index, pencil) in hand::PENCILS.into_iter().enumerate() {
            let mut dice = Random(index as u64);
            if let Some(rates) = hand::rates(&case.pins, &truth, pencil, &mut dice) {
                self.hand[index].push(case.error(&rates));
                self.hand_units[index].extend(case.worst_units(&rates));
            }
        }
    }
}

/// The errors of all methods.
pub struct Survey {
    pub rows: Vec<Row>,
}

impl Survey {
    pub fn new() -> Survey {
        let rows = |family: Family| {
            let parameters = family.parameters().into_iter();
            parameters.map(move |parameter| Row::new(family, parameter))
        };
        Survey { rows: Family::ALL.into_iter().flat_map(rows).collect() }
    }

    pub fn of(&self, family: Family) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.family == family)
    }

    /// The largest error of a method on a family, in units u·condition.
    pub fn worst(&self, family: Family, method: Method) -> f64 {
        let units = self.of(family).map(|row| row.units[method as usize]);
        units.fold(0.0, f64::max)
    }

    /// The largest error of a method on all families but the random one, and on which.
    pub fn worst_of_all(&self, method: Method) -> (f64, Family) {
        let hard = Family::ALL.into_iter().filter(|f| *f != Family::Random);
        let all = hard.map(|family| (self.worst(family, method), family));
        all.fold((0.0, Family::Random), |worst, one| if one.0 > worst.0 { one } else { worst })
    }
}

/// The value in the middle; `None` of nothing.
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// The value below which a share of all lies; `None` of nothing.
pub fn quantile(values: &[f64], share: f64) -> Option<f64> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    Some(values[libm::round(share * last as f64) as usize])
}

/// Groups that are solved in turn when time is taken.
pub const TIMED: usize = 256;

/// Rounds over them that are timed; the quickest counts, the others were disturbed.
pub const ROUNDS: usize = 200;

/// Nanoseconds for velocities and accelerations of a group, by method.
pub fn times() -> [f64; METHODS] {
    let mut dice = Random(1);
    let groups = (0..TIMED).map(|_| Family::Random.group(1.0, &mut dice));
    let prepared: Vec<Prepared> = groups.filter_map(|g| Prepared::new(&g)).collect();
    Method::ALL.map(|method| {
        let round = || {
            let start = Instant::now();
            for one in &prepared {
                black_box(black_box(one).rates(method));
            }
            start.elapsed()
        };
        let quickest = (0..ROUNDS).map(|_| round()).min();
        quickest.unwrap_or(Duration::ZERO).as_secs_f64() * 1e9 / prepared.len() as f64
    })
}
