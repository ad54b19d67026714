use super::{Path, Position};
use crate::construction::{Construction, construct};
use crate::geometry::Row;
use crate::motion::{Order, motion};
use crate::quantity::{Asked, Quantity, QuantityError};

/// What is asked for at every position of a sweep.
#[derive(Clone, Debug)]
pub struct Column {
    /// The quantity.
    pub asked: Asked,
}

impl Column {
    /// Names of its numbers: that of the quantity, of a vector with `.x` and `.y`.
    pub fn names(&self) -> impl Iterator<Item = String> + '_ {
        let parts: &[&str] = if self.asked.is_vector() { &[".x", ".y"] } else { &[""] };
        parts.iter().map(|part| format!("{}{part}", self.asked.name()))
    }
}

/// Quantities that are read together at positions of a path.
#[derive(Clone, Debug)]
pub(super) struct Columns<'a> {
    pub path: &'a Path<'a>,
    pub list: Vec<Column>,
    constructs: bool,
}

impl<'a> Columns<'a> {
    /// The quantities of these names.
    pub fn new(path: &'a Path<'a>, names: &[String]) -> Result<Self, QuantityError> {
        let column = |name: &String| {
            let asked = Asked::new(name, path.mechanism)?;
            Ok(Column { asked })
        };
        let list = names.iter().map(column).collect::<Result<Vec<_>, _>>()?;
        Ok(Self::of(path, list))
    }

    /// These quantities.
    pub fn of(path: &'a Path<'a>, list: Vec<Column>) -> Self {
        let constructs = list.iter().any(|c| c.asked.needs_construction());
        Columns { path, list, constructs }
    }

    /// Their values at a position, in order; none where it is singular or a quantity has no value.
    pub fn values<'p, R: Row>(
        &'p self,
        position: Option<Position<'p, R>>,
    ) -> impl Iterator<Item = (&'p Column, Option<Quantity>)> + 'p {
        let built = position.filter(|_| self.constructs).and_then(|p| self.construct(&p));
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

    /// The plans at a position; none where it is singular.
    fn construct<R: Row>(&self, position: &Position<R>) -> Option<Construction> {
        let (mechanism, pose) = (self.path.mechanism, position.pose());
        let motion = motion(mechanism, &pose, Order::Acceleration).ok()?;
        Some(construct(mechanism, &pose, &motion))
    }

    /// Whether every plan point that is asked for is there, at the first of some values of the drive that has plans.
    pub fn check(&self, values: impl Iterator<Item = f64>) -> Result<(), QuantityError> {
        let mut walker = self.path.walker();
        for value in values.take_while(|_| self.constructs) {
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
