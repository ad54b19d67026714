//! What is probably wrong with a sum of moments that was taken in another way than Kinegon's own: another point, other arms.

use super::bench::Bench;
use super::entry::{Compute, Entry, Solve};
use super::formula::Formula;
use super::names::segment_of;
use super::table::Made;
use crate::check::{Blank, Mistake, Told, tell};
use crate::construction::{LoadShown, Teller, plain_text};
use crate::forces::Source;
use crate::sheet::Sheet;

/// What two numbers that are the same may differ by, in parts of the larger; and where loads are typed with three digits.
const SAME: [f64; 2] = [1e-6, 0.004];

impl Bench<'_> {
    /// The slip in a sum of moments: arms in millimetres of paper, a couple that is left out or turns the wrong way.
    pub(super) fn slip_of_moments(&self, entry: &Entry, made: &Made) -> Option<Told> {
        let Made::Numbers(all) = made else { return None };
        let (name, _) = all.first()?;
        let right = self.judge.given().number(name)?;
        let Ok(Made::Numbers(found)) = self.right[0].carried_out_again(entry) else { return None };
        let found = found.first()?.1;
        let formulas = formulas(entry);
        let same = SAME[usize::from(formulas.iter().any(Formula::has_numbers))];
        self.in_paper_mm(entry, name, (right, same)).or_else(|| self.with_couple(&formulas, found, (right, same)))
    }

    fn in_paper_mm(&self, entry: &Entry, name: &str, (right, same): (f64, f64)) -> Option<Told> {
        let Entry::Compute(Compute { by: Some(by), .. }) = entry else { return None };
        let scale = Sheet::Scheme.facts().scale_key;
        if !by.names().contains(&scale) {
            return None;
        }
        let table = &self.right[0];
        let value = by.value(&mut |own| if own == scale { Ok(1.0) } else { table.number(own) }).ok()?;
        let told = || {
            let symbol = Sheet::Scheme.facts().scale_symbol.to_owned();
            tell::arm_in_paper_mm(Blank::Quantity(name.to_owned()), Blank::Words(symbol))
        };
        is_same(value.abs(), right.abs(), same).then(told)
    }

    /// A couple that is left out, or counts with the wrong sign: over each length of the formula, as nobody knows which is the unknown's arm.
    fn with_couple(&self, formulas: &[Formula], found: f64, (right, same): (f64, f64)) -> Option<Told> {
        let table = &self.right[0];
        let names = formulas.iter().flat_map(Formula::names);
        let arms = names.filter_map(|name| table.number(name).ok()).map(f64::abs).chain([1.0]);
        let arms: Vec<f64> = arms.filter(|arm| *arm > 0.0).collect();
        let plan = self.judge.given().construction().forces.as_deref()?;
        let loads = || plan.loads.iter().filter(|load| load.couple != 0.0);
        let all: f64 = loads().map(|load| load.couple).sum();
        let one = loads().map(|load| (load.couple, vec![load]));
        let couples: Vec<(f64, Vec<&LoadShown>)> = one.chain([(all, loads().collect())]).collect();
        let missing = |couple: f64, times: f64| {
            arms.iter().any(|arm| {
                let part = times * couple / arm;
                [part, -part].iter().any(|part| is_same((found + part).abs(), right.abs(), same))
            })
        };
        let symbols = |loads: &[&LoadShown]| {
            let words = self.judge.given().solution.wording();
            let teller = Teller::new(&self.judge.given().solution, &words);
            let each = loads.iter().map(|load| plain_text(&teller.couple_symbol(load.source, load.body)));
            Blank::Words(each.collect::<Vec<_>>().join(", "))
        };
        let forgotten = couples.iter().find(|(couple, _)| missing(*couple, 1.0));
        if let Some((_, loads)) = forgotten {
            return Some(tell::couple_forgotten(symbols(loads)));
        }
        let is_inertia = |loads: &[&LoadShown]| loads.iter().all(|load| load.source == Source::Inertia);
        let turned = couples.iter().find(|(couple, loads)| is_inertia(loads) && missing(*couple, 2.0));
        turned.map(|(_, loads)| tell::inertia_couple_along_alpha(symbols(loads)))
    }

    /// A length up to a point that should be one up to a foot of the hand's own: an arm that was measured to where the force acts.
    pub(super) fn as_arm(&self, entry: &Entry, told: Told) -> Told {
        let Some(name) = entry.made().first().map(|name| (*name).to_owned()) else { return told };
        let is_own = |end: &String| self.judge.given().place(Sheet::Scheme, end).is_none();
        let of_foot = |blank: &Blank| match blank {
            Blank::Symbol(length) => segment_of(length).is_some_and(|(_, ends)| ends.iter().any(is_own)),
            _ => false,
        };
        match told.mistake == Mistake::WrongLength && told.blanks.iter().any(|(_, blank)| of_foot(blank)) {
            true => tell::arm_to_point(Blank::Quantity(name)),
            false => told,
        }
    }
}

fn formulas(entry: &Entry) -> Vec<Formula> {
    match entry {
        Entry::Compute(Compute { by, .. }) => by.iter().cloned().collect(),
        Entry::Solve(Solve { equations, .. }) => {
            equations.iter().filter_map(|text| Formula::sides(text).ok()).flatten().collect()
        }
        _ => Vec::new(),
    }
}

fn is_same(a: f64, b: f64, same: f64) -> bool {
    (a - b).abs() <= same * a.max(b)
}
