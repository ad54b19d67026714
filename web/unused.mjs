// Takes out of the compiled engine what the bundled letters never need: node unused.mjs FROM.wasm TO.wasm
//
// The crates that read letters and write PDF know every kind of font. Ours are two faces of OpenType with outlines of PostScript, without variations, hints, colours or
// pictures, and no compiler can know that: the code for all of these is an eighth of the engine. Functions of these parts of the crates are made traps here, by the names that the
// compiler gives; what only they call, `wasm-opt` then takes out. A test draws and writes all kinds of files in the browser, so that none of them is needed.
import { readFileSync, writeFileSync } from "node:fs";

/** Parts of crates by their paths, and functions of them that are called to see that a font has none of it. */
const UNUSED = [
  { path: ["skrifa", "outline", "autohint"], but: [] },
  { path: ["skrifa", "outline", "glyf"], but: ["new"] },
  { path: ["skrifa", "outline", "hint"], but: [] },
  { path: ["skrifa", "outline", "cff", "hint"], but: ["new"] },
  { path: ["skrifa", "outline", "varc"], but: ["new"] },
  { path: ["skrifa", "color"], but: ["new", "get", "get_with_format"] },
  { path: ["write_fonts"], but: [] },
  { path: ["subsetter", "interjector", "skrifa"], but: [] },
  { path: ["subsetter", "glyf"], but: [] },
  { path: ["krilla", "text", "glyph", "colr"], but: [] },
  { path: ["krilla", "text", "type3"], but: ["new"] },
];

/** The beginning of a function's own name in a part of a crate, as older and newer mangling writes it; also that of a method of a type there. */
function patterns({ path, but }) {
  const counted = path.map((part) => `${part.length}${part}`);
  const plain = `^_ZN${counted.join("")}`;
  const method = `^_ZN\\d+_\\$LT\\$(?:impl\\$u20\\$)?${path.join("\\.\\.")}\\.\\.`;
  const newer = `^_RN(?:v|I?Nv)[A-Za-z]*Cs[0-9A-Za-z]+_${counted.join("(?:s[0-9A-Za-z]*_)?")}`;
  const stays = [...but, "drop", "clone", "default"].map((name) => `${name.length}${name}17h[0-9a-f]{16}E$`);
  return { goes: new RegExp(`${plain}|${method}|${newer}`), stays: new RegExp(stays.join("|")) };
}

/** A number as WebAssembly writes it, and where what follows begins. */
function numberAt(bytes, at) {
  let [number, shift, next] = [0, 1, at];
  for (;;) {
    const byte = bytes[next];
    next += 1;
    number += (byte & 127) * shift;
    if (byte < 128) return [number, next];
    shift *= 128;
  }
}

function written(number) {
  const bytes = [];
  for (let rest = number; ; rest = Math.floor(rest / 128)) {
    if (rest < 128) return [...bytes, rest];
    bytes.push((rest % 128) + 128);
  }
}

const textAt = (bytes, at) => {
  const [length, start] = numberAt(bytes, at);
  return [new TextDecoder().decode(bytes.subarray(start, start + length)), start + length];
};

/** The sections: their numbers, and where their contents begin and end. */
function sections(bytes) {
  const all = [];
  for (let at = 8; at < bytes.length; ) {
    const [length, start] = numberAt(bytes, at + 1);
    all.push({ kind: bytes[at], begin: at, start, end: start + length });
    at = start + length;
  }
  return all;
}

/** How many functions are imported: those have the first numbers. */
function imported(bytes, section) {
  if (section === undefined) return 0;
  let [count, at] = numberAt(bytes, section.start);
  let functions = 0;
  for (; count > 0; count -= 1) {
    at = textAt(bytes, textAt(bytes, at)[1])[1];
    if (bytes[at] !== 0) throw new Error("the engine imports functions alone");
    functions += 1;
    at = numberAt(bytes, at + 1)[1];
  }
  return functions;
}

/** The names of functions by their numbers. */
function names(bytes, all) {
  const found = new Map();
  for (const { kind, start, end } of all) {
    if (kind !== 0) continue;
    let [name, at] = textAt(bytes, start);
    while (name === "name" && at < end) {
      const [length, inner] = numberAt(bytes, at + 1);
      if (bytes[at] === 1) {
        let [count, next] = numberAt(bytes, inner);
        for (; count > 0; count -= 1) {
          const [index, place] = numberAt(bytes, next);
          const [text, after] = textAt(bytes, place);
          found.set(index, text);
          next = after;
        }
      }
      at = inner + length;
    }
  }
  return found;
}

/** A function that is never called: no variables, a trap. */
const TRAP = [3, 0, 0x00, 0x0b];

const [from, to] = process.argv.slice(2);
const bytes = readFileSync(from);
const all = sections(bytes);
const called = names(bytes, all);
const code = all.find(({ kind }) => kind === 10);
const rules = UNUSED.map(patterns);
let [count, at] = numberAt(bytes, code.start);
const bodies = [Buffer.from(written(count))];
let index = imported(bytes, all.find(({ kind }) => kind === 2));
let [gone, saved] = [0, 0];
for (; count > 0; count -= 1) {
  const [length, start] = numberAt(bytes, at);
  const name = called.get(index) ?? "";
  const isUnused = rules.some(({ goes, stays }) => goes.test(name) && !stays.test(name));
  bodies.push(isUnused ? Buffer.from(TRAP) : bytes.subarray(at, start + length));
  if (isUnused) [gone, saved] = [gone + 1, saved + length];
  at = start + length;
  index += 1;
}
if (gone === 0) throw new Error("no function is called as unused.mjs expects");
const contents = Buffer.concat(bodies);
writeFileSync(to, Buffer.concat([bytes.subarray(0, code.begin), Buffer.from([10, ...written(contents.length)]), contents, bytes.subarray(code.end)]));
console.log(`${gone} functions of ${Math.round(saved / 1000)} kB are not needed`);
