/**
 * Compiled by `tsc`, never run: what TypeScript knows of the tag, its events and its attributes. What must
 * not compile says so with `@ts-expect-error`, which fails where it does compile.
 */
import type {
  CandleFlameAttributes,
  CandleFlameElement,
  CandleFlameListeners,
  CandleFlameProperties,
  FlameReport,
} from "../../src/candle-flame-element.ts";

export function tag(): CandleFlameElement | null {
  const made: CandleFlameElement = document.createElement("candle-flame");
  made.look = "paper";
  made.windDirection = 90;
  // @ts-expect-error: no such look
  made.look = "vivid";
  // @ts-expect-error: told by the element alone
  made.currentTime = 3;
  return document.querySelector("candle-flame");
}

export function events(element: CandleFlameElement): void {
  const listener = (event: CustomEvent<{ readonly totalProgress: number }>): number =>
    event.detail.totalProgress;
  element.addEventListener("progress", listener);
  element.removeEventListener("progress", listener);
  element.addEventListener("error", ({ detail }) => {
    const { type, message }: { type: string; message: string } = detail;
    // @ts-expect-error: no such type of error
    if (detail.type === "weather") throw new Error(type + message);
  });
  element.addEventListener("light", function () {
    const flame: FlameReport | null = this.flame;
    void flame;
  });
  element.addEventListener("click", (event) => event.preventDefault());
  element.addEventListener("keydown", ({ key }) => key.length);
  // @ts-expect-error: a sheet of paper, not of music
  element.addEventListener("load", ({ detail }) => detail.volume);
}

export const attributes: CandleFlameAttributes = {
  scene: "candle",
  "wind-direction": "90",
  paused: "",
  seed: 7,
  // @ts-expect-error: no such quality
  quality: "best",
};

export const properties: CandleFlameProperties = {
  windDirection: 90,
  paused: true,
  lit: false,
  camera: { yaw: 1 },
  features: { bloom: false },
  // @ts-expect-error: an attribute's name
  "wind-direction": 90,
};

export const listeners: CandleFlameListeners = {
  onprogress: ({ detail }) => detail.totalProgress,
  // @ts-expect-error: a number
  onerror: ({ detail }) => detail.message * 2,
};
