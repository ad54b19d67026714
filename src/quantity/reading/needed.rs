//! What of a construction a hand leaves out where it does not draw all sheets.

use crate::construction::{Construction, NumberId, Operation, OperationKind};
use crate::sheet::Sheet;
use std::collections::BTreeSet;

/// Leaves out what is done on sheets that a hand does not draw, but for the given numbers that others need; and on a scheme that is drawn for its
/// forces alone what only velocities need.
pub(super) fn keep_drawn(construction: &mut Construction, read: impl Iterator<Item = NumberId>) {
    let has_plans = construction.draws_plans();
    let Construction { operations, by_hand, .. } = construction;
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    for operation in operations.iter().filter(|operation| by_hand.contains(&operation.sheet)) {
        operation.kind.each_number_read(|number| needed.extend([number.0]));
    }
    operations.retain(|operation| match &operation.kind {
        OperationKind::Take { number, .. } => needed.contains(&number.0),
        _ => by_hand.contains(&operation.sheet),
    });
    if !has_plans {
        keep_needed(operations, read.map(|number| number.0).collect());
    }
}

/// Leaves out what is done on the scheme and needed by nothing on other sheets, but for the joints.
fn keep_needed(operations: &mut Vec<Operation>, mut numbers: BTreeSet<usize>) {
    let (mut places, mut lines) = (BTreeSet::new(), BTreeSet::new());
    let mut kept: Vec<bool> = Vec::new();
    for Operation { sheet, kind, .. } in operations.iter().rev() {
        let is_needed = *sheet != Sheet::Scheme
            || matches!(kind, OperationKind::Plot { .. })
            || kind.place().is_some_and(|place| places.contains(&place.0))
            || kind.line().is_some_and(|line| lines.contains(&line.0))
            || kind.numbers().iter().any(|number| numbers.contains(&number.0));
        kept.push(is_needed);
        if is_needed {
            let (read_places, read_lines) = kind.places_and_lines_read();
            places.extend(read_places.iter().map(|place| place.0));
            lines.extend(read_lines.iter().map(|line| line.0));
            kind.each_number_read(|number| numbers.extend([number.0]));
        }
    }
    let mut kept = kept.into_iter().rev();
    operations.retain(|_| kept.next().unwrap_or(true));
}
