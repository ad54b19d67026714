/** The card of a point, a link or a load that somebody clicked in the picture or in Build. */
import type { App } from "../../app.ts";
import { at, dotted, isDrawn, linksOf, parsed, pointsOn, type Draft, type Path } from "../parts/scene.ts";

/** Where the numbers of a point, a link or a load are: of a point that has none of its own, in the first link that has it. */
function pathOf(scene: Draft, of: "point" | "link" | "load", name: string): Path | null {
  if (of === "link") return ["links", name];
  if (of === "load") return ["forces", Number(name)];
  const own: Path = isDrawn(scene) ? ["points", name] : ["ground", name];
  if (at(scene, own) !== undefined) return own;
  const link = linksOf(scene).find((each) => pointsOn(scene, each).includes(name));
  return link === undefined ? null : ["links", link];
}

/** How long what was clicked is marked, in ms. */
const MARKED = 1600;

export function revealing(app: App, form: HTMLElement): void {
  const find = (path: string): HTMLElement | null => form.querySelector(`[data-path="${CSS.escape(path)}"]`);
  const twoFrames = (): Promise<unknown> => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));

  async function show(path: string, types: boolean): Promise<void> {
    // What is far from what is seen is built when it comes near.
    find(path)?.scrollIntoView({ block: "nearest" });
    await twoFrames();
    const place = find(path);
    if (place === null) return;
    const group = place.closest("details");
    if (group !== null) group.open = true;
    place.scrollIntoView({ block: "nearest" });
    place.classList.add("revealed");
    window.setTimeout(() => place.classList.remove("revealed"), MARKED);
    if (!types) return;
    const input = place.querySelector<HTMLInputElement>("input.number") ?? place.querySelector<HTMLInputElement>("input");
    input?.focus({ preventScroll: true });
    input?.select();
  }

  app.card.on((card) => {
    if (card === null) return;
    app.card.set(null);
    const scene = parsed(app.history.now.value.text);
    const path = scene === null ? null : pathOf(scene, card.of, card.name);
    if (path !== null) void show(dotted(path), card.types);
  });
}
