// The engine's worker: calls in their order, and what happens when it falls, takes too long or is stopped.
import assert from "node:assert/strict";
import test, { mock } from "node:test";
import { hand, PATIENCE, type Why } from "../../web/page/engine/hand.ts";

/** Workers that answer when the test says so. */
class Played {
  static all: Played[] = [];
  static get now(): Played {
    return Played.all.at(-1)!;
  }
  asked: string[] = [];
  isEnded = false;
  onmessage: (event: { data: unknown }) => void = () => undefined;
  onerror: (event: { preventDefault(): void }) => void = () => undefined;
  constructor() {
    Played.all.push(this);
  }
  postMessage(data: { name?: string }): void {
    if (data.name !== undefined) this.asked.push(data.name);
  }
  answer(data: object): void {
    this.onmessage({ data: { took: 1, ...data } });
  }
  terminate(): void {
    this.isEnded = true;
  }
}
Object.assign(globalThis, { Worker: Played, window: globalThis });

function started(): { own: ReturnType<typeof hand>; told: [Why, string][] } {
  const told: [Why, string][] = [];
  const own = hand("", {} as WebAssembly.Module, { busy: () => undefined, restarted: (why, during) => (told.push([why, during]), why) });
  return { own, told };
}

test("calls are answered one after the other", async () => {
  const { own } = started();
  const [first, second, third] = [own.call("open", []), own.call("drop", []), own.call("values", [])];
  assert.deepEqual(Played.now.asked, ["open"]);
  Played.now.answer({ value: "[1]" });
  assert.deepEqual(await first, [1]);
  assert.deepEqual(Played.now.asked, ["open", "drop"]);
  Played.now.answer({ value: "as it is" });
  assert.equal(await second, "as it is");
  Played.now.answer({ value: "2" });
  assert.equal(await third, 2);
  assert.deepEqual(Played.now.asked, ["open", "drop", "values"]);
});

test("a refusal is one, and the next call goes on", async () => {
  const { own } = started();
  const [first, second] = [own.call("open", []), own.call("open", [])];
  Played.now.answer({ refused: '{"message":"no"}' });
  await assert.rejects(first, { message: "no" });
  Played.now.answer({ value: "2" });
  assert.equal(await second, 2);
});

test("when it falls, the call that was under way alone is lost", async () => {
  const { own, told } = started();
  const worker = Played.now;
  const [first, second] = [own.call("check", []), own.call("values", [])];
  worker.onerror({ preventDefault: () => undefined });
  await assert.rejects(first, { message: "fell" });
  assert.ok(worker.isEnded && Played.now !== worker);
  Played.now.answer({ value: "3" });
  assert.equal(await second, 3);
  assert.deepEqual(told, [["fell", "check"]]);
});

test("what takes too long is ended", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { own, told } = started();
  const first = own.call("modes", []);
  mock.timers.tick(PATIENCE - 1);
  assert.deepEqual(told, []);
  mock.timers.tick(1);
  mock.timers.reset();
  await assert.rejects(first, { message: "too_slow" });
  assert.deepEqual(told, [["too_slow", "modes"]]);
});

test("stopped, it drops what is under way and what waits, and goes on", async () => {
  const { own, told } = started();
  own.stop();
  assert.deepEqual(told, [], "where nothing is under way nothing is stopped");
  const worker = Played.now;
  const all = ["modes", "modes", "values"].map((name) => own.call(name, []));
  own.stop();
  for (const each of all) await assert.rejects(each, { message: "stopped" });
  assert.ok(worker.isEnded);
  const next = own.call("values", []);
  assert.deepEqual(Played.now.asked, ["values"]);
  Played.now.answer({ value: "4" });
  assert.equal(await next, 4);
});
