/** What a letter in a plan stands for, beside it, when the pointer rests on it or a finger taps it. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { say } from "../layout/words.ts";
import { allPoints, linksOf, parsed, type Draft } from "../panels/parts/scene.ts";

/** How long the pointer rests, in ms; how near a letter it is, and how far from it the words stand, in pixels. */
const [REST, NEAR, AWAY] = [220, 5, 14];

export function meaning(app: App): void {
  const pane = byId("pane");
  const tip = element("div", { id: "meaning", role: "tooltip", hidden: true });
  pane.append(tip);
  let clock = 0;

  function hide(): void {
    clearTimeout(clock);
    tip.hidden = true;
  }

  function show(x: number, y: number): void {
    const scene = parsed(app.solved.value.good);
    const label = scene === null ? undefined : labelAt(x, y);
    const told = label === undefined ? [] : meanings(scene!, label);
    if (told.length === 0) return hide();
    tip.textContent = told.join("\n");
    tip.hidden = false;
    const { left, top, width, height } = pane.getBoundingClientRect();
    const own = tip.getBoundingClientRect();
    const within = (at: number, most: number): number => Math.max(4, Math.min(at, most));
    const above = y - top - own.height - AWAY;
    tip.style.left = `${within(x - left - own.width / 2, width - own.width - 4)}px`;
    tip.style.top = `${within(above > 4 ? above : y - top + AWAY, height - own.height - 4)}px`;
  }

  pane.addEventListener("pointermove", ({ clientX, clientY, buttons, pointerType }) => {
    if (pointerType === "touch") return;
    hide();
    if (buttons === 0 && !app.building.value) clock = window.setTimeout(() => show(clientX, clientY), REST);
  });
  pane.addEventListener("pointerleave", hide);
  pane.addEventListener("pointerdown", hide, { capture: true });
  pane.addEventListener("click", ({ clientX, clientY }) => !app.building.value && show(clientX, clientY));
  document.addEventListener("keydown", hide);
  app.picture.on(hide);
}

/** The letters of the picture at a place of the window. */
function labelAt(x: number, y: number): Element | undefined {
  const isNear = (text: Element): boolean => {
    const { left, right, top, bottom } = text.getBoundingClientRect();
    return x >= left - NEAR && x <= right + NEAR && y >= top - NEAR && y <= bottom + NEAR;
  };
  return [...document.querySelectorAll("#sheet text[id*=-label-]")].find(isNear);
}

/** What letters stand for, a line each; those of points that share a place stand together. */
function meanings(scene: Draft, label: Element): string[] {
  const [sheet = "", , own = ""] = label.id.split("-");
  const names = (label.textContent ?? "").split(",").map((name) => name.trim());
  if (sheet === "scheme") return names.flatMap((name) => inScheme(scene, name));
  const isVelocity = sheet === "velocity";
  // Images at the pole are those of what stands still: the pole's sentence says so.
  if (own === "p" || own === "pi") return [say(isVelocity ? "means_pole_v" : "means_pole_a", { name: names[0]! })];
  return names.flatMap((name) => inPlan(scene, name, isVelocity));
}

function inScheme(scene: Draft, name: string): string[] {
  const rate = /^([ωα])(.+)$/.exec(name);
  if (rate !== null) return [say(rate[1] === "ω" ? "means_omega" : "means_alpha", { name, link: rate[2]! })];
  const link = special(scene, name);
  return link === null ? [] : [say("means_special", { name, link })];
}

function inPlan(scene: Draft, name: string, isVelocity: boolean): string[] {
  const plain = name.replaceAll("′", "").toLowerCase();
  const points = allPoints(scene);
  const point = points.find((point) => point.toLowerCase() === plain);
  if (point !== undefined) return [say(isVelocity ? "means_image_v" : "means_image_a", { name, point })];
  const link = special(scene, plain);
  if (link !== null) return [say("means_special_image", { name, link })];
  const under = points.flatMap((point) => linksOf(scene).map((link) => ({ point, link }))).find(({ point, link }) => `${point}${link}`.toLowerCase() === plain);
  if (under !== undefined) return [say("means_under", { name, ...under })];
  const part = ({ n: "means_normal", k: "means_coriolis", c: "means_coriolis", r: "means_sliding" } as const)[plain[0] ?? ""];
  return part === undefined ? [] : [say(part, { name })];
}

/** The link whose special point has that name. */
function special(scene: Draft, name: string): string | null {
  return linksOf(scene).find((link) => `s${link}`.toLowerCase() === name.toLowerCase()) ?? null;
}
