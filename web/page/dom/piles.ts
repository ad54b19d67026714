/**
 * Marks that stand on one letter, more than any writing has (UAX #15, Stream-Safe Text Format): tens of thousands of them take a browser seconds to
 * lay out, each time. What comes after the thirtieth is not shown.
 */
export const PILE = /(?<=\p{M}{30})\p{M}+/gu;

/** A text as it is shown. */
export function calmed(text: string): string {
  return text.replace(PILE, "…");
}
