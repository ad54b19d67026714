// What the page is packed as comes out of it as it went in.
import assert from "node:assert/strict";
import test from "node:test";
import { base85, bytesOf } from "../../web/page/base85.mjs";

test("bytes of every count come back, the least and the greatest among them", () => {
  for (let count = 0; count < 40; count += 1) {
    for (const byte of [(): number => 0, (): number => 255, (index: number): number => (97 * index * index + 31 * count) % 256]) {
      const bytes = Uint8Array.from({ length: count }, (_, index) => byte(index));
      const text = base85(bytes);
      assert.deepEqual(bytesOf(text), bytes);
      assert.equal(text.length, Math.ceil((5 * count) / 4));
    }
  }
});

test("nothing in it ends an element, is white space or no ASCII", () => {
  const text = base85(Uint8Array.from({ length: 60_000 }, (_, index) => (index * 7919 + (index >> 3)) % 256));
  assert.ok(new Set(text).size === 85, "all letters are used");
  assert.doesNotMatch(text, /[\s<>&"'\\`{}]|[^\x21-\x7e]/);
});
