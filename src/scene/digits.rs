//! The numbers of a scene as they are written, beyond the digits that f64 keeps.

use super::value::polar;
use crate::geometry::{Ball, Pair};
use jsonc_parser::ast::Value;
use std::borrow::Cow;
use std::collections::HashMap;

/// Whole numbers of so many digits are exact in f64, and decimals of so many are the shortest that read as their f64.
const KEPT: usize = 15;

/// Keys of a scene whose numbers nothing is computed from.
const SHOWN: [&str; 4] = ["near", "figure", "want", "form"];

/// What the numbers of a scene's text truly are, by the f64 that they are read as.
///
/// A scene keeps its numbers as f64. Where the last digit counts, they are looked up here: 0.1 is a tenth again, and a
/// coordinate of thirty digits has all of them. A vector by size and angle stands here by its two components, as they
/// follow from size and angle. Where two texts read as one f64, its ball holds both.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Digits(HashMap<u64, Given>);

/// A number of the text.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Given {
    /// What is written, without its sign.
    ball: Ball,
    /// Whether its f64 is printed with the same digits.
    is_printed: bool,
}

impl Digits {
    /// The numbers of a scene's tree.
    pub fn of(tree: &Value<'_>) -> Digits {
        let mut digits = Digits::default();
        let mut is_long = false;
        each_number(tree, &mut |number| match number {
            Number::Written(text) if is_exact(text) => {}
            Number::Written(text) => {
                let x = text.parse::<f64>().unwrap_or_default();
                let is_printed = significant(text).count() <= KEPT || is_shortest(text, x);
                is_long |= !is_printed;
                digits.add(x, Given { ball: Ball::of_decimal(text), is_printed });
            }
            Number::Component(x, ball) => {
                is_long = true;
                digits.add(x, Given { ball, is_printed: false });
            }
        });
        if is_long {
            // A whole number may stand beside one that only differs from it in its last digits.
            each_number(tree, &mut |number| {
                if let Number::Written(text) = number
                    && is_exact(text)
                {
                    let x = text.parse::<f64>().unwrap_or_default();
                    if digits.0.contains_key(&key(x)) {
                        digits.add(x, Given { ball: Ball::within(x, 0.0), is_printed: true });
                    }
                }
            });
        }
        digits
    }

    fn add(&mut self, x: f64, given: Given) {
        let ball = if x < 0.0 { -given.ball } else { given.ball };
        let given = Given { ball, ..given };
        let kept = self.0.entry(key(x)).or_insert(given);
        if kept.ball != given.ball {
            *kept = Given { ball: kept.ball.joined(given.ball), is_printed: false };
        }
    }

    /// The sum of two numbers of the text, as it is with all their digits: it counts as one of the text's own.
    pub fn sum(&mut self, [a, b]: [f64; 2]) -> f64 {
        let balls = [a, b].map(|x| self.written(x).unwrap_or_else(|| Ball::decimal(x)));
        let ball = match balls.iter().all(|ball| ball.low == 0.0 && ball.radius == 0.0) {
            true => Ball::difference(a, -b),
            false => balls[0] + balls[1],
        };
        let x = ball.high;
        if ball != Ball::decimal(x) {
            self.add(x, Given { ball, is_printed: false });
        }
        x
    }

    /// The number that was read as `x`; `None` where the text has no such number, or has it as a whole number that is exactly `x`.
    pub fn written(&self, x: f64) -> Option<Ball> {
        Some(self.0.get(&key(x))?.ball.signed(x))
    }

    /// Whether `x` is one of the text's numbers and is printed as it is written there.
    pub fn is_printed(&self, x: f64) -> bool {
        self.0.get(&key(x)).is_some_and(|given| given.is_printed)
    }
}

/// Signs do not count: a mirrored link has the same digits.
fn key(x: f64) -> u64 {
    x.abs().to_bits()
}

/// What a tree gives as numbers.
enum Number<'a> {
    /// A number by its text.
    Written(&'a str),
    /// A component of a vector by size and angle: as it is read, and what it truly is.
    Component(f64, Ball),
}

/// Calls `see` with all numbers from which something is computed.
fn each_number(value: &Value<'_>, see: &mut impl FnMut(Number<'_>)) {
    match value {
        Value::NumberLit(number) => see(Number::Written(number.value)),
        Value::Array(array) => array.elements.iter().for_each(|element| each_number(element, see)),
        Value::Object(object) => {
            if let (Some(size), Some(angle)) = (object.get_number("size"), object.get_number("angle")) {
                let read = |text: &str| text.parse::<f64>().unwrap_or_default();
                let angle = within_a_turn("angle", angle.value);
                let [x, y] = polar(read(size.value), read(&angle));
                let turn = Pair::direction_of_degrees(Ball::of_decimal(&angle));
                let true_vector = turn * Ball::of_decimal(size.value);
                see(Number::Component(x, true_vector.x));
                see(Number::Component(y, true_vector.y));
            }
            let shown = |name: &str| SHOWN.contains(&name);
            let properties = object.properties.iter().filter(|property| !shown(property.name.as_str()));
            properties.for_each(|property| match &property.value {
                Value::NumberLit(number) => {
                    see(Number::Written(&within_a_turn(property.name.as_str(), number.value)));
                }
                value => each_number(value, see),
            });
        }
        _ => {}
    }
}

/// Keys under which a number is an angle in degrees.
const ANGLES: [&str; 3] = ["angle", "along", "turned"];

/// Angles have their whole turns up to this size, up to which f64 keeps tenths of a degree.
const TURNS_KEPT: f64 = 1e14;

/// Whether the number under a key is an angle from which f64 would take degrees.
fn loses_degrees(key: &str, text: &str) -> bool {
    let is_angle = || ANGLES.contains(&key) || key.starts_with("angle(");
    text.parse::<f64>().is_ok_and(|x| x.is_finite() && x.abs() > TURNS_KEPT) && is_angle()
}

/// Where an angle that loses its whole turns stands in a tree, and its text.
pub(super) fn without_turns<'a>(value: &'a Value<'_>) -> Option<(Vec<String>, &'a str)> {
    let inside = |name: &str, (mut path, text): (Vec<String>, &'a str)| {
        path.insert(0, name.to_owned());
        (path, text)
    };
    match value {
        Value::Array(array) => array
            .elements
            .iter()
            .enumerate()
            .find_map(|(index, element)| Some(inside(&index.to_string(), without_turns(element)?))),
        Value::Object(object) => object.properties.iter().find_map(|property| {
            let name = property.name.as_str();
            let found = match &property.value {
                Value::NumberLit(number) => loses_degrees(name, number.value).then_some((Vec::new(), number.value)),
                value => without_turns(value),
            };
            Some(inside(name, found?))
        }),
        _ => None,
    }
}

/// The number under a key; of an angle so large that f64 would take degrees from it the remainder by 360, exactly.
pub(super) fn within_a_turn<'a>(key: &str, text: &'a str) -> Cow<'a, str> {
    if !loses_degrees(key, text) {
        return text.into();
    }
    let (sign, size) = text.strip_prefix('-').map_or(("", text), |size| ("-", size));
    let (mantissa, power) = size.split_once(['e', 'E']).unwrap_or((size, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.to_owned() + decimals;
    // A large number has digits before its point, however it is written; a small power is not told from none.
    let before = usize::try_from(whole.len() as i64 + power.parse::<i64>().unwrap_or_default()).unwrap_or_default();
    let (before, after) = (digits.chars().chain(std::iter::repeat('0')).take(before), digits.get(before..));
    let turned = before.filter_map(|digit| digit.to_digit(10)).fold(0, |rest, digit| (10 * rest + digit) % 360);
    format!("{sign}{turned}.{}", after.filter(|after| !after.is_empty()).unwrap_or("0")).into()
}

/// Whether the text is a whole number that f64 holds exactly.
fn is_exact(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text);
    digits.len() <= KEPT && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// The digits of a decimal from the first that is not zero to the last that is not zero.
fn significant(text: &str) -> impl Iterator<Item = u8> {
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    let digits: Vec<u8> = mantissa.bytes().filter(u8::is_ascii_digit).skip_while(|digit| *digit == b'0').collect();
    let last = digits.iter().rposition(|digit| *digit != b'0').map_or(0, |last| last + 1);
    digits.into_iter().take(last)
}

/// Whether the text has the digits of the shortest decimal that reads as `x`.
fn is_shortest(text: &str, x: f64) -> bool {
    significant(text).eq(significant(&format!("{x:e}")))
}
