//! Names in a film: one that would be elsewhere or gone a moment later is left out for that moment, for it could not be
//! read and draws the eye away from what moves.

use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen};
use indexmap::IndexMap;
use kurbo::Point;
use std::collections::BTreeSet;

/// A name that moves by so many mm further, or another way, than it did before is elsewhere beside what it names.
const HOP: f64 = 4.0;

/// By picture: the names that are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Steady(Vec<BTreeSet<String>>);

impl Steady {
    /// For pictures that are shown over and over: names that do not stay for `least` pictures are left out.
    pub(super) fn of(pictures: impl Iterator<Item = Drawing>, least: usize) -> Steady {
        let mut places: IndexMap<String, Vec<Option<Point>>> = IndexMap::new();
        let mut count = 0;
        for picture in pictures {
            for (name, place) in picture.marks.iter().filter_map(named) {
                let all = places.entry(name.to_owned()).or_default();
                all.resize(count, None);
                all.push(Some(place));
            }
            count += 1;
        }
        let mut steady = Steady(vec![BTreeSet::new(); count]);
        for (name, mut all) in places {
            all.resize(count, None);
            let hasty = hasty(&all, least);
            let pictures = steady.0.iter_mut().zip(hasty).filter(|(_, is_hasty)| *is_hasty);
            pictures.for_each(|(names, _)| names.extend([name.clone()]));
        }
        steady
    }

    /// Leaves out the names of the picture of a number, with their leaders.
    pub(super) fn leave_out(&self, number: usize, drawing: &mut Drawing) {
        let Some(names) = self.0.get(number).filter(|names| !names.is_empty()) else { return };
        let all = std::mem::take(&mut drawing.marks);
        for mark in all {
            if !named(&mark).is_some_and(|(name, _)| names.contains(name)) {
                drawing.marks.push(mark);
            } else if drawing.marks.last().is_some_and(|mark| mark.pen == Pen::Leader) {
                drawing.marks.pop();
            }
        }
    }
}

/// A label's name and its middle; also of the words that a panel has no room for names, but not of those that something is
/// cut off, however short that is.
fn named(mark: &Mark) -> Option<(&str, Point)> {
    match (mark.id.as_deref(), &mark.shape) {
        (Some(name), Shape::Text(text)) if !name.ends_with("-cut") => Some((name, text.ink_box().center())),
        _ => None,
    }
}

/// By picture, where a name is, if it is there: whether it stays for fewer than `least` pictures in that place.
fn hasty(places: &[Option<Point>], least: usize) -> Vec<bool> {
    let count = places.len();
    let at = |number: usize| places[number % count];
    let mut begins = vec![false; count];
    // Whether one begins hangs on the one before it: the second time round that is known of all.
    for number in count.max(2)..3 * count {
        let has_begun = begins[(number - 1) % count];
        begins[number % count] = match [number - 2, number - 1, number].map(at) {
            [_, _, None] => false,
            [_, None, Some(_)] => true,
            [None, Some(_), Some(_)] => false,
            [Some(a), Some(b), Some(now)] => !has_begun && ((now - b) - (b - a)).hypot() > HOP,
        };
    }
    let mut hasty = vec![false; count];
    for begin in (0..count).filter(|number| begins[*number]) {
        let stays = |number: &usize| at(*number).is_some() && !begins[*number % count];
        let length = 1 + (begin + 1..begin + count).take_while(stays).count();
        if length < least {
            (begin..begin + length).for_each(|number| hasty[number % count] = true);
        }
    }
    hasty
}
