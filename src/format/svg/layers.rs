//! Marks in layers by the step that draws them.

use super::{Drawn, Text, attribute, drawn, write_marks};
use crate::drawing::{Drawing, Mark, Pen};
use crate::text::xml;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Marks that come and go together.
pub(in crate::format) struct Layer {
    /// The step that draws them, from 1; 0 for marks that are there from the start.
    pub step: u16,
    /// Whether they are shown in that step only.
    pub passing: bool,
    /// The step from which later marks stand in their place.
    pub until: Option<u16>,
    /// Whether they lie below all marks of other layers: areas and construction lines.
    pub below: bool,
    /// The marks as SVG, one per line.
    pub svg: String,
}

/// The layers from the lowest to the highest, without empty ones.
pub(in crate::format) fn layers(drawing: &Drawing, text: Text) -> Vec<Layer> {
    let mut piles: BTreeMap<(bool, u16, bool, Option<u16>), Vec<Drawn<'_>>> = BTreeMap::new();
    for one in drawn(drawing) {
        let mark = one.0;
        piles.entry((!lies_below(mark), mark.since, mark.passing, mark.until)).or_default().push(one);
    }
    let layer = |((above, step, passing, until), marks): ((bool, u16, bool, Option<u16>), Vec<Drawn<'_>>)| {
        let mut svg = String::new();
        write_marks(&mut svg, drawing, text, &marks);
        Layer { step, passing, until, below: !above, svg }
    };
    piles.into_iter().map(layer).collect()
}

/// The marks with a group for each layer; passing layers are left out. Groups `step-03-until-07` with what later marks
/// replace are hidden: all groups together are the finished figure.
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
        let until = layer.until.map_or_else(String::new, |until| format!("-until-{until:0digits$}"));
        attribute(&mut written, "id", &format!("step-{:0digits$}{until}{suffix}", layer.step));
        if layer.until.is_some() {
            attribute(&mut written, "visibility", "hidden");
        }
        written.push_str(">\n");
        let words = drawing.steps.get(usize::from(layer.step) - 1);
        if let (false, None, Some(words)) = (layer.below, layer.until, words) {
            let _ = writeln!(written, "<title>{}</title>", xml(words));
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
