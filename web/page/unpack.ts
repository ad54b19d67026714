import { XzReadableStream } from "xz-decompress";

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
  const groups = Math.ceil(text.length / 5);
  const bytes = new DataView(new ArrayBuffer(groups * 4));
  for (let group = 0; group < groups; group += 1) {
    let number = 0;
    for (let at = group * 5; at < group * 5 + 5; at += 1) {
      number = number * 85 + (at < text.length ? (digits[text.charCodeAt(at)] ?? 0) : 84);
    }
    bytes.setUint32(group * 4, number);
  }
  return new Uint8Array(bytes.buffer, 0, groups * 4 - (groups * 5 - text.length));
}

/** The text of a packed element of the page. */
function textOf(id: string): string {
  return document.getElementById(id)?.textContent?.trim() ?? "";
}

/**
 * The contents of a packed element of the page, as they would come from a server: `type` is what they are. xz packs the engine a tenth smaller than Zstandard and
 * by a quarter than what browsers unpack by themselves.
 */
export function unpacked(id: string, type: string): Response {
  return new Response(new XzReadableStream(new Blob([bytesOf(textOf(id))]).stream()), { headers: { "content-type": type } });
}

declare global {
  interface Window {
    /** What boot.ts has unpacked the page's script with unpacks the rest, too: it is in the page once. */
    unpacked: typeof unpacked;
  }
}
