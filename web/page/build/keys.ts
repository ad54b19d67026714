/** Keys on the stage: they move a cross in place of a pointer, and everything is done that pointers do. */
import type { App } from "../app.ts";
import { redo, undo } from "../layout/keys.ts";
import { speak } from "../layout/messages.ts";
import { loadNames } from "../panels/mechanism/loads.ts";
import { clicked, copyChosen, isChosen, paste, pointsOfChosen, removeChosen, reveal } from "./acting.ts";
import { crossed, isAt, thingsFor } from "./cross.ts";
import { NOTHING, type Held, type Model } from "./model.ts";
import type { Pixels, Place } from "./sight.ts";
import { DRAWN, KEY_OF, nextChoice, TOOLS, type Press } from "./tools.ts";
import { say } from "./words.ts";

/** Steps with Shift, in one without. */
const FINER = 5;
/** How near a thing must be, in steps: no place is farther from where steps lead. */
const NEAR = 0.71;

export interface BuildKeys {
  cross(): Place;
  /** What is at the cross. */
  words(): string;
  line(): { from: Press; to: Press } | null;
  /** The cross is where something is to be seen. */
  begin(): void;
  cancel(): boolean;
}

/** `putBack` puts back what a pointer holds, and says whether it held something. */
export function buildKeys(app: App, model: Model, stage: SVGSVGElement, menu: (press: Press, at: Pixels) => void, draw: () => void, putBack: () => boolean): BuildKeys {
  const { sight } = model;
  let cross: Place = [0, 0];
  /** What keys carry: taken up by Enter, put down by Enter. */
  let carried: { held: Held; from: Place } | null = null;

  const things = (): Place[] => {
    const there = model.present();
    return there === null ? [] : [...thingsFor(model.tool.value, there.scene, there.places), ...model.handles().map(({ at }) => at)];
  };
  /** What the cross stands at: where it has been put on a thing, that alone; where it went by fine steps, what is within one of them. */
  const pressAt = (place: Place): Press => {
    const { fine } = sight.grid();
    const step = isAt(sight.rounded(place, true), place) ? fine : fine / FINER;
    const found = model.press(place, things().some((thing) => isAt(thing, place)) ? 1e-3 : NEAR * step * sight.now.value.scale);
    return found.point === null ? { ...found, at: place } : found;
  };
  const press = (): Press => pressAt(cross);

  function words(): string {
    const { at, point, link, load } = press();
    if (load !== undefined) return say("at_load", { name: loadNames(model.present()?.scene ?? {})[load.index] ?? "" });
    if (point !== null) return point;
    return link !== null ? say("at_link", { name: link }) : at.map((value) => Number(value.toPrecision(5))).join(", ");
  }

  async function enter(at: Place): Promise<void> {
    await model.fresh();
    const what = pressAt(at);
    if (carried !== null) {
      const { held, from } = carried;
      carried = null;
      if (!isAt(at, from)) held.move([at[0] - from[0], at[1] - from[1]]);
      await held.drop();
      return speak(say("put_down"));
    }
    if (what.load !== undefined && model.scaling.value === null) {
      carried = { held: model.holdLoad(what.load), from: at };
      return speak(say("taken_up"));
    }
    if (model.tool.value !== "select" || model.scaling.value !== null) return clicked(app, model, what);
    if (what.point === null && what.link === null) return model.chosen.set(NOTHING);
    if (!isChosen(model.chosen.value, what)) return clicked(app, model, what);
    carried = { held: model.hold(pointsOfChosen(model)), from: at };
    speak(say("taken_up"));
  }

  function move(to: Place): void {
    cross = to;
    if (!sight.holds(cross)) sight.pan(...(sight.toPane(cross).map((pixel, axis) => (axis === 0 ? sight.size.width : sight.size.height) / 2 - pixel) as Pixels));
    if (carried !== null) carried.held.move([cross[0] - carried.from[0], cross[1] - carried.from[1]]);
    speak(words());
  }

  function cancel(): boolean {
    const was = carried !== null || model.begun.value !== null || model.scaling.value !== null;
    carried?.held.cancel();
    if (carried !== null) cross = carried.from;
    carried = null;
    model.begun.set(null);
    model.scaling.set(null);
    if (!was) model.chosen.set(NOTHING);
    return was;
  }

  const acts: Record<string, () => unknown> = {
    Delete: () => removeChosen(app, model),
    Backspace: () => removeChosen(app, model),
    ContextMenu: () => menu(press(), sight.toPane(cross)),
    n: () => reveal(app, press(), true),
    [KEY_OF.sliding]: () => {
      model.choices.set(nextChoice(model.choices.value, "sliding"));
      speak(say(`slides_${model.choices.value.sliding}`));
    },
    [KEY_OF.guided]: () => {
      model.choices.set(nextChoice(model.choices.value, "guided"));
      speak(say(`guided_${model.choices.value.guided}`));
    },
    g: () => model.snaps.set(!model.snaps.value),
    0: () => model.fit(),
    f: () => model.fit(),
    "+": () => sight.zoom(1.25, sight.toPane(cross)),
    "=": () => sight.zoom(1.25, sight.toPane(cross)),
    "-": () => sight.zoom(0.8, sight.toPane(cross)),
  };
  const withControl: Record<string, (event: KeyboardEvent) => unknown> = {
    c: () => copyChosen(model),
    v: () => paste(model),
    a: () => model.chosen.set({ ...NOTHING, points: new Set(model.present()?.places.keys()) }),
    z: (event) => (event.shiftKey ? redo(app) : undo(app)),
    y: () => redo(app),
  };

  stage.addEventListener("keydown", (event) => {
    const { key } = event;
    if (event.altKey) return;
    const then = (act: () => unknown): void => void model.inTurn(act).then(draw);
    const stop = (): void => {
      event.preventDefault();
      event.stopPropagation();
      draw();
    };
    if (event.ctrlKey || event.metaKey) {
      const act = withControl[key.toLowerCase()];
      if (act === undefined) return;
      then(() => act(event));
      return stop();
    }
    const { fine } = sight.grid();
    const next = crossed(cross, key, event.shiftKey ? fine / FINER : fine, things());
    const tool = TOOLS[Number(key) - 1];
    const act = acts[key === "F10" && event.shiftKey ? "ContextMenu" : key];
    const at = cross;
    if (next !== null) move(next);
    else if (key === "Enter" || key === " ") then(() => enter(at));
    else if (key === "Escape") {
      if (putBack() || cancel()) speak(say("put_back"));
    } else if (tool !== undefined) {
      then(() => {
        cancel();
        model.tool.set(tool);
        speak(say(`tool_${tool}`));
      });
    } else if (act !== undefined) then(act);
    else return;
    stop();
  });
  stage.addEventListener("pointerdown", (event) => {
    const { left, top } = stage.getBoundingClientRect();
    cross = model.press(sight.toScene([event.clientX - left, event.clientY - top]), 10).at;
  });
  const begin = (): void => {
    if (!sight.holds(cross)) cross = sight.rounded(sight.now.value.centre as Place, true);
    draw();
  };
  stage.addEventListener("focus", begin);
  return {
    cross: () => cross,
    words,
    line: () => (model.begun.value !== null && DRAWN.includes(model.tool.value) && stage.matches(":focus-visible") ? { from: model.begun.value, to: press() } : null),
    begin,
    cancel,
  };
}

