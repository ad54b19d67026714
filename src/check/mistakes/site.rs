use super::candidate::Candidate;
use super::told::{Blank, Told};
use crate::check::answer_key::AnswerKey;
use crate::check::entry::Entry;
use crate::check::model::{Edit, Model};
use crate::construction::{Along, NumberId, NumberKind, Operation, OperationKind, PlaceId, Product, ProductKind};
use crate::geometry::{Vector, unit};
use crate::sheet::Sheet;

/// A construction in which mistakes are looked for.
pub(in crate::check) struct Site<'a> {
    pub model: &'a Model,
    pub key: &'a AnswerKey<'a>,
    pub entries: &'a [Entry],
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

    pub fn candidate(&self, told: Told, operation: usize, edit: Edit) -> Candidate {
        Candidate { edits: vec![(operation, edit)], ..Candidate::at(told, self.model.steps[operation]) }
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

    /// A place by its name.
    pub fn place(&self, place: PlaceId) -> Blank {
        self.place_name(place).into()
    }

    pub fn number_kind(&self, number: NumberId) -> &NumberKind {
        &self.model.construction.numbers[number.0]
    }

    pub fn place_name(&self, place: PlaceId) -> &str {
        self.model.place_name(place)
    }

    /// The plan points at the ends of a vector that is laid off: of one that only leads on to another, or away from
    /// one, the ends of both together, as of a part of the crank's acceleration. `None` for a vector that is laid off
    /// only to be read.
    pub fn vector_ends(&self, from: PlaceId, place: PlaceId) -> Option<[&str; 2]> {
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
    pub fn vectors(&self) -> Vec<Laid<'_>> {
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

    /// The sums from which vectors' sizes are computed: the operation, the number it makes, the sum, the names of the
    /// vector's ends.
    pub fn sums(&self) -> Vec<(usize, NumberId, &[Product], [&str; 2])> {
        let computed = self.vectors().into_iter().filter(|vector| !vector.sum.is_empty());
        computed.map(|vector| (vector.maker, vector.size, vector.sum, vector.ends)).collect()
    }

    /// Whether a rate is given by the scene, as a crank's.
    pub fn is_given(&self, number: NumberId) -> bool {
        let maker = self.model.makers[number.0];
        maker.is_some_and(|maker| matches!(self.operation(maker).kind, OperationKind::Take { .. }))
    }

    /// Numbers of the construction whose operation is done before this one, with their kinds.
    pub fn numbers_before(&self, operation: usize) -> impl Iterator<Item = (NumberId, &NumberKind)> {
        let numbers = (0..self.model.makers.len()).map(NumberId);
        let made = numbers.filter(move |n| self.model.makers[n.0].is_some_and(|maker| maker < operation));
        made.map(|number| (number, self.number_kind(number)))
    }
}

/// A vector that is laid off in a plan.
pub(in crate::check) struct Laid<'s> {
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
    pub fn turned(&self, along: Along) -> Edit {
        let &Laid { place, from, size, .. } = self;
        Edit::Instead(OperationKind::LayOff { place, from, size, along })
    }

    /// Its direction on a drawing without errors, that of a negative size reversed.
    pub fn direction(&self, site: &Site<'_>) -> Vector {
        let (place, from) = (site.model.exact.place(self.place), site.model.exact.place(self.from));
        unit(place - from).unwrap_or_default()
    }
}
