use super::contacts::ContactResult;
use super::forces::ForcesResult;
use crate::accuracy::says::{pulls, unbounded};
use crate::accuracy::{Bounds, bounds};
use crate::centers::Center;
use crate::construction::{Solution, coincident_name};
use crate::cycle::{told_engagement, told_turning_back};
use crate::drawing::FigureSheets;
use crate::geometry::{Place, Point, degrees_of};
use crate::mechanism::{BodyId, PointId, Role};
use crate::quantity::{Band, Head, Pencil, Quantity, QuantityRequest, Unread, measured_names};
use crate::scene::{ForceUnit, MassUnit, SceneError, Units};
use crate::sheet::{Order, Scales};
use crate::words::{Medium, Wording};
use indexmap::IndexMap;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde_json::json;

/// The result of `kinegon solve`: every number at full precision, in the scene's units.
///
/// A `…_error` bounds the whole error of the number beside it, against what follows exactly from the numbers of the
/// scene as they are written: positions found from lengths, drive angles found from a link's angle, rounded turns per
/// minute and roundings of every kind count in. Of a vector it bounds each component. It is zero for a number that the
/// scene gives, and null where no bound can be proved: at a limit position or a singular one.
#[derive(Debug, Serialize, JsonSchema)]
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
    #[schemars(with = "IndexMap<String, Option<f64>>")]
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
#[derive(Debug, Serialize, JsonSchema)]
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
#[derive(Debug, Serialize, JsonSchema)]
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
    #[schemars(with = "Option<f64>")]
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

/// The motion of a point.
#[derive(Debug, Default, Serialize, JsonSchema)]
#[non_exhaustive]
pub struct PointResult {
    /// Where it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 2]>,
    /// Bound on the error of both coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position_error: Option<f64>,
    /// The direction in which it lies at infinity, in place of a position.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_infinity: Option<[f64; 2]>,
    /// Its velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<[f64; 2]>,
    /// Bound on the error of both components of `velocity`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_error: Option<f64>,
    /// Its acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<[f64; 2]>,
    /// Bound on the error of both components of `acceleration`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_error: Option<f64>,
    /// The link of which it is a point, where its name does not say so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on: Option<String>,
}

/// The motion of a slider along its guide, seen from the body that carries the guide.
#[derive(Debug, Serialize, JsonSchema)]
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
    #[schemars(with = "Option<f64>")]
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
#[derive(Debug, Serialize, JsonSchema)]
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
}

/// The value of a quantity: a number, or a vector.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
#[non_exhaustive]
pub enum QuantityResult {
    /// A number.
    Number(f64),
    /// Components along x and y.
    Vector([f64; 2]),
}

/// An instant centre: its place, or the direction in which it lies at infinity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
#[non_exhaustive]
pub enum CenterResult {
    /// At a place.
    At {
        /// Its coordinates.
        position: [f64; 2],
        /// Bound of the error of each.
        #[schemars(with = "Option<f64>")]
        error: f64,
    },
    /// At infinity, as far as it is certain.
    AtInfinity {
        /// The direction in which it lies, of length 1.
        at_infinity: [f64; 2],
        /// Bound of the error of that direction, in degrees.
        #[schemars(with = "Option<f64>")]
        angle_error: f64,
        /// How far away it is at least, where it is not at infinity in every position: bounds of rates can tell no more.
        #[serde(skip_serializing_if = "Option::is_none")]
        farther_than: Option<f64>,
    },
}

impl CenterResult {
    /// The result for a whole centre that is asked for; `None` for other quantities. Where no bound can be proved it is the place without one.
    fn of(asked: &QuantityRequest, bounds: &Bounds<'_>) -> Option<Option<CenterResult>> {
        if asked.written.head != Head::Center || !asked.written.is_plain() {
            return None;
        }
        let found = match bounds.center(asked) {
            Some(Center::At { place, error }) => Some(CenterResult::At { position: place.into(), error }),
            Some(Center::AtInfinity { direction, error, beyond }) => Some(CenterResult::AtInfinity {
                at_infinity: direction.into(),
                angle_error: error,
                farther_than: beyond.is_finite().then_some(beyond),
            }),
            Some(_) => None,
            None => match bounds.valued(asked, None) {
                Ok((Quantity::Vector(place), error)) => Some(CenterResult::At { position: place.into(), error }),
                _ => None,
            },
        };
        Some(found)
    }
}

/// How far hand drawings at the figure's scales are from the numbers, by quantity name.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PencilResult {
    /// Limit of the error of a point set, along x and along y, and of a length laid off or measured: millimetres of paper.
    pub mm: f64,
    /// Limit of the error of a direction drawn or read: degrees.
    pub degrees: f64,
    /// The scales of the sheets: units per millimetre of paper.
    #[serde(flatten)]
    #[schemars(schema_with = "scales_schema")]
    pub mu: Scales,
    /// By quantity name: what an honest drawing gives. A vector stands here by its `.size` and its `.angle`.
    pub bands: IndexMap<String, BandResult>,
    /// By quantity name: why a drawing gives no such value. Given values and points at rest are left out.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub without: IndexMap<String, String>,
}

/// What an honest hand drawing gives for a quantity.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BandResult {
    /// Its value, of lengths and segments without a sign.
    pub value: f64,
    /// At least 95 of 100 drawings are at most this far from it.
    pub band: f64,
    /// Unit of both.
    pub unit: String,
    /// Present and true where errors are so large against the quantity that the band is only a rough one.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub rough: bool,
}

fn scales_schema(generator: &mut SchemaGenerator) -> Schema {
    Scales::schema(generator, |sheet| {
        let per_mm = || format!(": {} per millimetre of paper", sheet.facts().scaled_units);
        let units = sheet.order().map_or_else(per_mm, |_| String::new());
        json!({ "description": format!("Scale of the {}{units}.", sheet.name()) })
    })
}

/// The JSON Schema (draft 2020-12) of the result file.
#[must_use]
pub fn result_schema() -> serde_json::Value {
    schemars::schema_for!(ResultFile).to_value()
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

/// All points: joints, points of guides under sliders, special points.
fn points(solution: &Solution, bounds: &Bounds<'_>) -> IndexMap<String, PointResult> {
    let Solution { mechanism, pose, motion, construction, .. } = solution;
    let mut points = IndexMap::new();
    let has_accelerations = motion.order == Order::Acceleration;
    let moving = |body: BodyId, place: Point, on: Option<BodyId>, errors: [f64; 3]| PointResult {
        position: Some([place.x, place.y]),
        position_error: Some(errors[0]),
        velocity: Some(motion.body(body).velocity_at(place).into()),
        velocity_error: Some(errors[1]),
        acceleration: has_accelerations.then(|| motion.body(body).acceleration_at(place).into()),
        acceleration_error: has_accelerations.then_some(errors[2]),
        on: on.map(|b| mechanism.body(b).name.clone()),
        ..PointResult::default()
    };
    let point_of = |body: BodyId, point: PointId, on: Option<BodyId>| {
        let [velocity, acceleration] = bounds.motion_of(body, point);
        moving(body, pose.point(point), on, [bounds.place(point), velocity, acceleration])
    };
    let holders = mechanism.holders();
    for point in mechanism.point_ids() {
        let holders = &holders[point.0];
        // Preferably a body of known motion.
        if let Some(&body) = holders.iter().find(|&&body| mechanism.is_known(body)).or(holders.first()) {
            let name = mechanism.point_name(point).to_owned();
            points.insert(name, point_of(body, point, None));
        }
    }
    for slider in &mechanism.sliders {
        let name = coincident_name(mechanism.point_name(slider.at), &mechanism.body(slider.on).name);
        let under = point_of(slider.on, slider.at, Some(slider.on));
        points.entry(name).or_insert(under);
    }
    for special in construction.special.iter().filter(|s| s.is_assur) {
        let result = match special.place {
            Place::At(place) => {
                let errors = bounds.special(special).unwrap_or_default();
                moving(special.link, place, Some(special.link), errors)
            }
            Place::AtInfinity(direction) => PointResult {
                at_infinity: Some(direction.into()),
                on: Some(mechanism.body(special.link).name.clone()),
                ..PointResult::default()
            },
        };
        points.insert(special.name.clone(), result);
    }
    points
}

/// The bands for the result file.
#[must_use]
pub fn pencil_result(pencil: &Pencil, units: Units) -> PencilResult {
    let (mut bands, mut without) = (IndexMap::new(), IndexMap::new());
    for (asked, band) in &pencil.quantities {
        let name = asked.name().to_owned();
        match band {
            Ok(Band { value, band, is_rough }) => {
                let unit = if asked.written.on_paper { "mm".to_owned() } else { asked.kind().unit(units) };
                let result = BandResult { value: *value, band: *band, unit, rough: *is_rough };
                bands.insert(name, result);
            }
            Err(Unread::Given) => {}
            Err(why) => {
                without.insert(name, why.to_string());
            }
        }
    }
    PencilResult { mm: pencil.tolerance.mm, degrees: pencil.tolerance.degrees, mu: pencil.scales, bands, without }
}
