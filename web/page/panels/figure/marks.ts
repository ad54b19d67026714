import type { Group, Row } from "../parts/form.ts";
import { allPoints, at, entries, linksOf, names, type Draft } from "../parts/scene.ts";
import { say } from "./words.ts";

/** Paths of points and pale positions over the cycle. */
export function paths(scene: Draft, traceable: string[]): Group {
  const given = names(at(scene, ["figure", "trace"]));
  const options = [...new Set([...traceable, ...given])].map((value) => ({ value, text: value }));
  const trace: Row[] = [
    { fields: [{ kind: "checks", path: ["figure", "trace"], label: say("trace"), options }] },
    { fields: [{ kind: "switch", path: ["figure", "beyond_limits"], label: say("beyond"), usual: false }] },
    { fields: [{ kind: "number", path: ["figure", "ghosts"], label: say("ghosts"), unit: say("ghosts_unit"), step: 1, least: 2, usual: "–" }] },
  ];
  const isMovable = options.length > 0 || at(scene, ["figure", "ghosts"]) !== undefined;
  return isMovable ? { id: "paths", title: say("paths"), rows: trace } : { id: "paths", title: say("paths"), help: say("no_trace") };
}

/** Texts in place of names. */
export function labels(scene: Draft): Group {
  const given = entries(at(scene, ["figure", "labels"])).map(([name]) => name);
  const rows = given.map((name): Row => ({
    label: name,
    path: ["figure", "labels", name],
    fields: [{ kind: "text", path: ["figure", "labels", name], label: say("label_of", { name }), quiet: true, keepsEmpty: true }],
    buttons: [{ text: say("drop_label", { name }), icon: "remove", edits: [{ remove: given.length === 1 ? ["figure", "labels"] : ["figure", "labels", name] }] }],
  }));
  const lists = [{ label: say("own_name"), options: unnamed }];
  return {
    id: "labels",
    title: say("labels"),
    help: say("labels_help"),
    folded: true,
    rows: [...rows, { fields: [{ kind: "adder", path: ["figure", "labels", "+"], label: say("add_label"), text: say("add_label"), ask: { do: "label", with: [] }, lists }] }],
  };
}

/** What has no text in place of its name yet. */
function* unnamed(scene: Draft): Iterable<{ value: string; text: string }> {
  const given = new Set(entries(at(scene, ["figure", "labels"])).map(([name]) => name));
  for (const value of [...allPoints(scene), ...linksOf(scene), "ground"]) if (!given.has(value)) yield { value, text: value };
}
