/** Most signs of a line that is put into the editor, texts in quotes not counted: a browser lays out all of a line, however little of it is seen. */
const LONGEST = 10_000;

const QUOTED = /"(?:[^"\\]|\\.)*"?/g;

/** Whether a text has a line that is too long for the editor, and may be broken. */
export function hasLongLine(text: string): boolean {
  return text.length > LONGEST && text.split(/[\r\n]/).some((line) => line.length > LONGEST && line.replace(QUOTED, '""').length > LONGEST);
}

/** How deep a text is broken into lines: a link has a line of its own. */
const DEEP = 2;

/** The text with a line for each key of the scene, and for each thing that it holds; all signs but blanks stay as they are, also where it is no JSON yet. */
export function inLines(text: string): string {
  const signs = text.match(/"(?:[^"\\]|\\.)*"?|[[\]{},:]|[^"[\]{},:\s\uFEFF]+/g) ?? [];
  let depth = 0;
  const broken = (otherwise: string): string => (depth <= DEEP ? `\n${"  ".repeat(depth)}` : otherwise);
  const laid = signs.map((sign, index) => {
    const [before, after] = [signs[index - 1], signs[index + 1]];
    switch (sign) {
      case "{":
      case "[":
        depth += 1;
        return after === "}" || after === "]" ? sign : sign + broken(sign === "{" ? " " : "");
      case "}":
      case "]": {
        const isBroken = depth <= DEEP;
        depth = Math.max(0, depth - 1);
        if (before === "{" || before === "[") return sign;
        return (isBroken ? broken("") : sign === "}" ? " " : "") + sign;
      }
      case ",":
        return sign + broken(" ");
      default:
        return sign === ":" ? ": " : sign;
    }
  });
  return `${laid.join("")}\n`;
}
