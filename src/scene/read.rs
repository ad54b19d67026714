//! The scene file, version 1, key by key; the checked scene; and the way from text to scene.

use indexmap::IndexMap;
use serde::Deserialize;

use super::centers::check_centers;
use super::choices::FrameName;
use super::digits::Digits;
use super::error::{SceneError, Source, Wrong};
use super::figure::{Figure, Movable, check_traced};
use super::friction::FrictionFile;
use super::given::{GivenBy, PointMotion};
use super::joint::{Contact, ContactFile, Gear, GearFile, Slider, SliderFile, contacts, faces, gears, sliders};
use super::link::{Link, LinkFile, links};
use super::loads::{Analysis, LoadFields, LoadFile, Loads, SpringFile, loads};
use super::names::Names;
use super::points::{Ground, Near, check_given_once, check_motions, check_points, ground, known, near};
use super::quantity_name::QuantityName;
use super::says;
use super::schema::schema;
use super::text::FileKind;
use super::typed::{read_as, read_with};
use super::units::Units;
use super::value::{NearValue, Vector};
use super::write::{text_of, write_keys};
use crate::geometry::{Ball, UNIT_ROUNDOFF};
use crate::message::Message;
use crate::text::{Untrusted, shown};

/// A planar mechanism: x right, y up, counter-clockwise positive, angles in degrees.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "scene"))]
#[serde(deny_unknown_fields, expecting = r#"a scene as { "kinegon": 1, … }"#)]
pub(super) struct SceneFile {
    /// Version of the scene format.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "crate::scene::schema_made::version"))]
    pub kinegon: u64,
    /// Title of the mechanism, for example the publication it is from.
    pub title: Option<Untrusted>,
    /// Units of every length and time of the scene. They are labels; nothing is converted.
    pub units: Units,
    /// The frame's points with their coordinates; in a drawn configuration their names are enough.
    pub ground: Option<Ground>,
    /// A drawn configuration: coordinates of every point. Then there are no lengths, shapes or angles.
    pub points: Option<IndexMap<String, Vector>>,
    /// Points of known motion, in a drawn configuration.
    pub known: Option<IndexMap<String, PointMotion>>,
    /// The links by name. A point named in two links is a revolute joint between them.
    pub links: IndexMap<String, LinkFile>,
    /// Links that slide along straight guides, and pins that ride in slots.
    pub sliders: Option<Vec<SliderFile>>,
    /// Pairs of wheels that mesh.
    pub gears: Option<Vec<GearFile>>,
    /// Profiles that touch, as those of a cam and its follower.
    pub contacts: Option<Vec<ContactFile>>,
    /// The acceleration of free fall, in length per time²; left out: zero.
    pub gravity: Option<Vector>,
    /// Forces and couples on links.
    pub forces: Option<Vec<LoadFile>>,
    /// Springs between links.
    pub springs: Option<Vec<SpringFile>>,
    /// Coulomb friction in joints, which counts where loads press on them.
    pub friction: Option<Vec<FrictionFile>>,
    /// Whether inertia counts among the loads; left out: dynamic.
    pub analysis: Option<Analysis>,
    /// Approximate coordinates of some points, and angles of links as "angle(3)", to choose the assembly mode.
    /// The one with the least sum of squared distances from them is taken; an angle counts as its chord at a radius of the mechanism's size.
    /// A slotted lever with one point has its slider on the positive side of `through`, unless its angle stands here.
    pub near: Option<IndexMap<String, NearValue>>,
    /// What the figure shows, and how large.
    pub figure: Option<Figure>,
    /// Names of the quantities asked for, as "omega(2)" or "a(S3)"; left out: everything.
    pub want: Option<Vec<String>>,
    /// The quantities for which the forms and sheets of students have boxes, as "omega(2)" or "vplan(p,b)", with the marks that each is
    /// worth; left out: all that the steps of the construction give, one mark each. What no step gives has no box.
    pub form: Option<IndexMap<String, f64>>,
    /// How many stages of a hint somebody may open who solves this as an exercise in the workbench: 1 the plan, 2 the first wrong value,
    /// 3 the step, 4 what was done; left out: all.
    #[cfg_attr(feature = "schemas", schemars(range(min = 0, max = MOST_HINTS)))]
    pub hints: Option<usize>,
}

write_keys!(SceneFile {
    kinegon,
    title,
    units,
    ground,
    points,
    known,
    links,
    sliders,
    gears,
    contacts,
    gravity,
    forces,
    springs,
    friction,
    analysis,
    near,
    figure,
    want,
    form,
    hints
});

/// A mechanism as its scene file describes it: checked, in the file's order and units, angles in degrees. What is computed
/// does not depend on that order.
///
/// Coordinates are in the fixed frame (x right, y up) and in `units.length`, unless the field says otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The title, if any.
    pub title: Option<Untrusted>,
    /// The units of every length and time of the scene.
    pub units: Units,
    /// Whether the scene is given by lengths or by a drawing.
    pub given_by: GivenBy,
    /// Names of the frame's points, in file order.
    pub ground: Vec<String>,
    /// Given coordinates: of the ground points, or in a drawn configuration of every point.
    pub coordinates: IndexMap<String, [f64; 2]>,
    /// Points whose motion is given; only in a drawn configuration.
    pub known: IndexMap<String, PointMotion>,
    /// The links by name, without the frame.
    pub links: IndexMap<String, Link>,
    /// The sliders, and the pins in slots.
    pub sliders: Vec<Slider>,
    /// The pairs of wheels that mesh.
    pub gears: Vec<Gear>,
    /// The profiles that touch, each with a link or a slider of its own among the others.
    pub contacts: Vec<Contact>,
    /// Masses, forces, springs and friction; none where the scene gives none of the first three.
    pub loads: Option<Box<Loads>>,
    /// Approximate positions that choose the assembly mode; not in a drawn configuration.
    pub near: Near,
    /// What the figure shows, and how large.
    pub figure: Figure,
    /// Names of the quantities asked for; `None` for all. They are not checked here.
    pub want: Option<Vec<String>>,
    /// The quantities for which a student's form has boxes, with the marks that each is worth; `None` for all that the steps give, one mark
    /// each. One that no step gives has none.
    pub form: Option<IndexMap<String, f64>>,
    /// How many stages of a hint a student may open in the workbench.
    pub hints: usize,
    /// The scene's text, for the places of errors of later stages.
    text: String,
    /// Its numbers as they are written there.
    digits: Digits,
}

impl Scene {
    /// The scene that `text` describes, or the first error in it.
    ///
    /// ```
    /// use kinegon::scene::Scene;
    /// let scene = Scene::read(r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    ///     "ground": { "A": [0, 0] },
    ///     "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 100 }, "drive": { "angle": 70, "omega": -1 } } } }"#)?;
    /// assert_eq!(scene.links["1"].points, ["A", "B"]);
    ///
    /// let error = Scene::read(r#"{ "kinegon": 1, "unit": {} }"#).unwrap_err();
    /// assert_eq!(error.to_string(), "1:17: unit: unknown key `unit`; hint: did you mean `units`?");
    /// # Ok::<(), kinegon::scene::SceneError>(())
    /// ```
    pub fn read(text: &str) -> Result<Scene, SceneError> {
        let (file, digits) = read_with(text, &FileKind::SCENE, Digits::of)?;
        let scene = check(file, text, digits).map_err(|wrong| Source(text).error(wrong))?;
        SizeLimit::NUMBERS.check(&scene)?;
        Ok(scene)
    }

    /// An error of a later stage at a JSON path of this scene; an index of a list is written in digits.
    ///
    /// If the scene has nothing at the path, the place is that of the nearest part around it.
    pub fn error_at(&self, path: &[&str], message: impl Into<Message>, hint: Option<Message>) -> SceneError {
        Source(&self.text).error(Wrong::value(path, message).maybe_hint(hint))
    }

    /// The number that is written in its text where it has `x`: with all digits of the decimal, or of the size and angle
    /// of the vector of which it is a component. Where the text has none such and `x` is no whole number, it was computed, and may be
    /// off by a rounding.
    pub(crate) fn as_written(&self, x: f64) -> Ball {
        let is_whole = x.trunc() == x;
        let computed = || Ball::within(x, if is_whole { 0.0 } else { 2.0 * UNIT_ROUNDOFF * x.abs() });
        self.digits.written(x).unwrap_or_else(computed)
    }

    /// The same, or the decimal as which `x` is printed: of what may have been given another number since.
    pub(crate) fn as_written_or_printed(&self, x: f64) -> Ball {
        self.digits.written(x).unwrap_or_else(|| Ball::decimal(x))
    }

    /// Whether `x` is a number of its text and is printed as it is written there.
    pub(crate) fn is_written(&self, x: f64) -> bool {
        self.digits.is_printed(x)
    }

    /// The text that it was read from.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// The JSON Schema (draft 2020-12) of the scene file, with descriptions, for editors.
    pub fn schema() -> serde_json::Value {
        schema!("scene", SceneFile, "Kinegon scene, version 1")
    }
}

impl Scene {
    /// How many forces and couples it has, and how many springs.
    fn counts_of_loads(&self) -> [usize; 2] {
        self.loads.as_ref().map_or([0; 2], |loads| [loads.loads.len(), loads.springs.len()])
    }

    /// How many forces, couples and springs it has.
    pub(crate) fn count_of_loads(&self) -> usize {
        self.counts_of_loads().iter().sum()
    }
}

/// How large a scene may be for what is done with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizeLimit {
    links: usize,
    points: usize,
    /// Forces, couples and springs.
    loads: usize,
    /// What has the limits.
    what: Limited,
}

/// What may only be so large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Limited {
    Scene,
    Figure,
    Steps,
    Board,
    Hand,
}

impl SizeLimit {
    /// For numbers, which take seconds then; no scene may be larger.
    pub const NUMBERS: SizeLimit = SizeLimit { links: 10_000, points: 100_000, loads: 10_000, what: Limited::Scene };
    /// For a figure, which takes three seconds then.
    pub const FIGURE: SizeLimit = SizeLimit { links: 3_000, points: 10_000, loads: 1_000, what: Limited::Figure };
    /// For steps, whose sheets grow as the square of the links.
    pub const STEPS: SizeLimit = SizeLimit { links: 150, points: 1_000, loads: 100, what: Limited::Steps };
    /// For a drawing that is judged operation by operation, each by all that was made before.
    pub const BOARD: SizeLimit = SizeLimit { links: 75, points: 200, what: Limited::Board, ..SizeLimit::STEPS };
    /// For what is drawn by hand: errors of all lines go through to all later ones.
    pub const HAND: SizeLimit = SizeLimit { links: 1_000, points: 2_000, loads: 300, what: Limited::Hand };

    /// Refuses a scene that is larger; a point counts in every link that has it, and loads are forces, couples and springs.
    ///
    /// # Errors
    /// What there is too much of, and how much there may be.
    pub fn check(self, scene: &Scene) -> Result<(), SceneError> {
        let points = scene.ground.len() + scene.links.values().map(|link| link.points.len()).sum::<usize>();
        let what = match self.what {
            Limited::Scene => says::a_scene(),
            Limited::Figure => says::a_figure(),
            Limited::Steps => says::a_figure_with_steps(),
            Limited::Board => says::a_drawing_judged(),
            Limited::Hand => says::by_hand(),
        };
        let ([forces, springs], loads) = (scene.counts_of_loads(), scene.count_of_loads());
        let (key, message, hint) = if scene.links.len() > self.links {
            ("links", says::too_many_links(what, self.links, scene.links.len()), says::divide_mechanism())
        } else if points > self.points {
            ("links", says::too_many_points_in(what, self.points, points), says::divide_mechanism())
        } else if loads > self.loads {
            let key = if forces < springs { "springs" } else { "forces" };
            (key, says::too_many_loads(what, self.loads, loads), says::replace_loads())
        } else {
            return Ok(());
        };
        Err(scene.error_at(&[key], message, Some(hint)))
    }
}

/// Bits of the sign: eight digits of base 32.
const BITS: u32 = 40;
/// Digits of base 32.
const DIGITS: &[u8; 32] = b"0123456789ABCDEFGHIJKLMNOPQRSTUV";

impl Scene {
    /// Eight signs from `0`–`9` and `A`–`V` that stand for the scene: 40 bits of its mechanism, motion and wanted
    /// quantities as they are written into a file. Title, figure, notes and layout of the file do not count.
    ///
    /// Two different scenes have the same signs with a probability of 10⁻¹².
    #[must_use]
    pub fn fingerprint(&self) -> String {
        // Its text has been read before, so it is read again without an error.
        let file = read_as::<SceneFile>(self.text(), &FileKind::SCENE);
        let text =
            file.map_or_else(|_| String::new(), |file| text_of(&SceneFile { title: None, figure: None, ..file }));
        let on_one_line = serde_json::from_str::<serde_json::Value>(&text).map_or(text, |json| json.to_string());
        signs(folded(on_one_line.as_bytes()))
    }

    /// Whether the paths of these points over the cycle of the drive, and so many ghosts, can be drawn.
    ///
    /// # Errors
    /// The first that cannot; its path is `trace.0` or `ghosts`, and it has no place in the text.
    pub fn check_traced(&self, trace: &[String], ghosts: Option<usize>) -> Result<(), SceneError> {
        let names = Names::new(&self.ground, &self.links);
        let figure = Figure { trace: trace.to_vec(), ghosts, ..Figure::default() };
        check_traced(self.movable(), &names, &self.sliders, &figure).map_err(Wrong::without_place)
    }

    /// Whether paths, ghosts, centrodes, inflection circles, instant centres and velocities by them that the figure asks for can be drawn.
    ///
    /// # Errors
    /// The first that cannot; its path begins with the figure's key, as `centrodes.0`, and it has no place in the text.
    pub fn check_shown(&self) -> Result<(), SceneError> {
        let (names, figure) = (Names::new(&self.ground, &self.links), &self.figure);
        let traced = check_traced(self.movable(), &names, &self.sliders, figure);
        let shown =
            traced.and_then(|()| check_centers(&names, figure)).and_then(|()| check_willis(&self.gears, figure));
        shown.map_err(Wrong::without_place)
    }

    /// Whether it can be followed to other positions.
    fn movable(&self) -> Movable {
        Movable::of(self.given_by, &self.contacts)
    }

    /// Whether the frame can be called by the number that the figure gives it.
    ///
    /// # Errors
    /// A link has that name; the error's path is `frame`, and it has no place in the text.
    pub fn check_frame(&self) -> Result<(), SceneError> {
        check_frame(&self.links, &self.figure).map_err(Wrong::without_place)
    }
}

/// Refuses to call the frame as a link is called.
fn check_frame(links: &IndexMap<String, Link>, figure: &Figure) -> Result<(), Wrong> {
    match figure.frame.map(FrameName::as_str).filter(|frame| links.contains_key(*frame)) {
        Some(frame) => Err(Wrong::value(&["frame"], says::frame_is_link(frame)).hint(says::other_frame())),
        None => Ok(()),
    }
}

/// Refuses a table of trains where no wheels mesh.
fn check_willis(gears: &[Gear], figure: &Figure) -> Result<(), Wrong> {
    match figure.willis && !gears.iter().any(|gear| gear.rack.is_none()) {
        true => Err(Wrong::value(&["willis"], says::no_train()).hint(says::add_gears())),
        false => Ok(()),
    }
}

/// FNV-1a of 64 bits, folded to 40.
pub fn folded(bytes: &[u8]) -> u64 {
    let hash = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3));
    (hash >> BITS) ^ (hash & ((1 << BITS) - 1))
}

/// A number of 40 bits in base 32, the highest digit first.
pub fn signs(number: u64) -> String {
    let digits = (0..BITS / 5).rev().map(|place| DIGITS[(number >> (5 * place)) as usize % 32]);
    digits.map(char::from).collect()
}

/// The stages of a hint: the plan, the first wrong value, the step, what was done.
pub(crate) const MOST_HINTS: usize = 4;

/// Most marks that a value of a form may be worth.
pub(crate) const MOST_MARKS: f64 = 1e6;

/// Whether what a form asks for has names of quantities, is worth something, and is anything at all.
fn check_form(form: Option<&IndexMap<String, f64>>) -> Result<(), Wrong> {
    let Some(asked) = form else { return Ok(()) };
    if asked.is_empty() {
        return Err(Wrong::value(&["form"], says::form_asks_nothing()).hint(says::leave_key_out()));
    }
    for (name, marks) in asked {
        let wrong = |message| Wrong::value(&["form", name], message);
        if QuantityName::parse(name).is_none() {
            return Err(wrong(says::form_no_quantity(shown(name))).hint(says::form_names_quantities()));
        }
        if !(0.0..=MOST_MARKS).contains(marks) {
            return Err(wrong(says::form_no_marks(*marks)).hint(says::form_marks_from_0(MOST_MARKS)));
        }
    }
    Ok(())
}

/// Checks the parts of the file, in the order in which errors are reported.
fn check(file: SceneFile, text: &str, mut digits: Digits) -> Result<Scene, Wrong> {
    let given_by = if file.points.is_some() { GivenBy::Drawing } else { GivenBy::Lengths };
    let (mut links, of_links) = links(given_by, file.units.time, file.links)?;
    let (ground, coordinates) = ground(given_by, file.ground, file.points)?;
    let touching = file.contacts.unwrap_or_default();
    let touching = contacts(given_by, &ground, &coordinates, &mut links, &mut digits, touching)?;
    let names = Names::new(&ground, &links);
    check_points(given_by, &names, &coordinates)?;
    let mut sliders = sliders(given_by, &names, &coordinates, file.sliders.unwrap_or_default(), of_links.pushes)?;
    let contacts = faces(given_by, &names, &coordinates, &mut sliders, touching)?;
    let is_drawn = given_by == GivenBy::Drawing;
    let gears = gears(is_drawn, &names, &coordinates, &sliders, file.gears.unwrap_or_default())?;
    let known = known(given_by, &names, file.known)?;
    check_given_once(&names, &known, &sliders)?;
    let fields = LoadFields {
        analysis: file.analysis,
        gravity: file.gravity,
        masses: of_links.masses,
        forces: file.forces,
        springs: file.springs,
        friction: file.friction,
    };
    let loads = loads(given_by, &names, file.units, fields)?;
    if let Some(index) = gears.iter().position(|gear| loads.is_some() && gear.belt.is_some()) {
        let message = says::no_forces_of_belts();
        return Err(Wrong::key(&["gears", &index.to_string(), "belt"], message).hint(says::remove_belts_or_loads()));
    }
    let near = near(given_by, &names, file.near)?;
    check_motions(&names)?;
    let figure = file.figure.unwrap_or_default();
    figure.check().and_then(|()| check_frame(&links, &figure)).map_err(|wrong| wrong.inside(&["figure"]))?;
    check_traced(Movable::of(given_by, &contacts), &names, &sliders, &figure)
        .map_err(|wrong| wrong.inside(&["figure"]))?;
    check_centers(&names, &figure).map_err(|wrong| wrong.inside(&["figure"]))?;
    check_willis(&gears, &figure).map_err(|wrong| wrong.inside(&["figure"]))?;
    check_form(file.form.as_ref())?;
    if let Some(hints) = file.hints.filter(|hints| *hints > MOST_HINTS) {
        return Err(Wrong::value(&["hints"], says::no_hints(hints)).hint(says::hints_from_0(MOST_HINTS)));
    }
    Ok(Scene {
        title: file.title,
        units: file.units,
        given_by,
        ground,
        coordinates,
        known,
        links,
        sliders,
        gears,
        contacts,
        loads,
        near,
        figure,
        want: file.want,
        form: file.form,
        hints: file.hints.unwrap_or(MOST_HINTS),
        text: text.to_owned(),
        digits,
    })
}
