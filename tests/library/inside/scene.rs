//! The short sign of a scene on a sheet of paper.

use kinegon::scene::{Scene, folded, signs};

#[test]
fn the_hash_is_fnv_1a() {
    // Published values of FNV-1a, 64 bits: of nothing and of "foobar".
    let fold = |hash: u64| (hash >> 40) ^ (hash & 0xff_ffff_ffff);
    assert_eq!(folded(b""), fold(0xcbf2_9ce4_8422_2325));
    assert_eq!(folded(b"foobar"), fold(0x8594_4171_f739_67e8));
    assert_eq!(signs(0), "00000000");
    assert_eq!(signs((1 << 40) - 1), "VVVVVVVV");
    assert_eq!(signs(33), "00000011");
}

#[test]
fn only_what_moves_counts() {
    let scene = |text: &str| Scene::read(text).expect("a scene").fingerprint();
    let drive = r#""links": { "1": { "points": ["A", "B"], "lengths": { "AB": 100 }, "drive": { "angle": 70, "omega": -1 } } } }"#;
    let plain =
        format!(r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0] }}, {drive}"#);
    let dressed = format!(
        r#"{{ "kinegon": 1, "title": "T", "note": "n", "figure": {{ "page": "a3" }},
        "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0.0, 0] }}, {drive}"#
    );
    assert_eq!(scene(&plain), scene(&dressed));
    assert_ne!(scene(&plain), scene(&plain.replace("70", "71")));
    assert_ne!(scene(&plain), scene(&plain.replace("100", "100.1")));
    assert_eq!(scene(&plain).len(), 8);
}
