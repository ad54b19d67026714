//! The motion: a table in memory, column by column; extremes.

use crate::plot::symbols;
use crate::pool::on_all_cores;
use crate::scene::Scene;
use crate::table::{Notes, Table, empty};
use crate::wanted::Wanted;
use kinegon::Error;
use kinegon::cycle::{Curves, Drive, Path, Steps, Sweep, alone};
use kinegon::mechanism::Mechanism;
use kinegon::position::Pose;
use kinegon::quantity::{QuantityKind, QuantityRequest};
use kinegon::scene::{SizeLimit, Units};
use kinegon::words::Wording;
use pyo3::prelude::*;

/// Rows that are computed before Python may interrupt.
const ROWS: usize = 1 << 16;

/// The table of a scene in the assembly mode of that number, or in its own.
pub fn table(scene: &Scene, mode: Option<usize>, wanted: &Wanted) -> PyResult<Table> {
    let (mechanism, pose) = scene.posed(SizeLimit::NUMBERS, mode)?;
    table_of(scene, &mechanism, &pose, wanted)
}

/// The table of a mechanism that starts in a pose.
pub fn table_of(scene: &Scene, mechanism: &Mechanism, pose: &Pose, wanted: &Wanted) -> PyResult<Table> {
    moved(scene, mechanism, pose, wanted, |path, range| {
        let refused = |error: Error| scene.refused(error);
        let step = wanted.step.unwrap_or_else(|| path.usual_step(range));
        let steps = if wanted.is_part() { Steps::new(range[0], range[1], step) } else { path.rows(range, step) };
        let steps = steps.map_err(|error| refused(error.into()))?;
        let sweep = Sweep::new(path, steps, wanted.names(scene)).map_err(|error| refused(error.into()))?;
        let sweep = if wanted.errors { sweep.with_errors(&scene.scene) } else { sweep };
        let data = numbers(&sweep, wanted.huge)?;
        let units = units(&sweep, scene.scene.units);
        let notes = notes(path, range, wanted.is_part(), &Wording::of(&scene.scene.figure));
        let symbols = symbols(&sweep, mechanism, &Wording::of(&scene.scene.figure).notation);
        Ok(Table::of(sweep.header(), units, sweep.steps.count(), data, notes).with_symbols(symbols))
    })
}

/// A quantity's name and unit, and where on the way of the drive it is least and greatest: the drive's value and its own, and how far
/// each can be from that; none where it grows without bound.
pub type Extremes = (String, String, Option<[f64; 4]>, Option<[f64; 4]>);

/// The extremes of a mechanism that starts in a pose, and that a part of the range cannot be reached.
pub fn extremes_of(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    wanted: &Wanted,
) -> PyResult<(Vec<Extremes>, Option<String>)> {
    moved(scene, mechanism, pose, wanted, |path, mut range| {
        if !wanted.is_part() {
            range = path.shown_range(range);
        }
        let names = wanted.names(scene);
        let curves = on_all_cores(|| Curves::new(path, range, names))?;
        let curves = curves.map_err(|error| scene.refused(Error::from(error)))?;
        let extremes = curves.curves.iter().flat_map(|curve| {
            let certain = curves.certain_extremes(&scene.scene, curve);
            let [least, greatest] = certain.map(|found| found.map(|e| [e.at, e.value, e.within, e.error]));
            let unit = curve.kind().unit(scene.scene.units);
            curve.asked.iter().map(move |asked| (asked.name().to_owned(), unit.clone(), least, greatest))
        });
        let cut = notes(path, range, wanted.is_part(), &Wording::of(&scene.scene.figure)).cut;
        Ok((extremes.collect(), cut))
    })
}

/// What is made of the way of a mechanism that starts in a pose, and of the range of its drive.
fn moved<T>(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    wanted: &Wanted,
    made: impl FnOnce(&mut Path<'_>, [f64; 2]) -> PyResult<T>,
) -> PyResult<T> {
    let refused = |error: Error| scene.refused(error);
    let drive = Drive::new(mechanism, wanted.drive.as_deref()).map_err(|error| refused(error.into()))?;
    let still = wanted.alone.then(|| alone(mechanism, &drive.name));
    let mechanism = still.as_ref().unwrap_or(mechanism);
    let mut path = Path::new(mechanism, pose, drive).map_err(|error| refused(error.into()))?;
    let range = path.cover(wanted.start, wanted.stop).map_err(|error| refused(error.into()))?;
    made(&mut path, range)
}

/// The units of the columns.
fn units(sweep: &Sweep<'_>, units: Units) -> Vec<String> {
    let drive = if sweep.path.drive.is_angle { QuantityKind::Angle } else { QuantityKind::Position };
    let of = |asked: &QuantityRequest| {
        let count = 1 + usize::from(asked.is_vector()) + usize::from(sweep.error_name(asked).is_some());
        vec![asked.kind().unit(units); count]
    };
    std::iter::once(drive.unit(units)).chain(sweep.columns.iter().flat_map(of)).collect()
}

/// All numbers, column after column; NaN where there is none.
fn numbers(sweep: &Sweep<'_>, is_huge: bool) -> PyResult<Vec<f64>> {
    let (rows, columns) = (sweep.steps.count(), sweep.header().len());
    let hint =
        "take a larger step, a part of the range (start, stop) or fewer quantities (want); with huge=True it is made";
    let mut data = empty(rows, columns, is_huge, hint)?;
    for first in (0..rows).step_by(ROWS) {
        let block = on_all_cores(|| sweep.rows_on_all_cores(first..(first + ROWS).min(rows)))?;
        for (row, numbers) in (first..).zip(block.chunks_exact(columns)) {
            for (column, number) in numbers.iter().enumerate() {
                data[column * rows + row] = number.unwrap_or(f64::NAN);
            }
        }
        Python::attach(|py| py.check_signals())?;
    }
    Ok(data)
}

/// What is to be told of the motion.
fn notes(path: &Path<'_>, range: [f64; 2], is_given: bool, words: &Wording) -> Notes {
    let beyond = |value: f64| !(path.low()..=path.high()).contains(&value);
    let limits = path.limits(is_given.then_some(range), words);
    let cut = (is_given && range.into_iter().any(beyond)).then(|| {
        let [from, to] = range.map(|value| path.drive.amount(value));
        format!(
            "only a part of the range from {from} to {to} can be reached, and only it is in the table: {}",
            limits.join("; ")
        )
    });
    Notes { events: path.happenings(range, words), limits, cut }
}
