//! Four-bars, whose branches are known in closed form: the hand of the triangle of coupler, rocker and diagonal never changes on one.

use crate::exact::Exact;
use crate::random::Random;
use crate::{LOCATED, path, posed};
use kinegon::cycle::Happening;
use kinegon::geometry::Point;
use kinegon::plan::State;

pub struct FourBar {
    pub crank: f64,
    pub coupler: f64,
    pub rocker: f64,
    pub ground: f64,
}

impl FourBar {
    pub fn scene(&self, angle: f64, [x, y]: [f64; 2]) -> String {
        let FourBar {
            crank,
            coupler,
            rocker,
            ground,
        } = self;
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }},
              "ground": {{ "A": [0, 0], "D": [{ground:?}, 0] }},
              "links": {{
                "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {crank:?} }}, "drive": {{ "angle": {angle:?}, "omega": 1 }} }},
                "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {coupler:?} }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "DC": {rocker:?} }} }} }},
              "near": {{ "C": [{x:?}, {y:?}] }} }}"#
        )
    }

    /// B at a crank angle in degrees.
    pub fn pin(&self, angle: f64) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(angle.to_radians());
        [self.crank * cosine, self.crank * sine]
    }

    /// C on one side of BD; `None` where coupler and rocker do not meet.
    pub fn joint(&self, angle: f64, hand: f64) -> Option<[f64; 2]> {
        let [x, y] = self.pin(angle);
        let (dx, dy) = (self.ground - x, -y);
        let square = dx * dx + dy * dy;
        let (b, c) = (self.coupler, self.rocker);
        let along = (square + (b - c) * (b + c)) / (2.0 * square);
        let d = square.sqrt();
        // Heron's formula as Kahan wrote it, by the four sums.
        let area = (d + b + c) * (d + b - c) * (d - b + c) * (b + c - d);
        if area < 0.0 {
            return None;
        }
        let across = hand * area.sqrt() / (2.0 * square);
        Some([x + along * dx - across * dy, y + along * dy + across * dx])
    }
}

/// sin²(θ/2) where the diagonal is as long as this, in exact arithmetic up to the last division.
fn half_sine_square(bar: &FourBar, diagonal: Exact) -> f64 {
    let side = Exact::from(bar.ground) - bar.crank.into();
    let top = (diagonal - side) * (diagonal + side);
    top.rounded() / (4.0 * bar.ground * bar.crank)
}

#[test]
fn nasty() {
    let mut random = Random(7);
    let mut worst: f64 = 0.0;
    let mut lim: f64 = 0.0;
    for exponent in 1..=12 {
        let mut stats = [0; 4];
        for trial in 0..60 {
            let deficit = -libm::pow(10.0, -f64::from(exponent));
            let crank = 1.0 + random.unit();
            let ground = crank + 2.0 * random.unit() + 0.2;
            let coupler = crank + 2.0 * random.unit() + 0.2;
            let rocker = match random.below(3) {
                0 => ground + coupler - crank - deficit,
                1 => ground - coupler + crank + deficit,
                _ => coupler - ground + crank + deficit,
            };
            if rocker < crank * 1.01 {
                continue;
            }
            let bar = FourBar {
                crank,
                coupler,
                rocker,
                ground,
            };
            let at = random.unit() * 360.0;
            for hand in [1.0, -1.0] {
                let Some(c) = bar.joint(at, hand) else {
                    continue;
                };
                let (mechanism, pose) = posed(&bar.scene(at, c));
                let mut path = path(&mechanism, &pose);
                path.cover(None, None).unwrap();
                for event in path.events() {
                    match event.what {
                        Happening::Change { .. } => stats[0] += 1,
                        Happening::Singular { .. } => stats[1] += 1,
                        Happening::Limit { .. } => {
                            stats[2] += 1;
                            let squares = [
                                Exact::from(coupler) + rocker.into(),
                                Exact::from(coupler) - rocker.into(),
                            ]
                            .map(|d| half_sine_square(&bar, d))
                            .into_iter()
                            .filter(|s| *s >= 0.0 && *s <= 1.0);
                            let half = 0.5 * event.at.to_radians();
                            let (s, c) = libm::sincos(half);
                            let err = squares
                                .map(|q| ((s * s - q) / (s * c).abs()).abs())
                                .fold(f64::MAX, f64::min);
                            let allowed = 2e-12 * 3.14159 + 4e-16 / (s * c).abs();
                            let err = err / allowed;
                            if err > 1.0 {
                                println!(
                                    "{deficit:e} {crank} {coupler} {rocker} {ground} at {at} hand {hand} {event:?} err {err:e} {:e}",
                                    (s * c).abs()
                                );
                                stats[3] += 1
                            }
                            lim = lim.max(err);
                        }
                        _ => {}
                    }
                }
            }
        }
        println!(
            "{exponent} change {} singular {} limit {} wrong {}",
            stats[0], stats[1], stats[2], stats[3]
        );
    }
    println!("worst {worst:e} {lim:e}");
}
