//! How an entry is carried out with the things that are there.

use super::direction::Direction;
use super::entry::{Compute, Cross, Entry, Join, LayOff, Like, Line, Mark, Measure};
use super::names::{is_center, segment_of, two_points};
use super::says;
use super::table::{DrawnLine, Made, Table};
use crate::geometry::{Vector, complex_product, cross, degrees_of, direction_of_degrees, quarter_turn, unit};
use crate::message::Message;
use crate::scene::QuantityName;
use crate::sheet::Sheet;

impl Table<'_> {
    /// What an entry makes, with the things that are there. Nothing is put down. Places where free hands drew are not looked at, but for
    /// lines of which nothing else is said, and for marks.
    ///
    /// # Errors
    /// What is missing or cannot be done.
    pub fn carry_out(&self, entry: &Entry) -> Result<Made, Message> {
        match entry {
            Entry::Join(join) => self.join(join),
            Entry::Line(line) => self.line(line),
            Entry::Cross(cross) => self.cross(cross),
            Entry::LayOff(laid) => self.lay_off(laid),
            Entry::Like(like) => self.like(like),
            Entry::Mark(mark) => self.mark(mark),
            Entry::Measure(measure) => self.measure(measure),
            Entry::Compute(compute) => self.compute(compute),
            Entry::Solve(solve) => self.solve(solve),
            Entry::Undo(_) => Ok(Made::Numbers(Vec::new())),
        }
    }

    /// The same of an entry whose result is there already, as if it were not.
    ///
    /// # Errors
    /// What is missing or cannot be done.
    pub(super) fn carried_out_again(&self, entry: &Entry) -> Result<Made, Message> {
        let mut before = self.clone();
        let names = entry.made();
        before.places.retain(|(sheet, own), _| {
            !names.iter().any(|name| self.given.usual(*sheet, name) == *own) || self.given.is_there(own)
        });
        before.lines.retain(|name, _| !names.contains(&name.as_str()));
        before.numbers.retain(|name, _| !names.contains(&name.as_str()));
        before.carry_out(entry)
    }

    /// The same as the hand did it: where it was free, its places and numbers stand beside what was meant.
    ///
    /// # Errors
    /// What is missing or cannot be done.
    pub fn carry_out_by_hand(&self, entry: &Entry) -> Result<Made, Message> {
        let made = self.carry_out(entry)?;
        Ok(match (made, entry) {
            (Made::Line(name, line), Entry::Line(Line { drawn: Some(drawn), .. })) => {
                Made::Line(name, self.drawn_line(line.sheet, drawn))
            }
            (
                Made::Place(sheet, name, _),
                Entry::Cross(Cross { drawn: Some(drawn), .. }) | Entry::LayOff(LayOff { drawn: Some(drawn), .. }),
            ) => Made::Place(sheet, name, self.drawn_place(sheet, drawn)),
            (Made::Numbers(mut all), Entry::Measure(Measure { read: Some(read), .. })) => {
                all.iter_mut().for_each(|(_, number)| *number = *read);
                Made::Numbers(all)
            }
            (made, _) => made,
        })
    }

    fn drawn_place(&self, sheet: Sheet, drawn: &[f64; 2]) -> Vector {
        Vector::from(*drawn) * self.scales[sheet]
    }

    fn drawn_line(&self, sheet: Sheet, [x, y, degrees]: &[f64; 3]) -> DrawnLine {
        DrawnLine { sheet, at: self.drawn_place(sheet, &[*x, *y]), along: direction_of_degrees(*degrees) }
    }

    fn new_place(&self, sheet: Sheet, name: &str) -> Result<String, Message> {
        let is_one = is_name(name) || sheet == Sheet::Centers && is_center(name);
        let free = is_one && self.place(sheet, name).is_none();
        if free { Ok(self.given.usual(sheet, name)) } else { Err(says::taken(name)) }
    }

    fn new_line(&self, name: &str) -> Result<String, Message> {
        let free = is_name(name) && !name.contains(',') && !self.lines.contains_key(name) && !self.given.is_part(name);
        if free { Ok(name.to_owned()) } else { Err(says::taken(name)) }
    }

    pub(super) fn new_number(&self, name: &str) -> Result<String, Message> {
        let name: String = name.chars().filter(|c| !c.is_whitespace()).collect();
        let free = !self.numbers.contains_key(&name) && self.given.given_number(&name).is_none();
        // What is no quantity is a plain word.
        let is_plain = name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '\''))
            && name.chars().next().is_some_and(char::is_alphabetic);
        match free && (is_plain || QuantityName::parse(&name).is_some()) {
            true => Ok(name),
            false => Err(says::taken(name)),
        }
    }

    /// The sheet that is named, or the only one that has all these points.
    fn sheet(&self, on: Option<Sheet>, points: &[&str]) -> Result<Sheet, Message> {
        if let Some(sheet) = on {
            return Ok(sheet);
        }
        let mut having = Sheet::ALL.into_iter().filter(|&sheet| points.iter().all(|p| self.place(sheet, p).is_some()));
        match (having.next(), having.next()) {
            (Some(sheet), None) => Ok(sheet),
            (None, _) => Err(says::no_point(points.first().copied().unwrap_or(""))),
            _ => Err(says::which_sheet()),
        }
    }

    fn point(&self, sheet: Sheet, name: &str) -> Result<Vector, Message> {
        self.place(sheet, name).ok_or_else(|| says::no_point(name))
    }

    /// The sheet on which two points give a direction to another one: the scheme, else the one that is drawn on, else that of forces, whose
    /// lines of action are drawn on the scheme.
    pub(super) fn sheet_of_reference(&self, drawn_on: Sheet, points: [&str; 2]) -> Sheet {
        let has_both = |sheet: &Sheet| points.iter().all(|point| self.place(*sheet, point).is_some());
        [Sheet::Scheme, drawn_on, Sheet::Forces].into_iter().find(has_both).unwrap_or(drawn_on)
    }

    /// The direction that a line, two points, a link or a guide give on a sheet.
    fn reference(&self, sheet: Sheet, name: &str) -> Result<Vector, Message> {
        if let Some(line) = self.lines.get(name) {
            return Ok(line.along);
        }
        if let Some([from, to]) = two_points(name) {
            let on = self.sheet_of_reference(sheet, [from, to]);
            let between = self.point(on, to)? - self.point(on, from)?;
            return unit(between).ok_or_else(|| says::no_direction(name));
        }
        self.given.direction(name).unwrap_or_else(|| Err(says::no_reference(name)))
    }

    /// A direction, of length 1.
    pub(super) fn direction(&self, sheet: Sheet, along: &Direction) -> Result<Vector, Message> {
        match along {
            Direction::Parallel { parallel } => self.reference(sheet, parallel),
            Direction::Normal { normal } => self.reference(sheet, normal).map(quarter_turn),
            Direction::Turned { turned, base } => {
                let [from, to] = [self.reference(sheet, &turned[0])?, self.reference(sheet, &turned[1])?];
                let base = self.reference(sheet, base)?;
                Ok(complex_product(complex_product(base, to), Vector::new(from.x, -from.y)))
            }
            Direction::Angle { angle } => Ok(direction_of_degrees(*angle)),
        }
    }

    fn join(&self, Join { join, on, points: [from, to] }: &Join) -> Result<Made, Message> {
        let sheet = self.sheet(*on, &[from, to])?;
        let [from, to] = [self.point(sheet, from)?, self.point(sheet, to)?];
        let along = unit(to - from).ok_or_else(|| says::no_direction(join))?;
        Ok(Made::Line(self.new_line(join)?, DrawnLine { sheet, at: from, along }))
    }

    fn line(&self, Line { line: name, on, through, along, drawn }: &Line) -> Result<Made, Message> {
        let new = self.new_line(name)?;
        let points: Vec<&str> = through.iter().map(String::as_str).collect();
        let sheet = self.sheet(*on, &points)?;
        Ok(Made::Line(
            new,
            match (through, along, drawn) {
                (Some(through), Some(along), _) => {
                    DrawnLine { sheet, at: self.point(sheet, through)?, along: self.direction(sheet, along)? }
                }
                (_, _, Some(drawn)) => self.drawn_line(sheet, drawn),
                _ => return Err(says::no_direction(name.as_str())),
            },
        ))
    }

    fn cross(&self, Cross { cross: name, of, .. }: &Cross) -> Result<Made, Message> {
        let line = |name: &String| self.lines.get(name).ok_or_else(|| says::no_line(name));
        let [one, two] = [line(&of[0])?, line(&of[1])?];
        if one.sheet != two.sheet {
            return Err(says::two_sheets(&of[0], &of[1]));
        }
        let sine = cross(one.along, two.along);
        if sine.abs() < SMALLEST_SINE {
            return Err(says::no_crossing(&of[0], &of[1]));
        }
        let at = one.at + one.along * (cross(two.at - one.at, two.along) / sine);
        Ok(Made::Place(one.sheet, self.new_place(one.sheet, name)?, at))
    }

    fn lay_off(&self, LayOff { lay_off, on, from, size, along, .. }: &LayOff) -> Result<Made, Message> {
        let sheet = self.sheet(*on, &[from])?;
        let start = self.point(sheet, from)?;
        let at = start + self.direction(sheet, along)? * self.formula(size)?;
        Ok(Made::Place(sheet, self.new_place(sheet, lay_off)?, at))
    }

    fn like(&self, Like { like, on, ends, points, mirrored }: &Like) -> Result<Made, Message> {
        let sheet = self.sheet(*on, &[&ends[0], &ends[1]])?;
        let [from, to] = [self.point(sheet, &ends[0])?, self.point(sheet, &ends[1])?];
        let place = |name: &String| self.point(Sheet::Scheme, name);
        let [b, c, d] = [place(&points[0])?, place(&points[1])?, place(&points[2])?];
        let (base, arm) = (c - b, d - b);
        let size = base.norm_squared();
        if size == 0.0 {
            return Err(says::no_direction(format!("{},{}", points[0], points[1])));
        }
        // (d − b) / (c − b) as complex numbers.
        let mut ratio = complex_product(arm, Vector::new(base.x, -base.y)) / size;
        if *mirrored {
            ratio.y = -ratio.y;
        }
        Ok(Made::Place(sheet, self.new_place(sheet, like)?, from + complex_product(to - from, ratio)))
    }

    fn mark(&self, Mark { mark, on, drawn }: &Mark) -> Result<Made, Message> {
        let sheet = on.ok_or_else(says::which_sheet)?;
        Ok(Made::Place(sheet, self.new_place(sheet, mark)?, self.drawn_place(sheet, drawn)))
    }

    /// The sheet on which a distance is measured.
    ///
    /// # Errors
    /// It is not said, or a point is missing.
    pub(super) fn measured_on(&self, Measure { measure, on, from, to, .. }: &Measure) -> Result<Sheet, Message> {
        let named = segment_of(measure).map(|(sheet, _)| sheet);
        self.sheet(on.or(named), &[from, to])
    }

    fn measure(&self, entry: &Measure) -> Result<Made, Message> {
        let Measure { measure, from, to, .. } = entry;
        let sheet = self.measured_on(entry)?;
        let distance = (self.point(sheet, to)? - self.point(sheet, from)?).norm();
        Ok(Made::Numbers(vec![(self.new_number(measure)?, distance)]))
    }

    fn compute(&self, Compute { compute, by, value, sense }: &Compute) -> Result<Made, Message> {
        let number = match (by, value) {
            (Some(formula), _) => self.formula(formula)?,
            (None, value) => value.unwrap_or(f64::NAN),
        };
        let number = sense.map_or(number, |sense| number.abs() * sense.sign());
        Ok(Made::Numbers(vec![(self.new_number(compute)?, number)]))
    }

    /// How far a line lies from what was meant, in millimetres at the place through which it should go, and in degrees.
    pub(super) fn off(&self, meant: &DrawnLine, drawn: &[f64; 3]) -> [f64; 2] {
        let drawn = self.drawn_line(meant.sheet, drawn);
        let turn = degrees_of(complex_product(drawn.along, Vector::new(meant.along.x, -meant.along.y)));
        let turn = if turn > 90.0 {
            turn - 180.0
        } else if turn < -90.0 {
            turn + 180.0
        } else {
            turn
        };
        [drawn.distance(meant.at).abs() / self.scales[meant.sheet], turn.abs()]
    }
}

/// The smallest sine of the angle between two lines that cross somewhere.
const SMALLEST_SINE: f64 = 1e-9;

/// Whether a word may name a point or a line.
fn is_name(name: &str) -> bool {
    !name.is_empty() && !name.chars().any(|c| c.is_whitespace() || c.is_control() || matches!(c, '(' | ')' | '='))
}
