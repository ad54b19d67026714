//! The survey in words: a table for the terminal, a page, numbers as JSON.

use super::families::Family;
use super::hand;
use super::methods::Method;
use super::survey::{Survey, median};
use serde_json::{Value, json};
use std::fmt::Write;

/// The family by whose parameter the page shows how a special point gets lost.
const SHOWN: Family = Family::Parallel;

/// What is compared with what, how the errors are counted.
const INTRODUCTION: &str = "\
# How accurate, how fast

Velocities and accelerations of fourth-class groups with pins, positions given, by several methods, against a reference of 256 bits:
the equations of all joints in `examples/speed_vs_error/truth.rs`, which `tests/library/accuracy.rs` holds to the 20 digits of `tests/reference`.
Groups are random, or hard for one reason each: a family of groups with a parameter from 10⁻¹ to 10⁻¹⁵, and to zero where the group stays
regular (`examples/speed_vs_error/families.rs`). Ten groups for each family and parameter, 150 random ones; the worst
counts.

This page is made by `cargo run --release --example speed_vs_error`. The errors are the same in every run, the times are not.

![Error against time](accuracy.svg)

An *error* is |computed − true| over the largest true number of that kind (ω, α, v, a) in the group. In *units of u·condition*
(u = 2⁻⁵³) 1 is about what rounding the given numbers would do; there rates count with the size of their links, and accelerations against
ω v too, as in the equations whose condition it is. Groups that Kinegon refuses as singular (condition above 4.5·10¹⁴) are left out.
";

/// What the tests add to the table.
const REMARKS: &str = "
f32 counts in its own units (u = 2⁻²⁴), up to a condition of 8·10⁵; where lengths or rates leave its range it has no number.

With 1000 groups for each family and parameter (`KINEGON_SURVEY=full cargo test --release --test library accuracy::`) Kinegon's velocities and accelerations stay below 1 unit
everywhere, and each ω and α errs by less than 4 u of its own true value whatever the condition, nearly always by less than 1 u, as the nearest f64 does:
what a solution leaves of the equations is computed with twice the digits, and gives a correction until nothing is left. The bound of each rate says the same:
`KINEGON_SURVEY=full cargo test --release --test library error_bounds::` holds it to true errors on a million mechanisms of all classes. The condition then tells how much errors of the
*given* numbers are enlarged, and nothing else.

The equations of all joints lose little more than rounding the given numbers would, but for input motions that are large and nearly alike; Kinegon takes their
differences first.
";

/// The part of the page that is the same in every run.
pub fn accuracy(survey: &Survey) -> String {
    let mut text = String::from(INTRODUCTION);
    let columns = [Method::Naive, Method::Lu, Method::Qr, Method::Library, Method::Single];
    text.push_str("\n## Largest error in units of u·condition\n\n| family |");
    for method in columns {
        let _ = write!(text, " {} |", method.name());
    }
    text.push_str("\n|---|---:|---:|---:|---:|---:|\n");
    for family in Family::ALL {
        let _ = write!(text, "| {} |", family.name());
        for method in columns {
            let _ = write!(text, " {} |", units(survey.worst(family, method), method));
        }
        text.push('\n');
    }
    text.push_str(REMARKS);
    let _ = write!(
        text,
        "\n## {}: largest error, by the parameter\n\n| parameter | condition | {} | {} |\n|---|---:|---:|---:|\n",
        SHOWN.name(),
        Method::Naive.name(),
        Method::Library.name(),
    );
    for row in survey.of(SHOWN) {
        let error = |method: Method| relative(row.errors[method as usize]);
        let _ = writeln!(
            text,
            "| {} | {:.0} | {} | {} |",
            power(row.parameter),
            row.condition,
            error(Method::Naive),
            error(Method::Library),
        );
    }
    text.push_str(
        "\n## By hand\n\nThe same procedure on paper: joints over 150 mm, the largest velocity and acceleration 150 mm long, every point as far \
         beside its place\nas the pencil errs, in a direction by lot. A special point more than 1 m of paper away cannot be drawn.\n\n\
         | pencil errs by | random groups drawn | error, median | hard groups drawn | error, median |\n|---:|---:|---:|---:|---:|\n",
    );
    for (index, pencil) in hand::PENCILS.into_iter().enumerate() {
        let _ = write!(text, "| {pencil} mm |");
        for random in [true, false] {
            let rows = survey.rows.iter();
            let rows = rows.filter(|row| (row.family == Family::Random) == random);
            let (mut errors, mut all) = (Vec::new(), 0);
            for row in rows {
                errors.extend(&row.hand[index]);
                all += row.counted();
            }
            let drawn = 100.0 * errors.len() as f64 / all as f64;
            let middle = 100.0 * median(errors).unwrap_or(f64::NAN);
            let _ = write!(text, " {drawn:.0} % | {} % |", digits(middle));
        }
        text.push('\n');
    }
    text
}

/// The times, measured on the machine of that name.
pub fn speed(times: &[f64], machine: &str) -> String {
    let mut text = format!(
        "\n## Time for velocities and accelerations of a group\n\nOn one core of {machine}; positions given, the quickest of many rounds.\n\n\
         | method | time | what it is |\n|---|---:|---|\n"
    );
    for (method, time) in Method::ALL.into_iter().zip(times) {
        let (name, says) = (method.name(), method.says());
        let _ = writeln!(text, "| {name} | {} | {says} |", duration(*time));
    }
    let _ = writeln!(text, "| by hand | {} | taken, not measured |", duration(hand::TIME));
    text
}

/// A line for each method.
pub fn table(survey: &Survey, times: &[f64]) -> String {
    let mut text = format!(
        "{:<24}{:>10}{:>16}{:>20}  worst family\n{:<24}{:>10}{:>16}{:>20}\n",
        "method", "time", "random groups", "hard families", "", "", "u·condition", "u·condition"
    );
    for (method, time) in Method::ALL.into_iter().zip(times) {
        let random = survey.worst(Family::Random, method);
        let (hard, family) = survey.worst_of_all(method);
        let _ = writeln!(
            text,
            "{:<24}{:>10}{:>16}{:>20}  {}",
            method.name(),
            duration(*time),
            units(random, method),
            units(hard, method),
            family.name(),
        );
    }
    text.push_str("(f32 in its own units)\n\nby hand, 10 min: error of random groups, median\n");
    let random = survey.of(Family::Random).next();
    for (index, pencil) in hand::PENCILS.into_iter().enumerate() {
        let errors = random.map(|row| row.hand[index].clone());
        let middle = 100.0 * median(errors.unwrap_or_default()).unwrap_or(f64::NAN);
        let _ = writeln!(text, "  pencil {pencil:4} mm {:>8} %", digits(middle));
    }
    text
}

/// All numbers; one that is infinite is written as null.
pub fn numbers(survey: &Survey, times: &[f64], machine: &str) -> Value {
    let methods = Method::ALL.into_iter().zip(times);
    let methods =
        methods.map(|(method, time)| json!({ "name": method.name(), "is": method.says(), "nanoseconds": time }));
    let rows = survey.rows.iter().map(|row| {
        json!({
            "family": row.family.name(),
            "parameter": row.parameter,
            "groups": row.counted(),
            "refused": row.refused,
            "condition": row.condition,
            "error": row.errors,
            "error_in_u_condition": row.units,
            "by_hand": row.hand.iter().map(|errors| median(errors.clone())).collect::<Vec<_>>(),
        })
    });
    json!({
        "machine": machine,
        "methods": methods.collect::<Vec<_>>(),
        "pencils_mm": hand::PENCILS,
        "rows": rows.collect::<Vec<_>>(),
    })
}

/// A number of units; of f32 in its own.
fn units(units: f64, method: Method) -> String {
    let own = f64::from(f32::EPSILON) / f64::EPSILON;
    match method {
        _ if !units.is_finite() => "no number".to_owned(),
        Method::Single => digits(units / own),
        _ => digits(units),
    }
}

fn relative(error: f64) -> String {
    match error.is_finite() {
        true => digits(error),
        false => "no number".to_owned(),
    }
}

/// Two digits, or one and a power of ten.
fn digits(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let decade = libm::floor(libm::log10(x.abs())) as i32;
    match decade {
        -2 => format!("{x:.3}"),
        -1 => format!("{x:.2}"),
        0 => format!("{x:.1}"),
        1..=3 => format!("{x:.0}"),
        _ => {
            let text = format!("{x:.0e}");
            let (first, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            format!("{first}·10{}", raised(exponent))
        }
    }
}

/// A power of ten, or zero.
fn power(parameter: f64) -> String {
    if parameter == 0.0 {
        return "0, parallel".to_owned();
    }
    let exponent = libm::round(libm::log10(parameter)) as i32;
    format!("10{}", raised(&exponent.to_string()))
}

fn raised(exponent: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    };
    exponent.chars().map(raised).collect()
}

/// A time in nanoseconds, with its unit.
pub fn duration(nanoseconds: f64) -> String {
    match nanoseconds {
        t if t < 1e3 => format!("{t:.0} ns"),
        t if t < 1e6 => format!("{:.1} µs", t / 1e3),
        t => format!("{:.0} min", t / 60e9),
    }
}
