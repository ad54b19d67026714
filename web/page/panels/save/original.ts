/** The page's own text as it was loaded, before anything of it was changed, so that it can be saved with another scene inside. */

const MARK = '<script type="application/json" id="kinegon-scene">';
const END = "</script>\n";

/** The text of the page's file: what the browser gives back, with the white space that it leaves out. */
const loaded = `<!DOCTYPE html>\n${document.documentElement.outerHTML}`
  .replace(/(<html[^>]*>)<head>/, "$1\n<head>")
  .replace(/\n*<\/body><\/html>$/, "\n</body>\n</html>\n");

/** The page as a file with this scene inside, as `kinegon draw SCENE -o page.html` writes it; null where it was not loaded whole. */
export function pageWith(text: string, step: number | null): string | null {
  const end = loaded.indexOf("</head>");
  if (end < 0) return null;
  const scene = loaded.lastIndexOf(MARK, end);
  const head = loaded.slice(0, scene < 0 ? end : scene);
  return `${head}${MARK}${inert(JSON.stringify({ text, step }))}${END}${loaded.slice(end)}`;
}

/** JSON in letters that nothing obeys: whatever a stranger has written, it ends no element. */
function inert(json: string): string {
  return json.replace(/[^ -;=-~]/g, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`);
}
