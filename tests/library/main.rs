//! What the library computes, draws and writes, held against mathematics, references and committed files.
//! `cargo test --test library cycle::` runs one of the modules.

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod architecture;
mod assemblies;
mod bad_scenes;
mod camera;
mod committed_files;
mod complete_plans;
mod coriolis;
mod curves;
mod cycle;
mod drawing;
mod driven_cycles;
mod driven_sliders;
mod editing;
mod error_bounds;
mod forms;
mod fuzzed;
mod gallery_measured;
mod given_angle;
mod hall;
mod higher_class;
mod hodographs;
mod honest_checks;
mod invariants;
mod lectured;
mod levers;
mod markers;
mod paper_facts;
mod pencil;
mod photographs;
mod planted_mistakes;
mod planted_modes;
mod point_paths;
mod properties;
mod published_numbers;
mod published_sets;
mod pull;
mod reference;
mod scene_build;
mod scene_read;
mod sizes;
mod stage;
mod step_names;
mod students;
mod templates;
mod values;
mod whole_errors;
mod worked;
mod worksheets;

/// Examples whose tables are tested.
#[expect(dead_code, reason = "they are programs, too")]
#[path = "../../examples"]
mod examples {
    pub mod gallery;
    pub mod mistakes;
    #[path = "published_numbers/table.rs"]
    pub mod published_numbers;
    #[path = "textbook_cases.rs"]
    pub mod textbook_cases;
}

/// Hard groups of the example `speed_vs_error`, its methods and their truth.
#[expect(dead_code, reason = "the example draws a picture besides")]
#[path = "../../examples/speed_vs_error"]
mod speed_vs_error {
    use crate::support::{groups, planted, random};
    pub mod assembled;
    mod differences;
    pub mod document;
    pub mod families;
    mod general;
    mod hand;
    pub mod joints;
    mod kernel;
    pub mod lengths;
    mod measure;
    pub mod methods;
    mod naive;
    mod single;
    pub mod survey;
    pub mod truth;
}
