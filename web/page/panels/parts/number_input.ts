import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { evaluated, shownNumber, stepped } from "../../number.ts";
import { edit } from "./edits.ts";
import { labelled, newId, put, type Live } from "./fields.ts";
import type { NumberField } from "./form.ts";
import { pinButton } from "./pin.ts";
import { at } from "./scene.ts";
import { say } from "./words.ts";

/** How many steps a key goes. */
const KEYS: Record<string, number> = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/**
 * A field for a number. Typing changes the scene at once, as far as it is a number; arrow keys and the wheel go by steps. What is typed
 * while it has the focus is one entry of undo.
 */
export function numberInput(app: App, field: NumberField): Live {
  const { path, unit, step } = field;
  const input = element("input", {
    type: "text",
    inputmode: "decimal",
    class: "number",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: field.usual ?? (field.needed === true ? "?" : null),
  });
  const why = element("p", { class: "why", role: "alert", id: newId(), hidden: true });
  let gesture = newId();
  let given: number | undefined;
  let comma = false;

  const refuse = (message: string | null): void => {
    input.classList.toggle("unread", message !== null);
    why.textContent = message ?? "";
    why.hidden = message === null;
    if (message === null) input.removeAttribute("aria-describedby");
    else input.setAttribute("aria-describedby", why.id);
  };
  const take = (value: number | undefined): void => {
    refuse(null);
    if (value === given) return;
    given = value;
    void edit(app, [put(path, value)], gesture);
  };
  const read = (): void => {
    const text = input.value.trim();
    const value = evaluated(text, unit);
    if (text === "") field.needed === true ? refuse(say("needed")) : take(undefined);
    else if (value === null) refuse(say("unread"));
    else if (field.least !== undefined && value < field.least) refuse(say("least", { least: field.least }));
    else take(value);
  };
  const go = (steps: number): void => {
    const next = stepped(evaluated(input.value, unit) ?? given ?? 0, step, steps);
    const value = Math.max(next, field.least ?? -Infinity);
    input.value = shownNumber(value, comma);
    take(value);
  };
  const revert = (): void => {
    input.value = given === undefined ? "" : shownNumber(given, comma);
    refuse(null);
  };

  input.addEventListener("focus", () => (gesture = newId()));
  input.addEventListener("input", read);
  input.addEventListener("blur", () => input.classList.contains("unread") || revert());
  input.addEventListener("keydown", (event) => {
    const steps = (KEYS[event.key] ?? 0) * (event.shiftKey ? 10 : 1) * (event.altKey ? 0.1 : 1);
    if (steps !== 0) go(steps);
    else if (event.key === "Enter") revert(), input.select(), (gesture = newId());
    else if (event.key === "Escape" && input.classList.contains("unread")) revert();
    else return;
    event.preventDefault();
  });
  // Only over the field that has the focus: else a page that is scrolled would change numbers.
  input.addEventListener("wheel", (event) => {
    if (document.activeElement !== input || event.deltaY === 0) return;
    event.preventDefault();
    go(event.deltaY < 0 ? 1 : -1);
  }, { passive: false });

  const root = labelled(field, input, element("span", { class: "unit" }, unit), ...(field.pin === undefined ? [] : [pinButton(app, field.pin)]));
  root.append(why);
  return {
    root,
    show(scene) {
      const value = at(scene, path);
      const next = typeof value === "number" ? value : undefined;
      const mark = at(scene, ["figure", "decimal"]) === "comma";
      const stays = next === given && mark === comma && (document.activeElement === input || input.classList.contains("unread"));
      comma = mark;
      if (stays) return;
      given = next;
      // What is being typed stays as it is typed.
      if (document.activeElement === input && next !== undefined && evaluated(input.value, unit) === next) return;
      revert();
    },
  };
}
