//! Names: the characters they may have, and keys that join two of them.

use std::collections::HashSet;

use super::error::{Wrong, close, list, shortened};

/// Longest name, in characters.
const LONGEST: usize = 64;

/// Refuses a name with other characters than allowed; `what` is "a point" or "a link".
pub(super) fn check_name(what: &str, name: &str) -> Result<(), Wrong> {
    if name.is_empty() {
        let hint = "write a letter or a number between the quotes";
        return Err(Wrong::key(&[], format!("{what} has no name")).hint(hint));
    }
    if name.chars().count() > LONGEST {
        return Err(Wrong::key(&[], format!("the name of {what} has more than {LONGEST} characters")));
    }
    if let Some(bad) = name.chars().find(|c| !(c.is_alphanumeric() || *c == '\'' || *c == '_')) {
        let hint = match bad {
            '′' | '’' | '`' | '´' => "write ' for a prime",
            '-' => "write _ in place of -, which joins two points",
            _ => "names have letters, digits, ' and _",
        };
        let message = format!("the name `{}` of {what} contains `{}`", shortened(name), bad.escape_debug());
        return Err(Wrong::key(&[], message).hint(hint));
    }
    if name == "note" {
        return Err(Wrong::key(&[], format!("{what} cannot be called `note`: that key is for notes")));
    }
    if what == "a link" && name == "ground" {
        return Err(Wrong::key(&[], "a link cannot be called `ground`: that is the frame"));
    }
    Ok(())
}

/// Refuses a list of points with an invalid name or with a name twice; `place` is empty or as ` in link 4`.
pub(super) fn check_list(points: &[String], place: &str) -> Result<(), Wrong> {
    let mut seen = HashSet::new();
    for (index, point) in points.iter().enumerate() {
        let inside = |wrong: Wrong| wrong.inside(&[&index.to_string()]);
        check_name("a point", point).map_err(inside)?;
        if !seen.insert(point) {
            return Err(inside(Wrong::value(&[], format!("point {point} stands twice{place}"))));
        }
    }
    Ok(())
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

/// The two points of a carrier that a key like `AB` or `A-B` names; `what` is the name of the key in messages.
pub(super) fn checked_pair(
    what: &str,
    key: &str,
    carrier: &str,
    points: &[String],
    is_point: impl Fn(&str) -> bool,
) -> Result<(String, String), Wrong> {
    let wrong = |why: String| Wrong::key(&[], format!("{what} `{}`{why}", shortened(key)));
    let unknown = |name: &str| {
        let hint = close(name, points.iter().map(String::as_str));
        Err(wrong(format!(": {}", no_point(carrier, name, points))).maybe_hint(hint))
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
                let hint = format!("write \"{a}-{b}\" or \"{c}-{d}\"");
                return Err(wrong(format!(" can mean {a} and {b}, or {c} and {d}")).hint(hint));
            }
            (None, _) => {
                // The unknown point is the rest of the key beside its longest part that is a point.
                let known = cuts.flat_map(|(from, to)| [(from, to), (to, from)]).filter(|(part, _)| is_point(part));
                return unknown(known.max_by_key(|(part, _)| part.len()).map_or(key, |(_, rest)| rest));
            }
        }
    };
    if from == to {
        return Err(wrong(format!(" names the point {from} twice")));
    }
    Ok((from.to_owned(), to.to_owned()))
}

/// The key of two points, as `AB`, or as `A1-B` where names are longer.
pub(crate) fn joined(from: &str, to: &str) -> String {
    let is_short = from.chars().count() + to.chars().count() == 2;
    if is_short { format!("{from}{to}") } else { format!("{from}-{to}") }
}

/// Why a point or a link cannot have this name; `what` is "a point" or "a link".
pub(crate) fn why_not(what: &str, name: &str) -> Option<(String, Option<String>)> {
    check_name(what, name).err().map(|wrong| (wrong.message, wrong.hint))
}

/// The two points of a link or of the ground that a key like `AB` or `A-B` names, if it names two of them.
pub(crate) fn pair(key: &str, points: &[String]) -> Option<(String, String)> {
    checked_pair("", key, "", points, |name| points.iter().any(|point| point == name)).ok()
}
