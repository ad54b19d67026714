import type { App } from "../../../app.ts";
import type { Form, Photo, PhotoPlan, Tapped } from "../../../engine/types.ts";
import type { FormFile, Place } from "../form.ts";
import { greyOf, type Photograph } from "./picture.ts";
import { keyOf, placesOn, withoutPoint, withPoint } from "./placing.ts";
import type { State } from "./points_bar.ts";
import { kindOf, type Mark } from "./stage.ts";

/** What the photograph asks of the form. */
export interface FormOf {
  change(how: (file: FormFile) => FormFile, gesture: string): void;
  /** What has been changed is an entry of undo of its own. */
  left(): void;
  present(): FormFile;
  form(): Form | null;
  /** Goes to what the check says. */
  toResult(): void;
}

/** A point of a plan on the sheet. */
export interface Item {
  key: string;
  plan: PhotoPlan;
  name: string;
  label: string;
  isPole: boolean;
}

/** A photograph that was read, and how far somebody is with its points. */
export interface Session {
  photo: Photo;
  /** The scene that it was read for. */
  scene: string;
  items: Item[];
  /** The point that is marked next; empty where none is. */
  chosen: string;
  /** The points of the student with their verdicts. */
  marks: Mark[];
  isLooking: boolean;
  item(key: string): Item | undefined;
  placeOf(one: Item): Place | undefined;
  /** The place that pencil lines propose for a point, as long as it has none. */
  guessOf(one: Item): Tapped | undefined;
  stateOf(one: Item): State;
  /** Whether it is still to be marked. */
  isOpen(one: Item): boolean;
  /** The first point behind this one that is still to be marked, else the first of all; empty where all are done. */
  next(after: string): string;
  leaveOut(one: Item, is: boolean): void;
  /** Puts points where the photograph has them. */
  put(all: [Item, Tapped][]): void;
  /** Moves a point by hand. */
  move(one: Item, at: [number, number]): void;
  remove(one: Item): void;
  /** The same photograph read anew, for another text of its scene. */
  renew(photo: Photo, scene: string): void;
  /** Looks for the points among the pencil lines. */
  look(): Promise<void>;
  /** Asks how the points in the form stand. */
  judge(): Promise<void>;
  /** The place at a place in the picture, as {@link Engine.photo_tap}; `undefined` where the engine fell. */
  tap(one: Item, at: [number, number], reach: number, aim: number): Promise<Tapped | null | undefined>;
}

/** How the engine gets a photograph. */
export const sent = (app: App, form: FormOf, of: Photograph, text: string) => app.engine.photo(text, form.present().exercise ?? "", of.width, of.height, greyOf(of));

function itemsOf(photo: Photo): Item[] {
  return photo.plans.flatMap((plan) => plan.points.map(({ name, label }, index) => ({ key: keyOf(plan.plan, name), plan, name, label, isPole: index === 0 })));
}

/** Begins with a photograph; `original` is as the engine got it. */
export function session(app: App, form: FormOf, original: Photograph, read: Photo, text: string): Session {
  const leftOut = new Set<string>();
  let proposed = new Map<string, Tapped>();

  /** Asks the engine; where it was started anew meanwhile, once more with the photograph. */
  async function ask<Answer>(question: () => Promise<Answer>): Promise<Answer | undefined> {
    try {
      return await question();
    } catch {
      return sent(app, form, original, own.scene).then(question).catch(() => undefined);
    }
  }

  const own: Session = {
    photo: read,
    scene: text,
    items: itemsOf(read),
    chosen: "",
    marks: [],
    isLooking: true,
    item: (key) => own.items.find((one) => one.key === key),
    placeOf: ({ plan, name }) => placesOn(form.present(), plan)[name],
    guessOf: (one) => (own.placeOf(one) === undefined && !leftOut.has(one.key) ? proposed.get(one.key) : undefined),
    stateOf(one) {
      const mark = own.marks.find(({ plan, name }) => keyOf(plan, name) === one.key);
      if (mark !== undefined) return kindOf(mark);
      if (one.isPole) return "printed";
      return own.guessOf(one) !== undefined ? "proposed" : leftOut.has(one.key) ? "out" : "none";
    },
    isOpen: (one) => !one.isPole && !leftOut.has(one.key) && own.placeOf(one) === undefined,
    next(after) {
      const from = own.items.findIndex(({ key }) => key === after) + 1;
      return [...own.items.slice(from), ...own.items.slice(0, from)].find(own.isOpen)?.key ?? "";
    },
    leaveOut: (one, is) => void (is ? leftOut.add(one.key) : leftOut.delete(one.key)),
    put(all) {
      const put = (file: FormFile): FormFile => all.reduce((now, [one, { at, band }]) => withPoint(now, one.plan, own.photo, one.name, at, band), file);
      form.change(put, `photo ${all[0]?.[0].key}`);
      form.left();
    },
    move: (one, at) => form.change((file) => withPoint(file, one.plan, own.photo, one.name, at, null), `photo move ${one.key}`),
    remove(one) {
      form.change((file) => withoutPoint(file, one.plan, one.name), `photo without ${one.key}`);
      form.left();
    },
    renew(photo, scene) {
      Object.assign(own, { photo, scene, items: itemsOf(photo) });
    },
    async look() {
      const found = await ask(() => app.engine.photo_proposed());
      proposed = new Map(found?.map(({ plan, name, place }) => [keyOf(plan, name), place]));
      own.isLooking = false;
    },
    async judge() {
      const file = form.present();
      const placed = own.items.flatMap(({ plan, name }) => {
        const place = placesOn(file, plan)[name];
        return place === undefined ? [] : [{ plan: plan.plan, name, at: [place[0], place[1]] as [number, number], band: place[2] ?? null }];
      });
      const found = placed.length === 0 ? [] : ((await ask(() => app.engine.photo_points(placed))) ?? []);
      const labels = new Map(own.items.map(({ key, label }) => [key, label]));
      own.marks = found.map((verdict) => ({ ...verdict, label: labels.get(keyOf(verdict.plan, verdict.name)) ?? verdict.name, isChosen: false }));
    },
    tap: (one, [x, y], reach, aim) => ask(() => app.engine.photo_tap(one.plan.plan, x, y, reach, aim)),
  };
  own.chosen = own.next("");
  return own;
}
