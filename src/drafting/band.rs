use super::act::Sheet;
use super::read::{Reading, Unread, drafting_with};
use super::replay::{Change, Disturbance, SheetScales, Values};
use super::writer::Drafting;
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
pub fn pencil(
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &Motion,
    construction: &Construction,
    scales: &Scales,
    tolerance: Tolerance,
    asked: Vec<Asked>,
) -> Pencil {
    let (drafting, readings) = drafting_with(mechanism, pose, motion, construction, &asked);
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
    let per_sheet = SheetScales {
        // On a sheet that is not there nothing is read.
        per_mm: given.map(|scale| scale.unwrap_or(0.0)),
    };
    let there: Vec<Reading> = readings.iter().flatten().copied().collect();
    let mut bands = drafting.bands(per_sheet, &tolerance, &there).into_iter();
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
    Pencil {
        tolerance,
        scales: *scales,
        quantities: all.collect(),
    }
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
        let errors = self.errors(tolerance);
        let mut off = [exact.clone(), exact.clone()];
        let mut squares = vec![0.0; readings.len()];
        for &(act, which, limit) in &errors {
            for (values, size) in off.iter_mut().zip([limit, -limit]) {
                values.clone_from(&exact);
                let change = Change::Error(which, size);
                self.replay_from(act, values, scales, &[Disturbance { act, change }]);
            }
            for ((reading, value), square) in readings.iter().zip(&values).zip(&mut squares) {
                let [up, down] = [0, 1].map(|side| reading.difference(&off[side], *value));
                let slope = 0.5 * (up - down);
                *square += slope * slope / 3.0;
            }
        }
        let mut bends = vec![0.0; readings.len()];
        for drawing in 0..DRAWINGS {
            for (values, sign) in off.iter_mut().zip([1.0, -1.0]) {
                let all = errors.iter().enumerate();
                let all = all.map(|(index, &(act, which, limit))| {
                    let toss = if scattered(index) >> drawing & 1 == 0 {
                        1.0
                    } else {
                        -1.0
                    };
                    let change = Change::Error(which, sign * toss * limit / 3.0_f64.sqrt());
                    Disturbance { act, change }
                });
                let all: Vec<Disturbance<'_>> = all.collect();
                self.replay_from(0, values, scales, &all);
            }
            for ((reading, value), bend) in readings.iter().zip(&values).zip(&mut bends) {
                let [up, down] = [0, 1].map(|side| reading.difference(&off[side], *value));
                let middle = 0.5 * (up + down);
                *bend += middle * middle / f64::from(DRAWINGS);
            }
        }
        let all = readings
            .iter()
            .zip(values)
            .zip(squares.into_iter().zip(bends));
        let bands = all.map(|((reading, value), (square, bend))| {
            let (deviation, second_order) = (square.sqrt(), bend.sqrt());
            let band = DEVIATIONS * deviation;
            let is_firm = second_order <= SECOND_ORDER * deviation;
            Band {
                value: if reading.is_magnitude {
                    value.abs()
                } else {
                    value
                },
                band,
                is_rough: !is_firm || reading.is_distance && band > value,
            }
        });
        bands.collect()
    }

    /// All errors of the hand: act, which of its errors, limit.
    fn errors(&self, tolerance: &Tolerance) -> Vec<(usize, usize, f64)> {
        let acts = self.acts.iter().enumerate();
        let errors = acts.flat_map(|(act, a)| {
            let errors = a.deed.errors().iter().enumerate();
            errors.map(move |(which, error)| (act, which, error.limit(tolerance)))
        });
        errors.collect()
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
