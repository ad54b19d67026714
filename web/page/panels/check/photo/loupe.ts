import { element, svgElement } from "../../../dom/element.ts";
import type { Pixel, Stage } from "./stage.ts";

/** Its side in pixels of the page, and how much paper it shows, in mm. */
const [SIDE, SHOWN] = [132, 13];
/** How far it is from the finger. */
const AWAY = 34;

/** A magnifier beside the finger, which hides what it touches. */
export function loupe(of: Stage): { root: HTMLElement; show(at: Pixel | null, snapped: Pixel | null, perMm: number): void } {
  const canvas = element("canvas");
  const mark = svgElement("g", { class: "snapped" }, svgElement("circle", { r: 8 }), svgElement("path", { d: "M-13 0H13M0-13V13" }));
  const hairs = svgElement("svg", { viewBox: `${-SIDE / 2} ${-SIDE / 2} ${SIDE} ${SIDE}` }, svgElement("path", { class: "hairs", d: "M-66 0H-5M5 0H66M0-66V-5M0 5V66" }), mark);
  const root = element("div", { class: "loupe", "aria-hidden": "true", hidden: true }, canvas);
  root.append(hairs);

  return {
    root,
    show(at, snapped, perMm) {
      root.hidden = at === null;
      if (at === null) return;
      const sharp = Math.min(2, window.devicePixelRatio);
      if (canvas.width !== SIDE * sharp) Object.assign(canvas, { width: SIDE * sharp, height: SIDE * sharp });
      const scale = SIDE / (SHOWN * perMm);
      of.magnify(canvas, at, scale * sharp);
      const [x, y] = of.view.toPane(at);
      const { width } = of.view.size;
      const isHigh = y > SIDE + AWAY;
      const left = Math.min(Math.max(x - SIDE / 2, 6), width - SIDE - 6);
      // Near the upper edge it stands beside the finger.
      const beside = x > width / 2 ? x - SIDE - AWAY : x + AWAY;
      root.style.transform = `translate(${isHigh ? left : beside}px, ${isHigh ? y - SIDE - AWAY : Math.max(6, y - SIDE / 2)}px)`;
      mark.style.display = snapped === null ? "none" : "";
      if (snapped !== null) mark.setAttribute("transform", `translate(${(snapped[0] - at[0]) * scale} ${(snapped[1] - at[1]) * scale})`);
    },
  };
}
