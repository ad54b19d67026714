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

/** The number that the next new link gets: that which the engine gives it. */
export function freeLink(scene: Draft, also: string[] = []): string {
  const taken = new Set([...linksOf(scene), ...also]);
  // S3 is special point 3's, and D_3 a point of link 3.
  for (const point of allPoints(scene)) taken.add(point.startsWith("S") ? point.slice(1) : (point.split("_")[1] ?? ""));
  let number = 1;
  while (taken.has(String(number))) number += 1;
  return String(number);
}
