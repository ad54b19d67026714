import type { ChoiceField, Field, Group } from "../parts/form.ts";
import { at, linksOf, type Draft } from "../parts/scene.ts";
import { SHEETS } from "../../engine/types.ts";
import { called } from "../../sheets.ts";
import { figure, LANGUAGES } from "../../sentences.ts";
import { say } from "./words.ts";

/** The panels of a figure that does not say which. */
const USUAL = SHEETS.filter(({ isUsual }) => isUsual).map(({ key }) => key);

function choice(key: string, label: string, options: ChoiceField["options"], open = true): Field {
  return { kind: "choice", path: ["figure", key], label, open, options };
}

/** Style, notations, language. */
export function look(scene: Draft): Group {
  // What is usual is not written; a scene that says it nevertheless keeps it.
  const usual = (key: string, value: string): unknown => (at(scene, ["figure", key]) === value ? value : undefined);
  const styles = [
    { value: usual("style", "paper"), text: say("paper") },
    { value: "print", text: say("print") },
    { value: "lecture", text: say("lecture") },
    { value: "board", text: say("board") },
  ];
  const notations = [
    { value: usual("notation", "paper"), text: say("n_paper") },
    { value: "english", text: say("english") },
    { value: "russian", text: say("russian") },
    { value: "german", text: say("german") },
  ];
  const slidings = [{ value: usual("sliding", "slider"), text: "v_r(3/2)" }, { value: "points", text: "v_B3B2" }];
  const letters = [{ text: say("as_notation") }, ...["c", "C", "k", "cor"].map((value) => ({ value, text: value }))];
  // A link that has the number keeps it.
  const taken = new Set(linksOf(scene));
  const numbers = ["0", "1"].filter((value) => !taken.has(value) || at(scene, ["figure", "frame"]) === value);
  const frames = [{ text: say("word") }, ...numbers.map((value) => ({ value, text: value }))];
  const senses = [
    { text: say("not_turned") },
    { value: "counter-clockwise", text: say("turned_by", { angle: "+90" }) },
    { value: "clockwise", text: say("turned_by", { angle: "−90" }) },
  ];
  const languages = LANGUAGES.map((code) => ({ value: code === "en" ? usual("language", code) : code, text: figure[code].language_name }));
  const marks = [{ value: usual("decimal", "point"), text: say("point") }, { value: "comma", text: say("comma") }];
  return {
    id: "look",
    title: say("look"),
    rows: [
      { fields: [choice("style", say("style"), styles)] },
      { fields: [choice("notation", say("notation"), notations)] },
      { fields: [choice("sliding", say("sliding"), slidings)] },
      { fields: [choice("coriolis", say("coriolis"), letters, false), choice("frame", say("frame"), frames, false)] },
      { fields: [choice("turned", say("turned"), senses, false)] },
      { fields: [choice("language", say("language"), languages), choice("decimal", say("decimal"), marks)] },
    ],
  };
}

/** Panels and the one that is large. */
export function shown(): Group {
  const panels = SHEETS.map(({ key }) => ({ value: key, text: called(key, "panel") }));
  return {
    id: "shown",
    title: say("shown"),
    rows: [
      { fields: [{ kind: "checks", path: ["figure", "panels"], label: say("panels"), quiet: true, options: panels, usual: USUAL, needed: true }] },
      { fields: [choice("focus", say("focus"), [{ text: say("none") }, ...panels], false)] },
    ],
  };
}

/** The sheet of paper. */
export function page(scene: Draft): Group {
  const given = at(scene, ["figure", "page"]);
  const [size = "a4", direction = "landscape"] = (typeof given === "string" ? given : "a4").split("-");
  const named = (of: string, to: string): string | undefined => {
    if (of === size && to === direction) return typeof given === "string" ? given : undefined;
    return to === "landscape" ? (of === "a4" ? undefined : of) : `${of}-${to}`;
  };
  const sizes = [["a4", "A4"], ["a3", "A3"], ["letter", "Letter"], ["16x9", say("projector")]] as const;
  const directions = ["landscape", "portrait"] as const;
  return {
    id: "page",
    title: say("page"),
    rows: [
      {
        fields: [
          choice("page", say("page_size"), sizes.map(([value, text]) => ({ value: named(value, direction), text })), false),
          choice("page", say("direction"), directions.map((value) => ({ value: named(size, value), text: say(value) })), false),
        ],
      },
      { fields: [{ kind: "switch", path: ["figure", "worksheet"], label: say("worksheet"), usual: false }] },
    ],
  };
}

/** What stands on the figure besides the mechanism. */
export function contents(): Group {
  const units = ["mm", "cm", "m", "in", "ft"].map((value) => ({ value, text: say("with_unit", { unit: value }) }));
  const values = [{ text: say("usual") }, { value: true, text: say("yes") }, ...units, { value: false, text: say("no") }];
  const construction = [{ text: say("whole") }, { value: "paper", text: say("as_paper") }, { value: false, text: say("hidden") }];
  return {
    id: "contents",
    title: say("contents"),
    rows: [
      { fields: [choice("values", say("values"), values, false)] },
      { fields: [choice("construction", say("construction"), construction)] },
      { fields: [{ kind: "switch", path: ["figure", "special_points"], label: say("special"), usual: true }] },
    ],
  };
}
