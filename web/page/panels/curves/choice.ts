import type { Opened, OverCycle, Quantity } from "../../engine/types.ts";

/** What can be drawn over the cycle. */
export const KINDS = ["curves", "hodograph", "path"] as const;
export type Kind = (typeof KINDS)[number];

/** What a person chose, kept for each kind. */
export interface Choice {
  kind: Kind;
  /** Names of quantities, of vectors, of points. */
  names: Record<Kind, string[]>;
  /** Whether paths go on beyond limits of the drive. */
  beyond: boolean;
}

/** What can be chosen of each kind; points that never move are left out. */
export interface Offered {
  curves: Quantity[];
  hodograph: Quantity[];
  path: string[];
}

export function offered({ quantities, wanted, traceable, scene }: Opened): Offered {
  const fixed = new Set(Object.keys(scene.ground ?? {}));
  const moving = quantities.filter(({ of, inside }) => of !== "point" || !fixed.has(inside));
  const names = new Set(moving.map(({ name }) => name));
  const further = wanted.filter(({ name }) => !names.has(name));
  return { curves: [...moving, ...further], hodograph: moving.filter((one) => one.is_vector), path: traceable };
}

/** The names of what can be chosen. */
export function offeredNames(all: Offered): Record<Kind, string[]> {
  const names = (of: Quantity[]): string[] => of.map(({ name }) => name);
  return { curves: names(all.curves), hodograph: names(all.hodograph), path: all.path };
}

/** So many curves are told apart in one graph. */
const TOLD_APART = 12;

/** What is drawn before anybody chose: what the scene wants, else ω of the links that follow the drives, as far as they are told apart. */
function usual({ wanted, drives, quantities, traceable }: Opened): Record<Kind, string[]> {
  const driven = new Set(drives.map(({ name }) => name));
  const rates = quantities.filter(({ head, of, inside, part }) => head === "omega" && of === "link" && part === "" && !driven.has(inside)).slice(0, TOLD_APART);
  const last = (names: string[]): string[] => names.slice(-1);
  return {
    curves: (wanted.length > 0 ? wanted : rates).map(({ name }) => name),
    hodograph: last(quantities.filter((one) => one.is_vector && one.head === "v").map(({ name }) => name)),
    path: last(traceable),
  };
}

/** A choice for another scene: what it still has; the usual where nothing is left. */
export function fitted(choice: Choice, opened: Opened): Choice {
  const [all, else_] = [offeredNames(offered(opened)), usual(opened)];
  const names = (kind: Kind): string[] => {
    const kept = choice.names[kind].filter((name) => all[kind].includes(name));
    return kept.length > 0 ? kept : else_[kind];
  };
  return { ...choice, names: { curves: names("curves"), hodograph: names("hodograph"), path: names("path") } };
}

/** The points of which paths are drawn, or whose motion is. */
export function tracedOf({ kind, names }: Choice, { quantities, traceable }: Opened): string[] {
  if (kind === "path") return names.path;
  const subjects = new Set(quantities.filter(({ name, of }) => of === "point" && names[kind].includes(name)).map(({ inside }) => inside));
  return traceable.filter((point) => subjects.has(point));
}

/** The request for what is chosen. */
export function wantedOf({ kind, names, beyond }: Choice): OverCycle {
  switch (kind) {
    case "curves":
      return { curves: names.curves };
    case "hodograph":
      return { hodograph: names.hodograph };
    case "path":
      return beyond ? { path: names.path, beyond_limits: true } : { path: names.path };
  }
}

/** The quantities for a table of what is chosen. */
export function columnsOf({ kind, names }: Choice): string[] {
  return kind === "path" ? names.path.flatMap((point) => [`x(${point})`, `y(${point})`]) : names[kind];
}
