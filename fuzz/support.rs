//! What the targets share with each other, and with the tests.
#![allow(dead_code)] // not every target uses all of it

#[path = "../tests/support/case.rs"]
pub mod case;
#[path = "mutations.rs"]
pub mod mutations;
#[path = "odd.rs"]
pub mod odd;
#[path = "../tests/support/outputs.rs"]
pub mod outputs;
#[path = "../tests/support/random.rs"]
pub mod random;
#[path = "../tests/support/read_back.rs"]
pub mod read_back;
#[path = "../tests/support/stages.rs"]
pub mod stages;
#[path = "../tests/support/whole_way.rs"]
pub mod whole_way;
