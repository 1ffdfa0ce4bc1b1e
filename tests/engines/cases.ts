import type { Camera, Look, Quality } from "../../src/candle-flame-element.ts";
import { SCENES } from "../visual/scenes.ts";

/** CSS pixels of the element's box, at which its canvas has 320 x 180 (at ultra 321): tiers scale it. */
const BOXES: Readonly<Record<Quality, readonly [width: number, height: number]>> = {
  low: [480, 270],
  medium: [320, 180],
  high: [320, 180],
  ultra: [214, 120],
  auto: [320, 180],
};

/** An element of the package, whose picture is compared. */
export interface ElementCase {
  readonly kind: "element";
  readonly name: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly box: readonly [width: number, height: number];
  readonly camera?: Camera;
  readonly place?: Camera | undefined;
  /** Seconds; each is stepped, and drawn. */
  readonly steps: readonly number[];
  /** What the camera moves by with each step, while the animation runs, metres. */
  readonly stride?: readonly [x: number, y: number, z: number];
}

/** A page as it is hosted, which is to come up and to say nothing. */
export interface PageCase {
  readonly kind: "page";
  readonly name: string;
  readonly path: string;
}

export type Case = ElementCase | PageCase;

/** So many frames that what is kept of one shows in the next. */
const STEPS = [0.25, 0.1, 0.1, 0.05] as const;

/** One view of each look: the candle near, and what it lights. */
const VIEWS: Readonly<Record<Look, string>> = {
  physical: "cabin-table-high",
  paper: "paper-front",
  original: "original-front",
};

function inRoom(look: Look, quality: Quality): ElementCase {
  const scene = SCENES.find(({ name }) => name === VIEWS[look]);
  if (!scene) throw new Error(`There is no scene ${VIEWS[look]}.`);
  const { camera, place } = scene;
  const attributes = { look, quality, seed: "1" };
  return {
    kind: "element",
    name: `${look}, ${quality}`,
    attributes,
    box: BOXES[quality],
    camera,
    place,
    steps: STEPS,
  };
}

const LONE: ElementCase = {
  kind: "element",
  name: "lone candle",
  attributes: { scene: "candle", quality: "low", seed: "1" },
  box: BOXES.low,
  steps: STEPS,
};

const WREATH: ElementCase = {
  ...LONE,
  name: "advent wreath",
  attributes: { ...LONE.attributes, src: "models/wreath.glb" },
};

/** In frames that follow each other, until its surfaces are a sum of images. */
const PLAYING_WREATH: ElementCase = {
  ...WREATH,
  name: "advent wreath, playing",
  steps: Array.from({ length: 40 }, () => 1 / 60),
  stride: [0, 0, 0],
};

function fourCandles(quality: Quality): ElementCase {
  const room = inRoom("physical", quality);
  const attributes = { ...room.attributes, "lit-wicks": "0 1 2 3" };
  return { ...room, name: `four candles, ${quality}`, attributes };
}

/** Moonlight alone, as bright as it may be: the candle is out. */
function moonAlone(quality: Quality): ElementCase {
  const room = inRoom("physical", quality);
  const attributes = { ...room.attributes, unlit: "", moonlight: "0.3" };
  return { ...room, name: `moon alone, ${quality}`, attributes };
}

/** Frames in motion, each from the ones before; from medium on a GPU keeps a part of them. */
function inMotion(one: ElementCase): ElementCase {
  return {
    ...one,
    name: `${one.name}, in motion`,
    attributes: { ...one.attributes, "data-gpu": "" },
    place: undefined,
    stride: [0.02, 0, 0.01],
  };
}

const HOSTED: PageCase = { kind: "page", name: "hosted page, auto", path: "" };

/** What `npm test` looks at. The hosted page is at `low`. */
export const SHORT: readonly Case[] = [
  LONE,
  inRoom("paper", "low"),
  inRoom("original", "low"),
  inRoom("physical", "medium"),
  HOSTED,
];

const LOOKS: readonly Look[] = ["physical", "paper", "original"];
const TIERS: readonly Quality[] = ["low", "medium", "high", "ultra"];

/** The matrix of `npm run test:engines`. */
export const LONG: readonly Case[] = [
  LONE,
  WREATH,
  PLAYING_WREATH,
  ...LOOKS.flatMap((look) => TIERS.map((quality) => inRoom(look, quality))),
  fourCandles("low"),
  fourCandles("medium"),
  moonAlone("low"),
  moonAlone("medium"),
  inMotion(inRoom("physical", "low")),
  inMotion(inRoom("physical", "medium")),
  inMotion(moonAlone("medium")),
  HOSTED,
  { kind: "page", name: "how.html", path: "how.html" },
  { kind: "page", name: "use.html", path: "use.html" },
];
