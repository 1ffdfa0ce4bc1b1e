export function packGlb(json: unknown, binary: Uint8Array): Buffer;
