//! What a hand takes from the mechanism: its joints on a sheet, the lines through them, guides, lengths.

use super::number::{End, NumberId, NumberKind};
use super::operation::{Along, LineId, MeasuredAs, OperationKind, OperationRole, PlaceId};
use super::writer::Writer;
use crate::geometry::{Ball, Number, Pair, cross};
use crate::mechanism::{Guide, PointId, SliderId};
use crate::motion::guide_error;
use crate::sheet::Sheet;

impl Writer<'_> {
    /// A joint on the scheme.
    pub(crate) fn plot(&mut self, point: PointId) -> PlaceId {
        self.plot_on(Sheet::Scheme, point)
    }

    /// A joint on a sheet that shows the mechanism.
    pub(crate) fn plot_on(&mut self, sheet: Sheet, point: PointId) -> PlaceId {
        let name = self.mechanism.point_name(point);
        if let Some(place) = self.construction.place(sheet, name) {
            return place;
        }
        let place = self.next_place();
        let at = self.pose.point(point) - self.construction.origin;
        self.push(sheet, OperationRole::Joint(point), OperationKind::Plot { place, at });
        let exact = Pair::between(self.construction.origin, self.pose.point(point));
        self.construction.record.exact.places[place.0] = exact;
        self.name_place(sheet, name, place);
        place
    }

    /// A place of the scheme that is no joint, with the bound of its error.
    pub(super) fn plot_place(&mut self, role: OperationRole, at: Pair<Ball>) -> PlaceId {
        self.plot_exact(Sheet::Scheme, role, at - Pair::within(self.construction.origin.coords, 0.0))
    }

    /// A place of a sheet, in its units, with the bound of its error.
    pub(super) fn plot_exact(&mut self, sheet: Sheet, role: OperationRole, exact: Pair<Ball>) -> PlaceId {
        let place = self.next_place();
        self.push(sheet, role, OperationKind::Plot { place, at: exact.rounded() });
        self.construction.record.exact.places[place.0] = exact;
        place
    }

    /// The line through two joints, from the first towards the second.
    pub(crate) fn join(&mut self, from: PointId, towards: PointId) -> LineId {
        let (from, towards) = (self.plot(from), self.plot(towards));
        self.join_places(Sheet::Scheme, OperationRole::Line, [from, towards])
    }

    /// The distance of two joints: given where both belong to one body, else measured.
    pub(super) fn length(&mut self, a: PointId, b: PointId) -> NumberId {
        let known = &self.construction.record.lengths;
        if let Some(number) = known.get(&[a, b]).or_else(|| known.get(&[b, a])) {
            return *number;
        }
        let bodies = self.holders[a.0].iter().map(|&body| self.mechanism.body(body));
        let given = bodies.into_iter().any(|body| body.local_of(a).and(body.local_of(b)).is_some());
        let kind = NumberKind::Length([End::Joint(a), End::Joint(b)]);
        let number = if given {
            let value = self.pose.arm(a, b).norm();
            let number = self.new_number(kind);
            self.push(Sheet::Scheme, OperationRole::Number, OperationKind::Take { number, value });
            let arm = Pair::between(self.pose.point(a), self.pose.point(b));
            self.construction.record.exact.numbers[number.0] = arm.dot(arm).sqrt();
            number
        } else {
            let line = self.join(a, b);
            let ends = [self.plot(a), self.plot(b)];
            self.measure(Sheet::Scheme, kind, ends, MeasuredAs::Along(line))
        };
        self.construction.record.lengths.insert([a, b], number);
        number
    }

    /// A slider's guide on the scheme.
    pub(crate) fn guide(&mut self, id: SliderId) -> LineId {
        self.guide_on(Sheet::Scheme, id)
    }

    /// A slider's guide on a sheet that shows the mechanism.
    pub(super) fn guide_on(&mut self, sheet: Sheet, id: SliderId) -> LineId {
        if let Some(line) = self.construction.record.guides.get(&(sheet, id)) {
            return *line;
        }
        let direction = self.pose.guide(id);
        let line = match self.points_of_guide(id) {
            Some(ends) => {
                let ends = ends.map(|point| self.plot_on(sheet, point));
                self.join_places(sheet, OperationRole::Guide(id), ends)
            }
            None => {
                let at = self.plot_on(sheet, self.mechanism.slider(id).at);
                self.draw(sheet, OperationRole::Guide(id), at, Along::given(direction))
            }
        };
        // The scene gives the direction itself; a join of rounded joints would be less exact.
        let error = guide_error(direction);
        self.construction.record.exact.lines[line.0].1 = Pair::within(direction, error);
        self.construction.record.guides.insert((sheet, id), line);
        line
    }

    /// The two points of the guide on its body that are farthest apart, in the guide's direction; `None` without two
    /// distinct points.
    fn points_of_guide(&self, id: SliderId) -> Option<[PointId; 2]> {
        let slider = self.mechanism.slider(id);
        let (u, at) = (self.pose.guide(id), self.pose.point(slider.at));
        let along = |p: PointId| (self.pose.point(p) - at).dot(&u);
        let candidates = match slider.guide {
            Guide::DrawnBetween(p, q) => vec![p, q],
            Guide::Drawn(_) => Vec::new(),
            Guide::Local { .. } => {
                let on_it = |p: &PointId| cross(self.pose.point(*p) - at, u).abs() <= self.near;
                self.mechanism.body(slider.on).points.iter().copied().filter(on_it).collect()
            }
        };
        let by_place = |a: &&PointId, b: &&PointId| along(**a).total_cmp(&along(**b));
        let first = *candidates.iter().min_by(by_place)?;
        let last = *candidates.iter().max_by(by_place)?;
        (along(last) - along(first) > self.near).then_some([first, last])
    }
}
