//! Printed answers of 20 textbook cases (`tests/worked`) beside what Kinegon computes from the same lengths.
//! Run with `cargo run --example textbook_cases`; with `-- --markdown` it writes docs/textbook-cases.md.

mod columns;

use columns::{COLUMNS, wrap};
use kinegon::quantity::Quantity;
use kinegon::scene::Scene;
use serde::Deserialize;
use std::error::Error;
use std::fmt::Write;

/// A case with its printed answers.
#[derive(Clone, Debug)]
pub struct Case {
    /// The name of its folder.
    pub id: &'static str,
    /// Where its answers are printed.
    pub source: String,
    /// The answers, in the source's order.
    pub rows: Vec<Row>,
}

/// A printed answer and the computed one.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its name in a scene's `want`, or close to that.
    pub quantity: String,
    /// The digits as printed.
    pub printed: String,
    /// Its unit.
    pub unit: String,
    /// From the lengths of the case.
    pub computed: f64,
    /// The value to 17 digits.
    pub exact: f64,
    /// How far they agree.
    pub verdict: String,
    /// A few words more; may be empty.
    pub note: String,
}

macro_rules! texts {
    ($($id:literal),+ $(,)?) => {
        [$((
            $id,
            include_str!(concat!("../tests/worked/", $id, "/scene.json")),
            include_str!(concat!("../tests/worked/", $id, "/expect.json")),
        )),+]
    };
}

/// Folder, scene and expectations, simplest mechanisms first.
const TEXTS: [(&str, &str, &str); 20] = texts![
    "FB01-khurmi-7.1",
    "FB03-khurmi-8.5",
    "FB05-eme152-hw8-p6-circuit1",
    "FB07-meriam-5-8",
    "FB09-pmks-four-bar-60",
    "SC01-khurmi-7.2",
    "SC02-khurmi-8.1",
    "SC05-ub-eas208-exam3-2010",
    "SC07-mathcad-fourbar-sheet",
    "SC08-pmks-slider_crank_tracer-77",
    "SC10-khurmi-8.3",
    "IN01-beer-15.SP.19-20-geneva",
    "IN02-ansys-VM-WB-MECH-056",
    "IN04-khurmi-7.7-lever",
    "IN06-khurmi-8.14-lever",
    "SB01-marghitu-dupac-E5.5",
    "SB03-khurmi-7.8-whitworth",
    "SB04-pmks-watt-i-0",
    "C3-01-pmks-stephenson-iii-driven-at-FG",
    "DF2-01-pmks-five-bar-from-stephenson",
];

/// Answers whose printed name is the source's own: case, that name, the quantity, and what the source makes of it.
const OWN_NAMES: [(&str, &str, &str, Made); 17] = [
    ("FB05", "theta:r3", "angle(r3)", Made::Radians),
    ("FB05", "theta:r4", "angle(r4)", Made::Radians),
    ("IN01", "beta_deg", "angle(S)", Made::Same),
    ("IN06", "v_B'", "v(B_3)", Made::Same),
    ("IN06", "coriolis", "a_c(2/3)", Made::Same),
    ("SB01", "phi3_deg", "angle(3)", Made::Same),
    ("SB01", "phi4_deg", "angle(4)", Made::Turned(-180.0)),
    ("SB01", "coriolis_x(B3 rel 2)", "a_c(2/3).x", Made::Opposite),
    ("SB01", "coriolis_y(B3 rel 2)", "a_c(2/3).y", Made::Opposite),
    ("SB01", "a_n_DC", "a_n(D/C)", Made::Same),
    ("SB01", "a_t_DC", "a_t(D/C)", Made::Same),
    ("SB01", "vE-vD_x", "v(E/D).x", Made::Same),
    ("SB01", "vE-vD_y", "v(E/D).y", Made::Same),
    ("SB01", "a_n_ED", "a_n(E/D)", Made::Same),
    ("SB01", "a_t_ED", "a_t(E/D)", Made::Same),
    ("SB03", "v_SR", "v(S/R)", Made::Same),
    ("SC07", "theta_deg:BA", "angle(2)", Made::Turned(180.0)),
];

/// What a source makes of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    Same,
    /// An angle in radians.
    Radians,
    /// The angle of the link seen from its other end: so many degrees more.
    Turned(f64),
    /// The motion seen from the other body.
    Opposite,
}

#[derive(Deserialize)]
struct Expectations {
    published: Vec<Published>,
    source: String,
}

#[derive(Deserialize)]
struct Published {
    quantity: String,
    printed: String,
    unit: String,
    verdict: String,
    name: Option<String>,
    exact: f64,
    #[serde(default)]
    magnitude_only: bool,
    #[serde(default)]
    note: String,
}

/// All cases, solved.
///
/// # Errors
/// Only if a case has been changed so that it cannot be solved, or names a quantity that it does not have.
pub fn cases() -> Result<Vec<Case>, Box<dyn Error>> {
    TEXTS.into_iter().map(case).collect()
}

fn case((id, scene, expect): (&'static str, &str, &str)) -> Result<Case, Box<dyn Error>> {
    let Expectations { published, source } = serde_json::from_str(expect)?;
    let solution = kinegon::solve(&Scene::read(scene)?)?;
    let (result, units) = (solution.result(), solution.scene.units);
    let number = |full: &str| -> Result<f64, Box<dyn Error>> {
        let (name, axis) = match full.rsplit_once('.') {
            Some((name, "x")) => (name, Some(0)),
            Some((name, "y")) => (name, Some(1)),
            _ => (full, None),
        };
        let inner = |head: &str| name.strip_prefix(head)?.strip_suffix(')');
        let vector = match inner("position(") {
            Some(slider) if axis.is_none() => {
                let slider = result.sliders.get(slider).and_then(|s| s.position);
                return slider.ok_or_else(|| format!("{id}: no {full}").into());
            }
            Some(point) => result.points.get(point).and_then(|p| p.position),
            None => match solution.quantity(name) {
                Ok(Quantity::Number(number)) => return Ok(number),
                Ok(Quantity::Vector(vector)) => Some([vector.x, vector.y]),
                // The point of a guide under a slider.
                Err(error) => match inner("v(").and_then(|p| result.points.get(p)) {
                    Some(point) => point.velocity,
                    None => return Err(error.into()),
                },
            },
        };
        let vector = vector.ok_or_else(|| format!("{id}: no {full}"))?;
        Ok(match axis {
            Some(axis) => vector[axis],
            None => libm::hypot(vector[0], vector[1]),
        })
    };
    let rows = published.into_iter().map(|p| -> Result<Row, Box<dyn Error>> {
        let own = OWN_NAMES.iter().find(|(case, name, ..)| id.starts_with(case) && *name == p.quantity);
        let (name, made) = match (p.name, own) {
            (Some(name), _) => (name, Made::Same),
            (None, Some(&(_, _, name, made))) => (name.to_owned(), made),
            (None, None) => return Err(format!("{id}: what is {}?", p.quantity).into()),
        };
        let value = number(&name)?;
        let (computed, quantity) = match made {
            Made::Same if p.magnitude_only => (value.abs(), format!("|{name}|")),
            Made::Same => (value, name),
            Made::Radians => (value.to_radians(), name),
            Made::Turned(by) => {
                let sign = if by < 0.0 { '−' } else { '+' };
                (value + by, format!("{name} {sign} {}°", by.abs()))
            }
            Made::Opposite => (-value, format!("−{name}")),
        };
        let unit = match p.unit.as_str() {
            "" => unit_of(&quantity, units.length.as_str(), units.time.as_str()),
            unit => unit.replace("^2", "²"),
        };
        Ok(Row { quantity, printed: p.printed, unit, computed, exact: p.exact, verdict: p.verdict, note: p.note })
    });
    Ok(Case { id, source, rows: rows.collect::<Result<_, _>>()? })
}

/// The unit of a quantity, by its name.
fn unit_of(name: &str, length: &str, time: &str) -> String {
    let name = name.trim_start_matches(['−', '|']);
    match name.split('(').next().unwrap_or_default() {
        "omega" => format!("rad/{time}"),
        "alpha" => format!("rad/{time}²"),
        "angle" => "deg".to_owned(),
        "position" => length.to_owned(),
        head if head.starts_with('v') => format!("{length}/{time}"),
        _ => format!("{length}/{time}²"),
    }
}

/// Below this a computed number is the rounding of zero.
const ZERO: f64 = 1e-13;

/// Twelve digits, without idle zeros.
fn digits(x: f64) -> String {
    if x.abs() < ZERO {
        return "0".to_owned();
    }
    let whole = libm::floor(libm::log10(x.abs())) as i32;
    let decimals = usize::try_from(11 - whole).unwrap_or(0);
    let text = format!("{x:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// Where the verdict begins.
const VERDICT: usize = 66;

/// Verdict and note.
fn remark(row: &Row) -> String {
    let verdict = row.verdict.replace("<=", "≤ ");
    let verdict = verdict.replace("≤  ", "≤ ").replace("(3-6 %)", "(3–6 %)");
    match row.note.as_str() {
        "" => verdict,
        note => format!("{verdict}; {note}"),
    }
}

/// The tables in at most 100 columns.
#[must_use]
pub fn plain(cases: &[Case]) -> String {
    let mut text = String::from("Printed answers of textbook cases, beside the computed ones\n");
    for case in cases {
        let source = wrap(&case.source, COLUMNS).join("\n");
        let _ = write!(text, "\n{}\n{source}\n", case.id);
        let _ = writeln!(text, "  {:<16}{:>21}  {:>15}  {:<8}verdict", "quantity", "printed", "computed", "unit");
        for row in &case.rows {
            let remark = wrap(&remark(row), COLUMNS - VERDICT);
            let _ = writeln!(
                text,
                "  {:<16}{:>21}  {:>15}  {:<8}{}",
                row.quantity,
                row.printed,
                digits(row.computed),
                row.unit,
                remark[0],
            );
            for line in &remark[1..] {
                let _ = writeln!(text, "{:VERDICT$}{line}", "");
            }
        }
    }
    text
}

/// The tables as a Markdown page.
#[must_use]
pub fn markdown(cases: &[Case]) -> String {
    let mut text = String::from(
        "# Textbook cases\n\n\
         Printed answers of textbooks, course sheets and reference data beside what Kinegon computes from the same lengths \
         (`tests/worked`).\n\
         Computed numbers have 12 digits here; `tests/library/worked.rs` holds all of them to 1e-10 and the verdicts to their words.\n\n\
         This page is made by `cargo run --example textbook_cases -- --markdown > docs/textbook-cases.md`.\n",
    );
    for case in cases {
        let _ = write!(
            text,
            "\n## {}\n\n{}.\n\n\
             | quantity | printed | computed | unit | verdict |\n|---|---:|---:|---|---|\n",
            case.id, case.source
        );
        for row in &case.rows {
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} |",
                row.quantity.replace('|', "\\|"),
                row.printed,
                digits(row.computed),
                row.unit,
                remark(row),
            );
        }
    }
    text
}

fn main() -> Result<(), Box<dyn Error>> {
    let cases = cases()?;
    match std::env::args().nth(1).as_deref() {
        None => print!("{}", plain(&cases)),
        Some("--markdown") => print!("{}", markdown(&cases)),
        Some(other) => return Err(format!("{other}: only --markdown is known").into()),
    }
    Ok(())
}
