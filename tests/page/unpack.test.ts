// What the page is packed as comes out of it as it went in.
import assert from "node:assert/strict";
import test from "node:test";
import { base116, bytesOf } from "../../web/page/base116.mjs";

test("bytes of every count come back, the least and the greatest among them", () => {
  for (let count = 0; count < 40; count += 1) {
    for (const byte of [(): number => 0, (): number => 255, (index: number): number => (97 * index * index + 31 * count) % 256]) {
      const bytes = Uint8Array.from({ length: count }, (_, index) => byte(index));
      const text = base116(bytes);
      assert.deepEqual(bytesOf(text), bytes);
      assert.equal(text.length, Math.ceil((7 * count) / 6));
    }
  }
});

test("nothing in it ends an element, is white space or no ASCII", () => {
  const text = base116(Uint8Array.from({ length: 60_000 }, (_, index) => (index * 7919 + (index >> 3)) % 256));
  assert.ok(new Set(text).size > 110, "all letters are used");
  assert.doesNotMatch(text, /[\0\s<&"\\`]|[^\x00-\x7f]/);
});
