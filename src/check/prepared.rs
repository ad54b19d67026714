//! What the forms of a class have in common, worked out once: the names of the scene's quantities, and for each set of
//! quantities that forms have the constructions and the bands with which their values are compared.

use super::answer_key::AnswerKey;
use super::covariance::Groups;
use super::entry::Entry;
use super::error::CheckError;
use super::model::Model;
use super::names::Names;
use super::search::other_modes;
use crate::quantity::Band;
use crate::sheet::{PerSheet, Scales};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// An answer key for many forms, which may be checked on many cores at once: the first form takes longest.
#[derive(Debug)]
pub struct Prepared<'a> {
    pub(super) key: AnswerKey<'a>,
    pub(super) names: Names<'a>,
    ready: Mutex<BTreeMap<Asking, Arc<Ready>>>,
}

/// The quantities of a form in their order, and the bits of its scales.
type Asking = (Vec<String>, PerSheet<Option<u64>>);

/// Most sets of quantities that are kept: forms are alike, or blanks are left in each at other places.
const KEPT: usize = 50;

/// What forms with the same quantities at the same scales are compared with.
#[derive(Debug)]
pub(super) struct Ready {
    /// The right construction, followed by the readings of the quantities.
    pub right: Model,
    /// By quantity: the band of honest drawings, where there is one.
    pub bands: Vec<Option<Band>>,
    mu: Scales,
    /// The right construction, and those of the other assembly modes.
    models: OnceLock<Vec<Model>>,
    /// The covariances of a right drawing that the errors of hands cause.
    pub groups: OnceLock<Groups>,
}

impl<'a> Prepared<'a> {
    /// Makes an answer key ready for many forms.
    #[must_use]
    pub fn new(key: &AnswerKey<'a>) -> Prepared<'a> {
        Prepared { key: *key, names: Names::new(key.solution), ready: Mutex::default() }
    }

    /// The answer key.
    #[must_use]
    pub fn key(&self) -> &AnswerKey<'a> {
        &self.key
    }

    /// What a form's values are compared with.
    pub(super) fn ready(&self, mu: Scales, entries: &[Entry]) -> Result<Arc<Ready>, CheckError> {
        let names = entries.iter().map(|entry| entry.asked.name().to_owned());
        let asking = (names.collect(), mu.map(|mu| mu.map(f64::to_bits)));
        // A check that has panicked leaves the map as it was before or after.
        let kept = || self.ready.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(ready) = kept().get(&asking) {
            return Ok(Arc::clone(ready));
        }
        let right = Model::new(&self.key, self.key.solution, mu, entries)?;
        let bands = right.bands(&self.key.tolerance);
        let ready = Arc::new(Ready { right, bands, mu, models: OnceLock::new(), groups: OnceLock::new() });
        let mut kept = kept();
        if kept.len() < KEPT {
            kept.insert(asking, Arc::clone(&ready));
        }
        Ok(ready)
    }
}

impl Ready {
    /// The right construction, and those of the other assembly modes; `entries` are of a form with these quantities.
    pub fn models(&self, key: &AnswerKey<'_>, entries: &[Entry]) -> &[Model] {
        self.models.get_or_init(|| {
            let mut models = vec![self.right.clone()];
            models.extend(other_modes(key, self.mu, entries));
            models
        })
    }
}
