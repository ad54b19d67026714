// What the page's engine gives for forms: `node page_marks.mjs ENGINE SCHEME` reads [[scene, form], …] and prints [[earned, of], …].
// ENGINE is the folder with the engine, as `web/build --engine` makes it.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, scheme] = process.argv.slice(2);
const engine = await import(pathToFileURL(`${folder}/kinegon_web.js`));
await engine.default({ module_or_path: readFileSync(`${folder}/kinegon_web_bg.wasm`) });
const own = new engine.Engine();
const options = { marks: scheme, pencil_mm: null, pencil_degrees: null, drawn: false };
const marks = JSON.parse(readFileSync(0, "utf8")).map(([scene, form]) => {
  const { result } = JSON.parse(own.check(scene, form, JSON.stringify(options)));
  return [result.marks.earned, result.marks.of];
});
console.log(JSON.stringify(marks));
