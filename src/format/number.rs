/// A length in mm, rounded to a micrometre, as the shortest text. NaN gives 0.
pub fn number(value: f64) -> String {
    let mut text = String::with_capacity(8);
    push_number(&mut text, value);
    text
}

/// Appends the text of [`number`].
pub(super) fn push_number(text: &mut String, value: f64) {
    // The cast maps values out of range to the ends of the range, and NaN to 0.
    let thousandths = (value * 1000.0).round() as i64;
    if thousandths < 0 {
        text.push('-');
    }
    let (whole, mut rest) = (thousandths.unsigned_abs() / 1000, thousandths.unsigned_abs() % 1000);
    push_digits(text, whole);
    if rest == 0 {
        return;
    }
    text.push('.');
    let mut place = 100;
    while rest > 0 {
        push_digits(text, rest / place);
        rest %= place;
        place /= 10;
    }
}

/// Appends a whole number; faster than `format!`, and files of figures are mostly numbers.
pub(super) fn push_digits(text: &mut String, whole: u64) {
    if whole >= 10 {
        push_digits(text, whole / 10);
    }
    text.push(char::from(b'0' + (whole % 10) as u8));
}
