import type { Field, Option } from "../parts/form.ts";
import { at, type Path } from "../parts/scene.ts";
import { say } from "./words.ts";


/** Fields of a vector: two components, or size and angle, as the scene gives it. */
export function vectorFields(scene: unknown, path: Path, unit: string, step: number): Field[] {
  const value = at(scene, path);
  if (typeof value === "object" && value !== null && !Array.isArray(value)) {
    return [
      { kind: "number", path: [...path, "size"], label: say("size"), unit, step, least: 0, needed: true },
      { kind: "number", path: [...path, "angle"], label: "∠", unit: "°", step: 1, needed: true },
    ];
  }
  return placeFields(path, unit, step);
}

/** Fields of two coordinates. */
export function placeFields(path: Path, unit: string, step: number): Field[] {
  return ["x", "y"].map((label, index) => ({ kind: "number", path: [...path, index], label, unit: index === 0 ? "" : unit, means: unit, step, needed: true }));
}

/** Whether a vector is given by its components or by size and angle. */
export function vectorForm(path: Path, label: string): Field {
  const to = (form: string): Option["ask"] => ({ do: form, with: path.map(String) });
  const options: Option[] = [
    { any: "list", text: say("by_parts"), ask: to("parts")! },
    { any: "object", text: say("by_size"), ask: to("size")! },
  ];
  return { kind: "choice", path, label, quiet: true, options };
}
