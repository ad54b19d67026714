/** The packed bytes of an element of the page, which are in Base64. */
export function packedBytes(id: string): Uint8Array<ArrayBuffer> {
  const letters = atob(document.getElementById(id)?.textContent?.trim() ?? "");
  const bytes = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index += 1) bytes[index] = letters.charCodeAt(index);
  return bytes;
}

/** The contents of an element of the page that is packed by gzip. `type` is what they are. */
export function unpacked(id: string, type: string): Response {
  const stream = new Blob([packedBytes(id)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream, { headers: { "Content-Type": type } });
}
