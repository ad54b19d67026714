//! Names of points and links within names of quantities, of points of the plans and of parts of the construction.

use super::names::{Named, Names};
use crate::construction::image_name;
use crate::scene::{Argument, QuantityName};

/// Where such names mean one point or one link, and the new name of it.
pub(super) struct Renamer<'a> {
    what: Named,
    from: &'a str,
    to: &'a str,
    points: Vec<String>,
    links: Vec<&'a String>,
}

impl<'a> Renamer<'a> {
    /// A new name for a point or a link.
    pub fn new(names: &'a Names, what: Named, from: &'a str, to: &'a str) -> Renamer<'a> {
        Renamer { what, from, to, points: names.points(), links: names.links.keys().collect() }
    }

    /// A name of the construction with the new name, if it means what is renamed: a point, a link, `S3`, `D_2`, `d`,
    /// `n_b3`, `3/2`.
    pub fn plan_name(&self, name: &str) -> Option<String> {
        if let Some((sliding, on)) = name.split_once('/') {
            return self.slider(sliding, on);
        }
        match self.what {
            _ if name == self.from => Some(self.to.to_owned()),
            Named::Point => self.of_point(name),
            Named::Link => self.of_link(name),
        }
    }

    /// The name of a quantity with the new name, if it means what is renamed.
    pub fn quantity(&self, name: &str) -> Option<String> {
        QuantityName::reworded(name, |argument, name| match (argument, self.what) {
            (Argument::Slider, _) => name.split_once('/').and_then(|(sliding, on)| self.slider(sliding, on)),
            (Argument::Link, Named::Link) => (name == self.from).then(|| self.to.to_owned()),
            (Argument::Link, Named::Point) => None,
            (Argument::Point, _) => self.plan_name(name),
        })
    }

    /// The name of a slider, as `3/2`, `P/3` or `P/3#2`.
    fn slider(&self, sliding: &str, on: &str) -> Option<String> {
        let (on, number) = on.split_at(on.find('#').unwrap_or(on.len()));
        let new = |name: &str| if name.trim() == self.from { self.to.to_owned() } else { name.to_owned() };
        let is_link = self.links.iter().any(|link| *link == sliding.trim());
        let (first, second) = match self.what {
            Named::Link => (new(sliding), new(on)),
            Named::Point if is_link => return None,
            Named::Point => (new(sliding), on.to_owned()),
        };
        (first != sliding || second != on).then(|| format!("{first}/{second}{number}"))
    }

    fn of_point(&self, name: &str) -> Option<String> {
        let (from, to) = (self.from, self.to);
        if name == image_name(from) {
            return Some(image_name(to));
        }
        let under = self.links.iter().map(|link| [from, to].map(|point| format!("{point}_{link}")));
        renamed(name, under).or_else(|| {
            let (mark, image, tail) = self.part(name)?;
            (image == from).then(|| format!("{mark}{}{tail}", image_name(to)))
        })
    }

    fn of_link(&self, name: &str) -> Option<String> {
        let (from, to) = (self.from, self.to);
        for special in ["S", "s"] {
            if name.strip_prefix(special) == Some(from) {
                return Some(format!("{special}{to}"));
            }
        }
        let under = self.points.iter().map(|point| [from, to].map(|link| format!("{point}_{link}")));
        renamed(name, under).or_else(|| {
            let (mark, image, tail) = self.part(name)?;
            (tail == from).then(|| format!("{mark}{}{to}", image_name(image)))
        })
    }

    /// A part of a plan, as `n_b3`: its mark, the point from whose image it is laid off, and its link.
    fn part<'n>(&self, name: &'n str) -> Option<(&'n str, &str, &'n str)> {
        let (mark, rest) =
            ["n_", "r_", "k_"].iter().find_map(|mark| name.strip_prefix(mark).map(|rest| (&name[..2], rest)))?;
        let of = |point: &'_ String| rest.strip_prefix(&image_name(point)).filter(|tail| !tail.is_empty());
        let found = self.points.iter().filter_map(|point| Some((point, of(point)?)));
        let (point, tail) = found.min_by_key(|(_, tail)| tail.len())?;
        Some((mark, point, tail))
    }
}

/// The new name of what has one of these old ones, or of its image.
fn renamed(name: &str, mut all: impl Iterator<Item = [String; 2]>) -> Option<String> {
    all.find_map(|[old, new]| match name == old {
        true => Some(new),
        false => (name == image_name(&old)).then(|| image_name(&new)),
    })
}
