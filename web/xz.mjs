import { execFileSync } from "node:child_process";

/** A text or bytes, packed by the program `xz` as small as it can: with a window that holds all of it and no heed to alignment, which WebAssembly has not. */
export function xz(contents) {
  const input = Buffer.from(contents);
  const window = 2 ** Math.max(12, Math.ceil(Math.log2(input.length)));
  const options = ["--stdout", "--threads=1", "--check=crc32", `--lzma2=preset=9e,lc=4,lp=0,pb=0,nice=273,dict=${window}`];
  return execFileSync("xz", options, { input, maxBuffer: 1 << 26 });
}
