import { stepFor } from "../../number.ts";
import type { Adder, Button, Field, Group, Row } from "../parts/form.ts";
import { allPoints, at, entries, groundOf, pointsOf, sizeOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { restOfDrive } from "./drives.ts";
import { placeFields, vectorFields, vectorForm } from "./vector.ts";
import { say } from "./words.ts";

/** The points of a drawn scene. */
export function drawnPoints(scene: Draft): Group {
  const fixed = groundOf(scene);
  const step = stepFor(sizeOf(scene));
  return {
    id: "points",
    title: say("drawn_points"),
    help: say("drawn_help"),
    path: ["points"],
    rows: entries(scene["points"]).map(([name]): Row => ({
      path: ["points", name],
      name: { of: "point", name, label: say("point_name", { name }) },
      fields: [...vectorFields(scene, ["points", name], unitsOf(scene).length, step), isFixed(name, fixed)],
      buttons: [{ text: say("no_longer_there", { name }), icon: "remove", edits: [{ drop_point: name }] }],
    })),
  };
}

/** Whether a point of a drawn scene is on the ground. */
function isFixed(name: string, fixed: string[]): Field {
  const others = fixed.filter((other) => other !== name);
  const without = others.length === 0 ? { remove: ["ground"] } : { set: ["ground"], value: others };
  const options = [
    { value: others.length === 0 ? undefined : others, text: say("moving"), edits: [without] },
    { value: fixed, text: say("fixed"), edits: [{ set: ["ground"], value: [...others, name] }] },
  ];
  return { kind: "choice", path: ["ground"], label: say("fixed"), quiet: true, options: fixed.includes(name) ? options : [{ ...options[0]!, value: fixed.length === 0 ? undefined : fixed }, { ...options[1]!, value: [...others, name] }] };
}

/** The known motions of points. */
export function known(scene: Draft): Group {
  const given = entries(scene["known"]).map(([name]) => name);
  const others = (now: Draft): string[] => {
    const has = new Set([...entries(now["known"]).map(([name]) => name), ...groundOf(now)]);
    return allPoints(now).filter((name) => !has.has(name));
  };
  const adder: Adder = {
    kind: "adder",
    path: ["known", "+"],
    label: say("add_known"),
    text: say("add_known"),
    ask: { do: "known", with: [] },
    lists: [{ label: say("points"), options: (now) => others(now).map((value) => ({ value, text: value })) }],
  };
  return {
    id: "known",
    title: say("known"),
    help: say("known_help"),
    path: ["known"],
    cards: given.map((name) => ({
      path: ["known", name],
      title: name,
      line: () => rates(scene, ["known", name]).slice(0, 1).map((row) => ({ ...row, titled: false })),
      rows: () => rates(scene, ["known", name]).slice(1),
      buttons: [{ text: say("drop_known", { name }), icon: "remove", edits: [{ remove: ["known", name] }] }],
    })),
    ...(others(scene).length === 0 ? {} : { adder }),
  };
}

/** Velocity and acceleration, each in the form in which it is given. */
function rates(scene: Draft, path: Path): Row[] {
  const units = unitsOf(scene);
  const velocity: Path = [...path, "velocity"];
  const acceleration: Path = [...path, "acceleration"];
  const step = stepFor(sizeOf(scene));
  const first: Row = { label: say("velocity"), titled: true, path: velocity, fields: [...vectorFields(scene, velocity, units.velocity, step), vectorForm(velocity, say("velocity"))] };
  const isGiven = at(scene, acceleration) !== undefined;
  const add: Button = { text: say("add_acceleration"), icon: "plus", edits: [{ set: acceleration, value: [0, 0] }] };
  if (!isGiven) return [first, { fields: [], buttons: [add] }];
  const remove: Button = { text: say("drop_acceleration"), icon: "remove", edits: [{ remove: acceleration }] };
  const fields = [...vectorFields(scene, acceleration, units.acceleration, 10 * step), vectorForm(acceleration, say("acceleration"))];
  return [first, { label: say("acceleration"), titled: true, path: acceleration, fields, buttons: [remove] }];
}

/** Drive or known motion of a link of a drawn scene. */
export function motionRows(scene: Draft, name: string): Row[] {
  const path: Path = ["links", name];
  const drive = at(scene, [...path, "drive"]);
  const points = pointsOf(at(scene, path));
  if (drive !== undefined) return [restOfDrive(scene, [...path, "drive"], name)];
  const motion: Path = [...path, "motion"];
  if (at(scene, motion) !== undefined) return motionFields(scene, motion, points, name);
  const buttons: Button[] = [];
  if (points.filter((point) => groundOf(scene).includes(point)).length === 1) buttons.push({ text: say("drive_it"), icon: "plus", ask: { do: "drive", with: [name] } });
  if (points.length > 1) buttons.push({ text: say("known_motion"), icon: "plus", ask: { do: "motion", with: [name] } });
  return buttons.length === 0 ? [] : [{ fields: [], buttons }];
}

function motionFields(scene: Draft, path: Path, points: string[], name: string): Row[] {
  const { length, omega, alpha } = unitsOf(scene);
  const isPlace = Array.isArray(at(scene, [...path, "at"]));
  const remove: Button = { text: say("drop_motion", { name }), icon: "remove", edits: [{ remove: path }] };
  const where: Field[] = isPlace
    ? placeFields([...path, "at"], length, stepFor(sizeOf(scene)))
    : [{ kind: "choice", path: [...path, "at"], label: say("at"), options: points.map((value) => ({ value, text: value })) }];
  const turning: Field[] = [
    { kind: "number", path: [...path, "omega"], label: "ω", unit: omega, step: 0.5, usual: "0" },
    { kind: "number", path: [...path, "alpha"], label: "α", unit: alpha, step: 1, usual: "0" },
  ];
  return [{ label: say("known_motion"), titled: true, path, fields: [...where, ...turning], buttons: [remove] }, ...rates(scene, path)];
}
