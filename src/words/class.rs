/// What is said of marks and of a whole class.
#[derive(Clone, Copy, Debug)]
pub struct ClassWords {
    /// Marks earned, of how many, those among them for values that follow from a mistake; the last may be empty.
    pub marks: fn(&str, &str, &str) -> String,
    /// Files in all, passed, off, not understood.
    pub counts: fn(usize, usize, usize, usize) -> String,
    /// How many of how many files that were understood begin with a mistake, its step (0 for the whole drawing), what was done.
    pub common: fn(usize, usize, usize, &str) -> String,
}

pub(super) const ENGLISH: ClassWords = ClassWords {
    marks: |earned, of, follow| {
        let among = if follow.is_empty() {
            String::new()
        } else {
            format!(", {follow} of them for values that follow from a mistake")
        };
        format!("Marks: {earned} of {of}{among}")
    },
    counts: |files, passed, off, broken| {
        let all = if files == 1 { "file" } else { "files" };
        format!("{files} {all}: {passed} passed, {off} off, {broken} not understood")
    },
    common: |count, of, step, done| {
        let place = match step {
            0 => "whole drawing".to_owned(),
            step => format!("step {step}"),
        };
        format!("{count} of {of}: {place}, {done}")
    },
};

pub(super) const SPANISH: ClassWords = ClassWords {
    marks: |earned, of, follow| {
        let among = if follow.is_empty() {
            String::new()
        } else {
            format!(", {follow} de ellos por valores que se siguen de un error")
        };
        format!("Puntos: {earned} de {of}{among}")
    },
    counts: |files, passed, off, broken| {
        let all = if files == 1 { "archivo" } else { "archivos" };
        format!("{files} {all}: {passed} aprobados, {off} con errores, {broken} no entendidos")
    },
    common: |count, of, step, done| {
        let place = match step {
            0 => "todo el dibujo".to_owned(),
            step => format!("paso {step}"),
        };
        format!("{count} de {of}: {place}, {done}")
    },
};
