//! Lengths, shapes and angles of the links that have the joint.

use super::Change;
use crate::editing::drive::{near_to, number_at, turning};
use crate::editing::measure::Decimals;
use crate::editing::measure::shape_place;
use crate::geometry::{Point, degrees_of, direction_of_degrees};
use crate::scene::{Length, Link, Shape};

impl Change<'_> {
    /// The numbers of all links that have the point, and what counts from their axes.
    pub fn add_links(&mut self) {
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
        let new: Vec<bool> = lengths.iter().map(is_new).collect();
        if let [a, b, c] = values.as_mut_slice() {
            close([a, b, c], [new[0], new[1], new[2]], self.decimals);
            self.tell_side(link, joint);
        }
        for (length, value) in lengths.iter().zip(&values).filter(|(length, _)| is_new(length)) {
            self.put(&["links", name, "lengths", &length.key], crate::editing::measure::json(*value));
        }
        let axis = &link.points[..2];
        if !axis.iter().any(|end| end == joint) {
            return None;
        }
        let ends = [0, 1].map(|index| self.place(&axis[index], joint, place));
        self.add_axis(name, degrees_of(ends[1] - ends[0]));
        let angle = link.drive.as_ref()?.angle_deg?;
        let turned = near_to(degrees_of(ends[1] - ends[0]), angle);
        let direction = direction_of_degrees(Decimals::ANGLE.round(turned));
        let along = lengths.iter().position(|length| axis.contains(&length.from) && axis.contains(&length.to))?;
        // The pivot is on the ground; a joint that is the pivot itself is where it was pulled to.
        match self.solved.scene.ground.contains(&axis[0]) {
            true => Some(ends[0] + direction * values[along]),
            false => Some(ends[1] - direction * values[along]),
        }
        .filter(|_| !self.solved.scene.ground.iter().any(|point| point == joint))
    }

    /// What counts from the axis of a link: given angles, rough angles, guides on it, its own turn on a guide.
    fn add_axis(&mut self, link: &str, axis: f64) {
        let angle = |new: f64, old: Option<f64>| Decimals::ANGLE.json(near_to(new, old.unwrap_or(0.0)));
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
}

/// Lets three rounded lengths form a triangle, or a straight link: only new ones change.
fn close(sides: [&mut f64; 3], is_new: [bool; 3], decimals: Decimals) {
    let values = sides.each_ref().map(|side| **side);
    let longest = (0..3).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    let others = [(longest + 1) % 3, (longest + 2) % 3];
    let excess = values[longest] - values[others[0]] - values[others[1]];
    if excess <= 0.0 {
        return;
    }
    let mended = if is_new[longest] {
        longest
    } else if is_new[others[0]] {
        others[0]
    } else {
        others[1]
    };
    for (index, side) in sides.into_iter().enumerate().filter(|(index, _)| *index == mended) {
        *side = if index == longest { values[others[0]] + values[others[1]] } else { *side + excess };
        // Lengths of other links have digits of their own.
        *side = decimals.finer(6).round(*side);
    }
}
