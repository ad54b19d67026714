use crate::answers::{Opened, Owner, Quantity, Step, ValueRow};
use crate::desk::{Desk, in_words};
use crate::refused::Refused;
use kinegon::construction::{Action, NumberedStep, Teller, shown_text};
use kinegon::cycle::every_name;
use kinegon::drawing::{FigureSheets, RichText, SheetLabels};
use kinegon::format::{self, html_text};
use kinegon::mechanism::Mechanism;
use kinegon::quantity::{QuantityName, QuantityRequest, force_names, measured_names, turning_names};
use kinegon::scene::{Argument, GivenBy, SizeLimit};
use kinegon::words::Wording;
use kinegon::{Order, Sheet, Solution};
use serde_json::Value;

impl Desk {
    /// What is known of a scene.
    pub fn open(&mut self, text: &str) -> Result<Opened, Refused> {
        let spoken = self.language();
        let (kept, language) = self.kept_with_language(text)?;
        let drives = kept.drives()?;
        let too_large = kept.check(SizeLimit::STEPS).err().map(|refused| refused.message().clone());
        let solution = &*in_words(kept.figure()?, language);
        let words = solution.wording();
        let (steps, passages) = match too_large {
            None => (steps(solution, &words), solution.construction.passages()),
            Some(_) => (Vec::new(), Vec::new()),
        };
        let teller = Teller::shown(solution, &words);
        let captions = passages.iter().map(|passage| {
            let plan = solution.shown_construction().steps_of(passage).next().and_then(|step| step.plan);
            shown_text(&teller.passage_caption(passage), plan, &words)
        });
        let (scene, mechanism) = (&solution.scene, &solution.mechanism);
        let mut quantities = every_name(mechanism);
        quantities.extend(turning_names(mechanism));
        quantities.extend(force_names(mechanism));
        quantities.extend(measured_names(&solution.construction));
        let named = |name: &String| quantity(name, mechanism);
        let is_traceable = |name: &&String| scene.check_traced(&[(*name).clone()], None).is_ok();
        let title = scene.title.clone().unwrap_or_else(|| words.language.title().into());
        Ok(Opened {
            title: title.for_message(),
            scene: match serde_json::from_str(text.trim_start_matches('\u{feff}')) {
                Ok(Value::Object(scene)) => scene,
                _ => Default::default(),
            },
            drives,
            steps,
            passage_captions: captions.collect(),
            passages: passages.iter().map(|passage| passage.steps).collect(),
            traceable: mechanism.points.iter().filter(is_traceable).cloned().collect(),
            quantities: quantities.iter().map(named).collect(),
            wanted: scene.want.iter().flatten().map(named).collect(),
            structure: format::structure(mechanism, &words),
            panels: scene.figure.panels.iter().copied().filter(|panel| has_panel(solution, *panel)).collect(),
            warnings: {
                let of_figure = FigureSheets::new(solution).overflow_warnings().into_iter().chain(too_large);
                solution.warnings_in(spoken).chain(of_figure.map(|warning| spoken.says(&warning))).collect()
            },
            is_drawn: scene.given_by == GivenBy::Drawing,
        })
    }

    /// All rates, velocities and accelerations with their certain digits.
    pub fn values(&mut self, text: &str) -> Result<Vec<ValueRow>, Refused> {
        let kept = self.kept(text)?;
        let solution = kept.solution(Order::Acceleration)?;
        let labels = SheetLabels::of(solution);
        let label = |name: &str| match QuantityRequest::new(name, &solution.mechanism) {
            Ok(asked) => html_text(&labels.quantity(&asked)),
            Err(_) => html_text(&RichText::verbatim(name)),
        };
        let rows = solution.digit_rows().into_iter().map(|row| ValueRow {
            label: label(&row.name),
            quantity: quantity(&row.name, &solution.mechanism),
            error: row.bound.strip_prefix("± ").map(str::to_owned),
            name: row.name,
            value: row.value,
            unit: row.unit,
        });
        Ok(rows.collect())
    }
}

/// Whether a panel has something to show.
fn has_panel(solution: &Solution, panel: Sheet) -> bool {
    panel.order().is_none() || solution.construction.plan_on(panel).is_some()
}

/// What the name of a quantity says.
fn quantity(name: &str, mechanism: &Mechanism) -> Quantity {
    let is_vector = QuantityRequest::new(name, mechanism).is_ok_and(|asked| asked.is_vector());
    let plain =
        |of| Quantity { name: name.to_owned(), head: "".into(), inside: "".into(), part: "".into(), of, is_vector };
    let Some(written) = QuantityName::parse(name) else { return plain(Owner::Others) };
    let of = match written.head.argument(0) {
        Argument::Link if written.arguments.len() == 1 => Owner::Link,
        Argument::Slider => Owner::Slider,
        Argument::Point if written.arguments.len() == 1 => Owner::Point,
        Argument::Link | Argument::Point | Argument::Load | Argument::Nothing => Owner::Others,
    };
    let (head, inside) = (written.head.word(), written.subject());
    Quantity { head: head.into(), part: written.tail().into(), inside, ..plain(of) }
}

/// The steps of the construction.
fn steps(solution: &Solution, words: &Wording) -> Vec<Step> {
    let teller = Teller::shown(solution, words);
    let equations = |step: &NumberedStep<'_>| match &step.action {
        Action::Solve { equations, .. } => equations.iter().map(|equation| teller.equation(equation)).collect(),
        _ => vec![teller.formula(step).markup()],
    };
    let step = |(step, lines): (NumberedStep<'_>, Vec<String>)| {
        let equation = shown_text(&equations(&step).join("; "), step.plan, words);
        // An equation is told once.
        let rest = |line: String| line.strip_prefix(&equation).unwrap_or(&line).trim_start_matches("; ").to_owned();
        Step {
            number: step.number,
            caption: shown_text(&teller.caption(&step), step.plan, words),
            values: lines.into_iter().map(rest).filter(|line| !line.is_empty()).collect(),
            equation,
            panel: step.sheet,
        }
    };
    solution.shown_construction().numbered_steps().zip(format::step_values(solution)).map(step).collect()
}
