/** The worker: it holds the engine and answers one call after the other. */
import init, { Engine } from "kinegon-wasm";

/** A call from the page. */
export interface Call {
  name: string;
  given: unknown[];
  /** The page's language, in which the engine tells what stands beside the picture. */
  language: string;
}

/** An answer: what was asked for, a refusal as JSON, or that the engine fell. `took` is the engine's time in ms. */
export type Answer = { value: unknown; took: number } | { refused: string; took: number } | { fell: string };

type Anything = Record<string, (...given: unknown[]) => unknown>;

let engine: Anything | undefined;

/** Texts, numbers and bytes are handed over as they are, all else as JSON. */
function handed(given: unknown): unknown {
  return typeof given === "object" && !(given instanceof Uint8Array) ? JSON.stringify(given) : given;
}

let spoken = "";

function answered({ name, given, language }: Call): Answer {
  const begin = performance.now();
  const took = (): number => performance.now() - begin;
  try {
    if (language !== spoken) engine?.["speak"]?.(language);
    spoken = language;
    const method = engine?.[name];
    if (method === undefined) {
      const message = `the engine has no ${name}`;
      return { refused: JSON.stringify({ message, hint: null, path: "", from: null, to: null, line: null, column: null }), took: took() };
    }
    return { value: method.apply(engine, given.map(handed)), took: took() };
  } catch (error) {
    return typeof error === "string" ? { refused: error, took: took() } : { fell: String(error) };
  }
}

/** Settles when the engine is there. */
let started: Promise<unknown> = Promise.resolve();

async function start(module: WebAssembly.Module): Promise<void> {
  await init({ module_or_path: module });
  engine = new Engine() as unknown as Anything;
}

self.onmessage = async ({ data }: MessageEvent<Call | { module: WebAssembly.Module }>) => {
  if ("module" in data) {
    started = start(data.module);
    return;
  }
  try {
    await started;
    postMessage(answered(data));
  } catch (error) {
    postMessage({ fell: String(error) } satisfies Answer);
  }
};
