//! A loop of bodies compiled: a walk along it sums its vectors by the classes of links that turn together.

use super::action::{Chain, Closing, Member, Rail, Unknown};
use super::compile::Compiler;
use super::lengths::{Column, Span, Spot, Sum, Way, ZERO, total};
use crate::geometry::Vector;
use crate::mechanism::{BodyId, JointId, Loop};

/// Present place of a walk along a loop.
struct Walk {
    body: BodyId,
    here: Spot,
}

/// The vectors and sliders of a loop, summed by class during a walk.
struct LoopSums<'a> {
    classes: &'a [usize],
    unknowns: &'a [Unknown],
    members: Vec<(Member, Sum)>,
    rails: Vec<Rail>,
    /// By rail: its unit vector, positive along the loop.
    ways: Vec<Way>,
}

impl LoopSums<'_> {
    fn unknown(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|u| *u == unknown)
    }

    /// Adds a vector to the member of its class.
    fn add_vector(&mut self, span: Span) {
        let class = self.classes[span.body.0];
        let index = self.members.iter().position(|(member, _)| member.class == class);
        let index = index.unwrap_or_else(|| {
            let member = Member { class, spin: self.unknown(Unknown::Spin(class)), column: ZERO };
            self.members.push((member, Sum::new()));
            self.members.len() - 1
        });
        self.members[index].1.push(span);
    }

    /// Adds a slider whose guide has the rotation of the body's class.
    fn add_slider(&mut self, body: BodyId, way: Way) {
        let (class, slider) = (self.classes[body.0], way.slider.0);
        self.rails.push(Rail {
            class,
            slider,
            spin: self.unknown(Unknown::Spin(class)),
            slide: self.unknown(Unknown::Slide(slider)),
            arm: ZERO,
            column: ZERO,
        });
        self.ways.push(way);
    }
}

impl Compiler<'_> {
    /// Compiles a loop: sums its vectors by class, and assigns columns.
    pub(super) fn compile_loop(&mut self, chain: &Loop, closing: &mut Closing) {
        // A loop names the lead of a compound link; the joints may be on others of its links.
        let side = |joint, link| self.mechanism.side(joint, link);
        let last = chain.joints.len() - 1;
        let first = side(chain.joints[0], chain.bodies[0]);
        let (start, from) = self.loop_end(first, chain.joints[0], chain.closed);
        let mut walk = Walk { body: first, here: from };
        let mut sums = LoopSums {
            classes: &self.classes,
            unknowns: &closing.unknowns,
            members: Vec::new(),
            rails: Vec::new(),
            ways: Vec::new(),
        };
        for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
            let [body, next] = [sides[0], sides[1]].map(|link| side(joint, link));
            self.walk_compound(&mut sums, &mut walk, body);
            self.walk_joint(&mut sums, &mut walk, joint, next);
        }
        let ends = if chain.closed {
            self.walk_compound(&mut sums, &mut walk, first);
            sums.add_vector(Span { body: first, from: walk.here, to: from });
            None
        } else {
            let (end, there) = self.loop_end(walk.body, chain.joints[last], false);
            sums.add_vector(Span { body: walk.body, from: walk.here, to: there });
            Some([start, end])
        };
        let LoopSums { members: summed, mut rails, ways, .. } = sums;
        let recipe = &mut self.kernel.recipe;
        let mut members = Vec::with_capacity(summed.len());
        for (mut member, sum) in summed {
            let vector = total(&sum, self.mechanism, |body| self.turns[body.0]);
            // A class whose vector vanishes and that has no slider contributes nothing: a known body with a pin at the
            // loop's end.
            if vector == Vector::zeros() && !rails.iter().any(|r: &Rail| r.class == member.class) {
                recipe.vanishing.push(sum);
                continue;
            }
            closing.size = closing.size.max(vector.x.abs()).max(vector.y.abs());
            member.column = recipe.add_column(Column::Member(sum));
            for rail in rails.iter_mut().filter(|r| r.class == member.class) {
                rail.arm = member.column;
            }
            members.push(member);
        }
        for (rail, way) in rails.iter_mut().zip(ways) {
            rail.column = recipe.add_column(Column::Guide(way));
        }
        let column = |unknown: &Unknown| match *unknown {
            Unknown::Spin(class) => {
                let member = members.iter().find(|m| m.class == class);
                member.map_or(ZERO, |m| m.column)
            }
            Unknown::Slide(slider) => {
                let rail = rails.iter().find(|r| r.slider == slider);
                rail.map_or(ZERO, |r| r.column)
            }
        };
        let columns = closing.unknowns.iter().map(column).collect();
        let has_known = members.iter().any(|m| m.spin.is_none()) || rails.iter().any(|r| r.slide.is_none());
        closing.chains.push(Chain { ends, members, rails, has_known, columns });
    }

    /// Continues the walk over the driven sliders of a compound link to its body `to`.
    fn walk_compound(&self, sums: &mut LoopSums, walk: &mut Walk, to: BodyId) {
        for driven in self.mechanism.slides_between(walk.body, to) {
            self.walk_joint(sums, walk, self.mechanism.slider_joint(driven.slider), driven.to);
        }
    }

    /// Continues the walk over a joint to body `to`: on the present body to the joint, then along the guide, if there
    /// is one, to the joint on body `to`.
    fn walk_joint(&self, sums: &mut LoopSums, walk: &mut Walk, joint: JointId, to: BodyId) {
        let [leave, arrive] = [walk.body, to].map(|body| self.joint_on(joint, body));
        sums.add_vector(Span { body: walk.body, from: walk.here, to: leave });
        if let Some(slider) = self.mechanism.joint(joint).slider {
            sums.add_slider(walk.body, Way { slider, is_back: self.mechanism.slider(slider).on != walk.body });
        }
        *walk = Walk { body: to, here: arrive };
    }

    /// Slot and place of a loop's end on a known body: its pin, or the body's first point at a slider.
    fn loop_end(&self, body: BodyId, joint: JointId, closed: bool) -> (usize, Spot) {
        match self.mechanism.joint(joint).pin {
            Some(point) => (point.0, self.joint_on(joint, body)),
            None if closed => (0, Spot::Origin),
            None => self.anchors[body.0].unwrap_or((0, Spot::Origin)),
        }
    }
}
