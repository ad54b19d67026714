/** Most pixels that are looked at: those of a usual telephone, and less than what browsers have room for. */
const MOST = 12.5e6;
/** Rows that are read at a time. */
const ROWS = 512;

/** A photograph in the page: itself, then halves, quarters, …, so that what is drawn small does not flicker. */
export interface Photograph {
  /** The file's name. */
  name: string;
  width: number;
  height: number;
  levels: HTMLCanvasElement[];
}

function canvas(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const made = document.createElement("canvas");
  Object.assign(made, { width, height });
  const context = made.getContext("2d", { alpha: false, willReadFrequently: true });
  if (context === null) throw new Error("no canvas");
  context.imageSmoothingQuality = "high";
  return [made, context];
}

/** The photograph of a file, upright as its camera says; null where the browser cannot decode it. */
export async function photograph(file: File): Promise<Photograph | null> {
  try {
    const bitmap = await createImageBitmap(file, { imageOrientation: "from-image" });
    const share = Math.min(1, Math.sqrt(MOST / (bitmap.width * bitmap.height)));
    const [width, height] = [Math.max(1, Math.round(bitmap.width * share)), Math.max(1, Math.round(bitmap.height * share))];
    const [first, context] = canvas(width, height);
    context.drawImage(bitmap, 0, 0, width, height);
    bitmap.close();
    return { name: file.name, width, height, levels: levelsOf(first) };
  } catch {
    return null;
  }
}

function levelsOf(first: HTMLCanvasElement): HTMLCanvasElement[] {
  const levels = [first];
  for (let last = first; Math.max(last.width, last.height) > 600; ) {
    const [half, context] = canvas(Math.ceil(last.width / 2), Math.ceil(last.height / 2));
    context.drawImage(last, 0, 0, last.width / 2, last.height / 2);
    levels.push(half);
    last = half;
  }
  return levels;
}

/** The photograph turned clockwise by quarters. */
export function turned(photo: Photograph, quarters: number): Photograph {
  if (quarters === 0) return photo;
  const { width, height } = photo;
  const [wide, high] = quarters % 2 === 0 ? [width, height] : [height, width];
  const [made, context] = canvas(wide, high);
  context.translate(wide / 2, high / 2);
  context.rotate((quarters * Math.PI) / 2);
  context.drawImage(photo.levels[0]!, -width / 2, -height / 2);
  return { ...photo, width: wide, height: high, levels: levelsOf(made) };
}

/** Its brightness, row by row. */
export function greyOf({ width, height, levels }: Photograph): Uint8Array {
  const context = levels[0]!.getContext("2d")!;
  const grey = new Uint8Array(width * height);
  let to = 0;
  for (let top = 0; top < height; top += ROWS) {
    const { data } = context.getImageData(0, top, width, Math.min(ROWS, height - top));
    for (let from = 0; from < data.length; from += 4) grey[to++] = (77 * data[from]! + 150 * data[from + 1]! + 29 * data[from + 2]!) >> 8;
  }
  return grey;
}
