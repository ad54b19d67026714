/** One engine's file, one worker and one instance of WebAssembly for all plans of a page. */
import { XzReadableStream } from "xz-decompress";
import packed from "kinegon-engine.xz";
import worker from "kinegon-worker.txt";
import type { EngineClient } from "../page/engine/client.ts";
import { hand, type Hand, type Why } from "../page/engine/hand.ts";

/** Why the engine was started again, in the words of whoever is told. */
type Told = (why: Why) => string;

let shared: Promise<Hand> | undefined;
let number = 0;

async function started(told: Told): Promise<Hand> {
  const address = URL.createObjectURL(new Blob([worker], { type: "text/javascript" }));
  const file = new Response(new XzReadableStream(new Blob([packed]).stream()), { headers: { "content-type": "application/wasm" } });
  return hand(address, await WebAssembly.compileStreaming(file), { restarted: told, busy: () => undefined });
}

/** An engine for one plan, which keeps that plan's scene; `free` ends it. */
export async function engineFor(told: Told): Promise<EngineClient & { free(): Promise<void> }> {
  const all = await (shared ??= started(told));
  const own = (number += 1);
  const call = (name: string) => (...given: unknown[]) => all.call(name, given, own);
  // A promise asks what it resolves with for `then`; the engine has none.
  return new Proxy({}, { get: (_, name) => (name === "then" ? undefined : call(String(name))) }) as EngineClient & { free(): Promise<void> };
}
