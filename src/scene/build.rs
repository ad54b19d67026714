//! A scene put together in Rust: the types of the scene file, filled in key by key.

use super::build_parts::{Guide, NewLink};
use super::error::SceneError;
use super::figure::Figure;
use super::kind::FileKind;
use super::link::LinkFile;
use super::motion::PointMotion;
use super::place::Source;
use super::points::Ground;
use super::read::{Scene, SceneFile};
use super::slider::SliderFile;
use super::units::{LengthUnit, TimeUnit, Units};
use super::value::{Entries, NearValue, Vector};
use super::wrong::Wrong;
use super::{text, write};

/// Puts a scene together in Rust.
///
/// Each method fills in what the key of the same name says in a scene file, and [`Builder::build`] checks it as that of a
/// file: so a scene built in code and one read from a file are the same, with the same checks and messages.
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
    /// A key that was set twice.
    wrong: Option<Wrong>,
}

impl Builder {
    /// An empty scene in these units.
    pub fn new(length: LengthUnit, time: TimeUnit) -> Builder {
        Builder { file: SceneFile::new(Units { length, time }), wrong: None }
    }

    /// Gives the scene a title.
    pub fn title(mut self, title: &str) -> Builder {
        self.file.title = Some(title.to_owned());
        self
    }

    /// Adds a point of the frame.
    pub fn ground(mut self, point: &str, place: [f64; 2]) -> Builder {
        if let Ground::Places(places) = self.file.ground.get_or_insert(Ground::Places(Entries::default())) {
            places.add(point, Vector(place));
        }
        self
    }

    /// Adds the coordinates of a moving point. The scene is then a drawn configuration: every point has coordinates, and
    /// there are no lengths, shapes, angles or approximate places.
    pub fn point(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.file.points.get_or_insert_default().add(point, Vector(place));
        self
    }

    /// Gives the motion of a point, in a drawn configuration; [`polar`](super::polar) takes size and angle.
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

    /// Lets a link, by its point `at`, slide on a guide.
    pub fn slider(self, link: &str, at: &str, guide: Guide) -> Builder {
        self.sliding(guide, |slider| SliderFile { link: Some(link.to_owned()), at: Some(at.to_owned()), ..slider })
    }

    /// Lets a pin, a point of another link, ride in a slot without a block.
    pub fn pin(self, pin: &str, slot: Guide) -> Builder {
        self.sliding(slot, |slider| SliderFile { pin: Some(pin.to_owned()), ..slider })
    }

    fn sliding(mut self, guide: Guide, who: impl Fn(SliderFile) -> SliderFile) -> Builder {
        let sliders = self.file.sliders.get_or_insert_default();
        let index = sliders.len().to_string();
        sliders.push(who(guide.0.file));
        self.wrong = self.wrong.or(guide.0.wrong.map(|wrong| wrong.inside(&["sliders", &index])));
        self
    }

    /// Says roughly where a point is, to choose the assembly mode.
    pub fn near(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.file.near.get_or_insert_default().add(point, NearValue::Vector(place));
        self
    }

    /// Says roughly how a link lies, in degrees from +x to its axis, to choose the assembly mode.
    pub fn near_angle(mut self, link: &str, degrees: f64) -> Builder {
        self.file.near.get_or_insert_default().add(&format!("angle({link})"), NearValue::Degrees(degrees));
        self
    }

    /// Says what the figure shows, and how large. Without it there are all three panels on A4.
    ///
    /// ```
    /// # use kinegon::scene::{Builder, Figure, LengthUnit, PanelName, TimeUnit};
    /// # let builder = Builder::new(LengthUnit::Mm, TimeUnit::S);
    /// let panels = vec![PanelName::Scheme, PanelName::Velocity];
    /// let builder = builder.figure(Figure { panels, mu_v: Some(10.0), ..Figure::default() });
    /// ```
    pub fn figure(mut self, figure: Figure) -> Builder {
        self.file.figure = Some(figure);
        self
    }

    /// Names the quantities that are asked for, as `"omega(2)"`. Without it everything is computed.
    pub fn want<'a>(mut self, names: impl IntoIterator<Item = &'a str>) -> Builder {
        self.file.want = Some(names.into_iter().map(str::to_owned).collect());
        self
    }

    /// The scene, checked.
    ///
    /// # Errors
    /// The first thing that is wrong, as [`Scene::read`] says it; its place is in [`Builder::text`].
    pub fn build(&self) -> Result<Scene, SceneError> {
        let text = self.text();
        // What Rust can say and a text cannot: a name twice, numbers that are none or too large.
        let said = text::parse(Source(&text), &FileKind::SCENE).map(|_| ());
        let wrong = said.err().or_else(|| self.wrong.clone());
        match wrong {
            Some(wrong) => Err(Source(&text).error(wrong)),
            None => Scene::checked(self.file.clone(), &text),
        }
    }

    /// The text of the scene's file, to be saved.
    #[must_use]
    pub fn text(&self) -> String {
        write::text(&self.file)
    }
}
