import type { Engine } from "./engine.ts";
import type { Refused } from "./types.ts";
import type { Answer } from "./worker.ts";

/** The engine as the page calls it: every function answers later, and refuses with {@link Refused}. */
export type EngineClient = {
  [Name in keyof Engine]: (...given: Parameters<Engine[Name]>) => Promise<ReturnType<Engine[Name]>>;
};

/** The functions whose answers are no JSON. */
const PLAIN = new Set(["drop", "edit", "choose_mode", "file", "read_form", "write_form", "exercise_file"]);

interface Waiting {
  name: string;
  done(value: unknown): void;
  refused(why: Refused): void;
}

/** Starts the engine in a worker. */
export function startEngine(script: string, wasm: ArrayBuffer): EngineClient {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(address);
  const waiting = new Map<number, Waiting>();
  let last = 0;
  worker.onmessage = ({ data }: MessageEvent<Answer>) => {
    const call = waiting.get(data.id);
    if (call === undefined) return;
    waiting.delete(data.id);
    if ("refused" in data) call.refused(JSON.parse(data.refused) as Refused);
    else call.done(PLAIN.has(call.name) ? data.value : JSON.parse(data.value as string));
  };
  worker.postMessage({ wasm }, [wasm]);
  const call = (name: string) => (...given: unknown[]) =>
    new Promise<unknown>((done, refused) => {
      last += 1;
      waiting.set(last, { name, done, refused });
      worker.postMessage({ id: last, name, given });
    });
  return new Proxy({}, { get: (_, name: string) => call(name) }) as EngineClient;
}
