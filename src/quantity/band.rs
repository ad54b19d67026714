//! Bands of quantities: the scatter that honest errors of a hand drawing give them.

use super::error::QuantityError;
use super::name::QuantityRequest;
use super::names::step_names;
use super::reading::{Reading, Sense, Unread, read_by_hand};
use crate::construction::{
    Change, ComingRound, Construction, Disturbance, NumberId, Operation, Rubbed, Solution, Tolerance, Values,
    pressing_off,
};
use crate::geometry::{with_turns, without_sense};
use crate::sheet::{PerSheet, Scales};
use std::collections::BTreeSet;

/// The value that a hand drawing gives for a quantity, and its scatter; in the quantity's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The value without any error, as read from the drawing: a measured segment without its sign.
    pub value: f64,
    /// Half the width of the band: at least 95 of 100 honest drawings give a value that differs from `value` by at most
    /// this.
    pub band: f64,
    /// Whether the band is only a rough one, because errors are large against the quantity: lines that cross under
    /// small angles, vectors hardly longer than a pencil line is wide.
    pub is_rough: bool,
}

/// Half the width of a band in standard deviations.
const DEVIATIONS: f64 = 2.1;

/// Largest second-order part of the error, in standard deviations, for which first order counts as sufficient.
const SECOND_ORDER: f64 = 0.2;

/// Step of difference quotients by friction, in parts of it.
const NUDGE: f64 = 1e-3;

/// Pairs of drawings from which the second-order part is estimated.
const DRAWINGS: u32 = 32;

/// The bands of a scene's quantities as drawn by hand at given scales.
#[derive(Clone, Debug)]
pub struct Pencil {
    /// The limits of the hand's errors.
    pub tolerance: Tolerance,
    /// The scales of its sheets.
    pub scales: Scales,
    /// The quantities asked for, each with its band, or why it has none.
    pub quantities: Vec<(QuantityRequest, Result<Band, Unread>)>,
}

impl Pencil {
    /// The band of a quantity by its name; `None` if it has none or was not asked for.
    #[must_use]
    pub fn band(&self, name: &str) -> Option<Band> {
        let mut quantities = self.quantities.iter();
        let found = quantities.find(|(asked, _)| asked.name() == name)?;
        found.1.as_ref().ok().copied()
    }
}

/// The bands of the quantities `asked` for, or why one has none.
///
/// Every operation brings errors e_i of its own, independent of each other, which the later operations pass on. An
/// error that is equally likely within limits ±t_i has the standard deviation t_i/√3 (JCGM 100:2008, 4.3.7); that of a
/// quantity q is to first order σ = √(Σ (∂q/∂e_i)² t_i²/3) (5.1.2), and the band is 2.1 σ: 96 % of a normal
/// distribution. Here ∂q/∂e_i is the difference quotient over the whole tolerance, (q(t_i) − q(−t_i))/2t_i. The
/// second-order part is estimated from pairs of drawings with all errors at once, of opposite sign in the two: it is
/// the difference of the pair's mean from the exact value. The band is rough if the root mean square of that part
/// exceeds σ/5, as under small angles of crossing, or if a distance may be zero within its band.
///
/// Friction is found from what presses in such a drawing, and brings its errors round once more; so do the angle by which forces lean, and the line that touches a
/// circle of friction.
#[must_use]
pub fn pencil(solution: &Solution, scales: &Scales, tolerance: Tolerance, asked: Vec<QuantityRequest>) -> Pencil {
    let (construction, readings) = read_by_hand(solution, &asked);
    let on_sheets = readings.into_iter().map(|reading| {
        let reading = reading?;
        let mut needed = reading.sheet.with_those_needed().iter();
        match needed.find(|sheet| scales[**sheet].is_none()) {
            Some(sheet) => Err(Unread::NoSheet(*sheet)),
            None => Ok(reading),
        }
    });
    let readings: Vec<Result<Reading, Unread>> = on_sheets.collect();
    // Nothing is read from a sheet without a scale.
    let per_sheet = scales.map(|scale| scale.unwrap_or(0.0));
    let readable: Vec<Reading> = readings.iter().flatten().copied().collect();
    let mut bands = construction.bands(per_sheet, &tolerance, &readable).into_iter();
    let all = asked.into_iter().zip(readings).map(|(asked, reading)| {
        let band = reading.and_then(|reading| {
            let mut band = bands.next().ok_or(Unread::NotDrawn)?;
            if !(band.value.is_finite() && band.band.is_finite()) {
                return Err(Unread::Apart);
            }
            if asked.written.on_paper {
                let per_mm = per_sheet[reading.sheet];
                band.value /= per_mm;
                band.band /= per_mm;
            }
            Ok(band)
        });
        (asked, band)
    });
    Pencil { tolerance, scales: *scales, quantities: all.collect() }
}

/// What honest hands find for the quantities of the steps when they draw at the figure's scales.
///
/// # Errors
/// A name that the construction gives is not understood.
pub fn step_pencil(solution: &Solution, tolerance: Tolerance) -> Result<Pencil, QuantityError> {
    let names = step_names(&solution.construction);
    let asked =
        names.iter().map(|name| QuantityRequest::new(name, &solution.mechanism)).collect::<Result<Vec<_>, _>>()?;
    Ok(pencil(solution, &solution.scales(), tolerance, asked))
}

impl Construction {
    /// The bands of `readings`, in the scene's units.
    #[must_use]
    pub fn bands(&self, scales: PerSheet<f64>, tolerance: &Tolerance, readings: &[Reading]) -> Vec<Band> {
        let errors = self.operations.iter().enumerate().flat_map(|(index, operation)| {
            let errors = operation.kind.errors().iter().enumerate();
            errors.map(move |(which, error)| (index, which, error.limit(tolerance)))
        });
        let hand = Hand {
            construction: self,
            scales,
            tolerance,
            readings,
            errors: errors.collect(),
            exact: self.run(scales, &[]),
        };
        let all = readings.iter().zip(hand.first_order());
        let bands = all.zip(hand.second_order());
        let bands = bands.map(|((reading, deviation), second_order)| {
            let value = reading.value(&hand.exact);
            let band = DEVIATIONS * deviation;
            let is_first_order = second_order <= SECOND_ORDER * deviation;
            Band { value, band, is_rough: !is_first_order || reading.sense == Sense::Distance && band > value }
        });
        bands.collect()
    }
}

/// A construction as a hand carries it out, with errors.
struct Hand<'a> {
    construction: &'a Construction,
    scales: PerSheet<f64>,
    tolerance: &'a Tolerance,
    readings: &'a [Reading],
    /// All errors: index of the operation, index of the error among those of the operation, its limit.
    errors: Vec<(usize, usize, f64)>,
    /// The values without any error.
    exact: Values,
}

impl Hand<'_> {
    /// The standard deviation of each reading, to first order.
    fn first_order(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.readings.len()];
        let mut pair = [self.exact.clone(), self.exact.clone()];
        let operations = &self.construction.operations;
        let users = Users::of(operations, self.construction.counts());
        let mut read = vec![Vec::new(); operations.len()];
        for (index, reading) in self.readings.iter().enumerate() {
            read[users.maker(reading.number)].push(index);
        }
        let friction = self.friction(&users);
        if let Some(Friction { rubbed, coming_round }) = &friction {
            for (joint, own) in rubbed.iter().enumerate() {
                let part = own.drawn(self.scales, self.tolerance);
                add(&mut squares, coming_round.of_joint(joint).iter().map(|slope| slope * part));
            }
        }
        for &(operation, which, limit) in &self.errors {
            // What uses none of the disturbed results stays exact: of many points on a link each has its own.
            let disturbed = users.all_after(operation);
            for (values, size) in pair.iter_mut().zip([limit, -limit]) {
                let mut errors = [0.0; 2];
                errors[which] = size;
                for &index in &disturbed {
                    let own = if index == operation { errors } else { [0.0; 2] };
                    values.repeat(&operations[index], own, self.scales);
                }
            }
            let slopes = disturbed.iter().flat_map(|&index| &read[index]).map(|&index| {
                let [up, down] = self.difference(&pair, &self.readings[index]);
                (index, 0.5 * (up - down))
            });
            match &friction {
                None => slopes.for_each(|(index, slope)| squares[index] += slope * slope / 3.0),
                Some(friction) => {
                    let mut own = vec![0.0; squares.len()];
                    slopes.for_each(|(index, slope)| own[index] = slope);
                    friction.add(&own, &pair, &self.exact, &mut squares);
                }
            }
            for values in &mut pair {
                disturbed.iter().for_each(|&index| values.take(&operations[index], &self.exact));
            }
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// How errors come round by friction; none where nothing rubs.
    fn friction(&self, users: &Users) -> Option<Friction> {
        let rubbed = self.construction.rubbed();
        if rubbed.is_empty() {
            return None;
        }
        let operations = &self.construction.operations;
        let (mut of_values, mut of_pressing) = (Vec::new(), Vec::new());
        for own in &rubbed {
            let mut values = self.exact.clone();
            let mut disturbed = BTreeSet::new();
            for &number in &own.taken {
                values.put_number(number, self.exact.number(number) * (1.0 + NUDGE));
                disturbed.extend(users.all_after(users.maker(number)).into_iter().skip(1));
            }
            disturbed.iter().for_each(|&index| values.repeat(&operations[index], [0.0; 2], self.scales));
            let slope = |reading: &Reading| reading.difference(&values, self.exact.number(reading.number)) / NUDGE;
            of_values.push(self.readings.iter().map(slope).collect());
            let pressing = pressing_off(&rubbed, &values, &self.exact);
            of_pressing.push(pressing.into_iter().map(|off| off / NUDGE).collect());
        }
        Some(Friction { coming_round: ComingRound::new(&of_values, &of_pressing), rubbed })
    }

    /// The root mean square of each reading's second-order part, from drawings whose errors have the size of their
    /// standard deviations and random signs.
    fn second_order(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.readings.len()];
        let mut pair = [self.exact.clone(), self.exact.clone()];
        for drawing in 0..DRAWINGS {
            for (values, sign) in pair.iter_mut().zip([1.0, -1.0]) {
                let all = self.errors.iter().enumerate();
                let all = all.map(|(index, &(operation, which, limit))| {
                    let is_positive = random_bits(index) >> drawing & 1 == 0;
                    let size = sign * limit / 3.0_f64.sqrt();
                    let change = Change::Error(which, if is_positive { size } else { -size });
                    Disturbance { operation, change }
                });
                let all: Vec<Disturbance> = all.collect();
                values.carry_out(&self.construction.operations, 0, self.scales, &all);
            }
            for (square, [up, down]) in squares.iter_mut().zip(self.differences(&pair)) {
                let middle = 0.5 * (up + down);
                *square += middle * middle / f64::from(DRAWINGS);
            }
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// The error of each reading in both drawings of a pair.
    fn differences<'p>(&'p self, pair: &'p [Values; 2]) -> impl Iterator<Item = [f64; 2]> + 'p {
        self.readings.iter().map(|reading| self.difference(pair, reading))
    }

    fn difference(&self, pair: &[Values; 2], reading: &Reading) -> [f64; 2] {
        let exact = self.exact.number(reading.number);
        [0, 1].map(|side| reading.difference(&pair[side], exact))
    }
}

/// Friction that a hand finds from what presses in its drawing.
struct Friction {
    rubbed: Vec<Rubbed>,
    coming_round: ComingRound,
}

impl Friction {
    /// Adds the variances of an error that changes readings by `own`; `pair` has the values of drawings with it and with its opposite.
    fn add(&self, own: &[f64], pair: &[Values; 2], exact: &Values, squares: &mut [f64]) {
        let [up, down] = pair.each_ref().map(|values| pressing_off(&self.rubbed, values, exact));
        let pressing: Vec<f64> = up.iter().zip(down).map(|(up, down)| 0.5 * (up - down)).collect();
        for slopes in self.coming_round.with(own, &pressing) {
            add(squares, slopes.into_iter());
        }
    }
}

/// Adds the variances of an error that is equally likely within limits at which readings change so much.
fn add(squares: &mut [f64], slopes: impl Iterator<Item = f64>) {
    squares.iter_mut().zip(slopes).for_each(|(square, slope)| *square += slope * slope / 3.0);
}

/// Which operations use the results of which.
struct Users {
    /// By operation: those that use its results, in order.
    next: Vec<Vec<usize>>,
    /// By number: the operation that makes it.
    makers: Vec<usize>,
}

impl Users {
    /// Of operations that make so many places, lines and numbers.
    fn of(operations: &[Operation], counts: [usize; 3]) -> Users {
        let [mut places, mut lines, mut numbers] = counts.map(|count| vec![None; count]);
        let mut next = vec![Vec::new(); operations.len()];
        for (index, Operation { kind, .. }) in operations.iter().enumerate() {
            let mut uses = |maker: Option<usize>| {
                if let Some(maker) = maker.filter(|&maker| next[maker].last() != Some(&index)) {
                    next[maker].push(index);
                }
            };
            let (read_places, read_lines) = kind.places_and_lines_read();
            read_places.iter().for_each(|place| uses(places[place.0]));
            read_lines.iter().for_each(|line| uses(lines[line.0]));
            kind.each_number_read(|number| uses(numbers[number.0]));
            kind.place().iter().for_each(|place| places[place.0] = Some(index));
            kind.line().iter().for_each(|line| lines[line.0] = Some(index));
            kind.numbers().iter().for_each(|number| numbers[number.0] = Some(index));
        }
        Users { next, makers: numbers.into_iter().map(Option::unwrap_or_default).collect() }
    }

    fn maker(&self, number: NumberId) -> usize {
        self.makers[number.0]
    }

    /// An operation and all that, over others, use its results, in order.
    fn all_after(&self, operation: usize) -> Vec<usize> {
        let mut waiting = BTreeSet::from([operation]);
        let mut found = Vec::new();
        while let Some(first) = waiting.pop_first() {
            waiting.extend(&self.next[first]);
            found.push(first);
        }
        found
    }
}

/// 64 pseudorandom bits, the same for the same index (Splitmix64: Steele, Lea, Flood 2014).
fn random_bits(index: usize) -> u64 {
    let mut z = (index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Reading {
    /// The quantity in the values of a run of the construction.
    #[must_use]
    pub fn value(&self, values: &Values) -> f64 {
        let value = values.number(self.number);
        if self.sense == Sense::Magnitude { value.abs() } else { value }
    }

    /// The difference of the quantity from `signed`; that of an angle is within ±180°.
    #[must_use]
    pub fn difference(&self, values: &Values, signed: f64) -> f64 {
        let difference = values.number(self.number) - signed;
        match self.sense {
            Sense::Angle => with_turns(difference, 0.0),
            Sense::Line => without_sense(difference, 0.0),
            _ => difference,
        }
    }
}
