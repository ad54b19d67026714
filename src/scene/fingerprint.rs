//! A short sign by which a sheet of paper knows its scene.

use super::read::{Scene, SceneFile};
use super::text::FileKind;
use super::typed::read_as;
use super::write;

/// Bits of the sign: eight digits of base 32.
const BITS: u32 = 40;
/// Digits of base 32.
const DIGITS: &[u8; 32] = b"0123456789ABCDEFGHIJKLMNOPQRSTUV";

impl Scene {
    /// Eight signs from `0`–`9` and `A`–`V` that stand for the scene: 40 bits of its mechanism, motion and wanted
    /// quantities as they are written into a file. Title, figure, notes and layout of the file do not count.
    ///
    /// Two different scenes have the same signs with a probability of 10⁻¹².
    #[must_use]
    pub fn fingerprint(&self) -> String {
        signs(folded(self.canonical().as_bytes()))
    }

    /// The scene as it is written into a file, without title and figure, on one line without white.
    fn canonical(&self) -> String {
        // Its text has been read before.
        let Ok(file) = read_as::<SceneFile>(self.text(), &FileKind::SCENE) else { return String::new() };
        let text = write::text(&SceneFile { title: None, figure: None, ..file });
        serde_json::from_str::<serde_json::Value>(&text).map_or(text, |json| json.to_string())
    }
}

/// FNV-1a of 64 bits, folded to 40.
fn folded(bytes: &[u8]) -> u64 {
    let hash = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3));
    (hash >> BITS) ^ (hash & ((1 << BITS) - 1))
}

/// A number of 40 bits in base 32, the highest digit first.
fn signs(number: u64) -> String {
    let digits = (0..BITS / 5).rev().map(|place| DIGITS[(number >> (5 * place)) as usize % 32]);
    digits.map(char::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let plain = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0] }}, {drive}"#
        );
        let dressed = format!(
            r#"{{ "kinegon": 1, "title": "T", "note": "n", "figure": {{ "page": "a3" }},
            "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0.0, 0] }}, {drive}"#
        );
        assert_eq!(scene(&plain), scene(&dressed));
        assert_ne!(scene(&plain), scene(&plain.replace("70", "71")));
        assert_ne!(scene(&plain), scene(&plain.replace("100", "100.1")));
        assert_eq!(scene(&plain).len(), 8);
    }
}
