import type { Shown } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import type { Handle } from "../engine/types.ts";
import { name } from "../layout/say.ts";
import { say } from "../layout/words.ts";
import { language } from "../words.ts";
import type { Box, Viewport } from "../look/viewport.ts";

/** A joint as an element over the picture, which a hand or the keyboard takes. */
export interface Grip {
  readonly button: HTMLButtonElement;
  handle: Handle;
}

const isIn = (box: Box | null, [x, y]: readonly [number, number]): boolean =>
  box === null || (x >= box[0] && y >= box[1] && x <= box[0] + box[2] && y <= box[1] + box[3]);

/** The joints over the picture. An element stays while its joint does, so that focus and a finger stay on it. */
export function handles(app: Shown, view: Viewport, made: (grip: Grip) => void): void {
  const layer = byId("handles", app.root);
  const grips = new Map<string, Grip>();

  function label({ button, handle }: Grip): void {
    name(button, say(handle.is_fixed ? "fixed_joint" : "joint", { name: handle.name }));
    button.title = "";
    button.setAttribute("aria-description", say("joint_hint"));
  }

  function grip(handle: Handle): Grip {
    const button = element("button", { type: "button", class: "handle", "data-point": handle.name, id: `handle-${handle.name}` });
    const made_ = { button, handle };
    label(made_);
    grips.set(handle.name, made_);
    layer.append(button);
    made(made_);
    return made_;
  }

  function place(): void {
    for (const { button, handle } of grips.values()) {
      const [x, y] = view.toPane(handle.at);
      button.hidden = !isIn(view.alone(), handle.at) && !button.matches(".pulled");
      button.style.transform = `translate(${x}px, ${y}px)`;
    }
  }

  function draw(): void {
    const shown = (app.picture.value?.handles ?? []).filter(({ is_fixed }) => app.shaping.value || !is_fixed);
    const names = new Set(shown.map(({ name }) => name));
    for (const [key, { button }] of grips)
      if (!names.has(key)) {
        button.remove();
        grips.delete(key);
      }
    const pinned = new Set(app.pins.value.points);
    for (const handle of shown) {
      const own = grips.get(handle.name) ?? grip(handle);
      own.handle = handle;
      own.button.classList.toggle("fixed", handle.is_fixed);
      own.button.classList.toggle("pinned", app.shaping.value && pinned.has(handle.name));
    }
    place();
  }

  app.picture.on(draw);
  app.shaping.on(draw);
  app.pins.on(draw);
  view.now.on(place);
  language.on(() => grips.forEach(label));
  app.solved.on(({ refused }) => layer.toggleAttribute("inert", refused !== null));
}
