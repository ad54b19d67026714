/** Starts the page's script, which is packed as the engine is. */
import { unpacked } from "./unpack.ts";

async function start(): Promise<void> {
  const element = document.createElement("script");
  element.src = URL.createObjectURL(await unpacked("script", "text/javascript").blob());
  document.head.append(element);
  // It runs all the same, and the page stays as its file has it.
  element.remove();
}

start().catch((error: unknown) => {
  const place = document.getElementById("message");
  if (place === null) return;
  place.hidden = false;
  place.textContent = `This browser is too old for the page. · Este navegador es demasiado antiguo para la página. (${String(error)})`;
});
