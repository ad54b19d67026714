//! In: a tree of JSON. Out: the typed values that serde makes of it, or why not: which key, word or value is wrong, with
//! its path, as facts that no one has to read out of a sentence.

use std::fmt::Display;

use crate::sheet::Scales;
use serde::de::value::{MapAccessDeserializer, StrDeserializer};
use serde::de::{self, DeserializeSeed, Deserializer, Expected, IntoDeserializer, Unexpected, Visitor};
use serde_json::{Map, Value as Json};

/// What a place or a direction expects of a list.
pub(super) const TWO_NUMBERS: &str = "two numbers [x, y]";

/// Why a tree is not of a type.
#[derive(Debug, thiserror::Error)]
#[error("{why:?}")]
pub(super) struct Refusal {
    /// The keys and indices that lead to the place, the last one first.
    pub path: Vec<String>,
    pub why: Why,
}

/// What is wrong at a place.
#[derive(Debug)]
pub(super) enum Why {
    /// The last key of the path is none of these.
    UnknownKey(&'static [&'static str]),
    /// The value is this word, which is none of these.
    UnknownWord(String, &'static [&'static str]),
    /// The object lacks this key.
    Missing(&'static str),
    /// The value is something else than this, which stands after "expected" in a sentence.
    Type(String),
    /// The value is a list of so many in place of two numbers.
    Length(usize),
    /// What the type itself says.
    Said(String),
}

impl Refusal {
    fn inside(mut self, part: impl Into<String>) -> Refusal {
        self.path.push(part.into());
        self
    }
}

impl From<Why> for Refusal {
    fn from(why: Why) -> Refusal {
        Refusal { path: Vec::new(), why }
    }
}

impl de::Error for Refusal {
    fn custom<T: Display>(message: T) -> Refusal {
        Why::Said(message.to_string()).into()
    }

    fn invalid_length(found: usize, expected: &dyn Expected) -> Refusal {
        match expected.to_string() {
            expected if expected == TWO_NUMBERS => Why::Length(found).into(),
            expected => Why::Type(expected).into(),
        }
    }

    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Refusal {
        Why::Type(expected.to_string()).into()
    }

    fn invalid_value(_: Unexpected<'_>, expected: &dyn Expected) -> Refusal {
        Why::Type(expected.to_string()).into()
    }

    fn unknown_field(_: &str, names: &'static [&'static str]) -> Refusal {
        Why::UnknownKey(names).into()
    }

    fn unknown_variant(word: &str, names: &'static [&'static str]) -> Refusal {
        Why::UnknownWord(word.to_owned(), names).into()
    }

    fn missing_field(key: &'static str) -> Refusal {
        Why::Missing(key).into()
    }
}

/// A value that serde reads.
#[derive(Clone, Copy)]
pub(super) struct Reader<'a>(pub &'a Json);

/// Refuses what is not of a plain type, in the words of a scene, before the type is asked; a type that says itself what it
/// expects asks for any value.
macro_rules! plain_types {
    ($($read:ident: $allowed:pat $(if $condition:expr)? => $expected:literal,)*) => { $(
        fn $read<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
            match self.0 {
                $allowed $(if $condition)? => self.deserialize_any(visitor),
                _ => Err(Why::Type($expected.to_owned()).into()),
            }
        }
    )* };
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = Refusal;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        match self.0 {
            Json::Null => visitor.visit_unit(),
            Json::Bool(truth) => visitor.visit_bool(*truth),
            Json::Number(number) => match (number.as_u64(), number.as_i64()) {
                (Some(whole), _) => visitor.visit_u64(whole),
                (None, Some(whole)) => visitor.visit_i64(whole),
                (None, None) => visitor.visit_f64(number.as_f64().unwrap_or(f64::NAN)),
            },
            Json::String(text) => visitor.visit_borrowed_str(text),
            Json::Array(elements) => visitor.visit_seq(Elements(elements.iter().enumerate())),
            Json::Object(entries) => visitor.visit_map(Entries::new(pairs(entries))),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        match self.0 {
            Json::Object(entries) if fields.contains(&Scales::FIELD) => {
                if entries.contains_key(Scales::FIELD) {
                    return Err(Refusal::from(Why::UnknownKey(fields)).inside(Scales::FIELD));
                }
                // The first scale stands for all of them: their field gets the whole object.
                let mut scales = Some((Scales::FIELD, self.0));
                let entries = pairs(entries).filter_map(move |(key, value)| match Scales::is_key(key) {
                    true => scales.take(),
                    false => Some((key, value)),
                });
                visitor.visit_map(Entries::new(entries))
            }
            // What is made of an object is not made of a list of its values.
            Json::Array(_) => Err(Why::Type((&visitor as &dyn Expected).to_string()).into()),
            _ => self.deserialize_any(visitor),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &str, visitor: V) -> Result<V::Value, Refusal> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        match self.0 {
            Json::String(word) => visitor.visit_enum(word.as_str().into_deserializer()),
            _ => Err(Why::Type("a text in double quotes".to_owned()).into()),
        }
    }

    plain_types! {
        deserialize_bool: Json::Bool(_) => "true or false",
        deserialize_u16: Json::Number(number) if number.as_u64().is_some_and(|n| u16::try_from(n).is_ok())
            => "a whole number from 1 to 65535",
        deserialize_f64: Json::Number(_) => "a number",
        deserialize_str: Json::String(_) => "a text in double quotes",
        deserialize_string: Json::String(_) => "a text in double quotes",
        deserialize_seq: Json::Array(_) => "a list [ … ]",
        deserialize_map: Json::Object(_) => "an object { … }",
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u32 u64 u128 f32 char bytes byte_buf unit unit_struct tuple tuple_struct identifier
        ignored_any
    }
}

/// The elements of a list that are not read yet.
struct Elements<'a>(std::iter::Enumerate<std::slice::Iter<'a, Json>>);

impl<'de> de::SeqAccess<'de> for Elements<'de> {
    type Error = Refusal;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Refusal> {
        let next = self
            .0
            .next()
            .map(|(index, value)| seed.deserialize(Reader(value)).map_err(|refusal| refusal.inside(index.to_string())));
        next.transpose()
    }
}

/// The entries of an object that are not read yet.
struct Entries<'a> {
    entries: Box<dyn Iterator<Item = (&'a str, &'a Json)> + 'a>,
    /// The entry whose key is read.
    present: Option<(&'a str, &'a Json)>,
}

impl<'a> Entries<'a> {
    fn new(entries: impl Iterator<Item = (&'a str, &'a Json)> + 'a) -> Entries<'a> {
        Entries { entries: Box::new(entries), present: None }
    }
}

impl<'de> de::MapAccess<'de> for Entries<'de> {
    type Error = Refusal;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Refusal> {
        self.present = self.entries.next();
        let read = self.present.map(|(key, _)| {
            let name: StrDeserializer<'_, Refusal> = key.into_deserializer();
            seed.deserialize(name).map_err(|Refusal { path, why }| match why {
                // A key from a list of words.
                Why::UnknownWord(_, names) => Refusal { path, why: Why::UnknownKey(names) }.inside(key),
                why => Refusal { path, why }.inside(key),
            })
        });
        read.transpose()
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Refusal> {
        match self.present {
            Some((Scales::FIELD, Json::Object(all))) => {
                let scales = pairs(all).filter(|(key, _)| Scales::is_key(key));
                seed.deserialize(MapAccessDeserializer::new(Entries::new(scales)))
            }
            Some((key, value)) => seed.deserialize(Reader(value)).map_err(|refusal| refusal.inside(key)),
            None => Err(Why::Said("a value without a key".to_owned()).into()),
        }
    }
}

/// The entries of an object.
fn pairs(object: &Map<String, Json>) -> impl Iterator<Item = (&str, &Json)> {
    object.iter().map(|(key, value)| (key.as_str(), value))
}
