import { stepFor } from "../../number.ts";
import { named } from "../output/subject.ts";
import type { Adder, Card, Field, Option, Row } from "../parts/form.ts";
import { at, linksOf, listOf, pointsOn, sizeOf, unitsOf, type Draft, type Path } from "../parts/scene.ts";
import { PROFILES, profileOf } from "./joint_commands.ts";
import { guide } from "./sliders.ts";
import { say } from "./words.ts";

type Listed = { value: string; text: string };

/** Profiles that touch, as those of a cam and its follower: a card each. */
export function contacts(scene: Draft): Card[] {
  return listOf(scene, "contacts").map((contact, index) => card(scene, contact, index));
}

export function contactAdder(): Adder {
  const lists = [
    { label: say("first_center"), options: (scene: Draft) => centers(scene, false) },
    { label: say("second_center"), options: (scene: Draft) => centers(scene, true) },
  ];
  return { kind: "adder", path: ["contacts", "+"], label: say("add_contact"), text: say("add_contact"), ask: { do: "contact", with: [] }, lists };
}

/** Points that may be centres of curvature: a cam mostly comes first with its last point, what it moves last with its first. */
function* centers(scene: Draft, isSecond: boolean): Iterable<Listed> {
  const turned = (all: string[], is: boolean): string[] => (is ? all.toReversed() : all);
  for (const link of turned(linksOf(scene), isSecond)) for (const name of turned(pointsOn(scene, link), !isSecond)) yield { value: `${link}:${name}`, text: say("link_at", { link, name }) };
  for (const name of pointsOn(scene, "ground")) yield { value: `ground:${name}`, text: `${say("ground_word")} ${name}` };
}

function nameOf(body: string): string {
  return body === "ground" ? say("ground_word") : body;
}

function card(scene: Draft, contact: unknown, index: number): Card {
  const path: Path = ["contacts", index];
  const bodies = [0, 1].map((which) => String(at(contact, ["links", which]) ?? "?")) as [string, string];
  const profile = profileOf(contact);
  const title = say("contact_of", { first: nameOf(bodies[0]), second: nameOf(bodies[1]) });
  const sides = profile === "flat" ? [0] : [0, 1];
  return {
    path,
    title,
    role: say(`profile_${profile}`),
    line: () => radii(scene, path, sides, bodies),
    rows: () => [
      ...[0, 1].map((which): Row => ({ fields: [body(path, which), ...(sides.includes(which) ? [center(scene, path, bodies[which]!, which)] : [])] })),
      { fields: [second(path, profile)] },
      ...(profile === "flat" ? guide(scene, path, bodies[1], true) : []),
      { fields: [{ kind: "switch", path: [...path, "circular"], label: say("circular"), usual: false }] },
      ...(profile === "flat" ? [] : [nameRow(contact, path)]),
    ],
    buttons: [{ text: say("drop_load", { name: title }), icon: "remove", ask: { do: "drop_of", with: ["contacts", String(index)] } }],
  };
}

/** The radii of curvature; a drawn scene need not give them. */
function radii(scene: Draft, path: Path, sides: number[], bodies: string[]): Row[] {
  const own: Path = [...path, "radii"];
  if (at(scene, own) === undefined) return [{ path: own, fields: [], buttons: [{ text: say("add_radii"), icon: "plus", ask: { do: "radii", with: [String(path[1])] } }] }];
  return [{ path: own, fields: sides.map((which) => radius(scene, path, bodies[which]!, which)) }];
}

function radius(scene: Draft, path: Path, name: string, which: number): Field {
  return { kind: "number", path: [...path, "radii", which], label: say("radius_of", { name: nameOf(name) }), symbol: which === 0 ? "r₁" : "r₂", unit: unitsOf(scene).length, step: stepFor(sizeOf(scene)), needed: true };
}

function body(path: Path, which: number): Field {
  const options = (scene: Draft): Listed[] => ["ground", ...linksOf(scene)].map((value) => ({ value, text: value === "ground" ? say("ground_word") : named({ kind: "link", name: value }) }));
  return { kind: "choice", path: [...path, "links", which], label: say(which === 0 ? "first_profile" : "second_profile"), options };
}

function center(scene: Draft, path: Path, name: string, which: number): Field {
  return { kind: "choice", path: [...path, "centers", which], label: say("center_at"), options: pointsOn(scene, name).map((value) => ({ value, text: value })) };
}

/** What the second profile is. */
function second(path: Path, profile: string): Field {
  const options = PROFILES.map((value): Option => ({ value, text: say(`profile_${value}`), ask: { do: "profile", with: [String(path[1]), value] } }));
  return { kind: "choice", path: [...path, "roller"], label: say("second_is"), options, now: PROFILES.findIndex((value) => value === profile) };
}

/** The name of the equivalent link: one that is given may be named elsewhere, too. */
function nameRow(contact: unknown, path: Path): Row {
  const name = at(contact, ["name"]);
  const label = say("equivalent");
  if (typeof name === "string") return { label, path: [...path, "name"], name: { of: "link", name, label }, fields: [] };
  return { fields: [{ kind: "text", path: [...path, "name"], label, usual: `E${Number(path[1]) + 1}` }] };
}
