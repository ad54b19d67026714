/** Bytes as letters. */
export function base85(bytes: Uint8Array): string;
/** Letters as bytes. */
export function bytesOf(text: string): Uint8Array<ArrayBuffer>;
