use super::act::Sheet;
use super::drafting::Drafting;
use super::read::{Reading, Unread, drafting_with};
use super::replay::{Change, Disturbance, SheetScales, Values};
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::plan::{Asked, Construction, Scales};
use crate::position::Pose;

/// How far an honest hand may be off: limits within which every error is equally likely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Millimetres of paper: of a point set, along x and along y, and of a length laid off or measured.
    pub mm: f64,
    /// Degrees: of a direction drawn or read.
    pub degrees: f64,
}

impl Default for Tolerance {
    /// 0.3 mm and 0.3°: a sharp pencil, a ruler with millimetres, two set squares.
    fn default() -> Self {
        Tolerance {
            mm: 0.3,
            degrees: 0.3,
        }
    }
}

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

/// Two standard deviations of an error that is equally likely within its limits: 2/√3 of the limit.
const TWO_DEVIATIONS: f64 = 1.154_700_538_379_251_5;

/// Share of the band that the second-order effect of the errors may reach before first order counts as rough.
const SECOND_ORDER: f64 = 0.1;

/// The bands of quantities, each by its name, in the order asked for; or why one has none.
///
/// Every act brings errors e_i of its own, independent of each other, which the later acts pass on. With limits t_i, within which an
/// error is equally likely, the standard deviation of e_i is t_i/√3 (JCGM 100:2008, 4.3.7), that of a quantity q to first order
/// √(Σ (∂q/∂e_i)² t_i²/3) (5.1.2), and the band is twice that (6.3.3: about 95 %). The derivative is taken as the difference quotient over
/// the whole tolerance, (q(t_i) − q(−t_i))/2t_i. Where the mean of both differs from q by more than a tenth of the band, summed over
/// all errors, first order is not enough and the band says that it is rough.
#[must_use]
pub fn bands(
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &Motion,
    construction: &Construction,
    scales: &Scales,
    tolerance: &Tolerance,
    asked: &[Asked],
) -> Vec<Result<Band, Unread>> {
    let (drafting, readings) = drafting_with(mechanism, pose, motion, construction, asked);
    let given = [scales.length, scales.velocity, scales.acceleration];
    let on_sheets = readings.into_iter().map(|reading| {
        let reading = reading?;
        let needed = Sheet::ALL.into_iter().zip(given);
        let mut needed = needed.filter(|(sheet, _)| *sheet <= reading.sheet);
        match needed.find(|(_, scale)| scale.is_none()) {
            Some((sheet, _)) => Err(Unread::NoSheet(sheet.name())),
            None => Ok(reading),
        }
    });
    let readings: Vec<Result<Reading, Unread>> = on_sheets.collect();
    let scales = SheetScales {
        // On a sheet that is not there nothing is read.
        per_mm: given.map(|scale| scale.unwrap_or(0.0)),
    };
    let there: Vec<Reading> = readings
        .iter()
        .filter_map(|r| r.as_ref().ok().copied())
        .collect();
    let mut bands = drafting.bands(scales, tolerance, &there).into_iter();
    let all = readings.into_iter().zip(asked).map(|(reading, asked)| {
        let reading = reading?;
        let mut band = bands.next().ok_or(Unread::NotDrawn)?;
        if asked.is_on_paper() {
            let per_mm = scales.per_mm[reading.sheet as usize];
            band.value /= per_mm;
            band.band /= per_mm;
        }
        Ok(band)
    });
    all.collect()
}

impl Drafting {
    /// The bands of what is read, in the scene's units.
    #[must_use]
    pub fn bands(
        &self,
        scales: SheetScales,
        tolerance: &Tolerance,
        readings: &[Reading],
    ) -> Vec<Band> {
        let exact = self.replay(scales, &[]);
        let values: Vec<f64> = readings.iter().map(|r| r.signed(&exact)).collect();
        let mut squares = vec![0.0; readings.len()];
        let mut bends = vec![0.0; readings.len()];
        let mut off = [exact.clone(), exact.clone()];
        for (act, errors) in self.acts.iter().map(|act| act.deed.errors()).enumerate() {
            for (which, error) in errors.iter().enumerate() {
                let limit = error.limit(tolerance);
                for (values, size) in off.iter_mut().zip([limit, -limit]) {
                    values.clone_from(&exact);
                    let change = Change::Error(which, size);
                    self.replay_from(act, values, scales, &[Disturbance { act, change }]);
                }
                for (index, reading) in readings.iter().enumerate() {
                    let [up, down] =
                        [0, 1].map(|side| reading.difference(&off[side], values[index]));
                    let half = 0.5 * (up - down);
                    squares[index] += half * half;
                    bends[index] += 0.5 * (up + down).abs();
                }
            }
        }
        let all = values.iter().zip(squares).zip(bends);
        let bands = all
            .zip(readings)
            .map(|(((&value, square), bend), reading)| {
                let band = TWO_DEVIATIONS * square.sqrt();
                Band {
                    value: if reading.is_magnitude {
                        value.abs()
                    } else {
                        value
                    },
                    band,
                    is_rough: !(bend <= SECOND_ORDER * band),
                }
            });
        bands.collect()
    }
}

impl Reading {
    /// The quantity in values of a replay.
    #[must_use]
    pub fn value(&self, values: &Values) -> f64 {
        let value = self.signed(values);
        if self.is_magnitude {
            value.abs()
        } else {
            value
        }
    }

    fn signed(&self, values: &Values) -> f64 {
        values.number(self.number)
    }

    /// How far the quantity is from `signed`; of an angle the shorter way round.
    #[must_use]
    pub fn difference(&self, values: &Values, signed: f64) -> f64 {
        let difference = self.signed(values) - signed;
        if self.is_angle {
            difference - 360.0 * libm::round(difference / 360.0)
        } else {
            difference
        }
    }
}
