//! Typesetting of text with markup: the face of each letter, and the positions of subscripts and superscripts.

use kurbo::{Point, Rect};

use super::fonts::{self, TextExtent};
use crate::text::printable;

// Proportions of scripts, in em of their base; near those of TeX for a serif font of this x-height.
const SCRIPT_SCALE: f64 = 0.7;
const SMALLEST_SCALE: f64 = 0.5;
const SUBSCRIPT_DROP: f64 = 0.2;
/// Deeper under a superscript, to keep the two apart.
const SUBSCRIPT_DROP_BELOW_SUPERSCRIPT: f64 = 0.27;
const SUPERSCRIPT_RISE: f64 = 0.38;
/// White before and after scripts, and after a slanted letter that leans towards an upright one, in em.
const SCRIPT_GAP: f64 = 0.03;
/// Deepest nesting of scripts; deeper markup is taken literally.
const DEEPEST: usize = 3;

/// A stretch of a text in one face, size and height. Lengths are in em of the whole text, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The letters; without leading, trailing or double spaces, which viewers drop.
    pub content: String,
    /// Whether the face is the slanted one.
    pub italic: bool,
    /// Size of the run over that of the text: 1 on the baseline, less in subscripts and
    /// superscripts.
    pub scale: f64,
    /// Left end of the run, from that of the text.
    pub x: f64,
    /// Baseline of the run, from that of the text; positive in subscripts.
    pub y: f64,
    /// The scripts from the baseline to the run, outermost first; empty on the baseline.
    pub scripts: Vec<Script>,
    /// Whether a space precedes the run.
    pub spaced: bool,
}

/// Position of a script relative to its base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// Subscript.
    Sub,
    /// Superscript.
    Super,
}
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Setting {
    /// Letters slanted, digits and signs upright.
    Math,
    /// All upright.
    Plain,
}

/// The face of a letter, and whether it must be a run of its own.
#[derive(Clone, Copy, PartialEq)]
enum LetterKind {
    Italic,
    Upright,
    /// A sign that only some fonts have, in a run of its own: for one missing glyph some viewers replace the font of
    /// the whole run.
    Sign,
}

/// Sets letters one after another; collects runs, pen position and ink.
pub(super) struct Setter {
    setting: Setting,
    pub(super) runs: Vec<Run>,
    pub(super) ink: Option<Rect>,
    pub(super) pen: Point,
    scale: f64,
    /// The letters of the present run.
    content: String,
    kind: LetterKind,
    /// Overhang of the last run beyond the pen, for a slanted letter.
    lean: f64,
    /// The scripts at the pen, from the baseline on.
    scripts: Vec<Script>,
    /// Whether a space precedes the pen.
    spaced: bool,
}

impl Setter {
    /// Sets a line of text; without `markup` all letters are literal.
    pub(super) fn set(source: &str, setting: Setting, markup: bool) -> Self {
        let letters: Vec<char> = source.chars().filter_map(printable).collect();
        let mut setter = Self {
            setting,
            runs: Vec::new(),
            ink: None,
            pen: Point::ORIGIN,
            scale: 1.0,
            content: String::new(),
            kind: LetterKind::Upright,
            lean: 0.0,
            scripts: Vec::new(),
            spaced: false,
        };
        setter.line(&letters, if markup { DEEPEST } else { 0 });
        setter
    }

    /// Sets letters with scripts of a nesting depth, and ends the last run.
    fn line(&mut self, letters: &[char], depth: usize) {
        let mut rest = letters;
        while let Some((&letter, after)) = rest.split_first() {
            if depth > 0 && script(rest).is_some() {
                rest = self.scripts(rest, depth);
            } else {
                self.letter(letter);
                rest = after;
            }
        }
        self.end_run();
    }

    /// Sets the one or two scripts at the start of `letters`; returns the rest.
    fn scripts<'a>(&mut self, letters: &'a [char], depth: usize) -> &'a [char] {
        self.end_run();
        let (base, scale, lean) = (self.pen, self.scale, self.lean);
        let (mut subscript, mut superscript, mut rest) = (None, None, letters);
        while let Some((mark, body, after)) = script(rest) {
            let place = if mark == '_' { &mut subscript } else { &mut superscript };
            if place.is_some() {
                break;
            }
            *place = Some(body);
            rest = after;
        }
        let drop = if superscript.is_some() { SUBSCRIPT_DROP_BELOW_SUPERSCRIPT } else { SUBSCRIPT_DROP };
        let mut end: f64 = base.x;
        for (script, body, lean, shift) in
            [(Script::Sub, subscript, 0.0, drop), (Script::Super, superscript, lean, -SUPERSCRIPT_RISE)]
        {
            let Some(body) = body else { continue };
            self.pen = Point::new(base.x + lean + SCRIPT_GAP * scale, base.y + shift * scale);
            self.scale = (scale * SCRIPT_SCALE).max(SMALLEST_SCALE);
            self.lean = 0.0;
            self.scripts.push(script);
            self.line(body, depth - 1);
            self.scripts.pop();
            end = end.max(self.pen.x + self.lean);
        }
        self.pen = Point::new(end + SCRIPT_GAP * scale, base.y);
        self.scale = scale;
        self.lean = 0.0;
        rest
    }

    fn letter(&mut self, letter: char) {
        if letter == ' ' {
            return self.space();
        }
        let letter = match (self.setting, letter) {
            (Setting::Math, '\'') => '′',
            (Setting::Math, '-') => '−',
            _ => letter,
        };
        // Two primes become one double prime.
        if letter == '′' && self.content == "′" {
            self.content.clear();
            self.content.push('″');
            return;
        }
        let kind = self.kind_of(letter);
        if kind != self.kind || kind == LetterKind::Sign {
            self.end_run();
        }
        if self.content.is_empty() && kind != LetterKind::Italic && !matches!(letter, '.' | ',' | ';' | ':') {
            self.pen.x += self.lean;
        }
        self.kind = kind;
        self.content.push(letter);
    }

    /// A space belongs to the run around it; where a run cannot keep it, the pen moves.
    fn space(&mut self) {
        if self.content.is_empty() || self.content.ends_with(' ') {
            self.end_run();
            self.pen.x += self.scale * fonts::face(false).measure(" ").advance;
            self.lean = 0.0;
            self.spaced = true;
        } else {
            self.content.push(' ');
        }
    }

    fn kind_of(&self, letter: char) -> LetterKind {
        let slanted = self.setting == Setting::Math && letter.is_alphabetic() && fonts::face(true).has(letter);
        // Latin, Greek, Cyrillic and Western punctuation are in every serif font.
        let common = matches!(letter, ' '..='~' | '\u{A0}'..='\u{4FF}' | '–' | '—' | '‘' | '’' | '“' | '”' | '…')
            && fonts::face(false).has(letter);
        match (slanted, common) {
            (true, _) => LetterKind::Italic,
            (false, true) => LetterKind::Upright,
            (false, false) => LetterKind::Sign,
        }
    }

    /// Measures the present run and moves the pen past it.
    fn end_run(&mut self) {
        let content = std::mem::take(&mut self.content);
        let letters = content.trim_end();
        if letters.is_empty() {
            return;
        }
        let italic = self.kind == LetterKind::Italic;
        let face = fonts::face(italic);
        let TextExtent { advance, ink } = face.measure(letters);
        let spaces = (content.len() - letters.len()) as f64 * fonts::face(false).measure(" ").advance;
        self.runs.push(Run {
            content: letters.to_owned(),
            italic,
            scale: self.scale,
            x: self.pen.x,
            y: self.pen.y,
            scripts: self.scripts.clone(),
            spaced: std::mem::replace(&mut self.spaced, spaces > 0.0),
        });
        if let Some(ink) = ink {
            let scale = self.scale;
            let here = Rect::new(ink.x0 * scale, ink.y0 * scale, ink.x1 * scale, ink.y1 * scale) + self.pen.to_vec2();
            self.ink = Some(self.ink.map_or(here, |all| all.union(here)));
        }
        let over = ink.map_or(0.0, |ink| ink.x1 - advance).max(0.0);
        let leans = italic && spaces == 0.0 && over > 0.0;
        self.lean = if leans { (over + SCRIPT_GAP) * self.scale } else { 0.0 };
        self.pen.x += (advance + spaces) * self.scale;
    }
}

/// The script at the start of `letters`: its mark, its body, the rest; none where the mark is literal.
fn script(letters: &[char]) -> Option<(char, &[char], &[char])> {
    let (&mark, after) = letters.split_first()?;
    if !matches!(mark, '_' | '^') {
        return None;
    }
    let (&first, rest) = after.split_first()?;
    match first {
        '{' => {
            let mut open = 1;
            let close = rest.iter().position(|&letter| {
                open += match letter {
                    '{' => 1,
                    '}' => -1,
                    _ => 0,
                };
                open == 0
            })?;
            Some((mark, &rest[..close], &rest[close + 1..]))
        }
        '_' | '^' | ' ' => None,
        _ => Some((mark, &after[..1], rest)),
    }
}
