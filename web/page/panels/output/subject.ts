import type { Quantity } from "../../engine/types.ts";
import { subject } from "../../sentences.ts";
import { speaker } from "../../words.ts";

/** What values are about: a link, a slider, a point. */
export interface Subject {
  kind: Quantity["of"];
  name: string;
}

const say = speaker(subject);

/** What a quantity is about. */
function subjectOf({ of, inside }: Quantity): Subject {
  return { kind: of, name: of === "others" ? "" : inside };
}

/** Its name in words, as `Link 2`. */
export function named({ kind, name }: Subject): string {
  return say(kind, { name });
}

/** Things by what they are about, in the order in which that first comes. */
export function bySubject<Thing>(things: Thing[], quantityOf: (thing: Thing) => Quantity): [Subject, Thing[]][] {
  const groups = new Map<string, [Subject, Thing[]]>();
  for (const thing of things) {
    const subject = subjectOf(quantityOf(thing));
    const key = `${subject.kind} ${subject.name}`;
    const group = groups.get(key);
    if (group === undefined) groups.set(key, [subject, [thing]]);
    else group[1].push(thing);
  }
  return [...groups.values()];
}
