use crate::drafting::{Pencil, Tolerance, Unread};
use crate::geometry::degrees_of;
use crate::plan::{Action, Construction, Plan, PlanKind, Step, plain_text};
use crate::scene::{Scene, Units};
use std::fmt::Write;

/// The construction as numbered text, each step with its values, its lengths in millimetres of paper and the bands of hand drawings.
#[must_use]
pub fn steps(scene: &Scene, construction: &Construction, pencil: &Pencil) -> String {
    let mut page = Page {
        text: String::new(),
        number: 0,
        units: scene.units,
        pencil,
    };
    if let Some(title) = &scene.title {
        page.line(title);
    }
    page.scales_line();
    page.pencil_lines();
    page.line("\nOn the mechanism");
    for step in &construction.scheme {
        page.step(step, None);
    }
    for plan in construction.plans() {
        page.line(match plan.kind {
            PlanKind::Velocity => "\nVelocity plan",
            PlanKind::Acceleration => "\nAcceleration plan",
        });
        for step in &plan.steps {
            page.step(step, Some(plan));
        }
    }
    for agreement in construction.agreement.iter().flatten() {
        let _ = writeln!(
            page.text,
            "\nThe rates from this construction and from the loop equations differ by {:.0e} of the largest; its crossings allow {:.0e}.",
            agreement.difference, agreement.allowed
        );
    }
    page.text
}

struct Page<'a> {
    text: String,
    number: usize,
    units: Units,
    pencil: &'a Pencil,
}

impl Page<'_> {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn unit(&self, kind: Option<PlanKind>) -> String {
        let (length, time) = (self.units.length.as_str(), self.units.time.as_str());
        match kind {
            None => length.to_owned(),
            Some(PlanKind::Velocity) => format!("{length}/{time}"),
            Some(PlanKind::Acceleration) => format!("{length}/{time}²"),
        }
    }

    fn mu(&self, kind: Option<PlanKind>) -> Option<f64> {
        match kind {
            None => self.pencil.scales.length,
            Some(PlanKind::Velocity) => self.pencil.scales.velocity,
            Some(PlanKind::Acceleration) => self.pencil.scales.acceleration,
        }
    }

    fn scales_line(&mut self) {
        let kinds = [None, Some(PlanKind::Velocity), Some(PlanKind::Acceleration)];
        let entries = kinds
            .into_iter()
            .zip(["μ_l", "μ_v", "μ_a"])
            .filter_map(|(kind, name)| {
                Some(format!(
                    "{name} = {} {} per mm",
                    self.mu(kind)?,
                    self.unit(kind)
                ))
            });
        let line = format!("Scales: {}", entries.collect::<Vec<_>>().join(", "));
        self.line(&line);
    }

    /// What the bands mean, and why some values have none.
    fn pencil_lines(&mut self) {
        let Tolerance { mm, degrees } = self.pencil.tolerance;
        self.line(&format!(
            "± is what honest hand drawings (±{mm} mm, ±{degrees}°) keep to, at least 95 of 100."
        ));
        let mut reasons: Vec<&Unread> = Vec::new();
        for (_, band) in &self.pencil.quantities {
            if let Err(why @ (Unread::NoConstruction | Unread::NoSheet(_))) = band
                && !reasons.contains(&why)
            {
                reasons.push(why);
            }
        }
        for why in reasons {
            self.line(&format!("A value has no ± where {why}."));
        }
    }

    /// The band of a quantity, in its unit and, of what is measured, on paper, as it follows a value; nothing where it has none.
    fn band(&self, name: &str, unit: &str, mu: Option<f64>) -> String {
        let Some(band) = self.pencil.band(name) else {
            return String::new();
        };
        let on_paper = mu.map(|mu| format!(" ({:.2} mm)", band.band / mu));
        let rough = if band.is_rough { ", only roughly" } else { "" };
        format!(
            "; ± {} {unit}{}{rough}",
            significant(band.band, 2),
            on_paper.unwrap_or_default()
        )
    }

    /// The band of a plan's segment.
    fn segment_band(&self, kind: Option<PlanKind>, from: &str, to: &str) -> String {
        let name = kind.map(|kind| kind.segment_name(from, to));
        self.band(&name.unwrap_or_default(), &self.unit(kind), self.mu(kind))
    }

    /// A value with its unit and its length on paper.
    fn measure(&self, value: f64, kind: Option<PlanKind>) -> String {
        let on_paper = self
            .mu(kind)
            .map(|mu| format!(" ({:.2} mm on paper)", value / mu));
        format!(
            "{} {}{}",
            digits(value),
            self.unit(kind),
            on_paper.unwrap_or_default()
        )
    }

    fn step(&mut self, step: &Step, plan: Option<&Plan>) {
        self.number += 1;
        let _ = writeln!(
            self.text,
            "{:3}. {}",
            self.number,
            plain_text(&step.caption)
        );
        for detail in self.details(step, plan) {
            let _ = writeln!(self.text, "     {detail}");
        }
    }

    /// Equation and values of a step, a line each.
    fn details(&self, step: &Step, plan: Option<&Plan>) -> Vec<String> {
        let kind = plan.map(|p| p.kind);
        let equation = plain_text(&step.equation.markup());
        match &step.action {
            Action::Pole { .. } | Action::Note => Vec::new(),
            Action::SpecialPoint { sine, .. } => {
                vec![format!("angle of crossing {:.2}°", angle_of_sine(*sine))]
            }
            Action::MeasureLength { from, to, value } => {
                let band = self.band(&format!("L({from},{to})"), &self.unit(None), self.mu(None));
                vec![format!("{equation} = {}{band}", self.measure(*value, None))]
            }
            Action::LayOff(arrow) => {
                let vector = plan.and_then(|p| p.segment(&arrow.from, &arrow.to));
                let Some(vector) = vector else {
                    return Vec::new();
                };
                let mut lines = Vec::new();
                if !equation.is_empty() {
                    lines.push(equation);
                }
                lines.push(format!(
                    "{} {} = {}, direction {:.2}°{}",
                    arrow.from,
                    arrow.to,
                    self.measure(vector.norm(), kind),
                    degrees_of(vector),
                    self.segment_band(kind, &arrow.from, &arrow.to)
                ));
                lines
            }
            Action::Ray(ray) => {
                let direction = format!("direction {:.2}°", degrees_of(ray.direction));
                if equation.is_empty() {
                    vec![direction]
                } else {
                    vec![format!("{equation}; {direction}")]
                }
            }
            Action::Cross { point, sine, .. } => {
                let mut lines = vec![format!("angle of crossing {:.2}°", angle_of_sine(*sine))];
                let vector = plan.and_then(|p| p.segment(p.kind.pole(), point));
                if let (Some(vector), Some(plan)) = (vector, plan) {
                    lines.push(format!(
                        "{} {point} = {}, direction {:.2}°{}",
                        plan.kind.pole(),
                        self.measure(vector.norm(), kind),
                        degrees_of(vector),
                        self.segment_band(kind, plan.kind.pole(), point)
                    ));
                }
                lines
            }
            Action::Measure { from, to, value } => {
                let band = self.segment_band(kind, from, to);
                vec![format!(
                    "{from} {to} = {}{band}",
                    self.measure(*value, kind)
                )]
            }
            Action::Solve {
                equations,
                unknowns,
            } => {
                let mut lines: Vec<String> = equations.iter().map(|e| plain_text(e)).collect();
                let time = self.units.time.as_str();
                lines.extend(unknowns.iter().map(|(name, value)| {
                    let unit = match name.split('(').next() {
                        Some("omega") => format!("rad/{time}"),
                        Some("alpha") => format!("rad/{time}²"),
                        _ => self.unit(kind),
                    };
                    // Computed, not measured: it has no length on paper.
                    let band = self.band(name, &unit, None);
                    format!("{name} = {} {unit}{band}", digits(*value))
                }));
                lines
            }
        }
    }
}

/// A number with so many significant digits.
fn significant(x: f64, count: i32) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::floor(libm::log10(x.abs())) as i32;
    let after = (count - 1 - exponent).max(0) as usize;
    if (-4..9).contains(&exponent) {
        format!("{x:.after$}")
    } else {
        format!("{x:.*e}", count as usize - 1)
    }
}

/// Seven significant digits.
fn digits(x: f64) -> String {
    significant(x, 7)
}

/// The acute angle, in degrees, that has this sine.
fn angle_of_sine(sine: f64) -> f64 {
    libm::asin(sine.abs().min(1.0)).to_degrees()
}
