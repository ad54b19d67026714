/** Starts the page: its style and its script are packed as the engine is. */
import { unpacked } from "./unpack.ts";

async function start(): Promise<void> {
  // Neither is left in the page, which stays as its file has it: it saves itself.
  const style = new CSSStyleSheet();
  style.replaceSync(await unpacked("style", "text/css").text());
  document.adoptedStyleSheets = [style];
  window.unpacked = unpacked;
  const element = document.createElement("script");
  element.src = URL.createObjectURL(await unpacked("script", "text/javascript").blob());
  document.head.append(element);
  element.remove();
}

start().catch((error: unknown) => {
  document.body.style.visibility = "visible";
  const place = document.getElementById("message");
  if (place !== null) {
    place.hidden = false;
    place.textContent = `This browser is too old for the page. · Este navegador es demasiado antiguo para la página. (${String(error)})`;
  }
});
