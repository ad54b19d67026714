/// What is said on the sheet of an exercise.
#[derive(Clone, Copy, Debug)]
pub struct ExerciseWords {
    /// All that is given, parted by commas.
    pub given: fn(&str) -> String,
    /// The scales of the plans, parted by commas.
    pub draw: fn(&str) -> String,
    /// Above the names of what is to be found.
    pub quantity: &'static str,
}

pub(super) const ENGLISH: ExerciseWords = ExerciseWords {
    given: |all| format!("Given: {all}."),
    draw: |scales| {
        format!(
            "Draw the plans at {scales}; measure on this sheet, which is true to scale, and on your plans, and fill in the boxes."
        )
    },
    quantity: "Quantity",
};

pub(super) const SPANISH: ExerciseWords = ExerciseWords {
    given: |all| format!("Datos: {all}."),
    draw: |scales| {
        format!(
            "Dibujar los planos a {scales}; medir en esta hoja, que está a escala, y en los planos, y rellenar las casillas."
        )
    },
    quantity: "Magnitud",
};
