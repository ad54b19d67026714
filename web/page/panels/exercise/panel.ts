import type { App, Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Exercise, Kind } from "../../engine/types.ts";
import { fileName } from "../../files/save.ts";
import { isDark } from "../../layout/theme.ts";
import { forDark } from "../../picture/dark.ts";
import { instead } from "../../picture/instead.ts";
import { sheetElement } from "../../picture/sheet.ts";
import { said } from "../../refused.ts";
import { language } from "../../words.ts";
import { forStudents, forTeacher } from "./actions.ts";
import { choice } from "./choice.ts";
import { making, type Made } from "./making.ts";
import { say } from "./words.ts";

function mount(root: HTMLElement, app: App): void {
  root.classList.add("exercise-panel");
  const { made, make } = making(app);
  let kinds: Kind[] = [];
  const fields = choice(ask);
  const intro = element("p", { class: "quiet" });
  const status = element("span", { role: "status" });
  const sheet = element("div", { class: "sheet" });
  const large = instead(app, "exercise");
  const largeButton = element("button", { type: "button", class: "large" });
  largeButton.onclick = () => {
    const { exercise } = made.value;
    if (large.isShown.value) large.hide();
    else if (exercise !== null) large.show(exercise.sheets[0]!);
  };
  const actions = element("div", { class: "actions" });
  root.append(intro, fields.root, element("p", { class: "made" }, status, largeButton), sheet, actions);

  /** Asks for the exercise that the fields name, while the panel is seen. */
  function ask(): void {
    if (app.shown.value !== "exercise") return;
    const { kind, seed, number, options } = fields.now();
    const own = app.solved.value;
    const text = kind === "" ? own.good : (kinds.find(({ name }) => name === kind)?.text ?? "");
    if (text === "") return;
    const name = kind === "" ? fileName(own.opened?.title) : kind;
    make({ text, name, seed, number, options });
  }

  function picture(svg: string, prefix: string, name: string): SVGSVGElement {
    return sheetElement(isDark.value ? forDark(svg) : svg, prefix, name);
  }

  /** The key is drawn when somebody unfolds it. */
  function keyOf(exercise: Exercise): HTMLElement {
    const place = element("div", { class: "sheet" });
    const details = element("details", {}, element("summary", {}, say("show_key")), place);
    details.ontoggle = () => {
      if (details.open) place.replaceChildren(picture(exercise.key.svg, "exercise-key", say("key_of", { name: exercise.name })));
    };
    return details;
  }

  function show({ exercise, wanted, refused, isMaking }: Made): void {
    status.textContent = isMaking ? say("making") : refused !== null ? said(refused) : (exercise?.name ?? "");
    status.classList.toggle("bad", refused !== null && !isMaking);
    sheet.classList.toggle("busy", isMaking);
    largeButton.hidden = exercise === null;
    if (isMaking) return;
    if (exercise === null || wanted === null) {
      sheet.replaceChildren();
      actions.replaceChildren();
      return;
    }
    sheet.replaceChildren(picture(exercise.sheets[0]!.svg, "exercise-sheet", say("sheet_of", { name: exercise.name })));
    if (large.isShown.value) large.show(exercise.sheets[0]!);
    actions.replaceChildren(forStudents(app, { exercise, wanted }), forTeacher(app, { exercise, wanted }, keyOf(exercise)));
  }

  function build(): void {
    intro.textContent = say("intro");
    largeButton.textContent = say(large.isShown.value ? "small" : "large");
    fields.build(kinds, app.solved.value.opened?.title ?? "");
  }

  made.on(show);
  large.isShown.on((is) => {
    largeButton.textContent = say(is ? "small" : "large");
    largeButton.setAttribute("aria-pressed", String(is));
  });
  isDark.on(() => show(made.value));
  language.on(() => {
    build();
    show(made.value);
    ask();
  });
  app.solved.on(() => {
    build();
    if (fields.now().kind === "") ask();
  });
  app.shown.on(ask);
  void app.engine.kinds().then((all) => {
    kinds = all;
    build();
  });
}

export const exercisePanel: Panel = { id: "exercise", title: () => say("panel_title"), mount };
