//! Mistakes with instant centres on lines of people's own choice: a centre lies on a line over every third link, and the construction draws
//! two of them.

use super::beside::{measured_there, not_gone_on_with};
use super::centers::{Crossing, Drawn, ONE, found};
use super::site::{Amount, Candidate, Free, Site, instead};
use super::told::{Told, tell};
use crate::centers::{LinkPair, Moved};
use crate::construction::{
    CenterId, CenterOrigin, Disturbance, FigureOf, OperationKind, PlaceId, Ruled, RuledEnd, Spot,
};
use crate::geometry::{Pair, Vector, cross, unit};
use crate::mechanism::BodyId;

/// Part of a segment at its ends where somebody sees a crossing as none of its own.
const END: f64 = 0.01;

/// A line on which a centre lies.
struct Line {
    over: BodyId,
    /// The pairs of links whose centres it runs through, and these.
    pairs: [LinkPair; 2],
    ends: [RuledEnd; 2],
}

impl Drawn<'_> {
    /// The centre of a pair of links as far as it is there before an operation: the place that is marked, else where it is.
    fn end(&self, pair: LinkPair, operation: usize) -> Option<RuledEnd> {
        let model = self.site.model;
        match self.all.of(pair).map(|id| self.all.get(id).spot) {
            Some(Spot::At(place)) if model.place_makers[place.0].is_some_and(|maker| maker < operation) => {
                Some(RuledEnd::Place(place))
            }
            Some(Spot::Towards(along)) => Some(RuledEnd::Towards(along)),
            _ => self.place_by_motion(pair).map(RuledEnd::At),
        }
    }

    /// Where the centre of a pair is by the computed motion; `None` at infinity.
    fn place_by_motion(&self, pair: LinkPair) -> Option<Vector> {
        let solution = self.site.key.solution;
        let origin = self.site.model.construction.origin;
        let [a, b] = pair.links().map(|link| solution.motion.body(link));
        let velocity = b.velocity_at(origin) - a.velocity_at(origin);
        let still = Pair::from(Vector::zeros());
        let moved = Moved {
            at: still,
            velocity: Pair::from(velocity),
            acceleration: still,
            omega: b.omega - a.omega,
            alpha: 0.0,
        };
        let Pair { x, y } = moved.pole();
        let place = Vector::new(x, y);
        (place.norm() * f64::EPSILON.sqrt() < self.mm(1.0)).then_some(place)
    }

    fn place_of(&self, end: RuledEnd) -> Option<Vector> {
        match end {
            RuledEnd::Place(place) => Some(self.at(place)),
            RuledEnd::At(at) => Some(at),
            RuledEnd::Towards(_) => None,
        }
    }

    /// The lines of a centre over all third links, those that are drawn first.
    fn lines_of(&self, crossing: &Crossing) -> Vec<Line> {
        let center = self.all.get(crossing.id);
        let [a, b] = center.pair.links();
        let line = |&over: &BodyId| {
            let pairs = [LinkPair::new(a, over)?, LinkPair::new(b, over)?];
            let [from, towards] = pairs.map(|pair| self.end(pair, crossing.operation));
            let ends = [from?, towards?];
            let is_line = match ends.map(|end| self.place_of(end)) {
                [Some(from), Some(towards)] => (towards - from).norm() > self.mm(ONE),
                [None, None] => false,
                _ => true,
            };
            is_line.then_some(Line { over, pairs, ends })
        };
        let mut lines: Vec<Line> = self.all.links.iter().filter_map(line).collect();
        let drawn = |over: BodyId| center.lines().iter().any(|line| line.over == Some(over));
        lines.sort_by_key(|line| !drawn(line.over));
        lines
    }

    /// A centre marked at a wrong place: as that place is used for further lines, and as it is not.
    pub(super) fn marked(&self, candidate: Candidate, place: PlaceId) -> Vec<Candidate> {
        let model = self.site.model;
        let aside = not_gone_on_with(model, &candidate, place);
        let measured = |candidate| measured_there(model, candidate, place);
        measured(candidate).into_iter().chain(aside.into_iter().flat_map(measured)).collect()
    }

    /// The crossings that lead to centres of the mechanism itself.
    fn own_crossings(&self) -> impl Iterator<Item = &Crossing> {
        self.crossings.iter().filter(|crossing| self.all.get(crossing.id).figure == FigureOf::Mechanism)
    }
}

/// The lines of a centre not drawn far enough: marked where the lines between the same four places cross within these.
pub(super) fn not_extended(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = Vec::new();
        for crossing in drawn.own_crossings() {
            let &Crossing { operation, id, place, .. } = crossing;
            let mut known: Vec<Vector> = Vec::new();
            for [first, second] in pairs_of(&drawn.lines_of(crossing)) {
                let ([a, b], [c, d]) = (first.ends, second.ends);
                for ends in [[[a, c], [b, d]], [[a, d], [b, c]]] {
                    let Some(at) = within(drawn, ends) else { continue };
                    let is_new = known.iter().all(|other| (other - at).norm() > 1e-6 * drawn.mm(ONE));
                    if is_new && drawn.is_free(at, operation) {
                        known.push(at);
                        let [first, second] = [first, second].map(|line| drawn.line_through(line.pairs));
                        let told = tell::not_extended(drawn.center(id), first, second);
                        let edit = instead(operation, OperationKind::Meet { place, lines: ends.map(Ruled::Through) });
                        all.extend(drawn.marked(site.candidate(told, edit), place));
                    }
                }
            }
        }
        all
    })
}

fn pairs_of(lines: &[Line]) -> impl Iterator<Item = [&Line; 2]> {
    lines.iter().enumerate().flat_map(|(index, first)| lines[index + 1..].iter().map(move |second| [first, second]))
}

/// Where two segments cross within both.
fn within(drawn: &Drawn<'_>, [[a, b], [c, d]]: [[RuledEnd; 2]; 2]) -> Option<Vector> {
    let place = |end| drawn.place_of(end);
    let (a, b, c, d) = (place(a)?, place(b)?, place(c)?, place(d)?);
    let (u, v) = (b - a, d - c);
    let area = cross(u, v);
    let (s, t) = (cross(c - a, v) / area, cross(c - a, u) / area);
    let is_within = |part: f64| part > END && part < 1.0 - END;
    (is_within(s) && is_within(t)).then(|| a + u * s)
}

/// Centres on one of their lines, at places to which another line leads that runs past the pin of three links through which it should run: whatever was taken for
/// the pin's centre. One centre is found so, or two after one another.
pub(super) fn beside_pin_of_three(drawn: &Drawn<'_>) -> Vec<Candidate> {
    let mut all = Vec::new();
    for (index, center) in drawn.all.all.iter().enumerate() {
        let (CenterOrigin::Pin(point), true) = (&center.origin, drawn.is_one_of_three(CenterId(index))) else {
            continue;
        };
        let name = drawn.site.key.solution.mechanism.point_name(*point);
        let told = || tell::pin_of_three(drawn.center(CenterId(index)), name.into());
        all.extend(all_lines_elsewhere(drawn, center.spot, told()));
        let alone = past_pin(drawn, center.pair);
        for (at, first) in alone.iter().enumerate() {
            for second in alone[at + 1..].iter().filter(|second| second.operation > first.operation) {
                all.push(first.candidate(drawn, told()).and(second));
            }
            let used = first.candidate(drawn, told());
            all.extend(not_gone_on_with(drawn.site.model, &used, first.place));
            all.push(used);
        }
    }
    all
}

/// All lines through a pin drawn through another place, whatever that is.
fn all_lines_elsewhere(drawn: &Drawn<'_>, spot: Spot, told: Told) -> Option<Candidate> {
    let Spot::At(pin) = spot else { return None };
    let operation = drawn.site.model.place_makers[pin.0]?;
    let range = drawn.at(pin).norm().max(drawn.mm(1.0)) / drawn.mm(1.0);
    let free = |which| Free { operation, what: Amount::Error(which), is_angle: false, range, keeps_sign: false };
    Some(Candidate { free: vec![free(0), free(1)], ..Candidate::at(told, drawn.site.model.steps[operation]) })
}

/// A place on a line that is not known beforehand.
struct OnRight {
    operation: usize,
    place: PlaceId,
    edit: Disturbance,
    free: Free,
}

impl OnRight {
    fn candidate(&self, drawn: &Drawn<'_>, told: Told) -> Candidate {
        let step = drawn.site.model.steps[self.operation];
        Candidate { edits: vec![self.edit.clone()], free: vec![self.free], ..Candidate::at(told, step) }
    }
}

impl Candidate {
    fn and(mut self, further: &OnRight) -> Candidate {
        self.edits.push(further.edit.clone());
        self.free.push(further.free);
        self
    }
}

/// Where centres may be found if one of their other lines runs past the pin of this pair of links: a place on each right line.
fn past_pin(drawn: &Drawn<'_>, missed: LinkPair) -> Vec<OnRight> {
    let mut all = Vec::new();
    for crossing in drawn.own_crossings() {
        let &Crossing { operation, place, .. } = crossing;
        let lines = drawn.lines_of(crossing);
        let is_past = |right: &Line| {
            let mut wrong = lines.iter().filter(|line| line.over != right.over && line.pairs.contains(&missed));
            wrong.any(|wrong| !is_same(drawn, right, wrong))
        };
        let range = drawn.at(place).norm().max(drawn.mm(1.0)) / drawn.mm(1.0);
        for line in lines.iter().filter(|line| is_past(line)) {
            let kind = OperationKind::OnLine { place, line: Ruled::Through(line.ends), near: drawn.at(place) };
            let free = Free { operation, what: Amount::Error(0), is_angle: false, range, keeps_sign: false };
            all.push(OnRight { operation, place, edit: instead(operation, kind), free });
        }
    }
    all
}

/// Whether two lines are one.
fn is_same(drawn: &Drawn<'_>, one: &Line, other: &Line) -> bool {
    let along = |line: &Line| match line.ends {
        [RuledEnd::Towards(along), _] | [_, RuledEnd::Towards(along)] => Some(drawn.site.model.exact.along(&along)),
        [from, towards] => unit(drawn.place_of(towards)? - drawn.place_of(from)?),
    };
    along(one).zip(along(other)).is_none_or(|(one, other)| cross(one, other).abs() < 1e-6)
}
