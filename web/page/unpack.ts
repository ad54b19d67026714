/** The contents of a packed element of the page: gzip, as Base64. */
export async function unpacked(id: string): Promise<ArrayBuffer> {
  const packed = document.getElementById(id)?.textContent?.trim() ?? "";
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return await new Response(stream).arrayBuffer();
}
