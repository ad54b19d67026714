import { documentOf, type BadLink, type Shared } from "./address.ts";
import { lesson, short, thisPage } from "./lesson.ts";
import type { Kept, Store } from "./storage.ts";

/** What the page begins with, and where that comes from. */
export interface Beginning {
  shared: Shared | null;
  from: "link" | "reload" | "lesson" | "autosave" | "kind";
  /** Why the address could not be read. */
  bad: BadLink | null;
  /** What somebody has made of the lesson in this file before, where the page begins with the lesson itself. */
  before: Kept | null;
}

/**
 * A link goes before what this tab has made of the lesson in the file, that before the lesson itself, the lesson before the last work. What was made in
 * another tab, or of the lesson that the file had before, is there to be taken up.
 */
export async function beginning(hash: string, store: Store): Promise<Beginning> {
  const linked = await documentOf(hash);
  if (linked !== null && typeof linked !== "string") return { shared: linked, from: "link", bad: null, before: null };
  const bad = linked;
  const own = store.own();
  const taught = lesson();
  const page = thisPage();
  if (own !== null && (own.page?.lesson ?? "") === page.lesson) return { shared: own, from: "reload", bad, before: null };
  if (taught !== null) {
    const isOfThis = (kept: Kept): boolean => kept.page !== undefined && (kept.page.lesson === page.lesson || kept.page.address === page.address);
    // A lesson as it came is nobody's work.
    const isWork = (kept: Kept): boolean => kept.form !== "" || ![page.lesson, kept.page?.lesson].includes(short(kept.text));
    const all = own === null ? store.others() : [own, ...store.others()];
    return { shared: taught, from: "lesson", bad, before: all.find((kept) => isOfThis(kept) && isWork(kept)) ?? null };
  }
  const last = store.others()[0];
  if (last !== undefined) return { shared: last, from: "autosave", bad, before: null };
  return { shared: null, from: "kind", bad, before: null };
}
