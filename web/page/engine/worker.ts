/** The worker: it holds the engine and answers one call after the other. */
import init, { Engine } from "kinegon-wasm";

/** A call from the page. */
export interface Call {
  id: number;
  name: string;
  given: unknown[];
}

/** An answer: what was asked for, or a refusal as JSON. */
export type Answer = { id: number; value: unknown } | { id: number; refused: string };

type Anything = Record<string, (...given: unknown[]) => unknown>;

let engine: Anything | undefined;

/** Texts and numbers are handed over as they are, all else as JSON. */
function handed(given: unknown): unknown {
  return typeof given === "object" ? JSON.stringify(given) : given;
}

function answered({ id, name, given }: Call): Answer {
  try {
    const method = engine?.[name];
    if (method === undefined || engine === undefined) throw new Error(`the engine has no ${name}`);
    return { id, value: method.apply(engine, given.map(handed)) };
  } catch (error) {
    return { id, refused: typeof error === "string" ? error : JSON.stringify({ message: String(error), panicked: true }) };
  }
}

/** Settles when the engine is there. */
let started: Promise<unknown> = Promise.resolve();

async function start(wasm: ArrayBuffer): Promise<void> {
  await init({ module_or_path: wasm });
  engine = new Engine() as unknown as Anything;
}

self.onmessage = async ({ data }: MessageEvent<Call | { wasm: ArrayBuffer }>) => {
  if ("wasm" in data) {
    started = start(data.wasm);
  } else {
    await started;
    postMessage(answered(data));
  }
};
