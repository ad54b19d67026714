import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { sheetElement } from "../picture/sheet.ts";
import { pagesFor } from "./pages.ts";

/** Prints sheets at their true size, each on a page of its own. */
export function printer(): App["print"] {
  const place = byId("print");
  const style = element("style");
  document.head.append(style);
  return (sheets) => {
    style.textContent = pagesFor(sheets);
    place.replaceChildren(
      ...sheets.map(({ svg, width, height }, index) => {
        const root = sheetElement(svg, `print-${index}`, "");
        root.setAttribute("width", `${width}mm`);
        root.setAttribute("height", `${height}mm`);
        return element("div", {}, root);
      }),
    );
    window.print();
  };
}

/** What the browser's own print command prints: the picture as it is on the screen, on a sheet of its own size. */
export function printedByBrowser(app: App): void {
  const place = byId("print");
  window.addEventListener("beforeprint", () => {
    const picture = app.picture.value;
    if (place.childElementCount > 0 || picture === null) return;
    const root = sheetElement(picture.svg, "print-0", "");
    place.append(element("div", { class: "own" }, root));
  });
  window.addEventListener("afterprint", () => place.replaceChildren());
}
