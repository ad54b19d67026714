//! Tries random variants of a scene until one is an exercise.

use super::even::evened;
use super::forces;
use super::judge::{Exercise, Refusal, key_page};
use super::says;
use super::vary::{OnGuide, length_step, varied};
use crate::check::form_names;
use crate::construction::Solution;
use crate::editing::measure::json as json_number;
use crate::geometry::Random;
use crate::message::Message;
use crate::quantity::Quantity;
use crate::scene::{ConstructionShown, Figure, Page, PageSize, figure_keys};
use crate::sheet::Sheet;
use crate::text::Untrusted;
use indexmap::IndexMap;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// What a form asks for, with its marks, as a scene says it.
fn marks_of(asked: &IndexMap<String, f64>) -> Value {
    asked.iter().map(|(name, marks)| (name.clone(), json_number(*marks))).collect::<Map<String, Value>>().into()
}

/// Most variants that are tried for each exercise; fewer of a mechanism with very many points and loads, each of which takes long.
const TRIES: usize = 1000;
const LEAST_TRIES: usize = 50;
/// So many points and loads of variants are looked at.
const POINTS: usize = 20_000;

/// Variants that are tried to find whether A4 sheets are large enough …
const PILOT: usize = 40;
/// … which they are if at least so many of them are exercises.
const FEW: usize = 6;

/// Why there is no exercise, or no further one.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}", self.message())]
#[non_exhaustive]
pub enum ExerciseError {
    /// The scene's plans cannot be constructed.
    NoConstruction,
    /// Its figure of instant centres shows permanent ones alone, which nobody has to find.
    NothingToFind,
    /// No variant was an exercise.
    GaveUp {
        /// How many were tried.
        tries: usize,
        /// The commonest reason of refusal.
        most: Refusal,
        /// Its share of the variants, in per cent.
        percent: usize,
        /// The symbols of the smallest and of the largest force of the scene as it stands, where these are too unequal.
        unequal: Option<[String; 2]>,
    },
}

impl ExerciseError {
    /// Refuses a figure of instant centres on which a hand finds nothing.
    ///
    /// # Errors
    /// It finds nothing.
    pub fn refuse_nothing(solution: &Solution) -> Result<(), ExerciseError> {
        let construction = &solution.construction;
        let is_nothing = construction.centers.is_some() && form_names(construction).is_empty();
        if is_nothing { Err(ExerciseError::NothingToFind) } else { Ok(()) }
    }

    /// What it says.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            ExerciseError::NoConstruction => says::no_construction(),
            ExerciseError::NothingToFind => says::nothing_to_find(),
            ExerciseError::GaveUp { tries, most, percent, unequal } => {
                let why = match unequal {
                    Some([small, large]) if *most == Refusal::ForcesUnequal => says::forces_unequal_as(small, large),
                    _ => most.message(),
                };
                says::gave_up(*tries, *percent, why)
            }
        }
    }
}

/// The exercises of a scene, one after another; they do not depend on how many are asked for.
#[derive(Clone, Debug)]
pub struct Exercises {
    base: Value,
    on_guides: Vec<OnGuide>,
    title: Untrusted,
    figure: Figure,
    seed: u64,
    random: Random,
    /// Most variants that are tried for each.
    tries: usize,
    /// Forces of the scene that are too unequal.
    unequal: Option<[String; 2]>,
    /// The number of the last exercise.
    number: usize,
    seen: BTreeSet<String>,
    /// Whether their forms ask for all arms.
    has_arms: bool,
    /// How the scene's loads were made more alike.
    evened: Option<String>,
    /// Whether nobody has chosen the size of the sheets.
    is_page_open: bool,
}

impl Exercises {
    /// The exercises of a solved scene, in the style of its figure. Where neither its text nor `page` gives the size of
    /// the sheets, they are A4, or A3 where few variants can be drawn well on A4.
    ///
    /// # Errors
    /// The scene has no construction.
    pub fn new(solution: &Solution, page: Option<Page>, seed: u64) -> Result<Exercises, ExerciseError> {
        let Solution { scene, construction, .. } = solution;
        let has_no_plans = construction.agreement.iter().any(Option::is_none) || construction.agreement.is_empty();
        if construction.draws_plans() && has_no_plans {
            return Err(ExerciseError::NoConstruction);
        }
        ExerciseError::refuse_nothing(solution)?;
        let base = serde_json::from_str(scene.text().trim_start_matches('\u{feff}'));
        let base: Value = base.expect("a scene is JSON");
        let is_page_open = page.is_none() && base["figure"]["page"].is_null();
        let figure = Figure {
            // The plans, unless the figure asks for instant centres or forces.
            panels: match construction.centers.is_some() || forces::has_forces(solution) {
                true => scene.figure.shown_panels(),
                false => Sheet::USUAL.to_vec(),
            },
            step: None,
            special_points: true,
            construction: ConstructionShown::Whole,
            page: page.unwrap_or(scene.figure.page),
            ..scene.figure.clone()
        };
        let mut exercises = Exercises {
            base,
            on_guides: OnGuide::all(scene),
            title: scene.title.clone().unwrap_or_default(),
            figure,
            seed,
            random: Random(seed),
            tries: (POINTS / (solution.mechanism.points.len() + scene.count_of_loads()).max(1))
                .clamp(LEAST_TRIES, TRIES),
            unequal: forces::too_unequal(solution),
            number: 0,
            seen: BTreeSet::new(),
            has_arms: false,
            evened: None,
            is_page_open,
        };
        if is_page_open && exercises.lacks_room() {
            exercises.figure.page.size = PageSize::A3;
        }
        Ok(exercises)
    }

    /// The same exercises, whose forms ask for the arms that force polygons need, too.
    #[must_use]
    pub fn with_arms(self) -> Exercises {
        Exercises { has_arms: true, ..self }
    }

    /// Whether few variants can be drawn well on the sheets; the same for every seed.
    fn lacks_room(&self) -> bool {
        let mut random = Random(0);
        let variants = (0..PILOT).map(|_| varied(&self.base, &self.on_guides, &mut random).to_string());
        let good = variants
            .filter(|numbers| Exercise::of(numbers, self.figure.page, Some(&self.figure), self.has_arms).is_ok());
        good.take(FEW).count() < FEW
    }

    /// The next exercise.
    ///
    /// # Errors
    /// None of 1000 variants, or fewer of a mechanism with very many points or loads, was an exercise; says what was wrong most often.
    #[expect(clippy::should_implement_trait, reason = "there is no end to iterate to")]
    pub fn next(&mut self) -> Result<Exercise, ExerciseError> {
        self.number += 1;
        let tries = self.tries;
        let mut refused = match self.try_variants() {
            Ok(exercise) => return Ok(exercise),
            Err(refused) => refused,
        };
        let is_unequal =
            refused.iter().max_by_key(|(_, count)| **count).is_some_and(|(most, _)| *most == Refusal::ForcesUnequal);
        if is_unequal && self.even() {
            match self.try_variants() {
                Ok(exercise) => return Ok(exercise),
                Err(again) => refused = again,
            }
        }
        let (most, count) = refused.into_iter().max_by_key(|(_, count)| *count).unwrap_or((Refusal::Numbers, tries));
        let percent = (100 * count + tries / 2) / tries;
        Err(ExerciseError::GaveUp { tries, most, percent, unequal: self.unequal.clone() })
    }

    /// A variant that is an exercise; else how often each refusal was met.
    fn try_variants(&mut self) -> Result<Exercise, BTreeMap<Refusal, usize>> {
        let mut refused: BTreeMap<Refusal, usize> = BTreeMap::new();
        for _ in 0..self.tries {
            match self.variant() {
                Ok(exercise) => return Ok(exercise),
                Err(refusal) => *refused.entry(refusal).or_default() += 1,
            }
        }
        Err(refused)
    }

    /// Makes the loads of the scene more alike, once; whether it has.
    fn even(&mut self) -> bool {
        if self.evened.is_some() {
            return false;
        }
        let Some((base, told)) = evened(&self.base, &self.on_guides, &self.figure) else { return false };
        (self.base, self.evened) = (base, Some(told));
        if self.is_page_open && self.lacks_room() {
            self.figure.page.size = PageSize::A3;
        }
        true
    }

    /// How the loads of the scene were changed, because some forces are too small beside others to be drawn with them, in symbols: `m_2 × 4, g = 0`. `None`
    /// where they were not.
    #[must_use]
    pub fn evened(&self) -> Option<Message> {
        self.evened.as_ref().map(says::evened)
    }

    /// A random variant, if it is an exercise.
    fn variant(&mut self) -> Result<Exercise, Refusal> {
        let mut file = varied(&self.base, &self.on_guides, &mut self.random);
        let numbers = file.to_string();
        let first = Exercise::of(&numbers, self.figure.page, Some(&self.figure), self.has_arms)?;
        if !self.seen.insert(numbers) {
            return Err(Refusal::Same);
        }
        // The position and the scales that were found go into the file, which is then judged as it stands.
        self.put_near(&mut file, &first);
        self.put_figure(&mut file, &first);
        let mut exercise = Exercise::of(&crate::format::json(&file), self.figure.page, None, false)?;
        let same = exercise.solution.pose.points.iter().zip(&first.solution.pose.points);
        let size = crate::geometry::span(first.solution.pose.points.iter().copied());
        let moved = same.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max);
        exercise.has_markers &= self.figure.markers;
        if moved < 1e-6 * size { Ok(exercise) } else { Err(Refusal::Assembly) }
    }

    /// Sets the scene's `near`, the rough places and angles that choose the assembly mode, to those of the variant.
    fn put_near(&self, file: &mut Value, found: &Exercise) {
        let step = length_step(file);
        let Some(near) = file.get_mut("near").and_then(Value::as_object_mut) else {
            return;
        };
        // The note describes the template's places.
        near.shift_remove("note");
        let solution = &found.solution;
        for (name, value) in near {
            if let Some(point) = solution.mechanism.point(name) {
                let place = solution.pose.point(point);
                *value = json!([place.x, place.y].map(|x| json_number(step.multiple(x, 0.0))));
            } else if let Ok(Quantity::Number(angle)) = solution.quantity(name) {
                *value = json_number(libm::round(angle));
            }
        }
    }

    /// Sets the scene's `figure`: the sheet, its scales, its words; and puts the exercise's number into the title.
    fn put_figure(&self, file: &mut Value, found: &Exercise) {
        let Some(file) = file.as_object_mut() else {
            return;
        };
        let asked = self.figure.clone();
        let figure = Figure {
            page: key_page(asked.page),
            style: asked.style,
            notation: asked.notation,
            sliding: asked.sliding,
            coriolis: asked.coriolis,
            frame: asked.frame,
            language: asked.language,
            decimal: asked.decimal,
            labels: asked.labels,
            panels: asked.panels,
            centers: asked.centers,
            velocities: asked.velocities,
            curvature: asked.curvature,
            inflection: asked.inflection,
            mu: found.scales,
            ..Figure::default()
        };
        file.shift_remove("want");
        file.shift_remove("$schema");
        file.insert("form".into(), marks_of(&found.to_ask));
        file.insert("figure".into(), Value::Object(figure_keys(&figure)));
        let number = format!("{}-{}", self.seed, self.number);
        file.insert("title".into(), json!(self.title.numbered(&number)));
    }
}
