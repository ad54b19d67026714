//! What an entry comes to by itself, with right inputs: a point must be where its name says, a number must be what its name says, a line
//! must go through the point for which it is used.

use super::bench::{Bench, Found, is_size_of_force};
use super::entry::{Compute, Cross, Entry, LayOff, Line, Measure, Solve};
use super::formula::Formula;
use super::says;
use super::table::{DrawnLine, Made, Table};
use crate::geometry::Vector;
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;

/// What two numbers that are the same may differ by, in parts.
pub(super) const SAME: f64 = 1e-6;

/// What a number that somebody typed may be off by, in parts: it has three digits or more.
const TYPED: f64 = 0.012;

/// Most numbers of a formula whose signs are tried: in another scene a segment may run the other way.
const MOST_SIGNS: usize = 6;

/// Whether a line goes through the points for which it is used.
pub(super) enum Held {
    /// It does.
    All,
    /// It misses this one.
    Not(String),
    /// It is used for no point that has a meaning.
    Nothing,
}

impl Bench<'_> {
    /// What an entry comes to with right inputs. Where numbers in it were typed, only the scene itself counts, and what digits leave open.
    pub fn found(&self, entry: &Entry, made: &Made, is_typed: bool) -> Found {
        let given = self.judge.given();
        match (entry, made) {
            (Entry::Line(line), Made::Line(name, _)) => self.found_line(line, name, is_typed),
            (Entry::Join(_), Made::Line(name, _)) => match self.holds(entry, name, is_typed) {
                // Two points that are there are joined rightly, whatever for.
                Held::Nothing => Found::Own,
                Held::All => Found::Right,
                Held::Not(point) => Found::Wrong(says::line_misses(self.shown(&point))),
            },
            (Entry::Mark(_), Made::Place(sheet, name, at)) if given.place(*sheet, name).is_some() => {
                match self.is_at_crossing(*sheet, name, *at) || self.is_near_expected(*sheet, name, *at) {
                    true => Found::Right,
                    false => Found::Wrong(says::point_elsewhere(self.shown(name))),
                }
            }
            (Entry::Mark(_), _) => Found::Own,
            (_, Made::Place(sheet, name, at)) => self.found_place(entry, *sheet, name, *at, is_typed),
            (Entry::Solve(solve), Made::Numbers(all)) => self.found_equations(solve, all, is_typed),
            (_, Made::Numbers(all)) => match all.first() {
                Some((name, own)) => self.found_number(entry, name, *own, is_typed),
                None => Found::Own,
            },
            _ => Found::Own,
        }
    }

    fn shown(&self, name: &str) -> String {
        self.judge.given().shown(name)
    }

    fn found_line(&self, line: &Line, name: &str, is_typed: bool) -> Found {
        let mut missed = None;
        for one in &self.meant(line) {
            let is_typed = is_typed || self.reads_typed(one);
            let held = match self.holds(one, name, is_typed) {
                // It is not used yet: right is one that leads to a point that is still to be found.
                Held::Nothing if !self.targets.contains_key(name) && self.leads_on(one, is_typed) => Held::All,
                held => held,
            };
            match held {
                Held::Nothing => return Found::Own,
                Held::All => match self.line_off_hand(one, line) {
                    None => return Found::Right,
                    Some(off) => missed = Some(off),
                },
                Held::Not(point) => missed = missed.or_else(|| Some(says::line_misses(self.shown(&point)))),
            }
        }
        match (missed, self.targets.get(name)) {
            (Some(missed), _) => Found::Wrong(missed),
            (None, Some(targets)) => Found::Wrong(says::line_misses(self.shown(&targets[0]))),
            (None, None) => Found::Own,
        }
    }

    /// Whether a line goes through the points at whose crossings it is used.
    pub fn holds(&self, entry: &Entry, name: &str, is_typed: bool) -> Held {
        let Some(targets) = self.targets.get(name) else { return Held::Nothing };
        // What was drawn for something else, too, is crossed wrongly there, not drawn wrongly.
        if matches!(entry, Entry::Join(_)) && self.uses.get(name).is_some_and(|uses| *uses > targets.len()) {
            return Held::Nothing;
        }
        let mut first = None;
        for target in targets {
            let mut has_meaning = false;
            let held = self.scenes(is_typed).enumerate().all(|(scene, table)| {
                let Ok(Made::Line(_, line)) = table.carry_out(entry) else { return scene > 0 };
                let Some(place) = table.given.place(line.sheet, target) else { return true };
                has_meaning = true;
                let allowed = if is_typed { self.typed_reach(line.sheet, (place - line.at).norm()) } else { 0.0 };
                line.distance(place).abs() <= allowed + SAME * table.given.size(line.sheet)
            });
            match (has_meaning, held) {
                (true, true) => return Held::All,
                (true, false) => first = first.or(Some(target.clone())),
                (false, _) => {}
            }
        }
        first.map_or(Held::Nothing, Held::Not)
    }

    /// Whether a line goes through a point of the plan that the hand does not have yet.
    fn leads_on(&self, entry: &Entry, is_typed: bool) -> bool {
        let Some(sheet) = self.own.carry_out(entry).ok().and_then(|made| match made {
            Made::Line(_, line) => Some(line.sheet),
            _ => None,
        }) else {
            return false;
        };
        let given = self.judge.given();
        // A point may have several names.
        let has = |at: Vector| {
            let near = SAME * given.size(sheet);
            given
                .places(sheet)
                .any(|(name, place)| self.own.place(sheet, name).is_some() && (place - at).norm() <= near)
        };
        let mut open = given.places(sheet).filter(|(_, at)| !has(*at));
        open.any(|(name, _)| {
            self.scenes(is_typed).enumerate().all(|(scene, table)| {
                let Ok(Made::Line(_, line)) = table.carry_out(entry) else { return scene > 0 };
                let Some(place) = table.given.place(sheet, name) else { return false };
                let allowed = if is_typed { self.typed_reach(sheet, (place - line.at).norm()) } else { 0.0 };
                line.distance(place).abs() <= allowed + SAME * table.given.size(sheet)
            })
        })
    }

    /// The right things of the scenes that count.
    pub fn scenes(&self, is_typed: bool) -> impl Iterator<Item = &Table<'_>> {
        self.right.iter().take(if is_typed { 1 } else { usize::MAX })
    }

    /// How far a typed number or angle may lead aside at this distance.
    pub fn typed_reach(&self, sheet: Sheet, distance: f64) -> f64 {
        let limit = self.judge.tolerance();
        3.0 * (limit.mm * self.own.scale(sheet) + limit.degrees.to_radians() * distance) + TYPED * distance
    }

    fn found_place(&self, entry: &Entry, sheet: Sheet, name: &str, own: Vector, is_typed: bool) -> Found {
        if self.judge.given().place(sheet, name).is_none() {
            return if self.is_known_vector(entry, sheet) { Found::Right } else { Found::Own };
        }
        if matches!(entry, Entry::Cross(Cross { of, .. }) if of.iter().any(|line| self.wrong_lines.contains(line))) {
            return Found::Right;
        }
        let start = match entry {
            Entry::LayOff(LayOff { from, .. }) => Some(from),
            _ => None,
        };
        let is_right = self.in_all(entry, is_typed, |table, made| match (made, table.given.place(sheet, name)) {
            (Made::Place(_, _, at), Some(right)) => {
                let run = start.and_then(|from| table.place(sheet, from)).map_or(0.0, |from| (at - from).norm());
                let allowed = match entry {
                    _ if !is_typed => 0.0,
                    // Lines that typed numbers have moved cross farther away.
                    Entry::Cross(_) => self.typed_reach(sheet, right.norm()) + self.reach(sheet, name),
                    _ => self.typed_reach(sheet, run),
                };
                (at - right).norm() <= allowed + SAME * table.given.size(sheet)
            }
            _ => false,
        });
        let as_expected = || {
            let expected = self.causes.expected_place(&self.own, sheet, name);
            let start = start.and_then(|from| self.own.place(sheet, from));
            expected.is_some_and(|expected| {
                let run = start.map_or(0.0, |start| (own - start).norm());
                (own - expected).norm() <= self.typed_reach(sheet, run)
            })
        };
        let as_recognised = || {
            let given = self.judge.given();
            let is_right = |made: &Made| match (made, given.place(sheet, name)) {
                (Made::Place(_, _, at), Some(right)) => (at - right).norm() <= SAME * given.size(sheet),
                _ => false,
            };
            self.made_with_right_numbers(entry, false).iter().any(is_right)
        };
        if !(is_right || is_typed && (as_expected() || as_recognised())) {
            return Found::Wrong(match entry {
                Entry::Cross(_) => says::lines_of_others(self.shown(name)),
                _ => says::point_elsewhere(self.shown(name)),
            });
        }
        match self.place_off_hand(entry, sheet, own) {
            Some(off) => Found::Wrong(off),
            None => Found::Right,
        }
    }

    /// Whether a vector that leads to a point of the hand's own is one that the plan may show.
    pub fn is_known_vector(&self, entry: &Entry, sheet: Sheet) -> bool {
        let Entry::LayOff(LayOff { from, .. }) = entry else { return false };
        self.in_all(entry, false, |table, made| {
            let (Made::Place(_, _, end), Some(start)) = (made, table.place(sheet, from)) else { return false };
            let small = SAME * table.given.size(sheet);
            table.given.vectors(sheet).iter().any(|known| (end - start - known).norm() <= small)
        })
    }

    /// Whether a number of the hand's own is one that has a name. A measured distance is that of its points.
    pub fn is_known_number(&self, entry: &Entry) -> bool {
        matches!(entry, Entry::Measure(_)) || self.causes.is_known_number(entry, &self.right)
    }

    /// Whether what an entry makes is right in the scenes that count; in others the numbers of a formula may have changed their signs.
    pub fn in_all(&self, entry: &Entry, is_typed: bool, is_right: impl Fn(&Table<'_>, &Made) -> bool) -> bool {
        self.scenes(is_typed).enumerate().all(|(scene, table)| {
            let right = || match table.carry_out(entry) {
                Ok(made) => is_right(table, &made),
                // What degenerates elsewhere says nothing.
                Err(_) => scene > 0,
            };
            right() || (scene > 0 && any_signs(table, &formulas(entry), right))
        })
    }

    fn found_number(&self, entry: &Entry, name: &str, own: f64, is_typed: bool) -> Found {
        // A side of a polygon that hangs on something wrong is measured rightly.
        let ends = |measure: &Measure| [&measure.from, &measure.to].map(|end| (Some(Sheet::Forces), end.clone()));
        if let Entry::Measure(measure) = entry
            && ends(measure).iter().any(|end| self.tainted.contains(end))
        {
            return Found::Right;
        }
        if let Entry::Measure(measure) = entry {
            if self.is_between_others(measure) {
                return Found::Wrong(says::number_wrong(name));
            }
            if let Found::Wrong(what) = self.misread(entry, measure) {
                return Found::Wrong(what);
            }
        }
        let Some(asked) = self.meaning(entry, name) else {
            return if self.is_known_number(entry) { Found::Right } else { Found::Own };
        };
        if matches!(entry, Entry::Compute(Compute { by: None, .. })) {
            return match self.is_near_expected_number(&asked, own) {
                true => Found::Right,
                false => Found::Wrong(says::number_wrong(name)),
            };
        }
        let stated = matches!(entry, Entry::Compute(Compute { sense: Some(_), .. }));
        let is_size = self.is_size_alone(&asked);
        let near =
            |found: f64, right: f64| same(found, right) || (is_typed && (found - right).abs() <= TYPED * right.abs());
        let is_right = self.in_all(entry, is_typed, |table, made| {
            let (Made::Numbers(all), Some(right)) = (made, table.given.number(&asked)) else { return false };
            let is_scene = std::ptr::eq(table.given, self.judge.given());
            all.iter().all(|(_, found)| {
                // In other scenes a link may turn the other way, which a stated sense does not know.
                near(*found, right) || ((is_size || stated && !is_scene) && near(found.abs(), right.abs()))
            })
        });
        if !(is_right || is_typed && self.is_near_expected_number(&asked, own)) {
            return Found::Wrong(says::number_wrong(name));
        }
        Found::Right
    }

    /// Whether a quantity is the size of a velocity that is laid off on no plan: its sign says nothing there.
    fn is_size_alone(&self, asked: &str) -> bool {
        if is_size_of_force(asked) {
            return true;
        }
        let is_velocity = QuantityName::parse(asked).is_some_and(|name| name.head == Head::Velocity);
        is_velocity && !self.judge.given().construction().by_hand.contains(&Sheet::Velocity)
    }

    /// Whether a length or a segment is measured between other points than its name has.
    pub fn is_between_others(&self, measure: &Measure) -> bool {
        let Some((sheet, ends)) = super::names::segment_of(&measure.measure) else { return false };
        let own = [&measure.from, &measure.to];
        let place = |name: &String| self.own.place(sheet, name);
        // A point may have several names.
        let is_same = |a: &String, b: &String| a == b || place(a).is_some_and(|at| Some(at) == place(b));
        let [a, b] = &ends;
        !(is_same(own[0], a) && is_same(own[1], b) || is_same(own[0], b) && is_same(own[1], a))
    }

    /// The quantity that a number's name means: itself, or of two points written together the segment between them.
    pub fn meaning(&self, entry: &Entry, name: &str) -> Option<String> {
        let given = self.judge.given();
        if given.number(name).is_some() {
            return Some(name.to_owned());
        }
        let Entry::Measure(measure) = entry else { return None };
        // Signs behind letters may be the hand's own.
        if !name.chars().all(char::is_alphabetic) {
            return None;
        }
        let sheet = self.measured_on(measure)?;
        let names: Vec<&str> = given.places(sheet).map(|(name, _)| name).collect();
        let split = names.iter().find_map(|first| {
            let second = name.strip_prefix(first)?;
            names.contains(&second).then(|| sheet.segment_name(first, second))
        })?;
        given.number(&split)?;
        Some(split)
    }

    /// The sheet on which something is measured.
    pub fn measured_on(&self, Measure { on, from, to, .. }: &Measure) -> Option<Sheet> {
        let has = |sheet: &Sheet| self.own.place(*sheet, from).is_some() && self.own.place(*sheet, to).is_some();
        on.or_else(|| Sheet::ALL.into_iter().find(has))
    }

    fn found_equations(&self, solve: &Solve, own: &[(String, f64)], is_typed: bool) -> Found {
        if own.iter().any(|(name, _)| self.judge.given().number(name).is_none()) {
            return Found::Own;
        }
        let wrong = (0..solve.equations.len()).find(|&equation| {
            !self.scenes(is_typed).enumerate().all(|(scene, table)| {
                let unknowns: Option<Vec<f64>> = own.iter().map(|(name, _)| table.given.number(name)).collect();
                let Some(unknowns) = unknowns else { return false };
                let allowed = if is_typed { TYPED } else { SAME };
                let turned: Vec<f64> = unknowns
                    .iter()
                    .zip(own)
                    .map(
                        |(right, (name, own))| if is_size_of_force(name) { right.abs().copysign(*own) } else { *right },
                    )
                    .collect();
                let holds = || {
                    let remains = table.residuals(solve, &turned);
                    remains.is_ok_and(|remains| remains[equation].abs() <= allowed)
                };
                let sides = Formula::sides(&solve.equations[equation]);
                let holds_turned = || sides.is_ok_and(|[left, right]| any_signs(table, &[&left, &right], holds));
                holds() || (scene > 0 && holds_turned())
            })
        });
        match wrong {
            Some(_) if is_typed && own.iter().all(|(name, own)| self.is_near_expected_number(name, *own)) => {
                Found::Right
            }
            Some(equation) => Found::Wrong(says::equation_wrong(equation + 1)),
            None => Found::Right,
        }
    }

    /// Whether a point that was put down is a right crossing of two lines of the hand's.
    fn is_at_crossing(&self, sheet: Sheet, name: &str, at: Vector) -> bool {
        let near = 3.0 * std::f64::consts::SQRT_2 * self.judge.tolerance().mm * self.own.scale(sheet);
        let is_here = |line: &DrawnLine| line.sheet == sheet && line.distance(at).abs() <= near;
        let lines: Vec<&str> = self.own.lines().filter(|(_, line)| is_here(line)).map(|(name, _)| name).collect();
        let mut pairs =
            lines.iter().enumerate().flat_map(|(index, one)| lines[index + 1..].iter().map(move |two| [one, two]));
        pairs.any(|of| {
            let entry =
                Entry::Cross(Cross { cross: name.to_owned(), of: of.map(|line| (*line).to_owned()), drawn: None });
            let is_there =
                matches!(self.own.carry_out(&entry), Ok(Made::Place(_, _, found)) if (found - at).norm() <= near);
            is_there && matches!(self.found_place(&entry, sheet, name, at, self.reads_typed(&entry)), Found::Right)
        })
    }

    /// How far from its place a point may be that a hand has found, in units of its sheet.
    fn reach(&self, sheet: Sheet, name: &str) -> f64 {
        self.causes.reach(sheet, name, &self.own)
    }

    /// Whether a point that was put down, or laid off with a typed number, is where the hand's own things lead, or where it is in the end,
    /// as far as a hand can tell.
    fn is_near_expected(&self, sheet: Sheet, name: &str, at: Vector) -> bool {
        let reach = self.reach(sheet, name);
        let near = |place: Vector| (at - place).norm() <= reach;
        self.judge.given().place(sheet, name).is_some_and(near)
            || self.causes.expected_place(&self.own, sheet, name).is_some_and(near)
    }

    /// The same of a typed number.
    fn is_near_expected_number(&self, name: &str, own: f64) -> bool {
        let near = |value: f64, band: f64| (own - value).abs() <= band;
        let typed = |value: f64| near(value, TYPED * value.abs());
        let right = self.judge.given().number(name);
        right.is_some_and(typed)
            || self.causes.expected_number(&self.own, name).is_some_and(typed)
            || right.is_some_and(|right| near(right, 1.5 * self.causes.band(name, &self.own)))
    }
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs()).max(f64::MIN_POSITIVE) || (a.abs() < 1e-9 && b.abs() < 1e-9)
}

/// Whether something holds with some of the numbers in formulas taken with the other sign.
fn any_signs(table: &Table<'_>, formulas: &[&Formula], holds: impl Fn() -> bool) -> bool {
    let mut names = table.signed(formulas);
    names.truncate(MOST_SIGNS);
    let found = (1..1_usize << names.len()).any(|turned| {
        let chosen = names.iter().enumerate().filter(|(at, _)| turned >> at & 1 == 1);
        table.turn(chosen.map(|(_, name)| name.clone()).collect());
        holds()
    });
    table.turn(Vec::new());
    found
}

/// The formulas of an entry, but for equations.
fn formulas(entry: &Entry) -> Vec<&Formula> {
    match entry {
        Entry::LayOff(LayOff { size, .. }) => vec![size],
        Entry::Compute(Compute { by, .. }) => by.iter().collect(),
        _ => Vec::new(),
    }
}
