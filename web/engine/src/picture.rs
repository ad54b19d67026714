use crate::answers::{Drive, Handle, Panel, Picture, View};
use crate::desk::{Desk, Staged};
use crate::refused::Refused;
use kinegon::Sheet;
use kinegon::Solution;
use kinegon::cycle::OtherModes;
use kinegon::drawing::{self, Drawing};
use kinegon::scene::SizeLimit;

impl Desk {
    /// The picture of a scene in its own position.
    pub fn picture(&mut self, text: &str, view: &View) -> Result<Picture, Refused> {
        let kept = self.kept(text)?;
        let drives = kept.drives()?;
        if view.step.is_none() && kept.check(SizeLimit::STEPS).is_err() {
            return Ok(still(kept.figure()?, drives));
        }
        let staged = kept.stage(view)?;
        Ok(staged.picture(&staged.own, staged.modes.as_ref(), view, drives))
    }
}

impl Staged {
    /// The picture of a position.
    pub fn picture(&self, solution: &Solution, modes: Option<&OtherModes>, view: &View, drives: Vec<Drive>) -> Picture {
        let finished = match (view.eased, &self.before) {
            (Some(share), Some(before)) => self.stage.eased_from(before, share.clamp(0.0, 1.0)).draw(solution, modes),
            _ => self.stage.draw(solution, modes),
        };
        let drawing = match view.step {
            Some(step) => finished.after_step(step.clamp(1, finished.steps.len().max(1))),
            None => finished,
        };
        self.picture_of(&drawing, solution, drives)
    }

    /// The picture with what can be held on a drawing of a position.
    pub fn picture_of(&self, drawing: &Drawing, solution: &Solution, drives: Vec<Drive>) -> Picture {
        let panels = self.stage.panels(drawing);
        let cut = panels.iter().filter(|panel| panel.is_cut);
        let words = solution.wording().language;
        let notes = cut.map(|panel| format!("{}: {}", panel.name, words.cut_at_edge())).collect();
        let panel = |panel: &drawing::HeldPanel| Panel {
            name: panel.name.clone(),
            key: panel.panel,
            area: [panel.frame.x0, panel.frame.y0, panel.frame.width(), panel.frame.height()],
            is_cut: panel.is_cut,
        };
        Picture {
            panels: panels.iter().map(panel).collect(),
            handles: self.stage.handles(solution).into_iter().map(handle).collect(),
            notes,
            ..sheet(drawing, drives)
        }
    }
}

fn handle(handle: drawing::Handle) -> Handle {
    let drawing::Handle { panel, name, at, is_fixed } = handle;
    Handle { name, panel, at: [at.x, at.y], is_fixed }
}

/// The figure of a scene that is too large to be moved by hand.
fn still(solution: &Solution, drives: Vec<Drive>) -> Picture {
    let drawing = solution.figure();
    let names = solution.scene.figure.shown_panels();
    let panel = |((name, frame), key): (&(String, drawing::Rect), &Sheet)| Panel {
        name: name.clone(),
        key: *key,
        area: [frame.x0, frame.y0, frame.width(), frame.height()],
        is_cut: false,
    };
    let panels = drawing.panels.iter().zip(&names).map(panel).collect();
    Picture { panels, ..sheet(&drawing, drives) }
}

fn sheet(drawing: &Drawing, drives: Vec<Drive>) -> Picture {
    Picture {
        svg: drawing.svg(),
        width: drawing.width,
        height: drawing.height,
        panels: Vec::new(),
        handles: Vec::new(),
        drives,
        notes: Vec::new(),
    }
}
