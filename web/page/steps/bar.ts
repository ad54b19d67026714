import type { Shown } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { say } from "../layout/words.ts";
import { language } from "../words.ts";
import type { Steps } from "./steps.ts";

/** Plain text, as `v_S3 = v_G + v_S3G`, with its marks set low. */
export function marked(plain: string): (string | HTMLElement)[] {
  const pieces = plain.split(/_(?:\{([^}]*)\}|([\p{L}\p{N}']+))/u);
  // By threes: text, mark in braces, mark without.
  return pieces.flatMap<string | HTMLElement>((piece, at) => (at % 3 === 0 ? [piece] : piece === undefined ? [] : [element("sub", {}, piece)]));
}

/** The bar below the picture: caption and equation, and the controls to go through the steps. */
export function stepsBar(app: Shown, steps: Steps): void {
  const slider = byId<HTMLInputElement>("step-slider", app.root);
  const coarse = byId<HTMLInputElement>("step-coarse", app.root);
  const toggle = byId("steps-toggle", app.root);
  let shown = "";

  function show(): void {
    const [count, now, said] = [steps.count(), steps.now(), steps.said()];
    const isFinished = said === null;
    const place = isFinished ? say("finished", { count }) : say("step_of", { number: now, count });
    const caption = isFinished ? (app.solved.value.opened?.title ?? "") : said.caption;
    if (caption !== shown) byId("step-caption", app.root).replaceChildren(...(isFinished ? [caption] : marked(caption)));
    shown = caption;
    byId("step-equation", app.root).replaceChildren(...(said?.equation ?? "").split("\n").map((line) => element("span", {}, ...marked(line))));
    byId("step-values", app.root).replaceChildren(...(said?.values ?? []).map((line) => element("span", {}, ...marked(line), ". ")));
    text("step-number", isFinished ? `${count} / ${count}` : `${now} / ${count}`);
    slider.max = String(count + 1);
    slider.value = String(now);
    slider.setAttribute("aria-valuetext", place);
    for (const id of ["step-first", "step-back"]) byId<HTMLButtonElement>(id, app.root).disabled = now <= 1;
    for (const id of ["step-last", "step-forward"]) byId<HTMLButtonElement>(id, app.root).disabled = isFinished;
    coarse.checked = app.view.value.coarse;
    coarse.parentElement!.hidden = (app.solved.value.opened?.passages.length ?? 0) === 0;
    byId<HTMLButtonElement>("steps-toggle", app.root).disabled = count === 0;
  }

  function text(id: string, words: string): void {
    const place = byId(id, app.root);
    if (place.textContent !== words) place.textContent = words;
  }

  const buttons = { "step-first": () => steps.go(1), "step-back": () => steps.by(-1), "step-forward": () => steps.by(1), "step-last": () => steps.go(Infinity) };
  for (const [id, act] of Object.entries(buttons)) byId(id, app.root).onclick = act;
  slider.oninput = () => steps.go(slider.valueAsNumber);
  coarse.onchange = () => steps.coarse(coarse.checked);
  toggle.onclick = () => (steps.on.value ? steps.on.set(false) : steps.go(1));
  steps.on.on((is) => {
    byId("steps", app.root).hidden = !is;
    toggle.setAttribute("aria-pressed", String(is));
  });
  app.view.on(show);
  app.solved.on(show);
  language.on(show);
}
