//! Builds a scene in Rust: fills the types of the scene file key by key.

use super::build_parts::{Guide, NewLink};
use super::error::{SceneError, Source, Wrong};
use super::figure::Figure;
use super::given::PointMotion;
use super::joint::SliderFile;
use super::link::LinkFile;
use super::points::Ground;
use super::read::{Scene, SceneFile};
use super::text::FileKind;
use super::units::{LengthUnit, TimeUnit, Units};
use super::value::{Entries, NearValue, Vector};
use super::{text, write};

/// Builds a scene in Rust.
///
/// Each method sets the key of the same name of a scene file, and [`Builder::build`] checks the scene as if it were
/// read from that file, with the same messages.
///
/// ```
/// use kinegon::scene::{Builder, Guide, LengthUnit, NewLink, TimeUnit, Turn};
///
/// let builder = Builder::new(LengthUnit::Mm, TimeUnit::S)
///     .title("Offset slider-crank")
///     .ground("A", [0.0, 0.0])
///     .link("1", NewLink::points(["A", "B"]).length("AB", 50.0).drive(Turn::omega(10.0).angle(60.0)))
///     .link("2", NewLink::points(["B", "C"]).length("BC", 150.0))
///     .link("3", NewLink::points(["C"]))
///     .slider("3", "C", Guide::on("ground").through([0.0, -20.0]).along(0.0))
///     .near("C", [160.0, -20.0]);
/// let scene = builder.build()?;
/// assert_eq!(scene.links["2"].points, ["B", "C"]);
/// assert_eq!(builder.text(), r#"{
///   "kinegon": 1,
///   "title": "Offset slider-crank",
///   "units": { "length": "mm", "time": "s" },
///   "ground": { "A": [0, 0] },
///   "links": {
///     "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "omega": 10, "angle": 60 } },
///     "2": { "points": ["B", "C"], "lengths": { "BC": 150 } },
///     "3": { "points": ["C"] }
///   },
///   "sliders": [
///     { "link": "3", "at": "C", "on": "ground", "through": [0, -20], "along": 0 }
///   ],
///   "near": { "C": [160, -20] }
/// }
/// "#);
/// # Ok::<(), kinegon::scene::SceneError>(())
/// ```
#[derive(Debug, Clone)]
#[must_use]
pub struct Builder {
    file: SceneFile,
    /// The first key that was set twice.
    wrong: Option<Wrong>,
}

impl Builder {
    /// An empty scene in these units.
    pub fn new(length: LengthUnit, time: TimeUnit) -> Builder {
        Builder { file: SceneFile::new(Units { length, time }), wrong: None }
    }

    /// Gives the scene a title.
    pub fn title(mut self, title: &str) -> Builder {
        self.file.title = Some(title.into());
        self
    }

    /// Adds a point of the frame, with its coordinates in the fixed frame.
    pub fn ground(mut self, point: &str, place: [f64; 2]) -> Builder {
        if let Ground::Places(places) = self.file.ground.get_or_insert(Ground::Places(Entries::default())) {
            places.add(point, Vector(place));
        }
        self
    }

    /// Adds the coordinates of a moving point in the fixed frame. The scene is then a drawn configuration: every point
    /// has coordinates, and there are no lengths, shapes, angles or approximate places.
    pub fn point(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.file.points.get_or_insert_default().add(point, Vector(place));
        self
    }

    /// Gives the motion of a point, in a drawn configuration; [`polar`](super::polar) makes vectors of size and angle.
    pub fn known(mut self, point: &str, motion: PointMotion) -> Builder {
        self.file.known.get_or_insert_default().add(point, motion);
        self
    }

    /// Adds a link.
    pub fn link(mut self, name: &str, link: NewLink) -> Builder {
        self.file.links.add(name, LinkFile(link.0.file));
        self.wrong = self.wrong.or(link.0.wrong.map(|wrong| wrong.inside(&["links", name])));
        self
    }

    /// Lets a link slide on a guide by its point `at`.
    pub fn slider(self, link: &str, at: &str, guide: Guide) -> Builder {
        self.sliding(guide, |slider| SliderFile { link: Some(link.to_owned()), at: Some(at.to_owned()), ..slider })
    }

    /// Lets a pin, a point of another link, ride in a slot without a block.
    pub fn pin(self, pin: &str, slot: Guide) -> Builder {
        self.sliding(slot, |slider| SliderFile { pin: Some(pin.to_owned()), ..slider })
    }

    fn sliding(mut self, guide: Guide, set: impl Fn(SliderFile) -> SliderFile) -> Builder {
        let sliders = self.file.sliders.get_or_insert_default();
        let index = sliders.len().to_string();
        sliders.push(set(guide.0.file));
        self.wrong = self.wrong.or(guide.0.wrong.map(|wrong| wrong.inside(&["sliders", &index])));
        self
    }

    /// Gives the approximate place of a point in the fixed frame, to choose the assembly mode.
    pub fn near(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.file.near.get_or_insert_default().add(point, NearValue::Vector(place));
        self
    }

    /// Gives the approximate angle of a link's axis from +x, in degrees, to choose the assembly mode.
    pub fn near_angle(mut self, link: &str, degrees: f64) -> Builder {
        self.file.near.get_or_insert_default().add(&format!("angle({link})"), NearValue::Degrees(degrees));
        self
    }

    /// Sets what the figure shows, and its scales. Without it the figure has all three panels on A4.
    pub fn figure(mut self, figure: Figure) -> Builder {
        self.file.figure = Some(figure);
        self
    }

    /// Names the quantities that are asked for, as `"omega(2)"`. Without it all are computed.
    pub fn want<'a>(mut self, names: impl IntoIterator<Item = &'a str>) -> Builder {
        self.file.want = Some(names.into_iter().map(str::to_owned).collect());
        self
    }

    /// The checked scene.
    ///
    /// # Errors
    /// The first error, as [`Scene::read`] gives it; its place is in [`Builder::text`].
    pub fn build(&self) -> Result<Scene, SceneError> {
        let text = self.text();
        // A builder can be given what a parsed text cannot have: a name twice, numbers not finite or too large.
        let parsed = text::parse(Source(&text), &FileKind::SCENE);
        let wrong = parsed.err().or_else(|| self.wrong.clone());
        match wrong {
            Some(wrong) => Err(Source(&text).error(wrong)),
            None => Scene::checked(self.file.clone(), &text),
        }
    }

    /// The text of the scene file.
    #[must_use]
    pub fn text(&self) -> String {
        write::text(&self.file)
    }
}
