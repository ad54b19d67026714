import { SHEETS, type Form } from "../../engine/types.ts";
import { called, scaleOf, type Sheet } from "../../sheets.ts";
import type { Button, Group, Row } from "../parts/form.ts";
import { at, LATER, unitOn, unitsOf, type Draft } from "../parts/scene.ts";
import { say } from "./words.ts";

/** By sheet: units per mm of paper; null where there is none. */
export type Scales = Form["scales"];

/** The scales: given, or automatic with the present one to hold. */
export function scales(scene: Draft, present: Scales): Group {
  const units = unitsOf(scene);
  return {
    id: "scales",
    title: say("scales"),
    help: say("scales_help"),
    rows: [
      ...SHEETS.filter(({ key }) => !LATER.includes(key) || key in present).map(({ key }) => scale(scene, key, unitOn(units, key), present[key] ?? null)),
      {
        fields: [
          {
            kind: "choice",
            path: ["figure", "scales"],
            label: say("scales_for"),
            options: [{ text: say("position") }, { value: "sheet", text: say("sheet") }, { value: "cycle", text: say("cycle") }],
          },
        ],
      },
    ],
  };
}

function scale(scene: Draft, sheet: Sheet, unit: string, present: number | null): Row {
  const key = scaleOf(sheet);
  const path = ["figure", key];
  const isHeld = at(scene, path) !== undefined;
  const hold: Button[] = present === null ? [] : [{ text: say("take", { value: present }), icon: "pin", pressed: false, edits: [{ set: path, value: present }] }];
  const buttons: Button[] = isHeld ? [{ text: say("as_before"), icon: "pin", pressed: true, edits: [{ remove: path }] }] : hold;
  const per = unit.includes("/") ? `(${unit})/mm` : `${unit}/mm`;
  const usual = present === null ? say("automatic") : String(present);
  const step = (present ?? 1) / 10;
  return { label: called(sheet, "scaled"), aligned: true, path, fields: [{ kind: "number", path, label: key.replace("mu_", "µ"), quiet: true, unit: per, step: roundStep(step), least: 0, usual }], buttons };
}

/** A step of 1 before zeros. */
function roundStep(step: number): number {
  return 10 ** Math.floor(Math.log10(step));
}
