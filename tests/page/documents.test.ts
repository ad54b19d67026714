// The document: its history, the links that hold it, what changes it.
import assert from "node:assert/strict";
import test from "node:test";
import { deflateRawSync } from "node:zlib";
import { smallest } from "../../web/page/panels/text/change.ts";
import { calmed } from "../../web/page/dom/piles.ts";
import { edited, endsOf, filed, placed } from "../../web/page/panels/text/ends.ts";
import { hasLongLine, inLines } from "../../web/page/panels/text/lines.ts";
import { baseOf, documentOf, hashOf, type Shared } from "../../web/page/state/address.ts";
import { history } from "../../web/page/state/history.ts";
import { short } from "../../web/page/state/lesson.ts";
import { newest } from "../../web/page/state/newest.ts";
import { owned, signal } from "../../web/page/state/signal.ts";

test("undo and redo go through what was changed", () => {
  const all = history({ text: "0", form: "" });
  for (const text of ["1", "2", "3"]) all.change({ text });
  all.change({ text: "3" });
  assert.equal(all.past().length, 3, "what is the same is no change");
  all.undo();
  all.undo();
  assert.equal(all.now.value.text, "1");
  all.redo();
  assert.equal(all.now.value.text, "2");
  all.change({ form: "f" });
  assert.equal(all.canRedo.value, false);
  all.redo();
  assert.deepEqual(all.now.value, { text: "2", form: "f" });
  for (let count = 0; count < 9; count += 1) all.undo();
  assert.deepEqual(all.now.value, { text: "0", form: "" });
  assert.equal(all.canUndo.value, false);
});

test("a gesture is one entry until it is broken off", () => {
  const all = history({ text: "0", form: "" });
  for (const text of ["1", "2", "3"]) all.change({ text }, "pull");
  all.undo();
  assert.equal(all.now.value.text, "0");
  all.change({ text: "4" }, "pull");
  all.change({ text: "5" }, "other");
  all.undo();
  assert.equal(all.now.value.text, "4");
});

test("a link holds a document, whatever letters it has", async () => {
  const shared: Shared = { text: 'ñ “ ” 𝄞 \u202e </script>\n{"a":1}', form: "f", panel: "check", student: true, view: { step: 3, coarse: true, modes: false } };
  const hash = await hashOf(shared);
  assert.match(hash, /^#1=[\w-]+$/);
  assert.deepEqual(await documentOf(hash), shared);
});

test("what is no document is refused, and what is in it is checked", async () => {
  const packed = (text: string): string => `#1=${deflateRawSync(text).toString("base64url")}`;
  assert.equal(await documentOf("#chapter-3"), null);
  assert.equal(await documentOf(""), null);
  assert.equal(await documentOf("#9=abc"), "newer");
  for (const bad of ["#1=!!!", "#1=", packed("no JSON"), packed("[1]"), packed("null"), packed('{"text":1}'), packed('{"text":"abc"}').slice(0, -6)]) assert.equal(await documentOf(bad), "broken", bad);
  assert.equal(await documentOf(packed(`{"text":"${" ".repeat(6 << 20)}"}`)), "too_large");
  const odd = { text: "t", form: 1, panel: {}, student: "yes", view: { step: -1, coarse: 1, pane: "?" }, task: { name: "x", seed: -1, number: 1 }, more: 1 };
  assert.deepEqual(await documentOf(packed(JSON.stringify(odd))), { text: "t", view: { step: null, coarse: false, modes: false } });
});

test("two texts have two short names", () => {
  assert.equal(short(""), "");
  assert.notEqual(short("ab"), short("ba"));
  assert.equal(short("ab"), short("ab"));
});

test("the smallest change makes the next text", () => {
  for (const [now, next] of [["", "abc"], ["abc", ""], ["aaa", "aa"], ["aXb", "aYb"], ["abab", "abXab"], ["same", "same"]] as const) {
    const { from, to, insert } = smallest(now, next);
    assert.equal(now.slice(0, from) + insert + now.slice(to), next);
    assert.ok(to - from + insert.length <= Math.max(now.length, next.length));
  }
  assert.deepEqual(smallest("aXb", "aYb"), { from: 1, to: 2, insert: "Y" });
});

test("a file keeps the ends of its lines and its mark", () => {
  for (const text of ["a\nb\n", "a\r\nb\r\n", "\uFEFFa\r\nb", "\uFEFFa"]) assert.equal(filed(edited(text), endsOf(text)), text);
  assert.equal(placed("\uFEFFa\r\nb", 4), 2);
});

test("of what waits only the newest is done", async () => {
  const done: number[] = [];
  let go = (): void => undefined;
  const work = newest(async (wanted: number) => {
    done.push(wanted);
    await new Promise<void>((end) => (go = end));
  });
  for (const wanted of [1, 2, 3]) work.want(wanted);
  assert.equal(work.isStale(), true);
  go();
  await new Promise(setImmediate);
  go();
  await new Promise(setImmediate);
  assert.deepEqual(done, [1, 3]);
  assert.equal(work.isIdle(), true);
});

test("what was built by an owner hears nothing when that has ended", () => {
  const heard: string[] = [];
  const value = signal(0);
  const outer = owned(() => {
    value.on((now) => heard.push(`outer ${now}`));
    return owned(() => value.on((now) => heard.push(`inner ${now}`)));
  });
  value.set(0);
  value.set(1);
  outer.made.end();
  value.set(2);
  outer.end();
  value.set(3);
  assert.deepEqual(heard, ["outer 0", "inner 0", "outer 1", "inner 1", "outer 2"]);
});

test("what no browser can lay out is not shown", () => {
  const pile = "a" + "\u0301".repeat(60_000) + "b";
  assert.equal([...calmed(pile)].length, 1 + 30 + 1 + 1);
  for (const text of ["ñandú", "각", "n\u0303a", "\u0915\u094d\u0937\u093f", ""]) assert.equal(calmed(text), text);
});

test("a text on one line is laid out, and no sign of it is lost", () => {
  const scene = '{"kinegon":1,"title":"a, {b} \\"c\\" : [","ground":{"A":[0,0]},"links":{"1":{"points":["A","B"],"lengths":{"AB":30.50}},"2":["B","C"]},"near":{},"want":[]}';
  const laid = inLines(scene);
  assert.deepEqual(JSON.parse(laid), JSON.parse(scene));
  const bare = (text: string): string => text.replace(/"(?:[^"\\]|\\.)*"|\s/g, (piece) => piece.trim());
  for (const text of [scene, scene.slice(0, 90), '{"a": "x', "}}]] 1,", ""]) assert.equal(bare(inLines(text)), bare(text));
  assert.equal(inLines(laid), laid);
  assert.ok(laid.includes('\n    "1": { "points": ["A", "B"], "lengths": { "AB": 30.50 } },\n'), "a link has its line");
  const links = Object.fromEntries([...Array(999).keys()].map((k) => [k, { points: [`A${k}`, `B${k}`], lengths: { AB: 1 } }]));
  const long = JSON.stringify({ links });
  assert.ok(hasLongLine(long) && !hasLongLine(inLines(long)));
  assert.ok(!hasLongLine(JSON.stringify({ title: "W".repeat(60_000) })), "what cannot be broken is shown");
});

test("links of a page from a file lead to the page in the web, once its place is known", () => {
  const [file, web] = ["file:///home/ana/kinegon.html#1=x", "https://kinegon.example/workbench.html"];
  assert.equal(baseOf(file, web), web);
  assert.equal(baseOf(file, ""), "file:///home/ana/kinegon.html");
  assert.equal(baseOf("https://school.example/lesson.html#1=x", web), "https://school.example/lesson.html");
});
