import type { PlaywrightTestConfig } from "playwright/test";

/** SwiftShader, on every machine: the same pixels, whoever runs the tests. */
const SWIFTSHADER = [
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
];

/** Playwright's `use` of the tests, the bench and the shots. */
export const browser: NonNullable<PlaywrightTestConfig["use"]> = {
  browserName: "chromium",
  viewport: { width: 640, height: 360 },
  deviceScaleFactor: 1,
  colorScheme: "dark",
  locale: "en-US",
  timezoneId: "UTC",
  launchOptions: {
    ...(process.env.CHROMIUM_PATH ? { executablePath: process.env.CHROMIUM_PATH } : {}),
    args: [
      ...SWIFTSHADER,
      "--force-color-profile=srgb",
      "--font-render-hinting=none",
      "--disable-lcd-text",
      "--hide-scrollbars",
      ...(process.env.CHROMIUM_ARGS?.split(" ").filter(Boolean) ?? []),
    ],
  },
};

const vite = "node node_modules/vite/bin/vite.js";

/** The hosted page as built, the package as built, and the sources, for tests of what is inside. */
export const servers = {
  page: {
    command: `${vite} preview --port 4173 --strictPort`,
    url: "http://127.0.0.1:4173/",
    reuseExistingServer: false,
  },
  library: {
    command: `${vite} preview --outDir dist --port 4174 --strictPort`,
    url: "http://127.0.0.1:4174/define.js",
    reuseExistingServer: false,
  },
  sources: {
    command: `${vite} --port 4175 --strictPort`,
    url: "http://127.0.0.1:4175/",
    reuseExistingServer: false,
  },
};
