//! The proof that one and only one assembly of a group lies near angles and slides, and how far from them it can be.

use super::given::Vector;
use super::locals::Locals;
use super::places::PlacesOf;
use crate::geometry::{Ball, Elements, LinearSystem, Numbers, Pair};
use crate::mechanism::{AngularRate, BodyId, Group, LoopEquations, Mechanism, SlideRate};
use crate::motion::coefficient_errors;

/// What curvature adds to an error is small enough below this part of the group's size: 2⁻⁹⁸.
const SMALL: f64 = f64::EPSILON * f64::EPSILON * 64.0;

/// More than what squares of angles add to a bound of first order, for angles up to a tenth.
const SECOND_ORDER: f64 = 1.01;

/// A group with its links at some angles and slides x₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near<'a> {
    pub group: &'a Group,
    pub equations: &'a LoopEquations,
    /// The derivatives of the gaps there, in rounded numbers.
    pub system: &'a LinearSystem,
    pub places: PlacesOf<'a>,
    /// By body: as [`sizes`] has them.
    pub sizes: &'a [f64],
}

impl Near<'_> {
    /// How far the assembly can be from x₀ and `correction`, where the `gaps` are left in the loops at x₀; and whether that
    /// comes from the gaps' own errors. `None` where it is not proved that there is one and only one.
    ///
    /// The gaps f(x₀) and the derivatives A of them anywhere within a box about x₀ give the proof
    /// ([`LinearSystem::verified_near`]). The assembly x then has f(x₀) = A (x − x₀) for one such
    /// A, so that what the correction leaves of the gaps bounds the rest. All of that holds for every value that the
    /// inputs may have, as balls have them.
    pub fn enclosed(&self, gaps: &[Ball], correction: &[f64]) -> Option<(Numbers, bool)> {
        let most: Numbers = gaps.iter().map(|gap| gap.largest()).collect();
        let size: f64 = self.group.bodies.iter().map(|body| self.sizes[body.0]).sum();
        // Where no gap is left, a box that is not empty.
        let mut least = Numbers::from_elem(SMALL, self.equations.unknowns);
        let radii = self.equations.angular.iter().filter_map(|terms| Some(terms.travel.as_ref()?.radius));
        let longest = radii.fold(size, f64::max);
        for &(_, unknown) in &self.equations.slides {
            least[unknown] = SMALL * longest;
        }
        let mut off = Elements::new();
        let verified = self.system.verified_near(&most, &least, |reach| {
            off = coefficient_errors(self.equations, &self.places);
            self.add_turning(&most, reach, &mut off);
            off.clone()
        })?;
        let right: Numbers = gaps.iter().map(|gap| gap.high).collect();
        let uncertain: Numbers = gaps.iter().map(|gap| gap.error()).collect();
        let rows = off.chunks(self.equations.unknowns);
        let curved = rows.map(|row| row.iter().zip(correction).map(|(a, x)| a * x.abs()).sum()).fold(0.0, f64::max);
        let is_sharp = curved <= uncertain.iter().copied().fold(SMALL * size, f64::max);
        Some((verified.error_bound(correction, &right, &uncertain), is_sharp))
    }

    /// Adds to the errors of the coefficients by how much these change within a box about x₀.
    ///
    /// A body turns by at most the reach θ of its angle, and no two places on it move by more than θ times its size
    /// against each other; a place that a chain of bodies and slides carries moves by no more than the sum of these. An arm
    /// has two ends, which other loops may have placed: these are off by the gaps.
    fn add_turning(&self, gaps: &[f64], reach: &[f64], off: &mut Elements) {
        let equations = self.equations;
        let (mut turned, mut moved) = (0.0, 0.0);
        for body in &self.group.bodies {
            if let AngularRate::Unknown(unknown) = equations.angular_rate_of(*body) {
                turned += reach[unknown];
                moved += reach[unknown] * self.sizes[body.0];
            }
        }
        let slid: f64 = equations.slides.iter().map(|&(_, unknown)| reach[unknown]).sum();
        moved += slid * (1.0 + turned);
        let loops = 2 * equations.loops.len();
        let apart: f64 = gaps[..loops].iter().sum();
        let (of_arm, of_guide) = (2.0 * (moved + apart) * SECOND_ORDER, turned * SECOND_ORDER);
        let width = equations.unknowns;
        for (terms, rows) in equations.loops.iter().zip(off.chunks_mut(2 * width)) {
            for row in rows.chunks_mut(width) {
                for arm in &terms.arms {
                    if let AngularRate::Unknown(unknown) = arm.angular {
                        row[unknown] += of_arm;
                    }
                }
                for slide in &terms.slides {
                    if let SlideRate::Unknown(unknown) = slide.rate {
                        row[unknown] += of_guide;
                    }
                }
            }
        }
        // A relation between angles has the sine of what is left of it: its derivative is a weight times the cosine.
        for ((terms, row), gap) in
            equations.angular.iter().zip(off[loops * width..].chunks_mut(width)).zip(&gaps[loops..])
        {
            let weighted = || terms.coefficients().map(|(unknown, weight)| (unknown, weight.abs()));
            let left: f64 = 2.0 * gap + weighted().map(|(at, weight)| weight * reach[at]).sum::<f64>();
            for (unknown, weight) in weighted() {
                row[unknown] += weight * left * left;
            }
        }
    }
}

/// By body: a bound of the distances between places on it, of its points and of what slides on it or it slides with.
pub(super) fn sizes(mechanism: &Mechanism, locals: &Locals<'_>, lines: &[[Vector; 2]], slides: &[Ball]) -> Vec<f64> {
    let from = |origin: Vector, place: Vector| {
        let Pair { x, y } = place - origin;
        2.0 * (x.largest() + y.largest())
    };
    let origin = |body: BodyId| locals.of(body).first().copied().unwrap_or_default();
    let of_points = |body: BodyId| locals.of(body).iter().map(|&place| from(origin(body), place)).fold(0.0, f64::max);
    let mut sizes: Vec<f64> = mechanism.body_ids().map(of_points).collect();
    for id in mechanism.slider_ids() {
        let slider = mechanism.slider(id);
        sizes[slider.on.0] += from(origin(slider.on), lines[id.0][0]);
        for body in [slider.on, slider.link] {
            sizes[body.0] += 2.0 * slides[id.0].largest();
        }
    }
    sizes
}
