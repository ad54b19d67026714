use crate::construction::{
    Action, CurvatureStep, ForceStep, NOTHING, NumberedStep, Solution, Teller, Tolerance, contacts_told, display,
    plain_text, shown_text,
};
use crate::drawing::{FigureSheets, drawn_vector};
use crate::geometry::{Vector, degrees_of};
use crate::quantity::{Pencil, QuantityRequest, Unread};
use crate::scene::{Head, QuantityName, Units};
use crate::sheet::{QuantityKind, Scales, Sheet};
use crate::words::{NumberStyle, Wording};
use std::fmt::Write;

/// The style of lengths on paper and of angles.
const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2);
/// The style of values in a list to work with.
const SEVEN_DIGITS: NumberStyle = NumberStyle::significant(7);
/// The style of values that are read aloud.
const FOUR_DIGITS: NumberStyle = NumberStyle::significant(4);
/// The style of the difference of the two routes.
const ONE_DIGIT: NumberStyle = NumberStyle::significant(1).in_full(0, 0);

impl Solution {
    /// The construction as a numbered list: each step with its values, its lengths in millimetres of paper and the
    /// bands of hand drawings.
    #[must_use]
    pub fn steps(&self, pencil: &Pencil) -> String {
        let (scene, construction) = (&self.scene, self.shown_construction());
        let words = self.wording();
        let language = words.language;
        let teller = Teller::shown(self, &words);
        let style = SEVEN_DIGITS;
        let mut list =
            StepList { text: String::new(), solution: self, units: scene.units, words: &words, teller, pencil, style };
        if let Some(title) = scene.title.as_ref().filter(|title| !title.is_blank()) {
            list.line(&title.for_terminal());
        }
        list.scales_lines();
        list.pencil_lines();
        let shown = |name: &str| display(name);
        for said in contacts_told(&self.mechanism, &words, &shown) {
            list.line(&shown_text(&said, None, &words));
        }
        let mut sheet = None;
        for step in construction.numbered_steps() {
            if sheet.replace(step.sheet) != Some(step.sheet) {
                list.heading(&match step.sheet {
                    Sheet::Scheme => language.on_the_mechanism().to_owned(),
                    sheet => list.teller.sheet_name(sheet),
                });
            }
            list.step(&step);
        }
        for agreement in construction.agreement.iter().flatten() {
            let [difference, allowed] =
                [agreement.difference, agreement.allowed].map(|x| words.agreement(x, ONE_DIGIT));
            list.heading(&language.routes_differ(&difference, &allowed));
        }
        if let Some(agreement) = construction.forces.as_ref().and_then(|plan| plan.agreement) {
            let [difference, allowed] =
                [agreement.difference, agreement.allowed].map(|x| words.agreement(x, ONE_DIGIT));
            list.heading(&language.forces_differ(&difference, &allowed));
        }
        if let Some(agreement) = construction.centers.as_ref().and_then(|centers| centers.agreement) {
            let [difference, allowed] =
                [agreement.difference, agreement.allowed].map(|x| words.agreement(x, ONE_DIGIT));
            list.heading(&language.centers_differ(&difference, &allowed));
        }
        let curvatures = construction.centers.iter().flat_map(|centers| &centers.curvatures);
        for agreement in curvatures.filter_map(|found| found.agreement) {
            let [difference, allowed] =
                [agreement.difference, agreement.allowed].map(|x| words.agreement(x, ONE_DIGIT));
            list.heading(&language.curvatures_differ(&difference, &allowed));
        }
        let inflections = construction.centers.iter().flat_map(|centers| &centers.inflections);
        for agreement in inflections.filter_map(|found| found.agreement) {
            let [difference, allowed] =
                [agreement.difference, agreement.allowed].map(|x| words.agreement(x, ONE_DIGIT));
            list.heading(&language.inflections_differ(&difference, &allowed));
        }
        list.text
    }
}

/// The equation and the values of each step in plain text, a line each, to be read aloud beside its caption: with four
/// digits, in the scene's units, without lengths on paper and without bands.
#[must_use]
pub fn step_values(solution: &Solution) -> Vec<Vec<String>> {
    let words = solution.wording();
    let teller = Teller::shown(solution, &words);
    let none = Pencil { tolerance: Tolerance::default(), scales: Scales::default(), quantities: Vec::new() };
    let units = solution.scene.units;
    let list =
        StepList { text: String::new(), solution, units, words: &words, teller, pencil: &none, style: FOUR_DIGITS };
    solution.shown_construction().numbered_steps().map(|step| list.details(&step)).collect()
}

struct StepList<'a> {
    text: String,
    solution: &'a Solution,
    /// Of values.
    style: NumberStyle,
    units: Units,
    words: &'a Wording,
    teller: Teller<'a>,
    pencil: &'a Pencil,
}

impl StepList<'_> {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// A line with an empty one before it.
    fn heading(&mut self, line: &str) {
        self.text.push('\n');
        self.line(line);
    }

    fn unit(&self, sheet: Sheet) -> String {
        sheet.facts().drawn.unit(self.units)
    }

    /// The scales of the lengths on paper, which are those for a hand, and those of the figure where it has others.
    fn scales_lines(&mut self) {
        let all = |scales: &Scales| {
            let scale = |sheet: Sheet| {
                let mu = self.words.write(scales[sheet]?, NumberStyle::shortest());
                Some(self.words.language.scale_per_mm(sheet.facts().scale_symbol, &mu, &self.unit(sheet)))
            };
            Sheet::ALL.into_iter().filter_map(scale).collect::<Vec<String>>().join(", ")
        };
        let [by_hand, figure] = [&self.pencil.scales, &FigureSheets::new(self.solution).scales()].map(all);
        let language = self.words.language;
        if by_hand == figure {
            self.line(&language.scales(&by_hand));
        } else {
            self.line(&language.scales_by_hand(&by_hand));
            self.line(&language.scales_of_figure(&figure));
        }
    }

    /// Lines that say what the bands mean, and why some values have none.
    fn pencil_lines(&mut self) {
        let Tolerance { mm, degrees } = self.pencil.tolerance;
        let [mm, degrees] = [mm, degrees].map(|x| self.words.write(x, NumberStyle::shortest()));
        let language = self.words.language;
        self.line(&language.bands(&mm, &degrees));
        let mut reasons: Vec<&Unread> = Vec::new();
        for (_, band) in &self.pencil.quantities {
            if let Err(why @ (Unread::NoConstruction | Unread::NoSheet(_))) = band
                && !reasons.contains(&why)
            {
                reasons.push(why);
            }
        }
        for why in reasons {
            match why {
                Unread::NoSheet(sheet) => {
                    self.line(&language.no_band_no_sheet(language.named_sheet(*sheet)));
                }
                _ => self.line(language.no_band_no_construction()),
            }
        }
    }

    /// The band of a quantity as a text that follows its value: in its unit and, with a scale `mu`, in mm of paper.
    /// Empty where the quantity has no band.
    fn band(&self, name: &str, unit: &str, mu: Option<f64>) -> String {
        let Some(band) = self.pencil.band(name) else {
            return String::new();
        };
        let on_paper = mu.and_then(|mu| {
            let mm = self.words.on_paper(band.band, mu, HUNDREDTHS)?;
            Some(format!(" ({mm} mm)"))
        });
        let rough = if band.is_rough { self.words.language.only_roughly() } else { "" };
        format!(
            "; ± {}{}{unit}{}{rough}",
            self.words.write(band.band, NumberStyle::significant(2)),
            if unit == "°" { "" } else { " " },
            on_paper.unwrap_or_default()
        )
    }

    /// A force or a moment that hands find, with its value and its band.
    fn force(&self, name: &str) -> Option<String> {
        let Solution { mechanism, construction, .. } = self.solution;
        let asked = QuantityRequest::new(name, mechanism).ok()?;
        let value = asked.value(&self.solution.snapshot(), Some(construction), None).ok()?.as_number();
        let symbol = shown_text(&asked.symbol(mechanism, &self.words.notation, &display), None, self.words);
        let unit = asked.kind().unit(self.units);
        Some(format!("{symbol} = {} {unit}{}", self.digits(value), self.band(name, &unit, None)))
    }

    /// The lines of a step of the force plan or a lever: its equation with the value, and what else it finds.
    fn of_forces(&self, step: &NumberedStep<'_>, equation: String) -> Vec<String> {
        let names = step.names();
        if let Action::Force(ForceStep::Cross(..)) = step.action {
            let sizes = names.iter().filter(|name| !name.ends_with(".angle"));
            return [equation].into_iter().chain(sizes.filter_map(|name| self.force(name))).collect();
        }
        let Some((value, kind)) = self.teller.value_of_step(step.action) else { return vec![equation] };
        let unit = kind.unit(self.units);
        let is_it = |name: &&String| QuantityName::parse(name).is_some_and(|name| name.kind() == kind);
        let band = names.iter().find(is_it).map_or_else(String::new, |name| self.band(name, &unit, None));
        let first = format!("{equation} = {} {unit}{band}", self.digits(value));
        let further = names.iter().filter(|name| !is_it(name)).filter_map(|name| self.force(name));
        [first].into_iter().chain(further).collect()
    }

    /// The band of a plan's segment.
    fn segment_band(&self, sheet: Sheet, from: &str, to: &str) -> String {
        self.band(&sheet.segment_name(from, to), &self.unit(sheet), self.pencil.scales[sheet])
    }

    /// A number that is read off the sheet of centres, with its band: a coordinate, a distance, a direction.
    fn read(&self, name: &str, sheet: Sheet) -> Option<String> {
        let Solution { mechanism, construction, .. } = self.solution;
        let asked = QuantityRequest::new(name, mechanism).ok()?;
        let value = asked.value(&self.solution.snapshot(), Some(construction), None).ok()?.as_number();
        let symbol = shown_text(&asked.symbol(mechanism, &self.words.notation, &display), None, self.words);
        Some(match asked.kind() {
            QuantityKind::Angle => format!("{symbol} = {}°{}", self.degrees(value), self.band(name, "°", None)),
            _ => {
                let band = self.band(name, &self.unit(sheet), self.pencil.scales[sheet]);
                format!("{symbol} = {}{band}", self.measure(value, sheet))
            }
        })
    }

    /// A value with its unit and its length on paper.
    fn measure(&self, value: f64, sheet: Sheet) -> String {
        let on_paper = self.pencil.scales[sheet].and_then(|mu| {
            let mm = self.words.on_paper(value, mu, HUNDREDTHS)?;
            Some(format!(" ({})", self.words.language.on_paper(&mm)))
        });
        format!("{} {}{}", self.digits(value), self.unit(sheet), on_paper.unwrap_or_default())
    }

    fn step(&mut self, step: &NumberedStep<'_>) {
        let caption = shown_text(&self.teller.caption(step), step.plan, self.words);
        let _ = writeln!(self.text, "{:3}. {caption}", step.number);
        for detail in self.details(step) {
            let _ = writeln!(self.text, "     {detail}");
        }
    }

    /// A value.
    fn digits(&self, value: f64) -> String {
        self.words.write(value, self.style)
    }

    fn degrees(&self, degrees: f64) -> String {
        self.words.write(degrees, HUNDREDTHS)
    }

    /// The acute angle of a crossing with this sine.
    fn crossing(&self, sine: f64) -> String {
        let angle = libm::asin(sine.abs().min(1.0)).to_degrees();
        self.words.language.angle_of_crossing(&self.degrees(angle))
    }

    /// A vector's size with its length on paper, and its direction.
    fn vector(&self, vector: Vector, sheet: Sheet) -> String {
        let size = self.measure(vector.norm(), sheet);
        if vector == Vector::zeros() {
            return size;
        }
        self.words.language.with_direction(&size, &self.degrees(degrees_of(vector)))
    }

    /// The equation and the values of a step, one per line.
    fn details(&self, step: &NumberedStep<'_>) -> Vec<String> {
        let plan = step.plan;
        let sheet = step.sheet;
        let equation = shown_text(&self.teller.formula(step).markup(), plan, self.words);
        let shown = |name: &str| match plan {
            Some(plan) => plain_text(&plan.shown(name, name.to_owned(), &self.words.notation)),
            None => name.to_owned(),
        };
        let with_vector = |first: String| {
            let drawn = drawn_vector(step).map(|(ends, vector)| {
                // Its band is known by the names in the order of the steps.
                let named = if let Action::LayOff(arrow) = step.action { [&*arrow.from, &*arrow.to] } else { ends };
                let ([from, to], band) = (ends.map(shown), self.segment_band(sheet, named[0], named[1]));
                format!("{from} {to} = {}{band}", self.vector(vector, sheet))
            });
            [first].into_iter().filter(|line| !line.is_empty()).chain(drawn).collect()
        };
        match step.action {
            Action::SpecialPoint { sine, .. } => vec![self.crossing(*sine)],
            Action::LayOff(_) | Action::Divide { .. } | Action::Coincide { .. } => with_vector(equation),
            Action::Cross { sine, .. } => with_vector(self.crossing(*sine)),
            Action::Ray(ray) => {
                let direction = self.words.language.direction(&self.degrees(degrees_of(ray.direction)));
                if equation.is_empty() { vec![direction] } else { vec![format!("{equation}; {direction}")] }
            }
            Action::Measure { from, to, value } => {
                let measured = if plan.is_some() { format!("{} {}", shown(from), shown(to)) } else { equation };
                let value = if plan.is_some_and(|plan| plan.is_nothing(*value)) { 0.0 } else { *value };
                let band = self.segment_band(sheet, from, to);
                vec![format!("{measured} = {}{band}", self.measure(value, sheet))]
            }
            Action::Solve { equations, unknowns } => {
                let shown = |e| shown_text(&self.teller.equation(e), plan, self.words);
                let mut lines: Vec<String> = equations.iter().map(shown).collect();
                let largest = unknowns.iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
                lines.extend(unknowns.iter().map(|(name, value)| {
                    let value = if value.abs() <= NOTHING * largest { &0.0 } else { value };
                    let unit = QuantityName::parse(name).map_or_else(String::new, |name| name.kind().unit(self.units));
                    // A rate is computed, not measured: it has no length on paper.
                    // Of a plan that is not drawn there is none.
                    let is_drawn = self.teller.draws(sheet);
                    let band = if is_drawn { self.band(name, &unit, None) } else { String::new() };
                    format!("{name} = {} {unit}{band}", self.digits(*value))
                }));
                lines
            }
            Action::Center(id) => {
                let sine = self.teller.sine_of_center(*id).filter(|sine| *sine > 0.0);
                let first = std::iter::once(equation).chain(sine.map(|sine| self.crossing(sine)));
                first.chain(step.names().iter().filter_map(|name| self.read(name, sheet))).collect()
            }
            Action::Curvature { step: CurvatureStep::InflectionPoint | CurvatureStep::InflectionPole, .. } => {
                let read = step.names();
                let read = read.iter().filter_map(|name| self.read(name, sheet));
                [equation].into_iter().filter(|line| !line.is_empty()).chain(read).collect()
            }
            Action::RateByCenters { .. }
            | Action::RateBySlide { .. }
            | Action::VelocityByCenters(_)
            | Action::Curvature { .. }
            | Action::Force(_)
            | Action::Lever(_)
            | Action::Speeds(_) => {
                if let (Action::Force(_), Some(force)) = (step.action, self.teller.force_of_step(step.action)) {
                    let names = step.names();
                    let band = names
                        .first()
                        .map_or_else(String::new, |name| self.band(name, &self.unit(sheet), self.pencil.scales[sheet]));
                    return vec![format!("{equation} = {}{band}", self.vector(force, sheet))];
                }
                if equation.is_empty() {
                    return Vec::new();
                }
                if matches!(step.action, Action::Force(_) | Action::Lever(_) | Action::Speeds(_)) {
                    return self.of_forces(step, equation);
                }
                let names = step.names();
                // The distances that are measured for it come before it, the direction of a velocity after it.
                let is_length = |name: &&String| {
                    QuantityName::parse(name).is_some_and(|name| matches!(name.head, Head::Between(_)))
                };
                let (measured, found): (Vec<&String>, Vec<&String>) = names.iter().partition(is_length);
                let value = self.teller.value_of_step(step.action).map(|(value, kind)| {
                    let unit = kind.unit(self.units);
                    let band = found.first().map_or_else(String::new, |name| self.band(name, &unit, None));
                    format!(" = {} {unit}{band}", self.digits(value))
                });
                let further = found.iter().skip(1).filter_map(|name| self.read(name, sheet));
                let measured = measured.iter().filter_map(|name| self.read(name, sheet));
                measured.chain([equation + &value.unwrap_or_default()]).chain(further).collect()
            }
            // Other steps have neither equation nor value.
            _ => Vec::new(),
        }
    }
}
