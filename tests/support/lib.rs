//! What tests share.

pub mod browser;
pub mod camera;
pub mod case;
pub mod changes;
pub mod comparison;
pub mod exact;
pub mod faults;
pub mod files;
pub mod groups;
pub mod images;
pub mod ink;
pub mod later;
pub mod legible;
pub mod outputs;
pub mod photographs;
pub mod planted;
pub mod program;
pub mod random;
pub mod read_back;
pub mod speed_vs_error;
pub mod stages;
pub mod students;
pub mod survey;
pub mod tools;
pub mod whole_errors;
pub mod whole_way;
