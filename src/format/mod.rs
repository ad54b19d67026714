//! formats
mod result;
pub use result::*;
