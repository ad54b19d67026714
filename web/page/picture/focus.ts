import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import type { Picture } from "../engine/types.ts";
import { say } from "../layout/words.ts";
import { signal, type Signal } from "../state/signal.ts";
import { called } from "../sheets.ts";
import { language } from "../words.ts";
import type { Box, Viewport } from "./viewport.ts";

/** Which panel of the sheet is shown large; empty for the whole sheet. */
export interface Focus {
  readonly on: Signal<string>;
  /** The panel at a place on the sheet; empty where none is. */
  at(mm: [number, number]): string;
  /** The next panel to the right or left, as a finger swipes. */
  swipe(by: 1 | -1): void;
}

/** Screens narrower than this show one panel at a time. */
const NARROW = 600;

export function focus(app: App, view: Viewport): Focus {
  const on = signal("");
  const bar = byId("focus");
  let names = "";
  let boxes = "";

  const panels = (): Picture["panels"] => app.picture.value?.panels ?? [];

  function fit(): void {
    const picture = app.picture.value;
    if (picture === null) return;
    const whole: Box = [0, 0, picture.width, picture.height];
    view.fit(panels().find(({ key }) => key === on.value)?.box ?? whole);
  }

  function choice(key: string, text: string): HTMLButtonElement {
    const button = element("button", { type: "button", role: "radio", id: `focus-${key === "" ? "all" : key}`, "data-key": key }, text);
    button.onclick = () => {
      on.set(key);
      fit();
    };
    return button;
  }

  function mark(): void {
    for (const button of bar.querySelectorAll("button")) {
      const is = button.dataset["key"] === on.value;
      button.setAttribute("aria-checked", String(is));
      button.tabIndex = is ? 0 : -1;
    }
  }

  function build(): void {
    const plain = panels().map(({ key }) => choice(key, called(key, "short")));
    bar.replaceChildren(choice("", say("all")), ...plain);
    bar.hidden = plain.length < 2;
    mark();
  }

  app.picture.on((picture) => {
    if (picture === null) return;
    const first = names === "";
    const nextNames = picture.panels.map(({ key, name }) => key + name).join();
    const nextBoxes = JSON.stringify([picture.width, picture.height, picture.panels.map(({ box }) => box)]);
    if (nextNames !== names) {
      names = nextNames;
      const narrow = first && view.size.width < NARROW && picture.panels.length > 1;
      if (narrow) on.set(picture.panels[0]?.key ?? "");
      if (!picture.panels.some(({ key }) => key === on.value)) on.set("");
      build();
    }
    if (nextBoxes !== boxes) {
      boxes = nextBoxes;
      if (!view.isZoomed()) fit();
    }
  });
  on.on(mark);
  // Where one panel is shown alone, it is that of the step.
  app.view.on(({ step, coarse }) => {
    const { steps = [], passages = [] } = app.solved.value.opened ?? {};
    const number = step !== null && coarse ? passages[step - 1]?.[1] : step;
    const key = steps[(number ?? 0) - 1]?.panel;
    if (on.value === "" || key === undefined || !panels().some((panel) => panel.key === key)) return;
    on.set(key);
    fit();
  });
  language.on(build);

  return {
    on,
    at: ([x, y]) => panels().find(({ box: [left, top, width, height] }) => x >= left && x <= left + width && y >= top && y <= top + height)?.key ?? "",
    swipe(by) {
      const keys: string[] = panels().map(({ key }) => key);
      const next = keys[keys.indexOf(on.value) + by];
      if (on.value === "" || next === undefined) return;
      on.set(next);
      fit();
    },
  };
}

/** Chooses a panel, as its button does. */
export function choose(key: string): void {
  document.querySelector<HTMLButtonElement>(`#focus-${key === "" ? "all" : key}`)?.click();
}
