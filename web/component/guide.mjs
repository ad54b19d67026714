// Puts what the guide's scenes live from beside the book: node guide.mjs FOLDER_OF_THE_COMPONENT FOLDER_OF_THE_BOOK
import { copyFileSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";

const root = join(import.meta.dirname, "../..");
const [component, book] = process.argv.slice(2).map((path) => resolve(path));

/** The scenes by the names of their pictures in docs/gallery. */
const kinds = readdirSync(join(root, "templates")).filter((name) => name.endsWith(".json") && !name.endsWith(".schema.json"));
const files = { ...Object.fromEntries(kinds.map((name) => [basename(name, ".json"), `templates/${name}`])), "paper-figure-1": "examples/figure-1.json", "paper-figure-2": "examples/figure-2.json" };
const pictures = new Set(readdirSync(join(root, "docs/gallery")));
const shown = Object.entries(files).filter(([name]) => pictures.has(`${name}.svg`));
const scenes = Object.fromEntries(shown.map(([name, path]) => [name, readFileSync(join(root, path), "utf8")]));
writeFileSync(join(book, "kinegon-scenes.js"), `window.kinegonScenes = ${JSON.stringify(scenes)};\n`);
copyFileSync(join(component, "kinegon-plan.js"), join(book, "kinegon-plan.js"));
console.log(`${shown.length} scenes beside ${book}`);
