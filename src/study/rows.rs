/// What became of one mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It goes through the whole cycle.
    Whole,
    /// It goes through a part of the cycle, from `reach_from` to `reach_to`; figures are of that part.
    Part,
    /// It cannot come from the scene's position to any part of the cycle.
    Outside,
    /// Its position in the scene is singular, so which way it goes on is not decided.
    Singular,
    /// It cannot be assembled at the scene's position.
    NotAssembled,
    /// It is no mechanism: a length is not positive, three lengths form no triangle, or the like.
    NoMechanism,
}

impl Status {
    /// All of them, by the number that stands for each in a row.
    pub const ALL: [Status; 6] =
        [Status::Whole, Status::Part, Status::Outside, Status::Singular, Status::NotAssembled, Status::NoMechanism];

    /// The word that stands in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Status::Whole => "whole",
            Status::Part => "part",
            Status::Outside => "outside",
            Status::Singular => "singular",
            Status::NotAssembled => "not assembled",
            Status::NoMechanism => "no mechanism",
        }
    }

    /// The number that stands for it in a row.
    #[must_use]
    pub(super) fn number(self) -> f64 {
        Status::ALL.iter().position(|other| *other == self).map_or(f64::NAN, |at| at as f64)
    }
}

/// A column of a study's table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// What its numbers are.
    pub content: Content,
    /// The unit of its numbers, as `rad/s²`; angles are in degrees (°), numbers of rows and words have none.
    pub unit: String,
}

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Whole numbers.
    Index,
    /// Numbers; NaN where there is none.
    Number,
    /// Places in [`Status::ALL`].
    Status,
}
