/** Keys on the sheets: letters choose tools, N goes from one possible thing to the next, arrows move a cross, Enter is a press. */
import type { App } from "../app.ts";
import { called, type Sheet } from "../sheets.ts";
import { askWhich, meantBy, snaps } from "./hands.ts";
import type { Model } from "./model.ts";
import type { Place, Stage } from "./stage.ts";
import { howOf, KEY_OF, lacking, TOOLS, turned } from "./tools.ts";
import type { Snapped } from "../engine/types.ts";
import { say } from "./words.ts";

/** Steps of the arrows, in mm: by themselves, and with Shift. */
const [STEP, FINE] = [1, 0.1];
/** How near a thing must be to the cross, in mm. */
const NEAR = 1.5;
/** Everything on a sheet is so near, in mm. */
const ALL = 1e4;

const WAYS: Record<string, Place> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Points that lie apart: of several at one place, as images of the ground, the first. */
function apart<Found extends { snap: Snapped }>(all: Found[]): Found[] {
  const isSame = (a: Place, b: Place): boolean => Math.hypot(a[0] - b[0], a[1] - b[1]) < 1e-6;
  return all.filter(({ snap }, index) => !all.slice(0, index).some((other) => isSame(other.snap.at, snap.at)));
}

/** `toStrip` goes to what is written next of the entry under way, if it is not pointed at. */
export function keys(app: App, model: Model, stages: readonly Stage[], toStrip: () => void): void {
  /** What N goes through, with the entry for which it was asked. */
  let round: { of: string; all: { stage: Stage; snap: Snapped }[]; at: number } = { of: "", all: [], at: -1 };
  /** The plan on which keys were last. */
  let plan: Sheet | null = null;

  const middle = ({ view }: Stage): Place => view.toSheet([view.size.width / 2, view.size.height / 2]);

  function put(stage: Stage, at: Place): void {
    stage.cursor = at;
    const [x, y] = stage.view.toPane(at);
    const { width, height } = stage.view.size;
    if (x < 0 || y < 0 || x > width || y > height) stage.view.pan(width / 2 - x, height / 2 - y);
    stage.draw();
  }

  /** The sheets in the order in which what comes next is looked for: directions on the scheme, points where the entry is drawn. */
  function inOrder(stage: Stage): Stage[] {
    const takes = lacking(model.tool.value, model.has.value)?.takes;
    const on = takes === "direction" || takes === "scheme" ? "scheme" : (model.has.value["on"] ?? (stage.sheet === "scheme" ? (plan ?? model.drawnOn()) : stage.sheet));
    const there = stages.filter(({ root }) => !root.classList.contains("missing"));
    return [...there.filter(({ sheet }) => sheet === on), ...there.filter(({ sheet }) => sheet !== on)];
  }

  /** Goes on by one; `before` is said first. */
  async function next(stage: Stage, by: number, before = ""): Promise<void> {
    const of = `${JSON.stringify(model.has.value)} ${model.drawing().did.length}`;
    if (round.of !== of) {
      const found = await Promise.all(inOrder(stage).map(async (each) => (await snaps(app, model, each, each.cursor ?? middle(each), ALL)).map((snap) => ({ stage: each, snap }))));
      const isPoint = ["point", "scheme"].includes(lacking(model.tool.value, model.has.value)?.takes ?? "");
      round = { of, all: isPoint ? found.flatMap(apart) : found.flat(), at: by > 0 ? -1 : 0 };
    }
    if (round.all.length === 0) return app.speak([before, say("nothing_here")].filter(Boolean).join(". "));
    round.at = (round.at + by + round.all.length) % round.all.length;
    const { stage: on, snap } = round.all[round.at]!;
    if (on !== stage) {
      stage.aim(null);
      if (model.alone.value !== "" && on.root.hidden) model.alone.set(on.sheet);
      on.over.focus();
    }
    put(on, snap.at);
    on.aim(snap);
    app.speak([before, on === stage ? snap.words : `${called(on.sheet, "short")}: ${snap.words}`].filter(Boolean).join(". "));
  }

  /** Goes on to what comes next of the entry: it is written, or pointed at. */
  function goOn(stage: Stage, before: string): Promise<void> | undefined {
    toStrip();
    if (document.activeElement === stage.over) return next(stage, 1, before);
    app.speak(before);
    return undefined;
  }

  async function press(stage: Stage): Promise<void> {
    const { snap: chosen } = round.all[round.at] ?? {};
    const isOn = chosen !== undefined && stage.cursor !== null && chosen.at[0] === stage.cursor[0] && chosen.at[1] === stage.cursor[1];
    const at = stage.cursor ?? middle(stage);
    const all = isOn ? [chosen] : await snaps(app, model, stage, at, NEAR);
    const [snap] = all;
    round = { of: "", all: [], at: -1 };
    stage.aim(null);
    const meant = meantBy(model, all, at, NEAR, stage.view.now.value.scale);
    if (meant.length > 1) {
      askWhich(model, meant);
      app.speak(model.says.value.text);
      return toStrip();
    }
    if (snap === undefined) return app.speak(say("nothing_here"));
    if (!(await model.take(snap))) await goOn(stage, snap.words);
  }

  async function moved(stage: Stage, to: Place): Promise<void> {
    put(stage, to);
    const [snap] = await snaps(app, model, stage, to, NEAR);
    if (stage.cursor?.[0] !== to[0] || stage.cursor[1] !== to[1]) return;
    stage.aim(snap ?? null);
    if (snap !== undefined) app.speak(snap.words);
  }

  /** The square turned by a quarter. */
  function turn(): void {
    const next = turned(model.tool.value, model.has.value);
    if (next === model.has.value) return;
    model.fill(next);
    app.speak(say(howOf(next)));
  }

  function pressed(stage: Stage, event: KeyboardEvent): boolean {
    const { key } = event;
    const way = WAYS[key];
    const tool = TOOLS.find((each) => KEY_OF[each] === key.toLowerCase());
    if (way !== undefined) {
      const step = event.shiftKey ? FINE : STEP;
      const [x, y] = stage.cursor ?? middle(stage);
      const at = [x + way[0] * step, y + way[1] * step].map((mm) => Math.round(mm * 10) / 10) as Place;
      void model.inTurn(() => moved(stage, at));
    } else if (key === "n" || key === "N") void model.inTurn(() => next(stage, event.shiftKey ? -1 : 1));
    else if (key === "Enter" || key === " ") void model.inTurn(() => press(stage));
    else if (key === "t" || key === "T") turn();
    else if (key === "f" || key === "0") stage.view.refit();
    else if (key === "+" || key === "-") stage.view.zoom(key === "+" ? 1.25 : 0.8, stage.cursor === null ? [stage.view.size.width / 2, stage.view.size.height / 2] : stage.view.toPane(stage.cursor));
    else if (key === "Backspace" || key === "Delete") void model.inTurn(model.undo);
    else if (tool !== undefined) {
      model.choose(tool);
      void model.inTurn(() => goOn(stage, say(`tool_${tool}`)));
    } else if (/^[1-9]$/.test(key) && stages[Number(key) - 1] !== undefined) {
      const other = stages[Number(key) - 1]!;
      if (model.alone.value !== "") model.alone.set(other.sheet);
      other.over.focus();
    } else return false;
    return true;
  }

  for (const stage of stages) {
    stage.over.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (!pressed(stage, event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    stage.over.addEventListener("focus", () => {
      if (stage.sheet !== "scheme") plan = stage.sheet;
      if (!stage.over.matches(":focus-visible") || stage.cursor !== null) return;
      stage.cursor = model.known.value?.sheets.find(({ sheet }) => sheet === stage.sheet)?.pole ?? middle(stage);
      stage.draw();
    });
    stage.over.addEventListener("blur", () => {
      stage.aim(null);
    });
  }
}
