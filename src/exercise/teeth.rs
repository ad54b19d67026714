//! Other numbers of teeth for the wheels of a scene, with distances of centres that fit: whole numbers from 17 on, rims that belong together, trains
//! that can be assembled with three planets, ratios that are not 1.

use crate::editing::measure::json as json_number;
use crate::geometry::{Point, Random};
use serde_json::{Value, json};

/// Fewest and most teeth: of fewer the teeth are undercut, more are hard to draw.
const FEWEST: f64 = 17.0;
const MOST: f64 = 100.0;

/// Largest relative change of a number of teeth, up or down.
const PART: f64 = 0.25;

/// Draws of teeth of which one must fit.
const TRIES: usize = 200;

/// So many planets are mounted at equal angles.
const PLANETS: f64 = 3.0;

/// A mesh of a scene file.
struct Mesh {
    wheels: [String; 2],
    teeth: [f64; 2],
    carrier: String,
    centers: [String; 2],
    /// The distance of the centres for each tooth of both wheels together.
    module: f64,
}

/// The wheels of a scene file with the distances of their centres.
pub(super) struct Wheels {
    meshes: Vec<Mesh>,
}

impl Wheels {
    /// Those of a scene from lengths, whose carriers have the distances of their centres; empty where that is not so.
    pub fn of(scene: &Value) -> Wheels {
        let gears = scene["gears"].as_array().into_iter().flatten();
        let meshes: Option<Vec<Mesh>> = gears.map(|gear| mesh(scene, gear)).collect();
        Wheels { meshes: meshes.unwrap_or_default() }
    }

    /// Puts other numbers of teeth and the distances that belong to them into a variant of the scene; without any that fit the scene's own.
    pub fn vary(&self, scene: &mut Value, random: &mut Random) {
        if self.meshes.is_empty() {
            return;
        }
        let own = || self.meshes.iter().map(|mesh| mesh.teeth).collect();
        let teeth = (0..TRIES).find_map(|_| self.drawn(random)).unwrap_or_else(own);
        for (index, (mesh, teeth)) in self.meshes.iter().zip(&teeth).enumerate() {
            scene["gears"][index]["teeth"] = json!(teeth.map(json_number));
            put_distance(scene, mesh, mesh.module * (teeth[0] + teeth[1]).abs());
        }
    }

    /// Numbers of teeth by lot; `None` where they do not fit.
    fn drawn(&self, random: &mut Random) -> Option<Vec<[f64; 2]>> {
        // Each rim, by its wheel and the scene's number of teeth.
        let mut rims: Vec<(&str, f64, f64)> = Vec::new();
        let mut distances: Vec<([&String; 2], f64)> = Vec::new();
        let mut all = Vec::new();
        for mesh in &self.meshes {
            let pair = {
                let [a, b] = &mesh.centers;
                if a <= b { [a, b] } else { [b, a] }
            };
            let fixed = distances.iter().find(|(own, _)| *own == pair).map(|(_, distance)| *distance);
            let known = |side: usize| {
                let is_it = |rim: &&(&str, f64, f64)| rim.0 == mesh.wheels[side] && rim.1 == mesh.teeth[side];
                rims.iter().find(is_it).map(|rim| rim.2)
            };
            let mut lot = |side: usize| {
                libm::round(mesh.teeth[side].abs() * (1.0 + PART * random.within())).copysign(mesh.teeth[side])
            };
            let sum = mesh.teeth[0] + mesh.teeth[1];
            let needed = fixed.map(|distance| libm::copysign(distance / mesh.module, sum));
            let teeth = match (known(0), known(1), needed) {
                (Some(first), Some(second), _) => [first, second],
                (Some(first), None, Some(needed)) => [first, needed - first],
                (None, Some(second), Some(needed)) => [needed - second, second],
                (None, None, Some(needed)) => {
                    let first = lot(0);
                    [first, needed - first]
                }
                (first, second, None) => [first.unwrap_or_else(|| lot(0)), second.unwrap_or_else(|| lot(1))],
            };
            let distance = mesh.module * (teeth[0] + teeth[1]).abs();
            let is_whole = teeth.iter().all(|z| (z - libm::round(*z)).abs() < 1e-6);
            let is_usual = teeth.iter().all(|z| (FEWEST..=MOST).contains(&libm::round(z.abs())));
            let keeps_senses =
                teeth.iter().zip(mesh.teeth).all(|(z, own)| z * own > 0.0) && (teeth[0] + teeth[1]) * sum > 0.0;
            let fits = fixed.is_none_or(|fixed| (fixed - distance).abs() < 1e-6 * distance);
            if !(is_whole && is_usual && keeps_senses && fits) || teeth[0].abs() == teeth[1].abs() {
                return None;
            }
            let teeth = teeth.map(libm::round);
            let own = mesh.wheels.iter().zip(mesh.teeth).zip(teeth);
            rims.extend(own.map(|((wheel, own), teeth)| (wheel.as_str(), own, teeth)));
            distances.push((pair, distance));
            all.push(teeth);
        }
        (self.can_be_assembled(&all) && self.has_ratios(&all)).then_some(all)
    }

    /// The pairs of meshes in which a wheel lies between two others on one line of centres, with the index of the wheel in each.
    fn between(&self) -> impl Iterator<Item = ([usize; 2], [usize; 2])> {
        let count = self.meshes.len();
        let pairs = (0..count).flat_map(move |a| (a + 1..count).map(move |b| (a, b)));
        pairs.flat_map(move |(a, b)| {
            let (first, second) = (&self.meshes[a], &self.meshes[b]);
            let sides = (0..2).flat_map(|i| (0..2).map(move |j| (i, j)));
            let shared = sides.filter(move |&(i, j)| {
                first.carrier == second.carrier
                    && first.wheels[i] == second.wheels[j]
                    && first.centers[1 - i] == second.centers[1 - j]
            });
            shared.map(move |(i, j)| ([a, b], [i, j]))
        })
    }

    /// Whether three planets between a sun and a ring can be mounted at equal angles: (z_sun + z_ring) / 3 is whole.
    fn can_be_assembled(&self, teeth: &[[f64; 2]]) -> bool {
        self.between().all(|([a, b], [i, j])| {
            let [first, second] = [teeth[a][1 - i], teeth[b][1 - j]];
            let is_planet = self.meshes[a].teeth[i] == self.meshes[b].teeth[j] && first * second < 0.0;
            !is_planet || (first.abs() + second.abs()) % PLANETS == 0.0
        })
    }

    /// Whether no train between two coaxial wheels has the ratio 1.
    fn has_ratios(&self, teeth: &[[f64; 2]]) -> bool {
        self.between().all(|([a, b], [i, j])| {
            let over = teeth[a][1 - i] * teeth[b][j];
            let under = teeth[a][i] * teeth[b][1 - j];
            (over - under).abs() > 0.1 * over.abs()
        })
    }
}

fn mesh(scene: &Value, gear: &Value) -> Option<Mesh> {
    let name = |value: &Value| value.as_str().map(str::to_owned);
    let wheels = [name(&gear["mesh"][0])?, name(&gear["mesh"][1])?];
    let teeth = [gear["teeth"][0].as_f64()?, gear["teeth"][1].as_f64()?];
    let carrier = name(&gear["on"])?;
    let center = |wheel: &str| {
        let on_carrier = points(scene, &carrier);
        points(scene, wheel).into_iter().find(|point| on_carrier.contains(point))
    };
    let centers = [center(&wheels[0])?, center(&wheels[1])?];
    let module = distance(scene, &carrier, &centers)? / (teeth[0] + teeth[1]).abs();
    Some(Mesh { wheels, teeth, carrier, centers, module })
}

fn points(scene: &Value, body: &str) -> Vec<String> {
    if body == "ground" {
        let ground = scene["ground"].as_object();
        return ground.into_iter().flat_map(|ground| ground.keys().filter(|key| *key != "note").cloned()).collect();
    }
    let link = &scene["links"][body];
    let names = link["points"].as_array().or_else(|| link.as_array());
    names.into_iter().flatten().filter_map(|name| name.as_str().map(str::to_owned)).collect()
}

/// Where a fixed point is.
fn place(scene: &Value, point: &str) -> Option<Point> {
    let place = &scene["ground"][point];
    Some(Point::new(place[0].as_f64()?, place[1].as_f64()?))
}

/// The key of the length between two points of a link.
fn length_key(scene: &Value, link: &str, [a, b]: &[String; 2]) -> Option<String> {
    let lengths = scene["links"][link]["lengths"].as_object()?;
    let keys = [format!("{a}{b}"), format!("{b}{a}"), format!("{a}-{b}"), format!("{b}-{a}")];
    keys.into_iter().find(|key| lengths.contains_key(key))
}

fn distance(scene: &Value, carrier: &str, centers: &[String; 2]) -> Option<f64> {
    match carrier {
        "ground" => Some((place(scene, &centers[1])? - place(scene, &centers[0])?).norm()),
        link => scene["links"][link]["lengths"][length_key(scene, link, centers)?].as_f64(),
    }
}

/// Puts the distance of the centres of a mesh: a length of its carrier, or the second centre moved along the line from the first.
fn put_distance(scene: &mut Value, mesh: &Mesh, distance: f64) {
    let rounded = libm::round(distance * 1e6) / 1e6;
    if mesh.carrier != "ground" {
        if let Some(key) = length_key(scene, &mesh.carrier, &mesh.centers) {
            scene["links"][&mesh.carrier]["lengths"][key] = json_number(rounded);
        }
        return;
    }
    let [Some(from), Some(to)] = mesh.centers.each_ref().map(|point| place(scene, point)) else { return };
    if let Some(along) = (to - from).try_normalize(0.0) {
        let at = from + along * rounded;
        scene["ground"][&mesh.centers[1]] = json!([at.x, at.y].map(|x| json_number(libm::round(x * 1e6) / 1e6)));
    }
}
