import type { ChoiceField, Group, Row } from "../parts/form.ts";
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

/** Instant centres and what is drawn by them: the figure of centres, and curves on the scheme. */
export function centers(scene: Draft, traceable: string[]): Group {
  const checks = (key: string, label: string, all: string[]): Row => ({
    fields: [{ kind: "checks", path: ["figure", key], label, options: [...new Set([...all, ...names(at(scene, ["figure", key]))])].map((value) => ({ value, text: value })) }],
  });
  const links = linksOf(scene);
  const wanted = at(scene, ["figure", "centers"]);
  const named = Array.isArray(wanted) && wanted.length > 0 ? wanted : links.slice(0, 1).map((link) => `P(${link},ground)`);
  const amounts: ChoiceField["options"] = [{ text: say("usual_centers") }, { value: "all", text: say("all_centers") }, { value: named, any: "list", text: say("these_centers") }];
  const isShown = names(at(scene, ["figure", "panels"])).includes("centers");
  const ofFigure: Row[] = [
    { fields: [{ kind: "choice", path: ["figure", "centers"], label: say("wanted_centers"), open: true, options: amounts }] },
    ...(Array.isArray(wanted) ? [checks("centers", say("these_centers"), centersOf(links))] : []),
    checks("velocities", say("velocities"), traceable),
    checks("curvature", say("curvature"), traceable),
  ];
  return {
    id: "centers",
    title: say("centers"),
    ...(isShown ? {} : { help: say("centers_help") }),
    rows: [...(isShown ? ofFigure : []), ...(traceable.length > 0 ? [checks("centrodes", say("centrodes"), links)] : []), checks("inflection", say("inflection"), links)],
  };
}

/** Most links of which all pairs are offered; of more those with the frame. */
const FEW = 8;

/** The centres of links, those with the frame first. */
function centersOf(links: string[]): string[] {
  const pairs = links.flatMap((a, index) => links.slice(index + 1).map((b) => `P(${a},${b})`));
  return [...links.map((link) => `P(${link},ground)`), ...(links.length <= FEW ? pairs : [])];
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
