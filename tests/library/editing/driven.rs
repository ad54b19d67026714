use super::{position, size, solvable};
use kinegon::cycle::{Drive, Path};
use kinegon::editing::{with_mode, with_position};
use kinegon::position::{Pose, counted_poses};
use kinegon::scene::GivenBy;
use support::survey::DRIVEN_POSITIONS;

/// The largest distance of a point in two positions, in parts of the size.
fn distance(one: &Pose, other: &Pose) -> f64 {
    let off = one.points.iter().zip(&other.points).map(|(a, b)| (a - b).norm());
    off.fold(0.0, f64::max) / size(one)
}

#[test]
fn a_mode_that_is_chosen_is_taken() {
    let mut seen = 0;
    for (name, text) in solvable() {
        let (scene, mechanism, _) = position(&text).expect("solvable");
        let Ok(listed) = counted_poses(&mechanism, &scene.near) else { continue };
        for (index, wanted) in listed.poses.iter().enumerate().take(12) {
            let chosen = with_mode(&text, index + 1).unwrap_or_else(|error| panic!("{name} {index}: {error}"));
            let (_, _, pose) = position(&chosen).expect("it is solvable");
            assert!(distance(wanted, &pose) < 1e-6, "{name} {index}\n{chosen}");
            seen += 1;
        }
        let error = with_mode(&text, 4097).expect_err("there are not so many");
        assert!(
            error.message.to_string().starts_with("there is no assembly mode 4097")
                || error.message.to_string().contains("too far"),
            "{error}"
        );
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn a_drive_put_into_the_text_stays_on_its_branch() {
    let steps = DRIVEN_POSITIONS.now();
    let (mut seen, mut as_it_was) = (0, 0);
    for (name, text) in solvable() {
        let (scene, mechanism, pose) = position(&text).expect("solvable");
        if scene.given_by == GivenBy::Drawing {
            assert!(with_position(&text, &pose).is_err(), "{name}");
            continue;
        }
        for drive in mechanism.drive_names() {
            let of_path = Drive::new(&mechanism, Some(&drive)).expect("one of its names");
            let Ok(mut path) = Path::new(&mechanism, &pose, of_path) else { continue };
            let Ok([from, to]) = path.cover(None, None) else { continue };
            let mut walker = path.walker();
            for step in 0..steps {
                let value = from + (to - from) * (f64::from(step) + 0.37) / f64::from(steps);
                let Some(now) = walker.position(value).map(|position| position.pose()) else { continue };
                let moved =
                    with_position(&text, &now).unwrap_or_else(|error| panic!("{name} {drive} at {value}: {error}"));
                let (_, _, there) = position(&moved).expect("it is solvable");
                let off = distance(&now, &there);
                assert!(off <= 0.02, "{name} {drive} at {value}: {off}\n{moved}");
                assert_eq!(moved.matches("note").count(), text.matches("note").count());
                is_nearest(&moved, &now, &there);
                seen += 1;
                as_it_was += usize::from(moved.contains("\"near\"") == text.contains("\"near\""));
            }
        }
    }
    assert!(seen > 25 * steps as usize && as_it_was > seen / 2, "{as_it_was} of {seen}");
}

/// No other assembly mode is as near to the position that was meant; of a lever turned round, its axis tells.
fn is_nearest(text: &str, now: &Pose, taken: &Pose) {
    let (scene, mechanism, _) = position(text).expect("it is solvable");
    let listed = counted_poses(&mechanism, &scene.near).expect("it has modes");
    let turned = |pose: &Pose| {
        let axes = pose
            .axes
            .iter()
            .zip(&now.axes)
            .filter_map(|(a, b)| Some((a.as_ref()?.normalize() - b.as_ref()?.normalize()).norm()));
        axes.fold(0.0, f64::max)
    };
    let off = |pose: &Pose| distance(now, pose) + turned(pose);
    let least = listed.poses.iter().take(16).map(off).fold(f64::INFINITY, f64::min);
    assert!(off(taken) <= least + 1e-6, "{} and {least}\n{text}", off(taken));
}

#[test]
fn a_drive_is_rounded() {
    let text = include_str!("../../../templates/four-bar.json");
    let (_, mechanism, pose) = position(text).expect("a template");
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a crank")).expect("it moves");
    path.follow_to(100.0);
    let mut walker = path.walker();
    let now = walker.position(71.2345).expect("on the way").pose();
    let moved = with_position(text, &now).expect("it is solvable");
    assert_eq!(moved, text.replace("\"angle\": 60", "\"angle\": 71.2"));
    let now = walker.position(60.0).expect("on the way").pose();
    assert_eq!(with_position(text, &now).expect("the same"), text);
    path.follow_to(400.0);
    let now = path.walker().position(385.0).expect("on the way").pose();
    assert_eq!(with_position(text, &now).expect("it is solvable"), text.replace("\"angle\": 60", "\"angle\": 25"));
}

#[test]
fn the_angle_of_another_link_moves_in_place_of_the_drive() {
    let text = include_str!("../../../templates/four-bar.json").replace("\"angle\": 60, ", "");
    let text = text
        .replace("\"CD\": 110 } }", "\"CD\": 110 }, \"angle\": 91.3 }")
        .replace("\"near\": { ", "\"near\": { \"B\": [30, 52], ");
    let (_, mechanism, pose) = position(&text).unwrap_or_else(|error| panic!("{error}"));
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a crank")).expect("it moves");
    path.follow_to(120.0);
    let now = path.walker().position(100.0).expect("on the way").pose();
    let moved = with_position(&text, &now).expect("it is solvable");
    let (scene, _, there) = position(&moved).expect("it is solvable");
    assert!(distance(&now, &there) < 0.005, "{moved}");
    assert!(
        scene.links["1"].drive.is_some_and(|drive| drive.angle_deg.is_none())
            && scene.links["3"].angle_deg != Some(91.3)
    );
}
