//! Names and numbers as messages show them, and suggestions for misspelt names.

pub(super) use crate::text::shown as shortened;

/// A number as a person would write it, very small and large ones with a power of ten.
pub(super) fn number(value: f64) -> String {
    match value.abs() {
        0.0 | 1e-5..1e16 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// Names joined by commas; only the first twelve.
pub(crate) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let mut shown = names.by_ref().take(12).map(shortened).collect::<Vec<_>>().join(", ");
    if names.next().is_some() {
        shown.push_str(", …");
    }
    shown
}

/// The most similar name, if at most one letter in three differs or the name only goes on; else `None`.
pub(crate) fn nearest<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_within(word, names, 3)
}

/// The most similar name, if at most one letter in `letters` differs: names of points are short.
pub(crate) fn nearest_within<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str>,
    letters: usize,
) -> Option<&'a str> {
    let word = shortened(&word.to_lowercase());
    let mut best: Option<(usize, &str)> = None;
    // A scene may have a million names; comparing the first thousands is enough for a hint.
    for name in names.into_iter().take(4096) {
        let lower = name.to_lowercase();
        let begins = word.chars().count() >= 3 && lower.starts_with(&word);
        let distance = if begins { 1 } else { strsim::osa_distance(&word, &lower) };
        let slips = lower.chars().count().max(word.chars().count()) / letters;
        if (distance <= slips || begins) && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, name));
        }
    }
    best.map(|(_, name)| name)
}

/// `did you mean …?` for the nearest name.
pub(crate) fn close<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<String> {
    nearest(word, names).map(|name| format!("did you mean `{name}`?"))
}

/// `did you mean …?` for the nearest name, or else the list of all after `otherwise`.
pub(super) fn suggestion<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str> + Clone,
    otherwise: &str,
) -> Option<String> {
    close(word, names.clone()).or_else(|| {
        let all = list(names);
        (!all.is_empty()).then(|| format!("{otherwise} {all}"))
    })
}
