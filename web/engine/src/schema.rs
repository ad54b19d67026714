use crate::answers::{Opened, Picture, Running, ValueRow, View};
use crate::board::{BoardJudged, BoardPictureAsk};
use crate::building::{Drafted, DraftedView};
use crate::checks::{CheckOptions, Checked, SheetPicture};
use crate::exercises::{Exercise, ExerciseOptions};
use crate::files::{Drawn, FileRequest, OverCycle};
use crate::forms::Form;
use crate::gesture::{Grab, To};
use crate::kinds::Kind;
use crate::modes::{Mode, Place};
use crate::photo_answers::{PhotoRead, PlacedPoint, PointVerdict, Proposed, Tapped};
use crate::refused::Told;
use kinegon::board::{Board, BoardHint, Pressed, Snapped};
use kinegon::editing::Edit;
use kinegon::{Order, Scene, Sheet};
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The JSON Schema of all that goes into the engine and comes out of it, by the names of the page's types.
#[must_use]
pub fn schema() -> Value {
    let mut types = SchemaSettings::draft07().for_serialize().into_generator();
    macro_rules! add {
        ($($type:ty),*) => { $(types.subschema_for::<$type>();)* };
    }
    add!(
        Told,
        Kind,
        Opened,
        View,
        Picture,
        Running,
        Grab,
        To,
        Edit,
        Place,
        Mode,
        FileRequest,
        OverCycle,
        Drawn,
        ValueRow
    );
    add!(Drafted, DraftedView);
    add!(Board, Pressed, Snapped, SheetPicture, BoardPictureAsk, BoardJudged, BoardHint);
    add!(Form, Checked, CheckOptions, Exercise, ExerciseOptions);
    add!(PhotoRead, Tapped, PlacedPoint, PointVerdict, Proposed);
    let mut definitions = types.take_definitions(true);
    definitions.extend(scene_types());
    json!({ "title": "Engine", "definitions": definitions, "sheets": Sheet::ALL.map(facts) })
}

/// What the page is told of a sheet, as a value in place of a type.
fn facts(sheet: Sheet) -> Value {
    let (is_plan, vector) = (sheet.order().is_some(), sheet.order().map_or("", Order::vector));
    let is_usual = Sheet::USUAL.contains(&sheet);
    json!({
        "key": sheet,
        "scale": sheet.facts().scale_key,
        "isPlan": is_plan,
        "hasPlaces": sheet.has_places(),
        "isUsual": is_usual,
        "vector": vector
    })
}

/// The types of scene files, from their own schema: `SceneFile`, and its parts by their names there behind `Scene`.
fn scene_types() -> Map<String, Value> {
    const OTHER: &str = "#/$defs/";
    let name = |part: &str| format!("Scene{}{}", part[..1].to_uppercase(), &part[1..]);
    let mut file = Scene::schema();
    let parts = file.as_object_mut().and_then(|file| file.remove("$defs"));
    let mut all = Map::from_iter([("SceneFile".to_owned(), file)]);
    all.extend(parts.iter().filter_map(Value::as_object).flatten().map(|(part, schema)| (name(part), schema.clone())));
    fn renamed(value: &mut Value, name: &dyn Fn(&str) -> String) {
        match value {
            Value::Object(object) => {
                // Only the file as a whole has these as texts.
                object.retain(|key, value| !(matches!(key.as_str(), "title" | "$schema") && value.is_string()));
                // Remarks stand among entries that have a type; the page passes over them.
                if let Some(Value::Object(properties)) = object.get_mut("properties") {
                    properties.shift_remove("note");
                }
                if let Some(Value::String(target)) = object.shift_remove("$ref") {
                    let part = target.strip_prefix(OTHER).unwrap_or(&target);
                    // Beside other words the tool takes a reference for a type of its own.
                    object.insert("allOf".to_owned(), json!([{ "$ref": format!("#/definitions/{}", name(part)) }]));
                    return;
                }
                object.values_mut().for_each(|value| renamed(value, name));
            }
            Value::Array(list) => list.iter_mut().for_each(|value| renamed(value, name)),
            _ => {}
        }
    }
    all.values_mut().for_each(|schema| renamed(schema, &name));
    all
}
