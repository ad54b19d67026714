use super::{Path, Position};
use crate::accuracy::{bounds, is_bounded};
use crate::construction::{Construction, Extent, construct};
use crate::geometry::Row;
use crate::motion::motion;
use crate::quantity::{Quantity, QuantityError, QuantityRequest, Snapshot};
use crate::scene::Scene;
use crate::sheet::Sheet;

/// A quantity that is asked for at every position of a sweep: a number or a vector.
#[derive(Clone, Debug)]
pub struct Column {
    /// The quantity.
    pub asked: QuantityRequest,
}

impl Column {
    /// Names of its numbers: the quantity's name, for a vector with `.x` and with `.y`.
    pub fn names(&self) -> impl Iterator<Item = String> + '_ {
        let parts: &[&str] = if self.asked.is_vector() { &[".x", ".y"] } else { &[""] };
        parts.iter().map(|part| format!("{}{part}", self.asked.name()))
    }

    /// The name of the bound of its error; `None` of a quantity without one.
    #[must_use]
    pub fn error_name(&self) -> Option<String> {
        is_bounded(&self.asked).then(|| format!("{}_error", self.asked.name()))
    }
}

/// A value with the bound of its error, where it has one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    pub value: Quantity,
    pub error: Option<f64>,
}

/// Quantities that are read together at positions of a path.
#[derive(Clone, Debug)]
pub(super) struct Columns<'a> {
    pub path: &'a Path<'a>,
    pub list: Vec<Column>,
    /// Whether one of them needs the construction.
    constructs: bool,
}

impl<'a> Columns<'a> {
    /// The quantities of these names.
    pub fn new(path: &'a Path<'a>, names: &[String]) -> Result<Self, QuantityError> {
        let column = |name: &String| {
            let asked = QuantityRequest::new(name, &path.mechanism)?;
            Ok(Column { asked })
        };
        let list = names.iter().map(column).collect::<Result<Vec<_>, _>>()?;
        Ok(Self::of(path, list))
    }

    /// The quantities of these columns.
    pub fn of(path: &'a Path<'a>, list: Vec<Column>) -> Self {
        let constructs = list.iter().any(|c| c.asked.needs_construction());
        Columns { path, list, constructs }
    }

    /// The columns with their values at a position, in order; `None` where it is singular or a quantity has no value.
    pub fn values<'p, R: Row>(
        &'p self,
        position: Option<Position<'p, R>>,
    ) -> impl Iterator<Item = (&'p Column, Option<Quantity>)> + 'p {
        let built = if self.constructs { position.and_then(|p| self.construct(&p)) } else { None };
        self.list.iter().map(move |column| {
            let asked = &column.asked;
            let found = position.and_then(|position| {
                if asked.needs_construction() {
                    let built = built.as_ref()?;
                    asked.value(&position, Some(built), None).ok()
                } else {
                    asked.value(&position, None, None).ok()
                }
            });
            (column, found)
        })
    }

    /// As [`Self::values`], each with the bound of its error: of a vector in each component. Rates are those of
    /// [`motion`], which are bounded.
    /// `scene` is the path's, `value` that of its drive.
    pub fn values_with_errors<R: Row>(
        &self,
        scene: &Scene,
        value: f64,
        position: Option<Position<'_, R>>,
    ) -> Vec<(&Column, Option<Bounded>)> {
        let Columns { path, list, .. } = self;
        let mechanism = &path.mechanism_at(value);
        let moved = position.and_then(|position| {
            let pose = position.pose();
            let motion = motion(mechanism, &pose, Sheet::Acceleration).ok()?;
            let built = self.constructs.then(|| construct(mechanism, &pose, &motion, Extent::Points));
            Some((pose, motion, built))
        });
        let Some((pose, motion, built)) = &moved else {
            return list.iter().map(|column| (column, None)).collect();
        };
        let (state, bounds) = (Snapshot { pose, motion }, bounds(scene, mechanism, pose, motion));
        let bounded = |column: &Column| {
            let value = column.asked.value(&state, built.as_ref(), None).ok()?;
            Some(Bounded { value, error: bounds.of(&column.asked) })
        };
        list.iter().map(|column| (column, bounded(column))).collect()
    }

    /// The construction at a position; `None` where it is singular.
    fn construct<R: Row>(&self, position: &Position<R>) -> Option<Construction> {
        let (mechanism, pose) = (&self.path.mechanism, position.pose());
        let motion = motion(mechanism, &pose, Sheet::Acceleration).ok()?;
        Some(construct(mechanism, &pose, &motion, Extent::Points))
    }

    /// Checks that every plan point asked for exists, at the first of these values of the drive that has plans.
    pub fn check(&self, values: impl Iterator<Item = f64>) -> Result<(), QuantityError> {
        if !self.constructs {
            return Ok(());
        }
        let mut walker = self.path.walker();
        for value in values {
            let Some(position) = walker.position(value) else {
                continue;
            };
            let Some(built) = self.construct(&position) else {
                continue;
            };
            for column in &self.list {
                let value = column.asked.value(&position, Some(&built), None);
                if let Err(error @ QuantityError::Unknown { .. }) = value {
                    return Err(error);
                }
            }
            break;
        }
        Ok(())
    }
}
