use super::{QuantityResult, ResultFile};
use crate::construction::Solution;
use crate::quantity::{Asked, Quantity, measured_names};
use crate::scene::SceneError;

impl Solution {
    /// The result file's content with the quantities that the scene wants, or all that the construction measures if it
    /// wants none in particular.
    ///
    /// # Errors
    /// A quantity that is wanted has no value; the place is its place in the scene.
    pub fn whole_result(&self) -> Result<ResultFile, SceneError> {
        let mut result = self.result();
        let names = match &self.scene.want {
            Some(want) => want.clone(),
            None => measured_names(&self.construction),
        };
        let on_paper = names.iter().any(|name| name.ends_with("/mu"));
        let scales = on_paper.then(|| self.scales());
        for (index, name) in names.iter().enumerate() {
            let value = Asked::new(name, &self.mechanism)
                .and_then(|asked| asked.value(&self.snapshot(), Some(&self.construction), scales.as_ref()));
            let value = value.map_err(|error| {
                let path = ["want", &index.to_string()];
                self.scene.error_at(&path, error.to_string(), None)
            })?;
            let value = match value {
                Quantity::Number(x) => QuantityResult::Number(x),
                Quantity::Vector(v) => QuantityResult::Vector([v.x, v.y]),
            };
            result.quantities.insert(name.clone(), value);
        }
        Ok(result)
    }
}
