//! Parts of the library that other tests reach only through many others. What is not public for people is public for these tests,
//! and not in the reference.

mod check;
mod construction;
mod cycle;
mod decimals;
mod drawing;
mod editing;
mod format;
mod geometry;
mod kernel;
mod marked_sheets;
mod mechanism;
mod position;
mod quantity;
mod scene;
mod structure;
mod text;
mod words;
