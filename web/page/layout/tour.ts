import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { owned, type Signal } from "../state/signal.ts";
import type { Store } from "../state/storage.ts";
import { language } from "../words.ts";
import { say, type Saying } from "./words.ts";

/** What is shown to somebody who is here for the first time: where it is, and what it is for. */
const STOPS: [string, Saying][] = [
  ["#pane", "tour_pull"],
  ["#steps-toggle", "tour_steps"],
  ["#tab-mechanism", "tour_own"],
];

/** White between the words and what they are about, in px. */
const GAP = 10;

/** A tour of three stops beside the page, which goes on working; once, unless somebody asks for it again. */
export function tour(app: App, store: Store): { begin(): void } {
  const words = element("p");
  const count = element("span", { class: "count" });
  const leave = element("button", { type: "button" });
  const next = element("button", { type: "button", class: "main" });
  const box = element("div", { id: "tour", role: "dialog", "aria-live": "polite", hidden: true }, words, element("div", { class: "foot" }, count, leave, next));
  document.body.append(box);
  let stop = 0;
  let isBegun = false;
  let acting: (() => void) | null = null;

  function end(): void {
    box.hidden = true;
    isBegun = false;
    store.prefer("tour", "seen");
  }

  function show(): void {
    if (box.hidden) return;
    const [selector, saying] = STOPS[stop]!;
    words.textContent = say(saying);
    count.textContent = `${stop + 1} / ${STOPS.length}`;
    leave.textContent = say("tour_leave");
    next.textContent = say(stop + 1 < STOPS.length ? "tour_next" : "tour_done");
    leave.hidden = stop + 1 === STOPS.length;
    box.setAttribute("aria-label", say("tour"));
    place(document.querySelector(selector));
  }

  /** Beside what it is about: above it, or to its left, always within the window. */
  function place(target: Element | null): void {
    const about = target?.getBoundingClientRect();
    const own = box.getBoundingClientRect();
    const within = (at: number, size: number, room: number): number => Math.min(Math.max(at, GAP), room - size - GAP);
    const isSide = about !== undefined && about.left > own.width + 2 * GAP && about.left > window.innerWidth * 0.6 && about.height < window.innerHeight / 2;
    const left = about === undefined ? GAP : isSide ? about.left - own.width - GAP : about.left + about.width / 2 - own.width / 2;
    const top = about === undefined ? GAP : isSide ? about.top : about.height > window.innerHeight / 3 ? about.bottom - own.height - GAP : about.top - own.height - GAP;
    box.style.left = `${within(left, own.width, window.innerWidth)}px`;
    box.style.top = `${within(top, own.height, window.innerHeight)}px`;
  }

  leave.onclick = end;
  next.onclick = () => {
    stop += 1;
    if (stop >= STOPS.length) return end();
    show();
  };
  box.onkeydown = (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    end();
  };
  // Whoever does something needs no tour, and none lies over what is done.
  const acts = [app.history.now, app.shown, app.view, app.focus];
  window.addEventListener("resize", show);
  language.on(show);
  return {
    begin() {
      stop = 0;
      box.hidden = false;
      show();
      acting?.();
      acting = owned(() => acts.forEach((signal: Signal<unknown>) => signal.on(() => isBegun && end()))).end;
      isBegun = true;
    },
  };
}
