use crate::geometry::{Vector, quarter_turn};
use std::f64::consts::{FRAC_PI_2, PI};

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
