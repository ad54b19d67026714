//! Builds a scene in Rust: writes the text of its file key by key, which is then read as any other.

use super::error::SceneError;
use super::figure::Figure;
use super::given::{LinkMotion, PointMotion};
use super::joint::{Belt, key_order};
use super::read::Scene;
use super::units::{LengthUnit, TimeUnit, Units};
use super::value::{At, Direction};
use super::write::{Write, Written, text_of};

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
    pub(super) file: Object,
    /// The figure, which may have more than a file can say.
    figure: Option<Figure>,
}

impl Builder {
    /// An empty scene in these units.
    pub fn new(length: LengthUnit, time: TimeUnit) -> Builder {
        let file = Object::default().with("kinegon", &1.0).with("units", &Units::new(length, time));
        Builder { file: file.with("links", &Object::default()), figure: None }
    }

    /// Gives the scene a title.
    pub fn title(mut self, title: &str) -> Builder {
        *self.file.slot("title") = title.written();
        self
    }

    /// Adds a point of the frame, with its coordinates in the fixed frame.
    pub fn ground(self, point: &str, place: [f64; 2]) -> Builder {
        self.entry("ground", point, &place)
    }

    /// Adds the coordinates of a moving point in the fixed frame. The scene is then a drawn configuration: every point
    /// has coordinates, and there are no lengths, shapes, angles or approximate places.
    pub fn point(self, point: &str, place: [f64; 2]) -> Builder {
        self.entry("points", point, &place)
    }

    /// Gives the motion of a point, in a drawn configuration; [`polar`](super::polar) makes vectors of size and angle.
    pub fn known(self, point: &str, motion: PointMotion) -> Builder {
        self.entry("known", point, &motion)
    }

    /// Adds a link.
    pub fn link(self, name: &str, link: NewLink) -> Builder {
        self.entry("links", name, &link.0.in_order(&["links", name]))
    }

    /// Lets a link slide on a guide by its point `at`.
    pub fn slider(self, link: &str, at: &str, guide: Guide) -> Builder {
        self.sliding(guide.0.with("link", link).with("at", at))
    }

    /// Lets a pin, a point of another link, ride in a slot without a block.
    pub fn pin(self, pin: &str, slot: Guide) -> Builder {
        self.sliding(slot.0.with("pin", pin))
    }

    /// Lets two wheels mesh that turn on pins of one carrier: links, or `"ground"`.
    ///
    /// ```
    /// use kinegon::scene::{Builder, LengthUnit, Mesh, NewLink, TimeUnit, Turn};
    ///
    /// let scene = Builder::new(LengthUnit::Mm, TimeUnit::S)
    ///     .ground("A", [0.0, 0.0])
    ///     .ground("D", [60.0, 0.0])
    ///     .link("1", NewLink::points(["A", "B"]).length("AB", 10.0).drive(Turn::omega(8.0).angle(30.0)))
    ///     .link("2", NewLink::points(["D", "E"]).length("DE", 10.0))
    ///     .gear(["1", "2"], Mesh::on("ground").teeth([20, 40]))
    ///     .build()?;
    /// let solution = kinegon::solve(&scene).expect("it turns");
    /// assert_eq!(solution.motion.body(solution.mechanism.link("2").expect("a wheel")).omega, -4.0);
    /// # Ok::<(), kinegon::scene::SceneError>(())
    /// ```
    pub fn gear(mut self, wheels: [&str; 2], mesh: Mesh) -> Builder {
        let gear = mesh.0.with("mesh", &wheels.map(str::to_owned).to_vec());
        self.file.push("gears", gear.in_order(&["gears", ""]));
        self
    }

    fn sliding(mut self, slider: Object) -> Builder {
        self.file.push("sliders", slider.in_order(&["sliders", ""]));
        self
    }

    /// Gives the approximate place of a point in the fixed frame, to choose the assembly mode.
    pub fn near(self, point: &str, place: [f64; 2]) -> Builder {
        self.entry("near", point, &place)
    }

    /// Gives the approximate angle of a link's axis from +x, in degrees, to choose the assembly mode.
    pub fn near_angle(self, link: &str, degrees: f64) -> Builder {
        self.entry("near", &format!("angle({link})"), &degrees)
    }

    /// Sets what the figure shows, and its scales. Without it the figure has all three panels on A4.
    pub fn figure(mut self, figure: Figure) -> Builder {
        *self.file.slot("figure") = figure.written();
        self.figure = Some(figure);
        self
    }

    /// Names the quantities that are asked for, as `"omega(2)"`. Without it all are computed.
    pub fn want<'a>(mut self, names: impl IntoIterator<Item = &'a str>) -> Builder {
        *self.file.slot("want") = Written::List(names.into_iter().map(str::written).collect());
        self
    }

    fn entry(mut self, table: &str, name: &str, value: &impl Write) -> Builder {
        self.file.add(table, name, value);
        self
    }

    /// The checked scene.
    ///
    /// # Errors
    /// The first error, as [`Scene::read`] gives it; its place is in [`Builder::text`].
    pub fn build(&self) -> Result<Scene, SceneError> {
        let mut scene = Scene::read(&self.text())?;
        scene.figure = self.figure.clone().unwrap_or_default();
        Ok(scene)
    }

    /// The text of the scene file.
    #[must_use]
    pub fn text(&self) -> String {
        text_of(&self.file.clone().in_order(&[]))
    }
}

/// An object of the file. A key that is set twice stands there twice, and is refused as in any file.
#[derive(Debug, Clone, Default)]
pub(super) struct Object(Vec<(String, Written)>);

impl Object {
    pub fn with(mut self, key: &str, value: &(impl Write + ?Sized)) -> Object {
        self.0.push((key.to_owned(), value.written()));
        self
    }

    /// The value of a key, for one that may be set again.
    pub fn slot(&mut self, key: &str) -> &mut Written {
        let index = self.0.iter().position(|(own, _)| own == key).unwrap_or(self.0.len());
        if index == self.0.len() {
            self.0.push((key.to_owned(), Written::Nothing));
        }
        &mut self.0[index].1
    }

    pub fn with_list(mut self, key: &str, list: Vec<Written>) -> Object {
        self.0.push((key.to_owned(), Written::List(list)));
        self
    }

    /// Adds an object to the list under a key.
    pub fn push(&mut self, key: &str, object: Object) {
        match self.slot(key) {
            Written::List(list) => list.push(object.written()),
            none => *none = Written::List(vec![object.written()]),
        }
    }

    /// Adds an entry to the object under a key.
    pub fn add(&mut self, key: &str, name: &str, value: &impl Write) {
        let entry = (name.to_owned(), value.written());
        match self.slot(key) {
            Written::Object(entries) => entries.push(entry),
            none => *none = Written::Object(vec![entry]),
        }
    }

    /// With its keys in the order in which people write them, as the object at that path.
    pub fn in_order(mut self, path: &[&str]) -> Object {
        let order = key_order(path);
        self.0.sort_by_key(|(key, _)| order.iter().position(|known| known == key));
        self
    }
}

impl Write for Object {
    fn written(&self) -> Written {
        Written::Object(self.0.clone())
    }
}

/// A link for [`Builder::link`](super::Builder::link).
#[derive(Debug, Clone)]
#[must_use]
pub struct NewLink(pub(super) Object);

impl NewLink {
    /// A link with these points. Its axis runs from the first to the second.
    pub fn points<'a>(names: impl IntoIterator<Item = &'a str>) -> NewLink {
        let names: Vec<String> = names.into_iter().map(str::to_owned).collect();
        NewLink(Object::default().with("points", &names))
    }

    /// A link by the coordinates of its points in its own frame, whose x axis is the link's axis.
    pub fn shape<'a>(places: impl IntoIterator<Item = (&'a str, [f64; 2])>) -> NewLink {
        let empty = Object::default();
        let shape = places.into_iter().fold(empty, |shape, (point, place)| shape.with(point, &place));
        NewLink(Object::default().with("shape", &shape))
    }

    /// Adds the distance of two of its points, as `"AB"`, or `"A1-B1"` for longer names: one for two points, three for
    /// three.
    pub fn length(mut self, points: &str, length: f64) -> NewLink {
        self.0.add("lengths", points, &length);
        self
    }

    /// Adds a drive that turns it about its ground pivot.
    pub fn drive(self, turn: Turn) -> NewLink {
        NewLink(self.0.with("drive", &turn.0))
    }

    /// Gives the angle of its axis from +x, in degrees, in place of that of another link's drive.
    pub fn angle(self, degrees: f64) -> NewLink {
        NewLink(self.0.with("angle", &degrees))
    }

    /// Gives its motion, in a drawn configuration.
    pub fn motion(self, motion: LinkMotion) -> NewLink {
        NewLink(self.0.with("motion", &motion))
    }
}

/// A drive that turns a link, for [`NewLink::drive`]; counter-clockwise positive.
#[derive(Debug, Clone)]
#[must_use]
pub struct Turn(Object);

impl Turn {
    /// With this angular velocity, in radians per unit of time.
    pub fn omega(omega: f64) -> Turn {
        Turn(Object::default().with("omega", &omega))
    }

    /// With this speed of rotation, in turns per minute.
    pub fn rpm(rpm: f64) -> Turn {
        Turn(Object::default().with("rpm", &rpm))
    }

    /// With the link's axis at this angle from +x, in degrees; required except in a drawn configuration.
    pub fn angle(self, degrees: f64) -> Turn {
        Turn(self.0.with("angle", &degrees))
    }

    /// With this angular acceleration, in radians per unit of time squared; zero by default.
    pub fn alpha(self, alpha: f64) -> Turn {
        Turn(self.0.with("alpha", &alpha))
    }
}

/// A straight guide and the use of it, for [`Builder::slider`](super::Builder::slider) and
/// [`Builder::pin`](super::Builder::pin).
#[derive(Debug, Clone)]
#[must_use]
pub struct Guide(Object);

impl Guide {
    /// A guide of the link of this name, or of `"ground"`.
    pub fn on(carrier: &str) -> Guide {
        Guide(Object::default().with("on", carrier))
    }

    /// Through a point of its carrier, as `"B"`, or a place `[x, y]`, on the ground in the fixed frame, else in the
    /// carrier's shape. By default through the first point of [`Guide::along`], else of the carrier.
    pub fn through(self, place: impl Into<At>) -> Guide {
        Guide(self.0.with("through", &place.into()))
    }

    /// In the direction from one point of its carrier to another, as `"BE"`; or at an angle in degrees, from +x on the
    /// ground, else from the carrier's axis; or along `[dx, dy]`. By default at 0°.
    pub fn along(self, direction: impl Into<Direction>) -> Guide {
        Guide(self.0.with("along", &direction.into()))
    }

    /// With this angle from the guide to the sliding link's axis, in degrees; zero by default.
    pub fn turned(self, degrees: f64) -> Guide {
        Guide(self.0.with("turned", &degrees))
    }

    /// With a drive that pushes the sliding link or the pin.
    pub fn drive(self, push: Push) -> Guide {
        Guide(self.0.with("drive", &push.0))
    }
}

/// How two wheels mesh, for [`Builder::gear`](super::Builder::gear).
#[derive(Debug, Clone)]
#[must_use]
pub struct Mesh(Object);

impl Mesh {
    /// On pins of the link of this name, or of `"ground"`.
    pub fn on(carrier: &str) -> Mesh {
        Mesh(Object::default().with("on", carrier))
    }

    /// With these numbers of teeth, in the order of the wheels; that of a ring with inner teeth is negative.
    pub fn teeth(self, teeth: [i32; 2]) -> Mesh {
        Mesh(self.0.with("teeth", &teeth.map(f64::from)))
    }

    /// With the second link a straight rack, on which the first, a wheel with this pitch radius, rolls.
    pub fn rack(self, teeth: i32, radius: f64) -> Mesh {
        let both = vec![f64::from(teeth).written(), "rack".written()];
        Mesh(self.0.with_list("teeth", both).with("radius", &radius))
    }

    /// With a belt or a chain around both wheels, whose numbers of teeth then say the ratio of their radii.
    pub fn belt(self, belt: Belt) -> Mesh {
        Mesh(self.0.with("belt", &belt))
    }

    /// With the second wheel at this angle where the first stands at 0, both from the carrier's axis, in degrees; zero by default.
    pub fn phase(self, degrees: f64) -> Mesh {
        Mesh(self.0.with("phase", &degrees))
    }

    /// With this pressure angle, in degrees; zero by default.
    pub fn pressure(self, degrees: f64) -> Mesh {
        Mesh(self.0.with("pressure", &degrees))
    }
}

/// A drive that pushes a slider along its guide, for [`Guide::drive`].
#[derive(Debug, Clone)]
#[must_use]
pub struct Push(Object);

impl Push {
    /// With this velocity along the guide, in length per time.
    pub fn speed(speed: f64) -> Push {
        Push(Object::default().with("speed", &speed))
    }

    /// At this distance along the guide from the place of [`Guide::through`]; required except in a drawn configuration.
    pub fn position(self, position: f64) -> Push {
        Push(self.0.with("position", &position))
    }

    /// With this acceleration along the guide, in length per time squared; zero by default.
    pub fn acceleration(self, acceleration: f64) -> Push {
        Push(self.0.with("acceleration", &acceleration))
    }
}
