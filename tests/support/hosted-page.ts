import { readFileSync } from "node:fs";
import { test as base, expect, type Locator, type Page } from "playwright/test";
import type { CandleFlameElement, Feature } from "../../src/candle-flame-element.ts";
import { ORIGINS, browser as options } from "./browser.ts";
import { stopDrawing } from "./no-drawing.ts";
import { complaintsOf } from "./room-driver.ts";
import { serveSmallTextures } from "./small-textures.ts";

export { expect };
export const PAGE = ORIGINS.page;

const POLICY = "default-src 'self'";
/** Small, and a look that is quick to load and to draw, for tests that are not about pictures. */
const VIEWPORT = { width: 320, height: 200 };
const QUICK = "#look=paper";

const AXE = readFileSync("node_modules/axe-core/axe.min.js", "utf8");

/** What axe finds wrong with a page as it stands: the rule, and where it is broken. */
export async function findingsOf(page: Page): Promise<string[]> {
  await page.evaluate(AXE);
  return page.evaluate(async () => {
    type Findings = {
      violations: { id: string; nodes: { target: unknown; failureSummary?: string }[] }[];
    };
    const { axe } = window as unknown as { axe: { run(): Promise<Findings> } };
    const { violations } = await axe.run();
    return violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target}: ${failureSummary}`),
    );
  });
}

/** Sets the size of a page's type, as a share of the usual; 1 is as the page has it. */
export function scaleType(page: Page, scale: number): Promise<void> {
  return page.evaluate((scale) => {
    document.documentElement.style.fontSize = scale === 1 ? "" : `${scale * 100}%`;
  }, scale);
}

/** The hosted page, under a policy that allows nothing inline and nothing from elsewhere. */
export class HostedPage {
  readonly page: Page;
  readonly room: Locator;
  readonly enter: Locator;
  readonly lab: Locator;
  readonly complaints: readonly string[];

  constructor(page: Page) {
    this.page = page;
    this.room = page.locator("candle-flame.room");
    this.enter = page.getByRole("button", { name: "Walk in" });
    this.lab = page.getByRole("complementary", { name: "Lab" });
    this.complaints = complaintsOf(page);
  }

  /**
   * Loads it, with small textures.
   *
   * @param address as a visitor has it, who may have it from any folder of a site
   */
  async load(hash = QUICK, address: string = PAGE): Promise<void> {
    const served = address === PAGE ? PAGE : `${address}**`;
    await this.page.route(served, async (route) => {
      const url = route.request().url().replace(address, PAGE);
      // A server may close a connection that was idle just as it is used again.
      const response = await route.fetch({ url, maxRetries: 3 });
      const headers = { ...response.headers(), "content-security-policy": POLICY };
      await route.fulfill({ response, headers });
    });
    await serveSmallTextures(this.page); // last: it comes before the address's own route
    const response = await this.page.goto(address + hash);
    expect(response?.headers()["content-security-policy"]).toBe(POLICY);
  }

  async open(hash = QUICK, address: string = PAGE): Promise<this> {
    await this.load(hash, address);
    await this.settle();
    return this;
  }

  /** Makes a page that is loading quick to draw, and waits for its first picture. */
  async settle(): Promise<void> {
    await this.evaluate((room) => {
      room.quality = "low";
      room.maxPixelRatio = 0.5;
      return room.ready;
    });
  }

  /** Brings an opened page back to how it opens, in the paper's look; the lab's sections stay open. */
  async restore(): Promise<void> {
    await this.page.setViewportSize(VIEWPORT);
    await this.page.emulateMedia({ reducedMotion: null, contrast: null, forcedColors: null });
    await this.page.mouse.move(0, 0);
    await this.evaluate((room) => {
      room.blur();
      for (const dialog of document.querySelectorAll("dialog")) dialog.close();
      for (const name of Object.keys(room.features) as Feature[]) room.features[name] = true;
      const kept = [
        "class",
        "controls",
        "asset-base",
        "tabindex",
        "look",
        "quality",
        "max-pixel-ratio",
      ];
      for (const name of room.getAttributeNames()) {
        if (!kept.includes(name)) room.removeAttribute(name);
      }
      room.look = "paper";
      room.quality = "low";
      room.take();
      room.reset();
    });
    await expect.poll(() => this.isWalking()).toBe(false);
    if (await this.lab.isVisible()) {
      await this.lab.getByRole("button", { name: "Close the lab" }).click();
    }
  }

  evaluate<Result>(run: (room: CandleFlameElement) => Result | Promise<Result>): Promise<Result> {
    return this.room.evaluate(run as never) as Promise<Result>;
  }

  /** What axe finds wrong with the page as it stands: the rule, and where it is broken. */
  axe(): Promise<string[]> {
    return findingsOf(this.page);
  }

  isWalking(): Promise<boolean> {
    return this.evaluate((room) => room.matches(":state(walking)"));
  }

  /** Opens the lab, and one of its sections. */
  async openLab(title: string): Promise<Locator> {
    await this.page.getByRole("button", { name: "Lab", exact: true }).click();
    await expect(this.lab).toBeVisible();
    return this.openSection(title);
  }

  async openSection(title: string): Promise<Locator> {
    const section = this.lab.locator("details").filter({
      has: this.page.locator("summary", { hasText: title }),
    });
    if ((await section.getAttribute("open")) === null) await section.locator("summary").click();
    return section;
  }
}

/**
 * Playwright's `test` with the hosted page: `hosted` is open already, in the paper's look, and shared, so
 * that nobody waits for shaders and textures twice, and draws nothing any more; `fresh` is one's own, and still empty. A
 * test fails if its page complained of anything that it does not tolerate.
 */
export const test = base.extend<
  { tolerated: RegExp; fresh: HostedPage; hosted: HostedPage },
  { shared: HostedPage }
>({
  tolerated: [/^$/, { option: true }],
  viewport: VIEWPORT,
  fresh: async ({ page, tolerated }, use) => {
    const fresh = new HostedPage(page);
    await use(fresh);
    // Files may be on their way still, and nobody needs them.
    await page.unrouteAll({ behavior: "ignoreErrors" });
    expect(fresh.complaints.filter((complaint) => !tolerated.test(complaint))).toEqual([]);
  },
  shared: [
    async ({ browser }, use) => {
      const { colorScheme = null, locale = "en", timezoneId = "UTC" } = options;
      const page = await browser.newPage({
        viewport: VIEWPORT,
        colorScheme,
        locale,
        timezoneId,
      });
      const shared = await new HostedPage(page).open();
      await shared.evaluate((room) => room.pause());
      await page.evaluate(stopDrawing);
      await use(shared);
      await page.close();
    },
    { scope: "worker" },
  ],
  hosted: async ({ shared }, use) => {
    await shared.restore();
    const before = shared.complaints.length;
    await use(shared);
    // It stays open beside the pages of the tests to come, and would take a processor for itself.
    await shared.evaluate((room) => room.pause());
    expect(shared.complaints.slice(before)).toEqual([]);
  },
});
