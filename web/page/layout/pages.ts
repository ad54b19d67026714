/** The pages for sheets of these sizes, each as large as its sheet and without a margin of the browser's. */
export function pagesFor(sheets: readonly { width: number; height: number }[]): string {
  const [first] = sheets;
  if (first === undefined) return "";
  // Where a browser knows no pages by name, all are as large as the first.
  const named = sheets.map(({ width, height }, index) => `@page sheet-${index} { size: ${width}mm ${height}mm; margin: 0; }`);
  // A little less than the page, which browsers round; else an empty one would follow. That is margin.
  const placed = sheets.map(({ width, height }, index) => `#print > :nth-child(${index + 1}) { page: sheet-${index}; width: ${width}mm; height: ${height - 0.5}mm; }`);
  return [`@page { size: ${first.width}mm ${first.height}mm; margin: 0; }`, ...named, `@media print { ${placed.join(" ")} }`].join("\n");
}
