use crate::sheet::Sheet;

/// How a school writes poles, images of points and parts of accelerations; in markup, where `_{…}` is an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Notation {
    /// The poles that are not written as in results.
    poles: &'static [(Sheet, &'static str)],
    /// Whether images of points bear a prime in the acceleration plan: `b′` beside `b` of the velocity plan.
    pub primes: bool,
    /// Index of the normal part of an acceleration.
    pub normal: &'static str,
    /// Index of the tangential part of an acceleration.
    pub tangential: &'static str,
    /// Index of the Coriolis part of an acceleration.
    pub coriolis: &'static str,
    /// Index of the part along a guide.
    pub relative: &'static str,
}

impl Notation {
    /// The notations in the order of [`NotationName::ALL`](crate::scene::NotationName::ALL).
    pub const ALL: [&'static Notation; 4] = [&PAPER, &ENGLISH, &RUSSIAN, &GERMAN];

    /// The symbol of a plan's pole, in markup.
    #[must_use]
    pub fn pole(&self, plan: Sheet) -> &'static str {
        self.poles.iter().find(|(sheet, _)| *sheet == plan).map_or(plan.pole(), |(_, pole)| pole)
    }
}

/// H. Quintero, G. Calle, A. Díaz, E. Henao, Rev. Fac. Ing. Univ. Antioquia 60 (2011) 81–91.
const PAPER: Notation =
    Notation { poles: &[], primes: false, normal: "n", tangential: "t", coriolis: "c", relative: "r" };

/// C. E. Wilson, J. P. Sadler, *Kinematics and Dynamics of Machinery*, 3rd ed., Pearson 2003.
const ENGLISH: Notation =
    Notation { poles: &[(Sheet::Velocity, "o"), (Sheet::Acceleration, "o′")], primes: true, ..PAPER };

/// K. V. Frolov (ed.), *Теория механизмов и машин*, Высшая школа, Moscow 1987.
const RUSSIAN: Notation = Notation { tangential: "τ", coriolis: "k", ..PAPER };

/// H. Kerle, B. Corves, M. Hüsing, *Getriebetechnik*, 5th ed., Springer Vieweg 2015.
const GERMAN: Notation = Notation { poles: &[(Sheet::Velocity, "P_{v}"), (Sheet::Acceleration, "P_{a}")], ..PAPER };

/// A name with a prime after its letter: `b′`, `d′_2`, `s′3`.
#[must_use]
pub fn with_prime(name: &str) -> String {
    let letters = name.split('_').next().unwrap_or(name);
    let letters = letters.trim_end_matches(|c: char| c.is_ascii_digit());
    let (letter, rest) = name.split_at(letters.len());
    format!("{letter}′{rest}")
}
