//! What holds of every mechanism, tried on the templates with other numbers and on random groups: how it is looked at changes results
//! only as it should, plans show images of links, both routes agree, rates are derivatives of positions.
//!
//! The same scenes in every run; PROPTEST_CASES=1000 tries more of them.

mod looks;
mod scenes;

use kinegon::format::ResultFile;
use kinegon::mechanism::StructureError;
use kinegon::{Error, Solution};
use looks::{Look, renamed, reversed};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, RngSeed};
use scenes::{Scene, scenes, varied};
use serde_json::Value;
use support::changes::{self, Change, U, compare};
use support::groups::Names;
use support::images::dissimilarity;
use support::later;
use support::stages::solved;
use support::survey::PROPERTIES;

/// Positions that are less certain than this are left to the tests that know how uncertain.
const HARDEST: f64 = 1e3;

/// Rates by differences, relative to the largest of their kind.
const DIFFERENCES: f64 = 1e-4;

fn config() -> ProptestConfig {
    ProptestConfig {
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(60),
        failure_persistence: None,
        ..ProptestConfig::with_cases(PROPERTIES.now())
    }
}

/// A scene that can be solved, with all that is known of it.
struct Moving {
    solution: Solution,
    result: ResultFile,
    /// The product of its groups' condition numbers: how much they can enlarge an error together.
    condition: f64,
}

/// `None` where it cannot be assembled or moved.
fn moving(scene: &Value) -> Result<Option<Moving>, TestCaseError> {
    match solved(&scene.to_string()) {
        Ok(solution) => {
            let result = solution.result();
            let condition = result.groups.iter().map(|group| group.condition).product();
            Ok(Some(Moving { solution, result, condition }))
        }
        Err(Error::Assembly(_) | Error::Motion(_) | Error::Structure(StructureError::Singular { .. })) => Ok(None),
        // Varied lengths of a thin triangle.
        Err(Error::Scene(error)) if error.message.to_string().contains("cannot form a triangle") => Ok(None),
        Err(error) => Err(TestCaseError::fail(format!("{error}\n{scene}"))),
    }
}

/// The scene and the scene changed differ as they should.
fn changed(scene: &Value, other: &Value, change: &Change<'_>) -> Result<[ResultFile; 2], TestCaseError> {
    let before = moving(scene)?;
    prop_assume!(before.as_ref().is_some_and(|before| before.condition < HARDEST));
    let (Some(before), Some(after)) = (before, moving(other)?) else {
        return Err(TestCaseError::fail(format!("only one of two can be solved\n{other}")));
    };
    // Positions that are found, not given, carry errors of their own; and so do the rates that follow from them.
    let found = scene.get("points").is_none();
    let condition = before.condition.max(after.condition);
    let (unit, placing) = if found {
        let unit = U * condition * condition;
        (unit, 64.0 * unit * condition)
    } else {
        (U * condition, 64.0 * U * condition)
    };
    let seen = compare(&before.result, &after.result, change, unit, placing);
    prop_assert!(seen.small(), "{}\n{}", seen, other);
    Ok([before.result, after.result])
}

/// The plane turned and perhaps mirrored, units of length and time changed.
fn looked_at(scene: &Scene, look: Look) -> Result<(), TestCaseError> {
    // In the mirror the direction of a flat profile is the opposite one, and so is the sense of what slides on it.
    let mut contacts = scene.0["contacts"].as_array().into_iter().flatten();
    if look.sense < 0.0 && contacts.any(|contact| !contact["along"].is_null()) {
        return Ok(());
    }
    let vector = |v| look.vector(v);
    let change = Change {
        place: &vector,
        vector: &vector,
        length: look.length,
        order: [look.pace, look.pace * look.pace],
        turn: look.sense,
        names: Names::default(),
    };
    let [before, after] = changed(&scene.0, &look.scene(&scene.0), &change)?;
    for (name, link) in &before.links {
        let Some(angle) = link.angle else { continue };
        // Of a link with one point as drawn it is that of its guide.
        let off = after.links[name].angle.unwrap_or(f64::NAN) - look.angle(angle);
        let turns = (off / 360.0).round();
        prop_assert!((off - 360.0 * turns).abs() < 1e-6, "angle({}) is {} off", name, off);
    }
    Ok(())
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn turning_the_plane_turns_the_result(scene in scenes(), turned in -180..=180_i32) {
        looked_at(&scene, Look { turned: turned.into(), ..Look::SAME })?;
    }

    #[test]
    fn a_mirror_image_turns_the_other_way(scene in scenes()) {
        looked_at(&scene, Look { sense: -1.0, ..Look::SAME })?;
    }

    #[test]
    fn units_do_not_matter(scene in scenes(), length in 1e-6..1e6_f64, pace in 1e-3..1e3_f64) {
        looked_at(&scene, Look { length, pace, ..Look::SAME })?;
    }

    /// Velocities change their sign, accelerations stay as they are, to the last bit: they know the squares of rates only.
    #[test]
    fn time_running_backwards_turns_velocities_round(scene in scenes()) {
        looked_at(&scene, Look { pace: -1.0, ..Look::SAME })?;
    }

    #[test]
    fn names_and_order_do_not_matter(scene in scenes()) {
        let change = Change { names: Names { renamed: true, reversed: true }, ..Change::default() };
        let other = reversed(&renamed(&scene.0, &change.names));
        changed(&scene.0, &other, &change)?;
    }

    #[test]
    fn plans_are_images_and_both_routes_agree(scene in scenes()) {
        let Some(Moving { solution, result, condition }) = moving(&scene.0)? else {
            return Err(TestCaseError::reject("not solvable"));
        };
        let (_, part, what) = dissimilarity(&solution, &result, condition);
        prop_assert!(part <= 1.0, "{}: {} of what is allowed", what, part);
        for group in &result.groups {
            if let (Some(difference), Some(allowed)) = (group.disagreement, group.disagreement_allowed) {
                prop_assert!(difference <= allowed, "{:?}: {} > {}", group.links, difference, allowed);
            }
        }
    }

    #[test]
    fn rates_are_derivatives_of_positions(scene in varied()) {
        let (Some(now), Some(fastest)) = (moving(&scene.0)?, later::fastest(&scene.0)) else {
            return Err(TestCaseError::reject("it does not move"));
        };
        prop_assume!(now.condition < 100.0);
        // Steps of a twentieth and a fortieth of a degree.
        let steps = [0.05_f64, 0.025].map(|degrees| degrees.to_radians() / fastest);
        let mut errors = [[0.0; 2]; 2];
        for (error, time) in errors.iter_mut().zip(steps) {
            match later::differences(&scene.0, &now.result, time) {
                Ok(found) => *error = found,
                Err(_) => return Err(TestCaseError::reject("next to a limit")),
            }
        }
        let sizes = changes::Sizes::of(&now.result);
        for (what, index, size) in [("velocity", 0, sizes.velocity), ("acceleration", 1, sizes.acceleration)] {
            let [coarse, fine] = errors.map(|error| error[index]);
            prop_assert!(fine <= DIFFERENCES * size, "{} differs by {:e}, then {:e} of {:e}", what, coarse, fine, size);
        }
    }
}
