//! The numbers beside the sheets of a board, and the names of one's own that are free.

use super::file::HandDrawing;
use super::names::{LENGTH, two_points};
use super::screen::Screen;
use super::shown::{BoardNumber, FreeNames};
use super::table::Table;
use crate::drawing::{RichText, SheetLabels};
use crate::forces::Source;
use crate::format::html_text;
use crate::quantity::QuantityRequest;
use crate::scene::Head;
use crate::sheet::Sheet;
use indexmap::IndexMap;
use std::collections::BTreeMap;

/// By thing: the entry that made it.
pub(super) type Makers = BTreeMap<(Option<Sheet>, String), usize>;

impl Screen {
    /// What the scene gives; and all that a formula may use.
    pub(super) fn numbers(
        &self,
        drawing: &HandDrawing,
        table: &Table<'_>,
        labels: &SheetLabels<'_>,
        makers: &Makers,
    ) -> [Vec<BoardNumber>; 2] {
        let numbers = Numbers { screen: self, drawing, table, labels, makers };
        [numbers.given(), numbers.all()]
    }

    /// The next names of one's own that are free.
    pub(super) fn free_names(table: &Table<'_>) -> FreeNames {
        free_names(table)
    }
}

/// The numbers of a board.
struct Numbers<'s> {
    screen: &'s Screen,
    drawing: &'s HandDrawing,
    table: &'s Table<'s>,
    labels: &'s SheetLabels<'s>,
    makers: &'s Makers,
}

impl Numbers<'_> {
    fn number(&self, name: &str, number: f64, entry: Option<usize>) -> BoardNumber {
        let given = self.screen.judge.given();
        // A name of somebody's own is a stranger's text.
        let label = match QuantityRequest::new(name, given.mechanism()) {
            Ok(asked) => self.labels.quantity(&asked),
            Err(_) => RichText::verbatim(name.to_owned()),
        };
        BoardNumber {
            name: name.to_owned(),
            label: html_text(&label),
            value: self.screen.figures(number),
            unit: self.screen.unit_of(name, entry.map(|index| &self.drawing.did[index]), self.table),
            entry,
        }
    }

    /// Rates of drives, and lengths between points of links.
    fn given(&self) -> Vec<BoardNumber> {
        let table = self.table;
        let given = self.screen.judge.given();
        let mechanism = given.mechanism();
        let mut names: Vec<String> = Vec::new();
        for (_, body) in mechanism.links().filter(|(id, _)| mechanism.is_known(*id)) {
            names.extend([Head::Omega, Head::Alpha].map(|head| head.of(&body.name)));
        }
        for id in mechanism.slider_ids().filter(|id| mechanism.slider(*id).drive.is_some()) {
            let slider = mechanism.slider_name(id);
            names.extend([Head::SlideVelocity, Head::SlideAcceleration].map(|head| head.of(&slider)));
        }
        let loads = given.construction().forces.iter().flat_map(|plan| &plan.loads);
        for load in loads.filter(|_| !given.polygons.is_empty()) {
            names.push(load.name(mechanism));
            let is_inertia = load.source == Source::Inertia;
            names.extend(is_inertia.then(|| Head::InertiaCouple.of(&mechanism.body(load.body).name)));
        }
        for body in &mechanism.bodies {
            let points: Vec<&str> = body.points.iter().map(|point| mechanism.point_name(*point)).collect();
            for (at, from) in points.iter().enumerate() {
                names.extend(points[at + 1..].iter().map(|to| Sheet::Scheme.segment_name(from, to)));
            }
        }
        let known: IndexMap<String, f64> =
            names.into_iter().filter_map(|name| Some((name.clone(), table.known(&name)?))).collect();
        known
            .iter()
            .filter(|(_, number)| **number != 0.0)
            .map(|(name, number)| self.number(name, *number, None))
            .collect()
    }

    fn all(&self) -> Vec<BoardNumber> {
        let table = self.table;
        let mut all = self.given();
        // Lengths that are taken from the scheme, as up to a block on its lever or to a special point.
        let pairs = self.screen.references(table).into_iter().filter(|reference| two_points(&reference.name).is_some());
        for name in pairs.map(|reference| LENGTH.of(&reference.name)) {
            if let (Some(number), false) = (table.known(&name), all.iter().any(|known| known.name == name)) {
                all.push(self.number(&name, number, None));
            }
        }
        all.extend(
            table
                .numbers()
                .map(|(name, number)| self.number(name, number, self.makers.get(&(None, name.to_owned())).copied())),
        );
        // Segments between points that are there, from the pole on.
        for sheet in Sheet::ALL.into_iter().filter(|sheet| sheet.has_places()) {
            let own: Vec<&str> = table
                .places(sheet)
                .map(|(name, _)| name)
                .filter(|name| self.makers.contains_key(&(Some(sheet), (*name).to_owned())))
                .collect();
            for (at, to) in own.iter().enumerate() {
                // From the pole; from the centres and joints that are there from the start.
                let given = table.places(sheet).map(|(name, _)| name).filter(|name| {
                    self.screen.judge.given().is_there(name) && sheet.order().is_none_or(|order| order.pole() == *name)
                });
                for from in given.chain(own[..at].iter().copied()) {
                    let name = sheet.segment_name(from, to);
                    let is_measured = all.iter().any(|number| number.name == name);
                    if let (Some(number), false) = (table.known(&name), is_measured) {
                        all.push(self.number(&name, number, None));
                    }
                }
            }
        }
        all
    }
}

fn free_names(table: &Table<'_>) -> FreeNames {
    let free = |letter: &str, is_taken: &dyn Fn(&str) -> bool| {
        let mut names = (1..).map(|number| format!("{letter}{number}"));
        names.find(|name| !is_taken(name)).unwrap_or_default()
    };
    let is_point = |name: &str| Sheet::ALL.into_iter().any(|sheet| table.place(sheet, name).is_some());
    FreeNames {
        line: free("r", &|name| table.lines().any(|(own, _)| own == name)),
        point: free("h", &is_point),
        number: free("m", &|name| table.numbers().any(|(own, _)| own == name)),
    }
}
