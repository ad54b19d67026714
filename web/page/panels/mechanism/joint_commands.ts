/** What the form's buttons do about wheels, profiles that touch and the ends of slots. */
import type { Edit } from "../../engine/types.ts";
import { added } from "../parts/edits.ts";
import { at, groundOf, linksOf, listOf, pointsOn, slidersOf, type Draft } from "../parts/scene.ts";
import type { Command, Present } from "./commands.ts";
import { freeLink, freePoint } from "./free_name.ts";
import { freshPlace } from "./fresh_place.ts";

/** How two wheels touch: teeth outside of both, one is a ring, one is a rack, a belt. */
export const TOUCHES = ["outside", "ring_second", "ring_first", "rack_second", "rack_first", "open", "crossed"] as const;
export type Touch = (typeof TOUCHES)[number];

export function touchOf(pair: unknown): Touch {
  const belt = at(pair, ["belt"]);
  if (belt === "open" || belt === "crossed") return belt;
  for (const [index, which] of (["first", "second"] as const).entries()) {
    const teeth = at(pair, ["teeth", index]);
    if (teeth === "rack") return `rack_${which}`;
    if (Number(teeth) < 0) return `ring_${which}`;
  }
  return "outside";
}

/** What the second of two profiles that touch is. */
export const PROFILES = ["round", "roller", "flat"] as const;

export function profileOf(contact: unknown): (typeof PROFILES)[number] {
  if (at(contact, ["along"]) !== undefined) return "flat";
  return at(contact, ["roller"]) === true ? "roller" : "round";
}

export const JOINT_COMMANDS: Record<string, Command> = {
  gear: (present, first, second) => {
    if (second === "+wheel") return withNewWheel(present, first!);
    if (second === "+rack") return withNewRack(present, first!);
    const { scene } = present;
    const on = ["ground", ...linksOf(scene)].find((body) => carries(scene, body, first!, second!));
    const teeth = [teethOf(scene, first!) ?? 20, teethOf(scene, second!) ?? 40];
    if (on !== undefined) return [added(scene, "gears", { mesh: [first, second], teeth, on })];
    const rolling = ["ground", ...linksOf(scene)].find((body) => centerOn(scene, first!, body) !== undefined && slides(scene, body, second!));
    if (rolling !== undefined) return [added(scene, "gears", { mesh: [first, second], teeth: [teeth[0], "rack"], on: rolling, radius: usualRadius(present) })];
    // The engine says what is missing.
    return [added(scene, "gears", { mesh: [first, second], teeth, on: carrierOf(scene, first!) })];
  },
  touch: (present, index, touch) => touched(present, Number(index), touch as Touch),
  contact: ({ scene, places }, first, second) => {
    const [[link, center], [other, far]] = [first!, second!].map((spot) => spot.split(":")) as [[string, string], [string, string]];
    const radii = radiiOf(distance(places.get(center), places.get(far)));
    return [added(scene, "contacts", { links: [link, other], centers: [center, far], radii, roller: true, circular: true })];
  },
  profile: ({ scene }, index, profile) => profiled(scene, Number(index), profile as (typeof PROFILES)[number]),
  radii: ({ scene, places }, index) => {
    const [first, second] = (at(scene, ["contacts", index!, "centers"]) ?? []) as string[];
    const radii = radiiOf(distance(places.get(first ?? ""), places.get(second ?? "")));
    return [{ set: ["contacts", Number(index), "radii"], value: second === undefined ? radii.slice(0, 1) : radii }];
  },
  travel: ({ places, drafted }, index) => {
    const position = drafted.sliders[Number(index)]?.position ?? 0;
    const grain = 10 ** Math.floor(Math.log10(sizeIn(places) || 100) - 1);
    const end = (way: number): number => Number((Math.round((position + way * 3 * grain) / grain) * grain).toPrecision(6));
    return [{ set: ["sliders", Number(index), "travel"], value: [end(-1), end(1)] }];
  },
};

/** The point about which a wheel turns on a carrier: the only one that both have. */
function centerOn(scene: Draft, wheel: string, carrier: string): string | undefined {
  if (wheel === carrier) return undefined;
  const own = pointsOn(scene, carrier);
  const common = pointsOn(scene, wheel).filter((point) => own.includes(point));
  return common.length === 1 ? common[0] : undefined;
}

/** Whether both wheels turn on this body, about two points. */
function carries(scene: Draft, body: string, first: string, second: string): boolean {
  const [one, other] = [centerOn(scene, first, body), centerOn(scene, second, body)];
  return one !== undefined && other !== undefined && one !== other;
}

/** What carries a wheel as far as that can be told. */
function carrierOf(scene: Draft, wheel: string): string {
  return ["ground", ...linksOf(scene)].find((body) => centerOn(scene, wheel, body) !== undefined) ?? "ground";
}

/** Whether one slides on the other, or both on the ground. */
function slides(scene: Draft, body: string, other: string): boolean {
  const isOn = (link: string, on: string): boolean => slidersOf(scene).some((slider) => at(slider, ["link"]) === link && at(slider, ["on"]) === on);
  return isOn(body, other) || isOn(other, body) || (isOn(body, "ground") && isOn(other, "ground"));
}

function distance(a: readonly number[] | undefined, b: readonly number[] | undefined): number {
  return a === undefined || b === undefined ? 0 : Math.hypot(b[0]! - a[0]!, b[1]! - a[1]!);
}

/** The width of what is there. */
function sizeIn(places: Present["places"]): number {
  const all = [...places.values()];
  return Math.max(0, ...all.map((place) => distance(all[0], place)));
}

function usualRadius({ places }: Present): number {
  return Number((0.2 * (sizeIn(places) || 100)).toPrecision(1));
}

/** Radii that bring two centres as far apart as they are. */
function radiiOf(apart: number): [number, number] {
  if (apart === 0) return [40, 10];
  const whole = Number(apart.toPrecision(4));
  const small = Number((whole / 4).toPrecision(2));
  return [Number((whole - small).toPrecision(4)), small];
}

/** How many teeth a wheel has where it runs on another one already. */
function teethOf(scene: Draft, wheel: string): number | null {
  for (const pair of listOf(scene, "gears")) {
    const which = [0, 1].find((index) => at(pair, ["mesh", index]) === wheel);
    const teeth = which === undefined ? undefined : at(pair, ["teeth", which]);
    if (typeof teeth === "number" && teeth !== 0) return Math.abs(teeth);
  }
  return null;
}

/** The rim of a wheel that meshes with another one: its teeth, and where the next wheel of the same size has its centre. */
function rimOf(scene: Draft, places: Present["places"], wheel: string): { teeth: number; next: [number, number] } | null {
  for (const pair of listOf(scene, "gears")) {
    const [own, other] = at(pair, ["mesh", 0]) === wheel ? [0, 1] : [1, 0];
    const body = (which: number): string => String(at(pair, ["mesh", which]));
    const [mine, its] = [own, other].map((which) => at(pair, ["teeth", which]));
    if (body(own!) !== wheel || typeof mine !== "number" || typeof its !== "number" || mine + its === 0) continue;
    const on = String(at(pair, ["on"]));
    const [to, from] = [own, other].map((which) => places.get(centerOn(scene, body(which!), on) ?? ""));
    const apart = distance(from, to);
    if (to === undefined || from === undefined || apart === 0) continue;
    const part = Math.abs((2 * mine) / (mine + its));
    return { teeth: Math.abs(mine), next: [0, 1].map((axis) => Number((to[axis]! + part * (to[axis]! - from[axis]!)).toPrecision(6))) as [number, number] };
  }
  return null;
}

/** A wheel beside another, on what carries that. */
function withNewWheel({ scene, places }: Present, first: string): Edit[] {
  const on = carrierOf(scene, first);
  const center = centerOn(scene, first, on);
  const name = freePoint(scene);
  const rim = rimOf(scene, places, first);
  // Its rim is as large here as where it runs on another wheel already: one of the same size goes on in a row.
  const place = rim?.next ?? freshPlace(places, center === undefined ? [] : [center]);
  const pair = { mesh: [first, freeLink(scene)], teeth: rim === null ? [20, 40] : [rim.teeth, rim.teeth], on };
  return [{ add_point: { link: on, name, at: place } }, { add_link: { points: [{ name, at: place }] } }, added(scene, "gears", pair)];
}

/** A rack below a wheel, which slides on what carries that. */
function withNewRack(present: Present, first: string): Edit[] {
  const { scene, places } = present;
  const on = carrierOf(scene, first);
  const [x, y] = places.get(centerOn(scene, first, on) ?? "") ?? [0, 0];
  const radius = usualRadius(present);
  const name = freePoint(scene);
  const rack = freeLink(scene);
  const pair = { mesh: [first, rack], teeth: [teethOf(scene, first) ?? 20, "rack"], on, radius };
  return [{ add_link: { points: [{ name, at: [x, y - radius] }] } }, { add_slider: { link: rack, at: name, on, along: 0 } }, added(scene, "gears", pair)];
}

/** Another way to touch, with numbers that can be so. */
function touched(present: Present, index: number, touch: Touch): Edit[] {
  const pair = listOf(present.scene, "gears")[index];
  const given = [0, 1].map((which) => at(pair, ["teeth", which]));
  const counts = given.map((teeth) => (typeof teeth === "number" ? Math.abs(teeth) || 20 : undefined));
  const [first, second] = [counts[0] ?? 2 * (counts[1] ?? 10), counts[1] ?? 2 * (counts[0] ?? 10)];
  // A ring holds the wheel inside of it.
  const ring = (own: number, other: number): number => -(own > other ? own : 3 * other);
  const teeth: Record<Touch, (number | "rack")[]> = {
    outside: [first, second],
    ring_first: [ring(first, second), second],
    ring_second: [first, ring(second, first)],
    rack_first: ["rack", second],
    rack_second: [first, "rack"],
    open: [first, second],
    crossed: [first, second],
  };
  const isBelt = touch === "open" || touch === "crossed";
  const isRack = touch === "rack_first" || touch === "rack_second";
  const gone = [...(isBelt ? ["pressure"] : ["belt"]), ...(isRack ? ["phase"] : ["position"]), ...(isBelt || isRack ? [] : ["radius"])];
  return [
    { set: ["gears", index, "teeth"], value: teeth[touch] },
    ...gone.map((key): Edit => ({ remove: ["gears", index, key] })),
    ...(isBelt ? [{ set: ["gears", index, "belt"], value: touch }] : []),
    ...(isRack && at(pair, ["radius"]) === undefined ? [{ set: ["gears", index, "radius"], value: usualRadius(present) }] : []),
  ];
}

/** Another second profile: a flat one has a direction in place of a centre. */
function profiled(scene: Draft, index: number, profile: (typeof PROFILES)[number]): Edit[] {
  const contact = listOf(scene, "contacts")[index];
  const own = (key: string): (string | number)[] => ["contacts", index, key];
  const points = pointsOn(scene, String(at(contact, ["links", 1])));
  const [center, other] = (at(contact, ["centers"]) ?? []) as string[];
  const radii = at(contact, ["radii"]) as number[] | undefined;
  const isFlat = profile === "flat";
  const rest: Edit[] = [{ remove: own("roller") }, ...(profile === "roller" ? [{ set: own("roller"), value: true }] : [])];
  if (isFlat) {
    const through = other ?? points[0];
    const edits: Edit[] = [{ remove: own("name") }, { set: own("centers"), value: [center] }, ...(radii === undefined ? [] : [{ set: own("radii"), value: radii.slice(0, 1) }])];
    return [...rest, ...edits, { set: own("along"), value: 0 }, ...(through === undefined ? [] : [{ set: own("through"), value: through }])];
  }
  if (other !== undefined) return rest;
  const through = at(contact, ["through"]);
  const second = typeof through === "string" ? through : (points.find((point) => !groundOf(scene).includes(point)) ?? points[0]);
  const more: Edit[] = [{ remove: own("along") }, { remove: own("through") }, { set: own("centers"), value: [center, second] }];
  return [...more, ...(radii === undefined ? [] : [{ set: own("radii"), value: [...radii, Number((radii[0]! / 3).toPrecision(2))] }]), ...rest];
}
