use super::{position, size, solvable};
use kinegon::editing::{Pins, Reshape, Reshaped};
use kinegon::geometry::Point;
use kinegon::mechanism::{BodyId, GROUND, Mechanism, PointId};
use kinegon::position::Pose;
use support::survey::PULLED;

fn pins(points: &[&str], lengths: &[&str]) -> Pins {
    let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    Pins { points: owned(points), lengths: owned(lengths) }
}

/// The largest distance of the points but for one, in parts of the size; ends of slotted levers on which nothing hangs may turn.
fn others_moved(mechanism: &Mechanism, before: &Pose, after: &Pose, joint: PointId) -> f64 {
    let slotted = mechanism.sliders.iter().map(|slider| slider.on).filter(|link| *link != GROUND).collect::<Vec<_>>();
    let is_end = |point: usize| {
        let mut bodies = (0..mechanism.bodies.len()).map(BodyId).filter(|id| mechanism.body(*id).has(PointId(point)));
        bodies.next().is_some_and(|first| slotted.contains(&first)) && bodies.next().is_none()
    };
    let pairs = before.points.iter().zip(&after.points).enumerate();
    let off = pairs.filter(|(index, _)| *index != joint.0 && !is_end(*index)).map(|(_, (a, b))| (a - b).norm());
    off.fold(0.0, f64::max) / size(before)
}

/// Why a pulled joint is held, in English.
fn told(reshaped: &Reshaped) -> Option<String> {
    reshaped.note.as_ref().map(ToString::to_string)
}

/// The ways that each joint is pulled, in parts of the mechanism's size.
const WAYS: [(f64, f64); 4] = [(0.06, 0.02), (-0.05, 0.11), (0.013, -0.07), (0.0, 0.2)];

#[test]
fn a_joint_goes_to_the_hand_and_all_others_stay() {
    let (mut free, mut held, mut refused) = (0, 0, 0);
    for (name, text) in solvable() {
        let (_, mechanism, pose) = position(&text).expect("solvable");
        let size = size(&pose);
        for (index, point) in mechanism.points.iter().enumerate() {
            let id = PointId(index);
            let pull =
                Reshape::new(&text, point, &Pins::default()).unwrap_or_else(|error| panic!("{name} {point}: {error}"));
            for (x, y) in WAYS.into_iter().skip(index % PULLED.now()).step_by(PULLED.now()) {
                let wanted = pose.point(id) + kinegon::geometry::Vector::new(x, y) * size;
                let Reshaped { text: new, pose: found, note, .. } = match pull.to(wanted.into()) {
                    Ok(reshaped) => reshaped,
                    Err(_) => {
                        refused += 1;
                        continue;
                    }
                };
                let (_, _, anew) = position(&new).unwrap_or_else(|error| panic!("{name} {point}: {error}\n{new}"));
                assert_eq!(anew.points, found.points, "{name} {point}");
                let others = others_moved(&mechanism, &pose, &anew, id);
                // A rack goes with its wheel, and that with what carries it.
                let rolls = text.contains("\"rack\"");
                assert!(others < 0.01 || rolls, "{name} {point} moves others by {others}\n{text}\n{new}");
                if note.is_none() {
                    let off = (anew.point(id) - wanted).norm() / size;
                    assert!(off < 0.01, "{name} {point} is off by {off}\n{new}");
                    free += 1;
                } else {
                    held += 1;
                }
                assert_eq!(new.matches("note").count(), text.matches("note").count(), "{name} {point}");
                // Numbers stay short.
                let grown = new.len().saturating_sub(text.len());
                assert!(grown < 200, "{name} {point}: {grown} bytes more\n{new}");
            }
        }
    }
    let every = PULLED.now();
    assert!(
        free > 700 / every && held > 50 / every && refused < free / 20,
        "{free} free, {held} held, {refused} refused"
    );
}

#[test]
fn pins_hold() {
    let text = include_str!("../../../templates/four-bar.json");
    let at = |pins: &Pins, place: [f64; 2]| {
        Reshape::new(text, "C", pins).expect("solvable").to(place).expect("it can go there")
    };
    let c = |reshaped: &Reshaped| reshaped.pose.point(reshaped.mechanism.point("C").expect("C"));
    let free = at(&Pins::default(), [130.0, 120.0]);
    assert_eq!(
        free.text,
        text.replace("\"BC\": 140", "\"BC\": 120.95")
            .replace("\"CD\": 110", "\"CD\": 123.69")
            .replace("[155, 110]", "[130, 120]")
    );
    assert_eq!(free.note, None);
    let pinned = at(&pins(&["C"], &[]), [130.0, 120.0]);
    assert_eq!((pinned.text.as_str(), told(&pinned).as_deref()), (text, Some("C is pinned")));
    let one = at(&pins(&["B"], &["2.BC"]), [130.0, 120.0]);
    assert!(one.text.contains("\"BC\": 140") && !one.text.contains("\"CD\": 110"), "{}", one.text);
    assert_eq!(told(&one).as_deref(), Some("C moves on a circle: BC is pinned"));
    let off = (c(&one) - Point::new(30.0, 51.96)).norm() - 140.0;
    assert!(off.abs() < 0.01, "{off}");
    let two = at(&pins(&[], &["2.CB", "3.CD"]), [130.0, 120.0]);
    assert_eq!(two.text, text);
    // Pulled below, it goes to the other crossing.
    let two = at(&pins(&[], &["2.CB", "3.CD"]), [80.0, -80.0]);
    assert!((c(&two) - Point::new(82.3, -77.9)).norm() < 0.2, "{}", two.text);
    assert!(two.text.contains("\"BC\": 140") && two.text.contains("\"CD\": 110"));
    let pull =
        |pins: &Pins| Reshape::new(text, "B", pins).expect("solvable").to([40.0, 60.0]).expect("it can go there").text;
    let free = pull(&Pins::default());
    assert!(free.contains("\"AB\": 72.11") && free.contains("\"angle\": 56.31"), "{free}");
    let angle = pull(&pins(&[], &["1.angle"]));
    assert!(angle.contains("\"angle\": 60,") && !angle.contains("\"AB\": 60 "), "{angle}");
    let both = pull(&pins(&[], &["1.angle", "1.AB"]));
    assert!(both.contains("\"angle\": 60,") && both.contains("\"AB\": 60,") | both.contains("\"AB\": 60 "), "{both}");
}

#[test]
fn guides_go_with_their_blocks_and_stay_where_pivots_go() {
    let text = include_str!("../../../templates/slider-crank.json");
    let pull = |point: &str, place: [f64; 2]| {
        Reshape::new(text, point, &Pins::default()).expect("solvable").to(place).expect("it can go there").text
    };
    let block = pull("C", [150.0, -35.0]);
    assert!(block.contains("\"through\": [0, -35]"), "{block}");
    let pivot = pull("A", [5.0, 7.0]);
    assert!(pivot.contains("\"through\": [0, -20]") && pivot.contains("\"ground\": { \"A\": [5, 7] }"), "{pivot}");
    let toggle = include_str!("../../../templates/toggle-press.json");
    let pivot =
        Reshape::new(toggle, "D", &Pins::default()).expect("solvable").to([10.0, 7.0]).expect("it can go there").text;
    assert!(pivot.contains("\"through\": [0, 0]"), "{pivot}");
    let figure = include_str!("../../../examples/figure-2.json");
    let end =
        Reshape::new(figure, "E", &Pins::default()).expect("solvable").to([400.0, 440.0]).expect("it can go there");
    assert_eq!(told(&end).as_deref(), Some("E moves on a line: the guide of 3/2"));
    let boom = include_str!("../../../templates/hydraulic-boom.json");
    let piston =
        Reshape::new(boom, "D", &Pins::default()).expect("solvable").to([900.0, 100.0]).expect("it can go there").text;
    assert!(!piston.contains("\"position\": 450,"), "{piston}");
}

#[test]
fn a_slotted_lever_turns_with_its_pin() {
    let text = include_str!("../../../templates/slotted-lever.json");
    let pull = |point: &str, place: [f64; 2], pins: &Pins| {
        Reshape::new(text, point, pins).expect("solvable").to(place).expect("it can go there")
    };
    let place = |reshaped: &Reshaped, point: &str| reshaped.pose.point(reshaped.mechanism.point(point).expect(point));
    let pin = pull("B", [60.0, 60.0], &Pins::default());
    assert_eq!(pin.note, None);
    assert!(
        (place(&pin, "B") - Point::new(60.0, 60.0)).norm() < 0.1 && pin.text.contains("\"CD\": 220 }"),
        "{}",
        pin.text
    );
    assert!(pin.text.contains("\"AB\": 84.85,") && pin.text.contains("\"angle\": 45,"), "{}", pin.text);
    let pivot = pull("D", [20.0, -100.0], &Pins::default());
    assert!(pivot.text.contains("\"AB\": 60,") && pivot.text.contains("\"CD\": 220 }"), "{}", pivot.text);
    // Where the lever's end is pinned, it cannot turn.
    let held = pull("B", [60.0, 60.0], &pins(&["C"], &[]));
    assert_eq!(told(&held).as_deref(), Some("B moves on a line: the guide of 2/3"));
}

#[test]
fn no_two_joints_of_a_link_in_one_place() {
    let text = include_str!("../../../templates/four-bar.json");
    let pull = Reshape::new(text, "C", &Pins::default()).expect("solvable");
    let error = pull.to([160.0, 0.0]).expect_err("there is D");
    assert!(error.message.to_string().starts_with("link 3 would have C and D in one place"), "{error}");
    assert!(pull.to([f64::NAN, 0.0]).is_err());
    assert!(Reshape::new(text, "X", &Pins::default()).is_err());
    assert!(Reshape::new("{}", "X", &Pins::default()).is_err());
}
