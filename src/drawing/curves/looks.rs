use super::error::MOST_CURVES;
use crate::cycle::Curves;
use crate::quantity::Kind;

/// By curve: the number of its colour and dash. Curves of one link or point have the same number in all panels, curves
/// of one panel different ones.
pub(super) fn looks(curves: &Curves, kinds: &[(Kind, Vec<usize>)]) -> Vec<usize> {
    let subject = |index: &usize| curves.curves[*index].asked[0].subject();
    // The links and points with curves in more than one panel.
    let mut shared: Vec<&str> = Vec::new();
    for (number, (_, members)) in kinds.iter().enumerate() {
        for named in members.iter().map(subject) {
            let again = kinds[number + 1..].iter().any(|(_, other)| other.iter().any(|index| subject(index) == named));
            if again && !shared.contains(&named) {
                shared.push(named);
            }
        }
    }
    let mut numbers = vec![0; curves.curves.len()];
    for (_, members) in kinds {
        let mut free: Vec<usize> = (0..MOST_CURVES).collect();
        let mut later = Vec::new();
        let mut take = |free: &mut Vec<usize>, index: usize, place: usize| {
            numbers[index] = free.remove(place);
        };
        for &index in members {
            let wanted = shared.iter().position(|s| *s == subject(&index));
            match free.iter().position(|number| Some(*number) == wanted) {
                Some(place) => take(&mut free, index, place),
                None => later.push(index),
            }
        }
        // Other curves take numbers that are not shared, while there are any.
        for index in later {
            let unshared = free.iter().position(|number| *number >= shared.len());
            take(&mut free, index, unshared.unwrap_or(0));
        }
    }
    numbers
}
