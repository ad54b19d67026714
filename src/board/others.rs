//! Scenes like a given one, with other sizes, angles and rates: in them a way that is right only by chance goes wrong.
//!
//! What holds by the scene's own shape holds in them, too: points of a link on a line stay on it, links of equal length stay equal, what is
//! at rest stays at rest. A scene in which that comes out otherwise, as next to a dead centre, is not taken; then less is changed.

use super::given::Given;
use crate::construction::Solution;
use crate::exercise::{Number, each_number};
use crate::geometry::Random;
use crate::mechanism::mechanism;
use crate::position::{pose, with_nearest_sides};
use crate::scene::Scene;
use crate::sheet::{Order, Sheet};
use indexmap::IndexMap;
use serde_json::{Map, Value as Json, json};

/// How many others are looked for.
const WANTED: usize = 3;

/// What is changed, from most to least.
#[derive(Clone, Copy)]
struct Changed {
    /// Largest part of a length, up or down.
    sizes: f64,
    /// Largest turn of a drive, in degrees.
    turn: f64,
}

const WAYS: [Changed; 9] = [
    Changed { sizes: 0.1, turn: 12.0 },
    Changed { sizes: 0.1, turn: 12.0 },
    Changed { sizes: 0.05, turn: 6.0 },
    Changed { sizes: 0.1, turn: 0.0 },
    Changed { sizes: 0.0, turn: 12.0 },
    Changed { sizes: 0.02, turn: 2.0 },
    Changed { sizes: 0.005, turn: 0.5 },
    Changed { sizes: 0.0005, turn: 0.05 },
    // Rates alone.
    Changed { sizes: 0.0, turn: 0.0 },
];

/// Up to three scenes like this one; fewer where hardly anything may be changed.
#[must_use]
pub(super) fn others(given: &Given) -> Vec<Given> {
    let text = given.solution.scene.text().trim_start_matches('\u{feff}');
    let Ok(scene) = serde_json::from_str::<Json>(text) else { return Vec::new() };
    let mut random = Random(1);
    let mut found = Vec::new();
    for way in WAYS {
        for _ in 0..WANTED {
            if found.len() == WANTED {
                return found;
            }
            let other = changed(&scene, way, &mut random).to_string();
            found.extend(solved(&other).map(|solution| Given::new(&solution)).filter(|other| is_like(given, other)));
        }
    }
    found
}

fn solved(text: &str) -> Option<Solution> {
    let scene = Scene::read(text).ok()?;
    let mechanism = with_nearest_sides(&scene, mechanism(&scene).ok()?);
    let pose = pose(&mechanism, &scene.near).ok()?;
    Solution::new(scene, mechanism, pose, Order::Acceleration).ok()
}

/// Whether the same is at rest in both, and the plans have the same points.
fn is_like(given: &Given, other: &Given) -> bool {
    let same_rest = Sheet::ALL.into_iter().all(|sheet| {
        let nothing = |of: &Given, at: crate::geometry::Vector| at.norm() <= REST * of.size(sheet);
        given.places(sheet).count() == other.places(sheet).count()
            && given.places(sheet).all(|(name, place)| {
                other.place(sheet, name).is_some_and(|moved| nothing(given, place) == nothing(other, moved))
            })
    });
    let rates = |of: &Given| -> Vec<bool> {
        let motion = &of.solution.motion;
        let largest = |order: usize| {
            let rate = |b: &crate::motion::BodyMotion| [b.omega, b.alpha][order].abs();
            motion.bodies.iter().map(rate).fold(0.0, f64::max)
        };
        let [omega, alpha] = [largest(0), largest(1)];
        motion.bodies.iter().flat_map(|b| [b.omega.abs() <= REST * omega, b.alpha.abs() <= REST * alpha]).collect()
    };
    same_rest && rates(given) == rates(other) && signs(given) == signs(other)
}

/// The signs that somebody sees in a scene and writes into formulas: senses of rates, the sides on which special points lie, the senses of
/// segments.
fn signs(given: &Given) -> Vec<bool> {
    let (mechanism, motion, construction) = (given.mechanism(), &given.solution.motion, given.construction());
    let mut signs: Vec<bool> = motion.bodies.iter().flat_map(|body| [body.omega < 0.0, body.alpha < 0.0]).collect();
    signs.extend(motion.slides.iter().flat_map(|slide| [slide.velocity < 0.0, slide.acceleration < 0.0]));
    for special in &construction.special {
        let Some(place) = given.place(Sheet::Scheme, &special.name) else { continue };
        let points = mechanism.body(special.link).points.iter().map(|point| mechanism.point_name(*point));
        let points: Vec<_> = points.filter_map(|name| given.place(Sheet::Scheme, name)).collect();
        for from in &points {
            signs.extend(points.iter().filter(|to| *to != from).map(|to| (place - from).dot(&(to - from)) < 0.0));
        }
    }
    let values = construction.run(crate::sheet::PerSheet::from_fn(|_| 1.0), &[]);
    for operation in &construction.operations {
        signs.extend(operation.kind.numbers().iter().map(|number| values.number(*number) < 0.0));
    }
    signs
}

/// What is less than this part of the largest is at rest.
const REST: f64 = 1e-9;

fn changed(scene: &Json, way: Changed, random: &mut Random) -> Json {
    let mut scene = scene.clone();
    // Equal lengths stay equal: the factor is found by the length.
    let mut factors: IndexMap<u64, f64> = IndexMap::new();
    let mut factor = |length: f64, random: &mut Random| {
        *factors.entry(length.abs().to_bits()).or_insert_with(|| 1.0 + way.sizes * random.within())
    };
    let change = |number: Number, x: f64, size: f64, random: &mut Random| match number {
        Number::Length | Number::DrivePosition => x * size,
        Number::DriveAngle => x + way.turn * random.within(),
        // Rates that are equal in size may have a meaning together only where they are zero.
        Number::Motion | Number::Turning | Number::DriveRate => x * (1.2 + 0.3 * random.within()),
        Number::Direction | Number::Load => x,
    };
    if let Some(links) = scene.get_mut("links").and_then(Json::as_object_mut) {
        for (name, link) in links.iter_mut() {
            let mut longest = 0.0_f64;
            let mut alone = json!({ "links": { name.as_str(): link.take() } });
            each_number(&mut alone, &mut |number, x| {
                if number == Number::Length {
                    longest = longest.max(x.abs());
                }
                x
            });
            let size = factor(longest, random);
            each_number(&mut alone, &mut |number, x| change(number, x, size, random));
            *link = alone["links"][name.as_str()].take();
        }
    }
    let mut rest = Json::Object(
        ["known", "sliders"].into_iter().filter_map(|key| Some((key.to_owned(), scene.get(key)?.clone()))).collect(),
    );
    each_number(&mut rest, &mut |number, x| change(number, x, 1.0, random));
    put_back(&mut scene, rest);
    // A drawn configuration is sheared: lines, ratios on them and parallels stay.
    if scene.get("points").is_some() {
        let [a, b, c, d] = [(); 4].map(|()| way.sizes * random.within());
        for key in ["points", "ground"] {
            let places = scene.get_mut(key).and_then(Json::as_object_mut);
            for place in places.into_iter().flat_map(Map::values_mut) {
                if let [Some(x), Some(y)] = [0, 1].map(|axis| place.get(axis).and_then(Json::as_f64)) {
                    *place = json!([x + a * x + b * y, y + c * x + d * y]);
                }
            }
        }
    }
    scene
}

fn put_back(scene: &mut Json, parts: Json) {
    if let (Some(scene), Json::Object(parts)) = (scene.as_object_mut(), parts) {
        scene.extend(parts);
    }
}
