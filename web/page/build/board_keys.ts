/** Keys on the board: they move a cross in place of a pointer, and everything is done that pointers do. */
import type { App } from "../app.ts";
import { redo, undo } from "../layout/keys.ts";
import { speak } from "../layout/messages.ts";
import { clicked, copyChosen, isChosen, paste, pointsOfChosen, removeChosen, reveal } from "./acting.ts";
import { crossed, isAt, thingsFor } from "./cross.ts";
import { NOTHING, type Held, type Model } from "./model.ts";
import type { Pixels, Place } from "./sight.ts";
import { DRAWN, TOOLS, type Press } from "./tools.ts";
import { say } from "./words.ts";

export interface BoardKeys {
  cross(): Place;
  /** What is at the cross. */
  words(): string;
  line(): { from: Press; to: Press } | null;
  cancel(): boolean;
}

/** `putBack` puts back what a pointer holds, and says whether it held something. */
export function boardKeys(app: App, model: Model, stage: SVGSVGElement, menu: (press: Press, at: Pixels) => void, draw: () => void, putBack: () => boolean): BoardKeys {
  const { sight } = model;
  let cross: Place = [0, 0];
  /** What keys carry: taken up by Enter, put down by Enter. */
  let carried: { held: Held; from: Place } | null = null;

  const things = (): Place[] => {
    const there = model.present();
    return there === null ? [] : thingsFor(model.tool.value, there.scene, there.places);
  };
  /** Where the cross has been put on a thing, it is that alone. */
  const press = (): Press => model.press(cross, things().some((thing) => isAt(thing, cross)) ? 1e-3 : 0.45 * sight.grid().fine * sight.now.value.scale);

  function words(): string {
    const { at, point, link } = press();
    if (point !== null) return point;
    return link !== null ? say("at_link", { name: link }) : at.join(", ");
  }

  async function enter(): Promise<void> {
    await model.fresh();
    const what = press();
    if (carried !== null) {
      const { held } = carried;
      carried = null;
      await held.drop();
      return speak(say("put_down"));
    }
    if (model.tool.value !== "select" || model.scaling.value !== null) return clicked(app, model, what);
    if (what.point === null && what.link === null) return model.chosen.set(NOTHING);
    if (!isChosen(model.chosen.value, what)) return clicked(app, model, what);
    carried = { held: model.hold(pointsOfChosen(model)), from: cross };
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

  const acts: Record<string, () => void> = {
    Enter: () => void enter().then(draw),
    " ": () => void enter().then(draw),
    Delete: () => void removeChosen(app, model),
    Backspace: () => void removeChosen(app, model),
    Escape: () => {
      if (putBack() || cancel()) speak(say("put_back"));
    },
    ContextMenu: () => menu(press(), sight.toPane(cross)),
    n: () => reveal(app, press(), true),
    g: () => model.snaps.set(!model.snaps.value),
    0: () => model.fit(),
    f: () => model.fit(),
    "+": () => sight.zoom(1.25, sight.toPane(cross)),
    "=": () => sight.zoom(1.25, sight.toPane(cross)),
    "-": () => sight.zoom(0.8, sight.toPane(cross)),
  };
  const withControl: Record<string, (event: KeyboardEvent) => void> = {
    c: () => copyChosen(model),
    v: () => void paste(model),
    a: () => model.chosen.set({ ...NOTHING, points: new Set(model.present()?.places.keys()) }),
    z: (event) => (event.shiftKey ? redo(app) : undo(app)),
    y: () => redo(app),
  };

  stage.addEventListener("keydown", (event) => {
    const { key } = event;
    if (event.altKey) return;
    const stop = (): void => {
      event.preventDefault();
      event.stopPropagation();
      draw();
    };
    if (event.ctrlKey || event.metaKey) {
      const act = withControl[key.toLowerCase()];
      if (act === undefined) return;
      act(event);
      return stop();
    }
    const { fine } = sight.grid();
    const next = crossed(cross, key, event.shiftKey ? fine / 5 : fine, things());
    const tool = TOOLS[Number(key) - 1];
    if (next !== null) move(next);
    else if (key === "F10" && event.shiftKey) menu(press(), sight.toPane(cross));
    else if (tool !== undefined) {
      cancel();
      model.tool.set(tool);
      speak(say(`tool_${tool}`));
    } else if (acts[key] !== undefined) acts[key]();
    else return;
    stop();
  });
  stage.addEventListener("pointerdown", (event) => {
    const { left, top } = stage.getBoundingClientRect();
    cross = model.press(sight.toScene([event.clientX - left, event.clientY - top]), 10).at;
  });
  // Keys begin where something is to be seen.
  stage.addEventListener("focus", () => {
    if (!sight.holds(cross)) cross = sight.rounded(sight.now.value.centre as Place, true);
    draw();
  });
  return {
    cross: () => cross,
    words,
    line: () => (model.begun.value !== null && DRAWN.includes(model.tool.value) && stage.matches(":focus-visible") ? { from: model.begun.value, to: press() } : null),
    cancel,
  };
}

