type Child = Node | string | null | undefined | false;

/** What an element has: properties by their names, attributes in kebab case, listeners as functions. */
export type Given = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

/** An element with what it has and what is in it. */
export function h<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  given: Given = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  return filled(document.createElement(name), given, children);
}

/** The same in SVG. */
export function s<Name extends keyof SVGElementTagNameMap>(
  name: Name,
  given: Given = {},
  ...children: Child[]
): SVGElementTagNameMap[Name] {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", name), given, children);
}

function filled<T extends Element>(element: T, given: Given, children: Child[]): T {
  for (const [key, value] of Object.entries(given)) {
    if (typeof value === "function") element.addEventListener(key.replace(/^on/, ""), value as unknown as EventListener);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(key, String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

/** Drawings of the buttons, on 16 × 16. */
const ICONS = {
  remove: "M4 4l8 8M12 4l-8 8",
  add: "M8 3v10M3 8h10",
  pin: "M6 2h4l-.5 4.5L12 9H4l2.5-2.5zM8 9v5",
  down: "M4 6l4 4 4-4",
} as const;

export type Icon = keyof typeof ICONS;

/** A drawing of a button; what the button does is its own name. */
export function icon(name: Icon): SVGElement {
  return s("svg", { class: "icon", viewBox: "0 0 16 16", "aria-hidden": "true" }, s("path", { d: ICONS[name] }));
}
