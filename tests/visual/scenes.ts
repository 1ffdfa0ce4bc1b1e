import type { Camera, Look, Quality } from "../../src/candle-flame-element.ts";

/** One picture that must not change by accident. */
export interface Scene {
  readonly name: string;
  readonly attributes: {
    readonly look: Look;
    readonly seed: string;
    readonly quality?: Quality;
    readonly wind?: string;
    readonly moonlight?: string;
    readonly "lit-wicks"?: string;
  };
  readonly camera: Camera;
  /** Time simulated, seconds. */
  readonly seconds: number;
  /** Whether the candle is out, and the eye used to the dark. */
  readonly isOut?: boolean;
  /** Strength of a breath at the candle before that time, 0 to 1. */
  readonly breath?: number;
  /** Where the candle is put down first, as seen by a visitor who then goes to `camera`. */
  readonly place?: Camera;
}

/** A view of the cabin, a visitor's. */
type View = Pick<Scene, "name" | "camera" | "place">;

const SPAWN: View = {
  name: "spawn",
  camera: { position: [-1.55, 1.6, 1.3], yaw: -0.3 * Math.PI, pitch: -0.08 },
};
const TABLE: View = {
  name: "table",
  place: { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 },
  camera: { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 },
};
const CLOSE: View = {
  name: "close",
  place: { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 },
  camera: { position: [0, 1.08, 0.61], yaw: -0.7, pitch: -0.3 },
};
const CABIN: readonly View[] = [
  SPAWN,
  TABLE,
  {
    name: "hearth",
    place: { position: [-0.5, 1.6, -0.5], yaw: 0, pitch: -1.27 },
    camera: { position: [-0.3, 1.3, 0.6], yaw: 0.165, pitch: -0.202 },
  },
  {
    name: "window",
    camera: { position: [0.6, 1.5, -0.75], yaw: -1.45, pitch: -0.1 },
  },
  CLOSE,
];

/** A view of the cabin at a tier, half a second after it opens. */
function inCabin(
  { name: view, ...rest }: View,
  quality: Quality,
  {
    name = `cabin-${view}-${quality}`,
    ...more
  }: Partial<Scene["attributes"]> & { name?: string } = {},
): Scene {
  const attributes = { look: "physical", seed: "1", quality, ...more } as const;
  return { name, attributes, ...rest, seconds: 0.5 };
}

function byMoonAndCandles(quality: Quality): Scene[] {
  const moon = inCabin(SPAWN, quality, { name: `cabin-moon-${quality}`, moonlight: "0.15" });
  return [
    inCabin(SPAWN, quality, { name: `cabin-candles-${quality}`, "lit-wicks": "0 1 2 3" }),
    { ...moon, isOut: true },
  ];
}

/** In an order that changes the tier seldom: each change prepares the room's light anew. */
export const SCENES: readonly Scene[] = [
  {
    name: "paper-front",
    attributes: { look: "paper", seed: "1", quality: "medium" },
    camera: { position: [1.2, 1.6, 2.6], yaw: 0.35, pitch: 0 },
    seconds: 1,
  },
  {
    name: "paper-close",
    attributes: { look: "paper", seed: "1", quality: "medium" },
    place: { position: [0, 1.6, 0.9], yaw: 0, pitch: 0 },
    camera: { position: [0.08, 0.5, 0.44], yaw: 0.18, pitch: -0.42 },
    seconds: 1,
  },
  {
    name: "paper-corner",
    attributes: { look: "paper", seed: "2", quality: "medium" },
    camera: { position: [-3.4, 1.6, -3.6], yaw: 0.9, pitch: -0.1 },
    seconds: 0.1,
  },
  {
    name: "original-front",
    attributes: { look: "original", seed: "1", quality: "medium" },
    camera: { position: [1.2, 1.6, 2.6], yaw: 0.35, pitch: 0 },
    seconds: 1,
  },
  {
    name: "original-close",
    attributes: { look: "original", seed: "1", quality: "medium" },
    camera: { position: [0.15, 1.35, 0.95], yaw: 0.15, pitch: -0.1 },
    seconds: 1,
  },
  {
    name: "original-corner",
    attributes: { look: "original", seed: "2", quality: "medium" },
    camera: { position: [-3.4, 1.6, -3.6], yaw: 0.9, pitch: -0.1 },
    seconds: 0.1,
  },
  ...CABIN.map((view) => inCabin(view, "low")),
  inCabin(SPAWN, "low", { name: "cabin-moonlit-low", moonlight: "0.15" }),
  ...byMoonAndCandles("low"),
  ...CABIN.map((view) => inCabin(view, "high")),
  inCabin(SPAWN, "high", { name: "cabin-moonlit-high", moonlight: "0.15" }),
  { ...inCabin(CLOSE, "medium", { name: "cabin-wind", wind: "0.8" }), seconds: 1.5 },
  {
    // Smoke shows by the light of the candles that still burn.
    ...inCabin(CLOSE, "medium", { name: "cabin-smoke", wind: "0.05", "lit-wicks": "0 1 2 3" }),
    breath: 1,
    seconds: 2,
  },
  ...byMoonAndCandles("medium"),
  inCabin(TABLE, "ultra"),
];
