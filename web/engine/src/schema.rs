use crate::answers::{Drawn, Mode, Opened, Picture, Place, ValueRow, View};
use crate::checks::{CheckOptions, Checked};
use crate::exercises::{Exercise, ExerciseOptions};
use crate::files::{FileRequest, OverCycle};
use crate::forms::Form;
use crate::gesture::{Grab, To};
use crate::kinds::Kind;
use crate::photo_answers::{PhotoRead, PlacedPoint, PointVerdict, Proposed, Tapped};
use crate::refused::Refused;
use kinegon::editing::Edit;
use schemars::generate::SchemaSettings;
use serde_json::{Value, json};

/// The JSON Schema of all that goes into the engine and comes out of it, by the names of the page's types.
#[must_use]
pub fn schema() -> Value {
    let mut types = SchemaSettings::draft07().for_serialize().into_generator();
    macro_rules! add {
        ($($type:ty),*) => { $(types.subschema_for::<$type>();)* };
    }
    add!(Refused, Kind, Opened, View, Picture, Grab, To, Edit, Place, Mode, FileRequest, OverCycle, Drawn, ValueRow);
    add!(Form, Checked, CheckOptions, Exercise, ExerciseOptions);
    add!(PhotoRead, Tapped, PlacedPoint, PointVerdict, Proposed);
    json!({ "title": "Engine", "definitions": types.take_definitions(true) })
}
