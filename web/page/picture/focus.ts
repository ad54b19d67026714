import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import type { Picture } from "../engine/types.ts";
import { say } from "../layout/words.ts";
import { called, PLANS, type Sheet } from "../sheets.ts";
import { language } from "../words.ts";
import type { Box, Viewport } from "../look/viewport.ts";

/** Which panel is shown large: on the screen it is laid out anew, of the paper it is cut out. */
export interface Focus {
  /** The panel at a place on the sheet; empty where none is. */
  at(mm: [number, number]): string;
  /** The next panel to the right or left, as a finger swipes. */
  swipe(by: 1 | -1): void;
}

export function focus(app: App, view: Viewport): Focus {
  const bar = byId("focus");
  let boxes = "";
  let wasSheet = false;

  const shown = (): Picture["panels"] => app.picture.value?.panels ?? [];
  /** The panels that there are to choose from; by a student's link there is one. */
  const panels = (): Sheet[] => app.view.value.panels ?? app.solved.value.opened?.panels ?? [];

  function fit(): void {
    const picture = app.picture.value;
    if (picture === null) return;
    const whole: Box = [0, 0, picture.width, picture.height];
    const alone = app.paper.value ? shown().find(({ key }) => key === app.focus.value) : undefined;
    view.fit(alone?.box ?? whole);
  }

  function choice(key: Sheet | "", text: string): HTMLButtonElement {
    const button = element("button", { type: "button", role: "radio", id: `focus-${key === "" ? "all" : key}`, "data-key": key }, text);
    button.onclick = () => {
      app.focus.set(key);
      fit();
    };
    return button;
  }

  function mark(): void {
    for (const button of bar.querySelectorAll("button")) {
      const is = button.dataset["key"] === app.focus.value;
      button.setAttribute("aria-checked", String(is));
      button.tabIndex = is ? 0 : -1;
    }
  }

  function build(): void {
    const all = panels();
    if (!all.some((key) => key === app.focus.value)) app.focus.set("");
    bar.replaceChildren(choice("", say("all")), ...all.map((key) => choice(key, called(key, "short"))));
    bar.hidden = all.length < 2;
    mark();
  }

  app.picture.on((picture) => {
    if (picture === null) return;
    const next = JSON.stringify([picture.width, picture.height, picture.panels.map(({ box }) => box)]);
    if (next === boxes) return;
    boxes = next;
    // A sheet that takes the place of the picture is shown whole, and so is the picture after it.
    const isSheet = picture.panels.length === 0;
    if (!view.isZoomed() || isSheet !== wasSheet) fit();
    wasSheet = isSheet;
  });
  app.solved.on(build);
  app.focus.on(mark);
  app.paper.on(fit);
  language.on(build);
  // Where one plan is large, it is that of the step.
  app.view.on(({ step, coarse }) => {
    if (bar.childElementCount - 1 !== panels().length) build();
    const { steps = [], passages = [] } = app.solved.value.opened ?? {};
    const number = step !== null && coarse ? passages[step - 1]?.[1] : step;
    const key = steps[(number ?? 0) - 1]?.panel;
    if (app.focus.value === "" || key === undefined || !panels().includes(key)) return;
    // Beside a plan there is the scheme.
    if (!PLANS.includes(key) && !app.paper.value) return;
    app.focus.set(key);
    fit();
  });

  return {
    at: ([x, y]) => shown().find(({ box: [left, top, width, height] }) => x >= left && x <= left + width && y >= top && y <= top + height)?.key ?? "",
    swipe(by) {
      const keys: (Sheet | "")[] = ["", ...panels()];
      const next = keys[keys.indexOf(app.focus.value) + by];
      if (next !== undefined) choose(next);
    },
  };
}

/** Chooses a panel, as its button does. */
export function choose(key: string): void {
  document.querySelector<HTMLButtonElement>(`#focus-${key === "" ? "all" : key}`)?.click();
}
