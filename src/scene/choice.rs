//! Choices: enums whose values are single words in the file.

/// Makes an enum of such words, with one list for reading, schema and writing.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident { $($(#[$doc:meta])* $value:ident = $word:literal,)* }) => {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
        $(#[$about])*
        #[non_exhaustive]
        pub enum $name { $($(#[$doc])* #[serde(rename = $word)] $value,)* }

        super::write::write_forms! { $name { word => word.as_str() } }

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
