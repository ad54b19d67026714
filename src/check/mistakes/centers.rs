//! Mistakes with instant centres: lines through the wrong places, wrong crossings.

use super::beside::measured_there;
use super::rays::sides;
use super::routes;
use super::site::{Candidate, Site, instead};
use super::told::{Blank, Told, tell};
use crate::centers::LinkPair;
use crate::construction::{
    Along, Center, CenterId, CenterOrigin, Centers, Disturbance, FigureOf, LineId, OperationKind, OperationRole,
    PlaceId, Spot,
};
use crate::geometry::{Vector, cross, unit};
use crate::mechanism::{GROUND, SliderId};
use crate::sheet::Sheet;
use std::collections::BTreeSet;

/// Two places nearer than this are one to a hand, in mm: nobody marks a new centre on an old one.
pub(super) const ONE: f64 = 3.0;

/// Farthest wrong crossing, in sizes of what is drawn.
const REACH: f64 = 2.5;

/// Smallest sine of the angle of wrong lines that somebody crosses.
const SINE: f64 = 0.1;

/// Where two lines are crossed to an instant centre.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    pub operation: usize,
    pub id: CenterId,
    pub place: PlaceId,
    pub lines: [LineId; 2],
}

/// The instant centres of a construction in which mistakes are looked for.
pub(super) struct Drawn<'s> {
    pub site: &'s Site<'s>,
    pub all: &'s Centers,
    pub crossings: Vec<Crossing>,
}

impl<'s> Drawn<'s> {
    /// None where the figure has no centres.
    fn of(site: &'s Site<'_>) -> Option<Drawn<'s>> {
        let all = site.model.construction.centers.as_deref()?;
        let crossings = site.operations().filter_map(|(operation, done)| match (done.role, &done.kind) {
            (OperationRole::Center(id), &OperationKind::Cross { place, lines }) => {
                Some(Crossing { operation, id, place, lines })
            }
            _ => None,
        });
        Some(Drawn { site, all, crossings: crossings.collect() })
    }

    /// A centre by its name; of one without a link that of the centre that it leads to.
    pub(super) fn center(&self, id: CenterId) -> Blank {
        Blank::Quantity(self.all.get(id).pair.name(&self.site.key.solution.mechanism))
    }

    /// A line by the centres through which it is drawn.
    fn line(&self, line: LineId) -> Blank {
        let own = self.all.all.iter().flat_map(Center::lines).find(|own| own.line == Some(line));
        if let Some(own) = own {
            return self.line_through(own.through.map(|id| self.all.get(id).pair));
        }
        match self.site.drawing_of(line).map(|(_, operation)| (operation.role, &operation.kind)) {
            Some((OperationRole::Guide(slider), _)) => self.guide(slider),
            Some((_, OperationKind::Join { from, towards, .. })) => {
                Blank::Words([*from, *towards].map(|end| self.site.place_name(end)).join(" "))
            }
            _ => Blank::Words(String::new()),
        }
    }

    /// A line by the centres of two pairs of links.
    pub(super) fn line_through(&self, pairs: [LinkPair; 2]) -> Blank {
        let mechanism = &self.site.key.solution.mechanism;
        let notation = &self.site.key.solution.wording().notation;
        let symbol = |pair: LinkPair| pair.symbol(0, mechanism, notation, &str::to_owned).replace(['{', '}'], "");
        Blank::Words(pairs.map(symbol).join(" "))
    }

    fn guide(&self, slider: SliderId) -> Blank {
        let solution = self.site.key.solution;
        Blank::Guide(solution.mechanism.slider_in_words(slider, &solution.wording()))
    }

    pub(super) fn at(&self, place: PlaceId) -> Vector {
        self.site.model.exact.place(place)
    }

    /// Millimetres of paper in units of the sheet.
    pub(super) fn mm(&self, mm: f64) -> f64 {
        mm * self.site.model.scales[Sheet::Centers]
    }

    /// Whether somebody may take a point for a new centre: it is on the sheet, and no place that has a name already.
    pub(super) fn is_free(&self, at: Vector, operation: usize) -> bool {
        let places = self.site.model.places_before(Sheet::Centers, operation);
        let places = || places.iter().map(|place| self.at(*place)).filter(|place| place.norm().is_finite());
        let size = places().map(|place| place.norm()).fold(0.0, f64::max);
        at.norm() <= REACH * size && places().all(|place| (place - at).norm() > self.mm(ONE))
    }

    /// The lines of the sheet that are drawn before an operation.
    fn lines_before(&self, operation: usize) -> impl Iterator<Item = LineId> {
        let before = self.site.operations().take(operation).filter(|(_, done)| done.sheet == Sheet::Centers);
        before.filter_map(|(_, done)| done.kind.line())
    }

    /// Where two lines cross, at an angle at which somebody crosses them.
    fn meeting(&self, lines: [LineId; 2]) -> Option<Vector> {
        meeting(lines.map(|line| self.site.model.exact.line(line)))
    }

    /// The guides' centres: each with the direction towards it.
    fn of_guides(&self) -> impl Iterator<Item = (CenterId, SliderId, Along)> {
        self.all.all.iter().enumerate().filter_map(|(index, center)| match (&center.origin, center.spot) {
            (CenterOrigin::Guide(slider), Spot::Towards(along)) => Some((CenterId(index), *slider, along)),
            _ => None,
        })
    }

    /// The lines that are drawn in a direction: operation, line, a place of it.
    fn drawn_along(&self, along: Along) -> impl Iterator<Item = (usize, LineId, PlaceId)> {
        self.site.operations().filter_map(move |(index, done)| match done.kind {
            OperationKind::Draw { line, through, along: own } if own == along => Some((index, line, through)),
            _ => None,
        })
    }

    /// Whether a centre is a pin of three links or more.
    pub(super) fn is_one_of_three(&self, id: CenterId) -> bool {
        let origin = &self.all.get(id).origin;
        let same = || self.all.all.iter().filter(|other| other.origin == *origin).count();
        matches!(origin, CenterOrigin::Pin(_)) && same() >= 3
    }

    /// Several changes as one mistake, at the step of the first of them.
    fn together(&self, told: Told, edits: Vec<Disturbance>) -> Option<Candidate> {
        let first = edits.iter().map(|edit| edit.operation).min()?;
        let step = self.site.model.steps[first];
        Some(Candidate { edits, ..Candidate::at(told, step) })
    }
}

/// Where two lines cross, each given by a place and its direction, at an angle at which somebody crosses them.
fn meeting([(a, u), (b, v)]: [(Vector, Vector); 2]) -> Option<Vector> {
    let sine = cross(u, v);
    (sine.abs() > SINE).then(|| a + u * (cross(b - a, v) / sine))
}

/// The candidates that a function finds where the figure has centres.
pub(super) fn found(site: &Site<'_>, find: impl Fn(&Drawn<'_>) -> Vec<Candidate>) -> Vec<Candidate> {
    Drawn::of(site).map_or_else(Vec::new, |drawn| find(&drawn))
}

/// The centre of a guide sought along the guide in place of normal to it.
pub(super) fn along_guide(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let along = drawn.of_guides().filter_map(|(id, slider, along)| {
            let kind =
                |(index, line, through)| instead(index, OperationKind::Draw { line, through, along: along.turned(1) });
            let edits = drawn.drawn_along(along).map(kind).collect();
            drawn.together(tell::center_along_guide(drawn.center(id), drawn.guide(slider)), edits)
        });
        along.collect()
    })
}

/// The centre of a guide taken in the pin of its block.
pub(super) fn at_slider(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let solution = site.key.solution;
        let at = drawn.of_guides().filter_map(|(id, slider, along)| {
            let name = solution.mechanism.point_name(solution.mechanism.slider(slider).at);
            let pin = site.model.construction.place(Sheet::Centers, name)?;
            let maker = site.model.place_makers[pin.0]?;
            let is_apart = |place: PlaceId| (drawn.at(place) - drawn.at(pin)).norm() > drawn.mm(ONE);
            let lines = drawn.drawn_along(along).filter(|(index, _, through)| maker < *index && is_apart(*through));
            let edits = lines.map(|(index, line, through)| {
                instead(index, OperationKind::Join { line, from: through, towards: pin })
            });
            drawn.together(tell::center_at_slider(drawn.center(id), name.into(), drawn.guide(slider)), edits.collect())
        });
        at.collect()
    })
}

/// A centre marked where other lines cross: one of its lines with one that is not its own, or the lines of another centre.
pub(super) fn other_lines(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for crossing in &drawn.crossings {
            all.extend(with_one_line(drawn, crossing));
        }
        for (index, first) in drawn.crossings.iter().enumerate() {
            for second in &drawn.crossings[index + 1..] {
                all.extend(swapped(drawn, [first, second]));
            }
        }
        all
    })
}

fn with_one_line(drawn: &Drawn<'_>, crossing: &Crossing) -> Vec<Candidate> {
    let &Crossing { operation, id, place, lines } = crossing;
    let mut all = Vec::new();
    let others: Vec<LineId> = drawn.lines_before(operation).filter(|line| !lines.contains(line)).collect();
    for side in 0..2 {
        for &wrong in &others {
            let taken = [lines[1 - side], wrong];
            if drawn.meeting(taken).is_some_and(|at| drawn.is_free(at, operation)) {
                let told = tell::line_without_common_link(drawn.center(id), drawn.line(wrong), drawn.line(lines[side]));
                let edit = instead(operation, OperationKind::Cross { place, lines: taken });
                all.extend(drawn.marked(drawn.site.candidate(told, edit), place));
            }
        }
    }
    all
}

/// A centre at the place of another one, and both at each other's.
fn swapped(drawn: &Drawn<'_>, [first, second]: [&Crossing; 2]) -> Vec<Candidate> {
    let is_own = |crossing: &Crossing| drawn.all.get(crossing.id).figure == FigureOf::Mechanism;
    if !is_own(first) || !is_own(second) {
        return Vec::new();
    }
    let before: BTreeSet<usize> = drawn.lines_before(first.operation).map(|line| line.0).collect();
    let taken = |crossing: &Crossing, lines: [LineId; 2]| {
        instead(crossing.operation, OperationKind::Cross { place: crossing.place, lines })
    };
    let mut all = Vec::new();
    let [a, b] = [first, second].map(|crossing| drawn.center(crossing.id));
    let later = taken(second, first.lines);
    if second.lines.iter().all(|line| before.contains(&line.0)) {
        let earlier = taken(first, second.lines);
        let both = vec![earlier.clone(), later.clone()];
        let both = drawn.together(tell::centers_swapped(a.clone(), b.clone()), both);
        let model = drawn.site.model;
        let first_measured = both.into_iter().flat_map(|both| measured_there(model, both, first.place));
        all.extend(first_measured.flat_map(|both| measured_there(model, both, second.place)));
        let alone = drawn.site.candidate(tell::center_of_other_lines(a.clone(), b.clone()), earlier);
        all.extend(drawn.marked(alone, first.place));
    }
    let alone = drawn.site.candidate(tell::center_of_other_lines(b, a), later);
    all.extend(drawn.marked(alone, second.place));
    all
}

/// A pair of links in a pin of three or more not taken for a centre: lines through it are drawn through a crossing elsewhere.
pub(super) fn pin_of_three(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for (index, center) in drawn.all.all.iter().enumerate() {
            let (CenterOrigin::Pin(point), Spot::At(pin)) = (&center.origin, center.spot) else { continue };
            if !drawn.is_one_of_three(CenterId(index)) {
                continue;
            }
            let name = site.key.solution.mechanism.point_name(*point);
            for wrong in wrong_places(drawn, CenterId(index)) {
                let told = tell::pin_of_three(drawn.center(CenterId(index)), name.into());
                all.extend(drawn.together(told, through_elsewhere(drawn, CenterId(index), pin, wrong)));
            }
        }
        all.extend(routes::beside_pin_of_three(drawn));
        all
    })
}

/// The lines through a centre, each with the operation that draws it and the place of its other centre.
fn lines_through(drawn: &Drawn<'_>, id: CenterId, pin: PlaceId) -> Vec<(usize, LineId, PlaceId)> {
    let own = drawn.all.all.iter().flat_map(Center::lines).filter(|line| line.through.contains(&id));
    let mut found: Vec<(usize, LineId, PlaceId)> = Vec::new();
    for line in own.filter_map(|line| line.line) {
        let Some((index, operation)) = drawn.site.drawing_of(line) else { continue };
        if let OperationKind::Join { from, towards, .. } = operation.kind
            && found.iter().all(|(known, ..)| *known != index)
        {
            found.push((index, line, if from == pin { towards } else { from }));
        }
    }
    found
}

/// Crossings of the first lines of a sheet that are no centres: where somebody may seek one that is there already.
fn wrong_places(drawn: &Drawn<'_>, id: CenterId) -> Vec<Vector> {
    let Spot::At(pin) = drawn.all.get(id).spot else { return Vec::new() };
    let used = lines_through(drawn, id, pin);
    let operations = drawn.site.model.construction.operations.len();
    let first =
        drawn.crossings.iter().find(|crossing| crossing.lines.iter().any(|line| used.iter().any(|u| u.1 == *line)));
    let before = drawn.lines_before(first.map_or(operations, |crossing| crossing.operation));
    let lines = before.map(|line| drawn.site.model.exact.line(line));
    let lines: Vec<_> = lines.chain(sides(drawn.site).into_iter().map(|(_, side)| side)).chain(frame(drawn)).collect();
    let mut found: Vec<Vector> = Vec::new();
    for (index, &a) in lines.iter().enumerate() {
        for &b in &lines[index + 1..] {
            if let Some(at) = meeting([a, b])
                && drawn.is_free(at, operations)
                && found.iter().all(|other| (other - at).norm() > drawn.mm(ONE))
            {
                found.push(at);
            }
        }
    }
    found
}

/// The lines through two pins of the frame.
fn frame(drawn: &Drawn<'_>) -> Vec<(Vector, Vector)> {
    let solution = drawn.site.key.solution;
    let pins = &solution.mechanism.body(GROUND).points;
    let place = |point| solution.pose.point(point) - drawn.site.model.construction.origin;
    let pairs = pins.iter().enumerate().flat_map(|(index, &a)| pins[index + 1..].iter().map(move |&b| (a, b)));
    pairs.filter_map(|(a, b)| Some((place(a), unit(place(b) - place(a))?))).collect()
}

/// The lines through a centre drawn through another place.
fn through_elsewhere(drawn: &Drawn<'_>, id: CenterId, pin: PlaceId, wrong: Vector) -> Vec<Disturbance> {
    let lines = lines_through(drawn, id, pin).into_iter();
    let edit = |(index, line, other): (usize, LineId, PlaceId)| {
        let along = Along::given(unit(wrong - drawn.at(other))?);
        Some(instead(index, OperationKind::Draw { line, through: other, along }))
    };
    lines.filter_map(edit).collect()
}
