/** The tools, as buttons of which one is chosen. */
import { element, svgElement } from "../dom/element.ts";
import { radios } from "../dom/radios.ts";
import { language } from "../words.ts";
import type { Model } from "./model.ts";
import { KEY_OF, TOOLS, type Tool } from "./tools.ts";
import { say } from "./words.ts";

/** Pictograms in a square of 24. */
const SHAPES: Record<Tool, string> = {
  lay_off: "M12 3v3M12 6 6 21M12 6l6 15M8.500 15h7M12 4.500m-1.500 0a1.500 1.500 0 1 0 3 0 1.500 1.500 0 1 0-3 0",
  line: "M4 20V6l14 14zM8 16v-3l3 3z",
  join: "M3 17 17 3l4 4L7 21zM8 12l2 2M11 9l3 3M14 6l2 2",
  cross: "M4 20 16 8M5 6l14 12M10.800 13.200m-2.600 0a2.600 2.600 0 1 0 5.200 0 2.600 2.600 0 1 0-5.200 0",
  mark: "M12 4v16M4 12h16M12 12m-1.500 0a1.500 1.500 0 1 0 3 0 1.500 1.500 0 1 0-3 0",
  like: "M3 20h8L5 13zM13 14h9L15 5z",
  measure: "M3 8v8M21 8v8M3 12h18M6 9l-3 3 3 3M18 9l3 3-3 3",
  compute: "M6 3h12v18H6zM9 7h6M9 12v.1M12 12v.1M15 12v.1M9 16v.1M12 16v.1M15 16v.1",
  solve: "M5 7h8M5 12h8M5 17h8M17 8.500h4M17 6.500h4M17 16h4M19 14v4M3 5v14",
  rub: "M8 20 3.500 15.500 14 5l6 6-9 9zM9 10l6 6M8 20h12",
};

export function rail(model: Model): HTMLElement {
  const buttons = TOOLS.map((tool) => {
    const words = element("span", { class: "text" });
    const button = element("button", { type: "button", role: "radio", "data-tool": tool, onclick: () => model.choose(tool) }, svgElement("svg", { class: "icon", viewBox: "0 0 24 24", "aria-hidden": "true" }, svgElement("path", { d: SHAPES[tool] })), words);
    language.on(() => {
      words.textContent = say(`short_${tool}`);
      button.setAttribute("aria-label", say(`tool_${tool}`));
      button.title = `${say(`tool_${tool}`)} (${KEY_OF[tool]})`;
    });
    return button;
  });
  const root = element("div", { class: "rail", role: "radiogroup" }, ...buttons);
  radios(root);
  language.on(() => root.setAttribute("aria-label", say("tools")));
  // Points are put down by eye where the hand is free.
  model.known.on(() => (buttons[TOOLS.indexOf("mark")]!.hidden = (model.drawing().snap ?? "all") === "all"));
  model.tool.on((now) =>
    TOOLS.forEach((tool, index) => {
      buttons[index]!.setAttribute("aria-checked", String(tool === now));
      buttons[index]!.tabIndex = tool === now ? 0 : -1;
      // On a narrow screen there are more tools than are seen.
      if (tool === now && root.scrollWidth > root.clientWidth) buttons[index]!.scrollIntoView({ block: "nearest", inline: "nearest" });
    }),
  );
  return root;
}
