//! The classical mistakes. Each is a row of the `catalogue` and a function that lists the places of the construction where
//! it could be made, with the edits it makes there; a replay shows what follows from them. Its sentences stand in the
//! languages' files, `words/*.ftl`, each pair under the key that the row names with `-done` and `-should` behind it.

mod beside;
mod by_centers;
mod catalogue;
mod centers;
mod contacts;
mod copying;
mod forces;
mod friction;
mod images;
mod lengths;
mod moments;
mod polygons;
mod radii;
mod rates;
mod rays;
mod routes;
mod site;
mod teeth;
mod told;
mod unknown;
mod vectors;
mod wheels;

pub(super) use beside::measured_there;
use catalogue::catalogue;
pub use site::Candidate;
pub(super) use site::{Amount, Free, Site};
pub(super) use told::symbol;
pub(crate) use told::tell;
pub use told::{Blank, Mistake, Told};

macro_rules! functions {
    ($($(#[$about:meta])+ $mistake:ident $id:literal $percent:literal $find:path { $($sentences:tt)+ })+) => {
        /// By mistake: the function that lists it at every place of a construction where it could be made.
        const FIND: &[fn(&Site<'_>) -> Vec<Candidate>] = &[$($find),+];
    };
}

catalogue!(functions);

impl Site<'_> {
    /// All candidates of the catalogue.
    pub fn candidates(&self) -> Vec<Candidate> {
        FIND.iter().flat_map(|find| find(self)).collect()
    }

    /// The candidates of one mistake.
    pub fn of(&self, mistake: Mistake) -> Vec<Candidate> {
        FIND[mistake as usize](self)
    }
}
