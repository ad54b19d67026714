//! Decimals, as people write them, as balls.

use super::Ball;
use super::ball::exact;

/// Powers of ten up to this one are exact in f64.
const EXACT: u32 = 22;

/// So many digits at a time are exact in f64.
const TOGETHER: usize = 15;

/// Digits that count; a ball keeps some 31.
const MOST: usize = 3 * TOGETHER;

/// Whole numbers below this are exact in f64 and printed as they are.
const WHOLE: f64 = 1e15;

impl Ball {
    /// The decimal number that `text` writes, as in `-3.125e-2`, with all its digits. Nothing for other texts: zero.
    #[must_use]
    pub fn of_decimal(text: &str) -> Ball {
        let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let unsigned = mantissa.trim_start_matches(['-', '+']);
        let decimals = unsigned.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let digits = unsigned.bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0');
        let digits: Vec<u8> = digits.skip_while(|digit| *digit == 0).collect();
        // What ends in zeros is a shorter number, which may be exact.
        let last = digits.iter().rposition(|digit| *digit > 0).map_or(0, |last| last + 1);
        let kept = &digits[..last.min(MOST)];
        let number = kept.chunks(TOGETHER).fold(Ball::default(), |number, chunk| {
            let whole = exact(chunk.iter().fold(0.0, |whole, digit| 10.0 * whole + f64::from(*digit)));
            if number == Ball::default() { whole } else { number * exact(power_of_ten(chunk.len() as u32)) + whole }
        });
        let number = if last > MOST { number.widened(1.0) } else { number };
        let moved = (digits.len() - kept.len()) as i64 - decimals as i64;
        let power = power.parse::<i64>().unwrap_or_default().saturating_add(moved).clamp(-1000, 1000);
        let scaled = scaled(number, power);
        if mantissa.starts_with('-') { -scaled } else { scaled }
    }

    /// The shortest decimal that reads as `x`, which is how `x` is printed.
    #[must_use]
    pub fn decimal(x: f64) -> Ball {
        if x.trunc() == x && x.abs() < WHOLE { exact(x) } else { Ball::of_decimal(&format!("{x:e}")) }
    }
}

/// A number times a power of ten.
fn scaled(number: Ball, power: i64) -> Ball {
    let size = power.unsigned_abs() as u32;
    (0..size).step_by(EXACT as usize).fold(number, |number, done| {
        let scale = power_of_ten((size - done).min(EXACT));
        if power < 0 {
            number / exact(scale)
        } else if number.low == 0.0 && number.radius == 0.0 {
            Ball::product(number.high, scale)
        } else {
            number * exact(scale)
        }
    })
}

/// A power of ten up to [`EXACT`].
fn power_of_ten(power: u32) -> f64 {
    (0..power).fold(1.0, |scale, _| 10.0 * scale)
}
