// A scene after changes of single values, as the engine would make them.
import type { Edit } from "../../web/page/engine/types.ts";
import type { Draft } from "../../web/page/panels/parts/scene.ts";

export function after(scene: Draft, edits: Edit[]): Draft {
  const next = structuredClone(scene);
  for (const each of edits) {
    const path = "set" in each ? each.set : "remove" in each ? each.remove : [];
    const last = path.at(-1)!;
    let around = next as Record<string | number, unknown>;
    for (const key of path.slice(0, -1)) around = (around[key] ??= {}) as typeof around;
    if ("set" in each) around[last] = each.value;
    else if (Array.isArray(around)) around.splice(Number(last), 1);
    else delete around[last];
  }
  return next;
}
