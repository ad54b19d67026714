import { documentOf, type BadLink, type Shared } from "./address.ts";
import type { Store } from "./storage.ts";

/** What the page begins with, and where that comes from. */
export interface Beginning {
  shared: Shared | null;
  from: "link" | "reload" | "lesson" | "autosave" | "kind";
  /** Why the address could not be read. */
  bad: BadLink | null;
}

/** The scene that `kinegon draw -o page.html` has put into the page. */
function lesson(): Shared | null {
  try {
    const given = JSON.parse(document.getElementById("kinegon-scene")?.textContent ?? "null") as { text?: unknown; step?: unknown } | null;
    if (typeof given?.text !== "string" || given.text.trim() === "") return null;
    const step = typeof given.step === "number" ? given.step : null;
    return { text: given.text, view: { step, coarse: false, modes: false } };
  } catch {
    return null;
  }
}

/** A link goes before what this tab had, that before the lesson in the file, the lesson before the last work. */
export async function beginning(hash: string, store: Store): Promise<Beginning> {
  const linked = await documentOf(hash);
  if (linked !== null && typeof linked !== "string") return { shared: linked, from: "link", bad: null };
  const bad = linked;
  const own = store.own();
  if (own !== null) return { shared: own, from: "reload", bad };
  const taught = lesson();
  if (taught !== null) return { shared: taught, from: "lesson", bad };
  const last = store.others()[0];
  if (last !== undefined) return { shared: last, from: "autosave", bad };
  return { shared: null, from: "kind", bad };
}
