//! What a calculator is asked: a formula of numbers and of names of quantities.
//!
//! No library reads these formulas: `L(B,S3)`, `v_r(3/2)` and `a_n(C/B)` are names here, with commas and slashes in them, and to a library
//! they are calls and divisions. So the reader is here: sums of products of powers.

use super::says;
use crate::geometry::direction_of_degrees;
use crate::message::Message;
use crate::scene::QuantityName;
use crate::words::Medium;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A formula as it was written, and what it means.
#[derive(Clone, Debug)]
pub struct Formula {
    text: String,
    value: Node,
}

#[derive(Clone, Debug)]
enum Node {
    Number(f64),
    Name(String),
    Minus(Box<Node>),
    Of(Function, Box<Node>),
    Two(Sign, Box<[Node; 2]>),
}

#[derive(Clone, Copy, Debug)]
enum Sign {
    Plus,
    Minus,
    Times,
    Over,
    Power,
}

/// A function of one number; angles are in degrees.
#[derive(Clone, Copy, Debug)]
enum Function {
    Root,
    Size,
    Sine,
    Cosine,
    Tangent,
}

const FUNCTIONS: [(&str, Function); 5] = [
    ("sqrt", Function::Root),
    ("abs", Function::Size),
    ("sin", Function::Sine),
    ("cos", Function::Cosine),
    ("tan", Function::Tangent),
];

/// How deep brackets may be.
const DEEPEST: usize = 50;

impl Formula {
    /// As it is written in this kind of text: in figures with minus signs in place of hyphens, but for those in names.
    pub(super) fn written(&self, medium: Medium) -> String {
        match medium {
            Medium::Text => self.text.clone(),
            Medium::Figure => {
                let (mut written, mut word, mut is_name) = (String::new(), String::new(), false);
                for letter in self.text.chars() {
                    match letter {
                        '(' => is_name |= !word.is_empty() && !FUNCTIONS.iter().any(|(name, _)| *name == word),
                        ')' => is_name = false,
                        _ => {}
                    }
                    match letter.is_alphanumeric() || letter == '_' {
                        true => word.push(letter),
                        false => word.clear(),
                    }
                    written.push(if letter == '-' && !is_name { '−' } else { letter });
                }
                written
            }
        }
    }

    /// The formula of a text.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(text: &str) -> Result<Formula, Message> {
        let mut reader = Reader { all: text, rest: text, depth: 0 };
        let value = reader.sum()?;
        match reader.next() {
            None => Ok(Formula { text: text.to_owned(), value }),
            Some(_) => Err(reader.wrong()),
        }
    }

    /// The two sides of an equation.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn sides(text: &str) -> Result<[Formula; 2], Message> {
        let (left, right) = text.split_once('=').ok_or_else(|| says::no_equation(text))?;
        Ok([Formula::read(left)?, Formula::read(right)?])
    }

    /// As it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its value, where `number` knows what the names mean.
    pub(super) fn value(&self, number: &mut dyn FnMut(&str) -> Result<f64, Message>) -> Result<f64, Message> {
        self.value.value(number)
    }

    /// The formula with others in place of some names.
    pub(super) fn with(&self, other: &dyn Fn(&str) -> Option<Formula>) -> Formula {
        Formula { text: self.text.clone(), value: self.value.with(other) }
    }

    /// Whether it has numbers that somebody has looked up or worked out: more than factors of 2, halves and exponents.
    pub(super) fn has_constants(&self) -> bool {
        self.value.has(&|x| ![0.0, 0.5, 1.0, 2.0].contains(&x))
    }

    /// Whether it has any numbers, but for exponents.
    pub(super) fn has_numbers(&self) -> bool {
        self.value.has(&|_| true)
    }

    /// Whether there is a power in it.
    pub(super) fn has_power(&self) -> bool {
        self.value.has_power()
    }

    /// The names in it, in order.
    pub(super) fn names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        self.value.names(&mut names);
        names
    }
}

impl Node {
    fn value(&self, number: &mut dyn FnMut(&str) -> Result<f64, Message>) -> Result<f64, Message> {
        Ok(match self {
            Node::Number(x) => *x,
            Node::Name(name) => number(name)?,
            Node::Minus(node) => -node.value(number)?,
            Node::Of(function, node) => {
                let x = node.value(number)?;
                match function {
                    Function::Root => x.sqrt(),
                    Function::Size => x.abs(),
                    Function::Sine => direction_of_degrees(x).y,
                    Function::Cosine => direction_of_degrees(x).x,
                    Function::Tangent => {
                        let direction = direction_of_degrees(x);
                        direction.y / direction.x
                    }
                }
            }
            Node::Two(sign, two) => {
                let [a, b] = [two[0].value(number)?, two[1].value(number)?];
                match sign {
                    Sign::Plus => a + b,
                    Sign::Minus => a - b,
                    Sign::Times => a * b,
                    Sign::Over => a / b,
                    Sign::Power => libm::pow(a, b),
                }
            }
        })
    }

    fn with(&self, other: &dyn Fn(&str) -> Option<Formula>) -> Node {
        match self {
            Node::Number(_) => self.clone(),
            Node::Name(name) => other(name).map_or_else(|| self.clone(), |other| other.value),
            Node::Minus(node) => Node::Minus(Box::new(node.with(other))),
            Node::Of(function, node) => Node::Of(*function, Box::new(node.with(other))),
            Node::Two(sign, two) => Node::Two(*sign, Box::new([two[0].with(other), two[1].with(other)])),
        }
    }

    fn has_power(&self) -> bool {
        match self {
            Node::Number(_) | Node::Name(_) => false,
            Node::Minus(node) | Node::Of(_, node) => node.has_power(),
            Node::Two(Sign::Power, _) => true,
            Node::Two(_, two) => two.iter().any(Node::has_power),
        }
    }

    /// Whether it has such numbers, but for exponents.
    fn has(&self, is_such: &dyn Fn(f64) -> bool) -> bool {
        match self {
            Node::Number(x) => is_such(*x),
            Node::Name(_) => false,
            Node::Minus(node) | Node::Of(_, node) => node.has(is_such),
            Node::Two(Sign::Power, two) => two[0].has(is_such),
            Node::Two(_, two) => two.iter().any(|node| node.has(is_such)),
        }
    }

    fn names<'n>(&'n self, names: &mut Vec<&'n str>) {
        match self {
            Node::Number(_) => {}
            Node::Name(name) => names.push(name),
            Node::Minus(node) | Node::Of(_, node) => node.names(names),
            Node::Two(_, two) => two.iter().for_each(|node| node.names(names)),
        }
    }
}

struct Reader<'t> {
    all: &'t str,
    rest: &'t str,
    depth: usize,
}

impl<'t> Reader<'t> {
    fn wrong(&self) -> Message {
        let at = self.all.chars().count() - self.rest.chars().count() + 1;
        says::no_formula(self.all, at)
    }

    fn next(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn skip(&mut self, letter: char) {
        self.rest = &self.rest[letter.len_utf8()..];
    }

    fn sum(&mut self) -> Result<Node, Message> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.wrong());
        }
        let mut sum = self.product()?;
        while let Some(letter @ ('+' | '-' | '−')) = self.next() {
            self.skip(letter);
            let sign = if letter == '+' { Sign::Plus } else { Sign::Minus };
            sum = Node::Two(sign, Box::new([sum, self.product()?]));
        }
        self.depth -= 1;
        Ok(sum)
    }

    fn product(&mut self) -> Result<Node, Message> {
        let mut product = self.signed()?;
        while let Some(letter @ ('*' | '·' | '×' | '/' | ':')) = self.next() {
            self.skip(letter);
            let sign = if matches!(letter, '/' | ':') { Sign::Over } else { Sign::Times };
            product = Node::Two(sign, Box::new([product, self.signed()?]));
        }
        Ok(product)
    }

    /// A power, or one with a sign before it: −2² is −4.
    fn signed(&mut self) -> Result<Node, Message> {
        let mut minus = false;
        while let Some(letter @ ('+' | '-' | '−')) = self.next() {
            self.skip(letter);
            minus ^= letter != '+';
        }
        let node = self.power()?;
        Ok(if minus { Node::Minus(Box::new(node)) } else { node })
    }

    fn power(&mut self) -> Result<Node, Message> {
        let base = self.single()?;
        let exponent = match self.next() {
            Some('^') => {
                self.skip('^');
                let negative = self.next() == Some('-');
                if negative {
                    self.skip('-');
                }
                let exponent = self.single()?;
                if negative { Node::Minus(Box::new(exponent)) } else { exponent }
            }
            Some('²') => {
                self.skip('²');
                Node::Number(2.0)
            }
            _ => return Ok(base),
        };
        Ok(Node::Two(Sign::Power, Box::new([base, exponent])))
    }

    fn single(&mut self) -> Result<Node, Message> {
        match self.next() {
            Some('(') => {
                self.skip('(');
                let inner = self.sum()?;
                match self.next() {
                    Some(')') => self.skip(')'),
                    _ => return Err(self.wrong()),
                }
                Ok(inner)
            }
            Some(letter) if letter.is_ascii_digit() || letter == '.' => self.number(),
            Some(letter) if letter.is_alphabetic() || letter == '_' => self.name(),
            _ => Err(self.wrong()),
        }
    }

    fn number(&mut self) -> Result<Node, Message> {
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let mut length = digits(self.rest);
        // An exponent, if digits follow.
        let after = &self.rest[length..];
        if let Some(exponent) = after.strip_prefix(['e', 'E']) {
            let signed = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            let count = signed.find(|c: char| !c.is_ascii_digit()).unwrap_or(signed.len());
            if count > 0 {
                length += after.len() - signed.len() + count;
            }
        }
        let (number, rest) = self.rest.split_at(length);
        let number: f64 = number.parse().map_err(|_| self.wrong())?;
        self.rest = rest;
        Ok(Node::Number(number))
    }

    /// A name with what stands in its brackets, or a function with its number.
    fn name(&mut self) -> Result<Node, Message> {
        let is_letter = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
        let length = self.rest.find(|c| !is_letter(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(length);
        let function = FUNCTIONS.iter().find(|(name, _)| *name == word);
        if let (Some((_, function)), true) = (function, rest.trim_start().starts_with('(')) {
            self.rest = rest;
            return Ok(Node::Of(*function, Box::new(self.single()?)));
        }
        let Some(close) = rest.starts_with('(').then(|| closing(rest)).flatten() else {
            self.rest = rest;
            return Ok(Node::Name(word.to_owned()));
        };
        let name = &self.rest[..=length + close];
        if QuantityName::parse(name).is_none() {
            return Err(self.wrong());
        }
        // The number of a vector, as in `v(B).x`.
        let mut end = name.len();
        for tail in [".x", ".y", ".size", ".angle"] {
            if self.rest[end..].starts_with(tail) {
                end += tail.len();
                break;
            }
        }
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        Ok(Node::Name(name.chars().filter(|c| !c.is_whitespace()).collect()))
    }
}

/// Where the bracket is closed with which a text begins.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    let close = text.char_indices().find(|(_, letter)| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        depth == 0
    });
    close.map(|(at, _)| at)
}

impl<'de> Deserialize<'de> for Formula {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Formula, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Written {
            Number(f64),
            Text(String),
        }
        let text = match Written::deserialize(deserializer)? {
            Written::Number(number) => number.to_string(),
            Written::Text(text) => text,
        };
        Formula::read(&text).map_err(D::Error::custom)
    }
}

impl Serialize for Formula {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}
