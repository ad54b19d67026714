//! Students who draw velocity and acceleration plans by hand: a second construction of all exercises, which shares
//! nothing with that of the check, with hands that err and mistakes that are not taken from its catalogue.
//!
//! In reading order: `hand` errs, `scheme` is what a sheet gives, `act` is what can go wrong, `sheet` holds the plans;
//! `dyads` and `groups` draw them as textbooks do, `script` says which kind of mechanism needs what.

pub mod act;
pub mod dyads;
pub mod groups;
pub mod hand;
pub mod plane;
pub mod scheme;
pub mod script;
pub mod sheet;
