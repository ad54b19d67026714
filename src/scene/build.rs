//! A scene put together in Rust: what a file would say, key by key, and nothing else.

use super::build_parts::{Guide, NewLink};
use super::error::SceneError;
use super::figure::{DecimalMark, Figure, LanguageName, NotationName, Page, StyleName};
use super::units::{LengthUnit, TimeUnit};
use super::write::{Object, Written, texts};
use super::{PointMotion, Scene};

/// Puts a scene together in Rust.
///
/// Each method adds what the key of the same name says in a scene file, and [`Builder::build`] reads the file's text: so a
/// scene built in code and one read from a file are the same, with the same checks and messages.
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
pub struct Builder {
    units: (LengthUnit, TimeUnit),
    title: Option<String>,
    ground: Object,
    points: Object,
    known: Object,
    links: Object,
    sliders: Vec<Written>,
    near: Object,
    figure: Option<Figure>,
    want: Option<Written>,
}

impl Builder {
    /// An empty scene in these units.
    #[must_use]
    pub fn new(length: LengthUnit, time: TimeUnit) -> Builder {
        Builder {
            units: (length, time),
            title: None,
            ground: Object::default(),
            points: Object::default(),
            known: Object::default(),
            links: Object::default(),
            sliders: Vec::new(),
            near: Object::default(),
            figure: None,
            want: None,
        }
    }

    /// Gives the scene a title.
    #[must_use]
    pub fn title(mut self, title: &str) -> Builder {
        self.title = Some(title.to_owned());
        self
    }

    /// Adds a point of the frame.
    #[must_use]
    pub fn ground(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.ground.add(point, place);
        self
    }

    /// Adds the coordinates of a moving point. The scene is then a drawn configuration: every point has coordinates, and
    /// there are no lengths, shapes, angles or approximate places.
    #[must_use]
    pub fn point(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.points.add(point, place);
        self
    }

    /// Gives the motion of a point, in a drawn configuration; [`polar`](super::polar) takes size and angle.
    #[must_use]
    pub fn known(mut self, point: &str, motion: PointMotion) -> Builder {
        let mut object = Object::of("velocity", motion.velocity);
        object.add("acceleration", motion.acceleration);
        self.known.add(point, object);
        self
    }

    /// Adds a link.
    #[must_use]
    pub fn link(mut self, name: &str, link: NewLink) -> Builder {
        self.links.add(name, link.written());
        self
    }

    /// Lets a link, by its point `at`, slide on a guide.
    #[must_use]
    pub fn slider(mut self, link: &str, at: &str, guide: Guide) -> Builder {
        let mut slider = Object::of("link", link);
        slider.add("at", at);
        self.sliders.push(slider.and(guide.written()).into());
        self
    }

    /// Lets a pin, a point of another link, ride in a slot without a block.
    #[must_use]
    pub fn pin(mut self, pin: &str, slot: Guide) -> Builder {
        self.sliders.push(Object::of("pin", pin).and(slot.written()).into());
        self
    }

    /// Says roughly where a point is, to choose the assembly mode.
    #[must_use]
    pub fn near(mut self, point: &str, place: [f64; 2]) -> Builder {
        self.near.add(point, place);
        self
    }

    /// Says roughly how a link lies, in degrees from +x to its axis, to choose the assembly mode.
    #[must_use]
    pub fn near_angle(mut self, link: &str, degrees: f64) -> Builder {
        self.near.add(&format!("angle({link})"), degrees);
        self
    }

    /// Says what the figure shows, and how large. Without it there are all three panels on A4.
    ///
    /// ```
    /// # use kinegon::scene::{Builder, Figure, LengthUnit, Panel, TimeUnit};
    /// # let builder = Builder::new(LengthUnit::Mm, TimeUnit::S);
    /// let panels = vec![Panel::Scheme, Panel::Velocity];
    /// let builder = builder.figure(Figure { panels, mu_v: Some(10.0), ..Figure::default() });
    /// ```
    #[must_use]
    pub fn figure(mut self, figure: Figure) -> Builder {
        self.figure = Some(figure);
        self
    }

    /// Names the quantities that are asked for, as `"omega(2)"`. Without it everything is computed.
    #[must_use]
    pub fn want<'a>(mut self, names: impl IntoIterator<Item = &'a str>) -> Builder {
        self.want = Some(texts(names));
        self
    }

    /// The scene, checked.
    ///
    /// # Errors
    /// The first thing that is wrong, as [`Scene::read`] says it; its place is in [`Builder::text`].
    pub fn build(&self) -> Result<Scene, SceneError> {
        Scene::read(&self.text())
    }

    /// The text of the scene's file, to be saved.
    #[must_use]
    pub fn text(&self) -> String {
        let mut units = Object::of("length", self.units.0.as_str());
        units.add("time", self.units.1.as_str());
        let mut scene = Object::of("kinegon", 1.0);
        scene.add_some("title", self.title.as_deref());
        scene.add("units", units);
        scene.add_entries("ground", &self.ground);
        scene.add_entries("points", &self.points);
        scene.add_entries("known", &self.known);
        scene.add("links", self.links.clone());
        if !self.sliders.is_empty() {
            scene.add("sliders", Written::List(self.sliders.clone()));
        }
        scene.add_entries("near", &self.near);
        scene.add_some("figure", self.figure.as_ref().map(written_figure));
        scene.add_some("want", self.want.clone());
        scene.text()
    }
}

/// The figure's keys that say anything but the standard.
fn written_figure(figure: &Figure) -> Object {
    let Figure {
        panels,
        mu_l,
        mu_v,
        mu_a,
        page,
        worksheet,
        style,
        notation,
        language,
        decimal,
        labels,
        special_points,
        construction,
        step,
    } = figure;
    let mut object = Object::of("panels", texts(panels.iter().map(|panel| panel.as_str())));
    object.add_some("mu_l", *mu_l);
    object.add_some("mu_v", *mu_v);
    object.add_some("mu_a", *mu_a);
    object.add_some("page", (*page != Page::default()).then(|| page.name()));
    object.add_some("worksheet", worksheet.then_some(true));
    let other = |is_standard: bool, name: &'static str| (!is_standard).then_some(name);
    for (key, name) in [
        ("style", other(*style == StyleName::default(), style.as_str())),
        ("notation", other(*notation == NotationName::default(), notation.as_str())),
        ("language", other(*language == LanguageName::default(), language.as_str())),
        ("decimal", other(*decimal == DecimalMark::default(), decimal.as_str())),
    ] {
        object.add_some(key, name);
    }
    let mut shown = Object::default();
    for (name, label) in labels {
        shown.add(name, label.as_str());
    }
    object.add_entries("labels", &shown);
    object.add_some("special_points", (!special_points).then_some(false));
    object.add_some("construction", (!construction).then_some(false));
    object.add_some("step", step.map(|step| step as f64));
    object
}
