use crate::answers::{Opened, Panel, Picture, Step, View};
use crate::refused::Refused;
use kinegon::Scene;
use kinegon::construction::{PlanKind, Solution, shown_text};
use serde_json::Value;

/// The last scene, solved.
#[derive(Default)]
pub struct Desk {
    current: Option<(String, Solution)>,
}

impl Desk {
    /// The scene of this text, solved.
    pub fn solution(&mut self, text: &str) -> Result<&Solution, Refused> {
        if self.current.as_ref().is_none_or(|(known, _)| known != text) {
            let scene = Scene::read(text).map_err(|error| Refused::of(text, error))?;
            let solution = kinegon::solve(&scene).map_err(|error| Refused::of(text, error))?;
            self.current = Some((text.to_owned(), solution));
        }
        match &self.current {
            Some((_, solution)) => Ok(solution),
            None => Err(Refused::whole("there is no scene")),
        }
    }

    /// What is known of a scene.
    pub fn open(&mut self, text: &str) -> Result<Opened, Refused> {
        let scene: Value = serde_json::from_str(text).unwrap_or_default();
        let solution = self.solution(text)?;
        let words = solution.wording();
        let figure = solution.stepwise_figure();
        let steps = solution.construction.numbered_steps().zip(&figure.steps).map(|(step, caption)| Step {
            number: step.number,
            caption: caption.clone(),
            equation: String::new(),
            panel: step.plan.map_or("scheme", |plan| match plan.kind {
                PlanKind::Velocity => "velocity",
                PlanKind::Acceleration => "acceleration",
            }),
        });
        let _ = (words, shown_text);
        Ok(Opened {
            title: figure.title.for_message(),
            scene,
            drives: Vec::new(),
            steps: steps.collect(),
            passages: Vec::new(),
            traceable: Vec::new(),
            quantities: Vec::new(),
            vectors: Vec::new(),
            structure: kinegon::format::structure(&solution.mechanism),
            warnings: solution.warnings().collect(),
            is_drawn: false,
        })
    }

    /// The picture of a scene.
    pub fn picture(&mut self, text: &str, view: &View) -> Result<Picture, Refused> {
        let solution = self.solution(text)?;
        let drawing = match view.step {
            None => solution.figure(),
            Some(step) => solution.stepwise_figure().after_step(step),
        };
        let panels = drawing.panels.iter().zip(["scheme", "velocity", "acceleration"]).map(|((name, area), key)| {
            Panel { name: name.clone(), key, area: [area.x0, area.y0, area.width(), area.height()], is_cut: false }
        });
        Ok(Picture {
            svg: drawing.svg(),
            width: drawing.width,
            height: drawing.height,
            panels: panels.collect(),
            handles: Vec::new(),
            drives: Vec::new(),
            notes: Vec::new(),
        })
    }
}
