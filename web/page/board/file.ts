/** The file of a drawing, as docs/drawings.md says it: text in, text out. What an entry means is the engine's business. */

/** One entry: its first key says what is done, and its value what that makes. */
export type Entry = Readonly<Record<string, unknown>>;

export interface Drawing {
  readonly kinegon_drawing: 1;
  readonly name?: string;
  readonly exercise?: string;
  /** Scales of the sheets, in units per mm. */
  readonly mu_l?: number;
  readonly mu_v?: number;
  readonly mu_a?: number;
  readonly mu_c?: number;
  readonly mu_f?: number;
  readonly mu_h?: number;
  readonly mu_k?: number;
  /** What the hand is helped with. */
  readonly snap?: string;
  /** How many hints were opened. */
  readonly hints?: number;
  readonly did: readonly Entry[];
}

/** The drawing of a text; null where it is empty or none. */
export function drawingOf(text: string): Drawing | null {
  try {
    const file = JSON.parse(text) as Partial<Drawing> | null;
    return typeof file === "object" && file !== null && "kinegon_drawing" in file && Array.isArray(file.did) ? (file as Drawing) : null;
  } catch {
    return null;
  }
}

/** Its text: the head on a line, one entry a line. */
export function drawingText({ did, ...head }: Drawing): string {
  const opening = JSON.stringify(head).slice(0, -1);
  return did.length === 0 ? `${opening},"did":[]}\n` : `${opening},"did":[\n  ${did.map((entry) => JSON.stringify(entry)).join(",\n  ")}\n]}\n`;
}

/** What stands after all undos: indices, in order. */
export function standing(did: readonly Entry[]): number[] {
  const left: number[] = [];
  did.forEach((entry, index) => {
    if (typeof entry["undo"] === "number") left.splice(Math.max(0, left.length - entry["undo"]));
    else left.push(index);
  });
  return left;
}
