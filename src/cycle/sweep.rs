use super::columns::{Column, Columns};
use super::{Drive, MANY, Path, Position, Steps};
use crate::geometry::{Eight, Number};
use crate::mechanism::{GROUND, Mechanism, PointId, SliderId};
use crate::plan::{Quantity, QuantityError};
use std::collections::BTreeSet;
use std::ops::Range;

/// How many positions go through the kernel side by side.
const LANES: usize = 8 * MANY;

/// A path read at equal steps: a table with a row for each value of the drive and a column for each number.
#[derive(Clone, Debug)]
pub struct Sweep<'a> {
    path: &'a Path<'a>,
    steps: Steps,
    columns: Columns<'a>,
}

/// Numbers of a table, row after row; none where a position is singular or a quantity has no value.
pub type Numbers = Vec<Option<f64>>;

impl<'a> Sweep<'a> {
    /// The table for the values of `steps` that the path has reached; the first column is the drive's value.
    ///
    /// `names` are quantities as in `want`; without them: angles and rates of all links, places and motions of all points that move,
    /// positions and rates of all sliders.
    ///
    /// # Errors
    /// A name is no quantity of this mechanism.
    pub fn new(
        path: &'a Path<'a>,
        steps: Steps,
        names: Option<&[String]>,
    ) -> Result<Self, QuantityError> {
        let mechanism = path.mechanism;
        let mut names = names.map_or_else(|| every_name(mechanism), <[String]>::to_vec);
        // Each name once; the drive's value is the first column already.
        let mut seen = BTreeSet::from([path.drive.quantity()]);
        names.retain(|name| seen.insert(name.clone()));
        let columns = Columns::new(path, &names)?;
        if let Some(column) = columns.list.iter().find(|c| c.asked.is_on_paper()) {
            let name = column.asked.name().to_owned();
            return Err(QuantityError::NoValue(name, "a table has no scale"));
        }
        let steps = steps.within(path.low(), path.high());
        // A plan point that does not exist shows in the first row with plans, before anything is written.
        let first = (0..steps.count().min(LANES)).map(|row| steps.value(row));
        columns.check(first)?;
        Ok(Sweep {
            path,
            steps,
            columns,
        })
    }

    /// The values of the drive.
    #[must_use]
    pub fn steps(&self) -> &Steps {
        &self.steps
    }

    /// The drive that is moved.
    #[must_use]
    pub fn drive(&self) -> &Drive {
        &self.path.drive
    }

    /// What is asked for, in order, after the drive's value.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns.list
    }

    /// Names of the numbers of a row.
    #[must_use]
    pub fn header(&self) -> Vec<String> {
        let drive = std::iter::once(self.path.drive.quantity());
        drive
            .chain(self.columns().iter().flat_map(Column::names))
            .collect()
    }

    /// The numbers of these rows.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>) -> Numbers {
        let mut numbers = Numbers::with_capacity(rows.len() * self.header().len());
        let mut many = self.path.walker_of::<Eight, MANY>();
        let mut one = self.path.walker();
        let mut next = rows.start;
        while next < rows.end {
            let full = rows.end - next >= LANES;
            let value = |i: usize| self.steps.value(next + i);
            let values = std::array::from_fn(|k| Eight::from_lanes(|i| value(8 * k + i)));
            let block = if full {
                many.many_motions(&values)
            } else {
                None
            };
            if let Some(block) = block {
                for lane in 0..LANES {
                    let position = self.path.position(block, lane);
                    self.read(value(lane), Some(position), &mut numbers);
                }
                next += LANES;
                continue;
            }
            // The block crosses a node, ends the range, or holds a singular position.
            for value in (0..LANES.min(rows.end - next)).map(value) {
                self.read(value, one.position(value), &mut numbers);
            }
            next = (next + LANES).min(rows.end);
        }
        numbers
    }

    /// The same on all cores.
    #[cfg(feature = "parallel")]
    #[must_use]
    pub fn rows_on_all_cores(&self, rows: Range<usize>) -> Numbers {
        use rayon::prelude::*;
        const PIECE: usize = 1024;
        let firsts: Vec<usize> = rows.clone().step_by(PIECE).collect();
        let pieces = firsts
            .par_iter()
            .map(|first| self.rows(*first..(first + PIECE).min(rows.end)));
        pieces.collect::<Vec<Numbers>>().concat()
    }

    /// Appends a row.
    fn read<T: Number, const M: usize>(
        &self,
        value: f64,
        position: Option<Position<T, M>>,
        numbers: &mut Numbers,
    ) {
        numbers.push(Some(value));
        let finite = |x: f64| x.is_finite().then_some(x);
        for (column, found) in self.columns.values(position) {
            match found {
                Some(Quantity::Number(x)) => numbers.push(finite(x)),
                Some(Quantity::Vector(v)) => numbers.extend([finite(v.x), finite(v.y)]),
                None => numbers.extend(column.names().map(|_| None)),
            }
        }
    }
}

/// Names of everything that a table shows where nothing is asked for.
fn every_name(mechanism: &Mechanism) -> Vec<String> {
    let links = mechanism.links().map(|(_, body)| &body.name);
    let links = links.flat_map(|l| ["angle", "omega", "alpha"].map(|head| format!("{head}({l})")));
    let fixed = &mechanism.body(GROUND).points;
    let points = (0..mechanism.points.len()).map(PointId);
    let points = points.filter(|p| !fixed.contains(p)).flat_map(|p| {
        let name = mechanism.point_name(p);
        ["x", "y", "v", "a"].map(|head| format!("{head}({name})"))
    });
    let sliders = (0..mechanism.sliders.len()).map(|s| mechanism.slider_name(SliderId(s)));
    let sliders =
        sliders.flat_map(|s| ["position", "v_r", "a_r"].map(|head| format!("{head}({s})")));
    links.chain(points).chain(sliders).collect()
}
