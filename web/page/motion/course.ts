import type { Shown } from "../app.ts";
import type { Drive, Grab } from "../engine/types.ts";
import { range } from "./drives.ts";

/** How the mechanism runs: what is taken hold of, and the values through which that is pulled. */
export interface Course {
  what: Grab;
  /** The drive that is pulled. */
  drive: string;
  /** Where it stands. */
  from: number;
  low: number;
  high: number;
  /** Whether it turns all the way round; else it goes to and fro. */
  isRound: boolean;
  /** The sense in which it begins, as the scene says. */
  sense: 1 | -1;
  /** The turns, or the ways to and fro, after which it begins again. */
  turns: number;
  /** Whether several drives run. */
  isTogether: boolean;
}

/**
 * All drives run together, in proportion to their speeds, as time moves them. Of a scene whose drives have no speed the one runs that
 * was touched last. Null where nothing can run.
 */
export async function courseOf(app: Shown, touched: Drive | undefined): Promise<Course | null> {
  await known(app);
  const { good } = app.solved.value;
  const runs = await app.engine.running(good);
  const drives = app.picture.value?.drives ?? [];
  const drive = runs === null ? touched : drives.find(({ name }) => name === runs.drive);
  if (drive === undefined) return null;
  const led = runs === null ? drive : { ...drive, low: runs.low, high: runs.high };
  const [low, high] = range(led);
  return {
    what: runs === null ? { kind: "drive", drive: drive.name } : { kind: "run", drive: drive.name },
    drive: drive.name,
    from: drive.value,
    low,
    high,
    isRound: drive.is_angle && led.low === null && led.high === null,
    sense: runs?.is_backwards ? -1 : 1,
    turns: runs?.turns ?? 1,
    isTogether: runs !== null && drives.length > 1,
  };
}

/** Waits until the engine has said what the present text means: what was held may just have changed it. */
function known(app: Shown): Promise<void> {
  const is = (): boolean => app.solved.value.text === app.history.now.value.text;
  if (is()) return Promise.resolve();
  return new Promise((done) => {
    const end = app.solved.on(() => {
      if (!is()) return;
      end();
      done();
    });
  });
}

/** How many pictures without a motion tell that something stops the drive. */
const STILL = 6;

/** Watches whether the drive follows where it is pulled. */
export function following(app: Shown, drive: string): { isStuck(): boolean; again(): void; at(): number; end(): void } {
  const at = (): number => app.picture.value?.drives.find(({ name }) => name === drive)?.value ?? Number.NaN;
  let last = at();
  let still = -1;
  const end = app.picture.on(() => {
    const now = at();
    still = now === last ? still + 1 : 0;
    last = now;
  });
  return { isStuck: () => still >= STILL, again: () => (still = 0), at, end };
}
