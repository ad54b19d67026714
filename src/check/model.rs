//! What a drawing gives for all values at once: exact, with mistakes put in, and how far honest errors carry them, together.

use super::entry::Entry;
use super::order::{numbered_steps, step_of};
use super::sheet::CheckError;
use super::together::ways_together;
use super::answer_key::AnswerKey;
use crate::drafting::{
    Act, Band, Change, Deed, Disturbance, Drafting, LineId, NumberId, PlaceId, Reading, Reference, Sheet, SheetScales,
    Tolerance, Unread, Values, drafting_with,
};
use crate::plan::{Asked, Construction, Solution};
use smallvec::SmallVec;

/// Kinds of errors whose sizes a hand may have apart: joints plotted, the rest of the scheme, the velocity plan, the acceleration plan,
/// and joints off together, so that every link keeps its shape, as a drawing program leaves them.
pub(super) const GROUPS: usize = 5;

/// Of these the errors of joints plotted, each for itself.
pub(super) const PLOTTED: usize = 0;

/// Of these the errors of joints off together.
pub(super) const TOGETHER: usize = 4;

/// Why a value is not read from the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NotRead {
    Given,
    Otherwise,
}

impl NotRead {
    pub fn is_given(self) -> bool {
        self == NotRead::Given
    }
}

/// The construction as it replays, with all that candidates for mistakes ask of it.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub drafting: Drafting,
    /// By entry.
    pub readings: Vec<Result<Reading, NotRead>>,
    pub scales: SheetScales,
    /// What comes out without any error.
    pub exact: Values,
    /// By act: the number of its step.
    pub steps: Vec<usize>,
    /// By number: the act that makes it.
    pub makers: Vec<Option<usize>>,
    /// By number: whether a later act reads it.
    pub used: Vec<bool>,
    /// By number: what it is called.
    pub number_names: Vec<String>,
    /// By place: its sheet and its first name.
    pub place_names: Vec<Option<(Sheet, String)>>,
    /// By place: the act that makes it.
    pub place_makers: Vec<usize>,
    /// Numbers that are computed for vectors, with their sheets.
    pub sizes: Vec<(NumberId, Sheet)>,
    /// Ways in which the joints may be off together, links keeping their shapes: along x and y of each plotted place, in the order of the acts.
    pub together: Vec<Vec<f64>>,
}

/// What goes otherwise than it should at an act, in a mistake.
#[derive(Clone, Debug)]
pub(super) enum Put {
    /// This is done instead.
    Act(Act),
    /// The number comes out so many times as large.
    Times(NumberId, f64),
}

impl Put {
    /// It as a change of a replay.
    pub fn change(&self) -> Change<'_> {
        match self {
            Put::Act(act) => Change::Instead(act),
            Put::Times(number, factor) => Change::Times(*number, *factor),
        }
    }
}

/// Changes of the replay, in the order of the acts.
pub(super) type Changes<'c> = SmallVec<[Disturbance<'c>; 4]>;

impl Model {
    /// The construction of a position at the student's scales.
    pub fn new(
        key: &AnswerKey<'_>,
        solution: &Solution,
        mu: [Option<f64>; 3],
        entries: &[Entry],
    ) -> Result<Model, CheckError> {
        let asked: Vec<Asked> = entries.iter().map(|e| e.asked.clone()).collect();
        let (mut drafting, readings) = drafting_with(solution, &asked);
        given_first(&mut drafting.acts);
        let readings = readings.into_iter().map(|reading| {
            reading.map_err(|why| match why {
                Unread::Given => NotRead::Given,
                _ => NotRead::Otherwise,
            })
        });
        let usual = [key.scales.length, key.scales.velocity, key.scales.acceleration];
        let mut per_mm = [1.0; 3];
        for (sheet, scale) in per_mm.iter_mut().enumerate() {
            *scale = mu[sheet].or(usual[sheet]).ok_or_else(|| {
                let name = ["mu_l", "mu_v", "mu_a"][sheet];
                CheckError::new(
                    format!("the scene's figure has no {}, so its scale is missing", Sheet::ALL[sheet].name()),
                    format!("add {name} to the values, or the panel to the scene's figure"),
                )
            })?;
        }
        let scales = SheetScales { per_mm };
        let exact = drafting.replay(scales, &[]);
        let mut model = Model {
            readings: readings.collect(),
            scales,
            exact,
            steps: Vec::new(),
            makers: Vec::new(),
            used: Vec::new(),
            number_names: Vec::new(),
            place_names: Vec::new(),
            place_makers: Vec::new(),
            sizes: Vec::new(),
            together: Vec::new(),
            drafting,
        };
        model.look_around(&solution.construction);
        model.together = ways_together(&model, &solution.mechanism);
        Ok(model)
    }

    /// The bands of the entries that are read.
    pub fn bands(&self, tolerance: &Tolerance) -> Vec<Option<Band>> {
        let there: Vec<Reading> = self.readings.iter().flatten().copied().collect();
        let mut bands = self.drafting.bands(self.scales, tolerance, &there).into_iter();
        let bands = self.readings.iter().map(|reading| {
            let band = reading.ok().and_then(|_| bands.next())?;
            (band.value.is_finite() && band.band.is_finite()).then_some(band)
        });
        bands.collect()
    }

    /// Finds what acts make and read.
    fn look_around(&mut self, construction: &Construction) {
        let acts = &self.drafting.acts;
        let mut places: Vec<usize> = Vec::new();
        let note = |list: &mut Vec<Option<usize>>, id: usize, act: usize| {
            if list.len() <= id {
                list.resize(id + 1, None);
            }
            list[id] = Some(act);
        };
        for (index, act) in acts.iter().enumerate() {
            for number in numbers_made(&act.deed) {
                note(&mut self.makers, number.0, index);
            }
            if let Some(place) = place_made(&act.deed) {
                if places.len() <= place.0 {
                    places.resize(place.0 + 1, 0);
                }
                places[place.0] = index;
            }
        }
        self.place_makers = places;
        self.used = vec![false; self.makers.len()];
        self.number_names = vec![String::new(); self.makers.len()];
        for act in acts {
            for number in numbers_read(&act.deed) {
                self.used[number.0] = true;
            }
            if let Deed::Solve { .. } = act.deed {
                for name in act.makes.split(", ") {
                    if let Some(number) = self.drafting.number(name) {
                        self.number_names[number.0] = name.to_owned();
                    }
                }
            } else {
                for number in numbers_made(&act.deed) {
                    self.number_names[number.0] = act.makes.clone();
                }
            }
        }
        self.place_names = vec![None; self.place_makers.len()];
        let mut all_names: Vec<Vec<String>> = vec![Vec::new(); self.place_makers.len()];
        for (sheet, name, place) in self.drafting.named_places() {
            all_names[place.0].push(name.to_owned());
            self.place_names[place.0].get_or_insert((sheet, name.to_owned()));
        }
        let steps = numbered_steps(construction);
        let mut before = 0;
        for act in acts {
            let made = place_made(&act.deed).map_or(&[][..], |p| &all_names[p.0]);
            before = step_of(act, &steps, made, before);
            self.steps.push(before);
        }
        // What is computed for a vector belongs to the step that lays it off.
        for index in (0..acts.len()).rev() {
            if let Deed::LayOff { size, .. } = acts[index].deed
                && let Some(maker) = self.makers[size.0]
                && matches!(acts[maker].deed, Deed::Compute { .. })
            {
                self.steps[maker] = self.steps[index];
                self.sizes.push((size, acts[maker].sheet));
            }
        }
    }

    /// All numbers that the entries read, after a replay with changes; NaN where an entry reads nothing.
    pub fn read(&self, values: &Values) -> Vec<f64> {
        let readings = self.readings.iter();
        let read = readings.map(|r| r.as_ref().map_or(f64::NAN, |r| values.number(r.number)));
        read.collect()
    }

    /// A replay with changes.
    pub fn replay(&self, changes: &[Disturbance<'_>]) -> Values {
        let mut values = self.exact.clone();
        let first = changes.first().map_or(self.drafting.acts.len(), |c| c.act);
        self.drafting.replay_from(first, &mut values, self.scales, changes);
        values
    }

    /// A replay of what follows an act, on values that hold everything before it.
    pub fn replay_after(
        &self,
        values: &mut Values,
        before: &Values,
        act: usize,
        own: Change<'_>,
        changes: &[Disturbance<'_>],
    ) {
        values.clone_from(before);
        let start = changes.partition_point(|c| c.act < act);
        let end = changes.partition_point(|c| c.act <= act);
        let mut all: Changes<'_> = SmallVec::new();
        all.extend(changes[start..end].iter().cloned());
        all.push(Disturbance { act, change: own });
        all.extend(changes[end..].iter().cloned());
        self.drafting.replay_from(act, values, self.scales, &all);
    }

    /// All elementary errors: act, which of its errors, limit in mm or degrees, group.
    pub fn errors(&self, tolerance: &Tolerance) -> Vec<(usize, usize, f64, usize)> {
        let acts = self.drafting.acts.iter().enumerate();
        let errors = acts.flat_map(|(index, act)| {
            let group = match (act.sheet, &act.deed) {
                (Sheet::Scheme, Deed::Plot { .. }) => 0,
                (Sheet::Scheme, _) => 1,
                (Sheet::Velocity, _) => 2,
                (Sheet::Acceleration, _) => 3,
            };
            let errors = act.deed.errors().iter().enumerate();
            errors.map(move |(which, e)| (index, which, e.limit(tolerance), group))
        });
        errors.collect()
    }

    /// What a place is called.
    pub fn place_name(&self, place: PlaceId) -> &str {
        let name = self.place_names[place.0].as_ref();
        name.map_or("", |(_, name)| name.as_str())
    }

    /// The named places of a sheet that are there before an act, in the order in which they are made.
    pub fn places_before(&self, sheet: Sheet, act: usize) -> Vec<PlaceId> {
        let all = self.place_names.iter().enumerate();
        let here = all.filter(|(_, name)| name.as_ref().is_some_and(|n| n.0 == sheet && !n.1.is_empty()));
        let ids = here.map(|(id, _)| PlaceId(id));
        ids.filter(|p| self.place_makers[p.0] < act).collect()
    }
}

/// Moves what reads nothing to the front, and lines through joints behind it, so that mistakes may use them anywhere.
fn given_first(acts: &mut [Act]) {
    let plotted = |acts: &[Act]| -> Vec<PlaceId> {
        let plots = acts.iter().filter_map(|act| match act.deed {
            Deed::Plot { place, .. } => Some(place),
            _ => None,
        });
        plots.collect()
    };
    let plotted = plotted(acts);
    acts.sort_by_key(|act| match &act.deed {
        Deed::Pole { .. } | Deed::Plot { .. } | Deed::Take { .. } => 0,
        Deed::Join { from, towards, .. } if plotted.contains(from) && plotted.contains(towards) => 1,
        Deed::Draw { through, reference: Reference::Given(_), .. } if plotted.contains(through) => 1,
        _ => 2,
    });
}

pub(super) fn numbers_made(deed: &Deed) -> SmallVec<[NumberId; 4]> {
    match deed {
        Deed::Measure { number, .. } | Deed::Take { number, .. } | Deed::Compute { number, .. } => {
            SmallVec::from_slice(&[*number])
        }
        Deed::Solve { unknowns, .. } => SmallVec::from_slice(unknowns),
        _ => SmallVec::new(),
    }
}

fn numbers_read(deed: &Deed) -> Vec<NumberId> {
    match deed {
        Deed::Compute { sum, .. } => sum.iter().flat_map(|p| p.of.iter().copied()).collect(),
        Deed::Solve { equations, .. } => {
            let left = equations.iter().flat_map(|e| e.left.iter().map(|(_, p)| p));
            let right = equations.iter().flat_map(|e| &e.right);
            left.chain(right).flat_map(|p| p.of.iter().copied()).collect()
        }
        Deed::LayOff { size, .. } => vec![*size],
        _ => Vec::new(),
    }
}

pub(super) fn place_made(deed: &Deed) -> Option<PlaceId> {
    match deed {
        Deed::Pole { place, .. }
        | Deed::Plot { place, .. }
        | Deed::Cross { place, .. }
        | Deed::LayOff { place, .. } => Some(*place),
        _ => None,
    }
}

/// The line that an act draws.
pub(super) fn line_made(deed: &Deed) -> Option<LineId> {
    match deed {
        Deed::Join { line, .. } | Deed::Draw { line, .. } => Some(*line),
        _ => None,
    }
}
