//! Times of the stages: `cargo bench -p kinegon-benches`. Times differ between machines; quote ratios of one run, as they stand at the end.

mod by_hand;
mod by_hand_together;
mod ratios;
mod reactions;

use by_hand::ByHand;
use divan::{Bencher, black_box};
use kinegon::check::{AnswerKey, LENIENCY, Measured, check};
use kinegon::construction::{Extent, Tolerance, construct};
use kinegon::cycle::{Drive, Mover, Path, Steps, Sweep, Walker};
use kinegon::geometry::{MANY, Many};
use kinegon::mechanism::Mechanism;
use kinegon::motion::motion;
use kinegon::position::{Pose, pose};
use kinegon::quantity::{QuantityRequest, pencil, read_by_hand, readable_names};
use kinegon::scene::Scene;
use kinegon::{Order, PerSheet};
use kinegon::{Solution, solve};

/// How often each of two sides of a ratio is timed.
#[derive(Clone, Copy)]
enum Repeats {
    Once,
    Measured,
}

impl Repeats {
    /// That many times, where something is measured.
    fn of(self, measured: usize) -> usize {
        match self {
            Repeats::Once => 1,
            Repeats::Measured => measured,
        }
    }
}

const FIGURE_1: &str = include_str!("../../examples/figure-1.json");
const FIGURE_2: &str = include_str!("../../examples/figure-2.json");

fn main() {
    divan::main();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    // Some benches, which have been named, need no ratios; as a test, which `cargo test -p kinegon-benches --bench speed` asks for, each runs once.
    let repeats = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--bench"] => Repeats::Measured,
        [] => Repeats::Once,
        _ => return,
    };
    ratios::print(repeats);
    reactions::print(repeats);
}

fn text(which: &str) -> &'static str {
    match which {
        "figure-1" => FIGURE_1,
        "excavator" => include_str!("../../tests/lecture/excavator.json"),
        _ => FIGURE_2,
    }
}

fn solved(text: &str) -> Solution {
    solve(&Scene::read(text).expect("a good scene")).expect("it can be solved")
}

/// Mechanisms of which many positions are computed: scene, and a range of the crank.
const MOVED: [(&str, &str, [f64; 2]); 3] = [
    ("four-bar", include_str!("../../templates/four-bar.json"), [0.0, 360.0]),
    ("six-bar", include_str!("../../templates/watt-1.json"), [0.0, 360.0]),
    ("paper", FIGURE_2, [-135.0, 135.0]),
];

fn moved(which: &str) -> (&'static str, [f64; 2]) {
    let mut all = MOVED.into_iter();
    let (_, text, range) = all.find(|m| m.0 == which).expect("a known one");
    (text, range)
}

/// What is computed at each of them.
const WHAT: [&str; 3] = ["position", "rates", "both"];

fn path<'a>(mechanism: &'a Mechanism, pose: &Pose, [from, to]: [f64; 2]) -> Path<'a> {
    let drive = Drive::new(mechanism, None).expect("it has a drive");
    let mut path = Path::new(mechanism, pose, drive).expect("it is not singular");
    path.cover(Some(from), Some(to)).expect("it can be reached");
    path
}

/// A thousand positions one by one, in the order of the crank: position alone, velocities and accelerations alone, both.
#[divan::bench(args = MOVED.map(|m| m.0), consts = [0, 1, 2])]
fn thousand<const WHICH: usize>(bencher: Bencher, which: &str) {
    let (text, range) = moved(which);
    let Solution { mechanism, pose, .. } = solved(text);
    let path = path(&mechanism, &pose, range);
    let values: Vec<[f64; 1]> = (0..1000).map(|i| [range[0] + (range[1] - range[0]) * f64::from(i) / 1000.0]).collect();
    let mut walker = path.walker();
    bencher.bench_local(|| {
        for value in black_box(&values) {
            match WHAT[WHICH] {
                "position" => _ = black_box(walker.positions(value)),
                "rates" => _ = black_box(walker.rates()),
                _ => _ = black_box(walker.motions(value)),
            }
        }
    });
}

/// Two thousand positions of the paper's mechanism with rates of all links, each from the one before: along a path that has been
/// followed, wherever the drive goes, and by a program for this mechanism alone. Kinegon's have all joints, too.
#[divan::bench(args = ["path", "mover", "by-hand"])]
fn one_after_another(bencher: Bencher, who: &str) {
    let Solution { mechanism, pose, .. } = solved(FIGURE_2);
    let path = path(&mechanism, &pose, [-135.0, 135.0]);
    let there_and_back = (0..1000).chain((0..1000).rev());
    let values: Vec<[f64; 1]> = there_and_back.map(|i| [-135.0 + 0.27 * f64::from(i)]).collect();
    let mut walker = path.walker();
    let mut mover = Mover::new(&mechanism, &pose).expect("it is not singular");
    let mut by_hand = ByHand::new();
    by_hand.check();
    for i in 0..2050 {
        by_hand.go_to(70.0 - 0.1 * f64::from(i));
        mover.move_to(&[by_hand.degrees]).expect("it goes there");
    }
    bencher.bench_local(|| {
        for value in black_box(&values) {
            match who {
                "path" => _ = black_box(walker.motions(value)),
                "mover" => _ = black_box(mover.move_to(value)),
                _ => {
                    by_hand.go_to(value[0]);
                    _ = black_box(&by_hand);
                }
            }
        }
    });
}

/// 32 000 positions in the registers of one core, in memory that stays in its cache: angles and slides of all links, their rates, both.
#[divan::bench(args = MOVED.map(|m| m.0), consts = [0, 1, 2])]
fn batch_of_links<const WHICH: usize>(bencher: Bencher, which: &str) {
    batch::<WHICH>(bencher, which, false);
}

/// The same with places, velocities and accelerations of all joints.
#[divan::bench(args = MOVED.map(|m| m.0), consts = [0, 1, 2])]
fn batch_with_joints<const WHICH: usize>(bencher: Bencher, which: &str) {
    batch::<WHICH>(bencher, which, true);
}

fn batch<const WHICH: usize>(bencher: Bencher, which: &str, joints: bool) {
    let (text, range) = moved(which);
    let Solution { mechanism, pose, .. } = solved(text);
    let path = path(&mechanism, &pose, range);
    let values: Vec<f64> = (0..32_000).map(|i| range[0] + (range[1] - range[0]) * f64::from(i) / 32_000.0).collect();
    let mut walker = if joints { path.many_walker() } else { path.many_walker_without_places() };
    bencher.bench_local(|| walk::<WHICH>(&mut walker, black_box(&values)));
}

fn walk<const WHICH: usize>(walker: &mut Walker<Many>, values: &[f64]) {
    let mut rest = values;
    while !rest.is_empty() {
        let count = match WHAT[WHICH] {
            "position" => walker.positions(rest).0,
            "rates" => {
                black_box(walker.rates());
                MANY
            }
            _ => walker.motions(rest).0,
        };
        rest = &rest[count.min(rest.len())..];
    }
}

/// 1 280 000 positions of the paper's mechanism with the rates of its links, in 64 pieces, on one core and on all.
#[divan::bench(args = [false, true])]
fn batch_on_all_cores(bencher: Bencher, all: bool) {
    use rayon::prelude::*;
    let Solution { mechanism, pose, .. } = solved(FIGURE_2);
    let path = path(&mechanism, &pose, [-135.0, 135.0]);
    let count = 1_280_000;
    let value = |i: i32| -135.0 + 270.0 * f64::from(i) / f64::from(count);
    let values: Vec<f64> = (0..count).map(value).collect();
    let mut walker = path.many_walker_without_places();
    bencher.bench_local(|| {
        let pieces = black_box(&values).par_chunks(20_000);
        if all {
            let walker = || path.many_walker_without_places();
            pieces.for_each_init(walker, |walker, piece| walk::<2>(walker, piece));
        } else {
            walk::<2>(&mut walker, &values);
        }
    });
}

/// A sweep of 100 000 positions of the paper's mechanism, four numbers each.
#[divan::bench]
fn sweep_100_000(bencher: Bencher) {
    sweep(bencher, |sweep| sweep.rows(0..sweep.steps.count()));
}

#[divan::bench]
fn sweep_100_000_on_all_cores(bencher: Bencher) {
    sweep(bencher, |sweep| sweep.rows_on_all_cores(0..sweep.steps.count()));
}

fn sweep(bencher: Bencher, rows: impl Fn(&Sweep) -> kinegon::cycle::Numbers) {
    let Solution { mechanism, pose, .. } = solved(FIGURE_2);
    let path = path(&mechanism, &pose, [-135.0, 135.0]);
    let steps = Steps::new(-135.0, 135.0, 0.0027).expect("a range");
    let names = ["omega(4)", "alpha(4)", "v_r(3/2)", "a_r(3/2)"].map(String::from);
    let sweep = Sweep::new(&path, steps, Some(&names)).expect("known quantities");
    bencher.bench_local(|| rows(&sweep));
}

/// All modes from lengths, and the choice among them.
#[divan::bench]
fn position(bencher: Bencher) {
    let Solution { scene, mechanism, .. } = solved(FIGURE_2);
    bencher.bench(|| pose(black_box(&mechanism), &scene.near).expect("it can be assembled"));
}

/// Motion with all error bounds.
#[divan::bench]
fn motion_with_bounds(bencher: Bencher) {
    let Solution { mechanism, pose, .. } = solved(FIGURE_2);
    bencher.bench(|| motion(&mechanism, black_box(&pose), Order::Acceleration));
}

#[divan::bench]
fn plans(bencher: Bencher) {
    let Solution { mechanism, pose, motion, .. } = solved(FIGURE_2);
    bencher.bench(|| construct(&mechanism, black_box(&pose), &motion, Extent::Points));
}

/// The whole construction once more, operation by operation.
#[divan::bench]
fn replay_by_hand(bencher: Bencher) {
    let solution = solved(FIGURE_2);
    let (drawn, _) = read_by_hand(&solution, &[]);
    let given = solution.scales();
    let scales = PerSheet::from_fn(|sheet| given[sheet].unwrap_or(1.0));
    let mut values = drawn.run(scales, &[]);
    bencher.bench_local(|| black_box(&mut values).carry_out(&drawn.operations, 0, scales, &[]));
}

/// The bands of all quantities of a result.
#[divan::bench]
fn bands_of_hand_drawings(bencher: Bencher) {
    let solution = solved(FIGURE_2);
    let scales = solution.scales();
    let names = readable_names(&solution);
    let asked = names.iter().map(|n| QuantityRequest::new(n, &solution.mechanism).expect("a name"));
    let asked: Vec<QuantityRequest> = asked.collect();
    let usual = Tolerance::default();
    bencher.bench(|| {
        let asked = black_box(&asked).clone();
        pencil(&solution, &scales, usual, asked)
    });
}

#[divan::bench]
fn read_scene(bencher: Bencher) {
    bencher.bench(|| Scene::read(black_box(FIGURE_2)).expect("a good scene"));
}

/// Layout, labels and all marks, of a figure and of the most crowded one of the lecture.
#[divan::bench(args = ["figure-2", "excavator"])]
fn draw_figure(bencher: Bencher, which: &str) {
    let solution = solved(text(which));
    bencher.bench(|| black_box(&solution).figure());
}

/// The whole way from a scene's text to SVG.
#[divan::bench(args = ["figure-1", "figure-2"])]
fn scene_to_svg(bencher: Bencher, which: &str) {
    let text = text(which);
    bencher.bench(|| solved(black_box(text)).figure().svg());
}

/// A drawing to PDF.
#[divan::bench]
fn drawing_to_pdf(bencher: Bencher) {
    let solution = solved(FIGURE_2);
    let drawing = solution.figure();
    bencher.bench(|| black_box(&drawing).pdf());
}

#[divan::bench]
fn drawing_to_tikz(bencher: Bencher) {
    let solution = solved(FIGURE_2);
    let drawing = solution.figure();
    bencher.bench(|| black_box(&drawing).tikz());
}

/// A drawing to PNG at so many dots per inch; 100 give 1169 by 827 pixels.
#[divan::bench(args = [100.0, 150.0])]
fn drawing_to_png(bencher: Bencher, dpi: f64) {
    let solution = solved(FIGURE_2);
    let drawing = solution.figure();
    bencher.bench(|| black_box(&drawing).png(dpi));
}

/// The sheets of all 41 steps as SVG.
#[divan::bench]
fn step_sheets_to_svg(bencher: Bencher) {
    let solution = solved(FIGURE_2);
    bencher.bench(|| {
        let all = black_box(&solution).stepwise_figure();
        let sheets = (1..=all.steps.len()).map(|step| all.after_step(step).svg());
        sheets.map(|sheet| sheet.len()).sum::<usize>()
    });
}

/// The numbers that the paper prints, checked with the whole catalogue, so many mistakes at once looked for.
#[divan::bench(args = [1, 2, 5])]
fn check_a_drawing(bencher: Bencher, depth: usize) {
    let solution = solved(FIGURE_2);
    let values = include_str!("../../examples/paper-as-student.json");
    let measured = Measured::read_json(values).expect("a good form");
    let key = AnswerKey {
        solution: &solution,
        scales: solution.scales(),
        tolerance: Tolerance::default(),
        leniency: LENIENCY,
        depth,
    };
    bencher.bench(|| check(black_box(&measured), &key));
}
