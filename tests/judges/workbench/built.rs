//! Eight mechanisms are built in Build from nothing: by mouse, by finger, by keys alone. What is saved stands and moves as the geometry
//! that was meant does, by equations of this file's own: places by crossings of circles and lines, rates by differences of places.

use super::bench::Bench;
use super::build::{click, drag, empty, on_screen, places, state, tool};
use nalgebra::Complex;
use serde_json::json;
use support::survey::Size;

type Z = Complex<f64>;

/// What a hand does.
enum Act {
    /// Chooses a tool, or one of its choices.
    Tool(&'static str),
    /// Goes from one place to another.
    Drag([f64; 2], [f64; 2]),
    /// Presses at a place.
    Press([f64; 2]),
}

use Act::{Drag, Press, Tool};

/// A mechanism: how it is built, and where its points are so many seconds later.
struct Kind {
    name: &'static str,
    acts: Vec<Act>,
    meant: fn(f64) -> Vec<Z>,
}

fn z(x: f64, y: f64) -> Z {
    Z::new(x, y)
}

/// The unit vector of an angle.
fn turned(angle: f64) -> Z {
    z(libm::cos(angle), libm::sin(angle))
}

/// The end of a crank that turns by 10 radians a second.
fn crank(pivot: Z, end: Z, time: f64) -> Z {
    pivot + (end - pivot) * turned(10.0 * time)
}

/// Where two circles cross, on the left of the way from the one middle to the other, or with −1 on the right.
fn crossing(a: Z, from_a: f64, b: Z, from_b: f64, side: f64) -> Z {
    let way = b - a;
    let along = (from_a * from_a - from_b * from_b + way.norm_sqr()) / (2.0 * way.norm());
    let beside = libm::sqrt(from_a * from_a - along * along);
    a + way / way.norm() * z(along, side * beside)
}

/// Where `joint` has come to, whose distances from two points stay as they were.
fn joint(a: [Z; 2], b: [Z; 2], joint: Z) -> Z {
    let [(a0, a), (b0, b)] = [a, b].map(|[before, now]| (before, now));
    let side = ((b0 - a0).conj() * (joint - a0)).im.signum();
    crossing(a, (joint - a0).norm(), b, (joint - b0).norm(), side)
}

/// Where a point of a link has come to, of which two points are known.
fn carried(a: [Z; 2], b: [Z; 2], point: Z) -> Z {
    a[1] + (b[1] - a[1]) * (point - a[0]) / (b[0] - a[0])
}

fn still(place: Z) -> [Z; 2] {
    [place, place]
}

fn four_bar() -> Kind {
    let [a, b, c, d] = [[0.0, 0.0], [20.0, 60.0], [140.0, 100.0], [160.0, 0.0]];
    let acts =
        vec![Drag(a, b), Drag(b, c), Drag(c, d), Tool("fixed"), Press(a), Press(d), Tool("drive"), Press([10.0, 30.0])];
    let meant = |time| {
        let [a, b0, c0, d] = [z(0.0, 0.0), z(20.0, 60.0), z(140.0, 100.0), z(160.0, 0.0)];
        let b = crank(a, b0, time);
        vec![a, b, joint([b0, b], still(d), c0), d]
    };
    Kind { name: "four-bar", acts, meant }
}

fn slider_crank() -> Kind {
    let [a, b, c] = [[0.0, 0.0], [30.0, 40.0], [150.0, 0.0]];
    let acts = vec![
        Drag(a, b),
        Drag(b, c),
        Tool("fixed"),
        Press(a),
        Tool("slider"),
        Drag(c, [190.0, 0.0]),
        Tool("drive"),
        Press([12.0, 16.0]),
    ];
    let meant = |time| {
        let b = crank(z(0.0, 0.0), z(30.0, 40.0), time);
        vec![z(0.0, 0.0), b, z(b.re + libm::sqrt(120.0 * 120.0 + 40.0 * 40.0 - b.im * b.im), 0.0)]
    };
    Kind { name: "slider-crank", acts, meant }
}

/// A crank's pin slides in a lever, which moves the ram of a shaper.
fn shaper() -> Kind {
    let [a, b, c, d, e] = [[0.0, 0.0], [40.0, 20.0], [0.0, -80.0], [60.0, 80.0], [140.0, 100.0]];
    let acts = vec![
        Drag(a, b),
        Drag(c, d),
        Drag(d, e),
        Tool("fixed"),
        Press(a),
        Press(c),
        Tool("slider"),
        Drag(b, [18.0, -32.0]),
        Drag(e, [180.0, 100.0]),
        Tool("drive"),
        Press([16.0, 8.0]),
    ];
    let meant = |time| {
        let [b, c] = [crank(z(0.0, 0.0), z(40.0, 20.0), time), z(0.0, -80.0)];
        let d = c + (b - c) / (b - c).norm() * z(60.0, 160.0).norm();
        let rise = 100.0 - d.im;
        vec![z(0.0, 0.0), b, c, d, z(d.re + libm::sqrt(80.0 * 80.0 + 20.0 * 20.0 - rise * rise), 100.0)]
    };
    Kind { name: "shaper", acts, meant }
}

/// Klann's leg.
fn klann() -> Kind {
    let [m, a, b, c, d] = [[100.0, 30.0], [120.0, 40.0], [70.0, -10.0], [70.0, 30.0], [20.0, 40.0]];
    let [e, f, g] = [[70.0, 90.0], [20.0, 90.0], [0.0, -40.0]];
    let acts = vec![
        Drag(m, a),
        Drag(a, c),
        Drag(b, c),
        Tool("third"),
        Drag([94.0, 34.0], d),
        Tool("link"),
        Drag(d, f),
        Drag(e, f),
        Tool("third"),
        Drag([20.0, 66.0], g),
        Tool("fixed"),
        Press(m),
        Press(b),
        Press(e),
        Tool("drive"),
        Press([110.0, 34.0]),
    ];
    let meant = |time| {
        let [m, a0, b, c0, d0] = [z(100.0, 30.0), z(120.0, 40.0), z(70.0, -10.0), z(70.0, 30.0), z(20.0, 40.0)];
        let [e, f0, g0] = [z(70.0, 90.0), z(20.0, 90.0), z(0.0, -40.0)];
        let a = crank(m, a0, time);
        let c = joint([a0, a], still(b), c0);
        let d = carried([a0, a], [c0, c], d0);
        let f = joint([d0, d], still(e), f0);
        vec![m, a, b, c, d, e, f, carried([d0, d], [f0, f], g0)]
    };
    Kind { name: "Klann", acts, meant }
}

/// Two blocks on crossing guides carry a bar, whose third point runs on an ellipse.
fn trammel() -> Kind {
    let [a, b] = [[0.0, 80.0], [120.0, 0.0]];
    let acts = vec![
        Drag(a, b),
        Tool("third"),
        Drag([60.0, 40.0], [160.0, -30.0]),
        Tool("slider"),
        Drag(a, [0.0, 120.0]),
        Drag(b, [170.0, 0.0]),
        Tool("drive"),
        Press(b),
    ];
    let meant = |time| {
        let x = 120.0 + 40.0 * time;
        let [a, b] = [z(0.0, libm::sqrt(120.0 * 120.0 + 80.0 * 80.0 - x * x)), z(x, 0.0)];
        vec![a, b, carried([z(0.0, 80.0), a], [z(120.0, 0.0), b], z(160.0, -30.0))]
    };
    Kind { name: "trammel", acts, meant }
}

fn scotch_yoke() -> Kind {
    let [a, b, c, d] = [[0.0, 0.0], [40.0, 30.0], [40.0, 0.0], [160.0, 0.0]];
    let acts = vec![
        Drag(a, b),
        Drag(c, d),
        Tool("fixed"),
        Press(a),
        Tool("slider"),
        Tool("itself"),
        Drag(d, [200.0, 0.0]),
        Tool("block"),
        Tool("across"),
        Drag(b, [100.0, 0.0]),
        Tool("drive"),
        Press([16.0, 12.0]),
    ];
    let meant = |time| {
        let b = crank(z(0.0, 0.0), z(40.0, 30.0), time);
        vec![z(0.0, 0.0), b, z(b.re, 0.0), z(b.re + 120.0, 0.0)]
    };
    Kind { name: "Scotch yoke", acts, meant }
}

/// Two shafts side by side, coupled by a block that slides on both, at right angles.
fn oldham() -> Kind {
    let [a, b, c, d, e] = [[0.0, 0.0], [80.0, 0.0], [20.0, 20.0], [20.0, 100.0], [20.0, 0.0]];
    let acts = vec![
        Drag(a, b),
        Drag(c, d),
        Tool("fixed"),
        Press(a),
        Press(c),
        Tool("slider"),
        Drag(e, [60.0, 0.0]),
        Tool("itself"),
        Drag(e, [20.0, 60.0]),
        Tool("drive"),
        Press([70.0, 0.0]),
    ];
    let meant = |time| {
        let [way, c] = [turned(10.0 * time), z(20.0, 20.0)];
        vec![z(0.0, 0.0), way * 80.0, c, c + way * z(0.0, 80.0), way * (way.conj() * c).re]
    };
    Kind { name: "Oldham coupling", acts, meant }
}

/// Three arms, each pushed by a cylinder.
fn boom() -> Kind {
    let [a, b, c, d] = [[0.0, 0.0], [100.0, 80.0], [180.0, 40.0], [200.0, -20.0]];
    let [e, f, g, h] = [[50.0, 70.0], [110.0, 120.0], [220.0, 30.0], [60.0, -40.0]];
    let acts = vec![
        Drag(a, b),
        Drag(b, c),
        Drag(c, d),
        Tool("third"),
        Drag([50.0, 40.0], e),
        Drag([120.0, 70.0], f),
        Drag([190.0, 10.0], g),
        Tool("cylinder"),
        Drag(h, e),
        Drag(e, f),
        Drag(f, g),
        Tool("fixed"),
        Press(a),
        Press(h),
    ];
    let meant = |time| {
        let [a, b0, c0, d0] = [z(0.0, 0.0), z(100.0, 80.0), z(180.0, 40.0), z(200.0, -20.0)];
        let [e0, f0, g0, h] = [z(50.0, 70.0), z(110.0, 120.0), z(220.0, 30.0), z(60.0, -40.0)];
        // A new cylinder grows by a tenth of its length in a second, to four digits.
        let cylinder = |from: Z, to: Z| {
            let length = (to - from).norm();
            length + time * format!("{:.3e}", 0.1 * length).parse::<f64>().expect("a number")
        };
        let e = crossing(a, (e0 - a).norm(), h, cylinder(h, e0), 1.0);
        let b = carried(still(a), [e0, e], b0);
        let f = crossing(b, (f0 - b0).norm(), e, cylinder(e0, f0), -1.0);
        let c = carried([b0, b], [f0, f], c0);
        let g = crossing(c, (g0 - c0).norm(), f, cylinder(f0, g0), -1.0);
        vec![a, b, c, carried([c0, c], [g0, g], d0), e, f, g, h]
    };
    Kind { name: "boom", acts, meant }
}

/// Builds it by mouse.
fn by_mouse(bench: &mut Bench, acts: &[Act]) {
    for act in acts {
        match act {
            Tool(name) => tool(bench, name),
            Drag(from, to) => drag(bench, *from, *to),
            Press(at) => click(bench, *at),
        }
    }
}

/// Builds it by finger.
fn by_finger(bench: &mut Bench, acts: &[Act]) {
    for act in acts {
        match act {
            Tool(name) => bench.tap(&format!("#build .tools [data-value={name}]")),
            Drag(from, to) => {
                let [from, to] = [*from, *to].map(|place| on_screen(bench, place));
                let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
                bench.touch(&[&[from], &[middle], &[to]]);
            }
            Press(at) => {
                let at = on_screen(bench, *at);
                bench.touch(&[&[at]]);
            }
        }
        bench.settle();
    }
}

/// Builds it by keys alone: digits choose tools, arrows move the cross, with Shift by a fifth, and Enter presses.
fn by_keys(bench: &mut Bench, acts: &[Act]) {
    const TOOLS: [&str; 8] = ["select", "link", "third", "fixed", "slider", "cylinder", "drive", "drop"];
    const SLIDING: &[&str] = &["block", "itself", "pin"];
    const GUIDED: &[&str] = &["along", "across"];
    let [mut sliding, mut guided] = [(SLIDING, 0, "w"), (GUIDED, 0, "x")];
    bench.press("ArrowRight");
    bench.press("ArrowLeft");
    bench.frame();
    let spoken = bench.text("document.querySelector('#spoken').textContent");
    let mut cross: Vec<f64> = spoken.split(", ").map(|number| number.parse().expect("a place")).collect();
    let mut press = |bench: &mut Bench, to: &[f64; 2]| {
        for (axis, keys) in [["ArrowLeft", "ArrowRight"], ["ArrowDown", "ArrowUp"]].iter().enumerate() {
            while (to[axis] - cross[axis]).abs() > 1e-9 {
                let off = to[axis] - cross[axis];
                let (step, held) = if off.abs() >= 10.0 { (10.0, "") } else { (2.0, "Shift+") };
                bench.press(&format!("{held}{}", keys[usize::from(off > 0.0)]));
                cross[axis] = (libm::round(cross[axis] / step) + off.signum()) * step;
            }
        }
        bench.press("Enter");
    };
    for act in acts {
        match act {
            Tool(name) => match TOOLS.iter().position(|tool| tool == name) {
                Some(index) => bench.press(&(index + 1).to_string()),
                // The choices of a slider go round.
                None => {
                    let choice = if GUIDED.contains(name) { &mut guided } else { &mut sliding };
                    while choice.0[choice.1] != *name {
                        bench.press(choice.2);
                        choice.1 = (choice.1 + 1) % choice.0.len();
                    }
                }
            },
            Drag(from, to) => {
                press(bench, from);
                press(bench, to);
            }
            Press(at) => press(bench, at),
        }
    }
}

/// The step of the differences, in seconds.
const STEP: f64 = 1e-4;

/// Holds places, velocities and accelerations of the scene against what was meant: lengths are saved with four digits.
fn holds(bench: &mut Bench, Kind { name, meant, .. }: &Kind) {
    // What quick keys have begun is done one after the other.
    for _ in 0..100 {
        bench.settle();
        if state(bench).starts_with("Complete") {
            break;
        }
    }
    assert!(state(bench).starts_with("Complete"), "{name}: {}\n{}", state(bench), bench.scene());
    let text = json!(bench.scene());
    let values = bench.ask("values", &[text]);
    let value = |asked: String| -> f64 {
        let row = values.as_array().and_then(|all| all.iter().find(|row| row["name"] == asked));
        let written = row.and_then(|row| row["value"].as_str()).unwrap_or_else(|| panic!("{name} has no {asked}"));
        written.parse().expect("a number")
    };
    let [before, now, after] = [-STEP, 0.0, STEP].map(meant);
    let rates: Vec<[Z; 2]> = (0..now.len())
        .map(|k| [(after[k] - before[k]) / (2.0 * STEP), (after[k] - now[k] * 2.0 + before[k]) / (STEP * STEP)])
        .collect();
    let largest = |order: usize| rates.iter().map(|rate| rate[order].norm()).fold(0.0, f64::max);
    let size = now.iter().map(|place| (place - now[0]).norm()).fold(0.0, f64::max);
    let found = places(bench);
    assert!(found.len() >= now.len(), "{name}: {found:?}");
    for (place, rate) in now.iter().zip(&rates) {
        let off = |(_, at): &&(String, Z)| (at - place).norm();
        let (point, at) = found.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("points");
        assert!((at - place).norm() < 2e-3 * size, "{name}: {point} at {at}, meant at {place}");
        for (order, letter) in ["v", "a"].iter().enumerate() {
            let is = z(value(format!("{letter}({point}).x")), value(format!("{letter}({point}).y")));
            let off = (is - rate[order]).norm() / largest(order).max(1e-9);
            assert!(off < 3e-3, "{name}: {letter}({point}) is {is}, meant {}, off by {off}", rate[order]);
        }
    }
}

#[test]
#[ignore = "needs Chromium"]
fn by_mouse_they_are_what_was_meant() {
    let mut bench = empty("built-mouse");
    let mut kinds = vec![klann(), scotch_yoke(), oldham(), boom()];
    assert!(four_bar().acts.len() < 12 && klann().acts.len() < 24, "with the press of New, empty");
    if Size::is_usual("four mechanisms built by mouse") {
        kinds.extend([four_bar(), slider_crank(), shaper(), trammel()]);
    }
    for kind in kinds {
        begin(&mut bench);
        by_mouse(&mut bench, &kind.acts);
        holds(&mut bench, &kind);
        bench.picture(&format!("built-{}", kind.name));
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn by_finger_they_are_what_was_meant() {
    let mut bench = empty("built-finger");
    let mut screens = vec![([390, 844], vec![four_bar()]), ([1280, 800], vec![slider_crank()])];
    if Size::is_usual("six mechanisms built by finger") {
        screens[1].1.extend([shaper(), klann(), trammel(), scotch_yoke(), oldham(), boom()]);
    }
    for (screen, kinds) in screens {
        bench.telephone(screen);
        for kind in kinds {
            begin(&mut bench);
            by_finger(&mut bench, &kind.acts);
            holds(&mut bench, &kind);
            bench.picture(&format!("built-by-finger-{}", kind.name));
        }
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn by_keys_they_are_what_was_meant() {
    let mut bench = empty("built-keys");
    let mut kinds = vec![trammel(), shaper()];
    if Size::is_usual("six mechanisms built by keys") {
        kinds.extend([four_bar(), slider_crank(), klann(), scotch_yoke(), oldham(), boom()]);
    }
    for kind in kinds {
        begin(&mut bench);
        by_keys(&mut bench, &kind.acts);
        holds(&mut bench, &kind);
    }
    assert_eq!(bench.value("document.querySelector('#play').ariaPressed"), "false", "no key is the page's");
    bench.assert_quiet();
}

/// Another empty stage, with the choices of a first one.
fn begin(bench: &mut Bench) {
    bench.value("kinegon.app.show('mechanism')");
    super::build::begin(bench);
    if bench.value("[...document.querySelectorAll('#build [data-value=block], #build [data-value=along]')].every((e) => e.ariaChecked === 'true')") != true {
        tool(bench, "slider");
        tool(bench, "block");
        tool(bench, "along");
        tool(bench, "link");
    }
    bench.value("document.querySelector('#build-stage').focus()");
}
