//! Which values an exercise asks for, and what each is worth.

use crate::construction::Solution;
use crate::drawing::KeyRow;
use crate::quantity::{ForceOf, QuantityKind, QuantityRequest, What};
use crate::sheet::Sheet;
use indexmap::IndexMap;
use std::collections::BTreeSet;

/// Most that a careful hand may be off by in a value that is asked for, in parts of the value: a box that accepts nearly everything shows
/// nothing.
pub const MEASURABLE: f64 = 0.25;

/// Most that a careful hand may be off by in the direction of a velocity or a force, in degrees.
const DIRECTION: f64 = 10.0;

/// Most boxes of an exercise that asks for all that a hand can measure: more are an evening's copying, and say little that the others do not.
const MANY: usize = 24;

/// What a result is worth, in marks, where what leads to it is worth one.
const RESULT: f64 = 2.0;

/// The values that an exercise asks for, of those that it could, with the marks that each is worth, as the scene's own form says or by default: none that no hand can measure. Where these are many, all rates,
/// and of each point of scheme and plans one segment to it: from the pole, else the first that is measured.
pub(super) fn to_ask(rows: &[KeyRow<'_>], solution: &Solution) -> IndexMap<String, f64> {
    let is_measurable = |row: &&KeyRow<'_>| {
        row.allowed.is_some_and(|allowed| match (&row.asked.what, row.asked.kind()) {
            // Of a coordinate the place counts, of a direction the turn, not how near zero they are.
            (What::Pole(_), _) => true,
            (What::Motion(..) | What::Force(..), QuantityKind::Angle) => allowed <= DIRECTION,
            _ => allowed <= MEASURABLE * row.value.abs(),
        })
    };
    let measurable: Vec<&QuantityRequest> = rows.iter().filter(is_measurable).map(|row| row.asked).collect();
    let steps = solution.construction.steps_by_hand().filter(|step| step.action.is_measured());
    let measured: BTreeSet<String> = steps.flat_map(|step| step.names()).collect();
    let is_main = |asked: &&QuantityRequest| {
        let Some(own) = Ends::of(asked) else { return true };
        let to_same = || measurable.iter().filter(|other| Ends::of(other).is_some_and(|ends| ends.is_to_same(&own)));
        let has_pole = to_same().any(|other| Ends::of(other).is_some_and(|ends| ends.is_from_pole));
        let first = to_same().find(|other| measured.contains(other.name()));
        own.is_from_pole || (!has_pole && first.is_some_and(|first| first.name() == asked.name()))
    };
    let own = |name: &str| solution.scene.form.as_ref()?.get(name).copied();
    let worth = |asked: &QuantityRequest| own(asked.name()).unwrap_or_else(|| usual(asked));
    let is_few = measurable.len() <= MANY;
    measurable
        .iter()
        .filter(|asked| is_few || is_main(asked))
        .map(|asked| (asked.name().to_owned(), worth(asked)))
        .collect()
}

/// Where a segment of a sheet ends.
struct Ends<'a> {
    sheet: Sheet,
    to: &'a str,
    is_from_pole: bool,
}

impl<'a> Ends<'a> {
    /// Of a segment or a length; none of other quantities.
    fn of(asked: &'a QuantityRequest) -> Option<Ends<'a>> {
        match &asked.what {
            What::Segment(order, [from, to]) => {
                Some(Ends { sheet: order.sheet(), to, is_from_pole: from == order.pole() })
            }
            What::Length(_, to) if asked.sheet() == Sheet::Scheme => {
                Some(Ends { sheet: Sheet::Scheme, to: to.name(), is_from_pole: false })
            }
            _ => None,
        }
    }

    fn is_to_same(&self, other: &Ends<'_>) -> bool {
        self.sheet == other.sheet && self.to == other.to
    }
}

/// What a value is usually worth, in marks: two where it is a result, as every rate and what a drive needs are, one where it leads to one.
fn usual(asked: &QuantityRequest) -> f64 {
    let is_effort = matches!(&asked.what, What::Force(ForceOf::Torque(_) | ForceOf::Push(_), _));
    if is_effort || asked.is_rate() { RESULT } else { 1.0 }
}
