//! Forces, moments and powers by their names, with their stated errors: held to independent truth (`tests/forces/README.md`), to sums that
//! the scene's own numbers and that truth give, and to equilibrium of the frame.

use super::forces::cases;
use kinegon::quantity::QuantityName;
use serde_json::{Value, json};
use support::comparison::{decimal, entries};
use support::exact::{Exact, exceeds};
use support::stages::solved;

/// Errors allowed, in parts of the largest number of its kind.
const OFF: f64 = 1e-10;

/// What the truth's own arithmetic leaves of nothing.
const NOTHING: f64 = 1e-50;

/// A name, and its true number.
type Named = (String, Exact);

fn true_number(json: &Value) -> Exact {
    Exact::read(decimal(json))
}

/// All that the truth of a case tells by names.
fn named(case: &Value) -> Vec<Named> {
    let truth = &case["expected"];
    let mut all: Vec<Named> = Vec::new();
    for (pin, bodies) in entries(&truth["reactions"]) {
        for (body, force) in entries(bodies) {
            // Points of given motion are on no body that could receive a force.
            if !(text(&case["id"]).starts_with('F') && body == "ground") {
                let of = |(index, axis)| (format!("R({pin},{body}).{axis}"), true_number(&force[index]));
                all.extend(["x", "y"].into_iter().enumerate().map(of));
            }
        }
    }
    for (drive, needed) in entries(&truth["drives"]) {
        let (head, key) = if needed["torque"].is_null() { ("F", "force") } else { ("T", "torque") };
        all.push((format!("{head}({drive})"), true_number(&needed[key])));
    }
    for group in truth["groups"].as_array().into_iter().flatten() {
        all.extend(entries(&group["parts"]).map(|(name, value)| (name.to_owned(), true_number(value))));
    }
    for (slider, carried) in entries(&truth["sliders"]) {
        all.extend(["N", "M"].map(|key| (format!("{key}({slider})"), true_number(&carried[key]))));
        // A guide that carries nothing across has no such line.
        if carried["h"].is_string() {
            all.push((format!("h({slider})"), true_number(&carried["h"])));
        }
    }
    let is_static = case["scene"]["analysis"] == "static";
    for (link, inertia) in entries(&truth["inertia"]) {
        for (index, axis) in ["x", "y"].into_iter().enumerate() {
            all.push((format!("a_cm({link}).{axis}"), true_number(&inertia["a_center"][index])));
            if !is_static {
                all.push((format!("F_i({link}).{axis}"), true_number(&inertia["inertia_force"][index])));
            }
        }
        if !is_static {
            all.push((format!("M_i({link})"), true_number(&inertia["inertia_couple"])));
        }
    }
    all
}

/// Powers of loads: those at rate 1 of each drive, times its rate.
fn powers(case: &Value) -> Vec<Named> {
    let rate = |drive: &str| {
        let own = &case["scene"]["links"][drive]["drive"]["omega"];
        let slider = || {
            let sliders = case["scene"]["sliders"].as_array().into_iter().flatten();
            let pushed = |slider: &&Value| format!("{}/{}", text(&slider["link"]), text(&slider["on"])) == drive;
            sliders.filter(pushed).find_map(|slider| slider["drive"]["speed"].as_f64())
        };
        own.as_f64().or_else(slider)
    };
    let mut sums: Vec<Named> = Vec::new();
    for (drive, found) in entries(&case["expected"]["drives"]) {
        let Some(rate) = rate(drive) else { return Vec::new() };
        for term in found["power_terms"].as_array().into_iter().flatten() {
            let name = format!("power({})", text(&term[0]));
            // What a scene lacks, as weight without gravity, has no power there, and no name here.
            let Some(power) = (term[1] != "0").then(|| true_number(&term[1]) * Exact::from(rate)) else { continue };
            match sums.iter_mut().find(|(own, _)| *own == name) {
                Some((_, sum)) => *sum = *sum + power,
                None => sums.push((name, power)),
            }
        }
    }
    sums
}

fn text(json: &Value) -> &str {
    json.as_str().unwrap_or_default()
}

/// What a scene says of these names, with the stated errors.
fn asked(case: &Value, names: &[Named]) -> Vec<(String, f64, f64, Exact)> {
    let mut scene = case["scene"].clone();
    scene["want"] = names.iter().map(|(name, _)| json!(name)).collect();
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{}: {error}", case["id"]));
    let whole = solution.whole_result().unwrap_or_else(|error| panic!("{}: {error}", case["id"]));
    let whole = serde_json::to_value(whole).expect("a result is JSON");
    let number = |key: &str, name: &str| {
        let value = &whole[key][name];
        value.as_f64().unwrap_or_else(|| panic!("{}: {key} of {name} is {value}", case["id"]))
    };
    let read =
        |(name, truth): &Named| (name.clone(), number("quantities", name), number("quantity_errors", name), *truth);
    names.iter().map(read).collect()
}

/// Each number is near the truth, in parts of the largest of its kind, and within its stated error of it.
fn are_true(case: &Value, names: &[Named]) -> usize {
    // Forces count among forces, moments among moments.
    let head = |name: &str| QuantityName::parse(name).expect("a name").kind();
    let found = asked(case, names);
    for (name, value, error, truth) in &found {
        let same = found.iter().filter(|(other, ..)| head(other) == head(name));
        let size = same.fold(0.0_f64, |most, (.., truth)| most.max(truth.rounded().abs()));
        let off = (*truth + -Exact::from(*value)).rounded().abs();
        let id = &case["id"];
        // Next to a singular position, and where a guide carries nearly nothing, numbers have few digits.
        let is_hard = ["D05", "D07"].iter().any(|hard| text(id).starts_with(hard));
        assert!(is_hard || !exceeds(off, OFF * size + NOTHING), "{id}: {name} is {value}, off by {off:e}");
        let printed = 1e-28 * truth.rounded().abs() + NOTHING;
        assert!(!exceeds(off, error + printed), "{id}: {name} {value} ± {error:e} is off by {off:e}");
    }
    found.len()
}

#[test]
fn joints_and_inertia_are_true() {
    let mut seen = 0;
    for case in cases() {
        seen += are_true(&case, &named(&case));
    }
    assert!(seen > 900, "only {seen}");
}

#[test]
fn powers_are_true() {
    let seen: usize = cases().iter().map(|case| are_true(case, &powers(case))).sum();
    assert!(seen > 120, "only {seen}");
}

/// The moment of a force about a point, from the numbers of drawn scenes as they stand there.
#[test]
fn moments_of_loads_are_true() {
    let mut seen = 0;
    for case in cases() {
        let scene = &case["scene"];
        let at_pair = |json: &Value| [0, 1].map(|axis| Some(Exact::read(json[axis].as_f64()?.to_string().as_str())));
        let mut names = Vec::new();
        for load in scene["forces"].as_array().into_iter().flatten() {
            let Some(at) = load["at"].as_array().filter(|_| !scene["points"].is_null()) else { continue };
            let [[Some(x), Some(y)], [Some(f), Some(g)]] = [&json!(at), &load["force"]].map(at_pair) else { continue };
            for (point, place) in entries(&scene["points"]) {
                let [Some(px), Some(py)] = at_pair(place) else { continue };
                let moment = (x + -px) * g + -((y + -py) * f);
                names.push((format!("moment({},{point})", text(&load["name"])), moment));
            }
        }
        seen += are_true(&case, &names);
    }
    assert!(seen > 100, "only {seen}");
}

/// What the frame receives in all its pins is the shaking force, and their moments with the drive's reaction its moment.
#[test]
fn the_frame_is_shaken_by_its_joints() {
    let mut seen = 0;
    for case in cases() {
        let (scene, truth) = (&case["scene"], &case["expected"]);
        let has_sliders = scene["sliders"].as_array().is_some_and(|sliders| !sliders.is_empty());
        let (true, Some(points)) = (!has_sliders && scene["ground"].is_array(), scene["points"].as_object()) else {
            continue;
        };
        let place = |pin: &str| [0, 1].map(|axis| Exact::read(&points[pin][axis].to_string()));
        let pins = scene["ground"].as_array().expect("points of the ground").iter().map(text);
        let pins: Vec<&str> = pins.filter(|pin| !truth["reactions"][pin]["ground"].is_null()).collect();
        let about = pins[pins.len() - 1];
        let nothing = Exact::from(0.0);
        let [mut sum_x, mut sum_y, mut moment] = [nothing; 3];
        for pin in &pins {
            let force = &truth["reactions"][pin]["ground"];
            let [f, g] = [0, 1].map(|axis| true_number(&force[axis]));
            let ([x, y], [ax, ay]) = (place(pin), place(about));
            (sum_x, sum_y) = (sum_x + f, sum_y + g);
            moment = moment + (x + -ax) * g + -((y + -ay) * f);
        }
        for (_, drive) in entries(&truth["drives"]) {
            moment = moment + -true_number(&drive["torque"]);
        }
        let names =
            [("shaking.x".to_owned(), sum_x), ("shaking.y".to_owned(), sum_y), (format!("shaking({about})"), moment)];
        seen += are_true(&case, &names);
    }
    assert!(seen >= 15, "only {seen}");
}

/// Names are read back as they are written, each with its kind; none means another one.
#[test]
fn names_are_read_back() {
    for name in [
        "h(3/2)",
        "R_n(B,2)",
        "R_t(B,2).size",
        "F_i(2).x",
        "M_i(2)",
        "a_cm(2).angle",
        "moment(weight(2),S3)",
        "power(K1(ground))",
        "shaking",
        "shaking.size",
        "shaking(A)",
    ] {
        let read = QuantityName::parse(name).unwrap_or_else(|| panic!("{name} is a name"));
        assert_eq!(read.to_string(), name);
    }
    for name in ["shaking()x", "shaking/mu", "R_n(B)", "moment(P)", "omega", "R", "shaken"] {
        assert!(QuantityName::parse(name).is_none(), "{name}");
    }
}

#[test]
fn names_of_what_is_not_there_are_refused() {
    let case = cases().into_iter().find(|case| case["id"] == "H17-paper-figure-2").expect("the case is there");
    let solution = solved(&case["scene"].to_string()).expect("it is solved");
    for (name, why) in [
        ("power(Z)", "there is no load `Z` here"),
        ("moment(weight(22),B)", "there is no load `weight(22)` here"),
        ("power(weight(22))", "did you mean `weight(2)`"),
        ("R_n(B,4)", "that link has no joint at that pin"),
        ("R_n(D,4)", "that link has not two joints there, whose line would be meant"),
        ("shaking(B/2)", "there is no point"),
    ] {
        let error = solution.quantity(name).expect_err(name).to_string();
        assert!(error.contains(why), "{name}: {error}");
    }
    let case = cases().into_iter().find(|case| case["id"] == "H07-four-bar-static").expect("the case is there");
    let mut scene = case["scene"].clone();
    scene["units"]["mass"] = json!("kg");
    for key in ["mass", "inertia", "center"] {
        scene["links"]["3"].as_object_mut().expect("an object").remove(key);
    }
    scene["links"]["2"]["mass"] = json!(2);
    scene["links"]["2"]["center"] = json!(10);
    let solution = solved(&scene.to_string()).expect("it is solved");
    for (name, why) in [("F_i(2)", "inertia is left out"), ("F_i(3)", "that link has no mass")] {
        let error = solution.quantity(name).expect_err(name).to_string();
        assert!(error.contains(why), "{name}: {error}");
    }
    assert!(solution.quantity("a_cm(2)").is_ok());
}

/// Renaming a link renames the loads that have its name.
#[test]
fn a_load_is_renamed_with_its_link() {
    use kinegon::scene::Argument;
    let other = |argument: Argument, name: &str| {
        (argument == Argument::Load && name == "weight(2)").then(|| "weight(9)".to_owned())
    };
    assert_eq!(QuantityName::reworded("moment( weight(2), S3)", other).as_deref(), Some("moment( weight(9), S3)"));
}

/// A couple without a name is called by its link, the second one there with a prime, later ones with their number, and gives way to names
/// that the scene gives.
#[test]
fn a_couple_is_called_by_its_link() {
    let mut scene: Value = serde_json::from_str(&support::files::read("templates/four-bar.json")).expect("a scene");
    scene["units"] = json!({ "length": "mm", "time": "s", "force": "N" });
    scene["analysis"] = json!("static");
    scene["forces"] = json!([
        { "on": "3", "couple": 100 },
        { "on": "2", "couple": 200 },
        { "on": "3", "couple": 300 },
        { "on": "1", "couple": 400 },
        { "name": "M2", "on": "3", "couple": 500 },
        { "name": "P", "on": "3", "at": "C", "force": [1, 0] },
        { "on": "3", "at": "C", "force": [2, 0] },
        { "on": "3", "couple": 600 },
        { "name": "M3-4", "on": "1", "couple": 700 },
        { "on": "3", "couple": 800 },
    ]);
    let solution = support::stages::solved(&scene.to_string()).expect("it can be solved");
    let value = |name: &str| solution.quantity(name).unwrap_or_else(|error| panic!("{name}: {error}")).as_number();
    let about = |name: &str| value(&format!("moment({name},A)"));
    let first = [("M3", 100.0), ("M'2", 200.0), ("M'3", 300.0), ("M1", 400.0), ("M2", 500.0)];
    let later = [("M3-3", 600.0), ("M3-4", 700.0), ("M3-5", 800.0)];
    for (name, couple) in first.into_iter().chain(later) {
        assert!((about(name) - couple).abs() < 1e-12 * couple, "{name}");
    }
    assert!((value("load(F2).x") - 2.0).abs() < 1e-15, "every force counts");
}
