//! The workbench in a browser, used as people use it: with hands, keys and fingers. `KINEGON_PAGE` names another page than the committed one; with `KINEGON_PICTURES` each
//! test leaves pictures in `target/pictures`.

pub mod access;
mod bench;
mod board;
mod board_more;
mod build;
mod build_hands;
mod built;
mod bytes;
mod centers;
mod course;
mod documents;
mod film;
mod gestures;
mod hostile;
mod joints;
mod keyboard;
mod lesson;
mod loads;
mod minutes;
mod people;
mod photo;
mod prepare;
mod road;
mod share;
mod speed;
mod student;
mod surface;
mod telephone;
