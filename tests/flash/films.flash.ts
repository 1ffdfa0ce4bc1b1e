import { expect, test } from "playwright/test";
import { candlePlate, ringOf } from "../support/candle-model.ts";
import { FlashMeter } from "../support/flash.ts";
import { type Attributes, RoomDriver } from "../support/room-driver.ts";
import { SCREEN } from "./playwright.config.ts";

const RATE = 60;
const SECONDS = 10;
/** What is drawn and judged: a quarter of the screen's lines and columns. */
const SIZE = { width: SCREEN.width / 4, height: SCREEN.height / 4 };

/** Each frame's deed: any of the element's own verbs, on all candles. */
type Deed = "light" | "extinguish" | "blow";

interface Scenario {
  readonly name: string;
  readonly attributes: Attributes;
  /** What is done before a frame. */
  readonly deed: (frame: number) => Deed | null;
}

const STILL: Attributes = { wind: "0", gustiness: "0", wick: "2" };
/** Keys cannot be struck faster: fifteen times a second. */
const STROKE = 4;

const SCENARIOS: readonly Scenario[] = [
  { name: "still", attributes: STILL, deed: () => null },
  {
    name: "gusts of 1.5 m/s, lit again each second",
    attributes: { ...STILL, wind: "1.5", gustiness: "1" },
    deed: (frame) => (frame % RATE === 0 ? "light" : null),
  },
  {
    name: "blown out, and lit two seconds later, again and again",
    attributes: STILL,
    deed: (frame) =>
      frame % (4 * RATE) === 2 * RATE ? "blow" : frame % (4 * RATE) === 0 ? "light" : null,
  },
  { name: "the widest wick", attributes: { ...STILL, wick: "50" }, deed: () => null },
  {
    name: "the widest wick, in gusts",
    attributes: { wick: "50", wind: "0.5", gustiness: "1" },
    deed: () => null,
  },
  {
    name: "put out and lit as fast as keys can be struck",
    attributes: STILL,
    deed: (frame) =>
      frame % (2 * STROKE) === 0 ? "extinguish" : frame % (2 * STROKE) === STROKE ? "light" : null,
  },
  {
    name: "the widest wick, in gusts, for who wants less motion",
    attributes: { wick: "50", wind: "0.5", gustiness: "1", motion: "reduced" },
    deed: () => null,
  },
];

/** The element's pictures for ten seconds, frame by frame, as a flash meter sees them. */
async function film(room: RoomDriver, { attributes, deed }: Scenario): Promise<FlashMeter> {
  const meter = new FlashMeter(SIZE.width, SIZE.height);
  await room.evaluate((element) => {
    element.reset();
    for (const candle of element.candles) candle.light();
  });
  await room.set(attributes);
  for (let second = 0; second < SECONDS; second++) {
    const deeds = Array.from({ length: RATE }, (_, i) => deed(second * RATE + i));
    const text = await room.evaluate(
      async (element, { deeds, width, height }) => {
        const canvas = element.shadowRoot?.querySelector("canvas");
        const paper = new OffscreenCanvas(width, height).getContext("2d", {
          willReadFrequently: true,
        });
        if (!canvas || !paper) throw new Error("There is no canvas.");
        paper.imageSmoothingQuality = "high";
        const frames = new Uint8Array(deeds.length * width * height * 4);
        for (const [i, deed] of deeds.entries()) {
          if (deed) for (const candle of element.candles) candle[deed]();
          element.step(1 / 60);
          paper.drawImage(canvas, 0, 0, width, height);
          frames.set(paper.getImageData(0, 0, width, height).data, i * width * height * 4);
        }
        const reader = new FileReader();
        reader.readAsDataURL(new Blob([frames]));
        await new Promise((resolve) => reader.addEventListener("load", resolve, { once: true }));
        return String(reader.result);
      },
      { deeds, ...SIZE },
    );
    const bytes = Buffer.from(text.slice(text.indexOf(",") + 1), "base64");
    const length = SIZE.width * SIZE.height * 4;
    expect(bytes.length).toBe(RATE * length);
    for (let i = 0; i < RATE; i++) {
      meter.look(bytes.subarray(i * length, (i + 1) * length), second + i / RATE);
    }
  }
  return meter;
}

/** One pixel drawn for each judged: shares of the picture stay, and a film takes seconds, not minutes. */
const LOOKS: Readonly<Record<string, Attributes>> = {
  paper: { look: "paper", quality: "medium", "max-pixel-ratio": "0.25" },
  original: { look: "original", quality: "medium", "max-pixel-ratio": "0.25" },
  physical: { look: "physical", quality: "low", "max-pixel-ratio": "0.25" },
  sixteen: {
    look: "physical",
    scene: "candle",
    src: "sixteen.glb",
    quality: "low",
    "max-pixel-ratio": "0.25",
  },
};

/** Sixteen flames on one plate, filling the screen: their sum. */
const SIXTEEN = candlePlate(ringOf(16, 0.085, 0.05, 0.004), 0.11);
const OF_SIXTEEN = ["gusts of 1.5 m/s", "blown out, and lit", "put out and lit"];

for (const [look, attributes] of Object.entries(LOOKS)) {
  for (const scenario of SCENARIOS) {
    if (look === "sixteen" && !OF_SIXTEEN.some((begin) => scenario.name.startsWith(begin)))
      continue;
    test(`${look}: ten seconds do not flash: ${scenario.name}`, async ({ page }) => {
      const begin = Date.now();
      await page.route("**/sixteen.glb", (route) =>
        route.fulfill({ contentType: "model/gltf-binary", body: SIXTEEN }),
      );
      const room = await new RoomDriver(page).open({ ...attributes, motion: "full" }, SCREEN);
      const { worst, moving, isHarmful } = await film(room, scenario);
      const shares = Object.entries(worst).map(([kind, share]) => `${kind} ${share.toFixed(3)}`);
      const took = ((Date.now() - begin) / 1000).toFixed(0);
      console.log(
        `${look}, ${scenario.name}: ${shares.join(", ")}, ${moving} frames move (${took} s)`,
      );
      expect(moving, "frames that are not the one before").toBeGreaterThan(10);
      expect(isHarmful).toBe(false);
      expect(room.complaints).toEqual([]);
    });
  }
}
