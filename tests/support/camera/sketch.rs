//! A plan as a hand draws it with pencil and ruler.

use super::letters::written;
use super::pencil::Stroke;
use crate::random::Random;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A point of a plan, in mm of the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub name: String,
    pub mm: [f64; 2],
}

/// What is drawn between or through places of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// A vector, with its head at the second place.
    Vector,
    /// A line of construction through the first place, past the second.
    Ray,
    /// Both ends joined, for a measure or an image.
    Side,
}

/// A line of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    pub line: Line,
    pub ends: [[f64; 2]; 2],
}

/// How a hand uses its pencil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Habit {
    /// Grey of vectors, 0 to 255; lines of construction are lighter.
    pub grey: f64,
    /// Width of vectors in mm.
    pub width: f64,
    /// How far lines leave their way, in mm.
    pub wobble: f64,
    /// Height of letters in mm.
    pub letters: f64,
    /// So many lines of 10 were drawn before somewhere else and erased.
    pub erased: usize,
}

impl Habit {
    pub fn random(random: &mut Random) -> Habit {
        Habit {
            grey: random.between(88.0, 150.0),
            width: random.between(0.35, 0.6),
            wobble: random.between(0.04, 0.1),
            letters: random.between(2.4, 3.8),
            erased: random.below(3),
        }
    }
}

/// All strokes of a plan: its lines, marks of its points and their letters.
pub fn sketch(points: &[Point], lines: &[Drawn], habit: &Habit, random: &mut Random) -> Vec<Stroke> {
    let mut hand = Hand { habit: *habit, random, strokes: Vec::new() };
    for line in lines {
        hand.line(line);
    }
    for point in points {
        hand.point(point);
    }
    hand.letters(points, lines);
    hand.strokes
}

struct Hand<'a> {
    habit: Habit,
    random: &'a mut Random,
    strokes: Vec<Stroke>,
}

impl Hand<'_> {
    fn stroke(&mut self, points: &[[f64; 2]], [width, grey]: [f64; 2]) {
        let wobble = self.habit.wobble;
        self.strokes.push(Stroke { points: points.to_vec(), width, grey, wobble });
    }

    fn line(&mut self, line: &Drawn) {
        let [a, b] = line.ends;
        let d = [b[0] - a[0], b[1] - a[1]];
        let length = libm::hypot(d[0], d[1]);
        if length < 0.3 {
            return;
        }
        let way = d.map(|part| part / length);
        let at = |s: f64| [a[0] + way[0] * s, a[1] + way[1] * s];
        let strong = [self.habit.width, self.habit.grey];
        let faint = [
            (self.habit.width * self.random.between(0.65, 0.9)).max(0.28),
            (self.habit.grey + self.random.between(10.0, 45.0)).min(178.0),
        ];
        if self.random.below(10) < self.habit.erased {
            self.erased(a, way, length);
        }
        match line.line {
            Line::Vector => {
                let over = self.random.between(-0.2, 0.2);
                self.stroke(&[at(0.0), at(length + over)], strong);
                self.head(b, way, length, strong);
            }
            Line::Ray => {
                let [before, past] = [(2.0, 12.0), (5.0, 25.0)].map(|(low, high)| self.random.between(low, high));
                self.stroke(&[at(-before), at(length + past)], faint);
                if self.random.below(2) == 0 {
                    self.right_angle(at(length + 0.6 * past), way, faint);
                }
            }
            Line::Side => {
                let over = self.random.between(0.0, 2.0);
                self.stroke(&[at(-over), at(length + over)], faint);
            }
        }
    }

    fn head(&mut self, tip: [f64; 2], way: [f64; 2], length: f64, pen: [f64; 2]) {
        let size = self.random.between(2.2, 3.6).min(0.45 * length);
        for side in [-1.0, 1.0] {
            let (sin, cos) = libm::sincos(side * self.random.between(0.2, 0.38));
            let back = [way[0] * cos - way[1] * sin, way[0] * sin + way[1] * cos];
            self.stroke(&[tip, [tip[0] - size * back[0], tip[1] - size * back[1]]], pen);
        }
    }

    /// The small sign of a perpendicular.
    fn right_angle(&mut self, at: [f64; 2], way: [f64; 2], pen: [f64; 2]) {
        let size = self.random.between(1.6, 2.6);
        let across = [-way[1] * size, way[0] * size];
        let from = [at[0] + across[0], at[1] + across[1]];
        let along = way.map(|part| part * size);
        self.stroke(&[from, [from[0] + along[0], from[1] + along[1]], [at[0] + along[0], at[1] + along[1]]], pen);
    }

    /// What an eraser leaves: a smear with the rest of a line in it.
    fn erased(&mut self, from: [f64; 2], way: [f64; 2], length: f64) {
        let (sin, cos) = libm::sincos(self.random.within(0.25));
        let way = [way[0] * cos - way[1] * sin, way[0] * sin + way[1] * cos];
        let (start, end) = (self.random.within(4.0), length * self.random.between(0.5, 1.1));
        let at = |s: f64| [from[0] + way[0] * s, from[1] + way[1] * s];
        let smear = Stroke {
            points: vec![at(start), at(end)],
            width: self.random.between(2.0, 5.0),
            grey: self.random.between(238.0, 248.0),
            wobble: 0.8,
        };
        self.strokes.push(smear);
        let rest = self.random.between(205.0, 230.0);
        self.stroke(&[at(start), at(end)], [0.4, rest]);
    }

    /// A small cross, a dot or nothing.
    fn point(&mut self, point: &Point) {
        let [x, y] = point.mm;
        let pen = [self.habit.width * 0.9, self.habit.grey * 0.9];
        match self.random.below(4) {
            0 => {
                let size = self.random.between(0.7, 1.2);
                let turn = self.random.angle();
                for turn in [turn, turn + FRAC_PI_2] {
                    let (sin, cos) = libm::sincos(turn);
                    let off = [0.15, 0.15].map(|mm| self.random.within(mm));
                    let end = |s: f64| [x + s * size * cos + off[0], y + s * size * sin + off[1]];
                    self.stroke(&[end(-1.0), end(1.0)], pen);
                }
            }
            1 => {}
            _ => {
                let dot = Stroke { points: vec![[x, y], [x + 0.05, y]], width: 0.9, grey: 60.0, wobble: 0.05 };
                self.strokes.push(dot);
            }
        }
    }

    /// Names beside points, where few lines run.
    fn letters(&mut self, points: &[Point], lines: &[Drawn]) {
        let mut taken: Vec<[f64; 2]> = Vec::new();
        for point in points {
            let mut best: Option<(f64, [f64; 2])> = None;
            for k in 0..16 {
                let (sin, cos) = libm::sincos(f64::from(k % 8) * FRAC_PI_4 + self.random.within(0.2));
                let away = self.habit.letters * if k < 8 { 1.3 } else { 2.2 } + 0.8;
                let place = [point.mm[0] + away * cos, point.mm[1] + away * sin];
                let free = lines.iter().map(|line| distance(place, line.ends));
                let other = taken.iter().map(|other| distance(place, [*other; 2]) - 2.0);
                let free = free.chain(other).fold(5.0_f64, f64::min) - 0.12 * away + self.random.within(0.4);
                if best.is_none_or(|(most, _)| free > most) {
                    best = Some((free, place));
                }
            }
            let Some((_, place)) = best else { continue };
            taken.push(place);
            let foot = [place[0], place[1] + self.habit.letters / 2.0];
            let height = self.habit.letters * self.random.between(0.9, 1.15);
            self.strokes.extend(written(&point.name, foot, height, self.habit.grey, self.random));
        }
    }
}

/// From a place to a straight line between two ends.
fn distance(p: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let d = [b[0] - a[0], b[1] - a[1]];
    let off = [p[0] - a[0], p[1] - a[1]];
    let t = ((off[0] * d[0] + off[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]).max(1e-9)).clamp(0.0, 1.0);
    libm::hypot(off[0] - t * d[0], off[1] - t * d[1])
}
