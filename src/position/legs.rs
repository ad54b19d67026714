use super::frames::LegJoint;
use crate::geometry::{Placement, Point, Turn, Vector, cross, quarter_turn};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Condition that a leg between rigid bodies a and b imposes on the placement of b in the frame of a.
///
/// A binary link with two revolute joints keeps a distance; one with one prismatic joint keeps a point of one body on a
/// line of the other; one with two prismatic joints keeps the relative angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LegCondition {
    /// Point `a` of body a and point `b` of body b are `length` apart.
    Distance { a: Point, b: Point, length: f64 },
    /// Point `b` of body b lies on the line through `point` along `direction` of body a.
    OnLineOfA { point: Point, direction: Vector, b: Point },
    /// Point `a` of body a lies on the line through `point` along `direction` of body b.
    OnLineOfB { point: Point, direction: Vector, a: Point },
    /// The rotation of body b relative to a is given.
    Turned(Turn),
}

impl LegCondition {
    /// The rotation of body b relative to a, if the leg keeps it.
    fn turn(&self) -> Option<Turn> {
        match self {
            LegCondition::Turned(turn) => Some(*turn),
            _ => None,
        }
    }

    /// The largest of its coordinates and lengths.
    fn size(&self) -> f64 {
        match *self {
            LegCondition::Distance { a, b, length } => a.coords.amax().max(b.coords.amax()).max(length),
            LegCondition::OnLineOfA { point, b: other, .. } | LegCondition::OnLineOfB { point, a: other, .. } => {
                point.coords.amax().max(other.coords.amax())
            }
            LegCondition::Turned(_) => 0.0,
        }
    }

    /// With all lengths so many times as large.
    fn scaled(&self, by: f64) -> LegCondition {
        let scaled = |point: Point| point * by;
        match *self {
            LegCondition::Distance { a, b, length } => {
                LegCondition::Distance { a: scaled(a), b: scaled(b), length: length * by }
            }
            LegCondition::OnLineOfA { point, direction, b } => {
                LegCondition::OnLineOfA { point: scaled(point), direction, b: scaled(b) }
            }
            LegCondition::OnLineOfB { point, direction, a } => {
                LegCondition::OnLineOfB { point: scaled(point), direction, a: scaled(a) }
            }
            LegCondition::Turned(turn) => LegCondition::Turned(turn),
        }
    }
}

/// Every real placement of body b in the frame of a that satisfies three conditions.
///
/// For a given relative rotation each leg restricts the translation t to a circle or a straight line. Two linear
/// equations (differences of circles are linear) and one remaining condition leave a trigonometric polynomial of the
/// rotation of degree 3 at most, so at most 6 placements. Its real roots are isolated by the roots of its derivatives,
/// so none is lost. The placements are in the order of the relative rotation, counter-clockwise from 0. Near a double
/// root they are exact to about half the digits; the caller closes the loops to full accuracy and drops what does not
/// close.
pub fn placements(conditions: [LegCondition; 3]) -> Vec<Placement> {
    if let Some((k, turn)) = conditions.iter().enumerate().find_map(|(k, c)| Some((k, c.turn()?))) {
        let rows = [(k + 1) % 3, (k + 2) % 3].map(|other| Row::new(&conditions[other], turn));
        return translations(&rows).into_iter().map(|t| placement(t, turn)).collect();
    }
    // The polynomial has lengths to the power of six, which must stay within the range of f64: a power of two changes no digit.
    let largest = conditions.iter().map(LegCondition::size).fold(0.0, f64::max);
    let unit = if largest.is_normal() { libm::exp2(libm::floor(libm::log2(largest))) } else { 1.0 };
    let conditions = conditions.map(|condition| condition.scaled(1.0 / unit));
    let rows_at = |turn: Turn| conditions.map(|c| Row::new(&c, turn));
    let mut found = Vec::new();
    for direction in real_roots(|direction| closing_polynomial(&rows_at(turn_to(direction)))) {
        let turn = turn_to(direction);
        found.extend(translations_at_root(&rows_at(turn)).into_iter().map(|t| placement(t * unit, turn)));
    }
    found
}

/// Every real placement of body b that joint `direct` connects with the fixed frame and that satisfies one condition.
///
/// About a pin the condition is a trigonometric polynomial of degree 1: two placements at most. Along a guide it is a
/// line or a circle, cut by a line.
pub(super) fn joined_placements(direct: &LegJoint, condition: LegCondition) -> Vec<Placement> {
    match *direct {
        LegJoint::Pin { local, place } => {
            let at = |turn: Turn| place.coords - turn * local.coords;
            if let Some(turn) = condition.turn() {
                return vec![placement(at(turn), turn)];
            }
            let excess = |turn: Turn| Row::new(&condition, turn).excess(at(turn));
            let directions = real_roots_of_first_degree(|direction| excess(turn_to(direction)));
            directions.into_iter().map(turn_to).map(|turn| placement(at(turn), turn)).collect()
        }
        LegJoint::Slide { frame, along } => {
            let normal = quarter_turn(along);
            let guide = Row { is_circle: false, arm: normal, constant: normal.dot(&frame.translation.vector) };
            let rows = [guide, Row::new(&condition, frame.rotation)];
            translations(&rows).into_iter().map(|t| placement(t, frame.rotation)).collect()
        }
    }
}

/// The smallest deviation of the first distance condition with the other conditions satisfied, over all relative
/// rotations: positive where the leg would have to be longer; and the index of that condition. `None` without a distance
/// condition or where the others have no solution.
pub(super) fn smallest_deviation(direct: Option<&LegJoint>, conditions: &[LegCondition]) -> Option<(usize, f64)> {
    const SAMPLES: usize = 720;
    // Two links on pins: the third side of a triangle lies between difference and sum of the others.
    if let (Some(LegJoint::Pin { local, place }), &[LegCondition::Distance { a, b, length }]) = (direct, conditions) {
        let (base, link) = ((place - a).norm(), (b - local).norm());
        let [near, far] = [(base - link).abs(), base + link].map(|distance| distance - length);
        return Some((0, if near.abs() < far.abs() { near } else { far }));
    }
    let first = conditions.iter().position(|c| matches!(c, LegCondition::Distance { .. }))?;
    let others: Vec<&LegCondition> =
        conditions.iter().enumerate().filter(|(k, _)| *k != first).map(|(_, c)| c).collect();
    let turns: Vec<Turn> = match (others.iter().find_map(|c| c.turn()), direct) {
        (Some(turn), _) => vec![turn],
        (None, Some(LegJoint::Slide { frame, .. })) => vec![frame.rotation],
        (None, _) => (0..SAMPLES)
            .map(|k| TAU * k as f64 / SAMPLES as f64)
            .map(|angle| Turn::from_cos_sin_unchecked(libm::cos(angle), libm::sin(angle)))
            .collect(),
    };
    let deviations = turns.into_iter().flat_map(|turn| {
        let circle = Row::new(&conditions[first], turn);
        let found = match (direct, others.as_slice()) {
            (Some(LegJoint::Pin { local, place }), _) => vec![place.coords - turn * local.coords],
            // The point of the guide nearest to the circle's centre.
            (Some(LegJoint::Slide { frame, along }), _) => {
                let start = frame.translation.vector;
                vec![start + along * (-circle.arm - start).dot(along)]
            }
            (None, &[a, b]) => translations(&[Row::new(a, turn), Row::new(b, turn)]),
            (None, _) => Vec::new(),
        };
        // Present distance less the leg's length.
        found.into_iter().map(move |t| (t + circle.arm).norm() - circle.constant)
    });
    let least = deviations.filter(|m| m.is_finite()).min_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    Some((first, least))
}

/// The rotation of the x axis to a unit vector.
fn turn_to(direction: Vector) -> Turn {
    Turn::from_cos_sin_unchecked(direction.x, direction.y)
}

fn placement(t: Vector, turn: Turn) -> Placement {
    Placement::from_parts(t.into(), turn)
}

/// A condition on the translation t at a given rotation.
#[derive(Clone, Copy)]
struct Row {
    /// Circle: |t + arm| = constant. Line: arm · t = constant.
    is_circle: bool,
    arm: Vector,
    constant: f64,
}

impl Row {
    fn new(condition: &LegCondition, turn: Turn) -> Row {
        match *condition {
            LegCondition::Distance { a, b, length } => {
                Row { is_circle: true, arm: turn * b.coords - a.coords, constant: length }
            }
            LegCondition::OnLineOfA { point, direction, b } => {
                let normal = quarter_turn(direction);
                Row { is_circle: false, arm: normal, constant: normal.dot(&(point.coords - turn * b.coords)) }
            }
            LegCondition::OnLineOfB { point, direction, a } => {
                let normal = turn * quarter_turn(direction);
                Row { is_circle: false, arm: normal, constant: normal.dot(&(a.coords - turn * point.coords)) }
            }
            // At this rotation it holds for every t.
            LegCondition::Turned(_) => Row { is_circle: false, arm: Vector::zeros(), constant: 0.0 },
        }
    }

    /// Zero where the condition is satisfied, with opposite signs on its two sides.
    fn excess(&self, t: Vector) -> f64 {
        if self.is_circle {
            let distance = (t + self.arm).norm();
            (distance - self.constant) * (distance + self.constant)
        } else {
            self.arm.dot(&t) - self.constant
        }
    }

    /// The radical axis of this circle and `other`: (arm_1 − arm_0) · t = constant.
    fn radical_axis(&self, other: &Row) -> Row {
        let (s, d) = (self.arm + other.arm, self.arm - other.arm);
        // |t + arm|² = L²: the difference of two such equations. Products of sums and differences avoid cancellation of
        // squares.
        let lengths = (self.constant - other.constant) * (self.constant + other.constant);
        Row { is_circle: false, arm: d, constant: 0.5 * (lengths - d.dot(&s)) }
    }
}

/// Two linear conditions and the remaining one, from three; all but one circle are replaced by radical axes.
fn linearized(rows: &[Row; 3]) -> (Row, Row, Row) {
    let mut straight = Vec::with_capacity(2);
    let mut last = None;
    for row in rows {
        match (row.is_circle, last) {
            (true, None) => last = Some(*row),
            (true, Some(first)) => straight.push(row.radical_axis(&first)),
            (false, _) => straight.push(*row),
        }
    }
    match (last, straight.as_slice()) {
        (Some(circle), [p, q]) => (*p, *q, circle),
        _ => (straight[0], straight[1], straight[2]),
    }
}

/// Zero where the three conditions have a common t: a trigonometric polynomial of the rotation of degree 3 at most.
fn closing_polynomial(rows: &[Row; 3]) -> f64 {
    let (p, q, last) = linearized(rows);
    let determinant = cross(p.arm, q.arm);
    let t = solution_times_determinant(&p, &q);
    if last.is_circle {
        let v = t + last.arm * determinant;
        let radius = last.constant * determinant;
        (v.norm() - radius.abs()) * (v.norm() + radius.abs())
    } else {
        last.arm.dot(&t) - last.constant * determinant
    }
}

/// The solution t of two linear conditions, times their determinant.
fn solution_times_determinant(p: &Row, q: &Row) -> Vector {
    Vector::new(p.constant * q.arm.y - q.constant * p.arm.y, q.constant * p.arm.x - p.constant * q.arm.x)
}

/// The translations at a root: one where two lines cross at more than 1e-6 rad, else those of one line and the
/// remaining condition.
fn translations_at_root(rows: &[Row; 3]) -> Vec<Vector> {
    let (p, q, last) = linearized(rows);
    let size = p.arm.norm() * q.arm.norm();
    let determinant = cross(p.arm, q.arm);
    if determinant.abs() > 1e-6 * size {
        return vec![solution_times_determinant(&p, &q) / determinant];
    }
    let stronger = if p.arm.norm_squared() >= q.arm.norm_squared() { p } else { q };
    translations(&[stronger, last])
}

/// The common translations of two conditions: none, one or two, or where two nearly meet, the one between them, too; none for
/// parallel lines.
fn translations(rows: &[Row; 2]) -> Vec<Vector> {
    let (line, circle) = match (rows[0].is_circle, rows[1].is_circle) {
        (false, false) => {
            let determinant = cross(rows[0].arm, rows[1].arm);
            let t = solution_times_determinant(&rows[0], &rows[1]) / determinant;
            return if t.x.is_finite() && t.y.is_finite() { vec![t] } else { Vec::new() };
        }
        (true, true) => (rows[1].radical_axis(&rows[0]), rows[0]),
        (true, false) => (rows[1], rows[0]),
        (false, true) => (rows[0], rows[1]),
    };
    let length = line.arm.norm();
    if length == 0.0 {
        return Vec::new();
    }
    let normal = line.arm / length;
    let centre = -circle.arm;
    let distance = line.constant / length - normal.dot(&centre);
    let half = (circle.constant - distance) * (circle.constant + distance);
    // A circle that misses the line only by rounding counts as tangent; closing the loops decides.
    let whole = circle.constant * circle.constant;
    if half < -1e-9 * whole {
        return Vec::new();
    }
    // As for roots of first degree: the place between two that nearly meet comes first, and they stay apart.
    let foot = centre + normal * distance;
    let along = quarter_turn(normal) * half.max(f64::EPSILON * whole).sqrt();
    let between = (half <= RAISED * whole).then_some(foot);
    between.into_iter().chain([foot + along, foot - along]).collect()
}

/// Largest degree of the trigonometric polynomials solved here.
const DEGREE: usize = 3;
/// Number of coefficients of the polynomial in the tangent of the half angle.
const TERMS: usize = 2 * DEGREE + 1;
/// Samples that determine a trigonometric polynomial of that degree.
const SAMPLES: usize = 2 * DEGREE + 2;

/// Value at a double root, in parts of the largest, to which rounding may raise it: such a root is kept, and the caller must test it.
const RAISED: f64 = 1e-11;

/// The directions (cos φ, sin φ) of the zeros of c₀ + c₁ cos φ + s₁ sin φ.
///
/// Where two zeros nearly meet, the direction between them comes first: closed from there, a double root is found as one. The others are
/// no closer to it than rounding tells them apart, because equations to be closed may be singular at the double root itself. The caller
/// must test the roots.
pub fn real_roots_of_first_degree(f: impl Fn(Vector) -> f64) -> Vec<Vector> {
    let [right, left, up] = [f(Vector::x()), f(-Vector::x()), f(Vector::y())];
    let constant = 0.5 * (right + left);
    let greatest = Vector::new(0.5 * (right - left), up - constant);
    let height = greatest.norm();
    // The cosine of their angle from the direction in which the polynomial is greatest.
    let along = -constant / height;
    let beyond = along.abs() - 1.0;
    if beyond.is_nan() || beyond > RAISED {
        return Vec::new();
    }
    let axis = greatest / height;
    let across = ((1.0 - along) * (1.0 + along)).max(f64::EPSILON).sqrt();
    let between = (beyond >= -RAISED).then(|| axis * along.signum());
    let apart = [across, -across].map(|across| (axis * along + quarter_turn(axis) * across).normalize());
    between.into_iter().chain(apart).collect()
}

/// The directions (cos φ, sin φ) of the zeros of a trigonometric polynomial of degree 3 at most, φ ascending from 0 to
/// 2π.
///
/// `f` is sampled at 8 angles, which determine it. On each half circle it becomes a polynomial of τ = tan(φ′/2) on [−1,
/// 1], whose roots are separated by those of its derivative. A double root whose value rounding has raised to `RAISED` of
/// the largest is kept: the caller must test the roots.
pub fn real_roots(f: impl Fn(Vector) -> f64) -> Vec<Vector> {
    let samples: [f64; SAMPLES] = std::array::from_fn(|k| {
        let angle = 2.0 * PI * k as f64 / SAMPLES as f64;
        f(Vector::new(libm::cos(angle), libm::sin(angle)))
    });
    let largest = samples.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return Vec::new();
    }
    // The sum c_0 + Σ (c_k cos kφ + s_k sin kφ).
    let mut cosines = [0.0; DEGREE + 1];
    let mut sines = [0.0; DEGREE + 1];
    for (j, sample) in samples.iter().enumerate() {
        for k in 0..=DEGREE {
            let angle = 2.0 * PI * ((j * k) % SAMPLES) as f64 / SAMPLES as f64;
            let weight = if k == 0 { 1.0 } else { 2.0 } / SAMPLES as f64;
            cosines[k] += weight * sample / largest * libm::cos(angle);
            sines[k] += weight * sample / largest * libm::sin(angle);
        }
    }
    let mut angles: Vec<f64> = Vec::new();
    // Half circles centred at π/2 and 3π/2: [0, π) and [π, 2π).
    for centre in [FRAC_PI_2, 3.0 * FRAC_PI_2] {
        let polynomial = half_angle_polynomial(&cosines, &sines, centre);
        for tau in roots_in_unit_interval(&polynomial) {
            angles.push(centre + 2.0 * libm::atan(tau));
        }
    }
    angles.sort_by(f64::total_cmp);
    angles.dedup_by(|a, b| (*a - *b).abs() < 1e-14);
    angles.into_iter().map(|a| Vector::new(libm::cos(a), libm::sin(a))).collect()
}

/// The trigonometric polynomial times (1 + τ²)³, as coefficients of τ ascending, φ = centre + 2 atan τ.
fn half_angle_polynomial(cosines: &[f64; DEGREE + 1], sines: &[f64; DEGREE + 1], centre: f64) -> [f64; TERMS] {
    // (1 + iτ)^2k (1 + τ²)^(3−k) = (1 + τ²)³ e^{2ik atan τ}
    let mut sum = [0.0; TERMS];
    for k in 0..=DEGREE {
        let (c, s) = (libm::cos(k as f64 * centre), libm::sin(k as f64 * centre));
        // cos k(centre + x) and sin k(centre + x) by the angle sums.
        let along = cosines[k] * c + sines[k] * s;
        let across = sines[k] * c - cosines[k] * s;
        let (mut re, mut im) = ([0.0; TERMS], [0.0; TERMS]);
        re[0] = 1.0;
        for _ in 0..2 * k {
            let (r, i) = (re, im);
            for d in (0..TERMS).rev() {
                re[d] = r[d] - if d > 0 { i[d - 1] } else { 0.0 };
                im[d] = i[d] + if d > 0 { r[d - 1] } else { 0.0 };
            }
        }
        for _ in 0..DEGREE - k {
            for part in [&mut re, &mut im] {
                for d in (2..TERMS).rev() {
                    part[d] += part[d - 2];
                }
            }
        }
        for d in 0..TERMS {
            sum[d] += along * re[d] + across * im[d];
        }
    }
    sum
}

/// The roots of a polynomial in [−1, 1], ascending; multiple roots once.
fn roots_in_unit_interval(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.len() - 1;
    if degree == 0 {
        return Vec::new();
    }
    let derivative: Vec<f64> = (1..=degree).map(|d| d as f64 * coefficients[d]).collect();
    let value = |x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
    let size: f64 = coefficients.iter().map(|c| c.abs()).sum();
    let nearly_zero = RAISED * size;
    let mut knots = vec![-1.0];
    knots.extend(roots_in_unit_interval(&derivative));
    knots.push(1.0);
    let mut roots: Vec<f64> = Vec::new();
    for pair in knots.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let (fa, fb) = (value(a), value(b));
        if fa != 0.0 && fb != 0.0 && (fa < 0.0) != (fb < 0.0) {
            roots.push(bisected(&value, a, b, fa));
        } else {
            // No change of sign: there may be a double root at an end.
            for (x, fx) in [(a, fa), (b, fb)] {
                let new = roots.iter().all(|r| (r - x).abs() > 1e-6);
                if fx.abs() <= nearly_zero && new {
                    roots.push(x);
                }
            }
        }
    }
    roots.sort_by(f64::total_cmp);
    roots
}

/// The root in [a, b], at which `f` changes its sign once, by bisection.
fn bisected(f: &impl Fn(f64) -> f64, mut a: f64, mut b: f64, fa: f64) -> f64 {
    // 60 halvings of an interval of length 2 reach the spacing of f64 near 1.
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b {
            break;
        }
        if (f(middle) < 0.0) == (fa < 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
    0.5 * (a + b)
}
