//! Mistakes of lines: rays, cut lines, special points, the whole position.

use super::{Candidate, Mistake, Site};
use crate::check::model::line_made;
use crate::drafting::{Act, Deed, LineId, Sheet};

/// The points that a ray goes through and leads to, from what its act makes.
fn ends(makes: &str) -> Option<(&str, &str)> {
    makes.strip_prefix("ray from ")?.split_once(" to ")
}

pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    turned_lines(site, Mistake::TurnedRay, |act, _| {
        let (from, to) = ends(&act.makes)?;
        Some([from.to_owned(), to.to_owned()])
    })
}

pub(super) fn turned_cut_line(site: &Site<'_>) -> Vec<Candidate> {
    turned_lines(site, Mistake::TurnedCutLine, |act, through| {
        let special = act.makes.strip_prefix("cut line of ")?;
        Some([through.to_owned(), special.to_owned()])
    })
}

/// Lines drawn turned by 90°; `blanks` tells which are meant and what is said of them, from the act and the place that the line goes through.
fn turned_lines(
    site: &Site<'_>,
    mistake: Mistake,
    blanks: impl Fn(&Act, &str) -> Option<[String; 2]>,
) -> Vec<Candidate> {
    let lines = site.acts().filter_map(|(index, act)| {
        let Deed::Draw { line, through, reference, quarter_turns } = act.deed else {
            return None;
        };
        let blanks = blanks(act, site.place_name(through))?;
        let deed = Deed::Draw { line, through, reference, quarter_turns: quarter_turns + 1 };
        let put = site.instead(index, deed);
        let blanks = blanks.each_ref().map(String::as_str);
        Some(site.candidate(mistake, index, put, &blanks))
    });
    lines.collect()
}

pub(super) fn from_wrong_point(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, act) in site.acts() {
        let Deed::Draw { line, through, reference, quarter_turns } = act.deed else {
            continue;
        };
        let Some((from, to)) = ends(&act.makes) else {
            continue;
        };
        for wrong in site.model.places_before(act.sheet, index) {
            if wrong == through {
                continue;
            }
            let deed = Deed::Draw { line, through: wrong, reference, quarter_turns };
            let put = site.instead(index, deed);
            let blanks = [to, site.place_name(wrong), from];
            found.push(site.candidate(Mistake::RayFromWrongPoint, index, put, &blanks));
        }
    }
    found
}

pub(super) fn wrong_lines(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, act) in site.acts() {
        let Deed::Cross { place, lines } = act.deed else {
            continue;
        };
        if act.sheet != Sheet::Scheme {
            continue;
        }
        let before = site.acts().take(index);
        let drawn = before.filter(|(_, a)| a.sheet == Sheet::Scheme);
        let drawn: Vec<LineId> = drawn.filter_map(|(_, a)| line_made(&a.deed)).collect();
        for side in 0..2 {
            for &wrong in &drawn {
                if lines.contains(&wrong) {
                    continue;
                }
                let mut taken = lines;
                taken[side] = wrong;
                let deed = Deed::Cross { place, lines: taken };
                let put = site.instead(index, deed);
                let [wrong, right] = [wrong, lines[side]].map(|line| line_name(site, line));
                let blanks = [act.makes.as_str(), &wrong, &right];
                found.push(site.candidate(Mistake::WrongLines, index, put, &blanks));
            }
        }
    }
    found
}

/// A line of the scheme by two of its points, or by what it is.
fn line_name(site: &Site<'_>, line: LineId) -> String {
    let mut acts = site.acts();
    let found = acts.find(|(_, act)| line_made(&act.deed) == Some(line));
    match found.map(|(_, act)| (&act.deed, &act.makes)) {
        Some((Deed::Join { from, towards, .. }, _)) => {
            format!("{}{}", site.place_name(*from), site.place_name(*towards))
        }
        Some((_, makes)) => makes.clone(),
        None => String::new(),
    }
}

/// Everything drawn in another position in which the links fit together.
pub(super) fn other_mode(site: &Site<'_>) -> Vec<Candidate> {
    let modes = 1..=site.other_modes;
    let other = modes.map(|mode| Candidate {
        mistake: Mistake::OtherMode,
        step: 0,
        blanks: Vec::new(),
        puts: Vec::new(),
        stands: Vec::new(),
        goes_on: Vec::new(),
        mode,
    });
    other.collect()
}
