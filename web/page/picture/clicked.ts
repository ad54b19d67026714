/** A click on a joint or a link of the picture, which drags nothing: its card in the form of the mechanism is shown. */
import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { distance } from "../build/hit.ts";
import { linksOf, parsed, pointsOn } from "../panels/parts/scene.ts";
import { inPane } from "./pulling.ts";
import type { Viewport } from "../look/viewport.ts";

/** How far a click may wander, how long it may last, in pixels and ms; and how near the link must be. */
const [STILL, SHORT, REACH] = [4, 500, 8];

export function clicked(app: App, view: Viewport): void {
  const pane = byId("pane");
  let start: { at: [number, number]; time: number } | null = null;

  function linkAt(pixels: [number, number]): string | null {
    const handles = (app.picture.value?.handles ?? []).filter(({ panel }) => panel === "scheme");
    const places = new Map(handles.map(({ name, at }) => [name, view.toPane(at)]));
    const scene = parsed(app.solved.value.good);
    if (scene === null) return null;
    const near = linksOf(scene).map((link): [string, number] => {
      const corners = pointsOn(scene, link).flatMap((point) => (places.has(point) ? [places.get(point)!] : []));
      return [link, Math.min(Infinity, ...corners.flatMap((a, index) => corners.slice(index + 1).map((b) => distance(pixels, a, b))))];
    });
    const [found] = near.sort((a, b) => a[1] - b[1]);
    return found !== undefined && found[1] <= REACH ? found[0] : null;
  }

  /** On a narrow screen a panel would cover the picture. */
  const hasRoom = (): boolean => !app.student.value && !app.building.value && (app.shown.value === "mechanism" || window.innerWidth >= 960);

  pane.addEventListener("pointerdown", (event) => (start = event.button === 0 ? { at: inPane(app, event), time: event.timeStamp } : null), { capture: true });
  pane.addEventListener(
    "pointerup",
    (event) => {
      const at = inPane(app, event);
      const isClick = start !== null && Math.hypot(at[0] - start.at[0], at[1] - start.at[1]) <= STILL && event.timeStamp - start.time <= SHORT;
      start = null;
      const target = event.target as Element;
      if (!isClick || !hasRoom() || target.closest(".floating") !== null) return;
      const point = target.closest<HTMLElement>(".handle")?.dataset["point"] ?? null;
      const link = point === null ? linkAt(at) : null;
      if (point === null && link === null) return;
      app.show("mechanism");
      app.card.set({ of: point === null ? "link" : "point", name: point ?? link!, types: true });
    },
    { capture: true },
  );
}
