//! What a press on a sheet may mean for the entry that is being written: points, crossings, directions near it, the nearest first.

use super::entry::Entry;
use super::file::{HandDrawing, Snap};
use super::screen::{Screen, across, path};
use super::shown::{Ghost, GhostKind, Pressed, Snapped};
use super::table::{DrawnLine, Made, Table};
use crate::drawing::HandPaper;
use crate::geometry::{Vector, cross};
use crate::sheet::Sheet;
use serde_json::{Map, Value as Json, json};

/// Most meanings of a press that are told.
const MOST: usize = 24;

/// Most lines of a sheet whose crossings are looked at.
const MOST_LINES: usize = 200;

impl Screen {
    /// What a press may mean, the nearest first.
    #[must_use]
    pub fn snapped(&self, drawing: &HandDrawing, pressed: &Pressed) -> Vec<Snapped> {
        let scales = self.judge.scales(drawing);
        let Some(paper) = self.paper(pressed.sheet, scales) else { return Vec::new() };
        let (table, _) = self.judge.drawn(drawing);
        let press = Press { screen: self, table: &table, paper, pressed, snap: drawing.snap };
        let mut found = press.found();
        found.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        found.truncate(MOST);
        found.into_iter().map(|(_, snapped)| snapped).collect()
    }
}

struct Press<'p> {
    screen: &'p Screen,
    table: &'p Table<'p>,
    paper: HandPaper,
    pressed: &'p Pressed,
    snap: Snap,
}

/// What is caught, with its distance in mm.
type Caught = (f64, Snapped);

impl Press<'_> {
    fn found(&self) -> Vec<Caught> {
        let has = &self.pressed.has;
        let is = |key: &str| has.contains_key(key);
        if is("line") {
            match self.direction_is_there() {
                false => self.references(),
                // On the scheme a link is pressed for another direction; a line is drawn there through a point that is pressed itself.
                true if self.pressed.sheet == Sheet::Scheme && self.near(Sheet::Scheme).is_empty() => self.references(),
                true => self.through(),
            }
        } else if is("lay_off") {
            match (text(has, "from").is_empty(), self.direction_is_there()) {
                (true, _) => self.points("from"),
                (false, false) => self.references(),
                (false, true) => Vec::new(),
            }
        } else if is("join") {
            self.listed("points", 2, self.pressed.sheet)
        } else if is("measure") {
            self.points(if text(has, "from").is_empty() { "from" } else { "to" })
        } else if is("cross") {
            self.crossings()
        } else if is("like") {
            match self.pressed.sheet {
                Sheet::Scheme => self.listed("points", 3, Sheet::Scheme),
                sheet => self.listed("ends", 2, sheet),
            }
        } else if is("mark") {
            self.free_mark()
        } else if is("rub") {
            self.drawn_things()
        } else {
            Vec::new()
        }
    }

    fn direction_is_there(&self) -> bool {
        let along = self.pressed.has.get("along").and_then(Json::as_object);
        along.is_some_and(|along| {
            along.values().all(|value| match value {
                Json::String(name) => !name.is_empty(),
                Json::Array(all) => all.iter().all(|name| name.as_str().is_some_and(|name| !name.is_empty())),
                value => value.is_number(),
            }) && !along.is_empty()
        })
    }

    /// How far a place of the sheet is from the press, in mm.
    fn distance(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.pressed.at;
        libm::hypot(at[0] - x, at[1] - y)
    }

    fn entry(&self, key: &str, value: Json) -> Map<String, Json> {
        let mut entry = self.pressed.has.clone();
        entry.insert(key.to_owned(), value);
        // Crossings say their sheet by their lines.
        if !entry.contains_key("cross") && key != "along" && !(entry.contains_key("like") && key == "points") {
            entry.insert("on".to_owned(), json!(self.pressed.sheet));
        }
        entry
    }

    /// An entry, whether it is whole, and what it would draw.
    fn snapped(&self, entry: Map<String, Json>, words: String, at: [f64; 2]) -> Snapped {
        let made = self.made(&entry);
        let ghost = made.iter().flat_map(|made| self.ghost(&entry, made)).collect();
        Snapped { is_whole: made.is_some(), entry, words, at, ghost, direction: None }
    }

    /// What an entry makes, with any name where it has none.
    fn made(&self, entry: &Map<String, Json>) -> Option<Made> {
        let mut named = entry.clone();
        for key in ["line", "join", "cross", "lay_off", "like", "mark", "measure"] {
            if text(&named, key).is_empty() && named.contains_key(key) {
                let name = if key == "measure" { "zz" } else { "?" };
                named.insert(key.to_owned(), json!(name));
            }
        }
        let entry: Entry = serde_json::from_value(Json::Object(named)).ok()?;
        self.table.carry_out_by_hand(&entry).ok()
    }

    fn ghost(&self, entry: &Map<String, Json>, made: &Made) -> Vec<Ghost> {
        match made {
            Made::Place(sheet, _, at) if *sheet == self.pressed.sheet => {
                let end = self.paper.at(*at);
                let from = self.table.place(*sheet, &text(entry, "from"));
                let arrow = from.map(|from| Ghost { kind: GhostKind::Arrow, path: path(&[self.paper.at(from), end]) });
                arrow.into_iter().chain([dot(end)]).collect()
            }
            Made::Line(_, line) if line.sheet == self.pressed.sheet => {
                vec![Ghost { kind: GhostKind::Line, path: path(&across(line, &self.paper)) }]
            }
            _ => Vec::new(),
        }
    }

    /// The points near the press.
    fn near(&self, sheet: Sheet) -> Vec<(f64, String, [f64; 2])> {
        if sheet != self.pressed.sheet {
            return Vec::new();
        }
        let given = self.screen.judge.given();
        let places = self.table.places(sheet).filter(|(name, _)| !given.is_second_name(sheet, name));
        let all = places.map(|(name, place)| {
            let at = self.paper.at(place);
            (self.distance(at), name.to_owned(), at)
        });
        all.filter(|(distance, ..)| *distance <= self.pressed.reach).collect()
    }

    fn points(&self, key: &str) -> Vec<Caught> {
        let caught = |(distance, name, at): (f64, String, [f64; 2])| {
            (distance, self.snapped(self.entry(key, json!(name)), name, at))
        };
        self.near(self.pressed.sheet).into_iter().map(caught).collect()
    }

    /// Points for a list of so many.
    fn listed(&self, key: &str, count: usize, sheet: Sheet) -> Vec<Caught> {
        let before: Vec<String> = self.pressed.has.get(key).and_then(Json::as_array).map_or_else(Vec::new, |all| {
            all.iter().filter_map(|name| name.as_str()).filter(|name| !name.is_empty()).map(str::to_owned).collect()
        });
        if before.len() >= count {
            return Vec::new();
        }
        let near = self.near(sheet).into_iter().filter(|(_, name, _)| !before.contains(name));
        near.map(|(distance, name, at)| {
            let mut all = before.clone();
            all.push(name.clone());
            (distance, self.snapped(self.entry(key, json!(all)), name, at))
        })
        .collect()
    }

    /// What gives a direction near the press: links, guides, lines.
    fn references(&self) -> Vec<Caught> {
        let how = self.pressed.has.get("along").and_then(Json::as_object).and_then(|along| along.keys().next());
        let how = how.map_or("normal", String::as_str);
        let language = self.screen.language();
        let mut caught = Vec::new();
        let mut add = |name: String, words: String, ends: [[f64; 2]; 2]| {
            let (distance, at) = self.segment_off(&ends);
            if distance <= self.pressed.reach {
                let mut snapped = self.snapped(self.entry("along", self.along(&name)), words, at);
                let [[x, y], [to_x, to_y]] = ends;
                snapped.direction = Some(crate::geometry::degrees_of(Vector::new(to_x - x, y - to_y)));
                if how != "turned" {
                    snapped.ghost.push(square(&ends, at, how == "normal"));
                }
                // Of two at the same place the shorter is meant: a part of a link.
                let length = libm::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
                caught.push((distance + 1e-3 * length, snapped));
            }
        };
        // The figure of instant centres has the mechanism, too.
        if matches!(self.pressed.sheet, Sheet::Scheme | Sheet::Centers) {
            let all = self.screen.references(self.table);
            for (index, reference) in all.iter().enumerate() {
                // A link of two points and the two are the same at a press.
                if all[..index].iter().any(|before| before.ends == reference.ends) {
                    continue;
                }
                let ends = reference.ends.map(|end| self.paper.at(end));
                add(reference.name.clone(), language.says(&reference.words), ends);
            }
        }
        if self.pressed.sheet == Sheet::Forces {
            for reference in self.screen.corners(self.table) {
                let ends = reference.ends.map(|end| self.paper.at(end));
                add(reference.name.clone(), language.says(&reference.words), ends);
            }
        }
        for (name, line) in self.table.lines().filter(|(_, line)| line.sheet == self.pressed.sheet) {
            add(name.to_owned(), language.says(&super::says::drawn_line(name)), across(line, &self.paper));
        }
        caught
    }

    /// The direction that is being said, with a reference where the next is missing.
    fn along(&self, name: &str) -> Json {
        let mut along = self.pressed.has.get("along").cloned().unwrap_or_else(|| json!({ "normal": "" }));
        let Some(parts) = along.as_object_mut() else { return json!({ "normal": name }) };
        let is_turned = parts.contains_key("turned");
        let turned = parts.get_mut("turned").and_then(Json::as_array_mut);
        let missing = turned.and_then(|all| all.iter_mut().find(|part| part.as_str() == Some("")));
        match missing {
            Some(part) => *part = json!(name),
            None if is_turned => {
                parts.insert("base".to_owned(), json!(name));
            }
            None => parts.values_mut().take(1).for_each(|part| *part = json!(name)),
        }
        along
    }

    /// How far a segment is from the press, and its nearest place.
    fn segment_off(&self, [a, b]: &[[f64; 2]; 2]) -> (f64, [f64; 2]) {
        let (start, along) = (Vector::from(*a), Vector::from(*b) - Vector::from(*a));
        let press = Vector::from(self.pressed.at);
        let share = ((press - start).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let at = start + along * share;
        ((press - at).norm(), [at.x, at.y])
    }

    /// The points through which the edge of the set square goes that lies at the press.
    fn through(&self) -> Vec<Caught> {
        let sheet = self.pressed.sheet;
        let along = self.pressed.has.get("along").cloned().unwrap_or_default();
        let Ok(along) = serde_json::from_value(along) else { return Vec::new() };
        let Ok(direction) = self.table.direction(sheet, &along) else { return Vec::new() };
        let press = self.paper.under(self.pressed.at);
        let off = |place: Vector| cross(direction, place - press).abs() / self.paper.mu;
        let given = self.screen.judge.given();
        let near = self
            .table
            .places(sheet)
            .filter(|(name, place)| off(*place) <= self.pressed.reach && !given.is_second_name(sheet, name));
        let mut caught: Vec<Caught> = near
            .map(|(name, place)| {
                let at = self.paper.at(place);
                // Of several points on the edge the one next to the press is meant.
                let distance = off(place) + 1e-3 * self.distance(at);
                let mut entry = self.entry("through", json!(name));
                if self.snap == Snap::None {
                    // The point is meant, and the line is where the hand has put it.
                    entry.insert("drawn".to_owned(), self.drawn(press, Some(direction)));
                }
                let mut snapped = self.snapped(entry, name.to_owned(), at);
                // The set square slides with the hand, its edge on the line.
                let edge = [at, self.paper.at(place + direction * self.paper.mu)];
                snapped.ghost.push(square(&edge, at, true));
                (distance, snapped)
            })
            .collect();
        if self.snap != Snap::All {
            let mut entry = self.entry("drawn", self.drawn(press, Some(direction)));
            entry.shift_remove("through");
            let words = self.screen.language().says(&super::says::line_by_eye(text(&entry, "line")));
            caught.push((self.pressed.reach, self.snapped(entry, words, self.pressed.at)));
        }
        caught
    }

    /// A place as entries have it, with a direction in degrees.
    fn drawn(&self, place: Vector, direction: Option<Vector>) -> Json {
        let round = |x: f64| libm::round(x * 100.0) / 100.0;
        let [x, y] = [place.x, place.y].map(|side| round(side / self.paper.mu));
        match direction {
            None => json!([x, y]),
            Some(direction) => json!([x, y, round(crate::geometry::degrees_of(direction))]),
        }
    }

    fn crossings(&self) -> Vec<Caught> {
        let sheet = self.pressed.sheet;
        let lines: Vec<(&str, &DrawnLine)> =
            self.table.lines().filter(|(_, line)| line.sheet == sheet).take(MOST_LINES).collect();
        let mut caught = Vec::new();
        for (index, (one, first)) in lines.iter().enumerate() {
            for (two, second) in &lines[index + 1..] {
                let sine = cross(first.along, second.along);
                if sine.abs() < 1e-6 {
                    continue;
                }
                let place = first.at + first.along * (cross(second.at - first.at, second.along) / sine);
                let at = self.paper.at(place);
                let distance = self.distance(at);
                if distance <= self.pressed.reach {
                    let mut entry = self.entry("of", json!([one, two]));
                    if self.snap == Snap::None {
                        entry.insert("drawn".to_owned(), self.drawn(self.paper.under(self.pressed.at), None));
                    }
                    caught.push((distance, self.snapped(entry, format!("{one} × {two}"), at)));
                }
            }
        }
        caught
    }

    /// What was drawn near the press: points before lines, which many points lie on.
    fn drawn_things(&self) -> Vec<Caught> {
        let sheet = self.pressed.sheet;
        let caught = |(distance, name, at, words, ghost): (f64, &str, [f64; 2], String, Ghost)| {
            let mut entry = self.pressed.has.clone();
            entry.insert("rub".to_owned(), json!(name));
            entry.insert("on".to_owned(), json!(sheet));
            (distance, Snapped { entry, is_whole: true, words, at, ghost: vec![ghost], direction: None })
        };
        let is_drawn = |name: &str| self.screen.judge.given().there().all(|(on, own, _)| (on, own) != (sheet, name));
        let points = self.table.places(sheet).filter(|(name, _)| is_drawn(name)).map(|(name, place)| {
            let at = self.paper.at(place);
            (0.5 * self.distance(at), name, at, name.to_owned(), dot(at))
        });
        let lines = self.table.lines().filter(|(_, line)| line.sheet == sheet).map(|(name, line)| {
            let ends = across(line, &self.paper);
            let (distance, at) = self.segment_off(&ends);
            let words = self.screen.language().says(&super::says::drawn_line(name));
            (distance, name, at, words, Ghost { kind: GhostKind::Line, path: path(&ends) })
        });
        points.chain(lines).filter(|(distance, ..)| *distance <= self.pressed.reach).map(caught).collect()
    }

    fn free_mark(&self) -> Vec<Caught> {
        let place = self.paper.under(self.pressed.at);
        let entry = self.entry("drawn", self.drawn(place, None));
        vec![(0.0, self.snapped(entry, String::new(), self.pressed.at))]
    }
}

fn text(entry: &Map<String, Json>, key: &str) -> String {
    entry.get(key).and_then(Json::as_str).unwrap_or_default().to_owned()
}

fn dot([x, y]: [f64; 2]) -> Ghost {
    Ghost { kind: GhostKind::Point, path: format!("M{:.2} {:.2}h0", x, y) }
}

/// The set square as it lies on what gives its direction: its edge, and the leg that is normal to it.
fn square(ends: &[[f64; 2]; 2], at: [f64; 2], is_normal: bool) -> Ghost {
    let [a, b] = ends.map(Vector::from);
    let along = crate::geometry::unit(b - a).unwrap_or(Vector::x());
    let (at, leg) = (Vector::from(at), if is_normal { 26.0 } else { 14.0 });
    let across = Vector::new(along.y, -along.x);
    let [p, q, r] = [at - along * 26.0, at + along * 26.0, at + across * leg];
    let corner = |v: Vector| format!("{:.2} {:.2}", v.x, v.y);
    Ghost { kind: GhostKind::Square, path: format!("M{}L{}L{}Z", corner(p), corner(q), corner(r)) }
}
