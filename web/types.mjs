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
const types = await compile(JSON.parse(readFileSync(schema, "utf8"), read), "Engine", {
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
if (!process.argv.includes("--check")) {
  writeFileSync(output, text);
} else if (readFileSync(output, "utf8") !== text) {
  throw new Error("page/engine/types.ts is not that of engine/schema.json: web/build --types");
}
