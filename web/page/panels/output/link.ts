import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { copied } from "../../files/clipboard.ts";
import { link as sentences } from "../../sentences.ts";
import { baseOf } from "../../state/address.ts";
import { speaker } from "../../words.ts";

const say = speaker(sentences);

/** Links beyond this many characters are cut by some mail programs and chats. */
const LONG = 8000;

/** What whoever gives a link away should know of it. */
function warnings(size: number, page: string): string[] {
  const found = [];
  if (size > LONG) found.push(say("long", { size }));
  if (baseOf(page).startsWith("file:")) found.push(say("local"));
  return found;
}

/** The place of a link to be given away: it is copied, stands there to be copied by hand, and below it what to know of it. */
export function linkBox(app: App): { root: HTMLElement[]; isGiven(): boolean; give(link: string): Promise<void> } {
  const address = element("input", { type: "text", readonly: true, hidden: true, onfocus: () => address.select() });
  const about = element("p", { class: "quiet", role: "status" });
  return {
    root: [address, about],
    isGiven: () => !address.hidden,
    async give(link) {
      const size = link.length;
      address.value = link;
      address.hidden = false;
      address.setAttribute("aria-label", say("of", { size }));
      const isCopied = await copied(link);
      if (!isCopied) address.select();
      const warned = warnings(size, location.href);
      app.tell([isCopied ? say("copied", { size }) : say("not_copied"), ...warned].join(" "));
      about.className = warned.length > 0 ? "warned" : "quiet";
      about.textContent = [`${say("of", { size })}.`, ...warned].join(" ");
    },
  };
}
