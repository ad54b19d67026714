/** Mouse, pen and fingers on the sheets: what a press adds is the engine's answer. */
import type { App } from "../app.ts";
import { touch, type Press } from "../look/touch.ts";
import { said } from "../refused.ts";
import { newest } from "../state/newest.ts";
import type { Model } from "./model.ts";
import type { Place, Stage } from "./stage.ts";
import { lacking } from "./tools.ts";
import type { Snapped } from "../engine/types.ts";
import { say } from "./words.ts";

/** How near something must be, in pixels: for a finger, and for a mouse or a pen. */
const REACH = { touch: 22, pen: 10, mouse: 12 };
/** A finger that rests so long, in ms, sees what it touches. */
const HOLD = 280;

/** Directions that differ by less, in degrees, are one. */
const SAME_DIRECTION = 0.01;

/** Points nearer to each other, in pixels, are not told apart by a hand: it is asked which is meant. */
const CLOSE = 5;

type By = Press["by"];

/** Those that are not apart from the first; of several at the very same place, as images of the ground, one. */
function together(all: readonly Snapped[], near: number): Snapped[] {
  const away = (one: Snapped, other: Snapped): number => Math.hypot(one.at[0] - other.at[0], one.at[1] - other.at[1]);
  return all.filter((one, index) => away(one, all[0]!) < near && all.slice(0, index).every((other) => away(one, other) > 1e-6));
}

/** Directions that a press so near to each of them may have meant: those that lie alike, as parts of a straight link, are one. The sense of a
 * vector is seen before it has a name, and turned by a press. */
function unlike(all: readonly Snapped[], at: Place, near: number): Snapped[] {
  const off = (one: Snapped): number => Math.hypot(one.at[0] - at[0], one.at[1] - at[1]);
  const isAlike = (one: Snapped, other: Snapped): boolean => {
    const between = Math.abs((one.direction ?? 0) - (other.direction ?? 0)) % 180;
    return Math.min(between, 180 - between) < SAME_DIRECTION;
  };
  const there = all.filter((one) => off(one) < off(all[0]!) + near);
  return there.filter((one, index) => there.slice(0, index).every((other) => !isAlike(one, other)));
}

/** What a press may have meant as well as the nearest thing, that among them. */
export function meantBy(model: Model, all: readonly Snapped[], at: Place, reach: number, scale: number): Snapped[] {
  const { takes } = lacking(model.tool.value, model.has.value) ?? {};
  if (all.length < 2) return [...all];
  if (takes === "point" || takes === "scheme") return together(all, CLOSE / scale);
  return takes === "direction" ? unlike(all, at, reach / 2) : all.slice(0, 1);
}

/** Asks which of several things a press has meant. */
export function askWhich(model: Model, meant: readonly Snapped[]): void {
  model.between.set(meant);
  const isDirection = meant[0]?.direction !== null;
  model.says.set({ text: say(isDirection ? "which_direction" : "which_of", { count: meant.length }), isBad: false });
}

/** What is possible at a place, the nearest first. */
export async function snaps(app: App, model: Model, stage: Stage, at: Place, reach: number): Promise<Snapped[]> {
  const known = model.known.value;
  if (known === null || model.until.value !== null) return [];
  return app.engine.board_snap(known.scene, known.drawing, { has: model.has.value, sheet: stage.sheet, at, reach }).catch((refused: unknown) => {
    model.says.set({ text: said(refused), isBad: true });
    return [];
  });
}

export function hands(app: App, model: Model, stages: readonly Stage[]): void {
  /** Once a pen is seen, fingers look and do not draw. */
  let hasPen = false;
  /** What is aimed at just now; null where nothing is. */
  let aim: { stage: Stage; at: Place; by: By } | null = null;

  const near = (stage: Stage, by: By): number => REACH[by] / stage.view.now.value.scale;
  const aiming = newest(async ({ stage, at, by }: NonNullable<typeof aim>) => {
    const all = await snaps(app, model, stage, at, near(stage, by));
    const [snap] = all;
    // Where several are meant, all are said.
    const meant = meantBy(model, all, at, near(stage, by), stage.view.now.value.scale);
    if (aim?.stage === stage) stage.aim(snap === undefined ? null : { ...snap, words: meant.map(({ words }) => words).join(" · ") });
    if (by === "touch" && aim?.stage === stage) stage.loupe.show(snap?.at ?? at);
  });

  function aimAt(next: typeof aim): void {
    if (aim !== null && aim.stage !== next?.stage) {
      aim.stage.aim(null);
      aim.stage.loupe.show(null);
    }
    aim = next;
    if (next !== null) aiming.want(next);
  }

  /** A press at a place; one with which a pull begins finishes nothing. */
  const press = (stage: Stage, at: Place, by: By, isBeginning = false): Promise<void> =>
    model.inTurn(async () => {
      const all = await snaps(app, model, stage, at, near(stage, by));
      const [snap] = all;
      stage.aim(null);
      if (snap === undefined || (isBeginning && snap.is_whole)) return;
      const meant = meantBy(model, all, at, near(stage, by), stage.view.now.value.scale);
      if (meant.length < 2) return void (await model.take(snap));
      askWhich(model, meant);
    });

  /** The sheet under a place of one: what is picked up on the scheme is put down on a plan. */
  function under(stage: Stage, [x, y]: Place): { stage: Stage; at: Place } {
    const from = stage.root.getBoundingClientRect();
    const [left, top] = [from.left + x, from.top + y];
    const found = stages.find(({ root }) => {
      const box = root.getBoundingClientRect();
      return box.width > 0 && left >= box.left && left <= box.right && top >= box.top && top <= box.bottom && root.contains(document.elementFromPoint(left, top));
    });
    const on = found ?? stage;
    const box = on.root.getBoundingClientRect();
    return { stage: on, at: on.view.toSheet([left - box.left, top - box.top]) };
  }

  for (const stage of stages) {
    const { over, view } = stage;
    touch(over, view, {
      takes: (event) => event.button <= 1,
      pressed({ by }) {
        hasPen ||= by === "pen";
        stage.cursor = null;
        stage.draw();
        over.focus({ preventScroll: true });
      },
      rests: {
        after: HOLD,
        pulls(of, at) {
          if (of.by !== "touch" || hasPen) return false;
          aimAt({ stage, at: view.toSheet(at), by: of.by });
          return true;
        },
      },
      pulls(of) {
        if (of.button === 1 || (of.by === "touch" && hasPen) || model.until.value !== null) return false;
        void press(stage, view.toSheet(of.start), of.by, true);
        return true;
      },
      pulled(at, of) {
        aimAt({ ...under(stage, at), by: of.by });
      },
      dropped(at, of) {
        const there = under(stage, at);
        aimAt(null);
        void press(there.stage, there.at, of.by);
      },
      cancelled: () => aimAt(null),
      tapped(at, of) {
        if (of.button === 1 || (of.by === "touch" && hasPen)) return;
        void press(stage, view.toSheet(at), of.by);
      },
    });
    over.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0 || event.pointerType === "touch") return;
      const { left, top } = over.getBoundingClientRect();
      aimAt({ stage, at: view.toSheet([event.clientX - left, event.clientY - top]), by: event.pointerType === "pen" ? "pen" : "mouse" });
    });
    over.addEventListener("pointerleave", (event) => event.buttons === 0 && aimAt(null));
    over.addEventListener("contextmenu", (event) => event.preventDefault());
    over.addEventListener("mousedown", (event) => event.preventDefault());
  }
  // What the tool takes next is another thing at the same place.
  model.has.on(() => aim !== null && aiming.want(aim));
}
