//! All names of a scene: the points of each link, and the names that results need.

use std::collections::{HashMap, HashSet};

use indexmap::{IndexMap, IndexSet};

use super::error::{Wrong, shortened, suggestion};
use super::link::Link;
use super::name::no_point;
use super::says;
use crate::message::Message;

/// Coordinates in the fixed frame, by the name of the point.
pub(super) type Coordinates = IndexMap<String, [f64; 2]>;

/// All names of a scene, and the points of each link.
#[derive(Debug)]
pub(super) struct Names<'a> {
    /// The frame's points, in file order.
    pub ground: &'a [String],
    /// The links, in file order.
    pub links: &'a IndexMap<String, Link>,
    on_ground: HashSet<&'a str>,
    on_link: HashSet<(&'a str, &'a str)>,
    points: HashSet<&'a str>,
    /// The first point of each name in lower case, which is the name of its image in the plans.
    images: HashMap<String, &'a str>,
}

impl<'a> Names<'a> {
    /// The names of the frame and the links.
    pub fn new(ground: &'a [String], links: &'a IndexMap<String, Link>) -> Names<'a> {
        let pairs = links.iter().flat_map(|(name, link)| link.points.iter().map(move |p| (name.as_str(), p.as_str())));
        let on_ground = ground.iter().map(String::as_str);
        let points = on_ground.clone().chain(pairs.clone().map(|(_, point)| point));
        let mut images = HashMap::new();
        for point in points.clone() {
            images.entry(point.to_lowercase()).or_insert(point);
        }
        Names {
            ground,
            links,
            images,
            on_ground: on_ground.collect(),
            on_link: pairs.collect(),
            points: points.collect(),
        }
    }

    /// Whether the point is on the frame.
    pub fn on_ground(&self, point: &str) -> bool {
        self.on_ground.contains(point)
    }

    /// Whether the point is on the link.
    pub fn on_link(&self, link: &str, point: &str) -> bool {
        self.on_link.contains(&(link, point))
    }

    /// Whether the point is on the frame or on any link.
    pub fn is_point(&self, point: &str) -> bool {
        self.points.contains(point)
    }

    /// The link of this name, or an error at `path` that suggests the nearest name.
    pub fn link(&self, path: &[&str], name: &str) -> Result<&'a Link, Wrong> {
        self.links.get(name).ok_or_else(|| {
            let hint = suggestion(name, self.links.keys().map(String::as_str), says::the_links_are);
            Wrong::value(path, says::no_link(shortened(name))).maybe_hint(hint)
        })
    }

    /// An error at `path` if there is no point of this name; it suggests the nearest.
    pub fn point(&self, path: &[&str], name: &str) -> Result<(), Wrong> {
        if self.is_point(name) {
            return Ok(());
        }
        let all = self.ground.iter().chain(self.links.values().flat_map(|link| &link.points)).map(String::as_str);
        let hint = suggestion(name, all.collect::<IndexSet<_>>(), says::the_points_are);
        Err(Wrong::value(path, says::no_point(shortened(name))).maybe_hint(hint))
    }

    /// An error at `path` if the point is not on the link; it lists the link's points.
    pub fn point_of_link(&self, path: &[&str], link: &str, point: &str) -> Result<(), Wrong> {
        if self.on_link(link, point) {
            return Ok(());
        }
        let points = self.links.get(link).map_or(&[][..], |link| &link.points);
        Err(Wrong::value(path, no_point(says::link_named(link), point, points)))
    }

    /// Refuses a name that results need: `S3` beside link 3, `D_2` beside link 2, `d` beside D.
    pub fn check_reserved(&self, point: &str) -> Result<(), Wrong> {
        let reserved = |what: Message| Err(Wrong::key(&[], says::name_kept(point, what)).hint(says::other_name()));
        if let Some(first) = self.images.get(&point.to_lowercase()).filter(|first| **first != point) {
            return reserved(says::image_of(*first));
        }
        if let Some(link) = point.strip_prefix('S').filter(|link| self.links.contains_key(*link)) {
            return reserved(says::special_point_of(link));
        }
        for (at, _) in point.match_indices('_') {
            let (before, link) = (&point[..at], &point[at + 1..]);
            if !before.is_empty() && self.links.contains_key(link) {
                return reserved(says::point_under(link, before));
            }
        }
        Ok(())
    }
}
