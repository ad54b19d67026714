//! Values that a file may write in several forms: vectors, places, directions.
//!
//! The error of a wrong value lists the forms it may have.

use std::fmt;

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, IgnoredAny, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};

use super::error::number;
use super::reader::TWO_NUMBERS;
use super::write::write_forms;
use crate::geometry::{Ball, Pair};

/// A vector, written as `[x, y]` or by size and angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vector(pub [f64; 2]);

/// Reads a vector as its components.
pub(super) fn vector<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 2], D::Error> {
    Vector::deserialize(deserializer).map(|vector| vector.0)
}

/// The coordinates of a point in a shape, written as a vector or as a distance along the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShapePoint(pub [f64; 2]);

/// A value of `near`: coordinates of a point, or an angle in degrees.
#[derive(Debug, Clone, Copy)]
pub(super) enum NearValue {
    Vector([f64; 2]),
    Degrees(f64),
}

/// A place, by a named point or by coordinates.
#[derive(Debug, Clone, PartialEq)]
pub enum At {
    /// The place of this point.
    Point(String),
    /// Coordinates, in the fixed frame unless the field that holds it says otherwise.
    Place([f64; 2]),
}

/// The direction of a guide as the file writes it.
#[derive(Debug, Clone, PartialEq)]
pub enum Direction {
    /// From the first to the second of two points, as `BE`, or `B-E` where names are longer or ambiguous.
    Points(String),
    /// An angle in degrees: from +x on the ground, from the axis of the guide's carrier otherwise.
    Degrees(f64),
    /// `[dx, dy]`.
    Vector([f64; 2]),
}

impl From<&str> for At {
    fn from(point: &str) -> Self {
        At::Point(point.to_owned())
    }
}

impl From<[f64; 2]> for At {
    fn from(place: [f64; 2]) -> Self {
        At::Place(place)
    }
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

/// The vector of this size at this angle from +x, in degrees, each component rounded once; at multiples of 90° its zero
/// component is exact.
#[must_use]
pub fn polar(size: f64, angle_deg: f64) -> [f64; 2] {
    let angle = angle_deg % 360.0;
    match angle {
        0.0 => [size, 0.0],
        90.0 | -270.0 => [0.0, size],
        180.0 | -180.0 => [0.0 - size, 0.0],
        270.0 | -90.0 => [0.0, 0.0 - size],
        _ => {
            let Pair { x, y } = Pair::direction_of_degrees(Ball::decimal(angle)) * Ball::decimal(size);
            [x.high, y.high]
        }
    }
}

/// A vector by size and angle.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "sizeAngle"))]
#[serde(deny_unknown_fields, expecting = r#"a vector as { "size": 150, "angle": 210 }"#)]
struct SizeAngle {
    /// Size, not negative.
    #[cfg_attr(feature = "schemas", schemars(range(min = 0.0)))]
    size: f64,
    /// Angle from +x, in degrees.
    angle: f64,
}

/// Reads a string, a number or a vector; `from` makes a `T` of the forms that are allowed.
pub(super) struct OneOf<T> {
    pub expecting: &'static str,
    pub from: fn(Direction) -> Option<T>,
}

impl<'de, T> Visitor<'de> for OneOf<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<T, E> {
        (self.from)(Direction::Degrees(number)).ok_or_else(|| E::invalid_type(Unexpected::Float(number), &self))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<T, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        self.visit_f64(number as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.from)(text.into()).ok_or_else(|| E::invalid_type(Unexpected::Str(text), &self))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<T, A::Error> {
        let wrong = |count: usize| A::Error::invalid_length(count, &TWO_NUMBERS);
        let x = seq.next_element::<f64>()?.ok_or_else(|| wrong(0))?;
        let y = seq.next_element::<f64>()?.ok_or_else(|| wrong(1))?;
        let mut more = 0;
        while seq.next_element::<IgnoredAny>()?.is_some() {
            more += 1;
        }
        let vector = (more == 0).then_some(Direction::Vector([x, y]));
        vector.and_then(self.from).ok_or_else(|| wrong(2 + more))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
        let SizeAngle { size, angle } = SizeAngle::deserialize(MapAccessDeserializer::new(map))?;
        if size < 0.0 {
            let turned = "a size is not negative: turn the angle by 180 instead";
            return Err(A::Error::custom(format!("size is {}; {turned}", number(size))));
        }
        (self.from)(Direction::Vector(polar(size, angle))).ok_or_else(|| A::Error::custom(self.expecting))
    }
}

/// Reads a list of names, or an `M`.
pub(super) struct NamesOr<T, M> {
    pub expecting: &'static str,
    pub names: fn(Vec<String>) -> T,
    pub other: fn(M) -> T,
}

impl<'de, T, M: Deserialize<'de>> Visitor<'de> for NamesOr<T, M> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<T, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(seq)).map(self.names)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
        M::deserialize(MapAccessDeserializer::new(map)).map(self.other)
    }
}

/// Implements reading and schema of a type that may be written in several forms.
macro_rules! several_forms {
    ($type:ident, $name:literal, $reads:expr, $generator:ident => $schema:tt) => {
        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any($reads)
            }
        }

        #[cfg(feature = "schemas")]
        impl schemars::JsonSchema for $type {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }

            fn json_schema($generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!($schema)
            }
        }
    };
}
pub(crate) use several_forms;

/// Makes an enum of such words, with one list for reading, schema and writing.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident { $($(#[$doc:meta])* $value:ident = $word:literal,)* }) => {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
        #[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
        $(#[$about])*
        #[non_exhaustive]
        pub enum $name { $($(#[$doc])* #[serde(rename = $word)] $value,)* }

        crate::scene::write::write_forms! { $name { word => word.as_str() } }

        impl $name {
            /// All of them.
            pub const ALL: [$name; [$($word),*].len()] = [$($name::$value),*];

            /// The word for it in a scene file.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $($name::$value => $word,)* }
            }
        }
    };
}
pub(super) use choice;

several_forms!(Vector, "vector", OneOf {
    expecting: r#"two numbers [x, y] or { "size": …, "angle": … }"#,
    from: |given| match given {
        Direction::Vector(vector) => Some(Vector(vector)),
        Direction::Degrees(_) | Direction::Points(_) => None,
    },
}, generator => {
    "description": "[x, y], or size and angle",
    "anyOf": [
        { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 },
        generator.subschema_for::<SizeAngle>(),
    ]
});

several_forms!(ShapePoint, "shapePoint", OneOf {
    expecting: "two numbers [x, y] or one number, the distance along the axis",
    from: |given| match given {
        Direction::Vector(place) => Some(ShapePoint(place)),
        Direction::Degrees(x) => Some(ShapePoint([x, 0.0])),
        Direction::Points(_) => None,
    },
}, generator => {
    "description": "Coordinates in the link's own frame; a lone number is the distance along the link's axis",
    "anyOf": [generator.subschema_for::<Vector>(), { "type": "number" }]
});

several_forms!(NearValue, "nearValue", OneOf {
    expecting: "two numbers [x, y], or for an \"angle(…)\" one number, its degrees",
    from: |given| match given {
        Direction::Vector(place) => Some(NearValue::Vector(place)),
        Direction::Degrees(degrees) => Some(NearValue::Degrees(degrees)),
        Direction::Points(_) => None,
    },
}, generator => {
    "description": "Approximate coordinates of a point; under a key like angle(3), degrees",
    "anyOf": [generator.subschema_for::<Vector>(), { "type": "number" }]
});

several_forms!(At, "nameOrPlace", OneOf {
    expecting: "the name of a point in double quotes, or its coordinates [x, y]",
    from: |given| match given {
        Direction::Vector(place) => Some(At::Place(place)),
        Direction::Points(name) => Some(At::Point(name)),
        Direction::Degrees(_) => None,
    },
}, generator => {
    "description": "The name of a point, or coordinates",
    "anyOf": [{ "type": "string" }, generator.subschema_for::<Vector>()]
});

several_forms!(Direction, "direction", OneOf {
    expecting: "two points as \"BE\", or a number of degrees, or [dx, dy]",
    from: Some,
}, generator => {
    "description": "Two points of the guide's carrier as \"BE\" or \"B-E\"; or degrees; or [dx, dy]",
    "anyOf": [{ "type": "string" }, { "type": "number" }, generator.subschema_for::<Vector>()]
});

write_forms! {
    Vector { Vector(vector) => vector }
    ShapePoint { ShapePoint(place) => place }
    NearValue { NearValue::Vector(place) => place, NearValue::Degrees(degrees) => degrees }
    At { At::Point(name) => name, At::Place(place) => place }
    Direction {
        Direction::Points(points) => points,
        Direction::Degrees(degrees) => degrees,
        Direction::Vector(vector) => vector,
    }
}
