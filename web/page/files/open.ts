import { element } from "../dom/element.ts";

/** As large as a scene may be (docs/scenes.md), in bytes; forms have far less. */
const MOST = 4 << 20;

/** Asks for a file; null where none is chosen. */
export function askedFor(accept: string): Promise<File | null> {
  return new Promise((done) => {
    const input = element("input", { type: "file", accept, hidden: true });
    input.onchange = () => done(input.files?.[0] ?? null);
    input.oncancel = () => done(null);
    document.body.append(input);
    input.click();
    input.remove();
  });
}

/** The text of a file that a spreadsheet may have written: UTF-8, UTF-16 or Windows-1252. Null where it is too large. */
export async function textOf(file: File): Promise<string | null> {
  if (file.size > MOST) return null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  return decoded(bytes);
}

function decoded(bytes: Uint8Array): string {
  const marked = bytes[0] === 0xff && bytes[1] === 0xfe ? "utf-16le" : bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : byZeros(bytes);
  if (marked !== null) return new TextDecoder(marked).decode(bytes);
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

/** UTF-16 without a mark: Latin letters and digits leave every other byte zero. */
function byZeros(bytes: Uint8Array): "utf-16le" | "utf-16be" | null {
  const start = bytes.subarray(0, 4096);
  const half = start.length / 2;
  const zeros = (first: number): number => start.filter((byte, at) => at % 2 === first && byte === 0).length;
  if (half > 1 && zeros(1) > half / 2 && zeros(0) === 0) return "utf-16le";
  if (half > 1 && zeros(0) > half / 2 && zeros(1) === 0) return "utf-16be";
  return null;
}
