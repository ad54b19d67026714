//! Four-bars, whose branches, limits and dead centres are known in closed form: on a branch the triangle of coupler, rocker and
//! diagonal never changes its hand.

use super::{TURN, U, path, posed};
use kinegon::cycle::Happening;
use kinegon::quantity::State;
use support::exact::Exact;
use support::random::Random;
use support::survey::{FOUR_BAR_POSITIONS, FOUR_BARS};

/// Four-bars of each kind.
fn bars() -> usize {
    FOUR_BARS.now()
}

/// Positions on a path that are compared.
fn positions() -> u32 {
    FOUR_BAR_POSITIONS.now()
}

/// The largest error of a position in units of rounding over the sine of the transmission angle; the worst seen is 4.3.
const BOUND: f64 = 20.0;

/// Lengths of a four-bar.
#[derive(Clone, Copy, Debug)]
pub struct FourBar {
    pub crank: f64,
    pub coupler: f64,
    pub rocker: f64,
    pub ground: f64,
}

impl FourBar {
    /// The scene at a crank angle in degrees, with C near a place.
    pub fn scene(&self, angle: f64, near: [f64; 2]) -> String {
        let FourBar { crank, coupler, rocker, ground } = self;
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }},
              "ground": {{ "A": [0, 0], "D": [{ground:?}, 0] }},
              "links": {{
                "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {crank:?} }}, "drive": {{ "angle": {angle:?}, "omega": 1 }} }},
                "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {coupler:?} }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "DC": {rocker:?} }} }} }},
              "near": {{ "C": {near:?} }} }}"#
        )
    }

    /// C on one side of BD at a crank angle in degrees, and the sine of the transmission angle there; `None` where
    /// coupler and rocker do not meet.
    pub fn joint(&self, angle: f64, hand: f64) -> Option<([f64; 2], f64)> {
        let (sine, cosine) = libm::sincos(angle.to_radians());
        let (x, y) = (self.crank * cosine, self.crank * sine);
        let (dx, dy) = (self.ground - x, -y);
        let (b, c, d) = (self.coupler, self.rocker, libm::hypot(dx, dy));
        // Heron's formula: sixteen times the square of the triangle's area.
        let squares = (d + b + c) * (d + b - c) * (d - b + c) * (b + c - d);
        if squares < 0.0 {
            return None;
        }
        let along = 0.5 * (1.0 + (b - c) * (b + c) / (d * d));
        let across = hand * squares.sqrt() / (2.0 * d * d);
        let place = [x + along * dx - across * dy, y + along * dy + across * dx];
        Some((place, squares.sqrt() / (2.0 * b * c)))
    }

    /// Crank angles in degrees, from 0 to 180, where the diagonal is coupler plus rocker or their difference: there
    /// sin²(θ/2) = (d − (g − a)) (d + (g − a)) / (4 g a), whose factors cancel and are taken in exact arithmetic.
    fn limits(&self) -> Vec<f64> {
        let exact = Exact::from;
        let side = exact(self.ground) - exact(self.crank);
        let (b, c) = (exact(self.coupler), exact(self.rocker));
        let half_sines = [b + c, b - c].map(|d| {
            let product = (d - side) * (d + side);
            product.rounded() / (4.0 * self.ground * self.crank)
        });
        let real = half_sines.into_iter().filter(|s| (0.0..=1.0).contains(s));
        // The angle from both its sine and its cosine is exact near 0 and near 180.
        real.map(|s| 2.0 * libm::atan2(s.sqrt(), (1.0 - s).sqrt()).to_degrees()).collect()
    }
}

/// A four-bar whose shortest link is the crank, and which turns fully if `deficit` is positive: that is how much the
/// shortest and the longest link together are shorter than the others.
fn random_bar(random: &mut Random, deficit: f64) -> FourBar {
    let crank = 1.0 + random.unit();
    let ground = crank + 0.2 + 2.0 * random.unit();
    let coupler = crank + 0.2 + 2.0 * random.unit();
    let rocker = match random.below(3) {
        0 => ground + coupler - crank - deficit,
        1 => ground - coupler + crank + deficit,
        _ => coupler - ground + crank + deficit,
    };
    let bar = FourBar { crank, coupler, rocker, ground };
    if rocker > 1.05 * crank { bar } else { random_bar(random, deficit) }
}

/// Follows a branch once around or from limit to limit, and compares its positions with the closed form. Returns what happens, and the
/// largest error of C in units of rounding over the sine of the transmission angle.
fn followed(bar: &FourBar, start: f64, hand: f64) -> (Vec<(f64, Happening)>, f64) {
    let (place, _) = bar.joint(start, hand).expect("it can be assembled");
    let (mechanism, pose) = posed(&bar.scene(start, place));
    let mut path = path(&mechanism, &pose);
    let [low, high] = path.cover(None, None).expect("it can be followed");
    let mut walker = path.walker();
    let joint = mechanism.point("C").expect("a point of the scene");
    let size = bar.ground + bar.crank + bar.coupler + bar.rocker;
    let mut worst: f64 = 0.0;
    for k in 1..positions() {
        let angle = low + (high - low) * f64::from(k) / f64::from(positions());
        let position = walker.position(angle);
        let got = position.unwrap_or_else(|| panic!("{bar:?}: nothing at {angle}")).place(joint);
        let (place, sine) = bar.joint(angle, hand).expect("the closed form has it too");
        let off = libm::hypot(got.x - place[0], got.y - place[1]);
        worst = worst.max(off * sine / (size * U));
    }
    let events = path.events().into_iter().map(|e| (e.at, e.what));
    (events.collect(), worst)
}

#[test]
fn a_crank_that_turns_fully_stays_on_its_branch() {
    let mut random = Random(0xf4);
    let mut worst: f64 = 0.0;
    for exponent in 1..=9 {
        for _ in 0..bars() {
            let bar = random_bar(&mut random, libm::exp10(-f64::from(exponent)));
            let start = 360.0 * random.unit();
            for hand in [1.0, -1.0] {
                let (events, error) = followed(&bar, start, hand);
                let turns = |h: &Happening| matches!(h, Happening::TurnsBack { .. });
                assert!(events.iter().all(|e| turns(&e.1)), "{bar:?} {events:?}");
                worst = worst.max(error);
            }
        }
    }
    println!("largest error {worst:.1} u/sin μ");
    assert!(worst < BOUND, "{worst}");
}

#[test]
fn very_unequal_links_stay_on_their_branch() {
    let mut random = Random(0x4f);
    let mut worst: f64 = 0.0;
    for _ in 0..3 * bars() {
        let short = libm::exp10(-4.0 * random.unit());
        let long = 1.0 + random.unit();
        let rest = long + short * random.within(0.9);
        let bars = [
            // A short crank; a short ground, a drag link; a short coupler and a short rocker, whose crank swings.
            [short, long, 1.5, rest],
            [long, rest, 1.5, short],
            [long, short, 1.5, rest],
            [long, 1.5, short, rest],
        ];
        for [crank, coupler, rocker, ground] in bars {
            let bar = FourBar { crank, coupler, rocker, ground };
            for start in [20.0, 170.0, 300.0] {
                for hand in [1.0, -1.0] {
                    if bar.joint(start, hand).is_none() {
                        continue;
                    }
                    let (_, error) = followed(&bar, start, hand);
                    worst = worst.max(error);
                }
            }
        }
    }
    println!("largest error {worst:.1} u/sin μ");
    assert!(worst < BOUND, "{worst}");
}

/// Down to two limits 1e-4 turns apart with nothing between them.
#[test]
fn limits_are_those_of_the_diagonal() {
    let mut random = Random(0x1f);
    let (mut worst, mut seen) = (0.0_f64, 0);
    for exponent in 1..=8 {
        for _ in 0..bars() {
            let bar = random_bar(&mut random, -libm::exp10(-f64::from(exponent)));
            let limits = bar.limits();
            for hand in [1.0, -1.0] {
                let (events, _) = followed(&bar, 90.0, hand);
                let ends = events.iter().filter(|(_, what)| matches!(what, Happening::Limit(_)));
                let ends: Vec<f64> = ends.map(|e| e.0).collect();
                assert_eq!(ends.len(), 2, "{bar:?} {events:?}");
                seen += 2;
                for at in ends {
                    let folded = (at - TURN * (at / TURN).round()).abs();
                    let distances = limits.iter().map(|limit| (folded - limit).abs());
                    let nearest = distances.fold(f64::MAX, f64::min);
                    worst = worst.max(nearest / TURN);
                    // Rounding of a length moves the limit by its part of 1/sin θ.
                    let rounding = (4.0 * U / libm::sin(folded.to_radians())).to_degrees();
                    let allowed = 1e-12 * TURN + rounding;
                    assert!(nearest < allowed, "{bar:?}: {at} {limits:?}");
                }
            }
        }
    }
    println!("{seen} limits, largest error {worst:.1e} turns");
    assert_eq!(seen, 32 * bars());
}
