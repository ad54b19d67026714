//! Names of points and links: what they may be made of, and which are kept for results.

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use super::error::SceneError;
use super::link::Link;
use super::place::Source;
use super::words::{close, list, shortened, suggestion};

/// The longest name, in characters.
const LONGEST: usize = 64;

/// Checks what a name is made of; `what` is "a point" or "a link".
pub(super) fn check_name(what: &str, name: &str) -> Result<(), (String, Option<String>)> {
    if name.is_empty() {
        return Err((format!("{what} has no name"), Some("write a letter or a number between the quotes".into())));
    }
    if name.chars().count() > LONGEST {
        return Err((format!("the name of {what} has more than {LONGEST} characters"), None));
    }
    if let Some(bad) = name.chars().find(|c| !(c.is_alphanumeric() || *c == '\'' || *c == '_')) {
        let hint = match bad {
            '′' | '’' | '`' | '´' => "write ' for a prime",
            '-' => "write _ in place of -, which joins two points",
            _ => "names have letters, digits, ' and _",
        };
        let bad = bad.escape_debug();
        return Err((format!("the name `{}` of {what} contains `{bad}`", shortened(name)), Some(hint.into())));
    }
    if name == "note" {
        return Err((format!("{what} cannot be called `note`: that key is for notes"), None));
    }
    if what == "a link" && name == "ground" {
        return Err(("a link cannot be called `ground`: that is the frame".into(), None));
    }
    Ok(())
}

/// All names of a scene, and which point is on which link.
#[derive(Debug)]
pub(super) struct Names<'a> {
    source: Source<'a>,
    /// The frame's points, in file order.
    ground: &'a [String],
    links: &'a IndexMap<String, Link>,
    on_ground: HashSet<&'a str>,
    on_link: HashSet<(&'a str, &'a str)>,
    on_any_link: HashSet<&'a str>,
    /// The first point of each name in lower case, which is its image in the plans.
    images: HashMap<String, &'a str>,
}

impl<'a> Names<'a> {
    /// The names of the frame and the links.
    pub fn new(source: Source<'a>, ground: &'a [String], links: &'a IndexMap<String, Link>) -> Names<'a> {
        let pairs = links.iter().flat_map(|(name, link)| link.points.iter().map(move |p| (name.as_str(), p.as_str())));
        let mut images = HashMap::new();
        let on_links = links.values().flat_map(|link| &link.points);
        for point in ground.iter().chain(on_links) {
            images.entry(point.to_lowercase()).or_insert(point.as_str());
        }
        Names {
            source,
            ground,
            links,
            images,
            on_ground: ground.iter().map(String::as_str).collect(),
            on_any_link: pairs.clone().map(|(_, point)| point).collect(),
            on_link: pairs.collect(),
        }
    }

    /// The frame's points, in file order.
    pub fn ground(&self) -> &'a [String] {
        self.ground
    }

    /// The links, in file order.
    pub fn links(&self) -> &'a IndexMap<String, Link> {
        self.links
    }

    /// The link of this name.
    pub fn get(&self, link: &str) -> Option<&'a Link> {
        self.links.get(link)
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
        self.on_ground(point) || self.on_any_link.contains(point)
    }

    /// The link of this name, or an error at `path` that names the nearest.
    pub fn link(&self, path: &[&str], name: &str) -> Result<&'a Link, SceneError> {
        self.links.get(name).ok_or_else(|| {
            let names = self.links.keys().map(String::as_str);
            self.source.error(path, format!("there is no link {}", shortened(name))).maybe_hint(suggestion(
                name,
                names,
                "the links are",
            ))
        })
    }

    /// An error at `path` if there is no point of this name; it names the nearest.
    pub fn point(&self, path: &[&str], name: &str) -> Result<(), SceneError> {
        if self.is_point(name) {
            return Ok(());
        }
        let mut names: Vec<&str> = self.ground.iter().map(String::as_str).collect();
        names.extend(self.links.values().flat_map(|link| &link.points).map(String::as_str));
        let mut seen = HashSet::new();
        names.retain(|name| seen.insert(*name));
        Err(self.source.error(path, format!("there is no point {}", shortened(name))).maybe_hint(suggestion(
            name,
            names.iter().copied(),
            "the points are",
        )))
    }

    /// An error at `path` if the point is not on the link; it names the link's points.
    pub fn point_of_link(&self, path: &[&str], link: &str, point: &str) -> Result<(), SceneError> {
        if self.on_link(link, point) {
            return Ok(());
        }
        let points = self.links.get(link).map_or(&[][..], |link| &link.points);
        Err(self.source.error(path, no_point(&format!("link {link}"), point, points)))
    }

    /// What is wrong with a name that results need: `S3` beside link 3, `D_2` beside link 2, `d` beside D.
    pub fn check_reserved(&self, point: &str) -> Result<(), (String, Option<String>)> {
        let hint = Some("choose another name for the point".into());
        let first = self.images.get(&point.to_lowercase());
        if let Some(first) = first.filter(|first| **first != point) {
            return Err((format!("the name `{point}` is kept for the image of {first} in the plans"), hint));
        }
        if let Some(link) = point.strip_prefix('S').filter(|link| self.links.contains_key(*link)) {
            return Err((format!("the name `{point}` is kept for the special point of link {link}"), hint));
        }
        for (at, _) in point.match_indices('_') {
            let (before, link) = (&point[..at], &point[at + 1..]);
            if !before.is_empty() && self.links.contains_key(link) {
                return Err((format!("the name `{point}` is kept for the point of link {link} under {before}"), hint));
            }
        }
        Ok(())
    }
}

/// "link 4 has no point X; its points are G, D, F".
pub(super) fn no_point(carrier: &str, point: &str, points: &[String]) -> String {
    let point = shortened(point);
    match points {
        [] => format!("{carrier} has no point {point}; it has no points"),
        [only] => format!("{carrier} has no point {point}; its only point is {only}"),
        _ => format!("{carrier} has no point {point}; its points are {}", list(points.iter().map(String::as_str))),
    }
}

/// Why a key does not name two points.
pub(super) enum NotAPair {
    /// A name in it is no point of the carrier.
    Unknown(String),
    /// It can be cut in two ways.
    Ambiguous([String; 2], [String; 2]),
    /// Both names are the same.
    Same(String),
}

/// The two points that a key like `AB` or `A-B` names, among the points that `is_point` accepts.
pub(super) fn pair(key: &str, is_point: impl Fn(&str) -> bool) -> Result<(String, String), NotAPair> {
    let unknown = |name: &str| NotAPair::Unknown(name.to_owned());
    let (from, to) = if let Some((from, to)) = key.split_once('-') {
        if let Some(name) = [from, to].into_iter().find(|name| !is_point(name)) {
            return Err(unknown(name));
        }
        (from, to)
    } else if key.len() > 8 * LONGEST + 1 {
        return Err(unknown(key));
    } else {
        let cuts = key.char_indices().skip(1).map(|(at, _)| key.split_at(at));
        let mut pairs = cuts.clone().filter(|(from, to)| is_point(from) && is_point(to));
        match (pairs.next(), pairs.next()) {
            (Some(pair), None) => pair,
            (Some((a, b)), Some((c, d))) => {
                return Err(NotAPair::Ambiguous([a.into(), b.into()], [c.into(), d.into()]));
            }
            (None, _) => {
                // The part that is not a point: beside the longest part that is one.
                let known = cuts.flat_map(|(from, to)| [(from, to), (to, from)]).filter(|(part, _)| is_point(part));
                let rest = known.max_by_key(|(part, _)| part.len()).map_or(key, |(_, rest)| rest);
                return Err(unknown(rest));
            }
        }
    };
    match from == to {
        true => Err(NotAPair::Same(from.to_owned())),
        false => Ok((from.to_owned(), to.to_owned())),
    }
}

impl NotAPair {
    /// The message for a key of `carrier`, whose points are `points`, and a hint.
    pub fn explain(&self, what: &str, key: &str, carrier: &str, points: &[String]) -> (String, Option<String>) {
        let key = shortened(key);
        match self {
            NotAPair::Unknown(name) => {
                let hint = close(name, points.iter().map(String::as_str));
                (format!("{what} `{key}`: {}", no_point(carrier, name, points)), hint)
            }
            NotAPair::Ambiguous([a, b], [c, d]) => (
                format!("{what} `{key}` can mean {a} and {b}, or {c} and {d}"),
                Some(format!("write \"{a}-{b}\" or \"{c}-{d}\"")),
            ),
            NotAPair::Same(name) => (format!("{what} `{key}` names the point {name} twice"), None),
        }
    }
}
