use super::{BodyId, Group, JointKind, Loop, Mechanism, PointId, SliderId};
use crate::geometry::{LinearSystem, Point, Vector, quarter_turn};

/// Unknown rates of a fourth-class group: angular rates of classes of links that turn together, then slide rates.
pub const UNKNOWNS: usize = 4;

/// The loop equations of a group: which rates are unknown and which arms and slides each loop sums.
///
/// With the revolute joints p_1 … p_m of a loop, arms r_k = p_(k+1) − p_k, J the quarter turn and u the unit
/// guides signed in walking direction:
///
/// velocity:     Σ ω_k J r_k + Σ ṡ u = v_end(p_m) − v_start(p_1)
/// acceleration: Σ α_k J r_k + Σ s̈ u = a_end(p_m) − a_start(p_1) + Σ ω_k² r_k − Σ 2 ω ṡ J u
///
/// Both have the same matrix. Made once for a mechanism; positions come with each pose.
#[derive(Clone, Debug)]
pub struct LoopEquations {
    /// One entry for each loop of the group.
    pub loops: [LoopTerms; 2],
    /// Where both loops share two rates and have one of their own each: which ones.
    pub reduction: Option<Reduction>,
    spins: Vec<(BodyId, Spin)>,
    slides: Vec<(SliderId, usize)>,
}

/// The rates that both loops share, and the one that each has alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reduction {
    /// The unknowns in both loops.
    pub shared: [usize; 2],
    /// The unknown in the first loop alone, and in the second alone.
    pub own: [usize; 2],
}

/// The rotation of a body: an unknown of the system, or that of a known body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spin {
    /// This unknown.
    Unknown(usize),
    /// The rotation of this body.
    Known(BodyId),
}

/// What one loop sums.
#[derive(Clone, Debug)]
pub struct LoopTerms {
    /// The known body where it starts.
    pub start: BodyId,
    /// The known body where it ends.
    pub end: BodyId,
    /// Its first revolute joint p_1.
    pub first: PointId,
    /// Its last revolute joint p_m.
    pub last: PointId,
    /// The arms between successive revolute joints.
    pub arms: Vec<Arm>,
    /// The prismatic joints.
    pub slides: Vec<Slide>,
}

/// An arm r_k of a loop.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// The revolute joint p_k.
    pub from: PointId,
    /// The revolute joint p_(k+1).
    pub to: PointId,
    /// The rotation of the links that make up the arm.
    pub spin: Spin,
}

/// A prismatic joint of a loop.
#[derive(Clone, Copy, Debug)]
pub struct Slide {
    /// The slider.
    pub slider: SliderId,
    /// The unknown that is its rate.
    pub unknown: usize,
    /// +1 where the loop walks from the guide to the sliding link, −1 the other way.
    pub sign: f64,
    /// The rotation of its guide.
    pub spin: Spin,
}

impl LoopEquations {
    /// The equations of `group`.
    #[must_use]
    pub fn new(mechanism: &Mechanism, group: &Group) -> Self {
        let spins = spins(mechanism, group);
        let spin_of = |body: BodyId| {
            let found = spins.iter().find(|(b, _)| *b == body);
            found.map_or(Spin::Known(body), |(_, spin)| *spin)
        };
        let mut unknowns = spins
            .iter()
            .filter_map(|(_, s)| match s {
                Spin::Unknown(u) => Some(u + 1),
                Spin::Known(_) => None,
            })
            .max()
            .unwrap_or(0);
        let mut slides: Vec<(SliderId, usize)> = Vec::new();
        let mut terms = |chain: &Loop| {
            let mut pins = Vec::new();
            let mut arms: Vec<Arm> = Vec::new();
            let mut sliding = Vec::new();
            for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
                match mechanism.joint(joint).kind {
                    JointKind::Revolute(point) => {
                        if let Some(&from) = pins.last() {
                            let spin = spin_of(sides[0]);
                            arms.push(Arm {
                                from,
                                to: point,
                                spin,
                            });
                        }
                        pins.push(point);
                    }
                    JointKind::Prismatic(slider) => {
                        let known = slides.iter().find(|(s, _)| *s == slider);
                        let unknown = known.map_or(unknowns, |(_, u)| *u);
                        if unknown == unknowns {
                            slides.push((slider, unknown));
                            unknowns += 1;
                        }
                        let forward = mechanism.slider(slider).on == sides[0];
                        sliding.push(Slide {
                            slider,
                            unknown,
                            sign: if forward { 1.0 } else { -1.0 },
                            spin: spin_of(sides[0]),
                        });
                    }
                }
            }
            let first = pins.first().copied();
            // Loops without a revolute joint are singular by structure and never get here.
            let first = first.unwrap_or_else(|| mechanism.joint_point(chain.joints[0]));
            LoopTerms {
                start: chain.bodies[0],
                end: chain.bodies[chain.bodies.len() - 1],
                first,
                last: pins.last().copied().unwrap_or(first),
                arms,
                slides: sliding,
            }
        };
        let loops = [terms(&group.loops[0]), terms(&group.loops[1])];
        Self {
            reduction: reduction(&loops),
            loops,
            spins,
            slides,
        }
    }

    /// The unknown that is the slide rate of `slider`.
    #[must_use]
    pub fn slide_unknown(&self, slider: SliderId) -> Option<usize> {
        let found = self.slides.iter().find(|(s, _)| *s == slider);
        found.map(|(_, unknown)| *unknown)
    }

    /// The unknown that is the angular rate of `link`; `None` where a prismatic joint ties it to a known body.
    #[must_use]
    pub fn spin_unknown(&self, link: BodyId) -> Option<usize> {
        match self.spins.iter().find(|(b, _)| *b == link)?.1 {
            Spin::Unknown(unknown) => Some(unknown),
            Spin::Known(_) => None,
        }
    }

    /// The value of `link`'s angular rate, given the unknowns and the known bodies' rates.
    #[must_use]
    pub fn spin(&self, link: BodyId, x: &[f64; UNKNOWNS], known: impl Fn(BodyId) -> f64) -> f64 {
        let found = self.spins.iter().find(|(b, _)| *b == link);
        match found.map(|(_, spin)| *spin) {
            Some(Spin::Unknown(unknown)) => x[unknown],
            Some(Spin::Known(body)) => known(body),
            None => known(link),
        }
    }

    /// The matrix where the points and the guides' unit directions are these.
    #[must_use]
    pub fn matrix(&self, points: &[Point], guides: &[Vector]) -> [[f64; UNKNOWNS]; UNKNOWNS] {
        let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
        for (terms, rows) in self.loops.iter().zip(matrix.chunks_exact_mut(2)) {
            let mut add = |unknown: usize, column: Vector| {
                rows[0][unknown] += column.x;
                rows[1][unknown] += column.y;
            };
            for arm in &terms.arms {
                if let Spin::Unknown(unknown) = arm.spin {
                    add(unknown, quarter_turn(points[arm.to.0] - points[arm.from.0]));
                }
            }
            for slide in &terms.slides {
                add(slide.unknown, guides[slide.slider.0] * slide.sign);
            }
        }
        matrix
    }

    /// The factored matrix there; `None` where it is exactly singular.
    #[must_use]
    pub fn factored(&self, points: &[Point], guides: &[Vector]) -> Option<LinearSystem<UNKNOWNS>> {
        LinearSystem::new(self.matrix(points, guides))
    }
}

/// The split of the unknowns into shared ones and those of one loop; `None` where a closure link has two sliders.
fn reduction(loops: &[LoopTerms; 2]) -> Option<Reduction> {
    let within = |terms: &LoopTerms, unknown: usize| {
        let arms = terms.arms.iter().any(|a| a.spin == Spin::Unknown(unknown));
        arms || terms.slides.iter().any(|s| s.unknown == unknown)
    };
    let of = |first: bool, second: bool| -> Vec<usize> {
        let wanted = |u: &usize| within(&loops[0], *u) == first && within(&loops[1], *u) == second;
        (0..UNKNOWNS).filter(wanted).collect()
    };
    match (
        of(true, true).as_slice(),
        of(true, false).as_slice(),
        of(false, true).as_slice(),
    ) {
        (&[a, b], &[c], &[d]) => Some(Reduction {
            shared: [a, b],
            own: [c, d],
        }),
        _ => None,
    }
}

/// The spin of every link of the group: links tied by prismatic joints turn together.
fn spins(mechanism: &Mechanism, group: &Group) -> Vec<(BodyId, Spin)> {
    let mut classes: Vec<Vec<BodyId>> = group.links.iter().map(|&l| vec![l]).collect();
    for chain in &group.loops {
        for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
            if !mechanism.is_prismatic(joint) {
                continue;
            }
            let find =
                |classes: &[Vec<BodyId>], body| classes.iter().position(|c| c.contains(&body));
            match (find(&classes, sides[0]), find(&classes, sides[1])) {
                (Some(a), Some(b)) if a != b => {
                    let merged = classes.remove(a.max(b));
                    classes[a.min(b)].extend(merged);
                }
                (Some(a), None) => classes[a].push(sides[1]),
                (None, Some(b)) => classes[b].push(sides[0]),
                _ => {}
            }
        }
    }
    let mut spins = Vec::new();
    let mut unknowns = 0;
    for class in classes {
        let anchor = class.iter().find(|b| !group.links.contains(b));
        let spin = anchor.map_or(Spin::Unknown(unknowns), |&body| Spin::Known(body));
        unknowns += usize::from(anchor.is_none());
        let links = class.into_iter().filter(|b| group.links.contains(b));
        spins.extend(links.map(|link| (link, spin)));
    }
    spins
}
