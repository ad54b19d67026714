/** The engine's SVG on the page. */

import { patch } from "../dom/patch.ts";

const ROOT = /^[^<]*<svg\b([^>]*)>/;

/** The colours of a sheet on a dark screen, by the colour on paper. */
const darkened = new Map<string, string>();

/** A colour with its lightness turned round and its hue kept: white paper becomes dark, ink light. */
function dark(colour: string): string {
  const known = darkened.get(colour);
  if (known !== undefined) return known;
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) as [number, number, number];
  const shift = 255 - Math.max(red, green, blue) - Math.min(red, green, blue);
  // Not quite black, and not quite white: from 24 to 240; what is pale on paper stays a little lighter, or it would be lost.
  const mapped = [red, green, blue].map((part) => Math.round(24 + 216 * ((part + shift) / 255) ** 0.75));
  const made = `#${mapped.map((part) => Math.min(255, Math.max(0, part)).toString(16).padStart(2, "0")).join("")}`;
  darkened.set(colour, made);
  return made;
}

/** Whether the sheet is drawn on a dark ground already, as a blackboard is. */
function isDarkGround(svg: string): boolean {
  const ground = /<rect [^>]*fill="#([0-9a-f]{6})"/.exec(svg)?.[1];
  return ground !== undefined && parseInt(ground.slice(2, 4), 16) < 128;
}

/** The sheet in the colours of a dark screen. */
export function forDark(svg: string): string {
  return isDarkGround(svg) ? svg : svg.replace(/(fill|stroke)="(#[0-9a-f]{6})"/g, (_, what: string, colour: string) => `${what}="${dark(colour)}"`);
}

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
