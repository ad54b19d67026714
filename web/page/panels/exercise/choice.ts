import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import type { ExerciseOptions, Kind } from "../../engine/types.ts";
import { language } from "../../words.ts";
import { say } from "./words.ts";

/** What is chosen: the kind (empty for the open scene), seed, number, and how it is written. */
export interface Choice {
  kind: string;
  seed: number;
  number: number;
  options: ExerciseOptions;
}

/** Largest seed: up to here every whole number is exact in JavaScript. */
const MOST = Number.MAX_SAFE_INTEGER;
const PAGES = ["a4-landscape", "a4-portrait", "a3-landscape", "a3-portrait"];

/** The fields that choose an exercise. */
export function choice(changed: () => void): { root: HTMLElement; now(): Choice; build(kinds: Kind[], own: string): void } {
  const kind = element("select");
  const seed = number("0", "1");
  const count = number("1", "1");
  const page = element("select");
  const back = stepper("back", -1);
  const forward = stepper("forward", 1);
  kind.onchange = page.onchange = changed;
  seed.onchange = () => {
    count.value = "1";
    changed();
  };
  count.onchange = changed;

  function number(least: string, value: string): HTMLInputElement {
    const made = element("input", { type: "number", min: least, step: "1", inputmode: "numeric" });
    made.value = value;
    return made;
  }

  function whole(input: HTMLInputElement, least: number, most: number): number {
    const value = Math.round(Number(input.value));
    return Number.isFinite(value) ? Math.min(most, Math.max(least, value)) : least;
  }

  function stepper(name: "back" | "forward", by: number): HTMLButtonElement {
    const made = element("button", { type: "button" }, icon(name));
    made.onclick = () => {
      count.value = String(Math.max(1, whole(count, 1, 1000) + by));
      back.disabled = count.value === "1";
      changed();
    };
    return made;
  }

  const labels: { name: "kind" | "seed" | "number" | "page"; text: HTMLElement }[] = [];
  const labelled = (name: "kind" | "seed" | "number" | "page", field: HTMLElement): HTMLElement => {
    const text = element("span");
    labels.push({ name, text });
    return element("label", { class: `for-${name}` }, text, field);
  };
  const variant = element("div", { class: "variant" }, back, labelled("number", count), forward);
  const root = element("div", { class: "choice" }, labelled("kind", kind), labelled("seed", seed), variant, labelled("page", page));

  return {
    root,
    now() {
      const options = { page: page.value === "" ? null : page.value, language: kind.value === "" ? null : language.value, notation: null, decimal: null };
      back.disabled = count.value === "1";
      return { kind: kind.value, seed: whole(seed, 0, MOST), number: whole(count, 1, 1000), options };
    },
    build(kinds, own) {
      for (const { name, text } of labels) text.textContent = say(name);
      for (const [button, name] of [[back, "back"], [forward, "forward"]] as const) {
        button.setAttribute("aria-label", say(name));
        button.title = say(name);
      }
      const [chosen, paper] = [kind.value, page.value];
      kind.replaceChildren(new Option(say("own", { title: own }), ""), ...kinds.map(({ name, title }) => new Option(title === "" ? name : title, name)));
      kind.value = chosen;
      const named = (value: string): string => {
        const [size = "", way] = value.split("-");
        return say("page_name", { size: size.toUpperCase(), way: say(way === "portrait" ? "portrait" : "landscape") });
      };
      page.replaceChildren(new Option(say("page_auto"), ""), ...PAGES.map((value) => new Option(named(value), value)));
      page.value = paper;
    },
  };
}
