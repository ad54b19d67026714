import { stepFor } from "../../number.ts";
import type { Button, Field, Row } from "../parts/form.ts";
import { at, isDrawn, sizeOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { say } from "./words.ts";

/** Whether a drive pushes along a guide. */
function isSlidingDrive(drive: unknown): boolean {
  return ["position", "speed", "acceleration"].some((key) => at(drive, [key]) !== undefined);
}

/** Where a drive stands and how fast it is, in the line of what it drives; nothing where there is none. */
export function lineOfDrive(scene: Draft, path: Path): Row[] {
  const drive = at(scene, path);
  if (drive === undefined) return [];
  return [{ label: say("drive"), quiet: true, path, fields: isSlidingDrive(drive) ? pushing(scene, path) : turning(scene, path) }];
}

/** Its acceleration, and what takes it away; `name` is that of what it drives. */
export function restOfDrive(scene: Draft, path: Path, name: string): Row {
  const { acceleration, alpha } = unitsOf(scene);
  const own = isSlidingDrive(at(scene, path)) ? { path: [...path, "acceleration"], unit: acceleration, step: stepFor(sizeOf(scene)) } : { path: [...path, "alpha"], unit: alpha, step: 1 };
  const remove: Button = { text: say("drop_drive", { name }), icon: "remove", edits: [{ remove: path }] };
  return { label: say("drive"), path, fields: [{ kind: "number", ...own, label: say("acceleration"), usual: "0" }], buttons: [remove] };
}

function turning(scene: Draft, path: Path): Field[] {
  const inTurns = at(scene, [...path, "rpm"]) !== undefined;
  const angle: Field = { kind: "number", path: [...path, "angle"], label: say("angle"), symbol: "∠", unit: "°", step: 1, usual: "–" };
  const speed: Field = { kind: "number", path: [...path, inTurns ? "rpm" : "omega"], label: say("speed"), symbol: inTurns ? "n" : "ω", unit: "", means: inTurns ? "rpm" : unitsOf(scene).omega, step: inTurns ? 5 : 0.5, needed: true };
  const unit: Field = {
    kind: "choice",
    path: [...path, "rpm"],
    label: say("turns"),
    quiet: true,
    options: [
      { text: unitsOf(scene).omega, ask: { do: "omega", with: path.map(String) } },
      { text: "1/min", any: "number", ask: { do: "rpm", with: path.map(String) } },
    ],
  };
  return isDrawn(scene) ? [speed, unit] : [angle, speed, unit];
}

function pushing(scene: Draft, path: Path): Field[] {
  const { length, velocity } = unitsOf(scene);
  const step = stepFor(sizeOf(scene));
  const position: Field = { kind: "number", path: [...path, "position"], label: say("position"), unit: length, step, usual: "–" };
  const speed: Field = { kind: "number", path: [...path, "speed"], label: say("speed"), symbol: "v", unit: velocity, step, needed: true };
  return isDrawn(scene) ? [speed] : [position, speed];
}
