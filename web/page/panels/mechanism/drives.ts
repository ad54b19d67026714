import { stepFor } from "../../number.ts";
import type { Button, Field, Row } from "../parts/form.ts";
import { at, isDrawn, sizeOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { say } from "./words.ts";

/** Whether a drive pushes along a guide. */
export function isSlidingDrive(drive: unknown): boolean {
  return ["position", "speed", "acceleration"].some((key) => at(drive, [key]) !== undefined);
}

/** The rows of a drive that turns a link. */
export function driveRows(scene: Draft, path: Path, remove: Button): Row[] {
  const { omega, alpha } = unitsOf(scene);
  const inTurns = at(scene, [...path, "rpm"]) !== undefined;
  const angle: Field = { kind: "number", path: [...path, "angle"], label: say("angle"), unit: "°", step: 1, usual: "–" };
  const speed: Field = { kind: "number", path: [...path, inTurns ? "rpm" : "omega"], label: say("speed"), unit: "", step: inTurns ? 5 : 0.5, needed: true };
  const unit: Field = {
    kind: "choice",
    path: [...path, "rpm"],
    label: say("turns"),
    quiet: true,
    options: [
      { text: omega, ask: { do: "omega", with: path.map(String) } },
      { text: "1/min", any: "number", ask: { do: "rpm", with: path.map(String) } },
    ],
  };
  const acceleration: Field = { kind: "number", path: [...path, "alpha"], label: say("acceleration"), unit: alpha, step: 1, usual: "0" };
  const fields = [speed, unit, acceleration];
  return [{ label: say("drive"), titled: true, path, fields: isDrawn(scene) ? fields : [angle, ...fields], buttons: [remove] }];
}

/** The fields of a drive that pushes along a guide. */
export function slidingDriveFields(scene: Draft, path: Path): Field[] {
  const { length, velocity, acceleration } = unitsOf(scene);
  const step = stepFor(sizeOf(scene));
  const position: Field = { kind: "number", path: [...path, "position"], label: say("position"), unit: length, step, usual: "–" };
  const rates: Field[] = [
    { kind: "number", path: [...path, "speed"], label: say("speed"), unit: velocity, step, needed: true },
    { kind: "number", path: [...path, "acceleration"], label: say("acceleration"), unit: acceleration, step, usual: "0" },
  ];
  return isDrawn(scene) ? rates : [position, ...rates];
}
