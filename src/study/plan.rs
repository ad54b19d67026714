//! A study of its scene: which numbers vary and how, and the rows of its table.

use super::file::{StudyFile, USUAL_SEED};
use super::member::{StudyError, every_pose, follow_alone, has_links, member, posed};
use super::task::{Column, Content, DriveRange, Outcome, Task, Wanted};
use super::together::{follow, suits};
use super::vary::{Named, Values, Varied, numbers};
use crate::Problem;
use crate::cores::on_all_cores;
use crate::cycle::{Assemblies, CycleError, Drive, Steps, Variants, alone as alone_moving};
use crate::geometry::MANY;
use crate::mechanism::{Mechanism, mechanism, renumber};
use crate::position::rough_places;
use crate::quantity::{QuantityKind, QuantityRequest};
use crate::scene::{GivenBy, Scene, close, list};
use std::ops::Range;

/// Most rows of a study.
const MOST: u64 = 1_000_000_000;

/// Rows that a core computes at a time.
const CHUNK: u64 = 4 * MANY as u64;

/// Most positions of a cycle.
const MOST_STEPS: usize = 100_000;

/// Many mechanisms that differ from one scene in some numbers, and what is asked of each.
#[derive(Clone, Debug)]
pub struct Study {
    scene: Scene,
    varied: Vec<Varied>,
    /// Rows at each point of the grid.
    shots: u64,
    seed: u64,
    rows: u64,
    task: Task,
    /// The scene's mechanism with all of its assemblies, from which those of others can be found; `None` where they are found for each by
    /// itself.
    like: Option<(Mechanism, Assemblies)>,
}

/// What the rows of a study take turns to use.
struct Bench {
    /// The study's scene with the numbers of a row.
    scene: Scene,
    /// Mechanisms of a block of rows: the next block gives them other numbers.
    mechanisms: Vec<Mechanism>,
}

impl StudyFile {
    /// The study of this scene.
    ///
    /// # Errors
    /// It asks for what the scene does not have, with its place in the study; or the scene cannot be moved.
    pub fn of(&self, scene: Scene) -> Result<Study, StudyError> {
        if scene.given_by == GivenBy::Drawing {
            return Err(CycleError::Drawn.into());
        }
        let (mechanism, _) = posed(&scene)?;
        let range = drive_range(self, &mechanism)?;
        let varied = varied(self, &scene, &range)?;
        let is_random = varied.iter().any(|v| !matches!(v.values, Values::Grid { .. }));
        let shots = match (self.keys.count, is_random) {
            (None, false) => 1,
            (Some(0), _) => return self.refuse(&["count"], "a study has at least one row", None),
            (Some(count), true) => count,
            (None, true) => {
                let hint = r#"add "count": 1000, so many at each point of the grid"#;
                return self.refuse(&["vary"], "numbers vary at random, and nothing says how often", Some(hint));
            }
            (Some(_), false) => {
                let hint = "leave it out: each point of the grid has one row";
                return self.refuse(&["count"], "nothing varies at random", Some(hint));
            }
        };
        let rows = varied.iter().try_fold(shots, |rows, v| rows.checked_mul(v.values.points()));
        let Some(rows) = rows.filter(|rows| *rows <= MOST) else {
            return self.refuse(&["vary"], format!("these are more than {MOST} mechanisms"), None);
        };
        let mut wanted = Vec::new();
        for (name, figures) in &self.keys.want {
            let asked = QuantityRequest::new(name, &mechanism)
                .map_err(|error| refused(self, &["want", name], &error.problem()))?;
            if asked.written.on_paper {
                return self.refuse(&["want", name], "a study has no paper", Some("the name without `/mu`"));
            }
            let in_scene = || posed(&scene).ok().map(|(_, pose)| pose);
            // Each mechanism has its own polygons; the scene has these corners, at least.
            let known = asked.check_size().and_then(|()| asked.clone().for_many(&mechanism, in_scene));
            known.map_err(|error| refused(self, &["want", name], &error.problem()))?;
            wanted.push(Wanted { name: name.clone(), asked, figures: figures.clone() });
        }
        let task = Task { range, wanted, errors: self.keys.bounds, at_steps: self.keys.at_steps };
        let like = if suits(&task) { with_assemblies(&scene) } else { None };
        Ok(Study { scene, varied, shots, seed: self.keys.seed.unwrap_or(USUAL_SEED), rows, task, like })
    }
}

/// The mechanism of a scene with all of its assemblies, where they give those of others.
fn with_assemblies(scene: &Scene) -> Option<(Mechanism, Assemblies)> {
    let mechanism = mechanism(scene).ok()?;
    let (poses, rough) = (every_pose(&mechanism, scene)?, rough_places(&mechanism, &scene.near)?);
    let assemblies = Assemblies::new(&mechanism, poses, rough)?;
    Some((mechanism, assemblies))
}

impl Study {
    /// How many rows it has.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.rows
    }

    /// The columns of its table.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        let column = |name: &str, content, unit: String| Column { name: name.to_owned(), content, unit };
        let number = |name: &str, unit: &str| column(name, Content::Number, unit.to_owned());
        let units = self.scene.units;
        let drive =
            if self.task.range.drive.is_angle { QuantityKind::Angle } else { QuantityKind::Position }.unit(units);
        let mut columns = vec![column("index", Content::Index, String::new())];
        columns.extend(self.varied.iter().map(|v| number(&v.name, &v.number.unit(units))));
        columns.push(column("status", Content::Status, String::new()));
        columns.extend(["reach_from", "reach_to"].map(|name| number(name, &drive)));
        for wanted in &self.task.wanted {
            for figure in &wanted.figures {
                let name = format!("{}.{}", wanted.name, figure.name());
                columns.push(number(&name, &wanted.asked.kind().unit(units)));
                if figure.has_place() {
                    columns.push(number(&format!("{name}_at"), &drive));
                }
                if self.task.errors && figure.has_error() {
                    columns.push(number(&format!("{name}_error"), &wanted.asked.kind().unit(units)));
                }
            }
        }
        columns
    }

    /// The numbers of these rows, one row after the other, as [`Self::columns`] says; NaN where there is none.
    #[must_use]
    pub fn rows(&self, rows: Range<u64>) -> Vec<f64> {
        let (width, many) = (self.columns().len(), MANY as u64);
        let mut numbers = Vec::new();
        let mut bench = Bench { scene: self.scene.clone(), mechanisms: Vec::new() };
        for first in (rows.start / many * many..rows.end).step_by(MANY) {
            // Last digits depend on the mechanisms that are followed together, so a block is always computed whole.
            let last = self.rows.min(first + many);
            let mut block = Vec::with_capacity(MANY * width);
            self.block(first..last, &mut bench, &mut block);
            let [from, to] = [rows.start.max(first), rows.end.min(last)].map(|row| (row - first) as usize * width);
            numbers.extend_from_slice(&block[from..to]);
        }
        numbers
    }

    /// The numbers of these rows as [`Self::rows`] gives them, computed on all cores.
    #[must_use]
    pub fn rows_on_all_cores(&self, rows: Range<u64>) -> Vec<f64> {
        let chunk = |at: u64| rows.start.max(at * CHUNK)..rows.end.min((at + 1) * CHUNK);
        let chunks: Vec<Range<u64>> = (rows.start / CHUNK..rows.end.div_ceil(CHUNK)).map(chunk).collect();
        on_all_cores(&chunks, |chunk| self.rows(chunk.clone())).concat()
    }

    /// Appends rows of mechanisms that are followed side by side where that is sure, else each by itself.
    fn block(&self, rows: Range<u64>, bench: &mut Bench, numbers: &mut Vec<f64>) {
        let varied: Vec<Vec<f64>> = rows.clone().map(|row| self.values(row)).collect();
        let together = self.together(bench, &varied);
        for ((row, values), outcome) in rows.zip(varied).zip(together) {
            let outcome = outcome.unwrap_or_else(|| {
                self.set(&mut bench.scene, &values);
                self.alone(&bench.scene)
            });
            numbers.push(row as f64);
            numbers.extend(values);
            numbers.push(outcome.status as u8 as f64);
            numbers.extend(outcome.reach.unwrap_or([f64::NAN; 2]));
            for (wanted, summary) in self.task.wanted.iter().zip(&outcome.summaries) {
                for figure in &wanted.figures {
                    let (value, at) = summary.figure(*figure);
                    numbers.push(value.unwrap_or(f64::NAN));
                    if figure.has_place() {
                        numbers.push(at.unwrap_or(f64::NAN));
                    }
                    if self.task.errors && figure.has_error() {
                        numbers.push(summary.error(*figure).unwrap_or(f64::NAN));
                    }
                }
            }
        }
    }

    /// Gives a scene the numbers of a row.
    fn set(&self, scene: &mut Scene, values: &[f64]) {
        for (varied, value) in self.varied.iter().zip(values) {
            varied.number.set(scene, *value);
        }
    }

    /// What becomes of a mechanism that is followed by itself.
    fn alone(&self, scene: &Scene) -> Outcome {
        match member(scene) {
            Ok((mechanism, pose)) => {
                let bounded = self.task.errors.then_some(scene);
                follow_alone(&self.task, bounded, &self.moving(mechanism), &pose)
            }
            Err(status) => Outcome::without_motion(status, &self.task),
        }
    }

    /// The mechanism as the study moves it.
    fn moving(&self, mechanism: Mechanism) -> Mechanism {
        let range = &self.task.range;
        if range.alone { alone_moving(&mechanism, &range.drive.name) } else { mechanism }
    }

    /// What becomes of mechanisms that are followed side by side; `None` of those for which that is not sure.
    fn together(&self, bench: &mut Bench, varied: &[Vec<f64>]) -> Vec<Option<Outcome>> {
        if !suits(&self.task) {
            return vec![None; varied.len()];
        }
        self.assembled_together(bench, varied).unwrap_or_else(|| self.assembled_alone(&mut bench.scene, varied))
    }

    /// As [`Self::together`], with the mechanisms assembled side by side, too, which takes a small part of the time; `None` where that
    /// cannot be.
    fn assembled_together(&self, bench: &mut Bench, varied: &[Vec<f64>]) -> Option<Vec<Option<Outcome>>> {
        let (like, assemblies) = self.like.as_ref()?;
        let Bench { scene, mechanisms } = bench;
        mechanisms.resize_with(mechanisms.len().max(varied.len()), || like.clone());
        let mut rows = Vec::new();
        for (row, values) in varied.iter().enumerate() {
            self.set(scene, values);
            if !has_links(scene) {
                continue;
            }
            let mechanism = &mut mechanisms[rows.len()];
            renumber(mechanism, scene)?;
            if self.task.range.alone {
                *mechanism = self.moving(std::mem::take(mechanism));
            }
            rows.push(row);
        }
        let mut outcomes = vec![None; varied.len()];
        if rows.is_empty() {
            return Some(outcomes);
        }
        let (variants, is_nearest) = assemblies.nearest(&mechanisms[..rows.len()])?;
        for ((row, outcome), is_nearest) in rows.into_iter().zip(follow(&self.task, variants)).zip(is_nearest) {
            outcomes[row] = outcome.filter(|_| is_nearest);
        }
        Some(outcomes)
    }

    /// As [`Self::together`], with each mechanism assembled by itself.
    fn assembled_alone(&self, scene: &mut Scene, varied: &[Vec<f64>]) -> Vec<Option<Outcome>> {
        let mut outcomes = vec![None; varied.len()];
        let (mut rows, mut mechanisms, mut poses) = (Vec::new(), Vec::new(), Vec::new());
        for (row, values) in varied.iter().enumerate() {
            self.set(scene, values);
            match member(scene) {
                Ok((mechanism, pose)) => {
                    rows.push(row);
                    mechanisms.push(self.moving(mechanism));
                    poses.push(pose);
                }
                Err(status) => outcomes[row] = Some(Outcome::without_motion(status, &self.task)),
            }
        }
        if !mechanisms.is_empty()
            && let Ok(variants) = Variants::new(&mechanisms, &poses)
        {
            for (row, outcome) in rows.into_iter().zip(follow(&self.task, variants)) {
                outcomes[row] = outcome;
            }
        }
        outcomes
    }

    /// The varied numbers of a row.
    fn values(&self, row: u64) -> Vec<f64> {
        let mut point = row / self.shots;
        let mut values = vec![0.0; self.varied.len()];
        // The last number varies fastest.
        for (column, varied) in self.varied.iter().enumerate().rev() {
            let points = varied.values.points();
            values[column] = varied.values.value(point % points, [self.seed, row, column as u64]);
            point /= points;
        }
        values
    }
}

/// A problem at a place of the study.
fn refused(file: &StudyFile, path: &[&str], problem: &Problem) -> StudyError {
    file.error(path, problem.message.clone(), problem.hint.clone()).into()
}

/// The motion that the study asks for.
fn drive_range(file: &StudyFile, mechanism: &Mechanism) -> Result<DriveRange, StudyError> {
    let cycle = &file.keys.cycle;
    let path: &[&str] = if cycle.drive.is_some() { &["cycle", "drive"] } else { &["cycle"] };
    let drive = Drive::new(mechanism, cycle.drive.as_deref()).map_err(|error| refused(file, path, &error.problem()))?;
    let steps = Steps::new(cycle.from, cycle.to, cycle.step);
    let steps = steps.map_err(|error| refused(file, &["cycle", "step"], &error.problem()))?;
    if steps.count() < 3 || steps.count() > MOST_STEPS {
        let message = format!("a cycle has 3 to {MOST_STEPS} positions, and here are {}", steps.count());
        return file.refuse(&["cycle", "step"], message, None);
    }
    let (last, wide) = (steps.value(steps.count() - 1), cycle.to - cycle.from);
    if (last - cycle.to).abs() > 1e-9 * wide.abs() {
        let even = wide.abs() / ((wide / cycle.step).abs().round().max(1.0));
        let hint = format!("as {even}, which leads from {} to {}", cycle.from, cycle.to);
        let message = "no whole number of steps leads to the end of the cycle";
        return file.refuse(&["cycle", "step"], message, Some(&hint));
    }
    Ok(DriveRange {
        is_turn: drive.is_angle && wide.abs() == 360.0,
        drive,
        from: cycle.from,
        to: cycle.to,
        steps,
        alone: cycle.alone,
    })
}

/// The numbers that vary.
fn varied(file: &StudyFile, scene: &Scene, driven: &DriveRange) -> Result<Vec<Varied>, StudyError> {
    let known: Vec<Named> = numbers(scene);
    let mut all: Vec<Varied> = Vec::new();
    for (name, range) in &file.keys.vary {
        let path = ["vary", name.as_str()];
        let Some(found) = known.iter().find(|k| k.name == *name || k.path == *name) else {
            let names = known.iter().flat_map(|k| [k.name.as_str(), k.path.as_str()]);
            let hint = close(name, names)
                .unwrap_or_else(|| format!("what may vary: {}", list(known.iter().map(|k| k.name.as_str()))).into());
            let message = format!("`{}` is no number of the scene that may vary", crate::text::shown(name));
            return Err(file.error(&path, message, Some(hint)).into());
        };
        let moved = if driven.drive.is_angle { "angle" } else { "position" };
        if found.name == format!("{}.{moved}", driven.drive.name) {
            let hint = "leave it out of `vary`: `cycle` says where the drive goes";
            return file.refuse(&path, "this is the drive that moves", Some(hint));
        }
        if let Some(twin) = all.iter().find(|v| v.number == found.number) {
            let message = format!("this is the same number as `{}`", crate::text::shown(&twin.name));
            return file.refuse(&path, message, Some("keep one of them"));
        }
        let own = found.number.of(&mut scene.clone()).copied().unwrap_or_default();
        let values = Values::of(range, own).map_err(|message| {
            let hint = r#"write { "from": 80, "to": 120, "count": 9 }, { "from": 80, "to": 120 }, { "plus_minus": 0.5 } or { "sigma": 0.2 }"#;
            file.error(&path, message, Some(hint.into()))
        })?;
        all.push(Varied { name: name.clone(), number: found.number, values });
    }
    Ok(all)
}
