//! The numbers of a scene's text that change with the place of a point.

use super::held::{Lever, can_be_placed, contact_of, has_place, is_through, slides};
use crate::editing::measure::{Decimals, json, shape_place};
use crate::editing::position::{number_at, position_of, turning};
use crate::editing::present::Solved;
use crate::geometry::{Placement, Point, cross, degrees_of, direction_of_degrees, with_turns};
use crate::mechanism::{GROUND, PointId};
use crate::position::Pose;
use crate::scene::{Along, Equivalent, GivenBy, Length, Link, On, Shape, Slider};
use serde_json::Value as Json;

/// Decimals of a phase, which wheels of many teeth multiply.
const PHASE: Decimals = Decimals(4);

/// The numbers of a scene's text that change with the place of a point.
pub(super) struct Change<'a> {
    pub solved: &'a Solved,
    pub json: &'a Json,
    pub point: PointId,
    pub decimals: Decimals,
    /// The position that is wanted, with the point at its new place.
    pub pose: &'a Pose,
    /// Links that turn as they are.
    pub levers: &'a [Lever],
    /// Paths and new values.
    pub values: Vec<(Vec<String>, Json)>,
}

impl Change<'_> {
    /// All of them.
    pub fn add_all(&mut self) {
        let name = self.solved.mechanism.point_name(self.point).to_owned();
        let place = self.pose.point(self.point);
        let exact = Decimals(self.decimals.0 + 2);
        for table in ["ground", "points", "near"] {
            if self.json[table].get(&name).is_some() {
                self.put(&[table, &name], exact.place_json(place));
            }
        }
        if self.solved.scene.given_by == GivenBy::Lengths {
            self.add_links();
            self.add_guides();
            self.add_levers();
            self.add_wheels();
        }
    }

    /// Puts a value at a path.
    fn put(&mut self, path: &[&str], value: Json) {
        self.values.push((path.iter().map(|&part| part.to_owned()).collect(), value));
    }

    /// The numbers of all links that have the point, and what counts from their axes.
    fn add_links(&mut self) {
        let solved = self.solved;
        let name = solved.mechanism.point_name(self.point);
        let turns = |link: &str| self.levers.iter().any(|lever| solved.mechanism.body(lever.link).name == link);
        let with_point = solved.scene.links.iter();
        let with_point =
            with_point.filter(|(link, entry)| entry.points.iter().any(|point| point == name) && !turns(link));
        // A driven link first: where its rounded length and angle put the joint, the others are measured to.
        let mut links: Vec<(&String, &Link)> = with_point.collect();
        links.sort_by_key(|(_, link)| link.drive.is_none());
        let mut place = self.pose.point(self.point);
        for (link_name, link) in links {
            if let Some((contact, radii)) = self.contact_of_link(link_name) {
                self.add_radius(contact, link, radii, name, place);
                continue;
            }
            match &link.shape {
                Shape::Bare => {}
                Shape::Local(_) => self.add_shape(link_name, name, place),
                Shape::Lengths(lengths) => {
                    if let Some(seated) = self.add_lengths(link_name, link, lengths, name, place) {
                        place = seated;
                    }
                }
            }
        }
    }

    /// The contact, by its index, for which a link stands, and its radii.
    fn contact_of_link(&self, link: &str) -> Option<(usize, [f64; 2])> {
        let contacts = self.solved.scene.contacts.iter().enumerate();
        contacts.into_iter().find_map(|(index, contact)| match &contact.equivalent {
            Equivalent::Link { name, radii, .. } if name == link => Some((index, (*radii)?)),
            _ => None,
        })
    }

    /// The radius by which an equivalent link reaches the joint: that of the first profile, as of the cam, unless it would turn round or hollow.
    fn add_radius(&mut self, contact: usize, link: &Link, [first, second]: [f64; 2], joint: &str, place: Point) {
        let ends = [0, 1].map(|index| self.place(&link.points[index], joint, place));
        let sum = self.decimals.round((ends[1] - ends[0]).norm()).copysign(first + second);
        let (index, other) = if (sum - second) * first > 0.0 { ("0", second) } else { ("1", first) };
        self.put(&["contacts", &contact.to_string(), "radii", index], json(self.decimals.finer(3).round(sum - other)));
    }

    /// The place of a point with the joint at `place`.
    fn place(&self, point: &str, joint: &str, place: Point) -> Point {
        match self.solved.mechanism.point(point) {
            Some(id) if point != joint => self.pose.point(id),
            _ => place,
        }
    }

    fn add_shape(&mut self, link: &str, joint: &str, place: Point) {
        let placement = self.solved.mechanism.link(link).and_then(|id| self.solved.placement(id));
        if let Some(placement) = placement {
            let local = self.decimals.place(placement.inverse() * place);
            self.put(&["links", link, "shape", joint], shape_place(local));
        }
    }

    /// Lengths to the joint, and what counts from the link's axis; for a driven link the place where these put the joint.
    fn add_lengths(&mut self, name: &str, link: &Link, lengths: &[Length], joint: &str, place: Point) -> Option<Point> {
        let measured = |length: &Length| {
            let ends = [&length.from, &length.to].map(|end| self.place(end, joint, place));
            self.decimals.round((ends[1] - ends[0]).norm())
        };
        let is_new = |length: &Length| length.from == joint || length.to == joint;
        let values = lengths.iter().map(|length| if is_new(length) { measured(length) } else { length.value });
        let mut values: Vec<f64> = values.collect();
        if values.len() == 3 {
            let is_new: Vec<bool> = lengths.iter().map(is_new).collect();
            close(&mut values, &is_new, self.decimals);
            self.tell_side(link, joint);
        }
        for (length, value) in lengths.iter().zip(&values).filter(|(length, _)| is_new(length)) {
            self.put(&["links", name, "lengths", &length.key], json(*value));
        }
        let axis = &link.points[..2];
        if !axis.iter().any(|end| end == joint) {
            return None;
        }
        let ends = [0, 1].map(|index| self.place(&axis[index], joint, place));
        self.add_axis(name, degrees_of(ends[1] - ends[0]));
        let angle = link.drive.as_ref()?.angle_deg?;
        let turned = with_turns(degrees_of(ends[1] - ends[0]), angle);
        let direction = direction_of_degrees(Decimals::ANGLE.round(turned));
        let along = lengths.iter().position(|length| axis.contains(&length.from) && axis.contains(&length.to))?;
        // The pivot is on the ground; a joint that is the pivot itself is where it was pulled to.
        let (ground, arm) = (&self.solved.scene.ground, direction * values[along]);
        let place = if ground.contains(&axis[0]) { ends[0] + arm } else { ends[1] - arm };
        (!ground.iter().any(|point| point == joint)).then_some(place)
    }

    /// What counts from the axis of a link: given angles, rough angles, guides on it, its own turn on a guide.
    fn add_axis(&mut self, link: &str, axis: f64) {
        let angle = |new: f64, old: Option<f64>| Decimals::ANGLE.json(with_turns(new, old.unwrap_or(0.0)));
        if let Some(path) = turning(self.json, link) {
            let old = number_at(self.json, &path);
            self.values.push((path, angle(axis, old)));
        }
        let rough = format!("angle({link})");
        if let Some(old) = self.json["near"].get(&rough) {
            self.put(&["near", &rough], angle(axis, old.as_f64()));
        }
        self.turn_guides(link, axis);
    }

    /// Makes `near` tell on which side the third point of a triangle is.
    fn tell_side(&mut self, link: &Link, joint: &str) {
        let scene = &self.solved.scene;
        let is_told = |point: &String| scene.near.points.contains_key(point) || scene.ground.contains(point);
        let missing: Vec<&String> = link.points.iter().filter(|point| !is_told(point)).collect();
        for point in missing {
            let place = self.place(point, joint, self.pose.point(self.point));
            self.put(&["near", point], self.decimals.place_json(place));
        }
    }

    /// The places of guides that the joint slides on or that go through it, and positions on them that are given.
    fn add_guides(&mut self) {
        let solved = self.solved;
        let name = solved.mechanism.point_name(self.point);
        for (index, slider) in solved.scene.sliders.iter().enumerate() {
            let slides = slides(slider, name);
            let is_through = is_through(solved, slider, name);
            let id = solved.mechanism.given_slider(index);
            let turns = self.levers.iter().any(|lever| Some(lever.slider) == id);
            if (slides || is_through) && !turns {
                self.add_guide(index, slider, slides, is_through);
            }
        }
    }

    fn add_guide(&mut self, index: usize, slider: &Slider, slides: bool, is_through: bool) {
        let Some(id) = self.solved.mechanism.given_slider(index) else { return };
        let given = self.solved.mechanism.slider(id);
        let placement = match given.on {
            GROUND => Some(Placement::identity()),
            link => self.solved.placement(link),
        };
        let Some(placement) = placement else { return };
        let (local, direction) = given.line();
        let along = placement * direction;
        let names_end = matches!(&slider.along, Along::Points(..));
        let mut through = placement * local;
        let at = self.pose.point(given.at);
        let number = index.to_string();
        if let Some(contact) = contact_of(self.solved, index) {
            if slides {
                // The first body lies to the right of the flat profile.
                let radius = slider.beside - cross(along, at - through);
                self.put(&["contacts", &contact.to_string(), "radii", "0"], json(self.decimals.round(radius)));
            }
            return;
        }
        if slides && has_place(slider) {
            let off = (at - through) - along * along.dot(&(at - through));
            if off.norm() > 0.5 * self.decimals.step() {
                let moved = self.decimals.place(placement.inverse() * (through + off));
                through = placement * moved;
                self.put(&["sliders", &number, "through"], self.decimals.place_json(moved));
            }
        } else if is_through && !names_end && can_be_placed(self.solved, slider) {
            // The guide stays where it is.
            let place = [local.x, local.y].map(json);
            self.put(&["sliders", &number, "through"], place.to_vec().into());
        } else if is_through {
            through = self.pose.point(self.point);
        }
        if let Some(path) = position_of(self.json, index).filter(|_| given.drive.is_some()) {
            self.values.push((path, self.decimals.json(along.dot(&(at - through)))));
        }
    }

    /// Turns what counts from the axis of a link, which is now at `axis` degrees: guides on it keep their directions, and so does the
    /// link on its guide.
    fn turn_guides(&mut self, link: &str, axis: f64) {
        let solved = self.solved;
        for (index, slider) in solved.scene.sliders.iter().enumerate() {
            let number = index.to_string();
            let Some(id) = solved.mechanism.given_slider(index) else { continue };
            let guide = degrees_of(solved.pose.guide(id));
            if slider.on == On::Link(link.to_owned()) && !matches!(slider.along, Along::Points(..)) {
                let of_face = contact_of(solved, index).map(|contact| contact.to_string());
                let (list, entry) = of_face.as_ref().map_or(("sliders", &number), |contact| ("contacts", contact));
                let path = [list, entry, "along"];
                let old = number_at(self.json, &path.map(str::to_owned)).unwrap_or(0.0);
                self.put(&path, Decimals::ANGLE.json(with_turns(guide - axis, old)));
            }
            if slider.link.as_deref() == Some(link) {
                let turned = with_turns(axis - guide, slider.turned_deg);
                let is_new = (turned - slider.turned_deg).abs() > 0.5 * Decimals::ANGLE.step();
                if is_new {
                    self.put(&["sliders", &number, "turned"], Decimals::ANGLE.json(turned));
                }
            }
        }
    }

    /// Phases of wheels that turn with their points, or whose carriers do: the other wheels stay as they are.
    fn add_wheels(&mut self) {
        let gears = &self.solved.scene.gears;
        for (index, gear) in gears.iter().enumerate() {
            // On a rack a wheel turns with what slides.
            if gear.rack.is_some() {
                continue;
            }
            let [first, second] = gear.teeth.map(f64::from);
            let [turned, other] = [&gear.wheels[0], &gear.wheels[1]].map(|wheel| self.turned(wheel));
            let turned = (first * turned + second * other - (first + second) * self.turned(&gear.on)) / second;
            let phase = PHASE.round(gear.phase_deg + turned);
            if (phase - gear.phase_deg).abs() > PHASE.step() {
                self.put(&["gears", &index.to_string(), "phase"], json(phase));
            }
        }
    }

    /// By how many degrees a body has turned.
    fn turned(&self, body: &On) -> f64 {
        let On::Link(name) = body else { return 0.0 };
        let drive = turning(self.json, name).and_then(|path| {
            let new = self.values.iter().rev().find(|(own, _)| *own == path)?.1.as_f64()?;
            Some(new - number_at(self.json, &path)?)
        });
        let of_points = || {
            let [a, b] = self.solved.scene.links.get(name)?.points.get(..2)? else { return None };
            let [a, b] = [self.solved.mechanism.point(a)?, self.solved.mechanism.point(b)?];
            let [old, new] = [&self.solved.pose, self.pose].map(|pose| degrees_of(pose.arm(a, b)));
            Some(with_turns(new - old, 0.0))
        };
        drive.or_else(of_points).unwrap_or(0.0)
    }

    /// Rough places and angles of levers that turn.
    fn add_levers(&mut self) {
        let solved = self.solved;
        for lever in self.levers {
            let body = solved.mechanism.body(lever.link);
            let pulled = self.point;
            for point in body.points.iter().filter(|point| **point != pulled) {
                let name = solved.mechanism.point_name(*point);
                if self.json["near"].get(name).is_some() {
                    self.put(&["near", name], self.decimals.place_json(self.pose.point(*point)));
                }
            }
            let rough = format!("angle({})", body.name);
            if let Some(axis) = self.pose.axes[lever.link.0].filter(|_| self.json["near"].get(&rough).is_some()) {
                self.put(&["near", &rough], Decimals::ANGLE.json(degrees_of(axis)));
            }
        }
    }
}

/// Lets three rounded lengths form a triangle, or a straight link: only new ones change.
fn close(sides: &mut [f64], is_new: &[bool], decimals: Decimals) {
    let longest = (0..3).max_by(|&a, &b| sides[a].total_cmp(&sides[b])).unwrap_or(0);
    let [one, other] = [(longest + 1) % 3, (longest + 2) % 3];
    let excess = sides[longest] - sides[one] - sides[other];
    if excess <= 0.0 {
        return;
    }
    let mended = [longest, one].into_iter().find(|side| is_new[*side]).unwrap_or(other);
    let closing = if mended == longest { sides[one] + sides[other] } else { sides[mended] + excess };
    // Lengths of other links have digits of their own.
    sides[mended] = decimals.finer(6).round(closing);
}
