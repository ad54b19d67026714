//! Values that the scene file may write in more than one form: vectors, places, directions, the ground, links.
//!
//! Each has a visitor of its own, so that a wrong value is told which forms it may have.

use std::borrow::Cow;
use std::fmt;

use indexmap::IndexMap;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, IgnoredAny, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};

use super::file::{LinkFields, SizeAngle};

/// `[x, y]`, or size and angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vector(pub [f64; 2]);

/// The coordinates of a point in a shape: a vector, or a distance along the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShapePoint(pub [f64; 2]);

/// A value of `near`: coordinates of a point, or degrees of an angle.
#[derive(Debug, Clone, Copy)]
pub(super) enum NearValue {
    Vector([f64; 2]),
    Degrees(f64),
}

/// The name of a point, or coordinates.
#[derive(Debug, Clone)]
pub(super) enum NameOrPlace {
    Name(String),
    Place([f64; 2]),
}

/// The direction of a guide as the file writes it.
#[derive(Debug, Clone)]
pub enum Direction {
    /// From the first to the second of two points, as `BE`, or `B-E` where names are longer or ambiguous.
    Points(String),
    /// An angle in degrees: from +x on the ground, from the axis of the guide's carrier otherwise.
    Degrees(f64),
    /// `[dx, dy]`.
    Vector([f64; 2]),
}

impl From<&str> for Direction {
    fn from(points: &str) -> Self {
        Direction::Points(points.to_owned())
    }
}

impl From<f64> for Direction {
    fn from(degrees: f64) -> Self {
        Direction::Degrees(degrees)
    }
}

impl From<[f64; 2]> for Direction {
    fn from(vector: [f64; 2]) -> Self {
        Direction::Vector(vector)
    }
}

/// The frame's points: names, or names with coordinates.
#[derive(Debug)]
pub(super) enum Ground {
    Names(Vec<String>),
    Places(IndexMap<String, Vector>),
}

/// A link: a bare list of points, or its fields.
#[derive(Debug)]
pub(super) struct LinkForm(pub LinkFields);

/// What stands in the file, of the forms that are allowed there.
enum Given {
    Number(f64),
    Text(String),
    Vector([f64; 2]),
}

/// Accepts a vector, and a number or a text where these are allowed.
struct OneOf {
    number: bool,
    text: bool,
    expecting: &'static str,
}

impl<'de> Visitor<'de> for OneOf {
    type Value = Given;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Given, E> {
        match self.number {
            true => Ok(Given::Number(number)),
            false => Err(E::invalid_type(Unexpected::Float(number), &self)),
        }
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Given, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Given, E> {
        self.visit_f64(number as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Given, E> {
        match self.text {
            true => Ok(Given::Text(text.to_owned())),
            false => Err(E::invalid_type(Unexpected::Str(text), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Given, A::Error> {
        let wrong = |count: usize| A::Error::custom(format!("expected two numbers [x, y], found a list of {count}"));
        let x = seq.next_element::<f64>()?.ok_or_else(|| wrong(0))?;
        let y = seq.next_element::<f64>()?.ok_or_else(|| wrong(1))?;
        let mut more = 0;
        while seq.next_element::<IgnoredAny>()?.is_some() {
            more += 1;
        }
        match more {
            0 => Ok(Given::Vector([x, y])),
            _ => Err(wrong(2 + more)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Given, A::Error> {
        let SizeAngle { size, angle } = SizeAngle::deserialize(MapAccessDeserializer::new(map))?;
        if size < 0.0 {
            let turned = "a size is not negative: turn the angle by 180 instead";
            return Err(A::Error::custom(format!("size is {}; {turned}", super::words::number(size))));
        }
        Ok(Given::Vector(polar(size, angle)))
    }
}

/// The vector of this size at this angle from +x, in degrees; at multiples of 90° its zeros are exact.
#[must_use]
pub fn polar(size: f64, angle_deg: f64) -> [f64; 2] {
    let angle = angle_deg % 360.0;
    match angle {
        0.0 => [size, 0.0],
        90.0 | -270.0 => [0.0, size],
        180.0 | -180.0 => [0.0 - size, 0.0],
        270.0 | -90.0 => [0.0, 0.0 - size],
        _ => [size * libm::cos(angle.to_radians()), size * libm::sin(angle.to_radians())],
    }
}

const VECTOR: OneOf =
    OneOf { number: false, text: false, expecting: r#"two numbers [x, y] or { "size": …, "angle": … }"# };

impl<'de> Deserialize<'de> for Vector {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match deserializer.deserialize_any(VECTOR)? {
            Given::Vector(vector) => Ok(Vector(vector)),
            Given::Number(_) | Given::Text(_) => Err(D::Error::custom(VECTOR.expecting)),
        }
    }
}

impl<'de> Deserialize<'de> for ShapePoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "two numbers [x, y] or one number, the distance along the axis";
        match deserializer.deserialize_any(OneOf { number: true, text: false, expecting })? {
            Given::Vector(vector) => Ok(ShapePoint(vector)),
            Given::Number(x) => Ok(ShapePoint([x, 0.0])),
            Given::Text(_) => Err(D::Error::custom(expecting)),
        }
    }
}

impl<'de> Deserialize<'de> for NearValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "two numbers [x, y], or for an \"angle(…)\" one number, its degrees";
        match deserializer.deserialize_any(OneOf { number: true, text: false, expecting })? {
            Given::Vector(vector) => Ok(NearValue::Vector(vector)),
            Given::Number(degrees) => Ok(NearValue::Degrees(degrees)),
            Given::Text(_) => Err(D::Error::custom(expecting)),
        }
    }
}

impl<'de> Deserialize<'de> for NameOrPlace {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "the name of a point in double quotes, or its coordinates [x, y]";
        match deserializer.deserialize_any(OneOf { number: false, text: true, expecting })? {
            Given::Vector(vector) => Ok(NameOrPlace::Place(vector)),
            Given::Text(name) => Ok(NameOrPlace::Name(name)),
            Given::Number(_) => Err(D::Error::custom(expecting)),
        }
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "two points as \"BE\", or a number of degrees, or [dx, dy]";
        Ok(match deserializer.deserialize_any(OneOf { number: true, text: true, expecting })? {
            Given::Vector(vector) => Direction::Vector(vector),
            Given::Number(degrees) => Direction::Degrees(degrees),
            Given::Text(points) => Direction::Points(points),
        })
    }
}

impl<'de> Deserialize<'de> for Ground {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Forms;
        impl<'de> Visitor<'de> for Forms {
            type Value = Ground;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(r#"the frame's points as { "A": [x, y], … }, or their names as ["A", …]"#)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Ground, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Ground::Names)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Ground, A::Error> {
                IndexMap::deserialize(MapAccessDeserializer::new(map)).map(Ground::Places)
            }
        }
        deserializer.deserialize_any(Forms)
    }
}

impl<'de> Deserialize<'de> for LinkForm {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Forms;
        impl<'de> Visitor<'de> for Forms {
            type Value = LinkForm;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(r#"a link as { "points": ["A", "B"], … }, or a list of its points ["A", "B"]"#)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<LinkForm, A::Error> {
                let points = Vec::deserialize(SeqAccessDeserializer::new(seq))?;
                Ok(LinkForm(LinkFields { points: Some(points), ..LinkFields::default() }))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<LinkForm, A::Error> {
                LinkFields::deserialize(MapAccessDeserializer::new(map)).map(LinkForm)
            }
        }
        deserializer.deserialize_any(Forms)
    }
}

/// The schema of a value of several forms.
macro_rules! schema_of {
    ($type:ident, $name:literal, $generator:ident => $schema:expr) => {
        impl JsonSchema for $type {
            fn schema_name() -> Cow<'static, str> {
                $name.into()
            }
            fn json_schema($generator: &mut SchemaGenerator) -> Schema {
                $schema
            }
        }
    };
}

schema_of!(Vector, "vector", generator => json_schema!({
    "description": "[x, y], or size and angle",
    "anyOf": [
        { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 },
        generator.subschema_for::<SizeAngle>(),
    ]
}));

schema_of!(ShapePoint, "shapePoint", generator => json_schema!({
    "description": "Coordinates in the link's own frame; a lone number is the distance along the link's axis",
    "anyOf": [generator.subschema_for::<Vector>(), { "type": "number" }]
}));

schema_of!(NearValue, "nearValue", generator => json_schema!({
    "description": "Approximate coordinates of a point; under a key like angle(3), degrees",
    "anyOf": [generator.subschema_for::<Vector>(), { "type": "number" }]
}));

schema_of!(NameOrPlace, "nameOrPlace", generator => json_schema!({
    "description": "The name of a point, or coordinates",
    "anyOf": [{ "type": "string" }, generator.subschema_for::<Vector>()]
}));

schema_of!(Direction, "direction", generator => json_schema!({
    "description": "Two points of the guide's carrier as \"BE\" or \"B-E\"; or degrees; or [dx, dy]",
    "anyOf": [{ "type": "string" }, { "type": "number" }, generator.subschema_for::<Vector>()]
}));

schema_of!(Ground, "ground", generator => json_schema!({
    "anyOf": [
        generator.subschema_for::<IndexMap<String, Vector>>(),
        { "type": "array", "items": { "type": "string" }, "description": "Names only, in a drawn configuration" },
    ]
}));

schema_of!(LinkForm, "link", generator => json_schema!({
    "anyOf": [
        generator.subschema_for::<LinkFields>(),
        { "type": "array", "items": { "type": "string" }, "description": "The link's points" },
    ]
}));
