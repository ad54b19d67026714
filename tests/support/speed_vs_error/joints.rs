//! The equations that every joint of a mechanism sets its two bodies, as general programs for mechanisms write them.
//!
//! Unknowns are, for each link of an Assur group, the velocity of its home (its first joint) and its angular velocity:
//! three for each link, two equations for each joint and one for each slider's drive (Haug, *Computer Aided Kinematics and Dynamics of Mechanical Systems*,
//! 1989, chapter 3). Accelerations have the same matrix. Nothing here uses the library's loops.

use kinegon::mechanism::{BodyId, JointId, Mechanism, Role};
use std::ops::{Add, Mul, Neg, Sub};

/// What the equations calculate with: f64 or more digits.
pub trait Real: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// An f64 in these numbers, without rounding.
    fn exactly(number: f64) -> Self;

    /// The square root.
    fn root(self) -> Self;
}

impl Real for f64 {
    fn exactly(number: f64) -> f64 {
        number
    }

    fn root(self) -> f64 {
        self.sqrt()
    }
}

/// A vector of such numbers.
pub type Vector<T> = [T; 2];

/// A vector of such numbers.
pub fn exactly<T: Real>([x, y]: [f64; 2]) -> Vector<T> {
    [T::exactly(x), T::exactly(y)]
}

pub fn plus<T: Real>([a, b]: Vector<T>, [c, d]: Vector<T>) -> Vector<T> {
    [a + c, b + d]
}

pub fn minus<T: Real>([a, b]: Vector<T>, [c, d]: Vector<T>) -> Vector<T> {
    [a - c, b - d]
}

pub fn scaled<T: Real>([x, y]: Vector<T>, by: &T) -> Vector<T> {
    [x * by.clone(), y * by.clone()]
}

pub fn turned<T: Real>([x, y]: Vector<T>) -> Vector<T> {
    [-y, x]
}

pub fn dot<T: Real>([a, b]: Vector<T>, [c, d]: Vector<T>) -> T {
    a * c + b * d
}

/// Positions, and motions that are known.
pub struct Given<T> {
    /// By point.
    pub points: Vec<Vector<T>>,
    /// By slider: along its guide, of any length.
    pub guides: Vec<Vector<T>>,
    /// By body; at rest for those that are looked for.
    pub known: Vec<State<T>>,
}

/// The motion of a body.
#[derive(Clone, Debug)]
pub struct State<T> {
    /// A place of it.
    pub at: Vector<T>,
    /// Velocity there.
    pub velocity: Vector<T>,
    /// Acceleration there.
    pub acceleration: Vector<T>,
    /// Angular velocity.
    pub omega: T,
    /// Angular acceleration.
    pub alpha: T,
}

impl<T: Real> State<T> {
    fn rest(at: Vector<T>) -> State<T> {
        State {
            at,
            velocity: exactly([0.0; 2]),
            acceleration: exactly([0.0; 2]),
            omega: T::exactly(0.0),
            alpha: T::exactly(0.0),
        }
    }

    pub fn velocity_at(&self, place: Vector<T>) -> Vector<T> {
        let arm = minus(place, self.at.clone());
        plus(self.velocity.clone(), scaled(turned(arm), &self.omega))
    }

    pub fn acceleration_at(&self, place: Vector<T>) -> Vector<T> {
        let arm = minus(place, self.at.clone());
        let tangential = scaled(turned(arm.clone()), &self.alpha);
        let square = self.omega.clone() * self.omega.clone();
        let normal = scaled(arm, &square);
        minus(plus(self.acceleration.clone(), tangential), normal)
    }
}

impl<T: Real> Given<T> {
    /// The motions that a mechanism's turning drives and known points have at these places.
    pub fn new(mechanism: &Mechanism, points: &[[f64; 2]], guides: &[[f64; 2]]) -> Given<T> {
        let vectors = |all: &[[f64; 2]]| all.iter().map(|v| exactly(*v)).collect();
        Given::at(mechanism, vectors(points), vectors(guides))
    }

    /// What the equations are given, where places and guides are in these numbers already.
    pub fn at(mechanism: &Mechanism, points: Vec<Vector<T>>, guides: Vec<Vector<T>>) -> Given<T> {
        let known = mechanism.bodies.iter().map(|body| {
            let pair = |v: &kinegon::geometry::Vector| exactly([v.x, v.y]);
            match &body.role {
                Role::Driver { pivot, omega, alpha, .. } => State {
                    omega: T::exactly(*omega),
                    alpha: T::exactly(*alpha),
                    ..State::rest(points[pivot.0].clone())
                },
                Role::Moving { at, velocity, acceleration, omega, alpha } => State {
                    at: exactly([at.x, at.y]),
                    velocity: pair(velocity),
                    acceleration: pair(acceleration),
                    omega: T::exactly(*omega),
                    alpha: T::exactly(*alpha),
                },
                Role::Carrier { velocity, acceleration } => State {
                    velocity: pair(velocity),
                    acceleration: pair(acceleration),
                    ..State::rest(points[body.points[0].0].clone())
                },
                _ => State::rest(exactly([0.0; 2])),
            }
        });
        Given { known: known.collect(), guides, points }
    }
}

/// A joint of two bodies at a point; for a prismatic one its slider, guide body first.
struct Joint {
    sides: [Side; 2],
    point: usize,
    slider: Option<usize>,
    /// Speed and acceleration of a driven slider.
    drive: Option<[f64; 2]>,
    /// The first of its equations: two, or three where it is driven.
    row: usize,
}

/// A body with the sign of its side of the equations.
#[derive(Clone, Copy)]
enum Side {
    /// Looked for: the link of that number.
    Link(usize),
    /// The body of that index.
    Known(usize),
}

/// The joint equations of all links that a mechanism's groups have.
pub struct JointEquations {
    joints: Vec<Joint>,
    /// By link: the point of its first joint.
    homes: Vec<usize>,
    /// By body: the number of the link that it is.
    links: Vec<Option<usize>>,
}

/// The signs of a joint's sides.
const SIGNS: [f64; 2] = [1.0, -1.0];

impl JointEquations {
    pub fn new(mechanism: &Mechanism) -> JointEquations {
        let mut count = 0;
        let links = mechanism.bodies.iter().map(|body| {
            matches!(body.role, Role::Member | Role::Pushed { .. }).then(|| {
                count += 1;
                count - 1
            })
        });
        let links: Vec<Option<usize>> = links.collect();
        let mut joints: Vec<Joint> = Vec::new();
        let mut row = 0;
        for (id, joint) in mechanism.joints.iter().enumerate() {
            let side = |b: BodyId| links[b.0].map_or(Side::Known(b.0), Side::Link);
            let sides = joint.bodies.map(side);
            if sides.iter().all(|s| matches!(s, Side::Known(_))) {
                continue;
            }
            let drive = joint.slider.and_then(|slider| mechanism.slider(slider).drive);
            joints.push(Joint {
                sides,
                point: mechanism.joint_point(JointId(id)).0,
                slider: joint.slider.map(|slider| slider.0),
                drive: drive.map(|drive| [drive.speed, drive.acceleration]),
                row,
            });
            row += 2 + usize::from(drive.is_some());
        }
        let home = |link: usize| {
            let on = |joint: &&Joint| joint.sides.iter().any(|s| matches!(s, Side::Link(l) if *l == link));
            joints.iter().find(on).expect("a link has joints").point
        };
        JointEquations { homes: (0..count).map(home).collect(), joints, links }
    }

    /// How many equations and unknowns there are.
    pub fn size(&self) -> usize {
        3 * self.homes.len()
    }

    /// Puts the coefficients that are not zero: row, column, value.
    pub fn matrix<T: Real>(&self, given: &Given<T>, mut put: impl FnMut(usize, usize, T)) {
        for joint in &self.joints {
            let row = joint.row;
            for (side, sign) in joint.sides.into_iter().zip(SIGNS) {
                let Side::Link(link) = side else { continue };
                let column = 3 * link;
                let arm = self.arm(given, joint, link);
                let sign = T::exactly(sign);
                match joint.slider {
                    None => {
                        let [x, y] = scaled(turned(arm), &sign);
                        put(row, column, sign.clone());
                        put(row, column + 2, x);
                        put(row + 1, column + 1, sign);
                        put(row + 1, column + 2, y);
                    }
                    Some(slider) => {
                        put(row, column + 2, sign.clone());
                        let guide = scaled(given.guides[slider].clone(), &sign);
                        let mut component = |row: usize, direction: Vector<T>| {
                            let turning = dot(direction.clone(), turned(arm.clone()));
                            let [x, y] = direction;
                            put(row, column, x);
                            put(row, column + 1, y);
                            put(row, column + 2, turning);
                        };
                        component(row + 1, turned(guide.clone()));
                        if joint.drive.is_some() {
                            component(row + 2, guide);
                        }
                    }
                }
            }
        }
    }

    /// The right sides of the velocity equations.
    pub fn velocity_sides<T: Real>(&self, given: &Given<T>) -> Vec<T> {
        let mut sides = Vec::with_capacity(self.size());
        for joint in &self.joints {
            let mut sum = exactly([0.0; 2]);
            let mut turning = T::exactly(0.0);
            for (side, sign) in joint.sides.into_iter().zip(SIGNS) {
                let Side::Known(body) = side else { continue };
                let (body, sign) = (&given.known[body], T::exactly(-sign));
                let velocity = body.velocity_at(given.points[joint.point].clone());
                sum = plus(sum, scaled(velocity, &sign));
                turning = turning + body.omega.clone() * sign;
            }
            self.push(given, joint, &mut sides, sum, turning, 0);
        }
        sides
    }

    /// The right sides of the acceleration equations, with the solution of the velocity equations.
    pub fn acceleration_sides<T: Real>(&self, given: &Given<T>, first: &[T]) -> Vec<T> {
        let mut sides = Vec::with_capacity(self.size());
        for joint in &self.joints {
            let mut sum = exactly([0.0; 2]);
            let mut turning = T::exactly(0.0);
            for (side, sign) in joint.sides.into_iter().zip(SIGNS) {
                match side {
                    Side::Link(link) => {
                        let omega = first[3 * link + 2].clone();
                        let square = omega.clone() * omega * T::exactly(sign);
                        let arm = self.arm(given, joint, link);
                        sum = plus(sum, scaled(arm, &square));
                    }
                    Side::Known(body) => {
                        let (body, sign) = (&given.known[body], T::exactly(-sign));
                        let acceleration = body.acceleration_at(given.points[joint.point].clone());
                        sum = plus(sum, scaled(acceleration, &sign));
                        turning = turning + body.alpha.clone() * sign;
                    }
                }
            }
            if let Some(slider) = joint.slider {
                // Coriolis: a_link − a_on has 2 ω ṡ across the guide; here it stands as a_on − a_link.
                let [on, link] = joint
                    .sides
                    .map(|side| self.state(given, side, first).velocity_at(given.points[joint.point].clone()));
                let omega = self.state(given, joint.sides[0], first).omega;
                let guide = given.guides[slider].clone();
                // Guide and normal have the length |u|: across counts 2 ω ṡ |u|, and ṡ |u| is this.
                let along = dot(guide, minus(link, on));
                let coriolis = T::exactly(-2.0) * omega * along;
                self.push(given, joint, &mut sides, sum, turning, 1);
                let across = joint.row + 1;
                sides[across] = sides[across].clone() + coriolis;
            } else {
                self.push(given, joint, &mut sides, sum, turning, 1);
            }
        }
        sides
    }

    /// The right sides of a joint: both components; or the rotations', the component across the guide and, where it is driven, that
    /// along it. `order` is 0 for velocities, 1 for accelerations.
    fn push<T: Real>(
        &self,
        given: &Given<T>,
        joint: &Joint,
        sides: &mut Vec<T>,
        sum: Vector<T>,
        turning: T,
        order: usize,
    ) {
        let Some(slider) = joint.slider else {
            sides.extend(sum);
            return;
        };
        let guide = given.guides[slider].clone();
        sides.extend([turning, dot(turned(guide.clone()), sum.clone())]);
        if let Some(drive) = joint.drive {
            let length = dot(guide.clone(), guide.clone()).root();
            sides.push(dot(guide, sum) - length * T::exactly(drive[order]));
        }
    }

    /// The motion of a body: known, or from the solution; without accelerations.
    fn state<T: Real>(&self, given: &Given<T>, side: Side, first: &[T]) -> State<T> {
        match side {
            Side::Known(body) => given.known[body].clone(),
            Side::Link(link) => State {
                velocity: [first[3 * link].clone(), first[3 * link + 1].clone()],
                omega: first[3 * link + 2].clone(),
                ..State::rest(given.points[self.homes[link]].clone())
            },
        }
    }

    /// The motions of all bodies from the solutions of both equations.
    pub fn states<T: Real>(&self, given: &Given<T>, first: &[T], second: &[T]) -> Vec<State<T>> {
        let bodies = self.links.iter().enumerate();
        bodies
            .map(|(body, link)| match link {
                None => given.known[body].clone(),
                Some(link) => State {
                    acceleration: [second[3 * link].clone(), second[3 * link + 1].clone()],
                    alpha: second[3 * link + 2].clone(),
                    ..self.state(given, Side::Link(*link), first)
                },
            })
            .collect()
    }

    fn arm<T: Real>(&self, given: &Given<T>, joint: &Joint, link: usize) -> Vector<T> {
        let home = given.points[self.homes[link]].clone();
        minus(given.points[joint.point].clone(), home)
    }
}
