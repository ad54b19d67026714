/** Mouse, pen and fingers on the stage. */
import type { App } from "../app.ts";
import { fingers } from "../look/fingers.ts";
import { clicked, isChosen, only, pointsOfChosen, reveal, tapped, toggled, went } from "./acting.ts";
import { NOTHING, type Held, type Model } from "./model.ts";
import type { Pixels, Place } from "./sight.ts";
import { DRAWN, type Press } from "./tools.ts";

/** How near something must be, in pixels, and how far a press may wander that is still a click. */
const REACH = { mouse: 10, finger: 22 };
const STILL = { mouse: 4, finger: 10 };
/** How long a finger rests for the menu, in ms. */
const LONG = 550;

/** What goes on between pressing and letting go. */
interface Pressed {
  start: Pixels;
  press: Press;
  finger: boolean;
  shift: boolean;
  hasMoved: boolean;
  held: Held | null;
  /** Whether the ground is moved. */
  pans: boolean;
}

/** What the stage shows of it. */
export interface Hands {
  /** Where the pointer is; null away from the stage. */
  at(): Pixels | null;
  /** What a tool goes from, and where it has come to; null where none is under way. */
  line(): { from: Press; to: Press } | null;
  /** A frame that is drawn around what is to be chosen. */
  frame(): [Pixels, Pixels] | null;
  /** Puts back what goes on; whether something did. */
  cancel(): boolean;
}

export function hands(app: App, model: Model, stage: SVGSVGElement, menu: (press: Press, at: Pixels) => void, draw: () => void): Hands {
  const { sight } = model;
  const down = fingers(stage, sight);
  let now: Pressed | null = null;
  let at: Pixels | null = null;
  let clock = 0;

  const reachOf = (event: PointerEvent | MouseEvent): number => ("pointerType" in event && event.pointerType === "touch" ? REACH.finger : REACH.mouse);
  const pressAt = (pixels: Pixels, reach: number): Press => model.press(sight.toScene(pixels), reach);

  function cancel(): boolean {
    clearTimeout(clock);
    const was = now;
    now = null;
    was?.held?.cancel();
    draw();
    return was !== null;
  }

  stage.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    stage.focus({ preventScroll: true });
    const pixels = down.at(event);
    at = pixels;
    if (event.button === 2) return;
    if (down.press(event) > 1) return void cancel();
    const finger = event.pointerType === "touch";
    const press = pressAt(pixels, reachOf(event));
    const isGround = press.point === null && press.link === null && press.load === undefined;
    const pans = event.button === 1 || (model.tool.value === "select" && isGround && !event.shiftKey);
    now = { start: pixels, press, finger, shift: event.shiftKey, hasMoved: false, held: null, pans };
    if (finger) clock = window.setTimeout(() => cancel() && menu(press, pixels), LONG);
    draw();
  });

  stage.addEventListener("pointermove", (event) => {
    const pixels = down.at(event);
    const before = down.move(event);
    at = pixels;
    if (now === null) return draw();
    const way = Math.hypot(pixels[0] - now.start[0], pixels[1] - now.start[1]);
    if (!now.hasMoved && way > (now.finger ? STILL.finger : STILL.mouse)) moved(now);
    if (now.hasMoved) follow(now, before ?? now.start, pixels);
    draw();
  });

  /** The press has become a drag. */
  function moved(pressed: Pressed): void {
    clearTimeout(clock);
    pressed.hasMoved = true;
    const { press } = pressed;
    if (press.load !== undefined && !pressed.pans && model.scaling.value === null) {
      pressed.held = model.holdLoad(press.load);
      return;
    }
    if (pressed.pans || model.tool.value !== "select" || model.scaling.value !== null || pressed.shift) return;
    if (!isChosen(model.chosen.value, press)) model.chosen.set(only(press));
    pressed.held = model.hold(pointsOfChosen(model));
  }

  function follow(pressed: Pressed, before: Pixels, pixels: Pixels): void {
    if (pressed.pans) return sight.pan(pixels[0] - before[0], pixels[1] - before[1]);
    pressed.held?.move(wayOf(pressed, pixels));
  }

  /** How far what is held goes: a joint that is held comes to lie on the grid. */
  function wayOf({ press, start }: Pressed, pixels: Pixels): Place {
    const [from, to] = [sight.toScene(start), sight.toScene(pixels)];
    const origin = press.point === null ? sight.rounded(from, model.snaps.value) : press.at;
    const off = [0, 1].map((axis) => origin[axis]! + to[axis]! - from[axis]!) as Place;
    const goal = sight.rounded(off, model.snaps.value);
    return [goal[0] - origin[0], goal[1] - origin[1]];
  }

  stage.addEventListener("pointerup", (event) => {
    down.lift(event);
    clearTimeout(clock);
    const was = now;
    now = null;
    if (was === null) return draw();
    const [pixels, reach] = [down.at(event), reachOf(event)];
    void model.inTurn(() => ended(was, pixels, reach)).then(draw);
    draw();
  });

  async function ended(was: Pressed, pixels: Pixels, reach: number): Promise<void> {
    if (was.held !== null) return was.held.drop();
    if (was.pans && was.hasMoved) return;
    await model.fresh();
    const press = pressAt(was.start, reach);
    if (model.scaling.value !== null) return clicked(app, model, pressAt(pixels, reach));
    if (!was.hasMoved) {
      if (was.shift && model.tool.value === "select") return model.chosen.set(toggled(model.chosen.value, press));
      return tapped(app, model, press);
    }
    if (DRAWN.includes(model.tool.value)) return went(app, model, press, pressAt(pixels, reach));
    if (model.tool.value === "select" && was.shift) return chooseIn(was.start, pixels);
  }

  /** Chooses the points in a frame. */
  function chooseIn(from: Pixels, to: Pixels): void {
    const [a, b] = [sight.toScene(from), sight.toScene(to)];
    const isIn = (place: Place): boolean => [0, 1].every((axis) => place[axis]! >= Math.min(a[axis]!, b[axis]!) && place[axis]! <= Math.max(a[axis]!, b[axis]!));
    const points = [...(model.present()?.places ?? [])].filter(([, place]) => isIn(place)).map(([name]) => name);
    model.chosen.set({ ...NOTHING, points: new Set(points) });
  }

  stage.addEventListener("pointercancel", (event) => {
    down.lift(event);
    cancel();
  });
  stage.addEventListener("pointerleave", () => {
    if (now === null) at = null;
    draw();
  });
  stage.addEventListener("dblclick", (event) => {
    if (model.tool.value === "select") reveal(app, pressAt(down.at(event), REACH.mouse), true);
  });
  stage.addEventListener("contextmenu", (event) => {
    event.preventDefault();
    // A finger that rests opens it by itself.
    if ("pointerType" in event && event.pointerType === "touch") return;
    const pixels = down.at(event);
    cancel();
    menu(pressAt(pixels, REACH.mouse), pixels);
  });
  return {
    at: () => at,
    frame: () => (now !== null && now.hasMoved && now.shift && now.held === null && at !== null && model.tool.value === "select" ? [now.start, at] : null),
    line() {
      if (at === null) return null;
      const isDrawn = now !== null && now.hasMoved && !now.pans && DRAWN.includes(model.tool.value) && model.scaling.value === null;
      const from = isDrawn ? now!.press : now === null ? model.begun.value : null;
      return from === null ? null : { from, to: pressAt(at, now?.finger === true ? REACH.finger : REACH.mouse) };
    },
    cancel,
  };
}
