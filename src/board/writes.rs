//! Kinegon's own construction as a drawing: for demonstrations, and as the key of an exercise.

use super::bench::is_size_of_force;
use super::given::Given;
use super::polygons::pitch_name;
use crate::construction::{
    Along, Construction, LineId, MeasuredAs, NumberId, NumberKind, Operation, OperationKind, OperationRole, PlaceId,
    Product, Reference,
};
use crate::forces::Source;
use crate::geometry::{Vector, unit};
use crate::mechanism::Mechanism;
use crate::scene::Head;
use crate::sheet::{PerSheet, Scales, Sheet};
use indexmap::{IndexMap, IndexSet};
use serde_json::{Map, Value as Json, json};

/// Kinegon's construction of a scene as the text of a drawing, an entry on each line.
#[must_use]
pub fn own_drawing(given: &Given, scales: &Scales) -> String {
    let mut writer = Writer::new(given);
    let construction = given.construction();
    let is_drawn = |operation: &&Operation| {
        // Numbers that the scene gives are there whatever is drawn.
        construction.by_hand.contains(&operation.sheet) || matches!(operation.kind, OperationKind::Take { .. })
    };
    for operation in construction.operations.iter().filter(is_drawn) {
        writer.write(operation.sheet, operation.role, &operation.kind, operation.step.is_some());
    }
    let mut head = Map::new();
    head.insert("kinegon_drawing".to_owned(), json!(1));
    scales.given().for_each(|(sheet, mu)| drop(head.insert(sheet.facts().scale_key.to_owned(), json!(mu))));
    let head = Json::Object(head).to_string();
    let did: Vec<String> = writer.did.iter().map(|entry| format!("    {entry}")).collect();
    format!("{},\n  \"did\": [\n{}\n  ]\n}}\n", head.trim_end_matches('}'), did.join(",\n"))
}

struct Writer<'g> {
    given: &'g Given,
    construction: &'g Construction,
    mechanism: &'g Mechanism,
    values: crate::construction::Values,
    /// By place: its sheet and name.
    places: IndexMap<PlaceId, (Sheet, String)>,
    /// By line: what gives its direction, and its name if it is drawn.
    lines: IndexMap<LineId, (String, Option<String>)>,
    /// Lines that are crossed or to which others are drawn: the others need no drawing.
    crossed: IndexSet<LineId>,
    /// By number: how a formula writes it.
    numbers: IndexMap<NumberId, String>,
    /// Names of numbers that have been given, with the values that the drawing has of them.
    named: IndexMap<String, f64>,
    did: Vec<Json>,
    /// How many points and measured numbers have names of their own.
    own: usize,
    measured: usize,
}

impl<'g> Writer<'g> {
    fn new(given: &'g Given) -> Writer<'g> {
        let construction = given.construction();
        let mut places = IndexMap::new();
        let of_load = |role: &OperationRole| match role {
            OperationRole::Load(load) => given.load_places.get(*load).cloned(),
            OperationRole::Pitch(mesh) => Some(pitch_name(given.mechanism(), *mesh)),
            _ => None,
        };
        for (sheet, name, place) in construction.named_places() {
            places.entry(place).or_insert((sheet, name.to_owned()));
        }
        let mut crossed = IndexSet::new();
        for operation in &construction.operations {
            if let (Some(place), Some(name)) = (operation.kind.place(), of_load(&operation.role)) {
                places.entry(place).or_insert((Sheet::Scheme, name));
            }
            if let OperationKind::Cross { lines, .. } = operation.kind {
                crossed.extend(lines);
            }
        }
        Writer {
            construction,
            mechanism: given.mechanism(),
            values: construction.run(PerSheet::from_fn(|_| 1.0), &[]),
            places,
            lines: IndexMap::new(),
            crossed,
            numbers: IndexMap::new(),
            named: IndexMap::new(),
            given,
            did: Vec::new(),
            own: 0,
            measured: 0,
        }
    }

    /// The name of a place; one without gets one of its own.
    fn place(&mut self, sheet: Sheet, place: PlaceId) -> String {
        if let Some((_, name)) = self.places.get(&place) {
            return name.clone();
        }
        self.own += 1;
        let name = format!("h{}", self.own);
        self.places.insert(place, (sheet, name.clone()));
        name
    }

    fn write(&mut self, sheet: Sheet, role: OperationRole, kind: &OperationKind, in_step: bool) {
        match kind {
            // The last two no construction has.
            OperationKind::Pole { .. }
            | OperationKind::Plot { .. }
            | OperationKind::Meet { .. }
            | OperationKind::OnLine { .. } => {}
            OperationKind::Join { line, from, towards } => self.join(sheet, *line, [*from, *towards], role),
            OperationKind::Draw { line, through, along } => self.draw(sheet, *line, *through, along, role),
            OperationKind::Cross { place, lines } => {
                let lines =
                    lines.map(|line| self.lines.get(&line).and_then(|(_, name)| name.clone()).unwrap_or_default());
                let point = self.place(sheet, *place);
                self.did.push(json!({ "cross": point, "of": lines }));
            }
            OperationKind::Divide { place, ends, like } => {
                let ends = ends.map(|end| self.place(sheet, end));
                let points = like.map(|point| self.place(Sheet::Scheme, point));
                let point = self.place(sheet, *place);
                self.did.push(json!({ "like": point, "on": sheet.as_str(), "ends": ends, "points": points }));
            }
            OperationKind::LayOff { place, from, size, along } => {
                let (along, sign) = self.direction(along);
                let size = self.numbers.get(size).cloned().unwrap_or_default();
                let size = if sign < 0.0 { negative(&size) } else { size };
                let (from, to) = (self.place(sheet, *from), self.place(sheet, *place));
                self.did
                    .push(json!({ "lay_off": to, "on": sheet.as_str(), "from": from, "size": size, "along": along }));
            }
            OperationKind::Measure { number, from, to, how } => {
                self.measure(sheet, *number, [*from, *to], *how, in_step)
            }
            // The board has no tool for it; a form asks for it.
            OperationKind::ReadDirection { .. } => {}
            OperationKind::Take { number, value } => self.take(*number, *value),
            OperationKind::Compute { number, sum } => self.compute(*number, sum),
            OperationKind::Solve { unknowns, equations } => {
                let names: Vec<String> = unknowns
                    .iter()
                    .map(|number| {
                        let name = self.construction.number_name(self.mechanism, *number);
                        if name.is_empty() { self.own_number() } else { name }
                    })
                    .collect();
                let equations: Vec<String> = equations
                    .iter()
                    .map(|equation| {
                        let left: Vec<String> = equation
                            .left
                            .iter()
                            .map(|(unknown, product)| format!("{} * {}", self.product(product), names[*unknown]))
                            .collect();
                        format!("{} = {}", sum_of(&left), self.sum(&equation.right))
                    })
                    .collect();
                self.did.push(json!({ "solve": names, "equations": equations }));
                for (number, name) in unknowns.iter().zip(&names) {
                    self.numbers.insert(*number, name.clone());
                    self.named.insert(name.clone(), self.values.number(*number));
                }
            }
        }
    }

    fn join(&mut self, sheet: Sheet, line: LineId, ends: [PlaceId; 2], role: OperationRole) {
        let ends = ends.map(|end| self.place(sheet, end));
        let along = match role {
            OperationRole::Guide(slider) => self.mechanism.slider_name(slider),
            _ => ends.join(","),
        };
        let name = self.drawn(line);
        if let Some(name) = &name {
            self.did.push(json!({ "join": name, "on": sheet.as_str(), "points": ends }));
        }
        self.lines.insert(line, (along, name));
    }

    fn draw(&mut self, sheet: Sheet, line: LineId, through: PlaceId, along: &Along, role: OperationRole) {
        let (along, _) = self.direction(along);
        let through = self.place(sheet, through);
        let name = self.drawn(line);
        if let Some(name) = &name {
            let along = match role {
                // A guide needs no other line to be drawn.
                OperationRole::Guide(slider) => json!({ "parallel": self.mechanism.slider_name(slider) }),
                _ => along,
            };
            self.did.push(json!({ "line": name, "on": sheet.as_str(), "through": through, "along": along }));
        }
        let reference = match role {
            OperationRole::Guide(slider) => self.mechanism.slider_name(slider),
            _ => name.clone().unwrap_or_default(),
        };
        self.lines.insert(line, (reference, name));
    }

    /// The name of a line that is to be drawn.
    fn drawn(&mut self, line: LineId) -> Option<String> {
        self.crossed.contains(&line).then(|| {
            let count = self.lines.values().filter(|(_, name)| name.is_some()).count();
            format!("r{}", count + 1)
        })
    }

    /// A direction, and the sign that sizes along it get.
    fn direction(&self, along: &Along) -> (Json, f64) {
        let reference =
            |line: &LineId| self.lines.get(line).map_or_else(String::new, |(reference, _)| reference.clone());
        let turns = along.quarter_turns % 4;
        let sign = if turns < 2 { 1.0 } else { -1.0 };
        let json = match &along.reference {
            Reference::Line(line) if turns.is_multiple_of(2) => json!({ "parallel": reference(line) }),
            Reference::Line(line) => json!({ "normal": reference(line) }),
            Reference::Angle { base, from, to } => {
                json!({ "turned": [reference(from), reference(to)], "base": reference(base) })
            }
            Reference::Given(direction) => {
                if let Some(load) = self.load_along(*direction) {
                    let along = if turns.is_multiple_of(2) { "parallel" } else { "normal" };
                    return (json!({ along: load }), sign);
                }
                let degrees = crate::geometry::degrees_of(*direction) + 90.0 * f64::from(turns % 2);
                json!({ "angle": degrees })
            }
        };
        (json, sign)
    }

    /// The name of a load whose force has a direction.
    fn load_along(&self, direction: Vector) -> Option<String> {
        let plan = self.construction.forces.as_deref()?;
        let is_it = |force: &Vector| unit(*force).is_some_and(|along| (along - direction).norm() <= 1e-12);
        let load = plan.loads.iter().find(|load| is_it(&load.force))?;
        Some(load.name(self.mechanism))
    }

    /// How a load's size, or the couple of a link's inertia, is written; a couple that somebody has stated is its number.
    fn load_number(&self, number: NumberId) -> Option<String> {
        let plan = self.construction.forces.as_deref()?;
        let index = plan.numbers.loads.iter().position(|own| own.contains(&Some(number)))?;
        let load = plan.loads.get(index)?;
        if plan.numbers.loads[index][0] == Some(number) {
            return Some(load.name(self.mechanism));
        }
        let is_inertia = load.source == Source::Inertia;
        is_inertia.then(|| Head::InertiaCouple.of(&self.mechanism.body(load.body).name))
    }

    /// A name for a number that has none, as an arm or the force between teeth.
    fn own_number(&mut self) -> String {
        self.measured += 1;
        format!("m{}", self.measured)
    }

    fn measure(&mut self, sheet: Sheet, number: NumberId, ends: [PlaceId; 2], how: MeasuredAs, in_step: bool) {
        // What is only read belongs to no step, and no formula needs it.
        if !matches!(how, MeasuredAs::Size | MeasuredAs::Along(_))
            || matches!(self.construction.numbers[number.0], NumberKind::Reading(_))
        {
            return;
        }
        let mut name = self.construction.number_name(self.mechanism, number);
        if name.is_empty() {
            name = self.own_number();
        }
        let value = self.values.number(number);
        // The force in a joint is needed even where a side of the polygon is all of it, which no step joins.
        let is_force = self.construction.numbers[number.0] == NumberKind::Force;
        if (in_step || is_force) && !self.named.contains_key(&name) {
            let ends = match how {
                MeasuredAs::Along(line) if sheet == Sheet::Forces => self.along(line, ends, value),
                _ => ends.map(|end| self.place(sheet, end)),
            };
            // A distance has no sign; one along a line has.
            self.named.insert(name.clone(), value.abs());
            let [from, to] = ends;
            self.did.push(json!({ "measure": name, "on": sheet.as_str(), "from": from, "to": to }));
        }
        let is_turned = self.named.get(&name).map_or(value < 0.0, |known| known.is_sign_negative() != (value < 0.0));
        let written = if is_turned { format!("(-{name})") } else { name };
        self.numbers.insert(number, written);
    }

    /// The ends of the part of a force along a line, which is drawn with the part across where the force has both.
    fn along(&mut self, line: LineId, ends: [PlaceId; 2], value: f64) -> [String; 2] {
        let force = self.values.place(ends[1]) - self.values.place(ends[0]);
        let [from, to] = ends.map(|end| self.place(Sheet::Forces, end));
        if (force.norm() - value.abs()).abs() <= 1e-9 * force.norm() {
            return [from, to];
        }
        let reference = self.lines.get(&line).map_or_else(String::new, |(reference, _)| reference.clone());
        self.own += 1;
        let corner = format!("h{}", self.own);
        let drawn = [(&from, "normal", "across"), (&to, "parallel", "along")].map(|(through, how, word)| {
            let name = format!("{word}{}", self.own);
            self.did.push(json!({ "line": name, "on": "forces", "through": through, "along": { how: reference } }));
            name
        });
        self.did.push(json!({ "cross": corner, "of": drawn }));
        [corner, to]
    }

    fn take(&mut self, number: NumberId, value: f64) {
        let name = self.construction.number_name(self.mechanism, number);
        let of_load = || self.load_number(number);
        let written = if name.is_empty() { of_load().unwrap_or_else(|| written(value)) } else { name };
        self.numbers.insert(number, written);
    }

    fn compute(&mut self, number: NumberId, sum: &[Product]) {
        let formula = self.sum(sum);
        let name = self.construction.number_name(self.mechanism, number);
        if name.is_empty() {
            // Other sums take a moment away.
            let is_moment = self.construction.numbers[number.0] == NumberKind::Moment;
            self.numbers.insert(number, if is_moment && sum.len() > 1 { format!("({formula})") } else { formula });
        } else {
            // A couple that a guide gives the link that carries it is that on the slider, reversed.
            let value = self.values.number(number);
            let is_turned = !is_size_of_force(&name) && self.given.number(&name).is_some_and(|own| own * value < 0.0);
            let formula = if is_turned { negative(&formula) } else { formula };
            self.did.push(json!({ "compute": name, "as": formula }));
            self.numbers.insert(number, if is_turned { format!("(-{name})") } else { name });
        }
    }

    fn sum(&self, sum: &[Product]) -> String {
        let products: Vec<String> = sum.iter().map(|product| self.product(product)).collect();
        sum_of(&products)
    }

    fn product(&self, product: &Product) -> String {
        let mut factors: Vec<String> = Vec::new();
        for number in &product.of {
            let name = self.numbers.get(number).cloned().unwrap_or_default();
            // A rate times itself is its square.
            match factors.last_mut() {
                Some(last) if *last == name => last.push_str("^2"),
                _ => factors.push(name),
            }
        }
        let size = product.factor.abs();
        if size != 1.0 || factors.is_empty() {
            factors.insert(0, written(size));
        }
        let product_text = factors.join(" * ");
        if product.factor < 0.0 { format!("-{product_text}") } else { product_text }
    }
}

fn sum_of(terms: &[String]) -> String {
    let mut sum = String::new();
    for term in terms {
        match term.strip_prefix('-') {
            Some(rest) if !sum.is_empty() => sum.push_str(&format!(" - {rest}")),
            _ if !sum.is_empty() => sum.push_str(&format!(" + {term}")),
            _ => sum.push_str(term),
        }
    }
    if sum.is_empty() { "0".to_owned() } else { sum }
}

fn negative(formula: &str) -> String {
    match formula.strip_prefix('-') {
        Some(rest) if !rest.contains(" + ") && !rest.contains(" - ") => rest.to_owned(),
        _ => format!("-({formula})"),
    }
}

fn written(x: f64) -> String {
    crate::format::json(&x).trim().to_owned()
}
