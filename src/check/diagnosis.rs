//! Weighs the explanations that were tried, and chooses what is told: causes only that are probable, and none that the
//! student's own values refute.

use super::checked::{Diagnosis, Explanation, Finding, Judged, Verdict};
use super::covariance::{Datum, Hand};
use super::entry::Entry;
use super::fit::Fit;
use super::lesson::{Lesson, lesson, of_value};
use super::mistakes::{Blank, Candidate, Mistake, tell};
use super::search::{Search, Tried};

/// Least probability of a cause that is told.
const TOLD: f64 = 0.6;

/// Least probability of another explanation that is reported.
const LEAST: f64 = 0.02;

/// Most other explanations that are reported.
const OTHERS: usize = 4;

/// Least weight of an explanation, in parts of the likeliest one's, that is weighed at all.
const NEGLIGIBLE: f64 = 1e-5;

/// The share of students in whose values a mistake of the catalogue is seen although they made another, that no
/// catalogue has, and the same for each further mistake: found with students who are not of the catalogue
/// (docs/mistakes.md). The first pair is for drawings by hand, the second for those that are more exact: their values
/// fit by chance much more rarely.
const OUTSIDE: [[f64; 2]; 2] = [[0.1, 0.12], [0.03, 0.04]];

/// The power of a probability that is left, by hand, for rivals that nobody has listed: where some of the catalogue are
/// near, so are others.
const RIVALS: f64 = 1.5;

/// The part of a probability that is left, by hand, for each cause from which no other value follows: one value alone
/// fits by chance more often.
const ALONE: f64 = 0.88;

/// The part of the share where only the place of a mistake is told.
const UNKNOWN_OUTSIDE: f64 = 0.4;

/// Size of the largest errors of hands for which causes are told, in parts of the tolerance.
const WORST: f64 = 3.4;

/// Values that slips may leave open, beside what is explained.
const FEW: usize = 5;

/// A value follows from a mistake if the earlier values predict it: within this many standard deviations of an honest hand, or within one
/// part in so many of the change that the mistake makes.
const KNOWN: f64 = 3.0;
const RECOMPUTED: f64 = 20.0;

/// Values that must follow from a mistake of unknown cause for it to be said that it was gone on with: at some place of a
/// construction an amount can be found with which one more number agrees by chance.
const FOLLOWING: usize = 2;

/// At most one student in this many who invents all numbers is told that they agree with a mistake.
const RARELY: f64 = 300.0;

/// The logarithm of how many times less likely each value that is right makes it that the others are invented.
const TRUSTED: f64 = 3.0;

/// Explanations that are told in the same words.
struct Group<'t> {
    /// The likeliest of them.
    best: &'t Tried,
    findings: Vec<Finding>,
    /// Its probability among all that were tried.
    probability: f64,
    /// Whether the values alone cannot tell it from the likeliest group.
    is_alike: bool,
}

impl Group<'_> {
    fn tells(&self, candidate: &Candidate) -> bool {
        self.findings.iter().any(|finding| finding.candidate.told == candidate.told)
    }

    /// Whether it tells of the mistake, at one place or at more.
    fn has(&self, candidate: &Candidate) -> bool {
        self.findings.iter().any(|finding| {
            let own = &finding.candidate;
            own.told == candidate.told
                || is_repeated(own, candidate)
                || own.told.is_near(&candidate.told)
                || own.told.wider().as_ref() == Some(&candidate.told)
        })
    }
}

impl Search<'_> {
    /// What is told of the values, after the explanations that were tried, the best first.
    pub fn diagnosis(&self, tried: &[Tried], values: &[Judged]) -> Diagnosis {
        let groups = self.groups(tried);
        let Some(first) = groups.first() else {
            return Diagnosis::none(values);
        };
        let hand = &first.best.fit.hand;
        let mut told = told(&groups, values);
        told.retain(|finding| self.has_evidence(first.best, finding, values));
        let probability = |findings: &[Finding]| {
            let holds = |g: &&Group<'_>| findings.iter().all(|f| g.is_alike || has_cause(g, f));
            let all: f64 = groups.iter().filter(holds).map(|g| g.probability).sum();
            honest(all.min(1.0), findings, hand)
        };
        // Together they must be probable, too: the later ones are left out first.
        while !told.is_empty() && probability(&told) < TOLD {
            // Of the first its place is told at least.
            let last = told.pop().filter(|last| told.is_empty() && last.names_cause());
            let less = |last: Finding| {
                let wider = wider(&last).filter(|wider| probability(core::slice::from_ref(wider)) >= TOLD);
                wider.or_else(|| only_placed(&last, values))
            };
            told.extend(last.and_then(less));
        }
        let explained = |told: &[Finding], entry: usize| {
            told.iter().any(|f| f.follows.contains(&entry) || f.written.contains(&entry))
                && !self.is_outside(&first.best.fit, entry)
        };
        let off: Vec<usize> = (0..values.len()).filter(|&entry| values[entry].verdict == Verdict::Off).collect();
        // What leaves most of the wrong values open is no explanation of the drawing, nor is one for a hand that nobody has.
        let count = off.iter().filter(|&&entry| explained(&first.findings, entry)).count();
        let open = off.len() - count;
        if open > FEW.max(off.len() / 2) || hand.worst() > WORST {
            told.clear();
        }
        // In a drawing by hand a slip that moves no value out of its tolerance is a chance, in any drawing one in a value that is right.
        let shows = |entry: &usize| match values[*entry].verdict {
            Verdict::Right => false,
            verdict => verdict == Verdict::Off || !hand.is_by_hand(),
        };
        told.retain(|finding| finding.changed().iter().any(shows));
        // Beside a mistake without a name one with a name fits by chance too often: the place of the first is told.
        if told.len() > 1 && !told.iter().all(Finding::names_cause) {
            told.truncate(1);
            told = told.iter().filter_map(|finding| only_placed(finding, values)).collect();
        }
        told.retain(|finding| finding.names_cause() || self.has_evidence(first.best, finding, values));
        let open =
            |told: &[Finding]| off.iter().copied().filter(|&entry| !explained(told, entry)).collect::<Vec<usize>>();
        let mut unexplained = open(&told);
        let mut begins = self.begins(first, &told, &unexplained, values);
        if begins.is_some() && unexplained.len() > 1 {
            // What comes later may follow from it.
            told.clear();
            unexplained = open(&told);
            begins = self.begins(first, &told, &unexplained, values);
        }
        unexplained.retain(|&entry| begins.as_ref().is_none_or(|begins| !begins.written.contains(&entry)));
        // What holds all that is told is counted in its probability already.
        let all = || begins.iter().chain(&told);
        let is_counted = |group: &Group<'_>| all().count() > 0 && all().all(|f| has_cause(group, f));
        let is_place = all().any(|f| f.candidate.mistake() == Mistake::Unknown);
        let others = groups.iter().filter_map(|group| {
            let is_new = group.findings.iter().any(|f| !all().any(|t| t.candidate.told == f.candidate.told));
            // What the values cannot tell from an explanation that is told whole.
            let is_told =
                group.is_alike && told.iter().all(|t| first.tells(&t.candidate)) && told.len() == first.findings.len();
            // Where only the place of a mistake is told, the mistakes that may have been made there.
            let is_within =
                (is_counted(group) && is_place || begins.is_some()) && group.findings.iter().any(Finding::names_cause);
            let is_other = is_within || !is_counted(group) && begins.is_none();
            let is_shown = is_told || group.probability >= LEAST && is_other;
            (is_new && is_shown).then(|| Explanation {
                findings: group.findings.clone(),
                probability: if is_told {
                    probability(&told)
                } else {
                    honest(group.probability, &group.findings, hand)
                },
                is_alike: is_told,
                is_within: is_within && !is_told,
            })
        });
        let others = others.take(OTHERS).collect();
        let certain = begins.as_ref().map_or(1.0, |begins| honest(1.0, core::slice::from_ref(begins), hand));
        let probability = match (told.is_empty(), &begins) {
            (true, None) => none_told(&groups),
            (true, Some(_)) => certain,
            (false, _) => certain * probability(&told),
        };
        self.teach(&mut told);
        told.splice(0..0, begins);
        Diagnosis {
            best: Explanation { findings: told, probability, is_alike: false, is_within: false },
            others,
            unexplained,
            looked_at: values.len(),
        }
    }

    /// The first value that is off and that nothing of what is told explains, where it comes before all that: a mistake was made in it or
    /// at a step before, behind the last value that is right. `None` where an honest hand, the one that was found, comes to it.
    fn begins(&self, best: &Group<'_>, told: &[Finding], open: &[usize], values: &[Judged]) -> Option<Finding> {
        let fit = &best.best.fit;
        let &entry = open.first()?;
        let is_first = told.first().and_then(Finding::first).is_none_or(|first| entry < first);
        let is_mistake = fit.hand.worst() <= WORST && (!best.findings.is_empty() || self.is_outside(fit, entry));
        if !is_first || !is_mistake {
            return None;
        }
        let Entry { asked, step, .. } = &values[entry].entry;
        let quantity = Blank::Quantity(asked.name().to_owned());
        let is_alone = open.len() == 1 && told.is_empty();
        let tell = if is_alone { tell::unknown_alone } else { tell::unknown_first };
        let (follows, contradicts, written) = (Vec::new(), Vec::new(), vec![entry]);
        let lesson = of_value(&self.scorer.models[0], self.scorer.entries, entry, is_alone);
        Some(Finding { candidate: Candidate::at(tell(quantity), *step), follows, contradicts, written, lesson })
    }

    /// Adds to mistakes that are told what they teach.
    fn teach(&self, told: &mut [Finding]) {
        let candidates: Vec<Candidate> = told.iter().map(|finding| finding.candidate.clone()).collect();
        let all: Vec<&Candidate> = candidates.iter().collect();
        let model = self.scorer.model(&all);
        for (index, finding) in told.iter_mut().enumerate() {
            let others: Vec<&Candidate> =
                (0..all.len()).filter(|&other| other != index).map(|other| all[other]).collect();
            finding.lesson = lesson(model, self.scorer.entries, all[index], &others);
        }
    }

    /// The explanations grouped by their words, those left out that a written value refutes; the likeliest first.
    fn groups<'t>(&self, tried: &'t [Tried]) -> Vec<Group<'t>> {
        let least = tried.iter().map(|t| t.cost).fold(f64::INFINITY, f64::min);
        let weight = |t: &Tried| libm::exp(-0.5 * (t.cost - least));
        let mut groups: Vec<Group<'t>> = Vec::new();
        for tried in tried.iter().filter(|t| weight(t) > NEGLIGIBLE) {
            let findings = self.findings(tried);
            if self.is_refuted(tried, &findings) {
                continue;
            }
            let same = |g: &&mut Group<'_>| {
                g.findings.len() == findings.len() && findings.iter().all(|f| g.tells(&f.candidate))
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.probability += weight(tried),
                None => groups.push(Group { best: tried, findings, probability: weight(tried), is_alike: false }),
            }
        }
        let total: f64 = groups.iter().map(|g| g.probability).sum();
        groups.iter_mut().for_each(|g| g.probability /= total);
        groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        if let [first, others @ ..] = groups.as_mut_slice() {
            first.is_alike = true;
            for other in others.iter_mut().filter(|other| other.best.set.len() == first.best.set.len()) {
                let sets = [&first.best.set, &other.best.set].map(|set| self.set(set));
                let [a, b] = &sets;
                other.is_alike = self.scorer.are_alike(&first.best.fit, &other.best.fit, [a, b]);
            }
        }
        self.least_first(&mut groups);
        groups
    }

    /// Puts that explanation first that supposes the mistakes of the likeliest at the fewest places, among those that the values cannot tell apart.
    fn least_first(&self, groups: &mut [Group<'_>]) {
        let mistakes = |group: &Group<'_>| {
            let mut all: Vec<Mistake> = group.findings.iter().map(|finding| finding.candidate.mistake()).collect();
            all.sort_unstable();
            all
        };
        let places = |group: &Group<'_>| -> usize { self.set(&group.best.set).iter().map(|own| own.edits.len()).sum() };
        let Some(likeliest) = groups.first().map(mistakes) else { return };
        let alike = groups.iter().enumerate().filter(|(_, group)| group.is_alike && mistakes(group) == likeliest);
        if let Some((least, _)) = alike.min_by_key(|(_, group)| places(group)) {
            groups[..=least].rotate_right(1);
        }
    }

    /// Whether the values support a mistake: more of them agree with it than amounts were fitted, and better than invented numbers would agree
    /// with some mistake of the catalogue by chance.
    fn has_evidence(&self, tried: &Tried, finding: &Finding, values: &[Judged]) -> bool {
        let follows = finding.follows.len();
        // The sheets of two exercises differ in the crank's angle, too.
        let is_whole = finding.candidate.mistake() == Mistake::CrankAngle;
        if is_whole && self.is_of_another_sheet(finding, values) {
            return false;
        }
        match (finding.names_cause(), finding.candidate.free.is_empty()) {
            (true, true) => follows == 0 || self.agreement(tried, finding, values) >= self.by_chance(values),
            (true, false) => follows > 0,
            (false, _) => follows >= FOLLOWING && !self.is_of_another_sheet(finding, values),
        }
    }

    /// Whether a value that follows from the scene's numbers alone is wrong, and this mistake does not explain it: the student may have
    /// copied another sheet.
    fn is_of_another_sheet(&self, finding: &Finding, values: &[Judged]) -> bool {
        let mut given = self.scorer.given.iter().enumerate().filter(|(_, given)| **given);
        given.any(|(entry, _)| {
            let is_explained = finding.follows.contains(&entry) || finding.written.contains(&entry);
            values[entry].verdict == Verdict::Off && !is_explained
        })
    }

    /// How well the wrong values agree with a mistake: −ln of the probability that invented values would agree as well.
    fn agreement(&self, tried: &Tried, finding: &Finding, values: &[Judged]) -> f64 {
        let changed = finding.changed();
        let data = self.scorer.data.iter().enumerate();
        let data = data.filter(|(_, datum)| {
            let entry = datum.entry;
            changed.contains(&entry) && values[entry].verdict == Verdict::Off && !self.is_outside(&tried.fit, entry)
        });
        // The band is two standard deviations to each side. An invented value may be as large as the largest that was written.
        let range = |datum: &Datum| datum.span.max(datum.value.abs());
        data.map(|(place, datum)| libm::log(range(datum) / (4.0 * tried.fit.given[place].sqrt())).max(0.0)).sum()
    }

    /// The agreement that chance would give. It falls with the number of right values, because a sheet with many is not invented.
    fn by_chance(&self, values: &[Judged]) -> f64 {
        let is_right = |value: &&Judged| matches!(value.verdict, Verdict::Right | Verdict::WithinTolerance);
        let right = values.iter().filter(is_right).count();
        libm::log(self.pool.len() as f64 * RARELY) - TRUSTED * right as f64
    }

    fn is_outside(&self, fit: &Fit, entry: usize) -> bool {
        let mut data = fit.outside.iter().zip(&self.scorer.data);
        data.find(|(_, datum)| datum.entry == entry).is_none_or(|(outside, _)| *outside)
    }

    /// Whether the written values refute a mistake of an explanation: it changes none, or the first that it changes or
    /// half of all are not as it would make them.
    fn is_refuted(&self, tried: &Tried, findings: &[Finding]) -> bool {
        findings.iter().any(|finding| {
            let changed = finding.changed();
            let contradicting = changed.iter().filter(|&&entry| self.is_outside(&tried.fit, entry)).count();
            let begins_wrong = changed.first().is_none_or(|&entry| self.is_outside(&tried.fit, entry));
            let mut reinterpreted = finding.candidate.reinterpreted.iter();
            let is_written_wrong = reinterpreted.any(|r| self.is_outside(&tried.fit, r.entry));
            begins_wrong || is_written_wrong || 2 * contradicting > changed.len() || self.has_right_sense(finding)
        })
    }

    /// Whether a rate that was taken with the wrong sense, as a mistake says, is written with the right one.
    fn has_right_sense(&self, finding: &Finding) -> bool {
        let mut written = finding.written.iter();
        finding.candidate.mistake() == Mistake::WrongSense
            && written.any(|&entry| {
                let entry = &self.scorer.entries[entry];
                !entry.is_magnitude && entry.value * entry.expected > 0.0
            })
    }

    /// The values in which a mistake itself was made: those it makes to be written otherwise than meant, and those read
    /// from the operation that it changes.
    fn written(&self, candidate: &Candidate) -> Vec<usize> {
        let model = &self.scorer.models[0];
        let is_touched = |entry: usize| {
            let reading = model.readings[entry].ok();
            let maker = reading.and_then(|r| model.makers[r.number.0]);
            let is_edited = maker.is_some_and(|m| candidate.edits.iter().any(|edit| edit.operation == m));
            is_edited || candidate.reinterpreted.iter().any(|s| s.entry == entry)
        };
        self.scorer.data.iter().map(|d| d.entry).filter(|&entry| is_touched(entry)).collect()
    }

    /// The mistakes of an explanation with what each changes, in the order of the construction.
    fn findings(&self, tried: &Tried) -> Vec<Finding> {
        let finding = |&index: &usize| {
            let without: Vec<usize> = tried.set.iter().copied().filter(|&i| i != index).collect();
            let before = self.scorer.predicted(&self.set(&without));
            let candidate = self.pool[index].clone();
            let touched = self.written(&candidate);
            let (mut follows, mut contradicts, mut written) = (Vec::new(), Vec::new(), Vec::new());
            for (place, datum) in self.scorer.data.iter().enumerate() {
                let moved = datum.seen_apart(tried.fit.predicted[place], before[place]);
                let deviation = self.scorer.deviation(place, &tried.fit);
                let is_moved = moved.abs() > 2.0 * deviation;
                let is_reinterpreted = candidate.reinterpreted.iter().any(|r| r.entry == datum.entry);
                // What an amount was fitted to follows from nothing.
                let is_fitted = tried.fit.given[place].sqrt() > (KNOWN * deviation).max(moved.abs() / RECOMPUTED);
                // A mistake in all values of a kind is charged to the first of them; the others follow.
                let is_like_first = candidate.told.is_of_a_kind() && !written.is_empty();
                if is_reinterpreted && is_like_first && !tried.fit.outside[place] {
                    follows.push(datum.entry);
                } else if touched.contains(&datum.entry) {
                    // What a mistake leaves as it is was not made in it.
                    if is_moved || is_reinterpreted {
                        written.push(datum.entry);
                    }
                } else if is_moved && tried.fit.outside[place] {
                    contradicts.push(datum.entry);
                } else if is_moved && is_fitted {
                    written.push(datum.entry);
                } else if is_moved {
                    follows.push(datum.entry);
                }
            }
            // Amounts are fitted to the first values, so these are no evidence, even where they hardly depend on the amounts.
            let fitted = candidate.free.len().saturating_sub(written.len()).min(follows.len());
            written.extend(follows.drain(..fitted));
            written.sort_unstable();
            Finding { follows, contradicts, written, candidate, lesson: Lesson::default() }
        };
        let mut findings: Vec<Finding> = tried.set.iter().map(finding).collect();
        findings.sort_by_key(|f| f.candidate.step);
        findings
    }
}

/// Whether a group tells the cause of a finding; for a finding of unknown cause, whether one begins at the same value.
fn has_cause(group: &Group<'_>, finding: &Finding) -> bool {
    if finding.names_cause() {
        group.has(&finding.candidate)
    } else {
        group.findings.iter().any(|f| f.first() == finding.first())
    }
}

/// Whether two candidates are one mistake, made once or at more places from the same step on: what is told of one holds for both.
fn is_repeated(one: &Candidate, other: &Candidate) -> bool {
    let within = |a: &Candidate, b: &Candidate| {
        a.operations().count() < b.operations().count() && a.operations().all(|o| b.operations().any(|p| p == o))
    };
    one.mistake() == other.mistake() && one.step == other.step && (within(one, other) || within(other, one))
}

/// The probability that no mistake was made, or none that the catalogue has.
fn none_told(groups: &[Group<'_>]) -> f64 {
    let is_unknown = |g: &&Group<'_>| g.findings.iter().all(|f| f.candidate.mistake() == Mistake::Unknown);
    groups.iter().filter(is_unknown).map(|g| g.probability).sum()
}

/// The findings of the likeliest explanation that are told: those that are probable, be it as a mistake of the
/// catalogue or only at their place.
fn told(groups: &[Group<'_>], values: &[Judged]) -> Vec<Finding> {
    let sum = |is: &dyn Fn(&Group<'_>) -> bool| -> f64 {
        groups.iter().filter(|g| g.is_alike || is(g)).map(|g| g.probability).sum()
    };
    let told = groups[0].findings.iter().filter_map(|finding| {
        if sum(&|g| g.has(&finding.candidate)) >= TOLD {
            return Some(finding.clone());
        }
        if let Some(wider) = wider(finding).filter(|wider| sum(&|g| g.has(&wider.candidate)) >= TOLD) {
            return Some(wider);
        }
        let first = finding.first();
        let begins = |g: &Group<'_>| g.findings.iter().any(|f| f.first() == first);
        only_placed(finding, values).filter(|_| sum(&begins) >= TOLD)
    });
    // Behind a value that is wrong for no known reason no other such value is told: where to look first is enough.
    let mut told: Vec<Finding> = told.collect();
    let mut is_first = true;
    told.retain(|finding| finding.names_cause() || core::mem::take(&mut is_first));
    // Nor is it said that something begins at a value where an earlier one is off and unexplained.
    let explained: Vec<usize> = told.iter().flat_map(Finding::changed).collect();
    let first_open = (0..values.len()).find(|i| values[*i].verdict == Verdict::Off && !explained.contains(i));
    told.retain(|finding| {
        let begins = finding.first();
        finding.names_cause() || first_open.is_none_or(|open| begins.is_some_and(|b| b < open))
    });
    told
}

/// A mistake without which of several wrong things was taken; `None` of one that is told wholly or not at all.
fn wider(finding: &Finding) -> Option<Finding> {
    let told = finding.candidate.told.wider()?;
    Some(Finding { candidate: Candidate { told, ..finding.candidate.clone() }, ..finding.clone() })
}

/// A mistake told by its place and what follows from it, without a cause.
fn only_placed(finding: &Finding, values: &[Judged]) -> Option<Finding> {
    let off = finding.changed().into_iter().find(|&value| values[value].verdict == Verdict::Off);
    let first = off.or(finding.first())?;
    let Entry { asked, step, .. } = &values[first].entry;
    let told = tell::unknown(Blank::Quantity(asked.name().to_owned()));
    // A mistake in the whole drawing begins where it shows.
    let step = if finding.candidate.step == 0 { *step } else { finding.candidate.step };
    let mut placed = Finding { candidate: Candidate { told, step, ..finding.candidate.clone() }, ..finding.clone() };
    // Nothing follows from itself.
    if placed.follows.contains(&first) {
        placed.follows.retain(|&value| value != first);
        placed.written.insert(0, first);
    }
    Some(placed)
}

/// The share of students that made these mistakes, of those for whom they have this probability among all that was
/// tried.
fn honest(probability: f64, findings: &[Finding], hand: &Hand) -> f64 {
    let is_by_hand = hand.is_by_hand();
    let [first, further] = OUTSIDE[usize::from(!is_by_hand)];
    let names_any = findings.iter().any(Finding::names_cause);
    let first = if names_any { first } else { UNKNOWN_OUTSIDE * first };
    let others = findings.len().saturating_sub(1) as i32;
    let rivals = if is_by_hand && names_any { libm::pow(probability, RIVALS) } else { probability };
    let is_alone = |f: &&Finding| f.follows.is_empty() && f.names_cause();
    let alone = if is_by_hand { findings.iter().filter(is_alone).count() as i32 } else { 0 };
    rivals * libm::pow(ALONE, f64::from(alone)) * (1.0 - first) * libm::pow(1.0 - further, f64::from(others))
}
