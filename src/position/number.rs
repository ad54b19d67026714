//! How many complex assembly modes a group of links and pins has.

use crate::geometry::Random;
use crate::mechanism::{BodyId, Class, Group, Mechanism, PointId};
use std::collections::BTreeMap;

/// Most links of a group, with the frame as one, whose modes are counted: of more it takes long.
const MOST_LINKS: usize = 13;

/// The largest prime below 2³¹: products of two numbers below it fit 64 bits.
const PRIME: u64 = 0x7fff_ffff;

/// How many real assembly modes a group can have at most.
///
/// Two circles cross twice; the modes of a group of class III or IV are roots of a trigonometric polynomial of degree 3. Those of a group of higher
/// class whose joints are pins are the real ones among its complex modes: of links whose lengths are in no relation there are exactly so many as
/// are counted here, of all others no more that stand by themselves. `None` of groups with other joints, and of more than 12 links.
pub(super) fn most_modes(mechanism: &Mechanism, group: &Group) -> Option<u64> {
    match group.class {
        Class::Second => Some(2),
        Class::Third | Class::Fourth => Some(6),
        Class::Higher => complex_modes(group.links.len() + 1, &held_pins(mechanism, group)?),
    }
}

/// The pins of a group, each with the links that it joins, by their numbers in the group; all bodies of known position are one, which comes last.
/// `None` where other joints hold it.
fn held_pins(mechanism: &Mechanism, group: &Group) -> Option<Vec<Vec<usize>>> {
    let number = |body: BodyId| {
        let lead = mechanism.lead(body);
        group.links.iter().position(|&link| link == lead).unwrap_or(group.links.len())
    };
    let mut pins: BTreeMap<PointId, Vec<usize>> = BTreeMap::new();
    for &id in &group.joints {
        let joint = mechanism.joint(id);
        let point = joint.pin.filter(|_| joint.slider.is_none() && joint.angular.is_none())?;
        let links = pins.entry(point).or_default();
        links.extend(joint.bodies.map(number));
        links.sort_unstable();
        links.dedup();
    }
    Some(pins.into_values().collect())
}

/// The number of complex ways to put together `links` rigid links of lengths in no relation, one of which stands still, with pins that join the
/// links named in each. `None` where they are not just held, or are too many.
///
/// A link turned by an angle is a complex number z; the places of the pins close where the z of all links lie in a linear space, and where their
/// conjugates, the 1/z, lie in the conjugate one. How many do hangs on the matroid M of that space alone, on which links' angles follow from those of
/// others. It is counted by the recursion of J. Capco, M. Gallet, G. Grasegger, C. Koutschan, N. Lubbes, J. Schicho ("The number of realizations of a
/// Laman graph", SIAM Journal on Applied Algebra and Geometry 2, 2018) for pairs of graphs, with M in place of both: a graph of bars has links of two pins
/// only, and of each further pin of a link it would count both sides.
#[must_use]
pub fn complex_modes(links: usize, pins: &[Vec<usize>]) -> Option<u64> {
    if links > MOST_LINKS {
        return None;
    }
    let rows = turns(links, pins);
    let everything = (1 << links) - 1;
    let of_columns = |set: u16| {
        let chosen =
            |row: &Vec<u64>| row.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, x)| *x).collect();
        reduced(rows.iter().map(chosen).collect()).len()
    };
    let mut pairs = Pairs { ranks: (0..=everything).map(of_columns).collect(), counted: BTreeMap::new() };
    let is_held = 2 * pairs.rank(everything) == links + 1;
    is_held.then(|| pairs.count([0, 0], everything))
}

/// A basis of the turns of all links, each times a complex number, with which the pins close; modulo a prime, with random coordinates of the pins.
fn turns(links: usize, pins: &[Vec<usize>]) -> Vec<Vec<u64>> {
    let mut random = Random(0x7069_6e73);
    let mut number = || random.next() % PRIME;
    let mut rows = Vec::new();
    for joined in pins {
        let places: Vec<(usize, u64)> = joined.iter().map(|&link| (link, number())).collect();
        for pair in places.windows(2) {
            // The origins of the links come first, then their turns.
            let mut row = vec![0; 2 * links];
            for (&(link, place), sign) in pair.iter().zip([1, PRIME - 1]) {
                row[link] = sign;
                row[links + link] = place * sign % PRIME;
            }
            rows.push(row);
        }
    }
    let rows = reduced(rows);
    let leading: Vec<Option<usize>> = rows.iter().map(|row| row.iter().position(|&x| x != 0)).collect();
    let free = (0..2 * links).filter(|column| !leading.contains(&Some(*column)));
    let solution = |free: usize| {
        let of = |column: usize| match leading.iter().position(|&first| first == Some(column)) {
            Some(row) => (PRIME - rows[row][free]) % PRIME,
            None => u64::from(column == free),
        };
        (links..2 * links).map(of).collect()
    };
    reduced(free.map(solution).collect())
}

/// The rows of a matrix in reduced echelon form, modulo the prime, without those of zeros.
fn reduced(mut rows: Vec<Vec<u64>>) -> Vec<Vec<u64>> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..columns {
        let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
        rows.swap(rank, pivot);
        let inverse = inverse(rows[rank][column]);
        rows[rank].iter_mut().for_each(|x| *x = *x * inverse % PRIME);
        let first = rows[rank].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != rank) {
            let times = (PRIME - row[column]) % PRIME;
            row.iter_mut().zip(&first).for_each(|(x, y)| *x = (*x + times * y) % PRIME);
        }
        rank += 1;
    }
    rows.truncate(rank);
    rows
}

/// The inverse modulo the prime, by Fermat's little theorem.
fn inverse(number: u64) -> u64 {
    let mut power = number;
    let mut inverse = 1;
    let mut exponent = PRIME - 2;
    while exponent > 0 {
        if exponent & 1 == 1 {
            inverse = inverse * power % PRIME;
        }
        power = power * power % PRIME;
        exponent >>= 1;
    }
    inverse
}

/// Pairs of minors of a matroid, whose elements are bits.
struct Pairs {
    /// By set of elements.
    ranks: Vec<usize>,
    /// What has been counted: by what is contracted in the first and in the second minor, and their elements.
    counted: BTreeMap<([u16; 2], u16), u64>,
}

impl Pairs {
    fn rank(&self, set: u16) -> usize {
        self.ranks[usize::from(set)]
    }

    /// The number of a pair on these elements, with the sets that have been contracted in each.
    fn count(&mut self, contracted: [u16; 2], elements: u16) -> u64 {
        let added = |set: u16| contracted.map(|out| self.rank(out | set) - self.rank(out));
        let size = elements.count_ones() as usize;
        let bits = (0..16).map(|bit| 1 << bit).filter(|bit| elements & bit != 0);
        if size == 0 {
            return 1;
        }
        if added(elements).iter().sum::<usize>() != size + 1 || bits.clone().any(|bit| added(bit).contains(&0)) {
            return 0;
        }
        if size == 1 {
            return 1;
        }
        if let Some(&known) = self.counted.get(&(contracted, elements)) {
            return known;
        }
        let first = elements & elements.wrapping_neg();
        let others = elements ^ first;
        let [left, right] = contracted;
        let mut sum = 0;
        let mut part = others;
        loop {
            let rest = others ^ part;
            let number = self.count([left | first | part, right], rest);
            if number > 0 {
                sum += number * self.count([left, right | first | rest], part);
            }
            if part == 0 {
                break;
            }
            part = (part - 1) & others;
        }
        self.counted.insert((contracted, elements), sum);
        sum
    }
}
