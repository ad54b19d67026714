//! Judges a drawing: each operation by itself, with right inputs, in the scene and in others like it.

use super::cause::{Cause, Causes};
use super::file::{Compute, Cross, Entry, HandDrawing, LayOff, Line, Mark, Measure};
use super::formula::Formula;
use super::given::{Given, usual};
use super::others::others;
use super::reads::reads;
use super::says;
use super::table::{DrawnLine, Made, Table};
use crate::check::{AnswerKey, Told};
use crate::construction::Tolerance;
use crate::geometry::{Vector, unit};
use crate::message::Message;
use crate::scene::{Head, QuantityName};
use crate::sheet::{PerSheet, Sheet};
use std::collections::{BTreeMap, BTreeSet};

/// What is found of an entry.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Verdict {
    /// It is right.
    Right,
    /// It is wrong by itself.
    Wrong(Wrong),
    /// It is right by itself, but hangs on something that is wrong.
    Follows,
    /// Nothing uses it, and its name means nothing.
    Unused,
    /// It was taken back, or takes back.
    Undone,
}

/// What is wrong with an entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// What is to be seen: `c` does not lie on this line.
    pub what: Message,
    /// What was probably done, and what should be, where the catalogue of mistakes has it.
    pub mistake: Option<Told>,
}

/// A judged drawing.
#[derive(Clone, Debug)]
pub struct JudgedDrawing {
    /// By entry.
    pub verdicts: Vec<Verdict>,
}

impl JudgedDrawing {
    /// The index of the first entry that is wrong.
    #[must_use]
    pub fn first_wrong(&self) -> Option<usize> {
        self.verdicts.iter().position(|verdict| matches!(verdict, Verdict::Wrong(_)))
    }
}

/// Why a drawing cannot be carried out: at which entry, and what is wrong with it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("entry {}: {message}", entry + 1)]
pub struct BoardError {
    /// The index of the entry.
    pub entry: usize,
    /// What is wrong.
    pub message: Message,
}

/// A judge of drawings of one scene; may judge many.
#[derive(Debug)]
pub struct Judge {
    /// The scene.
    given: Given,
    /// Scenes like it.
    others: Vec<Given>,
    tolerance: Tolerance,
    /// The scales of the scene's figure, or such that the sheet is as large as a hand.
    scales: PerSheet<f64>,
}

/// Size of a plan in millimetres where neither drawing nor scene has a scale for it.
const USUAL_SIZE: f64 = 150.0;

/// How many times the tolerance a free hand may be off.
const FREE: f64 = 3.0;

/// What two numbers that are the same may differ by, in parts.
const SAME: f64 = 1e-6;

/// Most numbers of a formula whose signs are tried: in another scene a segment may run the other way.
const MOST_SIGNS: usize = 6;

impl Judge {
    /// A judge for the scene of an answer key.
    #[must_use]
    pub fn new(key: &AnswerKey<'_>) -> Judge {
        let given = Given::new(key.solution);
        let others = others(&given);
        let fitting = |sheet| if given.size(sheet) > 0.0 { given.size(sheet) / USUAL_SIZE } else { 1.0 };
        let scales = PerSheet::from_fn(|sheet| key.scales[sheet].unwrap_or_else(|| fitting(sheet)));
        Judge { given, others, tolerance: key.tolerance, scales }
    }

    /// What the scene gives and means.
    #[must_use]
    pub fn given(&self) -> &Given {
        &self.given
    }

    /// The scenes like it.
    pub(super) fn others(&self) -> &[Given] {
        &self.others
    }

    /// The scales of sheets of which a drawing says nothing.
    pub(super) fn usual_scales(&self) -> PerSheet<f64> {
        self.scales
    }

    /// The scales of a drawing's sheets, in units of the scene per millimetre.
    #[must_use]
    pub fn scales(&self, drawing: &HandDrawing) -> PerSheet<f64> {
        let stated = |sheet: Sheet| drawing.mu[sheet].filter(|mu| mu.is_finite() && *mu > 0.0);
        PerSheet::from_fn(|sheet| stated(sheet).unwrap_or(self.scales[sheet]))
    }

    /// The sheets as the hand drew them, up to the first entry that cannot be carried out.
    #[must_use]
    pub fn drawn(&self, drawing: &HandDrawing) -> (Table<'_>, Option<BoardError>) {
        let mut table = Table::new(&self.given, self.scales(drawing));
        for (entry, act) in standing(drawing) {
            match table.carry_out_by_hand(act) {
                Ok(made) => table.put(made),
                Err(message) => return (table, Some(BoardError { entry, message })),
            }
        }
        (table, None)
    }

    /// The verdicts on a drawing's entries.
    ///
    /// # Errors
    /// The first entry that cannot be carried out.
    pub fn judge(&self, drawing: &HandDrawing) -> Result<JudgedDrawing, BoardError> {
        Bench::new(self, drawing).judged(drawing)
    }
}

/// The entries that stand, with their indices.
fn standing(drawing: &HandDrawing) -> impl Iterator<Item = (usize, &Entry)> {
    let stands = drawing.standing();
    drawing.did.iter().enumerate().filter(move |(index, _)| stands[*index])
}

/// A drawing while it is judged.
struct Bench<'j> {
    judge: &'j Judge,
    /// The hand's own things.
    own: Table<'j>,
    /// The right things: in the scene, then in the others.
    right: Vec<Table<'j>>,
    /// By line: the points at whose crossings it is used, in order.
    targets: BTreeMap<String, Vec<String>>,
    /// Names of points and numbers of the hand's own that are not known to be right, with the entries that made them.
    unsure: BTreeMap<Thing, usize>,
    /// Names that hang on something wrong.
    tainted: BTreeSet<Thing>,
    causes: Causes<'j>,
}

/// A thing by its sheet, where it has one, and its name.
pub(super) type Thing = (Option<Sheet>, String);

/// What an entry comes to when it is carried out with right inputs.
enum Found {
    Right,
    /// What is wrong.
    Wrong(Message),
    /// It has a name of its own, and is neither.
    Own,
}

impl<'j> Bench<'j> {
    fn new(judge: &'j Judge, drawing: &HandDrawing) -> Bench<'j> {
        let scales = judge.scales(drawing);
        let all = std::iter::once(&judge.given).chain(&judge.others);
        let mut targets: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (_, entry) in standing(drawing) {
            if let Entry::Cross(Cross { cross, of, .. }) = entry {
                of.iter().for_each(|line| targets.entry(line.clone()).or_default().push(cross.clone()));
            }
        }
        Bench {
            judge,
            own: Table::new(&judge.given, scales),
            right: all.map(|given| Table::new(given, scales)).collect(),
            targets,
            unsure: BTreeMap::new(),
            tainted: BTreeSet::new(),
            causes: Causes::new(judge),
        }
    }

    fn judged(mut self, drawing: &HandDrawing) -> Result<JudgedDrawing, BoardError> {
        let mut verdicts = vec![Verdict::Undone; drawing.did.len()];
        let used = used(drawing, &self.own)?;
        for (index, entry) in standing(drawing) {
            let refused = |message| BoardError { entry: index, message };
            let made = self.own.carry_out_by_hand(entry).map_err(refused)?;
            let reads = reads(entry, &self.own);
            let found = self.found(entry, &made);
            let things = things(&made);
            verdicts[index] = match found {
                Found::Own if !things.iter().any(|thing| used.contains(thing)) => Verdict::Unused,
                Found::Right | Found::Own if reads.iter().any(|read| self.tainted.contains(read)) => Verdict::Follows,
                Found::Right | Found::Own => Verdict::Right,
                Found::Wrong(what) => self.blamed(index, entry, &made, &reads, what, &mut verdicts),
            };
            if matches!(verdicts[index], Verdict::Wrong(_) | Verdict::Follows) {
                self.tainted.extend(things.iter().cloned());
            }
            self.put_right(index, entry, &made, &reads, &verdicts[index]);
            self.own.put(made);
        }
        Ok(JudgedDrawing { verdicts })
    }

    /// The verdict on a wrong entry: it is wrong itself, or follows from something of the hand's own that nothing else has judged.
    fn blamed(
        &mut self,
        index: usize,
        entry: &Entry,
        made: &Made,
        reads: &[Thing],
        what: Message,
        verdicts: &mut [Verdict],
    ) -> Verdict {
        let mistake = self.causes.of(entry, made, &self.right);
        let unsure = reads.iter().filter_map(|read| self.unsure.get(read)).min().copied();
        match unsure {
            Some(earlier) if mistake.is_none() && self.is_of_number(entry, made) && earlier < index => {
                let name = things(made).into_iter().next().map_or_else(String::new, |(_, name)| name);
                verdicts[earlier] = Verdict::Wrong(Wrong { what: says::leads_wrong(name), mistake: None });
                Verdict::Follows
            }
            _ => Verdict::Wrong(Wrong { what, mistake: mistake.map(|Cause { told, .. }| told) }),
        }
    }

    /// Whether what is wrong may come from a number that was read: not where a vector has a wrong direction.
    fn is_of_number(&self, entry: &Entry, made: &Made) -> bool {
        let (Entry::LayOff(LayOff { from, .. }), Made::Place(sheet, name, _)) = (entry, made) else {
            return !matches!(entry, Entry::Line(_) | Entry::Join(_));
        };
        let right = &self.right[0];
        let ends = self.judge.given.place(*sheet, name).zip(right.place(*sheet, from));
        let Ok(Made::Place(_, _, end)) = right.carry_out(entry) else { return true };
        let directions = ends.and_then(|(end_right, start)| Some((unit(end_right - start)?, unit(end - start)?)));
        directions.is_none_or(|(a, b)| crate::geometry::cross(a, b).abs() < 1e-6)
    }

    /// What an entry comes to with right inputs.
    fn found(&self, entry: &Entry, made: &Made) -> Found {
        match (entry, made) {
            (Entry::Line(line), Made::Line(name, _)) => self.found_line(line, name),
            (Entry::Join(_), Made::Line(name, _)) => match self.holds(entry, name) {
                // Two points that are there are joined rightly, whatever for.
                Held::Nothing => Found::Own,
                Held::All => Found::Right,
                Held::Not(point) => Found::Wrong(says::line_misses(point)),
            },
            (Entry::Mark(Mark { .. }), Made::Place(sheet, name, at)) => match self.judge.given.place(*sheet, name) {
                None => Found::Own,
                Some(_) => self.near_expected(*sheet, name, *at),
            },
            (_, Made::Place(sheet, name, at)) => self.found_place(entry, *sheet, name, *at),
            (_, Made::Numbers(_)) => self.found_numbers(entry, made),
            _ => Found::Own,
        }
    }

    fn found_line(&self, line: &Line, name: &str) -> Found {
        let meant = self.meant(line);
        let mut missed = None;
        for one in &meant {
            match self.holds(one, name) {
                Held::Nothing => return Found::Own,
                Held::All => match self.off_hand(one, line) {
                    None => return Found::Right,
                    Some(off) => missed = Some(off),
                },
                Held::Not(point) => missed = missed.or_else(|| Some(says::line_misses(point))),
            }
        }
        match (missed, self.targets.get(name)) {
            (Some(missed), _) => Found::Wrong(missed),
            (None, Some(targets)) => Found::Wrong(says::line_misses(targets[0].as_str())),
            (None, None) => Found::Own,
        }
    }

    /// What a line may mean: what stands in its entry, or all points and directions that its place allows.
    fn meant(&self, line: &Line) -> Vec<Entry> {
        let Some(drawn) = line.drawn.filter(|_| line.through.is_none() || line.along.is_none()) else {
            return vec![Entry::Line(Line { drawn: None, ..line.clone() })];
        };
        let Some(sheet) = line.on else { return Vec::new() };
        let Ok(Made::Line(_, there)) = self.own.carry_out(&Entry::Line(line.clone())) else { return Vec::new() };
        let reach = FREE * self.judge.tolerance.mm * self.own.scale(sheet);
        let through = |name: &str| line.through.as_deref().is_none_or(|stated| stated == name);
        let points: Vec<String> = self
            .own
            .places(sheet)
            .filter(|(name, place)| through(name) && there.distance(*place).abs() <= reach)
            .map(|(name, _)| name.to_owned())
            .collect();
        let mut meant = Vec::new();
        for along in line.along.iter().cloned().chain(self.directions().into_iter().filter(|_| line.along.is_none())) {
            let Ok(direction) = self.own.direction(sheet, &along) else { continue };
            let [_, turn] = self.own.off(&DrawnLine { sheet, at: there.at, along: direction }, &drawn);
            if turn > FREE * self.judge.tolerance.degrees {
                continue;
            }
            meant.extend(points.iter().map(|point| {
                let (through, along) = (Some(point.clone()), Some(along.clone()));
                Entry::Line(Line { through, along, drawn: None, on: Some(sheet), line: line.line.clone() })
            }));
        }
        meant
    }

    /// The directions that a mechanism offers to a set square: along and across its links, guides and lines of the scheme.
    fn directions(&self) -> Vec<super::file::Direction> {
        use super::file::Direction::{Normal, Parallel};
        let mechanism = self.judge.given.mechanism();
        let mut names: Vec<String> = mechanism.slider_ids().map(|id| mechanism.slider_name(id)).collect();
        let special: Vec<&str> = self.own.places(Sheet::Scheme).map(|(name, _)| name).collect();
        for (id, body) in mechanism.links() {
            let mut points: Vec<&str> = body.points.iter().map(|p| mechanism.point_name(*p)).collect();
            let construction = self.judge.given.construction();
            points.extend(
                construction
                    .special
                    .iter()
                    .filter(|s| s.link == id)
                    .map(|s| s.name.as_str())
                    .filter(|s| special.contains(s)),
            );
            for (at, a) in points.iter().enumerate() {
                names.extend(points[at + 1..].iter().map(|b| format!("{a},{b}")));
            }
        }
        names.extend(self.own.lines().filter(|(_, line)| line.sheet == Sheet::Scheme).map(|(name, _)| name.to_owned()));
        let both = |name: String| [Parallel { parallel: name.clone() }, Normal { normal: name }];
        names.into_iter().flat_map(both).collect()
    }

    /// How far a free hand is from what it meant, where that is too far.
    fn off_hand(&self, meant: &Entry, line: &Line) -> Option<Message> {
        let drawn = line.drawn?;
        let Ok(Made::Line(_, meant)) = self.own.carry_out(meant) else { return None };
        let [mm, degrees] = self.own.off(&meant, &drawn);
        let limit = &self.judge.tolerance;
        let is_off = mm > FREE * limit.mm || degrees > FREE * limit.degrees;
        is_off.then(|| says::drawn_off(rounded(mm), rounded(degrees)))
    }

    /// Whether a line goes through the points at whose crossings it is used.
    fn holds(&self, entry: &Entry, name: &str) -> Held {
        let Some(targets) = self.targets.get(name) else { return Held::Nothing };
        let mut first = None;
        for target in targets {
            let mut has_meaning = false;
            let held = self.right.iter().enumerate().all(|(scene, table)| {
                let Ok(Made::Line(_, line)) = table.carry_out(entry) else { return scene > 0 };
                let Some(place) = table.given.place(line.sheet, target) else { return true };
                has_meaning = true;
                line.distance(place).abs() <= SAME * table.given.size(line.sheet)
            });
            match (has_meaning, held) {
                (true, true) => return Held::All,
                (true, false) => first = first.or(Some(target.clone())),
                (false, _) => {}
            }
        }
        first.map_or(Held::Nothing, Held::Not)
    }

    fn found_place(&self, entry: &Entry, sheet: Sheet, name: &str, own: Vector) -> Found {
        if self.judge.given.place(sheet, name).is_none() {
            return if self.is_known_vector(entry, sheet) { Found::Right } else { Found::Own };
        }
        if typed_size(entry) {
            return self.near_expected(sheet, name, own);
        }
        let is_right = self.in_all(entry, |table, made| match (made, table.given.place(sheet, name)) {
            (Made::Place(_, _, at), Some(right)) => (at - right).norm() <= SAME * table.given.size(sheet),
            _ => false,
        });
        if !is_right {
            return Found::Wrong(match entry {
                Entry::Cross(_) => says::lines_of_others(name),
                _ => says::point_elsewhere(name),
            });
        }
        match self.place_off_hand(entry, sheet, own) {
            Some(off) => Found::Wrong(off),
            None => Found::Right,
        }
    }

    /// How far a free hand is from what it meant, where that is too far.
    fn place_off_hand(&self, entry: &Entry, sheet: Sheet, own: Vector) -> Option<Message> {
        let is_free =
            matches!(entry, Entry::Cross(Cross { drawn: Some(_), .. }) | Entry::LayOff(LayOff { drawn: Some(_), .. }));
        let Ok(Made::Place(_, _, meant)) = self.own.carry_out(entry) else { return None };
        let mm = (own - meant).norm() / self.own.scale(sheet);
        // Along x and y each, and a direction's error over the length.
        let reach = match entry {
            Entry::LayOff(LayOff { from, .. }) => self.own.place(sheet, from).map_or(0.0, |from| (meant - from).norm()),
            _ => 0.0,
        };
        let turn = reach / self.own.scale(sheet) * self.judge.tolerance.degrees.to_radians();
        let limit = FREE * (std::f64::consts::SQRT_2 * self.judge.tolerance.mm + turn);
        (is_free && mm > limit).then(|| says::point_off(rounded(mm)))
    }

    /// Whether a vector that leads to a point of the hand's own is one that the plan may show.
    fn is_known_vector(&self, entry: &Entry, sheet: Sheet) -> bool {
        let Entry::LayOff(LayOff { from, .. }) = entry else { return false };
        self.in_all(entry, |table, made| {
            let (Made::Place(_, _, end), Some(start)) = (made, table.place(sheet, from)) else { return false };
            let small = SAME * table.given.size(sheet);
            table.given.vectors(sheet).iter().any(|known| (end - start - known).norm() <= small)
        })
    }

    /// Whether what an entry makes is right in the scene and in the others; in others the numbers of a formula may have changed their signs.
    fn in_all(&self, entry: &Entry, is_right: impl Fn(&Table<'_>, &Made) -> bool) -> bool {
        self.right.iter().enumerate().all(|(scene, table)| {
            let right = |table: &Table<'_>| match table.carry_out(entry) {
                Ok(made) => is_right(table, &made),
                // What degenerates elsewhere says nothing.
                Err(_) => scene > 0,
            };
            if right(table) {
                return true;
            }
            scene > 0 && any_signs(table, &formulas(entry), || right(table))
        })
    }

    fn found_numbers(&self, entry: &Entry, made: &Made) -> Found {
        if let Entry::Solve(solve) = entry {
            return self.found_equations(solve);
        }
        let Made::Numbers(all) = made else { return Found::Own };
        let Some((name, own)) = all.first() else { return Found::Own };
        let Some(asked) = self.meaning(entry, name) else {
            return if self.is_known_number(entry) { Found::Right } else { Found::Own };
        };
        if matches!(entry, Entry::Compute(Compute { by: None, .. })) {
            return self.near_expected_number(&asked, *own);
        }
        let stated = matches!(entry, Entry::Compute(Compute { sense: Some(_), .. }));
        let is_right = self.in_all(entry, |table, made| match (made, table.given.number(&asked)) {
            (Made::Numbers(all), Some(right)) => all.iter().all(|(_, found)| {
                let is_size = !stated && *found >= 0.0;
                same(*found, right) || (is_size && same(*found, right.abs()))
            }),
            _ => false,
        });
        // In other scenes a link may turn the other way, which the stated sense does not know.
        let is_right = is_right
            || (stated
                && self.in_all(entry, |table, made| match (made, table.given.number(&asked)) {
                    (Made::Numbers(all), Some(right)) => all.iter().all(|(_, found)| {
                        let is_scene = std::ptr::eq(table.given, &self.judge.given);
                        same(*found, right) || (!is_scene && same(found.abs(), right.abs()))
                    }),
                    _ => false,
                }));
        if !is_right {
            return Found::Wrong(says::number_wrong(name));
        }
        match entry {
            Entry::Measure(Measure { read: Some(read), .. }) => self.misread(entry, *read),
            _ => Found::Right,
        }
    }

    /// A length that was read otherwise than it was drawn.
    fn misread(&self, entry: &Entry, read: f64) -> Found {
        let Entry::Measure(Measure { measure, on, from, .. }) = entry else { return Found::Right };
        let Ok(Made::Numbers(all)) = self.own.carry_out(entry) else { return Found::Right };
        let sheet = on.or_else(|| {
            let mut having = Sheet::ALL.into_iter().filter(|sheet| self.own.place(*sheet, from).is_some());
            having.next()
        });
        let scale = sheet.map_or(1.0, |sheet| self.own.scale(sheet));
        let off = all.first().map_or(0.0, |(_, drawn)| (drawn - read).abs() / scale);
        match off > FREE * self.judge.tolerance.mm + 0.5 {
            true => Found::Wrong(says::misread(measure, rounded(off))),
            false => Found::Right,
        }
    }

    /// The quantity that a number's name means: itself, or of two points written together the segment between them.
    fn meaning(&self, entry: &Entry, name: &str) -> Option<String> {
        if self.judge.given.number(name).is_some() {
            return Some(name.to_owned());
        }
        let Entry::Measure(Measure { on, from, to, .. }) = entry else { return None };
        let sheet = on.or_else(|| {
            let has = |sheet: &Sheet| self.own.place(*sheet, from).is_some() && self.own.place(*sheet, to).is_some();
            Sheet::ALL.into_iter().find(has)
        })?;
        let names: Vec<&str> = self.judge.given.places(sheet).map(|(name, _)| name).collect();
        let split = names.iter().find_map(|first| {
            let second = name.strip_prefix(first)?;
            names.contains(&second).then(|| sheet.segment_name(first, second))
        })?;
        // A name that can be taken apart in another way, too, says nothing.
        self.judge.given.number(&split)?;
        Some(split)
    }

    /// Whether a number of the hand's own is one that has a name: then it is right.
    fn is_known_number(&self, entry: &Entry) -> bool {
        // A measured distance is that of its points.
        matches!(entry, Entry::Measure(_)) || self.causes.is_known_number(entry, &self.right)
    }

    fn found_equations(&self, solve: &super::file::Solve) -> Found {
        let names: Vec<String> =
            solve.solve.iter().map(|name| name.chars().filter(|c| !c.is_whitespace()).collect()).collect();
        if names.iter().any(|name| self.judge.given.number(name).is_none()) {
            return Found::Own;
        }
        for equation in 0..solve.equations.len() {
            let is_right = self.right.iter().enumerate().all(|(scene, table)| {
                let unknowns: Option<Vec<f64>> = names.iter().map(|name| table.given.number(name)).collect();
                let Some(unknowns) = unknowns else { return false };
                let holds = || {
                    let remains = table.residuals(solve, &unknowns);
                    remains.is_ok_and(|remains| remains[equation].abs() <= SAME)
                };
                if holds() {
                    return true;
                }
                let sides = Formula::sides(&solve.equations[equation]);
                scene > 0 && sides.is_ok_and(|[left, right]| any_signs(table, &[&left, &right], holds))
            });
            if !is_right {
                return Found::Wrong(says::equation_wrong(equation + 1));
            }
        }
        Found::Right
    }

    /// Whether a point that was put down, or laid off with a number from elsewhere, is where the hand's own inputs lead, or where it is in
    /// the end, as far as a hand can tell.
    fn near_expected(&self, sheet: Sheet, name: &str, at: Vector) -> Found {
        let reach = self.causes.reach(sheet, name, self.own.scale(sheet), &self.judge.tolerance);
        let expected = self.causes.expected_place(&self.own, sheet, name);
        let right = self.judge.given.place(sheet, name);
        let near = |place: Vector| (at - place).norm() <= reach * self.own.scale(sheet);
        match expected.is_some_and(near) || right.is_some_and(near) {
            true => Found::Right,
            false => Found::Wrong(says::point_elsewhere(name)),
        }
    }

    /// The same of a typed number.
    fn near_expected_number(&self, name: &str, own: f64) -> Found {
        let expected = self.causes.expected_number(&self.own, name);
        let right = self.judge.given.number(name);
        let band = self.causes.band(name, &self.judge.tolerance);
        let near = |value: f64, band: f64| {
            let close = |value: f64| (own - value).abs() <= band;
            close(value) || (own >= 0.0 && close(value.abs()))
        };
        let typed = |value: f64| near(value, TYPED * value.abs());
        match expected.is_some_and(typed) || right.is_some_and(|right| typed(right) || near(right, band)) {
            true => Found::Right,
            false => Found::Wrong(says::number_wrong(name)),
        }
    }

    /// Puts the right things down in all scenes.
    fn put_right(&mut self, index: usize, entry: &Entry, made: &Made, reads: &[Thing], verdict: &Verdict) {
        let is_wrong = matches!(verdict, Verdict::Wrong(_));
        // In the scene itself a size without a sense, or one that counts the other sense as positive, keeps its sign.
        let turned = self.is_turned(entry);
        let mut entry = entry.clone();
        if let Some(meant) = self.right_meaning(&entry) {
            entry = meant;
        }
        let mut unsure = false;
        for table in &mut self.right {
            let alone = table.carry_out(&entry).unwrap_or_else(|_| made.clone());
            let right = match alone {
                Made::Place(sheet, name, at) => {
                    let right = table.given.place(sheet, &name);
                    unsure |= right.is_none();
                    Made::Place(sheet, name, right.unwrap_or(at))
                }
                Made::Line(name, line) if is_wrong => {
                    let targets = self.targets.get(&name).into_iter().flatten();
                    let target = targets.filter_map(|target| table.given.place(line.sheet, target)).next();
                    let along = target.and_then(|target| unit(target - line.at)).unwrap_or(line.along);
                    Made::Line(name, DrawnLine { along, ..line })
                }
                Made::Numbers(all) => Made::Numbers(
                    all.into_iter()
                        .map(|(name, number)| {
                            let right = table.given.number(&name).or_else(|| concatenated(table.given, &entry, &name));
                            unsure |= right.is_none();
                            let right = right.map(|right| if turned { -right } else { right });
                            (name, right.unwrap_or(number))
                        })
                        .collect(),
                ),
                line => line,
            };
            table.put(right);
        }
        if unsure && !self.is_sure(&entry, made) {
            // The first of a chain is to blame.
            let first = reads.iter().filter_map(|read| self.unsure.get(read)).min().copied().unwrap_or(index);
            self.unsure.extend(things(made).into_iter().map(|thing| (thing, first)));
        }
    }

    fn is_sure(&self, entry: &Entry, made: &Made) -> bool {
        match made {
            Made::Place(sheet, ..) => self.is_known_vector(entry, *sheet),
            Made::Numbers(_) => self.is_known_number(entry),
            Made::Line(..) => true,
        }
    }

    /// Of what a free line may mean, what is right.
    fn right_meaning(&self, entry: &Entry) -> Option<Entry> {
        let Entry::Line(line) = entry else { return None };
        let meant = self.meant(line);
        let first = meant.iter().find(|one| matches!(self.holds(one, &line.line), Held::All)).or(meant.first());
        first.cloned()
    }

    /// Whether a number is right but for its sign in the scene itself, which the entry does not state.
    fn is_turned(&self, entry: &Entry) -> bool {
        let Entry::Compute(Compute { compute, sense: None, by, value }) = entry else { return false };
        let Some(right) = self.judge.given.number(compute) else { return false };
        let found = match (by, value) {
            (Some(_), _) => match self.right[0].carry_out(entry) {
                Ok(Made::Numbers(all)) => all.first().map_or(0.0, |(_, number)| *number),
                _ => 0.0,
            },
            (None, value) => value.unwrap_or(0.0),
        };
        found > 0.0 && right < 0.0
    }
}

/// Whether a line goes through the points for which it is used.
enum Held {
    /// It does.
    All,
    /// It misses this one.
    Not(String),
    /// It is used for no point that has a meaning.
    Nothing,
}

/// What a typed number may be off by, in parts: it has three digits or more.
const TYPED: f64 = 0.012;

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs()).max(f64::MIN_POSITIVE) || (a.abs() < 1e-9 && b.abs() < 1e-9)
}

/// A number of millimetres or degrees, to a tenth.
fn rounded(x: f64) -> String {
    format!("{x:.1}")
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

/// The value of a measured segment whose name is that of its ends written together.
fn concatenated(given: &Given, entry: &Entry, name: &str) -> Option<f64> {
    let Entry::Measure(Measure { on, from, to, .. }) = entry else { return None };
    if *name != format!("{from}{to}") {
        return None;
    }
    let has = |sheet: &Sheet| given.place(*sheet, from).is_some() && given.place(*sheet, to).is_some();
    let sheet = on.or_else(|| Sheet::ALL.into_iter().find(has))?;
    Some((given.place(sheet, to)? - given.place(sheet, from)?).norm())
}

/// Whether a vector is laid off with a number that nothing in the drawing gives.
fn typed_size(entry: &Entry) -> bool {
    matches!(entry, Entry::LayOff(LayOff { size, .. }) if size.names().is_empty())
}

/// The things that are made.
pub(super) fn things(made: &Made) -> Vec<Thing> {
    match made {
        Made::Place(sheet, name, _) => vec![(Some(*sheet), usual(*sheet, name).to_owned())],
        Made::Line(name, _) => vec![(None, name.clone())],
        Made::Numbers(all) => all.iter().map(|(name, _)| (None, name.clone())).collect(),
    }
}

/// All things that entries read.
fn used(drawing: &HandDrawing, empty: &Table<'_>) -> Result<BTreeSet<Thing>, BoardError> {
    let (mut table, mut used) = (empty.clone(), BTreeSet::new());
    for (entry, act) in standing(drawing) {
        let made = table.carry_out_by_hand(act).map_err(|message| BoardError { entry, message })?;
        used.extend(reads(act, &table));
        table.put(made);
    }
    Ok(used)
}

/// The names of lengths and segments in a name.
pub(super) fn segment_of(name: &str) -> Option<(Sheet, [String; 2])> {
    let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
    match (name.head, name.arguments.as_slice()) {
        (Head::Between(sheet), [from, to]) => Some((sheet, [from.clone(), to.clone()])),
        _ => None,
    }
}
