//! What the example `published_numbers` says about the numbers of Quintero et al. (2011), held against a list made apart from it,
//! and the drawing from which it takes them.

use crate::examples::published_numbers::Verdict::{self, Drafting, DraftingAndRounding, Right, Wrong};
use crate::examples::published_numbers::{Row, table};
use kinegon::geometry::{Point, cross, degrees_of};
use kinegon::scene::Scene;

/// Symbol, equation, digits as printed, digits from the paper's own drawing, exact value with all digits that are sure, verdict.
type Expected = (&'static str, &'static str, &'static str, &'static str, &'static str, Verdict);

#[rustfmt::skip] // a row a line
const EXPECTED: [Expected; 30] = [
    ("L_BS3", "", "248.0601", "370.95", "370.9647574331670510", Wrong),
    ("L_DS3", "", "481.9848", "481.9848", "481.9940922150301091", Drafting),
    ("L_FS5", "", "436.2923", "436.2923", "436.2223094459174108", Drafting),
    ("L_ES5", "", "155.1123", "155.1123", "155.0343572468607363", Drafting),
    ("v_BA", "32", "10", "100", "100", Wrong),
    ("b s3", "35", "59.3891", "59.3891", "59.40764643033", Drafting),
    ("g s3", "36", "138.2264", "138.2264", "138.25019898493", Drafting),
    ("b s5", "37", "21.4233", "21.4233", "21.40585474792", Drafting),
    ("g s5", "38", "119.3355", "119.3355", "119.31951451581", Drafting),
    ("ω2", "", "0.0086", "0.0086", "0.00860783887219", Right),
    ("ω4", "", "0.4746", "0.4746", "0.474663754894", Drafting),
    ("ω5", "", "0.1104", "0.1104", "0.110310615115", Drafting),
    ("v_S3S2", "", "61.5254", "61.5254", "62.6008512896", Wrong),
    ("a^n_BA", "41", "100", "100", "100", Right),
    // The exact values of the next eight follow from the lengths, ω and v_S3S2 above.
    ("a^n_S2B", "42", "0.0183", "0.0183", "0.02748659291", Wrong),
    ("a^c_S3S2", "42", "1.0582", "1.0582", "1.077716082", Wrong),
    ("a^n_DG", "44", "67.5735", "67.5735", "67.59170406", DraftingAndRounding),
    ("a^n_S3D", "44", "0.0356", "0.0356", "0.03571329927", DraftingAndRounding),
    ("a^n_FG", "46", "33.7869", "33.7868", "33.79585203", DraftingAndRounding),
    ("a^n_S5F", "46", "5.3176", "5.3176", "5.308141425", DraftingAndRounding),
    ("a^n_EB", "48", "0.037", "0.0370", "0.03704744502", Right),
    ("a^n_S5E", "48", "1.8905", "1.8905", "1.886525004", DraftingAndRounding),
    ("n_b5 s5", "50", "158.2219", "158.2219", "158.195550355", DraftingAndRounding),
    ("n_g5 s5", "51", "137.7597", "137.7579", "137.734751087", Wrong),
    ("n_b3 s3", "52", "40.3939", "40.3939", "40.377186831", Drafting),
    ("n_g3 s3", "53", "6.173", "6.1730", "6.183385189", Drafting),
    ("α2 = α3", "", "0.2663", "0.2663", "0.266304687858", Right),
    ("α4", "", "0.4485", "0.4485", "0.448468904885", Right),
    ("α5", "", "0.1616", "0.1616", "0.161533268309", Drafting),
    ("a_S3S2", "", "-25.6695", "-25.6696", "-58.4124671031", Wrong),
];

/// Relative error that rounding may leave in an exact value: the four equations' condition is 15.
const ROUNDING: f64 = 1e-14;

fn rows() -> Vec<Row> {
    let sections = table().expect("both scenes can be solved");
    sections.into_iter().flat_map(|s| s.rows).collect()
}

fn decimals(digits: &str) -> usize {
    digits.split_once('.').map_or(0, |(_, d)| d.len())
}

/// Whether `value` rounds to `digits`.
fn rounds_to(digits: &str, value: f64) -> bool {
    format!("{value:.*}", decimals(digits)) == digits
}

#[test]
fn every_number_comes_out_as_listed() {
    let rows = rows();
    assert_eq!(rows.len(), EXPECTED.len());
    for (row, (quantity, equation, printed, drawn, exact, verdict)) in rows.iter().zip(EXPECTED) {
        assert_eq!((row.quantity, row.equation, row.printed, row.verdict), (quantity, equation, printed, verdict));
        let value = row.drawn;
        assert!(rounds_to(drawn, value), "{quantity}: {value}, not {drawn}");
        let known: f64 = exact.parse().expect("digits");
        let half_a_unit = 0.5 * 0.1_f64.powi(decimals(exact) as i32);
        let allowed = half_a_unit.max(ROUNDING * known.abs());
        let value = row.exact;
        assert!((value - known).abs() <= allowed, "{quantity}: {value}, not {exact}");
    }
}

#[test]
fn verdicts_agree_with_the_numbers() {
    for row in rows() {
        let what = row.quantity;
        assert_eq!(
            rounds_to(row.printed, row.exact),
            row.verdict == Right,
            "{what}: right is what the exact value rounds to"
        );
        // What the paper's arithmetic on its drawing does not give: slips of the pen, and two last digits.
        let slips = ["L_BS3", "v_BA", "a^n_FG", "n_g5 s5", "a_S3S2"];
        assert_eq!(
            rounds_to(row.printed, row.drawn),
            !slips.contains(&what),
            "{what}: printed {}, from the drawing {}",
            row.printed,
            row.drawn
        );
        let explained = !row.note.is_empty();
        assert!(row.verdict != Wrong || explained, "{what}: why wrong?");
    }
}

#[test]
fn notes_hold_the_numbers_behind_the_wrong_length() {
    let note = |quantity| {
        let rows = rows().into_iter();
        let mut found = rows.filter(|row| row.quantity == quantity);
        found.next().expect("a row").note
    };
    assert!(note("L_BS3").starts_with("248.0601 "));
    assert!(note("v_S3S2").contains(" 62.59 "));
    assert!(note("a_S3S2").contains(" -58.40 "));
}

#[test]
fn the_drawing_has_the_papers_lengths_but_misses_its_guide() {
    let text = include_str!("../../examples/figure-2-published.json");
    let scene = Scene::read(text).expect("a scene");
    let place = |name: &str| Point::from(scene.coordinates[name]);
    let arm = |from: &str, to: &str| place(to) - place(from);
    let lengths = [
        ("A", "G", 275.0),
        ("A", "B", 100.0),
        ("B", "E", 500.0),
        ("E", "F", 300.0),
        ("G", "D", 300.0),
        ("F", "G", 150.0),
        ("F", "D", 180.0),
    ];
    // Coordinates are written to twelve decimals or more, and one rounding of an f64 near 500 is 6e-14.
    let written = 2e-12;
    for (from, to, length) in lengths {
        let drawn = arm(from, to).norm();
        assert!((drawn - length).abs() < written, "{from}{to} is {drawn}");
    }
    assert!((degrees_of(arm("A", "B")) - 70.0).abs() < 1e-12);
    assert!((degrees_of(arm("B", "E")) - 41.96791045).abs() < 1e-12);
    let guide = arm("B", "E").normalize();
    let off = cross(guide, arm("B", "D"));
    assert!(rounds_to("-0.00933", off), "D is {off} mm left of the guide");
    // F clockwise of D, seen from G.
    assert!(cross(arm("G", "D"), arm("G", "F")) < 0.0);
}
