use super::action::{Action, Chain, Closing, Placing};
use super::close::{Size, correct, place, unit};
use super::columns::turn_columns;
use super::solve::solve;
use super::{Block, Kernel, vector};
use crate::geometry::{Ball, OneByOne, Pair, Row, Vector};

/// A vector in numbers of twice the digits.
type Precise = Pair<Ball>;

/// A vector of a block, whose numbers count as given.
fn exactly(v: Vector) -> Precise {
    Precise::within(v, 0.0)
}

impl Kernel {
    /// One Newton step more for every group of closed positions, from gaps that are computed with twice the digits of
    /// f64.
    ///
    /// The gaps of [`Self::assemble`] are rounded to u·size, which leaves an error of u over Hadamard's ratio in angles and
    /// slides: next to a change point, where that ratio falls but rates stay bounded, far more than the position itself is
    /// uncertain. After this step u is left. Directions count by their angles alone: that rounding has changed their
    /// length is taken out. A group with ties is left as it is, since their angles have the digits of f64.
    pub fn refine<R: Row>(&self, block: &mut Block<R>) {
        let mut places: Vec<Vec<Precise>> = (0..R::LEN)
            .map(|position| block.points.iter().map(|rows| exactly(vector(rows, position))).collect())
            .collect();
        for action in &self.actions {
            match action {
                Action::Place(placing) => {
                    place(OneByOne, block, placing);
                    for (position, places) in places.iter_mut().enumerate() {
                        places[placing.to] = places[placing.from] + reach(block, placing, position);
                    }
                }
                Action::Close(closing) => {
                    turn_columns(OneByOne, block, closing);
                    if !closing.ties.is_empty() {
                        continue;
                    }
                    set_gaps(block, closing, &places);
                    solve(OneByOne, block, closing);
                    correct(OneByOne, block, closing, Size::Small);
                    turn_columns(OneByOne, block, closing);
                }
            }
        }
    }
}

/// Sets the right sides to the gaps of the loops, rounded once.
fn set_gaps<R: Row>(block: &mut Block<R>, closing: &Closing, places: &[Vec<Precise>]) {
    for (index, chain) in closing.chains.iter().enumerate() {
        for (position, places) in places.iter().enumerate() {
            let gap = gap(block, chain, places, position).rounded();
            block.sides[index][0][position] = gap.x;
            block.sides[index][1][position] = gap.y;
        }
    }
}

/// The vector from a loop's start to its end less the sum of its members' vectors, at one position.
fn gap<R: Row>(block: &Block<R>, chain: &Chain, places: &[Precise], position: usize) -> Precise {
    let local = |column: usize| -> Precise { exactly(vector(&block.lengths.columns[column], position)) };
    let mut gap = chain.ends.map_or_else(Precise::default, |[start, end]| places[end] - places[start]);
    for member in &chain.members {
        // A column is the member's vector turned by +90°.
        let column = direction(block, member.class, position).turn(local(member.column));
        gap = gap + column.quarter_turn();
    }
    for rail in &chain.rails {
        let guide = direction(block, rail.class, position).turn(local(rail.column));
        gap = gap - guide * Ball::within(block.slides[rail.slider][position], 0.0);
    }
    gap
}

/// The vector from the earlier point to the placed one, at one position.
fn reach<R: Row>(block: &Block<R>, placing: &Placing, position: usize) -> Precise {
    let of = |rows: &[[R; 2]]| -> Precise { exactly(vector(&rows[placing.reach], position)) };
    let turn = direction(block, placing.class, position);
    let reach = turn.turn(of(&block.lengths.reaches));
    match placing.slide {
        Some(slider) => {
            reach + turn.turn(of(&block.lengths.guides)) * Ball::within(block.slides[slider][position], 0.0)
        }
        None => reach,
    }
}

/// The direction of a class, made of length 1.
fn direction<R: Row>(block: &Block<R>, class: usize, position: usize) -> Precise {
    unit(exactly(vector(&block.turns[class], position)))
}
