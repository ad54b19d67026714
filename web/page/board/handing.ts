/** What is asked before a drawing is handed in: whose it is; and it is said how much is drawn, and what becomes of it. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { formFile } from "../panels/check/form.ts";
import { standing } from "./file.ts";
import type { Judging } from "./judging.ts";
import type { Model } from "./model.ts";
import { say } from "./words.ts";

export function handing(app: App, model: Model, judging: Judging): { root: HTMLDialogElement; ask(): void } {
  const root = element("dialog", { class: "handing", "aria-labelledby": "board-handing-title" });
  root.onclick = (event) => void (event.target === root && root.close());

  function ask(): void {
    const count = standing(model.drawing().did).length;
    const name = element("input", { type: "text", id: "board-hand-in-name", autocomplete: "name", maxlength: "200" });
    name.value = formFile(app.history.now.value.form)?.name ?? model.drawing().name ?? "";
    const what = element("p", { class: "quiet" });
    name.oninput = () => void (what.textContent = say("hand_in_what", { file: judging.fileOf(name.value) }));
    name.dispatchEvent(new Event("input"));
    const send = (event: Event): void => {
      event.preventDefault();
      root.close();
      void judging.handIn(name.value.trim());
    };
    const form = element(
      "form",
      { onsubmit: send },
      element("h2", { id: "board-handing-title" }, say("hand_in")),
      element("p", { class: count === 0 ? "bad" : "" }, count === 0 ? say("list_none") : say("hand_in_drawn", { count })),
      element("label", {}, element("span", {}, say("hand_in_name")), name),
      what,
      element("div", { class: "foot" }, element("button", { type: "button", onclick: () => root.close() }, say("end_replay")), element("button", { type: "submit", id: "board-hand-in-now", class: "main" }, say("hand_in"))),
    );
    root.replaceChildren(form);
    root.showModal();
    if (count === 0) root.querySelector<HTMLElement>(".foot button")?.focus();
  }
  return { root, ask };
}
