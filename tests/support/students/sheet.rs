//! A sheet with both plans, the rates found from them, and the form.

use super::act::{Act, Change, Doing, Formula, Value};
use super::hand::Hand;
use super::plane::{Place, QUARTER, size, unit};
use super::scheme::Scheme;
use std::collections::{BTreeMap, BTreeSet};

/// The images of a plan, in mm of paper from its pole.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    pub images: BTreeMap<String, Place>,
}

/// A line on a plan, as it was drawn.
#[derive(Clone, Debug)]
pub struct Trace {
    pub plan: usize,
    /// The names of both ends; a ray's second is what it is to find.
    pub ends: [String; 2],
    /// Where it begins, in mm from the pole, and its direction in radians.
    pub start: Place,
    pub towards: f64,
    /// A vector that ends there; else a ray.
    pub is_vector: bool,
}

/// What a student has drawn so far.
pub struct Sheet<'a> {
    pub scheme: &'a Scheme,
    pub hand: Hand,
    /// Mistakes: the acts by their keys, and what becomes of them.
    changes: &'a [(String, Change)],
    /// Index 0 is not used: the scheme has its own places.
    pub plans: [Plan; 3],
    pub rates: BTreeMap<String, f64>,
    /// Lengths that were measured or laid off, by plan and ends.
    readings: BTreeMap<(usize, [String; 2]), f64>,
    /// Vectors that a mistake has left out: nothing of them is on the sheet.
    pub left_out: BTreeSet<(usize, [String; 2])>,
    /// Vectors and rays, in their order.
    pub traces: Vec<Trace>,
    /// All acts, in their order.
    pub acts: Vec<Act>,
    /// How many mistakes were made.
    pub made: usize,
}

impl<'a> Sheet<'a> {
    pub fn new(scheme: &'a Scheme, hand: Hand, changes: &'a [(String, Change)]) -> Sheet<'a> {
        Sheet {
            scheme,
            hand,
            changes,
            plans: Default::default(),
            rates: scheme.rates.clone(),
            readings: BTreeMap::new(),
            left_out: BTreeSet::new(),
            traces: Vec::new(),
            acts: Vec::new(),
            made: 0,
        }
    }

    /// What comes of an act: its value, or what a mistake makes of it.
    fn act(&mut self, mut act: Act, value: Value) -> Value {
        let key = act.key();
        act.value = value;
        self.acts.push(act);
        let changes = self.changes;
        let mut value = value;
        for (_, change) in changes.iter().filter(|(changed, _)| *changed == key) {
            self.made += 1;
            value = change(value, self);
        }
        value
    }

    pub fn number(&mut self, act: Act, value: f64) -> f64 {
        self.act(act, Value::Number(value)).number()
    }

    pub fn place(&mut self, act: Act, value: Place) -> Place {
        self.act(act, Value::Place(value)).place()
    }

    /// Units of a plan per mm.
    pub fn scale(&self, plan: usize) -> f64 {
        self.scheme.scales[plan]
    }

    /// The place of an image, in mm from the pole; what is at rest lies there.
    pub fn at(&self, plan: usize, image: &str) -> Place {
        self.plans[plan].images.get(image).copied().unwrap_or_default()
    }

    pub fn has(&self, plan: usize, image: &str) -> bool {
        self.plans[plan].images.contains_key(image) || self.is_pole(image)
    }

    fn is_pole(&self, image: &str) -> bool {
        let is_ground = self.scheme.ground.iter().any(|point| image_of(point) == image);
        ["p", "π"].contains(&image) || is_ground || image.ends_with("_ground")
    }

    pub fn mark(&mut self, plan: usize, image: &str, place: Place) {
        self.plans[plan].images.insert(image.to_owned(), place);
    }

    /// A segment whichever way round and by whichever name of the pole.
    fn segment(&self, plan: usize, from: &str, to: &str) -> (usize, [String; 2]) {
        let own = |image: &str| if plan > 0 && self.is_pole(image) { "pole".to_owned() } else { image.to_owned() };
        let mut ends = [own(from), own(to)];
        ends.sort();
        (plan, ends)
    }

    /// The name by which the form asks for a segment, if it does.
    pub fn asked(&self, plan: usize, from: &str, to: &str) -> Option<String> {
        let wanted = self.segment(plan, from, to);
        let found = self.scheme.form.iter().find(|name| match ends_of(name) {
            Some((own, a, b)) => own == plan && self.segment(plan, a, b) == wanted,
            None => false,
        });
        found.cloned()
    }

    /// The length of a segment as it is measured once, in units of its quantity.
    pub fn read(&mut self, plan: usize, from: &str, to: &str) -> f64 {
        let segment = self.segment(plan, from, to);
        if let Some(read) = self.readings.get(&segment) {
            return *read;
        }
        let vector = match plan {
            0 => (self.scheme.at(to) - self.scheme.at(from)) / self.scale(0),
            _ => self.at(plan, to) - self.at(plan, from),
        };
        let right = self.hand.measured(vector) * self.scale(plan);
        let quantity = self.asked(plan, from, to).unwrap_or_default();
        let read = self.number(Act::new(Doing::Reading, plan, "", from, to).of(&quantity), right);
        self.readings.insert(segment, read);
        read
    }

    /// Measures a segment of a plan anew; of the scheme where the plan is 0.
    pub fn measured(&mut self, plan: usize, from: &str, to: &str) -> f64 {
        let vector = self.at(plan, to) - self.at(plan, from);
        self.hand.measured(vector) * self.scale(plan)
    }

    /// The distance of two points: given, else measured on the scheme.
    pub fn length(&mut self, a: &str, b: &str) -> f64 {
        match self.scheme.given_length(a, b) {
            Some(given) => given,
            None => self.read(0, a, b),
        }
    }

    /// A length as it enters the computation of a quantity or a vector.
    pub fn length_for(&mut self, plan: usize, link: &str, ends: [&str; 2], what: &str) -> f64 {
        let length = self.length(ends[0], ends[1]);
        self.number(Act::new(Doing::Length, plan, link, ends[0], ends[1]).of(what), length)
    }

    /// A rate as it enters the computation of a vector.
    pub fn rate_for(&mut self, plan: usize, rate: &str, what: &str) -> f64 {
        let value = self.rate(rate);
        self.number(Act::new(Doing::Rate, plan, rate, "", "").of(what), value)
    }

    pub fn rate(&self, name: &str) -> f64 {
        *self.rates.get(name).unwrap_or_else(|| panic!("{name} is not known yet"))
    }

    /// Lays off a vector: its signed size in a direction. The written length of a vector that was computed is the one
    /// that was laid off.
    pub fn lay(
        &mut self,
        plan: usize,
        [from, to]: [&str; 2],
        (formula, link): (Formula, &str),
        value: f64,
        towards: f64,
    ) {
        let of = self.asked(plan, from, to).unwrap_or_default();
        let act = |doing| Act::new(doing, plan, link, from, to).by(formula).of(&of);
        let computed = match formula {
            Formula::Given => value,
            _ => self.hand.computed(value),
        };
        let value = self.number(act(Doing::Size), computed);
        let laid = self.hand.laid_off(value.abs() / self.scale(plan));
        let towards = self.number(act(Doing::Heading), towards);
        let towards = self.hand.drawn(towards);
        let start = self.at(plan, from);
        let start = self.place(act(Doing::Start), start);
        let end = start + unit(towards) * laid.copysign(value);
        self.trace(plan, [from, to], (start, towards), true);
        self.mark(plan, to, end);
        let segment = self.segment(plan, from, to);
        self.readings.insert(segment, laid * self.scale(plan));
    }

    /// A ray: a place that it goes through, and its direction.
    pub fn ray(&mut self, plan: usize, link: &str, [from, to]: [&str; 2], towards: f64) -> (Place, f64) {
        let towards = self.number(Act::new(Doing::Ray, plan, link, from, to), towards);
        let start = self.at(plan, from);
        let start = self.place(Act::new(Doing::RayStart, plan, link, from, to), start);
        let towards = self.hand.drawn(towards);
        self.trace(plan, [from, to], (start, towards), false);
        (start, towards)
    }

    /// Notes a line that is drawn.
    pub fn trace(&mut self, plan: usize, ends: [&str; 2], (start, towards): (Place, f64), is_vector: bool) {
        self.traces.push(Trace { plan, ends: ends.map(str::to_owned), start, towards, is_vector });
    }

    /// Marks an image where two rays cross.
    pub fn cross(&mut self, plan: usize, image: &str, first: (Place, f64), second: (Place, f64)) {
        let place = self.hand.placed(super::plane::crossing(first, second));
        self.mark(plan, image, place);
    }

    /// The signed size of a segment along a direction: measured, and its sense read off.
    pub fn signed(&mut self, plan: usize, [from, to]: [&str; 2], towards: f64, what: &str) -> f64 {
        let read = self.read(plan, from, to);
        let vector = self.at(plan, to) - self.at(plan, from);
        let sense = self.hand.sense(vector, towards);
        read * self.number(Act::new(Doing::Sense, plan, "", from, to).of(what), sense)
    }

    /// Finds a rate and goes on with it.
    pub fn find(&mut self, name: &str, value: f64) {
        let computed = self.hand.computed(value);
        let found = self.number(Act::new(Doing::Found, 0, "", "", "").of(name), computed);
        self.rates.insert(name.to_owned(), found);
    }

    /// The direction in which a counter-clockwise turn about p moves q.
    pub fn across(&self, p: &str, q: &str) -> f64 {
        self.scheme.along(p, q) + QUARTER
    }

    /// The value of a quantity of the form; none where nothing on the sheet shows it.
    pub fn write(&mut self, quantity: &str) -> Option<f64> {
        let value = match ends_of(quantity) {
            Some((plan, from, to)) => {
                if plan > 0 && !(self.has(plan, from) && self.has(plan, to)) {
                    return None;
                }
                if self.left_out.contains(&self.segment(plan, from, to)) {
                    return None;
                }
                self.read(plan, from, to)
            }
            None => *self.rates.get(quantity)?,
        };
        let value = self.hand.computed(value);
        Some(self.number(Act::new(Doing::Written, 0, "", "", "").of(quantity), value))
    }

    /// A value of the form as it stands, read without writing it.
    pub fn quiet(&mut self, quantity: &str) -> f64 {
        match ends_of(quantity) {
            Some((plan, from, to)) => self.read(plan, from, to),
            None => self.rates.get(quantity).copied().unwrap_or_default(),
        }
    }

    /// Notes that a vector was left out, so that nobody can measure it.
    pub fn leave_out(&mut self, plan: usize, from: &str, to: &str) {
        let segment = self.segment(plan, from, to);
        self.left_out.insert(segment);
    }

    /// The longest segment from a pole, in mm.
    pub fn extent(&self) -> f64 {
        let images = self.plans.iter().flat_map(|plan| plan.images.values());
        images.map(|image| size(*image)).fold(0.0, f64::max)
    }
}

/// The name of a point's image.
pub fn image_of(point: &str) -> String {
    point.to_lowercase()
}

/// Plan and ends of a form's segment or length.
pub fn ends_of(quantity: &str) -> Option<(usize, &str, &str)> {
    let (head, ends) = quantity.strip_suffix(')')?.split_once('(')?;
    let plan = ["L", "vplan", "aplan"].iter().position(|known| *known == head)?;
    let (from, to) = ends.split_once(',')?;
    Some((plan, from, to))
}
