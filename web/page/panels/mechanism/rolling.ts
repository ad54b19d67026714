import type { Group } from "../parts/form.ts";
import { linksOf, listOf, type Draft } from "../parts/scene.ts";
import { contactAdder, contacts } from "./contacts.ts";
import { wheelAdder, wheels } from "./wheels.ts";
import { say } from "./words.ts";

/** What rolls on each other or touches: wheels, racks and belts, then cams. */
export function rolling(scene: Draft): Group {
  const isEmpty = listOf(scene, "gears").length + listOf(scene, "contacts").length === 0;
  return {
    id: "gears",
    title: say("rolling"),
    help: say("rolling_help"),
    path: ["gears"],
    folded: isEmpty,
    cards: [...wheels(scene), ...contacts(scene)],
    rows: linksOf(scene).length === 0 ? [] : [{ fields: [wheelAdder()] }, { path: ["contacts"], fields: [contactAdder()] }],
  };
}
