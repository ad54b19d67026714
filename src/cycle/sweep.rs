use super::columns::{Column, Columns};
use super::{CycleError, Drive, MANY, Path, Position};
use crate::geometry::{Eight, Number};
use crate::mechanism::{GROUND, Mechanism, PointId, SliderId};
use crate::plan::{Quantity, QuantityError};
use std::ops::Range;

/// The most values that a table may have.
const MOST: f64 = 1e12;

/// How many positions go through the kernel side by side.
const LANES: usize = 8 * MANY;

/// Values of a drive at equal steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    from: f64,
    step: f64,
    count: usize,
}

impl Steps {
    /// The values `from`, `from` ± `step` … as far as `to`; the sign of the step follows from the direction.
    ///
    /// # Errors
    /// [`CycleError::Range`] where a number is not finite, the step is zero or leads away from `to`, or there are too many values.
    pub fn new(from: f64, to: f64, step: f64) -> Result<Steps, CycleError> {
        let refuse = |text: String| Err(CycleError::Range(text));
        let wide = to - from;
        if !(wide.is_finite() && step.is_finite()) {
            return refuse("the range and the step must be finite numbers".into());
        }
        if step == 0.0 {
            let hint = "the distance from one position to the next, as 1";
            return refuse(format!("the step is zero\n  try: {hint}"));
        }
        if step < 0.0 && wide > 0.0 {
            let hint = "a positive step; its sign follows from the range";
            return refuse(format!(
                "a step of {step} leads away from {to}\n  try: {hint}"
            ));
        }
        let step = step.abs().copysign(wide);
        // A quotient that rounding has left just below a whole number is that number.
        let intervals = (wide / step * (1.0 + 8.0 * f64::EPSILON)).floor();
        if intervals >= MOST {
            return refuse(format!(
                "there are more than {MOST:e} steps of {step} from {from} to {to}"
            ));
        }
        let count = intervals as usize + 1;
        Ok(Steps { from, step, count })
    }

    /// How many values there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The value of that index.
    #[inline]
    #[must_use]
    pub fn value(&self, index: usize) -> f64 {
        self.from + self.step * index as f64
    }

    /// The part of them that lies between two values, both included.
    fn within(&self, low: f64, high: f64) -> Steps {
        let inside = |index: &usize| (low..=high).contains(&self.value(*index));
        let rising = self.step > 0.0;
        let (near, far) = if rising { (low, high) } else { (high, low) };
        // The quotients may be one off by rounding.
        let index =
            |value: f64| ((value - self.from) / self.step).clamp(0.0, self.count as f64) as usize;
        let first = (index(near).saturating_sub(1)..self.count)
            .take(4)
            .find(inside);
        let last = (0..=(index(far) + 1).min(self.count - 1))
            .rev()
            .take(4)
            .find(inside);
        match (first, last) {
            (Some(first), Some(last)) => Steps {
                from: self.value(first),
                step: self.step,
                count: last + 1 - first,
            },
            _ => Steps { count: 0, ..*self },
        }
    }
}

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
        // The drive's value is the first column already.
        names.retain(|name| *name != path.drive.quantity());
        let columns = Columns::new(path, &names)?;
        let steps = steps.within(path.low(), path.high());
        // A plan point that does not exist shows in the first row, before anything is written.
        if steps.count > 0 {
            columns.check(steps.value(0))?;
        }
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
