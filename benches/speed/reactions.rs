//! How much longer a table takes with what joints carry and drives need in it.

use crate::{Repeats, path, solved};
use divan::black_box;
use kinegon::cycle::{Steps, Sweep, every_name};
use kinegon::mechanism::{Mechanism, SliderId};
use kinegon::quantity::QuantityRequest;
use serde_json::{Value, json};
use std::time::Instant;

/// How often each is timed; the least time counts.
const REPEATS: usize = 20;

/// Rows of a table.
const ROWS: usize = 20_000;

/// Mechanisms, and a range of the crank.
const MECHANISMS: [(&str, &str, [f64; 2]); 4] = [
    ("four-bar", include_str!("../../templates/four-bar.json"), [0.0, 360.0]),
    ("slider-crank", include_str!("../../templates/slider-crank.json"), [0.0, 360.0]),
    ("third class", include_str!("../../templates/third-class.json"), [30.0, 60.0]),
    ("the paper's mechanism", crate::FIGURE_2, [-135.0, 135.0]),
];

/// Prints the times over those of the same tables without forces.
pub fn print(repeats: Repeats) {
    println!(
        "\nTimes of tables with all reactions and what the drive needs over those without, all motions of links and points in both; and, in µs per row,"
    );
    println!("without and with them:");
    for (name, text, range) in MECHANISMS {
        let solution = solved(&loaded(text));
        let mechanism = &solution.mechanism;
        let path = path(mechanism, &solution.pose, range);
        let motions = every_name(mechanism);
        let all = [motions.clone(), reactions(mechanism)].concat();
        let [without, with] = [motions, all].map(|names| {
            let steps = Steps::new(range[0], range[1], (range[1] - range[0]) / ROWS as f64).expect("a range");
            let sweep = Sweep::new(&path, steps, Some(&names)).expect("known quantities");
            let time = || {
                let start = Instant::now();
                black_box(sweep.rows(0..ROWS));
                start.elapsed().as_secs_f64()
            };
            (0..repeats.of(REPEATS)).map(|_| time()).fold(f64::INFINITY, f64::min) / ROWS as f64 * 1e6
        });
        println!("  {name}: {:.2}   {without:.3} {with:.3}", with / without);
    }
}

/// A scene with a mass in each link, gravity and a force.
fn loaded(text: &str) -> String {
    let mut scene: Value = serde_json::from_str(text).expect("JSON");
    scene["units"]["mass"] = "kg".into();
    scene["units"]["force"] = "N".into();
    scene["gravity"] = json!([0, -9810]);
    let links = scene["links"].as_object_mut().expect("links");
    for (_, link) in links.iter_mut() {
        let points = if link.is_array() { link.clone() } else { link["points"].clone() };
        if link.is_array() {
            *link = json!({ "points": points });
        }
        let center = points[0].clone();
        for (key, value) in [("mass", json!(1.5)), ("inertia", json!(2000)), ("center", center)] {
            link[key] = value;
        }
    }
    let (last, link) = links.iter().next_back().expect("a link");
    scene["forces"] = json!([{ "on": last, "at": link["points"][0], "force": [-100, -40] }]);
    scene.to_string()
}

/// The names of all forces at pins and guides and of what drives need.
fn reactions(mechanism: &Mechanism) -> Vec<String> {
    let links = || mechanism.links().map(|(_, body)| &body.name);
    let pins = mechanism.points.iter().flat_map(|point| links().map(move |link| format!("R({point},{link})")));
    let sliders =
        (0..mechanism.sliders.len()).map(SliderId).map(|slider| format!("N({})", mechanism.slider_name(slider)));
    let torques = links().map(|link| format!("T({link})"));
    let all = pins.chain(sliders).chain(torques);
    all.filter(|name| QuantityRequest::new(name, mechanism).is_ok()).collect()
}
