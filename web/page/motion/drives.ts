import type { Shown } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import type { Drive } from "../engine/types.ts";
import { say } from "../layout/words.ts";
import { measured } from "../units.ts";
import { unitsOf } from "../panels/parts/scene.ts";
import { REST, type Gesture, type Gestures } from "../picture/gesture.ts";
import { language } from "../words.ts";

/** A drive in words. */
export function driveName({ name }: Drive): string {
  return say(name.includes("/") ? "slider" : "link", { name });
}

/** From where to where its slider goes: its limits, one turn, or as far again as it stands. */
export function range({ is_angle, low, high, value }: Drive): [number, number] {
  if (low !== null && high !== null) return [low, high];
  if (is_angle) {
    const turn = 360 * Math.floor(value / 360);
    return [low ?? turn, high ?? turn + 360];
  }
  const reach = Math.max(100, 2 * Math.abs(value));
  return [low ?? (high ?? value) - reach, high ?? (low ?? value) + reach];
}

/** One drive's name, slider and value. */
interface Row {
  drive: Drive;
  root: HTMLElement;
  name: HTMLElement;
  slider: HTMLInputElement;
  value: HTMLInputElement;
}

/** The sliders of the drives. */
export interface Drives {
  /** The drive that was touched last, as the picture has it. */
  current(): Drive | undefined;
  /** Turns or slides it by so many degrees or hundredths of its way. */
  nudge(by: number): void;
}

export function drives(app: Shown, gestures: Gestures, taken: () => void): Drives {
  const place = byId("drives", app.root);
  let rows: Row[] = [];
  let touched = "";
  let gesture: Gesture | null = null;
  let taking: Promise<void> | null = null;
  let wanted = 0;
  let clock = 0;

  function finish(): void {
    clearTimeout(clock);
    const ended = taking;
    taking = null;
    void ended?.then(() => {
      void gesture?.drop();
      gesture = null;
    });
  }

  /** Drives to a value; a rest, or letting go, ends the gesture. */
  function pull(drive: Drive, value: number): void {
    if (touched !== drive.name) finish();
    touched = drive.name;
    wanted = value;
    if (taking === null) {
      taken();
      taking = gestures.start({ kind: "drive", drive: drive.name }).then((got) => {
        gesture = got;
        got?.pull({ value: wanted });
      });
    } else gesture?.pull({ value });
    clearTimeout(clock);
    clock = window.setTimeout(finish, REST);
  }

  function row(drive: Drive): Row {
    const id = `drive-${drive.name.replace("/", "-on-")}`;
    const slider = element("input", { type: "range", id, "data-drive": drive.name, step: "any" });
    const name = element("label", { for: id });
    const value = element("input", { type: "text", id: `${id}-value`, class: "at", inputmode: "decimal", autocomplete: "off", spellcheck: "false" });
    const made: Row = { drive, root: element("div", { class: "drive" }, name, slider, value), name, slider, value };
    slider.oninput = () => pull(made.drive, slider.valueAsNumber);
    value.onfocus = () => value.select();
    value.onchange = () => go(made);
    value.onkeydown = (event) => {
      if (event.key === "Enter") go(made), value.select();
      else if (event.key === "Escape") (value.value = made.drive.shown), value.blur();
      else return;
      event.preventDefault();
    };
    slider.onpointerup = finish;
    slider.onblur = finish;
    slider.onkeydown = (event) => {
      const way = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
      if (way === undefined) return;
      event.preventDefault();
      step(made, event.shiftKey ? way / 10 : way);
    };
    return made;
  }

  /** Drives to the value that was typed; what is none is put back. */
  function go({ drive, value }: Row): void {
    const typed = measured(value.value, drive.is_angle ? "°" : unitsOf(app.solved.value.opened?.scene ?? {}).length);
    if (typeof typed !== "number" && value.value.trim() !== "") app.tell(say("drive_unread", { typed: value.value }));
    if (typeof typed !== "number" || value.value === drive.shown) return void (value.value = drive.shown);
    const { low, high } = drive;
    pull(drive, Math.min(Math.max(typed, low ?? -Infinity), high ?? Infinity));
    finish();
  }

  /** One degree, or a hundredth of the way, times `by`. */
  function step({ drive, slider }: Row, by: number): void {
    const [low, high] = range(drive);
    const unit = drive.is_angle ? 1 : (high - low) / 100;
    const from = taking !== null && touched === drive.name ? wanted : drive.value;
    const isRound = drive.low === null || drive.high === null;
    const to = from + by * unit;
    pull(drive, isRound ? to : Math.min(Math.max(to, low), high));
    slider.value = String(to);
  }

  function draw(all: Drive[]): void {
    const names = all.map(({ name }) => name).join();
    if (names !== rows.map(({ drive }) => drive.name).join()) {
      rows = all.map(row);
      place.replaceChildren(...rows.map(({ root }) => root));
      label();
    }
    rows.forEach((own, index) => {
      const drive = all[index]!;
      own.drive = drive;
      const [low, high] = range(drive);
      own.slider.min = String(low);
      own.slider.max = String(high);
      if (app.root.activeElement !== own.slider || taking === null) own.slider.value = String(drive.value);
      own.slider.setAttribute("aria-valuetext", drive.shown);
      own.value.setAttribute("aria-label", say("drive_at", { name: driveName(drive) }));
      own.value.size = Math.max(5, drive.shown.length);
      if (app.root.activeElement !== own.value) own.value.value = drive.shown;
    });
  }

  function label(): void {
    for (const { drive, name } of rows) name.textContent = driveName(drive);
  }

  app.picture.on((picture) => picture !== null && draw(picture.drives));
  language.on(label);
  app.solved.on(({ opened, refused }) => {
    byId("motion", app.root).classList.toggle("still", (opened?.drives.length ?? 0) === 0 || opened?.is_drawn === true);
    for (const { slider, value } of rows) slider.disabled = value.disabled = refused !== null;
  });

  return {
    current: () => (rows.find(({ drive }) => drive.name === touched) ?? rows[0])?.drive,
    nudge(by) {
      const own = rows.find(({ drive }) => drive.name === touched) ?? rows[0];
      if (own !== undefined) step(own, by);
    },
  };
}
