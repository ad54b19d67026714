//! What to try where a value is of the wrong type, or a key is of something that scenes do not have.

use serde_json::Value as Json;

use super::figure::Page;
use super::units::LengthUnit;
use super::words::suggestion;

/// Keys of what moves otherwise than by pins and straight sliders.
const OTHER_JOINTS: [&str; 17] = [
    "gear", "gears", "gearing", "teeth", "pinion", "rack", "racks", "belt", "belts", "pulley", "pulleys", "chain",
    "chains", "cam", "cams", "follower", "geneva",
];

/// Keys of what moves a mechanism.
const FORCES: [&str; 14] = [
    "force", "forces", "load", "loads", "torque", "torques", "mass", "masses", "inertia", "spring", "springs",
    "damper", "dampers", "friction",
];

/// The hint for a key of something that scenes do not have.
pub(super) fn out_of_scope(word: &str) -> Option<String> {
    let word = word.to_lowercase();
    let hint = match word.as_str() {
        word if OTHER_JOINTS.contains(&word) => {
            "links are joined by pins and straight sliders: gears, belts, chains, racks and cams are out of scope"
        }
        word if FORCES.contains(&word) => {
            "motions follow from the drives: forces, masses, springs and friction are out of scope"
        }
        _ => return None,
    };
    Some(hint.to_owned())
}

/// The hint for the value `found` at `path`, where something else is expected.
pub(super) fn type_hint(path: &[&str], expected: &str, found: &Json) -> Option<String> {
    match found {
        Json::String(text) if expected.contains("number") => number_hint(path, expected, text.trim()),
        Json::Number(number) if expected.contains("text") || expected.contains("name") => {
            Some(format!("write \"{number}\" in double quotes"))
        }
        _ => None,
    }
}

/// The hint for a word that its type refuses in words of its own.
pub(super) fn word_hint(path: &[&str], word: &str) -> Option<String> {
    match path.last().copied()? {
        "page" => suggestion(word, Page::NAMES, "write one of"),
        "values" => suggestion(word, LengthUnit::ALL.map(LengthUnit::as_str), "write true, false or one of"),
        _ => None,
    }
}

/// The hint for a text where a number is expected.
fn number_hint(path: &[&str], expected: &str, text: &str) -> Option<String> {
    let key = path.last().copied().unwrap_or_default();
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit()).trim_end();
    let pointed = text.replacen(',', ".", 1);
    let is_number = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    let unit = text[number.len()..].trim().to_lowercase();
    if is_number(text) {
        return Some(format!("write {text} without quotes"));
    }
    if is_number(&pointed) {
        return Some(format!("write {pointed} without quotes and with a point"));
    }
    if let Some(value) = multiple_of_pi(text) {
        let digits = rounded(value);
        return Some(match key {
            "omega" => format!("write {digits} without quotes, or the speed as \"rpm\""),
            "angle" | "along" => {
                format!("angles are in degrees: write {} without quotes", rounded(value.to_degrees()))
            }
            _ => format!("write {digits} without quotes"),
        });
    }
    if !is_number(number) {
        return None;
    }
    if key == "omega" && ["rpm", "r/min", "1/min", "min-1", "u/min"].contains(&unit.as_str()) {
        return Some(format!("write \"rpm\": {number} in place of \"omega\""));
    }
    if key == "angle" && unit.starts_with("rad") {
        let degrees = number.parse::<f64>().unwrap_or_default().to_degrees();
        return Some(format!("angles are in degrees: write {} without quotes", rounded(degrees)));
    }
    Some(match expected.contains(" mm") {
        true => format!("write {number} without quotes"),
        false => format!("write {number} without quotes; units stand in `units`, angles are in degrees"),
    })
}

/// The value of a text like `2pi`, `pi/3`, `-2*π/3` or `2 pi rad/s`.
fn multiple_of_pi(text: &str) -> Option<f64> {
    let compact: String =
        text.to_lowercase().chars().filter(|c| !c.is_whitespace() && *c != '*' && *c != '·').collect();
    let compact =
        ["rad/s", "rad/min", "rad"].into_iter().find_map(|unit| compact.strip_suffix(unit)).unwrap_or(&compact);
    let (times, rest) = compact.split_once("pi").or_else(|| compact.split_once('π'))?;
    let times = match times {
        "" | "+" => 1.0,
        "-" | "−" => -1.0,
        times => times.parse::<f64>().ok()?,
    };
    let parts = match rest {
        "" => 1.0,
        rest => rest.strip_prefix('/')?.parse::<f64>().ok()?,
    };
    let value = times * std::f64::consts::PI / parts;
    value.is_finite().then_some(value)
}

/// Ten digits, without zeros at the end.
fn rounded(value: f64) -> String {
    let text = format!("{value:.9e}");
    text.parse().unwrap_or(value).to_string()
}
