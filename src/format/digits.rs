use super::centers::CenterResult;
use super::result::{QuantityResult, ResultFile};
use crate::construction::Solution;
use crate::geometry::{UNIT_ROUNDOFF, Vector, degrees_of};
use crate::quantity::{QuantityKind, QuantityRequest};
use crate::scene::{DecimalMark, Units};
use crate::words::NumberStyle;
use core::f64::consts::SQRT_2;

impl Solution {
    /// A table of every ω, α, velocity and acceleration with only its certain digits, of vectors with size and direction: name, value, unit, bound of the
    /// error. Quantities that a result has beside these follow.
    ///
    /// The true value is within one unit of the last digit that is printed. Given values are printed in full, with
    /// bound 0.
    #[must_use]
    pub fn digits(&self) -> String {
        self.digits_of(&self.result())
    }

    /// That of a result of this solution.
    #[must_use]
    pub fn digits_of(&self, result: &ResultFile) -> String {
        text(&self.rows_of(result))
    }

    /// The rows of that table.
    #[must_use]
    pub fn digit_rows(&self) -> Vec<DigitRow> {
        self.rows_of(&self.result())
    }

    fn rows_of(&self, result: &ResultFile) -> Vec<DigitRow> {
        let mut table = Table { units: self.scene.units, lines: Vec::new() };
        for (link, rates) in &result.links {
            let [omega, alpha] = ["omega", "alpha"].map(|head| format!("{head}({link})"));
            table.line(omega, rates.omega, rates.omega_error, QuantityKind::AngularVelocity);
            table.line(alpha, rates.alpha, rates.alpha_error, QuantityKind::AngularAcceleration);
        }
        for (slider, slide) in &result.sliders {
            let [velocity, acceleration] = ["v_r", "a_r"].map(|head| format!("{head}({slider})"));
            table.line(velocity, slide.velocity, slide.velocity_error, QuantityKind::Velocity);
            let kind = QuantityKind::Acceleration;
            table.line(acceleration, slide.acceleration, slide.acceleration_error, kind);
            table.vector(&format!("a_c({slider})"), slide.coriolis, slide.coriolis_error, kind);
        }
        for (point, motion) in &result.points {
            let [velocity, acceleration] = ["v", "a"].map(|head| format!("{head}({point})"));
            table.vector(&velocity, motion.velocity, motion.velocity_error, QuantityKind::Velocity);
            table.vector(&acceleration, motion.acceleration, motion.acceleration_error, QuantityKind::Acceleration);
        }
        for (name, value) in &result.quantities {
            let of_table = |row: &DigitRow| {
                row.name.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            };
            // What only the construction measures is not asked for.
            let is_wanted = self.scene.want.is_some() && !table.lines.iter().any(of_table);
            let Some(asked) = QuantityRequest::new(name, &self.mechanism).ok().filter(|_| is_wanted) else { continue };
            let (kind, error) = (asked.kind(), result.quantity_errors.get(name).copied());
            match *value {
                QuantityResult::Number(value) if asked.written.on_paper => table.row(name.clone(), value, error, "mm"),
                QuantityResult::Number(value) => table.line(name.clone(), value, error, kind),
                QuantityResult::Vector(vector) if asked.is_place() => table.components(name, vector, error, kind),
                QuantityResult::Vector(vector) => table.vector(name, Some(vector), error, kind),
            }
        }
        for (name, center) in &result.centers {
            let angle = format!("{name}.angle");
            if let Some(CenterResult::AtInfinity { at_infinity, angle_error, .. }) = center
                && !result.quantities.contains_key(&angle)
            {
                let direction = degrees_of(Vector::from(*at_infinity));
                table.line(angle, direction, *angle_error, QuantityKind::Angle);
            }
        }
        table.lines
    }
}

/// A row of the table of certain digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DigitRow {
    /// The name of the quantity.
    pub name: String,
    /// Its value with only its certain digits.
    pub value: String,
    /// Its unit.
    pub unit: String,
    /// The bound of its error, in words.
    pub bound: String,
}

struct Table {
    units: Units,
    lines: Vec<DigitRow>,
}

impl Table {
    /// Adds a number; nothing where it or its bound is not there.
    fn line(&mut self, name: String, value: impl Into<Option<f64>>, bound: impl Into<Option<f64>>, kind: QuantityKind) {
        self.row(name, value, bound, &kind.unit(self.units));
    }

    fn row(&mut self, name: String, value: impl Into<Option<f64>>, bound: impl Into<Option<f64>>, unit: &str) {
        let (Some(value), Some(bound)) = (value.into(), bound.into()) else { return };
        let (value, bound) = match certain(value, bound) {
            // The value is left out: nothing is known of its digits.
            _ if bound.is_infinite() => ("?".to_owned(), "no bound can be given here".to_owned()),
            Certain::Digits(value) => (value, format!("± {}", written(bound, NumberStyle::bound()))),
            Certain::None(within) => ("0".to_owned(), format!("± {within}, no digit is certain")),
        };
        self.lines.push(DigitRow { name, value, unit: unit.to_owned(), bound });
    }

    /// Size, direction and components of a vector, whose components are each off by at most `bound`.
    fn vector(&mut self, name: &str, vector: Option<[f64; 2]>, bound: Option<f64>, kind: QuantityKind) {
        let (Some([x, y]), Some(bound)) = (vector, bound) else { return };
        let vector = Vector::new(x, y);
        let (size, off) = (vector.norm(), bound * SQRT_2);
        let rounded = |value: f64| if value == 0.0 { 0.0 } else { 4.0 * UNIT_ROUNDOFF * value };
        self.line(format!("{name}.size"), size, off + rounded(size), kind);
        // The tip lies in a circle about that of the computed vector: seen from its start, asin(off/size) to either side.
        // With this circle about the start there is no direction.
        if off < size {
            let turned = libm::asin(off / size).to_degrees() + rounded(180.0);
            self.line(format!("{name}.angle"), degrees_of(vector), turned, QuantityKind::Angle);
        }
        self.components(name, [x, y], bound, kind);
    }

    fn components(&mut self, name: &str, [x, y]: [f64; 2], bound: impl Into<Option<f64>>, kind: QuantityKind) {
        let bound = bound.into();
        self.line(format!("{name}.x"), x, bound, kind);
        self.line(format!("{name}.y"), y, bound, kind);
    }
}

/// The table as text: names left-aligned, values with their decimal points aligned.
fn text(rows: &[DigitRow]) -> String {
    let before = |value: &str| value.find(['.', 'e']).unwrap_or(value.len());
    let wide = |text: &str| text.chars().count();
    let widest = |of: &dyn Fn(&DigitRow) -> usize| rows.iter().map(of).max();
    let name = widest(&|row| wide(&row.name)).unwrap_or(0);
    let left = widest(&|row| before(&row.value)).unwrap_or(0);
    let value = widest(&|row| left - before(&row.value) + row.value.len()).unwrap_or(0);
    let unit = widest(&|row| wide(&row.unit)).unwrap_or(0);
    let line = |row: &DigitRow| {
        let shift = " ".repeat(left - before(&row.value));
        let shifted = format!("{shift}{}", row.value);
        format!("{:name$}  {shifted:value$}  {:unit$}  {}\n", row.name, row.unit, row.bound)
    };
    rows.iter().map(line).collect()
}

/// The certain digits of a value.
#[derive(Debug, PartialEq)]
pub enum Certain {
    /// The value as text: the true one is within one unit of the last digit.
    Digits(String),
    /// No digit is certain: the magnitude of the true value is at most this.
    None(String),
}

/// The certain digits of `value`, whose error is at most `bound`.
///
/// Rounding to the last digit may add an error of half its unit, so `bound` may be at most the other half.
pub fn certain(value: f64, bound: f64) -> Certain {
    // An exact value: the shortest text that reads back to the number.
    if bound == 0.0 {
        return Certain::Digits(written(value, NumberStyle::shortest().in_full(-5, 9)));
    }
    let last = place_above(2.0 * bound);
    // The power of ten of the first digit.
    let first = exponent(&format!("{:e}", value.abs()));
    if value == 0.0 || first < last {
        return Certain::None(written(value.abs() + bound, NumberStyle::bound()));
    }
    // An f64 has no more than 17 significant digits.
    let digits = (first - last).min(16);
    if last <= 0 && (-5..9).contains(&first) {
        Certain::Digits(format!("{value:.*}", (digits - first) as usize))
    } else {
        Certain::Digits(format!("{value:.*e}", digits as usize))
    }
}

/// A number of a result, always with a decimal point, not a comma.
fn written(x: f64, style: NumberStyle) -> String {
    style.write(x, DecimalMark::Point)
}

/// The exponent of a number in scientific notation; 0 where there is none.
fn exponent(text: &str) -> i32 {
    text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

/// The smallest whole k with x ≤ 10^k, for a positive x.
fn place_above(x: f64) -> i32 {
    let k = exponent(&format!("{x:e}"));
    let unit: f64 = format!("1e{k}").parse().unwrap_or(x);
    if x <= unit { k } else { k + 1 }
}
