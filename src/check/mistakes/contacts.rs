//! Mistakes with profiles that touch, as those of a cam and its follower: with the centres and radii of curvature of the equivalent linkage, and with the velocity along
//! the common tangent.

use super::beside::measured_there;
use super::lengths::in_pose;
use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::construction::{
    Along, Disturbance, LineId, OperationKind, OperationRole, PlaceId, Reference, Ruled, RuledEnd,
};
use crate::geometry::{Vector, quarter_turn, unit};
use crate::mechanism::{BodyId, Contact, GROUND, PointId, Touch};
use crate::position::pose;
use crate::scene::GivenBy;
use crate::sheet::{Order, Sheet};

/// Directions nearer than this sine are one to a hand.
const ONE: f64 = 0.05;

impl Site<'_> {
    fn contacts(&self) -> impl Iterator<Item = &Contact> {
        self.key.solution.mechanism.contacts.iter()
    }

    fn body_name(&self, body: BodyId) -> Blank {
        let solution = self.key.solution;
        match body {
            GROUND => solution.wording().ground().into(),
            link => solution.mechanism.body(link).name.as_str().into(),
        }
    }

    fn point_name(&self, point: PointId) -> &str {
        self.key.solution.mechanism.point_name(point)
    }

    /// Where a joint is plotted on the scheme.
    fn plotted(&self, point: PointId) -> Option<PlaceId> {
        let mut plots = self.operations().filter(|(_, operation)| operation.sheet == Sheet::Scheme);
        plots.find_map(|(_, operation)| match (operation.role, &operation.kind) {
            (OperationRole::Joint(own), OperationKind::Plot { place, .. }) if own == point => Some(*place),
            _ => None,
        })
    }

    /// The lines of the scheme through two points.
    fn joined(&self, ends: [PlaceId; 2]) -> Vec<(usize, LineId)> {
        let lines = self.operations().filter_map(|(index, operation)| match operation.kind {
            OperationKind::Join { line, from, towards } if ends == [from, towards] || ends == [towards, from] => {
                Some((index, line))
            }
            _ => None,
        });
        lines.collect()
    }
}

/// The distance of two centres of curvature taken as one of the radii: in computations, or the mechanism drawn so.
pub(super) fn radius_left_out(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let mut all = Vec::new();
    for contact in site.contacts() {
        let Touch::Arcs { link, centers, radii: Some(radii) } = contact.touch else { continue };
        let number = site.model.construction.length_of(centers);
        let maker = number.and_then(|number| Some((site.model.makers[number.0]?, number)));
        for side in 0..2 {
            let ratio = (radii[side] / (radii[0] + radii[1])).abs();
            let length = match number {
                Some(number) => site.symbol(number),
                None => Blank::Symbol(format!("L({},{})", site.point_name(centers[0]), site.point_name(centers[1]))),
            };
            let told = tell::radius_left_out(length, site.body_name(contact.bodies[side]));
            if let Some((maker, number)) = maker {
                let first = site.operations().find(|(_, operation)| {
                    let mut reads = false;
                    operation.kind.each_number_read(|other| reads |= other == number);
                    reads
                });
                let step = site.model.steps[first.map_or(maker, |(index, _)| index)];
                all.push(Candidate { step, ..site.candidate(told.clone(), times(maker, number, ratio)) });
            }
            if solution.mechanism.given_by == GivenBy::Drawing || solution.mechanism.placing.is_some() {
                continue;
            }
            let mut mechanism = solution.mechanism.clone();
            mechanism.bodies[link.0].local.iter_mut().for_each(|at| *at *= ratio);
            if let Ok(pose) = pose(&mechanism, &solution.scene.near) {
                let mut edits = in_pose(site, &pose);
                edits.extend(
                    maker.filter(|(_, number)| site.is_given(*number)).map(|(op, number)| times(op, number, ratio)),
                );
                all.push(Candidate { edits, ..Candidate::at(told, 0) });
            }
        }
    }
    all
}

/// The common normal drawn from another point of a body than its centre of curvature, with the right length or that from there.
pub(super) fn wrong_center(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let mut all = Vec::new();
    for contact in site.contacts() {
        let Touch::Arcs { centers, .. } = contact.touch else { continue };
        let [Some(from), Some(to)] = centers.map(|center| site.plotted(center)) else { continue };
        let names = contact.bodies.map(|body| site.body_name(body));
        for side in 0..2 {
            let kept = [from, to][1 - side];
            let own = &solution.mechanism.body(contact.bodies[side]).points;
            for wrong in own.iter().filter(|point| !centers.contains(point)) {
                let Some(place) = site.plotted(*wrong).filter(|place| *place != kept) else { continue };
                let told = tell::wrong_center_of_curvature(
                    site.point_name(*wrong).into(),
                    site.point_name(centers[side]).into(),
                    names[0].clone(),
                    names[1].clone(),
                );
                let lines = site.joined([from, to]).into_iter().filter_map(|(index, line)| {
                    let OperationKind::Join { from: first, .. } = site.operation(index).kind else { return None };
                    let ends = if first == kept { [kept, place] } else { [place, kept] };
                    Some(instead(index, OperationKind::Join { line, from: ends[0], towards: ends[1] }))
                });
                let edits: Vec<_> = lines.collect();
                let Some(step) = edits.iter().filter_map(|edit| first_use(site, edit.operation)).min() else {
                    continue;
                };
                all.push(Candidate { edits: edits.clone(), ..Candidate::at(told.clone(), step) });
                let distance = |a: PlaceId, b: PlaceId| (site.model.exact.place(a) - site.model.exact.place(b)).norm();
                let ratio = distance(place, kept) / distance(from, to);
                let number = site.model.construction.length_of(centers);
                if let Some((maker, number)) = number.and_then(|own| Some((site.model.makers[own.0]?, own)))
                    && ratio.is_finite()
                {
                    let mut edits = edits;
                    edits.push(times(maker, number, ratio));
                    all.push(Candidate { edits, ..Candidate::at(told, step) });
                }
            }
        }
    }
    all
}

/// The step that first draws along the line of an operation.
fn first_use(site: &Site<'_>, operation: usize) -> Option<usize> {
    let line = site.operation(operation).kind.line()?;
    let uses = |kind: &OperationKind| kind.places_and_lines_read().1.contains(&line);
    let first = site.operations().find(|(_, operation)| operation.sheet != Sheet::Scheme && uses(&operation.kind))?;
    Some(site.model.steps[first.0])
}

/// The lines along which rays of the velocity between two profiles are drawn, with the quarter turns from them.
fn tangents(site: &Site<'_>, contact: &Contact) -> Vec<(LineId, bool)> {
    match contact.touch {
        Touch::Arcs { centers, .. } => {
            let [Some(from), Some(to)] = centers.map(|center| site.plotted(center)) else { return Vec::new() };
            site.joined([from, to]).into_iter().map(|(_, line)| (line, true)).collect()
        }
        Touch::Face { slider, .. } => {
            let guides = site.operations().filter(|(_, operation)| operation.role == OperationRole::Guide(slider));
            guides.filter_map(|(_, operation)| Some((operation.kind.line()?, false))).collect()
        }
    }
}

/// The velocity of one profile along the other left out: both centres, or the pin and its place on the face, have one image.
pub(super) fn sliding_left_out(site: &Site<'_>) -> Vec<Candidate> {
    let mut all = Vec::new();
    for contact in site.contacts() {
        let tangents = tangents(site, contact);
        for (_, operation) in site.operations().filter(|(_, operation)| operation.sheet == Order::Velocity.sheet()) {
            let OperationKind::Draw { line, through, along: Along { reference: Reference::Line(of), quarter_turns } } =
                operation.kind
            else {
                continue;
            };
            if !tangents.contains(&(of, quarter_turns % 2 == 1)) {
                continue;
            }
            let crossing = site.operations().find_map(|(index, operation)| match operation.kind {
                OperationKind::Cross { place, lines } if lines.contains(&line) => Some((index, place, lines)),
                _ => None,
            });
            let Some((index, place, lines)) = crossing else { continue };
            let ruled =
                |x, y| Ruled::Through([RuledEnd::Place(through), RuledEnd::Towards(Along::given(Vector::new(x, y)))]);
            let kind = OperationKind::Meet { place, lines: [ruled(1.0, 0.0), ruled(0.0, 1.0)] };
            let told = tell::sliding_left_out(site.place(place), site.place(through));
            all.extend(measured_there(site.model, site.candidate(told.clone(), instead(index, kind)), place));
            let other = lines.into_iter().find(|other| *other != line);
            all.extend(other.and_then(|other| at_its_speed(site, &told, (index, place), [line, other])));
        }
    }
    all
}

/// The same by somebody who takes the speed alone: the image stands as far out on its other ray, and the segment along the tangent is taken as nothing.
fn at_its_speed(
    site: &Site<'_>,
    told: &Told,
    (index, place): (usize, PlaceId),
    [tangent, other]: [LineId; 2],
) -> Option<Candidate> {
    let through = |line: LineId| match site.drawing_of(line)?.1.kind {
        OperationKind::Draw { through, .. } => Some(through),
        _ => None,
    };
    let at = |place: PlaceId| site.model.exact.place(place);
    let (known, begin) = (through(tangent)?, through(other)?);
    let sense = unit(at(place) - at(begin))?;
    let near = at(begin) + sense * (at(known) - at(begin)).norm();
    let (measured, number, _) = site.measuring_along(tangent)?;
    let kind = OperationKind::OnLine { place, line: Ruled::Line(other), near };
    let edits = vec![instead(index, kind), times(measured, number, 0.0)];
    Some(Candidate { edits, ..Candidate::at(told.clone(), site.model.steps[index]) })
}

/// A flat face taken along or across the line from the centre of curvature to another point of the bodies.
pub(super) fn face_along_wrong_line(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let mut all = Vec::new();
    for contact in site.contacts() {
        let Touch::Face { slider, center, .. } = contact.touch else { continue };
        let Some(from) = site.plotted(center) else { continue };
        let right = solution.pose.guide(slider);
        let points = contact.bodies.iter().flat_map(|body| &solution.mechanism.body(*body).points);
        for &other in points.filter(|point| **point != center) {
            let Some(along) = unit(solution.pose.arm(center, other)) else { continue };
            let line_name = Blank::LineThrough(format!("{}{}", site.point_name(other), site.point_name(center)));
            let link = site.body_name(contact.bodies[1]);
            for (along, told) in [
                (along, tell::face_along_wrong_line(link.clone(), line_name.clone())),
                (quarter_turn(along), tell::face_normal_to_wrong_line(link, line_name)),
            ] {
                // A line has no sense: it is taken as it lies nearest.
                let along = if along.dot(&right) < 0.0 { -along } else { along };
                if along.dot(&quarter_turn(right)).abs() < ONE {
                    continue;
                }
                let joined = site.plotted(other).map(|to| site.joined([from, to])).unwrap_or_default();
                let edits = along_instead(site, contact, along, joined.first().map(|(_, line)| *line));
                let step = edits.iter().map(|edit| site.model.steps[edit.operation]).min();
                if let Some(step) = step {
                    all.push(Candidate { edits, ..Candidate::at(told, step) });
                }
            }
        }
    }
    all
}

/// What is drawn and laid off along a face or across it, along another direction in place of it: that of a line that is there, where it is one.
fn along_instead(site: &Site<'_>, contact: &Contact, along: Vector, line: Option<LineId>) -> Vec<Disturbance> {
    let guides: Vec<LineId> = tangents(site, contact).into_iter().map(|(line, _)| line).collect();
    let taken = |turns: u8| {
        let by_line = line.and_then(|line| {
            let turned =
                (0..4).find(|turns| (site.model.exact.along(&Along::line(line).turned(*turns)) - along).norm() < ONE);
            turned.map(|turns| Along::line(line).turned(turns))
        });
        by_line.unwrap_or(Along::given(along)).turned(turns)
    };
    let edits =
        site.operations().filter(|(_, operation)| operation.sheet != Sheet::Scheme).filter_map(|(index, operation)| {
            let wrong = |own: Along| match own.reference {
                Reference::Line(of) if guides.contains(&of) => Some(taken(own.quarter_turns)),
                _ => None,
            };
            let kind = match operation.kind {
                OperationKind::Draw { line, through, along } => {
                    OperationKind::Draw { line, through, along: wrong(along)? }
                }
                OperationKind::LayOff { place, from, size, along } => {
                    OperationKind::LayOff { place, from, size, along: wrong(along)? }
                }
                _ => return None,
            };
            Some(instead(index, kind))
        });
    edits.collect()
}
