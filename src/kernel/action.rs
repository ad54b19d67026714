use super::lengths::{Lengths, Recipe, Spot};
use crate::geometry::Point;
use crate::mechanism::{BodyId, Mechanism, Reduction, Role, SliderId};
use std::collections::BTreeSet;

/// A mechanism compiled for many positions.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// By body: its class and its first point.
    pub seats: Vec<Seat>,
    /// The drives, in the order of [`Mechanism::drive_names`](crate::mechanism::Mechanism::drive_names).
    pub inputs: Vec<Input>,
    /// By group: its unknowns.
    pub unknowns: Vec<Vec<Unknown>>,
    pub(super) classes: usize,
    pub(super) sliders: usize,
    /// The largest numbers of loops and of ties of a group.
    pub(super) loops: usize,
    pub(super) ties: usize,
    /// Number of slots: of points, then of places of bodies without points.
    pub(super) slots: usize,
    /// The slots of the ground's places.
    pub(super) fixed: Vec<usize>,
    pub(super) recipe: Recipe,
    /// The numbers of the mechanism from which it was made.
    pub(super) lengths: Lengths<[f64; 1]>,
    pub(super) actions: Vec<Action>,
    /// By group: the index of the action that closes it.
    pub(super) closings: Vec<usize>,
}

/// A body's class and its first point.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    /// Its class.
    pub class: usize,
    /// The slot of the body's first point.
    pub slot: usize,
    /// That point in the body's frame.
    pub(super) spot: Spot,
}

/// A drive, whose value a scene or a sweep sets.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// The driven body; of a slider the sliding link.
    pub body: BodyId,
    /// Whether it is an angle or a slide.
    pub kind: InputKind,
    /// The scene's angle in degrees, or position along the guide; none where another link's angle is given in its
    /// place.
    pub value: Option<f64>,
    /// The scene's angular velocity in rad per unit of time, or velocity along the guide.
    pub rate: f64,
    /// The scene's angular acceleration in rad, or acceleration along the guide.
    pub second: f64,
}

/// The coordinate that a drive sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// The angle of a class.
    Turning {
        /// The class.
        class: usize,
    },
    /// A slider along its guide.
    Sliding {
        /// The slider.
        slider: usize,
    },
}

/// An unknown of a group's equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// The angle of a class of bodies.
    Spin(usize),
    /// The position of a slider along its guide.
    Slide(usize),
}

/// A step of the computation of positions and rates.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    Place(Placing),
    Close(Closing),
}

/// Placing of a point relative to one placed before: by a vector rotated with the class, and along a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placing {
    pub to: usize,
    pub from: usize,
    pub class: usize,
    pub slide: Option<usize>,
    /// Index of the vector between the two points among the block's reaches.
    pub reach: usize,
}

/// The equations of a group: two for each loop, then one for each tie.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Closing {
    pub group: usize,
    pub chains: Vec<Chain>,
    pub ties: Vec<Tied>,
    pub unknowns: Vec<Unknown>,
    /// The reduced equations, if they reduce; the unknowns are then in the order shared, shared, own, own.
    pub reduced: Option<Reducing>,
    /// Its shape, if there is code for that.
    pub shape: Option<Shape>,
    /// The largest component of a member's vector with all sliders at zero: the group's size for slides. Not zero, even
    /// where all of a loop belongs to one class and its vector vanishes.
    pub size: f64,
    /// By unknown: what makes a correction a part of one, 1 of an angle in radians and 1 / size of a slide.
    pub scales: Vec<f64>,
}

/// Groups of which a Newton step and the rates after it are computed without rows between: each has code of its own, in
/// which all vectors of the equations stay in registers. Other groups go through rows, to the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// Two links with pins, as in a four-bar.
    TwoTurns,
    /// A slide along a link that both loops share, as in the source's Figure 2.
    SlideAndTurn,
}

/// A loop as a sum of vectors.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// The slots of its end points on known bodies; none for a loop that closes on itself.
    pub ends: Option<[usize; 2]>,
    pub members: Vec<Member>,
    /// The sliders in the loop.
    pub rails: Vec<Rail>,
    /// Whether it has a member whose rotation is known, or a driven slider.
    pub has_known: bool,
    /// By unknown: its column; [`ZERO`](super::lengths::ZERO) where the loop does not contain it.
    pub columns: Vec<usize>,
}

/// A tie of rotations: the weighted sum of the classes' angles equals a constant angle, modulo whole turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tied {
    pub classes: Vec<TiedClass>,
    /// Sliders whose positions count in it, as of a rack on a wheel.
    pub slides: Vec<TiedSlide>,
    /// The constant angle, in radians.
    pub apart: f64,
}

impl Tied {
    /// The coefficient of an unknown.
    pub fn weight(&self, unknown: usize) -> f64 {
        let turning: f64 = self.classes.iter().filter(|c| c.spin == Some(unknown)).map(|c| c.weight).sum();
        self.slides
            .iter()
            .filter(|s| s.slide == Some(unknown))
            .map(|s| s.weight)
            .fold(turning, |sum, weight| sum + weight)
    }
}

/// A class in a tie, with its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TiedClass {
    pub class: usize,
    pub weight: f64,
    /// Index of its rotation among the unknowns; none for a known rotation.
    pub spin: Option<usize>,
}

/// A slider in a tie, with its weight in radians for each unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TiedSlide {
    pub slider: usize,
    pub weight: f64,
    /// Index of its position among the unknowns; none for a known one.
    pub slide: Option<usize>,
}

/// The sum of a loop's vectors in the bodies of one class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Member {
    pub class: usize,
    /// Index of its rotation among the unknowns; none for a known rotation.
    pub spin: Option<usize>,
    /// Column of its rotation: the vector turned by +90°.
    pub column: usize,
}

/// A slider in a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rail {
    pub class: usize,
    pub slider: usize,
    /// Index of its class's rotation among the unknowns.
    pub spin: Option<usize>,
    /// Index of its slide among the unknowns; none for a driven slider.
    pub slide: Option<usize>,
    /// The column of the member with the slider's guide.
    pub arm: usize,
    /// Column of its slide: the unit vector in the fixed frame.
    pub column: usize,
}

/// Equations of one loop, or of two, that [`Reduced`](crate::geometry::Reduced) solves: its columns, and which of them
/// change their length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Reducible<const LOOPS: usize> {
    /// By loop: column h of its own unknown, s and t of the shared ones; of a single loop s, s, t.
    pub columns: [[usize; 3]; LOOPS],
    /// By loop: whether a slider changes the length of h.
    pub varies: [bool; LOOPS],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reducing {
    One(Reducible<1>),
    Two(Reducible<2>),
}

impl Reducing {
    pub fn new(reduction: Reduction, chains: &[Chain]) -> Option<Reducing> {
        match (reduction, chains) {
            (Reduction::OneLoop, [chain]) => {
                let [s, t] = [chain.columns[0], chain.columns[1]];
                Some(Reducing::One(Reducible { columns: [[s, s, t]], varies: [false] }))
            }
            (Reduction::TwoLoops { .. }, [first, second]) => {
                let [h, g] = [first.columns[2], second.columns[3]];
                let varies = |chain: &Chain, own| chain.rails.iter().any(|r| r.arm == own);
                Some(Reducing::Two(Reducible {
                    columns: [[h, first.columns[0], first.columns[1]], [g, second.columns[0], second.columns[1]]],
                    varies: [varies(first, h), varies(second, g)],
                }))
            }
            _ => None,
        }
    }
}

impl Action {
    /// The action whatever the size of a group is.
    fn without_size(&self) -> Action {
        match self {
            Action::Place(_) => self.clone(),
            Action::Close(closing) => Action::Close(Closing { size: 0.0, scales: Vec::new(), ..closing.clone() }),
        }
    }
}

impl Kernel {
    /// Whether `other` has the same actions in the same order, with any lengths.
    #[must_use]
    pub fn is_like(&self, other: &Kernel) -> bool {
        let actions = |kernel: &Kernel| kernel.actions.iter().map(Action::without_size).collect::<Vec<Action>>();
        self.fixed == other.fixed && actions(self) == actions(other)
    }

    /// A kernel without the points that are no end of a loop: for angles, slides and their rates only.
    #[must_use]
    pub fn without_places(&self) -> Kernel {
        let mut wanted = BTreeSet::new();
        let mut kept: Vec<Action> = Vec::new();
        for action in self.actions.iter().rev() {
            match action {
                Action::Close(closing) => {
                    wanted.extend(closing.chains.iter().filter_map(|c| c.ends).flatten());
                }
                Action::Place(placing) if wanted.contains(&placing.to) => {
                    wanted.insert(placing.from);
                }
                Action::Place(_) => continue,
            }
            kept.push(action.clone());
        }
        kept.reverse();
        Kernel { closings: closings(&kept), actions: kept, ..self.clone() }
    }

    /// The drives of a mechanism of this kind.
    pub fn inputs_of(&self, mechanism: &Mechanism) -> impl Iterator<Item = Input> {
        self.inputs.iter().map(|input| match (input.kind, &mechanism.body(input.body).role) {
            (InputKind::Turning { .. }, Role::Driver { angle, omega, alpha, .. }) => {
                Input { value: *angle, rate: *omega, second: *alpha, ..*input }
            }
            (InputKind::Sliding { slider }, _) if let Some(drive) = mechanism.slider(SliderId(slider)).drive => {
                Input { value: drive.position, rate: drive.speed, second: drive.acceleration, ..*input }
            }
            _ => *input,
        })
    }

    /// A body's first point in the body's frame.
    #[must_use]
    pub fn first_place(&self, mechanism: &Mechanism, body: BodyId) -> Point {
        self.seat(body).spot.place(mechanism, body)
    }

    /// A body's class and first point.
    #[must_use]
    pub fn seat(&self, body: BodyId) -> &Seat {
        &self.seats[body.0]
    }
}

/// By group: the index of the action that closes it. Groups are closed in their order.
fn closings(actions: &[Action]) -> Vec<usize> {
    let numbered = actions.iter().enumerate();
    numbered.filter(|(_, action)| matches!(action, Action::Close(_))).map(|(index, _)| index).collect()
}
