//! The names of loads to which a scene gives none.

use indexmap::{IndexMap, IndexSet};

/// Names loads one after another: forces `F1`, `F2` … in the order of the file, couples by their links, `M3` on link 3.
#[derive(Debug, Default)]
pub(crate) struct LoadNames {
    /// The names that there are: those given, then those of couples.
    taken: IndexSet<String>,
    forces: usize,
    /// By link: the number of its last couple without a name.
    couples: IndexMap<String, usize>,
}

impl LoadNames {
    /// Those of a scene that gives some loads these names.
    pub fn new(given: impl Iterator<Item = String>) -> LoadNames {
        LoadNames { taken: given.collect(), ..LoadNames::default() }
    }

    /// The name of the next force; each counts, also one with a name of its own.
    pub fn force(&mut self) -> String {
        self.forces += 1;
        format!("F{}", self.forces)
    }

    /// The name of the next couple without one on this link: the second has a prime, the third and further ones their number.
    pub fn couple(&mut self, link: &str) -> String {
        let mut number = self.couples.get(link).map_or(0, |number| *number);
        let name = loop {
            number += 1;
            let name = couple_name(number, link);
            // Links whose names differ in parentheses alone have the same names of couples.
            if !self.taken.contains(&name) {
                break name;
            }
        };
        self.taken.insert(name.clone());
        self.couples.insert(link.to_owned(), number);
        name
    }
}

/// The name of the first, second … couple without one on a link: M and the link as its index, as textbooks have it, with a prime, or with the number behind
/// it: `M3`, `M'3`, `M3-3`, `M3-4`. Names of loads have no parentheses and no commas.
pub(crate) fn couple_name(number: usize, link: &str) -> String {
    let plain: String = link.chars().filter(|c| !matches!(c, '(' | ')' | ',')).collect();
    let index = if plain.chars().all(|c| c.is_ascii_digit()) { plain } else { format!("_{plain}") };
    match number {
        1 => format!("M{index}"),
        2 => format!("M'{index}"),
        _ => format!("M{index}-{number}"),
    }
}

/// The number of the couple without a name on a link that is called so.
pub(crate) fn couple_number(name: &str, link: &str) -> Option<usize> {
    let told = name.rsplit_once('-').and_then(|(_, number)| number.parse().ok());
    [1, 2].into_iter().chain(told).find(|number| name == couple_name(*number, link))
}
