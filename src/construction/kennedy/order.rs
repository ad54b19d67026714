//! In which order instant centres are found: Kennedy's theorem as a search, without a figure but for the sines of its crossings.
//!
//! Three links have their three centres on one line (S. H. Aronhold 1872, A. B. W. Kennedy 1886). So a centre is found where two such
//! lines cross, each over one third link. In the circle diagram links are corners and known centres edges: a missing edge that
//! closes two triangles can be drawn.

use core::cmp::Ordering;
use std::rc::Rc;

/// Two links by their numbers, the smaller first.
pub type Two = [usize; 2];

/// Two links in order.
#[must_use]
pub fn two(a: usize, b: usize) -> Two {
    if a < b { [a, b] } else { [b, a] }
}

/// A centre where two lines cross, one over each of two other links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crossed {
    /// The links whose centre it is.
    pub center: Two,
    /// The third links, the smaller number first.
    pub over: [usize; 2],
}

impl Crossed {
    /// The four centres that its lines run through.
    #[must_use]
    pub fn needs(&self) -> [Two; 4] {
        let [i, j] = self.center;
        let [k, l] = self.over;
        [two(i, k), two(j, k), two(i, l), two(j, l)]
    }
}

/// What the search asks of a figure.
pub trait Lines {
    /// The sine of the angle between the two lines of a crossing, whose four centres are known; `None` where the centres of a line
    /// coincide, or both lines are one.
    fn sine(&self, crossed: &Crossed) -> Option<f64>;
    /// Marks the centre where its lines cross.
    fn mark(&mut self, crossed: &Crossed);
}

/// The circle diagram: links are corners, centres that are known are edges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagram {
    links: usize,
    edges: Vec<bool>,
}

impl Diagram {
    /// The diagram of so many links with these edges.
    #[must_use]
    pub fn new(links: usize, edges: impl IntoIterator<Item = Two>) -> Diagram {
        let mut diagram = Diagram { links, edges: vec![false; links * links] };
        edges.into_iter().for_each(|edge| diagram.add(edge));
        diagram
    }

    /// How many links it has.
    #[must_use]
    pub fn links(&self) -> usize {
        self.links
    }

    /// Whether a centre is known.
    #[must_use]
    pub fn has(&self, pair: Two) -> bool {
        self.edges[self.index(pair)]
    }

    /// Adds an edge.
    pub fn add(&mut self, [a, b]: Two) {
        self.edges[a * self.links + b] = true;
        self.edges[b * self.links + a] = true;
    }

    /// Takes an edge away.
    fn remove(&mut self, [a, b]: Two) {
        self.edges[a * self.links + b] = false;
        self.edges[b * self.links + a] = false;
    }

    /// The pairs without an edge, in order.
    pub fn missing(&self) -> impl Iterator<Item = Two> {
        let pairs = (0..self.links).flat_map(|a| (a + 1..self.links).map(move |b| [a, b]));
        pairs.filter(|&pair| !self.has(pair))
    }

    /// The place of a pair among all.
    fn index(&self, [a, b]: Two) -> usize {
        a * self.links + b
    }

    /// The links over which there is a line to a centre.
    fn thirds(&self, [i, j]: Two) -> impl Iterator<Item = usize> {
        (0..self.links).filter(move |&k| k != i && k != j && self.has(two(i, k)) && self.has(two(j, k)))
    }

    /// The crossings that give a centre with the edges that there are.
    fn crossings(&self, center: Two) -> impl Iterator<Item = Crossed> {
        let thirds = self.thirds(center);
        thirds.flat_map(move |first| {
            let later = self.thirds(center).filter(move |&second| second > first);
            later.map(move |second| Crossed { center, over: [first, second] })
        })
    }

    /// Those of them with the line over a third link.
    fn crossings_over(&self, center: Two, third: usize) -> impl Iterator<Item = Crossed> {
        let others = self.thirds(center).filter(move |&other| other != third);
        others.map(move |other| Crossed { center, over: two(third, other) })
    }
}

/// A crossing with the sine of the angle between its lines.
type Steep = (f64, Crossed);

/// Marks all centres that Kennedy's lines reach, always the one whose lines cross best next, and adds them to the diagram.
pub fn reach(diagram: &mut Diagram, figure: &mut impl Lines) -> Vec<Crossed> {
    let mut found = Vec::new();
    // The best crossing of each centre that is missing; the first of equal ones.
    let mut best: Vec<Option<Steep>> = vec![None; diagram.links * diagram.links];
    let put = |best: &mut Option<Steep>, figure: &_, crossed: Crossed| {
        let Some(sine) = Lines::sine(figure, &crossed) else { return };
        if best.is_none_or(|(most, other)| sine > most || sine == most && crossed.over < other.over) {
            *best = Some((sine, crossed));
        }
    };
    for center in diagram.missing() {
        let best = &mut best[diagram.index(center)];
        diagram.crossings(center).for_each(|crossed| put(best, &*figure, crossed));
    }
    loop {
        let all = best.iter().flatten();
        let next = all.fold(
            None,
            |most: Option<Steep>, own| if most.is_none_or(|most| own.0 > most.0) { Some(*own) } else { most },
        );
        let Some((_, crossed)) = next else { return found };
        figure.mark(&crossed);
        diagram.add(crossed.center);
        best[diagram.index(crossed.center)] = None;
        found.push(crossed);
        // New are the lines over each end of the new edge.
        let [a, b] = crossed.center;
        for (own, third) in [(a, b), (b, a)] {
            for other in (0..diagram.links).filter(|&link| link != own && diagram.has(two(third, link))) {
                let center = two(own, other);
                if !diagram.has(center) {
                    let best = &mut best[diagram.index(center)];
                    diagram.crossings_over(center, third).for_each(|crossed| put(best, &*figure, crossed));
                }
            }
        }
    }
}

/// The fewest crossings that lead to the centres wanted, and of those the ones whose flattest crossing is steepest; each after those it needs.
///
/// `known` has the centres that are there, `reached` are those that [`reach`] has found from them and marked in the figure. Centres that are not
/// among them are left out. The search ends after so much work, and then has what it has found by then: that is not always the fewest.
#[must_use]
pub fn shortest(known: &Diagram, reached: &[Crossed], wanted: &[Two], figure: &impl Lines) -> Vec<Crossed> {
    let is_reached = |pair: &Two| reached.iter().any(|crossed| crossed.center == *pair);
    let mut todo: Vec<Two> = Vec::new();
    for pair in wanted.iter().filter(|pair| !known.has(**pair) && is_reached(pair)) {
        if !todo.contains(pair) {
            todo.push(*pair);
        }
    }
    let first = needed(reached, &todo);
    if todo.len() == first.len() {
        return first;
    }
    let mut all = known.clone();
    reached.iter().for_each(|crossed| all.add(crossed.center));
    let least = first.iter().filter_map(|crossed| figure.sine(crossed)).fold(f64::INFINITY, f64::min);
    let mut search = Search {
        known,
        all: &all,
        figure,
        best: first,
        least,
        work: WORK,
        looks: LOOKS,
        ways: vec![None; known.links * known.links],
    };
    search.go(&mut todo, &mut Vec::new(), f64::INFINITY);
    let best = search.best;
    in_order(known, &best)
}

/// How many choices are tried.
const WORK: usize = 40_000;
/// How many crossings are looked at for them: forty times as many as chains of eight links need. In a larger one fewer choices are tried.
const LOOKS: usize = 100_000;

/// Of crossings, each after those it needs, the ones that these centres need.
fn needed(crossings: &[Crossed], wanted: &[Two]) -> Vec<Crossed> {
    let mut wanted = wanted.to_vec();
    let mut kept: Vec<Crossed> = Vec::new();
    for crossed in crossings.iter().rev() {
        if wanted.contains(&crossed.center) {
            wanted.extend(crossed.needs());
            kept.push(*crossed);
        }
    }
    kept.reverse();
    kept
}

/// A search backwards from what is wanted, by branch and bound.
struct Search<'a, L> {
    known: &'a Diagram,
    all: &'a Diagram,
    figure: &'a L,
    best: Vec<Crossed>,
    /// The least sine of the best.
    least: f64,
    work: usize,
    looks: usize,
    /// By pair: the crossings that give its centre, once they were looked for.
    ways: Vec<Option<Rc<[Steep]>>>,
}

impl<L: Lines> Search<'_, L> {
    /// Looks for the centres still to be found, after those that are taken with this least sine.
    fn go(&mut self, todo: &mut Vec<Two>, taken: &mut Vec<Crossed>, least: f64) {
        if self.work == 0 || self.looks == 0 || !self.is_better(todo.len() + taken.len(), least) {
            return;
        }
        self.work -= 1;
        let Some(center) = todo.pop() else {
            (self.best, self.least) = (taken.clone(), least);
            return;
        };
        let steep = self.ways_to(center);
        self.looks = self.looks.saturating_sub(steep.len());
        let links = self.known.links;
        let from_it = leading_to(taken, center, links);
        let mut new = Diagram::new(links, self.known.missing());
        todo.iter().chain(taken.iter().map(|crossed| &crossed.center)).for_each(|pair| new.remove(*pair));
        let mut ways: Vec<(usize, f64, Crossed)> = Vec::new();
        for &(sine, crossed) in steep.iter() {
            let needs = crossed.needs();
            if !needs.iter().any(|pair| from_it.has(*pair)) {
                ways.push((needs.iter().filter(|pair| new.has(**pair)).count(), sine, crossed));
            }
        }
        ways.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.partial_cmp(&a.1).unwrap_or(Ordering::Equal)));
        for (_, sine, crossed) in ways {
            let before = todo.len();
            todo.extend(crossed.needs().into_iter().filter(|pair| new.has(*pair)));
            taken.push(crossed);
            self.go(&mut todo.clone(), taken, least.min(sine));
            taken.pop();
            todo.truncate(before);
        }
        todo.push(center);
    }

    /// The crossings that give a centre.
    fn ways_to(&mut self, center: Two) -> Rc<[Steep]> {
        let Search { all, figure, ways, .. } = self;
        let steep = || all.crossings(center).filter_map(|crossed| Some((figure.sine(&crossed)?, crossed))).collect();
        ways[all.index(center)].get_or_insert_with(steep).clone()
    }

    fn is_better(&self, count: usize, least: f64) -> bool {
        match count.cmp(&self.best.len()) {
            Ordering::Less => true,
            Ordering::Equal => least > self.least,
            Ordering::Greater => false,
        }
    }
}

/// A centre and those that are found from it, over the crossings that are taken.
fn leading_to(taken: &[Crossed], center: Two, links: usize) -> Diagram {
    let mut from_it = Diagram::new(links, [center]);
    let mut is_complete = false;
    while !is_complete {
        is_complete = true;
        // What is taken later is mostly needed by what was taken before.
        for crossed in taken.iter().rev().filter(|crossed| crossed.center != center) {
            if !from_it.has(crossed.center) && crossed.needs().iter().any(|need| from_it.has(*need)) {
                from_it.add(crossed.center);
                is_complete = false;
            }
        }
    }
    from_it
}

/// Crossings in an order in which each comes after those it needs.
fn in_order(known: &Diagram, crossings: &[Crossed]) -> Vec<Crossed> {
    let mut diagram = known.clone();
    let mut left: Vec<Crossed> = crossings.to_vec();
    let mut ordered = Vec::new();
    while let Some(at) = left.iter().position(|crossed| crossed.needs().iter().all(|need| diagram.has(*need))) {
        let crossed = left.remove(at);
        diagram.add(crossed.center);
        ordered.push(crossed);
    }
    ordered
}
