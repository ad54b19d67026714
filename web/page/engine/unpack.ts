import { XzReadableStream } from "xz-decompress";
import { packedBytes } from "../unpack.ts";

/** The engine, as the page has it: packed by xz, which is three tenths smaller than what browsers unpack by themselves. */
export function engineFile(): Response {
  const stream = new XzReadableStream(new Blob([packedBytes("engine")]).stream());
  return new Response(stream, { headers: { "Content-Type": "application/wasm" } });
}
