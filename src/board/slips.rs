//! Slips within one operation: another number in its formula, a factor, a sign, another point, a misread ruler. Each is undone, and where
//! the operation is right then, it was that.

use super::entry::{Compute, Entry, LayOff, Measure};
use super::formula::Formula;
use super::free_hand::FREE;
use super::given::Given;
use super::names::LENGTH;
use super::table::{Made, Table};
use crate::check::Told;
use crate::check::tell;
use crate::check::{Blank, Mistake};
use crate::geometry::Vector;
use crate::quantity::QuantityRequest;
use crate::scene::{Head, QuantityName};
use crate::sheet::{Order, Sheet};
use std::collections::BTreeMap;

/// An operation in the scene with right inputs, and what it should have made.
pub(super) struct Slip<'s, 'g> {
    /// The right things.
    pub table: &'s Table<'g>,
    /// The entry as it was written.
    pub entry: &'s Entry,
    /// What it makes with right inputs.
    pub alone: &'s Made,
    /// What it should make.
    pub right: Made,
    /// What numbers may differ by, in parts: typed ones have three digits or more.
    pub tolerance: f64,
    /// What the hand's own names of segments and lengths mean.
    pub measured: BTreeMap<String, (Sheet, [String; 2])>,
}

impl Slip<'_, '_> {
    /// What was probably done; `None` where no slip explains it.
    pub fn told(&self) -> Option<Told> {
        match (self.entry, self.alone, &self.right) {
            (Entry::Measure(measure), Made::Numbers(found), Made::Numbers(right)) => {
                self.measured(measure, found.first()?, right.first()?.1)
            }
            (Entry::Compute(compute), Made::Numbers(found), Made::Numbers(right)) => {
                self.computed(compute, found.first()?, right.first()?.1)
            }
            (Entry::Solve(solve), _, Made::Numbers(right)) => self.solved(solve, right),
            (Entry::LayOff(laid), Made::Place(sheet, name, at), Made::Place(_, _, right)) => {
                self.laid_off(laid, *sheet, name, [*at, *right])
            }
            (Entry::Like(like), _, Made::Place(sheet, _, right)) => self.image(like, *sheet, *right),
            _ => None,
        }
    }

    pub(super) fn is_same(&self, a: f64, b: f64) -> bool {
        a.is_finite() && (a - b).abs() <= self.tolerance * a.abs().max(b.abs())
    }

    /// A segment that was measured between other points, or read otherwise than it is.
    fn measured(&self, measure: &Measure, (name, found): &(String, f64), right: f64) -> Option<Told> {
        let (sheet, ends) = super::names::segment_of(name).or_else(|| {
            // Two points written together mean what lies between them.
            let sheet = measure.on?;
            let points: Vec<&str> = self.table.given.places(sheet).map(|(point, _)| point).collect();
            let split = points.iter().find_map(|first| {
                let second = name.strip_prefix(first).filter(|second| points.contains(second))?;
                Some([(*first).to_owned(), second.to_owned()])
            });
            Some((sheet, split.unwrap_or_else(|| [measure.from.clone(), measure.to.clone()])))
        })?;
        if !self.is_same(*found, right) {
            let is_other = |ends: &[String; 2]| {
                let place = |name: &String| self.table.given.place(sheet, name);
                place(&ends[0]) != place(&measure.from) || place(&ends[1]) != place(&measure.to)
            };
            let turned = [ends[1].clone(), ends[0].clone()];
            return (is_other(&ends) && is_other(&turned))
                .then(|| between_others(self.table.given, sheet, name, [&measure.from, &measure.to]));
        }
        None
    }

    /// Of a number that was read off the drawing: `drawn` is what the drawing has.
    pub fn misread(table: &Table<'_>, measure: &Measure, sheet: Sheet, read: f64) -> Option<Told> {
        let name = &measure.measure;
        let [from, to] = [table.place(sheet, &measure.from)?, table.place(sheet, &measure.to)?];
        let (run, drawn) = (to - from, (to - from).norm());
        // What a hand reads is off by a part of a millimetre.
        let off = FREE * 0.3 * table.scale(sheet);
        let near = |x: f64| {
            let near = (0.02 * drawn.min(x.abs())).max(off.min(0.2 * (drawn - x.abs())));
            (x.abs() - read.abs()).abs() <= near
        };
        let reading = (off / drawn).clamp(0.012, 0.05);
        let [start, end] = [&measure.from, &measure.to].map(|end| Blank::from(end.as_str()));
        let quantity = Blank::Quantity(name.clone());
        if near(run.x) {
            return Some(tell::component(quantity, Blank::Horizontal, start, end));
        }
        if near(run.y) {
            return Some(tell::component(quantity, Blank::Vertical, start, end));
        }
        written_otherwise(name, read, drawn, reading)
    }

    fn computed(&self, compute: &Compute, (name, found): &(String, f64), right: f64) -> Option<Told> {
        if let Some(told) = self.by_centers(compute, (name, *found), right) {
            return Some(told);
        }
        let is_rate = super::bench::turns(name);
        let is_turned =
            self.is_same(*found, -right) || (self.tolerance > 1e-3 && (found + right).abs() < 0.1 * right.abs());
        if is_turned && (is_rate || name.starts_with("v_r") || name.starts_with("a_r")) {
            return Some(tell::wrong_sense(Blank::Symbol(name.clone())));
        }
        let diameter = compute.by.as_ref().and_then(|by| self.diameter(by, name, found / right));
        if diameter.is_some() {
            return diameter;
        }
        let factor = || self.factor(name, compute.by.as_ref(), *found, right);
        let of_formula = || compute.by.as_ref().and_then(|by| self.formula(by, name, right));
        // A number that stands in a formula is rather a factor too many.
        let has_numbers = compute.by.as_ref().is_some_and(Formula::has_numbers);
        let told = if has_numbers { factor().or_else(of_formula) } else { of_formula().or_else(factor) };
        told.or_else(|| {
            let is_typed = compute.by.is_none();
            is_typed.then(|| written_otherwise(name, *found, right, self.tolerance)).flatten()
        })
    }

    /// A formula in which one number stands for another: it is exchanged until the formula is right.
    pub(super) fn formula(&self, formula: &Formula, name: &str, right: f64) -> Option<Told> {
        let value = |exchanged: &str, by: f64| {
            formula.value(&mut |own| if own == exchanged { Ok(by) } else { self.table.number(own) }).ok()
        };
        let is_right =
            |exchanged: &str, by: f64| value(exchanged, by).is_some_and(|x| self.is_same(x.abs(), right.abs()));
        let mechanism = self.table.given.mechanism();
        let symbol = |name: &str| Blank::Symbol(name.to_owned());
        let ends = || [self.start_of(name), Blank::from(name)];
        // A length may stand there as a number; in a Coriolis acceleration a velocity stands in its place.
        let names = formula.names();
        let a_length = names.iter().find(|name| LENGTH.begins(name));
        let length = || symbol(a_length.copied().unwrap_or("L"));
        let velocity = names.iter().find(|name| !super::bench::turns(name));
        let factor = || symbol(a_length.or(velocity).copied().unwrap_or("L"));
        // Of links that turn together the one whose rate was found is told.
        let found = self.table.numbers().map(|(name, _)| name.to_owned()).filter(|name| Head::Omega.begins(name));
        let omegas: Vec<String> = found.chain(mechanism.links().map(|(_, body)| Head::Omega.of(&body.name))).collect();
        for own in formula.names() {
            let Some(quantity) = QuantityName::parse(own) else { continue };
            let Ok(now) = self.table.number(own) else { continue };
            match quantity.head {
                Head::Omega => {
                    if is_right(own, now * now) {
                        let [from, to] = ends();
                        return Some(tell::omega_not_squared(from, to, symbol(own), length()));
                    }
                    let other = omegas.iter().find(|other| {
                        let other_value = self.table.given.number(other);
                        *other != own && other_value.is_some_and(|value| value != 0.0 && is_right(own, value))
                    });
                    if let Some(other) = other {
                        let [from, to] = ends();
                        return Some(tell::omega_of_another_link(from, to, symbol(other), factor(), symbol(own)));
                    }
                }
                Head::Velocity if quantity.arguments.len() == 1 => {
                    let other = segments(self.table, Order::Velocity).into_iter().find(|(_, v)| is_right(own, *v));
                    if other.is_some() {
                        let [from, to] = ends();
                        let image = crate::construction::image_name(&quantity.arguments[0]);
                        return Some(tell::normal_from_absolute(
                            from,
                            to,
                            self.rate_of(formula),
                            length(),
                            image.as_str().into(),
                        ));
                    }
                }
                _ => {}
            }
        }
        let exchanged = self.exchanged(&[formula], &is_right)?;
        // The velocity in a normal part is that of one point relative to the other.
        let pole = formula.names().into_iter().find_map(|own| {
            let (sheet, ends) = super::names::segment_of(own).filter(|(sheet, _)| *sheet == Sheet::Velocity)?;
            let absolute = ends.iter().position(|end| self.table.given.place(sheet, end) == Some(Vector::zeros()))?;
            Some(ends[1 - absolute].clone())
        });
        let is_normal = formula.names().iter().any(|name| LENGTH.begins(name));
        match pole {
            Some(point) if is_normal && exchanged.mistake == Mistake::WrongSegment && formula.has_power() => {
                let [from, to] = ends();
                Some(tell::normal_from_absolute(from, to, self.rate_of(formula), length(), point.as_str().into()))
            }
            _ => Some(exchanged),
        }
    }

    /// The angular velocity of the link whose length stands in a formula.
    pub(super) fn rate_of(&self, formula: &Formula) -> Blank {
        let mechanism = self.table.given.mechanism();
        let ends = formula.names().into_iter().find_map(super::names::segment_of).map(|(_, ends)| ends);
        let link = ends.and_then(|ends| {
            let points = [mechanism.point(&ends[0])?, mechanism.point(&ends[1])?];
            mechanism.links().find(|(_, body)| points.iter().all(|point| body.points.contains(point)))
        });
        Blank::Symbol(link.map_or_else(|| "ω".to_owned(), |(_, body)| Head::Omega.of(&body.name)))
    }

    /// A factor that should not be there.
    pub(super) fn factor(&self, name: &str, formula: Option<&Formula>, found: f64, right: f64) -> Option<Told> {
        let ratio = (found / right).abs();
        let names: Vec<&str> = formula.map_or_else(Vec::new, Formula::names);
        let rate = names.iter().find(|name| super::bench::turns(name));
        let rate = rate.map_or_else(|| Blank::Symbol(self.first_rate()), |rate| Blank::Symbol((*rate).to_owned()));
        let revolutions = 30.0 / std::f64::consts::PI;
        let powers = [revolutions, revolutions * revolutions];
        if powers.iter().any(|factor| self.is_same(ratio, *factor) || self.is_same(ratio, 1.0 / factor)) {
            return Some(tell::revolutions_for_radians(rate));
        }
        for (factor, tell) in
            [(2.0, tell::diameter_throughout as fn(Blank) -> Told), (0.5, tell::half_the_radius as fn(Blank) -> Told)]
        {
            if self.is_same(ratio, factor) && self.is_of_crank(name, right) {
                let length = names.iter().find(|name| LENGTH.begins(name));
                let length = length.map_or_else(|| self.crank_length(), |length| Some((*length).to_owned()));
                return Some(tell(Blank::Symbol(length?)));
            }
        }
        written_otherwise(name, found, right, self.tolerance)
    }

    /// A normal part of a link that is not driven, with the diameter in place of the radius.
    pub(super) fn diameter(&self, formula: &Formula, name: &str, ratio: f64) -> Option<Told> {
        let names = formula.names();
        let rate = names.iter().find(|name| Head::Omega.begins(name))?;
        let length = names.iter().find(|name| LENGTH.begins(name))?;
        let is_squared = formula.has_power() || names.iter().filter(|name| *name == rate).count() == 2;
        let is_driven = || {
            let mechanism = self.table.given.mechanism();
            let mut driven = mechanism.links().filter(|(id, _)| mechanism.is_known(*id));
            driven.any(|(_, body)| Head::Omega.of(&body.name) == **rate)
        };
        let is_twice = formula.has_numbers() && (ratio.abs() - 2.0).abs() <= 1e-6;
        (is_squared && is_twice && !is_driven()).then(|| {
            let [rate, length] = [rate, length].map(|name| Blank::Symbol((*name).to_owned()));
            tell::diameter(self.start_of(name), name.into(), rate, length)
        })
    }

    /// The first rate that the scene gives.
    fn first_rate(&self) -> String {
        let mechanism = self.table.given.mechanism();
        let mut known = mechanism.links().filter(|(id, _)| mechanism.is_known(*id));
        known.next().map_or_else(String::new, |(_, body)| Head::Omega.of(&body.name))
    }

    fn crank_length(&self) -> Option<String> {
        let mechanism = self.table.given.mechanism();
        let (_, body) = mechanism.links().find(|(id, body)| mechanism.is_known(*id) && body.points.len() > 1)?;
        let [from, to] = [body.points[0], body.points[1]].map(|point| mechanism.point_name(point));
        Some(Sheet::Scheme.segment_name(from, to))
    }

    /// Whether a vector or a size is one of a driven link.
    fn is_of_crank(&self, name: &str, right: f64) -> bool {
        let mechanism = self.table.given.mechanism();
        let driven = mechanism.links().filter(|(id, _)| mechanism.is_known(*id));
        let mut pairs = driven.flat_map(|(_, body)| {
            let names: Vec<&str> = body.points.iter().map(|point| mechanism.point_name(*point)).collect();
            let others = names.clone();
            names.into_iter().flat_map(move |a| others.clone().into_iter().map(move |b| [a, b])).collect::<Vec<_>>()
        });
        pairs.any(|[a, b]| {
            let names = match a == b {
                true => [Head::Velocity, Head::Acceleration].map(|head| head.of(a)),
                false => [Head::Normal, Head::Tangential].map(|head| head.of_two(a, b)),
            };
            let sizes = names.iter().filter_map(|name| self.table.given.number(name));
            sizes.into_iter().any(|size| self.is_same(size, right.abs())) || crate::construction::image_name(a) == name
        })
    }

    fn start_of(&self, name: &str) -> Blank {
        match self.entry {
            Entry::LayOff(LayOff { from, .. }) => from.as_str().into(),
            _ => name.into(),
        }
    }
}

/// A length or segment of that name that was measured between other points.
pub(super) fn between_others(given: &Given, sheet: Sheet, name: &str, ends: [&String; 2]) -> Told {
    let [from, to] = ends.map(|end| super::centers::end(given, end));
    match sheet {
        Sheet::Scheme => tell::wrong_length(Blank::Symbol(name.to_owned()), from, to),
        Sheet::Centers => tell::distance_from_wrong_center(Blank::Quantity(name.to_owned()), from, to),
        _ => tell::wrong_segment(Blank::Quantity(name.to_owned()), from, to),
    }
}

/// A number that was written otherwise than it is meant: two digits transposed, the point elsewhere.
fn written_otherwise(name: &str, found: f64, right: f64, tolerance: f64) -> Option<Told> {
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance.max(0.006) * b.abs();
    let quantity = || Blank::Quantity(name.to_owned());
    // Digits alone are meant, and the sign stays as it was written.
    let number = |x: f64| Blank::Number(crate::format::json(&rounded(x.copysign(found))).trim().to_owned());
    for power in [1, 2, 3, -1, -2, -3] {
        if near(found.abs() * libm::pow(10.0, -f64::from(power)), right.abs()) {
            return Some(tell::decimal_slipped(quantity(), number(found), number(right)));
        }
    }
    digits_transposed(name, found, right, tolerance.max(0.006))
}

/// A number with two digits in each other's place.
pub(super) fn digits_transposed(name: &str, found: f64, right: f64, tolerance: f64) -> Option<Told> {
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance * b.abs();
    let number = |x: f64| Blank::Number(crate::format::json(&rounded(x.copysign(found))).trim().to_owned());
    let text: Vec<char> = found.abs().to_string().chars().take(12).collect();
    for at in 0..text.len().saturating_sub(1) {
        if !(text[at].is_ascii_digit() && text[at + 1].is_ascii_digit()) || text[at] == text[at + 1] {
            continue;
        }
        let mut other = text.clone();
        other.swap(at, at + 1);
        let meant: f64 = other.iter().collect::<String>().parse().unwrap_or(f64::NAN);
        // Exchanged digits far behind change less than a hand's errors do.
        if near(meant, right.abs()) && !near(found.abs(), right.abs()) {
            return Some(tell::digits_transposed(Blank::Quantity(name.to_owned()), number(found), number(meant)));
        }
    }
    None
}

/// To four digits.
fn rounded(x: f64) -> f64 {
    if x == 0.0 {
        return x;
    }
    let scale = libm::pow(10.0, 3.0 - libm::floor(libm::log10(x.abs())));
    libm::round(x * scale) / scale
}

/// The segments of a plan, by their names.
pub(super) fn segments(table: &Table<'_>, order: Order) -> Vec<(String, f64)> {
    let sheet = order.sheet();
    let places: Vec<(&str, Vector)> = table.given.places(sheet).collect();
    let mut all = Vec::new();
    for (at, (from, start)) in places.iter().enumerate() {
        all.extend(places[at + 1..].iter().map(|(to, end)| (sheet.segment_name(from, to), (end - start).norm())));
    }
    // Those that the construction measures come first: they are meant.
    let measured = crate::quantity::measured_names(table.given.construction());
    let mut own: Vec<(String, f64)> = measured
        .into_iter()
        .filter(|name| QuantityRequest::new(name, table.given.mechanism()).is_ok_and(|asked| asked.sheet() == sheet))
        .filter_map(|name| Some((name.clone(), table.given.number(&name)?)))
        .collect();
    own.extend(all);
    own
}

/// The lengths between points of the scheme, those of the hand's own among them, by their names.
pub(super) fn lengths(table: &Table<'_>) -> Vec<(String, f64)> {
    let places: Vec<(&str, Vector)> = table.places(Sheet::Scheme).collect();
    let mut all = Vec::new();
    for (at, (from, start)) in places.iter().enumerate() {
        let others =
            places[at + 1..].iter().map(|(to, end)| (Sheet::Scheme.segment_name(from, to), (end - start).norm()));
        all.extend(others.filter(|(_, length)| *length > 0.0));
    }
    all
}
