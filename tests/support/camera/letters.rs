//! Letters as a hand writes them: a few strokes each.

use super::pencil::Stroke;
use crate::random::Random;

/// Letters and their strokes: points as two digits, to the right and up; 2 is the line on which letters stand, 6 the
/// height of small ones.
const STROKES: &str = "\
a 45 36 16 04 03 12 32 44 46|46 43 52
b 09 02|04 15 35 44 43 32 12 03
c 45 36 16 05 03 12 32 43
d 49 42|44 36 16 04 03 12 32 43
e 04 44 45 36 16 05 03 12 32 43
f 48 39 28 22|06 46
g 45 36 16 05 04 13 33 44|46 41 30 10 01
h 09 02|04 26 36 45 42
i 26 22|28 28
j 26 21 10 01|28 28
k 09 02|46 04 42
l 29 23 32
m 06 02|05 16 25 22|25 36 45 42
n 06 02|05 16 36 45 42
o 16 05 03 12 32 43 45 36 16
p 06 00|05 16 36 45 43 32 12 03
q 45 36 16 05 03 12 32 43|46 40 51
r 06 02|04 16 36 45
s 45 36 16 05 14 34 43 32 12 03
t 29 23 32 42|06 46
u 06 03 12 32 44|46 42
v 06 22 46
w 06 12 25 32 46
x 06 42|46 02
y 06 23|46 10
z 06 46 02 42
A 02 29 42|14 34
B 02 09 39 48 47 36 06|36 45 43 32 02
C 48 39 19 07 04 12 32 43
D 02 09 29 47 44 22 02
E 49 09 02 42|06 36
F 49 09 02|06 36
G 48 39 19 07 04 12 32 44 45 25
H 09 02|49 42|06 46
I 29 22
K 09 02|49 05 42
L 09 02 42
M 02 09 24 49 42
N 02 09 42 49
O 19 07 04 12 32 44 47 39 19
P 02 09 39 48 47 36 06
R 02 09 39 48 47 36 06|26 42
S 48 39 19 08 16 35 44 32 12 03
T 09 49|29 22
U 09 03 12 32 43 49
V 09 22 49
X 09 42|49 02
Y 09 26 49|26 22
Z 09 49 02 42
0 19 07 04 12 32 44 47 39 19
1 07 29 22
2 08 19 39 48 46 02 42
3 08 19 39 48 46 25|25 44 43 32 12 03
4 32 39 04 44
5 49 09 06 36 45 43 32 12 03
6 49 17 04 12 32 43 45 36 16 05
7 09 49 22
8 26 17 19 39 37 26 04 12 32 44 26
9 46 16 07 19 39 47 44 32 12
π 05 16 46|16 12|36 33 42
' 29 27
′ 29 27
- 05 45
. 22 22
";

/// How far letters stand apart, in their units.
const ADVANCE: f64 = 6.0;

/// A name, its foot in the middle at a place of the page: small letters are so many mm high. What follows `_` is small
/// and low.
pub fn written(name: &str, [x, y]: [f64; 2], height: f64, grey: f64, random: &mut Random) -> Vec<Stroke> {
    let mut strokes = Vec::new();
    let units: f64 = width(name);
    let slant = random.between(-0.05, 0.25);
    let (mut at, mut size, mut low) = (x - units * height / 8.0, height / 4.0, 0.0);
    for letter in name.chars() {
        if letter == '_' {
            (size, low) = (0.62 * height / 4.0, 0.35 * height);
            continue;
        }
        for way in ways(letter) {
            let corners: Vec<[f64; 2]> = way
                .iter()
                .map(|[u, v]| {
                    let up = (v - 2.0) * size + random.within(0.04 * height);
                    [at + u * size + slant * up + random.within(0.05 * height), y + low - up]
                })
                .collect();
            strokes.push(Stroke { points: rounded(&corners), width: random.between(0.3, 0.45), grey, wobble: 0.03 });
        }
        at += ADVANCE * size;
    }
    strokes
}

/// The width of a name in units.
fn width(name: &str) -> f64 {
    let (large, small) = name.split_once('_').unwrap_or((name, ""));
    ADVANCE * (large.chars().count() as f64 + 0.62 * small.chars().count() as f64) - 2.0
}

fn ways(letter: char) -> Vec<Vec<[f64; 2]>> {
    let line = STROKES.lines().find(|line| line.starts_with(letter));
    let ways = line.map_or("05 45", |line| line[letter.len_utf8()..].trim());
    let digit = |byte: u8| f64::from(byte - b'0');
    let point = |pair: &str| [digit(pair.as_bytes()[0]), digit(pair.as_bytes()[1])];
    ways.split('|').map(|way| way.split_whitespace().map(point).collect()).collect()
}

/// A smooth way through points (Catmull and Rom), as a hand takes it.
fn rounded(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut all = Vec::new();
    let last = points.len() - 1;
    for k in 0..last {
        let [a, b, c, d] = [k.saturating_sub(1), k, k + 1, (k + 2).min(last)].map(|k| points[k]);
        for step in 0..6 {
            let t = f64::from(step) / 6.0;
            all.push([0, 1].map(|i| {
                let (slope, bend) = (c[i] - a[i], 2.0 * a[i] - 5.0 * b[i] + 4.0 * c[i] - d[i]);
                let rest = 3.0 * b[i] - a[i] - 3.0 * c[i] + d[i];
                b[i] + 0.5 * t * (slope + t * (bend + t * rest))
            }));
        }
    }
    all.push(points[last]);
    all
}
