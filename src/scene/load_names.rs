//! The names of loads to which a scene gives none.

use indexmap::IndexSet;

/// Names loads one after another: forces `F1`, `F2` … in the order of the file, couples by their links, `M3` on link 3.
#[derive(Debug, Default)]
pub(crate) struct LoadNames {
    given: IndexSet<String>,
    forces: usize,
    couples: IndexSet<String>,
}

impl LoadNames {
    /// Those of a scene that gives some loads these names.
    pub fn new(given: impl Iterator<Item = String>) -> LoadNames {
        LoadNames { given: given.collect(), ..LoadNames::default() }
    }

    /// The name of the next force; each counts, also one with a name of its own.
    pub fn force(&mut self) -> String {
        self.forces += 1;
        format!("F{}", self.forces)
    }

    /// The name of the next couple without one on this link, with a prime for each that has it already.
    pub fn couple(&mut self, link: &str) -> String {
        let mut primes = String::new();
        loop {
            let name = couple_name(&primes, link);
            if !self.given.contains(&name) && self.couples.insert(name.clone()) {
                return name;
            }
            primes.push('\'');
        }
    }
}

/// The name of a couple without one on a link: M, perhaps with primes, and the link as its index, as textbooks have it. Names of loads have no
/// parentheses and no commas.
pub(crate) fn couple_name(primes: &str, link: &str) -> String {
    let plain: String = link.chars().filter(|c| !matches!(c, '(' | ')' | ',')).collect();
    let is_number = plain.chars().all(|c| c.is_ascii_digit());
    format!("M{primes}{}{plain}", if is_number { "" } else { "_" })
}
