//! The elementary acts of drawing plans, and what a mistake makes of them.

use super::plane::Place;
use super::sheet::Sheet;
use std::rc::Rc;

/// What is done in an act; its value is a number, or a place where that is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Doing {
    /// A length of the scheme enters a computation.
    Length,
    /// An ω, an α or a speed enters a computation.
    Rate,
    /// The size of a vector is computed.
    Size,
    /// A vector is laid off in a direction (radians).
    Heading,
    /// … from a place of the plan.
    Start,
    /// A ray is drawn in a direction (radians).
    Ray,
    /// … through a place of the plan.
    RayStart,
    /// The image of a point of a link with two images: the complex ratio of both lines from one of them.
    Ratio,
    /// A segment is measured; in units of its quantity.
    Reading,
    /// The sense of a rate is read off: +1 or −1.
    Sense,
    /// A rate is found, with its sense, and gone on with.
    Found,
    /// A value is written into the form.
    Written,
}

/// What a vector's size is computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Formula {
    /// None: it is given.
    Given,
    /// ω L
    Turning,
    /// ω² L
    Normal,
    /// α L
    Tangential,
    /// 2 ω v
    Coriolis,
    /// Along a guide.
    Sliding,
}

/// An act: what is done, where, and with which value.
#[derive(Clone, Debug)]
pub struct Act {
    pub doing: Doing,
    /// 0: scheme, 1: velocity plan, 2: acceleration plan.
    pub plan: usize,
    pub formula: Formula,
    /// The link or slider that it is about, as in the form's names; may be empty.
    pub link: String,
    /// The ends of the vector, ray, segment or length.
    pub ends: [String; 2],
    /// The quantity that is found or written; may be empty.
    pub quantity: String,
    pub value: Value,
}

/// A number or a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Number(f64),
    Place(Place),
}

impl Value {
    pub fn number(self) -> f64 {
        match self {
            Value::Number(x) => x,
            Value::Place(place) => place.re,
        }
    }

    pub fn place(self) -> Place {
        match self {
            Value::Number(x) => Place::new(x, 0.0),
            Value::Place(place) => place,
        }
    }
}

impl Act {
    pub fn new(doing: Doing, plan: usize, link: &str, from: &str, to: &str) -> Act {
        Act {
            doing,
            plan,
            formula: Formula::Given,
            link: link.to_owned(),
            ends: [from, to].map(str::to_owned),
            quantity: String::new(),
            value: Value::Number(0.0),
        }
    }

    pub fn by(mut self, formula: Formula) -> Act {
        self.formula = formula;
        self
    }

    pub fn of(mut self, quantity: &str) -> Act {
        self.quantity = quantity.to_owned();
        self
    }

    /// What tells it from all others of a sheet.
    pub fn key(&self) -> String {
        let [from, to] = &self.ends;
        format!("{:?} {:?} {} {} {from} {to} {}", self.doing, self.formula, self.plan, self.link, self.quantity)
    }
}

/// What a mistake makes of an act's value, on the sheet as it is by then.
pub type Change = Rc<dyn Fn(Value, &mut Sheet<'_>) -> Value>;
