type Child = Node | string | null | undefined | false;

/**
 * What an element has, by names: `onclick` and its like are called; `true` is an attribute without a value; `false`, `null` and
 * `undefined` are none.
 */
export type Given = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

/** A new element with what it has and what is in it; texts are texts, never markup. */
export function element<Name extends keyof HTMLElementTagNameMap>(name: Name, given: Given = {}, ...inside: Child[]): HTMLElementTagNameMap[Name] {
  return filled(document.createElement(name), given, inside);
}

/** The same in SVG. */
export function svgElement<Name extends keyof SVGElementTagNameMap>(name: Name, given: Given = {}, ...inside: Child[]): SVGElementTagNameMap[Name] {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", name), given, inside);
}

function filled<Made extends Element>(made: Made, given: Given, inside: Child[]): Made {
  for (const [name, value] of Object.entries(given)) {
    if (typeof value === "function") made.addEventListener(name.replace(/^on/, ""), value as unknown as EventListener);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(...inside.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return made;
}
