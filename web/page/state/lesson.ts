import type { Shared } from "./address.ts";

/** Where a document is made: the page's address, and which scene its file has inside, in short; that is empty where it has none. */
export interface Page {
  readonly address: string;
  readonly lesson: string;
}

/** The scene that `kinegon draw -o page.html` has put into the page. */
export function lesson(): Shared | null {
  try {
    const given = JSON.parse(document.getElementById("kinegon-scene")?.textContent ?? "null") as { text?: unknown; step?: unknown } | null;
    if (typeof given?.text !== "string" || given.text.trim() === "") return null;
    const step = typeof given.step === "number" ? given.step : null;
    return { text: given.text, view: { step, coarse: false, modes: false } };
  } catch {
    return null;
  }
}

/** This page, as documents that are kept name it. */
export function thisPage(): Page {
  return { address: location.href.replace(/#.*/s, ""), lesson: short(lesson()?.text ?? "") };
}

/** A few letters for a text: its length, and FNV-1a of its UTF-16. */
export function short(text: string): string {
  if (text === "") return "";
  let hash = 0x811c9dc5;
  for (let at = 0; at < text.length; at += 1) hash = Math.imul(hash ^ text.charCodeAt(at), 0x01000193) >>> 0;
  return `${text.length}-${hash.toString(36)}`;
}
