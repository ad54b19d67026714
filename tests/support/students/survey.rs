//! Many students, and how right the check is about them.

use super::hand::{SKILLS, Skill};
use super::judge::{CLASSES, Class, Said, Told, class, is_right};
use super::task::Task;
use crate::random::Random;
use crate::stages::answer_key;
use kinegon::check::{check, check_result};
use std::fmt::Write;

/// Mistakes that the check looks for together, as the program does.
const DEPTH: usize = 5;

/// What the check made of a sheet.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub kind: &'static str,
    pub skill: usize,
    /// The mistakes in words; none on an honest sheet.
    pub mistakes: Vec<String>,
    pub is_classical: bool,
    /// The class of a sheet with mistakes.
    pub class: Option<Class>,
    /// What was told.
    pub told: Vec<Told>,
    pub probability: f64,
    /// Whether what was told is right.
    pub is_right: bool,
    pub has_passed: bool,
    /// Where the mistakes begin.
    pub begins: Vec<String>,
}

/// Draws and checks a sheet; none where no mistake fits.
pub fn sheet(task: &Task, skill: usize, is_honest: bool, random: &mut Random) -> Option<Outcome> {
    let hand: Skill = SKILLS[skill];
    let planned = if is_honest { None } else { Some(task.plan(random, &hand)?) };
    let measured = task.hand_in(planned.as_ref(), hand, random.next());
    let key = answer_key(&task.solution, DEPTH);
    let checked = check(&measured, &key).unwrap_or_else(|error| panic!("{}: {error}", task.kind));
    let result = check_result(&checked, &key, None);
    let said = Said::new(&result);
    let causes = planned.as_ref().map_or(&[][..], |planned| &planned.causes);
    Some(Outcome {
        kind: task.kind,
        skill,
        mistakes: causes.iter().map(|cause| cause.text.clone()).collect(),
        is_classical: causes.iter().all(|cause| cause.is_classical),
        class: planned.as_ref().map(|planned| class(&said, planned)),
        told: said.diagnosis().told.clone(),
        probability: said.diagnosis().probability,
        is_right: is_right(&said, planned.as_ref()),
        has_passed: said.has_passed,
        begins: causes.iter().flat_map(|cause| cause.begins.clone()).collect(),
    })
}

/// So many sheets of these tasks, hands and kinds of mistakes by lot.
pub fn survey(tasks: &[Task], count: usize, is_honest: bool, seed: u64) -> Vec<Outcome> {
    let mut random = Random(seed);
    let mut outcomes = Vec::new();
    while outcomes.len() < count {
        // Kinds and hands by turns, so that all have their share.
        let (task, skill) = (&tasks[random.below(tasks.len())], outcomes.len() % SKILLS.len());
        outcomes.extend(sheet(task, skill, is_honest, &mut random));
    }
    outcomes
}

/// A bin of stated probabilities: how many, what they said, how many were right.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bin {
    pub count: usize,
    pub stated: f64,
    pub right: usize,
}

/// Ten bins of all sheets of which something is told.
pub fn bins<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> [Bin; 10] {
    let mut bins = [Bin::default(); 10];
    for outcome in outcomes.filter(|outcome| !outcome.told.is_empty()) {
        let bin = &mut bins[((outcome.probability * 10.0) as usize).min(9)];
        bin.count += 1;
        bin.stated += outcome.probability;
        bin.right += usize::from(outcome.is_right);
    }
    bins
}

/// The mean square of what was stated less what came out; 0 is best.
pub fn brier<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> f64 {
    let told = outcomes.filter(|outcome| !outcome.told.is_empty());
    let (count, sum) = told.fold((0, 0.0), |(count, sum), outcome| {
        let off = outcome.probability - f64::from(u8::from(outcome.is_right));
        (count + 1, sum + off * off)
    });
    sum / f64::from(count.max(1))
}

/// The table of calibration: stated against true, all hands and each.
pub fn calibration(outcomes: &[Outcome]) -> String {
    let mut text = String::from("| stated | sheets | mean | right |");
    for skill in &SKILLS {
        let _ = write!(text, " {} |", skill.name);
    }
    text.push_str("\n|---|---|---|---|---|---|---|---|---|---|\n");
    let all = bins(outcomes.iter());
    let each: Vec<[Bin; 10]> = (0..SKILLS.len()).map(|skill| bins(of(outcomes, skill))).collect();
    let share = |bin: &Bin| match bin.count {
        0 => "–".to_owned(),
        count => format!("{:.0} %", 100.0 * bin.right as f64 / count as f64),
    };
    for (k, bin) in all.iter().enumerate() {
        let mean = 100.0 * bin.stated / bin.count.max(1) as f64;
        let _ = write!(text, "| {}–{} % | {} | {mean:.0} % | {} |", 10 * k, 10 * k + 10, bin.count, share(bin));
        for bins in &each {
            let _ = write!(text, " {} of {} |", bins[k].right, bins[k].count);
        }
        text.push('\n');
    }
    let _ = write!(text, "| Brier | | | {:.3} |", brier(outcomes.iter()));
    for skill in 0..SKILLS.len() {
        let _ = write!(text, " {:.3} |", brier(of(outcomes, skill)));
    }
    text.push('\n');
    text
}

fn of(outcomes: &[Outcome], skill: usize) -> impl Iterator<Item = &Outcome> {
    outcomes.iter().filter(move |outcome| outcome.skill == skill)
}

/// How sheets with mistakes are judged, in per cent, by hand and by what was done.
pub fn classes(outcomes: &[Outcome]) -> String {
    let mut text = String::from("| hand | sheets |");
    for (_, name) in CLASSES {
        let _ = write!(text, " {name} |");
    }
    text.push_str("\n|---|---|---|---|---|---|---|---|\n");
    let mut row = |name: &str, own: &dyn Fn(&Outcome) -> bool| {
        let own: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.class.is_some() && own(outcome)).collect();
        let _ = write!(text, "| {name} | {} |", own.len());
        for (class, _) in CLASSES {
            let count = own.iter().filter(|outcome| outcome.class == Some(class)).count();
            let _ = write!(text, " {:.1} |", 100.0 * count as f64 / own.len().max(1) as f64);
        }
        text.push('\n');
    };
    row("all", &|_| true);
    for (k, skill) in SKILLS.iter().enumerate() {
        row(skill.name, &|outcome| outcome.skill == k);
    }
    row("classical", &|outcome| outcome.is_classical && outcome.mistakes.len() == 1);
    row("slips", &|outcome| !outcome.is_classical && outcome.mistakes.len() == 1);
    row("two mistakes", &|outcome| outcome.mistakes.len() == 2);
    for kind in super::script::kinds() {
        row(kind, &|outcome| outcome.kind == kind);
    }
    text
}

/// What is made of sheets without mistakes.
pub fn honest(outcomes: &[Outcome]) -> String {
    let mut text = String::from(
        "| hand | sheets | failed | accused | with 80 % or more | accused though passed |\n|---|---|---|---|---|---|\n",
    );
    for (k, skill) in SKILLS.iter().enumerate() {
        let own: Vec<&Outcome> = of(outcomes, k).collect();
        let count = |fits: &dyn Fn(&Outcome) -> bool| own.iter().filter(|outcome| fits(outcome)).count();
        let accused = |outcome: &Outcome| !outcome.told.is_empty();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            skill.name,
            own.len(),
            count(&|outcome| !outcome.has_passed),
            count(&accused),
            count(&|outcome| accused(outcome) && outcome.probability >= 0.8),
            count(&|outcome| accused(outcome) && outcome.has_passed)
        );
    }
    text
}
