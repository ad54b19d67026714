//! What is known before the hand begins, and what every name means in the end: the solved scene, with all points in its plans.

use super::names::is_center;
use super::polygons::{GivenPolygon, direction_of_load, load_places, pitch_points, polygons};
use super::says;
use crate::centers::LinkPair;
use crate::construction::Rate;
use crate::construction::{Center, Construction, Extent, PointRole, Solution, asked_construction};
use crate::forces::Source;
use crate::geometry::{Point, Vector, span, unit};
use crate::mechanism::{Mechanism, Role};
use crate::message::Message;
use crate::quantity::{ForceOf, Quantity, QuantityRequest, What};
use crate::scene::{Head, QuantityName};
use crate::sheet::{PerSheet, Sheet};
use indexmap::IndexMap;

/// A solved scene as somebody meets it who draws: what it gives, and what the names of points and numbers will mean.
#[derive(Debug)]
pub struct Given {
    /// The solution, whose plans have all points.
    pub solution: Solution,
    /// By sheet and name: every point, in units of the sheet, from the pole or from the mechanism's first point.
    places: IndexMap<(Sheet, String), Vector>,
    /// The names of points that are there before anything is drawn: joints on the scheme, on plans the pole under all its names, on the figure of instant centres joints and permanent centres.
    there: Vec<(Sheet, String)>,
    /// The force polygons, where a hand draws them.
    pub(super) polygons: Vec<GivenPolygon>,
    /// By load: the name of the place on the scheme at which its force acts.
    pub(super) load_places: Vec<String>,
    /// The largest distance from the origin, by sheet.
    sizes: PerSheet<f64>,
}

impl Given {
    /// What the scene of a solution gives and means. The plans are drawn to all points, whatever its figure shows.
    #[must_use]
    pub fn new(solution: &Solution) -> Given {
        let mut solution = solution.clone();
        if solution.construction.extent != Extent::Points {
            let Solution { scene, mechanism, pose, motion, .. } = &solution;
            solution.construction = asked_construction(scene, (mechanism, pose, motion), Extent::Points);
        }
        let (mut places, mut there) = (IndexMap::new(), Vec::new());
        let Solution { mechanism, pose, construction, .. } = &solution;
        for point in mechanism.point_ids() {
            let key = (Sheet::Scheme, mechanism.point_name(point).to_owned());
            there.push(key.clone());
            places.insert(key, pose.point(point) - construction.origin);
        }
        for special in &construction.special {
            if let Some(place) = special.place.finite() {
                places.entry((Sheet::Scheme, special.name.clone())).or_insert(place - construction.origin);
            }
        }
        for plan in construction.plans() {
            for (name, point) in &plan.points {
                let key = (plan.sheet(), name.clone());
                if point.role == PointRole::Pole {
                    there.push(key.clone());
                }
                places.insert(key, point.vector);
            }
        }
        for (name, ends) in &construction.known_parts {
            let end = places.get(&(Sheet::Acceleration, ends[1].clone())).copied();
            if let Some(end) = end {
                places.entry((Sheet::Acceleration, name.clone())).or_insert(end);
            }
        }
        for (name, place, is_there) in centers(&solution) {
            let key = (Sheet::Centers, name);
            there.extend(is_there.then(|| key.clone()));
            places.insert(key, place);
        }
        let polygons = polygons(&solution);
        if let Some(plan) = construction.forces.as_deref().filter(|_| !polygons.is_empty()) {
            for polygon in &polygons {
                let key = (Sheet::Forces, polygon.start.clone());
                there.push(key.clone());
                places.insert(key, plan.corner(&polygon.start).map_or_else(Vector::zeros, |corner| corner.at));
            }
        }
        let named = if polygons.is_empty() { Vec::new() } else { load_places(construction, mechanism, &pose.points) };
        for (name, place, _) in named.iter().filter(|(.., is_own)| *is_own) {
            let key = (Sheet::Scheme, name.clone());
            if !places.contains_key(&key) {
                there.push(key.clone());
                places.insert(key, place - construction.origin);
            }
        }
        for (name, place) in if polygons.is_empty() { Vec::new() } else { pitch_points(&solution) } {
            let key = (Sheet::Scheme, name);
            if !places.contains_key(&key) {
                there.push(key.clone());
                places.insert(key, place);
            }
        }
        let load_places = named.into_iter().map(|(name, ..)| name).collect();
        let mut sizes = PerSheet::from_fn(|_| 0.0_f64);
        for ((sheet, _), place) in &places {
            sizes[*sheet] = sizes[*sheet].max(place.norm());
        }
        // The polygons are as large as their forces.
        let of_forces = polygons.iter().map(GivenPolygon::size).fold(0.0, f64::max);
        sizes[Sheet::Forces] = sizes[Sheet::Forces].max(of_forces);
        Given { solution, places, there, polygons, load_places, sizes }
    }

    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.solution.mechanism
    }

    /// The plans, with all points.
    #[must_use]
    pub fn construction(&self) -> &Construction {
        &self.solution.construction
    }

    /// Where a point is in the end, by its sheet and name, in units of the sheet; `None` for a name that means nothing there.
    #[must_use]
    pub fn place(&self, sheet: Sheet, name: &str) -> Option<Vector> {
        self.places.get(&(sheet, self.usual(sheet, name))).copied()
    }

    /// The name that a point has in results: `π` for `pi`, `P(1,3)` for `P(3,1)`, `P(2,ground)` for `P(2,0)`.
    pub(super) fn usual(&self, sheet: Sheet, name: &str) -> String {
        let pair = || {
            let parts = QuantityName::parse(name).filter(|name| name.head == Head::Center && name.is_plain())?;
            Some(LinkPair::of_names(&parts.arguments, self.mechanism())?.name(self.mechanism()))
        };
        match sheet {
            Sheet::Acceleration if name == "pi" => Some("π".to_owned()),
            Sheet::Centers => pair(),
            _ => None,
        }
        .unwrap_or_else(|| name.to_owned())
    }

    /// Whether a name is a second one of a point: that of a permanent centre in a pin, which has the pin's.
    pub(super) fn is_second_name(&self, sheet: Sheet, name: &str) -> bool {
        sheet == Sheet::Centers && is_center(name) && self.is_there(name)
    }

    /// The permanent centres in a joint of the figure of instant centres.
    pub(super) fn centers_at(&self, joint: &str) -> impl Iterator<Item = LinkPair> {
        let at = self.place(Sheet::Centers, joint).filter(|_| !is_center(joint));
        let here = self
            .there()
            .filter(move |(sheet, name, place)| self.is_second_name(*sheet, name) && at.is_some_and(|at| at == *place));
        here.filter_map(|(_, name, _)| LinkPair::named(name, self.mechanism()))
    }

    /// A point as sentences name it: an instant centre by its symbol, `P_13`.
    pub(super) fn shown(&self, name: &str) -> String {
        let pair =
            is_center(name).then(|| LinkPair::named(&self.usual(Sheet::Centers, name), self.mechanism())).flatten();
        pair.map_or_else(|| name.to_owned(), |pair| self.symbol(pair))
    }

    /// The symbol of an instant centre in plain text.
    pub(super) fn symbol(&self, pair: LinkPair) -> String {
        let symbol = pair.symbol(0, self.mechanism(), &self.solution.wording().notation, &str::to_owned);
        symbol.replace(['{', '}'], "")
    }

    /// All points of a sheet by their names.
    pub fn places(&self, sheet: Sheet) -> impl Iterator<Item = (&str, Vector)> {
        let on = self.places.iter().filter(move |((other, _), _)| *other == sheet);
        on.map(|((_, name), place)| (name.as_str(), *place))
    }

    /// The points that are there before anything is drawn.
    pub(super) fn there(&self) -> impl Iterator<Item = (Sheet, &str, Vector)> {
        self.there.iter().map(|key| (key.0, key.1.as_str(), self.places[key]))
    }

    /// Whether there is a sheet to draw on: one that has a point from the start.
    pub(super) fn has_sheet(&self, sheet: Sheet) -> bool {
        self.there.iter().any(|(own, _)| *own == sheet)
    }

    /// Whether a point of this name is there before anything is drawn.
    pub(super) fn is_there(&self, name: &str) -> bool {
        self.there.iter().any(|(_, own)| own == name)
    }

    /// The largest distance of a point from a sheet's origin.
    #[must_use]
    pub fn size(&self, sheet: Sheet) -> f64 {
        self.sizes[sheet]
    }

    /// The value of a number by the name of its quantity; of a vector its size. `None` for a name of one's own.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        let Solution { mechanism, construction, .. } = &self.solution;
        // Corners of polygons are the hand's own.
        if QuantityName::parse(name).is_some_and(|name| name.head == Head::Between(Sheet::Forces)) {
            return self.segment(name);
        }
        let name = self.with_usual_centers(&with_usual_poles(name));
        let asked = QuantityRequest::new(&name, mechanism).ok()?;
        let value = asked.value(&self.solution.snapshot(), Some(construction), None).ok();
        value.map(Quantity::as_number).or_else(|| self.segment(&name))
    }

    /// The name of a distance of instant centres, or of a coordinate of one, as results call it.
    fn with_usual_centers(&self, name: &str) -> String {
        let usual = |parts: &QuantityName| match parts.head {
            Head::Center => Some(LinkPair::of_names(&parts.arguments, self.mechanism())?.links())
                .map(|links| links.map(|link| self.mechanism().body(link).name.clone()).to_vec()),
            Head::Between(Sheet::Scheme) => {
                Some(parts.arguments.iter().map(|end| self.usual(Sheet::Centers, end)).collect())
            }
            _ => None,
        };
        let parts = QuantityName::parse(name);
        let found = parts.as_ref().and_then(|parts| Some(parts.with_arguments(usual(parts)?).to_string()));
        found.unwrap_or_else(|| name.to_owned())
    }

    /// The distance of two points of a sheet that have a place here but none in the construction.
    fn segment(&self, name: &str) -> Option<f64> {
        let name = QuantityName::parse(name).filter(QuantityName::is_plain)?;
        let Head::Between(sheet) = name.head else { return None };
        let [from, to] = name.arguments.as_slice() else { return None };
        Some((self.place(sheet, to)? - self.place(sheet, from)?).norm())
    }

    /// The value of a number that the scene gives, with nothing drawn: rates of drives and links that they move, given velocities,
    /// angles, positions. `None` where it is to be found.
    pub(super) fn given_number(&self, name: &str) -> Option<f64> {
        let mechanism = self.mechanism();
        let asked = QuantityRequest::new(name, mechanism).ok()?;
        let is_given = match &asked.what {
            What::Rate(Rate::Angular(_, link)) => mechanism.is_known(*link),
            What::Rate(Rate::Slide(_, slider)) => mechanism.slider(*slider).drive.is_some(),
            What::Angle(_) | What::SlidePosition(_) | What::Coordinate(..) => true,
            // Where accelerations are drawn, inertia follows from them.
            What::Force(force, _) => self.is_given_load(force),
            What::Motion(_, crate::quantity::Spot::Point(_, point, _), None) => {
                // The scene gives the vector itself.
                mechanism.bodies.iter().any(|body| {
                    matches!(body.role, Role::Moving { .. } | Role::Carrier { .. }) && body.points.contains(point)
                })
            }
            _ => false,
        };
        is_given.then(|| self.number(name)).flatten()
    }

    /// Whether a force is a load that is known with nothing drawn.
    fn is_given_load(&self, force: &ForceOf) -> bool {
        let is_inertia = match force {
            ForceOf::Load(load) => load.source == Source::Inertia,
            ForceOf::InertiaForce(_) | ForceOf::InertiaCouple(_) => true,
            _ => return false,
        };
        !is_inertia || !self.construction().by_hand.contains(&Sheet::Acceleration)
    }

    /// The names of the rates that are always equal to this one, as those of a block to its lever's.
    pub(super) fn same_rates<'n>(&'n self, name: &'n str) -> impl Iterator<Item = &'n str> {
        let same = &self.construction().same_rates;
        let usual = same.get(name).map_or(name, String::as_str);
        let others = same.iter().filter(move |(_, other)| *other == usual).map(|(name, _)| name.as_str());
        std::iter::once(usual).chain(others).filter(move |other| *other != name)
    }

    /// The direction that a link with two points, or a guide, gives; `None` for a name that is neither.
    pub(super) fn direction(&self, name: &str) -> Option<Result<Vector, Message>> {
        let Solution { mechanism, pose, scene, .. } = &self.solution;
        if let Some(id) = mechanism.slider_ids().find(|&id| mechanism.slider_name(id) == name) {
            return Some(Ok(pose.guide(id)));
        }
        if let Some(along) = QuantityRequest::new(name, mechanism)
            .ok()
            .and_then(|asked| direction_of_load(&self.solution.construction, &asked))
        {
            return Some(Ok(along));
        }
        let body = mechanism.link(name)?;
        let listed = scene.links.get(name).map_or(&[][..], |link| link.points.as_slice());
        let point = |name: &String| mechanism.point(name).map(|point| pose.point(point));
        if let ([first, last], false) = (listed, body.0 == 0)
            && let (Some(first), Some(last)) = (point(first), point(last))
        {
            return Some(unit(last - first).ok_or_else(|| says::no_direction(name)));
        }
        Some(Err(says::which_points(name)))
    }

    /// Whether a name is that of a link or of a slider, and so no name for a line.
    pub(super) fn is_part(&self, name: &str) -> bool {
        let mechanism = self.mechanism();
        mechanism.link(name).is_some() || mechanism.slider_ids().any(|id| mechanism.slider_name(id) == name)
    }
}

/// How far from the mechanism an instant centre may be that has a place on a board, in sizes of the mechanism: no sheet is larger.
const FARTHEST: f64 = 100.0;

/// The points of the figure of instant centres, where there is one: joints and permanent centres, which are there from the start, and all others
/// by the computed motion, whatever lines the construction leads to them. Each with its place from the mechanism's first point.
fn centers(solution: &Solution) -> Vec<(String, Vector, bool)> {
    let Solution { mechanism, pose, construction, .. } = solution;
    let Some(centers) = construction.centers.as_deref() else { return Vec::new() };
    let joints = mechanism
        .point_ids()
        .map(|point| (mechanism.point_name(point).to_owned(), pose.point(point) - construction.origin, true));
    let mut all: Vec<(String, Vector, bool)> = joints.collect();
    let size = span(pose.points.iter().copied());
    let pairs = if centers.is_too_large { Vec::new() } else { LinkPair::all(mechanism) };
    for pair in pairs {
        let known = centers.of(pair).map(|id| centers.get(id));
        let place = match known {
            Some(center) => center.place.finite(),
            None => by_motion(pair, solution),
        };
        let place = place.map(|place| place - construction.origin).filter(|place| place.norm() <= FARTHEST * size);
        let is_there = known.is_some_and(Center::is_permanent);
        all.extend(place.map(|place| (pair.name(mechanism), place, is_there)));
    }
    all
}

/// The place of a centre by the computed motion; `None` at infinity, and of links that rest on one another.
fn by_motion(pair: LinkPair, solution: &Solution) -> Option<Point> {
    let asked = QuantityRequest::new(&pair.name(&solution.mechanism), &solution.mechanism).ok()?;
    match asked.value(&solution.snapshot(), Some(&solution.construction), None).ok()? {
        Quantity::Vector(place) => Some(Point::from(place)),
        Quantity::Number(_) => None,
    }
}

/// The name of a segment with the pole as results call it.
fn with_usual_poles(name: &str) -> String {
    name.replace("aplan(pi,", "aplan(π,").replace(",pi)", ",π)")
}
