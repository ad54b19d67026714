//! Names: the characters they may have, and keys that join two of them.

use std::cmp::Ordering;
use std::collections::HashSet;

use super::error::{Wrong, close, list, shortened};
use super::says;
use crate::message::Message;

/// Longest name, in characters.
const LONGEST: usize = 64;

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bearer {
    /// A point.
    Point,
    /// A link.
    Link,
}

impl Bearer {
    /// It in a sentence.
    fn told(self) -> Message {
        match self {
            Bearer::Point => says::a_point(),
            Bearer::Link => says::a_link(),
        }
    }
}

/// Refuses a name with other characters than allowed.
pub(super) fn check_name(what: Bearer, name: &str) -> Result<(), Wrong> {
    if name.is_empty() {
        return Err(Wrong::key(&[], says::no_name(what.told())).hint(says::write_a_name()));
    }
    if name.chars().count() > LONGEST {
        return Err(Wrong::key(&[], says::name_too_long(what.told(), LONGEST)));
    }
    if let Some(bad) = name.chars().find(|c| !(c.is_alphanumeric() || *c == '\'' || *c == '_')) {
        let hint = match bad {
            '′' | '’' | '`' | '´' => says::write_prime(),
            '-' => says::write_underscore(),
            _ => says::signs_of_names(),
        };
        let message = says::sign_in_name(shortened(name), what.told(), bad.escape_debug().to_string());
        return Err(Wrong::key(&[], message).hint(hint));
    }
    if name == "note" {
        return Err(Wrong::key(&[], says::called_note(what.told())));
    }
    if what == Bearer::Link && name == "ground" {
        return Err(Wrong::key(&[], says::called_ground()));
    }
    Ok(())
}

/// Refuses a list of points with an invalid name or with a name twice: those of a link, or of the ground.
pub(super) fn check_list(points: &[String], link: Option<&str>) -> Result<(), Wrong> {
    let mut seen = HashSet::new();
    for (index, point) in points.iter().enumerate() {
        let inside = |wrong: Wrong| wrong.inside(&[&index.to_string()]);
        check_name(Bearer::Point, point).map_err(inside)?;
        if !seen.insert(point) {
            let message = match link {
                Some(link) => says::point_twice_in_link(point, link),
                None => says::point_twice(point),
            };
            return Err(inside(Wrong::value(&[], message)));
        }
    }
    Ok(())
}

/// "link 4 has no point X; its points are G, D, F".
pub(super) fn no_point(carrier: Message, point: &str, points: &[String]) -> Message {
    let point = shortened(point);
    match points {
        [] => says::lacks_point(carrier, point),
        [only] => says::lacks_point_but(carrier, point, only),
        _ => says::lacks_point_of(carrier, point, list(points.iter().map(String::as_str))),
    }
}

/// The two points of a carrier that a key like `AB` or `A-B` names; `what` is the key in messages, `carrier` the carrier.
pub(super) fn checked_pair(
    what: fn(String) -> Message,
    key: &str,
    carrier: &Message,
    points: &[String],
    is_point: impl Fn(&str) -> bool,
) -> Result<(String, String), Wrong> {
    let shown = || what(shortened(key));
    let unknown = |name: &str| {
        let hint = close(name, points.iter().map(String::as_str));
        let why = no_point(carrier.clone(), name, points);
        Err(Wrong::key(&[], says::pair_unknown(shown(), why)).maybe_hint(hint))
    };
    let (from, to) = if let Some((from, to)) = key.split_once('-') {
        if let Some(name) = [from, to].into_iter().find(|name| !is_point(name)) {
            return unknown(name);
        }
        (from, to)
    } else if key.len() > 8 * LONGEST + 1 {
        return unknown(key);
    } else {
        let cuts = key.char_indices().skip(1).map(|(at, _)| key.split_at(at));
        let mut pairs = cuts.clone().filter(|(from, to)| is_point(from) && is_point(to));
        match (pairs.next(), pairs.next()) {
            (Some(pair), None) => pair,
            (Some((a, b)), Some((c, d))) => {
                let message = says::pair_ambiguous(shown(), a, b, c, d);
                return Err(Wrong::key(&[], message).hint(says::write_pair(a, b, c, d)));
            }
            (None, _) => {
                // The unknown point is the rest of the key beside its longest part that is a point.
                let known = cuts.flat_map(|(from, to)| [(from, to), (to, from)]).filter(|(part, _)| is_point(part));
                return unknown(known.max_by_key(|(part, _)| part.len()).map_or(key, |(_, rest)| rest));
            }
        }
    };
    if from == to {
        return Err(Wrong::key(&[], says::pair_same(shown(), from)));
    }
    Ok((from.to_owned(), to.to_owned()))
}

/// The order of names in which numbers in them count by their size: 2, 2a, 10, A, A2, A10.
pub(crate) fn by_name(one: &str, other: &str) -> Ordering {
    let (mut left, mut right) = (one, other);
    while !left.is_empty() && !right.is_empty() {
        let parts = [left, right].map(|text| {
            let is_number = text.starts_with(|c: char| c.is_ascii_digit());
            let end = text.find(|c: char| c.is_ascii_digit() != is_number).unwrap_or(text.len());
            let (part, rest) = text.split_at(end);
            // Of numbers without leading zeros the one with more digits is larger.
            let digits = part.trim_start_matches('0');
            let key = if is_number { (0, digits.len(), digits) } else { (1, 0, part) };
            (key, rest)
        });
        let [(a, rest), (b, others)] = parts;
        match a.cmp(&b) {
            Ordering::Equal => (left, right) = (rest, others),
            decided => return decided,
        }
    }
    left.len().cmp(&right.len()).then_with(|| one.cmp(other))
}

/// The key of two points, as `AB`, or as `A1-B` where names are longer.
pub(crate) fn joined(from: &str, to: &str) -> String {
    let is_short = from.chars().count() + to.chars().count() == 2;
    if is_short { format!("{from}{to}") } else { format!("{from}-{to}") }
}

/// Why a point or a link cannot have this name.
pub(crate) fn why_not(what: Bearer, name: &str) -> Option<(Message, Option<Message>)> {
    check_name(what, name).err().map(|wrong| (wrong.message, wrong.hint))
}

/// The two points of a link or of the ground that a key like `AB` or `A-B` names, if it names two of them.
pub(crate) fn pair(key: &str, points: &[String]) -> Option<(String, String)> {
    checked_pair(Message::from, key, &"".into(), points, |name| points.iter().any(|point| point == name)).ok()
}
