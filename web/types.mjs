// The page's types from the schema of the engine's: node types.mjs writes page/engine/types.ts, with --check it compares.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { compile } from "json-schema-to-typescript";

const here = import.meta.dirname;
const [schema, output] = ["engine/schema.json", "page/engine/types.ts"].map((path) => join(here, path));
/** What says nothing of a value holds any; the tool would take it for an object. */
const read = (key, value) =>
  value?.description !== undefined && Object.keys(value).every((word) => ["description", "default"].includes(word))
    ? { ...value, tsType: "unknown" }
    : value;
const { sheets, ...engine } = JSON.parse(readFileSync(schema, "utf8"), read);
const types = await compile(engine, "Engine", {
  additionalProperties: false,
  bannerComment: "// What goes into the engine and comes out of it. Made from engine/schema.json by types.mjs: web/README.md says how.\n",
  unreachableDefinitions: true,
  style: { printWidth: 120 },
});
// The root of the schema says nothing.
const text = types
  .replace(/export interface Engine \{[^}]*\}\n/, "")
  .replace(/\n?\/\*\*\n \* This interface was referenced by `Engine`'s JSON-Schema\n \* via the `definition` "\w+"\.\n \*\//g, "")
  .replace(/\n \*\n \* This interface was referenced by `Engine`'s JSON-Schema\n \* via the `definition` "\w+"\./g, "");
/** What is known of sheets is a value, not a type. */
const written = `${text}\n/**\n * The sheets in the order in which they are drawn: their words, the keys of their scales, the letters of their vectors.\n */\nexport const SHEETS = ${JSON.stringify(sheets, null, 2)} as const;\n`;
if (!process.argv.includes("--check")) {
  writeFileSync(output, written);
} else if (readFileSync(output, "utf8") !== written) {
  throw new Error("page/engine/types.ts is not that of engine/schema.json: web/build --types");
}
