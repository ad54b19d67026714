//! What was probably done where a line or a crossing on the figure of instant centres is wrong, and which centres are left to be found.

use super::alone::Held;
use super::bench::Bench;
use super::direction::Direction;
use super::entry::{Compute, Cross, Entry, Join, Line};
use super::given::Given;
use super::names::is_center;
use super::slips::Slip;
use super::table::{Made, Table};
use crate::centers::LinkPair;
use crate::check::{Blank, Told, tell};
use crate::mechanism::{BodyId, SliderId};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;

impl Bench<'_> {
    /// The mistake with instant centres that a wrong line or crossing shows.
    pub(super) fn cause_with_centers(&self, entry: &Entry, made: &Made) -> Option<Told> {
        match (entry, made) {
            (Entry::Line(line), Made::Line(name, drawn)) if drawn.sheet == Sheet::Centers => {
                let target = self.target(name)?;
                self.meant(line).iter().find_map(|meant| match meant {
                    Entry::Line(meant) => self.along_guide(meant, target),
                    _ => None,
                })
            }
            (Entry::Join(join), Made::Line(name, drawn)) if drawn.sheet == Sheet::Centers => {
                let target = self.target(name)?;
                self.at_slider(join, target).or_else(|| Some(self.without_common_link(&join.points, target)))
            }
            (Entry::Cross(Cross { of, .. }), Made::Place(Sheet::Centers, name, _)) => {
                let target = self.pair(name)?;
                let wrong = of.iter().find(|line| !self.leads_to(line, name))?;
                self.ends(wrong).map(|points| self.without_common_link(&points, target))
            }
            _ => None,
        }
    }

    /// The pair of links of the first centre for which a line is used.
    fn target(&self, line: &str) -> Option<LinkPair> {
        self.targets.get(line)?.iter().find_map(|target| self.pair(target))
    }

    fn pair(&self, name: &str) -> Option<LinkPair> {
        let given = self.judge.given();
        LinkPair::named(&given.usual(Sheet::Centers, name), given.mechanism())
    }

    /// Whether a line of the hand's own goes through a centre.
    fn leads_to(&self, line: &str, name: &str) -> bool {
        let right = &self.right[0];
        let place = self.judge.given().place(Sheet::Centers, name);
        let near = 1e-6 * self.judge.given().size(Sheet::Centers);
        let line = right.lines().find(|(own, _)| *own == line);
        line.zip(place).is_none_or(|((_, line), place)| line.distance(place).abs() <= near)
    }

    /// The points that a line of the hand's own joins; of one normal to a guide the second is the guide's centre.
    fn ends(&self, line: &str) -> Option<[String; 2]> {
        self.done.iter().find_map(|(_, entry)| match entry {
            Entry::Join(Join { join, points, .. }) if join == line => Some(points.clone()),
            Entry::Line(Line {
                line: own, through: Some(through), along: Some(Direction::Normal { normal }), ..
            }) if own == line => {
                let mechanism = self.judge.given().mechanism();
                let id = mechanism.slider_ids().find(|id| mechanism.slider_name(*id) == *normal)?;
                let slider = mechanism.slider(id);
                Some([through.clone(), LinkPair::new(slider.link, slider.on)?.name(mechanism)])
            }
            _ => None,
        })
    }

    /// A line along a guide in place of normal to it.
    fn along_guide(&self, line: &Line, target: LinkPair) -> Option<Told> {
        let Some(Direction::Parallel { parallel: name }) = &line.along else { return None };
        let (id, center) = self.guide(|id| self.judge.given().mechanism().slider_name(id) == *name, target)?;
        let normal = Line { along: Some(Direction::Normal { normal: name.clone() }), ..line.clone() };
        let is_right = matches!(self.holds(&Entry::Line(normal), &line.line, false), Held::All);
        is_right.then(|| tell::center_along_guide(self.symbol(center), self.guide_in_words(id)))
    }

    /// A line to the pin of a block in place of normal to its guide.
    fn at_slider(&self, join: &Join, target: LinkPair) -> Option<Told> {
        let given = self.judge.given();
        let mechanism = given.mechanism();
        let pin = |id: SliderId| mechanism.point_name(mechanism.slider(id).at);
        join.points.iter().enumerate().find_map(|(end, at)| {
            let is_pin = |id: SliderId| given.place(Sheet::Centers, pin(id)) == given.place(Sheet::Centers, at);
            let (id, center) = self.guide(is_pin, target)?;
            let normal = Line {
                line: join.join.clone(),
                on: Some(Sheet::Centers),
                through: Some(join.points[1 - end].clone()),
                along: Some(Direction::Normal { normal: mechanism.slider_name(id) }),
                drawn: None,
            };
            let is_right = matches!(self.holds(&Entry::Line(normal), &join.join, false), Held::All);
            is_right.then(|| tell::center_at_slider(self.symbol(center), pin(id).into(), self.guide_in_words(id)))
        })
    }

    /// A guide whose centre is on a line of that one.
    fn guide(&self, is_it: impl Fn(SliderId) -> bool, target: LinkPair) -> Option<(SliderId, LinkPair)> {
        let mechanism = self.judge.given().mechanism();
        mechanism.slider_ids().filter(|id| is_it(*id)).find_map(|id| {
            let slider = mechanism.slider(id);
            let center = LinkPair::new(slider.link, slider.on)?;
            center.links().iter().any(|link| target.other(*link).is_some()).then_some((id, center))
        })
    }

    fn guide_in_words(&self, id: SliderId) -> Blank {
        let solution = &self.judge.given().solution;
        Blank::Guide(solution.mechanism.slider_in_words(id, &solution.wording()))
    }

    fn symbol(&self, center: LinkPair) -> Blank {
        Blank::Quantity(center.name(self.judge.given().mechanism()))
    }

    /// A line through two places that no third link joins to the links of a centre.
    fn without_common_link(&self, points: &[String; 2], target: LinkPair) -> Told {
        let wrong = points.each_ref().map(|point| self.in_words(point, target)).join(" ");
        let right = self
            .right_line(points, target)
            .map_or_else(String::new, |line| line.map(|center| self.center_in_words(center)).join(" "));
        tell::line_without_common_link(self.symbol(target), Blank::Words(wrong), Blank::Words(right))
    }

    /// The line over a third link on which a centre lies: one with a place of the wrong line, else the first that can be drawn.
    fn right_line(&self, points: &[String; 2], target: LinkPair) -> Option<[LinkPair; 2]> {
        let mechanism = self.judge.given().mechanism();
        let [a, b] = target.links();
        let third =
            LinkPair::all(mechanism).into_iter().flat_map(LinkPair::links).filter(|link| ![a, b].contains(link));
        let line = |link: BodyId| Some([LinkPair::new(a, link)?, LinkPair::new(link, b)?]);
        let lines: Vec<[LinkPair; 2]> = third.filter_map(line).filter(|line| self.can_be_drawn(*line)).collect();
        let has_end = |line: &&[LinkPair; 2]| points.iter().any(|point| line.iter().any(|own| self.is_at(*own, point)));
        lines.iter().find(has_end).or(lines.first()).copied()
    }

    /// Whether both centres of a line are there, at infinity or apart.
    fn can_be_drawn(&self, line: [LinkPair; 2]) -> bool {
        let given = self.judge.given();
        let is_there = |center: &LinkPair| {
            let name = center.name(given.mechanism());
            let is_guide = || self.guide(|_| true, *center).is_some_and(|(_, own)| own == *center);
            self.own.place(Sheet::Centers, &name).is_some() || is_guide()
        };
        let places = line.map(|center| given.place(Sheet::Centers, &center.name(given.mechanism())));
        line.iter().all(is_there) && (places[0] != places[1] || places[0].is_none())
    }

    /// Whether a centre is at a point by its place.
    fn is_at(&self, center: LinkPair, point: &str) -> bool {
        let given = self.judge.given();
        let place = |name: &str| given.place(Sheet::Centers, name);
        let own = place(&center.name(given.mechanism()));
        own.is_some() && own == place(point)
    }

    /// A point in words: of a joint the permanent centre there that has a link of that centre.
    fn in_words(&self, point: &str, target: LinkPair) -> String {
        if let Some(pair) = self.pair(point) {
            return self.center_in_words(pair);
        }
        let all = LinkPair::all(self.judge.given().mechanism()).into_iter();
        let mut here = all.filter(|pair| self.is_at(*pair, point));
        let shares = |pair: &LinkPair| pair.links().iter().any(|link| target.other(*link).is_some());
        here.find(shares).map_or_else(|| point.to_owned(), |pair| self.center_in_words(pair))
    }

    fn center_in_words(&self, center: LinkPair) -> String {
        self.judge.given().symbol(center)
    }
}

impl Slip<'_, '_> {
    /// What is wrong with a number by distances of centres: the ratio upside down, its sense, another distance.
    pub(super) fn by_centers(&self, compute: &Compute, (name, found): (&str, f64), right: f64) -> Option<Told> {
        let formula = compute.by.as_ref()?;
        let has_center = |name: &&str| super::names::segment_of(name).is_some_and(|(sheet, _)| sheet == Sheet::Centers);
        let distances: Vec<&str> = formula.names().into_iter().filter(has_center).collect();
        if distances.is_empty() {
            return None;
        }
        let rate = Blank::Symbol(name.to_owned());
        if self.is_same(found, -right) && super::bench::turns(name) {
            return Some(tell::sense_by_center(rate));
        }
        let value = |exchanged: &dyn Fn(&str) -> Option<f64>| {
            formula.value(&mut |own| exchanged(own).map_or_else(|| self.table.number(own), Ok)).ok()
        };
        let pairs = distances.iter().enumerate().flat_map(|(at, one)| {
            distances[at + 1..].iter().filter(move |other| *other != one).map(move |other| [*one, *other])
        });
        let inverted = pairs.into_iter().find_map(|[one, other]| {
            let [a, b] = [self.table.number(one).ok()?, self.table.number(other).ok()?];
            let turned = value(&|name| match name {
                _ if name == one => Some(b),
                _ if name == other => Some(a),
                _ => None,
            })?;
            if !self.is_same(turned.abs(), right.abs()) {
                return None;
            }
            // What makes the number larger stands above, and should stand below.
            let larger = value(&|name| (name == one).then_some(2.0 * a))?;
            let [over, under] = if larger.abs() > found.abs() { [other, one] } else { [one, other] };
            let quantity = |name: &str| Blank::Quantity(name.to_owned());
            Some(tell::ratio_inverted(rate.clone(), quantity(over), quantity(under)))
        });
        // A distance is rather another one than a rate that of another link.
        inverted.or_else(|| {
            self.exchanged(&[formula], &|own, by| {
                let value = value(&|name| (name == own).then_some(by));
                value.is_some_and(|value| self.is_same(value.abs(), right.abs()))
            })
        })
    }
}

/// A point as sentences name it.
pub(super) fn end(given: &Given, name: &str) -> Blank {
    if is_center(name) { Blank::Quantity(given.usual(Sheet::Centers, name)) } else { name.into() }
}

/// By entry of the own construction: whether it leads to something that the figure of instant centres asks for and that is not there yet. Whoever
/// finds a centre by other lines needs none of those that lead to it here.
pub(super) fn needed(given: &Given, did: &[Entry], table: &Table<'_>) -> Vec<bool> {
    let mut own = Table::new(given, table.scales());
    let made: Vec<Option<(Made, Vec<super::table::Thing>)>> = did
        .iter()
        .map(|entry| {
            let made = own.carry_out(entry).ok()?;
            let reads = super::reads::reads(entry, &own);
            own.put(made.clone());
            Some((made, reads))
        })
        .collect();
    let is_of_polygons = !given.polygons.is_empty();
    let mut open = Vec::new();
    let mut needed = vec![false; did.len()];
    let closed = closed_polygons(given, did, table);
    for (index, step) in made.iter().enumerate().rev() {
        let Some((made, reads)) = step else { continue };
        if is_in_one(made, did, index, &closed) {
            continue;
        }
        let is_wanted = match made {
            Made::Place(sheet, name, _) => {
                !(matches!(sheet, Sheet::Centers | Sheet::Forces) || is_of_polygons && *sheet == Sheet::Scheme)
                    || LinkPair::named(name, given.mechanism()).is_some_and(|pair| is_asked(given, pair))
            }
            Made::Line(_, line) => {
                !(matches!(line.sheet, Sheet::Centers | Sheet::Forces) || is_of_polygons && line.sheet == Sheet::Scheme)
            }
            Made::Numbers(all) => {
                all.iter().any(|(name, _)| !is_distance(name) && (!is_of_polygons || given.number(name).is_some()))
            }
        };
        let things = super::table::things(made);
        let is_there = match made {
            Made::Place(sheet, name, _) => table.place(*sheet, name).is_some(),
            Made::Numbers(all) => all.iter().all(|(name, _)| is_found(table, name)),
            Made::Line(..) => false,
        };
        if (is_wanted || things.iter().any(|thing| open.contains(thing))) && !is_there {
            needed[index] = true;
            open.extend(reads.iter().cloned());
        }
    }
    needed
}

/// The polygons, by the ends of their corners' names, whose closing forces a hand has found, whatever order it has drawn them in.
fn closed_polygons(given: &Given, did: &[Entry], table: &Table<'_>) -> Vec<String> {
    let measured = |start: &str| {
        let own = start.trim_start_matches('o').to_owned();
        let names = did.iter().filter_map(move |entry| match entry {
            Entry::Measure(measure) if measure.on == Some(Sheet::Forces) && polygon_of(&measure.to) == own => {
                Some(measure.measure.as_str())
            }
            _ => None,
        });
        names.collect::<Vec<_>>()
    };
    let is_side = |name: &&str| {
        QuantityName::parse(name)
            .is_some_and(|name| matches!(name.head, Head::ReactionAlong | Head::GuideForce | Head::Push))
    };
    let is_closed = |start: &str| {
        let all = measured(start);
        let sides: Vec<&str> = all.iter().copied().filter(is_side).collect();
        let wanted = if sides.is_empty() { all } else { sides };
        !wanted.is_empty() && wanted.iter().all(|name| is_found(table, name))
    };
    let starts = given.polygons.iter().map(|polygon| polygon.start.as_str());
    starts.filter(|start| is_closed(start)).map(|start| polygon_of(start).to_owned()).collect()
}

/// The number at the end of a corner's name.
fn polygon_of(corner: &str) -> &str {
    corner.trim_start_matches(|letter: char| !letter.is_ascii_digit())
}

/// Whether an entry of the own construction draws one of these polygons.
fn is_in_one(made: &Made, did: &[Entry], index: usize, polygons: &[String]) -> bool {
    let corner = match (made, &did[index]) {
        (Made::Place(Sheet::Forces, name, _), _) => Some(name),
        (Made::Line(_, line), Entry::Line(drawn)) if line.sheet == Sheet::Forces => drawn.through.as_ref(),
        _ => None,
    };
    corner.is_some_and(|corner| polygons.iter().any(|polygon| polygon == polygon_of(corner)))
}

/// Whether a hand has found a number; the size of a vector also by the vector's name.
pub(super) fn is_found(table: &Table<'_>, name: &str) -> bool {
    table.numbers().any(|(own, _)| own == name || Some(own) == name.strip_suffix(".size"))
}

fn is_asked(given: &Given, pair: LinkPair) -> bool {
    given.construction().centers.as_ref().is_some_and(|centers| centers.wanted.contains(&pair))
}

fn is_distance(name: &str) -> bool {
    QuantityName::parse(name).is_some_and(|name| matches!(name.head, Head::Between(_)))
}

/// The distances between places of the figure of instant centres, by their names.
pub(super) fn distances(table: &Table<'_>) -> Vec<(String, f64)> {
    let places: Vec<_> = table.places(Sheet::Centers).collect();
    let centers = places.iter().filter(|(name, _)| is_center(name));
    let mut all = Vec::new();
    for (from, start) in centers {
        let ends = places.iter().filter(|(to, _)| to != from);
        all.extend(ends.map(|(to, end)| (Sheet::Centers.segment_name(from, to), (end - start).norm())));
    }
    all.retain(|(_, length)| *length > 0.0);
    all
}
