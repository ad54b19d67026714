//! What the sheets of a student and of a teacher have beside the figure: the given numbers in sentences, and the rows of the key.

use crate::check::{BANDS, asked_names};
use crate::construction::{Solution, contacts_told, display};
use crate::drawing::{Drawing, KeyRow, drawing_sheets};
use crate::quantity::{Pencil, QuantityKind, QuantityRequest};
use crate::scene::{Along, At, GivenBy, On, Scene, Shape};
use crate::sheet::{Order, Scales, Sheet};
use crate::words::{Medium, NumberStyle, SlidePart, SliderNames, Wording, under};
use indexmap::IndexMap;
use serde_json::Value;

impl Solution {
    /// The sheets on which the plans that the figure shows are drawn by hand, at the scales of the figure: first the
    /// scheme with the given numbers and a table of the form's quantities to be filled in, then sheets with the poles of
    /// the plans, last the table where it has no room beside the scheme.
    ///
    /// Those with panels have markers and a small code, [`Drawing::code`], by which a photograph of them is read, unless
    /// [`has_markers`](crate::scene::Figure::has_markers) says no; the first has none either where the scheme has no room
    /// between them. `name` stands in the codes.
    ///
    /// ```
    /// let scene = kinegon::Scene::read(include_str!("../../examples/figure-2.json"))?;
    /// let sheets = kinegon::solve(&scene)?.drawing_sheets("figure-2");
    /// let code = sheets[1].code.as_ref().expect("markers and a code");
    /// assert_eq!((code.number, code.name.as_str()), (2, "FIGURE-2"));
    /// // The pole of the first plan stands at whole millimetres.
    /// assert!(code.panels[0].origin.iter().all(|mm| mm.fract() == 0.0));
    /// # Ok::<(), kinegon::Error>(())
    /// ```
    #[must_use]
    pub fn drawing_sheets(&self, name: &str) -> Vec<Drawing> {
        let scales = self.scales();
        let mut own = self.clone();
        let figure = &mut own.scene.figure;
        figure.worksheet = false;
        // A sheet for the hand has letters for the hand, in a style for the hall too.
        figure.sizes.get_or_insert_default();
        let names = asked_names(&own);
        let asked: Vec<QuantityRequest> =
            names.iter().filter_map(|name| QuantityRequest::new(name, &own.mechanism).ok()).collect();
        let given = sentences(&own, &scales);
        drawing_sheets(&own, &scales, name, &asked, &given)
    }
}

/// The quantities of a form with their exact values, and what a careful hand is allowed; those without a value are left
/// out.
pub(super) fn key_rows<'a>(solution: &Solution, pencil: &'a Pencil) -> Vec<KeyRow<'a>> {
    let rows = pencil.quantities.iter().filter_map(|(asked, band)| {
        let value = asked.value(&solution.snapshot(), Some(&solution.construction), None).ok()?.as_number();
        Some(KeyRow { asked, value, allowed: band.as_ref().ok().map(|band| BANDS * band.band) })
    });
    rows.collect()
}

/// The sentences with all given numbers and with the scales of the plans, in markup. Vectors are given as in the
/// scene's text, by components or by size and direction.
pub(super) fn sentences(solution: &Solution, scales: &Scales) -> Vec<String> {
    let scene = &solution.scene;
    let file = serde_json::from_str(scene.text()).unwrap_or(Value::Null);
    let words = &Wording::of(&scene.figure);
    let teller = Teller { scene, words };
    let mut all = Vec::new();
    // The scheme of a drawn scene shows its points and guides.
    if scene.given_by == GivenBy::Lengths {
        all.extend(teller.lengths());
        all.extend(teller.guides());
    }
    all.extend(teller.teeth());
    all.extend(teller.drives(&file));
    all.extend(teller.motions(&file));
    all.extend(teller.loads(solution, &file));
    let scale = |(plan, mu): (Sheet, f64)| {
        let unit = plan.facts().drawn.unit(scene.units);
        format!("{} = {} ({unit})/mm", plan.facts().scale_symbol, teller.number(mu))
    };
    let of = |is_meant: fn(Sheet) -> bool| -> Vec<String> {
        scales.given().filter(|(sheet, _)| is_meant(*sheet)).map(scale).collect()
    };
    let (plans, centers) = (of(|sheet| sheet.order().is_some()), of(|sheet| sheet == Sheet::Centers));
    let (forces, levers) = (of(|sheet| sheet == Sheet::Forces), of(|sheet| sheet == Sheet::Lever));
    let scheme = of(|sheet| sheet == Sheet::Scheme);
    let has_none = [&centers, &forces, &levers].iter().all(|scales| scales.is_empty());
    let language = words.language;
    let draw = (!plans.is_empty() || has_none).then(|| language.exercise_draw(&listed(&plans)));
    let find = (!centers.is_empty()).then(|| language.exercise_centers(&listed(&centers)));
    // Arms are measured on the scheme.
    let balance = (!forces.is_empty()).then(|| language.exercise_forces(&listed(&[scheme, forces].concat())));
    let lever = (!levers.is_empty()).then(|| language.exercise_lever(&listed(&levers)));
    let given = std::iter::once(language.exercise_given(&listed(&all)));
    let contacts = contacts_told(&solution.mechanism, words, &display);
    given.chain(contacts).chain(find).chain(draw).chain(balance).chain(lever).collect()
}

/// A list that can be broken into lines between its items only.
fn listed(items: &[String]) -> String {
    let items: Vec<String> = items.iter().map(|item| item.replace(' ', "\u{a0}")).collect();
    items.join(", ")
}

/// Two points as one writes the line between them.
fn line(from: &str, to: &str) -> String {
    let between = if [from, to].iter().all(|name| name.chars().count() == 1) { "" } else { " " };
    format!("{from}{between}{to}")
}

/// The distances by which the points of a link are found from one another, where it has their coordinates: each from the first two.
fn distances(places: &IndexMap<String, [f64; 2]>) -> Vec<(String, f64)> {
    let points: Vec<(&String, &[f64; 2])> = places.iter().collect();
    let pairs = (1..points.len()).flat_map(|to| (0..to.min(2)).map(move |from| (from, to)));
    let distance = |(from, to): (usize, usize)| {
        let ((a, [x, y]), (b, [u, v])) = (points[from], points[to]);
        (line(a, b), libm::hypot(u - x, v - y))
    };
    pairs.map(distance).collect()
}

/// The line from the first to the second point of a link whose coordinates do not have it as their axis, with the degrees by which it is
/// turned from that axis: nobody sees the axis on a sheet.
fn first_line(shape: &Shape) -> Option<(String, f64)> {
    let Shape::Local(places) = shape else { return None };
    let ((a, [x, y]), (b, [u, v])) = (places.get_index(0)?, places.get_index(1)?);
    let turned = libm::atan2(v - y, u - x).to_degrees();
    (turned != 0.0).then(|| (line(a, b), turned))
}

pub(super) struct Teller<'a> {
    pub scene: &'a Scene,
    pub words: &'a Wording,
}

impl Teller<'_> {
    /// A number as people write it: more digits than six serve no drawing.
    pub fn number(&self, x: f64) -> String {
        self.words.write(x, NumberStyle::significant(6).trimmed().on(Medium::Figure))
    }

    pub fn unit(&self, kind: QuantityKind) -> String {
        kind.unit(self.scene.units)
    }

    /// A symbol with its value and unit; zero is written without a unit.
    pub fn value(&self, symbol: &str, x: f64, kind: QuantityKind) -> String {
        let value = self.number(x);
        match (x == 0.0, kind) {
            (_, QuantityKind::Angle) => format!("{symbol} = {value}°"),
            (true, _) => format!("{symbol} = {value}"),
            (_, QuantityKind::SpeedRatio) => format!("{symbol} = {value}"),
            _ => format!("{symbol} = {value} {}", self.unit(kind)),
        }
    }

    pub fn pair(&self, place: [f64; 2]) -> String {
        self.words.place(place.map(|x| self.number(x)))
    }

    /// Fixed points and lengths.
    fn lengths(&self) -> Vec<String> {
        let unit = self.unit(QuantityKind::Length);
        let fixed = self.scene.coordinates.iter().map(|(name, place)| format!("{name} {} {unit}", self.pair(*place)));
        let lengths = self.scene.links.values().flat_map(|link| match &link.shape {
            Shape::Lengths(lengths) => {
                lengths.iter().map(|length| (length.key.replace('-', " "), length.value)).collect()
            }
            Shape::Local(places) => distances(places),
            Shape::Bare => Vec::new(),
        });
        fixed.chain(lengths.map(|(name, length)| self.value(&name, length, QuantityKind::Length))).collect()
    }

    /// Guides on the ground and those along two points of a link.
    fn guides(&self) -> Vec<String> {
        let language = self.words.language;
        let unit = self.unit(QuantityKind::Length);
        let told = self.scene.sliders.iter().filter_map(|slider| {
            let name = slider.link.as_ref().or(slider.pin.as_ref())?;
            let degrees = match (&slider.along, &slider.on) {
                (Along::Points(a, b), _) => return Some(language.exercise_guide_through(name, &format!("{a}{b}"))),
                (Along::Degrees(degrees), On::Ground) => *degrees,
                (Along::Direction([x, y]), On::Ground) => libm::atan2(*y, *x).to_degrees(),
                _ => return None,
            };
            let place = match &slider.through {
                Some(At::Point(point)) => point.clone(),
                Some(At::Place(place)) => format!("{} {unit}", self.pair(*place)),
                None => self.scene.ground.first()?.clone(),
            };
            Some(language.exercise_guide(name, &place, &self.number(degrees)))
        });
        told.collect()
    }

    /// The teeth of each mesh; of one on a moving carrier with its name.
    fn teeth(&self) -> Vec<String> {
        let language = self.words.language;
        let told = self.scene.gears.iter().map(|gear| {
            let wheel = |side: usize| {
                let teeth = gear.teeth[side];
                let number = self.number(f64::from(teeth.abs()));
                match (&gear.wheels[side], teeth < 0) {
                    (On::Link(link), false) => language.exercise_wheel(link, &number),
                    (On::Link(link), true) => language.exercise_ring(link, &number),
                    (On::Ground, false) => language.exercise_fixed_wheel(&number),
                    (On::Ground, true) => language.exercise_fixed_ring(&number),
                }
            };
            match &gear.on {
                On::Ground => language.exercise_mesh(&wheel(0), &wheel(1)),
                On::Link(arm) => language.exercise_mesh_on(&wheel(0), &wheel(1), arm),
            }
        });
        told.collect()
    }

    /// Drives in the units in which the file gives them.
    fn drives(&self, file: &Value) -> Vec<String> {
        let mut told = Vec::new();
        for (name, link) in &self.scene.links {
            let angle = link.angle_deg.or(link.drive.and_then(|d| d.angle_deg));
            told.extend(angle.map(|axis| {
                let (of, turned) = first_line(&link.shape).unwrap_or_else(|| (name.clone(), 0.0));
                self.value(&format!("φ_{{{of}}}"), axis + turned, QuantityKind::Angle)
            }));
            if let Some(drive) = &link.drive {
                let [omega, alpha] = self.turning(name, drive.omega, drive.alpha);
                let rpm = file["links"][name]["drive"]["rpm"].as_f64();
                told.push(rpm.map_or(omega, |rpm| format!("n_{{{name}}} = {} rpm", self.number(rpm))));
                told.push(alpha);
            }
        }
        for slider in &self.scene.sliders {
            let (Some(drive), Some(link), Some(at)) = (&slider.drive, &slider.link, &slider.at) else {
                continue;
            };
            let on = match &slider.on {
                On::Ground => self.words.ground(),
                On::Link(on) => on,
            };
            let points = [link.as_str(), on].map(|link| under(at, link));
            let names = SliderNames { pair: format!("{link}/{on}"), points };
            let position = drive.position;
            told.extend(position.map(|x| self.value(&format!("s({})", names.pair), x, QuantityKind::Length)));
            let [v, a] = Order::ALL.map(|of| self.words.notation.slide(of, SlidePart::Relative, &names).markup());
            told.push(self.value(&v, drive.speed, QuantityKind::Velocity));
            told.push(self.value(&a, drive.acceleration, QuantityKind::Acceleration));
        }
        told
    }

    fn turning(&self, link: &str, omega: f64, alpha: f64) -> [String; 2] {
        [
            self.value(&format!("ω_{{{link}}}"), omega, QuantityKind::AngularVelocity),
            self.value(&format!("α_{{{link}}}"), alpha, QuantityKind::AngularAcceleration),
        ]
    }

    /// Given motions of a drawn scene.
    fn motions(&self, file: &Value) -> Vec<String> {
        let mut told = Vec::new();
        for (name, motion) in &self.scene.known {
            let written = &file["known"][name];
            told.extend(self.both(name, [motion.velocity, motion.acceleration], written));
        }
        for (name, link) in &self.scene.links {
            let Some(motion) = &link.motion else {
                continue;
            };
            let at = match &motion.at {
                At::Point(point) => point.clone(),
                At::Place(place) => self.pair(*place),
            };
            let written = &file["links"][name]["motion"];
            told.extend(self.both(&at, [motion.velocity, motion.acceleration], written));
            told.extend(self.turning(name, motion.omega, motion.alpha));
        }
        told
    }

    fn both(&self, at: &str, vectors: [[f64; 2]; 2], written: &Value) -> Vec<String> {
        let kinds = [("v", "velocity", QuantityKind::Velocity), ("a", "acceleration", QuantityKind::Acceleration)];
        let told = kinds.into_iter().zip(vectors).map(|((letter, key, kind), vector)| {
            let symbol = format!("{letter}_{{{at}}}");
            let polar = ["size", "angle"].map(|part| written[key][part].as_f64());
            match (polar, vector) {
                (_, [0.0, 0.0]) => format!("{symbol} = 0"),
                ([Some(size), Some(angle)], _) => {
                    let size = format!("{} {}", self.number(size), self.unit(kind));
                    format!("{symbol} = {}", self.words.language.with_direction(&size, &self.number(angle)))
                }
                _ => format!("{symbol} = {} {}", self.pair(vector), self.unit(kind)),
            }
        });
        told.collect()
    }
}
