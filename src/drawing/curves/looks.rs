use super::error::MOST_CURVES;
use crate::cycle::Curves;
use crate::quantity::Kind;

/// Numbers of the curves' looks: those of one link or point look the same in all panels, those in one panel differ.
pub(super) fn looks(curves: &Curves, kinds: &[(Kind, Vec<usize>)]) -> Vec<usize> {
    let subject = |index: &usize| curves.curves[*index].asked[0].subject();
    // The subjects that are in more than one panel.
    let mut shared: Vec<&str> = Vec::new();
    for (number, (_, members)) in kinds.iter().enumerate() {
        for own in members.iter().map(subject) {
            let again = kinds[number + 1..].iter().any(|(_, other)| other.iter().any(|index| subject(index) == own));
            if again && !shared.contains(&own) {
                shared.push(own);
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
            let own = shared.iter().position(|s| *s == subject(&index));
            match free.iter().position(|number| Some(*number) == own) {
                Some(place) => take(&mut free, index, place),
                None => later.push(index),
            }
        }
        // Others keep off the shared numbers while there are more.
        for index in later {
            let own = free.iter().position(|number| *number >= shared.len());
            take(&mut free, index, own.unwrap_or(0));
        }
    }
    numbers
}
