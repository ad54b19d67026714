//! A result against the result of the same scene changed: turned, mirrored, scaled, shifted, renamed.

use super::groups::{Names, Pair, distance, times};
use kinegon::format::{PointResult, ResultFile};

pub const U: f64 = f64::EPSILON / 2.0;

/// How far velocities and places of two results may be apart, in units u·cond: each may err by 8. Rates of single links and sliders are
/// held to what the results state of their errors instead: a very short link turns with the errors of its neighbours enlarged.
pub const BOUND: f64 = 16.0;

/// How far accelerations may be apart, which inherit the errors of the velocities and enlarge them once more.
pub const ACCELERATION_BOUND: f64 = 64.0;

/// How a result must change.
pub struct Change<'a> {
    pub place: &'a dyn Fn(Pair) -> Pair,
    pub vector: &'a dyn Fn(Pair) -> Pair,
    /// What a length becomes, in lengths.
    pub length: f64,
    /// What velocities and accelerations are multiplied with besides.
    pub order: [f64; 2],
    /// +1, or −1 for a mirror image.
    pub turn: f64,
    pub names: Names,
}

impl Default for Change<'_> {
    fn default() -> Self {
        Change { place: &|p| p, vector: &|v| v, length: 1.0, order: [1.0, 1.0], turn: 1.0, names: Names::default() }
    }
}

/// The largest magnitude of each kind of quantity.
pub struct Sizes {
    pub omega: f64,
    pub alpha: f64,
    pub length: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

impl Sizes {
    pub fn of(result: &ResultFile) -> Sizes {
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |m: f64, x| m.max(x.abs()));
        let named = || result.points.iter().filter(|(_, p)| p.on.is_none()).map(|(_, p)| p);
        let places: Vec<Pair> = named().filter_map(|p| p.position).collect();
        let spread = |axis: usize| {
            let (low, high) = places.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p[axis]), h.max(p[axis])));
            high - low
        };
        let omega = largest(&mut result.links.values().map(|l| l.omega));
        let alpha = largest(&mut result.links.values().filter_map(|l| l.alpha));
        let length = spread(0).max(spread(1));
        let velocity = largest(
            &mut named().filter_map(|p| p.velocity).flatten().chain(result.sliders.values().map(|s| s.velocity)),
        );
        let acceleration = largest(
            &mut named()
                .filter_map(|p| p.acceleration)
                .flatten()
                .chain(result.sliders.values().filter_map(|s| s.acceleration)),
        );
        Sizes { omega, alpha, length, velocity, acceleration }
    }
}

/// The largest differences between a changed scene's result and the changed result.
#[derive(Default)]
pub struct Differences {
    /// One unit, u·cond.
    pub unit: f64,
    /// What places that are not given, but found, add to the errors of rates: a part of the largest rate of their kind.
    pub placing: f64,
    /// Of positions and velocities, in that unit, and where.
    pub velocity: (f64, String),
    /// Of accelerations.
    pub acceleration: (f64, String),
    /// Of rates, in units of what the two results state as bounds of their errors.
    pub stated: (f64, String),
}

impl Differences {
    pub fn see(&mut self, what: &str, difference: f64, scale: f64) {
        let measured = ratio(difference, scale * self.unit);
        let accelerates = what.starts_with('a');
        let worst = if accelerates { &mut self.acceleration } else { &mut self.velocity };
        keep_worst(worst, measured, what);
    }

    pub fn see_pair(&mut self, what: &str, got: Option<Pair>, want: Option<Pair>, scale: f64) {
        match (got, want) {
            (Some(g), Some(w)) => self.see(what, libm::hypot(g[0] - w[0], g[1] - w[1]), scale),
            (None, None) => {}
            _ => self.see(what, f64::INFINITY, 1.0),
        }
    }

    /// A rate with its bound, and what it should be with its bound, beside the largest of its kind.
    pub fn see_rate(&mut self, what: &str, got: (f64, f64), want: (f64, f64), largest: f64) {
        let difference = got.0 - want.0;
        // The changes of a result round once themselves.
        let rounding = 2.0 * U * want.0.abs();
        keep_worst(&mut self.stated, ratio(difference, got.1 + want.1 + rounding + self.placing * largest), what);
    }

    pub fn merge(&mut self, other: Differences) {
        keep_worst(&mut self.velocity, other.velocity.0, &other.velocity.1);
        keep_worst(&mut self.acceleration, other.acceleration.0, &other.acceleration.1);
        keep_worst(&mut self.stated, other.stated.0, &other.stated.1);
    }

    pub fn small(&self) -> bool {
        self.velocity.0 <= BOUND && self.acceleration.0 <= ACCELERATION_BOUND && self.stated.0 <= 1.0
    }
}

impl std::fmt::Display for Differences {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [v, a, s] = [&self.velocity, &self.acceleration, &self.stated];
        write!(
            f,
            "velocities {:.3} u·cond ({}), accelerations {:.3} u·cond ({}), {:.3} of the stated bounds ({})",
            v.0, v.1, a.0, a.1, s.0, s.1
        )
    }
}

pub fn ratio(difference: f64, to: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference.abs() / to }
}

/// Keeps the larger one with its name; a NaN is the worst of all.
pub fn keep_worst(worst: &mut (f64, String), measured: f64, what: &str) {
    if measured.is_nan() || measured > worst.0 {
        *worst = (measured, what.to_owned());
    }
}

/// Compares them in units of `unit`; `placing` is what places that are found add to rates.
pub fn compare(before: &ResultFile, after: &ResultFile, change: &Change<'_>, unit: f64, placing: f64) -> Differences {
    let mut seen = Differences { unit, placing, ..Differences::default() };
    let sizes = Sizes::of(after);
    let names = &change.names;
    let [first, second] = change.order;
    let option = |x: Option<f64>| x.expect("accelerations were asked for");
    for (name, link) in &before.links {
        let got = &after.links[&names.link(name)];
        let by = first * change.turn;
        let want = (link.omega * by, link.omega_error * first.abs());
        seen.see_rate(&format!("omega({name})"), (got.omega, got.omega_error), want, sizes.omega);
        let by = second * change.turn;
        let want = (option(link.alpha) * by, option(link.alpha_error) * second);
        let got = (option(got.alpha), option(got.alpha_error));
        seen.see_rate(&format!("alpha({name})"), got, want, sizes.alpha);
    }
    for (name, slider) in &before.sliders {
        let (link, on) = name.split_once('/').expect("the name of a slider");
        // A pin in a slot, or on a flat profile, has the name of its point.
        let sliding = if before.links.contains_key(link) { names.link(link) } else { names.point(link) };
        let after = &after.sliders[&format!("{sliding}/{}", names.link(on))];
        let by = first * change.length;
        let want = (slider.velocity * by, slider.velocity_error * by.abs());
        let got = (after.velocity, after.velocity_error);
        seen.see_rate(&format!("v_r({name})"), got, want, sizes.velocity);
        let by = second * change.length;
        let want = (option(slider.acceleration) * by, option(slider.acceleration_error) * by);
        let got = (option(after.acceleration), option(after.acceleration_error));
        seen.see_rate(&format!("a_r({name})"), got, want, sizes.acceleration);
        let coriolis = slider.coriolis.map(|c| times((change.vector)(c), second));
        seen.see_pair(&format!("a_c({name})"), after.coriolis, coriolis, sizes.acceleration);
    }
    // Any joint: what counts is how many sizes of the mechanism a special point is away.
    let (_, home) = after.points.first().expect("there are joints");
    for (name, point) in &before.points {
        let new_name = match (name.strip_prefix('S'), name.split_once('_')) {
            (Some(links), None) => {
                // Of a third-class group it is named after two legs: in another order of the links, perhaps after two others.
                let names = legs(links, before).map(|link| names.link(link));
                let new_name = format!("S{}", names.concat());
                if change.names.reversed && !after.points.contains_key(&new_name) {
                    assert_ne!(names[1], "", "no {new_name} for {name}");
                    continue;
                }
                new_name
            }
            (_, Some((point, on))) => format!("{}_{}", names.point(point), names.link(on)),
            _ => names.point(name),
        };
        let got = after.points.get(&new_name);
        let got = got.unwrap_or_else(|| panic!("no {new_name} for {name}"));
        if name.starts_with('S') && !name.contains('_') {
            special(&mut seen, name, [point, got], home, change, &sizes);
            continue;
        }
        let motion = |value: Option<Pair>, by: f64| value.map(|v| times((change.vector)(v), by));
        // Places are given; a far origin leaves them exact too.
        seen.see_pair(
            &format!("place of {name}"),
            got.position,
            point.position.map(|p| (change.place)(p)),
            sizes.length,
        );
        seen.see_pair(&format!("v({name})"), got.velocity, motion(point.velocity, first), sizes.velocity);
        seen.see_pair(&format!("a({name})"), got.acceleration, motion(point.acceleration, second), sizes.acceleration);
    }
    seen
}

/// The one or two links after which a special point is named.
fn legs<'a>(links: &'a str, result: &ResultFile) -> [&'a str; 2] {
    let is_link = |name: &str| name.is_empty() || result.links.contains_key(name);
    let mut cuts = (1..=links.len()).rev().filter_map(|at| links.split_at_checked(at));
    let cut = cuts.find(|(a, b)| is_link(a) && is_link(b));
    cut.unwrap_or_else(|| panic!("S{links} is named after no link")).into()
}

/// A special point's error grows with the square of its distance; very far away it may turn into a direction.
pub fn special(
    seen: &mut Differences,
    name: &str,
    [before, got]: [&PointResult; 2],
    home: &PointResult,
    change: &Change<'_>,
    sizes: &Sizes,
) {
    let home = home.position.expect("a joint has a place");
    let far = |place: Pair| distance(place, home) / sizes.length;
    let expected = before.position.map(|p| (change.place)(p));
    let (Some(want), Some(place)) = (expected, got.position) else {
        if let Some(place) = expected.or(got.position) {
            seen.see(&format!("{name} at infinity"), if far(place) > 1e8 { 0.0 } else { f64::INFINITY }, 1.0);
        }
        return;
    };
    let far = far(want).max(1.0);
    let origin = libm::hypot(want[0], want[1]);
    let blur = (sizes.length * far * far).max(origin);
    seen.see_pair(&format!("place of {name}"), Some(place), Some(want), blur);
    let [first, second] = change.order;
    let motion = |value: Option<Pair>, by: f64| value.map(|v| times((change.vector)(v), by));
    // It is the motion of the link there, so a blurred place blurs it.
    let omega = sizes.omega;
    let rates = [sizes.velocity.max(blur * omega), sizes.acceleration.max(blur * sizes.alpha.max(omega * omega))];
    seen.see_pair(&format!("v({name})"), got.velocity, motion(before.velocity, first), rates[0]);
    seen.see_pair(&format!("a({name})"), got.acceleration, motion(before.acceleration, second), rates[1]);
}
