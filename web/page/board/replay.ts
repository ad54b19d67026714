/** A drawing as it was drawn, entry by entry: by a slider, or at its own speed. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { icon } from "../dom/icon.ts";
import { name } from "../layout/say.ts";
import { language } from "../words.ts";
import type { Model } from "./model.ts";
import { say } from "./words.ts";

/** Where a drawing does not say when: an entry takes so long, in ms; nobody waits longer for one, nor less. */
const [USUAL, MOST, LEAST] = [1400, 4000, 250];

export function replay(app: App, model: Model): HTMLElement {
  const slider = element("input", { type: "range", min: 0, step: 1 });
  const count = element("output");
  const play = element("button", { type: "button", class: "play" });
  const speed = element("select", {}, ...[["0.5", "½×"], ["1", "1×"], ["2", "2×"], ["4", "4×"]].map(([value, shown]) => element("option", { value, selected: value === "1" }, shown)));
  const end = element("button", { type: "button", class: "end" }, icon("remove"));
  const root = element("div", { class: "replay", role: "group", hidden: true }, play, slider, count, speed, end);
  let clock = 0;
  let isPlaying = false;

  const did = (): readonly Record<string, unknown>[] => model.drawing().did;
  const now = (): number => model.until.value ?? did().length;

  function go(to: number): void {
    model.until.set(Math.max(0, Math.min(to, did().length)));
    const words = model.known.value?.did[now() - 1]?.words ?? "";
    model.showSheetOf(now() - 1);
    model.says.set({ text: words, isBad: false });
  }

  /** How long until the next entry. */
  function wait(): number {
    const [here, next] = [did()[now() - 1]?.["t"], did()[now()]?.["t"]];
    const own = typeof here === "number" && typeof next === "number" ? next - here : USUAL;
    return Math.min(Math.max(own, LEAST), MOST) / Number(speed.value);
  }

  function run(is: boolean): void {
    clearTimeout(clock);
    isPlaying = is;
    show();
    if (!is) return;
    clock = window.setTimeout(() => {
      go(now() + 1);
      run(now() < did().length);
    }, wait());
  }

  function show(): void {
    const most = did().length;
    root.hidden = model.until.value === null;
    end.hidden = model.use().mode === "demonstration";
    slider.max = String(most);
    slider.value = String(now());
    count.textContent = `${now()} / ${most}`;
    play.replaceChildren(icon(isPlaying ? "pause" : "play"));
    name(play, say(isPlaying ? "pause" : "play"));
  }

  play.onclick = () => {
    if (!isPlaying && now() >= did().length) go(0);
    run(!isPlaying);
  };
  end.onclick = () => {
    model.looked.set(null);
    model.until.set(null);
  };
  slider.oninput = () => {
    const to = Number(slider.value);
    run(false);
    go(to);
  };
  model.until.on((until) => {
    if (until === null && isPlaying) run(false);
    show();
  });
  model.known.on(show);
  app.drawing.on((is) => !is && run(false));
  language.on(() => {
    root.setAttribute("aria-label", say("replay"));
    slider.setAttribute("aria-label", say("replay"));
    name(speed, say("speed"));
    name(end, say("end_replay"));
    show();
  });
  return root;
}
