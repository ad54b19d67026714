import { element } from "../../dom/element.ts";
import { button } from "../../dom/worded.ts";
import { sheet, type Sheet } from "../output/sheet.ts";
import { say } from "./words.ts";

/** A picture in all the room of the window; `show` opens it. */
export function large(): { root: HTMLElement; picture: Sheet; show(svg: string, width: number, height: number): void } {
  const picture = sheet(false);
  const root = element("dialog", { class: "large" }, button(() => say("close"), () => root.close()), picture.root);
  return {
    root,
    picture,
    show(svg, width, height) {
      picture.show(svg);
      picture.root.style.setProperty("--aspect", String(width / height));
      root.showModal();
    },
  };
}
