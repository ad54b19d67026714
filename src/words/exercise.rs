/// What is said on the sheet of an exercise.
#[derive(Clone, Copy, Debug)]
pub struct ExerciseWords {
    /// All that is given, parted by commas.
    pub given: fn(&str) -> String,
    /// The scales of the plans, parted by commas.
    pub draw: fn(&str) -> String,
    /// What a teacher finds below the drawn key: all rates, parted by commas.
    pub rates: fn(&str) -> String,
    /// Above the names of what is to be found.
    pub quantity: &'static str,
}

pub(super) const ENGLISH: ExerciseWords = ExerciseWords {
    given: |all| format!("Given: {all}."),
    draw: |scales| format!("Draw the plans at {scales}. Measure, on this sheet too, and fill in the boxes."),
    rates: |all| format!("Rates, ± what a careful hand may be off by: {all}."),
    quantity: "quantity",
};

pub(super) const SPANISH: ExerciseWords = ExerciseWords {
    given: |all| format!("Datos: {all}."),
    draw: |scales| format!("Dibujar los planos a {scales}. Medir, también en esta hoja, y rellenar las casillas."),
    rates: |all| format!("Velocidades y aceleraciones, ± lo que admite una mano cuidadosa: {all}."),
    quantity: "magnitud",
};
