// What is dragged: which picture is shown last.
import assert from "node:assert/strict";
import test from "node:test";
import type { Shown } from "../../web/page/app.ts";
import type { Picture, View } from "../../web/page/engine/types.ts";
import { gestures } from "../../web/page/picture/gesture.ts";
import { signal } from "../../web/page/state/signal.ts";

const picture = (svg: string) => ({ svg }) as Picture;

test("what is answered after a gesture was broken off does not cover the document's picture", async () => {
  const frames: (() => void)[] = [];
  globalThis.requestAnimationFrame = (frame) => frames.push(() => frame(0));
  let answer: (picture: Picture) => void = assert.fail;
  const engine = {
    grab: async () => picture("held"),
    drag: () => new Promise<Picture>((done) => (answer = done)),
    drop: async () => "text",
  };
  const app = {
    engine,
    solved: signal({ good: "text", text: "text", refused: null }),
    student: signal(false),
    history: { now: signal({ text: "text" }) },
    tell: assert.fail,
  } as unknown as Shown;
  const pictures: string[] = [];
  const show = ({ svg }: Picture): void => void pictures.push(svg);
  const held = await gestures(app, signal({} as View), show, { again: () => show(picture("document")), ease: assert.fail }).start({ kind: "shape" } as never);
  held!.pull({ value: 1 } as never);
  const over = held!.cancel();
  answer(picture("late"));
  await over;
  // The screen shows a frame only now.
  while (frames.length > 0) frames.shift()!();
  assert.deepEqual(pictures, ["held", "document"]);
});
