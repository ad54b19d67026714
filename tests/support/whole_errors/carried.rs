//! What the joints of a scene truly carry and its drives need, with 256 bits: every joint's force is the multiplier of the equation that holds it, and
//! all of them together keep all links in equilibrium (Lagrange). Friction is none of it.

use super::truth::{
    Pair, Real, Truth, cross, direction_of, dot, exactly, minus, number, pair, pi, plus, quarter, rounded, times, turn,
    unit,
};
use serde_json::Value;

/// A force of 1 kg mm/s² in newtons is so many times smaller.
const UNIT: f64 = 1000.0;

/// What multiplies an equation's multiplier, by column of the unknown rates: the force of each link's origin and its moment about it.
type Acts = Vec<(usize, Real)>;

/// What a multiplier is.
enum Part {
    /// Of a pin's force on a link, against that on another one.
    Pin {
        name: String,
        links: [usize; 2],
        axis: usize,
    },
    Across(usize),
    Turned(usize),
    Push(usize),
    Teeth {
        wheels: [usize; 2],
        apart: Acts,
        slope: Real,
    },
    Torque(usize),
    Contact,
}

/// The forces of a scene.
pub struct Carried {
    parts: Vec<Part>,
    sizes: Vec<Real>,
    names: Vec<String>,
}

impl Carried {
    /// The forces in the scene that `truth` is of; none where they are not determined, or teeth push apart in no definite way.
    pub fn new(scene: &Value, truth: &Truth) -> Option<Carried> {
        let (mut parts, mut rows) = (Vec::new(), Vec::new());
        truth.held(scene, &mut |part, acts| {
            parts.push(part);
            rows.push(acts);
        });
        let loads = truth.loads(scene)?;
        let mut signs = vec![0.0; rows.len()];
        for _ in 0..10 {
            let leaning = rows.iter().zip(&parts).zip(&signs).map(|((acts, part), sign)| {
                let mut acts = acts.clone();
                if let Part::Teeth { apart, slope, .. } = part {
                    acts.extend(apart.iter().map(|(column, value)| (*column, value * slope * exactly(*sign))));
                }
                acts
            });
            let sizes = solved(leaning.collect(), &loads)?;
            let next: Vec<f64> = sizes.iter().map(|size| rounded(size).signum()).collect();
            if next == signs {
                return Some(Carried { parts, sizes, names: truth.names() });
            }
            signs = next;
        }
        None
    }

    /// The force on a link at a pin, from all others there.
    pub fn at_pin(&self, pin: &str, link: &str) -> Pair {
        let mut sum = [exactly(0.0), exactly(0.0)];
        for (part, size) in self.parts.iter().zip(&self.sizes) {
            let Part::Pin { name, links, axis } = part else { continue };
            for (own, sign) in links.iter().zip([1.0, -1.0]) {
                if name == pin && self.names[*own] == link {
                    sum[*axis] += size * exactly(sign);
                }
            }
        }
        sum
    }

    fn one(&self, is: impl Fn(&Part) -> bool) -> Option<Real> {
        self.parts.iter().position(is).map(|index| self.sizes[index].clone())
    }

    /// Across a guide and the couple about the slider's point, on the sliding link.
    pub fn in_guide(&self, guide: usize) -> [Option<Real>; 2] {
        let across = self.one(|part| matches!(part, Part::Across(own) if *own == guide));
        [across, self.one(|part| matches!(part, Part::Turned(own) if *own == guide))]
    }

    /// Along the tangent, on the first wheel.
    pub fn between(&self, first: &str, second: &str) -> Option<Real> {
        self.one(|part| match part {
            Part::Teeth { wheels: [a, b], .. } => self.names[*a] == first && self.names[*b] == second,
            _ => false,
        })
    }

    /// The torque of the drive of a link.
    pub fn torque(&self, link: &str) -> Option<Real> {
        self.one(|part| matches!(part, Part::Torque(own) if self.names[*own] == link))
    }

    /// The force of the drive of a guide.
    pub fn push(&self, guide: usize) -> Option<Real> {
        self.one(|part| matches!(part, Part::Push(own) if *own == guide))
    }
}

impl Truth {
    fn names(&self) -> Vec<String> {
        self.links.iter().map(|link| link.name.clone()).collect()
    }

    /// What each joint and each drive can do to the links.
    fn held(&self, scene: &Value, see: &mut dyn FnMut(Part, Acts)) {
        let axes = [[exactly(1.0), exactly(0.0)], [exactly(0.0), exactly(1.0)]];
        for (link, other, name) in self.pins() {
            let place = self.links[link].place(self.links[link].own(&name).expect("its point"));
            for (axis, direction) in axes.iter().enumerate() {
                let part = Part::Pin { name: name.clone(), links: [link, other], axis };
                see(part, self.between([link, other], &place, direction));
            }
        }
        for (index, guide) in self.guides.iter().enumerate() {
            let [along, _] = self.guide_line(guide);
            let place = self.links[guide.carrier].place(self.links[guide.carrier].own(&guide.at).expect("its point"));
            see(Part::Across(index), self.between([guide.carrier, guide.on], &place, &quarter(&along)));
            if guide.drive.is_some() {
                see(Part::Push(index), self.between([guide.carrier, guide.on], &place, &along));
            }
            if let Some(link) = guide.link {
                let mut acts = Vec::new();
                Truth::add_turn(&mut acts, link, 1.0);
                Truth::add_turn(&mut acts, guide.on, -1.0);
                see(Part::Turned(index), acts);
            }
        }
        for given in scene["gears"].as_array().into_iter().flatten() {
            let (part, acts) = self.teeth(given);
            see(part, acts);
        }
        for touch in &self.touches {
            let [(one, _), (other, _)] = &touch.ends;
            let [first, second] = self.centers(touch);
            see(Part::Contact, self.between([*other, *one], &first, &unit(&minus(&second, &first))));
        }
        for (link, _) in &self.drives {
            let mut acts = Vec::new();
            Truth::add_turn(&mut acts, *link, 1.0);
            see(Part::Torque(*link), acts);
        }
    }

    /// A force on the first link and its opposite on the second.
    fn between(&self, [link, other]: [usize; 2], place: &Pair, direction: &Pair) -> Acts {
        let mut acts = Vec::new();
        self.add(&mut acts, link, place, direction, 1.0);
        self.add(&mut acts, other, place, direction, -1.0);
        acts
    }

    /// What two wheels, or a wheel and its rack, do to each other where they roll on each other.
    fn teeth(&self, given: &Value) -> (Part, Acts) {
        let index =
            |name: &Value| self.links.iter().position(|l| Some(l.name.as_str()) == name.as_str()).expect("a link");
        let (wheels, carrier) = ([index(&given["mesh"][0]), index(&given["mesh"][1])], index(&given["on"]));
        let center = |wheel: usize| {
            let own = self.links[wheel].points.iter().find(|(name, _)| self.links[carrier].own(name).is_some());
            self.links[wheel].place(&own.expect("the wheel's axis").1)
        };
        let (at, outwards, apart) = if given["teeth"][1] == "rack" {
            let slid =
                |g: &&super::truth::Guide| g.link == Some(wheels[1]) || g.link == Some(carrier) && g.on == wheels[1];
            let guide = self.guides.iter().find(slid).expect("the rack's guide");
            let [along, through] = self.guide_line(guide);
            let own = center(wheels[0]);
            let is_right = rounded(&cross(&along, &minus(&own, &through))) > -1e-9;
            let outwards = times(&quarter(&along), &exactly(if is_right { -1.0 } else { 1.0 }));
            (plus(&own, &times(&outwards, &number(&given["radius"]))), outwards, -1.0)
        } else {
            let [first, second] = wheels.map(center);
            let [own, other] = [0, 1].map(|which: usize| exactly(given["teeth"][which].as_f64().expect("teeth")));
            let is_ring = [&own, &other].into_iter().any(|teeth| rounded(teeth) < 0.0);
            let way = minus(&second, &first);
            (plus(&first, &times(&way, &(&own / (&own + &other)))), unit(&way), if is_ring { 1.0 } else { -1.0 })
        };
        let slope = given.get("pressure").map_or(exactly(0.0), |degrees| {
            let [cosine, sine] = direction_of(&number(degrees));
            sine / cosine
        });
        let apart = self.between(wheels, &at, &times(&outwards, &exactly(apart)));
        (Part::Teeth { wheels, apart, slope }, self.between(wheels, &at, &quarter(&outwards)))
    }

    /// What the loads of all links are, by column.
    fn loads(&self, scene: &Value) -> Option<Vec<Real>> {
        let mut all = vec![exactly(0.0); 3 * (self.links.len() - 1)];
        let mut add = |link: usize, place: &Pair, force: &Pair, couple: Real| {
            if let Some(column) = Truth::column(link) {
                all[column] += &force[0];
                all[column + 1] += &force[1];
                all[column + 2] += cross(&minus(place, &self.links[link].origin), force) + couple;
            }
        };
        let index = |name: &Value| self.links.iter().position(|l| Some(l.name.as_str()) == name.as_str());
        let place = |link: usize, at: &Value| match at {
            Value::String(name) => self.links[link].place(self.links[link].own(name).expect("its point")),
            at => self.links[link].place(&pair(at)),
        };
        let gravity = scene.get("gravity").map_or([exactly(0.0), exactly(0.0)], pair);
        for (name, given) in scene["links"].as_object().expect("links") {
            let Some(mass) = given.get("mass").map(number) else { continue };
            let link = index(&Value::from(name.as_str()))?;
            let at = place(link, &given["center"]);
            let force = times(&minus(&gravity, &self.links[link].motion(&at)[1]), &(mass / exactly(UNIT)));
            let inertia = given.get("inertia").map_or(exactly(0.0), number) / exactly(UNIT);
            add(link, &at, &force, -inertia * &self.links[link].rates[1].turn);
        }
        for given in scene["forces"].as_array().into_iter().flatten() {
            let link = index(&given["on"])?;
            let mut force = given.get("force").map_or([exactly(0.0), exactly(0.0)], pair);
            let mut couple = given.get("couple").map_or(exactly(0.0), number);
            if given["turns"] == true {
                force = turn(&self.links[link].angle, &force);
            }
            if let Some(over) = given.get("over") {
                let factor = self.factor(over)?;
                (force, couple) = (times(&force, &factor), couple * factor);
            }
            let at = given.get("at").map_or_else(|| self.links[link].origin.clone(), |at| place(link, at));
            add(link, &at, &force, couple);
        }
        for given in scene["springs"].as_array().into_iter().flatten() {
            let ends = [0, 1].map(|which: usize| {
                let end = &given["between"][which];
                let link = index(&end[0]).expect("a link");
                (link, place(link, &end[1]))
            });
            let way = minus(&ends[1].1, &ends[0].1);
            let pull = number(&given["rate"]) * (dot(&way, &way).sqrt() - number(&given["length"]));
            let force = times(&unit(&way), &pull);
            add(ends[0].0, &ends[0].1, &force, exactly(0.0));
            add(ends[1].0, &ends[1].1, &times(&force, &exactly(-1.0)), exactly(0.0));
        }
        Some(all)
    }

    /// How often a load acts by its table: in proportion between two lines; over an angle on to the first line of the next turn.
    fn factor(&self, over: &Value) -> Option<Real> {
        let of = over["of"].as_str()?;
        let table: Vec<Pair> = over["table"].as_array()?.iter().map(pair).collect();
        let (first, last) = (table.first()?.clone(), table.last()?.clone());
        let (at, table) = match of.strip_prefix("angle(") {
            Some(link) => {
                let axis = &self.links.iter().find(|own| own.name == link.trim_end_matches(')'))?.angle;
                let mut degrees = self.degrees(axis);
                let turns = (rounded(&(&degrees - &first[0])) / 360.0).floor();
                degrees -= exactly(360.0 * turns);
                (degrees, [&table[..], &[[&first[0] + exactly(360.0), first[1].clone()]]].concat())
            }
            None => {
                let slider = self.sliders().find(|slider| of == format!("position({})", slider.name))?;
                (slider.position?, table)
            }
        };
        if at <= first[0] || at >= table.last()?[0] {
            return Some(if at <= first[0] { first[1].clone() } else { last[1].clone() });
        }
        let pair = table.windows(2).rev().find(|pair| pair[0][0] <= at && pair[0][0] < pair[1][0])?;
        let ([x, y], [z, w]) = (&pair[0], &pair[1]);
        Some(y + (w - y) * (&at - x) / (z - x))
    }

    /// The angle of a direction in degrees.
    fn degrees(&self, axis: &Pair) -> Real {
        let mut degrees = exactly(libm::atan2(rounded(&axis[1]), rounded(&axis[0])).to_degrees());
        for _ in 0..4 {
            // Its sine is the angle up to the third power.
            let left = cross(&direction_of(&degrees), axis);
            degrees += left * exactly(180.0) / pi();
        }
        degrees
    }
}

/// The multipliers that keep these loads in equilibrium, by elimination with the largest pivot.
fn solved(rows: Vec<Acts>, loads: &[Real]) -> Option<Vec<Real>> {
    let size = loads.len();
    assert_eq!(rows.len(), size, "as many forces as equations");
    let mut matrix = vec![vec![exactly(0.0); size + 1]; size];
    for (unknown, acts) in rows.into_iter().enumerate() {
        for (column, value) in acts {
            matrix[column][unknown] += value;
        }
    }
    for (row, load) in matrix.iter_mut().zip(loads) {
        row[size] = -load.clone();
    }
    for step in 0..size {
        let sizes = |row: &usize| rounded(&matrix[*row][step]).abs();
        let pivot = (step..size).max_by(|a, b| sizes(a).total_cmp(&sizes(b)))?;
        if sizes(&pivot) < 1e-60 {
            return None;
        }
        matrix.swap(step, pivot);
        let own = matrix[step].clone();
        for (index, row) in matrix.iter_mut().enumerate().filter(|(index, _)| *index != step) {
            debug_assert_ne!(index, step);
            let factor = &row[step] / &own[step];
            for (x, y) in row.iter_mut().zip(&own).skip(step) {
                *x -= &factor * y;
            }
        }
    }
    Some((0..size).map(|step| &matrix[step][size] / &matrix[step][step]).collect())
}
