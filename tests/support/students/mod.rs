//! Students who draw velocity and acceleration plans by hand: a second construction of all exercises, which shares
//! nothing with that of the check, with hands that err and mistakes that are not taken from its catalogue.
//!
//! In reading order: `hand` errs, `scheme` is what a sheet gives, `act` is what can go wrong, `sheet` holds the plans;
//! `dyads` and `groups` draw them as textbooks do, `script` says which kind of mechanism needs what; `classical` (with
//! `parts`, `drawn`, `copied`) and `slips` are mistakes, `task` hands in sheets with them, `judge` and `survey` see what the check makes of these.

pub mod act;
pub mod classical;
pub mod copied;
pub mod drawn;
pub mod dyads;
pub mod groups;
pub mod hand;
pub mod judge;
pub mod mistake;
pub mod parts;
pub mod plane;
pub mod scheme;
pub mod script;
pub mod sheet;
pub mod slips;
pub mod survey;
pub mod task;
