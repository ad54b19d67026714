import { element } from "../dom/element.ts";

/** Names that Windows keeps for devices. */
const DEVICES = /^(con|prn|aux|nul|com\d|lpt\d)$/;

/** The longest name of a file, without its ending. */
const LONGEST = 60;

/** Words as the name of a file on any computer, without an ending: letters, digits and hyphens. */
export function fileName(...words: (string | undefined)[]): string {
  const text = words.filter(Boolean).join(" ").normalize("NFC").toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-");
  const name = [...text].slice(0, LONGEST).join("").replace(/^-+|-+$/g, "");
  return name === "" || DEVICES.test(name) ? ["kinegon", name].filter(Boolean).join("-") : name;
}

/** Lets the browser save a file. */
export function saveFile(name: string, contents: Uint8Array | string, type: string): void {
  const address = URL.createObjectURL(new Blob([contents as BlobPart], { type }));
  const link = element("a", { href: address, download: name, hidden: true });
  document.body.append(link);
  link.click();
  link.remove();
  // A browser may begin reading only after it has asked where to.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
