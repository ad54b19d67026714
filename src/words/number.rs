use crate::scene::DecimalMark;

/// The kind of text that a number is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Medium {
    /// On a figure, in markup: `−2.5·10^{−7}`, with the minus sign that is as wide as a plus, and `83 300` with a space that is not
    /// broken where the whole part has five digits or more (ISO 80000-1, 7.3.1).
    Figure,
    /// In plain text: `-2.5e-7`.
    Text,
}

/// The digits with which a number is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Digits {
    /// This number of digits, from the first that is not 0.
    Significant(usize),
    /// This number of digits behind the decimal mark.
    Decimals(usize),
    /// The fewest from which the same number is read back.
    Shortest,
    /// One digit, rounded away from 0.
    OneUp,
}

/// How a number is written, by default in plain text; the [`Wording`](super::Wording) gives the decimal mark.
///
/// Zero is `0`, with decimals only in a style of [`NumberStyle::decimals`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberStyle {
    digits: Digits,
    /// A number is written without a power of ten if the exponent of its first digit is in this range, the end
    /// excluded.
    full: [i32; 2],
    is_trimmed: bool,
    is_rounded: bool,
    has_plus: bool,
    medium: Medium,
}

impl NumberStyle {
    const fn new(digits: Digits, full: [i32; 2]) -> NumberStyle {
        NumberStyle { digits, full, is_trimmed: false, is_rounded: false, has_plus: false, medium: Medium::Text }
    }

    /// With this number of significant digits, as `0.1200`; with a power of ten outside of 10⁻⁴ to 10⁹.
    #[must_use]
    pub const fn significant(digits: usize) -> NumberStyle {
        NumberStyle::new(Digits::Significant(digits), [-4, 9])
    }

    /// With this number of decimals, as `12.30`; never with a power of ten.
    #[must_use]
    pub const fn decimals(decimals: usize) -> NumberStyle {
        NumberStyle::new(Digits::Decimals(decimals), [i32::MIN, i32::MAX])
    }

    /// With the fewest digits from which the same number is read back, as `0.25`; with a power of ten outside of 10⁻⁹ to
    /// 10¹⁶.
    #[must_use]
    pub const fn shortest() -> NumberStyle {
        NumberStyle::new(Digits::Shortest, [-9, 16])
    }

    /// A bound: one digit, rounded away from 0, with a power of ten, as `3e-17`.
    #[must_use]
    pub const fn bound() -> NumberStyle {
        NumberStyle::new(Digits::OneUp, [0, 0])
    }

    /// Without a power of ten where the rounded number is at least 10^`from` and below 10^`to`; elsewhere with one, and
    /// with all digits in a style of [`NumberStyle::decimals`].
    #[must_use]
    pub const fn in_full(self, from: i32, to: i32) -> NumberStyle {
        NumberStyle { full: [from, to], ..self }
    }

    /// Without trailing zeros of its decimals.
    #[must_use]
    pub const fn trimmed(self) -> NumberStyle {
        NumberStyle { is_trimmed: true, ..self }
    }

    /// With no more significant digits than asked for, before the decimal mark too: 83295 with three is `83300`.
    #[must_use]
    pub const fn rounded(self) -> NumberStyle {
        NumberStyle { is_rounded: true, ..self }
    }

    /// With a plus sign unless negative.
    #[must_use]
    pub const fn with_plus(self) -> NumberStyle {
        NumberStyle { has_plus: true, ..self }
    }

    /// As it is written in this kind of text.
    #[must_use]
    pub const fn on(self, medium: Medium) -> NumberStyle {
        NumberStyle { medium, ..self }
    }

    /// The number in this style.
    #[must_use]
    pub fn write(self, x: f64, mark: DecimalMark) -> String {
        let has_decimals = matches!(self.digits, Digits::Decimals(_));
        let mut text = if x == 0.0 && !has_decimals { "0".to_owned() } else { self.ascii(x) };
        if self.has_plus && !text.starts_with('-') {
            text.insert(0, '+');
        }
        if self.medium == Medium::Figure {
            text = in_groups(&text).replace('-', "−");
        }
        marked(text, mark)
    }

    /// The number in ASCII: hyphen as minus sign, decimal point, no plus sign.
    fn ascii(self, x: f64) -> String {
        if !x.is_finite() {
            return x.to_string();
        }
        // The exponent is that of the rounded number: with four digits, 9.9996 is 10.00.
        let scientific = match self.digits {
            Digits::Significant(digits) => format!("{x:.*e}", digits - 1),
            Digits::OneUp => one_up(x),
            Digits::Decimals(_) | Digits::Shortest => format!("{x:e}"),
        };
        let (mantissa, power) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let power: i32 = power.parse().unwrap_or(0);
        if self.full[0] <= power && power < self.full[1] {
            let full = match self.digits {
                Digits::Significant(digits) => {
                    let x = if self.is_rounded { scientific.parse().unwrap_or(x) } else { x };
                    format!("{x:.*}", usize::try_from(digits as i32 - 1 - power).unwrap_or(0))
                }
                Digits::Decimals(decimals) => format!("{x:.decimals$}"),
                Digits::Shortest | Digits::OneUp => x.to_string(),
            };
            return self.without_idle_zeros(&full).to_owned();
        }
        let mantissa = self.without_idle_zeros(mantissa);
        match self.medium {
            Medium::Figure => format!("{mantissa}·{}", power_of_ten(power)),
            Medium::Text => format!("{mantissa}e{power}"),
        }
    }

    fn without_idle_zeros(self, number: &str) -> &str {
        let has_idle = self.is_trimmed && number.contains('.');
        if has_idle { number.trim_end_matches('0').trim_end_matches('.') } else { number }
    }
}

/// A number that was written with a decimal point, with this decimal mark.
pub(super) fn marked(written: String, mark: DecimalMark) -> String {
    match mark {
        DecimalMark::Point => written,
        DecimalMark::Comma => written.replace('.', ","),
    }
}

/// A number with its whole part in groups of three digits; one of four digits stays together.
fn in_groups(number: &str) -> String {
    let from = number.find(|c: char| c.is_ascii_digit()).unwrap_or(number.len());
    let digits = number[from..].bytes().take_while(u8::is_ascii_digit).count();
    if digits < 5 {
        return number.to_owned();
    }
    let mut grouped = number[..from].to_owned();
    for (index, digit) in number[from..].chars().enumerate() {
        if index > 0 && index < digits && (digits - index).is_multiple_of(3) {
            grouped.push('\u{a0}');
        }
        grouped.push(digit);
    }
    grouped
}

/// Most decimals of an angle in degrees at which something happens.
const MOST: f64 = 10.0;

/// An angle in degrees with its unit, with as many decimals as are certain where it may be off by `within`: what is printed
/// is right to one unit of the last one.
pub(crate) fn certain_angle(degrees: f64, within: f64) -> String {
    let certain = if within > 0.0 { -libm::log10(2.0 * within) } else { MOST };
    let scale = libm::exp10(libm::floor(certain.clamp(0.0, MOST)));
    format!("{}°", (degrees * scale).round() / scale + 0.0)
}

/// A power of ten in markup: `10^{−3}`.
#[must_use]
pub fn power_of_ten(power: i32) -> String {
    format!("10^{{{}}}", power.to_string().replace('-', "−"))
}

/// A number rounded away from 0 to one digit, as in `3e-17`.
fn one_up(x: f64) -> String {
    let text = format!("{x:.0e}");
    if text.parse().is_ok_and(|rounded: f64| x.abs() <= rounded.abs()) {
        return text;
    }
    // It was rounded down: one unit is added, with a carry from 9 to 10.
    let (digit, power) = text.split_once('e').unwrap_or((&text, "0"));
    let [digit, power] = [digit, power].map(|part| part.parse::<i32>().unwrap_or(0));
    let next = digit + digit.signum();
    if next.abs() < 10 { format!("{next}e{power}") } else { format!("{}e{}", next.signum(), power + 1) }
}
