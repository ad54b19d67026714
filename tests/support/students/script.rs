//! What is drawn for each kind of mechanism, in the order of a textbook.

use super::act::Change;
use super::groups::{Leg, Special};
use super::hand::Hand;
use super::plane::{Place, QUARTER, unit};
use super::scheme::Scheme;
use super::sheet::Sheet;

/// Kinds and their scripts: verbs with points and links. `;` ends a verb.
const SCRIPTS: [(&str, &str); 19] = [
    ("four-bar", "crank 1 A B ; pins B D C 2 3"),
    ("slider-crank", "crank 1 A B ; guided B C 2 3"),
    ("slotted-lever", "crank 1 A B ; slot D B 2 3 ; image D B_3 C 3"),
    ("whitworth", "crank 1 A B ; slot D B 2 3 ; image D B_3 E 3 ; guided E F 4 5"),
    ("watt-1", "crank 1 A B ; pins B D C 2 3 ; image B C E 2 ; image D C F 3 ; pins E F G 4 5"),
    ("stephenson-3", "crank 1 A B ; pins B D C 2 3 ; image B C E 2 ; pins E G F 4 5"),
    ("five-bar", "crank 1 A B ; crank 4 E D ; pins B D C 2 3"),
    ("toggle-press", "crank 1 A B ; pins B D C 2 3 ; guided C E 4 5"),
    ("dyad-rrr", "known B ; known D ; pins B D C 2 3"),
    ("dyad-rrp", "known B ; guided B C 2 3"),
    ("dyad-rpr", "known D ; known B ; slot D B 2 3 ; image D B_3 C 3"),
    ("dyad-prp", "under 1 A C ; blocks C 2 1 3 ; known A ; image A C_1 B 1"),
    ("dyad-rpp", "known B ; yoke B 2 3"),
    (
        "hydraulic-boom",
        "cylinder A C O 2 3 4 ; rates A B 2 v ; rates C D 3 v ; rates A D_2 2 a ; rates C D 3 a ; image A D_2 B 2 a ; image O C E 4",
    ),
    (
        "third-class",
        "crank 1 A B ; special S24 3 pinned B C 2 pinned F D 4 ; special S25 3 pinned B C 2 pinned G E 5 ; solve \
         ; rates B C 2 v ; rates F D 4 v ; rates G E 5 v ; rates B C 2 a ; rates C D 3 a ; rates C E 3 a",
    ),
    (
        "fourth-class",
        "crank 1 A B ; special S3 3 pinned B C 2 pinned E D 4 ; special S5 5 pinned B G 2 pinned E F 4 ; solve \
         ; rates B C 2 v ; rates E D 4 v ; rates B G 2 v ; rates E F 4 v ; rates B C 2 a ; rates B G 2 a ; rates C D 3 a ; rates E F 4 a",
    ),
    (
        "platform-3rrr",
        "crank 1 A1 B1 ; crank 2 A2 B2 ; crank 3 A3 B3 ; special S45 7 pinned B1 C1 4 pinned B2 C2 5 \
         ; special S46 7 pinned B1 C1 4 pinned B3 C3 6 ; solve ; rates B1 C1 4 ; rates B2 C2 5 ; rates B3 C3 6",
    ),
    (
        "figure-1",
        "known B ; known E ; special S3 3 pinned B C 2 pinned E D 4 ; special S5 5 pinned B G 2 pinned E F 4 ; solve \
         ; rates B C 2 v ; rates E D 4 v ; rates B G 2 v ; rates E F 4 v ; rates B C 2 a ; rates B G 2 a ; rates C D 3 a ; rates D F 4 a",
    ),
    (
        "figure-2",
        "crank 1 A B ; special S3 3 guided B 3/2 2 pinned G D 4 ; special S5 5 pinned B E 2 pinned G F 4 ; solve 3 2 \
         ; rates G D 4 v ; rates B E 2 v ; rates G F 4 v ; rates B D_2 2 v ; slid D 3 2 v ; rates B E 2 a ; rates B D_2 2 a ; slid D 3 2 a ; rates G F 4 a",
    ),
];

/// All kinds that can be drawn.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    SCRIPTS.iter().map(|(kind, _)| *kind)
}

fn verbs(kind: &str) -> Vec<Vec<&'static str>> {
    let script = SCRIPTS.iter().find(|(known, _)| *known == kind);
    let (_, script) = script.unwrap_or_else(|| panic!("there is no script for {kind}"));
    script.split(';').map(|verb| verb.split_whitespace().collect()).collect()
}

/// The special point that a verb describes.
fn special(words: &[&str]) -> Special {
    let leg = |words: &[&str]| {
        let [a, b, c] = [1, 2, 3].map(|k| words[k].to_owned());
        if words[0] == "pinned" { Leg::Pinned(a, b, c) } else { Leg::Guided(a, b, c) }
    };
    Special { name: words[0].to_owned(), link: words[1].to_owned(), legs: [leg(&words[2..6]), leg(&words[6..10])] }
}

/// Puts a kind's special points on the scheme.
pub fn place_specials(kind: &str, scheme: &mut Scheme) {
    for verb in verbs(kind).iter().filter(|verb| verb[0] == "special") {
        let special = special(&verb[1..]);
        let place = special.place(scheme);
        scheme.places.insert(special.name, place);
    }
}

/// A joint that can lie on two sides of a line, a place of that line and its direction as a vector.
pub fn joints(kind: &str, scheme: &Scheme) -> Option<(String, Place, Place)> {
    let verb = verbs(kind).into_iter().find(|verb| ["pins", "guided"].contains(&verb[0]))?;
    let from = scheme.at(verb[1]);
    Some(match verb[0] {
        "pins" => (verb[3].to_owned(), from, scheme.at(verb[2]) - from),
        _ => {
            let guide = scheme.guide(&format!("{}/ground", verb[4])).direction;
            (verb[2].to_owned(), from, unit(guide + QUARTER))
        }
    })
}

/// Draws both plans.
pub fn draw<'a>(kind: &str, scheme: &'a Scheme, hand: Hand, changes: &'a [(String, Change)]) -> Sheet<'a> {
    let mut sheet = Sheet::new(scheme, hand, changes);
    for plan in [1, 2] {
        let mut equations = Vec::new();
        for verb in verbs(kind) {
            let words = &verb[1..];
            let of_other_plan = ["", "a", "v"][plan];
            if words.last() == Some(&of_other_plan) {
                continue;
            }
            match verb[0] {
                "crank" => sheet.crank(plan, words[0], [words[1], words[2]]),
                "known" => sheet.known(plan, words[0]),
                "under" => sheet.under(plan, words[0], [words[1], words[2]]),
                "pins" => sheet.pins(plan, [words[0], words[1], words[2]], [words[3], words[4]]),
                "guided" => sheet.guided(plan, [words[0], words[1]], [words[2], words[3]]),
                "slot" => sheet.slot(plan, [words[0], words[1]], [words[2], words[3]]),
                "blocks" => sheet.blocks(plan, words[0], [words[1], words[2], words[3]]),
                "yoke" => sheet.yoke(plan, words[0], [words[1], words[2]]),
                "image" => sheet.image(plan, [words[0], words[1], words[2]], words[3]),
                "rates" => sheet.from_rates(plan, [words[0], words[1]], words[2]),
                "slid" => sheet.slid(plan, words[0], [words[1], words[2]]),
                "cylinder" => {
                    sheet.cylinder(plan, [words[0], words[1], words[2]], [words[3], words[4], words[5]]);
                }
                "special" => equations.extend(sheet.special(plan, &special(words))),
                _ => sheet.solve(&equations, plan, words),
            }
        }
    }
    sheet
}
