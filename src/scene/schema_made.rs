//! JSON Schemas of files, made from the types that read or write them.

use schemars::generate::SchemaSettings;
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Value as Json, json};

/// The JSON Schema (draft 2020-12) of a kind of file; with a title for one that is read strictly.
pub(crate) fn schema_of<T: JsonSchema>(title: Option<&str>) -> Json {
    let mut schema = SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<T>();
    let Some(title) = title else {
        return schema.to_value();
    };
    RecursiveTransform(forbid_null).transform(&mut schema);
    RecursiveTransform(allow_note).transform(&mut schema);
    if let Some(properties) = schema.get_mut("properties").and_then(Json::as_object_mut) {
        let description = "Where an editor finds this schema; ignored";
        properties.insert("$schema".into(), json!({ "type": "string", "description": description }));
    }
    schema.insert("title".into(), title.into());
    schema.to_value()
}

/// The version of a format, in its schema.
pub(crate) fn version(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "const": 1 })
}

/// Forbids `null`: a key is left out in its place.
fn forbid_null(schema: &mut Schema) {
    let null = |value: &Json| *value == json!("null") || *value == json!({ "type": "null" });
    let Some(object) = schema.as_object_mut() else {
        return;
    };
    if let Some(types) = object.get_mut("type")
        && let Some([only, other]) = types.as_array().map(Vec::as_slice)
        && null(other)
    {
        *types = only.clone();
    }
    if let Some([only, other]) = object.get("anyOf").and_then(Json::as_array).map(Vec::as_slice)
        && null(other)
        && let Some(only) = only.as_object().cloned()
    {
        object.shift_remove("anyOf");
        for (key, value) in only {
            object.entry(key).or_insert(value);
        }
    }
}

/// Allows a `note` in every object.
fn allow_note(schema: &mut Schema) {
    if schema.get("type").and_then(Json::as_str) != Some("object") {
        return;
    }
    let properties = schema.ensure_object().entry("properties").or_insert_with(|| json!({}));
    if let Some(properties) = properties.as_object_mut() {
        properties.insert("note".into(), json!({ "description": "For people; ignored" }));
    }
}

/// Removes the defaults of keys that may be left out; their descriptions give them.
pub(super) fn without_defaults(schema: &mut Schema) {
    let properties = schema.get_mut("properties").and_then(Json::as_object_mut);
    for property in properties.into_iter().flat_map(|properties| properties.values_mut()) {
        property.as_object_mut().map(|property| property.shift_remove("default"));
    }
}
