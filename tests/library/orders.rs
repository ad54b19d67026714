//! The order in which a scene lists links, points and joints says nothing: structure, numbers, modes and constructions are the same in every order.
//!
//! Numbers may differ within the sum of their stated errors; those without one by [`WITHOUT_BOUND`] of the largest of their kind.

use kinegon::construction::Tolerance;
use kinegon::position::counted_poses;
use kinegon::quantity::pencil;
use kinegon::scene::{GivenBy, Scene};
use kinegon::{Error, Solution};
use serde_json::Value;
use std::collections::BTreeMap;
use support::files::{list, path, read, scene_text};
use support::orders::reordered;
use support::random::Random;
use support::stages::solved;
use support::survey::{ORDERED_FIGURES, ORDERED_SCENES, ORDERS, Size};

/// Largest difference of numbers without a stated error, in parts of the largest of their kind.
const WITHOUT_BOUND: f64 = 1e-9;

/// The same where nothing is proved, as at a limit.
const UNPROVED: f64 = 1e-5;

/// Names and texts of all scenes in a folder and those in it; each line of tables is one, too.
fn add_scenes(folder: &str, found: &mut Vec<(String, String)>) {
    for name in list(folder) {
        let file = format!("{folder}/{name}");
        if path(&file).is_dir() {
            add_scenes(&file, found);
        } else if name.ends_with(".json") {
            // Some are there because they are no texts.
            found.extend(std::fs::read_to_string(path(&file)).ok().map(|text| (file.clone(), text)));
        } else if name.ends_with(".jsonl") && Size::asked() >= Size::Usual {
            let text = read(&file);
            let cases = text
                .lines()
                .enumerate()
                .filter(|(_, line)| line.contains("\"scene\":{") || line.contains("\"scene\": {"));
            found.extend(cases.map(|(number, line)| (format!("{file}:{}", number + 1), scene_text(line).to_owned())));
        }
    }
}

fn scenes() -> Vec<(String, String)> {
    let mut found = Vec::new();
    ["templates", "examples", "tests"].iter().for_each(|folder| add_scenes(folder, &mut found));
    let is_scene = |text: &str| {
        let value: Option<Value> = serde_json::from_str(text).ok();
        value.is_some_and(|value| {
            value["links"].is_object() && value["kinegon"] == 1 && value["kinegon_study"].is_null()
        })
    };
    found.retain(|(_, text)| is_scene(text) && Scene::read(text).is_ok());
    found
}

/// What is said of a scene that is refused: without its place.
fn told(error: &Error) -> String {
    match error {
        Error::Scene(error) => error.problem().message.to_string(),
        other => other.to_string(),
    }
}

/// All numbers of a result by their path, with their errors.
#[derive(Default)]
struct Numbers {
    of: BTreeMap<String, (f64, Option<f64>)>,
    words: BTreeMap<String, String>,
}

impl Numbers {
    fn of(solution: &Solution) -> Numbers {
        let mut result = serde_json::to_value(solution.result()).expect("a result is JSON");
        result.as_object_mut().expect("an object").remove("warnings");
        let errors = result["quantity_errors"].take();
        let mut found = Numbers::default();
        found.add("", &result, &errors);
        found
    }

    fn add(&mut self, path: &str, value: &Value, errors: &Value) {
        match value {
            Value::Object(entries) => {
                for (key, own) in entries {
                    if key == "error" || key.contains("_error") || key.starts_with("disagreement") || key == "condition"
                    {
                        continue;
                    }
                    let is_whole = entries.contains_key("error") && key != "powers";
                    let error = entries.get(&format!("{key}_error")).or(entries.get("error").filter(|_| is_whole));
                    let path = format!("{path}/{key}");
                    match own {
                        Value::Object(_) => self.add(&path, own, errors),
                        _ => self.leaf(&path, own, error.or_else(|| errors.get(key))),
                    }
                }
            }
            other => self.leaf(path, other, None),
        }
    }

    fn leaf(&mut self, path: &str, value: &Value, error: Option<&Value>) {
        match value {
            Value::Number(number) => {
                let error = error.map(|error| error.as_f64().unwrap_or(f64::INFINITY));
                self.of.insert(path.to_owned(), (number.as_f64().expect("f64"), error));
            }
            Value::Array(elements) => {
                for (index, element) in elements.iter().enumerate() {
                    let path = format!("{path}/{index}");
                    match element {
                        Value::Object(_) => self.add(&path, element, &Value::Null),
                        _ => self.leaf(&path, element, error),
                    }
                }
            }
            other => _ = self.words.insert(path.to_owned(), other.to_string()),
        }
    }

    /// The last words of paths, so that numbers of a kind have one scale.
    fn scale(&self, path: &str) -> f64 {
        let kind = |path: &str| {
            path.trim_end_matches(|c: char| c.is_ascii_digit() || c == '/').rsplit('/').next().map(str::to_owned)
        };
        let own = kind(path);
        let alike = self.of.iter().filter(|(other, _)| kind(other) == own);
        alike.map(|(_, (x, _))| x.abs()).fold(0.0, f64::max)
    }

    fn differences(&self, other: &Numbers) -> Vec<String> {
        let mut found = Vec::new();
        if self.words != other.words {
            let apart = self.words.iter().filter(|(path, word)| other.words.get(*path) != Some(word));
            found.extend(apart.map(|(path, word)| format!("{path}: {word} and {:?}", other.words.get(path))));
        }
        for (path, &(x, error)) in &self.of {
            let Some(&(y, other_error)) = other.of.get(path) else {
                found.push(format!("{path} is missing"));
                continue;
            };
            let scale = || self.scale(path);
            let allowed = match error.zip(other_error).map(|(a, b)| a + b) {
                Some(sum) if sum.is_finite() => sum,
                Some(_) => UNPROVED * scale(),
                None => WITHOUT_BOUND * scale(),
            };
            let turns = if path.ends_with("/angle") { libm::round((x - y) / 360.0) } else { 0.0 };
            let apart = x - y - 360.0 * turns;
            if apart.abs() > allowed {
                found.push(format!("{path}: {x:e} and {y:e}, ± {allowed:.1e}"));
            }
        }
        found.extend(other.of.keys().filter(|path| !self.of.contains_key(*path)).map(|path| format!("{path} is more")));
        found
    }
}

/// Places of points in all modes.
fn modes(solution: &Solution) -> Option<(u64, Vec<Vec<[f64; 2]>>)> {
    if solution.scene.given_by == GivenBy::Drawing {
        return None;
    }
    let listed = counted_poses(&solution.mechanism, &solution.scene.near).ok()?;
    let places = |pose: &kinegon::position::Pose| pose.points.iter().map(|point| [point.x, point.y]).collect();
    Some((listed.count.number, listed.poses.iter().map(places).collect()))
}

fn compared(one: &Result<Solution, Error>, other: &Result<Solution, Error>, with_figures: bool) -> Vec<String> {
    let (one, other) = match (one, other) {
        (Ok(one), Ok(other)) => (one, other),
        (Err(one), Err(other)) if told(one) == told(other) => return Vec::new(),
        (Err(one), Err(other)) => return vec![format!("refused as `{}` and as `{}`", told(one), told(other))],
        (Ok(_), Err(error)) | (Err(error), Ok(_)) => return vec![format!("refused in one order: {}", told(error))],
    };
    let mut found = Numbers::of(one).differences(&Numbers::of(other));
    if one.mechanism.points != other.mechanism.points {
        found.push("points".to_owned());
        return found;
    }
    match (modes(one), modes(other)) {
        (Some((count, places)), Some((others, other_places))) => {
            let size = places.iter().flatten().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
            let pairs = places.iter().flatten().flatten().zip(other_places.iter().flatten().flatten());
            let apart = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            if count != others || places.len() != other_places.len() {
                found.push(format!("{count} and {others} modes"));
            } else if apart > UNPROVED * size {
                found.push(format!("modes {apart:e} apart"));
            }
        }
        (one, other) if one != other => found.push("modes of one order alone".to_owned()),
        _ => {}
    }
    if with_figures {
        found.extend(drawn_alike(one, other));
    }
    found
}

/// Differences of the steps of the construction, their vectors, and scales.
fn drawn_alike(one: &Solution, other: &Solution) -> Vec<String> {
    let mut found = Vec::new();
    let (scales, others) = (one.scales(), other.scales());
    if scales != others {
        found.push(format!("scales {scales:?} and {others:?}"));
    }
    for (plan, other_plan) in one.construction.plans().zip(other.construction.plans()) {
        let size = plan.points.values().map(|point| point.vector.norm()).fold(0.0, f64::max);
        let alike = plan.points.len() == other_plan.points.len()
            && plan.points.iter().zip(&other_plan.points).all(|((name, point), (other_name, other_point))| {
                name == other_name && (point.vector - other_point.vector).norm() <= UNPROVED * size
            });
        if !alike {
            found.push(format!("the plan {:?}", plan.order));
        }
    }
    // Numbers aside, of which results say more.
    let masked = |line: &str| {
        let is_number =
            |word: &&str| word.trim_end_matches([',', ';', '°', ')']).trim_start_matches('(').parse::<f64>().is_ok();
        line.split_whitespace().map(|word| if is_number(&word) { "#" } else { word }).collect::<Vec<_>>().join(" ")
    };
    let steps = |solution: &Solution| {
        let pencil = pencil(solution, &solution.scales(), Tolerance::default(), Vec::new());
        solution.steps(&pencil).lines().map(masked).collect::<Vec<_>>()
    };
    let (steps, other_steps) = (steps(one), steps(other));
    if steps != other_steps {
        let apart = steps.iter().zip(&other_steps).find(|(a, b)| a != b);
        found.push(format!("steps: {apart:?}"));
    }
    found
}

#[test]
fn the_order_of_links_points_and_joints_says_nothing() {
    let scenes = scenes();
    let mut wrong = Vec::new();
    let (mut seen, mut tried) = (0, 0);
    for (number, (name, text)) in scenes.iter().enumerate().step_by(ORDERED_SCENES.now()) {
        // Read and written until its numbers stay, as serde_json reads some of them one place beside their text.
        let written = |text: &str| serde_json::from_str::<Value>(text).expect("a scene is JSON").to_string();
        let text = (0..9).fold(written(text), |text, _| written(&text));
        let usual = solved(&text);
        seen += 1;
        for order in 0..ORDERS.now() {
            let mut dice = Random((number * 1000 + order) as u64);
            let other = reordered(&text, &mut dice);
            tried += 1;
            let found = compared(&usual, &solved(&other), number.is_multiple_of(ORDERED_FIGURES.now()) && order < 3);
            if !found.is_empty() {
                wrong.push(format!(
                    "{name}: {} differences, as {}",
                    found.len(),
                    found[..found.len().min(4)].join("; ")
                ));
                if std::env::var("KINEGON_SURVEY").is_ok() {
                    println!("{}\n{other}", wrong.last().expect("just pushed"));
                }
                break;
            }
        }
    }
    println!("{seen} scenes in {tried} orders, {} differ", wrong.len());
    assert!(
        seen * ORDERED_SCENES.now() > 120 && wrong.is_empty(),
        "{} of {seen} scenes:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// Structures that texts give, in every order of their links: the toggle press (three links on one pin), Peaucellier's cell, which is three dyads,
/// and a group of class IV two of whose links hang on one pin of a drag link.
#[test]
fn pins_of_several_links_give_the_finest_groups() {
    let peaucellier = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0], "Q": [60, 0] },
        "links": { "1": { "points": ["Q", "C"], "lengths": { "QC": 60 }, "drive": { "angle": 35, "omega": 2 } },
            "2": { "points": ["O", "A"], "lengths": { "OA": 200 } }, "3": { "points": ["O", "B"], "lengths": { "OB": 200 } },
            "4": { "points": ["A", "C"], "lengths": { "AC": 100 } }, "5": { "points": ["B", "C"], "lengths": { "BC": 100 } },
            "6": { "points": ["A", "P"], "lengths": { "AP": 100 } }, "7": { "points": ["B", "P"], "lengths": { "BP": 100 } } },
        "near": { "C": [109, 34], "A": [130, 150], "B": [190, -40], "P": [250, 80] } }"#;
    let fourth = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0], "E": [300, 0] },
        "links": { "1": { "points": ["O", "A"], "lengths": { "OA": 30 }, "drive": { "angle": 40, "omega": 2 } },
            "9": { "points": ["A", "P"], "lengths": { "AP": 120 } },
            "4": { "shape": { "E": [0, 0], "Q": [-60, 90], "R": [30, 110] } },
            "5": { "points": ["P", "Q"], "lengths": { "PQ": 110 } }, "6": { "points": ["P", "R"], "lengths": { "PR": 170 } } },
        "near": { "P": [120, 110], "Q": [230, 80], "R": [320, 110] } }"#;
    let toggle = read("templates/toggle-press.json");
    let cases = [
        (toggle.as_str(), vec!["II: 2 3", "II: 4 5"]),
        (peaucellier, vec!["II: 2 4", "II: 3 5", "II: 6 7"]),
        (fourth, vec!["IV: 4 5 6 9"]),
    ];
    for (text, expected) in cases {
        for seed in 0..40 {
            let text = reordered(text, &mut Random(seed));
            let mechanism = kinegon::mechanism::mechanism(&Scene::read(&text).expect("a scene")).expect("a mechanism");
            let group = |group: &kinegon::mechanism::Group| {
                let mut links: Vec<&str> = group.links.iter().map(|&link| mechanism.body(link).name.as_str()).collect();
                links.sort_unstable();
                format!("{}: {}", group.class.numeral(), links.join(" "))
            };
            assert_eq!(mechanism.groups.iter().map(group).collect::<Vec<_>>(), expected, "{text}");
        }
    }
}
