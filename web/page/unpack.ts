import { decompress } from "fzstd";

/** Signs that are no letters of Base 85: HTML, texts in quotes and templates would trip over them. */
const LEFT_OUT = "<>&\"'\\`{}";

/** The bytes of a text in Base 85 as `base85` of bundle.mjs writes it: five letters are four bytes, the first the highest; fewer at the end. */
function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const digits = new Uint8Array(128);
  let next = 0;
  for (let code = 33; code < 127; code += 1) {
    if (LEFT_OUT.includes(String.fromCharCode(code))) continue;
    digits[code] = next;
    next += 1;
  }
  const rest = text.length % 5;
  const bytes = new Uint8Array(Math.floor(text.length / 5) * 4 + Math.max(0, rest - 1));
  for (let from = 0, to = 0; from < text.length; from += 5, to += 4) {
    let number = 0;
    for (let index = 0; index < 5; index += 1) {
      number = number * 85 + (from + index < text.length ? (digits[text.charCodeAt(from + index)] ?? 0) : 84);
    }
    for (let index = 0; index < 4 && to + index < bytes.length; index += 1) {
      bytes[to + index] = Math.floor(number / 256 ** (3 - index)) % 256;
    }
  }
  return bytes;
}

/** The text of a packed element of the page. */
function textOf(id: string): string {
  return document.getElementById(id)?.textContent?.trim() ?? "";
}

/** The contents of a packed element of the page. Zstandard packs them by an eighth to a fifth smaller than what browsers unpack by themselves. */
export function unpacked(id: string): Uint8Array<ArrayBuffer> {
  return decompress(bytesOf(textOf(id))) as Uint8Array<ArrayBuffer>;
}

declare global {
  interface Window {
    /** What boot.ts has unpacked the page's script with unpacks the rest, too: it is in the page once. */
    unpacked: typeof unpacked;
  }
}
