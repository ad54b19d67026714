/** The small menu of a joint or a link: by the right button, a finger that rests, or the key for menus. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { groundOf } from "../panels/parts/scene.ts";
import { copyChosen, isChosen, only, paste, removeChosen, reveal } from "./acting.ts";
import type { Model } from "./model.ts";
import type { Pixels } from "./sight.ts";
import { pressed, type Press } from "./tools.ts";
import { say } from "./words.ts";

export interface Menu {
  root: HTMLElement;
  open(press: Press, at: Pixels): void;
}

/** `back` gives the focus back to the stage. */
export function menu(app: App, model: Model, back: () => void): Menu {
  const root = element("div", { class: "build-menu", popover: "manual", role: "menu" });
  // Not dismissed by itself: a finger that opens it by resting is lifted outside it.
  document.addEventListener("pointerdown", ({ target }) => root.matches(":popover-open") && !root.contains(target as Node) && root.hidePopover(), { capture: true });

  function entry(text: string, act: () => void, stays = false): HTMLButtonElement {
    const button = element("button", { type: "button", role: "menuitem", class: "entry" }, text);
    button.onclick = () => {
      if (!stays) root.hidePopover();
      if (!stays) back();
      act();
    };
    return button;
  }

  /** The entry becomes a box for the name. */
  function rename(press: Press): void {
    const from = press.point ?? press.link!;
    const input = element("input", { type: "text", value: from, "aria-label": say("rename"), class: "name", spellcheck: "false", autocomplete: "off" });
    input.onkeydown = (event) => {
      event.stopPropagation();
      if (event.key !== "Enter") return;
      const to = input.value.trim();
      root.hidePopover();
      back();
      if (to !== "" && to !== from) void model.make([{ rename: press.point !== null ? "point" : "link", from, to }]);
    };
    root.replaceChildren(element("label", { class: "entry" }, say("rename"), input));
    input.select();
    input.focus();
  }

  const act = (tool: "fixed" | "drive", press: Press): void => {
    const there = model.present();
    if (there !== null) void model.make(pressed(tool, there, press));
  };

  function entries(press: Press): HTMLElement[] {
    const { point, link } = press;
    if (point === null && link === null) {
      return model.copied === null ? [entry(say("fit"), () => model.fit())] : [entry(say("paste"), () => void paste(model)), entry(say("fit"), () => model.fit())];
    }
    const isFixed = groundOf(model.present()?.scene ?? {}).includes(point ?? "");
    return [
      entry(say("numbers"), () => reveal(app, press, true)),
      entry(`${say("rename")}…`, () => rename(press), true),
      ...(point !== null ? [entry(say(isFixed ? "free_it" : "fix_it"), () => act("fixed", press))] : []),
      ...(link !== null ? [entry(say("drive_it"), () => act("drive", { ...press, point: null }))] : []),
      entry(say("copy"), () => copyChosen(model)),
      entry(say("remove"), () => void removeChosen(app, model)),
    ];
  }

  root.addEventListener("keydown", (event) => {
    const all = [...root.querySelectorAll("button")];
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    event.stopPropagation();
    if (event.key === "Escape") {
      root.hidePopover();
      back();
    }
    if (by === undefined) return;
    event.preventDefault();
    all[(all.indexOf(document.activeElement as HTMLButtonElement) + by + all.length) % all.length]?.focus();
  });

  return {
    root,
    open(press, [x, y]) {
      if (!isChosen(model.chosen.value, press)) model.chosen.set(only(press));
      root.replaceChildren(...entries(press));
      const { left, top } = root.parentElement!.querySelector("#build-stage")!.getBoundingClientRect();
      root.showPopover();
      const { offsetWidth, offsetHeight } = root;
      root.style.left = `${Math.max(4, Math.min(left + x, innerWidth - offsetWidth - 4))}px`;
      root.style.top = `${Math.max(4, Math.min(top + y, innerHeight - offsetHeight - 4))}px`;
      root.querySelector("button")?.focus();
    },
  };
}
