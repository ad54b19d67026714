// A course's management system, sound or faulty in every way.
import assert from "node:assert/strict";
import test from "node:test";
import { course } from "../../web/page/state/course.ts";

type Api = Record<string, unknown>;
let leave = (): void => undefined;

/** A window with this interface, in a frame of a course or opened by one. */
function within(API: unknown, how: "frame" | "opener" = "frame"): { API: unknown } {
  const outer = { API } as { API: unknown; parent?: unknown };
  outer.parent = outer;
  const own = { opener: null as unknown, parent: undefined as unknown, addEventListener: (_: string, act: () => void) => (leave = act) };
  own.parent = how === "frame" ? outer : own;
  if (how === "opener") own.opener = outer;
  (globalThis as { window?: unknown }).window = own;
  return outer;
}

function system(faults: Api = {}): { api: Api; values: Record<string, string>; heard: string[] } {
  const values: Record<string, string> = {};
  const heard: string[] = [];
  const said = (name: string, answer: (...given: string[]) => unknown) => (...given: string[]) => (heard.push(name), answer(...given));
  const api: Api = {
    LMSInitialize: said("initialize", () => "true"),
    LMSFinish: said("finish", () => "true"),
    LMSGetValue: said("get", (name) => values[name!] ?? ""),
    LMSSetValue: said("set", (name, value) => ((values[name!] = value!), "true")),
    LMSCommit: said("commit", () => "true"),
    ...faults,
  };
  return { api, values, heard };
}

test("without a course there is none", () => {
  for (const none of [undefined, null, "API", 7, {}, { get: () => 1 }]) {
    within(none);
    assert.equal(course(), null);
  }
});

test("a sound one hears the best score", () => {
  for (const how of ["frame", "opener"] as const) {
    const { api, values, heard } = system();
    within(api, how);
    const own = course()!;
    own.report(3, 4, false);
    own.report(1, 4, true);
    assert.equal(values["cmi.core.score.raw"], "75");
    assert.equal(values["cmi.core.lesson_status"], "completed");
    assert.equal(own.isDeaf.value, false);
    leave();
    assert.equal(heard.at(-1), "finish");
  }
});

test("what an earlier visit earned stays", () => {
  const { api, values } = system();
  values["cmi.core.score.raw"] = "90";
  within(api);
  course()!.report(1, 2, false);
  assert.equal(values["cmi.core.score.raw"], "90");
});

const throws = (): never => {
  throw new Error("out of order");
};

test("a faulty one does no harm, and the student is told", () => {
  const all = (act: unknown): Api => Object.fromEntries(Object.keys(system().api).map((name) => [name, act]));
  const faulty: [string, Api][] = [
    ["all throw", all(throws)],
    ["all answer false", all(() => "false")],
    ["all answer nothing", all(() => undefined)],
    ["all answer objects", all(() => Object.create(null))],
    ["all answer symbols", all(() => Symbol("x"))],
    ["no call is one", all("true")],
    ["it sets nothing", { LMSSetValue: undefined }],
    ["setting is refused", { LMSSetValue: () => "false" }],
    ["keeping is refused", { LMSCommit: () => "false" }],
  ];
  for (const [what, faults] of faulty) {
    within(system(faults).api);
    const own = course()!;
    own.report(1, 2, false);
    own.again();
    assert.equal(own.isDeaf.value, true, what);
    leave();
  }
});

test("what is not needed may be missing", () => {
  for (const faults of [{ LMSInitialize: undefined }, { LMSInitialize: () => "false" }, { LMSGetValue: throws }, { LMSGetValue: () => "NaN" }, { LMSFinish: throws }]) {
    const { api, values } = system(faults);
    within(api);
    const own = course()!;
    own.report(1, 2, false);
    assert.equal(own.isDeaf.value, false);
    assert.equal(values["cmi.core.score.raw"], "50");
    leave();
  }
});

test("marks that were not taken are sent when it is there again", () => {
  const { api, values } = system();
  const outer = within(api);
  const own = course()!;
  outer.API = null;
  own.report(1, 2, false);
  assert.equal(own.isDeaf.value, true);
  outer.API = api;
  own.again();
  assert.equal(own.isDeaf.value, false);
  assert.equal(values["cmi.core.score.raw"], "50");
  outer.API = undefined;
  own.report(1, 1, true);
  outer.API = api;
  leave();
  assert.equal(values["cmi.core.score.raw"], "100", "at the latest when the page is left");
});
