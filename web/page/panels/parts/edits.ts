import type { App } from "../../app.ts";
import type { Edit, Refused } from "../../engine/types.ts";
import { listOf, type Draft, type List } from "./scene.ts";

interface Waiting {
  edits: Edit[];
  gesture: string | undefined;
  done(refused: Refused | null): void;
}

/** The change that adds an entry to a list, which there may not be yet. */
export function added(scene: Draft, list: List, entry: object): Edit {
  const count = listOf(scene, list).length;
  return count === 0 ? { set: [list], value: [entry] } : { set: [list, count], value: entry };
}

/** Changes of the scene that wait for those before them, by page. */
const queues = new WeakMap<App, Waiting[]>();

/**
 * Changes the scene; the answer is why not, or null. Changes with the same gesture, one after the other, are one entry of undo. Changes
 * come one after the other; of those with the same gesture that wait only the last is done, so that a held key never lags.
 */
export function edit(app: App, edits: Edit[], gesture?: string): Promise<Refused | null> {
  return new Promise((done) => {
    const queue = queues.get(app);
    if (queue === undefined) {
      const begun: Waiting[] = [{ edits, gesture, done }];
      queues.set(app, begun);
      void work(app, begun);
      return;
    }
    const last = queue.at(-1);
    if (queue.length > 1 && last !== undefined && gesture !== undefined && last.gesture === gesture) {
      queue.pop();
      last.done(null);
    }
    queue.push({ edits, gesture, done });
  });
}

async function work(app: App, queue: Waiting[]): Promise<void> {
  for (;;) {
    const next = queue[0];
    if (next === undefined) break;
    next.done(await changed(app, next));
    queue.shift();
  }
  queues.delete(app);
}

async function changed(app: App, { edits, gesture }: Waiting): Promise<Refused | null> {
  // What changes the text meanwhile is not undone by this: it is done again on the newer text.
  for (;;) {
    const before = app.history.now.value.text;
    try {
      // What is built by hand, or by the form's buttons, keeps its places while it is not complete. A number on its way is not what is built.
      const inPlace = !app.typing.value && (app.building.value || gesture === undefined);
      const text = await (inPlace ? app.engine.edit_in_place(before, edits) : app.engine.edit(before, edits));
      if (app.history.now.value.text !== before) continue;
      app.history.change({ text }, gesture);
      return null;
    } catch (refused) {
      return refused as Refused;
    }
  }
}
