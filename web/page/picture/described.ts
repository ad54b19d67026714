import type { Shown } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { SHEETS, type Opened } from "../engine/types.ts";
import { say } from "../layout/words.ts";
import { at, entries, groundOf, linksOf, names, pointsOn, slidersOf, unitsOf, type Draft } from "../panels/parts/scene.ts";
import { called } from "../sheets.ts";
import { marked } from "../steps/bar.ts";
import { language } from "../words.ts";

/** The picture in words, for who does not see it: links and joints as a list, then what is drawn in each plan and what it gives, as far as the steps have come. */
export function described(app: Shown): void {
  const place = byId("described", app.root);
  function show(): void {
    const { opened } = app.solved.value;
    if (opened === null) return place.replaceChildren();
    const isPlanless = app.student.value;
    const last = app.view.value.step === null || app.view.value.coarse ? Infinity : app.view.value.step;
    const parts = SHEETS.flatMap(({ key }) => {
      if (isPlanless && key !== "scheme") return [];
      const drawn = opened.steps.filter((step) => step.panel === key && step.number <= last);
      const told = isPlanless ? [] : drawn.map(({ caption, equation, values }) => [caption, [equation, ...values].filter((part) => part !== "").join("; ")].join(" ").trim());
      const begin = key === "scheme" ? mechanism(opened) : key === "velocity" && told.length > 0 ? [say("letter_poles"), say("letter_images")] : [];
      const lines = [...begin, ...told];
      return lines.length === 0 ? [] : [element("h3", {}, called(key, "title")), element("ul", {}, ...lines.map((line) => element("li", {}, ...marked(line))))];
    });
    place.replaceChildren(element("h2", {}, say("described")), ...parts);
  }
  app.solved.on(show);
  app.view.on(show);
  app.student.on(show);
  language.on(show);
}

/** The mechanism as a list: fixed points, links with their joints and lengths, sliders, drives. */
function mechanism({ scene, drives }: Opened): string[] {
  const draft: Draft = scene;
  const { length, omega } = unitsOf(draft);
  const listed = (all: string[]): string => all.join(", ");
  const placed = (name: string, place: unknown): string => (Array.isArray(place) ? `${name} (${place.join("; ")}) ${length}` : name);
  const driven = new Map(drives.map(({ name, shown }) => [name, shown]));
  const links = linksOf(draft).map((name) => {
    const link = at(draft, ["links", name]);
    const lengths = entries(at(link, ["lengths"])).map(([key, value]) => `${key} = ${String(value)} ${length}`);
    const place = driven.get(name);
    const speed = [["omega", "ω", omega], ["rpm", "n", "1/min"], ["speed", "v", unitsOf(draft).velocity]].flatMap(([key, symbol, unit]) => {
      const value = at(link, ["drive", key!]);
      return value === undefined ? [] : [`${symbol} = ${String(value)} ${unit}`];
    });
    return [say("is_link", { name, points: listed(pointsOn(draft, name)) }), ...lengths, ...(place === undefined ? [] : [say("is_driven", { place })]), ...speed].join("; ");
  });
  const sliders = slidersOf(draft).map((slider: unknown) => {
    const on = String(at(slider, ["on"]) ?? "ground");
    const what = String(at(slider, ["link"]) ?? at(slider, ["pin"]) ?? "");
    const through = at(slider, ["through"]);
    const words = say(at(slider, ["pin"]) === undefined ? "is_slider" : "is_pin", { name: what, on: on === "ground" ? say("is_ground") : on });
    return Array.isArray(through) ? `${words} ${say("is_through", { place: placed("", through).trim() })}` : words;
  });
  const known = entries(draft.known).map(([name]) => name);
  return [say("is_fixed", { points: listed(groundOf(draft).map((name) => placed(name, at(draft, ["ground", name])))) }), ...links, ...sliders, ...(known.length === 0 ? [] : [say("is_known", { points: listed(names(known)) })])];
}
