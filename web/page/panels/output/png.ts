/** Dots for each mm of paper: 100 dpi, as the program has by itself. */
const DOTS = 100 / 25.4;

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
    [canvas.width, canvas.height] = [Math.round(width * DOTS), Math.round(height * DOTS)];
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("this browser draws no pictures");
    context.fillStyle = "white";
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
    if (blob === null) throw new Error("this browser makes no PNG");
    return new Uint8Array(await blob.arrayBuffer());
  } finally {
    URL.revokeObjectURL(address);
  }
}
