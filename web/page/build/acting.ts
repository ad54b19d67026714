/** What clicks, drags and keys come to: the same, whichever hand it was. */
import type { App } from "../app.ts";
import { speak } from "../layout/messages.ts";
import { edit } from "../panels/parts/edits.ts";
import { newId } from "../panels/parts/fields.ts";
import { listOf, pointsOn } from "../panels/parts/scene.ts";
import { copied, pasted, type Chosen } from "./copied.ts";
import { NOTHING, type Model } from "./model.ts";
import type { Place } from "./sight.ts";
import { DRAWN, drawn, pressed, type Press } from "./tools.ts";
import { say } from "./words.ts";

/** One thing chosen. */
export function only({ point, link }: Press): Chosen {
  return { points: new Set(point === null ? [] : [point]), links: new Set(point === null && link !== null ? [link] : []) };
}

export function isChosen({ points, links }: Chosen, { point, link }: Press): boolean {
  return point !== null ? points.has(point) : link !== null && links.has(link);
}

/** The chosen things with one more, or without it. */
export function toggled({ points, links }: Chosen, press: Press): Chosen {
  const turned = (all: ReadonlySet<string>, one: string | null): Set<string> => {
    const next = new Set(all);
    if (one !== null && !next.delete(one)) next.add(one);
    return next;
  };
  return { points: turned(points, press.point), links: press.point === null ? turned(links, press.link) : links };
}

function isFormSeen(app: App): boolean {
  return app.shown.value !== "" && window.innerWidth >= 960;
}

/** Opens the card of what was pressed in the form of the mechanism; `types`: so that its number can be typed. */
export function reveal(app: App, { point, link, load }: Press, types: boolean): void {
  if (load !== undefined) return revealLoad(app, load.index, types);
  if (point === null && link === null) return;
  // A panel that is folded away stays so, unless its numbers are asked for.
  if (types || isFormSeen(app)) app.show("mechanism");
  app.card.set({ of: point === null ? "link" : "point", name: point ?? link!, types });
}

function revealLoad(app: App, index: number, types: boolean): void {
  app.show("mechanism");
  app.card.set({ of: "load", name: String(index), types });
}

/** All points of what is chosen. */
export function pointsOfChosen(model: Model): Set<string> {
  const { points, links } = model.chosen.value;
  const scene = model.present()?.scene ?? {};
  return new Set([...points, ...[...links].flatMap((link) => pointsOn(scene, link))]);
}

/** A click at a place: all of a tool that is done at one place, half of one that goes from here to there. */
export async function clicked(app: App, model: Model, press: Press): Promise<void> {
  const tool = model.tool.value;
  if (press.load !== undefined) return revealLoad(app, press.load.index, false);
  if (model.scaling.value !== null) return void model.scaling.set([...model.scaling.value, press.under].slice(0, 2));
  if (tool === "select") {
    model.chosen.set(only(press));
    return reveal(app, press, false);
  }
  if (!DRAWN.includes(tool)) {
    const there = model.present();
    if (there !== null) await model.make(pressed(tool, there, press));
    return;
  }
  const from = model.begun.value;
  if (from === null) return begin(app, model, press);
  await went(app, model, from, press);
}

/** A tap of a finger or a mouse: of the tool that loads a couple, else a click. */
export async function tapped(app: App, model: Model, press: Press): Promise<void> {
  const isCouple = press.load === undefined && model.tool.value === "load" && model.begun.value === null && model.scaling.value === null;
  await (isCouple ? went(app, model, press, press) : clicked(app, model, press));
}

function begin(app: App, model: Model, press: Press): void {
  const tool = model.tool.value;
  if ((tool === "third" && press.link === null) || (tool === "load" && press.link === null && press.point === null)) return app.tell(say("needs_link"));
  model.begun.set(press);
}

/** A tool that went from one place to another. */
export async function went(app: App, model: Model, from: Press, to: Press): Promise<void> {
  model.begun.set(null);
  const there = model.present();
  if (there === null || !(await model.make(drawn(model.tool.value, there, from, to, model.choices.value)))) return;
  if (model.tool.value === "load" && isFormSeen(app)) app.card.set({ of: "load", name: String(listOf(there.scene, "forces").length), types: false });
}

/** Removes what is chosen, as one entry of undo: what goes with something else is gone already. */
export async function removeChosen(app: App, model: Model): Promise<void> {
  const { points, links } = model.chosen.value;
  const gesture = newId();
  model.chosen.set(NOTHING);
  for (const link of links) await edit(app, [{ drop_link: link }], gesture);
  for (const point of points) await edit(app, [{ drop_point: point }], gesture);
  await model.fresh();
  speak(say("removed"));
}

export function copyChosen(model: Model): void {
  const there = model.present();
  if (there === null) return;
  model.copied = copied(there, model.chosen.value);
  speak(say("copied", { count: model.copied.places.length }));
}

/** Puts in what was copied: beside what it is a copy of, and chosen, to be moved. */
export async function paste(model: Model): Promise<void> {
  const there = model.present();
  if (there === null || model.copied === null || model.copied.places.length === 0) return;
  const { fine } = model.sight.grid();
  const by: Place = [2 * fine, -2 * fine];
  const { edits, chosen } = pasted(there.scene, model.copied, by);
  if (!(await model.make(edits))) return;
  model.copied = { ...model.copied, places: model.copied.places.map(([name, [x, y]]) => [name, [x + by[0], y + by[1]]]) };
  model.tool.set("select");
  model.chosen.set(chosen);
}
