//! The survey in words: a table for the terminal, a page, numbers as JSON.

use super::families::Family;
use super::hand;
use super::lengths::{Lengths, Reading, WAYS, WAYS_SAY};
use super::measure::U;
use super::methods::Method;
use super::survey::{ROUNDS, Survey, TIMED, median, quantile};
use serde_json::{Value, json};
use std::fmt::Write;

/// The family by whose parameter the page shows how a special point gets lost.
const SHOWN: Family = Family::Parallel;

/// What is compared with what, how the errors are counted.
const INTRODUCTION: &str = "\
# How accurate, how fast

Velocities and accelerations of fourth-class groups with pins, positions given, by several methods, against a reference of 256 bits:
the equations of all joints in `tests/support/speed_vs_error/truth.rs`, which `tests/library/accuracy.rs` holds to the 20 digits of `tests/reference/README.md`.
Groups are random, or hard for one reason each: a family of groups with a parameter from 10⁻¹ to 10⁻¹⁵, and to zero where the group stays
regular (`tests/support/speed_vs_error/families.rs`). Ten groups for each family and parameter, 150 random ones (seeds 100 to 119); the worst
counts.

This page is made by `cargo run --release --example speed_vs_error`. The errors are the same in every run, the times are not.

![Error against time](accuracy.svg)

An *error* is |computed − true| over the largest true number of that kind (ω, α, v, a) in the group. In *units of u·condition*
(u = 2⁻⁵³) 1 is about what rounding the given numbers would do; there rates count with the size of their links, and accelerations against
ω v too, as in the equations whose condition it is. Groups that Kinegon refuses as singular (condition above 4.5·10¹⁴) are left out.
";

/// What is measured where positions are not given.
const FROM_LENGTHS: &str = "
## Positions from lengths

Where a program finds positions from lengths, it knows them to rounding of its own, and rates inherit that: u·condition once for the
positions and once more for the rates. So errors of α grow with the square of the condition where it is large, whoever computes them. The truth is found from the same lengths with
256 bits, by Newton's method on the equations of all joints (`tests/support/speed_vs_error/assembled.rs`); what is given are the coordinates of joints in their
links' own frames. Errors are those of ω and α, over the largest true one of the mechanism, in units of u·condition: median, largest. Random mechanisms have pins and
sliders by lot (`tests/support/planted.rs`, seeds 502, 503 and 506), those of higher class six links; where sliders leave links no rotation of their own nothing is to err, so some medians are 0.
Cycles are those of the starting scenes.

![Error against condition](accuracy-condition.svg)

The lines are u·condition and its product with the condition. Where positions are given, Kinegon with bounds keeps 16 digits whatever the condition. From lengths nobody does:
towards a limit position all three lose alike, since the rounding of the crank's angle is enlarged as well; there Newton's method on all joints' equations is as good as Kinegon. Next to a
change point the crank's angle is not the trouble but the gaps of the loops are: tables compute these with twice the digits and keep three digits more than one position,
whose joints are rounded to f64 before its rates are found.

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
differences first. Whoever does so, as the four loop equations on differences do, and solves them by LU, has nearly the digits of the column Kinegon: what
Kinegon adds there is speed, and with bounds the digits that a condition number takes.
";

/// The part of the page that is the same in every run.
pub fn accuracy(survey: &Survey) -> String {
    let mut text = String::from(INTRODUCTION);
    let columns =
        [Method::Naive, Method::Lu, Method::Qr, Method::Differences, Method::Library, Method::Kernel, Method::Single];
    text.push_str("\n## Largest error in units of u·condition\n\n| family |");
    for method in columns {
        let _ = write!(text, " {} |", method.name());
    }
    text.push_str("\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
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
        "\n## By hand\n\nThe same procedure on paper (`tests/support/speed_vs_error/hand.rs`): joints over 150 mm, the largest velocity and acceleration \
         150 mm long, every point as far beside its place\nas the pencil errs, in a direction by lot. A special point more than 1 m of \
         paper away cannot be drawn. Errors of a drawing are stated in the middle\nand nine tenths of all: its worst case is a matter of \
         luck, which is why the picture does not show them beside the others' worst.\n\n\
         | pencil errs by | random groups drawn | error, median | 90 % below | hard groups drawn | error, median | 90 % below |\n\
         |---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for (index, pencil) in hand::PENCILS.into_iter().enumerate() {
        let _ = write!(text, "| {pencil} mm |");
        for random in [true, false] {
            let rows = survey.rows.iter();
            let rows = rows.filter(|row| (row.family == Family::Random) == random);
            let (mut errors, mut all) = (Vec::new(), 0);
            for row in rows {
                errors.extend(row.hand[index].iter().copied());
                all += row.counted();
            }
            let drawn = 100.0 * errors.len() as f64 / all as f64;
            let [middle, most] = [0.5, 0.9].map(|share| 100.0 * quantile(&errors, share).unwrap_or(f64::NAN));
            let _ = write!(text, " {drawn:.0} % | {} % | {} % |", digits(middle), digits(most));
        }
        text.push('\n');
    }
    text
}

/// What is measured from lengths; the last digits of tables depend on the processor's registers.
pub fn from_lengths(lengths: &Lengths) -> String {
    let mut text = String::from(FROM_LENGTHS);
    for (way, says) in WAYS.into_iter().zip(WAYS_SAY) {
        let _ = writeln!(text, "- **{way}**: {says}");
    }
    text.push_str("\n### All classes\n\n| class | mechanisms | condition, median | positions given: Kinegon | joint equations, LU |");
    WAYS.iter().for_each(|way| text.push_str(&format!(" from lengths: {way} |")));
    text.push_str("\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for class in &lengths.classes {
        let condition = median(class.given.iter().map(|g| g.0)).unwrap_or(f64::NAN);
        let _ = write!(text, "| {} | {} | {condition:.0} |", class.name, class.given.len());
        for k in 0..2 {
            let units = class.given.iter().map(|(condition, errors)| errors[k] / (U * condition));
            let _ = write!(text, " {} |", spread(units));
        }
        let _ = writeln!(text, "{}", columns(&class.lengths));
    }
    text.push_str("\n### Along a cycle\n\n| mechanism | positions | largest condition |");
    WAYS.iter().for_each(|way| text.push_str(&format!(" {way} |")));
    text.push_str("\n|---|---:|---:|---:|---:|---:|\n");
    for cycle in &lengths.cycles {
        let condition = cycle.readings.iter().map(|r| r.condition).fold(0.0, f64::max);
        let (name, count) = (&cycle.name, cycle.readings.len());
        let _ = writeln!(text, "| {name} | {count} | {} |{}", digits(condition), columns(&cycle.readings));
    }
    for approach in &lengths.approaches {
        let _ = write!(text, "\n### {}\n\n| distance | condition |", approach.name);
        WAYS.iter().for_each(|way| text.push_str(&format!(" {way} |")));
        text.push_str("\n|---:|---:|---:|---:|---:|\n");
        for (distance, reading) in &approach.rows {
            let _ = write!(text, "| {}° | {} |", digits(*distance), digits(reading.condition));
            reading.errors.iter().for_each(|error| text.push_str(&format!(" {} |", relative(*error))));
            text.push('\n');
        }
    }
    text
}

/// Median and largest error of each way, in units u·condition.
fn columns(readings: &[Reading]) -> String {
    let column = |way: usize| spread(readings.iter().map(|r| r.errors[way] / (U * r.condition)));
    (0..WAYS.len()).map(|way| format!(" {} |", column(way))).collect()
}

/// Median and largest of some numbers.
pub(super) fn spread(numbers: impl Iterator<Item = f64>) -> String {
    let numbers: Vec<f64> = numbers.collect();
    let largest = numbers.iter().copied().fold(0.0, f64::max);
    format!("{}, {}", relative(median(numbers).unwrap_or(f64::NAN)), relative(largest))
}

/// The times, measured on the machine of that name.
pub fn speed(times: &[f64], machine: &str) -> String {
    let mut text = format!(
        "\n## Time for velocities and accelerations of a group\n\nOn one core of {machine}; positions given, the quickest of {ROUNDS} rounds over {TIMED} random groups \
         (seed 1).\n\n| method | time | what it is | its code |\n|---|---:|---|---|\n"
    );
    for (method, time) in Method::ALL.into_iter().zip(times) {
        let (name, says) = (method.name(), method.says());
        let _ = writeln!(text, "| {name} | {} | {says} | `{}` |", duration(*time), method.source());
    }
    let _ = writeln!(
        text,
        "| by hand | {} | taken, not measured | `tests/support/speed_vs_error/hand.rs` |",
        duration(hand::TIME)
    );
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

pub(super) fn relative(error: f64) -> String {
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
        t if t < 1e9 => format!("{:.1} ms", t / 1e6),
        t => format!("{:.0} min", t / 60e9),
    }
}
