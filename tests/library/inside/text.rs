//! Texts of strangers, opened for what shows them.

use kinegon::text::Untrusted;

#[test]
fn nothing_that_a_terminal_obeys_gets_through() {
    for bad in [
        "\u{1b}[31m",
        "\u{9b}31m",
        "\u{90}q",
        "\u{202e}",
        "\u{2066}",
        "\u{7f}",
        "\n",
        "\r",
        "\u{2028}",
        "\u{85}",
        "\u{200f}",
    ] {
        let text = Untrusted::from(format!("a{bad}b"));
        for out in [
            text.for_terminal(),
            text.for_message(),
            text.for_cell(),
            text.for_xml(),
            text.for_tex_comment(),
            text.for_pdf(),
            format!("{text:?}"),
        ] {
            let first = bad.chars().next().expect("it is not empty");
            assert!(!out.contains(first), "{bad:?} in {out:?}");
        }
    }
}

#[test]
fn no_cell_is_a_formula() {
    for (text, expected) in [
        ("=1", "'=1"),
        ("@x", "'@x"),
        ("+a", "'+a"),
        ("-a", "'-a"),
        ("\t=1", " '=1"),
        ("\u{200b}=1", "\u{200b}'=1"),
        ("\u{feff} \u{ad}@", "\u{feff} \u{ad}'@"),
        ("\u{ff1d}1", "'\u{ff1d}1"),
        ("a;=1", "a;'=1"),
        ("a,\u{200b}+x", "a,\u{200b}'+x"),
        ("\"=1", "\"'=1"),
        ("'=1", "''=1"),
        ("-12.5", "-12.5"),
        ("+1e3", "+1e3"),
        ("-1+cmd", "'-1+cmd"),
        ("Ana B.", "Ana B."),
        ("a-b = c", "a-b = c"),
    ] {
        assert_eq!(Untrusted::from(text).for_cell(), expected, "{text:?}");
    }
}

#[test]
fn a_long_name_is_its_start_and_its_length() {
    let text = Untrusted::from("ñ".repeat(100_000));
    assert_eq!(text.for_message(), format!("{}… (100000 characters)", "ñ".repeat(60)));
    assert_eq!(Untrusted::from("a".repeat(80)).for_message(), "a".repeat(80));
}

#[test]
fn what_shows_nothing_is_blank() {
    for text in ["", " ", "\n", "\u{200b}\u{feff}", "\u{a0}\u{3000}", "\u{202e}", "\u{1}"] {
        assert!(Untrusted::from(text).is_blank(), "{text:?}");
    }
    assert!(!Untrusted::from(" . ").is_blank());
}
