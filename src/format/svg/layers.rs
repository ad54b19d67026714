//! Marks in layers by the step that draws them.

use super::{Drawn, Text, attribute, clean, drawn, escape, write_marks};
use crate::drawing::{Drawing, Mark, Pen};
use std::fmt::Write;

/// Marks that come and go together.
pub(in crate::format) struct Layer {
    /// The step that draws them, from 1; 0 for marks that are there from the start.
    pub step: u16,
    /// Whether they are shown in that step only.
    pub passing: bool,
    /// Whether they lie below all marks of other layers: areas and construction lines.
    pub below: bool,
    /// The marks as SVG, one per line.
    pub svg: String,
}

/// The layers from the lowest to the highest, without empty ones.
pub(in crate::format) fn layers(drawing: &Drawing, text: Text) -> Vec<Layer> {
    let all = drawn(drawing);
    let last = drawing.marks.iter().map(|mark| mark.since).max();
    let mut layers = Vec::new();
    for below in [true, false] {
        for step in 0..=last.unwrap_or_default() {
            for passing in [false, true] {
                let here =
                    |(mark, _): &&Drawn<'_>| (mark.since, mark.passing, lies_below(mark)) == (step, passing, below);
                let marks: Vec<Drawn<'_>> = all.iter().filter(here).copied().collect();
                if !marks.is_empty() {
                    let mut svg = String::new();
                    write_marks(&mut svg, drawing, text, &marks);
                    layers.push(Layer { step, passing, below, svg });
                }
            }
        }
    }
    layers
}

/// The marks with a group for each layer; passing layers are left out.
pub(super) fn groups(drawing: &Drawing, text: Text) -> String {
    let digits = drawing.steps.len().to_string().len().max(2);
    let mut written = String::new();
    for layer in layers(drawing, text).into_iter().filter(|l| !l.passing) {
        if layer.step == 0 {
            written.push_str(&layer.svg);
            continue;
        }
        let suffix = if layer.below { "-under" } else { "" };
        written.push_str("<g");
        attribute(&mut written, "id", &format!("step-{:0digits$}{suffix}", layer.step));
        written.push_str(">\n");
        let words = drawing.steps.get(usize::from(layer.step) - 1);
        if let (false, Some(words)) = (layer.below, words) {
            let _ = writeln!(written, "<title>{}</title>", escape(&clean(words)));
        }
        written.push_str(&layer.svg);
        written.push_str("</g>\n");
    }
    written.truncate(written.trim_end().len());
    written
}

fn lies_below(mark: &Mark) -> bool {
    matches!(mark.pen, Pen::LinkFill | Pen::ImageFill | Pen::Construction | Pen::Hint)
}
