import type { Shown } from "./app.ts";
import type { Refused } from "./engine/types.ts";
import { refused as sentences } from "./sentences.ts";
import { speaker } from "./words.ts";

const say = speaker(sentences);

/** The sentence of a refusal, with what to try. */
export function said(refused: unknown): string {
  const { message, hint } = refused as Partial<Refused>;
  return [message ?? String(refused), hint].filter(Boolean).join(" ");
}

/** What is wrong with the scene's text, with its line. */
export function withLine({ line, message }: Refused): string {
  return line === null ? message : say("line", { line, message });
}

/** Does something; what the engine refuses is told. */
export async function orTell(app: Pick<Shown, "tell">, act: () => Promise<void>): Promise<void> {
  try {
    await act();
  } catch (refused) {
    app.tell(said(refused));
  }
}
