import { element } from "../dom/element.ts";
import { icon } from "../dom/icon.ts";
import { language } from "../words.ts";
import { say, type Saying } from "./words.ts";

/** Sets pictograms and words of index.html, or of the component: `data-icon`, `data-say` (its text), `data-name` (its name for the mouse and for screen readers). */
export function sayAll(root: Document | ShadowRoot): void {
  for (const place of root.querySelectorAll<HTMLElement>("[data-icon]")) place.prepend(icon(place.dataset["icon"] ?? ""));
  for (const place of root.querySelectorAll<HTMLElement>("button[data-say]")) {
    place.append(element("span", { class: "text", "data-say": place.dataset["say"] }));
    delete place.dataset["say"];
  }
  // Those that are there now: what parts of the page make later may have names of another kind, as the board's numbers have.
  const marked = (key: "say" | "name"): [HTMLElement, Saying][] => [...root.querySelectorAll<HTMLElement>(`[data-${key}]`)].map((place) => [place, place.dataset[key] as Saying]);
  const [texts, names] = [marked("say"), marked("name")];
  language.on(() => {
    for (const [place, saying] of texts) place.textContent = say(saying);
    for (const [place, saying] of names) name(place, say(saying));
  });
}

/** Names a control; controls also show their name under the mouse. */
export function name(place: HTMLElement, text: string): void {
  place.setAttribute("aria-label", text);
  if (place.matches("button, select")) place.title = text;
}
