//! In which order the lines of a speed diagram follow from one another.

use super::line::Pair;
use super::{SpeedDiagram, SpeedLine, SpeedStep};
use crate::construction::writer::Writer;
use crate::mechanism::{BodyId, GROUND};

/// What moves, with its spots.
struct Moving {
    link: BodyId,
    spots: Vec<usize>,
    slides: bool,
}

impl Writer<'_> {
    /// Adds the lines of all wheels, racks and carriers that move, in an order in which each but those that are given goes through velocities that are
    /// there, as far as there is one; and the steps.
    pub(super) fn order_lines(&self, diagram: &mut SpeedDiagram, pairs: &[Pair<'_>]) {
        let (mut left, mut is_there) = self.moving(diagram, pairs);
        let mut belts: Vec<usize> = (0..diagram.belts.len()).collect();
        diagram.steps.push(SpeedStep::Train);
        while !left.is_empty() {
            if let Some((at, [from, to])) = belts.iter().enumerate().find_map(|(at, &belt)| {
                let [a, b] = diagram.belts[belt].rims;
                let ends = if is_there[a] { [a, b] } else { [b, a] };
                is_there[ends[0]].then_some((at, ends))
            }) {
                let belt = belts.remove(at);
                if !is_there[to] {
                    is_there[to] = true;
                    diagram.steps.push(SpeedStep::Belt { belt, from, to });
                }
                continue;
            }
            let following = left.iter().position(|moving| self.through(diagram, moving, &is_there).is_some());
            let given = left.iter().position(|moving| self.mechanism.is_known(moving.link));
            // What neither is given nor follows is found with a linkage: that moves a carriage rather than a wheel.
            let carried = left.iter().position(|moving| moving.slides).unwrap_or(0);
            let moving = left.remove(given.or(following).unwrap_or(carried));
            let follows = given.is_none() && following.is_some();
            let Moving { link, spots, slides } = &moving;
            let ends = [spots[0], if *slides { spots[0] } else { spots[spots.len() - 1] }];
            let through = self.through(diagram, &moving, &is_there).filter(|_| follows).unwrap_or(ends);
            spots.iter().for_each(|&spot| is_there[spot] = true);
            let omega = self.motion.body(*link).omega;
            diagram.steps.push(SpeedStep::Line(diagram.lines.len()));
            diagram.lines.push(SpeedLine {
                link: *link,
                spots: spots.clone(),
                through,
                follows,
                slides: *slides,
                omega,
            });
        }
        let turning = (0..diagram.lines.len()).filter(|&line| !diagram.lines[line].slides);
        let rays: Vec<SpeedStep> = turning.map(SpeedStep::Ray).collect();
        diagram.steps.push(SpeedStep::Pole);
        diagram.steps.extend(rays);
    }

    /// What moves, and which spots have velocities from the start: those of the frame.
    fn moving(&self, diagram: &SpeedDiagram, pairs: &[Pair<'_>]) -> (Vec<Moving>, Vec<bool>) {
        let mut left: Vec<Moving> = Vec::new();
        let mut is_there = vec![false; diagram.spots.len()];
        for pair in pairs {
            let rack = pair.joint.rack.map(|rack| pair.joint.bodies[1 - rack.wheel]);
            for (link, names) in pair.spots_of_bodies() {
                let slides = rack.is_some_and(|rack| link == rack || link == pair.carrier);
                let spots = names.into_iter().filter_map(|name| diagram.spots.iter().position(|spot| spot.at == name));
                for index in spots {
                    if link == GROUND {
                        is_there[index] = true;
                        continue;
                    }
                    match left.iter_mut().find(|moving| moving.link == link) {
                        Some(moving) if moving.spots.contains(&index) => {}
                        Some(moving) => moving.spots.push(index),
                        None => left.push(Moving { link, spots: vec![index], slides }),
                    }
                }
            }
        }
        left.iter_mut().for_each(|moving| moving.spots.sort_unstable());
        (left, is_there)
    }

    /// The velocities that are there through which the line of a link goes: two, or one of what slides.
    fn through(&self, diagram: &SpeedDiagram, moving: &Moving, is_there: &[bool]) -> Option<[usize; 2]> {
        let mut known = moving.spots.iter().copied().filter(|&spot| is_there[spot]);
        let first = known.next()?;
        if moving.slides {
            return Some([first; 2]);
        }
        let last = known.next_back()?;
        let apart = diagram.spots[last].height - diagram.spots[first].height;
        (apart > self.near).then_some([first, last])
    }
}
