import { speaker } from "../../words.ts";

/** What values are about: a link, a slider, a point. */
export interface Subject {
  kind: "link" | "slider" | "point" | "others";
  name: string;
}

const say = speaker({
  en: { link: "Link {name}", slider: "Slider {name}", point: "Point {name}", others: "Others" },
  es: { link: "Eslabón {name}", slider: "Corredera {name}", point: "Punto {name}", others: "Otras" },
});

const OF_LINKS = /^(?:angle|omega|alpha)\((.+)\)/;
const OF_SLIDERS = /^(?:position|v_r|a_r|a_c)\((.+)\)/;
const OF_POINTS = /^(?:[xyva])\(([^/]+)\)/;

/** What a quantity is about, by its name. */
export function subjectOf(quantity: string): Subject {
  const kinds = [["link", OF_LINKS], ["slider", OF_SLIDERS], ["point", OF_POINTS]] as const;
  for (const [kind, pattern] of kinds) {
    const name = pattern.exec(quantity)?.[1];
    if (name !== undefined) return { kind, name };
  }
  return { kind: "others", name: "" };
}

/** Its name in words, as `Link 2`. */
export function named({ kind, name }: Subject): string {
  return say(kind, { name });
}

/** Things by what they are about, in the order in which that first comes. */
export function bySubject<Thing>(things: Thing[], nameOf: (thing: Thing) => string): [Subject, Thing[]][] {
  const groups = new Map<string, [Subject, Thing[]]>();
  for (const thing of things) {
    const subject = subjectOf(nameOf(thing));
    const key = `${subject.kind} ${subject.name}`;
    const group = groups.get(key);
    if (group === undefined) groups.set(key, [subject, [thing]]);
    else group[1].push(thing);
  }
  return [...groups.values()];
}
