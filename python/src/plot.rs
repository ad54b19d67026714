//! What of a solution and of its motion is plotted: places, vectors and symbols.

use crate::refused::Refused;
use crate::solution::Solution;
use kinegon::Order;
use kinegon::construction::{PointRole, Teller, VectorPart, display};
use kinegon::cycle::Sweep;
use kinegon::mechanism::Mechanism;
use kinegon::quantity::{QuantityKind, QuantityRequest};
use kinegon::words::Notation;
use serde_json::{Value, json};

/// The symbols of a table's columns in markup, as on figures; empty for bounds of errors.
pub fn symbols(sweep: &Sweep<'_>, mechanism: &Mechanism, notation: &Notation) -> Vec<String> {
    let symbol = |name: &String| {
        // A bound's name is no quantity's.
        let asked = QuantityRequest::new(name, mechanism).ok();
        asked.map(|asked| asked.symbol(mechanism, notation, &display)).unwrap_or_default()
    };
    sweep.header().iter().map(symbol).collect()
}

fn part(part: VectorPart) -> &'static str {
    match part {
        VectorPart::Whole => "whole",
        VectorPart::Relative => "relative",
        VectorPart::Normal => "normal",
        VectorPart::Tangential => "tangential",
        VectorPart::Sliding => "sliding",
        VectorPart::Coriolis => "coriolis",
    }
}

impl Solution {
    /// A plan as JSON: its unit, its points by the markup of their symbols, its vectors with tail, head, what they show and symbol.
    /// Places are in the plan's unit, from the pole.
    pub fn plan_of(&self, order: Order) -> Result<String, Refused> {
        let solution = self.by_hand()?;
        let words = solution.wording();
        let unit = [QuantityKind::Velocity, QuantityKind::Acceleration][order].unit(solution.scene.units);
        let Some(plan) = solution.construction.plan(order) else {
            return Err(Refused::new("KinegonError", "this mechanism has no such plan", None));
        };
        let at = |name: &String| plan.points.get(name).map(|point| [point.vector.x, point.vector.y]);
        let vectors = Teller::new(solution, &words).vectors(plan);
        let is_shown = |name: &String, role: PointRole| {
            matches!(role, PointRole::Pole | PointRole::Known | PointRole::Image)
                || vectors.iter().any(|vector| vector.ends.contains(name))
        };
        let points = plan.points.iter().filter(|(name, point)| is_shown(name, point.role)).map(|(name, point)| {
            let symbol = plan.shown(name, display(name), &words.notation);
            json!({ "symbol": symbol, "at": [point.vector.x, point.vector.y] })
        });
        let points: Vec<Value> = points.collect();
        let vectors = vectors.iter().filter_map(|vector| {
            let [from, to] = [at(&vector.ends[0])?, at(&vector.ends[1])?];
            Some(json!({ "symbol": vector.symbol, "from": from, "to": to, "part": part(vector.part) }))
        });
        let vectors: Vec<Value> = vectors.collect();
        Ok(json!({ "unit": unit, "points": points, "vectors": vectors }).to_string())
    }
}
