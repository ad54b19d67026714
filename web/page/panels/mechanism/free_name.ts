import { allPoints, linksOf, once, type Draft } from "../parts/scene.ts";

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

const takenNames = once((scene: Draft) => new Set(allPoints(scene).map((name) => name.toLowerCase())));

/** A name that no point has: the first letter that is free, then letters with numbers. S is kept for special points. */
export function freePoint(scene: Draft, also: string[] = []): string {
  const taken = takenNames(scene);
  const others = also.map((name) => name.toLowerCase());
  const letters = [...LETTERS].filter((letter) => letter !== "S" && letter !== "O");
  for (let number = 0; ; number += 1) {
    const found = letters.map((letter) => (number === 0 ? letter : `${letter}${number}`)).find((name) => !taken.has(name.toLowerCase()) && !others.includes(name.toLowerCase()));
    if (found !== undefined) return found;
  }
}

/** The number that the next new link gets. */
export function freeLink(scene: Draft): string {
  const taken = linksOf(scene);
  let number = 1;
  while (taken.includes(String(number))) number += 1;
  return String(number);
}
