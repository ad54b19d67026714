use super::drives::{link_angle_for_drive, places_from_drives, role};
use super::group::group;
use super::joint::{Joint, add_given, held_here_alone, refresh_contacts, unlike_wheels};
use super::loaded::check_loads;
use super::says;
use super::shape::{Side, local_points};
use super::structure::{Edge, Structure, structure};
use super::{Body, BodyId, GROUND, Guide, LoopEquations, Mechanism, Placing, PointId, Role, Slider, StructureError};
use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, degrees_of, span, without_sense};
use crate::message::Message;
use crate::scene::{Along, GivenBy, Link, On, Scene, Shape, by_name};
use indexmap::{IndexMap, IndexSet};
use std::cell::LazyCell;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// The mechanism that a scene describes.
///
/// # Errors
/// [`StructureError`], with its place in the scene: the scene is no mechanism, or one that cannot be solved.
pub fn mechanism(scene: &Scene) -> Result<Mechanism, StructureError> {
    mechanism_with(scene, &[], |mechanism| add_given(scene, mechanism))
}

/// The mechanism with the triangles of these links mirrored.
///
/// # Errors
/// As [`mechanism`].
pub(crate) fn mirrored_mechanism(scene: &Scene, links: &[&str]) -> Result<Mechanism, StructureError> {
    mechanism_with(scene, links, |mechanism| add_given(scene, mechanism))
}

/// The mechanism with the triangles of the links `mirrored` mirrored, the joints that `add` adds to the bodies, and the pins, which
/// follow from shared points.
pub fn mechanism_with(
    scene: &Scene,
    mirrored: &[&str],
    add: impl FnOnce(&mut Mechanism),
) -> Result<Mechanism, StructureError> {
    let mut mechanism = bodies(scene, mirrored)?;
    mechanism.warnings.extend(radians_warnings(scene));
    mechanism.warnings.extend(far_origin_warning(scene));
    mechanism.warnings.extend(guides_from_drawings(scene));
    add(&mut mechanism);
    mechanism.warnings.extend(unlike_wheels(&mechanism));
    mechanism.warnings.extend(held_here_alone(&mechanism));
    let given_angle = link_angle_for_drive(scene)?;
    let unpinned = given_angle.map(|_| mechanism.clone());
    mechanism.join_driven();
    add_groups(scene, &mut mechanism)?;
    check_loads(scene, &mechanism)?;
    if let (Some((link, angle)), Some(unpinned)) = (given_angle, unpinned) {
        mechanism.placing = Some(Box::new(placing(scene, unpinned, link, angle)?));
    }
    Ok(mechanism)
}

/// Gives a mechanism the numbers of a scene that is made of the same links and joints: so it keeps its groups, which are what takes longest
/// to find. `None` where numbers decide more than lengths: where a link's angle stands in place of a drive's, or which of two sides
/// a triangle is on; it then has some of them.
pub(crate) fn renumber(mechanism: &mut Mechanism, scene: &Scene) -> Option<()> {
    if mechanism.placing.is_some() || scene.given_by == GivenBy::Drawing {
        return None;
    }
    if !(mechanism.sliders.is_empty() && scene.gears.is_empty()) {
        let mut other = bodies(scene, &[]).ok()?;
        add_given(scene, &mut other);
        other.join_driven();
        other.joints.extend(std::mem::take(&mut mechanism.joints).into_iter().filter(|joint| joint.pin.is_some()));
        other.groups = std::mem::take(&mut mechanism.groups);
        *mechanism = other;
        return mechanism.doubtful_sides.is_empty().then_some(());
    }
    // Pins know points and bodies, and no numbers.
    let place = |name: &String| scene.coordinates.get(name).map(|&place| Point::from(place));
    for (given, name) in mechanism.given.iter_mut().zip(&mechanism.points) {
        *given = place(name);
    }
    let (ground, links) = mechanism.bodies.split_at_mut(GROUND.0 + 1);
    for (local, place) in ground[GROUND.0].local.iter_mut().zip(in_order(&scene.ground).filter_map(place)) {
        *local = place;
    }
    let driven = LazyCell::new(|| places_from_drives(scene));
    for (body, (_, link)) in links.iter_mut().zip(links_in_order(scene)) {
        let side;
        (body.local, side) = shaped(scene, link, &driven);
        if side == Side::Doubtful || link.motion.is_some() {
            return None;
        }
        if let (Role::Driver { angle, omega, alpha, .. }, Some(drive)) = (&mut body.role, &link.drive) {
            (*angle, *omega, *alpha) = (drive.angle_deg, drive.omega, drive.alpha);
        }
    }
    refresh_contacts(scene, mechanism);
    Some(())
}

/// Adds the pins and the Assur groups of the links of unknown motion, in an order in which they can be solved.
///
/// Pins follow from shared points: a pin through n bodies counts as n − 1 joints, all at a body whose motion is known first.
/// Of a pin through three or more links of unknown motion the groups tell which that is, so that the joints do not decide the groups.
fn add_groups(scene: &Scene, mechanism: &mut Mechanism) -> Result<(), StructureError> {
    let members: Vec<BodyId> = mechanism.body_ids().filter(|&b| mechanism.body(b).role == Role::Member).collect();
    let mut places = vec![None; mechanism.bodies.len()];
    for (index, member) in members.iter().enumerate() {
        places[member.0] = Some(index);
    }
    let given = mechanism.joints.len();
    let pins = pins(mechanism);
    mechanism.joints.extend(pins.iter().flat_map(Pin::joints));
    let index = |b: BodyId| places[mechanism.lead(b).0];
    let edge = |joint: &Joint| {
        let slides =
            joint.angular.iter().filter_map(|angular| angular.travel.as_ref()).flat_map(|travel| &travel.slides);
        let sliding = slides.map(|(id, _)| mechanism.slider(*id)).flat_map(|slider| [slider.on, slider.link]);
        let related = joint.related_bodies().chain(sliding).filter_map(index).collect();
        Edge { ends: joint.bodies.map(index), constraints: joint.constraints(), related }
    };
    let mut edges: Vec<Edge> = mechanism.joints.iter().map(edge).collect();
    let shared: Vec<&Pin> = pins.iter().filter(|pin| pin.hub.is_none()).collect();
    for (number, pin) in shared.iter().enumerate() {
        for &body in &pin.bodies {
            edges.push(Edge::pin([index(body), Some(members.len() + number)]));
        }
    }
    let (mut surplus, mut over) = mechanism.surplus();
    let (mut missing, mut under) = (0, Vec::new());
    let links = |found: Vec<usize>| found.into_iter().flat_map(|i| mechanism.compound(members[i]));
    let components = match structure(members.len(), shared.len(), &edges) {
        Structure::Groups(components) => components,
        Structure::Misfit { under: movable, missing: free, over: fixed, surplus: more } => {
            under.extend(links(movable));
            over.extend(links(fixed));
            missing += free;
            surplus += more;
            Vec::new()
        }
    };
    if missing + surplus > 0 {
        over.sort_unstable();
        over.dedup();
        return Err(StructureError::misfit(scene, mechanism, &under, missing, &over, surplus));
    }
    if members.is_empty() {
        return Err(scene.error_at(&["links"], says::nothing_to_solve(), Some(says::add_links())).into());
    }
    let mut rank = vec![None; mechanism.bodies.len()];
    for (number, component) in components.iter().enumerate() {
        component.links.iter().for_each(|&link| rank[members[link].0] = Some(number));
    }
    mechanism.joints.truncate(given);
    let mut met = Vec::new();
    for pin in pins {
        let from = mechanism.joints.len();
        let rank = |&body: &BodyId| rank[mechanism.lead(body).0];
        let first = pin.bodies.iter().map(rank).min().flatten();
        let here: Vec<BodyId> = pin.bodies.iter().copied().filter(|body| rank(body) == first).collect();
        let hub = pin.hub.or_else(|| mechanism.fixed_in(pin.point).filter(|body| here.contains(body)));
        let pin = Pin { hub: hub.or(here.first().copied()), ..pin };
        mechanism.joints.extend(pin.joints());
        let has_choice =
            |first: &usize| hub.is_none() && here.len() > 2 && components[*first].links.len() == CLASS_OF_CHOICE;
        met.extend(first.filter(has_choice).map(|first| (first, from, pin, here)));
    }
    let rank = |body: BodyId| rank[mechanism.lead(body).0];
    let mut joints = vec![Vec::new(); components.len()];
    for (id, joint) in mechanism.joint_ids().zip(&mechanism.joints) {
        let [a, b] = joint.bodies;
        if let Some(own) = rank(a).max(rank(b)).filter(|_| mechanism.lead(a) != mechanism.lead(b)) {
            joints[own].push(id);
        }
    }
    // There the pin is at the link with which the group has the lowest class.
    for (first, from, pin, here) in met {
        let links: Vec<BodyId> = components[first].links.iter().map(|&link| members[link]).collect();
        let mut class = |hub: BodyId| {
            let joints_of_pin = Pin { hub: Some(hub), ..pin.clone() }.joints().collect::<Vec<Joint>>();
            mechanism.joints.splice(from..from + joints_of_pin.len(), joints_of_pin);
            group(mechanism, &links, &joints[first]).class
        };
        if let Some(&hub) = here.iter().min_by_key(|&&hub| class(hub)) {
            class(hub);
        }
    }
    for (component, joints) in components.iter().zip(joints).filter(|(component, _)| !component.links.is_empty()) {
        let links: Vec<BodyId> = component.links.iter().map(|&i| members[i]).collect();
        let group = group(mechanism, &links, &joints);
        if group.is_singular_by_structure(mechanism) || !LoopEquations::new(mechanism, &group).is_square() {
            return Err(StructureError::Singular {
                links: group.link_names(mechanism),
                class: group.class.numeral(),
                pattern: group.pattern(mechanism),
            });
        }
        if group.loops.is_empty() && !turns_definitely(&LoopEquations::new(mechanism, &group)) {
            let message = says::train_without_ratio(group.link_names(mechanism));
            return Err(scene.error_at(&["gears"], message, Some(says::other_teeth())).into());
        }
        mechanism.groups.push(group);
    }
    Ok(())
}

/// Number of links of a group whose class depends on the link at which a pin is where three or more of its links meet first: two links meet at no
/// such pin, and groups of more are of higher class at any.
const CLASS_OF_CHOICE: usize = 4;

/// The bodies that share a point.
#[derive(Clone, Debug)]
struct Pin {
    point: PointId,
    bodies: Vec<BodyId>,
    /// The one at which its joints are; `None` where three or more links of unknown motion, and no others, share it.
    hub: Option<BodyId>,
}

impl Pin {
    fn joints(&self) -> impl Iterator<Item = Joint> {
        let joint = |hub| self.bodies.iter().filter(move |&&body| body != hub).map(move |&body| (hub, body));
        self.hub.into_iter().flat_map(joint).map(|(hub, body)| Joint::pin(self.point, [hub, body]))
    }
}

/// The points that bodies share: each at the first of known motion.
fn pins(mechanism: &Mechanism) -> Vec<Pin> {
    let shared = mechanism.point_ids().zip(mechanism.holders()).filter(|(_, bodies)| bodies.len() > 1);
    let pin = |(point, bodies): (PointId, Vec<BodyId>)| {
        let known = bodies.iter().copied().find(|&body| mechanism.is_known(body));
        Pin { point, hub: known.or_else(|| bodies.first().copied().filter(|_| bodies.len() == 2)), bodies }
    };
    shared.map(pin).collect()
}

/// Whether the equations of a group without a loop, which are whole numbers and the same in every position, tell all angles.
fn turns_definitely(equations: &LoopEquations) -> bool {
    let matrix = equations.matrix(&[], &[]);
    let sizes: f64 = matrix.row_iter().map(|row| row.norm()).product();
    matrix.determinant().abs() > sizes * 1e-12
}

/// How positions are found where `link` is at `angle` degrees from +x and one drive has no position.
///
/// That drive is removed, and a carriage without mass or size holds the given link at its angle: the carriage slides
/// along y of the ground, and the link along x of the carriage. So the same groups, loops and assembly modes serve as
/// for a drive. `mechanism` has its bodies and sliders, but neither compound links nor pins yet.
///
/// # Errors
/// The angle does not depend on the drive: one part of the mechanism then has a constraint too many, another one too
/// few.
fn placing(scene: &Scene, mut mechanism: Mechanism, link: &str, angle: f64) -> Result<Placing, StructureError> {
    for body in &mut mechanism.bodies {
        if matches!(body.role, Role::Driver { angle: None, .. }) {
            body.role = Role::Member;
        }
    }
    for slider in &mut mechanism.sliders {
        slider.drive = slider.drive.filter(|drive| drive.position.is_some());
    }
    mechanism.join_driven();
    let held = mechanism.link(link).expect("it is a link of the scene");
    add_carriage(&mut mechanism, held, angle);
    add_groups(scene, &mut mechanism).map_err(|_| {
        let path = ["links", link, "angle"];
        StructureError::from(scene.error_at(&path, says::angle_of_another(link), Some(says::angle_in_drive())))
    })?;
    Ok(Placing { link: held, angle, mechanism })
}

/// Adds the carriage on which `link` keeps its angle, in degrees from +x.
fn add_carriage(mechanism: &mut Mechanism, link: BodyId, angle: f64) {
    let carriage = BodyId(mechanism.bodies.len());
    mechanism.bodies.push(Body {
        name: String::new(),
        points: Vec::new(),
        local: Vec::new(),
        role: Role::Member,
        block: true,
    });
    // Both sliders hold the link's first point; the choice only changes the zero of their positions.
    let points = &mechanism.body(link).points;
    let at = *points.first().expect("a link given by lengths has a point");
    // Positions count from a point of the ground, so that no digits are lost where the origin is far away.
    let ground = mechanism.origin.and_then(|point| mechanism.body(GROUND).local_of(point));
    // The carriage does not turn: from its guide, at 90°, to its axis are −90°.
    let slides = [(GROUND, carriage, ground, Vector::y(), -90.0), (carriage, link, None, Vector::x(), angle)];
    for (on, link, through, direction, turned) in slides {
        let through = through.unwrap_or_else(Point::origin);
        let guide = Guide::Local { through, direction };
        let slider = Slider {
            link,
            at,
            on,
            guide,
            counted_from: None,
            turned,
            drive: None,
            travel: None,
            is_contact: false,
            given: None,
        };
        mechanism.add_slider(slider);
    }
}

/// The points of a link given by lengths, in its own frame; what the drives determine is found where it is asked for.
fn shaped<'s, F: FnOnce() -> IndexMap<&'s str, Point>>(
    scene: &Scene,
    link: &Link,
    driven: &LazyCell<IndexMap<&'s str, Point>, F>,
) -> (Vec<Point>, Side) {
    let of = |places: &IndexMap<String, [f64; 2]>, point: &str| places.get(point).map(|&place| Point::from(place));
    let place = |point: &str| {
        let given = of(&scene.coordinates, point).or_else(|| driven.get(point).copied());
        given.or_else(|| of(&scene.near.points, point))
    };
    let (local, side) = local_points(link, place);
    (points_in_order(link).into_iter().map(|index| local[index]).collect(), side)
}

/// Names in their order, whatever that of the file is: so nothing that is found depends on the file's.
fn in_order<'s>(names: impl IntoIterator<Item = &'s String>) -> impl Iterator<Item = &'s String> {
    let mut names: Vec<&String> = names.into_iter().collect();
    names.sort_by(|one, other| by_name(one, other));
    names.into_iter()
}

/// The links in the order of their names.
fn links_in_order(scene: &Scene) -> Vec<(&String, &Link)> {
    let mut links: Vec<(&String, &Link)> = scene.links.iter().collect();
    links.sort_by(|(one, _), (other, _)| by_name(one, other));
    links
}

/// The indices of a link's points: the two of its axis, then the others in the order of their names.
fn points_in_order(link: &Link) -> Vec<usize> {
    let mut order: Vec<usize> = (0..link.points.len()).collect();
    if let Some(others) = order.get_mut(2..) {
        others.sort_by(|&one, &other| by_name(&link.points[one], &link.points[other]));
    }
    order
}

/// A mechanism of the scene's points and bodies, without joints.
fn bodies(scene: &Scene, mirrored: &[&str]) -> Result<Mechanism, StructureError> {
    let links = links_in_order(scene);
    let of_links =
        links.iter().flat_map(|(_, link)| points_in_order(link).into_iter().map(|index| &link.points[index]));
    let names: IndexSet<&String> =
        in_order(&scene.ground).chain(of_links).chain(in_order(scene.known.keys())).collect();
    let given = |name: &str| scene.coordinates.get(name).map(|&place| Point::from(place));
    let mut mechanism = Mechanism {
        time: scene.units.time,
        given_by: scene.given_by,
        points: names.iter().map(|&name| name.clone()).collect(),
        given: names.iter().map(|name| given(name)).collect(),
        loads: scene.loads.as_ref().map(|loads| {
            let factor = scene.units.force_of_mass_times_acceleration();
            Arc::new(((**loads).clone(), factor))
        }),
        ..Mechanism::default()
    };
    let body = |name: &str, points: &mut dyn Iterator<Item = &String>, role: Role, local: Vec<Point>| Body {
        name: name.to_owned(),
        points: points.filter_map(|point| names.get_index_of(point)).map(PointId).collect(),
        local,
        role,
        block: false,
    };
    let ground_places = in_order(&scene.ground).filter_map(|name| given(name)).collect();
    mechanism.bodies.push(body("ground", &mut in_order(&scene.ground), Role::Ground, ground_places));
    mechanism.origin = scene.ground.first().and_then(|name| names.get_index_of(name)).map(PointId);
    let driven = LazyCell::new(|| places_from_drives(scene));
    for (name, link) in links {
        let role = role(scene, &mechanism, name, link)?;
        let mut local = Vec::new();
        if scene.given_by == GivenBy::Lengths {
            let side;
            (local, side) = shaped(scene, link, &driven);
            if side == Side::Doubtful {
                mechanism.doubtful_sides.push(BodyId(mechanism.bodies.len()));
            }
            if mirrored.contains(&name.as_str()) {
                local.iter_mut().for_each(|point| point.y = -point.y);
            }
            if side == Side::Unknown {
                mechanism.warnings.push(says::mirror_image(name, link.points.join("-")));
            }
        }
        let mut points = points_in_order(link).into_iter().map(|index| &link.points[index]);
        mechanism.bodies.push(body(name, &mut points, role, local));
    }
    for name in in_order(scene.known.keys()) {
        let motion = &scene.known[name];
        let role = Role::Carrier { velocity: motion.velocity.into(), acceleration: motion.acceleration.into() };
        mechanism.bodies.push(body(name, &mut std::iter::once(name), role, Vec::new()));
    }
    Ok(mechanism)
}

impl StructureError {
    /// Links with `missing` free motions too many (`under`) and links with `surplus` constraints too many (`over`).
    fn misfit(
        scene: &Scene,
        mechanism: &Mechanism,
        under: &[BodyId],
        missing: usize,
        over: &[BodyId],
        surplus: usize,
    ) -> Self {
        let names = |links: &[BodyId]| {
            let names = links.iter().map(|&b| mechanism.body(b).name.as_str());
            let names = names.collect::<Vec<_>>().join(", ");
            if links.len() == 1 { says::one_link(names) } else { says::several_links(names) }
        };
        let mut parts = Vec::new();
        let mut hints = Vec::new();
        if !under.is_empty() {
            let free = if missing == 1 { says::one_free_motion() } else { says::free_motions(missing) };
            parts.push(says::can_still_move(names(under), free));
            hints.push(if missing == 1 { says::add_a_drive() } else { says::add_drives(missing) });
        }
        if !over.is_empty() {
            let surplus = if surplus == 1 { says::one_constraint() } else { says::constraints(surplus) };
            parts.push(says::cannot_move(names(over), surplus));
            hints.push(says::take_away());
        }
        parts.extend(mobility(scene, missing, surplus));
        let hint = Some(Message::list(hints, "; "));
        scene.error_at(&["links"], Message::list(parts, "; "), hint).into()
    }
}

/// The mobility of the joined links without drives, by the count of Grübler, beside the number of drives; `None` where motions are given otherwise than by
/// drives.
fn mobility(scene: &Scene, missing: usize, surplus: usize) -> Option<Message> {
    if !scene.known.is_empty() || scene.links.values().any(|link| link.motion.is_some()) {
        return None;
    }
    let turning = scene.links.values().filter(|link| link.drive.is_some()).count();
    let drives = turning + scene.sliders.iter().filter(|slider| slider.drive.is_some()).count();
    let links = scene.links.len();
    // The freedoms of the links that are joined but not driven: as many as drives, and those missing, less surplus constraints.
    let mobility = (drives + missing) as i64 - surplus as i64;
    let constraints = 3 * links as i64 - mobility;
    let drives = if drives == 1 { says::one_drive() } else { says::drives(drives) };
    Some(says::mobility(links, constraints, mobility, drives))
}

/// Digits of a mechanism's shape below which there is a warning.
const FEW_DIGITS: f64 = 8.0;

/// The warning of an origin so far away that f64 leaves places few digits of the mechanism's own shape.
fn far_origin_warning(scene: &Scene) -> Option<Message> {
    let places = || scene.coordinates.values().map(|&place| Point::from(place));
    let far = places().map(|place| place.coords.amax()).fold(0.0, f64::max);
    let lengths = scene.links.values().flat_map(|link| match &link.shape {
        Shape::Lengths(lengths) => lengths.iter().map(|length| length.value).collect(),
        Shape::Local(places) => places.values().flat_map(|place| place.map(f64::abs)).collect(),
        Shape::Bare => Vec::new(),
    });
    let size = lengths.fold(span(places()), f64::max);
    let digits = libm::log10(size / (far * UNIT_ROUNDOFF));
    let about = |x: f64| format!("{x:.1e}");
    let is_far = far > 0.0 && size > 0.0 && digits < FEW_DIGITS;
    is_far.then(|| says::far_origin(about(far), about(size), format!("{:.0}", digits.max(0.0))))
}

/// Most by which a rounded angle may differ from a multiple of 15° in radians.
const ROUNDED: f64 = 1e-3;

/// Warnings of angles that are near multiples of π/12, less than a turn in radians, and no round number of degrees.
fn radians_warnings(scene: &Scene) -> Vec<Message> {
    let links = scene.links.iter().filter_map(|(name, link)| {
        let angle = link.angle_deg.or(link.drive.and_then(|drive| drive.angle_deg))?;
        Some((says::angle_of_link(name), angle))
    });
    let sliders = scene.sliders.iter().filter_map(|slider| match slider.along {
        Along::Degrees(angle) => {
            let slides = slider.link.as_ref().or(slider.pin.as_ref())?;
            Some((says::guide_of(slides), angle))
        }
        _ => None,
    });
    let near = scene.near.angles_deg.iter().map(|(name, &angle)| (says::near_angle_of(name), angle));
    let all = links.chain(sliders).chain(near);
    let warning = |(what, angle): (Message, f64)| Some(says::radians(what, angle, degrees_meant(angle)?));
    all.filter_map(warning).collect()
}

/// Least angle in degrees between a guide and what looks like lying along it in the same drawing.
const BENT: f64 = 0.5;

/// Warnings of sliding links and carriers whose shapes are places of one drawing: there the slider's points lie along the guide, but without
/// `turned` the x axis of its shape does.
fn guides_from_drawings(scene: &Scene) -> Vec<Message> {
    let shape = |link: &str| match &scene.links.get(link)?.shape {
        Shape::Local(places) => Some(places),
        _ => None,
    };
    let warning = |slider: &crate::scene::Slider| {
        let link = slider.link.as_deref().filter(|_| slider.turned_deg == 0.0)?;
        let On::Link(carrier) = &slider.on else { return None };
        let (own, carrier) = (shape(link)?, shape(carrier)?);
        let guide = match &slider.along {
            Along::Points(from, to) => degrees_between(*carrier.get(from)?, *carrier.get(to)?),
            Along::Direction([x, y]) => degrees_of(Vector::new(*x, *y)),
            Along::Degrees(degrees) => *degrees,
        };
        let mut places = own.iter();
        let ((first, from), (second, to)) = places.next().zip(places.next())?;
        let axis = without_sense(degrees_between(*from, *to), 0.0);
        let is_alike = (without_sense(guide, axis) - axis).abs() < BENT;
        let turned = format!("{}", libm::round(-axis * 1e4) / 1e4);
        let points = format!("{first}–{second}");
        (is_alike && axis.abs() > BENT).then(|| says::along_its_x_axis(link, points, turned))
    };
    scene.sliders.iter().filter_map(warning).collect()
}

/// The direction from one place to another, in degrees.
fn degrees_between(from: [f64; 2], to: [f64; 2]) -> f64 {
    degrees_of(Vector::from(to) - Vector::from(from))
}

/// The multiple of 15° that an angle is in radians; `None` where it looks like degrees.
fn degrees_meant(angle: f64) -> Option<f64> {
    let tenths = angle * 10.0;
    let is_round = (tenths - libm::round(tenths)).abs() < 1e-9;
    let step = PI / 12.0;
    let count = libm::round(angle / step);
    let is_near = count != 0.0 && (angle - count * step).abs() <= ROUNDED;
    (!is_round && is_near && angle.abs() < TAU + ROUNDED).then_some(15.0 * count)
}
