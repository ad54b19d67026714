import { say } from "./words.ts";

/** The text of a plan's scene: what stands between its tags, else what its `src` leads to. */
export async function sceneText(plan: HTMLElement): Promise<string> {
  const src = plan.getAttribute("src");
  if (src === null) {
    // What stands between the tags comes after the first of them.
    if (document.readyState === "loading") await new Promise((done) => document.addEventListener("DOMContentLoaded", done, { once: true }));
    const inside = plan.querySelector('script[type="application/json"]')?.textContent?.trim() ?? "";
    if (inside === "") throw new Error(say("none"));
    return inside;
  }
  const unread = (why: string): Error => new Error(say("unread", { src, why }));
  let answer: Response;
  try {
    answer = await fetch(src);
  } catch (why) {
    const { message } = unread((why as Error).message);
    throw new Error(location.protocol === "file:" ? `${message} ${say("from_file")}` : message);
  }
  if (!answer.ok) throw unread(`HTTP ${answer.status}`);
  return answer.text();
}
