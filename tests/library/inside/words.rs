//! Catalogues of sentences, and how numbers are written.

use crate::messages::declared;
use kinegon::check::Mistake;
use kinegon::message::filled;
use kinegon::scene::{DecimalMark, LanguageName};
use kinegon::words::catalogue::{Declared, Read, blanks_of, read};
use kinegon::words::sentences::DECLARED;
use kinegon::words::{Medium, NumberStyle, catalogue_of, with_prime};
use std::collections::BTreeSet;

#[test]
fn primes_stand_by_the_letter() {
    for (name, primed) in [("b", "b′"), ("s3", "s′3"), ("d_2", "d′_2"), ("s_{24}", "s′_{24}"), ("b'", "b'′")]
    {
        assert_eq!(with_prime(name), primed);
    }
}

const FIVE: NumberStyle = NumberStyle::significant(5).in_full(-4, 7);

fn written(style: NumberStyle, x: f64) -> String {
    style.write(x, DecimalMark::Point)
}

#[test]
fn numbers_have_significant_digits() {
    for (x, text, figure) in [
        (0.0, "0", "0"),
        (-0.0, "0", "0"),
        (f64::NEG_INFINITY, "-inf", "−inf"),
        (0.25, "0.25000", "0.25000"),
        (-12.0, "-12.000", "−12.000"),
        (1234567.8, "1234568", "1\u{a0}234\u{a0}568"),
        (12345678.0, "1.2346e7", "1.2346·10^{7}"),
        (0.000123456, "0.00012346", "0.00012346"),
        (-0.0000123456, "-1.2346e-5", "−1.2346·10^{−5}"),
        (5e-324, "4.9407e-324", "4.9407·10^{−324}"),
        (f64::MAX, "1.7977e308", "1.7977·10^{308}"),
    ] {
        assert_eq!(written(FIVE, x), text);
        assert_eq!(written(FIVE.on(Medium::Figure), x), figure);
    }
}

/// On figures a number has no more digits than its neighbours.
#[test]
fn rounded_numbers_have_no_more_digits_before_the_mark() {
    let three = NumberStyle::significant(3).rounded().in_full(-3, 6);
    for (x, text) in
        [(83295.0, "83300"), (-999_999.0, "-1.00e6"), (2443.2, "2440"), (0.012_345, "0.0123"), (12.0, "12.0")]
    {
        assert_eq!(written(three, x), text);
    }
}

#[test]
fn rounding_may_give_the_next_power_of_ten() {
    for (x, five, four) in [
        (9.99996, "10.000", "10"),
        (-9.99996, "-10.000", "-10"),
        (9.9999, "9.9999", "10"),
        (0.0000999999, "0.00010000", "0.0001"),
        (9999999.0, "1.0000e7", "1e7"),
        (9.99999e-9, "1.0000e-8", "1e-8"),
    ] {
        assert_eq!(written(FIVE, x), five);
        assert_eq!(written(NumberStyle::significant(4).in_full(-4, 7).trimmed(), x), four);
    }
}

#[test]
fn idle_zeros_are_left_out() {
    let four = NumberStyle::significant(4).trimmed().on(Medium::Figure);
    for (x, text) in [
        (-1.25, "−1.25"),
        (1234.56, "1235"),
        (0.000123456, "0.0001235"),
        (1.5e-7, "1.5·10^{−7}"),
        (200.0, "200"),
        (-3e12, "−3·10^{12}"),
    ] {
        assert_eq!(written(four, x), text);
    }
}

#[test]
fn long_numbers_stand_in_groups() {
    let figure = NumberStyle::shortest().on(Medium::Figure);
    for (x, text) in [
        (1040.0, "1040"),
        (-83300.0, "−83 300"),
        (123456.75, "123 456.75"),
        (-1234567.0, "−1 234 567"),
        (0.12345678, "0.12345678"),
        (1e-12, "1·10^{−12}"),
    ] {
        assert_eq!(written(figure, x).replace('\u{a0}', " "), text);
        assert!(!written(figure, x).contains(' '), "{x} is broken");
    }
    assert_eq!(figure.with_plus().write(12345.5, DecimalMark::Comma), "+12\u{a0}345,5");
    assert_eq!(written(NumberStyle::shortest(), 83300.0), "83300");
}

#[test]
fn decimals_are_counted_from_the_mark() {
    let two = NumberStyle::decimals(2);
    assert_eq!([0.0, 12.345, -1e9].map(|x| written(two, x)), ["0.00", "12.35", "-1000000000.00"]);
    assert_eq!([0.0, -0.5].map(|x| written(two.with_plus().on(Medium::Figure), x)), ["+0.00", "−0.50"]);
    let scale = NumberStyle::decimals(6).trimmed().in_full(-4, 6);
    let scales = [0.0, 0.0025, 0.00012345678, 20.0, 2.5e-5, 1e6].map(|x| written(scale, x));
    assert_eq!(scales, ["0", "0.0025", "0.000123", "20", "2.5e-5", "1e6"]);
}

#[test]
fn the_shortest_text_reads_back() {
    let shortest = NumberStyle::shortest();
    assert_eq!([0.1, -30.0, 1e-7].map(|x| written(shortest, x)), ["0.1", "-30", "0.0000001"]);
    assert_eq!([0.1, 1e-7, 1e9].map(|x| written(shortest.in_full(-5, 9), x)), ["0.1", "1e-7", "1e9"]);
}

#[test]
fn bounds_are_rounded_up() {
    for (x, text) in
        [(0.0, "0"), (3e-17, "3e-17"), (3.0000001e-17, "4e-17"), (9.5e-17, "1e-16"), (9.2e-17, "1e-16"), (-2.1, "-3e0")]
    {
        assert_eq!(written(NumberStyle::bound(), x), text);
    }
    assert_eq!(written(NumberStyle::bound().on(Medium::Figure), 2.1e-15), "3·10^{−15}");
}

#[test]
fn the_decimal_mark_is_that_of_the_wording() {
    let comma = |style: NumberStyle, x: f64| style.write(x, DecimalMark::Comma);
    assert_eq!(comma(FIVE, -9.99996), "-10,000");
    assert_eq!(comma(FIVE.on(Medium::Figure), 1e-9), "1,0000·10^{−9}");
    assert_eq!(comma(NumberStyle::decimals(2).with_plus(), 0.125), "+0,12");
    assert_eq!(comma(NumberStyle::shortest(), 30.0), "30");
}

const TWO: [Declared; 2] = [
    Declared { key: "plan", blanks: &[], english: " plan" },
    Declared { key: "cross", blanks: &["image", "ray"], english: "on {ray}: {image}" },
];

#[test]
fn blanks_are_filled_by_name() {
    let text = "# Words.\n\nplan = \" plan\"\ncross = on {ray}: {image}, {ray}\nwrong.done = a = {image}";
    let (Read { sentences, tables }, faults) = read(text, &TWO);
    assert_eq!(faults, [""; 0]);
    let [plan, cross] = [0, 1].map(|i| sentences[i].expect("it is there"));
    assert_eq!(plan, " plan");
    assert_eq!(filled(cross, &["image", "ray"], &["b", "r"]), "on r: b, r");
    // Braces in the text that fills a blank are no blanks.
    assert_eq!(filled(tables["wrong.done"], &["image", "ray"], &["{ray}", "r"]), "a = {ray}");
}

#[test]
fn a_bad_line_is_named() {
    for (line, says) in [
        ("cross on {ray}", "line 2: no = in `cross on {ray}`; a line is: key = sentence"),
        ("crosses = {image}", "line 2: no sentence is called `crosses`"),
        ("plan = again", "line 2: `plan` is here for the second time"),
        ("cross = {image}", "line 2: `cross`: {ray} is missing"),
        ("cross = {image} {rays}", "line 2: `cross`: there is no {rays} here, only {image}, {ray}"),
        ("plan = {image}", "line 2: `plan`: there is no {image} here, only words"),
        ("cross = {image {ray}", "line 2: `cross`: a { without its }"),
        ("cross = image} {ray}", "line 2: `cross`: a } without its {"),
        ("cross = {image}} {ray}", "line 2: `cross`: a } without its {"),
    ] {
        let text = format!("plan = plan\n{line}\nwrong.done = wrong").leak();
        let (_, faults) = read(text, &TWO);
        assert_eq!(faults, [says, "`cross` is missing or cannot be read"]);
    }
}

#[test]
fn every_catalogue_says_everything() {
    for declared in DECLARED {
        let blanks = blanks_of(declared.english, declared.blanks);
        let all = declared.blanks.iter().copied().collect();
        assert_eq!(blanks, Ok(all), "the English words of `{}`", declared.key);
    }
    for name in LanguageName::ALL.into_iter().filter(|name| *name != LanguageName::English) {
        let (_, faults) = read(catalogue_of(name), DECLARED);
        assert!(faults.is_empty(), "the catalogue of `{}`:\n{}", name.as_str(), faults.join("\n"));
    }
}

/// The two sentences of each key of a mistake are there in every language, with the blanks that they have in English;
/// together they tell every blank. No file has sentences of other mistakes, nor of other messages.
#[test]
fn every_language_tells_every_mistake() {
    let tables = |name| read(catalogue_of(name), &[]).0.tables;
    let english = tables(LanguageName::English);
    for language in LanguageName::ALL {
        let mut left = tables(language);
        let messages = declared();
        left.retain(|key, _| !messages.contains_key(key));
        for told in Mistake::all().flat_map(Mistake::sentences) {
            let blanks: Vec<&str> = told.blanks.iter().map(|(name, _)| *name).collect();
            let mut used = BTreeSet::new();
            for key in ["done", "should"].map(|which| format!("{}.{which}", told.key)) {
                let own = left.remove(key.as_str()).unwrap_or_else(|| panic!("{language:?} lacks {key}"));
                let of = |text| blanks_of(text, &blanks).unwrap_or_else(|says| panic!("{key}: {says}"));
                let [own, english] = [own, english[key.as_str()]].map(of);
                assert_eq!(own, english, "the blanks of `{key}` in {language:?}");
                used.extend(own);
            }
            assert_eq!(used.len(), blanks.len(), "`{}` does not tell all", told.key);
        }
        assert!(left.is_empty(), "{language:?} has sentences of no mistake and no message: {left:?}");
    }
}
