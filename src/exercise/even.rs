//! Loads that are more alike: where some forces of a scene are too small beside others to be drawn with them, its loads change by powers of two,
//! and gravity is left out, until its polygons can be drawn; what changes is told.

use super::forces::ratio;
use super::vary::{OnGuide, varied};
use crate::construction::{Solution, display, plain_text};
use crate::editing::measure::json as json_number;
use crate::geometry::Random;
use crate::mechanism::mechanism;
use crate::position::{pose, with_nearest_sides};
use crate::scene::{Figure, Scene};
use crate::sheet::Order;
use serde_json::Value;

/// Variants of a scene whose polygons are looked at.
const SEEN: usize = 5;
/// Largest force over the smallest with which variants are drawn, too.
const EVEN: f64 = 16.0;
/// Most rounds in which one number after another is changed.
const ROUNDS: usize = 12;
/// Most numbers of which combinations are tried: each round solves variants for each of them.
const MOST_KNOBS: usize = 16;
/// What a change by a factor of two costs, in the logarithm of that ratio: of what is given for its own sake, more.
const COST: f64 = 0.05;
const COST_OF_LOAD: f64 = 0.3;

/// A number of the scene's loads, or several that go together.
#[derive(Clone, Debug, PartialEq)]
enum Knob {
    /// Mass or weight and moment of inertia of a link.
    Mass(String),
    /// The force of a load, or its couple.
    Load(usize, &'static str),
    /// The rates of all drives: accelerations by the square.
    Rates,
    /// Gravity, which is there or not.
    Gravity,
}

/// A scene with its loads changed.
#[derive(Clone, Debug)]
struct Changed<'a> {
    base: &'a Value,
    on_guides: &'a [OnGuide],
    figure: &'a Figure,
    /// What is changed, each with its exponent of two; of gravity any says that it is left out.
    by: Vec<(Knob, i32)>,
}

/// The scene with loads that are more alike, and what has changed, in symbols; `None` where its polygons stay too unequal, or it
/// has more than 16 loads. Of the ways with gravity
/// and without, the one that changes less.
pub(super) fn evened(base: &Value, on_guides: &[OnGuide], figure: &Figure) -> Option<(Value, String)> {
    let knobs = knobs(base);
    if knobs.len() > MOST_KNOBS {
        return None;
    }
    let starts = if knobs.contains(&Knob::Gravity) { 0..=1 } else { 0..=0 };
    let found = starts.filter_map(|start| {
        let by = knobs.iter().map(|knob| (knob.clone(), if *knob == Knob::Gravity { start } else { 0 })).collect();
        Changed { base, on_guides, figure, by }.evened()
    });
    let best = found.min_by(|a, b| a.cost().total_cmp(&b.cost()))?;
    Some((best.scene(), best.told()))
}

/// All that may change.
fn knobs(base: &Value) -> Vec<Knob> {
    let links = base["links"].as_object().into_iter().flatten();
    let heavy = links.filter(|(_, link)| !link["mass"].is_null() || !link["weight"].is_null());
    let has_weights = heavy.clone().any(|(_, link)| !link["weight"].is_null());
    let loads = base["forces"].as_array().into_iter().flatten().enumerate();
    let of_load = |(index, load): (usize, &Value)| {
        ["force", "couple"]
            .into_iter()
            .filter(|key| !load[*key].is_null())
            .map(move |key| Knob::Load(index, key))
            .collect::<Vec<_>>()
    };
    let mut knobs: Vec<Knob> = heavy.clone().map(|(link, _)| Knob::Mass(link.clone())).collect();
    knobs.extend(loads.flat_map(of_load));
    if heavy.clone().count() > 0 && base["analysis"] != "static" {
        knobs.push(Knob::Rates);
    }
    // Weights in place of masses need it.
    if !base["gravity"].is_null() && !has_weights {
        knobs.push(Knob::Gravity);
    }
    knobs
}

impl Knob {
    /// The steps by which its exponent changes.
    fn steps(&self) -> impl Iterator<Item = i32> + use<> {
        let steps: &[i32] = if *self == Knob::Gravity { &[1] } else { &[-2, -1, 1, 2] };
        steps.iter().copied()
    }

    /// What a step of one costs.
    fn cost(&self) -> f64 {
        if matches!(self, Knob::Load(..)) { COST_OF_LOAD } else { COST }
    }

    fn change(&self, scene: &mut Value, exponent: i32) {
        let factor = libm::exp2(f64::from(exponent));
        match self {
            Knob::Mass(link) => {
                let link = scene["links"].get_mut(link).and_then(Value::as_object_mut);
                let keys = link.into_iter().flatten();
                keys.filter(|(key, _)| ["mass", "weight", "inertia"].contains(&key.as_str()))
                    .for_each(|(_, value)| times(value, factor));
            }
            Knob::Load(index, key) => {
                if let Some(value) = scene["forces"].get_mut(index).and_then(|load| load.get_mut(*key)) {
                    times(value, factor);
                }
            }
            Knob::Rates => {
                let links = scene.get_mut("links").and_then(Value::as_object_mut);
                links.into_iter().flat_map(|links| links.values_mut()).for_each(|link| drive_times(link, factor));
                let sliders = scene.get_mut("sliders").and_then(Value::as_array_mut);
                sliders.into_iter().flatten().for_each(|slider| drive_times(slider, factor));
            }
            Knob::Gravity => {
                scene.as_object_mut().and_then(|scene| scene.shift_remove("gravity"));
            }
        }
    }

    /// It in symbols, as `m_2 × 4`.
    fn told(&self, scene: &Value, exponent: i32) -> String {
        let by = if exponent < 0 { format!("/ {}", 1 << -exponent) } else { format!("× {}", 1 << exponent) };
        match self {
            Knob::Mass(link) => format!("m_{link} {by}"),
            Knob::Load(index, _) => {
                let load = &scene["forces"][*index];
                let usual = || {
                    format!(
                        "{} {}",
                        if load["force"].is_null() { "M" } else { "F" },
                        load["on"].as_str().unwrap_or_default()
                    )
                };
                let name = load["name"].as_str().map_or_else(usual, |name| plain_text(&display(name)));
                format!("{name} {by}")
            }
            Knob::Rates => format!("ω {by}"),
            Knob::Gravity => "g = 0".to_owned(),
        }
    }
}

impl Changed<'_> {
    /// Changed further, by what helps most, until its polygons can be drawn.
    fn evened(self) -> Option<Self> {
        let mut best = self;
        let mut unequal = best.unequal()?;
        for _ in 0..ROUNDS {
            if unequal <= libm::log2(EVEN) {
                return Some(best);
            }
            let others = (0..best.by.len()).flat_map(|knob| best.by[knob].0.steps().map(move |step| (knob, step)));
            let tried = others.filter_map(|(knob, step)| {
                let mut other = best.clone();
                other.by[knob].1 += step;
                let unequal = other.unequal()?;
                Some((unequal + best.by[knob].0.cost() * f64::from(step.abs()), unequal, other))
            });
            let (value, found, other) = tried.min_by(|(a, ..), (b, ..)| a.total_cmp(b))?;
            if value >= unequal {
                return None;
            }
            (unequal, best) = (found, other);
        }
        None
    }

    /// What all changes cost.
    fn cost(&self) -> f64 {
        self.by.iter().map(|(knob, exponent)| knob.cost() * f64::from(exponent.abs())).sum()
    }

    fn scene(&self) -> Value {
        let mut scene = self.base.clone();
        let changed = self.by.iter().filter(|(_, exponent)| *exponent != 0);
        changed.for_each(|(knob, exponent)| knob.change(&mut scene, *exponent));
        scene
    }

    fn told(&self) -> String {
        let changed = self.by.iter().filter(|(_, exponent)| *exponent != 0);
        changed.map(|(knob, exponent)| knob.told(self.base, *exponent)).collect::<Vec<_>>().join(", ")
    }

    /// The logarithm to base two of the largest force over the smallest, on an average of variants; `None` where none is a mechanism.
    fn unequal(&self) -> Option<f64> {
        let scene = self.scene();
        let mut random = Random(0);
        let variants = (0..SEEN).map(|_| varied(&scene, self.on_guides, &mut random));
        let ratios: Vec<f64> = variants.filter_map(|variant| self.ratio(&variant)).map(libm::log2).collect();
        let average = ratios.iter().sum::<f64>() / ratios.len() as f64;
        (!ratios.is_empty()).then_some(average)
    }

    fn ratio(&self, variant: &Value) -> Option<f64> {
        let mut scene = Scene::read(&variant.to_string()).ok()?;
        scene.figure = self.figure.clone();
        let mechanism = with_nearest_sides(&scene, mechanism(&scene).ok()?);
        let pose = pose(&mechanism, &scene.near).ok()?;
        ratio(&Solution::new(scene, mechanism, pose, Order::Acceleration).ok()?.construction)
    }
}

/// Multiplies a number, or all of a vector but for its direction.
fn times(value: &mut Value, factor: f64) {
    match value {
        Value::Number(number) => *value = json_number(number.as_f64().unwrap_or(0.0) * factor),
        Value::Array(numbers) => numbers.iter_mut().for_each(|number| times(number, factor)),
        Value::Object(keys) => keys.get_mut("size").into_iter().for_each(|size| times(size, factor)),
        _ => {}
    }
}

/// Multiplies the rates of a drive, its acceleration by the square.
fn drive_times(driven: &mut Value, factor: f64) {
    for (key, value) in driven.get_mut("drive").and_then(Value::as_object_mut).into_iter().flatten() {
        match key.as_str() {
            "omega" | "rpm" | "speed" => times(value, factor),
            "alpha" | "acceleration" => times(value, factor * factor),
            _ => {}
        }
    }
}
