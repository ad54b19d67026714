//! Which things an entry reads.

use super::direction::Direction;
use super::entry::{Compute, Cross, Entry, Join, LayOff, Like, Line, Measure, Solve};
use super::formula::Formula;
use super::names::{segment_of, two_points};
use super::table::{Table, Thing};
use crate::construction::image_name;
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, Sheet};

/// The things that an entry reads from the table, by their sheets and names.
pub(super) fn reads(entry: &Entry, table: &Table<'_>) -> Vec<Thing> {
    let mut reads = Reads { table, all: Vec::new() };
    match entry {
        Entry::Join(Join { on, points, .. }) => points.iter().for_each(|point| reads.point(*on, point)),
        Entry::Line(Line { on, through, along, .. }) => {
            through.iter().for_each(|point| reads.point(*on, point));
            along.iter().for_each(|along| reads.direction(*on, along));
        }
        Entry::Cross(Cross { of, .. }) => of.iter().for_each(|line| reads.name(line)),
        Entry::LayOff(LayOff { on, from, size, along, .. }) => {
            reads.point(*on, from);
            reads.direction(*on, along);
            reads.formula(size);
        }
        Entry::Like(Like { on, ends, points, .. }) => {
            ends.iter().for_each(|point| reads.point(*on, point));
            points.iter().for_each(|point| reads.point(Some(Sheet::Scheme), point));
        }
        Entry::Measure(Measure { on, from, to, .. }) => {
            [from, to].into_iter().for_each(|point| reads.point(*on, point))
        }
        Entry::Compute(Compute { by, .. }) => by.iter().for_each(|formula| reads.formula(formula)),
        Entry::Solve(Solve { solve, equations }) => {
            for sides in equations.iter().filter_map(|text| Formula::sides(text).ok()) {
                sides.iter().for_each(|side| reads.formula(side));
            }
            reads.all.retain(|(_, name)| !solve.contains(name));
        }
        Entry::Mark(_) | Entry::Undo(_) => {}
    }
    reads.all
}

struct Reads<'t, 'g> {
    table: &'t Table<'g>,
    all: Vec<Thing>,
}

impl Reads<'_, '_> {
    fn name(&mut self, name: &str) {
        self.all.push((None, name.to_owned()));
    }

    /// A point of this sheet, else of each that has it: an entry that says none is about the only one.
    fn point(&mut self, on: Option<Sheet>, name: &str) {
        let sheets = Sheet::ALL.into_iter().filter(|sheet| on.is_none_or(|on| on == *sheet));
        let having = sheets.filter(|sheet| self.table.place(*sheet, name).is_some());
        self.all.extend(having.map(|sheet| (Some(sheet), self.table.given.usual(sheet, name))));
    }

    fn reference(&mut self, on: Option<Sheet>, name: &str) {
        match two_points(name) {
            Some([from, to]) => {
                let has = |sheet: Sheet| [from, to].iter().all(|p| self.table.place(sheet, p).is_some());
                let on = match on {
                    _ if has(Sheet::Scheme) => Some(Sheet::Scheme),
                    Some(on) if !has(on) && has(Sheet::Forces) => Some(Sheet::Forces),
                    on => on,
                };
                [from, to].into_iter().for_each(|point| self.point(on, point));
            }
            None => self.name(name),
        }
    }

    fn direction(&mut self, on: Option<Sheet>, along: &Direction) {
        match along {
            Direction::Parallel { parallel: name } | Direction::Normal { normal: name } => self.reference(on, name),
            Direction::Turned { turned, base } => {
                turned.iter().chain([base]).for_each(|name| self.reference(on, name));
            }
            Direction::Angle { .. } => {}
        }
    }

    fn formula(&mut self, formula: &Formula) {
        for name in formula.names() {
            self.name(name);
            if self.table.numbers().any(|(own, _)| own == name) {
                continue;
            }
            // What is measured on a sheet.
            if let Some((sheet, ends)) = segment_of(name) {
                ends.iter().for_each(|point| self.point(Some(sheet), point));
            } else if let Some(quantity) = QuantityName::parse(name) {
                let order = match quantity.head {
                    Head::Velocity => Order::Velocity,
                    Head::Acceleration => Order::Acceleration,
                    _ => continue,
                };
                quantity.arguments.iter().for_each(|point| self.point(Some(order.sheet()), &image_name(point)));
            }
        }
    }
}
