use crate::refused::Refused;
use crate::scene::Scene;
use kinegon::Order;
use kinegon::accuracy::bounds;
use kinegon::construction::{Action, NumberedStep, Teller, Tolerance, shown_text};
use kinegon::cycle::Traces;
use kinegon::drawing::{Drawing, FigureSheets, Film, Style, Timing};
use kinegon::editing::with_mode;
use kinegon::format::{OpenScene, workbench};
use kinegon::mechanism::Mechanism;
use kinegon::order_of_figure;
use kinegon::position::Pose;
use kinegon::quantity::{Quantity, QuantityRequest, step_pencil};
use kinegon::scene::SizeLimit;
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::sync::OnceLock;

/// A solved scene: its position, and its motion as far as it was asked for.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Solution {
    pub scene: Scene,
    mode: Option<usize>,
    pub mechanism: Mechanism,
    pub pose: Pose,
    /// Solved for velocities, and for accelerations.
    solved: [OnceLock<kinegon::Solution>; 2],
}

/// A value, of a vector two, its unit, and the bound of its error.
pub type ValueOf = (Vec<f64>, String, Option<f64>);

impl Solution {
    /// A scene in the assembly mode of that number, or in its own.
    pub fn of(scene: &Scene, mode: Option<usize>) -> Result<Solution, Refused> {
        let (mechanism, pose) = scene.posed(SizeLimit::NUMBERS, mode)?;
        let scene = Scene { text: scene.text.clone(), is_seen: scene.is_seen, scene: scene.scene.clone() };
        let solution = Solution { scene, mode, mechanism, pose, solved: Default::default() };
        solution.solved(Order::Acceleration)?;
        Ok(solution)
    }

    /// The figure with other keys, in the same position.
    pub fn with_keys(&self, keys: &str) -> Result<Solution, Refused> {
        let scene = self.scene.with_keys(keys)?;
        let (mechanism, pose) = (self.mechanism.clone(), self.pose.clone());
        Ok(Solution { scene, mode: self.mode, mechanism, pose, solved: Default::default() })
    }

    /// The scene solved for this order of motion.
    pub fn solved(&self, order: Order) -> Result<&kinegon::Solution, Refused> {
        let kept = &self.solved[order];
        if let Some(solution) = kept.get() {
            return Ok(solution);
        }
        let (mechanism, pose) = (self.mechanism.clone(), self.pose.clone());
        let solution = kinegon::Solution::new(self.scene.scene.clone(), mechanism, pose, order);
        let solution = solution.map_err(|error| self.scene.refused(error))?;
        Ok(kept.get_or_init(|| solution))
    }

    /// Solved for what is drawn by hand.
    pub fn by_hand(&self) -> Result<&kinegon::Solution, Refused> {
        self.allow(SizeLimit::HAND)?;
        self.solved(Order::Acceleration)
    }

    pub fn allow(&self, limit: SizeLimit) -> Result<(), Refused> {
        limit.check(&self.scene.scene).map_err(|error| self.scene.refused(error))
    }

    pub fn value(&self, name: &str) -> Result<ValueOf, Refused> {
        let solution = self.solved(Order::Acceleration)?;
        let asked = QuantityRequest::new(name, &solution.mechanism)?;
        let scales = asked.written.on_paper.then(|| FigureSheets::new(solution).scales());
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), scales.as_ref())?;
        let numbers = match value {
            Quantity::Number(x) => vec![x],
            Quantity::Vector(v) => vec![v.x, v.y],
        };
        let bounds = bounds(&solution.scene, &solution.mechanism, &solution.pose, &solution.motion);
        let error = Some(bounds.with_plans(&solution.construction).of(&asked, scales.as_ref()));
        let error = error.filter(|error| error.is_finite());
        let unit = if asked.written.on_paper { "mm".to_owned() } else { asked.kind().unit(solution.scene.units) };
        Ok((numbers, unit, error))
    }

    /// The sheets of the figure; those after a step where one is asked for.
    pub fn sheets(&self, style: Option<&str>, is_coarse: bool, is_layered: bool) -> Result<Vec<Drawing>, Refused> {
        let step = self.scene.scene.figure.step;
        let is_stepwise = step.is_some() || is_layered;
        self.allow(if is_stepwise { SizeLimit::STEPS } else { SizeLimit::FIGURE })?;
        let solution = self.solved(order_of_figure(&self.scene.scene))?;
        Traces::new(solution, None).map_err(|error| self.scene.refused(error))?;
        let style = style.map(Style::read).transpose()?;
        let styled = style.as_ref().map(|style| {
            let mut styled = solution.clone();
            put_sizes(style, &mut styled);
            styled
        });
        let solution = styled.as_ref().unwrap_or(solution);
        let mut sheets = match step {
            Some(step) => vec![after(solution, step, is_coarse)?],
            None => solution.sheets(),
        };
        if let Some(style) = style {
            sheets.iter_mut().for_each(|sheet| sheet.style = style.clone());
        }
        Ok(sheets)
    }

    /// The film of the figure.
    pub fn film_of(&self, timing: Timing, drive: Option<&str>, style: Option<&str>) -> Result<Film, Refused> {
        self.allow(SizeLimit::STEPS)?;
        let mut solution = self.solved(order_of_figure(&self.scene.scene))?.clone();
        let style = style.map(Style::read).transpose()?;
        if let Some(style) = &style {
            put_sizes(style, &mut solution);
        }
        let film = Film::new(&solution, drive, timing).map_err(|error| self.scene.refused(error))?;
        Ok(style.into_iter().fold(film, Film::in_style))
    }

    /// The workbench with the scene open at a step, or with the finished figure.
    pub fn page(&self, step: Option<usize>) -> Result<String, Refused> {
        self.allow(SizeLimit::STEPS)?;
        let Scene { text, scene, .. } = &self.scene;
        let moved = self.mode.map(|mode| with_mode(text, mode)).transpose()?;
        let text = moved.as_deref().unwrap_or(text);
        Ok(workbench(Some(OpenScene { text, step: scene.figure.step.or(step) })))
    }

    pub fn told_steps(&self, hand: Tolerance) -> Result<(String, String), Refused> {
        let solution = self.by_hand()?;
        let pencil = step_pencil(solution, hand).map_err(|error| self.scene.refused(error))?;
        Ok((solution.steps(&pencil), json!(steps(solution)).to_string()))
    }
}

/// Gives a figure the sizes of a style file, which must be known before anything is drawn.
fn put_sizes(style: &Style, solution: &mut kinegon::Solution) {
    let figure = &mut solution.scene.figure;
    (figure.sizes, figure.usual_values) = (Some(style.sizes()), Some(style.shows_values()));
}

/// The sheet after a step, or after the steps that a lecturer shows together.
fn after(solution: &kinegon::Solution, step: usize, is_coarse: bool) -> Result<Drawing, Refused> {
    let all = if is_coarse { solution.coarse_figure() } else { solution.stepwise_figure() };
    let count = all.steps.len();
    if (1..=count).contains(&step) {
        return Ok(all.after_step(step));
    }
    let hint = format!("the construction has steps 1 to {count}");
    Err(Refused::new("KinegonError", format!("there is no step {step}"), Some(&hint)))
}

/// The steps of the construction, in the figure's language.
fn steps(solution: &kinegon::Solution) -> Vec<Value> {
    let words = solution.wording();
    let teller = Teller::shown(solution, &words);
    let equation = |step: &NumberedStep<'_>| match &step.action {
        Action::Solve { equations, .. } => {
            let told: Vec<String> = equations.iter().map(|equation| teller.equation(equation)).collect();
            told.join("; ")
        }
        _ => teller.formula(step).markup(),
    };
    let step = |step: NumberedStep<'_>| {
        json!({
            "number": step.number,
            "caption": shown_text(&teller.caption(&step), step.plan, &words),
            "equation": shown_text(&equation(&step), step.plan, &words),
            "panel": step.sheet.as_str(),
        })
    };
    solution.shown_construction().numbered_steps().map(step).collect()
}

/// The limits of a hand's errors, if one is given.
pub fn tolerance(mm: Option<f64>, degrees: Option<f64>) -> Result<Option<Tolerance>, Refused> {
    if [mm, degrees].into_iter().flatten().any(|limit| !(0.0..=Tolerance::LARGEST).contains(&limit)) {
        let message = format!("the limits of a pencil's errors are from 0 to {}", Tolerance::LARGEST);
        return Err(Refused::new("KinegonError", message, None));
    }
    let usual = Tolerance::default();
    let given = Tolerance { mm: mm.unwrap_or(usual.mm), degrees: degrees.unwrap_or(usual.degrees) };
    Ok((mm.is_some() || degrees.is_some()).then_some(given))
}
