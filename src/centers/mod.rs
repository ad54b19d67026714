//! In: a mechanism and its motion. Out: instant centres: the point of two links that has one velocity on both. Which two is said by a [`LinkPair`].
//! Nothing here is drawn, and nothing is computed unless somebody asks for a centre.

mod pair;

pub use pair::LinkPair;
