use super::centers::CenterResult;
use super::contacts::ContactResult;
use super::forces::ForcesResult;
use super::pencil::PencilResult;
use super::points::{PointResult, points};
use crate::accuracy::says::{pulls, unbounded};
use crate::accuracy::{Bounds, bounds};
use crate::construction::Solution;
use crate::cycle::{told_engagement, told_turning_back};
use crate::drawing::FigureSheets;
use crate::geometry::degrees_of;
use crate::mechanism::{BodyId, Role};
use crate::quantity::{Quantity, QuantityRequest, measured_names};
use crate::scene::{ForceUnit, MassUnit, SceneError, Units};
use crate::sheet::Order;
use crate::words::{Medium, Wording};
use indexmap::IndexMap;
use serde::Serialize;

/// The result of `kinegon solve`: every number at full precision, in the scene's units.
///
/// A `…_error` bounds the whole error of the number beside it, against what follows exactly from the numbers of the
/// scene as they are written: positions found from lengths, drive angles found from a link's angle, rounded turns per
/// minute and roundings of every kind count in. Of a vector it bounds each component. It is zero for a number that the
/// scene gives, and null where no bound can be proved: at a limit position or a singular one.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ResultFile {
    /// Version of this format.
    pub kinegon: u32,
    /// The scene's units; rates are in rad per unit of time, angles in degrees.
    pub units: ResultUnits,
    /// By link name.
    pub links: IndexMap<String, LinkResult>,
    /// By point name; also special points (`S3`) and the points of guides under sliders (`D_2`).
    pub points: IndexMap<String, PointResult>,
    /// By slider name, as in `3/2`; of further sliders between the same two, in scene order, `3/2#2`.
    pub sliders: IndexMap<String, SliderResult>,
    /// Whether all errors of this file are proved; see `groups`.
    pub proved: bool,
    /// The Assur groups in solving order.
    pub groups: Vec<GroupResult>,
    /// The quantities that the scene's `want` asks for.
    pub quantities: IndexMap<String, QuantityResult>,
    /// By quantity name: bound on its error, of a vector that of each component, of an angle in degrees.
    #[cfg_attr(feature = "schemas", schemars(with = "IndexMap<String, Option<f64>>"))]
    pub quantity_errors: IndexMap<String, f64>,
    /// What joints carry and drives need; only of a scene with loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub forces: Option<ForcesResult>,
    /// By the bodies that touch, as `1/3`; of further contacts of the same two, `1/3#2`.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub contacts: IndexMap<String, ContactResult>,
    /// By name, as in `P(1,3)`: the instant centres that the scene's `want` asks for; null where the links rest on one another, or no place can be found.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub centers: IndexMap<String, Option<CenterResult>>,
    /// How far hand drawings are from these numbers; only where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pencil: Option<PencilResult>,
    /// What the reader should know of these numbers.
    pub warnings: Vec<String>,
    /// Links and sliders that stop and turn back in this position; the part of a turn in which a slot is engaged.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// Units of the numbers.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ResultUnits {
    /// Unit of length.
    pub length: &'static str,
    /// Unit of time.
    pub time: &'static str,
    /// Unit of mass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<&'static str>,
    /// Unit of force; moments are in force · length.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<&'static str>,
}

impl ResultUnits {
    fn of(units: Units) -> ResultUnits {
        ResultUnits {
            length: units.length.as_str(),
            time: units.time.as_str(),
            mass: units.mass.map(MassUnit::as_str),
            force: units.force.map(ForceUnit::as_str),
        }
    }
}

/// The motion of a link.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct LinkResult {
    /// Angle of its axis from +x in degrees, in (−180, 180].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Bound on the error of `angle`, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle_error: Option<f64>,
    /// Angular velocity, counter-clockwise positive.
    pub omega: f64,
    /// Bound on the error of `omega`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub omega_error: f64,
    /// Bound on its error where the positions of this file and the rates of the scene count as exact.
    pub omega_error_at_position: f64,
    /// Angular acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha: Option<f64>,
    /// Bound on the error of `alpha`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_error: Option<f64>,
    /// Bound on its error where the positions of this file and the rates of the scene count as exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_error_at_position: Option<f64>,
}

/// The motion of a slider along its guide, seen from the body that carries the guide.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SliderResult {
    /// The body that carries the guide.
    pub on: String,
    /// Its position along the guide, counted from the guide's `through`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<f64>,
    /// Bound on the error of `position`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position_error: Option<f64>,
    /// Whether the guide holds it there; only of a guide with ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub engaged: Option<bool>,
    /// Sliding velocity, positive along the guide.
    pub velocity: f64,
    /// Bound on the error of `velocity`.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub velocity_error: f64,
    /// Bound on its error where the positions of this file and the rates of the scene count as exact.
    pub velocity_error_at_position: f64,
    /// Sliding acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Bound on the error of `acceleration`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_error: Option<f64>,
    /// Bound on its error where the positions of this file and the rates of the scene count as exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_error_at_position: Option<f64>,
    /// Coriolis acceleration 2 ω ẑ × v_r, a vector.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coriolis: Option<[f64; 2]>,
    /// Bound on the error of both components of `coriolis`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coriolis_error: Option<f64>,
}

/// An Assur group and how well its motion is determined.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GroupResult {
    /// Its links.
    pub links: Vec<String>,
    /// Its class, a Roman numeral.
    pub class: &'static str,
    /// Kinds of its joints, R revolute or P prismatic; of a fourth-class group B C D E F G.
    pub joints: String,
    /// Its special points.
    pub special_points: Vec<String>,
    /// Condition number of its loop equations, at least 1: errors of the vectors between its joints, each in parts of itself, grow by about
    /// this factor at most in its rates, each counted with the size of its link, in parts of the largest. A place's error is a large part of
    /// a short vector, and the rate of a short link alone may lose more: its bound says how much.
    pub condition: f64,
    /// The largest difference between the two routes to its rates, relative to the largest rate; `null`, never left out, where a
    /// special point at infinity or a higher class leaves only one route.
    pub disagreement: Option<f64>,
    /// The difference that rounding and the crossings' angles allow; `null` together with `disagreement`.
    pub disagreement_allowed: Option<f64>,
    /// Whether its errors are proved: that one and only one assembly of it lies within those of its places, and that its rates lie within
    /// theirs. Where nothing is proved its errors are `null`.
    pub proved: bool,
    /// Number of this assembly mode; none in a drawn configuration. Where a link's angle is given in place of a drive's, it is that of
    /// the whole mechanism.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mode: Option<usize>,
    /// How many assembly modes there are; of a group of higher class, how many were found. None where there are too many to count.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub modes: Option<usize>,
    /// How many assembly modes it can have at most, as far as that is known: of links joined by pins alone as many as there are complex ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_most: Option<u64>,
    /// Whether it has assemblies besides in which it may move at fixed drives; these are no modes. Left out where none was found.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub may_move: bool,
}

/// The value of a quantity: a number, or a vector.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
#[non_exhaustive]
pub enum QuantityResult {
    /// A number.
    Number(f64),
    /// Components along x and y.
    Vector([f64; 2]),
}

/// The JSON Schema (draft 2020-12) of the result file.
#[must_use]
pub fn result_schema() -> serde_json::Value {
    crate::scene::schema!("result", ResultFile)
}

impl Solution {
    /// The result file's content, without `quantities`.
    #[must_use]
    pub fn result(&self) -> ResultFile {
        self.result_within(&self.bounds())
    }

    fn bounds(&self) -> Bounds<'_> {
        bounds(&self.scene, &self.mechanism, &self.pose, &self.motion).with_plans(&self.construction)
    }

    fn result_within(&self, bounds: &Bounds<'_>) -> ResultFile {
        let Solution { scene, mechanism, pose, motion, construction, .. } = self;
        let second = |value: f64| (motion.order == Order::Acceleration).then_some(value);
        let links = mechanism.links().filter(|(_, body)| body.role != Role::Unsolved).map(|(id, body)| {
            let (rates, at_position) = (motion.body(id), motion.errors[id.0]);
            let [omega_error, alpha_error] = bounds.angular_rates(id);
            let link = LinkResult {
                angle: pose.axes[id.0].map(degrees_of),
                angle_error: bounds.angle(id),
                omega: rates.omega,
                omega_error,
                omega_error_at_position: at_position.omega,
                alpha: second(rates.alpha),
                alpha_error: second(alpha_error),
                alpha_error_at_position: second(at_position.alpha),
            };
            (body.name.clone(), link)
        });
        let sliders = mechanism.slider_ids().map(|id| {
            let (slider, slide) = (mechanism.slider(id), motion.slide(id));
            let [velocity_error, acceleration_error] = bounds.slide(id);
            let result = SliderResult {
                on: mechanism.body(slider.on).name.clone(),
                position: pose.slides[id.0],
                position_error: bounds.slide_position(id),
                engaged: slider.travel.and(pose.slides[id.0]).map(|at| slider.beyond(at).is_none()),
                velocity: slide.velocity,
                velocity_error,
                velocity_error_at_position: slide.velocity_error,
                acceleration: second(slide.acceleration),
                acceleration_error: second(acceleration_error),
                acceleration_error_at_position: second(slide.acceleration_error),
                coriolis: second(0.0).map(|_| motion.coriolis(pose, id, slider.on).into()),
                coriolis_error: second(bounds.coriolis(id)),
            };
            (mechanism.slider_name(id), result)
        });
        let groups = mechanism.groups.iter().enumerate().map(|(index, group)| {
            let name = |&b: &BodyId| mechanism.body(b).name.clone();
            let agreement = construction.agreement[index];
            let special = construction.special.iter().filter(|special| special.group == index && special.is_assur);
            GroupResult {
                links: group.bodies.iter().map(name).collect(),
                class: group.class.numeral(),
                joints: group.pattern(mechanism),
                special_points: special.map(|special| special.name.clone()).collect(),
                condition: motion.conditions[index],
                disagreement: agreement.map(|a| a.difference),
                disagreement_allowed: agreement.map(|a| a.allowed),
                proved: bounds.is_proved(index),
                mode: pose.assemblies[index].map(|a| a.mode),
                modes: pose.assemblies[index].map(|a| a.modes),
                at_most: pose.assemblies[index].and_then(|a| a.at_most),
                may_move: pose.assemblies[index].is_some_and(|a| a.may_move),
            }
        });
        let forces = self.forces();
        let contacts = ContactResult::all(self, forces.as_ref(), bounds);
        let pulling = contacts.iter().filter(|(_, contact)| contact.pulls()).map(|(name, _)| pulls(name).to_string());
        let pulling: Vec<String> = pulling.collect();
        ResultFile {
            kinegon: 1,
            units: ResultUnits::of(scene.units),
            links: links.collect(),
            points: points(self, bounds),
            sliders: sliders.collect(),
            proved: (0..mechanism.groups.len()).all(|group| bounds.is_proved(group)),
            groups: groups.collect(),
            quantities: IndexMap::new(),
            quantity_errors: IndexMap::new(),
            forces: forces.map(|forces| ForcesResult::new(self, &forces, bounds)),
            contacts,
            centers: IndexMap::new(),
            pencil: None,
            warnings: self.warnings().chain(bounds.warnings().iter().map(ToString::to_string)).chain(pulling).collect(),
            notes: told_turning_back(self, &Wording::default())
                .into_iter()
                .chain(told_engagement(self, &Wording::default(), Medium::Text))
                .collect(),
        }
    }

    /// The result file's content with the quantities that the scene wants, or all that the construction measures if it
    /// wants none in particular.
    ///
    /// # Errors
    /// A quantity that is wanted has no value; the place is its place in the scene.
    pub fn whole_result(&self) -> Result<ResultFile, SceneError> {
        let bounds = self.bounds();
        let mut result = self.result_within(&bounds);
        let names = self.scene.want.clone().unwrap_or_else(|| measured_names(&self.construction));
        let on_paper = names.iter().any(|name| name.ends_with("/mu"));
        let scales = on_paper.then(|| FigureSheets::new(self).scales());
        for (index, name) in names.iter().enumerate() {
            let found = QuantityRequest::new(name, &self.mechanism).and_then(|asked| {
                let center = CenterResult::of(&asked, &bounds);
                let valued = bounds.valued(&asked, scales.as_ref());
                Ok((center, if center.is_some() { valued.ok() } else { Some(valued?) }))
            });
            let (center, valued) = found.map_err(|error| {
                let path = ["want", &index.to_string()];
                self.scene.error_at(&path, error.problem().message, None)
            })?;
            if let Some(center) = center {
                result.centers.insert(name.clone(), center);
            }
            let Some((value, error)) = valued else { continue };
            let value = match value {
                Quantity::Number(x) => QuantityResult::Number(x),
                Quantity::Vector(v) => QuantityResult::Vector([v.x, v.y]),
            };
            result.quantities.insert(name.clone(), value);
            result.quantity_errors.insert(name.clone(), error);
        }
        // Where nothing is proved that has been said.
        let bounded = |error: &f64| error.is_finite();
        let quantities = result.quantity_errors.iter().filter(|(_, error)| !bounded(error)).map(|(name, _)| name);
        let points = result.points.iter().filter(|(_, point)| !point.position_error.iter().all(bounded));
        let names: Vec<&str> = points.map(|(name, _)| name).chain(quantities).map(String::as_str).collect();
        if result.proved && !names.is_empty() {
            result.warnings.push(unbounded(names.join(", ")).to_string());
        }
        Ok(result)
    }
}
