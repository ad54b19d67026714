import { signal } from "../../state/signal.ts";

/** Widths to choose from, in pixels: for a page of text, a projector, a poster. */
export const WIDTHS = ["1200", "1920", "3840"] as const;

/** The width that is chosen; that of a projector is sharp on paper, too. */
export const pngWidth = signal<(typeof WIDTHS)[number]>("1920");

/** Most pixels of a picture: telephones make none that are larger. */
const MOST = 4096 * 4096;

/** A sheet as PNG, drawn by the browser: the engine stays a quarter smaller without a renderer of its own. */
export async function png(svg: Uint8Array): Promise<Uint8Array> {
  const text = new TextDecoder().decode(svg);
  const [width, height] = ["width", "height"].map((name) => Number(new RegExp(`\\b${name}="([\\d.]+)mm"`).exec(text)?.[1])) as [number, number];
  const address = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  try {
    const picture = new Image();
    picture.src = address;
    await picture.decode();
    const canvas = document.createElement("canvas");
    const dots = Math.min(Number(pngWidth.value) / width, Math.sqrt(MOST / (width * height)));
    [canvas.width, canvas.height] = [Math.round(width * dots), Math.round(height * dots)];
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("this browser draws no pictures");
    context.fillStyle = "white";
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
    if (blob === null) throw new Error("this browser makes no PNG");
    // Its pixels are let go at once, not when the browser gets round to it.
    canvas.width = canvas.height = 0;
    return new Uint8Array(await blob.arrayBuffer());
  } finally {
    URL.revokeObjectURL(address);
  }
}
