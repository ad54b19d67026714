// Makes one file of the page: node bundle.mjs FOLDER_OF_THE_ENGINE OUTPUT.html
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { build } from "esbuild";
import { base85 } from "./page/base85.mjs";
import { sources } from "./sources.mjs";
import { xz } from "./xz.mjs";

const here = import.meta.dirname;
const [engine, output] = process.argv.slice(2).map((path) => resolve(path));

/** Where the page stands in the web, once that is stated; links of a page that was opened from a file lead there. */
const home = /^homepage = "(.*)"$/m.exec(readFileSync(join(here, "../Cargo.toml"), "utf8"))?.[1];
const hosted = home === undefined ? "" : new URL("workbench.html", home).href;

/** A bundle of TypeScript or CSS as text. */
async function bundled(entry) {
  const made = await build({
    entryPoints: [join(here, "page", entry)],
    define: { HOSTED: JSON.stringify(hosted) },
    alias: { "kinegon-wasm": join(engine, "kinegon_web.js") },
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    logOverride: { "empty-import-meta": "silent" },
  });
  return made.outputFiles[0].text;
}

/** A text or bytes, packed. */
const packed = (contents) => base85(xz(contents));

const [boot, script, worker, style] = await Promise.all(["boot.ts", "main.ts", "engine/worker.ts", "style.css"].map(bundled));
if (/<\/script|<!--/i.test(boot)) throw new Error("the script would end its element");
const policy = [
  "default-src 'none'",
  `script-src 'sha256-${createHash("sha256").update(boot).digest("base64")}' 'wasm-unsafe-eval' blob:`,
  "worker-src blob:",
  "style-src 'unsafe-inline'",
  "img-src data: blob:",
  "font-src data: blob:",
  "frame-src blob:",
  "connect-src 'none'",
  "form-action 'none'",
  "base-uri 'none'",
].join("; ");
const contents = {
  policy,
  sources: sources(),
  boot,
  style: packed(style),
  script: packed(script),
  worker: packed(worker),
  engine: packed(readFileSync(join(engine, "kinegon_web_bg.wasm"))),
};
/** What the page consists of, as README.md says: a test holds the page to it. */
contents.contents = createHash("sha256").update(["style", "script", "worker", "engine", "boot"].map((name) => contents[name]).join("\n")).digest("hex");
const filled = (_, name) => {
  if (!(name in contents)) throw new Error(`index.html asks for ${name}`);
  return contents[name];
};
// Attributes without a value as a browser gives them back: the page saves itself (page/panels/save/original.ts).
const bare = / (checked|disabled|hidden|popover|selected)(?=[ >])/g;
const template = readFileSync(join(here, "page/index.html"), "utf8").replace(bare, ' $1=""');
const page = template.replace(/\{\{(\w+)\}\}/g, filled);
writeFileSync(output, page);
const kB = (text) => `${Math.round(Buffer.byteLength(text) / 1000)} kB`;
console.log(`${output}: ${kB(page)}, of it engine ${kB(contents.engine)}, script ${kB(contents.script)}, style ${kB(contents.style)}`);
