import type { EngineClient } from "./engine/client.ts";

/** Makes the letters of the drawings known to the page; they are those that the engine sets its PDF files with. */
export async function loadFonts(engine: EngineClient): Promise<void> {
  for (const style of ["normal", "italic"] as const) {
    const bytes = await engine.font(style === "italic");
    document.fonts.add(new FontFace("Libertinus Serif", bytes as BufferSource as ArrayBuffer, { style }));
  }
}
