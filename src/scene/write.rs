//! The text of a file that is built in Rust, in a readable layout: a line for each link, slider and known motion.
//!
//! Nothing is checked here: a name given twice and a number that is not finite are written, and refused when the text
//! is parsed.

use indexmap::IndexMap;

use super::error::number;
use crate::text::Untrusted;

/// A value of the file; `Nothing` for a key that is left out.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Written {
    Nothing,
    /// A string in quotes, a number or a boolean.
    Bare(String),
    List(Vec<Written>),
    Object(Vec<(String, Written)>),
}

/// A value that can be written to a file.
pub(super) trait Write {
    fn written(&self) -> Written;

    /// What an object has of it under `key`; scales have keys of their own.
    fn entries(&self, key: &str) -> Vec<(String, Written)> {
        vec![(key.to_owned(), self.written())]
    }
}

/// The text of a file.
pub(super) fn text_of(file: &impl Write) -> String {
    laid_out(&file.written(), 0) + "\n"
}

/// The text of a value that is `depth` levels below the top.
fn laid_out(value: &Written, depth: usize) -> String {
    let is_object = |value: &Written| matches!(value, Written::Object(_));
    // Keys of the top have a line each, and so have the objects in their values.
    let (open, close, parts, in_lines): (_, _, Vec<String>, _) = match value {
        Written::Nothing => return String::new(),
        Written::Bare(text) => return text.clone(),
        Written::List(values) => {
            let parts = values.iter().map(|value| laid_out(value, depth + 1));
            ("[", "]", parts.collect(), depth == 1 && values.iter().any(is_object))
        }
        Written::Object(entries) => {
            let given = entries.iter().filter(|(_, value)| *value != Written::Nothing);
            let parts = given.map(|(key, value)| format!("{}: {}", quoted(key), laid_out(value, depth + 1)));
            let has_objects = depth == 1 && entries.iter().any(|(_, value)| is_object(value));
            ("{", "}", parts.collect(), depth == 0 || has_objects)
        }
    };
    let line = format!("\n{}", "  ".repeat(depth));
    match (in_lines, open) {
        (true, _) => format!("{open}{line}  {}{line}{close}", parts.join(&format!(",{line}  "))),
        (false, "[") => format!("[{}]", parts.join(", ")),
        (false, _) => format!("{{ {} }}", parts.join(", ")),
    }
}

impl Write for Untrusted {
    fn written(&self) -> Written {
        Written::Bare(serde_json::json!(self).to_string())
    }
}

/// The text in double quotes, with the escapes of JSON.
pub(crate) fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// Writes a type as an object with these keys in this order; after the first, keys with the value of `unless` are left
/// out. A field that is missing in the list does not compile.
macro_rules! write_keys {
    ($part:ident { $($key:ident),* $(; $($hidden:ident),*)? } $(unless $standard:expr)?) => {
        impl crate::scene::write::Write for $part {
            fn written(&self) -> crate::scene::write::Written {
                let entries = |part: &$part| {
                    let $part { $($key,)* $($($hidden: _),*)? } = part;
                    [$(crate::scene::write::Write::entries($key, stringify!($key))),*].into_iter().flatten().collect::<Vec<_>>()
                };
                crate::scene::write::Written::Object(entries(self))$(.without(&entries(&$standard)))?
            }
        }
    };
}

/// Writes a type of several forms as the value of its form.
macro_rules! write_forms {
    ($($type:ty { $($form:pat => $value:expr),* $(,)? })*) => { $(
        impl crate::scene::write::Write for $type {
            fn written(&self) -> crate::scene::write::Written {
                match self { $($form => crate::scene::write::Write::written($value)),* }
            }
        }
    )* };
}
pub(super) use {write_forms, write_keys};

impl Written {
    /// An object without the entries after its first that `standard` has, too.
    pub fn without(self, standard: &[(String, Written)]) -> Written {
        let Written::Object(mut entries) = self else { return self };
        let rest = entries.split_off(1).into_iter().filter(|entry| !standard.contains(entry));
        entries.extend(rest);
        Written::Object(entries)
    }
}

impl Write for str {
    fn written(&self) -> Written {
        Written::Bare(quoted(self))
    }
}

impl Write for bool {
    fn written(&self) -> Written {
        Written::Bare(self.to_string())
    }
}

impl Write for f64 {
    fn written(&self) -> Written {
        // A negative zero is written with a decimal, as `-0` would be read as a whole number.
        let negative_zero = *self == 0.0 && self.is_sign_negative();
        Written::Bare(if negative_zero { "-0.0".into() } else { number(*self) })
    }
}

write_forms! {
    String { text => text.as_str() }
    u64 { number => &(*number as f64) }
    usize { number => &(*number as f64) }
    [f64; 2] { numbers => &numbers.to_vec() }
}

impl<T: Write> Write for Option<T> {
    fn written(&self) -> Written {
        self.as_ref().map_or(Written::Nothing, T::written)
    }
}

impl<T: Write> Write for Vec<T> {
    fn written(&self) -> Written {
        Written::List(self.iter().map(T::written).collect())
    }
}

impl<T: Write> Write for IndexMap<String, T> {
    fn written(&self) -> Written {
        Written::Object(self.iter().map(|(name, value)| (name.clone(), value.written())).collect())
    }
}
