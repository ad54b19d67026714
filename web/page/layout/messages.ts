import type { App } from "../app.ts";
import { isBegun, unfinished } from "../build/mobility.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { parsed } from "../panels/parts/scene.ts";
import { withLine } from "../refused.ts";
import { language } from "../words.ts";
import { say } from "./words.ts";

/** Says why the text is refused until it is mended, and folds warnings. */
export function messages(app: App): void {
  const bar = byId("message");
  const fold = byId<HTMLDetailsElement>("warnings");

  /** What was built last. */
  let built = "";
  app.history.now.on(({ text }) => app.building.value && (built = text));

  function refused(): void {
    const { text: now, refused: why } = app.solved.value;
    // What is being built is not complete for a while: Build says so by itself.
    bar.hidden = why === null || app.building.value;
    if (why === null) return bar.replaceChildren();
    const scene = app.student.value ? null : parsed(now);
    const begun = scene !== null && (now === built || isBegun(scene, why)) ? unfinished(scene, why) : null;
    bar.classList.toggle("calm", begun !== null);
    bar.role = begun === null ? "alert" : "status";
    const text = element("p", {}, begun ?? element("strong", {}, withLine(why)));
    if (begun === null && why.hint !== null) text.append(" ", why.hint);
    bar.replaceChildren(text);
    if (begun !== null) return bar.append(element("button", { type: "button", id: "message-build", onclick: () => app.building.set(true) }, say("go_on")));
    // What is scrolled is scrolled by keys, too.
    if (text.scrollHeight > text.clientHeight) text.tabIndex = 0;
    const { from, to } = why;
    // A student has no panel with the text.
    if (from === null || app.student.value) return;
    const go = element("button", { type: "button", id: "message-place" }, say("to_text"));
    go.onclick = () => {
      app.show("text");
      app.place.set({ from, to: to ?? from });
    };
    bar.append(go);
  }

  function warnings(): void {
    const all = app.solved.value.opened?.warnings ?? [];
    fold.hidden = all.length === 0;
    fold.querySelector("summary")!.textContent = all.length === 1 ? say("warning") : say("warnings", { count: all.length });
    fold.querySelector("ul")!.replaceChildren(...all.map((warning) => element("li", {}, warning)));
  }

  const both = (): void => {
    refused();
    warnings();
  };
  app.solved.on(both);
  app.building.on(refused);
  language.on(both);
}

/** Says something that stays until it is closed; `act` is what can be done about it, by its name. */
export function notice(message: string, act?: [string, () => void]): void {
  const bar = byId("notice");
  const close = element("button", { type: "button", id: "notice-close" }, say("close"));
  close.onclick = () => (bar.hidden = true);
  bar.replaceChildren(element("p", {}, message));
  if (act !== undefined) {
    const [name, does] = act;
    const press = element("button", { type: "button", id: "notice-act" }, name);
    press.onclick = () => {
      bar.hidden = true;
      does();
    };
    bar.append(press);
  }
  bar.append(close);
  bar.hidden = false;
  // Aloud it is said as everything else is.
  byId("said").classList.remove("shown");
  byId("said").textContent = message;
}

/** Says that the course does not take the marks, until it does. */
export function courseNotices(app: App): void {
  const { course } = app;
  let isTold = false;
  course?.isDeaf.on((is) => {
    if (is) notice(say("course_deaf"), [say("course_again"), course.again]);
    else if (isTold) notice(say("course_hears"));
    isTold = is;
  });
}

/** Says something aloud only, where the page shows it in another way. */
export function speak(message: string): void {
  byId("spoken").textContent = message;
}

/** How long a word stays on the page, in ms for a letter, and at least. */
const [LETTER, LEAST] = [60, 4000];

/** Puts a word at the foot of the picture, or below the picture's head where it covers fewer joints there. */
function settle(word: HTMLElement): void {
  const covered = (): number => {
    const own = word.getBoundingClientRect();
    const boxes = [...document.querySelectorAll("#pane :is(.handle, #warnings)")].map((control) => control.getBoundingClientRect());
    return boxes.filter((box) => box.width > 0 && box.left < own.right && box.right > own.left && box.top < own.bottom && box.bottom > own.top).length;
  };
  const isHigh = (is: boolean): number => (word.classList.toggle("high", is), covered());
  isHigh(isHigh(true) < isHigh(false));
}

/** Says something for a moment, aloud and on the page. */
export function teller(): (message: string) => void {
  const place = byId("said");
  let clock = 0;
  return (message) => {
    clearTimeout(clock);
    // The same words again are said again.
    place.textContent = "";
    place.textContent = message;
    settle(place);
    place.classList.add("shown");
    clock = window.setTimeout(() => place.classList.remove("shown"), Math.max(LEAST, message.length * LETTER));
  };
}
