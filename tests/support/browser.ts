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

/** First of three ports in a row; TEST_PORT names another where these are taken. */
const PORT = Number(process.env.TEST_PORT ?? 4173);
const origin = (port: number) => `http://127.0.0.1:${port}/`;

/** The hosted page as built, the package as built, and the sources, for tests of what is inside. */
export const ORIGINS = {
  page: origin(PORT),
  library: origin(PORT + 1),
  sources: origin(PORT + 2),
} as const;

export const servers = {
  page: {
    command: `${vite} preview --port ${PORT} --strictPort`,
    url: ORIGINS.page,
    reuseExistingServer: false,
  },
  library: {
    command: `${vite} preview --outDir dist --port ${PORT + 1} --strictPort`,
    url: `${ORIGINS.library}define.js`,
    reuseExistingServer: false,
  },
  sources: {
    command: `${vite} --port ${PORT + 2} --strictPort`,
    url: ORIGINS.sources,
    reuseExistingServer: false,
  },
};
