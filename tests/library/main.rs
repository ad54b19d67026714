//! What the library computes, draws and writes, held against mathematics, references and committed files.
//! `cargo test --test library cycle::` runs one of the modules.
//!
//! - Numbers: `reference` solves over 650 scenes with 90-digit truth and measures errors in units of u·condition;
//!   `accuracy` measures families of hard groups against a reference of 256 bits, which it holds to that truth;
//!   `error_bounds` holds bounds at a given position to true errors, `whole_errors` every stated error and every
//!   printed digit to 256 bits from the scene's text on, for random mechanisms from lengths and as drawn, `geared_errors` those of
//!   wheels, racks, belts, contacts and several drives over whole turns, with their forces, `numbers` what is hard on the way from a text's digits to them;
//!   `paper_facts`, `published_numbers` and `worked` hold the paper and 20 textbook cases; `templates` holds every
//!   starting scene to independent truth and its rates to finite differences.
//!   `singular` asks that nothing is proved of mechanisms that are exactly singular.
//! - Poles: `centers` holds instant centres, inflection poles and poles of accelerations to independent digits, of random mechanisms to 256 bits, and three
//!   centres of three links to a line.
//! - Lines to poles: `kennedy` holds instant centres by Kennedy's lines to independent digits and to the motion, and finds them for all chains of four, six and eight
//!   links with the fewest crossings.
//!   `by_centers` holds velocities and centres of curvature by them to the motion and to closed forms; `centers_drawn` reads their symbols on figures and in steps.
//!   `arms` holds the arms of forces to these digits, and sees forms ask for them.
//!   `centers_checked` holds forms of centres to independent digits, `forces_checked` those of forces, with their mistakes and exercises.
//! - Positions: `assemblies` holds counts and the nearest assembly of chains to circles, `studies` the assemblies of a study's mechanisms to those of each by itself; `planted_modes` and
//!   `higher_class` hide known assemblies in random groups; `given_angle` finds drives back from other links' angles;
//!   `levers` turns slotted levers round; `mode_counts` holds numbers of complex modes to tables, modes to published roots, and asks for the same in every order and turn.
//! - Forces: `forces` holds what joints and drives carry to 35 cases of 60 digits, to virtual power, to energy over a turn and to momentum;
//!   `force_tables` holds tables of them to single positions, `free_bodies` stated errors of random mechanisms to numbers of 256 bits; `named_forces` holds parts of reactions, arms, inertia, moments, powers and shaking forces to them, by their names;
//!   `polygons` holds force plans to these cases, and of random groups to the equations of equilibrium, and sees their polygons close.
//! - Drives: `driven_sliders` holds cylinders and telescopes to independent truth, from lengths and as drawn, and
//!   their plans to closing; `driven_cycles` moves each of their drives; `cycle` holds paths to closed forms, random
//!   mechanisms and finite differences.
//! - What may not matter: `orders` lists links, points and joints of all scenes in other orders; `invariants` turns, mirrors, scales, shifts and renames random groups; `properties` does so
//!   with whole mechanisms, templates with other numbers, and holds their rates to differences and their plans to the
//!   links' images.
//! - Cams: `cams` holds contacts of profiles to independent digits and to closed forms over whole turns.
//! - Racks and belts: `racks` holds rolling wheels, racks and the forces of teeth to closed forms and independent digits.
//! - Speeds: `speeds` holds relative rates, ratios and revolutions a minute to Willis' formula, to distances of instant centres and to what a hand reads.
//! - Wheels: `gears` holds trains to independent digits and to Willis' formula, geared five-bars and rolling curves to closed forms, pitch points to centres.
//! - Wheels: `trains` holds their construction by pitch points to the same formula, and exercises to teeth that fit; `gears` holds trains to independent digits and to Willis' formula, geared five-bars and rolling curves to closed forms, pitch points to centres.
//! - Sizes: `sizes` draws a thousand links, and holds how time grows; `growth` does so for what else may be large.
//! - By hand: `pull` holds pulled points to being nearest and cranks to the pointer; `stage` its handles to the
//!   marks, its own position to the figure, modes to their numbers.
//! - Photographs: `photographs` holds places, refusals and proposed points to a camera of the tests' own
//!   (`tests/support/camera`), which `camera` holds to mathematics.
//! - Drawings: `drawing` measures label boxes and the ruler test, `gallery_measured` the same of twelve positions of
//!   every scene; `plan_vectors` holds heads of vectors and arcs of rates to what they show; `worksheets` holds printed lengths to results on every page; `curves` and `hodographs` hold marked
//!   extremes and tips to closed forms, `point_paths` paths, their cusps and double points. `films` reads films back.
//! - The pencil: `pencil` holds the replayed construction to the numeric solution and simulated drawings to their
//!   bands; `planted_mistakes` draws with mistakes put in, `planted_numbers` holds what follows from those with wheels, cams and friction to closed forms.
//!   `directions` holds directions of plan points to closed forms.
//! - Students: `students` draws exercises of all kinds once more, by a construction that shares nothing with the
//!   check's (`tests/support/students`), with hands that err and mistakes of which many are in no catalogue;
//!   `published_sets` prints one number of a textbook wrong. What is told must be true, and no surer than it is
//!   right.
//! - Marks: `marks` counts by hand what a mistake costs, and what a form asks for. `cheats` and `strategies` hand in what tells nothing, or next to nothing.
//! - Photographs: `tests/support/camera` takes pictures of sheets as telephones do (paper bent, lens, light, sensor,
//!   JPEG), knows where each point of the page is in them, and draws the plans of the students above on sheets with a
//!   pencil; it shares nothing with what reads photographs. `camera` holds it to mathematics: edges to 0.02 pixels,
//!   lengths of bent paper, cross ratios, Exif.
//! - Input: `scene_read`, `scene_build`, `bad_scenes`; `messages` asks for every error in every language; `editing` changes the texts of all scenes and back, to the
//!   byte, pulls every joint and holds all others to their places; `fuzzed` takes what `fuzz/` has found the whole
//!   way.
//! - The repository: `committed_files` keeps `out/`, `templates/` and `docs/gallery` current; `architecture` holds
//!   sources to the rules above.

mod accuracy;
mod architecture;
mod arms;
mod assemblies;
mod bad_scenes;
mod board_shown;
mod boards;
mod by_centers;
mod camera;
mod cams;
mod centers;
mod centers_checked;
mod centers_drawn;
mod cheats;
mod committed_files;
mod complete_plans;
mod coriolis;
mod curves;
mod cycle;
mod directions;
mod drafts;
mod drawing;
mod driven_cycles;
mod driven_sliders;
mod earlier;
mod editing;
mod error_bounds;
mod films;
mod first_wrong;
mod force_boards;
mod force_tables;
mod forces;
mod forces_checked;
mod forms;
mod free_bodies;
mod friction;
mod fuzzed;
mod gallery_measured;
mod geared_errors;
mod gears;
mod given_angle;
mod growth;
mod hall;
mod higher_class;
mod hodographs;
mod honest_checks;
mod inside;
mod invariants;
mod kennedy;
mod kutzbach;
mod lectured;
mod legible;
mod levers;
mod markers;
mod marks;
mod messages;
mod mode_counts;
mod named_forces;
mod numbers;
mod orders;
mod paper_facts;
mod pencil;
mod photographs;
mod plan_vectors;
mod planted_mistakes;
mod planted_modes;
mod planted_numbers;
mod point_paths;
mod polygons;
mod properties;
mod published_numbers;
mod published_sets;
mod pull;
mod racks;
mod reference;
mod scene_build;
mod scene_read;
mod singular;
mod sizes;
mod speeds;
mod springs;
mod stage;
mod step_names;
mod strategies;
mod students;
mod studies;
mod templates;
mod ties;
mod toothed;

mod trains;
mod values;
mod what_follows;
mod whole_errors;
mod willis;
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
