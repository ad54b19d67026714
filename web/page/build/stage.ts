/** The stage itself: what lies behind, the engine's picture of the mechanism, and over it what hands and keys are about to do. */
import type { App } from "../app.ts";
import { svgElement } from "../dom/element.ts";
import { name } from "../layout/say.ts";
import { isDark } from "../layout/theme.ts";
import { unitsOf } from "../panels/parts/scene.ts";
import { forDark } from "../picture/dark.ts";
import { fill, withoutPaper } from "../picture/sheet.ts";
import { language } from "../words.ts";
import { buildKeys } from "./keys.ts";
import { crossShape } from "./cross.ts";
import { gridShapes, lineShapes, photoShape } from "./ground.ts";
import { hands } from "./hands.ts";
import { placesIn, placesOf } from "./hit.ts";
import { forceWords } from "./loading.ts";
import type { Model, Shown } from "./model.ts";
import type { Pixels, Place } from "./sight.ts";
import { degrees, type Press } from "./tools.ts";
import { say } from "./words.ts";

export interface Stage {
  focus(): void;
  /** Keys begin where something is to be seen. */
  begin(): void;
  /** Puts back what goes on; whether something did. */
  cancel(): boolean;
}

/** Fills `field` with the stage. */
export function stage(app: App, model: Model, field: HTMLElement, menu: (press: Press, at: Pixels) => void): Stage {
  const { sight } = model;
  const behind = svgElement("svg", { class: "behind", "aria-hidden": "true" });
  const picture = svgElement("svg", { class: "drawn", "aria-hidden": "true" });
  const over = svgElement("svg", { id: "build-stage", class: "over", tabindex: 0, role: "application" });
  field.append(behind, picture, over);

  function ground(): void {
    const photo = model.photo.value;
    const unit = unitsOf(model.present()?.scene ?? {}).length;
    const grid = svgElement("g", { class: "grid" }, ...gridShapes(sight, unit));
    behind.replaceChildren(...(photo === null ? [] : [photoShape(photo, sight)]), grid);
  }

  function drawn(shown: Shown | null): void {
    if (shown === null) return picture.replaceChildren();
    // Behind the mechanism are grid and photograph.
    const svg = withoutPaper(shown.drafted.svg);
    fill(picture, isDark.value ? forDark(svg) : svg);
    picture.setAttribute("viewBox", `0 0 ${shown.drafted.width} ${shown.drafted.height}`);
    name(over as unknown as HTMLElement, say("stage", { count: shown.drafted.points.length }));
    look();
  }

  /** Until the engine has drawn it anew, the picture goes with the window. */
  function look(): void {
    const shown = model.shown.value;
    if (shown === null) return;
    const { centre, scale } = shown.at;
    const factor = sight.now.value.scale / scale;
    const corner = sight.toPane([centre[0] - sight.size.width / 2 / scale, centre[1] + sight.size.height / 2 / scale]);
    picture.style.transform = `translate(${corner[0]}px, ${corner[1]}px) scale(${factor})`;
  }

  const marks = (): SVGElement[] => {
    const shown = model.shown.value;
    if (shown === null) return [];
    const places = placesIn(shown.drafted);
    const scene = model.present()?.scene ?? {};
    const { points, links } = model.chosen.value;
    const ring = (place: Place, kind: string): SVGElement => {
      const [cx, cy] = sight.toPane(place);
      return svgElement("circle", { cx, cy, r: 9, class: kind });
    };
    const of = (link: string): string => placesOf(scene, places, link).map((place) => sight.toPane(place).join(",")).join(" ");
    return [
      ...[...links].map((link) => svgElement("polygon", { points: of(link), class: "chosen" })),
      ...[...points].flatMap((point) => (places.has(point) ? [ring(places.get(point)!, "chosen")] : [])),
      ...(model.begun.value === null ? [] : [ring(model.begun.value.at, "begun")]),
      ...(model.scaling.value ?? []).map((place) => ring(place, "begun")),
    ];
  };

  /** What would be taken here. */
  function under(): SVGElement[] {
    const at = moving.at();
    if (at === null) return [];
    const press = model.press(sight.toScene(at), 10);
    if (press.point === null && press.load === undefined) return [];
    const [cx, cy] = sight.toPane(press.at);
    return [svgElement("circle", { cx, cy, r: 8, class: "under" })];
  }

  function line(): SVGElement[] {
    const load = model.dragging.value;
    if (load !== null) return lineShapes(sight.toPane(load.from), sight.toPane(load.to), load.words);
    const way = moving.line() ?? keyed.line();
    if (way === null) return [];
    const [from, to] = [way.from.at, way.to.at];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const unit = unitsOf(model.present()?.scene ?? {}).length;
    const there = model.present();
    if (model.tool.value === "load" && there !== null) return lineShapes(sight.toPane(from), sight.toPane(to), forceWords(there, way.from, way.to));
    return lineShapes(sight.toPane(from), sight.toPane(to), `${Number(length.toPrecision(4))} ${unit}, ${degrees(from, to).toFixed(1)}°`.replace("-", "−"));
  }

  function frame(): SVGElement[] {
    const corners = moving.frame();
    if (corners === null) return [];
    const [a, b] = corners;
    return [svgElement("rect", { class: "frame", x: Math.min(a[0], b[0]), y: Math.min(a[1], b[1]), width: Math.abs(a[0] - b[0]), height: Math.abs(a[1] - b[1]) })];
  }

  let isWaiting = false;
  function draw(): void {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      if (!app.building.value) return;
      const cross = svgElement("g", { class: "cross" }, ...crossShape(sight.toPane(keyed.cross()), keyed.words()));
      // For tests: what can be taken hold of of loads.
      over.dataset["loads"] = JSON.stringify(model.handles());
      over.replaceChildren(...marks(), ...frame(), ...under(), ...line(), cross);
    });
  }
  const moving = hands(app, model, over, menu, draw);
  const keyed = buildKeys(app, model, over, menu, draw, moving.cancel);

  /** Where the middle of the stage was on the screen: rows of tools that come and go move the stage, not the mechanism. */
  let middle: Pixels | null = null;
  new ResizeObserver(() => {
    const { left, top, width, height } = field.getBoundingClientRect();
    if (width === 0) return void (middle = null);
    sight.resize(width, height);
    for (const each of [behind, over, picture]) each.style.cssText += `;width:${width}px;height:${height}px`;
    const now: Pixels = [left + width / 2, top + height / 2];
    if (middle !== null) sight.pan(middle[0] - now[0], middle[1] - now[1]);
    middle = now;
    model.redraw();
    ground();
    draw();
  }).observe(field);
  model.shown.on((shown) => (drawn(shown), ground(), draw()));
  sight.now.on(({ centre, scale }) => {
    // For tests: where a place of the scene is on the screen.
    over.dataset["window"] = JSON.stringify([...centre, scale]);
    look();
    ground();
    draw();
  });
  for (const each of [model.begun, model.chosen, model.scaling, model.tool, model.dragging] as { on(act: () => void): void }[]) each.on(draw);
  model.photo.on(ground);
  isDark.on(() => drawn(model.shown.value));
  language.on(() => drawn(model.shown.value));
  return { focus: () => over.focus({ preventScroll: true }), begin: keyed.begin, cancel: () => moving.cancel() || keyed.cancel() };
}
