/** The worker: it holds the engine and answers one call after the other. */
import init, { Engine } from "kinegon-wasm";

/** A call from the page. */
export interface Call {
  name: string;
  given: unknown[];
  /** Which engine is called: each keeps a scene of its own, and all are in the same instance of WebAssembly. */
  of: number;
  /** The page's language, in which the engine tells what stands beside the picture. */
  language: string;
}

/** An answer: what was asked for, a refusal as JSON, or that the engine fell. `took` is the engine's time in ms. */
export type Answer = { value: unknown; took: number } | { refused: string; took: number } | { fell: string };

type Anything = Record<string, (...given: unknown[]) => unknown>;

const engines = new Map<number, { engine: Anything; spoken: string }>();

/** The engine of this number, which is made when it is called first. */
function engineOf(number: number): { engine: Anything; spoken: string } {
  const known = engines.get(number) ?? { engine: new Engine() as unknown as Anything, spoken: "" };
  engines.set(number, known);
  return known;
}

/** Texts, numbers and bytes are handed over as they are, all else as JSON. */
function handed(given: unknown): unknown {
  return typeof given === "object" && !(given instanceof Uint8Array) ? JSON.stringify(given) : given;
}

function answered({ name, given, language, of }: Call): Answer {
  const begin = performance.now();
  const took = (): number => performance.now() - begin;
  try {
    const own = engineOf(of);
    const { engine } = own;
    if (language !== own.spoken) engine["speak"]?.(language);
    own.spoken = language;
    if (name === "free") engines.delete(of);
    const method = engine[name];
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
  engineOf(0);
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
