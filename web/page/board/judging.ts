/** What is told of the drawing: verdicts, hints by stages, and what is handed in. */
import type { App } from "../app.ts";
import { fileName, saveFile } from "../files/save.ts";
import { formFile, formText, withFewDigits, withHintsOf } from "../panels/check/form.ts";
import { said } from "../refused.ts";
import { newest } from "../state/newest.ts";
import { signal, type Signal } from "../state/signal.ts";
import { standing, type Entry } from "./file.ts";
import type { Model } from "./model.ts";
import type { BoardJudged, JudgedEntry } from "../engine/types.ts";
import { say } from "./words.ts";

export interface Judging {
  /** Of the drawing as it is; null where it is not judged. */
  readonly verdicts: Signal<BoardJudged | null>;
  check(): void;
  hint(): Promise<void>;
  /** The drawing as a file. */
  save(): void;
  /** Its plans on sheets of paper, as PDF. */
  sheets(): Promise<void>;
  /** What the file is called with this name of a student; empty for no name. */
  fileOf(student: string): string;
  /** Its values into the form of the check, and in an exam the file, with the name of the student. */
  handIn(student?: string): Promise<void>;
}

/** Significant digits of what is read off the board: more than of any ruler. */
const DIGITS = 6;

/** Stages of a hint: where, by which relation, the operation itself. */
const STAGES = 3;

/** What is wrong with an entry, what was probably done, and what it should be: one sentence. */
export function whyOf({ says, done, should }: JudgedEntry): string {
  const there = (words: string | null | undefined): words is string => words != null && words !== "";
  const why = [says, [done, should].filter(there).join("; ")].filter(there).join(": ");
  return why === "" ? "" : `${why}.`;
}

/** What is said of a drawing in which nothing is wrong: only what is right is called right. `did` are its entries. */
export function soFar({ entries, is_complete: isComplete }: BoardJudged, did: readonly Entry[]): string {
  const stands = standing(did);
  if (stands.length === 0) return say("list_none");
  const unused = stands.filter((index) => entries[index]?.verdict === "unused");
  if (unused.length === 0) return say(isComplete ? "all_right" : "right_so_far");
  const numbers = unused.map((index) => stands.indexOf(index) + 1).join(", ");
  const others = isComplete ? [say("all_there")] : unused.length < stands.length ? [say("others_right")] : [];
  return [say("leads_nowhere", { numbers, count: unused.length }), ...others].join(" ");
}

export function judging(app: App, model: Model): Judging {
  const verdicts = signal<BoardJudged | null>(null);
  let stage = 0;
  const seen = (): string => model.known.value?.drawing ?? "";
  const tell = (text: string, isBad = false): void => {
    model.says.set({ text, isBad });
    app.speak(text);
  };

  const judge = newest(async (isAsked: boolean) => {
    const of = model.known.value;
    if (of === null) return;
    try {
      const judged = await app.engine.board_judge(of.scene, of.drawing);
      if (of !== model.known.value) return;
      verdicts.set(judged);
      const wrong = judged.first_wrong == null ? undefined : judged.entries[judged.first_wrong];
      if (wrong !== undefined) tell([say("first_wrong", { number: standing(model.drawing().did).indexOf(wrong.index) + 1 }), whyOf(wrong)].filter(Boolean).join(" – "), true);
      else if (isAsked || judged.entries.at(-1)?.verdict === "unused") tell(soFar(judged, model.drawing().did));
    } catch (refused) {
      tell(said(refused), true);
    }
  });

  const fileOf = (student: string): string => fileName(model.drawing().exercise ?? app.solved.value.opened?.title, student, "drawing");
  const name = (): string => fileOf(formFile(app.history.now.value.form)?.name ?? model.drawing().name ?? "");
  const save = (): void => saveFile(`${name()}.json`, seen(), "application/json");

  let before = "";
  model.known.on(() => {
    // Of another drawing nothing is known, and of one with another head all; at once what the teacher lets be told at once.
    const known = model.known.value;
    if (known === null) return;
    const did = JSON.stringify([known.scene, model.drawing().did]);
    if (did === before) return;
    before = did;
    stage = 0;
    verdicts.set(null);
    model.shown.set(null);
    const { mode, at_once } = model.use();
    if ((at_once && mode === "practice") || mode === "demonstration" || model.looked.value !== null) judge.want(false);
  });

  const own: Judging = {
    verdicts,
    check: () => judge.want(true),
    async hint() {
      const known = model.known.value;
      if (known === null) return;
      stage = Math.min(stage + 1, STAGES);
      try {
        const hint = await app.engine.board_hint(known.scene, known.drawing, stage);
        model.head({ hints: (model.drawing().hints ?? 0) + 1 });
        if (hint.sheet != null && hint.ghost.length > 0) model.shown.set({ sheet: hint.sheet, ghost: hint.ghost, kind: "hint" });
        tell(hint.words);
      } catch (refused) {
        tell(said(refused), true);
      }
    },
    fileOf: (student) => `${fileOf(student)}.json`,
    save,
    async sheets() {
      const known = model.known.value;
      if (known === null) return;
      try {
        const bytes = await app.engine.board_sheets(known.scene, known.drawing, model.drawing().exercise ?? "");
        saveFile(`${name()}.pdf`, bytes, "application/pdf");
      } catch (refused) {
        tell(said(refused), true);
      }
    },
    async handIn(student = "") {
      if (student !== "" && student !== model.drawing().name) model.head({ name: student });
      const known = model.known.value;
      if (known === null) return;
      try {
        const form = formFile(await app.engine.board_form(known.scene, known.drawing));
        const use = model.use();
        const file = own.fileOf(model.drawing().name ?? "");
        if (use.mode === "exam") {
          saveFile(file, seen(), "application/json");
          app.board.set({ ...use, handed_in: app.history.now.value.text });
        }
        if (form !== null) app.history.change({ form: withHintsOf(formText(withFewDigits(form, DIGITS)), app.history.now.value.form) });
        tell(use.mode === "exam" ? say("handed_in_file", { file }) : say("handed_in"));
      } catch (refused) {
        tell(said(refused), true);
      }
    },
  };
  return own;
}
