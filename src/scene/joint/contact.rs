//! Contacts of two profiles, as of a cam and its follower: their keys in the file, their checked form and the checks. What they say becomes the
//! equivalent linkage: a link between the two centres of curvature; where one profile is flat, a pin in a guide along it.

use indexmap::IndexMap;
use serde::Deserialize;

use super::slider::{Along, Slider, SliderFile, face};
use super::{JointKind, Meaning, On};
use crate::geometry::{Point, Vector, complex_product, direction_of_degrees, unit};
use crate::message::Message;
use crate::scene::digits::Digits;
use crate::scene::error::{Wrong, number};
use crate::scene::given::GivenBy;
use crate::scene::link::{Length, Link, Shape};
use crate::scene::name::{Bearer, check_name, joined, no_point};
use crate::scene::names::{Coordinates, Names};
use crate::scene::says;
use crate::scene::value::{At, Direction};
use crate::scene::write::write_keys;

/// Largest difference of a drawn distance from that of its radii, in parts of it: drawings have few digits.
const DRAWN: f64 = 0.01;

/// Two profiles that touch, as those of a cam and its follower.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = r#"a contact as { "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10] }"#
)]
#[cfg_attr(feature = "schemas", schemars(rename = "contact"))]
pub(in crate::scene) struct ContactFile {
    /// The two bodies that touch: links, or "ground".
    #[cfg_attr(feature = "schemas", schemars(length(equal = 2)))]
    pub links: Vec<String>,
    /// The centres of curvature of their profiles at the contact, a point of each, in the same order; only that of the first where the second
    /// profile is flat.
    #[cfg_attr(feature = "schemas", schemars(length(min = 1, max = 2)))]
    pub centers: Vec<String>,
    /// The radii of curvature in the same order, that of a hollow profile negative. In a drawn configuration they may be left out.
    #[cfg_attr(feature = "schemas", schemars(length(min = 1, max = 2)))]
    pub radii: Option<Vec<f64>>,
    /// The direction of the flat profile of the second body, as that of a guide; the first body lies to its right, below a face that runs to +x.
    pub along: Option<Direction>,
    /// A place on the flat profile: a point of the second body, or [x, y] on the ground or in its shape.
    /// Left out: the first point of `along`, else of the body.
    pub through: Option<At>,
    /// Whether the second body touches with a roller about its centre; left out: false.
    pub roller: Option<bool>,
    /// Whether both profiles are circles about these centres, or a circle and a straight line, so that the linkage is equivalent in every position;
    /// left out: false, in this position alone.
    pub circular: Option<bool>,
    /// The name of the equivalent link; left out: E1, E2 … in the order of the contacts.
    pub name: Option<String>,
}

write_keys!(ContactFile { links, centers, radii, along, through, roller, circular, name });

pub(super) const CONTACTS: JointKind = JointKind {
    list: "contacts",
    keys: &[
        ("links", Some(Meaning::Link)),
        ("centers", Some(Meaning::Point)),
        ("radii", None),
        ("along", Some(Meaning::PairOfGuide)),
        ("through", Some(Meaning::PointOfGuide)),
        ("roller", None),
        ("circular", None),
        ("name", Some(Meaning::Link)),
    ],
};

/// Two profiles that touch, and the link or the slider that has the same motion.
///
/// Profiles that touch move against each other as circles of curvature do, up to accelerations: the distance of their centres is constant to the
/// second order (L. Burmester, *Lehrbuch der Kinematik*, 1888; A. S. Hall, *Kinematics and Linkage Design*, 1961).
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The bodies that touch.
    pub bodies: [On; 2],
    /// What has the same motion.
    pub equivalent: Equivalent,
    /// Whether the second body touches with a roller.
    pub has_roller: bool,
    /// Whether the profiles are circles or straight, so that this holds in every position.
    pub is_circular: bool,
}

/// What moves as two profiles that touch.
#[derive(Debug, Clone, PartialEq)]
pub enum Equivalent {
    /// A link between the two centres of curvature.
    Link {
        /// Its name, among the links of the scene.
        name: String,
        /// The centres.
        centers: [String; 2],
        /// The radii of curvature, that of a hollow profile negative; `None` in a drawn configuration without them.
        radii: Option<[f64; 2]>,
    },
    /// A pin that slides along a flat profile, at the radius from it.
    Slider {
        /// Its index among the sliders of the scene.
        index: usize,
        /// The centre of curvature of the first profile.
        center: String,
        /// Its radius; `None` in a drawn configuration without it.
        radius: Option<f64>,
    },
}

/// A contact with what moves as it does.
pub(in crate::scene) struct Read {
    contact: Contact,
    /// The name of the equivalent link, and what its length follows from unless the scene is drawn.
    link: Option<(String, Option<Ends>)>,
    /// The pin on the flat profile, which is checked when the sliders are.
    slider: Option<SliderFile>,
}

/// The ends of an equivalent link and the radii at them.
type Ends = ([String; 2], [f64; 2]);

/// The contacts of a scene; their equivalent links join the others.
pub(in crate::scene) fn contacts(
    given_by: GivenBy,
    ground: &[String],
    coordinates: &Coordinates,
    links: &mut IndexMap<String, Link>,
    digits: &mut Digits,
    file: Vec<ContactFile>,
) -> Result<Vec<Read>, Wrong> {
    let mut read = Vec::with_capacity(file.len());
    for (index, given) in file.into_iter().enumerate() {
        let inside = |wrong: Wrong| wrong.inside(&["contacts", &index.to_string()]);
        let names = Names::new(ground, links);
        let mut own = contact(given_by, &names, coordinates, index, given).map_err(inside)?;
        if let Some((name, ends)) = own.link.take() {
            let length = ends.map(|(ends, radii)| equivalent_length(ends, radii, digits));
            let (points, shape) = match length {
                Some(length) => (vec![length.from.clone(), length.to.clone()], Shape::Lengths(vec![length])),
                None => (own.centers(), Shape::Bare),
            };
            links.insert(name, Link { points, shape, drive: None, angle_deg: None, motion: None });
        }
        read.push(own);
    }
    Ok(read)
}

/// The contacts with their pins on flat profiles among the sliders.
pub(in crate::scene) fn faces(
    given_by: GivenBy,
    names: &Names<'_>,
    coordinates: &Coordinates,
    sliders: &mut Vec<Slider>,
    read: Vec<Read>,
) -> Result<Vec<Contact>, Wrong> {
    let mut all = Vec::with_capacity(read.len());
    for (number, Read { mut contact, slider, .. }) in read.into_iter().enumerate() {
        if let (Some(slider), Equivalent::Slider { index, radius, .. }) = (slider, &mut contact.equivalent) {
            *index = sliders.len();
            let pin = face(given_by, names, coordinates, slider, radius.unwrap_or(0.0)).and_then(|pin| {
                let is_wrong = check_face(names, coordinates, &pin, *radius).filter(|_| given_by == GivenBy::Drawing);
                is_wrong.map_or(Ok(pin), Err)
            });
            sliders.push(pin.map_err(|wrong| wrong.inside(&["contacts", &number.to_string()]))?);
        }
        all.push(contact);
    }
    Ok(all)
}

impl Read {
    /// The centres of curvature.
    fn centers(&self) -> Vec<String> {
        match &self.contact.equivalent {
            Equivalent::Link { centers, .. } => centers.to_vec(),
            Equivalent::Slider { center, .. } => vec![center.clone()],
        }
    }
}

/// A contact of the file.
fn contact(
    given_by: GivenBy,
    names: &Names<'_>,
    coordinates: &Coordinates,
    index: usize,
    given: ContactFile,
) -> Result<Read, Wrong> {
    let ContactFile { links, centers, radii, along, through, roller, circular, name } = given;
    let links = <[String; 2]>::try_from(links).map_err(|all| Wrong::value(&["links"], says::two_touch(all.len())))?;
    let bodies = [body(names, &links[0], "0")?, body(names, &links[1], "1")?];
    if bodies[0] == bodies[1] {
        return Err(Wrong::value(&["links"], says::touches_itself(named(&bodies[0]))));
    }
    let (has_roller, is_circular, is_flat) = (roller.unwrap_or(false), circular.unwrap_or(false), along.is_some());
    check_centers(names, &bodies, &centers, is_flat)?;
    let radii = checked_radii(given_by, centers.len(), radii)?;
    if is_flat {
        if name.is_some() {
            return Err(Wrong::key(&["name"], says::face_without_link()).hint(says::leave_key_out()));
        }
        if has_roller {
            return Err(Wrong::key(&["roller"], says::flat_roller()).hint(says::leave_key_out()));
        }
        let [center] = <[String; 1]>::try_from(centers).unwrap_or_default();
        let pin = Some(center.clone());
        let slider = SliderFile { pin, on: links[1].clone(), through, along, ..SliderFile::default() };
        // Its place among the sliders is found when these have been read.
        let equivalent = Equivalent::Slider { index: 0, center, radius: radii.map(|radii| radii[0]) };
        let contact = Contact { bodies, equivalent, has_roller, is_circular };
        return Ok(Read { contact, link: None, slider: Some(slider) });
    }
    if through.is_some() {
        return Err(Wrong::key(&["through"], says::through_without_face()).hint(says::give_face()));
    }
    let centers = <[String; 2]>::try_from(centers).unwrap_or_default();
    let radii = radii.map(|radii| [radii[0], radii[1]]);
    if let Some(radii) = radii {
        check_touch(radii, has_roller)?;
        check_drawn(coordinates, &centers, radii).filter(|_| given_by == GivenBy::Drawing).map_or(Ok(()), Err)?;
    }
    let name = equivalent_name(names, index, name)?;
    let ends = radii.filter(|_| given_by == GivenBy::Lengths).map(|radii| (centers.clone(), radii));
    let equivalent = Equivalent::Link { name: name.clone(), centers, radii };
    let contact = Contact { bodies, equivalent, has_roller, is_circular };
    Ok(Read { contact, link: Some((name, ends)), slider: None })
}

/// Refuses other than a centre of each body, or of the first one where the second is flat.
fn check_centers(names: &Names<'_>, bodies: &[On; 2], centers: &[String], is_flat: bool) -> Result<(), Wrong> {
    let count = centers.len();
    if count != if is_flat { 1 } else { 2 } {
        let (message, hint) = match is_flat {
            true => (says::one_center_of_face(count), says::face_has_no_center()),
            false => (says::two_centers(count), says::center_or_face()),
        };
        return Err(Wrong::value(&["centers"], message).hint(hint));
    }
    for (center, (body, place)) in centers.iter().zip(bodies.iter().zip(["0", "1"])) {
        if !has(names, body, center) {
            let message = no_point(named(body), center, points(names, body));
            return Err(Wrong::value(&["centers", place], message).hint(says::center_on_body()));
        }
    }
    if has(names, &bodies[1], &centers[0]) || centers.get(1).is_some_and(|center| has(names, &bodies[0], center)) {
        let message = says::center_of_both(named(&bodies[0]), named(&bodies[1]));
        return Err(Wrong::value(&["centers"], message).hint(says::center_on_body()));
    }
    Ok(())
}

/// As many radii as centres; a drawn configuration may do without.
fn checked_radii(given_by: GivenBy, wanted: usize, radii: Option<Vec<f64>>) -> Result<Option<Vec<f64>>, Wrong> {
    let Some(radii) = radii else {
        return match given_by {
            GivenBy::Drawing => Ok(None),
            GivenBy::Lengths => Err(Wrong::value(&[], says::missing("radii")).hint(says::give_radii())),
        };
    };
    if radii.len() != wanted {
        return Err(Wrong::value(&["radii"], says::radii_as_centers(wanted, radii.len())));
    }
    if wanted == 1 && radii[0] < 0.0 {
        return Err(Wrong::value(&["radii", "0"], says::hollow_on_face()).hint(says::turn_face()));
    }
    Ok(Some(radii))
}

/// Refuses radii of profiles that cannot touch.
fn check_touch([first, second]: [f64; 2], has_roller: bool) -> Result<(), Wrong> {
    let wrong = |message: Message| Wrong::value(&["radii"], message);
    if first < 0.0 && second < 0.0 {
        return Err(wrong(says::two_hollows()).hint(says::hollow_and_round()));
    }
    if has_roller && second <= 0.0 {
        return Err(Wrong::value(&["radii", "1"], says::no_radius(second)).hint(says::give_roller()));
    }
    if first + second == 0.0 {
        return Err(wrong(says::centers_in_one_place()).hint(says::hollow_larger()));
    }
    if first + second > 0.0 && first.min(second) < 0.0 {
        let (hollow, round) = (number(first.min(second).abs()), number(first.max(second)));
        return Err(wrong(says::hollow_smaller(hollow, round)).hint(says::hollow_larger()));
    }
    Ok(())
}

/// The error of radii that do not fit the distance of drawn centres.
fn check_drawn(coordinates: &Coordinates, centers: &[String; 2], radii: [f64; 2]) -> Option<Wrong> {
    let place = |name: &String| coordinates.get(name).map(|&place| Point::from(place));
    let distance = (place(&centers[1])? - place(&centers[0])?).norm();
    let wanted = (radii[0] + radii[1]).abs();
    let is_far = (distance - wanted).abs() > DRAWN * distance.max(wanted);
    let short = |x: f64| number(libm::round(x * 1e4) / 1e4);
    let message = says::radii_not_as_drawn(&centers[0], &centers[1], short(distance), short(wanted));
    is_far.then(|| Wrong::value(&["radii"], message).hint(says::radii_as_drawn()))
}

/// The error of a flat profile that is not drawn where the radius puts it: so far to the left of the centre of curvature, looking along the profile.
fn check_face(names: &Names<'_>, coordinates: &Coordinates, face: &Slider, radius: Option<f64>) -> Option<Wrong> {
    let place = |name: &String| coordinates.get(name).map(|&place| Point::from(place));
    let center = face.pin.as_ref()?;
    let body = points(names, &face.on);
    let through = match &face.through {
        Some(At::Place(through)) => Point::from(*through),
        _ => place(face.counted_from(body.first())?)?,
    };
    let along = match &face.along {
        Along::Points(from, to) => unit(place(to)? - place(from)?)?,
        Along::Direction(along) => unit(Vector::from(*along))?,
        // Degrees count from the axis of the body, on the ground from +x.
        Along::Degrees(degrees) => {
            let axis = match body {
                [from, to, ..] if face.on != On::Ground => unit(place(to)? - place(from)?)?,
                _ => Vector::x(),
            };
            complex_product(axis, direction_of_degrees(*degrees))
        }
    };
    let arm = through - place(center)?;
    let distance = along.perp(&arm);
    let short = |x: f64| number(libm::round(x * 1e4) / 1e4);
    if distance < -DRAWN * arm.norm() {
        return Some(Wrong::value(&["along"], says::face_on_other_side(center)).hint(says::face_the_other_way()));
    }
    let radius = radius?;
    let most = if radius == 0.0 { arm.norm() } else { distance.max(radius) };
    let message = says::face_not_as_drawn(center, short(distance), short(radius));
    let is_far = (distance - radius).abs() > DRAWN * most;
    is_far.then(|| Wrong::value(&["radii"], message).hint(says::face_as_drawn()))
}

/// The name of the equivalent link, if no other link has it.
fn equivalent_name(names: &Names<'_>, index: usize, name: Option<String>) -> Result<String, Wrong> {
    let path: &[&str] = if name.is_some() { &["name"] } else { &[] };
    if let Some(name) = &name {
        check_name(Bearer::Link, name).map_err(|wrong| Wrong { is_key: false, ..wrong }.inside(path))?;
    }
    let name = name.unwrap_or_else(|| format!("E{}", index + 1));
    if names.links.contains_key(&name) {
        return Err(Wrong::value(path, says::equivalent_taken(&name)).hint(says::name_equivalent()));
    }
    Ok(name)
}

/// The length of an equivalent link, with the digits of the radii: 0.1 and 0.2 make 0.3.
fn equivalent_length([from, to]: [String; 2], radii: [f64; 2], digits: &mut Digits) -> Length {
    let value = digits.sum(radii).abs();
    Length { key: joined(&from, &to), from, to, value }
}

fn body(names: &Names<'_>, name: &str, place: &str) -> Result<On, Wrong> {
    match name {
        "ground" => Ok(On::Ground),
        link => names.link(&["links", place], link).map(|_| On::Link(link.to_owned())),
    }
}

fn has(names: &Names<'_>, body: &On, point: &str) -> bool {
    match body {
        On::Ground => names.on_ground(point),
        On::Link(link) => names.on_link(link, point),
    }
}

fn points<'n>(names: &'n Names<'_>, body: &On) -> &'n [String] {
    match body {
        On::Ground => names.ground,
        On::Link(link) => names.links.get(link).map_or(&[], |link| &link.points),
    }
}

/// "link 2" or "the ground".
fn named(body: &On) -> Message {
    match body {
        On::Ground => says::the_ground(),
        On::Link(link) => says::link_named(link),
    }
}
