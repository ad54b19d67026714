//! What a name says by itself of what lies between two points.

use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;

/// A length of the scheme, `L(A,B)`.
pub(super) const LENGTH: Head = Head::Between(Sheet::Scheme);

/// The sheet and the ends of a length or a segment: a length up to an instant centre is measured in their figure.
pub(super) fn segment_of(name: &str) -> Option<(Sheet, [String; 2])> {
    let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
    match (name.head, name.arguments.as_slice()) {
        (Head::Between(Sheet::Scheme), [from, to]) if is_center(from) || is_center(to) => {
            Some((Sheet::Centers, [from.clone(), to.clone()]))
        }
        (Head::Between(sheet), [from, to]) => Some((sheet, [from.clone(), to.clone()])),
        _ => None,
    }
}

/// Whether a name is that of an instant centre.
pub(super) fn is_center(name: &str) -> bool {
    QuantityName::parse(name).is_some_and(|name| name.head == Head::Center && name.is_plain())
}

/// The two points of a direction's name, as `B,C` and `P(1,3),C`; `None` for any other name.
pub(super) fn two_points(name: &str) -> Option<[&str; 2]> {
    let mut depth = 0;
    let between = name.char_indices().find(|(_, letter)| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        *letter == ',' && depth == 0
    });
    between.map(|(at, _)| [name[..at].trim(), name[at + 1..].trim()])
}
