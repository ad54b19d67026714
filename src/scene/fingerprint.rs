//! A short sign by which a sheet of paper knows its scene.

use super::read::{Scene, SceneFile};
use super::text::FileKind;
use super::typed::read_as;
use super::write::text_of;

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
        let text = text_of(&SceneFile { title: None, figure: None, ..file });
        serde_json::from_str::<serde_json::Value>(&text).map_or(text, |json| json.to_string())
    }
}

/// FNV-1a of 64 bits, folded to 40.
pub fn folded(bytes: &[u8]) -> u64 {
    let hash = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3));
    (hash >> BITS) ^ (hash & ((1 << BITS) - 1))
}

/// A number of 40 bits in base 32, the highest digit first.
pub fn signs(number: u64) -> String {
    let digits = (0..BITS / 5).rev().map(|place| DIGITS[(number >> (5 * place)) as usize % 32]);
    digits.map(char::from).collect()
}
