/**
 * An animated WebP of still ones that have no alpha. It repeats for ever.
 *
 * Each frame is whole: an encoder that stores differences takes dark pixels for equal, and leaves ghosts.
 * The container is that of Google 2024, "WebP Container Specification" (RFC 9649).
 */
export function animatedWebp(
  stills: readonly Buffer[],
  { width, height }: { readonly width: number; readonly height: number },
  milliseconds: number,
): Buffer {
  const size = [...uint24(width - 1), ...uint24(height - 1)];
  const frames = stills.map((still) => {
    const head = [...uint24(0), ...uint24(0), ...size, ...uint24(milliseconds), DO_NOT_BLEND];
    return chunk("ANMF", Buffer.from(head), still.subarray(RIFF_HEADER));
  });
  return chunk(
    "RIFF",
    Buffer.from("WEBP"),
    chunk("VP8X", Buffer.from([IS_ANIMATED, 0, 0, 0, ...size])),
    chunk("ANIM", Buffer.alloc(6)),
    ...frames,
  );
}

/** Bytes of "RIFF", the file's length and "WEBP". */
const RIFF_HEADER = 12;
const IS_ANIMATED = 0b10;
const DO_NOT_BLEND = 0b10;

const uint24 = (value: number) => [value & 255, (value >> 8) & 255, value >> 16];

function chunk(name: string, ...parts: readonly Buffer[]): Buffer {
  const data = Buffer.concat(parts);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(data.length);
  return Buffer.concat([Buffer.from(name), length, data, Buffer.alloc(data.length % 2)]);
}
