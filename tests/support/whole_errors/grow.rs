//! Random mechanisms that grow from a frame: cranks and pushed slides, then groups of all classes with pins, slides, slots
//! and cylinders on whatever is there. They are planted in a position, and written down as a person would, by numbers of
//! a few digits.

use crate::random::Random;
use serde_json::{Map, Value, json};

type Pair = [f64; 2];

/// A link (the frame is the first) with the places of its points.
struct Link {
    is_frame: bool,
    points: Vec<(String, Pair)>,
    angle: f64,
    /// The drive of a crank: its own object.
    drive: Option<Value>,
}

struct Slider {
    /// The sliding link; none for a pin.
    link: Option<usize>,
    at: String,
    on: usize,
    place: Pair,
    along: f64,
    drive: Option<[f64; 2]>,
}

/// A planted mechanism.
pub struct Grown {
    links: Vec<Link>,
    sliders: Vec<Slider>,
    names: usize,
}

/// A decimal of so many places.
fn short(x: f64, places: i32) -> f64 {
    let scale = libm::pow(10.0, f64::from(places));
    (x * scale).round() / scale
}

impl Grown {
    pub fn new(dice: &mut Random) -> Grown {
        let frame = Link { is_frame: true, points: Vec::new(), angle: 0.0, drive: None };
        let mut grown = Grown { links: vec![frame], sliders: Vec::new(), names: 0 };
        for _ in 0..1 + dice.below(3) {
            if dice.below(4) == 0 { grown.pushed_slide(dice) } else { grown.crank(dice) }
        }
        for _ in 0..1 + dice.below(3) {
            grown.group(dice);
        }
        grown
    }

    fn place(dice: &mut Random) -> Pair {
        [short(dice.within(150.0), 1), short(dice.within(150.0), 1)]
    }

    fn name(&mut self) -> String {
        self.names += 1;
        format!("P{}", self.names)
    }

    fn new_link(&mut self, dice: &mut Random) -> usize {
        self.links.push(Link { is_frame: false, points: Vec::new(), angle: short(dice.within(180.0), 1), drive: None });
        self.links.len() - 1
    }

    /// Puts a point with this place on links.
    fn pin(&mut self, links: &[usize], place: Pair) -> String {
        let name = self.name();
        for &link in links {
            self.links[link].points.push((name.clone(), place));
        }
        name
    }

    fn rate(dice: &mut Random) -> f64 {
        short(dice.within(20.0), 2)
    }

    fn crank(&mut self, dice: &mut Random) {
        let link = self.new_link(dice);
        let pivot = Grown::place(dice);
        self.pin(&[0, link], pivot);
        let angle = self.links[link].angle.to_radians();
        let length = 20.0 + 40.0 * dice.unit();
        self.pin(&[link], [pivot[0] + length * libm::cos(angle), pivot[1] + length * libm::sin(angle)]);
        if dice.below(3) == 0 {
            self.pin(&[link], Grown::place(dice));
        }
        let rate = if dice.below(4) == 0 { "rpm" } else { "omega" };
        let mut drive = json!({ rate: Grown::rate(dice) });
        if dice.below(2) == 0 {
            drive["alpha"] = json!(Grown::rate(dice));
        }
        self.links[link].drive = Some(drive);
    }

    fn pushed_slide(&mut self, dice: &mut Random) {
        let link = self.new_link(dice);
        let at = self.pin(&[link], Grown::place(dice));
        let place = self.links[link].points[0].1;
        self.pin(&[link], Grown::place(dice));
        if self.links[0].points.is_empty() {
            self.pin(&[0], Grown::place(dice));
        }
        self.slide(dice, Some(link), &at, 0, place, true);
    }

    fn slide(&mut self, dice: &mut Random, link: Option<usize>, at: &str, on: usize, place: Pair, driven: bool) {
        let drive = driven.then(|| [Grown::rate(dice), Grown::rate(dice)]);
        let along = short(dice.within(180.0), 1);
        self.sliders.push(Slider { link, at: at.to_owned(), on, place, along, drive });
    }

    /// A point of a link that is there already; the frame gets a new one.
    fn outer(&mut self, dice: &mut Random, there: usize) -> (usize, String, Pair) {
        let link = dice.below(there);
        if link == 0 || self.links[link].points.is_empty() {
            let place = Grown::place(dice);
            let name = self.pin(&[0], place);
            return (0, name, place);
        }
        let points = &self.links[link].points;
        let (name, place) = points[dice.below(points.len())].clone();
        (link, name, place)
    }

    /// Joins a new link to what was there before, by a pin or a slide.
    fn join_outside(&mut self, dice: &mut Random, link: usize, there: usize, slides: bool) {
        let (on, name, place) = self.outer(dice, there);
        if slides {
            // The link's own point slides on the body.
            let at = self.pin(&[link], Grown::place(dice));
            let place = self.links[link].points.last().map_or(place, |(_, place)| *place);
            self.slide(dice, Some(link), &at, on, place, false);
        } else {
            self.links[link].points.push((name, place));
        }
    }

    /// Joins two new links.
    fn join(&mut self, dice: &mut Random, a: usize, b: usize, slides: bool) {
        let place = Grown::place(dice);
        if slides {
            let at = self.pin(&[a], place);
            self.slide(dice, Some(a), &at, b, place, false);
        } else {
            self.pin(&[a, b], place);
        }
    }

    fn group(&mut self, dice: &mut Random) {
        let there = self.links.len();
        let slides = |dice: &mut Random| dice.below(4) == 0;
        match dice.below(8) {
            // A dyad.
            0..=2 => {
                let [a, b] = [0, 1].map(|_| self.new_link(dice));
                let kinds =
                    [[false; 3], [false, false, true], [false, true, false], [true, false, true], [false, true, true]];
                let kinds = kinds[dice.below(kinds.len())];
                self.join_outside(dice, a, there, kinds[0]);
                self.join(dice, a, b, kinds[1]);
                self.join_outside(dice, b, there, kinds[2]);
                if dice.below(3) == 0 {
                    self.pin(&[a], Grown::place(dice));
                }
            }
            // A lever with a slot for a pin.
            3 => {
                let moving = 1 + dice.below(there - 1);
                let points = self.links[moving].points.clone();
                if let Some((name, place)) = points.get(dice.below(points.len().max(1))) {
                    let lever = self.new_link(dice);
                    self.join_outside(dice, lever, there, false);
                    self.pin(&[lever], Grown::place(dice));
                    self.slide(dice, None, name, lever, *place, false);
                }
            }
            // A dyad one of whose links is a cylinder.
            4 => {
                let [a, b, c] = [0, 1, 2].map(|_| self.new_link(dice));
                self.join_outside(dice, a, there, false);
                let place = Grown::place(dice);
                let at = self.pin(&[b], place);
                self.slide(dice, Some(b), &at, a, place, true);
                self.join(dice, b, c, false);
                self.join_outside(dice, c, there, false);
            }
            // A third-class group.
            5 | 6 => {
                let center = self.new_link(dice);
                for _ in 0..3 {
                    let leg = self.new_link(dice);
                    let inner = slides(dice);
                    self.join(dice, center, leg, inner);
                    let outside = slides(dice) && !inner;
                    self.join_outside(dice, leg, there, outside);
                }
            }
            // A fourth-class group.
            _ => {
                let [a, b, c, d] = [0, 1, 2, 3].map(|_| self.new_link(dice));
                self.join_outside(dice, a, there, false);
                self.join_outside(dice, b, there, false);
                for (link, middle) in [(a, c), (a, d), (b, c), (b, d)] {
                    let slides = dice.below(6) == 0;
                    self.join(dice, link, middle, slides);
                }
            }
        }
    }

    /// The scene from lengths. With `given_angle` the first crank's angle is left out and that of this link given.
    pub fn scene(&self, dice: &mut Random, given_angle: Option<usize>) -> Value {
        let mut links = Map::new();
        let mut first_drive = true;
        for (index, link) in self.links.iter().enumerate().skip(1) {
            let mut given = self.shape(link, dice);
            if let Some(mut drive) = link.drive.clone() {
                if given_angle.is_none() || !first_drive {
                    drive["angle"] = json!(link.axis());
                }
                first_drive = false;
                given.insert("drive".to_owned(), drive);
            } else if given_angle == Some(index) {
                given.insert("angle".to_owned(), json!(short(link.axis(), 1)));
            }
            links.insert(format!("b{index}"), Value::Object(given));
        }
        let sliders: Vec<Value> = self.sliders.iter().map(|slider| self.slider(slider, dice)).collect();
        let near: Map<String, Value> = self.links[1..]
            .iter()
            .flat_map(|link| &link.points)
            .filter(|(name, _)| !self.links[0].points.iter().any(|(fixed, _)| fixed == name))
            .map(|(name, place)| (name.clone(), json!(place.map(|x| short(x, 1)))))
            .collect();
        let ground: Map<String, Value> =
            self.links[0].points.iter().map(|(name, place)| (name.clone(), json!(place))).collect();
        let mut scene = json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s" },
            "ground": ground, "links": links, "sliders": sliders, "near": near,
        });
        for (index, link) in self.links.iter().enumerate().skip(1) {
            if link.points.len() == 1 {
                scene["near"][format!("angle(b{index})")] = json!(link.axis());
            }
        }
        if dice.below(6) == 0 {
            move_away(&mut scene, [short(dice.within(1e6), 1), short(dice.within(1e6), 1)]);
        }
        scene
    }

    fn shape(&self, link: &Link, dice: &mut Random) -> Map<String, Value> {
        let distance = |a: Pair, b: Pair| short(libm::hypot(b[0] - a[0], b[1] - a[1]), 2);
        let named = |[a, b]: [usize; 2]| {
            let [(p, at), (q, to)] = [&link.points[a], &link.points[b]];
            (format!("{p}-{q}"), json!(distance(*at, *to)))
        };
        let names: Vec<&str> = link.points.iter().map(|(name, _)| name.as_str()).collect();
        // Guides on a link need coordinates of its own.
        let carries = self.sliders.iter().any(|s| std::ptr::eq(link, &self.links[s.on]));
        let is_plain =
            !carries && self.sliders.iter().all(|s| s.link.is_none_or(|l| !std::ptr::eq(link, &self.links[l])));
        let mut given = Map::new();
        match names.len() {
            0 | 1 => {
                given.insert("points".to_owned(), json!(names));
            }
            count @ (2 | 3) if is_plain && dice.below(2) == 0 => {
                let pairs: &[[usize; 2]] = if count == 2 { &[[0, 1]] } else { &[[0, 1], [0, 2], [1, 2]] };
                given.insert("points".to_owned(), json!(names));
                let lengths: Map<String, Value> = pairs.iter().map(|&pair| named(pair)).collect();
                given.insert("lengths".to_owned(), Value::Object(lengths));
            }
            _ => {
                let own = link.points.iter().map(|(name, place)| (name.clone(), json!(link.own(*place))));
                given.insert("shape".to_owned(), Value::Object(own.collect()));
            }
        }
        given
    }

    fn slider(&self, slider: &Slider, dice: &mut Random) -> Value {
        let on = &self.links[slider.on];
        let on_name = if slider.on == 0 { "ground".to_owned() } else { format!("b{}", slider.on) };
        let along = short(slider.along - on.axis(), 1);
        let (sin, cos) = libm::sincos(slider.along.to_radians());
        let back = slider.drive.map_or(30.0, |[position, _]| position);
        let through = on.own([slider.place[0] - back * cos, slider.place[1] - back * sin]);
        let mut given = json!({ "on": on_name, "through": through, "along": along });
        match slider.link {
            Some(link) => {
                given["link"] = json!(format!("b{link}"));
                given["at"] = json!(slider.at);
                given["turned"] = json!(short(self.links[link].axis() - slider.along, 1));
            }
            None => given["pin"] = json!(slider.at),
        }
        if let Some([position, speed]) = slider.drive {
            given["drive"] = json!({ "position": position, "speed": speed, "acceleration": Grown::rate(dice) });
        }
        given
    }

    pub fn links(&self) -> usize {
        self.links.len()
    }

    pub fn is_driven(&self, link: usize) -> bool {
        self.links[link].drive.is_some()
    }

    pub fn cranks(&self) -> usize {
        self.links.iter().filter(|l| l.drive.is_some()).count()
    }
}

impl Link {
    /// The angle of its axis in degrees.
    fn axis(&self) -> f64 {
        match self.points.as_slice() {
            _ if self.is_frame => 0.0,
            [(_, a), (_, b), ..] => short(libm::atan2(b[1] - a[1], b[0] - a[0]).to_degrees(), 2),
            _ => self.angle,
        }
    }

    /// A place in its own frame: from its first point, x along its axis.
    fn own(&self, place: Pair) -> Pair {
        let Some((_, origin)) = self.points.first().filter(|_| !self.is_frame) else {
            return place.map(|x| short(x, 2));
        };
        let (sin, cos) = libm::sincos(self.axis().to_radians());
        let [x, y] = [place[0] - origin[0], place[1] - origin[1]];
        [short(cos * x + sin * y, 2), short(cos * y - sin * x, 2)]
    }
}

/// Moves the frame of a scene far away.
fn move_away(scene: &mut Value, by: Pair) {
    for key in ["ground", "near"] {
        for (name, place) in scene[key].as_object_mut().expect("an object") {
            if !name.starts_with("angle") {
                *place = json!([0, 1].map(|i| short(place[i].as_f64().expect("a number") + by[i], 1)));
            }
        }
    }
    for slider in scene["sliders"].as_array_mut().expect("a list") {
        if slider["on"] == "ground" {
            slider["through"] =
                json!([0, 1].map(|i| short(slider["through"][i].as_f64().expect("a number") + by[i], 2)));
        }
    }
}
