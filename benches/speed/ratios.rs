//! Kinegon's times over those of loops written for one mechanism each, both taken in turns in one run: other times
//! depend on the machine and on what else it does.

use crate::by_hand::ByHand;
use crate::by_hand_together::{EIGHT, FourBar, Paper, four_bar, paper, paper_rates};
use crate::{Repeats, path, solved, walk};
use divan::black_box;
use fearless_simd::Level;
use kinegon::cycle::{Mover, Path};
use kinegon::geometry::MANY;
use kinegon::quantity::State;
use std::time::Instant;

/// How often each is timed; the least time counts.
const REPEATS: usize = 200;

/// Positions in a batch.
const BATCH: usize = 32_000;

/// Places that a loop fills over and over: as many positions as stand in one of Kinegon's blocks.
const PLACES: usize = MANY / EIGHT;

/// Prints all ratios.
pub fn print(repeats: Repeats) {
    println!("\nTimes per position over those by hand, of angles and slides with their rates:");
    let repeats = repeats.of(REPEATS);
    paper_together(repeats);
    four_bar_together(repeats);
    paper_one_after_another(repeats);
}

fn paper_together(repeats: usize) {
    let solution = solved(crate::FIGURE_2);
    let path = path(&solution.mechanism, &solution.pose, [-135.0, 135.0]);
    let values = values(-135.0, 135.0);
    let registers = Level::new();
    let mut start = ByHand::new();
    // In steps that Newton's method can take.
    for i in 0..=2050 {
        start.go_to(70.0 - 0.1 * f64::from(i));
    }
    let mut places = vec![Paper::ZERO; 100];
    paper(registers, &start, &values[..100 * EIGHT], &mut places);
    for (place, values) in places.iter().zip(values.chunks(EIGHT)) {
        for (index, link) in ["2", "4", "5"].into_iter().enumerate() {
            compare(&path, link, values[0], [place.rates[index][0], place.seconds[index][0]]);
        }
    }
    let mut walker = path.many_walker_without_places();
    let mut places = [Paper::ZERO; PLACES];
    let kinegon = || walk::<2>(&mut walker, black_box(&values));
    let by_hand = || {
        paper(registers, &start, black_box(&values), &mut places);
        black_box(&places);
    };
    ratio(repeats, "the paper's mechanism", BATCH, kinegon, by_hand);
    let kinegon = || walk::<1>(&mut walker, black_box(&values));
    let by_hand = || {
        for _ in 0..BATCH / MANY {
            paper_rates(registers, &start, black_box(&mut places));
        }
    };
    ratio(repeats, "its velocities and accelerations alone", BATCH, kinegon, by_hand);
}

fn four_bar_together(repeats: usize) {
    let solution = solved(include_str!("../../templates/four-bar.json"));
    let path = path(&solution.mechanism, &solution.pose, [0.0, 360.0]);
    let values = values(0.0, 360.0);
    let registers = Level::new();
    let mut places = vec![FourBar::ZERO; BATCH / EIGHT];
    four_bar(registers, &values, &mut places);
    for (place, values) in places.iter().zip(values.chunks(EIGHT)).step_by(100) {
        for (index, link) in ["2", "3"].into_iter().enumerate() {
            compare(&path, link, values[0], [place.rates[index][0], place.seconds[index][0]]);
        }
    }
    let mut walker = path.many_walker_without_places();
    let mut places = [FourBar::ZERO; PLACES];
    let kinegon = || walk::<2>(&mut walker, black_box(&values));
    let by_hand = || {
        four_bar(registers, black_box(&values), &mut places);
        black_box(&places);
    };
    ratio(repeats, "the four-bar", BATCH, kinegon, by_hand);
}

fn paper_one_after_another(repeats: usize) {
    let solution = solved(crate::FIGURE_2);
    let mut mover = Mover::new(&solution.mechanism, &solution.pose).expect("it is not singular");
    let mut by_hand = ByHand::new();
    for i in 0..2050 {
        by_hand.go_to(70.0 - 0.1 * f64::from(i));
        mover.move_to(&[by_hand.degrees]).expect("it goes there");
    }
    let there_and_back = (0..1000).chain((0..1000).rev());
    let values: Vec<[f64; 1]> = there_and_back.map(|i| [-135.0 + 0.27 * f64::from(i)]).collect();
    let kinegon = || {
        for value in black_box(&values) {
            black_box(mover.move_to(value));
        }
    };
    let by_hand = || {
        for value in black_box(&values) {
            by_hand.go_to(value[0]);
            black_box(&by_hand);
        }
    };
    ratio(repeats, "the paper's, one position after another", values.len(), kinegon, by_hand);
}

fn values(from: f64, to: f64) -> Vec<f64> {
    (0..BATCH).map(|i| from + (to - from) * i as f64 / BATCH as f64).collect()
}

/// Panics unless angular velocity and acceleration by hand are Kinegon's but for rounding.
fn compare(path: &Path, link: &str, value: f64, by_hand: [f64; 2]) {
    let body = path.mechanism.link(link).expect("it has this link");
    let mut walker = path.walker();
    let rates = walker.position(value).expect("it can be reached").angular_rates(body);
    for (ours, theirs) in rates.into_iter().zip(by_hand) {
        assert!((ours - theirs).abs() <= 1e-9 * (1.0 + ours.abs()), "link {link} at {value}: {ours} {theirs}");
    }
}

/// Prints the least times of both per position, and their ratio.
fn ratio(repeats: usize, what: &str, count: usize, mut kinegon: impl FnMut(), mut by_hand: impl FnMut()) {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..repeats {
        let start = Instant::now();
        kinegon();
        let between = Instant::now();
        by_hand();
        let times = [between - start, between.elapsed()];
        for (least, time) in least.iter_mut().zip(times) {
            *least = least.min(time.as_secs_f64() * 1e9 / count as f64);
        }
    }
    let [ours, theirs] = least;
    println!("{what}: {ours:.2} ns, by hand {theirs:.2} ns, {:.2} times", ours / theirs);
}
