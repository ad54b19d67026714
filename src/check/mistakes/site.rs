//! What mistakes are made from: the construction in which they are looked for, with its vectors and the products in their
//! sizes; and what a mistake at one place of it changes.

use super::told::{Blank, Mistake, Told};
use crate::check::entry::Entry;
use crate::check::measured::AnswerKey;
use crate::check::model::Model;
use crate::construction::{
    Along, Change, Disturbance, LineId, MeasuredAs, NumberId, NumberKind, Operation, OperationKind, PlaceId, Product,
    ProductKind, Rate,
};
use crate::geometry::{Vector, unit};
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, Sheet};
use std::sync::Arc;

/// A mistake at one place of a construction.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The mistake, and what is told of it: candidates with the same sentences are one to a person.
    pub told: Told,
    /// The number of the step at which it was made.
    pub step: usize,
    /// What it changes in operations.
    pub(in crate::check) edits: Vec<Disturbance>,
    /// The written values that it makes to be read otherwise.
    pub(in crate::check) reinterpreted: Vec<Reinterpretation>,
    /// Wrong numbers that later operations use.
    pub(in crate::check) passed_on: Vec<Disturbance>,
    /// What of it is not known beforehand but fitted to the values; the edits at these places have the fitted amounts.
    pub(in crate::check) free: Vec<Free>,
    /// The assembly mode that is replayed: 0 for the right one, then the others.
    pub(in crate::check) mode: usize,
}

impl Candidate {
    /// A mistake at a step, without anything that it changes.
    pub(in crate::check) fn at(told: Told, step: usize) -> Candidate {
        Candidate {
            told,
            step,
            edits: Vec::new(),
            reinterpreted: Vec::new(),
            passed_on: Vec::new(),
            free: Vec::new(),
            mode: 0,
        }
    }

    /// Which mistake.
    #[must_use]
    pub fn mistake(&self) -> Mistake {
        self.told.mistake
    }

    /// All that it changes in a replay.
    pub(in crate::check) fn changes(&self) -> impl Iterator<Item = &Disturbance> {
        self.edits.iter().chain(&self.passed_on)
    }

    /// The operations that it changes.
    pub(in crate::check) fn operations(&self) -> impl Iterator<Item = usize> {
        self.edits.iter().map(|edit| edit.operation).chain(self.free.iter().map(|free| free.operation))
    }

    /// What it does in place of an operation.
    pub(in crate::check) fn instead_of(&self, operation: usize) -> Option<&OperationKind> {
        self.edits.iter().find_map(|edit| match &edit.change {
            Change::Instead(kind) if edit.operation == operation => Some(&**kind),
            _ => None,
        })
    }
}

/// An operation replaced by another one.
pub(super) fn instead(operation: usize, kind: OperationKind) -> Disturbance {
    Disturbance { operation, change: Change::Instead(Arc::new(kind)) }
}

/// A number of an operation multiplied by a factor.
pub(super) fn times(operation: usize, number: NumberId, factor: f64) -> Disturbance {
    Disturbance { operation, change: Change::Times(number, factor) }
}

/// An amount by which an operation is wrong and which is not known beforehand.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Free {
    /// The operation.
    pub operation: usize,
    /// What of it is wrong.
    pub what: Amount,
    /// Whether it is an angle in degrees.
    pub is_angle: bool,
    /// Standard deviation of the amounts that occur: mm, degrees, or the unit of the number.
    pub range: f64,
    /// Whether the amount has the sign of the right one: a distance from which a rate is found is never negative.
    pub keeps_sign: bool,
}

/// What is wrong by a free amount.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) enum Amount {
    /// An elementary error of the operation, by its index.
    Error(usize),
    /// A number that the operation makes.
    Number(NumberId),
}

impl Free {
    /// The change of a replay in which the amount is this one.
    pub fn change(&self, amount: f64) -> Change {
        match self.what {
            Amount::Error(which) => Change::Error(which, amount),
            Amount::Number(number) => Change::Written(number, amount),
        }
    }
}

/// The value that is meant by a written one, if a mistake was made.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Reinterpretation {
    pub entry: usize,
    /// The value meant.
    pub value: f64,
    /// Half a unit of its last digit.
    pub rounding: f64,
}

/// A construction in which mistakes are looked for.
pub(in crate::check) struct Site<'a> {
    pub model: &'a Model,
    pub key: &'a AnswerKey<'a>,
    pub entries: &'a [Entry],
    /// By entry: how far a value may be off to pass; empty where nothing is judged.
    pub tolerances: &'a [f64],
    /// Number of other assembly modes.
    pub other_modes: usize,
}

impl Site<'_> {
    pub fn operations(&self) -> impl Iterator<Item = (usize, &Operation)> {
        self.model.construction.operations.iter().enumerate()
    }

    pub fn operation(&self, index: usize) -> &Operation {
        &self.model.construction.operations[index]
    }

    /// A mistake that changes one operation, at the step of that operation.
    pub fn candidate(&self, told: Told, edit: Disturbance) -> Candidate {
        let step = self.model.steps[edit.operation];
        Candidate { edits: vec![edit], ..Candidate::at(told, step) }
    }

    /// A number in a drawing without errors.
    pub fn exact(&self, number: NumberId) -> f64 {
        self.model.exact.number(number)
    }

    pub fn number_name(&self, number: NumberId) -> &str {
        &self.model.number_names[number.0]
    }

    /// A number as it stands in formulas.
    pub fn symbol(&self, number: NumberId) -> Blank {
        Blank::Symbol(self.number_name(number).to_owned())
    }

    /// A number as it stands in formulas; nothing where there is none.
    pub fn symbol_or_none(&self, number: Option<&NumberId>) -> Blank {
        number.map_or_else(|| "".into(), |&number| self.symbol(number))
    }

    /// A number by the name of its quantity.
    pub fn quantity(&self, number: NumberId) -> Blank {
        Blank::Quantity(self.number_name(number).to_owned())
    }

    /// A place by its name; an instant centre by its symbol.
    pub fn place(&self, place: PlaceId) -> Blank {
        let name = self.place_name(place);
        let is_center = QuantityName::parse(name).is_some_and(|name| name.head == Head::Center);
        if is_center { Blank::Quantity(name.to_owned()) } else { name.into() }
    }

    pub fn number_kind(&self, number: NumberId) -> &NumberKind {
        &self.model.construction.numbers[number.0]
    }

    pub fn place_name(&self, place: PlaceId) -> &str {
        self.model.place_name(place)
    }

    /// The operation that draws a line.
    pub fn drawing_of(&self, line: LineId) -> Option<(usize, &Operation)> {
        self.operations().find(|(_, operation)| operation.kind.line() == Some(line))
    }

    /// The operation that measures a segment along a line, with the number it makes and the end of the segment.
    pub fn measuring_along(&self, line: LineId) -> Option<(usize, NumberId, PlaceId)> {
        self.operations().find_map(|(index, operation)| match operation.kind {
            OperationKind::Measure { number, to, how: MeasuredAs::Along(along), .. } if along == line => {
                Some((index, number, to))
            }
            _ => None,
        })
    }

    /// The plan points at the ends of a vector that is laid off: of one that only leads on to another, or away from
    /// one, the ends of both together, as of a part of the crank's acceleration. `None` for a vector that is laid off
    /// only to be read.
    fn vector_ends(&self, from: PlaceId, place: PlaceId) -> Option<[&str; 2]> {
        let laid = || {
            self.operations().filter_map(|(_, operation)| match operation.kind {
                OperationKind::LayOff { place, from, .. } => Some((from, place)),
                _ => None,
            })
        };
        let (mut start, mut end) = (from, place);
        while self.place_name(end).is_empty() {
            end = laid().find(|(from, _)| *from == end)?.1;
        }
        while self.place_name(start).is_empty() {
            start = laid().find(|(_, place)| *place == start)?.0;
        }
        Some([self.place_name(start), self.place_name(end)])
    }

    /// The vectors that are laid off in the plans.
    pub(super) fn vectors(&self) -> Vec<Laid<'_>> {
        let laid = self.operations().filter_map(|(index, operation)| match operation.kind {
            OperationKind::LayOff { place, from, size, along } => {
                let ends = self.vector_ends(from, place)?;
                let maker = self.model.makers[size.0]?;
                let sum = match &self.operation(maker).kind {
                    OperationKind::Compute { sum, .. } => sum.as_slice(),
                    _ => &[],
                };
                Some(Laid { operation: index, sheet: operation.sheet, place, from, size, along, maker, sum, ends })
            }
            _ => None,
        });
        laid.collect()
    }

    /// The products in the sizes of vectors.
    pub(super) fn all_terms(&self) -> impl Iterator<Item = Term<'_>> {
        let vectors = self.vectors().into_iter();
        vectors.flat_map(|vector| (0..vector.sum.len()).map(move |at| Term { vector, at }))
    }

    /// The products of a kind in the sizes of vectors.
    pub(super) fn terms(&self, kind: ProductKind) -> Vec<Term<'_>> {
        self.all_terms().filter(|term| term.product().kind == kind).collect()
    }

    /// Whether a rate is given by the scene, as a crank's.
    pub fn is_given(&self, number: NumberId) -> bool {
        let maker = self.model.makers[number.0];
        maker.is_some_and(|maker| matches!(self.operation(maker).kind, OperationKind::Take { .. }))
    }

    /// Whether the first factor of a product is a given rate.
    pub fn is_of_crank(&self, product: &Product) -> bool {
        product.of.first().is_some_and(|&rate| self.is_given(rate))
    }

    /// Numbers of the construction whose operation is done before this one, with their kinds.
    pub fn numbers_before(&self, operation: usize) -> impl Iterator<Item = (NumberId, &NumberKind)> {
        let numbers = (0..self.model.makers.len()).map(NumberId);
        let made = numbers.filter(move |n| self.model.makers[n.0].is_some_and(|maker| maker < operation));
        made.map(|number| (number, self.number_kind(number)))
    }

    /// The angular velocities among these numbers.
    pub fn omegas_before(&self, operation: usize) -> impl Iterator<Item = NumberId> {
        let omegas = self
            .numbers_before(operation)
            .filter(|(_, kind)| matches!(kind, NumberKind::Rate(Rate::Angular(Order::Velocity, _))));
        omegas.map(|(number, _)| number)
    }
}

/// A vector that is laid off in a plan.
#[derive(Clone, Copy)]
pub(super) struct Laid<'s> {
    /// The operation that lays it off.
    pub operation: usize,
    pub sheet: Sheet,
    /// Its end.
    pub place: PlaceId,
    /// Its start.
    pub from: PlaceId,
    pub size: NumberId,
    pub along: Along,
    /// The operation that gives its size.
    pub maker: usize,
    /// The sum that gives its size; empty for a given one.
    pub sum: &'s [Product],
    /// The names of its ends.
    pub ends: [&'s str; 2],
}

impl Laid<'_> {
    /// The names of its ends for sentences.
    pub fn blanks(&self) -> [Blank; 2] {
        self.ends.map(Blank::from)
    }

    /// Whether its size is one product of this kind.
    pub fn is_only(&self, kind: ProductKind) -> bool {
        matches!(self.sum, [product] if product.kind == kind)
    }

    /// The vector laid off in another direction.
    pub fn turned(&self, along: Along) -> Disturbance {
        let &Laid { place, from, size, .. } = self;
        instead(self.operation, OperationKind::LayOff { place, from, size, along })
    }

    /// Its direction on a drawing without errors, that of a negative size reversed.
    pub fn direction(&self, site: &Site<'_>) -> Vector {
        let (place, from) = (site.model.exact.place(self.place), site.model.exact.place(self.from));
        unit(place - from).unwrap_or_default()
    }
}

/// A product in the sum that gives a vector's size.
#[derive(Clone, Copy)]
pub(super) struct Term<'s> {
    pub vector: Laid<'s>,
    /// Its place in the sum.
    pub at: usize,
}

impl<'s> Term<'s> {
    pub fn product(&self) -> &'s Product {
        &self.vector.sum[self.at]
    }

    /// The sum with this product in place of the term, or without it.
    pub fn instead(&self, product: Option<Product>) -> Disturbance {
        let mut sum = self.vector.sum.to_vec();
        match product {
            Some(changed) => sum[self.at] = changed,
            None => drop(sum.remove(self.at)),
        }
        instead(self.vector.maker, OperationKind::Compute { number: self.vector.size, sum })
    }

    /// The names of the vector's ends and of the first and the last factor.
    pub fn blanks(&self, site: &Site<'_>) -> [Blank; 4] {
        let [from, to] = self.vector.blanks();
        let [first, last] = [self.product().of.first(), self.product().of.last()];
        [from, to, site.symbol_or_none(first), site.symbol_or_none(last)]
    }

    /// A candidate that takes this product in place of the term.
    pub fn candidate(&self, site: &Site<'_>, told: Told, product: Option<Product>) -> Candidate {
        site.candidate(told, self.instead(product))
    }
}
