// The hash of all that the workbench is made of: node sources.mjs prints it. README.md says of what.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const root = join(import.meta.dirname, "..");
const sha256 = (data) => createHash("sha256").update(data).digest("hex");

/** What is left out of the folders. */
const LEFT_OUT = new Set(["web/node_modules", "web/component", "src/cli", "src/main.rs", "templates/workbench.html"]);

/** The paths of all files of a folder, from the repository's root. */
function files(folder) {
  const entries = readdirSync(join(root, folder), { withFileTypes: true });
  return entries.flatMap((entry) => {
    const path = `${folder}/${entry.name}`;
    if (LEFT_OUT.has(path)) return [];
    return entry.isDirectory() ? files(path) : [path];
  });
}

/** The hash. */
export function sources() {
  const paths = ["Cargo.lock", "Cargo.toml", ...["examples", "src", "templates", "web"].flatMap(files)];
  const kept = paths.filter((path) => !path.startsWith("examples/") || path.endsWith(".json"));
  const lines = kept.sort().map((path) => `${sha256(readFileSync(join(root, path)))}  ${path}\n`);
  return sha256(lines.join(""));
}

if (process.argv[1] === import.meta.filename) console.log(sources());
