//! Numbers of about 32 digits, so that a difference from a published decimal is not blurred by reading that decimal.
//! Plain code on purpose: it shares nothing with what it measures.

use std::ops::{Add, Mul, Neg, Sub};

/// The unevaluated sum of two f64 (Dekker 1971, Knuth 1969): about 106 bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exact {
    high: f64,
    low: f64,
}

impl Exact {
    /// The decimal number that `text` writes, to 30 digits or more.
    pub fn read(text: &str) -> Exact {
        let high: f64 = text.parse().expect("a decimal number");
        Exact::sum(high, -minus(high, text))
    }

    /// The nearest f64.
    pub fn rounded(self) -> f64 {
        self.high + self.low
    }

    fn sum(a: f64, b: f64) -> Exact {
        let high = a + b;
        let part = high - a;
        let low = (a - (high - part)) + (b - part);
        Exact { high, low }
    }
}

impl From<f64> for Exact {
    fn from(high: f64) -> Exact {
        Exact { high, low: 0.0 }
    }
}

impl Add for Exact {
    type Output = Exact;
    fn add(self, other: Exact) -> Exact {
        let (high, low) = (Exact::sum(self.high, other.high), Exact::sum(self.low, other.low));
        let once = Exact::sum(high.high, high.low + low.high);
        Exact::sum(once.high, once.low + low.low)
    }
}

impl Neg for Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { high: -self.high, low: -self.low }
    }
}

impl Sub for Exact {
    type Output = Exact;
    fn sub(self, other: Exact) -> Exact {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Exact;
    fn mul(self, other: Exact) -> Exact {
        let high = self.high * other.high;
        let low = self.high.mul_add(other.high, -high);
        Exact::sum(high, low + (self.high * other.low + self.low * other.high))
    }
}

/// A whole number times a power of ten.
struct Decimal {
    digits: i128,
    exponent: i32,
}

/// Digits of a decimal: an i128 holds two more, so that a difference fits.
const DIGITS: i32 = 36;

impl Decimal {
    fn read(text: &str) -> Decimal {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        let exponent: i32 = exponent.parse().expect("an exponent");
        Decimal {
            digits: digits.parse().expect("at most 38 digits"),
            exponent: exponent - i32::try_from(fraction.len()).expect("a short fraction"),
        }
    }

    /// The power of ten just above the number.
    fn top(&self) -> i32 {
        let count = self.digits.unsigned_abs().checked_ilog10().map_or(0, |log| log + 1);
        self.exponent + i32::try_from(count).expect("at most 38 digits")
    }

    /// How many units of 10^`unit` it is, cut off.
    fn in_units(&self, unit: i32) -> i128 {
        let shift = self.exponent - unit;
        let power = 10_i128.checked_pow(shift.unsigned_abs());
        match (shift >= 0, power) {
            (true, Some(power)) => self.digits * power,
            (false, Some(power)) => self.digits / power,
            (_, None) => 0,
        }
    }
}

/// The exact value of `x` minus the decimal number `reference`, rounded once.
///
/// The subtraction is done in whole numbers; what is lost is below 10^−35 of the larger one.
pub fn minus(x: f64, reference: &str) -> f64 {
    // Rust writes as many exact digits of an f64 as it is asked for.
    let x = Decimal::read(&format!("{x:.35e}"));
    let mut reference = Decimal::read(reference);
    if reference.digits == 0 {
        reference.exponent = x.exponent;
    }
    let top = |d: &Decimal| if d.digits == 0 { i32::MIN } else { d.top() };
    let largest = top(&x).max(top(&reference));
    if largest == i32::MIN {
        return 0.0;
    }
    let unit = largest - DIGITS;
    let units = x.in_units(unit) - reference.in_units(unit);
    format!("{units}e{unit}").parse().expect("a decimal number")
}

/// Whether `x` is above `bound`; a NaN is above all bounds.
pub fn exceeds(x: f64, bound: f64) -> bool {
    x.is_nan() || x > bound
}

/// A scene with every number written as the exact value of its f64, to sixty digits: 0.1 as 0.1000000000000000055511151…
///
/// What is stated of a scene's errors is against its decimals, so this is how a scene says that it means its f64.
pub fn exactly_written(scene: &str) -> String {
    let (mut written, mut number, mut in_text) = (String::new(), String::new(), false);
    for letter in scene.chars() {
        if !in_text && (letter.is_ascii_digit() || "+-.eE".contains(letter)) && (letter != 'e' || !number.is_empty()) {
            number.push(letter);
            continue;
        }
        let text = std::mem::take(&mut number);
        match text.parse::<f64>() {
            Ok(x) if text.contains(['.', 'e', 'E']) || text.len() > 15 => written.push_str(&format!("{x:.60e}")),
            _ => written.push_str(&text),
        }
        in_text ^= letter == '"';
        written.push(letter);
    }
    written
}
