import type { Kind } from "../../engine/types.ts";
import { kinds as translated } from "../../sentences.ts";
import type { Language } from "../../words.ts";

type Group = "groups_bars" | "groups_more" | "groups_drives" | "groups_wheels" | "groups_class" | "groups_drawn" | "groups_paper";

/** The starting scenes by group. */
export const GROUPS: Record<Group, string[]> = {
  groups_bars: ["four-bar", "slider-crank", "slotted-lever", "hydraulic-boom"],
  groups_more: ["watt-1", "stephenson-3", "whitworth", "toggle-press"],
  groups_drives: ["five-bar", "platform-3rrr"],
  groups_wheels: [
    "gear-train",
    "planetary",
    "planetary-sun-fixed",
    "planetary-carrier-fixed",
    "differential",
    "reverted-train",
    "sun-and-planet",
    "rack-and-pinion",
    "geared-five-bar",
    "geneva",
    "eccentric-cam",
    "flat-follower",
  ],
  groups_class: ["third-class", "fourth-class"],
  groups_paper: ["paper-figure-1", "paper-figure-2"],
  groups_drawn: ["dyad-rrr", "dyad-rrp", "dyad-rpr", "dyad-prp", "dyad-rpp"],
};

/** What a starting scene has in this language; the files are English. */
const own = (language: Language, key: string): string | undefined => (translated[language] as Record<string, string>)[key];

/** A scene's note, in the page's language where the scene has that of a starting scene. */
export function noteOf(note: string, kinds: Kind[], language: Language): string {
  const kind = kinds.find(({ text }) => text.includes(JSON.stringify(note)));
  return (kind && own(language, `note-${kind.name}`)) ?? note;
}

/** The title of a starting scene. */
export function titleOf(kind: Kind, language: Language): string {
  return own(language, `title-${kind.name}`) ?? kind.title ?? kind.name;
}

/** A scene without links, to begin with. */
export const EMPTY = `{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "ground": {},
  "links": {}
}
`;
