import { signal, type Signal } from "../state/signal.ts";
import type { Engine } from "./engine.ts";
import { hand, type Hand, type Watch } from "./hand.ts";

/** The engine as the page calls it: every function answers later, and rejects with {@link Refused}. */
export type EngineClient = {
  [Name in keyof Engine]: (...given: Parameters<Engine[Name]>) => Promise<ReturnType<Engine[Name]>>;
};

/** What the picture waits for; photographs and everything else have workers of their own, so that no curve and no check stops a hand. */
const AT_ONCE = new Set(["kinds", "open", "picture", "running", "grab", "drag", "drop", "edit", "edit_in_place", "move_points", "drafted", "load_table", "places", "font", "board", "board_snap", "board_picture"]);
const OF_PHOTOGRAPHS = new Set(["photo", "photo_proposed", "photo_tap", "photo_points"]);

/** Starts the engine in a worker, and in others as soon as something slow is asked for, or a photograph comes. */
export function startEngine(
  script: string,
  module: WebAssembly.Module,
  restarted: Watch["restarted"],
): { engine: EngineClient; busy: Signal<boolean>; stop(): void } {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const busy = signal(false);
  const working = new Set<string>();
  const named = (name: string) =>
    hand(address, module, {
      restarted,
      busy(is) {
        if (is) working.add(name);
        else working.delete(name);
        busy.set(working.size > 0);
      },
    });
  const first = named("picture");
  let second: Hand | undefined;
  let third: Hand | undefined;
  const call = (name: string) => (...given: unknown[]) => {
    if (AT_ONCE.has(name)) return first.call(name, given);
    return (OF_PHOTOGRAPHS.has(name) ? (third ??= named("photographs")) : (second ??= named("panels"))).call(name, given);
  };
  // A promise asks what it resolves with for `then`; the engine has none.
  const engine = new Proxy({}, { get: (_, name) => (name === "then" ? undefined : call(String(name))) }) as EngineClient;
  return { engine, busy, stop: () => [first, second, third].forEach((each) => each?.stop()) };
}
