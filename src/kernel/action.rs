use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::Reduction;

/// An unknown of a group's equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// The angle of a class.
    Spin(usize),
    /// The position of a slider.
    Slide(usize),
}

/// What the kernel does, one after another.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    Place(Placing),
    Close(Closing),
}

/// A point that follows from one placed before: from it by `local`, turned with the class, and along a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placing {
    pub to: usize,
    pub from: usize,
    pub class: usize,
    pub local: Vector,
    /// The slider and its direction in the class's frame, positive with its position.
    pub slide: Option<(usize, Vector)>,
    /// Where the reach is kept.
    pub reach: usize,
}

/// The equations of a group: of its loops, then of its ties.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Closing {
    pub group: usize,
    pub chains: Vec<Chain>,
    pub ties: Vec<Tied>,
    pub unknowns: Vec<Unknown>,
    /// How the equations reduce, if they do; unknowns are then in the order shared, shared, own, own.
    pub reduced: Option<ReducedColumns>,
    /// The largest component of a member's vector with all sliders at zero; not zero. All of a loop may be of one class,
    /// whose vector is zero where the loop closes.
    pub reach: f64,
}

/// A loop.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// The slots of its ends; none where it closes on itself.
    pub ends: Option<[usize; 2]>,
    pub members: Vec<Member>,
    /// The sliders that it passes.
    pub rails: Vec<Rail>,
    /// By unknown: its column; [`ZERO`] where the loop does not pass it.
    pub columns: Vec<usize>,
}

/// A tie of rotations: the angles of classes, each times its weight, add up to a constant angle but for whole turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tied {
    pub classes: Vec<TiedClass>,
    /// The constant angle, in radians.
    pub apart: f64,
}

impl Tied {
    /// The coefficient of an unknown.
    pub fn weight(&self, unknown: usize) -> f64 {
        self.classes.iter().filter(|c| c.spin == Some(unknown)).map(|c| c.weight).sum()
    }
}

/// A class in a tie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TiedClass {
    pub class: usize,
    pub weight: f64,
    /// Which unknown its rotation is; none where that is known before the group is solved.
    pub spin: Option<usize>,
}

/// All that a loop passes of one class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Member {
    pub class: usize,
    /// Its vector in the class's frame with all sliders at zero.
    pub local: Vector,
    /// Which unknown its rotation is; none where that is known before the group is solved.
    pub spin: Option<usize>,
    /// Where its vector, a quarter turn on, is kept: the column of its rotation.
    pub column: usize,
}

/// A slider that a loop passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rail {
    pub class: usize,
    pub slider: usize,
    /// Its direction in the class's frame, in the direction of the walk.
    pub direction: Vector,
    /// Which unknown the rotation of its class is.
    pub spin: Option<usize>,
    /// Which unknown its slide is; none where that is driven.
    pub slide: Option<usize>,
    /// The column of the member to which it belongs.
    pub arm: usize,
    /// Where its turned direction is kept: the column of its slide.
    pub column: usize,
}

/// The column of an unknown that a loop does not pass.
pub(super) const ZERO: usize = 0;

/// Which columns are those of [`Reduced`](crate::geometry::Reduced), and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReducedColumns {
    /// s, t of one loop.
    One([usize; 2]),
    Two {
        /// h, s, t by loop.
        columns: [[usize; 3]; 2],
        /// By loop, whether h gets longer and shorter with a slider.
        varies: [bool; 2],
    },
}

impl ReducedColumns {
    pub fn new(reduction: Reduction, chains: &[Chain]) -> Option<ReducedColumns> {
        match (reduction, chains) {
            (Reduction::OneLoop, [chain]) => Some(ReducedColumns::One([chain.columns[0], chain.columns[1]])),
            (Reduction::TwoLoops { .. }, [first, second]) => {
                let [h, g] = [first.columns[2], second.columns[3]];
                let varies = |chain: &Chain, own| chain.rails.iter().any(|r| r.arm == own);
                Some(ReducedColumns::Two {
                    columns: [[h, first.columns[0], first.columns[1]], [g, second.columns[0], second.columns[1]]],
                    varies: [varies(first, h), varies(second, g)],
                })
            }
            _ => None,
        }
    }
}

impl Closing {
    /// Vectors in the frames of their classes, by column: those of members, a quarter turn on, and of guides.
    pub fn lengths(&self) -> impl Iterator<Item = (usize, Vector)> + '_ {
        let members = self.chains.iter().flat_map(|c| &c.members);
        let rails = self.chains.iter().flat_map(|c| &c.rails);
        let rails = rails.map(|r| (r.column, r.direction));
        members.map(|m| (m.column, quarter_turn(m.local))).chain(rails)
    }
}

impl Action {
    /// The action without its lengths.
    pub fn bare(&self) -> Action {
        let none = Vector::zeros();
        match self {
            Action::Place(placing) => Action::Place(Placing {
                local: none,
                slide: placing.slide.map(|(slider, _)| (slider, none)),
                ..*placing
            }),
            Action::Close(closing) => {
                let mut bare = closing.clone();
                for chain in &mut bare.chains {
                    chain.members.iter_mut().for_each(|m| m.local = none);
                    chain.rails.iter_mut().for_each(|r| r.direction = none);
                }
                bare.reach = 0.0;
                Action::Close(bare)
            }
        }
    }
}
