//! All complex assemblies of a group of links and pins, by paths from those of other lengths.

use super::closing::Assembled;
use super::frames::{Frames, pinned, placement_in_compound};
use crate::geometry::{Point, Random, Turn};
use crate::mechanism::{BodyId, Group, JointId, Mechanism};
use num_complex::Complex64 as Complex;
use num_traits::Zero;
use std::f64::consts::{PI, TAU};

/// Most loops of a group.
pub(super) const MOST_LOOPS: usize = 6;

/// Most paths between the same two lengths: with so many, hardly an assembly is not reached.
const MOST_WAYS: usize = 24;

/// How far the logarithm of a product goes astray on a way, times 4; as much more on every so many-th further way.
const SWELL: f64 = 12.0;
const SWELLING: usize = 4;

/// The first step of a path, of its whole length 1, and the smallest.
const FIRST_STEP: f64 = 0.05;
const SMALLEST_STEP: f64 = 1e-11;

/// How far a step of a path may be off, in parts of the numbers: in the first try, and in further ones where two paths have run together.
const OFF: [f64; 3] = [1e-3, 1e-5, 1e-7];

/// By how many times a step is less off than it may be where the next is twice as long: the error grows with the fifth power.
const EASY: f64 = 50.0;

/// The part of the numbers by which the last correction changes them on the way, and at the end.
const ON_THE_WAY: f64 = 1e-8;
const AT_THE_END: f64 = 1e-12;

/// Two assemblies are the same where no number differs by more than this part.
const SAME: f64 = 1e-6;

/// How far from 1 the squared modulus of a real rotation may be, where a path has come to its end and where it has not, as beside a double root. Closing
/// the loops decides.
const REAL: f64 = 1e-3;
const NEARLY_REAL: f64 = 0.1;

/// A group of links and pins as two linear spaces: the rotations z of its links, complex numbers, lie in one, their conjugates w in the conjugate one.
///
/// Real assemblies have z w = 1 for every link. Where z w = λ for any complex λ, as for links lengthened by λ, there are equally many, and all of them come
/// from each other when λ runs in circles, because the pairs (z, w) of both spaces are one connected piece (A. J. Sommese, C. W. Wampler, "The Numerical
/// Solution of Systems of Polynomials Arising in Engineering and Science", 2005, chapter 15; T. Duff et al., "Solving polynomial systems via homotopy
/// continuation and monodromy", IMA Journal of Numerical Analysis 39, 2019). The first has any z, with its conjugate as w;
/// the others are found by going to and fro until all are there; from these, paths lead to λ = 1.
pub(super) struct Paths<'a> {
    mechanism: &'a Mechanism,
    known: &'a Frames,
    slides: &'a [f64],
    links: Vec<BodyId>,
    /// The links whose rotations follow, each with the row that says how: z = −(Σ row z + constant) over the free links.
    bound: Vec<(usize, [Complex; MOST_LOOPS], Complex)>,
    /// The links whose rotations are free.
    free: Vec<usize>,
    /// By link: the logarithm of the frame's size in parts of the link's.
    scales: Vec<f64>,
    random: Random,
    /// How many paths have been followed.
    pub followed: usize,
}

/// Numbers of the free links.
type Free = [Complex; MOST_LOOPS];

/// The rounds of a way, and by its end the assemblies from which it has been gone.
type Gone = (Vec<[f64; 3]>, [Vec<usize>; 2]);

/// A way through the products λ of all links, from real ones to others, whose logarithms it is given: each goes round zero some times, with a wave of its
/// angle and of its logarithm.
struct Way<'w> {
    ends: [&'w [f64]; 2],
    rounds: &'w [[f64; 3]],
}

impl Way<'_> {
    /// The products and their rates.
    fn at(&self, t: f64) -> Vec<[Complex; 2]> {
        let [from, to] = self.ends;
        let logarithms = from.iter().zip(to).zip(self.rounds);
        let product = |((&from, &to), &[turn, wave, swell]): ((&f64, &f64), &[f64; 3])| {
            let (sine, cosine) = libm::sincos(turn * t + wave * t * (1.0 - t));
            let product = Complex::new(cosine, sine) * libm::exp(from + (to - from) * t + swell * t * (1.0 - t));
            [product, product * Complex::new(to - from + swell * (1.0 - 2.0 * t), turn + wave * (1.0 - 2.0 * t))]
        };
        logarithms.map(product).collect()
    }
}

/// Where a path ends, and whether the assembly there stands by itself.
struct End {
    free: Free,
    is_regular: bool,
}

impl<'a> Paths<'a> {
    /// `None` for groups with other joints than pins, or too many loops.
    pub(super) fn new(
        mechanism: &'a Mechanism,
        group: &Group,
        known: &'a Frames,
        slides: &'a [f64],
    ) -> Option<Paths<'a>> {
        let links = group.links.clone();
        let is_pinned = group.joints.iter().all(|&joint| mechanism.joint(joint).pin.is_some());
        if !is_pinned || group.loops.len() > MOST_LOOPS || links.len() != 2 * group.loops.len() {
            return None;
        }
        let in_lead = |joint: JointId, lead: BodyId| {
            let side = mechanism.side(joint, lead);
            placement_in_compound(mechanism, lead, side) * mechanism.joint_on(joint, side)
        };
        let complex = |from: Point, to: Point| Complex::new(to.x - from.x, to.y - from.y);
        let mut rows = Vec::new();
        for chain in &group.loops {
            let mut row = vec![Complex::zero(); links.len()];
            let mut constant = Complex::zero();
            let mut add = |before: JointId, body: BodyId, after: JointId| {
                let link = links.iter().position(|&link| link == body)?;
                row[link] += complex(in_lead(before, body), in_lead(after, body));
                Some(())
            };
            for (joints, &body) in chain.joints.windows(2).zip(&chain.bodies[1..]) {
                add(joints[0], body, joints[1])?;
            }
            let (&first, &last) = (chain.joints.first()?, chain.joints.last()?);
            if chain.closed {
                add(last, chain.bodies[0], first)?;
            } else {
                let place = |joint: JointId, body: BodyId| {
                    let side = mechanism.side(joint, body);
                    Some(known.of(side)? * mechanism.joint_on(joint, side))
                };
                constant = complex(place(last, *chain.bodies.last()?)?, place(first, chain.bodies[0])?);
            }
            rows.push((row, constant));
        }
        let largest = |sizes: &mut dyn Iterator<Item = f64>| sizes.fold(f64::MIN_POSITIVE, f64::max);
        let frame = largest(&mut rows.iter().map(|(_, constant)| constant.norm_sqr()));
        let size = |link: usize| largest(&mut rows.iter().map(|(row, _)| row[link].norm_sqr()));
        let scales = (0..links.len()).map(|link| 0.5 * libm::log(frame / size(link))).collect();
        let mut paths = Paths {
            mechanism,
            known,
            slides,
            links,
            bound: Vec::new(),
            free: Vec::new(),
            scales,
            random: Random(0x7061_7468),
            followed: 0,
        };
        paths.solve_linear(rows)?;
        Some(paths)
    }

    /// Which rotations follow from the others, by elimination. The largest arms are divided by.
    fn solve_linear(&mut self, mut rows: Vec<(Vec<Complex>, Complex)>) -> Option<()> {
        let mut pivots: Vec<usize> = Vec::new();
        for step in 0..rows.len() {
            let entries = (step..rows.len()).flat_map(|row| (0..self.links.len()).map(move |link| (row, link)));
            let size = |&(row, link): &(usize, usize)| rows[row].0[link].norm_sqr();
            let (row, link) = entries.max_by(|a, b| size(a).total_cmp(&size(b)))?;
            rows.swap(step, row);
            let pivot = rows[step].0[link];
            if pivot.is_zero() {
                return None;
            }
            rows[step].0.iter_mut().for_each(|x| *x /= pivot);
            rows[step].1 /= pivot;
            let (first, constant) = rows[step].clone();
            for (_, (row, own)) in rows.iter_mut().enumerate().filter(|(other, _)| *other != step) {
                let times = row[link];
                row.iter_mut().zip(&first).for_each(|(x, y)| *x -= times * y);
                *own -= times * constant;
            }
            pivots.push(link);
        }
        self.free = (0..self.links.len()).filter(|link| !pivots.contains(link)).collect();
        let bound = pivots.iter().zip(rows).map(|(&link, (row, constant))| {
            let mut of_free = [Complex::zero(); MOST_LOOPS];
            of_free.iter_mut().zip(&self.free).for_each(|(x, &free)| *x = row[free]);
            (link, of_free, constant)
        });
        self.bound = bound.collect();
        Some(())
    }

    /// Starts for closing the loops, one for each assembly that is real or nearly so, of a group with that number of complex ones; and whether
    /// these are surely all: each of them has been reached, and all stand by themselves.
    pub(super) fn starts(&mut self, number: usize) -> (Vec<Assembled>, bool) {
        let Some((products, all)) = self.all(number) else {
            return (Vec::new(), false);
        };
        let ones = vec![0.0; self.links.len()];
        let mut starts: Vec<Vec<Complex>> = Vec::new();
        for off in OFF {
            let rounds = self.rounds(0.0);
            let way = Way { ends: [&products, &ones], rounds: &rounds };
            let ends: Vec<Option<End>> = all.iter().map(|start| self.follow(start, &way, off)).collect();
            let reached: Vec<(Vec<Complex>, bool)> =
                ends.iter().flatten().map(|end| (self.rotations(&end.free), end.is_regular)).collect();
            let is_alone = |index: usize| (0..index).all(|other| !are_same(&reached[index].0, &reached[other].0));
            let are_all = reached.len() == number && (0..number).all(|index| reached[index].1 && is_alone(index));
            let is_real = |(rotations, is_regular): &&(Vec<Complex>, bool)| {
                let off = if *is_regular { REAL } else { NEARLY_REAL };
                rotations.iter().all(|z| (z.norm_sqr() - 1.0).abs() < off)
            };
            starts.extend(reached.iter().filter(is_real).map(|(rotations, _)| rotations.clone()));
            if are_all {
                return (starts.iter().map(|rotations| self.start(rotations)).collect(), true);
            }
        }
        (starts.iter().map(|rotations| self.start(rotations)).collect(), false)
    }

    /// An approximate assembly with these rotations.
    fn start(&self, rotations: &[Complex]) -> Assembled {
        let mut frames = self.known.clone();
        for (&link, z) in self.links.iter().zip(rotations) {
            let size = z.norm_sqr().sqrt();
            let turn = Turn::from_cos_sin_unchecked(z.re / size, z.im / size);
            frames.set_compound(self.mechanism, link, pinned(turn, Point::origin(), Point::origin()));
        }
        Assembled { frames, slides: self.slides.to_vec(), gap: f64::INFINITY }
    }

    /// Products λ, and so many assemblies with them. At both places between which the ways run they are real: assemblies there are real or come in pairs.
    fn all(&mut self, number: usize) -> Option<(Vec<f64>, Vec<Free>)> {
        let mut first = [Complex::zero(); MOST_LOOPS];
        for (z, link) in first.iter_mut().zip(self.free.clone()) {
            *z = self.number() * libm::exp(self.scales[link]);
        }
        let places: [Vec<f64>; 2] = [
            self.rotations(&first).iter().map(|z| libm::log(z.norm_sqr())).collect(),
            (0..self.links.len()).map(|link| 2.0 * self.scales[link] + self.random.within()).collect(),
        ];
        let mut found = [vec![first], Vec::new()];
        let mut ways: Vec<Gone> = Vec::new();
        loop {
            // The next assembly at either end of a way from which it has not been gone.
            let next = ways.iter().enumerate().find_map(|(way, (_, gone))| {
                [0, 1].into_iter().find_map(|end| {
                    let index = (0..found[end].len()).find(|index| !gone[end].contains(index))?;
                    Some((way, end, index))
                })
            });
            let Some((way, end, index)) = next else {
                if ways.len() == MOST_WAYS {
                    return None;
                }
                let swell = SWELL * (1 + ways.len() / SWELLING) as f64;
                ways.push((self.rounds(swell), Default::default()));
                continue;
            };
            let (rounds, gone) = &mut ways[way];
            gone[end].push(index);
            let back: Vec<[f64; 3]> = rounds.iter().map(|&[turn, wave, swell]| [-turn, wave, swell]).collect();
            let along = Way { ends: [&places[end], &places[1 - end]], rounds: if end == 0 { rounds } else { &back } };
            let start = found[end][index];
            let Some(reached) = self.follow(&start, &along, OFF[0]).filter(|end| end.is_regular) else {
                continue;
            };
            let other = 1 - end;
            let is_there = self.added(&mut found[other], reached.free);
            gone[other].push(is_there);
            self.added(&mut found[other], self.mirrored(&reached.free, &places[other]));
            if found[other].len() >= number {
                let (mut places, mut found) = (Vec::from(places), Vec::from(found));
                let all = found.swap_remove(other);
                return (all.len() == number).then(|| (places.swap_remove(other), all));
            }
        }
    }

    /// The index of an assembly among those found, to which it is added if it is new.
    fn added(&self, found: &mut Vec<Free>, free: Free) -> usize {
        let rotations = self.rotations(&free);
        let same = found.iter().position(|other| are_same(&self.rotations(other), &rotations));
        same.unwrap_or_else(|| {
            found.push(free);
            found.len() - 1
        })
    }

    /// The assembly whose rotations are the conjugates of this one's w, with the same real products.
    fn mirrored(&self, free: &Free, products: &[f64]) -> Free {
        let mut mirrored = *free;
        for (z, &link) in mirrored.iter_mut().zip(&self.free) {
            *z = (libm::exp(products[link]) / *z).conj();
        }
        mirrored
    }

    /// For every link the angle by which a product goes round zero, and random waves of its angle and of its logarithm.
    fn rounds(&mut self, swell: f64) -> Vec<[f64; 3]> {
        let round = |random: &mut Random| {
            let turn = TAU * (random.below(3) as f64 - 1.0);
            [turn, PI * random.within(), swell * random.within()]
        };
        (0..self.links.len()).map(|_| round(&mut self.random)).collect()
    }

    /// A random complex number not far from 1 in modulus.
    fn number(&mut self) -> Complex {
        let (sine, cosine) = libm::sincos(self.random.unit() * TAU);
        Complex::new(cosine, sine) * (0.75 + 0.5 * self.random.unit())
    }

    /// The rotations of all links.
    fn rotations(&self, free: &Free) -> Vec<Complex> {
        let mut all = vec![Complex::zero(); self.links.len()];
        for (&link, &z) in self.free.iter().zip(free) {
            all[link] = z;
        }
        for (link, row, constant) in &self.bound {
            let sum = row.iter().zip(free).take(self.free.len()).map(|(x, z)| x * z);
            all[*link] = -(sum.sum::<Complex>() + constant);
        }
        all
    }

    /// The end of a path; `None` where it cannot be followed to its end.
    fn follow(&mut self, start: &Free, way: &Way<'_>, off: f64) -> Option<End> {
        self.followed += 1;
        let (mut free, mut t, mut step) = (*start, 0.0, FIRST_STEP);
        while t < 1.0 {
            let next = if t + step >= 1.0 { 1.0 } else { t + step };
            match self.stepped(&free, way, [t, next], off) {
                Some((reached, was_off)) => {
                    (free, t) = (reached, next);
                    if was_off < off / EASY {
                        step *= 2.0;
                    }
                }
                None => {
                    step *= 0.5;
                    if step < SMALLEST_STEP {
                        // Paths to an assembly that does not stand by itself are slow at their end.
                        return (1.0 - t < off).then_some(End { free, is_regular: false });
                    }
                }
            }
        }
        let products = way.at(1.0);
        let mut is_regular = false;
        for _ in 0..4 {
            let (reached, was_off) = self.corrected(&free, &products)?;
            free = reached;
            is_regular = was_off < AT_THE_END;
        }
        Some(End { free, is_regular })
    }

    /// The numbers a step further, by the rule of Runge and Kutta and then by Newton's, and by how much the first was off; `None` where that is too much.
    fn stepped(&self, free: &Free, way: &Way<'_>, [t, next]: [f64; 2], off: f64) -> Option<(Free, f64)> {
        let step = next - t;
        let moved = |by: &Free, times: f64| {
            let mut moved = *free;
            moved.iter_mut().zip(by).for_each(|(x, y)| *x += y * times);
            moved
        };
        let middle = way.at(t + 0.5 * step);
        let last = way.at(next);
        let first = self.rate(free, &way.at(t))?;
        let second = self.rate(&moved(&first, 0.5 * step), &middle)?;
        let third = self.rate(&moved(&second, 0.5 * step), &middle)?;
        let fourth = self.rate(&moved(&third, step), &last)?;
        let mut mean = first;
        for (k, x) in mean.iter_mut().enumerate() {
            *x = (first[k] + fourth[k] + (second[k] + third[k]) * 2.0) / 6.0;
        }
        let (mut reached, was_off) = self.corrected(&moved(&mean, step), &last)?;
        if was_off > off {
            return None;
        }
        for _ in 0..2 {
            let (nearer, still) = self.corrected(&reached, &last)?;
            reached = nearer;
            if still < ON_THE_WAY {
                return Some((reached, was_off));
            }
        }
        None
    }

    /// The rates of the free numbers along a way.
    fn rate(&self, free: &Free, products: &[[Complex; 2]]) -> Option<Free> {
        let inverse = self.inverse(free);
        let mut right = [Complex::zero(); MOST_LOOPS];
        for (x, (link, row, _)) in right.iter_mut().zip(&self.bound) {
            let own = self.free.iter().zip(row).map(|(&free, x)| x.conj() * products[free][1] * inverse[free]);
            *x = -(products[*link][1] * inverse[*link] + own.sum::<Complex>());
        }
        self.solved(&inverse, products, right)
    }

    /// The free numbers after one step of Newton's method, and the largest change in parts of a number.
    fn corrected(&self, free: &Free, products: &[[Complex; 2]]) -> Option<(Free, f64)> {
        let inverse = self.inverse(free);
        let mut right = [Complex::zero(); MOST_LOOPS];
        for (x, (link, row, constant)) in right.iter_mut().zip(&self.bound) {
            let own = self.free.iter().zip(row).map(|(&free, x)| x.conj() * products[free][0] * inverse[free]);
            *x = -(products[*link][0] * inverse[*link] + own.sum::<Complex>() + constant.conj());
        }
        let change = self.solved(&inverse, products, right)?;
        let mut reached = *free;
        reached.iter_mut().zip(&change).for_each(|(x, y)| *x += y);
        let bound = self.bound.iter().map(|(link, row, _)| {
            let sum: Complex = row.iter().zip(&change).map(|(x, y)| x * y).sum();
            (sum * inverse[*link]).norm_sqr()
        });
        let own = self.free.iter().zip(&change).map(|(&link, x)| (x * inverse[link]).norm_sqr());
        Some((reached, bound.chain(own).fold(0.0, f64::max).sqrt()))
    }

    /// The inverse of every rotation.
    fn inverse(&self, free: &Free) -> Vec<Complex> {
        self.rotations(free).into_iter().map(|z| z.conj() / z.norm_sqr()).collect()
    }

    /// The solution of the linear system of a Newton step; `None` where it is singular or leaves the range of numbers.
    fn solved(&self, inverse: &[Complex], products: &[[Complex; 2]], mut right: Free) -> Option<Free> {
        let size = self.bound.len();
        let mut matrix = [[Complex::zero(); MOST_LOOPS]; MOST_LOOPS];
        let weight = |link: usize| products[link][0] * inverse[link] * inverse[link];
        let of_free: Vec<Complex> = self.free.iter().map(|&link| weight(link)).collect();
        for (entries, (link, row, _)) in matrix.iter_mut().zip(&self.bound) {
            let own = weight(*link);
            for (k, entry) in entries.iter_mut().take(size).enumerate() {
                *entry = own * row[k] - row[k].conj() * of_free[k];
            }
        }
        for step in 0..size {
            let largest =
                (step..size).max_by(|&a, &b| matrix[a][step].norm_sqr().total_cmp(&matrix[b][step].norm_sqr()))?;
            matrix.swap(step, largest);
            right.swap(step, largest);
            let pivot = matrix[step][step];
            let inverse = pivot.conj() / pivot.norm_sqr();
            for row in step + 1..size {
                let times = matrix[row][step] * inverse;
                let pivot_row = matrix[step];
                for (entry, above) in matrix[row].iter_mut().zip(pivot_row).take(size).skip(step + 1) {
                    *entry -= times * above;
                }
                let above = right[step];
                right[row] -= times * above;
            }
            matrix[step][step] = inverse;
        }
        for step in (0..size).rev() {
            let known: Complex = (step + 1..size).map(|column| matrix[step][column] * right[column]).sum();
            right[step] = (right[step] - known) * matrix[step][step];
        }
        right.iter().all(|x| x.is_finite()).then_some(right)
    }
}

/// Whether two assemblies have the same rotations.
fn are_same(a: &[Complex], b: &[Complex]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).norm_sqr() <= SAME * SAME * (a.norm_sqr() + b.norm_sqr()))
}
