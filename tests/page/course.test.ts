// A course's management system, sound or faulty in every way.
import assert from "node:assert/strict";
import test from "node:test";
import { Scorm12API } from "../../web/node_modules/scorm-again/dist/esm/scorm12.js";
import { course, type Course } from "../../web/page/state/course.ts";
import { packed, unpacked } from "../../web/page/state/suspended.ts";

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

const EMPTY = JSON.stringify({ kinegon_measured: 1, name: "", exercise: "four-bar-7-1", values: { "vplan(p,b)": "", "vplan(π,c)": "", "omega(2)": "" } });

/** The form with these values, and more of it. */
function form(values: object, more: object = {}): string {
  const empty = JSON.parse(EMPTY) as { values: object };
  return JSON.stringify({ ...empty, ...more, values: { ...empty.values, ...values } });
}

/** A check that finds so many marks; all boxes are filled if it says so, and right if all marks are earned. */
const found = (earned: number, of: number, isFull: boolean): Parameters<Course["report"]>[0] => ({ earned, of, isFull, isRight: isFull && earned === of });

test("without a course there is none", () => {
  for (const none of [undefined, null, "API", 7, {}, { get: () => 1 }]) {
    within(none);
    assert.equal(course(EMPTY), null);
  }
});

test("a sound one hears the best score", () => {
  for (const how of ["frame", "opener"] as const) {
    const { api, values, heard } = system();
    within(api, how);
    const own = course(EMPTY)!;
    own.report(found(3, 4, false));
    assert.equal(values["cmi.core.lesson_status"], "incomplete");
    own.report(found(1, 4, true));
    assert.equal(values["cmi.core.score.raw"], "75");
    assert.equal(values["cmi.core.lesson_status"], "incomplete", "full, and much of it wrong");
    own.report(found(4, 4, true));
    assert.equal(values["cmi.core.lesson_status"], "completed");
    assert.equal(own.isDeaf.value, false);
    leave();
    assert.deepEqual(heard.filter((what) => what === "initialize").length, 1);
    assert.equal(heard.at(-1), "finish");
  }
});

test("what an earlier visit earned stays", () => {
  const { api, values } = system();
  values["cmi.core.score.raw"] = "90";
  within(api);
  course(EMPTY)!.report(found(1, 2, false));
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
    const own = course(EMPTY)!;
    own.report(found(1, 2, false));
    own.again();
    assert.equal(own.isDeaf.value, true, what);
    leave();
  }
});

test("what is not needed may be missing", () => {
  for (const faults of [{ LMSInitialize: undefined }, { LMSInitialize: () => "false" }, { LMSGetValue: throws }, { LMSGetValue: () => "NaN" }, { LMSFinish: throws }]) {
    const { api, values } = system(faults);
    within(api);
    const own = course(EMPTY)!;
    own.report(found(1, 2, false));
    assert.equal(own.isDeaf.value, false);
    assert.equal(values["cmi.core.score.raw"], "50");
    leave();
  }
});

test("marks that were not taken are sent when it is there again", () => {
  const { api, values } = system();
  const outer = within(api);
  const own = course(EMPTY)!;
  outer.API = null;
  own.report(found(1, 2, false));
  assert.equal(own.isDeaf.value, true);
  outer.API = api;
  own.again();
  assert.equal(own.isDeaf.value, false);
  assert.equal(values["cmi.core.score.raw"], "50");
  outer.API = undefined;
  own.report(found(1, 1, true));
  outer.API = api;
  leave();
  assert.equal(values["cmi.core.score.raw"], "100", "at the latest when the page is left");
});

/** The memory of scorm-again between sessions; of a call that it refuses the test hears. */
class System {
  kept: object = {};
  values: Record<string, string> = {};

  /** Opens the page in a session of its own, begun by the page around it. */
  session(about: { pass?: string; form?: string } = {}): { own: Course; get: (element: string) => string; end: () => void; write: (form: string) => void; api: Api } {
    const system = new Scorm12API({ autocommit: false, logLevel: 5 });
    system.loadFromJSON({ ...this.kept, ...(about.pass !== undefined && { "student_data.mastery_score": about.pass }) } as never, "");
    const told: Record<string, string> = {};
    const calls = ["LMSInitialize", "LMSFinish", "LMSGetValue", "LMSSetValue", "LMSCommit"] as const;
    const heard = (name: (typeof calls)[number]) => (...given: string[]): unknown => {
      const answer = (system[name] as (...given: string[]) => unknown)(...given);
      assert.equal(String(system.LMSGetLastError()), "0", `${name}(${given.join(", ")})`);
      if (name === "LMSSetValue") told[given[0]!] = given[1]!;
      return answer;
    };
    const api: Api = Object.fromEntries(calls.map((name) => [name, heard(name)]));
    within(api);
    heard("LMSInitialize")("");
    const own = course(EMPTY)!;
    let now = about.form ?? own.form;
    own.follow(() => ({ form: now }));
    // How a session ended and how long it took no system tells.
    const get = (element: string): string => told[`cmi.${element}`] ?? "";
    const end = (): void => {
      leave();
      this.values = Object.fromEntries(["exit", "lesson_status", "score.raw", "session_time"].map((name) => [name, get(`core.${name}`)]));
      const own = (element: string): string => String(system.getCMIValue(`cmi.${element}`));
      this.kept = { suspend_data: own("suspend_data"), core: { lesson_status: own("core.lesson_status"), score: { raw: own("core.score.raw") }, entry: "resume" } };
      heard("LMSFinish")("");
    };
    return { own, get, end, write: (form) => (now = form), api };
  }
}

test("a system that keeps the rules keeps what is written, and refuses nothing", () => {
  const course = new System();
  const written = form({ "vplan(π,c)": "54.3", "omega(2)": { value: "-3.00", unit: "rpm" } }, { name: "Ana Muñoz", in: "mm", points: { velocity: { π: [1.5, -2] } } });
  const first = course.session();
  assert.equal(first.own.form, EMPTY);
  assert.equal(first.get("core.score.raw"), "", "nothing has been checked");
  first.write(written);
  first.own.report(found(1, 4, false));
  first.end();
  assert.match(course.values["session_time"]!, /^\d\d:\d\d:\d\d$/);
  assert.deepEqual([course.values["exit"], course.values["lesson_status"], course.values["score.raw"]], ["suspend", "incomplete", "25"]);
  const second = course.session();
  assert.deepEqual(JSON.parse(second.own.form), JSON.parse(written));
  second.own.report(found(4, 4, true));
  second.end();
  assert.deepEqual([course.values["exit"], course.values["lesson_status"], course.values["score.raw"]], ["", "completed", "100"]);
});

test("a form that is left before it is checked is there again, and earns nothing", () => {
  const course = new System();
  const first = course.session();
  first.write(form({ "vplan(p,b)": "180" }));
  first.end();
  assert.deepEqual([course.values["score.raw"], course.values["lesson_status"]], ["", "incomplete"]);
  assert.equal(JSON.parse(course.session().own.form).values["vplan(p,b)"], "180");
});

test("a page that is loaded again within a session goes on with it", () => {
  const first = new System().session();
  first.write(form({ "omega(2)": "-3" }));
  leave();
  within(first.api);
  const again = course(EMPTY)!;
  assert.equal(JSON.parse(again.form).values["omega(2)"], "-3");
  again.report(found(1, 2, false));
  assert.equal(first.get("core.score.raw"), "50");
  assert.equal(again.isDeaf.value, false);
});

test("marks that must be reached count when all boxes are filled", () => {
  const course = new System();
  const { own, get, end } = course.session({ pass: "60" });
  own.report(found(3, 4, false));
  assert.deepEqual([get("core.score.raw"), get("core.lesson_status")], ["", "incomplete"]);
  own.report(found(2, 13, true));
  assert.deepEqual([get("core.score.raw"), get("core.lesson_status"), get("core.exit")], ["15.4", "failed", "suspend"]);
  own.report(found(9, 13, true));
  own.report(found(1, 13, true));
  assert.deepEqual([get("core.score.raw"), get("core.lesson_status")], ["69.2", "passed"]);
  end();
  assert.equal(course.values["exit"], "");
});

test("what has no room is left out as a whole", () => {
  const names = Array.from({ length: 300 }, (_, index) => `vplan(p,c${index})`);
  const empty = JSON.stringify({ exercise: "x", values: Object.fromEntries(names.map((name) => [name, ""])) });
  const filled = (digits: string, points?: object): string => JSON.stringify({ exercise: "x", values: Object.fromEntries(names.map((name) => [name, digits])), points });
  const back = (kept: string): Record<string, unknown> | null => JSON.parse(unpacked(kept)!.into(empty) ?? "null");
  const places = Object.fromEntries(names.map((name) => [name, [1.25, 2.5]]));
  const whole = packed(50, filled("123.4567"), empty);
  assert.ok(whole.length <= 4096);
  assert.deepEqual(back(whole), JSON.parse(filled("123.4567")));
  const apart = packed(50, filled("123.4567", { velocity: places }), empty);
  assert.deepEqual(back(apart), JSON.parse(filled("123.4567")), "without the points");
  const none = packed(50, filled("123.4567890123"), empty);
  assert.ok(none.length <= 4096);
  assert.equal(unpacked(none)!.best, 50);
  assert.equal(back(none), null);
});

test("a value in mm of paper and one that was not asked for come back as they were", () => {
  const written = JSON.stringify({ exercise: "four-bar-7-1", values: { "vplan(p,b)/mu": "90.1", "vplan(π,c)": "", "omega(2)": "1", "phi(2)": "47" } });
  assert.deepEqual(JSON.parse(unpacked(packed(null, written, EMPTY))!.into(EMPTY)!), JSON.parse(written));
  assert.equal(unpacked(packed(null, written, EMPTY))!.into(EMPTY.replace("7-1", "7-2")), null, "another exercise");
  for (const odd of ["", "[]", "null", "{", '{"v":2}', '{"v":1,"h":7,"x":{}}']) assert.equal(unpacked(odd)?.into(EMPTY) ?? null, null, odd);
});

test("a drawing comes back, and goes first where there is no room", () => {
  const entry = (number: number): object => ({ line: `r${number}`, on: "velocity", through: "b", along: { normal: "2" }, t: 1000 * number });
  const drawing = `${JSON.stringify({ kinegon_drawing: 1, did: Array.from({ length: 40 }, (_, number) => entry(number)) })}\n`;
  const kept = packed(50, form({ "omega(2)": "1" }), EMPTY, drawing);
  assert.ok(kept.length < 4096);
  assert.equal(unpacked(kept)!.drawing, drawing);
  const noise = Array.from({ length: 3000 }, (_, at) => ((at * 7919) % 65521).toString(36)).join("");
  const full = unpacked(packed(50, form({ "omega(2)": "1" }), EMPTY, noise))!;
  assert.equal(full.drawing, "");
  assert.equal(JSON.parse(full.into(EMPTY)!).values["omega(2)"], "1");
  assert.equal(unpacked('{"v":1,"b":null,"d":"?"}')!.drawing, "", "damaged");
});
