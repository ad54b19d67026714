//! The things that a hand has made so far, by their names.

use super::formula::Formula;
use super::given::Given;
use super::names::segment_of;
use super::says;
use crate::construction::image_name;
use crate::geometry::{Vector, cross};
use crate::message::Message;
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, PerSheet, Sheet};
use indexmap::IndexMap;
use std::cell::RefCell;

/// A line on a sheet: a place of it and its unit direction, in units of the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnLine {
    /// The sheet.
    pub sheet: Sheet,
    /// A place of it.
    pub at: Vector,
    /// Its unit direction.
    pub along: Vector,
}

impl DrawnLine {
    /// How far a place is to the left of it.
    #[must_use]
    pub fn distance(&self, place: Vector) -> f64 {
        cross(self.along, place - self.at)
    }
}

/// What an entry makes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Made {
    /// A point: its sheet, its name, its place.
    Place(Sheet, String, Vector),
    /// A line with its name.
    Line(String, DrawnLine),
    /// Numbers with their names.
    Numbers(Vec<(String, f64)>),
}

/// A thing by its sheet, where it has one, and its name.
pub(super) type Thing = (Option<Sheet>, String);

/// The things that are made.
pub(super) fn things(made: &Made) -> Vec<Thing> {
    match made {
        Made::Place(sheet, name, _) => vec![(Some(*sheet), name.clone())],
        Made::Line(name, _) => vec![(None, name.clone())],
        Made::Numbers(all) => all.iter().map(|(name, _)| (None, name.clone())).collect(),
    }
}

/// The things on the sheets and the numbers beside them, by name, in one scene: those of the hand, or the right ones.
#[derive(Clone, Debug)]
pub struct Table<'g> {
    pub(super) given: &'g Given,
    pub(super) places: IndexMap<(Sheet, String), Vector>,
    pub(super) lines: IndexMap<String, DrawnLine>,
    pub(super) numbers: IndexMap<String, f64>,
    /// Units of each sheet per millimetre of paper.
    pub(super) scales: PerSheet<f64>,
    /// The numbers that are taken with the other sign.
    turned: RefCell<Vec<String>>,
}

impl<'g> Table<'g> {
    /// A table on which nothing has been drawn yet.
    #[must_use]
    pub fn new(given: &'g Given, scales: PerSheet<f64>) -> Table<'g> {
        let places = given.there().map(|(sheet, name, place)| ((sheet, name.to_owned()), place));
        Table {
            given,
            places: places.collect(),
            lines: IndexMap::new(),
            numbers: IndexMap::new(),
            scales,
            turned: RefCell::default(),
        }
    }

    /// Units of a sheet per millimetre of paper.
    #[must_use]
    pub fn scale(&self, sheet: Sheet) -> f64 {
        self.scales[sheet]
    }

    /// The same of all sheets.
    pub(super) fn scales(&self) -> PerSheet<f64> {
        self.scales
    }

    /// The points that are there.
    pub fn places(&self, sheet: Sheet) -> impl Iterator<Item = (&str, Vector)> {
        let on = self.places.iter().filter(move |((other, _), _)| *other == sheet);
        on.map(|((_, name), place)| (name.as_str(), *place))
    }

    /// A point that is there.
    #[must_use]
    pub fn place(&self, sheet: Sheet, name: &str) -> Option<Vector> {
        self.places.get(&(sheet, self.given.usual(sheet, name))).copied()
    }

    /// The lines that are there.
    pub fn lines(&self) -> impl Iterator<Item = (&str, &DrawnLine)> {
        self.lines.iter().map(|(name, line)| (name.as_str(), line))
    }

    /// The numbers that have been found.
    pub fn numbers(&self) -> impl Iterator<Item = (&str, f64)> {
        self.numbers.iter().map(|(name, number)| (name.as_str(), *number))
    }

    /// The number that has been found under just this name.
    #[must_use]
    pub fn number_of(&self, name: &str) -> Option<f64> {
        self.numbers.get(name).copied()
    }

    /// Puts down what an entry has made.
    pub fn put(&mut self, made: Made) {
        match made {
            Made::Place(sheet, name, at) => drop(self.places.insert((sheet, name), at)),
            Made::Line(name, line) => drop(self.lines.insert(name, line)),
            Made::Numbers(all) => self.numbers.extend(all),
        }
    }

    /// The value of a formula.
    ///
    /// # Errors
    /// A number in it is not known yet.
    pub(super) fn formula(&self, formula: &Formula) -> Result<f64, Message> {
        let value = formula.value(&mut |name| self.number(name))?;
        if value.is_finite() { Ok(value) } else { Err(says::no_value(formula.text())) }
    }

    /// A number by its name, with the other sign where a judge asks for that.
    ///
    /// # Errors
    /// It is not known yet.
    pub(super) fn number(&self, name: &str) -> Result<f64, Message> {
        let number = self.number_as_is(name).ok_or_else(|| says::no_number(name))?;
        Ok(if self.turned.borrow().iter().any(|turned| turned == name) { -number } else { number })
    }

    /// Takes some numbers with the other sign, or none.
    pub(super) fn turn(&self, names: Vec<String>) {
        self.turned.replace(names);
    }

    /// The numbers in formulas whose signs may be others in other scenes, as the sheet shows them: segments of plans, lengths up to
    /// special points, numbers of the hand's own.
    pub(super) fn signed(&self, formulas: &[&Formula]) -> Vec<String> {
        let is_joint = |name: &String| self.given.mechanism().point(name).is_some();
        let mut names: Vec<String> = Vec::new();
        for name in formulas.iter().flat_map(|formula| formula.names()) {
            let has_sign = match QuantityName::parse(name).map(|quantity| (quantity.head, quantity.arguments)) {
                Some((Head::Between(Sheet::Scheme), ends)) => !ends.iter().all(is_joint),
                Some((Head::Between(_) | Head::Velocity | Head::Acceleration, _)) => true,
                Some(_) => false,
                None => self.numbers.contains_key(name),
            };
            if has_sign && !names.iter().any(|known| known == name) {
                names.push(name.to_owned());
            }
        }
        names
    }

    /// The value of a number that a formula may use; `None` where it is not known yet.
    #[must_use]
    pub fn known(&self, name: &str) -> Option<f64> {
        self.number_as_is(name).filter(|number| number.is_finite())
    }

    fn number_as_is(&self, name: &str) -> Option<f64> {
        if let Some(number) = self.numbers.get(name) {
            return Some(*number);
        }
        // A block turns as its lever does.
        if let Some(number) = self.given.same_rates(name).find_map(|same| self.numbers.get(same)) {
            return Some(*number);
        }
        if let Some(sheet) = Sheet::ALL.into_iter().find(|sheet| sheet.facts().scale_key == name) {
            return Some(self.scales[sheet]);
        }
        if let Some(number) = self.given.given_number(name) {
            return Some(number);
        }
        let quantity = QuantityName::parse(name).filter(QuantityName::is_plain)?;
        let ends =
            |sheet: Sheet, from: &str, to: &str| Some((self.place(sheet, to)? - self.place(sheet, from)?).norm());
        if let Some((sheet, [from, to])) = segment_of(name) {
            return ends(sheet, &from, &to);
        }
        match (quantity.head, quantity.arguments.as_slice()) {
            (Head::Velocity, [point]) => ends(Sheet::Velocity, Order::Velocity.pole(), &image_name(point)),
            (Head::Velocity, [point, from]) => ends(Sheet::Velocity, &image_name(from), &image_name(point)),
            (Head::Acceleration, [point]) => ends(Sheet::Acceleration, Order::Acceleration.pole(), &image_name(point)),
            (Head::Acceleration, [point, from]) => ends(Sheet::Acceleration, &image_name(from), &image_name(point)),
            _ => None,
        }
    }
}
