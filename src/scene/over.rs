//! How a load changes over the motion: a table over the angle of a link or the position of a slider, as gas pressure over a crank's turn or
//! a cutting force over a tool's stroke.

use super::error::Wrong;
use super::head::Head;
use super::names::Names;
use super::quantity_name::QuantityName;
use super::says;
use super::value::{Direction, OneOf, several_forms};
use super::write::{write_forms, write_keys};
use crate::geometry::Ball;
use crate::text::shown;
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{SeqAccess, Visitor};
use std::fmt;

/// A full turn, in degrees.
const TURN: f64 = 360.0;

/// How a load changes over the motion, in the file.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = r#"how a load changes as { "of": "angle(1)", "table": [[0, 0], [90, 1500], [180, 0]] }"#
)]
#[cfg_attr(feature = "schemas", schemars(rename = "over"))]
pub(super) struct OverFile {
    /// What it depends on: `angle(1)`, the angle of a link, or `position(3/ground)`, the position of a slider.
    of: String,
    /// Pairs: an angle in degrees or a position, and how many times the given force and couple act there; or a file with them.
    table: Table,
}

/// The lines of a table. Only the program reads them from files, and writes them into the text before it is read.
#[derive(Debug, Clone)]
pub(super) struct Table(Vec<Line>);

impl<'de> Deserialize<'de> for Table {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Table, D::Error> {
        deserializer.deserialize_any(Lines)
    }
}

struct Lines;

impl<'de> Visitor<'de> for Lines {
    type Value = Table;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("lines as [[0, 0], [90, 1500]]; a table in a file is read by the program `kinegon` alone")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, lines: A) -> Result<Table, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(lines)).map(Table)
    }
}

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for Table {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "loadTable".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "Lines, or the path of a CSV file that the program reads",
            "anyOf": [{ "type": "array", "items": generator.subschema_for::<Line>() }, { "type": "string" }]
        })
    }
}

write_forms! {
    Table { Table(lines) => lines }
}

write_keys!(OverFile { of, table });

/// A line of a table: a place and the factor there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line([f64; 2]);

several_forms!(Line, "tableLine", OneOf {
    expecting: "two numbers, a place and a factor, as [90, 1500]",
    from: |given| match given {
        Direction::Vector(line) => Some(Line(line)),
        Direction::Degrees(_) | Direction::Points(_) => None,
    },
}, generator => {
    "description": "A place and the factor there",
    "type": "array",
    "items": generator.subschema_for::<f64>(),
    "minItems": 2,
    "maxItems": 2
});

write_forms! {
    Line { Line(line) => line }
}

/// How a load changes over the motion.
///
/// Between two lines of its table it changes in proportion. Two lines at one place are a jump, at which the second counts. Over an
/// angle the table repeats with every turn, and from its last line it goes on to the first of the next turn; over a position
/// its first and its last line count beyond it, too.
#[derive(Debug, Clone, PartialEq)]
pub struct Over {
    /// What it depends on.
    pub of: Gauge,
    /// Places in ascending order, with the factor at each.
    pub table: Vec<[f64; 2]>,
}

/// What a load depends on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Gauge {
    /// The angle of the link's axis from +x, in degrees.
    Angle(String),
    /// The position of the slider of this name along its guide.
    Position(String),
}

impl Gauge {
    /// What a text as `angle(1)` or `position(3/ground)` names; `None` for others.
    pub(crate) fn parse(text: &str) -> Option<Gauge> {
        let name = QuantityName::parse(text).filter(|name| name.component.is_none())?;
        let QuantityName { head, mut arguments, .. } = name;
        let of = match head {
            Head::Angle => Gauge::Angle,
            Head::SlidePosition => Gauge::Position,
            _ => return None,
        };
        Some(of(arguments.pop().unwrap_or_default()))
    }
}

impl OverFile {
    pub fn read(self, names: &Names<'_>) -> Result<Over, Wrong> {
        let OverFile { of, table: Table(table) } = self;
        let table: Vec<[f64; 2]> = table.into_iter().map(|Line(line)| line).collect();
        let Some(gauge) = Gauge::parse(&of) else {
            return Err(Wrong::value(&["of"], says::over_what(shown(&of))).hint(says::over_angle_or_position()));
        };
        if let Gauge::Angle(link) = &gauge {
            names.link(&["of"], link)?;
        }
        let Some(ends) = table.first().zip(table.last()).map(|(first, last)| [first[0], last[0]]) else {
            return Err(Wrong::value(&["table"], says::over_short()).hint(says::over_two_lines()));
        };
        let back = table.windows(2).position(|lines| lines[1][0] < lines[0][0]);
        if let Some(line) = back {
            let at = (line + 1).to_string();
            let [before, after] = [table[line][0], table[line + 1][0]];
            return Err(Wrong::value(&["table", &at], says::over_back(after, before)).hint(says::over_in_order()));
        }
        if ends[0] == ends[1] {
            return Err(Wrong::value(&["table"], says::over_short()).hint(says::over_two_lines()));
        }
        if matches!(gauge, Gauge::Angle(_)) && ends[1] - ends[0] > TURN {
            return Err(Wrong::value(&["table"], says::over_more_than_a_turn()).hint(says::over_one_turn()));
        }
        Ok(Over { of: gauge, table })
    }
}

impl Over {
    /// The factor at a place that is known within a bound; its own bound covers every place within.
    /// `given` makes such numbers of those of the table.
    pub(crate) fn at(&self, place: Ball, given: impl Fn(f64) -> Ball) -> Ball {
        let lines = self.lines(place, given);
        let (start, middle) = (lines[0], place.middle());
        let pieces = || lines.windows(2).map(|pair| [pair[0], pair[1]]);
        let is_before = |[from, to]: &[[Ball; 2]; 2]| (middle - from[0]).high >= 0.0 && (to[0] - from[0]).high > 0.0;
        let factor = match pieces().rfind(is_before) {
            Some([from, to]) if (to[0] - middle).high >= 0.0 => {
                from[1] + (to[1] - from[1]) * ((middle - from[0]) / (to[0] - from[0]))
            }
            Some([_, last]) => last[1],
            None => start[1],
        };
        // What the factor changes by within the bounds: along each piece that is near, and at each jump.
        let change = |[from, to]: [[Ball; 2]; 2]| {
            let off = place.radius + from[0].radius + to[0].radius;
            let (after, before) = (place - from[0], to[0] - place);
            let is_near = [after, before].iter().all(|way| way.high + way.error() >= 0.0);
            let (change, length) = ((to[1] - from[1]).largest(), (to[0] - from[0]).smallest());
            if !is_near || off == 0.0 { 0.0 } else { change * (2.0 * off / length).min(1.0) }
        };
        let within: f64 = pieces().map(change).sum();
        factor.widened(within * (1.0 + 8.0 * f64::EPSILON))
    }

    /// The table with a piece before its first line and one after its last, in which it does not change; over an angle three turns of it, of
    /// which the second has the angle.
    fn lines(&self, place: Ball, given: impl Fn(f64) -> Ball) -> Vec<[Ball; 2]> {
        let table: Vec<[Ball; 2]> = self.table.iter().map(|line| line.map(&given)).collect();
        let (first, last) = (table[0], table[table.len() - 1]);
        match self.of {
            Gauge::Position(_) => {
                let more = last[0] - first[0];
                let (before, after) = ([first[0] - more, first[1]], [last[0] + more, last[1]]);
                [&[before], &table[..], &[after]].concat()
            }
            Gauge::Angle(_) => {
                let turns = libm::floor((place.high - first[0].high) / TURN);
                // A whole number of degrees.
                let by = |which: f64| Ball::within(TURN * (turns + which), 0.0);
                let turn = |which: f64| table.iter().map(move |line| [line[0] + by(which), line[1]]);
                [-1.0, 0.0, 1.0].into_iter().flat_map(turn).collect()
            }
        }
    }

    /// The factor at a place that counts as exact.
    pub(crate) fn at_exactly(&self, place: f64) -> f64 {
        let table = &self.table;
        let (first, last) = (table[0], table[table.len() - 1]);
        let is_angle = matches!(self.of, Gauge::Angle(_));
        let place = if is_angle { place - TURN * libm::floor((place - first[0]) / TURN) } else { place };
        let after = table.partition_point(|line| line[0] <= place);
        // From the last line of a turn on to the first of the next one; before and after a slider's table as at its ends.
        let [from, to] = match (table[..after].last(), table.get(after)) {
            (Some(&from), Some(&to)) => [from, to],
            (Some(&from), None) if is_angle => [from, [first[0] + TURN, first[1]]],
            (Some(_), None) => return last[1],
            (None, _) => return first[1],
        };
        if from[0] == to[0] { from[1] } else { from[1] + (to[1] - from[1]) * ((place - from[0]) / (to[0] - from[0])) }
    }
}
