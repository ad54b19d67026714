import type { Opened, OverCycle } from "../../engine/types.ts";
import { subjectOf } from "../output/subject.ts";

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

/** All names that can be chosen of each kind; points that never move are left out. */
export function offered({ quantities, vectors, traceable, scene }: Opened): Record<Kind, string[]> {
  const fixed = new Set(Object.keys((scene["ground"] ?? {}) as object));
  const moving = (name: string): boolean => {
    const { kind, name: subject } = subjectOf(name);
    return kind !== "point" || !fixed.has(subject);
  };
  const curves = [...new Set([...quantities.filter(moving), ...wantedBy(scene)])];
  return { curves, hodograph: vectors.filter(moving), path: traceable };
}

/** The quantities that a scene wants by itself. */
function wantedBy(scene: Opened["scene"]): string[] {
  const wanted: unknown = scene["want"];
  return Array.isArray(wanted) ? wanted.filter((name) => typeof name === "string") : [];
}

/** What is drawn before anybody chose: what the scene wants, else ω of the links that follow the drives. */
function usual(opened: Opened): Record<Kind, string[]> {
  const wanted = wantedBy(opened.scene);
  const driven = new Set(opened.drives.map(({ name }) => `omega(${name})`));
  const rates = opened.quantities.filter((name) => /^omega\([^)]*\)$/.test(name) && !driven.has(name));
  const last = (names: string[]): string[] => names.slice(-1);
  return {
    curves: wanted.length > 0 ? wanted : rates,
    hodograph: last(opened.vectors.filter((name) => name.startsWith("v("))),
    path: last(opened.traceable),
  };
}

/** A choice for another scene: what it still has; the usual where nothing is left. */
export function fitted(choice: Choice, opened: Opened): Choice {
  const [all, else_] = [offered(opened), usual(opened)];
  const names = (kind: Kind): string[] => {
    const kept = choice.names[kind].filter((name) => all[kind].includes(name));
    return kept.length > 0 ? kept : else_[kind];
  };
  return { ...choice, names: { curves: names("curves"), hodograph: names("hodograph"), path: names("path") } };
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
