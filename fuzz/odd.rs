//! Texts that some medium obeys, or that show nothing.

use super::random::Random;

/// Whole texts.
const TEXTS: [&str; 42] = [
    "", " ", "\n", "\t", "\r\n", "\u{200b}", "\u{feff}", "\u{a0}", "\u{3000}", "\u{0}", "\u{1b}[31m", "\u{1b}]0;x\u{7}", "\u{9b}2J",
    "\u{202e}abc", "\u{2066}", "\u{2028}", "\u{85}", "\u{e0041}", "\u{fffe}", "\u{1f600}", "e\u{301}", "漢", "=1+1", "@SUM(A1)", "+x", "-x",
    "\u{ff1d}1", "a;=1", "\u{200b}=1", "\"", "'", "</text>", "]]>", "&#27;", "<script>", "\\input{x}", "}{", "$a_1^2$", "%", "#1", "{{title}}",
    "../x",
];

/// Parts of larger ones.
const PARTS: [&str; 12] = ["_{", "}", "^", "a", "B", " ", "\u{1b}", ";", ",", "=", "\u{202e}", "\\"];

/// A text by lot: one of the list, two of its members, a row of parts, or a long one.
pub fn text(dice: &mut Random) -> String {
    let one = |dice: &mut Random| TEXTS[dice.below(TEXTS.len())].to_owned();
    match dice.below(8) {
        0..4 => one(dice),
        4 => one(dice) + &one(dice),
        5 => one(dice).repeat(1 + dice.below(300)),
        6 => "x".repeat(1 << dice.below(12)),
        _ => (0..dice.below(12)).map(|_| PARTS[dice.below(PARTS.len())]).collect(),
    }
}
