//! The same mechanism looked at in another way: turned, mirrored, in other units, with other names, in another order.

use serde_json::{Map, Value, json};
use support::groups::{Names, Pair};

/// How a mechanism is looked at.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// By how many degrees the plane is turned.
    pub turned: f64,
    /// −1 for a mirror image in the x axis, made before it is turned; else 1.
    pub sense: f64,
    /// What a length becomes.
    pub length: f64,
    /// What a velocity is multiplied with besides; an acceleration twice.
    pub pace: f64,
}

impl Look {
    pub const SAME: Look = Look { turned: 0.0, sense: 1.0, length: 1.0, pace: 1.0 };

    /// A vector of the fixed frame, in lengths.
    pub fn vector(&self, [x, y]: Pair) -> Pair {
        let (sin, cos) = match self.turned {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            turned => libm::sincos(turned.to_radians()),
        };
        let (x, y) = (self.length * x, self.sense * self.length * y);
        [cos * x - sin * y, sin * x + cos * y]
    }

    /// An angle from +x, in degrees.
    pub fn angle(&self, degrees: f64) -> f64 {
        self.sense * degrees + self.turned
    }

    pub fn scene(&self, scene: &Value) -> Value {
        let drawn = scene.get("points").is_some();
        let mut scene = scene.clone();
        for key in ["ground", "points", "near"] {
            for (name, place) in entries(&mut scene[key]) {
                match place {
                    Value::Array(_) => self.put(place, 0),
                    Value::Number(_) if name.starts_with("angle(") => self.turn(place),
                    _ => {}
                }
            }
        }
        for (_, known) in entries(&mut scene["known"]) {
            self.motion(known);
        }
        for (_, link) in entries(&mut scene["links"]) {
            self.link(link);
        }
        for slider in scene["sliders"].as_array_mut().into_iter().flatten() {
            self.slider(slider, drawn);
        }
        for gear in scene["gears"].as_array_mut().into_iter().flatten().filter(|_| !drawn) {
            self.gear(gear);
        }
        for contact in scene["contacts"].as_array_mut().into_iter().flatten().filter(|_| !drawn) {
            self.contact(contact);
        }
        clean(scene)
    }

    /// A flat profile has the other body to its right: in the mirror its direction is the opposite one.
    fn contact(&self, contact: &mut Value) {
        for radius in contact["radii"].as_array_mut().into_iter().flatten() {
            *radius = json!(number(radius) * self.length);
        }
        let backwards = if self.sense < 0.0 { 180.0 } else { 0.0 };
        match &contact["along"] {
            Value::String(ends) if self.sense < 0.0 => {
                let (from, to) = ends.split_once('-').unwrap_or_else(|| ends.split_at(1));
                contact["along"] = json!(format!("{to}-{from}"));
            }
            Value::Number(along) => {
                let along = self.sense * along.as_f64().unwrap_or(0.0) + backwards;
                let turned = if contact["links"][1] == "ground" { self.turned } else { 0.0 };
                contact["along"] = json!(along + turned);
            }
            _ => {}
        }
    }

    /// Angles on a moving carrier turn with it, and those on the frame do not.
    fn gear(&self, gear: &mut Value) {
        let [first, second] = [0, 1].map(|wheel| number(&gear["teeth"][wheel]));
        let turned = if gear["on"] == "ground" { self.turned * (first + second) / second } else { 0.0 };
        // A wheel that is the frame does not turn either.
        let fixed = [0, 1].map(|wheel| f64::from(gear["mesh"][wheel] == "ground"));
        let fixed = self.turned * (fixed[0] * first + fixed[1] * second) / second;
        gear["phase"] = json!(self.sense * gear["phase"].as_f64().unwrap_or(0.0) + turned - fixed);
    }

    fn link(&self, link: &mut Value) {
        if !link.is_object() {
            return;
        }
        for (_, length) in entries(&mut link["lengths"]) {
            *length = json!(number(length) * self.length);
        }
        for (_, place) in entries(&mut link["shape"]) {
            self.put_own(place);
        }
        if link["drive"].is_object() {
            let drive = &mut link["drive"];
            if !drive["angle"].is_null() {
                self.turn(&mut drive["angle"]);
            }
            self.rate(&mut drive["omega"], self.sense, 1);
            self.rate(&mut drive["alpha"], self.sense, 2);
        }
        if link["motion"].is_object() {
            self.motion(&mut link["motion"]);
        }
    }

    /// A velocity, an acceleration and rates.
    fn motion(&self, motion: &mut Value) {
        for (key, order) in [("velocity", 1), ("acceleration", 2)] {
            if !motion[key].is_null() {
                self.put(&mut motion[key], order);
            }
        }
        self.rate(&mut motion["omega"], self.sense, 1);
        self.rate(&mut motion["alpha"], self.sense, 2);
    }

    fn slider(&self, slider: &mut Value, drawn: bool) {
        let on_ground = slider["on"] == "ground";
        if slider["through"].is_array() {
            if on_ground || drawn {
                self.put(&mut slider["through"], 0);
            } else {
                self.put_own(&mut slider["through"]);
            }
        }
        match &slider["along"] {
            Value::Array(_) if on_ground || drawn => self.put(&mut slider["along"], 0),
            Value::Array(_) => self.put_own(&mut slider["along"]),
            Value::String(_) => {}
            along if on_ground => {
                slider["along"] = json!(self.angle(along.as_f64().unwrap_or(0.0)));
            }
            along => slider["along"] = json!(self.sense * along.as_f64().unwrap_or(0.0)),
        }
        self.rate(&mut slider["turned"], self.sense, 0);
        if slider["drive"].is_object() {
            for (order, key) in ["position", "speed", "acceleration"].into_iter().enumerate() {
                self.rate(&mut slider["drive"][key], self.length, order);
            }
        }
    }

    fn put(&self, vector: &mut Value, order: usize) {
        let [x, y] = self.vector([number(&vector[0]), number(&vector[1])]);
        let pace = self.pace.powi(order as i32);
        *vector = json!([x * pace, y * pace]);
    }

    /// A place in a link's own frame.
    fn put_own(&self, place: &mut Value) {
        *place = match place {
            Value::Array(_) => json!([self.length * number(&place[0]), self.sense * self.length * number(&place[1])]),
            _ => json!(self.length * number(place)),
        };
    }

    fn turn(&self, angle: &mut Value) {
        *angle = json!(self.angle(number(angle)));
    }

    fn rate(&self, rate: &mut Value, factor: f64, order: usize) {
        if !rate.is_null() {
            *rate = json!(number(rate) * factor * self.pace.powi(order as i32));
        }
    }
}

fn entries(node: &mut Value) -> impl Iterator<Item = (&String, &mut Value)> {
    node.as_object_mut().into_iter().flatten()
}

fn number(node: &Value) -> f64 {
    node.as_f64().unwrap_or_else(|| panic!("{node} is no number"))
}

/// Without the nulls that asking for absent keys has left.
fn clean(node: Value) -> Value {
    match node {
        Value::Object(entries) => {
            let kept = entries.into_iter().filter(|(_, value)| !value.is_null());
            kept.map(|(key, value)| (key, clean(value))).collect()
        }
        Value::Array(elements) => elements.into_iter().map(clean).collect(),
        other => other,
    }
}

/// The scene with other names.
pub fn renamed(scene: &Value, names: &Names) -> Value {
    let point = |node: &mut Value| {
        if let Value::String(name) = node {
            *name = names.point(name);
        }
    };
    let mut scene = scene.clone();
    let known: Vec<String> = points(&scene);
    // Two points as "AB" or "A-B".
    let pair = |text: &str| {
        let split = text.split_once('-').or_else(|| {
            let cuts = text.char_indices().map(|(at, _)| text.split_at(at));
            cuts.into_iter().find(|(a, b)| [a, b].iter().all(|name| known.iter().any(|k| k == *name)))
        });
        let (a, b) = split.unwrap_or_else(|| panic!("{text} is no pair of points"));
        format!("{}-{}", names.point(a), names.point(b))
    };
    for key in ["ground", "points", "known"] {
        match &mut scene[key] {
            Value::Array(list) => list.iter_mut().for_each(point),
            other => rename_keys(other, |name| names.point(name)),
        }
    }
    rename_keys(&mut scene["near"], |name| match name.strip_prefix("angle(").and_then(|rest| rest.strip_suffix(')')) {
        Some(link) => format!("angle({})", names.link(link)),
        None => names.point(name),
    });
    rename_keys(&mut scene["links"], |name| names.link(name));
    for (_, link) in entries(&mut scene["links"]) {
        if let Value::Array(list) = link {
            list.iter_mut().for_each(point);
            continue;
        }
        link["points"].as_array_mut().into_iter().flatten().for_each(point);
        rename_keys(&mut link["shape"], |name| names.point(name));
        rename_keys(&mut link["lengths"], pair);
        if link["motion"].is_object() {
            point(&mut link["motion"]["at"]);
        }
    }
    for slider in scene["sliders"].as_array_mut().into_iter().flatten() {
        ["at", "pin", "through"].into_iter().for_each(|key| point(&mut slider[key]));
        for key in ["link", "on"] {
            if let Value::String(name) = &mut slider[key] {
                *name = names.link(name);
            }
        }
        if let Value::String(text) = &mut slider["along"] {
            *text = pair(text);
        }
    }
    for gear in scene["gears"].as_array_mut().into_iter().flatten() {
        let mesh = gear["mesh"].as_array_mut().map(std::mem::take).unwrap_or_default();
        let mesh: Vec<String> = mesh.iter().filter_map(Value::as_str).map(|name| names.link(name)).collect();
        gear["on"] = json!(names.link(gear["on"].as_str().unwrap_or_default()));
        gear["mesh"] = json!(mesh);
    }
    for contact in scene["contacts"].as_array_mut().into_iter().flatten() {
        contact["centers"].as_array_mut().into_iter().flatten().for_each(point);
        point(&mut contact["through"]);
        if let Value::String(text) = &mut contact["along"] {
            *text = pair(text);
        }
        let links = contact["links"].as_array_mut().into_iter().flatten();
        for link in links {
            *link = json!(names.link(link.as_str().unwrap_or_default()));
        }
        if let Value::String(name) = &mut contact["name"] {
            *name = names.link(name);
        }
    }
    clean(scene)
}

fn rename_keys(node: &mut Value, name: impl Fn(&str) -> String) {
    if let Value::Object(entries) = node {
        *entries = std::mem::take(entries).into_iter().map(|(key, value)| (name(&key), value)).collect();
    }
}

/// All names of points.
fn points(scene: &Value) -> Vec<String> {
    let mut names = Vec::new();
    let mut keys = |node: &Value| {
        let keys = node.as_object().into_iter().flat_map(Map::keys);
        names.extend(keys.cloned());
        let list = node.as_array().into_iter().flatten();
        names.extend(list.filter_map(|name| name.as_str().map(str::to_owned)));
    };
    keys(&scene["ground"]);
    keys(&scene["points"]);
    for link in scene["links"].as_object().into_iter().flat_map(Map::values) {
        keys(&link["points"]);
        keys(&link["shape"]);
    }
    names
}

/// The scene with links, sliders and ground points in the opposite order.
pub fn reversed(scene: &Value) -> Value {
    let mut scene = scene.clone();
    for key in ["ground", "points", "known", "links", "sliders", "gears", "contacts"] {
        match &mut scene[key] {
            Value::Array(list) => list.reverse(),
            Value::Object(entries) => *entries = std::mem::take(entries).into_iter().rev().collect(),
            _ => {}
        }
    }
    clean(scene)
}
