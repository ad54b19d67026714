//! A fourth-class group with pins, its true motion, and how far a method's numbers are from it.

use super::groups::Group;
use super::truth::{Precise, Truth, error, error_of_pair, rounded, without_rounding};
use kinegon::Order;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::{Motion, motion};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;

/// Half the distance from 1 to the next f64.
pub const U: f64 = f64::EPSILON / 2.0;

/// What is given of a group with pins.
#[derive(Clone, Debug)]
pub struct Pins {
    /// Places of B, C, D, E, F, G.
    pub places: [[f64; 2]; 6],
    /// Velocities of B and E.
    pub velocity: [[f64; 2]; 2],
    /// Accelerations of B and E.
    pub acceleration: [[f64; 2]; 2],
    /// Indices of links 2, 3, 4, 5 among the mechanism's bodies.
    pub bodies: [usize; 4],
}

/// What is looked for.
#[derive(Clone, Copy, Debug)]
pub struct Rates<T> {
    /// Angular velocities of links 2, 3, 4, 5.
    pub omega: [T; 4],
    /// Angular accelerations.
    pub alpha: [T; 4],
    /// Velocities of C, D, F, G.
    pub velocity: [[T; 2]; 4],
    /// Accelerations of C, D, F, G.
    pub acceleration: [[T; 2]; 4],
}

impl<T> Rates<T> {
    /// All rates, each turned into another kind of number.
    pub fn map<S>(self, number: impl Fn(T) -> S + Copy) -> Rates<S> {
        Rates {
            omega: self.omega.map(number),
            alpha: self.alpha.map(number),
            velocity: self.velocity.map(|v| v.map(number)),
            acceleration: self.acceleration.map(|a| a.map(number)),
        }
    }
}

impl Rates<f64> {
    /// Motions of the inner joints from the rates of the links, where the joints stand at these places.
    pub fn from_links(pins: &Pins, places: [[f64; 2]; 6], omega: [f64; 4], alpha: [f64; 4]) -> Rates<f64> {
        // Outer joint and its place among the joints, drag link, inner joint.
        let joints = [(0, 0, 0, 1), (1, 3, 2, 2), (1, 3, 2, 4), (0, 0, 0, 5)];
        let arm = |outer: usize, joint: usize| {
            let ([a, b], [c, d]) = (places[outer], places[joint]);
            [c - a, d - b]
        };
        Rates {
            omega,
            alpha,
            velocity: joints.map(|(base, outer, link, joint)| {
                let ([x, y], [vx, vy]) = (arm(outer, joint), pins.velocity[base]);
                [vx - omega[link] * y, vy + omega[link] * x]
            }),
            acceleration: joints.map(|(base, outer, link, joint)| {
                let ([x, y], [ax, ay]) = (arm(outer, joint), pins.acceleration[base]);
                let (second, square) = (alpha[link], omega[link] * omega[link]);
                [ax - second * y - square * x, ay + second * x - square * y]
            }),
        }
    }
}

/// A group and its true motion.
pub struct Case {
    pub pins: Pins,
    pub mechanism: Mechanism,
    pub pose: Pose,
    /// Condition of the group as the library states it; `None` where it refuses the group as singular.
    pub condition: Option<f64>,
    pub truth: Rates<Precise>,
    sizes: Sizes,
}

/// The largest errors of each kind of number: ω, α, v, a; for ω and α also times the size of their link.
struct Errors {
    kinds: [f64; 4],
    omega_size: f64,
    alpha_size: f64,
}

/// Sizes of true numbers.
struct Sizes {
    /// Of the links: the largest distance of two of their joints.
    links: [f64; 4],
    /// The largest number of each kind: ω, α, v, a; of a kind that is zero throughout what the others make of it.
    kinds: [f64; 4],
    /// The largest velocity of a joint against another of its link, ω l.
    relative_velocity: f64,
    /// The largest acceleration that belongs to it: of α l and ω v, with any ω of the group.
    relative_acceleration: f64,
}

impl Case {
    /// `None` where the group is exactly singular.
    pub fn new(group: &Group) -> Option<Case> {
        let text = group.scene().to_string();
        let scene = Scene::read(&text).expect("a good scene");
        let mechanism = mechanism(&scene).expect("a mechanism");
        let pose = pose(&mechanism, &scene.near).expect("it is drawn");
        let points: Vec<[f64; 2]> = pose.points.iter().map(|p| [p.x, p.y]).collect();
        let body = |name: &str| mechanism.link(name).expect("a link of the group").0;
        let point = |name: &str| mechanism.point(name).expect("a joint of the group").0;
        let pins = Pins {
            places: super::groups::JOINTS.map(|joint| points[point(joint)]),
            velocity: [0, 1].map(|base| group.bases[base].velocity),
            acceleration: [0, 1].map(|base| group.bases[base].acceleration),
            bodies: ["2", "3", "4", "5"].map(body),
        };
        let truth = Truth::new(&mechanism, &points, &[])?;
        let joints = [("2", "C"), ("4", "D"), ("4", "F"), ("2", "G")];
        let joints = joints.map(|(link, joint)| truth.at(body(link), point(joint)));
        let rates = Rates {
            omega: pins.bodies.map(|b| truth.bodies[b].omega.clone()),
            alpha: pins.bodies.map(|b| truth.bodies[b].alpha.clone()),
            velocity: joints.clone().map(|[v, _]| v),
            acceleration: joints.map(|[_, a]| a),
        };
        let rates = rates.map(without_rounding);
        Some(Case {
            sizes: Sizes::new(&pins, &rates),
            condition: motion(&mechanism, &pose, Order::Velocity).ok().map(|motion| motion.conditions[0]),
            truth: rates,
            pins,
            mechanism,
            pose,
        })
    }

    /// The largest of |computed − true| / max |true of that kind|; kinds are ω, α, and the components of v and a.
    pub fn error(&self, rates: &Rates<f64>) -> f64 {
        let errors = self.errors(rates).kinds.into_iter().zip(self.sizes.kinds);
        errors.fold(0.0, |worst, (e, size)| worst.max(e / size))
    }

    /// The largest errors of velocities (ω, v) and of accelerations (α, a) in units of u·condition; `None` where the library refuses
    /// the group.
    ///
    /// The condition is that of equations in which every rate counts with the size of its link, ω l and α l; so errors do here.
    /// And accelerations count against ω v too, though their own sum may be smaller: a velocity's error goes into ω² l
    /// with the factor 2 ω.
    pub fn units(&self, rates: &Rates<f64>) -> Option<[f64; 2]> {
        let errors = self.errors(rates);
        let [_, _, v, a] = errors.kinds;
        let Sizes { kinds, relative_velocity: first, relative_acceleration: second, .. } = self.sizes;
        // Nothing is no error, even where there is nothing to compare it with.
        let share = |error: f64, size: f64| if error == 0.0 { 0.0 } else { error / size };
        let largest = [
            share(errors.omega_size, first).max(share(v, kinds[2].max(first))),
            share(errors.alpha_size, second).max(share(a, kinds[3].max(second))),
        ];
        let condition = self.condition?;
        Some(largest.map(|error| error / (U * condition)))
    }

    /// The largest error of a link's ω or α in units u·|its true value|; 1 at most where it is the nearest f64.
    pub fn roundings(&self, rates: &Rates<f64>) -> f64 {
        let truth = self.truth.omega.iter().chain(&self.truth.alpha);
        let got = rates.omega.into_iter().chain(rates.alpha);
        let errors = got.zip(truth).map(|(got, truth)| {
            let error = error(got, truth);
            if error == 0.0 { 0.0 } else { error / (U * rounded(truth).abs()) }
        });
        errors.fold(0.0, f64::max)
    }

    /// The larger of both.
    pub fn worst_units(&self, rates: &Rates<f64>) -> Option<f64> {
        self.units(rates).map(|[v, a]| v.max(a))
    }

    fn errors(&self, rates: &Rates<f64>) -> Errors {
        let truth = &self.truth;
        let numbers = |got: [f64; 4], truth: &[Precise; 4]| std::array::from_fn(|link| error(got[link], &truth[link]));
        let pairs = |got: [[f64; 2]; 4], truth: &[[Precise; 2]; 4]| {
            let errors = got.iter().zip(truth).map(|(x, t)| error_of_pair(*x, t));
            errors.fold(0.0, f64::max)
        };
        let omega = numbers(rates.omega, &truth.omega);
        let alpha = numbers(rates.alpha, &truth.alpha);
        Errors {
            kinds: [
                largest(omega),
                largest(alpha),
                pairs(rates.velocity, &truth.velocity),
                pairs(rates.acceleration, &truth.acceleration),
            ],
            omega_size: largest_product(omega, self.sizes.links),
            alpha_size: largest_product(alpha, self.sizes.links),
        }
    }

    /// The numbers of a motion that the library has found.
    pub fn rates_of(&self, motion: &Motion) -> Rates<f64> {
        let bodies = self.pins.bodies.map(|b| motion.bodies[b]);
        let at = |link: usize, joint: usize| {
            let [x, y] = self.pins.places[joint];
            let place = kinegon::geometry::Point::new(x, y);
            let (v, a) = (bodies[link].velocity_at(place), bodies[link].acceleration_at(place));
            ([v.x, v.y], [a.x, a.y])
        };
        let joints = [at(0, 1), at(2, 2), at(2, 4), at(0, 5)];
        Rates {
            omega: bodies.map(|b| b.omega),
            alpha: bodies.map(|b| b.alpha),
            velocity: joints.map(|j| j.0),
            acceleration: joints.map(|j| j.1),
        }
    }
}

fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let numbers = numbers.into_iter();
    numbers.fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

fn largest_product(a: [f64; 4], b: [f64; 4]) -> f64 {
    largest(a.into_iter().zip(b).map(|(a, b)| a * b))
}

impl Sizes {
    fn new(pins: &Pins, truth: &Rates<Precise>) -> Sizes {
        let distance = |a: usize, b: usize| {
            let ([x, y], [z, w]) = (pins.places[a], pins.places[b]);
            libm::hypot(z - x, w - y)
        };
        // Links 2 with B, C, G; 3 with C, D; 4 with E, D, F; 5 with G, F.
        let ternary = |a, b, c| distance(a, b).max(distance(b, c)).max(distance(c, a));
        let links = [ternary(0, 1, 5), distance(1, 2), ternary(3, 2, 4), distance(5, 4)];
        let [omegas, alphas] = [&truth.omega, &truth.alpha].map(|r| r.each_ref().map(rounded));
        let inner = |pairs: &[[Precise; 2]; 4]| largest(pairs.iter().flatten().map(rounded));
        let outer = |pairs: &[[f64; 2]; 2]| largest(pairs.iter().flatten().copied());
        let (omega, alpha) = (largest(omegas), largest(alphas));
        let velocity = inner(&truth.velocity).max(outer(&pins.velocity));
        let acceleration = inner(&truth.acceleration).max(outer(&pins.acceleration));
        let size = largest(links);
        let or = |size: f64, other: f64| if size > 0.0 { size } else { other };
        let or = |size: f64, other: f64| or(or(size, other), 1.0);
        let relative_velocity = largest_product(omegas, links);
        Sizes {
            kinds: [
                or(omega, velocity / size),
                or(alpha, (acceleration / size).max(omega * omega)),
                or(velocity, omega * size),
                or(acceleration, (alpha * size).max(omega * omega * size)),
            ],
            relative_velocity,
            relative_acceleration: largest_product(alphas, links).max(omega * relative_velocity),
            links,
        }
    }
}
