//! The text of a form from its bytes: spreadsheets save in more than UTF-8.

use encoding_rs::{Encoding, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// Part of the bytes at which it is seen whether every other one is zero.
const LOOKED_AT: usize = 4096;

/// The text of these bytes: in the encoding that a byte order mark at their start names, else UTF-8, UTF-16 by its
/// zeros, or else Windows-1252, which spreadsheets in Western Europe and America write. `None` for bytes of no text.
pub(super) fn decoded(bytes: Vec<u8>) -> Option<String> {
    let marked = Encoding::for_bom(&bytes).map(|(encoding, _)| encoding);
    let text = match marked.or_else(|| by_zeros(&bytes)) {
        Some(encoding) => encoding.decode(&bytes).0.into_owned(),
        None => match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => WINDOWS_1252.decode(error.as_bytes()).0.into_owned(),
        },
    };
    let is_text = !text.contains(|c: char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{b}' | '\u{c}'));
    is_text.then_some(text)
}

/// UTF-16 without a mark: its Latin letters and digits leave every other byte zero.
fn by_zeros(bytes: &[u8]) -> Option<&'static Encoding> {
    let bytes = &bytes[..bytes.len().min(LOOKED_AT)];
    let zeros = |first: usize| bytes.iter().skip(first).step_by(2).filter(|&&byte| byte == 0).count();
    let [even, odd] = [zeros(0), zeros(1)];
    match bytes.len() / 2 {
        half if half > 1 && odd > half / 2 && even == 0 => Some(UTF_16LE),
        half if half > 1 && even > half / 2 && odd == 0 => Some(UTF_16BE),
        _ => None,
    }
}
