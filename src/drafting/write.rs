//! A group's construction: special points, rays, crossings, what is measured, and the motions of its points.

use super::act::{Deed, How, LineId, NumberId, PlaceId, Reference, Sheet};
use super::body::Anchor;
use super::equations::Leg;
use super::writer::Writer;
use crate::mechanism::{Carried, Group, JointKind, LoopEquations, SliderId, Spin};
use crate::plan::{PlanKind, Special, coincident_name, image_name, point_on};

/// A special point as it is drawn.
pub(super) struct Drawn<'a> {
    pub special: &'a Special,
    pub legs: [Leg; 2],
    /// Where it is on the scheme.
    pub place: PlaceId,
    /// By leg: the length from its joint to it, where one enters an equation.
    pub reaches: [Option<NumberId>; 2],
}

impl Writer<'_> {
    /// The construction of a group; nothing where the plans have none, or where it hangs on links that have none.
    pub(super) fn group(&mut self, index: usize) {
        let mechanism = self.mechanism;
        let group = &mechanism.groups[index];
        if self.construction.agreement[index].is_none() {
            return;
        }
        let equations = LoopEquations::new(mechanism, group);
        for &link in &group.bodies {
            if let Spin::Known(body) = equations.spin_of(link) {
                self.drafting.spins[link.0] = self.drafting.spins[body.0];
            }
        }
        let special = &self.construction.special[index];
        let drawn: Vec<Drawn<'_>> = special.iter().map(|s| self.special_point(s)).collect();
        for &sheet in self.plans() {
            if self.plan(sheet, group, &equations, &drawn).is_none() {
                return;
            }
        }
        for &sheet in self.plans() {
            self.images(sheet, group);
        }
    }

    /// The cut lines and where they cross; for a dyad's joint nothing is crossed.
    fn special_point<'s>(&mut self, special: &'s Special) -> Drawn<'s> {
        let mut legs = [0, 1].map(|side| self.leg(&special.cuts[side], special));
        let place = match special.target {
            Some(target) => self.plot(target),
            None => {
                let lines = [0, 1].map(|side| self.cut_line(&mut legs[side], &special.name));
                self.cross(Sheet::Scheme, &special.name, lines)
            }
        };
        let mut drawn = Drawn { special, legs, place, reaches: [None; 2] };
        drawn.reaches = [0, 1].map(|side| self.reach(&drawn, side));
        drawn
    }

    /// Rays, crossings and measured segments of a plan, and the rates that follow.
    fn plan(&mut self, sheet: Sheet, group: &Group, equations: &LoopEquations, drawn: &[Drawn<'_>]) -> Option<()> {
        let kind = match sheet {
            Sheet::Acceleration => PlanKind::Acceleration,
            _ => PlanKind::Velocity,
        };
        let mut rows = Vec::new();
        for point in drawn {
            let image = image_name(&point.special.name);
            let mut rays = Vec::new();
            for side in 0..2 {
                rays.push(self.ray(sheet, point, side)?);
            }
            let lines: [LineId; 2] = [rays[0].2, rays[1].2];
            let crossing = self.cross(sheet, &image, lines);
            for (side, (from, start, ray)) in rays.into_iter().enumerate() {
                let name = kind.segment_name(&from, &image);
                let segment = self.measure(sheet, &name, [start, crossing], How::Along(ray));
                self.name_number(&name, segment);
                rows.push(self.equation(sheet, equations, point, side, segment)?);
            }
            if let Some(target) = point.special.target {
                // A dyad's joint belongs to both of its links; a point under a slider to one.
                let pair = point.special.cuts.iter().filter_map(|cut| cut.leg.carried);
                let mut holders = vec![point.special.link];
                for Carried { carrier, inner } in pair {
                    if !self.mechanism.is_prismatic(inner) {
                        holders.push(self.mechanism.side(inner, carrier));
                    }
                }
                for holder in holders {
                    self.moved.push((sheet, holder, target, crossing));
                }
            }
        }
        let unknowns: Vec<NumberId> = (0..equations.unknowns).map(|_| self.new_number()).collect();
        let makes = self.name_unknowns(sheet, group, equations, &unknowns);
        let deed = Deed::Solve { unknowns, equations: rows };
        self.solve(sheet, &makes, deed);
        if sheet == Sheet::Velocity {
            self.hang(group);
        }
        Some(())
    }

    /// Gives the solved rates their names and their bodies; the names in a row.
    fn name_unknowns(
        &mut self,
        sheet: Sheet,
        group: &Group,
        equations: &LoopEquations,
        unknowns: &[NumberId],
    ) -> String {
        let mechanism = self.mechanism;
        let order = usize::from(sheet == Sheet::Acceleration);
        let mut names = Vec::new();
        for &link in &group.bodies {
            if let Some(unknown) = equations.spin_unknown(link) {
                let number = unknowns[unknown];
                let rates = self.drafting.spins[link.0].get_or_insert_default();
                rates[order] = Some(number);
                let letter = ["omega", "alpha"][order];
                names.push((format!("{letter}({})", mechanism.body(link).name), number));
            }
        }
        for slider in (0..mechanism.sliders.len()).map(SliderId) {
            if let Some(unknown) = equations.slide_unknown(slider) {
                let number = unknowns[unknown];
                let rates = self.drafting.slides[slider.0].get_or_insert_default();
                rates[order] = Some(number);
                let letter = ["v_r", "a_r"][order];
                names.push((format!("{letter}({})", mechanism.slider_name(slider)), number));
            }
        }
        for (name, number) in &names {
            self.name_number(name, *number);
        }
        let names: Vec<String> = names.into_iter().map(|n| n.0).collect();
        names.join(", ")
    }

    /// The ray of a leg: the name of the point from which the segment is measured, that point, the line.
    fn ray(&mut self, sheet: Sheet, point: &Drawn<'_>, side: usize) -> Option<(String, PlaceId, LineId)> {
        let (cut, leg) = (&point.special.cuts[side], &point.legs[side]);
        let start = cut.start()?;
        let mut name = image_name(&point_on(self.mechanism, cut.leg.base, start));
        let mut place = self.motion(sheet, cut.leg.base, start)?;
        self.name_place(sheet, &name, place);
        (name, place) = self.named_slides(sheet, name, place, &cut.slides)?;
        if sheet == Sheet::Acceleration {
            let normal = point.special.normal_names(self.mechanism)[side].clone();
            place = self.normal(point, side, place)?;
            self.name_place(sheet, &normal, place);
            name = normal;
        }
        let makes = format!("ray from {name} to {}", image_name(&point.special.name));
        let known = self.drawn_ray(place, leg.ray);
        let line = match known {
            Some(line) => line,
            None => self.draw(sheet, &makes, place, leg.ray),
        };
        Some((name, place, line))
    }

    /// A ray that another special point has needed already.
    fn drawn_ray(&self, start: PlaceId, direction: (Reference, u8)) -> Option<LineId> {
        self.drafting.acts.iter().find_map(|act| match act.deed {
            Deed::Draw { line, through, reference, quarter_turns }
                if (through, (reference, quarter_turns)) == (start, direction) =>
            {
                Some(line)
            }
            _ => None,
        })
    }

    /// Notes on what each link hangs, now that the rates are there.
    fn hang(&mut self, group: &Group) {
        let mechanism = self.mechanism;
        for (special, leg) in group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg))) {
            let link = match leg.carried {
                Some(carried) => carried.carrier,
                None => mechanism.lead(special.link),
            };
            let outer = mechanism.side(leg.outer, link);
            self.anchors[outer.0].get_or_insert(Anchor { joint: leg.outer, from: leg.base });
        }
        for (special, leg) in group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg))) {
            if let Some(Carried { carrier, inner }) = leg.carried {
                let holder = mechanism.side(inner, mechanism.lead(special.link));
                self.anchors[holder.0].get_or_insert(Anchor { joint: inner, from: mechanism.side(inner, carrier) });
            }
        }
    }

    /// The images of the group's joints, pins first: each over the link that carries it.
    fn images(&mut self, sheet: Sheet, group: &Group) {
        let mechanism = self.mechanism;
        let legs = || group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg)));
        for (special, leg) in legs() {
            let Some(Carried { carrier, inner }) = leg.carried else {
                continue;
            };
            if let JointKind::Revolute(point) = mechanism.joint(inner).kind {
                let holder = mechanism.side(inner, carrier);
                if let Some(place) = self.motion(sheet, holder, point) {
                    let name = image_name(mechanism.point_name(point));
                    self.name_place(sheet, &name, place);
                    let other = mechanism.side(inner, mechanism.lead(special.link));
                    if self.moved_point(sheet, other, point).is_none() {
                        self.moved.push((sheet, other, point, place));
                    }
                }
            }
        }
        let joints = mechanism.joints_of(group);
        for slider in joints.iter().filter_map(|&j| match mechanism.joint(j).kind {
            JointKind::Prismatic(slider) => Some(slider),
            JointKind::Revolute(_) => None,
        }) {
            let ends = mechanism.slider(slider);
            let at = mechanism.point_name(ends.at);
            let under = coincident_name(at, &mechanism.body(ends.on).name);
            for (body, name) in [(ends.link, at), (ends.on, under.as_str())] {
                if let Some(place) = self.motion(sheet, body, ends.at) {
                    self.name_place(sheet, &image_name(name), place);
                }
            }
        }
    }
}
