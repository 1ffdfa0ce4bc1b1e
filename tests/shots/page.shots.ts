import { type Browser, expect, type Page, test } from "playwright/test";
import sharp from "sharp";
import { ORIGINS, browser as settings } from "../support/browser.ts";
import { complaintsOf } from "../support/room-driver.ts";
import { writeSheet } from "./sheet.ts";

interface Device {
  readonly width: number;
  readonly height: number;
  readonly hasTouch: boolean;
}

const DEVICES: readonly Device[] = [
  { width: 1440, height: 900, hasTouch: false },
  { width: 820, height: 1180, hasTouch: true },
  { width: 390, height: 844, hasTouch: true },
];

/** Pixels of the sheet's rows. */
const HEIGHT = 400;

/** What a visitor does, one after the other; each is shot. */
const STATES: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  "as it opens": async () => {},
  help: async (page) => {
    await page.locator(".room").evaluate((room: HTMLElementTagNameMap["candle-flame"]) => {
      room.quality = "low"; // as it is where one walks without a GPU
    });
    await page.getByRole("button", { name: "Help" }).click();
  },
  settings: async (page) => {
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Settings" }).click();
  },
  "walked in": async (page) => {
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Walk in" }).click();
  },
  "the candle is out": (page) =>
    page.locator(".room").evaluate((room: HTMLElementTagNameMap["candle-flame"]) => {
      room.extinguish();
      room.step(1.2);
    }),
  "the lab, Table 1": async (page) => {
    await page.locator(".room").evaluate((room: HTMLElementTagNameMap["candle-flame"]) => {
      document.exitPointerLock();
      room.blur();
      room.light();
      room.step(2);
    });
    await page.getByRole("button", { name: "Lab", exact: true }).click();
  },
  "the spot meter": async (page) => {
    await page.getByText("What each technique costs").click();
    await page.getByText("Spot meter", { exact: true }).click();
    await expect(page.locator(".meter")).toContainText("lx");
  },
  "before and after": async (page) => {
    await page.getByText("Spot meter", { exact: true }).click();
    await page.getByText("Before and after").click();
    await page.getByRole("button", { name: "Compare" }).click();
    await expect(page.getByRole("slider", { name: /Divider/ })).toBeVisible({ timeout: 60_000 });
  },
};

/** Pictures of all states on a device, scaled to the sheet's rows. */
async function tour(browser: Browser, { width, height, hasTouch }: Device): Promise<Buffer[]> {
  const { colorScheme = null, locale = "en", timezoneId = "UTC" } = settings;
  const page = await browser.newPage({
    viewport: { width, height },
    hasTouch,
    isMobile: hasTouch,
    reducedMotion: "reduce",
    colorScheme,
    locale,
    timezoneId,
  });
  const complaints = complaintsOf(page);
  // No finger has a pointer to lock.
  if (hasTouch) {
    await page.addInitScript(() => {
      Element.prototype.requestPointerLock = () =>
        Promise.reject(new DOMException("", "NotSupportedError"));
    });
  }
  await page.goto(ORIGINS.page);
  await page.locator(".room").evaluate((room: HTMLElementTagNameMap["candle-flame"]) => {
    room.maxPixelRatio = 0.5; // the sheet has fewer still
    room.quality = "high";
    room.pause();
    return room.ready;
  });
  const pictures: Buffer[] = [];
  for (const act of Object.values(STATES)) {
    await act(page);
    await page.mouse.move(0, 0);
    const picture = await page.screenshot({ animations: "disabled", timeout: 120_000 });
    pictures.push(await sharp(picture).resize({ height: HEIGHT }).png().toBuffer());
  }
  expect(complaints).toEqual([]);
  await page.close();
  return pictures;
}

test("sheet: the page, on a desk, on a tablet and on a phone", async ({ browser }) => {
  test.setTimeout(600_000);
  const tours: Buffer[][] = [];
  for (const device of DEVICES) tours.push(await tour(browser, device));
  const widths = DEVICES.map(({ width, height }) => Math.round((width * HEIGHT) / height));
  const width = widths.reduce((sum, width) => sum + width + 4, 8);
  const tiles = Object.keys(STATES).map(async (name, state) => {
    let left = 0;
    const overlays = tours.map((pictures, device) => {
      const overlay = { input: pictures[state] ?? Buffer.alloc(0), left, top: 0 };
      left += (widths[device] ?? 0) + 4;
      return overlay;
    });
    const size = { width, height: HEIGHT + 8, channels: 3 } as const;
    const picture = await sharp({ create: { ...size, background: "#777" } })
      .composite(overlays)
      .png()
      .toBuffer();
    return { name, picture };
  });
  await writeSheet("docs/shots/page.jpg", await Promise.all(tiles), 2);
});
