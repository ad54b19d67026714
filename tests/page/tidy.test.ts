// Nothing is in the page that nothing uses: what one file offers another takes, and what a style names is there.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import test from "node:test";

const PAGE = "page";
const names = (readdirSync(PAGE, { recursive: true }) as string[]).filter((name) => !name.endsWith("engine/types.ts"));
const texts = (ending: RegExp): [string, string][] => names.filter((name) => ending.test(name)).map((name) => [name, readFileSync(`${PAGE}/${name}`, "utf8")]);

test("what is exported is imported", () => {
  const scripts = texts(/\.ts$/);
  const imported = new Set(scripts.flatMap(([, text]) => [...text.matchAll(/^import ([^;]*?) from/gms)].flatMap(([, what]) => what!.match(/\w+/g) ?? [])));
  const others = ["../tests/page", "component"].flatMap((folder) => readdirSync(folder).filter((name) => name.endsWith(".ts")).map((name) => `${folder}/${name}`));
  const tested = others.map((path) => readFileSync(path, "utf8")).join("\n");
  // Types that a file's functions speak of may be named by nobody else.
  const offered = scripts.flatMap(([name, text]) => [...text.matchAll(/^export (?:async )?(?:function|const|let|class) (\w+)/gm)].map(([, what]) => [name, what!] as const));
  assert.ok(offered.length > 200);
  assert.deepEqual(offered.filter(([, what]) => !imported.has(what) && !new RegExp(`\\b${what}\\b`).test(tested)), []);
});

test("what a style names is in the page", () => {
  const words = texts(/\.(ts|html)$/).map(([, text]) => text).join("\n");
  // Panels and kinds of fields have their names put together.
  const isThere = (name: string): boolean => new RegExp(`(?<![\\w-])${name.replace(/^(panel|for)-/, "")}(?![\\w-])`).test(words);
  for (const [file, style] of texts(/\.css$/)) {
    const selectors = [...style.replace(/\/\*.*?\*\//gs, "").matchAll(/([^{}]+)\{/g)].map(([, selector]) => selector!.replace(/\[[^\]]*\]/g, ""));
    const named = new Set(selectors.flatMap((selector) => [...selector.matchAll(/[.#]([a-zA-Z_][\w-]*)/g)].map(([, name]) => name!)));
    assert.deepEqual([...named].filter((name) => !isThere(name)), [], file);
  }
});
