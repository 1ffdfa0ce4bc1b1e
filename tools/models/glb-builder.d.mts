export function packGlb(json: unknown, binary: Uint8Array): Buffer;
// biome-ignore lint/suspicious/noExplicitAny: whatever a file holds.
export function openGlb(bytes: Buffer): { json: any; binary: Buffer };
