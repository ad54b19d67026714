//! What errors and warnings say, as data: which sentence, and what stands in its blanks. Each folder declares its sentences in a
//! file `says.rs`; `words/*.ftl` have their words in each language under the same keys, and
//! [`Language::says`](crate::words::Language::says) puts them together. So nobody has to know a message by its words.

use crate::fluent::{Catalogue, english};
use std::fmt;

/// The declaration of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Its key in the catalogues.
    pub key: &'static str,
    /// The names of its blanks, in the order of what fills them.
    pub blanks: &'static [&'static str],
}

/// What an error or a warning says. Displayed in English.
///
/// ```
/// use kinegon::scene::LanguageName;
/// use kinegon::words::Language;
///
/// let error = kinegon::Scene::read(r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "links": {} }"#).unwrap_err();
/// assert_eq!(error.message.to_string(), "a mechanism has at least one link");
/// assert_eq!(Language::of(LanguageName::Spanish).says(&error.message), "un mecanismo tiene al menos un eslabón");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message(Box<Said>);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Said {
    /// A declared sentence, with what fills its blanks.
    Sentence(&'static Declared, Vec<Message>),
    /// Several, one after the other, with this between them.
    List(Vec<Message>, &'static str),
    /// A name, a number, a piece of JSON: the same in all languages.
    Text(String),
}

impl Message {
    /// A declared sentence; `says.rs` of each folder calls this.
    #[must_use]
    pub fn of(declared: &'static Declared, by: Vec<Message>) -> Message {
        Message(Box::new(Said::Sentence(declared, by)))
    }

    /// Several messages one after the other, with `between` between them.
    #[must_use]
    pub fn list(messages: impl IntoIterator<Item = Message>, between: &'static str) -> Message {
        Message(Box::new(Said::List(messages.into_iter().collect(), between)))
    }

    /// The words of `catalogue`, in English what it lacks.
    pub(crate) fn told(&self, catalogue: &Catalogue) -> String {
        match &*self.0 {
            Said::Text(text) => text.clone(),
            Said::List(all, between) => {
                all.iter().map(|message| message.told(catalogue)).collect::<Vec<_>>().join(between)
            }
            Said::Sentence(Declared { key, blanks }, by) => {
                let by: Vec<String> = by.iter().map(|message| message.told(catalogue)).collect();
                let by: Vec<&str> = by.iter().map(String::as_str).collect();
                let sentence = catalogue.sentence(key).or_else(|| english().sentence(key));
                sentence.map_or_else(|| (*key).to_owned(), |sentence| catalogue.filled(sentence, blanks, &by))
            }
        }
    }

    /// The declaration of its sentence; `None` for a name, a number or several sentences.
    #[must_use]
    pub fn declared(&self) -> Option<&'static Declared> {
        match *self.0 {
            Said::Sentence(declared, _) => Some(declared),
            _ => None,
        }
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(english()))
    }
}

impl PartialEq<str> for Message {
    fn eq(&self, other: &str) -> bool {
        self.told(english()) == other
    }
}

impl PartialEq<&str> for Message {
    fn eq(&self, other: &&str) -> bool {
        self.told(english()) == *other
    }
}

impl From<&Message> for Message {
    fn from(message: &Message) -> Message {
        message.clone()
    }
}

impl From<String> for Message {
    fn from(text: String) -> Message {
        Message(Box::new(Said::Text(text)))
    }
}

/// From what is written the same in all languages.
macro_rules! from_written {
    ($($written:ty),+) => { $(
        impl From<$written> for Message {
            fn from(written: $written) -> Message {
                Message(Box::new(Said::Text(written.to_string())))
            }
        }
    )+ };
}
from_written!(&str, &String, usize, u64, i64, f64);

/// Declares the sentences of a folder's errors and warnings, and a function for each: `no_link(name);`
/// gives `no_link(name) -> Message`. The word before them begins their keys in the catalogues, as `scene-no_link`.
macro_rules! messages {
    ($group:literal: $($(#[$about:meta])* $key:ident $(($($blank:ident),+))?;)+) => {
        /// Index of each sentence in [`DECLARED`].
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// All sentences.
        pub static DECLARED: &[$crate::message::Declared] = &[$($crate::message::Declared {
            key: concat!($group, "-", stringify!($key)),
            blanks: &[$($(stringify!($blank)),+)?],
        }),+];

        $(
            $(#[$about])*
            #[doc = concat!("`", $group, "-", stringify!($key), "` of the catalogues.")]
            #[must_use]
            pub fn $key($($($blank: impl Into<$crate::message::Message>),+)?) -> $crate::message::Message {
                $crate::message::Message::of(&DECLARED[Key::$key as usize], vec![$($($blank.into()),+)?])
            }
        )+
    };
}
pub(crate) use messages;
