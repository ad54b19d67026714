use crate::desk::{Desk, Kept};
use crate::refused::Refused;
use kinegon::position::counted_poses;
use kinegon::words::{Language, Wording};
use kinegon::{editing, format};
use serde::Serialize;

/// A point of the scene in its own coordinates.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Place {
    /// Its name.
    pub name: String,
    /// Where it is, in units of length.
    pub at: [f64; 2],
}

/// A way to assemble the scene.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Mode {
    /// Its number, as `kinegon modes` counts.
    pub number: usize,
    /// The places of moving points, and angles of links, in words; of many those alone that differ from the scene's own.
    pub shown: String,
    /// Whether it is that of the scene.
    pub is_own: bool,
}

impl Desk {
    /// Every way to assemble a scene.
    pub fn modes(&mut self, text: &str) -> Result<Vec<Mode>, Refused> {
        let (kept, language) = self.kept_with_language(text)?;
        let Kept { scene, mechanism, pose: own, .. } = &*kept;
        let listed = counted_poses(mechanism, &scene.near).map_err(|error| kept.refused(error))?;
        let mut words = Wording::of(&scene.figure);
        if let Some(language) = language {
            words.language = Language::of(language);
        }
        let standing = format::mode(mechanism, own, &words);
        let modes = listed.poses.iter().zip(1..).map(|(pose, number)| Mode {
            number,
            shown: apart(&format::mode(mechanism, pose, &words), &standing),
            is_own: own.is_same_as(pose),
        });
        Ok(modes.collect())
    }
}

/// Most places and angles that are told of a mode: of hundreds of links all modes would fill tens of megabytes.
const MOST_TOLD: usize = 24;

/// The lines of a mode: whole where they are short, else what differs from those of the scene's own.
fn apart(lines: &[String], own: &[String]) -> String {
    let told = |(line, own): (&String, &String)| {
        let all: Vec<&str> = line.split("  ").collect();
        if all.len() <= MOST_TOLD {
            return line.clone();
        }
        let others = all.iter().zip(own.split("  ")).filter(|(part, own)| *part != own).map(|(part, _)| *part);
        let others: Vec<&str> = others.collect();
        let parts = if others.is_empty() { &all } else { &others };
        let more = if parts.len() > MOST_TOLD { "  …" } else { "" };
        parts[..parts.len().min(MOST_TOLD)].join("  ") + more
    };
    lines.iter().zip(own).map(told).collect::<Vec<_>>().join("\n")
}

/// Where the points are, as far as that is known.
pub fn places(text: &str) -> Result<Vec<Place>, Refused> {
    let places = editing::places(text).map_err(|error| Refused::of(text, error))?;
    Ok(places.into_iter().map(|(name, at)| Place { name, at }).collect())
}
