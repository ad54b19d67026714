import { svgElement } from "../../dom/element.ts";

/** Size of low letters over that of the others, and how low they stand, in em. */
const LOW = { size: 0.7, drop: 0.25 };

/** A label of the engine, which is HTML with `<i>` and `<sub>`, as text of SVG; a name of a file alone is taken as it is. */
export function letters(label: string | undefined, name: string): SVGTextElement {
  const text = svgElement("text", { x: "1.6", y: "-1.6" });
  if (label === undefined) {
    text.textContent = name;
    return text;
  }
  const holder = document.createElement("template");
  holder.innerHTML = label;
  let low = 0;
  const walk = (node: Node, depth: number): void => {
    if (node.nodeType === Node.TEXT_NODE) {
      const run = svgElement("tspan", { dy: `${(depth - low) * LOW.drop}em`, "font-size": `${100 * LOW.size ** Math.abs(depth)}%` });
      low = depth;
      run.textContent = node.textContent;
      text.append(run);
      return;
    }
    const shift = node instanceof HTMLElement ? { SUB: 1, SUP: -1 }[node.tagName] ?? 0 : 0;
    node.childNodes.forEach((child) => walk(child, depth + shift));
  };
  walk(holder.content, 0);
  return text;
}
