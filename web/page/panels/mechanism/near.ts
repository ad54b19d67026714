import { stepFor } from "../../number.ts";
import type { Field, Group, Row } from "../parts/form.ts";
import { allPoints, entries, groundOf, linksOf, pointsOn, sizeOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { placeFields } from "./vector.ts";
import { say } from "./words.ts";

/** Rough places, which choose the assembly mode. */
export function near(scene: Draft): Group {
  const given = entries(scene["near"]);
  const add: Field = { kind: "adder", path: ["near", "+"], label: say("add_near"), text: say("add_near"), ask: { do: "near", with: [] }, lists: [{ label: say("add_near"), options: open }] };
  return {
    id: "near",
    title: say("near"),
    help: say("near_help"),
    path: ["near"],
    folded: true,
    rows: [...given.map(([name, value]) => row(scene, name, value)), ...(open(scene).length === 0 ? [] : [{ fields: [add] }])],
  };
}

/** What no rough place is given of. */
function open(scene: Draft): { value: string; text: string }[] {
  const has = new Set([...groundOf(scene), ...entries(scene["near"]).map(([name]) => name)]);
  const points = allPoints(scene).filter((name) => !has.has(name));
  const angles = linksOf(scene).filter((name) => pointsOn(scene, name).length > 0 && !has.has(`angle(${name})`));
  return [...points.map((value) => ({ value, text: value })), ...angles.map((name) => ({ value: `angle(${name})`, text: say("angle_of", { name }) }))];
}

function row(scene: Draft, name: string, value: unknown): Row {
  const path: Path = ["near", name];
  const fields: Field[] = Array.isArray(value)
    ? placeFields(path, unitsOf(scene).length, stepFor(sizeOf(scene)))
    : [{ kind: "number", path, label: "∠", unit: "°", step: 1, needed: true }];
  return { label: name, path, fields, buttons: [{ text: say("drop_near", { name }), icon: "remove", edits: [{ remove: path }] }] };
}
