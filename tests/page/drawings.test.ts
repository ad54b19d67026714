// A drawing taken apart by its lines, as the page mends it.
import assert from "node:assert/strict";
import test from "node:test";
import { drafts, keyOf, piecesOf, textOf } from "../../web/page/dom/drafts.ts";
import { forDark } from "../../web/page/picture/dark.ts";

test("the tree of the lines is the drawing", () => {
  const markup = '<g id="a">\n<path d="M0 0"/>\n<g stroke="#000000">\n<text x="1">v<tspan>B</tspan></text>\n</g>\n</g>\n<path d="M1 1"/>';
  const tree = drafts(markup)!;
  assert.equal(tree.map(textOf).join("\n"), markup);
  assert.deepEqual(tree.map(keyOf), [' id="a"', "<path"]);
  assert.equal(keyOf(tree[0]!.inner![1]!.inner![0]), "vB", "a text is found by its words");
  assert.equal(keyOf(undefined), "");
});

test("what is no tree is none", () => {
  for (const markup of ["</g>", "<g>", "<g>\n</g>\n</g>"]) assert.equal(drafts(markup), null, markup);
  assert.deepEqual(drafts(""), []);
  assert.equal(drafts('<g id="x"/>')![0]!.inner, null);
});

test("the pieces of a line are its tags and its words", () => {
  const line = '<text x="1">v<tspan dy="2">B</tspan> = 3</text>';
  assert.equal(piecesOf(line).join(""), line);
  assert.equal(piecesOf(line).length, 7);
});

test("a dark screen turns lightness round and keeps the hue", () => {
  const lightness = (svg: string): number => parseInt(/#(..)/.exec(svg)![1]!, 16);
  assert.ok(lightness(forDark('<path fill="#000000"/>')) > 200);
  assert.ok(lightness(forDark('<path fill="#ffffff"/>')) < 50);
  const red = /#(..)(..)(..)/.exec(forDark('<path stroke="#c02020"/>'))!.slice(1).map((part) => parseInt(part, 16)) as [number, number, number];
  assert.ok(red[0] > red[1] && red[1] === red[2]);
  const board = '<rect width="9" fill="#103020"/>\n<path stroke="#ffffff"/>';
  assert.equal(forDark(board), board, "a blackboard is dark already");
});
