//! In which order instant centres are found: Kennedy's theorem as a search, without a figure but for the sines of its crossings.
//!
//! Three links have their three centres on one line (S. H. Aronhold 1872, A. B. W. Kennedy 1886). So a centre is found where two such
//! lines cross, each over one third link. In the circle diagram links are corners and known centres edges: a missing edge that
//! closes two triangles can be drawn.

use core::cmp::Ordering;

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
    pub fn has(&self, [a, b]: Two) -> bool {
        self.edges[a * self.links + b]
    }

    /// Adds an edge.
    pub fn add(&mut self, [a, b]: Two) {
        self.edges[a * self.links + b] = true;
        self.edges[b * self.links + a] = true;
    }

    /// The pairs without an edge, in order.
    pub fn missing(&self) -> impl Iterator<Item = Two> {
        let pairs = (0..self.links).flat_map(|a| (a + 1..self.links).map(move |b| [a, b]));
        pairs.filter(|&pair| !self.has(pair))
    }

    /// The crossings that give a centre with the edges that there are.
    fn crossings(&self, center: Two) -> impl Iterator<Item = Crossed> {
        let [i, j] = center;
        let thirds = move |&k: &usize| k != i && k != j && self.has(two(i, k)) && self.has(two(j, k));
        let thirds: Vec<usize> = (0..self.links).filter(thirds).collect();
        let pairs = (0..thirds.len()).flat_map(|first| (first + 1..thirds.len()).map(move |second| [first, second]));
        let crossings: Vec<Crossed> =
            pairs.map(|[first, second]| Crossed { center, over: [thirds[first], thirds[second]] }).collect();
        crossings.into_iter()
    }
}

/// Marks all centres that Kennedy's lines reach, always the one whose lines cross best next, and adds them to the diagram.
pub fn reach(diagram: &mut Diagram, figure: &mut impl Lines) -> Vec<Crossed> {
    let mut found = Vec::new();
    loop {
        let mut best: Option<(f64, Crossed)> = None;
        for crossed in diagram.missing().flat_map(|center| diagram.crossings(center)) {
            if let Some(sine) = figure.sine(&crossed).filter(|sine| best.is_none_or(|(most, _)| *sine > most)) {
                best = Some((sine, crossed));
            }
        }
        let Some((_, crossed)) = best else { return found };
        figure.mark(&crossed);
        diagram.add(crossed.center);
        found.push(crossed);
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
    let mut search = Search { known, all: &all, figure, best: first, least, work: WORK };
    search.go(&mut todo, &mut Vec::new(), f64::INFINITY);
    let best = search.best;
    in_order(known, &best)
}

/// How many choices are tried.
const WORK: usize = 40_000;

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
}

impl<L: Lines> Search<'_, L> {
    /// Looks for the centres still to be found, after those that are taken with this least sine.
    fn go(&mut self, todo: &mut Vec<Two>, taken: &mut Vec<Crossed>, least: f64) {
        if self.work == 0 || !self.is_better(todo.len() + taken.len(), least) {
            return;
        }
        self.work -= 1;
        let Some(center) = todo.pop() else {
            (self.best, self.least) = (taken.clone(), least);
            return;
        };
        let is_new = |pair: &Two, todo: &[Two], taken: &[Crossed]| {
            !self.known.has(*pair) && !todo.contains(pair) && taken.iter().all(|crossed| crossed.center != *pair)
        };
        let mut ways: Vec<(usize, f64, Crossed)> = Vec::new();
        for crossed in self.all.crossings(center) {
            let is_circular = |pair: &Two| *pair == center || leads_to(taken, *pair, center);
            if crossed.needs().iter().any(is_circular) {
                continue;
            }
            if let Some(sine) = self.figure.sine(&crossed) {
                let new = crossed.needs().iter().filter(|pair| is_new(pair, todo, taken)).count();
                ways.push((new, sine, crossed));
            }
        }
        ways.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.partial_cmp(&a.1).unwrap_or(Ordering::Equal)));
        for (_, sine, crossed) in ways {
            let before = todo.len();
            for pair in crossed.needs() {
                let is_known = self.known.has(pair) || taken.iter().any(|crossed| crossed.center == pair);
                if !is_known && !todo.contains(&pair) {
                    todo.push(pair);
                }
            }
            taken.push(crossed);
            self.go(&mut todo.clone(), taken, least.min(sine));
            taken.pop();
            todo.truncate(before);
        }
        todo.push(center);
    }

    fn is_better(&self, count: usize, least: f64) -> bool {
        match count.cmp(&self.best.len()) {
            Ordering::Less => true,
            Ordering::Equal => least > self.least,
            Ordering::Greater => false,
        }
    }
}

/// Whether a centre is found from another one, over the crossings that are taken.
fn leads_to(taken: &[Crossed], center: Two, from: Two) -> bool {
    let Some(crossed) = taken.iter().find(|crossed| crossed.center == center) else { return false };
    crossed.needs().iter().any(|need| *need == from || leads_to(taken, *need, from))
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
