//! The example of Quintero et al. (2011): where its branch ends, how it grows there, and 72 true motions from two paths.

use crate::exact::minus;
use crate::{LOCATED, path, posed};
use kinegon::cycle::{Happening, Path};
use kinegon::geometry::degrees_of;
use kinegon::mechanism::SliderId;
use kinegon::plan::State;
use serde_json::Value;
use std::collections::BTreeMap;

const FIGURE_2: &str = include_str!("../../examples/figure-2.json");

/// Where the branch ends, in degrees, on both sides of zero.
const LIMIT: &str = "137.582082139174023594169921565";

#[test]
fn both_limits_are_located() {
    let (mechanism, pose) = posed(FIGURE_2);
    let mut path = path(&mechanism, &pose);
    path.cover(None, None).expect("it can be followed");
    for (above, limit) in [(true, LIMIT.to_owned()), (false, format!("-{LIMIT}"))] {
        let end = path.end(above).expect("the branch ends");
        let error = minus(end.at, &limit);
        println!("{limit}: {error:e}");
        assert!(error.abs() <= LOCATED, "{error:e}");
        let Happening::Limit { links } = &end.what else {
            panic!("{end:?}")
        };
        assert_eq!(links, "2, 3, 4, 5");
    }
    println!(
        "{} {:e} {:e}",
        path.node_count(),
        path.end(true).unwrap().at - path.high(),
        path.low() - path.end(false).unwrap().at
    );
}

/// θ ≈ θ* + c √δ, so the rate for a crank that runs away from the limit is c / (2 √δ), and wrong by a part of the order √δ.
#[test]
fn rates_grow_as_the_square_root_says() {
    let (mechanism, pose) = posed(FIGURE_2);
    let mut path = path(&mechanism, &pose);
    path.cover(None, None).expect("it can be followed");
    let limit: f64 = LIMIT.parse().expect("a number");
    let [two, four] = ["2", "4"].map(|name| mechanism.link(name).expect("a link"));
    let mut walker = path.walker();
    let coefficients = [
        0.208_316_168_621_543_87,
        -0.497_530_652_798_679_3,
        146.364_838_782_531_67,
    ];
    let mut before: Option<[f64; 3]> = None;
    for exponent in 2..=10 {
        let delta = libm::pow(10.0, -f64::from(exponent));
        let position = walker.position(limit - delta.to_degrees());
        let Some(position) = position else {
            println!("{exponent} not reached");
            continue;
        };
        let rates = [
            position.spin(two)[0],
            position.spin(four)[0],
            position.slide_rates(SliderId(0))[0],
        ];
        let mut errors = [0.0; 3];
        for k in 0..3 {
            let law = coefficients[k] / (2.0 * delta.sqrt());
            errors[k] = rates[k] / law - 1.0;
        }
        println!(
            "{delta:e} {errors:?} {:?}",
            before.map(|b| [0, 1, 2].map(|k| b[k] / errors[k]))
        );
        before = Some(errors);
    }
}
