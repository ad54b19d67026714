use crate::answers::{Drive, Picture, View};
use crate::desk::{Desk, Staged};
use crate::refused::Refused;
use kinegon::cycle::{self, OtherModes, Pull};
use kinegon::drawing::Point;
use kinegon::editing::{Pins, Reshape, says, with_position};
use kinegon::mechanism::PointId;
use kinegon::position::Pose;
use kinegon::scene::LanguageName;
use kinegon::text::Untrusted;
use kinegon::words::Language;
use kinegon::{Solution, geometry};
use serde::Deserialize;

/// What is taken hold of.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Grab {
    /// A joint, to move the mechanism: the first drive that moves it follows.
    Move {
        /// The joint.
        point: String,
    },
    /// A drive.
    Drive {
        /// The drive.
        drive: String,
    },
    /// All drives that have a speed in the scene, which run as time moves them: `Running` says which of them is pulled.
    Run {
        /// The drive that is pulled.
        drive: String,
    },
    /// A joint, to change lengths (or the place of a fixed point); pinned joints stay, pinned lengths keep their values.
    Shape {
        /// The joint.
        point: String,
        /// What stays.
        pins: Pins,
    },
}

/// Where to.
#[derive(Clone, Copy, Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "Pull"))]
#[serde(untagged)]
pub enum To {
    /// A place on the sheet.
    Place {
        /// In mm.
        to: [f64; 2],
    },
    /// A value of the drive.
    Value {
        /// In degrees or units of length.
        value: f64,
    },
}

/// Something that is held and pulled. Its sheet keeps layout and scales.
pub struct Gesture {
    text: String,
    view: View,
    staged: Staged,
    drives: Vec<Drive>,
    hold: Hold,
    /// The last position.
    now: Solution,
}

enum Hold {
    /// `moved` are the drives that it moves.
    Drive {
        pull: Box<Pull>,
        moved: Vec<cycle::Drive>,
        point: Option<PointId>,
        pose: Pose,
    },
    Shape {
        reshape: Box<Reshape>,
        text: String,
    },
}

impl Desk {
    /// Takes hold of something: the gesture, and the picture that it begins with.
    pub fn grab(&mut self, text: &str, view: &View, what: &Grab) -> Result<(Gesture, Picture), Refused> {
        let kept = self.kept(text)?;
        let drives = kept.drives()?;
        let own = kept.figure()?;
        let point_of = |name: &str| {
            let message = || Refused::whole(says::no_point(Untrusted::from(name).for_message()));
            own.mechanism.point(name).ok_or_else(message)
        };
        let refused = |error: cycle::CycleError| Refused::of(text, error);
        let hold = match what {
            Grab::Move { point } => {
                let point = point_of(point)?;
                Hold::drive(Pull::of_point(own, point).map_err(refused)?, Some(point), own)
            }
            Grab::Drive { drive } => Hold::drive(Pull::new(own, Some(drive)).map_err(refused)?, None, own),
            Grab::Run { drive } => {
                let pull = Pull::together(own, Some(drive)).map_err(refused)?;
                let names = own.mechanism.drive_names();
                let moved = names.iter().map(|name| cycle::Drive::new(&own.mechanism, Some(name)));
                let moved = moved.collect::<Result<_, _>>().map_err(refused)?;
                Hold::Drive { pull: Box::new(pull), moved, point: None, pose: own.pose.clone() }
            }
            Grab::Shape { point, pins } => {
                let reshape = Reshape::new(text, point, pins).map_err(|error| Refused::of(text, error))?;
                Hold::Shape { reshape: Box::new(reshape), text: text.to_owned() }
            }
        };
        let staged = kept.take_stage(view)?;
        let now = staged.own.clone();
        let picture = staged.picture(&staged.own, staged.modes.as_ref(), view, drives.clone());
        Ok((Gesture { text: text.to_owned(), view: view.clone(), staged, drives, hold, now }, picture))
    }
}

/// Why nothing can be pulled or let go.
pub fn nothing_held() -> Refused {
    Refused::whole("nothing is held")
}

impl Hold {
    fn drive(pull: Pull, point: Option<PointId>, own: &Solution) -> Hold {
        Hold::Drive { moved: vec![pull.drive().clone()], pull: Box::new(pull), point, pose: own.pose.clone() }
    }
}

impl Gesture {
    /// Lets go: the scene's text after the gesture. Its layout stays on the desk.
    pub fn let_go(self, desk: &mut Desk) -> Result<String, Refused> {
        let Gesture { text: before, view, staged, hold, .. } = self;
        let (text, is_moved) = match hold {
            Hold::Drive { pull, pose, .. } if pull.value() != pull.start() => {
                (with_position(&before, &pose).map_err(|error| Refused::of(&before, error))?, true)
            }
            Hold::Drive { .. } => (before.clone(), true),
            Hold::Shape { text, .. } => (text, false),
        };
        desk.hold(view, staged.stage, is_moved.then(|| [before, text.clone()]));
        Ok(text)
    }

    /// Pulls what is held.
    pub fn pull(&mut self, to: To, language: Option<LanguageName>) -> Result<Picture, Refused> {
        let mut words = self.now.wording();
        words.language = language.map_or(words.language, Language::of);
        let place = match to {
            To::Place { to: [x, y] } => self.staged.stage.place(Point::new(x, y)),
            To::Value { .. } => None,
        };
        let notes = match &mut self.hold {
            Hold::Drive { pull, moved: drives, point, pose } => {
                let pulled = match (to, *point, place) {
                    (To::Value { value }, ..) => pull.to_value(value),
                    (_, Some(point), Some(place)) => pull.to_place(point, place),
                    _ => return Err(Refused::whole("a drive goes to a value, a joint to a place")),
                };
                let place = |at| format!("{} = {}", pull.drive().quantity, pull.drive().shown(at, &words));
                let limit = pulled.limit.map(|end| end.text(&place(end.at), &words));
                let moved = self.staged.own.moved(pulled.pose.clone());
                for moved in drives {
                    if let Some(drive) = self.drives.iter_mut().find(|drive| drive.name == moved.name) {
                        drive.stands_at(pull.value_of(moved), moved, &words);
                    }
                }
                *pose = pulled.pose;
                let singular = moved
                    .map(|moved| self.now = moved)
                    .err()
                    .map(|error| words.language.says(&error.problem().message));
                // On paper a layout is that of the file, and stays.
                if self.view.pane.is_some() {
                    self.staged.stage.in_motion(&self.now);
                }
                limit.into_iter().chain(singular).collect()
            }
            Hold::Shape { reshape, text } => {
                let place: geometry::Point = place.ok_or_else(|| Refused::whole("a joint goes to a place"))?;
                match reshape.to([place.x, place.y]) {
                    Ok(shape) => {
                        let mut scene = shape.scene;
                        scene.figure = self.staged.own.scene.figure.clone();
                        match Solution::new(scene, shape.mechanism, shape.pose, self.now.motion.order) {
                            Ok(now) => {
                                (self.now, *text) = (now, shape.text);
                                shape.note.iter().map(|note| words.language.says(note)).collect()
                            }
                            Err(error) => vec![words.language.says(&error.problem().message)],
                        }
                    }
                    Err(error) => vec![words.language.says(&error.message)],
                }
            }
        };
        Ok(self.picture(notes))
    }

    /// The picture of the last position; `notes` come first.
    fn picture(&mut self, notes: Vec<String>) -> Picture {
        let modes = if self.view.modes { OtherModes::of(&self.now).ok() } else { None };
        let drawing = self.staged.stage.drag(&self.now, modes.as_ref(), self.view.step);
        let mut picture = self.staged.picture_of(&drawing, &self.now, self.drives.clone());
        picture.notes.splice(0..0, notes);
        picture
    }
}
