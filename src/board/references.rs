//! What gives directions on a sheet: links, pairs of points, guides, loads, forces of a polygon.

use super::says;
use super::screen::Screen;
use super::shown::ThingKind;
use super::table::Table;
use crate::geometry::{Vector, cross};
use crate::sheet::Sheet;

/// What gives a direction.
pub(super) struct Reference {
    /// As entries call it.
    pub name: String,
    pub kind: ThingKind,
    pub words: crate::Message,
    pub ends: [Vector; 2],
}

impl Screen {
    /// What gives directions on the sheet of forces: two corners, between which a force lies.
    pub(super) fn corners(&self, table: &Table<'_>) -> Vec<Reference> {
        let given = self.judge.given();
        let places: Vec<(&str, Vector)> = table.places(Sheet::Forces).collect();
        let mut all = Vec::new();
        for (at, (from, start)) in places.iter().enumerate() {
            // Between the starts of two polygons there is nothing.
            let others = places[at + 1..].iter().filter(|(to, _)| !(given.is_there(from) && given.is_there(to)));
            all.extend(others.map(|(to, end)| Reference {
                name: format!("{from},{to}"),
                kind: ThingKind::Link,
                words: format!("{from}{to}").into(),
                ends: [*start, *end],
            }));
        }
        all
    }

    /// What gives directions on the scheme: links, pairs of their points, guides.
    pub(super) fn references(&self, table: &Table<'_>) -> Vec<Reference> {
        let given = self.judge.given();
        let mechanism = given.mechanism();
        let place = |name: &str| table.place(Sheet::Scheme, name);
        let mut all = Vec::new();
        for (id, body) in mechanism.links() {
            let mut points: Vec<&str> = body.points.iter().map(|point| mechanism.point_name(*point)).collect();
            if let ([from, to], Some(Ok(_))) = (points.as_slice(), given.direction(&body.name))
                && let (Some(from), Some(to)) = (place(from), place(to))
            {
                let words = says::link(&body.name);
                all.push(Reference { name: body.name.clone(), kind: ThingKind::Link, words, ends: [from, to] });
            }
            // Of a dyad that is its inner joint, which is there already.
            let special = given.construction().special.iter().filter(|special| special.link == id);
            let special = special.map(|special| special.name.as_str()).filter(|name| mechanism.point(name).is_none());
            points.extend(special.collect::<Vec<_>>());
            // What slides on a link is on its guide just now, as are both ends of a piston's rod.
            for slider in mechanism.slider_ids().filter(|slider| mechanism.slider(*slider).on == id) {
                let (guide, slider) = (given.solution.pose.guide(slider), mechanism.slider(slider));
                let Some(at) = place(mechanism.point_name(slider.at)) else { continue };
                let sliding = &mechanism.body(slider.link).points;
                let names = std::iter::once(&slider.at).chain(sliding).map(|point| mechanism.point_name(*point));
                let near = 1e-9 * given.size(Sheet::Scheme);
                let names = names.filter(|name| place(name).is_some_and(|own| cross(guide, own - at).abs() <= near));
                for name in names {
                    if !points.contains(&name) {
                        points.push(name);
                    }
                }
            }
            for (at, from) in points.iter().enumerate() {
                for to in &points[at + 1..] {
                    if let (Some(start), Some(end)) = (place(from), place(to)) {
                        let (name, words) = (format!("{from},{to}"), format!("{from}{to}").into());
                        all.push(Reference { name, kind: ThingKind::Link, words, ends: [start, end] });
                    }
                }
            }
        }
        let half = 0.12 * given.size(Sheet::Scheme);
        let loads = given.construction().forces.iter().flat_map(|plan| &plan.loads).zip(&given.load_places);
        for (load, at) in loads {
            let name = load.name(mechanism);
            if let (Some(Ok(along)), Some(at)) = (given.direction(&name), place(at)) {
                let words = says::load(&name);
                all.push(Reference { name, kind: ThingKind::Guide, words, ends: [at - along * half, at] });
            }
        }
        for id in mechanism.slider_ids() {
            let name = mechanism.slider_name(id);
            let at = place(mechanism.point_name(mechanism.slider(id).at));
            if let (Some(Ok(along)), Some(at)) = (given.direction(&name), at) {
                let words = says::guide(&name);
                let ends = [at - along * half, at + along * half];
                all.push(Reference { name, kind: ThingKind::Guide, words, ends });
            }
        }
        all
    }
}
