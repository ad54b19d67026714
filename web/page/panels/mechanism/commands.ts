/** What the form's buttons do besides plain changes of one value. */
import type { App } from "../../app.ts";
import { placesIn, type Places } from "../../build/hit.ts";
import type { Drafted, Edit } from "../../engine/types.ts";
import { edit } from "../parts/edits.ts";
import type { Ask } from "../parts/form.ts";
import { at, entries, groundOf, isDrawn, linksOf, parsed, pointsOf, pointsOn, type Path, type Draft } from "../parts/scene.ts";
import { freeLink } from "./free_name.ts";
import { freshPlace } from "./fresh_place.ts";
import { JOINT_COMMANDS } from "./joint_commands.ts";
import { LOAD_COMMANDS } from "./load_commands.ts";

/** What a command is given: the scene as it is, and where its points are. */
export interface Present {
  scene: Draft;
  places: Places;
  drafted: Drafted;
}

export type Command = (present: Present, ...given: string[]) => Edit[];

/** Does what is asked for, as one entry of undo. */
export async function command(app: App, { do: name, with: given }: Ask): Promise<void> {
  const { text } = app.history.now.value;
  const scene = parsed(text);
  const found = COMMANDS[name];
  if (scene === null || found === undefined) return;
  const drafted = await app.engine.drafted(text, { pane: { width: 100, height: 100, letters: 14, words: false }, centre: [0, 0], scale: 1 });
  const refused = await edit(app, found({ scene, places: placesIn(drafted), drafted }, ...given));
  if (refused !== null) app.tell(refused.message);
}

const COMMANDS: Record<string, Command> = {
  ...LOAD_COMMANDS,
  ...JOINT_COMMANDS,
  fixed: ({ scene, places }, name) => {
    if (isDrawn(scene) && at(scene, ["points", name!]) !== undefined) return [{ set: ["ground"], value: [...groundOf(scene), name] }];
    return [{ add_point: { link: "ground", name: name!, at: placeOf(places, name!, []) } }];
  },
  link: ({ places }, from, to) => {
    const first = placeOf(places, from!, []);
    const second = placeOf(new Map([...places, [from!, first]]), to!, [from!]);
    const points = [{ name: from!, at: first }, { name: to!, at: second }];
    return [{ add_link: { points: from === to ? points.slice(0, 1) : points } }];
  },
  point: ({ scene, places }, link, name) => [{ add_point: { link: link!, name: name!, at: placeOf(places, name!, pointsOn(scene, link!)) } }],
  off: ({ scene }, link, point) => taken(scene, link!, point!),
  drive: ({ scene, places }, link) => {
    const angle = isDrawn(scene) ? {} : { angle: angleOf(scene, places, link!) };
    const path: Path = ["links", link!];
    const value = at(scene, path);
    if (Array.isArray(value)) return [{ set: path, value: { points: value, drive: { ...angle, omega: 10 } } }];
    return [{ set: [...path, "drive"], value: { ...angle, omega: 10 } }];
  },
  motion: ({ scene }, link) => {
    const points = pointsOn(scene, link!);
    return [{ set: ["links", link!], value: { ...withPoints(at(scene, ["links", link!])), motion: { at: points[0], velocity: [0, 0] } } }];
  },
  rpm: ({ scene }, ...path) => converted(scene, path, "omega", "rpm", turnsPerRadian(scene)),
  omega: ({ scene }, ...path) => converted(scene, path, "rpm", "omega", 1 / turnsPerRadian(scene)),
  slider: ({ scene }, what, on) => {
    const [link, point] = what!.split(":") as [string, string];
    const block = link === "new" ? freeLink(scene) : link;
    const along = on !== "ground" && pointsOn(scene, on!).length > 1 ? pointsOn(scene, on!).slice(0, 2) : 0;
    const guide = Array.isArray(along) ? (along.every((name) => name.length === 1) ? along.join("") : along.join("-")) : along;
    const first: Edit[] = link === "new" ? [{ set: ["links", block], value: { points: [point] } }] : [];
    return [...first, { add_slider: { link: block, at: point, on: on!, along: guide } }];
  },
  drop_slider: ({ scene }, index) => ((scene["sliders"] as unknown[]).length === 1 ? [{ remove: ["sliders"] }] : [{ remove: ["sliders", Number(index)] }]),
  push: ({ scene }, ...path) => [{ set: [...indexed(path), "drive"], value: isDrawn(scene) ? { speed: 100 } : { position: 100, speed: 100 } }],
  place: ({ scene, places }, ...path) => {
    // A slider, or a contact with a flat profile.
    const guided = at(scene, path);
    const point = String(at(guided, ["at"]) ?? at(guided, ["pin"]) ?? at(guided, ["centers", 0]));
    const value = (at(guided, ["on"]) ?? at(guided, ["links", 1])) === "ground" ? (places.get(point)?.map(short) ?? [0, 0]) : [0, 0];
    return [{ set: [...indexed(path), "through"], value }];
  },
  beside: ({ scene }, ...path) => [{ set: indexed(path), value: [at(scene, path), 0] }],
  near: ({ places }, name) => {
    const link = /^angle\((.*)\)$/.exec(name!)?.[1];
    return [{ set: ["near", name!], value: link === undefined ? placeOf(places, name!, []) : 0 }];
  },
  known: (_, name) => [{ set: ["known", name!], value: { velocity: [0, 0] } }],
  size: ({ scene }, ...path) => {
    const [x = 0, y = 0] = at(scene, path) as number[];
    return [{ set: path, value: { size: short(Math.hypot(x, y)), angle: short((Math.atan2(y, x) * 180) / Math.PI) } }];
  },
  parts: ({ scene }, ...path) => {
    const { size = 0, angle = 0 } = at(scene, path) as { size?: number; angle?: number };
    return [{ set: path, value: [short(size * Math.cos((angle * Math.PI) / 180)), short(size * Math.sin((angle * Math.PI) / 180))] }];
  },
};

/** The place of a point that is there, or one for a new point. */
function placeOf(places: Places, name: string, beside: string[]): [number, number] {
  return places.get(name) ?? freshPlace(places, beside);
}

/** A path of the scene whose second key is an index where it leads into the list of sliders. */
function indexed(path: string[]): Path {
  return path.map((key, index) => (path[0] === "sliders" && index === 1 ? Number(key) : key));
}

/** A number with the digits that a converted value needs. */
function short(value: number): number {
  return Number(value.toPrecision(7));
}

function withPoints(link: unknown): object {
  return Array.isArray(link) ? { points: link } : ((link ?? {}) as object);
}

/** Turns per minute for one radian per unit of time. */
function turnsPerRadian(scene: Draft): number {
  return (at(scene, ["units", "time"]) === "min" ? 1 : 60) / (2 * Math.PI);
}

/** Puts a speed under its other key. */
function converted(scene: Draft, path: Path, from: string, to: string, factor: number): Edit[] {
  const value = at(scene, [...path, from]);
  const next = typeof value === "number" ? short(value * factor) : 0;
  return [{ remove: [...path, from] }, { set: [...path, to], value: next }];
}

/** The present angle of a link's axis, in whole degrees. */
function angleOf(scene: Draft, places: Places, link: string): number {
  const [from, to] = pointsOn(scene, link).map((name) => places.get(name));
  if (from === undefined || to === undefined) return 60;
  return Math.round((Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI);
}

/** Takes a point off a link; a link without points goes. */
function taken(scene: Draft, link: string, point: string): Edit[] {
  const path: Path = ["links", link];
  const value = at(scene, path);
  const points = pointsOf(value);
  if (points.length < 2) return [{ drop_link: link }];
  const list = Array.isArray(value) ? path : [...path, "points"];
  const rest = points.filter((name) => name !== point);
  const edits: Edit[] = at(scene, list) === undefined ? [] : [{ set: list, value: rest }];
  for (const [key] of entries(at(scene, [...path, "lengths"]))) {
    const isBetween = (a: string, b: string): boolean => [a + b, `${a}-${b}`].includes(key);
    const stays = rest.some((a) => rest.some((b) => a !== b && isBetween(a, b)));
    if (!stays) edits.push({ remove: [...path, "lengths", key] });
  }
  if (rest.length === 1) edits.push({ remove: [...path, "lengths"] });
  if (at(scene, [...path, "shape", point]) !== undefined) edits.push({ remove: [...path, "shape", point] });
  const isElsewhere = linksOf(scene).some((other) => other !== link && pointsOn(scene, other).includes(point));
  if (!isElsewhere && at(scene, ["near", point]) !== undefined) edits.push({ remove: ["near", point] });
  return edits;
}
