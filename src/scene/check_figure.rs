//! The figure: panels, scales, page.

use super::error::SceneError;
use super::figure::{Figure, Page};
use super::file::FigureFile;
use super::place::Source;
use super::words::{shortened, suggestion};

/// The figure that the file asks for.
pub(super) fn figure(source: Source<'_>, file: Option<FigureFile>) -> Result<Figure, SceneError> {
    let standard = Figure::default();
    let Some(file) = file else {
        return Ok(standard);
    };
    for (key, scale) in [("mu_l", file.mu_l), ("mu_v", file.mu_v), ("mu_a", file.mu_a)] {
        if let Some(Err(why)) = scale.map(Figure::checked_scale) {
            return Err(source
                .error(&["figure", key], format!("`{key}` is {why}"))
                .hint("leave it out for the next scale that fits"));
        }
    }
    let panels = file.panels.unwrap_or(standard.panels);
    if panels.is_empty() {
        let message = "a figure without panels shows nothing";
        let hint = r#"name some of "scheme", "velocity", "acceleration", or leave `panels` out"#;
        return Err(source.error(&["figure", "panels"], message).hint(hint));
    }
    if let Some(index) = (1..panels.len()).find(|&index| panels[..index].contains(&panels[index])) {
        return Err(source.error(&["figure", "panels", &index.to_string()], "this panel stands twice"));
    }
    let page = match &file.page {
        None => standard.page,
        Some(name) => Page::from_name(name).ok_or_else(|| {
            let message = format!("there is no page \"{}\"", shortened(name));
            source.error(&["figure", "page"], message).maybe_hint(suggestion(name, Page::NAMES, "write one of"))
        })?,
    };
    if file.step == Some(0) {
        let message = "steps of the construction are numbered from 1";
        let hint = "`kinegon steps` lists them; leave `step` out for the finished figure";
        return Err(source.error(&["figure", "step"], message).hint(hint));
    }
    Ok(Figure {
        panels,
        mu_l: file.mu_l,
        mu_v: file.mu_v,
        mu_a: file.mu_a,
        page,
        worksheet: file.worksheet.unwrap_or(false),
        style: file.style.unwrap_or_default(),
        notation: file.notation.unwrap_or_default(),
        language: file.language.unwrap_or_default(),
        decimal: file.decimal.unwrap_or_default(),
        labels: file.labels.unwrap_or_default(),
        special_points: file.special_points.unwrap_or(true),
        construction: file.construction.unwrap_or(true),
        step: file.step.map(usize::from),
    })
}
