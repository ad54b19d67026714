/** A board on which a mechanism is put together point by point, also while it is not complete. */
import type { App } from "../../app.ts";
import { element, svgElement } from "../../dom/element.ts";
import { radios } from "../../dom/radios.ts";
import { worded } from "../../dom/worded.ts";
import { speak } from "../../layout/messages.ts";
import type { Signal } from "../../state/signal.ts";
import { language } from "../../words.ts";
import { edit } from "../parts/edits.ts";
import { newId } from "../parts/fields.ts";
import { parsed, unitsOf } from "../parts/scene.ts";
import { follows, TOOLS, type Begun, type Press, type Tool } from "./board_tools.ts";
import { crossShape, isAt, moved, thingsFor } from "./board_cross.ts";
import { command } from "./commands.ts";
import type { Places } from "./places.ts";
import { boxOf, grainOf, gridOf, holds, linkAt, pointAt, sketch, type Box, type Place } from "./sketch.ts";
import { say } from "./words.ts";

/** Width of the board by its height. */
const SHAPE = 1.4;

/** The board, closed at first; `open` opens it. */
export function board(app: App, places: Signal<Places>): { root: HTMLElement; open(): void } {
  let tool: Tool = "link";
  let begun: Begun | null = null;
  let box: Box = boxOf(places.value, "mm", SHAPE);
  let cross: Place = [0, 0];

  const summary = element("summary", {});
  const buttons = TOOLS.map((name) => worded(element("button", { type: "button", role: "radio", onclick: () => choose(name) }), () => say(`tool_${name}`)));
  const tools = element("div", { class: "tools", role: "radiogroup" }, ...buttons);
  radios(tools);
  const hint = element("p", { class: "hint", role: "status" });
  const drawing = svgElement("g");
  const cursor = svgElement("g", { class: "cross" });
  const help = element("p", { id: newId(), class: "keys" });
  const svg = svgElement("svg", { class: "board", tabindex: 0, role: "application", "aria-describedby": help.id, preserveAspectRatio: "xMidYMid meet" }, drawing, cursor);
  const state = element("p", { class: "state", role: "status" });
  const larger = element("button", { type: "button", class: "small" });
  const dialog = element("dialog", { class: "desk", open: true }, tools, hint, svg, element("div", { class: "foot" }, state, larger), help);
  const root = element("details", { class: "gallery drawing-board" }, summary, dialog);

  /** A length of a dot on the screen, in the scene's units. */
  const dot = (): number => (5 * box.width) / Math.max(svg.clientWidth, 240);

  function draw(): void {
    const scene = parsed(app.history.now.value.text);
    if (scene === null || !root.open) return;
    svg.setAttribute("viewBox", `${box.x} ${-box.y - box.height} ${box.width} ${box.height}`);
    svg.setAttribute("aria-label", say("board_label", { count: places.value.size }));
    drawing.replaceChildren(...sketch(scene, shownPlaces(), box, dot(), begun?.name ?? null));
    cursor.replaceChildren(...crossShape(cross, dot(), whereabouts()));
  }

  /** The places with the point that was begun. */
  function shownPlaces(): Places {
    return begun === null || places.value.has(begun.name) || tool === "third" ? places.value : new Map([...places.value, [begun.name, begun.at]]);
  }

  function words(): void {
    summary.textContent = say("board");
    help.textContent = say("board_keys");
    larger.textContent = say(dialog.matches(":modal") ? "done" : "larger");
    tools.setAttribute("aria-label", say("board"));
    tell();
  }

  function choose(name: Tool): void {
    tool = name;
    begun = null;
    buttons.forEach((button, index) => {
      button.setAttribute("aria-checked", String(TOOLS[index] === tool));
      button.tabIndex = TOOLS[index] === tool ? 0 : -1;
    });
    tell();
    draw();
  }

  function tell(): void {
    const second = tool === "third" ? "board_pick_link" : tool === "block" ? "board_pick_guide" : "board_pick_second";
    hint.textContent = begun === null ? say(`board_${tool}`) : say(second, { name: begun.name });
    const { refused, text } = app.solved.value;
    const isEmpty = places.value.size === 0;
    const isCurrent = text === app.history.now.value.text;
    state.textContent = isEmpty ? say("begin") : refused !== null && isCurrent ? say("incomplete", { why: refused.message }) : "";
  }

  /** What is at a place; where nothing is, the place is put on the grid. */
  function pressed(place: Place, reach: number): Press {
    const scene = parsed(app.history.now.value.text) ?? {};
    const point = pointAt(shownPlaces(), place, reach);
    const grid = grainOf(box);
    const round = (value: number): number => Number((Math.round(value / grid) * grid).toPrecision(10));
    const at = point === null ? (place.map(round) as Place) : shownPlaces().get(point)!;
    return { at, point, link: linkAt(scene, places.value, place, reach) };
  }

  async function press(place: Place, reach: number): Promise<void> {
    const scene = parsed(app.history.now.value.text);
    if (scene === null) return;
    const what = pressed(place, reach);
    const next = follows(tool, scene, what, begun);
    begun = next !== null && "begun" in next ? next.begun : null;
    if (next !== null && "ask" in next) await command(app, places.value, next.ask);
    if (next !== null && "edits" in next) {
      const refused = await edit(app, next.edits, newId());
      if (refused !== null) app.tell(refused.message);
    }
    tell();
    draw();
  }

  function placeOf(event: PointerEvent): Place {
    const area = svg.getBoundingClientRect();
    const scale = Math.max(box.width / area.width, box.height / area.height);
    const x = (event.clientX - area.left - area.width / 2) * scale;
    const y = (event.clientY - area.top - area.height / 2) * scale;
    return [box.x + box.width / 2 + x, box.y + box.height / 2 - y];
  }

  svg.addEventListener("pointerup", (event) => {
    cross = placeOf(event);
    const near = (event.pointerType === "mouse" ? 12 : 24) * (box.width / svg.clientWidth);
    void press(cross, near);
  });
  /** What the next press may take. */
  const things = (): Place[] => thingsFor(tool, begun, parsed(app.history.now.value.text) ?? {}, shownPlaces());
  /** How near to the cross something must be; where the cross has been put on a thing, it is that alone. */
  const reach = (): number => gridOf(box) * (things().some((thing) => isAt(thing, cross)) ? 1e-6 : 0.45);

  /** Where the cross is: what the tool would take there, or the place. */
  function whereabouts(): string {
    const { at, point, link } = pressed(cross, reach());
    const wantsLink = point === null || tool === "drive" || (tool === "third" && begun === null);
    return link !== null && wantsLink && tool !== "link" && tool !== "ground" ? say("at_link", { name: link }) : (point ?? at.join(", "));
  }

  svg.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const next = moved(cross, event.key, event.shiftKey ? grainOf(box) : gridOf(box), box, things());
    const numbered = TOOLS[Number(event.key) - 1];
    if (next !== null) {
      cross = next;
      speak(whereabouts());
    } else if (event.key === "Enter" || event.key === " ") void press(cross, reach());
    else if (numbered !== undefined) choose(numbered);
    else if (event.key === "Escape" && begun !== null) begun = null;
    else return;
    event.preventDefault();
    event.stopPropagation();
    tell();
    draw();
  });
  larger.addEventListener("click", () => {
    const isLarge = dialog.matches(":modal");
    dialog.close();
    if (isLarge) dialog.show();
    else dialog.showModal();
  });
  dialog.addEventListener("close", () => {
    // Closed by Escape: back into the panel.
    if (!dialog.open) dialog.show();
    words();
  });
  root.addEventListener("toggle", () => (refit(true), words(), draw()));
  new ResizeObserver(draw).observe(svg);

  function refit(always: boolean): void {
    const scene = parsed(app.history.now.value.text);
    if (scene !== null && (always || places.value.size === 0 || !holds(box, places.value))) {
      box = boxOf(places.value, unitsOf(scene).length, SHAPE);
      const grid = gridOf(box);
      // The cross stays on the board.
      if (!holds(box, new Map([["", cross]]))) cross = [box.x + box.width / 2, box.y + box.height / 2].map((value) => Number((Math.round(value / grid) * grid).toPrecision(10))) as Place;
    }
  }
  places.on(() => (refit(false), tell(), draw()));
  app.solved.on(tell);
  language.on(() => (words(), draw()));
  choose(tool);
  return { root, open: () => void ((root.open = true), svg.focus()) };
}
