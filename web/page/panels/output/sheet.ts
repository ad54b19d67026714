import { element } from "./element.ts";

/** A box on a sheet: x, y, width, height in mm. */
export type Box = [number, number, number, number];

/** A place for a picture of the engine. */
export interface Sheet {
  root: HTMLElement;
  /** Shows a picture, or the part of it in a box. */
  show(svg: string, part?: Box): void;
}

/** A place for a picture, in a tree of its own, so that the ids in it meet no others of the page. */
export function sheet(attributes: Record<string, string> = {}): Sheet {
  const root = element("div", { class: "drawn", ...attributes });
  const tree = root.attachShadow({ mode: "open" });
  return {
    root,
    show(svg, part) {
      tree.innerHTML = `<style>svg { display: block; width: 100%; height: auto; }</style>${svg}`;
      const picture = tree.querySelector("svg");
      if (part === undefined || picture === null) return;
      picture.setAttribute("viewBox", part.join(" "));
      picture.removeAttribute("width");
      picture.removeAttribute("height");
    },
  };
}

/** Width and height of a sheet in mm, as its SVG says them. */
export function sizeOf(svg: string): [number, number] {
  const side = (name: string): number => Number(new RegExp(`^<svg[^>]* ${name}="([\\d.]+)mm"`).exec(svg)?.[1] ?? Number.NaN);
  return [side("width"), side("height")];
}
