import type { Shown } from "../app.ts";
import { byId } from "../dom/find.ts";
import type { Picture } from "../engine/types.ts";
import { forDark } from "./dark.ts";
import { fill } from "./sheet.ts";
import type { Viewport } from "../look/viewport.ts";

/** Draws the picture that the app shows, through the window onto the sheet. */
export function pane(app: Shown, view: Viewport): void {
  const root = byId<SVGSVGElement>("sheet", app.root);
  const paper = byId("paper", app.root);
  const box = byId("pane", app.root);

  function look(): void {
    const { width, height } = view.size;
    const [left, top] = view.toSheet([0, 0]);
    const { scale } = view.now.value;
    root.setAttribute("viewBox", `${left} ${top} ${width / scale} ${height / scale}`);
    const picture = app.picture.value;
    if (picture === null) return;
    // A panel alone is cut out of the sheet.
    const [x0, y0, wide, high] = view.alone() ?? [0, 0, picture.width, picture.height];
    const [x, y] = view.toPane([x0, y0]);
    paper.style.cssText = `transform: translate(${x}px, ${y}px); width: ${wide * scale}px; height: ${high * scale}px`;
    const [right, bottom] = [view.size.width - x - wide * scale, view.size.height - y - high * scale];
    root.style.clipPath = view.alone() === null ? "" : `inset(${Math.max(0, y)}px ${Math.max(0, right)}px ${Math.max(0, bottom)}px ${Math.max(0, x)}px)`;
  }

  function draw(picture: Picture): void {
    fill(root, app.dark.value ? forDark(picture.svg) : picture.svg);
    look();
  }

  view.now.on(look);
  app.picture.on((picture) => (picture === null ? root.replaceChildren() : draw(picture)));
  app.dark.on(() => app.picture.value !== null && draw(app.picture.value));
  app.solved.on(({ opened, refused }) => {
    box.classList.toggle("stale", refused !== null);
    byId("no-picture", app.root).hidden = opened !== null || refused === null;
    root.setAttribute("aria-label", opened?.title ?? "");
  });
  new ResizeObserver(() => view.resize(box.clientWidth, box.clientHeight)).observe(box);
  view.resize(box.clientWidth, box.clientHeight);
}
