// Makes one file of the page: node bundle.mjs FOLDER_OF_WASM OUTPUT.html [HASH OF THE SOURCES]
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const here = import.meta.dirname;
const [wasm, output, sources = ""] = process.argv.slice(2);

/** A bundle of TypeScript or CSS as text. */
async function bundled(entry) {
  const made = await build({
    entryPoints: [join(here, "page", entry)],
    alias: { "kinegon-wasm": join(wasm, "kinegon_web.js") },
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

const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");
const [script, worker, style] = await Promise.all(["main.ts", "engine/worker.ts", "style.css"].map(bundled));
if (/<\/script|<!--/i.test(script)) throw new Error("the script would end its element");
const font = (name) => readFileSync(join(here, "../src/drawing/fonts", name)).toString("base64");
const policy = [
  "default-src 'none'",
  `script-src 'sha256-${createHash("sha256").update(script).digest("base64")}' 'wasm-unsafe-eval' blob:`,
  "worker-src blob:",
  "style-src 'unsafe-inline'",
  "img-src data: blob:",
  "font-src data: blob:",
  "connect-src 'none'",
  "form-action 'none'",
  "base-uri 'none'",
].join("; ");
const contents = {
  policy,
  sources,
  style,
  script,
  worker: packed(worker),
  engine: packed(readFileSync(join(wasm, "kinegon_web_bg.wasm"))),
  fonts: "",
};
const page = readFileSync(join(here, "page/index.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => contents[name]);
writeFileSync(output, page);
console.log(`${output}: ${page.length} bytes`);
