//! Mistakes put into drawings on purpose, and what the check says of them: the tables of docs/mistakes.md.
//! Run with `cargo run --release --example mistakes -- 500 > docs/mistakes.md`; the number counts the drawings of each mistake. A mistake's name, `clean` or
//! `pairs` behind it asks for these drawings alone.
//!
//! Every drawing is of a random scene: a starting scene with other lengths, places and rates. The student reads every quantity of the form,
//! lengths to 0.1 mm of paper, rates to four digits. A mistake that moves no value beyond its tolerance is none that anybody
//! could find, and one that throws a point off a sheet of 594 mm is seen at once; both are drawn again elsewhere.

use kinegon::Solution;
use kinegon::check::{AnswerKey, Candidate, Explanation, Given, LENIENCY, Measured, Mistake, Student, Verdict, check};
use kinegon::construction::Tolerance;
use kinegon::exercise::{Number, each_number};
use kinegon::geometry::Random;
use kinegon::scene::Scene;
use serde_json::Value;
use std::collections::BTreeMap;

/// The starting scenes whose plans are drawn.
const SCENES: [&str; 14] = [
    include_str!("../templates/four-bar.json"),
    include_str!("../templates/slider-crank.json"),
    include_str!("../templates/slotted-lever.json"),
    include_str!("../templates/whitworth.json"),
    include_str!("../templates/toggle-press.json"),
    include_str!("../templates/watt-1.json"),
    include_str!("../templates/stephenson-3.json"),
    include_str!("../templates/five-bar.json"),
    include_str!("../templates/third-class.json"),
    include_str!("../templates/fourth-class.json"),
    include_str!("../templates/dyad-rrr.json"),
    include_str!("../templates/dyad-rrp.json"),
    include_str!("figure-1.json"),
    include_str!("figure-2.json"),
];

/// A random scene that can be drawn.
pub fn random_scene(random: &mut Random) -> Solution {
    loop {
        let text = SCENES[random.below(SCENES.len())];
        let mut scene: Value = serde_json::from_str(text).unwrap_or_default();
        vary(&mut scene, random);
        if let Some(solution) = drawable(&scene.to_string()) {
            return solution;
        }
    }
}

/// The scene solved, where its plans have a construction without rays that hardly cross: those are no exercise.
fn drawable(text: &str) -> Option<Solution> {
    let solution = kinegon::solve(&Scene::read(text).ok()?).ok()?;
    let construction = &solution.construction;
    let is_drawn = construction.agreement.iter().all(Option::is_some);
    let sines = construction.steps.iter().flat_map(|(_, actions)| actions).filter_map(|action| match action {
        kinegon::construction::Action::Cross { sine, .. } => Some(sine.abs()),
        _ => None,
    });
    let is_good = sines.fold(1.0, f64::min) > 0.3;
    (is_drawn && is_good).then_some(solution)
}

/// What values are checked against; so many mistakes at once are looked for.
pub fn answer_key(solution: &Solution, depth: usize) -> AnswerKey<'_> {
    AnswerKey { solution, scales: solution.scales(), tolerance: Tolerance::default(), leniency: LENIENCY, depth }
}

/// Varies lengths, places and motions by up to an eighth, drives by up to 20°.
fn vary(scene: &mut Value, random: &mut Random) {
    each_number(scene, &mut |number, x| match number {
        Number::Length | Number::Motion | Number::Direction | Number::Turning => x * (1.0 + 0.125 * random.within()),
        Number::DriveAngle => x + 20.0 * random.within(),
        Number::DrivePosition | Number::DriveRate | Number::Load => x,
    });
    if let Some(object) = scene.as_object_mut() {
        object.shift_remove("figure");
        object.shift_remove("want");
    }
}

/// A drawing with a mistake, and which one it is.
struct Planted {
    measured: Measured,
    blanks: Vec<String>,
}

/// Draws with one mistake of a kind; none where the scene has no place for it.
fn plant(student: &Student<'_>, mistake: Mistake, hand: [f64; 2], random: &mut Random) -> Option<Planted> {
    let noise_seed = random.next();
    let draw = |mistakes: &[&Candidate], goes_on: &[(usize, f64)]| {
        let mut noise = Random(noise_seed);
        student.draw(mistakes, hand, &mut || noise.within(), goes_on)
    };
    if let Some(slip) = slip(mistake) {
        let right = draw(&[], &[]);
        let index = random.below(right.values.len());
        let other = random.below(right.values.len());
        let changed = slip(student, &right, [index, other], random)?;
        let mut goes_on = Vec::new();
        for (index, given) in &changed {
            let (place, is_used) = student.place(&right.values[*index])?;
            // What nothing follows from is no mistake of an unknown kind, but a value off.
            let must = mistake == Mistake::Unknown;
            // The senses that somebody writes are not those that he goes on with.
            let may = mistake != Mistake::SensesReversed;
            if is_used && may && (must || random.below(2) == 0) {
                let value: f64 = given.text.parse().ok()?;
                goes_on.push((place, value * student.factor(given)?));
            }
            if must && !is_used {
                return None;
            }
        }
        // Of two numbers both are gone on with or none.
        if goes_on.len() < changed.len() {
            goes_on.clear();
        }
        let name = |index: usize| right.values[index].name.trim_end_matches("/mu").to_owned();
        let blanks = match goes_on.as_slice() {
            [] => changed.iter().map(|(index, _)| name(*index)).collect(),
            used => used.iter().map(|(place, _)| student.names()[*place].clone()).collect(),
        };
        let mut measured = draw(&[], &goes_on);
        for (index, given) in changed {
            measured.values[index] = given;
        }
        return Some(Planted { measured, blanks });
    }
    let ways = student.ways(mistake);
    if ways.is_empty() {
        return None;
    }
    let way = &ways[random.below(ways.len())];
    let measured = draw(&[way], &[]);
    let is_whole = measured.values.len() == draw(&[], &[]).values.len();
    (is_whole && stays_on_paper(&measured)).then(|| Planted { measured, blanks: texts(way) })
}

/// Whether no length is longer than the largest sheets that people draw on, A2: rays that hardly cross do so far away, and everybody sees that.
fn stays_on_paper(measured: &Measured) -> bool {
    let on_paper = measured.values.iter().filter(|given| given.name.ends_with("/mu"));
    let mut lengths = on_paper.filter_map(|given| given.text.parse::<f64>().ok());
    lengths.all(|mm| mm.abs() <= 594.0)
}

/// What is written in place of some values.
type Slip = fn(&Student<'_>, &Measured, [usize; 2], &mut Random) -> Option<Vec<(usize, Given)>>;

fn slip(mistake: Mistake) -> Option<Slip> {
    match mistake {
        Mistake::DecimalSlipped => Some(|_, right, [i, _], random| {
            let up = random.below(2) == 0;
            times(&right.values[i], if up { 10.0 } else { 0.1 }).map(|given| vec![(i, given)])
        }),
        Mistake::DigitsTransposed => Some(|_, right, [i, _], random| {
            let text: Vec<char> = right.values[i].text.chars().collect();
            let digits = (0..text.len()).filter(|&k| text[k].is_ascii_digit());
            let digits: Vec<usize> = digits.collect();
            let pairs = digits.windows(2).filter(|p| text[p[0]] != text[p[1]]);
            let pairs: Vec<&[usize]> = pairs.collect();
            let pair = pairs.get(random.below(pairs.len().max(1)))?;
            let mut changed = text.clone();
            changed.swap(pair[0], pair[1]);
            Some(vec![(i, written(&right.values[i], changed.into_iter().collect()))])
        }),
        Mistake::Swapped => Some(|_, right, [i, j], _| {
            let kind = |k: usize| {
                let name: &str = &right.values[k].name;
                (name.split('(').next(), name.ends_with("/mu"))
            };
            let [a, b] = [i, j].map(|k| &right.values[k]);
            let both = || vec![(i, written(a, b.text.clone())), (j, written(b, a.text.clone()))];
            (i < j && kind(i) == kind(j) && a.text != b.text).then(both)
        }),
        Mistake::WrongUnit => Some(|student, right, [i, j], _| {
            let given = &right.values[i];
            let own = student.unit(given)?;
            let of_kind = UNITS.iter().find(|units| units.contains(&own.as_str()))?;
            let wrong = of_kind[j % of_kind.len()];
            let unit = Some(wrong.to_owned());
            (wrong != own).then(|| vec![(i, Given { unit, ..given.clone() })])
        }),
        Mistake::OtherUnit => Some(|student, right, [i, j], _| {
            let given = &right.values[i];
            let own = student.unit(given)?;
            let is_metric = |units: &&[&str]| units[0].starts_with('m') && units.contains(&own.as_str());
            let of_kind = UNITS.into_iter().find(is_metric)?;
            let wrong = of_kind[j % of_kind.len()];
            let factor = student.factor(&Given { unit: Some(wrong.to_owned()), ..given.clone() })?;
            (wrong != own).then(|| times(given, 1.0 / factor).map(|given| vec![(i, given)]))?
        }),
        Mistake::SensesReversed => Some(|_, right, _, _| {
            let turns = |given: &Given| given.name.starts_with("omega(") || given.name.starts_with("alpha(");
            let all = right.values.iter().enumerate().filter(|(_, given)| turns(given));
            let all: Vec<(usize, Given)> = all.map(|(i, given)| (i, written(given, reversed(&given.text)))).collect();
            (all.len() > 1).then_some(all)
        }),
        Mistake::Unknown => Some(|_, right, [i, _], random| {
            let factor = [0.7, 1.4][random.below(2)] * (1.0 + 0.1 * random.within());
            times(&right.values[i], factor).map(|given| vec![(i, given)])
        }),
        _ => None,
    }
}

/// Units of one kind each.
const UNITS: [&[&str]; 5] = [
    &["mm/s", "m/s", "cm/s"],
    &["mm/s²", "m/s²", "cm/s²"],
    &["mm", "m", "cm"],
    &["rad/s", "rpm", "deg/s"],
    &["rad/s²", "deg/s²"],
];

/// A signed number with the other sign.
fn reversed(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(size) => format!("+{size}"),
        None => format!("-{}", text.trim_start_matches('+')),
    }
}

fn written(given: &Given, text: String) -> Given {
    Given { text, ..given.clone() }
}

/// A value so many times as large, with as many significant digits.
fn times(given: &Given, factor: f64) -> Option<Given> {
    let number: f64 = given.text.parse().ok()?;
    let decimals = given.text.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let decimals = decimals - power_of_ten(factor);
    let sign = if given.text.starts_with('+') { "+" } else { "" };
    let decimals = decimals.max(0) as usize;
    Some(written(given, format!("{sign}{:.decimals$}", number * factor)))
}

/// The power of ten next to a factor.
fn power_of_ten(factor: f64) -> i32 {
    libm::round(libm::log10(factor)) as i32
}

/// What stands in the blanks of a mistake's sentences.
fn texts(candidate: &Candidate) -> Vec<String> {
    candidate.told.blanks.iter().map(|(_, blank)| blank.text().to_owned()).collect()
}

/// Whether an explanation is the planted mistake alone, at its place.
fn is_planted(explanation: &Explanation, mistake: Mistake, blanks: &[String]) -> bool {
    match explanation.findings.as_slice() {
        [finding] => {
            let own = &finding.candidate;
            own.mistake() == mistake && texts(own).iter().zip(blanks).all(|(a, b)| a == b)
        }
        _ => false,
    }
}

/// How often a mistake was named, and what was named in its place.
#[derive(Default)]
pub struct Row {
    /// Drawings with the mistake.
    pub planted: usize,
    /// Those of which it was named.
    pub named: usize,
    /// Of those named: how often values could not tell it from the one that stands first.
    pub alike: usize,
    /// Those of which it was named, or no cause was sure enough and it is the first of the possible ones.
    pub first: usize,
    /// The mistakes that were named in its place, and how often each.
    pub instead: BTreeMap<&'static str, usize>,
}

impl Row {
    /// Share named, share not told apart, what was named in its place.
    fn columns(&self) -> String {
        let share = |count: usize| format!("{:.1} %", 100.0 * count as f64 / self.planted.max(1) as f64);
        let mut instead: Vec<_> = self.instead.iter().map(|(k, n)| (n, k)).collect();
        instead.sort_by(|a, b| b.cmp(a));
        let instead: Vec<String> = instead.iter().map(|(n, k)| format!("{k} {n}")).collect();
        let shares = [self.named, self.alike, self.first].map(share);
        format!("{} | {} |", shares.join(" | "), instead.join(", "))
    }
}

/// Plants a mistake so many times and checks; `hand` is the pencil's noise in mm and degrees.
pub fn row(mistake: Mistake, count: usize, hand: [f64; 2], seed: u64) -> Row {
    let mut random = Random(seed);
    let mut row = Row::default();
    let mut tries = 0;
    while row.planted < count && tries < 60 * count {
        tries += 1;
        let solution = random_scene(&mut random);
        let key = answer_key(&solution, 1);
        let Ok(student) = Student::new(&key) else {
            continue;
        };
        let Some(planted) = plant(&student, mistake, hand, &mut random) else {
            continue;
        };
        let Ok(checked) = check(&planted.measured, &key) else {
            continue;
        };
        // Cutting off in place of rounding moves no value beyond its tolerance.
        if checked.is_nothing_off() && mistake != Mistake::Truncated {
            continue;
        }
        // A value off from which nothing follows is not explained, only told.
        let off = checked.values.iter().filter(|v| v.verdict == Verdict::Off);
        if mistake == Mistake::Unknown && off.count() < 2 {
            continue;
        }
        row.planted += 1;
        let is_own = |e: &Explanation| is_planted(e, mistake, &planted.blanks);
        let others = &checked.diagnosis.others;
        let best = &checked.diagnosis.best.findings;
        let is_cause = |e: &&Explanation| e.findings.iter().all(|f| f.candidate.mistake() != Mistake::Unknown);
        if is_own(&checked.diagnosis.best) {
            row.named += 1;
        } else if others.iter().any(|o| o.is_alike && is_own(o)) {
            row.named += 1;
            row.alike += 1;
        } else {
            let is_untold = best.iter().all(|f| f.candidate.mistake() == Mistake::Unknown);
            row.first += usize::from(is_untold && others.iter().find(is_cause).is_some_and(is_own));
            let first = best.first().map_or("nothing", |f| f.candidate.mistake().id());
            *row.instead.entry(first).or_default() += 1;
        }
    }
    row.first += row.named;
    row
}

/// Draws `count` sheets without a mistake; returns on how many a value is off, and on how many a mistake is named.
pub fn clean(count: usize, hand: [f64; 2], seed: u64) -> [usize; 2] {
    let mut random = Random(seed);
    let mut alarms = [0; 2];
    for _ in 0..count {
        let solution = random_scene(&mut random);
        let key = answer_key(&solution, 1);
        let Ok(student) = Student::new(&key) else {
            continue;
        };
        let measured = student.draw(&[], hand, &mut || random.within(), &[]);
        if let Ok(checked) = check(&measured, &key) {
            alarms[0] += usize::from(!checked.is_nothing_off());
            alarms[1] += usize::from(!checked.diagnosis.best.findings.is_empty());
        }
    }
    alarms
}

/// Two mistakes at once: how often both are named, and at least the first of them.
pub fn pairs(count: usize, hand: [f64; 2], seed: u64) -> [usize; 3] {
    let mut random = Random(seed);
    let whole = [Mistake::OtherMode, Mistake::Truncated];
    let kinds = Mistake::all().filter(|m| slip(*m).is_none() && !whole.contains(m));
    let kinds: Vec<Mistake> = kinds.collect();
    let mut found = [0; 3];
    let mut tries = 0;
    while found[0] < count && tries < 60 * count {
        tries += 1;
        let solution = random_scene(&mut random);
        let key = answer_key(&solution, 2);
        let Ok(student) = Student::new(&key) else {
            continue;
        };
        let chosen = [0, 1].map(|_| kinds[random.below(kinds.len())]);
        let ways = chosen.map(|mistake| student.ways(mistake));
        if ways.iter().any(Vec::is_empty) {
            continue;
        }
        let mut both = ways.map(|ways| ways[random.below(ways.len())].clone());
        both.sort_by_key(|c| c.step);
        // Each by itself must be one that somebody could find.
        let seen = |mistakes: &[&Candidate]| {
            let measured = student.draw(mistakes, [0.0; 2], &mut || 0.0, &[]);
            let shallow = AnswerKey { depth: 0, ..key };
            check(&measured, &shallow).is_ok_and(|c| !c.is_nothing_off())
        };
        if both[0].step == both[1].step || !seen(&[&both[0]]) || !seen(&[&both[1]]) {
            continue;
        }
        let measured = student.draw(&[&both[0], &both[1]], hand, &mut || random.within(), &[]);
        if !stays_on_paper(&measured) {
            continue;
        }
        let Ok(checked) = check(&measured, &key) else {
            continue;
        };
        found[0] += 1;
        let diagnosis = &checked.diagnosis;
        let alike = diagnosis.others.iter().filter(|o| o.is_alike);
        let named = |candidate: &Candidate| {
            let mut first = core::iter::once(&diagnosis.best).chain(alike.clone());
            first.any(|e| {
                let mut own = e.findings.iter().map(|f| &f.candidate);
                own.any(|c| c.told == candidate.told)
            })
        };
        let names = [named(&both[0]), named(&both[1])];
        found[1] += usize::from(names[0] && names[1]);
        found[2] += usize::from(names[0]);
    }
    found
}

const INTRODUCTION: &str = "# Mistakes put in, and what the check says

Written by `cargo run --release --example mistakes -- COUNT > docs/mistakes.md`. Every drawing is of a random scene, a starting scene with other lengths, places and drive \
angles, whose rays cross under more than 17°. One mistake of the catalogue is made at a random place where it can be made, moves at least one value beyond twice its band and leaves the drawing on a sheet of 594 mm. The \
student fills in the whole form: lengths to 0.1 mm of paper, rates to four digits. The last columns have the noise of a pencil in every act, all \
errors up to 0.3 mm or 0.3° equally likely.

A mistake counts as named where the check puts it first, at the right place; or where the given values alone cannot tell it from the first one, which the report then says: these are \
the same by nature, as a crank's velocity laid off along the crank and both rays drawn along their links, or one segment taken by a scale ten times too large and a \
slipped decimal. The columns `not told apart` count these apart. A mistake that is \
not 60 % sure is not named; *named or first of the possible* counts those, too, where no other cause is told and it stands first of what it could be: so it was counted before probabilities left a share for what no \
catalogue has. Cutting off in place of rounding moves no value beyond its tolerance, so nothing is told of it. \
Under `unknown` a value is simply wrong, and gone on with: no classical mistake, but with the noise of a pencil any number is near one that some classical mistake gives.
";

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let count = arguments.get(1).and_then(|n| n.parse().ok()).unwrap_or(20);
    let only = arguments.get(2);
    let is_asked = |part: &str| only.is_none_or(|only| only == part);
    if only.is_none() {
        println!("{INTRODUCTION}");
    }
    println!(
        "| mistake | drawings | named, no noise | not told apart | named or first of the possible | named in its place | named, ±0.3 mm, ±0.3° | not told apart | named or first of the possible | named in its place |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for mistake in Mistake::all().filter(|m| is_asked(m.id())) {
        let exact = row(mistake, count, [0.0; 2], 1);
        let noisy = if mistake == Mistake::Truncated {
            "hidden | | | |".to_owned()
        } else {
            row(mistake, count, [0.3; 2], 2).columns()
        };
        println!("| {} | {} | {} {noisy}", mistake.id(), exact.planted, exact.columns());
    }
    if is_asked("clean") {
        let [off, named] = clean(count * 4, [0.3; 2], 3);
        println!(
            "\nOf {} clean drawings with ±0.3 mm, ±0.3°, {off} are not passed, {named} are told of a mistake.",
            count * 4
        );
    }
    for (hand, how) in [(0.0, "no noise"), (0.3, "±0.3 mm, ±0.3°")] {
        if is_asked("pairs") {
            let [all, both, first] = pairs(count, [hand; 2], 4);
            println!(
                "\nOf {all} drawings with two mistakes and {how}, both are named in {both}, at least the first in {first}."
            );
        }
    }
}
