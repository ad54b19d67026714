//! How a scene truly stands and moves, with 256 bits, from its file alone: every link has a place and an angle of its own,
//! every joint its equations. No loops, groups or frames of the library are used; only the position to start from.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use std::collections::BTreeMap;

/// A number of 256 bits.
pub type Real = FBig<HalfEven, 2>;
pub type Pair = [Real; 2];

const BITS: usize = 256;

/// Newton's method ends after a correction below this.
const LAST: f64 = 1e-45;

pub fn exactly(x: f64) -> Real {
    Real::try_from(x).expect("finite").with_precision(BITS).value()
}

/// The nearest f64.
pub fn rounded(x: &Real) -> f64 {
    x.to_f64().value()
}

/// By how much a number is wrong.
pub fn error(number: f64, truth: &Real) -> f64 {
    rounded(&(exactly(number) - truth.clone())).abs()
}

/// The decimal number that stands in the scene.
pub fn number(value: &Value) -> Real {
    decimal(&format!("{:e}", value.as_f64().expect("a number")))
}

/// The decimal number that `text` writes, exactly but for the last of 256 bits.
pub fn decimal(text: &str) -> Real {
    let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, rest)| rest.len() as i32);
    let digits: i128 = mantissa.replace('.', "").parse().expect("digits");
    let power = power.parse::<i32>().expect("a power") - decimals;
    let scale = (0..power.abs()).fold(exactly(1.0), |scale, _| scale * exactly(10.0));
    let whole = Real::from(digits).with_precision(BITS).value();
    if power < 0 { whole / scale } else { whole * scale }
}

pub(super) fn pair(value: &Value) -> Pair {
    // A lone number is a distance along the axis.
    if value.is_number() { [number(value), exactly(0.0)] } else { [number(&value[0]), number(&value[1])] }
}

/// Cosine and sine of an angle in degrees.
pub fn direction(degrees: &Value) -> Pair {
    direction_of(&number(degrees))
}

/// The same, by Taylor's series of a sixteenth of what is left without whole turns.
pub fn direction_of(degrees: &Real) -> Pair {
    let turns = (rounded(degrees) / 360.0).round();
    let turned = (degrees - exactly(turns) * exactly(360.0)) * pi() / exactly(180.0 * 16.0);
    let square = turned.clone() * turned.clone();
    let series = |first: u32| {
        (0..40).rev().fold(exactly(1.0), |rest, term| {
            let k = f64::from(first + 2 * term);
            exactly(1.0) - square.clone() * rest / exactly(k * (k + 1.0))
        })
    };
    let mut direction = [series(1), turned.clone() * series(2)];
    for _ in 0..4 {
        direction = turn(&direction, &direction);
    }
    direction
}

/// Machin's formula.
pub(super) fn pi() -> Real {
    let arctangent = |k: f64| {
        let square = exactly(k * k);
        let (mut power, mut sum) = (exactly(1.0) / exactly(k), exactly(0.0));
        for term in 0..120 {
            let part = power.clone() / exactly(f64::from(2 * term + 1));
            sum = if term % 2 == 0 { sum + part } else { sum - part };
            power /= square.clone();
        }
        sum
    };
    exactly(16.0) * arctangent(5.0) - exactly(4.0) * arctangent(239.0)
}

/// `v` turned by the angle of `by`.
pub(super) fn turn(by: &Pair, v: &Pair) -> Pair {
    [&by[0] * &v[0] - &by[1] * &v[1], &by[0] * &v[1] + &by[1] * &v[0]]
}

pub(super) fn quarter(v: &Pair) -> Pair {
    [-v[1].clone(), v[0].clone()]
}

pub fn plus(a: &Pair, b: &Pair) -> Pair {
    [&a[0] + &b[0], &a[1] + &b[1]]
}

pub fn minus(a: &Pair, b: &Pair) -> Pair {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

pub(super) fn times(v: &Pair, s: &Real) -> Pair {
    [&v[0] * s, &v[1] * s]
}

pub fn dot(a: &Pair, b: &Pair) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1]
}

pub fn cross(a: &Pair, b: &Pair) -> Real {
    &a[0] * &b[1] - &a[1] * &b[0]
}

pub(super) fn unit(v: &Pair) -> Pair {
    let length = dot(v, v).sqrt();
    [&v[0] / &length, &v[1] / &length]
}

/// A link (the frame is the first): its points on itself, and where it is.
pub(super) struct Link {
    pub(super) name: String,
    pub(super) points: Vec<(String, Pair)>,
    pub(super) origin: Pair,
    /// Cosine and sine of its angle.
    pub(super) angle: Pair,
    pub(super) rates: [Rates; 2],
}

/// Rates of a link: of its origin and of its angle.
#[derive(Clone)]
pub(super) struct Rates {
    origin: Pair,
    pub(super) turn: Real,
}

impl Link {
    pub(super) fn place(&self, own: &Pair) -> Pair {
        plus(&self.origin, &turn(&self.angle, own))
    }

    pub(super) fn own(&self, name: &str) -> Option<&Pair> {
        self.points.iter().find(|(n, _)| n == name).map(|(_, own)| own)
    }

    /// Velocity and acceleration of its point at `place`.
    pub(super) fn motion(&self, place: &Pair) -> [Pair; 2] {
        let [first, second] = &self.rates;
        let arm = minus(place, &self.origin);
        let velocity = plus(&first.origin, &times(&quarter(&arm), &first.turn));
        let swing = minus(&times(&quarter(&arm), &second.turn), &times(&arm, &(&first.turn * &first.turn)));
        [velocity, plus(&second.origin, &swing)]
    }
}

/// A guide and what slides on it.
pub(super) struct Guide {
    name: String,
    /// The sliding link, which keeps its angle; none for a pin.
    pub(super) link: Option<usize>,
    /// Some link with the sliding point, and the point on it.
    pub(super) carrier: usize,
    pub(super) at: String,
    pub(super) on: usize,
    /// On the link with the guide: a place of the guide and its unit direction.
    through: Pair,
    along: Pair,
    /// From the guide to the sliding link.
    turned: Pair,
    /// Position, speed and acceleration.
    pub(super) drive: Option<[Real; 3]>,
    /// How far the point is from the guide, to its right: of a pin on a flat profile the radius about it.
    beside: Real,
}

/// What wheels keep, or a wheel and what slides: Σ weight · angle = constant + Σ weight · position / radius.
struct Tie {
    turning: Vec<(usize, i64)>,
    /// By guide.
    sliding: Vec<(usize, Real)>,
    /// In degrees.
    constant: Real,
}

/// Two round profiles that touch: the links, their centres, and how far these are apart.
pub(super) struct Touch {
    pub(super) ends: [(usize, String); 2],
    apart: Real,
}

/// An equation: its gap, its coefficients by unknown rate, and its right sides for velocities and accelerations.
struct Equation {
    gap: Real,
    terms: Vec<(usize, Real)>,
    sides: [Real; 2],
}

/// A scene from lengths or as drawn.
pub struct Truth {
    pub(super) links: Vec<Link>,
    pub(super) guides: Vec<Guide>,
    ties: Vec<Tie>,
    pub(super) touches: Vec<Touch>,
    /// Links with a given angle, and those that are driven: angular velocity and acceleration.
    angles: Vec<(usize, Pair)>,
    pub(super) drives: Vec<(usize, [Real; 2])>,
    is_drawn: bool,
}

/// The true motion of a point.
pub struct PointTruth {
    pub place: Pair,
    pub motion: [Pair; 2],
}

/// The true motion of a slider.
pub struct SliderTruth {
    pub name: String,
    pub position: Option<Real>,
    pub rates: [Real; 2],
    pub coriolis: Pair,
}

impl Truth {
    /// The truth of a scene near an approximate position: `places` by name of the points, `axes` by link. `None` where
    /// Newton's method does not get there.
    pub fn new(scene: &Value, places: &BTreeMap<String, [f64; 2]>, axes: &BTreeMap<String, [f64; 2]>) -> Option<Truth> {
        let mut truth = Truth::read(scene, places, axes);
        if !truth.is_drawn {
            truth.find_places()?;
        }
        truth.find_rates()?;
        Some(truth)
    }

    fn read(scene: &Value, places: &BTreeMap<String, [f64; 2]>, axes: &BTreeMap<String, [f64; 2]>) -> Truth {
        let is_drawn = scene.get("points").is_some();
        let none = || [exactly(0.0), exactly(0.0)];
        let still = Rates { origin: none(), turn: exactly(0.0) };
        let drawn = |name: &str| pair(&scene["points"][name]);
        let link = |name: &str, points: Vec<(String, Pair)>| {
            let exact = |[x, y]: [f64; 2]| [exactly(x), exactly(y)];
            let angle = match axes.get(name) {
                Some(&axis) if !is_drawn => unit(&exact(axis)),
                _ => [exactly(1.0), exactly(0.0)],
            };
            let origin = match points.first() {
                Some((first, own)) if name != "ground" && !is_drawn => minus(&exact(places[first]), &turn(&angle, own)),
                _ => none(),
            };
            Link { name: name.to_owned(), points, origin, angle, rates: [still.clone(), still.clone()] }
        };
        let ground: Vec<(String, Pair)> = match &scene["ground"] {
            Value::Object(ground) => ground.iter().map(|(name, at)| (name.clone(), pair(at))).collect(),
            names => texts(names).map(|name| (name.to_owned(), drawn(name))).collect(),
        };
        let mut links = vec![link("ground", ground)];
        for (name, given) in scene["links"].as_object().expect("links") {
            let own = match is_drawn {
                true => texts(given.get("points").unwrap_or(given)).map(|p| (p.to_owned(), drawn(p))).collect(),
                false => shape(given, places),
            };
            links.push(link(name, own));
        }
        let index = |name: &str| links.iter().position(|l| l.name == name).expect("a link");
        let mut truth = Truth {
            guides: Vec::new(),
            ties: Vec::new(),
            touches: Vec::new(),
            angles: Vec::new(),
            drives: Vec::new(),
            is_drawn,
            links: Vec::new(),
        };
        for (name, given) in scene["links"].as_object().expect("links") {
            if let Some(angle) = given.get("angle").or(given["drive"].get("angle")) {
                truth.angles.push((index(name), direction(angle)));
            }
            let drive = &given["drive"];
            let number = |key: &str| drive.get(key).map(number);
            let turns = || number("rpm").map(|rpm| rpm * pi() / exactly(30.0));
            if let Some(omega) = number("omega").or_else(turns) {
                truth.drives.push((index(name), [omega, number("alpha").unwrap_or(exactly(0.0))]));
            }
        }
        for given in scene["sliders"].as_array().into_iter().flatten() {
            // A drive may stand in the sliding link.
            let mut given = given.clone();
            let drive = given["link"].as_str().map(|link| scene["links"][link]["drive"].clone()).unwrap_or_default();
            if drive.get("speed").is_some() {
                given["drive"] = drive;
            }
            truth.guides.push(guide(&given, &links, is_drawn));
        }
        for given in scene["contacts"].as_array().into_iter().flatten() {
            let own = |which: usize| {
                let link = index(given["links"][which].as_str().expect("a link"));
                (link, given["centers"][which].as_str().unwrap_or_default().to_owned())
            };
            let radius = |which: usize| number(&given["radii"][which]);
            if given.get("along").is_some() {
                let (carrier, at) = own(0);
                let mut face = given.clone();
                face["on"] = given["links"][1].clone();
                face["pin"] = at.clone().into();
                truth.guides.push(Guide { carrier, beside: radius(0), ..guide(&face, &links, is_drawn) });
            } else {
                truth.touches.push(Touch { ends: [own(0), own(1)], apart: radius(0) + radius(1) });
            }
        }
        truth.links = links;
        for given in scene["gears"].as_array().into_iter().flatten() {
            let tie = truth.tie(given);
            truth.ties.push(tie);
        }
        truth
    }

    /// What a pair of wheels keeps, z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ = z₂ · phase, or a wheel and its rack, r (θ₁ − θ) = ± (s − position).
    fn tie(&self, given: &Value) -> Tie {
        let index =
            |name: &Value| self.links.iter().position(|l| Some(l.name.as_str()) == name.as_str()).expect("a link");
        let (wheels, carrier) = ([index(&given["mesh"][0]), index(&given["mesh"][1])], index(&given["on"]));
        let is_rack = |which: usize| given["teeth"][which] == "rack";
        if !is_rack(0) && !is_rack(1) {
            let [first, second] = [0, 1].map(|which: usize| given["teeth"][which].as_f64().expect("teeth") as i64);
            let second = if given["belt"] == "open" { -second } else { second };
            let phase = given.get("phase").map_or(exactly(0.0), number);
            let turning = vec![(wheels[0], first), (wheels[1], second), (carrier, -(first + second))];
            return Tie { turning, sliding: Vec::new(), constant: phase * exactly(second as f64) };
        }
        let [wheel, rack] = if is_rack(0) { [wheels[1], wheels[0]] } else { wheels };
        let slides = |link: usize, on: usize| self.guides.iter().position(|g| g.link == Some(link) && g.on == on);
        let guides = match slides(rack, carrier).or_else(|| slides(carrier, rack)) {
            Some(only) => vec![only],
            None => vec![
                slides(carrier, 0).expect("a carrier on the ground"),
                slides(rack, 0).expect("a rack on the ground"),
            ],
        };
        // On which side of the wheel the pitch line is, and which guides run the other way.
        let near = |v: &Pair| [rounded(&v[0]), rounded(&v[1])];
        let lines: Vec<[[f64; 2]; 2]> =
            guides.iter().map(|&g| self.guide_line(&self.guides[g]).map(|v| near(&v))).collect();
        let [along, through] = lines[lines.len() - 1];
        let shared =
            |(name, own): &(String, Pair)| self.links[carrier].own(name).map(|_| near(&self.links[wheel].place(own)));
        let center = self.links[wheel].points.iter().find_map(shared).expect("the wheel's axis");
        let off = along[0] * (center[1] - through[1]) - along[1] * (center[0] - through[0]);
        let side = if off < -1e-9 { -1.0 } else { 1.0 };
        let radius = number(&given["radius"]);
        let sign = |guide: usize, [other, _]: [[f64; 2]; 2]| {
            let onwards = if self.guides[guide].link == Some(carrier) { -side } else { side };
            if other[0] * along[0] + other[1] * along[1] < 0.0 { -onwards } else { onwards }
        };
        let signs: Vec<f64> = guides.iter().zip(&lines).map(|(&guide, &line)| sign(guide, line)).collect();
        let start = given.get("position").map_or(exactly(0.0), number) * exactly(signs[signs.len() - 1]);
        let sliding = guides.into_iter().zip(signs).map(|(guide, sign)| (guide, exactly(sign) / &radius));
        let constant = -start / &radius * exactly(180.0) / pi();
        Tie { turning: vec![(wheel, 1), (carrier, -1)], sliding: sliding.collect(), constant }
    }

    /// The unknowns of a link begin here; the frame has none.
    pub(super) fn column(link: usize) -> Option<usize> {
        link.checked_sub(1).map(|moving| 3 * moving)
    }

    /// The coefficients of the component along `direction` of the velocity of a link's point at `place`, times `sign`.
    pub(super) fn add(&self, terms: &mut Vec<(usize, Real)>, link: usize, place: &Pair, direction: &Pair, sign: f64) {
        if let Some(column) = Truth::column(link) {
            let arm = minus(place, &self.links[link].origin);
            let sign = exactly(sign);
            terms.push((column, &direction[0] * &sign));
            terms.push((column + 1, &direction[1] * &sign));
            terms.push((column + 2, cross(&arm, direction) * sign));
        }
    }

    pub(super) fn add_turn(terms: &mut Vec<(usize, Real)>, link: usize, sign: f64) {
        if let Some(column) = Truth::column(link) {
            terms.push((column + 2, exactly(sign)));
        }
    }

    /// The part of the acceleration at `place` that the angular velocity gives, along `direction`.
    fn normal(&self, link: usize, place: &Pair, direction: &Pair) -> Real {
        let omega = &self.links[link].rates[0].turn;
        -dot(&minus(place, &self.links[link].origin), direction) * omega * omega
    }

    /// The equations of all joints; of the drives with their positions, or with their rates.
    fn equations(&self, of_places: bool) -> Vec<Equation> {
        let mut equations = Vec::new();
        let zero = || exactly(0.0);
        for (link, other, name) in self.pins() {
            let place = |i: usize| self.links[i].place(self.links[i].own(&name).expect("its point"));
            let [p, q] = [place(link), place(other)];
            for direction in [[exactly(1.0), zero()], [zero(), exactly(1.0)]] {
                let mut terms = Vec::new();
                self.add(&mut terms, link, &p, &direction, 1.0);
                self.add(&mut terms, other, &q, &direction, -1.0);
                let second = self.normal(other, &q, &direction) - self.normal(link, &p, &direction);
                equations.push(Equation { gap: dot(&minus(&q, &p), &direction), terms, sides: [zero(), second] });
            }
        }
        for guide in &self.guides {
            let [along, through] = self.guide_line(guide);
            let place = self.links[guide.carrier].place(self.links[guide.carrier].own(&guide.at).expect("its point"));
            let slid = dot(&minus(&place, &through), &along);
            let omega = &self.links[guide.on].rates[0].turn;
            let [carrier, on] = [guide.carrier, guide.on].map(|link| self.links[link].motion(&place));
            let speed = dot(&minus(&carrier[0], &on[0]), &along);
            let across = quarter(&along);
            let mut row = |direction: &Pair, gap: Real, sides: [Real; 2]| {
                let mut terms = Vec::new();
                self.add(&mut terms, guide.carrier, &place, direction, 1.0);
                self.add(&mut terms, guide.on, &place, direction, -1.0);
                let [first, second] = sides;
                let normal = self.normal(guide.on, &place, direction) - self.normal(guide.carrier, &place, direction);
                equations.push(Equation { gap, terms, sides: [first, second + normal] });
            };
            // The Coriolis acceleration 2 ω v_r stands across the guide.
            let coriolis = exactly(2.0) * omega * &speed;
            let off = -guide.beside.clone() - dot(&minus(&place, &through), &across);
            row(&across, off, [zero(), coriolis]);
            if let Some([position, speed, acceleration]) = &guide.drive {
                row(&along, position - slid, [speed.clone(), acceleration.clone()]);
            }
            if let Some(link) = guide.link {
                let mut terms = Vec::new();
                Truth::add_turn(&mut terms, link, 1.0);
                Truth::add_turn(&mut terms, guide.on, -1.0);
                let wanted = turn(&turn(&self.links[guide.on].angle, &guide.along), &guide.turned);
                equations.push(Equation {
                    gap: cross(&self.links[link].angle, &wanted),
                    terms,
                    sides: [zero(), zero()],
                });
            }
        }
        equations.extend(self.ties.iter().map(|tie| self.equation_of_tie(tie)));
        equations.extend(self.touches.iter().map(|touch| self.equation_of_touch(touch)));
        let mut turned = |link: usize, gap: Real, sides: [Real; 2]| {
            let mut terms = Vec::new();
            Truth::add_turn(&mut terms, link, 1.0);
            equations.push(Equation { gap, terms, sides });
        };
        if of_places {
            for (link, angle) in &self.angles {
                turned(*link, cross(&self.links[*link].angle, angle), [zero(), zero()]);
            }
        } else {
            for (link, rates) in &self.drives {
                turned(*link, zero(), rates.clone());
            }
        }
        equations
    }

    fn equation_of_tie(&self, tie: &Tie) -> Equation {
        let (mut terms, mut side, mut constant) = (Vec::new(), exactly(0.0), tie.constant.clone());
        for &(link, weight) in &tie.turning {
            Truth::add_turn(&mut terms, link, weight as f64);
        }
        for (index, weight) in &tie.sliding {
            let guide = &self.guides[*index];
            let [along, through] = self.guide_line(guide);
            let place = self.links[guide.carrier].place(self.links[guide.carrier].own(&guide.at).expect("its point"));
            constant += weight * dot(&minus(&place, &through), &along) * exactly(180.0) / pi();
            let mut own = Vec::new();
            self.add(&mut own, guide.carrier, &place, &along, -1.0);
            self.add(&mut own, guide.on, &place, &along, 1.0);
            terms.extend(own.into_iter().map(|(column, value)| (column, value * weight)));
            side -= weight * (self.normal(guide.on, &place, &along) - self.normal(guide.carrier, &place, &along));
        }
        let mut left = direction_of(&constant);
        for &(link, weight) in &tie.turning {
            let [cosine, sine] = self.links[link].angle.clone();
            let back = [cosine, if weight > 0 { -sine } else { sine }];
            (0..weight.abs()).for_each(|_| left = turn(&back, &left));
        }
        Equation { gap: left[1].clone(), terms, sides: [exactly(0.0), side] }
    }

    /// The centres of two profiles that touch.
    pub(super) fn centers(&self, touch: &Touch) -> [Pair; 2] {
        touch
            .ends
            .each_ref()
            .map(|(link, center)| self.links[*link].place(self.links[*link].own(center).expect("its centre")))
    }

    fn equation_of_touch(&self, touch: &Touch) -> Equation {
        let [first, second] = self.centers(touch);
        let ([one, other], way) = (touch.ends.each_ref().map(|(link, _)| *link), minus(&second, &first));
        let mut terms = Vec::new();
        self.add(&mut terms, other, &second, &way, 1.0);
        self.add(&mut terms, one, &first, &way, -1.0);
        let [own, against] =
            [(one, &first), (other, &second)].map(|(link, place)| self.links[link].motion(place)[0].clone());
        let apart = minus(&against, &own);
        let normal = self.normal(other, &second, &way) - self.normal(one, &first, &way);
        let gap = (&touch.apart * &touch.apart - dot(&way, &way)) / exactly(2.0);
        Equation { gap, terms, sides: [exactly(0.0), -dot(&apart, &apart) - normal] }
    }

    /// Each further link with a point, with the first one that has it.
    pub(super) fn pins(&self) -> Vec<(usize, usize, String)> {
        let mut first: BTreeMap<&str, usize> = BTreeMap::new();
        let mut pins = Vec::new();
        for (index, link) in self.links.iter().enumerate() {
            for (name, _) in &link.points {
                match first.get(name.as_str()) {
                    Some(&other) => pins.push((index, other, name.clone())),
                    None => {
                        first.insert(name, index);
                    }
                }
            }
        }
        pins
    }

    /// The direction of a guide and a place on it.
    pub(super) fn guide_line(&self, guide: &Guide) -> [Pair; 2] {
        let on = &self.links[guide.on];
        [turn(&on.angle, &guide.along), on.place(&guide.through)]
    }

    fn find_places(&mut self) -> Option<()> {
        for _ in 0..40 {
            let equations = self.equations(true);
            let matrix = Factors::new(&equations, 3 * (self.links.len() - 1))?;
            let steps = matrix.solve(equations.iter().map(|e| e.gap.clone()).collect());
            let mut largest: f64 = 0.0;
            let span = self.links.iter().map(|l| rounded(&dot(&l.origin, &l.origin)).sqrt()).fold(1.0, f64::max);
            for (index, link) in self.links.iter_mut().enumerate().skip(1) {
                let column = 3 * (index - 1);
                link.origin = plus(&link.origin, &[steps[column].clone(), steps[column + 1].clone()]);
                let turned = plus(&link.angle, &times(&quarter(&link.angle), &steps[column + 2]));
                link.angle = unit(&turned);
                let sizes =
                    [rounded(&steps[column]) / span, rounded(&steps[column + 1]) / span, rounded(&steps[column + 2])];
                largest = sizes.into_iter().fold(largest, |l, x| l.max(x.abs()));
            }
            if largest.is_nan() || largest > 1e-2 {
                return None;
            }
            if largest < LAST {
                return Some(());
            }
        }
        None
    }

    fn find_rates(&mut self) -> Option<()> {
        for order in 0..2 {
            let equations = self.equations(false);
            let matrix = Factors::new(&equations, 3 * (self.links.len() - 1))?;
            let sides: Vec<Real> = equations.iter().map(|e| e.sides[order].clone()).collect();
            // What f64 factors leave of the equations is solved for again.
            let mut rates = vec![exactly(0.0); sides.len()];
            for _ in 0..40 {
                let rest = equations.iter().zip(&sides).map(|(e, side)| {
                    e.terms.iter().fold(side.clone(), |rest, (column, value)| rest - value * &rates[*column])
                });
                let more = matrix.solve(rest.collect());
                for (rate, more) in rates.iter_mut().zip(&more) {
                    *rate = &*rate + more;
                }
            }
            for (index, link) in self.links.iter_mut().enumerate().skip(1) {
                let [x, y, turn] = [0, 1, 2].map(|k| rates[3 * (index - 1) + k].clone());
                link.rates[order] = Rates { origin: [x, y], turn };
            }
        }
        Some(())
    }

    /// Angular velocity and acceleration of a link, and cosine and sine of its angle.
    pub fn link(&self, name: &str) -> Option<([Real; 2], Pair)> {
        let link = self.links.iter().find(|l| l.name == name)?;
        Some(([0, 1].map(|order: usize| link.rates[order].turn.clone()), link.angle.clone()))
    }

    /// A point of some link.
    pub fn point(&self, name: &str) -> Option<PointTruth> {
        let link = self.links.iter().find(|l| l.own(name).is_some())?;
        let place = link.place(link.own(name)?);
        Some(PointTruth { motion: link.motion(&place), place })
    }

    /// The point of a link at a place.
    pub fn point_of(&self, link: &str, place: &Pair) -> Option<[Pair; 2]> {
        Some(self.links.iter().find(|l| l.name == link)?.motion(place))
    }

    /// The direction of guide `index`.
    pub fn along(&self, index: usize) -> Pair {
        self.guide_line(&self.guides[index])[0].clone()
    }

    pub fn sliders(&self) -> impl Iterator<Item = SliderTruth> {
        self.guides.iter().map(|guide| {
            let [along, through] = self.guide_line(guide);
            let place = self.links[guide.carrier].place(self.links[guide.carrier].own(&guide.at).expect("its point"));
            let [carrier, on] = [guide.carrier, guide.on].map(|link| self.links[link].motion(&place));
            let rates = [0, 1].map(|order: usize| dot(&minus(&carrier[order], &on[order]), &along));
            let twice = exactly(2.0) * &self.links[guide.on].rates[0].turn;
            SliderTruth {
                name: guide.name.clone(),
                position: (!self.is_drawn).then(|| dot(&minus(&place, &through), &along)),
                coriolis: times(&quarter(&along), &(twice * &rates[0])),
                rates,
            }
        })
    }
}

fn texts(names: &Value) -> impl Iterator<Item = &str> {
    names.as_array().into_iter().flatten().filter_map(Value::as_str)
}

/// The points of a link on itself.
fn shape(link: &Value, places: &BTreeMap<String, [f64; 2]>) -> Vec<(String, Pair)> {
    let zero = || exactly(0.0);
    if let Some(shape) = link["shape"].as_object() {
        return shape.iter().map(|(name, at)| (name.clone(), pair(at))).collect();
    }
    let names: Vec<&str> = texts(link.get("points").unwrap_or(link)).collect();
    let length = |a: &str, b: &str| {
        let keys = [format!("{a}-{b}"), format!("{b}-{a}"), format!("{a}{b}"), format!("{b}{a}")];
        number(keys.iter().find_map(|key| link["lengths"].get(key)).expect("a length"))
    };
    match names.as_slice() {
        [a, b] => vec![((*a).to_owned(), [zero(), zero()]), ((*b).to_owned(), [length(a, b), zero()])],
        [a, b, c] => {
            let [ab, ac, bc] = [length(a, b), length(a, c), length(b, c)];
            let x = (&ab * &ab + &ac * &ac - &bc * &bc) / (exactly(2.0) * &ab);
            let square = &ac * &ac - &x * &x;
            // Lengths that fail to close by rounding only make a straight link.
            let is_straight = rounded(&square) < 1e-11 * rounded(&(&ac * &ac));
            let y = if is_straight { zero() } else { square.sqrt() };
            let [p, q, r] = [a, b, c].map(|name| places[*name]);
            let area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
            let y = if area < 0.0 { -y } else { y };
            let named = |name: &str, at: Pair| (name.to_owned(), at);
            vec![named(a, [zero(), zero()]), named(b, [ab, zero()]), named(c, [x, y])]
        }
        more => more.iter().map(|name| ((*name).to_owned(), [zero(), zero()])).collect(),
    }
}

fn guide(given: &Value, links: &[Link], is_drawn: bool) -> Guide {
    let index = |name: &str| links.iter().position(|l| l.name == name).expect("a link");
    let on_name = given["on"].as_str().expect("on");
    let on = index(on_name);
    let link = given["link"].as_str();
    let at = given["at"].as_str().or(given["pin"].as_str()).expect("a point").to_owned();
    let carrier = link.map(index).or_else(|| links.iter().position(|l| l.own(&at).is_some())).expect("a link");
    let own = |name: &str| links[on].own(name).expect("a point of the guide").clone();
    let ends = |key: &str| match key.split_once('-') {
        Some((a, b)) => [own(a), own(b)],
        None => [own(&key[..1]), own(&key[1..])],
    };
    let along = match &given["along"] {
        Value::String(key) => unit(&minus(&ends(key)[1], &ends(key)[0])),
        Value::Array(direction) => unit(&[number(&direction[0]), number(&direction[1])]),
        // As drawn, degrees count from the axis of the link.
        Value::Number(_) if is_drawn && on > 0 && links[on].points.len() > 1 => {
            let axis = unit(&minus(&links[on].points[1].1, &links[on].points[0].1));
            turn(&axis, &direction(&given["along"]))
        }
        Value::Number(_) => direction(&given["along"]),
        _ => [exactly(1.0), exactly(0.0)],
    };
    let through = match (&given["through"], &given["along"]) {
        (Value::String(name), _) => own(name),
        (Value::Array(_), _) => pair(&given["through"]),
        (_, Value::String(key)) => ends(key)[0].clone(),
        _ => links[on].points.first().map_or([exactly(0.0), exactly(0.0)], |(_, own)| own.clone()),
    };
    let turned = given.get("turned").map_or([exactly(1.0), exactly(0.0)], direction);
    let drive = given
        .get("drive")
        .map(|drive| ["position", "speed", "acceleration"].map(|key| drive.get(key).map_or(exactly(0.0), number)));
    let sliding = link.unwrap_or(&at);
    Guide {
        name: format!("{sliding}/{on_name}"),
        link: link.map(index),
        carrier,
        at,
        on,
        through,
        along,
        turned,
        drive,
        beside: exactly(0.0),
    }
}

/// The equations' matrix, factored in f64: its solutions are corrections.
struct Factors {
    factors: nalgebra::LU<f64, nalgebra::Dyn, nalgebra::Dyn>,
}

impl Factors {
    fn new(equations: &[Equation], unknowns: usize) -> Option<Factors> {
        assert_eq!(equations.len(), unknowns, "as many equations as unknowns");
        let mut matrix = DMatrix::zeros(unknowns, unknowns);
        for (row, equation) in equations.iter().enumerate() {
            for (column, value) in &equation.terms {
                matrix[(row, *column)] += rounded(value);
            }
        }
        let factors = matrix.lu();
        factors.is_invertible().then_some(Factors { factors })
    }

    fn solve(&self, sides: Vec<Real>) -> Vec<Real> {
        let sides = DVector::from_iterator(sides.len(), sides.iter().map(rounded));
        self.factors.solve(&sides).expect("it is invertible").iter().map(|&x| exactly(x)).collect()
    }
}
