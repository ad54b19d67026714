use super::together::Together;
use super::{Path, Position, Steps};
use crate::accuracy::bounds;
use crate::construction::{Extent, construct};
use crate::geometry::{MANY, Row};
use crate::mechanism::{GROUND, Mechanism, SliderId};
use crate::motion::motion;
use crate::quantity::{Quantity, QuantityError, QuantityRequest};
use crate::scene::Scene;
use crate::sheet::Order;
use std::collections::BTreeSet;
use std::ops::Range;

/// A path read at equal steps: a table with a row for each value of the drive and a column for each number.
#[derive(Clone, Debug)]
pub struct Sweep<'a> {
    /// The path.
    pub path: &'a Path<'a>,
    /// The values of the drive.
    pub steps: Steps,
    /// The quantities asked for, in order, without the drive's value.
    pub columns: Vec<QuantityRequest>,
    /// Whether one of the quantities needs the construction.
    constructs: bool,
    /// The scene, where each quantity is followed by the bound of its error.
    errors: Option<&'a Scene>,
}

/// Numbers of a table, row after row; `None` where a position is singular or a quantity has no value.
pub type Numbers = Vec<Option<f64>>;

impl<'a> Sweep<'a> {
    /// The table for the values of `steps` that the path has reached; the first column is the drive's value.
    ///
    /// `names` are quantities as in a scene's `want`; without them: angles and rates of all links, places and motions
    /// of all points that move, positions and rates of all sliders.
    ///
    /// # Errors
    /// A name is no quantity of this mechanism.
    pub fn new(path: &'a Path<'a>, steps: Steps, names: Option<&[String]>) -> Result<Self, QuantityError> {
        let mechanism = &path.mechanism;
        let mut names = names.map_or_else(|| every_name(mechanism), <[String]>::to_vec);
        // Each name once; the drive's value is the first column already.
        let mut seen = BTreeSet::from([path.drive.quantity.clone()]);
        names.retain(|name| seen.insert(name.clone()));
        let columns = names.iter().map(|name| QuantityRequest::new(name, mechanism));
        let columns = columns.map(|asked| asked?.for_many(mechanism, || path.start_pose()));
        let columns: Vec<QuantityRequest> = columns.collect::<Result<_, _>>()?;
        if let Some(asked) = columns.iter().find(|asked| asked.written.on_paper) {
            let name = asked.name().to_owned();
            return Err(QuantityError::NoValue(name, crate::quantity::says::no_scale_in_table()));
        }
        let steps = steps.within(path.low(), path.high());
        // A plan point that does not exist is found in the first row with plans, before anything is written.
        let first = (0..steps.count().min(MANY)).map(|row| steps.value(row));
        check_plan_points(path, &columns, first)?;
        let constructs = columns.iter().any(QuantityRequest::needs_construction);
        Ok(Sweep { path, steps, columns, constructs, errors: None })
    }

    /// The table with a further number for each quantity: the bound of its error, of a vector that of each component,
    /// as [`Bounds`](crate::accuracy::Bounds) has it. The drive's value counts as given; `scene` is that of
    /// the path's mechanism. It takes some hundred times as long.
    #[must_use]
    pub fn with_errors(self, scene: &'a Scene) -> Self {
        Sweep { errors: Some(scene), ..self }
    }

    /// Names of the numbers of a row.
    #[must_use]
    pub fn header(&self) -> Vec<String> {
        let drive = std::iter::once(self.path.drive.quantity.clone());
        let columns = self.columns.iter();
        drive.chain(columns.flat_map(|asked| column_names(asked).chain(self.error_name(asked)))).collect()
    }

    /// The name of the number that bounds the error of a quantity, if the table has bounds.
    #[must_use]
    pub fn error_name(&self, asked: &QuantityRequest) -> Option<String> {
        self.errors.is_some().then(|| format!("{}_error", asked.name()))
    }

    /// The numbers of these rows.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>) -> Numbers {
        let mut numbers = Numbers::with_capacity(rows.len() * self.header().len());
        let bare = self.errors.is_none() && self.columns.iter().all(QuantityRequest::is_of_links_alone);
        let mut many = if bare { self.path.many_walker_without_places() } else { self.path.many_walker() };
        let mut one = self.path.walker();
        let mut next = rows.start;
        let mut values = [0.0; MANY];
        while next < rows.end {
            let values = &mut values[..MANY.min(rows.end - next)];
            for (value, row) in values.iter_mut().zip(next..) {
                *value = self.steps.value(row);
            }
            let (count, block) = many.motions(values);
            let together = block
                .filter(|_| self.errors.is_none())
                .and_then(|block| self.path.together(block, count, &self.columns));
            for (lane, value) in values[..count].iter().enumerate() {
                match block {
                    Some(block) => {
                        let position = self.path.position(block, lane);
                        let forces = together.as_ref().map(|together| (together, lane));
                        self.read(*value, Some(position), forces, &mut numbers);
                    }
                    // Some position of the block is singular: read one by one, only that position has no numbers.
                    None => self.read(*value, one.position(*value), None, &mut numbers),
                }
            }
            next += count;
        }
        numbers
    }

    /// As [`Self::rows`], computed on all cores.
    #[cfg(feature = "parallel")]
    #[must_use]
    pub fn rows_on_all_cores(&self, rows: Range<usize>) -> Numbers {
        const PIECE: usize = 1024;
        let firsts: Vec<usize> = rows.clone().step_by(PIECE).collect();
        let piece = |first: &usize| self.rows(*first..(first + PIECE).min(rows.end));
        crate::cores::on_all_cores(&firsts, piece).concat()
    }

    /// Appends the row of a position to `numbers`; `forces` are those of several positions, with the place of this one.
    fn read<R: Row>(
        &self,
        value: f64,
        position: Option<Position<R>>,
        forces: Option<(&Together, usize)>,
        numbers: &mut Numbers,
    ) {
        numbers.push(Some(value));
        if let Some(scene) = self.errors {
            return self.read_with_errors(scene, value, position, numbers);
        }
        let built = position.as_ref().filter(|_| self.constructs).and_then(|position| position.construction());
        for (column, asked) in self.columns.iter().enumerate() {
            // What needs the construction has no value without it.
            let by_itself = || position.as_ref().and_then(|position| asked.value(position, built.as_ref(), None).ok());
            let force = forces.and_then(|(together, lane)| together.value(asked, column, lane));
            push(asked, force.unwrap_or_else(by_itself), numbers);
        }
    }

    /// As [`Self::read`], with the bounds of errors. Rates are those of [`motion`], which are bounded.
    fn read_with_errors<R: Row>(
        &self,
        scene: &Scene,
        value: f64,
        position: Option<Position<R>>,
        numbers: &mut Numbers,
    ) {
        let mechanism = &self.path.mechanism_at(value);
        let moved = position.and_then(|position| {
            let pose = position.pose();
            let motion = motion(mechanism, &pose, Order::Acceleration).ok()?;
            let built = self.constructs.then(|| construct(mechanism, &pose, &motion, Extent::Points));
            Some((pose, motion, built))
        });
        let state = moved.as_ref().map(|(pose, motion, built)| {
            let bounds = bounds(scene, mechanism, pose, motion);
            built.iter().fold(bounds, |bounds, built| bounds.with_plans(built))
        });
        for asked in &self.columns {
            let found = state.as_ref().and_then(|bounds| bounds.valued(asked, None).ok());
            push(asked, found.map(|(value, _)| value), numbers);
            numbers.push(found.map(|(_, error)| error).filter(|error| error.is_finite()));
        }
    }
}

/// Checks that every plan point asked for exists, at the first of these values of the drive that has plans.
pub(super) fn check_plan_points(
    path: &Path,
    asked: &[QuantityRequest],
    values: impl Iterator<Item = f64>,
) -> Result<(), QuantityError> {
    if !asked.iter().any(QuantityRequest::needs_construction) {
        return Ok(());
    }
    let mut walker = path.walker();
    for value in values {
        let Some(position) = walker.position(value) else { continue };
        let Some(built) = position.construction() else { continue };
        let values = asked.iter().map(|asked| asked.value(&position, Some(&built), None));
        let unknown = values.filter_map(Result::err).find(|error| matches!(error, QuantityError::Unknown { .. }));
        return unknown.map_or(Ok(()), Err);
    }
    Ok(())
}

/// Names of the numbers of a quantity: its own, for a vector with `.x` and with `.y`.
fn column_names(asked: &QuantityRequest) -> impl Iterator<Item = String> + '_ {
    let parts: &[&str] = if asked.is_vector() { &[".x", ".y"] } else { &[""] };
    parts.iter().map(|part| format!("{}{part}", asked.name()))
}

/// Appends the numbers of a quantity.
fn push(asked: &QuantityRequest, found: Option<Quantity>, numbers: &mut Numbers) {
    let finite = |x: f64| x.is_finite().then_some(x);
    match found {
        Some(Quantity::Number(x)) => numbers.push(finite(x)),
        Some(Quantity::Vector(v)) => numbers.extend([finite(v.x), finite(v.y)]),
        None => numbers.extend(column_names(asked).map(|_| None)),
    }
}

/// Names of the quantities of a table for which none are asked: angles and rates of all links, places and motions of all
/// points that move, positions and rates of all sliders.
#[must_use]
pub fn every_name(mechanism: &Mechanism) -> Vec<String> {
    let links = mechanism.links().map(|(_, body)| &body.name);
    let links = links.flat_map(|l| ["angle", "omega", "alpha"].map(|head| format!("{head}({l})")));
    let fixed = &mechanism.body(GROUND).points;
    let points = mechanism.point_ids();
    let points = points.filter(|p| !fixed.contains(p)).flat_map(|p| {
        let name = mechanism.point_name(p);
        ["x", "y", "v", "a"].map(|head| format!("{head}({name})"))
    });
    let sliders = (0..mechanism.sliders.len()).map(|s| mechanism.slider_name(SliderId(s)));
    let sliders = sliders.flat_map(|s| ["position", "v_r", "a_r"].map(|head| format!("{head}({s})")));
    links.chain(points).chain(sliders).collect()
}
