import type { App } from "../app.ts";
import type { Picture } from "../engine/types.ts";
import type { Gestures } from "../picture/gesture.ts";
import { range, type Drives } from "./drives.ts";

/** Pictures a second, at most. */
const RATE = 25;
/** Width of a film in pixels; encoders want even numbers. */
const WIDTH = 1280;
/** Enough for thin lines to stay sharp. */
const BITS = 12_000_000;
/** Kinds of films, the best first. */
const KINDS = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];

/**
 * A film is what the page shows: the drive runs on the page, and the browser records it. The engine stays without an encoder,
 * which would make the page larger. Null where the browser records nothing.
 */
export function filming(app: App, gestures: Gestures, drives: Drives): App["film"] {
  const kind = typeof MediaRecorder === "undefined" ? undefined : KINDS.find((kind) => MediaRecorder.isTypeSupported(kind));
  if (kind === undefined || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  let letters: Promise<string> | undefined;

  return async (seconds = 6) => {
    const drive = drives.current();
    const held = drive && (await gestures.start({ kind: "drive", drive: drive.name }));
    if (!held) return null;
    const canvas = document.createElement("canvas");
    const { width, height } = app.picture.value!;
    [canvas.width, canvas.height] = [WIDTH, 2 * Math.round((WIDTH * height) / width / 2)];
    let painted: Picture | null = null;
    const fonts = await (letters ??= lettersOf(app));
    const paint = async (): Promise<void> => {
      const now = app.picture.value!;
      if (now === painted) return;
      painted = now;
      await draw(canvas, now.svg, fonts);
    };
    await paint();
    const recorder = new MediaRecorder(canvas.captureStream(RATE), { mimeType: kind, videoBitsPerSecond: BITS });
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => void parts.push(data);
    const stopped = new Promise((done) => (recorder.onstop = done));
    const way = wayOf(...range(drive), drive.value, drive.low === null || drive.high === null);
    recorder.start();
    const begin = performance.now();
    for (let share = 0; share < 1 && gestures.isActive(); share = (performance.now() - begin) / 1000 / seconds) {
      held.pull({ value: way(share) });
      await paint();
      await new Promise(requestAnimationFrame);
    }
    const isWhole = gestures.isActive();
    recorder.stop();
    await Promise.all([stopped, held.cancel()]);
    return isWhole ? new Blob(parts, { type: kind.replace(/;.*/, "") }) : null;
  };
}

/** The drive's value after a share of the film: all the way round, or to its ends and back. */
function wayOf(low: number, high: number, own: number, isRound: boolean): (share: number) => number {
  const whole = high - low;
  if (isRound) return (share) => own + whole * share;
  return (share) => {
    const at = (own - low + 2 * whole * share) % (2 * whole);
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
