import type { App } from "../app.ts";
import type { Picture } from "../engine/types.ts";
import type { Gesture, Gestures } from "../picture/gesture.ts";
import { courseOf, following, type Course } from "./course.ts";
import type { Drives } from "./drives.ts";
import { SECONDS } from "./play.ts";

/** Pictures a second, at most. */
const RATE = 25;
/** Width of a film in pixels; encoders want even numbers. */
const WIDTH = 1280;
/** Enough for thin lines to stay sharp. */
const BITS = 12_000_000;
/** Kinds of films, the best first. */
const KINDS = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];

/** Why there is no film: something was moved or changed, the page went out of sight, the drive does not move. */
export type Broken = "taken" | "hidden" | "stuck";

/**
 * A film is what the page shows: the drives run on the page, and the browser records it. The engine stays without an encoder,
 * which would make the page larger. Null where the browser records nothing.
 */
export function filming(app: App, gestures: Gestures, drives: Drives): App["film"] {
  const kind = typeof MediaRecorder === "undefined" ? undefined : KINDS.find((kind) => MediaRecorder.isTypeSupported(kind));
  if (kind === undefined || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  let letters: Promise<string> | undefined;
  let isRecording = false;

  /** Runs the drives once through their course while the canvas shows them. */
  const record = async (course: Course): Promise<Blob | Broken> => {
    const held = await gestures.start(course.what);
    if (held === null) return "taken";
    const follows = following(app, course.drive);
    const parts: Blob[] = [];
    const over = new AbortController();
    // A page out of sight has no next picture, and is not waited for.
    const hidden = new Promise((done) => document.addEventListener("visibilitychange", done, { signal: over.signal }));
    let recorder: MediaRecorder | undefined;
    try {
      const canvas = document.createElement("canvas");
      const paint = await painter(app, canvas, await (letters ??= lettersOf(app)));
      const made = (recorder = new MediaRecorder(canvas.captureStream(RATE), { mimeType: kind, videoBitsPerSecond: BITS }));
      made.ondataavailable = ({ data }) => void parts.push(data);
      const way = wayOf(course);
      const seconds = SECONDS * course.turns;
      await still(app, held, way(0));
      const broken = (): Broken | null => {
        if (!held.isHeld()) return "taken";
        if (document.hidden) return "hidden";
        return follows.isStuck() && follows.at() === course.from ? "stuck" : null;
      };
      made.start();
      const begin = performance.now();
      for (let share = 0; share < 1; share = (performance.now() - begin) / 1000 / seconds) {
        const why = broken();
        if (why !== null) return why;
        held.pull({ value: way(share) });
        await paint();
        await Promise.race([new Promise(requestAnimationFrame), hidden]);
      }
      await new Promise((done) => {
        made.onstop = done;
        made.stop();
      });
      return broken() ?? new Blob(parts, { type: kind.replace(/;.*/, "") });
    } finally {
      follows.end();
      over.abort();
      if (recorder?.state === "recording") recorder.stop();
      await held.cancel();
    }
  };

  return async () => {
    if (isRecording) return "taken";
    isRecording = true;
    try {
      await gestures.end();
      const course = await courseOf(app, drives.current());
      if (course === null || !(course.high > course.low)) return "stuck";
      return await record(course);
    } finally {
      isRecording = false;
    }
  };
}

/** Makes the canvas as large as the film, and gives what paints the page's picture on it. */
async function painter(app: App, canvas: HTMLCanvasElement, fonts: string): Promise<() => Promise<void>> {
  const { width, height } = app.picture.value!;
  [canvas.width, canvas.height] = [WIDTH, 2 * Math.round((WIDTH * height) / width / 2)];
  let painted: Picture | null = null;
  const paint = async (): Promise<void> => {
    const now = app.picture.value!;
    if (now === painted) return;
    painted = now;
    await draw(canvas, now.svg, fonts);
  };
  await paint();
  return paint;
}

/** Waits until plans that were larger at rest have the scales that they keep while they move. */
async function still(app: App, held: Gesture, value: number): Promise<void> {
  for (let before = ""; held.isHeld() && app.picture.value!.svg !== before; ) {
    const shown = app.picture.value!;
    before = shown.svg;
    held.pull({ value });
    while (held.isHeld() && app.picture.value === shown) await new Promise(requestAnimationFrame);
  }
}

/** The drive's value after a share of the film: all the way round, or to its ends and back. */
function wayOf({ from, low, high, isRound, sense, turns }: Course): (share: number) => number {
  const whole = high - low;
  if (isRound) return (share) => from + sense * turns * whole * share;
  return (share) => {
    const gone = (from - low + sense * 2 * whole * share) % (2 * whole);
    const at = gone < 0 ? gone + 2 * whole : gone;
    return low + Math.min(at, 2 * whole - at);
  };
}

/** The letters of the drawings, for pictures that cannot ask the page for them. */
async function lettersOf(app: App): Promise<string> {
  const faces = [false, true].map(async (isItalic) => {
    const bytes = await app.engine.font(isItalic);
    const text = bytes.reduce((all, byte) => all + String.fromCharCode(byte), "");
    return `@font-face{font-family:"Libertinus Serif";font-style:${isItalic ? "italic" : "normal"};src:url(data:font/otf;base64,${btoa(text)})}`;
  });
  return `<style>${(await Promise.all(faces)).join("")}</style>`;
}

async function draw(canvas: HTMLCanvasElement, svg: string, fonts: string): Promise<void> {
  const address = URL.createObjectURL(new Blob([svg.replace(/<svg\b[^>]*>/, (opening) => opening + fonts)], { type: "image/svg+xml" }));
  try {
    const picture = new Image();
    picture.src = address;
    await picture.decode();
    canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
  } finally {
    URL.revokeObjectURL(address);
  }
}
