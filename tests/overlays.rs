//! A student's drawing over the right figure: nothing covers a name, crosses and lines are where the student has them, and the words tell what went wrong.

mod faults;
mod files;
mod stages;

use faults::{faults, id};
use kinegon::check::{self, Checked, Drawn, Measured, Mistake, Student};
use kinegon::drafting::Tolerance;
use kinegon::drawing::{Drawing, Mark, Overlay, Pen, Point, Shape, overlay, scales};
use kinegon::scene::PageSize;
use kinegon::words::Wording;
use stages::Stages;

fn stages(scene: &str) -> Stages {
    Stages::of(&files::read(scene)).expect("a good scene")
}

fn of(stages: &Stages) -> Drawn<'_> {
    let Stages {
        scene,
        mechanism,
        pose,
        motion,
        construction,
    } = stages;
    Drawn {
        units: scene.units,
        near: &scene.near,
        mechanism,
        pose,
        motion,
        construction,
        scales: scales(scene, mechanism, pose, construction),
        tolerance: Tolerance::default(),
        depth: 3,
    }
}

/// The sheets of a student's values, and what they are drawn from.
fn drawn(stages: &mut Stages, measured: &Measured) -> (Vec<Drawing>, Overlay, Checked) {
    let words = Wording::of(&stages.scene.figure);
    let (own, checked) = {
        let right = of(stages);
        let checked = check::check(measured, &right).expect("values that are understood");
        let own = check::redrawn(measured, &right, &checked, &words);
        (own.expect("scales are there"), checked)
    };
    let figure = &mut stages.scene.figure;
    let [mu_l, mu_v, mu_a] = measured.mu;
    figure.mu_l = mu_l.or(figure.mu_l);
    figure.mu_v = mu_v.or(figure.mu_v);
    figure.mu_a = mu_a.or(figure.mu_a);
    let sheets = overlay(
        &stages.scene,
        &stages.mechanism,
        &stages.pose,
        &stages.construction,
        &own,
    );
    (sheets, own, checked)
}

/// The values of somebody who makes one mistake in one of its ways and is exact elsewhere but for what a ruler shows.
fn with_mistake(stages: &Stages, mistake: Mistake, way: usize) -> Measured {
    let right = of(stages);
    let student = Student::new(&right).expect("all sheets");
    let ways = student.ways(mistake);
    student.draw(&[&ways[way]], [0.05, 0.05], &mut || 0.3, &[])
}

/// All that is looked at for names on names.
fn cases() -> Vec<(String, Vec<Drawing>, Overlay, Checked)> {
    let mut cases = Vec::new();
    let mut add = |name: &str, mut stages: Stages, measured: &Measured| {
        let (sheets, own, checked) = drawn(&mut stages, measured);
        cases.push((name.to_owned(), sheets, own, checked));
    };
    let mut paper = Measured::read_json(&files::read("examples/paper-as-student.json"));
    if let Ok(paper) = &mut paper {
        add("the paper", stages("examples/figure-2.json"), paper);
        paper.mu = [Some(5.0), Some(2.5), Some(2.5)];
        add("the paper smaller", stages("examples/figure-2.json"), paper);
    }
    for (scene, mistake, way) in [
        ("four-bar", Mistake::TurnedRay, 0),
        ("four-bar", Mistake::TurnedRay, 1),
        ("four-bar", Mistake::TurnedRay, 2),
        ("four-bar", Mistake::OtherMode, 0),
        ("four-bar", Mistake::NormalOutward, 0),
        ("four-bar", Mistake::WrongSense, 0),
        ("slider-crank", Mistake::ReversedVector, 0),
        ("whitworth", Mistake::CoriolisForgotten, 0),
        ("third-class", Mistake::RayFromWrongPoint, 0),
        ("third-class", Mistake::WrongLines, 0),
        ("third-class", Mistake::OtherMode, 0),
        ("fourth-class", Mistake::WrongSegment, 0),
        ("stephenson-3", Mistake::TurnedRay, 3),
    ] {
        let own = stages(&format!("templates/{scene}.json"));
        let measured = with_mistake(&own, mistake, way);
        add(&format!("{scene} {} {way}", mistake.id()), own, &measured);
    }
    cases
}

#[test]
fn zz() {
    for (name, sheets, own, _) in cases() {
        println!("== {name}: {:?}", own.words);
        for (i, sheet) in sheets.iter().enumerate() {
            let png = kinegon::format::png(sheet, 100.0).unwrap();
            std::fs::write(format!("/tmp/h1out/{}-{i}.png", name.replace(' ', "_")), png).unwrap();
            println!("{i}: {:?}", faults(sheet));
        }
    }
}
