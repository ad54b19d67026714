/** The engine's SVG on the page. */

import { patch } from "../dom/patch.ts";

const ROOT = /^[^<]*<svg\b([^>]*)>/;

/** The white of a sheet, for what lies on a ground of its own. */
const WHITE = /<rect [^>]*fill="#ffffff"[^>]*\/>/;
export const withoutPaper = (svg: string): string => svg.replace(WHITE, "");

/** A sheet as an element of its own, for panels: ids in it begin with `prefix`, so that they meet no others. */
export function sheetElement(svg: string, prefix: string, name: string): SVGSVGElement {
  const holder = document.createElement("div");
  holder.innerHTML = svg.slice(Math.max(0, svg.search(/<svg\b/)));
  const root = holder.querySelector("svg") ?? document.createElementNS("http://www.w3.org/2000/svg", "svg");
  for (const marked of root.querySelectorAll("[id]")) marked.id = `${prefix}-${marked.id}`;
  for (const user of root.querySelectorAll("[clip-path], [href]"))
    for (const attribute of ["clip-path", "href"]) {
      const value = user.getAttribute(attribute);
      if (value?.includes("#")) user.setAttribute(attribute, value.replace("#", `#${prefix}-`));
    }
  root.querySelector(":scope > title")?.remove();
  root.querySelector(":scope > desc")?.remove();
  root.setAttribute("role", "img");
  root.setAttribute("aria-label", name);
  return root;
}

/** Puts the contents of a sheet into the page's own SVG element. */
export function fill(root: SVGSVGElement, svg: string): void {
  const opening = ROOT.exec(svg);
  if (opening === null) return;
  const attribute = (name: string): string | undefined => new RegExp(`\\b${name}="([^"]*)"`).exec(opening[1] ?? "")?.[1];
  for (const name of ["fill", "font-family", "text-rendering"]) {
    const value = attribute(name) ?? "";
    if (root.getAttribute(name) !== value) root.setAttribute(name, value);
  }
  // Title and description would show as a tip wherever the mouse rests; the element has a name of its own.
  const inner = svg.slice(opening[0].length, svg.lastIndexOf("</svg>"));
  patch(root, inner.replace(/^\s*<title>[^<]*<\/title>/, "").replace(/^\s*<desc>[^<]*<\/desc>/, ""));
}
