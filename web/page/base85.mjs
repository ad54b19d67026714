/**
 * Bytes as printable letters that HTML and templates leave alone, and back: five of 85 letters are four bytes, the first letter the highest; fewer at the end. Of
 * Base64 there would be a sixteenth more. With control characters, which HTML keeps, a tenth less would do; but what edits, copies or filters a file need not keep them.
 */

/** Signs that are no letters: HTML, texts in quotes and templates would trip over them. */
const LEFT_OUT = "<>&\"'\\`{}";
const LETTERS = [...Array(94).keys()].map((code) => String.fromCharCode(33 + code)).filter((letter) => !LEFT_OUT.includes(letter));

export function base85(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 4) {
    const count = Math.min(4, bytes.length - at);
    let number = 0;
    for (let index = 0; index < 4; index += 1) number = number * 256 + (index < count ? bytes[at + index] : 0);
    let group = "";
    for (let index = 0; index < 5; index += 1) {
      group = LETTERS[number % 85] + group;
      number = Math.floor(number / 85);
    }
    text += group.slice(0, count + 1);
  }
  return text;
}

export function bytesOf(text) {
  const digits = new Uint8Array(128);
  LETTERS.forEach((letter, digit) => (digits[letter.charCodeAt(0)] = digit));
  const groups = Math.ceil(text.length / 5);
  const bytes = new DataView(new ArrayBuffer(groups * 4));
  for (let group = 0; group < groups; group += 1) {
    let number = 0;
    for (let at = group * 5; at < group * 5 + 5; at += 1) number = number * 85 + (at < text.length ? (digits[text.charCodeAt(at)] ?? 0) : 84);
    bytes.setUint32(group * 4, number);
  }
  return new Uint8Array(bytes.buffer, 0, groups * 4 - (groups * 5 - text.length));
}
