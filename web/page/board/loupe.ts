/** A magnifier beside the finger, which hides what it touches. */
import { element, svgElement } from "../dom/element.ts";
import type { Viewport } from "../look/viewport.ts";

/** Its side in pixels, how many times it magnifies, and how far it is from the finger. */
const [SIDE, TIMES, AWAY] = [132, 2.5, 34];

export interface Loupe {
  root: HTMLElement;
  /** Shows what lies around a place of the sheet; null hides it. */
  show(at: [number, number] | null): void;
}

/** Of a sheet and what lies over it. */
export function loupe(view: Viewport, drawn: SVGSVGElement, over: SVGSVGElement): Loupe {
  const root = element("div", { class: "loupe", "aria-hidden": "true", hidden: true });
  const hairs = svgElement("svg", { class: "hairs", viewBox: "-66 -66 132 132" }, svgElement("path", { d: "M-66 0H-5M5 0H66M0-66V-5M0 5V66" }));
  return {
    root,
    show(at) {
      root.hidden = at === null;
      if (at === null) return root.replaceChildren();
      const side = SIDE / (TIMES * view.now.value.scale);
      const copies = [drawn, over].map((each) => {
        const copy = each.cloneNode(true) as SVGSVGElement;
        copy.setAttribute("viewBox", `${at[0] - side / 2} ${at[1] - side / 2} ${side} ${side}`);
        for (const attribute of ["tabindex", "role", "data-sheet"]) copy.removeAttribute(attribute);
        for (const marked of copy.querySelectorAll("[id]")) marked.removeAttribute("id");
        return copy;
      });
      root.replaceChildren(...copies, hairs);
      const [x, y] = view.toPane(at);
      const { width } = view.size;
      const isHigh = y > SIDE + AWAY;
      const left = Math.min(Math.max(x - SIDE / 2, 6), width - SIDE - 6);
      // Near the upper edge it stands beside the finger.
      const beside = x > width / 2 ? x - SIDE - AWAY : x + AWAY;
      root.style.transform = `translate(${isHigh ? left : beside}px, ${isHigh ? y - SIDE - AWAY : Math.max(6, y - SIDE / 2)}px)`;
    },
  };
}
