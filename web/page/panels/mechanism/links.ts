import { stepFor } from "../../number.ts";
import type { Adder, Button, Card, Field, Group, Row } from "../parts/form.ts";
import { allPoints, at, entries, groundOf, isDrawn, lengthKey, linksOf, pairs, pointsOf, pointsOn, sizeOf, slidersOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { lineOfDrive, restOfDrive } from "./drives.ts";
import { freePoint } from "./free_name.ts";
import { motionRows } from "./known.ts";
import { placeFields } from "./vector.ts";
import { say } from "./words.ts";

/** The links, a card each. */
export function links(scene: Draft): Group {
  const slides = scene["sliders"];
  const blocks = new Set((Array.isArray(slides) ? slides : []).map((slider: unknown) => at(slider, ["link"])));
  const lists = [
    { label: say("from"), options: (now: Draft) => [...plain(allPoints(now).toReversed()), fresh(now)[0]!] },
    { label: say("to"), options: (now: Draft) => [...fresh(now).slice(allPoints(now).length === 0 ? 1 : 0), ...plain(allPoints(now))] },
  ];
  const adder: Adder = { kind: "adder", path: ["links", "+"], label: say("add_link"), text: say("add_link"), ask: { do: "link", with: [] }, lists };
  return {
    id: "links",
    title: say("links"),
    help: say("links_help"),
    path: ["links"],
    cards: linksOf(scene).map((name) => card(scene, name, blocks)),
    adder,
  };
}

/** Names of new points: the next one that is free, and the one after it. */
function fresh(scene: Draft): { value: string; text: string }[] {
  const free = freePoint(scene);
  return [free, freePoint(scene, [free])].map((value) => ({ value, text: say("new_point", { name: value }) }));
}

function plain(names: string[]): { value: string; text: string }[] {
  return names.map((value) => ({ value, text: value }));
}

function card(scene: Draft, name: string, blocks: Set<unknown>): Card {
  const path: Path = ["links", name];
  const link = at(scene, path);
  const points = pointsOf(link);
  const drawn = isDrawn(scene);
  const rest = (): Row[] => (drawn ? motionRows(scene, name) : [...shapeRows(scene, path, points), ...motionOf(scene, name, points)]);
  return {
    path,
    title: say("link"),
    name: { of: "link", name, label: say("link_name", { name }) },
    ...roleOf(scene, link, points, blocks.has(name)),
    line: () => [...(drawn ? [] : lengthRow(scene, path, points)), ...lineOfDrive(scene, [...path, "drive"])],
    rows: () => [{ fields: [pointChips(name, points), addPoint(name)] }, ...rest()],
    buttons: [{ text: say("drop_link", { name }), icon: "remove", edits: [{ drop_link: name }] }],
  };
}

/** What a link is, in a word, and its points where no lengths name them. */
function roleOf(scene: Draft, link: unknown, points: string[], isBlock: boolean): { role?: string } {
  const isLone = points.length < 2;
  const word = at(link, ["motion"]) !== undefined ? say("moves_as_known") : isLone && isBlock ? say("block") : isLone && isDrawn(scene) ? say("stub") : "";
  const named = isLone || isDrawn(scene) || at(link, ["shape"]) !== undefined || points.length > 3 ? points.join(" ") : "";
  const role = [word, named].filter((part) => part !== "").join(" ");
  return role === "" ? {} : { role };
}

function pointChips(link: string, points: string[]): Field {
  return {
    kind: "points",
    path: ["links", link, "points"],
    label: say("points"),
    quiet: true,
    points: points.map((name) => ({
      name,
      label: say("point_name", { name }),
      remove: say("take_off", { name }),
      ask: { do: "off", with: [link, name] },
    })),
  };
}

function addPoint(link: string): Field {
  function* options(scene: Draft): Iterable<{ value: string; text: string }> {
    const points = pointsOn(scene, link);
    yield fresh(scene)[0]!;
    for (const value of allPoints(scene)) if (!points.includes(value)) yield { value, text: value };
  }
  return { kind: "adder", path: ["links", link, "points", "+"], label: say("add_point"), text: say("add_point"), ask: { do: "point", with: [link] }, lists: [{ label: say("add_point"), options }] };
}

/** The lengths of a link. */
function lengthRow(scene: Draft, path: Path, points: string[]): Row[] {
  if (at(scene, [...path, "shape"]) !== undefined || points.length > 3) return [];
  const step = stepFor(sizeOf(scene));
  const unit = unitsOf(scene).length;
  const table = [...path, "lengths"];
  const fields = pairs(points).map(([a, b]): Field => {
    const key = lengthKey(at(scene, table), a, b);
    return { kind: "number", path: [...table, key], label: key, unit, step, needed: true, pin: { length: `${String(path[1])}.${key}` } };
  });
  return fields.length === 0 ? [] : [{ path: table, fields }];
}

/** The shape of a link, or that it has none. */
function shapeRows(scene: Draft, link: Path, points: string[]): Row[] {
  const path: Path = [...link, "shape"];
  const shape = at(scene, path);
  if (shape === undefined) return points.length > 3 ? [{ label: say("unsized"), titled: true, path, fields: [] }] : [];
  const step = stepFor(sizeOf(scene));
  const unit = unitsOf(scene).length;
  const rows = entries(shape).map(([name, place]): Row => {
    const own: Path = [...path, name];
    const beside: Button[] = typeof place === "number" ? [{ text: say("give_place"), icon: "plus", ask: { do: "beside", with: own.map(String) } }] : [];
    const fields: Field[] = typeof place === "number" ? [{ kind: "number", path: own, label: "x", unit, step, needed: true }] : placeFields(own, unit, step);
    return { label: name, path: own, fields, buttons: beside };
  });
  return [{ label: say("places_on_link"), titled: true, fields: [] }, ...rows];
}

/** Drive or given angle of a link, but for what its line has. */
function motionOf(scene: Draft, name: string, points: string[]): Row[] {
  const path: Path = ["links", name];
  if (at(scene, [...path, "drive"]) !== undefined) return [restOfDrive(scene, [...path, "drive"], name)];
  const rows: Row[] = [];
  if (points.length > 1 && givesAngle(scene, path)) {
    rows.push({ fields: [{ kind: "number", path: [...path, "angle"], label: say("axis_angle"), unit: "°", step: 1, usual: "–" }] });
  }
  const pivots = points.filter((point) => groundOf(scene).includes(point));
  if (pivots.length === 1) rows.push({ fields: [], buttons: [{ text: say("drive_it"), icon: "plus", ask: { do: "drive", with: [name] } }] });
  return rows;
}

/** Whether a link's angle may be given: it is, or a drive does not say where it stands. */
function givesAngle(scene: Draft, path: Path): boolean {
  const drives = [...entries(scene["links"]).map(([, link]) => link), ...slidersOf(scene)].map((part: unknown) => at(part, ["drive"]));
  const isOpen = drives.some((drive) => drive !== undefined && at(drive, ["angle"]) === undefined && at(drive, ["position"]) === undefined);
  return at(scene, [...path, "angle"]) !== undefined || isOpen;
}
