//! The construction as a student carries it out: replayed exactly, with mistakes, or with errors of the hand.

use super::entry::Entry;
use super::measured::{AnswerKey, CheckError};
use super::says;
use crate::construction::{
    Along, Change, Construction, Disturbance, LineId, NumberId, Operation, OperationKind, OperationRole, PlaceId,
    Reference, Solution, Tolerance, Values,
};
use crate::geometry::{Vector, unit};
use crate::mechanism::{GROUND, Joint, Mechanism, PointId};
use crate::quantity::{Band, QuantityRequest, Reading, Unread, read_by_hand};
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::words::sheet_told;
use nalgebra::DMatrix;
use smallvec::SmallVec;

/// The kind of errors of joints plotted, each by itself.
pub(super) const PLOTTED: usize = 0;

/// The kind of errors of what else is drawn on a sheet.
pub(super) const fn drawn_on(sheet: Sheet) -> usize {
    1 + sheet as usize
}

/// The kind of errors of joints displaced together so that every link keeps its shape, as with a drawing program.
pub(super) const TOGETHER: usize = 1 + Sheet::ALL.len();

/// The kind of errors of angles of friction and of lines that touch circles of friction; whoever computes friction has none.
pub(super) const LEANING: usize = TOGETHER + 1;

/// The kind of slips in computed numbers.
pub(super) const COMPUTING: usize = LEANING + 1;

/// Number of kinds of errors; a hand has a size for each.
pub(super) const GROUPS: usize = COMPUTING + 1;

/// The construction as a student carries it out, with the facts that mistakes are made from.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub construction: Construction,
    /// By entry: how it is read.
    pub readings: Vec<Result<Reading, Unread>>,
    pub scales: PerSheet<f64>,
    /// The values of a drawing without errors.
    pub exact: Values,
    /// By operation: the number of its step.
    pub steps: Vec<usize>,
    /// By number: the operation that makes it.
    pub makers: Vec<Option<usize>>,
    /// By number: whether a later operation reads it.
    pub used: Vec<bool>,
    /// By number: its name.
    pub number_names: Vec<String>,
    /// By place: its sheet and its first name.
    pub place_names: Vec<Option<(Sheet, String)>>,
    /// By place: the operation that makes it; `None` where a hand makes none.
    pub place_makers: Vec<Option<usize>>,
    /// Numbers that are computed as sizes of vectors, with their sheets.
    pub sizes: Vec<(NumberId, Sheet)>,
    /// Displacements of all joints that keep the links' shapes: along x and y of each plotted place, in the order of
    /// the operations.
    pub together: Vec<Vec<f64>>,
}

/// Changes of a replay, in the order of the operations.
pub(super) type Changes = SmallVec<[Disturbance; 4]>;

/// Changes put in the order of the operations.
pub(super) fn in_order<'c>(changes: impl Iterator<Item = &'c Disturbance>) -> Changes {
    let mut changes: Changes = changes.cloned().collect();
    changes.sort_by_key(|change| change.operation);
    changes
}

impl Model {
    /// The construction of a position at the student's scales.
    pub fn new(key: &AnswerKey<'_>, solution: &Solution, mu: Scales, entries: &[Entry]) -> Result<Model, CheckError> {
        let asked: Vec<QuantityRequest> = entries.iter().map(|e| e.asked.clone()).collect();
        let (mut construction, readings) = read_by_hand(solution, &asked);
        given_first(&mut construction.operations);
        if key.solution.mechanism.joints.iter().any(is_on_an_arm) {
            velocities_first(&mut construction.operations);
        }
        let given = mu.or(key.scales);
        let mut scales = PerSheet::from_fn(|_| 1.0);
        // On a sheet that nobody asks for nothing is drawn.
        let is_drawn = |sheet: Sheet| construction.by_hand.contains(&sheet);
        for (sheet, scale) in scales.iter_mut().filter(|(sheet, _)| is_drawn(*sheet)) {
            *scale = given[sheet].ok_or_else(|| {
                let hint = says::add_scale_or_panel(sheet.facts().scale_key);
                CheckError::new(says::no_sheet(sheet_told(sheet)), hint)
            })?;
        }
        let exact = construction.run(scales, &[]);
        let mechanism = &solution.mechanism;
        let [places, _, numbers] = construction.counts();
        let mut model = Model {
            steps: Vec::new(),
            makers: vec![None; numbers],
            used: vec![false; numbers],
            number_names: (0..numbers).map(|n| construction.number_name(mechanism, NumberId(n))).collect(),
            place_names: vec![None; places],
            place_makers: vec![None; places],
            sizes: Vec::new(),
            together: ways_together(&construction, &exact, mechanism),
            readings,
            scales,
            exact,
            construction,
        };
        model.index();
        Ok(model)
    }

    /// The construction as far as the first entries need it, which alone are read.
    pub fn first(&self, entries: usize) -> Model {
        let mut model = self.clone();
        model.readings.truncate(entries);
        let read = model.readings.iter().flatten().filter_map(|reading| model.makers[reading.number.0]);
        let last = read.max().map_or(0, |last| last + 1);
        model.construction.operations.truncate(last);
        model.steps.truncate(last);
        for maker in model.makers.iter_mut().chain(&mut model.place_makers) {
            *maker = maker.filter(|maker| *maker < last);
        }
        model.sizes.retain(|(size, _)| model.makers[size.0].is_some());
        model
    }

    /// The bands of the entries that are read.
    pub fn bands(&self, tolerance: &Tolerance) -> Vec<Option<Band>> {
        let there: Vec<Reading> = self.readings.iter().flatten().copied().collect();
        let mut bands = self.construction.bands(self.scales, tolerance, &there).into_iter();
        let band = |reading: &Result<Reading, Unread>| {
            let band = reading.ok().and_then(|_| bands.next())?;
            (band.value.is_finite() && band.band.is_finite()).then_some(band)
        };
        self.readings.iter().map(band).collect()
    }

    /// Fills the tables of what operations make and read, and of places' names.
    fn index(&mut self) {
        let construction = &self.construction;
        let mut before = 0;
        for (index, operation) in construction.operations.iter().enumerate() {
            for number in operation.kind.numbers() {
                self.makers[number.0] = Some(index);
            }
            operation.kind.each_number_read(|number| self.used[number.0] = true);
            if let Some(PlaceId(place)) = operation.kind.place() {
                self.place_makers[place] = Some(index);
            }
            // An operation without a step counts to the step before it.
            before = operation.step.map_or(before, |step| construction.step_number(step));
            self.steps.push(before);
        }
        for (sheet, name, PlaceId(place)) in construction.named_places() {
            if self.place_makers[place].is_some() {
                self.place_names[place].get_or_insert((sheet, name.to_owned()));
            }
        }
        // The computation of a vector's size counts to the step that lays the vector off.
        for (index, operation) in construction.operations.iter().enumerate().rev() {
            if let OperationKind::LayOff { size, .. } = operation.kind
                && let Some(maker) = self.makers[size.0]
                && matches!(construction.operations[maker].kind, OperationKind::Compute { .. })
            {
                self.steps[maker] = self.steps[index];
                self.sizes.push((size, construction.operations[maker].sheet));
            }
        }
    }

    /// By entry: the number that it reads from the values of a replay; NaN where it reads none.
    pub fn read(&self, values: &Values) -> Vec<f64> {
        self.readings.iter().map(|r| r.as_ref().map_or(f64::NAN, |r| values.number(r.number))).collect()
    }

    /// The values of a replay with changes.
    pub fn replay(&self, changes: &[Disturbance]) -> Values {
        let mut values = self.exact.clone();
        let operations = &self.construction.operations;
        let first = changes.first().map_or(operations.len(), |c| c.operation);
        values.carry_out(operations, first, self.scales, changes);
        values
    }

    /// Sets `values` to a replay with `changes` and the further change `own` of an operation. `before` is the replay
    /// without `own`: only that operation and the later ones are carried out again.
    pub fn replay_after(
        &self,
        values: &mut Values,
        before: &Values,
        operation: usize,
        own: Change,
        changes: &[Disturbance],
    ) {
        values.clone_from(before);
        let start = changes.partition_point(|c| c.operation < operation);
        let end = changes.partition_point(|c| c.operation <= operation);
        let mut all = Changes::new();
        all.extend(changes[start..end].iter().cloned());
        all.push(Disturbance { operation, change: own });
        all.extend(changes[end..].iter().cloned());
        values.carry_out(&self.construction.operations, operation, self.scales, &all);
    }

    /// All elementary errors: operation, which of its errors, limit in mm or degrees, group.
    pub fn errors(&self, tolerance: &Tolerance) -> Vec<(usize, usize, f64, usize)> {
        let all = self.construction.operations.iter().enumerate().flat_map(|(index, operation)| {
            let group = match (operation.sheet, &operation.kind) {
                (_, OperationKind::Plot { .. }) => PLOTTED,
                (sheet, _) => drawn_on(sheet),
            };
            let errors = operation.kind.errors().iter().enumerate();
            errors.map(move |(which, e)| (index, which, e.limit(tolerance), group))
        });
        all.collect()
    }

    /// Whether an entry is measured, and not computed or given.
    pub fn is_measured(&self, entry: usize) -> bool {
        self.readings[entry].is_ok_and(|reading| {
            let maker = self.makers[reading.number.0];
            maker.is_some_and(|maker| matches!(self.construction.operations[maker].kind, OperationKind::Measure { .. }))
        })
    }

    /// Numbers that are computed and used later, each with its operation: sizes of vectors, rates.
    pub fn computed(&self) -> impl Iterator<Item = (usize, NumberId)> {
        self.construction.operations.iter().enumerate().flat_map(move |(index, operation)| {
            let is_computed = matches!(operation.kind, OperationKind::Compute { .. } | OperationKind::Solve { .. });
            let numbers = operation.kind.numbers().iter().copied();
            numbers.filter(move |n| is_computed && self.used[n.0]).map(move |n| (index, n))
        })
    }

    /// The name of a place; empty if it has none.
    pub fn place_name(&self, place: PlaceId) -> &str {
        self.place_names[place.0].as_ref().map_or("", |(_, name)| name.as_str())
    }

    /// The named places of a sheet that earlier operations have made, in the order of their ids.
    pub fn places_before(&self, sheet: Sheet, operation: usize) -> Vec<PlaceId> {
        let is_named = |id: usize| self.place_names[id].as_ref().is_some_and(|n| n.0 == sheet && !n.1.is_empty());
        let is_made = |id: usize| self.place_makers[id].is_some_and(|maker| maker < operation);
        (0..self.place_names.len()).filter(|&id| is_named(id) && is_made(id)).map(PlaceId).collect()
    }
}

/// Moves operations that need no others to the front, and lines through joints next, so that mistakes may use them
/// anywhere.
fn given_first(operations: &mut [Operation]) {
    let plotted: Vec<PlaceId> = operations
        .iter()
        .filter_map(|operation| match operation.kind {
            OperationKind::Plot { place, .. } => Some(place),
            _ => None,
        })
        .collect();
    let normal: Vec<LineId> = operations
        .iter()
        .filter_map(|operation| match operation.kind {
            OperationKind::Draw { line, through, along: Along { reference: Reference::Given(_), .. } }
                if plotted.contains(&through) =>
            {
                Some(line)
            }
            OperationKind::Join { line, from, towards } if plotted.contains(&from) && plotted.contains(&towards) => {
                Some(line)
            }
            _ => None,
        })
        .collect();
    operations.sort_by_key(|operation| match &operation.kind {
        OperationKind::Pole { .. } | OperationKind::Plot { .. } | OperationKind::Take { .. } => 0,
        OperationKind::Join { from, towards, .. } if plotted.contains(from) && plotted.contains(towards) => 1,
        OperationKind::Draw { through, along: Along { reference: Reference::Given(_), .. }, .. }
            if plotted.contains(through) =>
        {
            1
        }
        // Lines towards the centres of guides.
        OperationKind::Draw { through, along: Along { reference: Reference::Line(line), .. }, .. }
            if operation.sheet == Sheet::Centers && plotted.contains(through) && normal.contains(line) =>
        {
            2
        }
        _ => 3,
    });
}

/// Whether a joint is a mesh whose wheels hang on an arm that moves.
fn is_on_an_arm(joint: &Joint) -> bool {
    joint.pitch.is_some() && joint.related_bodies().nth(2).is_some_and(|carrier| carrier != GROUND)
}

/// Moves what the acceleration plan has before the last ray of the velocity plan behind that, in its order: a mistake there may take angular velocities that are found.
fn velocities_first(operations: &mut [Operation]) {
    let last = operations.iter().rposition(|operation| operation.sheet == Sheet::Velocity);
    let before = &mut operations[..last.map_or(0, |last| last + 1)];
    before.sort_by_key(|operation| operation.sheet == Sheet::Acceleration);
}

/// Most joints of which the displacements that keep shapes are found: the work grows with the third power of their number, and nobody
/// draws more.
const MOST_TOGETHER: usize = 100;

/// A basis of the joint displacements that keep the links' shapes: the null space of the constraints, which are the
/// distances between points of one link and the places of the ground's points. Empty for more than 100 joints.
pub fn ways_together(construction: &Construction, exact: &Values, mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let operations = construction.operations.iter();
    let plots: Vec<(PointId, Vector)> = operations
        .filter_map(|operation| match (operation.role, &operation.kind) {
            (OperationRole::Joint(point), OperationKind::Plot { place, .. }) => Some((point, exact.place(*place))),
            _ => None,
        })
        .collect();
    if plots.is_empty() || plots.len() > MOST_TOGETHER {
        return Vec::new();
    }
    let count = 2 * plots.len();
    // AᵀA of the constraint matrix A: both have the same null space.
    let mut squares = DMatrix::<f64>::zeros(count, count);
    let mut constrain = |row: &[(usize, f64)]| {
        for &(i, a) in row {
            for &(j, b) in row {
                squares[(i, j)] += a * b;
            }
        }
    };
    for (i, (point, at)) in plots.iter().enumerate() {
        if mechanism.body(GROUND).points.contains(point) {
            constrain(&[(2 * i, 1.0)]);
            constrain(&[(2 * i + 1, 1.0)]);
        }
        for (j, (other, there)) in plots.iter().enumerate().take(i) {
            let is_rigid = mechanism.bodies.iter().any(|b| b.points.contains(point) && b.points.contains(other));
            if is_rigid && let Some(u) = unit(at - there) {
                constrain(&[(2 * i, u.x), (2 * i + 1, u.y), (2 * j, -u.x), (2 * j + 1, -u.y)]);
            }
        }
    }
    let eigen = squares.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    let null_space = eigen.eigenvalues.iter().enumerate().filter(|(_, value)| value.abs() <= 1e-10 * largest);
    null_space.map(|(k, _)| eigen.eigenvectors.column(k).iter().copied().collect()).collect()
}
