//! JSON Schemas of files, as they are committed.

/// The JSON Schema of a kind of file: that of `templates/NAME.schema.json`. With the feature `schemas` it is made anew from the type that
/// reads the files or writes them: strictly read files have a title.
macro_rules! schema {
    ($name:literal, $type:ty $(, $title:literal)?) => {{
        #[cfg(not(feature = "schemas"))]
        let schema = {
            let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/templates/", $name, ".schema.json"));
            serde_json::from_str(text).expect("a committed schema is JSON")
        };
        #[cfg(feature = "schemas")]
        let schema = $crate::scene::schema_made::schema_of::<$type>(None$(.or(Some($title)))?);
        schema
    }};
}
pub(crate) use schema;
