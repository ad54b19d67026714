//! What a free hand may have meant, and whether it is as near to that as a hand is.

use super::alone::Held;
use super::bench::{Bench, Found};
use super::direction::Direction;
use super::entry::{Cross, Entry, LayOff, Line, Measure};
use super::says;
use super::table::{DrawnLine, Made};
use crate::construction::image_name;
use crate::geometry::Vector;
use crate::message::Message;
use crate::sheet::Sheet;

/// How many times the tolerance a free hand may be off.
pub(super) const FREE: f64 = 3.0;

/// What a reading may be off by besides, in mm: rulers have millimetres.
const RULER: f64 = 0.5;

/// Most points of a link whose triangles a free line may have been drawn after.
const MOST_POINTS: usize = 6;

impl Bench<'_> {
    /// What a line may mean: what stands in its entry, or all points and directions that its place allows.
    pub fn meant(&self, line: &Line) -> Vec<Entry> {
        if line.drawn.is_none() || line.through.is_some() && line.along.is_some() {
            return vec![Entry::Line(Line { drawn: None, ..line.clone() })];
        }
        let directions = |sheet| match &line.along {
            Some(along) => vec![along.clone()],
            None => self.directions(sheet),
        };
        self.drawn_so(line, &directions)
    }

    /// Angles of triangles at which a line by eye was drawn, laid off to the wrong side.
    pub fn meant_turned_over(&self, line: &Line) -> Vec<Entry> {
        if line.drawn.is_none() || line.along.is_some() {
            return Vec::new();
        }
        let turned = |direction| match direction {
            Direction::Turned { turned: [from, to], base } => Some(Direction::Turned { turned: [to, from], base }),
            _ => None,
        };
        self.drawn_so(line, &|sheet| self.directions(sheet).into_iter().filter_map(turned).collect())
    }

    /// The points and, of some directions, those that the place of a free line allows.
    fn drawn_so(&self, line: &Line, directions: &dyn Fn(Sheet) -> Vec<Direction>) -> Vec<Entry> {
        let Some(drawn) = line.drawn else { return Vec::new() };
        let Ok(Made::Line(_, there)) = self.own.carry_out(&Entry::Line(line.clone())) else { return Vec::new() };
        let (sheet, limit) = (there.sheet, self.judge.tolerance());
        let reach = FREE * limit.mm * self.own.scale(sheet);
        let through = |name: &str| line.through.as_deref().is_none_or(|stated| stated == name);
        let near = self.own.places(sheet).filter(|(name, at)| through(name) && there.distance(*at).abs() <= reach);
        let points: Vec<String> = near.map(|(name, _)| name.to_owned()).collect();
        let mut meant = Vec::new();
        for along in directions(sheet) {
            let Ok(direction) = self.own.direction(sheet, &along) else { continue };
            let [_, turn] = self.own.off(&DrawnLine { sheet, at: there.at, along: direction }, &drawn);
            if turn <= FREE * limit.degrees {
                meant.extend(points.iter().map(|point| {
                    let (through, along) = (Some(point.clone()), Some(along.clone()));
                    Entry::Line(Line { through, along, drawn: None, on: Some(sheet), line: line.line.clone() })
                }));
            }
        }
        meant
    }

    /// Of what a free line may mean, what is right.
    pub fn right_meaning(&self, entry: &Entry) -> Option<Entry> {
        let Entry::Line(line) = entry else { return None };
        let meant = self.meant(line);
        let first = meant.iter().find(|one| matches!(self.holds(one, &line.line, self.reads_typed(one)), Held::All));
        first.or(meant.first()).cloned()
    }

    /// The directions that a mechanism offers to a set square: along and across its links, guides and lines of the scheme.
    fn directions(&self, sheet: Sheet) -> Vec<Direction> {
        let given = self.judge.given();
        let mechanism = given.mechanism();
        let mut names: Vec<String> = mechanism.slider_ids().map(|id| mechanism.slider_name(id)).collect();
        for (id, body) in mechanism.links() {
            let mut points: Vec<&str> = body.points.iter().map(|point| mechanism.point_name(*point)).collect();
            let special = given.construction().special.iter().filter(|special| special.link == id);
            points.extend(special.map(|special| special.name.as_str()));
            points.retain(|name| self.own.place(Sheet::Scheme, name).is_some());
            for (at, from) in points.iter().enumerate() {
                names.extend(points[at + 1..].iter().map(|to| format!("{from},{to}")));
            }
        }
        names.extend(self.own.lines().filter(|(_, line)| line.sheet == Sheet::Scheme).map(|(name, _)| name.to_owned()));
        let mut all = Vec::new();
        for (_, body) in mechanism.links().filter(|(_, body)| body.points.len() > 2 && sheet != Sheet::Scheme) {
            let points: Vec<&str> = body.points.iter().take(MOST_POINTS).map(|p| mechanism.point_name(*p)).collect();
            let pairs: Vec<[&str; 2]> = (0..points.len())
                .flat_map(|at| points[at + 1..].iter().map(|to| [points[at], *to]).collect::<Vec<_>>())
                .collect();
            // The image of a link is as its triangle: at a side that is there the angle to another.
            for base in
                pairs.iter().filter(|ends| ends.iter().all(|end| self.own.place(sheet, &image_name(end)).is_some()))
            {
                all.extend(pairs.iter().filter(|other| *other != base).map(|other| Direction::Turned {
                    turned: [base.join(","), other.join(",")],
                    base: base.map(image_name).join(","),
                }));
            }
        }
        // A line of centres runs through two of them.
        if sheet == Sheet::Centers {
            let places: Vec<&str> = self.own.places(sheet).map(|(name, _)| name).collect();
            for (at, from) in places.iter().enumerate() {
                all.extend(places[at + 1..].iter().map(|to| Direction::Parallel { parallel: format!("{from},{to}") }));
            }
        }
        let both = |name: String| [Direction::Parallel { parallel: name.clone() }, Direction::Normal { normal: name }];
        all.extend(names.into_iter().flat_map(both));
        all
    }

    /// How far a line is from what it meant, where that is too far.
    pub fn line_off_hand(&self, meant: &Entry, line: &Line) -> Option<Message> {
        let drawn = line.drawn?;
        let Ok(Made::Line(_, meant)) = self.own.carry_out(meant) else { return None };
        let [mm, degrees] = self.own.off(&meant, &drawn);
        let limit = self.judge.tolerance();
        let is_off = mm > FREE * limit.mm || degrees > FREE * limit.degrees;
        is_off.then(|| says::drawn_off(rounded(mm), rounded(degrees)))
    }

    /// How far a point is from what it meant, where that is too far.
    pub fn place_off_hand(&self, entry: &Entry, sheet: Sheet, own: Vector) -> Option<Message> {
        let (Entry::Cross(Cross { drawn: Some(_), .. }) | Entry::LayOff(LayOff { drawn: Some(_), .. })) = entry else {
            return None;
        };
        let Ok(Made::Place(_, _, meant)) = self.own.carry_out(entry) else { return None };
        let (scale, limit) = (self.own.scale(sheet), self.judge.tolerance());
        let mm = (own - meant).norm() / scale;
        // Along x and y each, and a direction's error over the length.
        let reach = match entry {
            Entry::LayOff(LayOff { from, .. }) => self.own.place(sheet, from).map_or(0.0, |from| (meant - from).norm()),
            _ => 0.0,
        };
        let turn = reach / scale * limit.degrees.to_radians();
        let is_off = mm > FREE * (std::f64::consts::SQRT_2 * limit.mm + turn);
        is_off.then(|| says::point_off(rounded(mm)))
    }

    /// A length that was read otherwise than it was drawn.
    pub fn misread(&self, entry: &Entry, measure: &Measure) -> Found {
        let Some(read) = measure.read else { return Found::Right };
        let Ok(Made::Numbers(all)) = self.own.carry_out(entry) else { return Found::Right };
        let scale = self.measured_on(measure).map_or(1.0, |sheet| self.own.scale(sheet));
        let off = all.first().map_or(0.0, |(_, drawn)| (drawn - read).abs() / scale);
        match off > FREE * self.judge.tolerance().mm + RULER {
            true => Found::Wrong(says::misread(&measure.measure, rounded(off))),
            false => Found::Right,
        }
    }
}

/// A number of millimetres or degrees, to a tenth.
fn rounded(x: f64) -> String {
    format!("{x:.1}")
}
