//! What honest errors of a hand make of quantities.

use super::name::Asked;
use super::reading::{Reading, Sense, Unread, read_by_hand};
use super::value::Scales;
use crate::construction::{Change, Construction, Disturbance, Sheet, SheetScales, Solution, Tolerance, Values};

/// What honest hand drawings give for a quantity: its value, and how far they are from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The value without any error, as read from the drawing: a measured segment without its sign.
    pub value: f64,
    /// At least 95 of 100 honest drawings give a value that is at most this far from `value`.
    pub band: f64,
    /// Whether errors are so large against the quantity that the band is only a rough one: crossings under small angles, vectors
    /// hardly longer than the pencil's width.
    pub is_rough: bool,
}

/// Half the width of a band in standard deviations.
const DEVIATIONS: f64 = 2.1;

/// Share of the standard deviation that the second-order part of the errors may reach before first order counts as rough.
const SECOND_ORDER: f64 = 0.2;

/// Pairs of drawings by which the second-order part is found.
const DRAWINGS: u32 = 32;

/// The bands of a scene's quantities as drawn by hand at given scales.
#[derive(Clone, Debug)]
pub struct Pencil {
    /// How good the hand is.
    pub tolerance: Tolerance,
    /// The scales at which it draws.
    pub scales: Scales,
    /// What was asked for, with its band or why it has none.
    pub quantities: Vec<(Asked, Result<Band, Unread>)>,
}

impl Pencil {
    /// The band of a quantity by its name; `None` where it has none.
    #[must_use]
    pub fn band(&self, name: &str) -> Option<Band> {
        let mut quantities = self.quantities.iter();
        let found = quantities.find(|(asked, _)| asked.name() == name)?;
        found.1.as_ref().ok().copied()
    }
}

/// The bands of the quantities `asked` for; or why one has none.
///
/// Every act brings errors e_i of its own, independent of each other, which the later acts pass on. With limits t_i within which an
/// error is equally likely, its standard deviation is t_i/√3 (JCGM 100:2008, 4.3.7), that of a quantity q to first order
/// σ = √(Σ (∂q/∂e_i)² t_i²/3) (5.1.2), and the band is 2.1 σ: 96 % of a normal distribution. Here ∂q/∂e_i is the difference quotient over
/// the whole tolerance, (q(t_i) − q(−t_i))/2t_i. What first order neglects is seen on pairs of drawings with all errors at once,
/// once with each sign: the mean of both leaves the exact value by the second-order part. Where its root mean square exceeds σ/5, as
/// under small angles of crossing, or where a distance may be nothing within its band, the band says that it is rough.
#[must_use]
pub fn pencil(solution: &Solution, scales: &Scales, tolerance: Tolerance, asked: Vec<Asked>) -> Pencil {
    let (construction, readings) = read_by_hand(solution, &asked);
    let given = scales.all();
    let on_sheets = readings.into_iter().map(|reading| {
        let reading = reading?;
        let needed = Sheet::ALL.into_iter().zip(given);
        let mut needed = needed.filter(|(sheet, _)| *sheet <= reading.sheet);
        match needed.find(|(_, scale)| scale.is_none()) {
            Some((sheet, _)) => Err(Unread::NoSheet(sheet)),
            None => Ok(reading),
        }
    });
    let readings: Vec<Result<Reading, Unread>> = on_sheets.collect();
    let per_sheet = SheetScales {
        // On a sheet that is not there nothing is read.
        per_mm: given.map(|scale| scale.unwrap_or(0.0)),
    };
    let there: Vec<Reading> = readings.iter().flatten().copied().collect();
    let mut bands = construction.bands(per_sheet, &tolerance, &there).into_iter();
    let all = asked.into_iter().zip(readings).map(|(asked, reading)| {
        let band = reading.and_then(|reading| {
            let mut band = bands.next().ok_or(Unread::NotDrawn)?;
            if !(band.value.is_finite() && band.band.is_finite()) {
                return Err(Unread::Apart);
            }
            if asked.is_on_paper() {
                let per_mm = per_sheet.per_mm[reading.sheet as usize];
                band.value /= per_mm;
                band.band /= per_mm;
            }
            Ok(band)
        });
        (asked, band)
    });
    Pencil { tolerance, scales: *scales, quantities: all.collect() }
}

impl Construction {
    /// The bands of what is read, in the scene's units.
    #[must_use]
    pub fn bands(&self, scales: SheetScales, tolerance: &Tolerance, readings: &[Reading]) -> Vec<Band> {
        let errors = self.operations.iter().enumerate().flat_map(|(index, operation)| {
            let errors = operation.kind.errors().iter().enumerate();
            errors.map(move |(which, error)| (index, which, error.limit(tolerance)))
        });
        let hand =
            Hand { construction: self, scales, readings, errors: errors.collect(), exact: self.run(scales, &[]) };
        let all = readings.iter().zip(hand.first_order());
        let bands = all.zip(hand.second_order());
        let bands = bands.map(|((reading, deviation), second_order)| {
            let value = reading.value(&hand.exact);
            let band = DEVIATIONS * deviation;
            let is_firm = second_order <= SECOND_ORDER * deviation;
            Band { value, band, is_rough: !is_firm || reading.sense == Sense::Distance && band > value }
        });
        bands.collect()
    }
}

/// A construction in the hands of somebody, who makes errors.
struct Hand<'a> {
    construction: &'a Construction,
    scales: SheetScales,
    readings: &'a [Reading],
    /// All errors: the operation, which of its errors, the limit.
    errors: Vec<(usize, usize, f64)>,
    /// What comes out without any.
    exact: Values,
}

impl Hand<'_> {
    /// The standard deviation of each reading, to first order.
    fn first_order(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.readings.len()];
        let mut pair = [self.exact.clone(), self.exact.clone()];
        let operations = &self.construction.operations;
        for &(operation, which, limit) in &self.errors {
            for (values, size) in pair.iter_mut().zip([limit, -limit]) {
                // What stands before the operation is as it was.
                values.clone_from(&self.exact);
                let change = Change::Error(which, size);
                values.carry_out(operations, operation, self.scales, &[Disturbance { operation, change }]);
            }
            for (square, [up, down]) in squares.iter_mut().zip(self.differences(&pair)) {
                let slope = 0.5 * (up - down);
                *square += slope * slope / 3.0;
            }
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// The root mean square of each reading's second-order part, from drawings with all errors as large as their standard deviations.
    fn second_order(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.readings.len()];
        let mut pair = [self.exact.clone(), self.exact.clone()];
        for drawing in 0..DRAWINGS {
            for (values, sign) in pair.iter_mut().zip([1.0, -1.0]) {
                let all = self.errors.iter().enumerate();
                let all = all.map(|(index, &(operation, which, limit))| {
                    let is_up = scattered(index) >> drawing & 1 == 0;
                    let size = sign * limit / 3.0_f64.sqrt();
                    let change = Change::Error(which, if is_up { size } else { -size });
                    Disturbance { operation, change }
                });
                let all: Vec<Disturbance<'_>> = all.collect();
                values.carry_out(&self.construction.operations, 0, self.scales, &all);
            }
            for (square, [up, down]) in squares.iter_mut().zip(self.differences(&pair)) {
                let middle = 0.5 * (up + down);
                *square += middle * middle / f64::from(DRAWINGS);
            }
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// How far each reading is off in both drawings of a pair.
    fn differences<'p>(&'p self, pair: &'p [Values; 2]) -> impl Iterator<Item = [f64; 2]> + 'p {
        self.readings.iter().map(|reading| {
            let exact = self.exact.number(reading.number);
            [0, 1].map(|side| reading.difference(&pair[side], exact))
        })
    }
}

/// 64 bits that look as if tossed for each index, always the same (Splitmix64: Steele, Lea, Flood 2014).
fn scattered(index: usize) -> u64 {
    let mut z = (index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Reading {
    /// The quantity in values of a replay.
    #[must_use]
    pub fn value(&self, values: &Values) -> f64 {
        let value = values.number(self.number);
        if self.sense == Sense::Magnitude { value.abs() } else { value }
    }

    /// How far the quantity is from `signed`; of an angle the shorter way round.
    #[must_use]
    pub fn difference(&self, values: &Values, signed: f64) -> f64 {
        let difference = values.number(self.number) - signed;
        if self.sense == Sense::Angle { difference - 360.0 * libm::round(difference / 360.0) } else { difference }
    }
}
