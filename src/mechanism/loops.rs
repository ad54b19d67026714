use super::{AngularConstraint, BodyId, DrivenSlide, Group, Loop, Mechanism, PointId, SliderId};
use crate::geometry::{LinearSystem, Point, Vector, quarter_turn};
use nalgebra::DMatrix;
use smallvec::SmallVec;

/// The loop equations of a group: its unknown rates, and the arms and slides of each loop.
///
/// With the revolute joints p_1 … p_m of a loop, arms r_k = p_(k+1) − p_k, J the rotation by +90° and u the unit
/// directions of the guides, reversed where the loop runs from the sliding link to the guide:
///
/// velocity:     Σ ω_k J r_k + Σ ṡ u = v_end(p_m) − v_start(p_1)
/// acceleration: Σ α_k J r_k + Σ s̈ u = a_end(p_m) − a_start(p_1) + Σ ω_k² r_k − Σ 2 ω ṡ J u
///
/// Both have the same matrix. A closed contour has one arm more, from p_m back to p_1, and zero for the ends. The rates
/// of driven sliders are known: their terms belong to the right sides.
/// Links with a constant angle between them have one angular rate. Any other relation between angles, as of gears, gives
/// one further equation, after those of the loops: Σ weight ω = 0, and the same for α. That of a wheel on a rack has the rates of sliders, too:
/// Σ weight ω − Σ ṡ / r = 0.
/// The unknowns are the angular rates, then the slide rates, two for each loop and one for each such relation. The
/// equations do not depend on the position.
#[derive(Clone, Debug)]
pub struct LoopEquations {
    /// One entry for each loop of the group.
    pub loops: Vec<LoopTerms>,
    /// One entry for each relation between angles that needs an equation: angular rates with their weights.
    pub angular: Vec<AngularTerms>,
    /// The number of unknown rates.
    pub unknowns: usize,
    /// How two equations for two rates are split off; `None` where they cannot be.
    pub reduction: Option<Reduction>,
    angular_rates: Vec<(BodyId, AngularRate)>,
    /// The sliders with unknown rates, each with the index of its unknown.
    pub(crate) slides: Vec<(SliderId, usize)>,
}

/// How the equations reduce to two equations for two rates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    /// One loop with two unknowns.
    OneLoop,
    /// Two loops that share two unknowns; each has one further unknown.
    TwoLoops {
        /// The unknowns of both loops.
        shared: [usize; 2],
        /// The unknown of the first loop alone, and that of the second alone.
        own: [usize; 2],
    },
}

/// The angular rate of a body: an unknown of the equations, or that of a known body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngularRate {
    /// The unknown of this index.
    Unknown(usize),
    /// The angular rate of this body.
    Known(BodyId),
}

/// The rate of a slider: an unknown of the equations, or given by its drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlideRate {
    /// The unknown of this index.
    Unknown(usize),
    /// Velocity and acceleration along the guide, in the scene's units.
    Driven([f64; 2]),
}

/// The terms of a loop.
#[derive(Clone, Debug)]
pub struct LoopTerms {
    /// The known bodies where it starts and ends; `None` for a closed contour.
    pub ends: Option<[BodyId; 2]>,
    /// Its first revolute joint p_1.
    pub first: PointId,
    /// Its last revolute joint p_m.
    pub last: PointId,
    /// The arms between successive revolute joints.
    pub arms: Vec<Arm>,
    /// Its prismatic joints, and the driven sliders within its compound links.
    pub slides: Vec<Slide>,
}

/// An arm r_k of a loop.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// The revolute joint p_k.
    pub from: PointId,
    /// The revolute joint p_(k+1).
    pub to: PointId,
    /// The angular rate of the arm.
    pub angular: AngularRate,
}

/// A slider of a loop.
#[derive(Clone, Copy, Debug)]
pub struct Slide {
    /// The slider.
    pub slider: SliderId,
    /// Its rate.
    pub rate: SlideRate,
    /// +1 where the loop runs from the guide to the sliding link, −1 from the sliding link to the guide.
    pub sign: f64,
    /// The angular rate of its guide.
    pub angular: AngularRate,
}

/// The terms of a relation between angular rates.
#[derive(Clone, Debug)]
pub struct AngularTerms {
    /// The rates with their weights, whose sum is zero.
    pub rates: SmallVec<[(AngularRate, i32); 3]>,
    /// What slides as the bodies turn.
    pub travel: Option<TravelTerms>,
}

/// Rates of sliders in a relation between angular rates.
#[derive(Clone, Debug)]
pub struct TravelTerms {
    /// The sliders.
    pub slides: SmallVec<[Travelling; 2]>,
    /// The radius by which their rates are divided.
    pub radius: f64,
}

/// A slider in a relation between angular rates.
#[derive(Clone, Copy, Debug)]
pub struct Travelling {
    /// The slider.
    pub slider: SliderId,
    /// The index of its rate among the unknowns; `None` where it is driven, or known from another group.
    pub unknown: Option<usize>,
    /// The sign with which it counts.
    pub sign: f64,
}

impl AngularTerms {
    /// The coefficients of the unknowns, each with the unknown's index.
    pub(crate) fn coefficients(&self) -> impl Iterator<Item = (usize, f64)> {
        let turning = self.rates.iter().filter_map(|&(rate, weight)| match rate {
            AngularRate::Unknown(unknown) => Some((unknown, f64::from(weight))),
            AngularRate::Known(_) => None,
        });
        let sliding = self.travel.iter().flat_map(|travel| {
            travel.slides.iter().filter_map(|slide| Some((slide.unknown?, -slide.sign / travel.radius)))
        });
        turning.chain(sliding)
    }
}

impl LoopTerms {
    /// Adds this loop's coefficients to the columns of the unknowns, with the vectors from one point to another and the
    /// unit directions of guides, both in the fixed frame.
    #[inline]
    pub(crate) fn add_columns(
        &self,
        vector: impl Fn(PointId, PointId) -> Vector,
        guide: impl Fn(SliderId) -> Vector,
        columns: &mut [Vector],
    ) {
        for arm in &self.arms {
            if let AngularRate::Unknown(unknown) = arm.angular {
                columns[unknown] += quarter_turn(vector(arm.from, arm.to));
            }
        }
        for slide in &self.slides {
            if let SlideRate::Unknown(unknown) = slide.rate {
                columns[unknown] += guide(slide.slider) * slide.sign;
            }
        }
    }

    fn has_unknown(&self, unknown: usize) -> bool {
        self.arms.iter().any(|arm| arm.angular == AngularRate::Unknown(unknown))
            || self.slides.iter().any(|slide| slide.rate == SlideRate::Unknown(unknown))
    }
}

impl LoopEquations {
    /// The equations of `group`.
    #[must_use]
    pub fn new(mechanism: &Mechanism, group: &Group) -> Self {
        let (angular_rates, mut unknowns) = angular_rates(mechanism, group);
        let mut slides: Vec<(SliderId, usize)> = Vec::new();
        let chains = group.loops.iter();
        let loops: Vec<LoopTerms> =
            chains.map(|chain| terms(mechanism, chain, &angular_rates, &mut slides, &mut unknowns)).collect();
        let gears = group.gears(mechanism);
        let angular =
            gears.map(|angular| angular_terms(mechanism, group, angular, &angular_rates, &mut slides, &mut unknowns));
        let angular = angular.collect();
        Self { reduction: reduction(&loops, unknowns), loops, angular, unknowns, angular_rates, slides }
    }

    /// The index of the unknown that is the rate of `slider`; `None` for a slider of another group and for a driven
    /// one.
    pub(crate) fn slide_unknown(&self, slider: SliderId) -> Option<usize> {
        self.slides.iter().find(|(s, _)| *s == slider).map(|(_, unknown)| *unknown)
    }

    /// The index of the unknown that is the angular rate of `link`; `None` if `link` turns as a known body does, or is
    /// none of the group.
    #[must_use]
    pub fn angular_unknown(&self, link: BodyId) -> Option<usize> {
        match self.angular_rate_of(link) {
            AngularRate::Unknown(unknown) => Some(unknown),
            AngularRate::Known(_) => None,
        }
    }

    /// The angular rate of `link`: an unknown, or that of the known body with which it turns.
    pub(crate) fn angular_rate_of(&self, link: BodyId) -> AngularRate {
        rate_of(&self.angular_rates, link)
    }

    /// The first link whose angular rate is this unknown; `None` for a slide rate.
    #[must_use]
    pub fn link_of(&self, unknown: usize) -> Option<BodyId> {
        self.angular_rates.iter().find(|(_, rate)| *rate == AngularRate::Unknown(unknown)).map(|(body, _)| *body)
    }

    /// The number of equations.
    fn count(&self) -> usize {
        2 * self.loops.len() + self.angular.len()
    }

    /// Whether there are as many equations as unknowns; else the group is singular in every position.
    pub(super) fn is_square(&self) -> bool {
        self.count() == self.unknowns
    }

    /// The matrix for these places of the points and unit directions of the guides, in the fixed frame.
    #[must_use]
    pub fn matrix(&self, points: &[Point], guides: &[Vector]) -> DMatrix<f64> {
        self.matrix_of(|from, to| points[to.0] - points[from.0], |slider| guides[slider.0])
    }

    /// The matrix with these vectors from one point to another and unit directions of guides.
    pub(crate) fn matrix_of(
        &self,
        vector: impl Fn(PointId, PointId) -> Vector,
        guide: impl Fn(SliderId) -> Vector,
    ) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.count(), self.unknowns);
        for (index, terms) in self.loops.iter().enumerate() {
            let mut columns = vec![Vector::zeros(); self.unknowns];
            terms.add_columns(&vector, &guide, &mut columns);
            for (unknown, column) in columns.into_iter().enumerate() {
                matrix[(2 * index, unknown)] = column.x;
                matrix[(2 * index + 1, unknown)] = column.y;
            }
        }
        for (index, terms) in self.angular.iter().enumerate() {
            for (unknown, coefficient) in terms.coefficients() {
                matrix[(2 * self.loops.len() + index, unknown)] += coefficient;
            }
        }
        matrix
    }

    /// That matrix, factored; `None` if it is exactly singular, or not square as in a group singular by structure.
    #[must_use]
    pub fn factored(&self, points: &[Point], guides: &[Vector]) -> Option<LinearSystem> {
        self.factored_of(|from, to| points[to.0] - points[from.0], |slider| guides[slider.0])
    }

    /// As [`Self::factored`], of [`Self::matrix_of`].
    pub(crate) fn factored_of(
        &self,
        vector: impl Fn(PointId, PointId) -> Vector,
        guide: impl Fn(SliderId) -> Vector,
    ) -> Option<LinearSystem> {
        LinearSystem::of_vectors(self.is_square().then(|| self.matrix_of(vector, guide))?, self.loops.len())
    }
}

fn rate_of(rates: &[(BodyId, AngularRate)], body: BodyId) -> AngularRate {
    rates.iter().find(|(b, _)| *b == body).map_or(AngularRate::Known(body), |(_, rate)| *rate)
}

/// The terms of a relation between angles; new slide rates get the indices from `unknowns` on.
fn angular_terms(
    mechanism: &Mechanism,
    group: &Group,
    angular: &AngularConstraint,
    rates: &[(BodyId, AngularRate)],
    slides: &mut Vec<(SliderId, usize)>,
    unknowns: &mut usize,
) -> AngularTerms {
    let mut unknown_of = |slider: SliderId| {
        let found = slides.iter().find(|(other, _)| *other == slider).map(|(_, unknown)| *unknown);
        let is_own = || group.joints.iter().any(|&joint| mechanism.joint(joint).slider == Some(slider));
        if found.is_some() || mechanism.slider(slider).drive.is_some() || !is_own() {
            return found;
        }
        slides.push((slider, *unknowns));
        *unknowns += 1;
        Some(*unknowns - 1)
    };
    let travel = angular.travel.as_ref().map(|travel| TravelTerms {
        slides: travel
            .slides
            .iter()
            .map(|&(slider, sign)| Travelling { slider, unknown: unknown_of(slider), sign })
            .collect(),
        radius: travel.radius,
    });
    let terms = angular.terms.iter();
    AngularTerms { rates: terms.map(|&(body, weight)| (rate_of(rates, body), weight)).collect(), travel }
}

/// The terms of a loop; new slide rates get the indices from `unknowns` on.
fn terms(
    mechanism: &Mechanism,
    chain: &Loop,
    rates: &[(BodyId, AngularRate)],
    slides: &mut Vec<(SliderId, usize)>,
    unknowns: &mut usize,
) -> LoopTerms {
    let mut pins = Vec::new();
    let mut arms: Vec<Arm> = Vec::new();
    let mut sliding = Vec::new();
    let driven = |slides: Vec<DrivenSlide>, angular| {
        slides.into_iter().map(move |DrivenSlide { slider, sign, .. }| {
            let rates = mechanism.slider(slider).drive.map_or([0.0; 2], |drive| [drive.speed, drive.acceleration]);
            Slide { slider, rate: SlideRate::Driven(rates), sign, angular }
        })
    };
    // The link of a compound link on which the loop enters it; it may leave by another one.
    let mut entered = None;
    for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
        let angular = rate_of(rates, sides[0]);
        if let Some(from) = entered {
            let left = mechanism.side(joint, sides[0]);
            sliding.extend(driven(mechanism.slides_between(from, left), angular));
        }
        entered = Some(mechanism.side(joint, sides[1]));
        let joint = mechanism.joint(joint);
        if let Some(to) = joint.pin {
            if let Some(&from) = pins.last() {
                arms.push(Arm { from, to, angular });
            }
            pins.push(to);
        }
        if let Some(slider) = joint.slider {
            let known = slides.iter().find(|(s, _)| *s == slider);
            let unknown = known.map_or(*unknowns, |(_, u)| *u);
            if unknown == *unknowns {
                slides.push((slider, unknown));
                *unknowns += 1;
            }
            sliding.push(Slide {
                slider,
                rate: SlideRate::Unknown(unknown),
                sign: mechanism.slide_sign(slider, sides[0]),
                angular,
            });
        }
    }
    // A group with a loop without revolute joints is singular by structure, so any point serves.
    let first = pins.first().copied().unwrap_or_else(|| mechanism.joint_point(chain.joints[0]));
    let last = pins.last().copied().unwrap_or(first);
    let ends = [chain.bodies[0], chain.bodies[chain.bodies.len() - 1]];
    if chain.closed {
        let angular = rate_of(rates, ends[0]);
        arms.push(Arm { from: last, to: first, angular });
        let left = mechanism.side(chain.joints[0], ends[0]);
        let slides = mechanism.slides_between(entered.unwrap_or(left), left);
        sliding.extend(driven(slides, angular));
    }
    LoopTerms { ends: (!chain.closed).then_some(ends), first, last, arms, slides: sliding }
}

/// How the unknowns split; `None` for a closure link with two sliders, and for higher classes.
fn reduction(loops: &[LoopTerms], unknowns: usize) -> Option<Reduction> {
    match loops {
        [_] if unknowns == 2 => Some(Reduction::OneLoop),
        [first, second] if unknowns == 4 => {
            let unknowns_in = |in_first: bool, in_second: bool| -> Vec<usize> {
                let is_there = |u: &usize| first.has_unknown(*u) == in_first && second.has_unknown(*u) == in_second;
                (0..unknowns).filter(is_there).collect()
            };
            let (shared, of_first, of_second) =
                (unknowns_in(true, true), unknowns_in(true, false), unknowns_in(false, true));
            let ([first], [second]): ([usize; 1], [usize; 1]) = (of_first.try_into().ok()?, of_second.try_into().ok()?);
            Some(Reduction::TwoLoops { shared: shared.try_into().ok()?, own: [first, second] })
        }
        _ => None,
    }
}

/// The angular rate of every link of the group, and the number of unknowns among them; links with a constant angle between them
/// share one.
fn angular_rates(mechanism: &Mechanism, group: &Group) -> (Vec<(BodyId, AngularRate)>, usize) {
    let mut classes: Vec<Vec<BodyId>> = group.links.iter().map(|&lead| mechanism.compound(lead)).collect();
    for &joint in &group.joints {
        let Some((sides, _)) = mechanism.joint(joint).angular.as_ref().and_then(AngularConstraint::as_fixed_angle)
        else {
            continue;
        };
        let find = |body| classes.iter().position(|c| c.contains(&body));
        match sides.map(find) {
            [Some(a), Some(b)] if a != b => {
                let merged = classes.remove(a.max(b));
                classes[a.min(b)].extend(merged);
            }
            [Some(a), None] => classes[a].push(sides[1]),
            [None, Some(b)] => classes[b].push(sides[0]),
            _ => {}
        }
    }
    let mut rates = Vec::new();
    let mut unknowns = 0;
    for class in classes {
        let is_unknown = |b: &BodyId| group.bodies.contains(b);
        let anchor = class.iter().find(|b| !is_unknown(b));
        let rate = anchor.map_or(AngularRate::Unknown(unknowns), |&body| AngularRate::Known(body));
        unknowns += usize::from(anchor.is_none());
        let links = class.into_iter().filter(is_unknown);
        rates.extend(links.map(|link| (link, rate)));
    }
    (rates, unknowns)
}
