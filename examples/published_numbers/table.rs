//! Every number of the example in Quintero et al. (2011), beside what the paper's own drawing gives and the exact value.
//!
//! The paper solved its mechanism on a drawing whose points were up to 0.02 mm from their exact places.
//! `figure-2-published.json` is that drawing, found again from the lengths read off it; [`table`] measures it and repeats
//! the paper's arithmetic, early rounding and slips included. The exact values come from `figure-2.json`.

use kinegon::Solution;
use kinegon::geometry::{Line, Point, Vector, quarter_turn};
use kinegon::quantity::Quantity;
use kinegon::scene::Scene;
use nalgebra::{Matrix4, Vector4};
use std::error::Error;

/// The mechanism with the lengths that the paper gives.
const EXACT: &str = include_str!("../figure-2.json");

/// The configuration that the paper drew: θ1 = 70°, every length exact, D 0.00933 mm off the guide BE.
const DRAWN: &str = include_str!("../figure-2-published.json");

/// What b s3 and g s3 of the paper have in common, over the same segments of its own drawing: as if this one plan had been
/// drawn with p b = 99.9894 mm for 100 mm/s. That is likely, not proven.
const PLAN_OF_S3: f64 = 0.9998944;

/// Eq. 51 as printed, two digits swapped; the paper goes on with this value.
const SWAPPED: f64 = 137.7597;

/// What is to be said of a printed number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The exact value rounds to it.
    Right,
    /// The drawing was not exact.
    Drafting,
    /// The drawing was not exact, and results were rounded before they were used.
    DraftingAndRounding,
    /// It is none of these: a mistake.
    Wrong,
}

impl Verdict {
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Drafting => "drafting",
            Verdict::DraftingAndRounding => "drafting and early rounding",
            Verdict::Wrong => "WRONG",
        }
    }
}

/// A printed number and what became of it, in the unit and the sense that the paper uses.
#[derive(Clone, Debug)]
pub struct Row {
    /// The number of the equation in or beside which it stands; may be empty.
    pub equation: &'static str,
    /// Its symbol.
    pub quantity: &'static str,
    /// The digits as printed.
    pub printed: &'static str,
    /// From the paper's own drawing, by the paper's arithmetic.
    pub drawn: f64,
    /// From the exact mechanism.
    pub exact: f64,
    /// How the printed number came about.
    pub verdict: Verdict,
    /// A few words more; may be empty.
    pub note: String,
}

/// Rows of one kind.
#[derive(Clone, Debug)]
pub struct Section {
    /// What they are, with unit and sense.
    pub title: &'static str,
    /// The rows, in the paper's order.
    pub rows: Vec<Row>,
}

/// Every number that the paper prints in its example.
///
/// # Errors
/// Only if one of the two scenes has been changed so that it cannot be solved.
#[rustfmt::skip] // a row a line
pub fn table() -> Result<Vec<Section>, Box<dyn Error>> {
    use Verdict::{Drafting, DraftingAndRounding, Right, Wrong};
    let (exact, drawing) = (solution(EXACT)?, solution(DRAWN)?);
    let x = |name| number(&exact, name);
    let d = |name| number(&drawing, name);
    let replay = Replay::new(&drawing)?;
    let (l, n) = (replay.lengths, replay.normals);
    let s2b = x("omega(2)")?.powi(2) * x("L(B,S3)")?;

    let horizontal = format!("{:.4} is the horizontal component of BS3, taken for its length", l.bs3);
    let factor = format!("both × {PLAN_OF_S3}, see below");
    let from_length = "follows from L_BS3";
    let right_length = |value| format!("{from_length}; {value:.2} from this drawing with the right length");
    let v_slide = right_length(d("v_r(3/2)")?);
    let a_slide = format!("{}; unit: mm/s², not m/s²", right_length(d("a_r(3/2)")?));
    let touched = "touched by early rounding and by L_BS3";
    let last = "last digit";

    let lengths = vec![
        // Here the length itself; what the paper took for it is in the note.
        row("", "L_BS3", "248.0601", d("L(B,S3)")?, x("L(B,S3)")?, Wrong, &horizontal),
        row("", "L_DS3", "481.9848", l.ds3, x("L(D,S3)")?, Drafting, ""),
        row("", "L_FS5", "436.2923", l.fs5, x("L(F,S5)")?, Drafting, ""),
        row("", "L_ES5", "155.1123", l.es5, x("L(E,S5)")?, Drafting, ""),
    ];
    let [b3, g3, b5, g5] = replay.velocities;
    let velocities = vec![
        row("32", "v_BA", "10", d("v(B/A)")?, x("v(B/A)")?, Wrong, "slipped decimal"),
        row("35", "b s3", "59.3891", b3, x("vplan(b,s3)")?, Drafting, &factor),
        row("36", "g s3", "138.2264", g3, x("vplan(g,s3)")?, Drafting, &factor),
        row("37", "b s5", "21.4233", b5, x("vplan(b,s5)")?, Drafting, ""),
        row("38", "g s5", "119.3355", g5, x("vplan(g,s5)")?, Drafting, ""),
    ];
    let [link_2, link_4, link_5, slider] = replay.rates;
    let rates = vec![
        row("", "ω2", "0.0086", link_2, -x("omega(2)")?, Right, ""),
        row("", "ω4", "0.4746", link_4, -x("omega(4)")?, Drafting, last),
        row("", "ω5", "0.1104", link_5, -x("omega(5)")?, Drafting, last),
        row("", "v_S3S2", "61.5254", slider, x("v_r(3/2)")?, Wrong, &v_slide),
    ];
    let normal_parts = vec![
        row("41", "a^n_BA", "100", d("a_n(B/A)")?, x("a_n(B/A)")?, Right, ""),
        row("42", "a^n_S2B", "0.0183", n.s2b, s2b, Wrong, from_length),
        row("42", "a^c_S3S2", "1.0582", n.coriolis, x("a_c(3/2)")?, Wrong, from_length),
        row("44", "a^n_DG", "67.5735", n.dg, x("a_n(D/G)")?, DraftingAndRounding, ""),
        row("44", "a^n_S3D", "0.0356", n.s3d, x("a_n(S3/D)")?, DraftingAndRounding, ""),
        row("46", "a^n_FG", "33.7869", n.fg, x("a_n(F/G)")?, DraftingAndRounding,
            "last digit slipped, 0.4746² · 150 = 33.7868"),
        row("46", "a^n_S5F", "5.3176", n.s5f, x("a_n(S5/F)")?, DraftingAndRounding, ""),
        row("48", "a^n_EB", "0.037", n.eb, x("a_n(E/B)")?, Right, ""),
        row("48", "a^n_S5E", "1.8905", n.s5e, x("a_n(S5/E)")?, DraftingAndRounding, ""),
    ];
    let [b3, g3, b5, g5] = replay.accelerations;
    let tangential_sums = vec![
        row("50", "n_b5 s5", "158.2219", b5, x("aplan(n_b5,s5)")?, DraftingAndRounding, ""),
        row("51", "n_g5 s5", "137.7597", g5, x("aplan(n_g5,s5)")?, Wrong,
            "digits swapped, and used so afterwards"),
        row("52", "n_b3 s3", "40.3939", b3, x("aplan(n_b3,s3)")?, Drafting, touched),
        row("53", "n_g3 s3", "6.173", g3, x("aplan(n_g3,s3)")?, Drafting, touched),
    ];
    let [link_2, link_4, link_5, slider] = replay.second_rates;
    let second_rates = vec![
        row("", "α2 = α3", "0.2663", link_2, x("alpha(2)")?, Right, ""),
        row("", "α4", "0.4485", link_4, x("alpha(4)")?, Right, ""),
        row("", "α5", "0.1616", link_5, x("alpha(5)")?, Drafting, last),
        row("", "a_S3S2", "-25.6695", slider, x("a_r(3/2)")?, Wrong, &a_slide),
    ];

    let section = |title, rows| Section { title, rows };
    Ok(vec![
        section("Lengths to the special points, mm", lengths),
        section("Velocities in the plan, mm/s", velocities),
        section("Angular velocities, rad/s, clockwise positive; sliding velocity, mm/s, from B to E", rates),
        section("Normal parts and Coriolis part, mm/s²", normal_parts),
        section("Tangential sums in the acceleration plan, mm/s²", tangential_sums),
        section(
            "Angular accelerations, rad/s², counter-clockwise positive; sliding acceleration, mm/s²",
            second_rates,
        ),
    ])
}

fn row(
    equation: &'static str,
    quantity: &'static str,
    printed: &'static str,
    drawn: f64,
    exact: f64,
    verdict: Verdict,
    note: &str,
) -> Row {
    Row { equation, quantity, printed, drawn, exact, verdict, note: note.to_owned() }
}

fn solution(text: &str) -> Result<Solution, kinegon::Error> {
    kinegon::solve(&Scene::read(text)?)
}

/// A named quantity; of a vector, its size.
fn number(figure: &Solution, name: &str) -> Result<f64, Box<dyn Error>> {
    Ok(match figure.quantity(name)? {
        Quantity::Number(number) => number,
        Quantity::Vector(vector) => vector.norm(),
    })
}

fn place(figure: &Solution, name: &str) -> Result<Point, Box<dyn Error>> {
    let special = figure.construction.special_point(name);
    let special = special.and_then(|s| s.place.finite());
    let joint = || figure.mechanism.point(name).map(|p| figure.pose.point(p));
    Ok(special.or_else(joint).ok_or_else(|| format!("there is no point {name}"))?)
}

/// The unit vector from one point to another.
fn direction(figure: &Solution, from: &str, to: &str) -> Result<Vector, Box<dyn Error>> {
    Ok((place(figure, to)? - place(figure, from)?).normalize())
}

/// The paper's arithmetic on the paper's drawing; numbers that it goes on with are rounded to four decimals first.
struct Replay {
    lengths: Lengths,
    /// b s3, g s3, b s5, g s5 of the velocity plan (Eqs. 35–38), mm/s.
    velocities: [f64; 4],
    /// ω2, ω4, ω5, clockwise, rad/s; v_S3S2, mm/s.
    rates: [f64; 4],
    normals: Normals,
    /// n_b3 s3, n_g3 s3, n_b5 s5, n_g5 s5 of the acceleration plan (Eqs. 52, 53, 50, 51), mm/s².
    accelerations: [f64; 4],
    /// α2, α4, α5, counter-clockwise, rad/s²; a_S3S2, mm/s².
    second_rates: [f64; 4],
}

/// Lengths as the paper took them, mm.
#[derive(Clone, Copy)]
struct Lengths {
    /// The horizontal component of BS3, which the paper took for the length.
    bs3: f64,
    ds3: f64,
    fs5: f64,
    es5: f64,
    eb: f64,
    dg: f64,
    fg: f64,
}

/// Normal parts and the Coriolis part (Eqs. 42–48), mm/s².
#[derive(Clone, Copy)]
struct Normals {
    s2b: f64,
    coriolis: f64,
    dg: f64,
    s3d: f64,
    fg: f64,
    s5f: f64,
    eb: f64,
    s5e: f64,
}

impl Replay {
    fn new(drawing: &Solution) -> Result<Self, Box<dyn Error>> {
        let length = |name: &str| number(drawing, name).map(four_decimals);
        let lengths = Lengths {
            bs3: four_decimals(place(drawing, "S3")?.x - place(drawing, "B")?.x),
            ds3: length("L(D,S3)")?,
            fs5: length("L(F,S5)")?,
            es5: length("L(E,S5)")?,
            eb: length("L(E,B)")?,
            dg: length("L(D,G)")?,
            fg: length("L(F,G)")?,
        };
        let velocities = [
            number(drawing, "vplan(b,s3)")? * PLAN_OF_S3,
            number(drawing, "vplan(g,s3)")? * PLAN_OF_S3,
            number(drawing, "vplan(b,s5)")?,
            number(drawing, "vplan(g,s5)")?,
        ];
        // Clockwise, link 2 counts against the sliding velocity (Eq. 35); counter-clockwise, with it (Eq. 52).
        let rates = lengths.solve(-1.0, velocities.map(four_decimals))?;

        let normals = Normals::new(&lengths, rates.map(four_decimals));
        let accelerations = normals.plan(drawing)?;
        let mut read = accelerations.map(four_decimals);
        read[3] = SWAPPED;
        let second_rates = lengths.solve(1.0, read)?;
        Ok(Self { lengths, velocities, rates, normals, accelerations, second_rates })
    }
}

impl Lengths {
    /// The rates of links 2, 4, 5 and of the slider from the segments b s3, g s3, b s5, g s5 (Eqs. 35–38, and 52, 53, 50, 51).
    fn solve(&self, link_2: f64, segments: [f64; 4]) -> Result<[f64; 4], Box<dyn Error>> {
        let matrix = Matrix4::from_row_slice(
            &[
                [link_2 * self.bs3, 0.0, 0.0, 1.0],
                [-self.ds3, self.dg, 0.0, 0.0],
                [self.eb, 0.0, self.es5, 0.0],
                [0.0, self.fg, self.fs5, 0.0],
            ]
            .concat(),
        );
        let rates = matrix.lu().solve(&Vector4::from(segments));
        Ok(rates.ok_or("the four equations have no solution")?.into())
    }
}

impl Normals {
    fn new(l: &Lengths, [omega_2, omega_4, omega_5, v_slide]: [f64; 4]) -> Self {
        let normal = |omega: f64, length: f64| omega * omega * length;
        Self {
            s2b: normal(omega_2, l.bs3),
            coriolis: 2.0 * omega_2 * v_slide,
            dg: normal(omega_4, l.dg),
            s3d: normal(omega_2, l.ds3),
            fg: normal(omega_4, l.fg),
            s5f: normal(omega_5, l.fs5),
            eb: normal(omega_2, l.eb),
            s5e: normal(omega_5, l.es5),
        }
    }

    /// Lays off the rounded normal parts and measures n_b3 s3, n_g3 s3, n_b5 s5, n_g5 s5.
    fn plan(&self, drawing: &Solution) -> Result<[f64; 4], Box<dyn Error>> {
        let r = four_decimals;
        let pole = Point::origin();
        let b = pole + direction(drawing, "B", "A")? * number(drawing, "a_n(B/A)")?;
        let b_s3 = direction(drawing, "B", "S3")?;
        let g_d = direction(drawing, "G", "D")?;
        let b_e = direction(drawing, "B", "E")?;
        let g_f = direction(drawing, "G", "F")?;
        // S3 lies beyond G seen from D, so its normal part about D points from G to D.
        let n_b3 = b + b_s3 * (r(self.coriolis) - r(self.s2b));
        let n_g3 = pole - g_d * (r(self.dg) - r(self.s3d));
        let n_b5 = b - b_e * (r(self.eb) + r(self.s5e));
        let n_g5 = pole - g_f * (r(self.fg) + r(self.s5f));
        let [b3, g3] = cross_rays((n_b3, b_s3), (n_g3, g_d))?;
        let [b5, g5] = cross_rays((n_b5, b_e), (n_g5, g_f))?;
        Ok([b3, g3, b5, g5])
    }
}

/// How far from each of the two starts the rays normal to the given lines cross.
fn cross_rays(one: (Point, Vector), other: (Point, Vector)) -> Result<[f64; 2], Box<dyn Error>> {
    let ray = |(start, line): (Point, Vector)| Line::new(start, quarter_turn(line));
    let rays = ray(one).zip(ray(other)).ok_or("a line without direction")?;
    let crossing = rays.0.crossing(&rays.1).place().finite();
    let crossing = crossing.ok_or("two rays are parallel")?;
    Ok([one, other].map(|(start, _)| (crossing - start).norm()))
}

/// The number as the paper writes it down.
fn four_decimals(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}
