//! In: the text of a scene, and what a hand does with it: values that are set, names that change, links and points that come and go.
//! Out: the text with these changes and no others: layout, order of keys and notes stay. The text need only be JSON, except
//! where a change follows from the mechanism's position. Nothing is drawn here, and nothing is kept between two changes.
//!
//! `document` changes a text value by value, so that what is added looks like what is there; `names` reads the names that a text
//! gives, and changes one. On these stand the changes of `edit`: `add`, `drop`; and those that a hand makes on the picture: `position`
//! moves the mechanism and makes the text choose the assembly that was seen, `reshape` pulls a joint to another place.
//!
//! # The text is the document
//!
//! A change made by hand, in a form or on the picture, is a change of the scene's text: values are replaced, the rest
//! stays byte for byte. A pulled joint gets the lengths that it has at its new place while all other joints stay; a
//! guide that this would take off a joint turns with its link where nothing else hangs on that, else holds the pulled
//! joint on its line. What comes out is solved at once, and `near` says as little as chooses that assembly: first
//! what it said, then present places, then all places.

mod add;
mod document;
mod drop;
mod edit;
#[doc(hidden)] // for tests
pub mod measure;
mod names;
mod position;
mod present;
#[doc(hidden)] // for tests
pub mod reshape;

pub use add::{Along, NewLink, NewPoint, NewSlider, PlacedPoint, blank};
pub use edit::{Edit, Key, apply, with_figure};
pub use names::Named;
pub use position::{with_mode, with_position};
pub use present::places;
pub use reshape::{Pins, Reshape, Reshaped};
