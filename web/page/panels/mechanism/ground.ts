import { stepFor } from "../../number.ts";
import type { Adder, Field, Group } from "../parts/form.ts";
import { allPoints, entries, groundOf, isDrawn, sizeOf, unitsOf, type Draft } from "../parts/scene.ts";
import { freePoint } from "./free_name.ts";
import { vectorFields } from "./vector.ts";
import { say } from "./words.ts";

/** Title and units. */
export function about(): Group {
  const unit = (key: string, label: string, names: string[]): Field => ({ kind: "choice", path: ["units", key], label, quiet: true, options: names.map((value) => ({ value, text: value })) });
  const units = [unit("length", say("length_unit"), ["mm", "cm", "m", "in", "ft"]), unit("time", say("time_unit"), ["s", "min"])];
  return {
    id: "about",
    title: say("about"),
    rows: [{ fields: [{ kind: "text", path: ["title"], label: say("title"), quiet: true, usual: say("untitled") }, ...units] }],
  };
}

/** The fixed points of a scene that gives lengths. */
export function ground(scene: Draft): Group {
  const step = stepFor(sizeOf(scene));
  return {
    id: "ground",
    title: say("ground"),
    help: say("ground_help"),
    path: ["ground"],
    adder: addGround(),
    rows: entries(scene["ground"]).map(([name]) => ({
      path: ["ground", name],
      name: { of: "point" as const, name, label: say("point_name", { name }) },
      fields: vectorFields(scene, ["ground", name], unitsOf(scene).length, step),
      buttons: [{ text: say("no_longer_there", { name }), icon: "remove" as const, edits: [{ drop_point: name }] }],
    })),
  };
}

function addGround(): Adder {
  function* options(scene: Draft): Iterable<{ value: string; text: string }> {
    const free = freePoint(scene);
    const fixed = new Set(groundOf(scene));
    yield { value: free, text: say("new_point", { name: free }) };
    if (isDrawn(scene)) for (const name of allPoints(scene)) if (!fixed.has(name)) yield { value: name, text: name };
  }
  return { kind: "adder", path: ["ground", "+"], label: say("add_fixed"), text: say("add_fixed"), ask: { do: "fixed", with: [] }, lists: [{ label: say("fixed_point"), options }] };
}
