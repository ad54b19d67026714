use serde_json::{Value, json};

/// The meaning of a number in a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// A coordinate of a place, or a length.
    Length,
    /// A component or the size of a given velocity or acceleration.
    Motion,
    /// The angle of a given velocity or acceleration, in degrees.
    Direction,
    /// A given angular velocity or acceleration of a link.
    Turning,
    /// The angle of a drive, in degrees.
    DriveAngle,
    /// The position of a driven slider along its guide.
    DrivePosition,
    /// Angular velocity, speed or acceleration of a drive.
    DriveRate,
}

/// Replaces the numbers of places, lengths, given motions and drives in a scene file, in this order, each by what
/// `change` returns.
///
/// Rough places (`near`), directions of guides and the figure stay as they are.
pub fn each_number(scene: &mut Value, change: &mut dyn FnMut(Number, f64) -> f64) {
    for (key, number) in [("ground", Number::Length), ("points", Number::Length), ("known", Number::Motion)] {
        within(scene.get_mut(key), number, change);
    }
    let links = scene.get_mut("links").and_then(Value::as_object_mut);
    for link in links.into_iter().flat_map(|links| links.values_mut()) {
        for (key, number) in [("lengths", Number::Length), ("shape", Number::Length), ("motion", Number::Motion)] {
            within(link.get_mut(key), number, change);
        }
        drive(link.get_mut("drive"), change);
        if let Some(angle) = link.get_mut("angle") {
            within(Some(angle), Number::DriveAngle, change);
        }
    }
    let sliders = scene.get_mut("sliders").and_then(Value::as_array_mut);
    for slider in sliders.into_iter().flatten() {
        drive(slider.get_mut("drive"), change);
    }
}

fn drive(drive: Option<&mut Value>, change: &mut dyn FnMut(Number, f64) -> f64) {
    let entries = drive.and_then(Value::as_object_mut);
    for (key, value) in entries.into_iter().flatten() {
        let number = match key.as_str() {
            "angle" => Number::DriveAngle,
            "position" => Number::DrivePosition,
            _ => Number::DriveRate,
        };
        within(Some(value), number, change);
    }
}

/// Changes all numbers of a part of the file.
fn within(part: Option<&mut Value>, number: Number, change: &mut dyn FnMut(Number, f64) -> f64) {
    match part {
        Some(value @ Value::Number(_)) => {
            let x = value.as_f64().unwrap_or(0.0);
            *value = written(change(number, x));
        }
        Some(Value::Array(elements)) => {
            for element in elements {
                within(Some(element), number, change);
            }
        }
        Some(Value::Object(entries)) => {
            for (key, value) in entries {
                let number = match (key.as_str(), number) {
                    ("angle", Number::Motion) => Number::Direction,
                    ("omega" | "alpha", Number::Motion) => Number::Turning,
                    ("at", Number::Motion) => Number::Length,
                    (_, number) => number,
                };
                within(Some(value), number, change);
            }
        }
        _ => {}
    }
}

/// A number as JSON: a whole one without a decimal point.
pub(super) fn written(x: f64) -> Value {
    if x == libm::trunc(x) && x.abs() < 1e15 {
        // As an integer, −0 becomes 0.
        return json!(x as i64);
    }
    json!(x)
}
