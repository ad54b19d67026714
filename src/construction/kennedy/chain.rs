//! A chain of links with the places of its centres: where lines cross, and what is done where Kennedy's lines alone do not lead on.
//!
//! # Where they do not: leave a link out
//!
//! Of chains with one freedom and up to eight links, the double butterfly and the single flier have centres that no two lines over
//! third links give (G. R. Pennock, E. C. Kinzel, J. Mech. Des. 126, 2004; R. Di Gregorio, J. Mech. Des. 130, 2008). Without a link L that joins two links a and b alone the
//! chain has two freedoms; twists of b against a are then sums of two, so P_ab lies on a line, whatever the motion. Two neighbours glued together take
//! one freedom away, and Kennedy's lines lead to a point of that line; two other neighbours give a second point. L in its place puts P_ab on the line of its own two
//! centres with a and b, and so it is where that line crosses the first (D. E. Foster, G. R. Pennock, J. Mech. Des. 125, 2003).

use super::order::{Crossed, Diagram, Lines, Two, reach, shortest, two};

/// A point of the projective plane, as a vector of length 1: (x : y : weight) in a frame at the mechanism whose unit is its size. At
/// infinity the weight is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homogeneous([f64; 3]);

/// A line of the projective plane: (a : b : c) of a x + b y + c = 0, of length 1. The line at infinity is (0 : 0 : 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectiveLine([f64; 3]);

/// Below this part of the mechanism's size two centres are one, and two lines are one.
const ONE: f64 = 1e-9;
/// A weight below this part of the place is rounding.
const NO_WEIGHT: f64 = 1e-12;

impl Homogeneous {
    /// A point in the frame of the chain.
    #[must_use]
    pub fn at(x: f64, y: f64) -> Homogeneous {
        Homogeneous([x, y, 1.0]).normalized()
    }

    /// The point at infinity in a direction.
    #[must_use]
    pub fn towards(x: f64, y: f64) -> Homogeneous {
        Homogeneous([x, y, 0.0]).normalized()
    }

    fn normalized(self) -> Homogeneous {
        let Homogeneous([x, y, weight]) = self;
        let is_far = weight.abs() <= NO_WEIGHT * libm::hypot(x, y);
        let all = [x, y, if is_far { 0.0 } else { weight }];
        Homogeneous(all.map(|part| part / norm(all)))
    }

    /// Whether it is at infinity.
    #[must_use]
    pub fn is_at_infinity(self) -> bool {
        self.0[2] == 0.0
    }

    /// The point in the frame of the chain, or at infinity its direction.
    #[must_use]
    pub fn place(self) -> [f64; 2] {
        let [x, y, weight] = self.0;
        if weight == 0.0 { [x, y] } else { [x / weight, y / weight] }
    }

    /// The line through this point and another; `None` where they are one.
    #[must_use]
    pub fn joined(self, other: Homogeneous) -> Option<ProjectiveLine> {
        crossed(self.0, other.0).map(ProjectiveLine)
    }
}

impl ProjectiveLine {
    /// Where this line crosses another; `None` where they are one.
    #[must_use]
    pub fn crossing(self, other: ProjectiveLine) -> Option<Homogeneous> {
        crossed(self.0, other.0).map(|point| Homogeneous(point).normalized())
    }

    /// The sine of the angle between two lines: 1 where one is that at infinity, 0 of parallel lines.
    #[must_use]
    pub fn sine(self, other: ProjectiveLine) -> f64 {
        let size = |line: ProjectiveLine| libm::hypot(line.0[0], line.0[1]);
        let sizes = size(self) * size(other);
        if self.is_at_infinity() || other.is_at_infinity() {
            return 1.0;
        }
        ((self.0[0] * other.0[1] - self.0[1] * other.0[0]) / sizes).abs()
    }

    fn is_at_infinity(self) -> bool {
        libm::hypot(self.0[0], self.0[1]) <= NO_WEIGHT
    }
}

fn norm([a, b, c]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(a, b), c)
}

/// The cross product of two vectors of length 1, at length 1; `None` where they are one.
fn crossed(a: [f64; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let product = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let size = norm(product);
    (size > ONE).then(|| product.map(|part| part / size))
}

/// The places of the centres of a chain, by two links.
#[derive(Clone, Debug)]
pub struct Places {
    links: usize,
    places: Vec<Option<Homogeneous>>,
}

impl Places {
    /// Those of a chain of so many links.
    #[must_use]
    pub fn new(links: usize) -> Places {
        Places { links, places: vec![None; links * links] }
    }

    /// The place of a centre, if it is known.
    #[must_use]
    pub fn get(&self, [a, b]: Two) -> Option<Homogeneous> {
        self.places[a * self.links + b]
    }

    /// Puts a centre in its place.
    pub fn put(&mut self, [a, b]: Two, place: Homogeneous) {
        self.places[a * self.links + b] = Some(place);
    }

    /// The line over a third link.
    fn line(&self, [i, j]: Two, over: usize) -> Option<ProjectiveLine> {
        self.get(two(i, over))?.joined(self.get(two(j, over))?)
    }

    fn lines(&self, crossed: &Crossed) -> Option<[ProjectiveLine; 2]> {
        let [first, second] = crossed.over.map(|over| self.line(crossed.center, over));
        Some([first?, second?])
    }
}

impl Lines for Places {
    fn sine(&self, crossed: &Crossed) -> Option<f64> {
        let [first, second] = self.lines(crossed)?;
        first.crossing(second)?;
        Some(first.sine(second))
    }

    fn mark(&mut self, crossed: &Crossed) {
        let place = self.lines(crossed).and_then(|[first, second]| first.crossing(second));
        if let Some(place) = place {
            self.put(crossed.center, place);
        }
    }
}

/// The crossings that lead to a centre where two neighbours are glued together.
#[derive(Clone, Debug, PartialEq)]
pub struct Glued {
    /// The neighbours: the first stands for both.
    pub together: Two,
    /// The crossings; the last one is the centre's. Empty where the centre is that of a joint.
    pub crossings: Vec<Crossed>,
    /// Where the centre then is.
    pub place: Homogeneous,
}

/// A centre that is found without a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// The centre.
    pub center: Two,
    /// The link that is left out: it joins the two links of the centre, and no other.
    pub link: usize,
    /// Two ways to glue.
    pub glued: [Glued; 2],
    /// The sine of the angle between the line of both and that of the link.
    pub sine: f64,
}

impl LeftOut {
    /// How many crossings it takes.
    fn work(&self) -> usize {
        self.glued.iter().map(|glued| glued.crossings.len()).sum()
    }
}

/// How a centre is found.
#[derive(Clone, Debug, PartialEq)]
pub enum Way {
    /// Where two lines cross.
    Crossed(Crossed),
    /// With a link left out.
    LeftOut(LeftOut),
}

/// How the wanted centres of a chain are found from its permanent ones, in order; their places are then in `places`. With `leaves_out` also
/// by leaving links out, which is right only for a chain with one freedom.
#[must_use]
pub fn ways(permanent: &[Two], places: &mut Places, wanted: &[Two], leaves_out: bool) -> Vec<Way> {
    let mut known = Diagram::new(places.links, permanent.iter().copied());
    let joints = places.clone();
    let mut found = Vec::new();
    loop {
        let mut all = known.clone();
        let reached = reach(&mut all, places);
        let is_left = wanted.iter().any(|&pair| !all.has(pair));
        let next = if is_left && leaves_out { without_a_link(permanent, &joints, &all) } else { None };
        let Some(left_out) = next else {
            found.extend(shortest(&known, &reached, wanted, places).into_iter().map(Way::Crossed));
            return found;
        };
        let cross = |places: &Places| {
            let [first, second] = left_out.glued.each_ref().map(|glued| glued.place);
            first.joined(second)?.crossing(places.line(left_out.center, left_out.link)?)
        };
        let Some(place) = cross(places) else { return found };
        // What has been reached so far is found again, from more.
        for crossed in &reached {
            let [a, b] = crossed.center;
            places.places[a * places.links + b] = None;
        }
        places.put(left_out.center, place);
        known.add(left_out.center);
        found.push(Way::LeftOut(left_out));
    }
}

/// The centre that is found with the least work by leaving out a link; `None` if there is none. `reached` are those that are known.
fn without_a_link(permanent: &[Two], joints: &Places, reached: &Diagram) -> Option<LeftOut> {
    let mut best: Option<LeftOut> = None;
    for link in 0..joints.links {
        let ends: Vec<usize> = neighbours(permanent, link).collect();
        let &[a, b] = ends.as_slice() else { continue };
        let center = two(a, b);
        let Some(own) = joints.line(center, link).filter(|_| !reached.has(center)) else { continue };
        let others: Vec<Two> = permanent.iter().copied().filter(|pair| !pair.contains(&link)).collect();
        let glued: Vec<Glued> = others.iter().filter_map(|&together| glue(&others, joints, center, together)).collect();
        for (index, first) in glued.iter().enumerate() {
            for second in &glued[index + 1..] {
                let line = first.place.joined(second.place);
                let Some(line) = line.filter(|line| line.crossing(own).is_some()) else { continue };
                let found = LeftOut { center, link, glued: [first.clone(), second.clone()], sine: line.sine(own) };
                let is_better = |best: &LeftOut| {
                    let [own, other] = [found.work(), best.work()];
                    own < other || own == other && found.sine > best.sine
                };
                if best.as_ref().is_none_or(is_better) {
                    best = Some(found);
                }
            }
        }
    }
    best
}

/// The links joined to a link, in order.
fn neighbours(permanent: &[Two], link: usize) -> impl Iterator<Item = usize> {
    permanent.iter().filter_map(move |&[a, b]| match () {
        () if a == link => Some(b),
        () if b == link => Some(a),
        () => None,
    })
}

/// How a centre is found where two neighbours are one link; `None` where Kennedy's lines do not lead to it.
fn glue(permanent: &[Two], joints: &Places, center: Two, together: Two) -> Option<Glued> {
    let [kept, gone] = together;
    let named = |link: usize| if link == gone { kept } else { link };
    let of = |[a, b]: Two| two(named(a), named(b));
    if center == together {
        return None;
    }
    let mut places = Places::new(joints.links);
    let mut edges: Vec<Two> = Vec::new();
    for &pair in permanent.iter().filter(|pair| **pair != together) {
        // A neighbour of both would be rigid with them.
        if edges.contains(&of(pair)) {
            return None;
        }
        edges.push(of(pair));
        places.put(of(pair), joints.get(pair)?);
    }
    let center = of(center);
    let known = Diagram::new(joints.links, edges);
    if known.has(center) {
        return Some(Glued { together, crossings: Vec::new(), place: places.get(center)? });
    }
    let mut all = known.clone();
    let reached = reach(&mut all, &mut places);
    let crossings = shortest(&known, &reached, &[center], &places);
    (!crossings.is_empty()).then_some(())?;
    Some(Glued { together, crossings, place: places.get(center)? })
}
