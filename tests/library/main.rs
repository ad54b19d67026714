//! What the library computes, draws and writes, held against mathematics, references and committed files.
//! `cargo test --test library cycle::` runs one of the modules.

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
mod inside;
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
mod ties;
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
