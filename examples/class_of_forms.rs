//! The forms of a large class, to measure how long `kinegon check` takes for them: so many drawings of one scene by a hand that errs by ±0.25 mm
//! and ±0.25°, a third of them with one mistake put in. Run with
//! `cargo run --release --example class_of_forms -- examples/figure-2.json 1000 FOLDER`.

use kinegon::check::{AnswerKey, Candidate, LENIENCY, Measured, Mistake, Student};
use kinegon::construction::Tolerance;
use kinegon::geometry::Random;
use kinegon::{Scene, solve};
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

/// Limits of the hand's errors, in mm and degrees.
const HAND: [f64; 2] = [0.25, 0.25];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, count, folder] = arguments.as_slice() else {
        return Err("give a scene's file, the number of forms, and the folder for them".into());
    };
    let solution = solve(&Scene::read(&std::fs::read_to_string(scene)?)?)?;
    let key = AnswerKey {
        solution: &solution,
        scales: solution.scales(),
        tolerance: Tolerance::default(),
        leniency: LENIENCY,
        depth: 1,
    };
    let student = Student::new(&key)?;
    let ways: Vec<Candidate> = Mistake::all().flat_map(|mistake| student.ways(mistake)).collect();
    std::fs::create_dir_all(folder)?;
    let mut random = Random(37);
    for number in 0..count.parse::<usize>()? {
        let mistakes = if number % 3 == 2 && !ways.is_empty() { vec![&ways[random.below(ways.len())]] } else { vec![] };
        let measured = student.draw(&mistakes, HAND, &mut || random.within(), &[]);
        std::fs::write(Path::new(folder).join(format!("student-{number:04}.csv")), table(&measured, number)?)?;
    }
    Ok(())
}

/// The form as students hand it in.
fn table(measured: &Measured, number: usize) -> Result<String, std::fmt::Error> {
    let mut text = format!("quantity,value,unit\nname,Student {number},\n");
    for (sheet, mu) in measured.mu.given() {
        writeln!(text, "{},{mu},", sheet.facts().scale_key)?;
    }
    for given in &measured.values {
        writeln!(text, "\"{}\",{},", given.name, given.text)?;
    }
    Ok(text)
}
