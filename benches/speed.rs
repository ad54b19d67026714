//! Times of the stages: `cargo bench`. Times differ between machines; quote ratios of one run.

use divan::{Bencher, black_box};
use kinegon::mechanism::{LoopEquations, Mechanism, mechanism};
use kinegon::motion::{Motion, Order, motion, rates};
use kinegon::plan::construction;
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use kinegon::{drawing, format};

const FIGURE_1: &str = include_str!("../examples/figure-1.json");
const FIGURE_2: &str = include_str!("../examples/figure-2.json");

fn main() {
    divan::main();
}

fn text(which: &str) -> &'static str {
    if which == "figure-1" {
        FIGURE_1
    } else {
        FIGURE_2
    }
}

fn solved(text: &str) -> (Scene, Mechanism, Pose, Motion) {
    let scene = Scene::read(text).expect("a good scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    let motion = motion(&mechanism, &pose, Order::Acceleration).expect("it is not singular");
    (scene, mechanism, pose, motion)
}

/// Velocities and accelerations of the group: Figure 1 has revolute joints only, Figure 2 a prismatic one.
#[divan::bench(args = ["figure-1", "figure-2"])]
fn solve(bencher: Bencher, which: &str) {
    let (_, mechanism, pose, motion) = solved(text(which));
    let equations = LoopEquations::new(&mechanism, &mechanism.groups[0]);
    bencher.bench(|| rates(black_box(&equations), black_box(&pose), &motion.bodies));
}

/// All modes from lengths, and the choice among them.
#[divan::bench]
fn position(bencher: Bencher) {
    let (scene, mechanism, ..) = solved(FIGURE_2);
    bencher.bench(|| pose(black_box(&mechanism), &scene.near).expect("it can be assembled"));
}

/// Motion with all error bounds.
#[divan::bench]
fn motion_with_bounds(bencher: Bencher) {
    let (_, mechanism, pose, _) = solved(FIGURE_2);
    bencher.bench(|| motion(&mechanism, black_box(&pose), Order::Acceleration));
}

#[divan::bench]
fn plans(bencher: Bencher) {
    let (_, mechanism, pose, motion) = solved(FIGURE_2);
    bencher.bench(|| construction(&mechanism, black_box(&pose), &motion));
}

#[divan::bench]
fn read_scene(bencher: Bencher) {
    bencher.bench(|| Scene::read(black_box(FIGURE_2)).expect("a good scene"));
}

/// Layout, labels and all marks.
#[divan::bench]
fn draw_figure(bencher: Bencher) {
    let (scene, mechanism, pose, motion) = solved(FIGURE_2);
    let plans = construction(&mechanism, &pose, &motion);
    bencher.bench(|| drawing::figure(black_box(&scene), &mechanism, &pose, &plans));
}

/// The whole way from a scene's text to SVG.
#[divan::bench(args = ["figure-1", "figure-2"])]
fn scene_to_svg(bencher: Bencher, which: &str) {
    let text = text(which);
    bencher.bench(|| {
        let (scene, mechanism, pose, motion) = solved(black_box(text));
        let plans = construction(&mechanism, &pose, &motion);
        format::svg(&drawing::figure(&scene, &mechanism, &pose, &plans))
    });
}

/// A drawing to PNG at 100 dots per inch, 1169 by 827 pixels.
#[cfg(feature = "png")]
#[divan::bench]
fn drawing_to_png(bencher: Bencher) {
    let (scene, mechanism, pose, motion) = solved(FIGURE_2);
    let plans = construction(&mechanism, &pose, &motion);
    let drawing = drawing::figure(&scene, &mechanism, &pose, &plans);
    bencher.bench(|| format::png(black_box(&drawing), 100.0));
}
