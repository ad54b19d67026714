use crate::refused::Refused;
use kinegon::editing::{Edit, Key, apply};
use kinegon::geometry::degrees_of;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::position::{Pose, counted_poses, with_nearest_sides};
use kinegon::scene::{Kind, SizeLimit};
use kinegon::words::Wording;
use kinegon::{format, posed};
use pyo3::prelude::*;
use serde_json::{Map, Value, json};

/// A scene that was read.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Scene {
    /// Its text.
    #[pyo3(get)]
    pub text: String,
    /// Whether the person has seen that text, so that lines and columns say something.
    pub is_seen: bool,
    pub scene: kinegon::Scene,
}

/// The text of the starting scene of a kind of mechanism.
#[pyfunction]
pub fn kind(name: &str) -> PyResult<String> {
    let found = Kind::named(name).map(|kind| kind.text);
    let nearest = || format!("the nearest is `{}`; kinegon.KINDS has all", Kind::nearest(name));
    found.ok_or_else(|| Refused::new("KinegonError", format!("there is no kind `{name}`"), Some(&nearest())).into())
}

impl Scene {
    pub fn read(text: String, is_seen: bool) -> Result<Scene, Refused> {
        let scene = kinegon::Scene::read(&text).map_err(|error| seen(is_seen, error))?;
        Ok(Scene { text, is_seen, scene })
    }

    /// An error of this scene.
    pub fn refused(&self, error: impl Into<Refused>) -> Refused {
        seen(self.is_seen, error)
    }

    /// The mechanism in its position.
    pub fn posed(&self, limit: SizeLimit, mode: Option<usize>) -> Result<(Mechanism, Pose), Refused> {
        posed(&self.scene, limit, mode).map_err(|error| self.refused(error))
    }

    /// The scene with these keys of its figure in place of its own; `null` takes one out.
    pub fn with_keys(&self, keys: &str) -> Result<Scene, Refused> {
        let keys = serde_json::from_str(keys).map_err(|error| Refused::new("KinegonError", error.to_string(), None));
        let keys: Map<String, Value> = keys?;
        let edit = |(key, value)| Edit::Set { set: vec![Key::from("figure"), Key::Name(key)], value };
        let edits: Vec<Edit> = keys.into_iter().map(edit).collect();
        let text = apply(&self.text, &edits).map_err(|error| Refused::from(error).without_place())?;
        Scene::read(text, false)
    }
}

fn seen(is_seen: bool, error: impl Into<Refused>) -> Refused {
    error.into().seen(is_seen)
}

impl Scene {
    /// The text of `kinegon modes`, and the modes as JSON.
    pub fn all_modes(&self) -> Result<(String, String), Refused> {
        let made = mechanism(&self.scene).map_err(|error| self.refused(error))?;
        let mechanism = with_nearest_sides(&self.scene, made);
        let listed = counted_poses(&mechanism, &self.scene.near).map_err(|error| self.refused(error))?;
        let own = kinegon::position::pose(&mechanism, &self.scene.near).ok();
        let words = Wording::of(&self.scene.figure);
        let modes = listed.poses.iter().zip(1..).map(|(pose, number): (&Pose, usize)| {
            let sought = mechanism.for_positions();
            let point = |p| (sought.point_name(p).to_owned(), json!([pose.point(p).x, pose.point(p).y]));
            let points: Map<String, Value> = sought.inner_points().into_iter().map(point).collect();
            let angle = |(id, body): (kinegon::mechanism::BodyId, &kinegon::mechanism::Body)| {
                let axis = pose.axes[id.0].filter(|_| sought.is_sought(id))?;
                Some((body.name.clone(), json!(degrees_of(axis))))
            };
            let angles: Map<String, Value> = sought.links().filter_map(angle).collect();
            let is_own = own.as_ref().is_some_and(|own| own.is_same_as(pose));
            let text = format::mode(&mechanism, pose, &words).join("\n");
            json!({ "number": number, "points": points, "angles": angles, "is_own": is_own, "text": text })
        });
        let modes: Vec<Value> = modes.collect();
        Ok((format::listed_modes(&self.scene, &mechanism, &listed), json!(modes).to_string()))
    }
}
