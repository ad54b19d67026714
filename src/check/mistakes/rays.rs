//! Mistakes with lines: rays, cut lines, special points, the whole position.

use super::candidate::Candidate;
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{Action, LineId, Operation, OperationKind, Part, Sheet};

/// The plan points that a ray goes through and leads to; `None` if the operation draws no ray.
fn ends<'s>(site: &'s Site<'_>, operation: &Operation) -> Option<[&'s str; 2]> {
    let step = site.key.solution.construction.step(operation.step?)?;
    match &step.action {
        Action::Ray(ray) if operation.part == Part::Ray => Some([&ray.through, &ray.to]),
        _ => None,
    }
}

/// A line drawn at 90° to its right direction.
fn turn(site: &Site<'_>, mistake: Mistake, index: usize, blanks: [&str; 2]) -> Option<Candidate> {
    let OperationKind::Draw { line, through, along } = site.operation(index).kind else {
        return None;
    };
    let edit = Edit::Instead(OperationKind::Draw { line, through, along: along.turned(1) });
    Some(site.candidate(mistake, index, edit, &blanks))
}

pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    let rays = site.operations().filter_map(|(index, operation)| Some((index, ends(site, operation)?)));
    rays.filter_map(|(index, ends)| turn(site, Mistake::TurnedRay, index, ends)).collect()
}

pub(super) fn turned_cut_line(site: &Site<'_>) -> Vec<Candidate> {
    let turned = |(index, operation): (usize, &Operation)| match (operation.part, &operation.kind) {
        (Part::CutLine(special), OperationKind::Draw { through, .. }) => {
            let special = &site.model.construction.special(special).name;
            turn(site, Mistake::TurnedCutLine, index, [site.place_name(*through), special])
        }
        _ => None,
    };
    site.operations().filter_map(turned).collect()
}

pub(super) fn from_wrong_point(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        let (OperationKind::Draw { line, through, along }, Some([from, to])) = (&operation.kind, ends(site, operation))
        else {
            continue;
        };
        for wrong in site.model.places_before(operation.sheet, index) {
            if wrong != *through {
                let edit = Edit::Instead(OperationKind::Draw { line: *line, through: wrong, along: *along });
                let blanks = [to, site.place_name(wrong), from];
                found.push(site.candidate(Mistake::RayFromWrongPoint, index, edit, &blanks));
            }
        }
    }
    found
}

pub(super) fn wrong_lines(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        let (Part::SpecialPoint(special), &OperationKind::Cross { place, lines }) = (operation.part, &operation.kind)
        else {
            continue;
        };
        let name = &site.model.construction.special(special).name;
        let before = site.operations().take(index).filter(|(_, other)| other.sheet == Sheet::Scheme);
        let drawn: Vec<LineId> = before.filter_map(|(_, other)| other.kind.line()).collect();
        for side in 0..2 {
            for &wrong in drawn.iter().filter(|line| !lines.contains(line)) {
                let mut taken = lines;
                taken[side] = wrong;
                let edit = Edit::Instead(OperationKind::Cross { place, lines: taken });
                let [wrong, right] = [wrong, lines[side]].map(|line| line_name(site, line));
                found.push(site.candidate(Mistake::WrongLines, index, edit, &[name, &wrong, &right]));
            }
        }
    }
    found
}

/// The name of a line of the scheme: two of its points, or its role.
fn line_name(site: &Site<'_>, line: LineId) -> String {
    let drawn = site.operations().find(|(_, operation)| operation.kind.line() == Some(line));
    match drawn.map(|(_, operation)| (operation.part, &operation.kind)) {
        Some((_, OperationKind::Join { from, towards, .. })) => {
            format!("{}{}", site.place_name(*from), site.place_name(*towards))
        }
        Some((Part::CutLine(special), _)) => format!("cut line of {}", site.model.construction.special(special).name),
        Some((Part::Guide(slider), _)) => format!("guide of {}", site.key.solution.mechanism.slider_name(slider)),
        _ => String::new(),
    }
}

/// The whole drawing made in another assembly mode.
pub(super) fn other_mode(site: &Site<'_>) -> Vec<Candidate> {
    let in_mode = |mode| Candidate {
        mistake: Mistake::OtherMode,
        step: 0,
        blanks: Vec::new(),
        edits: Vec::new(),
        reinterpreted: Vec::new(),
        goes_on: Vec::new(),
        free: Vec::new(),
        mode,
    };
    (1..=site.other_modes).map(in_mode).collect()
}
