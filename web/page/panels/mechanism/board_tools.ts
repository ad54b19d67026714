/** What a press on the drawing board does, tool by tool. */
import type { Ask } from "../parts/form.ts";
import type { Edit } from "../../engine/types.ts";
import { freePoint } from "./free_name.ts";
import type { Place } from "./sketch.ts";
import type { Draft } from "../parts/scene.ts";

export const TOOLS = ["ground", "link", "third", "block", "drive", "drop"] as const;
export type Tool = (typeof TOOLS)[number];

/** What was pressed: a point or a link that is there, and the place. */
export interface Press {
  at: Place;
  point: string | null;
  link: string | null;
}

/** What was pressed before, where a tool needs two presses. */
export interface Begun {
  name: string;
  at: Place;
}

/** What follows: changes, something that a command does, or the first half of it. */
export type Follows = { edits: Edit[] } | { ask: Ask } | { begun: Begun } | null;

export function follows(tool: Tool, scene: Draft, { at, point, link }: Press, begun: Begun | null): Follows {
  const name = point ?? freePoint(scene, begun === null ? [] : [begun.name]);
  switch (tool) {
    case "ground":
      return { edits: [{ add_point: { link: "ground", name, at } }] };
    case "link":
      if (begun === null) return { begun: { name, at } };
      return begun.name === name ? null : { edits: [{ add_link: { points: [begun, { name, at }] } }] };
    case "third":
      if (begun === null) return link === null ? null : { begun: { name: link, at } };
      return { edits: [{ add_point: { link: begun.name, name, at } }] };
    case "block":
      if (begun === null) return point === null ? null : { begun: { name: point, at } };
      return { ask: { do: "slider", with: [`new:${begun.name}`, link ?? "ground"] } };
    case "drive":
      return link === null ? null : { ask: { do: "drive", with: [link] } };
    case "drop":
      return point !== null ? { edits: [{ drop_point: point }] } : link !== null ? { edits: [{ drop_link: link }] } : null;
  }
}
