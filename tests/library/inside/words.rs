//! Catalogues of sentences, and how numbers are written.

use crate::messages::declared;
use kinegon::check::Mistake;
use kinegon::fluent::Catalogue;
use kinegon::message::Declared;
use kinegon::scene::{DecimalMark, LanguageName};
use kinegon::words::sentences;
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

fn catalogue(text: &str) -> (Catalogue, Vec<String>) {
    Catalogue::read("pt", text.to_owned().leak())
}

#[test]
fn blanks_are_filled_by_name() {
    let (catalogue, faults) =
        catalogue("# Words.\n\nplan = {\" \"}plan\ncross = on {$ray}: {$image}, {$ray}\nbrace = {\"{\"} {$a}");
    assert_eq!(faults, [""; 0]);
    let filled = |key: &str, blanks: &[&str], by: &[&str]| {
        catalogue.filled(catalogue.sentence(key).expect("it is there"), blanks, by)
    };
    assert_eq!(catalogue.sentence("plan").and_then(|plan| plan.words()), Some(" plan"));
    assert_eq!(filled("cross", &["image", "ray"], &["b", "r"]), "on r: b, r");
    // Braces in the text that fills a blank are no blanks.
    assert_eq!(filled("brace", &["a"], &["{$a}"]), "{ {$a}");
    assert_eq!(catalogue.sentence("cross").expect("it is there").blanks(), BTreeSet::from(["image", "ray"]));
    assert!(catalogue.sentence("ray").is_none());
}

/// In Portuguese zero and one are singular, in English one alone (Unicode CLDR, plural rules).
#[test]
fn words_follow_numbers_and_names() {
    let text = "points = {$count ->\n    [one] {$count} ponto\n   *[other] {$count} pontos\n  } do {$what ->\n    [elo] elo\n   *[other] ramo\n  }";
    let said = |language: &str, count: &str, what: &str| {
        let (catalogue, faults) = Catalogue::read(language, text);
        assert_eq!(faults, [""; 0]);
        catalogue.filled(catalogue.sentence("points").expect("it is there"), &["count", "what"], &[count, what])
    };
    for (language, count, what, says) in [
        ("pt", "0", "elo", "0 ponto do elo"),
        ("pt", "1", "", "1 ponto do ramo"),
        ("pt", "2", "elo", "2 pontos do elo"),
        ("en", "0", "elo", "0 pontos do elo"),
        ("en", "1", "elo", "1 ponto do elo"),
        ("de", "1.5", "elo", "1.5 pontos do elo"),
        ("es", "at least 4096", "elo", "at least 4096 pontos do elo"),
    ] {
        assert_eq!(said(language, count, what), says, "{language}");
    }
}

#[test]
fn a_bad_line_is_named() {
    for (line, says) in [
        ("cross on {$ray}", "line 2: Expected a token starting with \"=\""),
        ("plan = again", "`plan` is here for the second time"),
        ("cross = {plan}", "`cross`: in braces stand blanks as {$name} and texts in quotes"),
        ("cross = {$image", "line 2: Expected a token starting with \"}\""),
        ("-cross = ray", "`cross`: only sentences are read, no terms and no attributes"),
    ] {
        let (_, faults) = catalogue(&format!("plan = plan\n{line}\nwrong = wrong"));
        assert_eq!(faults, [says], "{line}");
    }
}

#[test]
fn every_catalogue_says_everything_and_nothing_else() {
    let mistakes = Mistake::all().flat_map(Mistake::sentences);
    let mistakes: Vec<String> =
        mistakes.flat_map(|told| ["done", "should"].map(|which| format!("{}-{which}", told.key))).collect();
    let messages = declared();
    for name in LanguageName::ALL {
        let (catalogue, faults) = Catalogue::read(name.as_str(), catalogue_of(name));
        assert!(faults.is_empty(), "the catalogue of `{}`:\n{}", name.as_str(), faults.join("\n"));
        for Declared { key, blanks } in sentences::declared() {
            let own = catalogue.sentence(key).unwrap_or_else(|| panic!("{name:?} lacks {key}"));
            assert_eq!(own.blanks(), blanks.iter().copied().collect(), "the blanks of `{key}` in {name:?}");
            assert!(!blanks.is_empty() || own.words().is_some(), "`{key}` in {name:?} chooses words, but has no blank");
        }
        let is_known = |key: &&str| {
            let sentences = || sentences::declared().iter().any(|declared| declared.key == *key);
            key.starts_with("page-")
                || messages.contains_key(key)
                || mistakes.iter().any(|known| known == key)
                || sentences()
        };
        let further: Vec<&str> = catalogue.keys().filter(|key| !is_known(key)).collect();
        assert!(further.is_empty(), "{name:?} has sentences that nobody says: {further:?}");
        // What follows that heading the library does not read.
        let (_, page) = catalogue_of(name).split_once("\n## The workbench").expect("the page's part");
        let own = page.lines().filter(|line| line.contains(" = ") && line.starts_with(char::is_alphabetic));
        let misplaced: Vec<&str> = own.filter(|line| !line.starts_with("page-")).collect();
        assert!(misplaced.is_empty(), "{name:?}: {misplaced:?}");
    }
}

/// The two sentences of each key of a mistake are there in every language, with the blanks that they have in English;
/// together they tell every blank.
#[test]
fn every_language_tells_every_mistake() {
    let english = kinegon::fluent::english();
    for language in LanguageName::ALL {
        let catalogue = Catalogue::read(language.as_str(), catalogue_of(language)).0;
        for told in Mistake::all().flat_map(Mistake::sentences) {
            let blanks: BTreeSet<&str> = told.blanks.iter().map(|(name, _)| *name).collect();
            let mut used = BTreeSet::new();
            for key in ["done", "should"].map(|which| format!("{}-{which}", told.key)) {
                let own = catalogue.sentence(&key).unwrap_or_else(|| panic!("{language:?} lacks {key}")).blanks();
                assert_eq!(
                    Some(&own),
                    english.sentence(&key).map(|told| told.blanks()).as_ref(),
                    "`{key}` in {language:?}"
                );
                used.extend(own);
            }
            assert_eq!(used, blanks, "`{}` does not tell all", told.key);
        }
    }
}

/// What the page says has the same blanks in every language; titles of starting scenes and the editor's words stand in English elsewhere.
#[test]
fn every_language_has_the_words_of_the_page() {
    let english = &Catalogue::read("en", catalogue_of(LanguageName::English)).0;
    let is_elsewhere = |key: &str| key.starts_with("page-kinds-") || key.starts_with("page-editor-");
    let all = |catalogue: &Catalogue| -> BTreeSet<&'static str> {
        catalogue.keys().filter(|key| key.starts_with("page-")).collect()
    };
    let spanish = all(&Catalogue::read("es", catalogue_of(LanguageName::Spanish)).0);
    for language in LanguageName::ALL {
        let catalogue = Catalogue::read(language.as_str(), catalogue_of(language)).0;
        let own = all(&catalogue);
        let expected = spanish.iter().copied().filter(|key| language != LanguageName::English || !is_elsewhere(key));
        assert_eq!(own, expected.collect(), "{language:?}");
        for key in own.into_iter().filter(|key| !is_elsewhere(key)) {
            let [own, english] = [&catalogue, english].map(|all| all.sentence(key).map(|said| said.blanks()));
            assert_eq!(own, english, "`{key}` in {language:?}");
        }
    }
}
