import { element } from "../../dom/element.ts";
import type { Form, PlanPoint } from "../../engine/types.ts";
import { called, DRAWN_ON, scaleOf, type Sheet } from "../../sheets.ts";
import { type FormFile, type Place, placesOf, withPlace } from "./form.ts";
import { planSheet } from "./plan_sheet.ts";
import { pointList } from "./point_list.ts";
import { say } from "./words.ts";

type Change = (how: (file: FormFile) => FormFile, gesture: string) => void;

/** Places of plan points, marked on a sheet of squared paper or typed. */
export function pointsPart(change: Change, left: () => void, present: () => FormFile): { root: HTMLElement; build(form: Form): void; show(file: FormFile): void } {
  const root = element("details", { class: "points" });
  let points: Form["points"] = {};
  let plan: Sheet = DRAWN_ON[0]!;
  let chosen = "";
  /** What has been placed last, in words. */
  let placed = "";

  const put = (name: string, at: Place | null, gesture: string): void => change((file) => withPlace(file, plan, name, at), gesture);
  const pointsOf = (sheet: Sheet): PlanPoint[] => points[sheet] ?? [];
  const here = (): PlanPoint[] => pointsOf(plan);
  const named = (name: string): PlanPoint => here().find((point) => point.name === name) ?? { name, label: name };

  /** The first point without a place after this one, else the first of all. */
  function next(after: string): string {
    const places = placesOf(present(), plan);
    const names = here().map((point) => point.name);
    const from = names.indexOf(after) + 1;
    return [...names.slice(from), ...names.slice(0, from)].find((name) => places[name] === undefined) ?? "";
  }

  const sheet = planSheet({
    placed(at) {
      const name = chosen;
      if (name === "") return;
      put(name, at, `place ${name}`);
      left();
      placed = say("placed", { name: named(name).label, x: at[0], y: at[1] });
      chosen = next(name);
      show(present());
    },
    dragged: (name, at, isOver) => {
      put(name, at, `drag ${name}`);
      if (isOver) left();
    },
  });
  const list = pointList({
    choose(name) {
      chosen = name;
      show(present());
      sheet.focus();
    },
    typed: (name, at) => put(name, at, `type ${name}`),
    left,
    remove(name) {
      put(name, null, `remove ${name}`);
      left();
      chosen = name;
      show(present());
    },
  });
  const summary = element("summary");
  const intro = element("p", { class: "quiet" });
  const choice = element("fieldset", { class: "plans" });
  const status = element("p", { class: "chosen", role: "status" });
  root.append(summary, intro, choice, status, sheet.root, list.root);

  function planButton(name: Sheet): HTMLElement {
    const input = element("input", { type: "radio", name: "check-plan", value: name });
    input.checked = name === plan;
    input.onchange = () => {
      plan = name;
      chosen = next("");
      show(present());
    };
    return element("label", {}, input, element("span", {}, called(name, "title")));
  }

  function show(file: FormFile): void {
    const places = placesOf(file, plan);
    const mu = file[scaleOf(plan)];
    if (chosen !== "" && !here().some((point) => point.name === chosen)) chosen = next("");
    const now = mu === undefined ? say("scale_first") : chosen === "" ? say("all_placed") : say("chosen", { name: named(chosen).label });
    // Words of the page and labels of the engine; names that stand in a file alone are never chosen.
    status.innerHTML = placed === "" ? now : `<small>${placed}</small><br>${now}`;
    // A sheet that nobody sees is not drawn: a plan may have thousands of points.
    if (!root.open) return;
    sheet.show(here(), places, chosen);
    list.show(here(), places, chosen);
  }
  root.addEventListener("toggle", () => root.open && show(present()));

  return {
    root,
    build(form) {
      points = form.points;
      const present = DRAWN_ON.filter((sheet) => pointsOf(sheet).length > 1);
      root.hidden = present.length === 0;
      summary.textContent = say("by_points");
      intro.textContent = say("points_intro");
      if (!present.includes(plan)) plan = present[0] ?? DRAWN_ON[0]!;
      choice.replaceChildren(
        element("legend", {}, say("plan")),
        ...present.map(planButton),
      );
      chosen = next("");
      placed = "";
    },
    show,
  };
}
