//! Parts of the library that other tests reach only through many others. What is not public for people is public for these tests,
//! and not in the reference.

mod cycle;
mod decimals;
mod editing;
mod format;
mod geometry;
mod mechanism;
mod position;
mod quantity;
mod structure;
mod text;
mod words;
