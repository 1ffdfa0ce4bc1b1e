import type { Camera } from "../../src/candle-flame-element.ts";

/** What the hosted page opens on, as page.spec.ts has it: its camera, and the one from which the candle was put down. */
export const OPENING = {
  camera: { position: [-0.6, 1.6, 0.85], yaw: -0.57, pitch: -0.4 },
  candle: { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 },
} as const satisfies Readonly<Record<string, Camera>>;
