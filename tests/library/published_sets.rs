//! Printed answers of textbooks with one number wrong: what is told must concern that number, or nothing is told. Whatever else is
//! blamed is refuted by the other numbers, which are right.

use crate::examples::textbook_cases::cases;
use crate::support::files;
use crate::support::stages::{answer_key, solved};
use crate::support::survey::tried;
use kinegon::Solution;
use kinegon::check::{Checked, Given, Measured, Positive, Verdict, check};

/// Of 100 sets with a wrong number, so many may blame something else.
const BLAMED: usize = 2;

/// What becomes of a number.
const CHANGES: [Change; 6] = [
    Change::Times(2.0),
    Change::Times(0.7),
    Change::Times(1.1),
    Change::Times(1.3),
    Change::Times(0.5),
    Change::Transposed,
];

#[derive(Clone, Copy, Debug)]
enum Change {
    Times(f64),
    Transposed,
}

/// The answers of a case that can be checked together, none of them off.
struct Set {
    id: &'static str,
    solution: Solution,
    given: Vec<Given>,
}

/// Mistakes that are looked for together, as the program does.
const DEPTH: usize = 5;

fn checked(solution: &Solution, given: &[Given]) -> Option<Checked> {
    let values = given.to_vec();
    let scales = solution.scales();
    let measured = Measured {
        mu: [scales.length, scales.velocity, scales.acceleration],
        positive: Some(Positive::CounterClockwise),
        values,
        ..Measured::default()
    };
    check(&measured, &answer_key(solution, DEPTH)).ok()
}

fn sets() -> Vec<Set> {
    let cases = cases().expect("the cases are solved").into_iter();
    let sets = cases.map(|case| {
        let scene = files::read(&format!("tests/worked/{}/scene.json", case.id));
        let solution = solved(&scene).expect("a good scene");
        let rows = case.rows.iter().map(|row| Given {
            name: row.quantity.clone(),
            text: row.printed.clone(),
            unit: (!row.unit.is_empty()).then(|| row.unit.clone()),
            place: String::new(),
        });
        // Sizes without a sense, components and the like are asked for by no form.
        let is_plain = |given: &Given| {
            let alone = checked(&solution, core::slice::from_ref(given));
            alone.is_some_and(|checked| [Verdict::Right, Verdict::WithinTolerance].contains(&checked.values[0].verdict))
        };
        let given = rows.filter(is_plain).collect();
        Set { id: case.id, solution, given }
    });
    sets.filter(|set| set.given.len() >= 3).collect()
}

/// The number as it is printed wrong, with as many decimals; none where that is the same.
fn wrong(text: &str, change: Change) -> Option<String> {
    let changed = match change {
        Change::Times(factor) => {
            let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            let number: f64 = text.parse().ok()?;
            let sign = if text.starts_with('+') { "+" } else { "" };
            format!("{sign}{:.decimals$}", number * factor)
        }
        Change::Transposed => {
            let mut written: Vec<char> = text.chars().collect();
            let digits: Vec<usize> = (0..written.len()).filter(|&k| written[k].is_ascii_digit()).collect();
            let pair =
                digits.windows(2).find(|pair| written[pair[0]] != written[pair[1]] && written[pair[0]] != '0')?;
            written.swap(pair[0], pair[1]);
            written.into_iter().collect()
        }
    };
    (changed != text).then_some(changed)
}

/// What is told besides what concerns a number, and how sure.
fn blamed(checked: &Checked, index: usize) -> Option<String> {
    let best = &checked.diagnosis.best;
    let other = best.findings.iter().find(|finding| {
        let touched = if finding.written.is_empty() { &finding.follows } else { &finding.written };
        !finding.written.contains(&index) && touched.first() != Some(&index)
    })?;
    Some(format!("{:.0} %: {} {:?}", 100.0 * best.probability, other.candidate.mistake.id(), other.candidate.blanks))
}

#[test]
fn a_wrong_number_is_off_and_nothing_else_is_blamed() {
    let mut tries = 0;
    let mut unseen = Vec::new();
    let mut falsely = Vec::new();
    for set in sets() {
        for index in (0..set.given.len()).step_by(tried(3, 1)) {
            for change in CHANGES.into_iter().step_by(tried(2, 1)) {
                let Some(text) = wrong(&set.given[index].text, change) else {
                    continue;
                };
                let mut given = set.given.clone();
                given[index].text = text.clone();
                let right =
                    checked(&set.solution, core::slice::from_ref(&set.given[index])).expect("it was read before");
                let Some(checked) = checked(&set.solution, &given) else {
                    continue;
                };
                let name = set.given[index].name.replace(' ', "");
                let place = checked.values.iter().position(|value| value.entry.asked.name().replace(' ', "") == name);
                let place = place.expect("it is judged");
                let judged = &checked.values[place];
                // What a pencil may be off by at the scales of the figure is no wrong number.
                if judged.difference.abs() <= 3.0 * right.values[0].tolerance.unwrap_or_default() {
                    continue;
                }
                tries += 1;
                let what = format!("{} {name}: {text} for {}", set.id, set.given[index].text);
                if judged.verdict != Verdict::Off {
                    unseen.push(what.clone());
                }
                falsely.extend(blamed(&checked, place).map(|blamed| format!("{what}: {blamed}")));
            }
        }
    }
    println!("{} of {tries} blame something else\n{}", falsely.len(), falsely.join("\n"));
    assert!(tries >= tried(40, 300), "only {tries} sets");
    assert!(unseen.is_empty(), "not off:\n{}", unseen.join("\n"));
    assert!(100 * falsely.len() <= BLAMED * tries, "{} of {tries} blame something else", falsely.len());
}
