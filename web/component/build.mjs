// Makes the component, one file with its engine inside: node build.mjs FOLDER_OF_THE_ENGINE OUTPUT_FOLDER
import { mkdirSync, readFileSync, writeFileSync, mkdtempSync, copyFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { brotliCompressSync } from "node:zlib";
import { build } from "esbuild";
import { xz } from "../xz.mjs";

const here = import.meta.dirname;
const [engine, output] = process.argv.slice(2).map((path) => resolve(path));
const common = { bundle: true, minify: true, write: false, format: "iife", target: "es2022", charset: "utf8", legalComments: "none" };
const text = async (entry, more = {}) => (await build({ ...common, entryPoints: [join(here, entry)], ...more })).outputFiles[0].text;

const made = mkdtempSync(join(tmpdir(), "kinegon-"));
const file = (name, contents) => (writeFileSync(join(made, name), contents), join(made, name));
const glue = { alias: { "kinegon-wasm": join(engine, "kinegon_web.js") }, logOverride: { "empty-import-meta": "silent" } };
const alias = {
  "kinegon-engine.xz": file("engine.xz", xz(readFileSync(join(engine, "kinegon_web_bg.wasm")))),
  "kinegon-worker.txt": file("worker.txt", await text("../page/engine/worker.ts", glue)),
  "kinegon-style.css": file("style.txt", await text("style.css")),
  "kinegon-tree.txt": join(here, "tree.html"),
};
const script = await text("plan.ts", { alias, loader: { ".xz": "binary", ".txt": "text", ".html": "text" } });
rmSync(made, { recursive: true });
mkdirSync(output, { recursive: true });
writeFileSync(join(output, "kinegon-plan.js"), script);
for (const name of ["package.json", "README.md", "kinegon-plan.d.ts"]) copyFileSync(join(here, name), join(output, name));
copyFileSync(join(here, "../../templates/workbench-third-party.txt"), join(output, "THIRD-PARTY.txt"));
for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) copyFileSync(join(here, "../..", name), join(output, name));
console.log(`${join(output, "kinegon-plan.js")}: ${Math.round(script.length / 1000)} kB, by Brotli ${Math.round(brotliCompressSync(script).length / 1000)} kB`);
