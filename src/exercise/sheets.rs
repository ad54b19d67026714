//! What the sheets of a student and of a teacher have beside the figure.

use super::given::sentences;
use crate::check::{BANDS, form_names};
use crate::construction::Solution;
use crate::drawing::{Drawing, KeyRow, drawing_sheets};
use crate::quantity::{Pencil, QuantityRequest};

impl Solution {
    /// The sheets on which the plans that the figure shows are drawn by hand, at the scales of the figure: first the
    /// scheme with the given numbers and a table of the form's quantities to be filled in, then sheets with the poles of
    /// the plans, last the table where it has no room beside the scheme.
    ///
    /// Those with panels have markers and a small code, [`Drawing::code`], by which a photograph of them is read, unless
    /// [`has_markers`](crate::scene::Figure::has_markers) says no; the first has none either where the scheme has no room
    /// between them. `name` stands in the codes.
    ///
    /// ```
    /// let scene = kinegon::Scene::read(include_str!("../../examples/figure-2.json"))?;
    /// let sheets = kinegon::solve(&scene)?.drawing_sheets("figure-2");
    /// let code = sheets[1].code.as_ref().expect("markers and a code");
    /// assert_eq!((code.number, code.name.as_str()), (2, "FIGURE-2"));
    /// // The pole of the first plan stands at whole millimetres.
    /// assert!(code.panels[0].origin.iter().all(|mm| mm.fract() == 0.0));
    /// # Ok::<(), kinegon::Error>(())
    /// ```
    #[must_use]
    pub fn drawing_sheets(&self, name: &str) -> Vec<Drawing> {
        let scales = self.scales();
        let mut own = self.clone();
        let figure = &mut own.scene.figure;
        figure.worksheet = false;
        // A sheet for the hand has letters for the hand, in a style for the hall too.
        figure.sizes.get_or_insert_default();
        let names = form_names(&own.construction);
        let asked: Vec<QuantityRequest> =
            names.iter().filter_map(|name| QuantityRequest::new(name, &own.mechanism).ok()).collect();
        let given = sentences(&own.scene, own.scene.text(), &scales, &own.wording());
        drawing_sheets(&own, &scales, name, &asked, &given)
    }
}

/// The rows of a key's table.
pub(super) fn key_rows<'a>(values: &'a [(QuantityRequest, f64)], pencil: &Pencil) -> Vec<KeyRow<'a>> {
    let row = |(asked, value): &'a (QuantityRequest, f64)| KeyRow {
        asked,
        value: *value,
        allowed: pencil.band(asked.name()).map(|band| BANDS * band.band),
    };
    values.iter().map(row).collect()
}

/// The sentences below the scales of a key.
pub(super) fn key_sentences(solution: &Solution) -> Vec<String> {
    let words = solution.wording();
    vec![words.language.exercise_allowed().to_owned()]
}
