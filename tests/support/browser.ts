import type { PlaywrightTestConfig } from "playwright/test";
import { WITHOUT_OWN_PAGES } from "../../tools/chromium-features.ts";
import { freePorts } from "../../tools/free-ports.mjs";

/** SwiftShader, on every machine: the same pixels on any of them. */
const SWIFTSHADER = [
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
];

type Use = NonNullable<PlaywrightTestConfig["use"]>;

/** Playwright's `use` of the tests, the bench and the shots. */
export const browser: Use = browserOn(SWIFTSHADER);

/** The same on the machine's own GPU, by the backend of ANGLE that `ANGLE_BACKEND` names, or by ANGLE's choice. */
export const onOwnGpu: Use = browserOn([
  "--use-gl=angle",
  `--use-angle=${process.env.ANGLE_BACKEND ?? "default"}`,
  "--ignore-gpu-blocklist",
]);

function browserOn(driver: readonly string[]): Use {
  return {
    browserName: "chromium",
    viewport: { width: 640, height: 360 },
    deviceScaleFactor: 1,
    colorScheme: "dark",
    locale: "en-US",
    timezoneId: "UTC",
    launchOptions: {
      ...(process.env.CHROMIUM_PATH ? { executablePath: process.env.CHROMIUM_PATH } : {}),
      args: [
        ...driver,
        "--force-color-profile=srgb",
        "--font-render-hinting=none",
        "--disable-lcd-text",
        "--hide-scrollbars",
        // A page's pictures are there as soon as the page is.
        "--disable-checker-imaging",
        // Texts and boxes of a page take a GPU that is a processor longer than the processor itself.
        "--disable-gpu-rasterization",
        WITHOUT_OWN_PAGES,
        ...(process.env.CHROMIUM_ARGS?.split(" ").filter(Boolean) ?? []),
      ],
    },
  };
}

const vite = "node node_modules/vite/bin/vite.js";
const bench = "--config tests/bench/vite.config.ts";

const SERVED = ["page", "library", "sources", "bench"] as const;
type Served = (typeof SERVED)[number];

/** Workers evaluate this again, and inherit the ports that Playwright's first process was given. */
process.env.TEST_PORTS ??= (await freePorts(SERVED.length)).join(" ");
const ports = process.env.TEST_PORTS.split(" ");

const onPorts = <T>(make: (port: string) => T) =>
  Object.fromEntries(SERVED.map((name, i) => [name, make(ports[i] ?? "")])) as Record<Served, T>;

/**
 * The hosted page as built, the package as built, the sources, for tests of what is inside, and the
 * bench's own page.
 */
export const ORIGINS = onPorts((port) => `http://127.0.0.1:${port}/`);

const on = onPorts((port) => `--port ${port} --strictPort`);

export const servers = {
  /** Page, library and sources. The sources answer last. */
  all: {
    command: `node tests/support/serve.mjs ${ports.slice(0, 3).join(" ")}`,
    url: ORIGINS.sources,
    reuseExistingServer: false,
  },
  page: {
    command: `${vite} preview ${on.page}`,
    url: ORIGINS.page,
    reuseExistingServer: false,
  },
  library: {
    command: `${vite} preview --outDir dist ${on.library}`,
    url: `${ORIGINS.library}define.js`,
    reuseExistingServer: false,
  },
  bench: {
    command: `${vite} build ${bench} && ${vite} preview ${bench} ${on.bench}`,
    url: ORIGINS.bench,
    reuseExistingServer: false,
  },
};
