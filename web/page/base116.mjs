/**
 * Bytes as letters that HTML leaves alone, and back: seven of 116 letters are six bytes, the first letter the highest; fewer at the end. ASCII has hardly more letters,
 * and of Base 64 there would be eight.
 */

/** The signs of ASCII that are no letters: zero, white space, what HTML, texts in quotes and templates would trip over. Other control characters are: HTML keeps them. */
const LEFT_OUT = [0, 9, 10, 11, 12, 13, 32, ...[..."<&\"\\`"].map((sign) => sign.charCodeAt(0))];
const LETTERS = [...Array(128).keys()].filter((code) => !LEFT_OUT.includes(code));
const BASE = LETTERS.length;
/** What the lower four of six bytes are less than. */
const LOWER = 2 ** 32;

export function base116(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 6) {
    const count = Math.min(6, bytes.length - at);
    let number = 0;
    for (let index = 0; index < 6; index += 1) number = number * 256 + (index < count ? bytes[at + index] : 0);
    let group = "";
    for (let index = 0; index < 7; index += 1) {
      group = String.fromCharCode(LETTERS[number % BASE]) + group;
      number = Math.floor(number / BASE);
    }
    text += group.slice(0, count + 1);
  }
  return text;
}

export function bytesOf(text) {
  const digits = new Uint8Array(128);
  LETTERS.forEach((code, digit) => (digits[code] = digit));
  const groups = Math.ceil(text.length / 7);
  const bytes = new DataView(new ArrayBuffer(groups * 6));
  for (let group = 0; group < groups; group += 1) {
    let number = 0;
    for (let at = group * 7; at < group * 7 + 7; at += 1) number = number * BASE + (at < text.length ? (digits[text.charCodeAt(at)] ?? 0) : BASE - 1);
    bytes.setUint16(group * 6, Math.floor(number / LOWER));
    bytes.setUint32(group * 6 + 2, number % LOWER);
  }
  return new Uint8Array(bytes.buffer, 0, groups * 6 - (groups * 7 - text.length));
}
