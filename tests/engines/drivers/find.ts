import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { firefox, webkit } from "playwright";
import { WITHOUT_OWN_PAGES } from "../../../tools/chromium-features.ts";
import { findBrowser } from "../../../tools/find-browser.mjs";
import { hasDisplay, openDisplay } from "./display.ts";
import { type Launch, launchByPlaywright, launchFirefox } from "./paged-driver.ts";
import { type Driver, Visitor } from "./visitor.ts";
import { WebKitDriver } from "./webkit-driver.ts";

export const PAIRS = ["chromium-swiftshader", "chromium-gl", "firefox", "webkit"] as const;
export type PairName = (typeof PAIRS)[number];

/** A browser and the driver that draws for it. */
export interface Pair {
  readonly name: PairName;
  /** As a reader knows it. */
  readonly title: string;
  launch(): Promise<Visitor>;
  /** What draws, in the driver's words, as far as the browser tells. */
  renderer(visitor: Visitor): Promise<string>;
  /** What draws if the pair is what its name says. */
  readonly expected: RegExp;
}

export interface Missing {
  readonly name: PairName;
  readonly why: string;
}

/** A backend of ANGLE, `vulkan` say, by which Chromium draws on the machine's own GPU. */
const ownGpu = process.env.ANGLE_BACKEND;
const isMesa = process.platform === "linux" && !ownGpu;
/**
 * Mesa's software renderer, whatever GPU there is: the same on every machine. Without its short cuts it filters
 * textures as GPUs do, each pixel by its own level and not in 8 bits.
 */
const MESA: Readonly<Record<string, string>> = isMesa
  ? {
      LIBGL_ALWAYS_SOFTWARE: "1",
      GALLIUM_DRIVER: "llvmpipe",
      GALLIVM_PERF: "no_aos_sampling,no_quad_lod,no_filter_hacks",
    }
  : {};
const NATIVE = isMesa
  ? /llvmpipe/
  : ownGpu
    ? /^(?!.*(SwiftShader|llvmpipe))./
    : /^(?!.*SwiftShader)./;

/** Colours and pixels as the other tests have them: tests/support/browser.ts. */
const CHROMIUM = [
  "--force-color-profile=srgb",
  "--hide-scrollbars",
  "--ignore-gpu-blocklist",
  WITHOUT_OWN_PAGES,
];
const SWIFTSHADER = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const NATIVE_GL = ["--use-gl=angle", `--use-angle=${isMesa ? "gl-egl" : (ownGpu ?? "default")}`];

/** What Debian has, and what is missing of it in a bare container. */
const PACKAGES = ["firefox-esr", "webkit2gtk-driver", "xvfb", "libegl1", "libgl1-mesa-dri"];
const FIREFOX = ["/usr/bin/firefox-esr"];
const WEBKIT = "/usr/bin/WebKitWebDriver";

/** Finds the pairs, or installs them on Debian as root; says which cannot be had, and why. */
export async function findPairs(
  names: readonly PairName[] = PAIRS,
): Promise<{ readonly pairs: readonly Pair[]; readonly missing: readonly Missing[] }> {
  if (names.some((name) => name !== "chromium-swiftshader")) install();
  const found = await Promise.all(names.map(find));
  return {
    pairs: found.filter((one): one is Pair => "launch" in one),
    missing: found.filter((one): one is Missing => "why" in one),
  };
}

/** Debian's packages that are not installed, as root; elsewhere it is not ours to install. */
function install(): void {
  if (process.getuid?.() !== 0 || !existsSync("/usr/bin/apt-get")) return;
  const isInstalled = (name: string) =>
    /^Status: install ok/m.test(outputOf("dpkg", "--status", name));
  const missing = PACKAGES.filter((name) => !isInstalled(name));
  if (missing.length === 0) return;
  const apt = (...command: string[]) =>
    spawnSync("apt-get", command, { stdio: "inherit", timeout: 600_000 });
  apt("update", "-qq");
  // Ubuntu has other names for some, and one that it does not know would spoil the others.
  const known = missing.filter((name) => outputOf("apt-cache", "show", name) !== "");
  if (known.length > 0) apt("install", "-y", "-qq", "--no-install-recommends", ...known);
}

function outputOf(command: string, ...options: string[]): string {
  try {
    return execFileSync(command, options, {
      encoding: "utf8",
      stdio: ["ignore", "pipe", "ignore"],
    });
  } catch {
    return "";
  }
}

function find(name: PairName): Promise<Pair | Missing> {
  return FINDERS[name](name);
}

type Finder = (name: PairName) => Promise<Pair | Missing>;

const FINDERS: Readonly<Record<PairName, Finder>> = {
  "chromium-swiftshader": async (name) =>
    pair(name, "Chromium, SwiftShader", await chromiumWith(SWIFTSHADER), /SwiftShader/),
  "chromium-gl": async (name) =>
    pair(name, "Chromium, native GL", await chromiumWith(NATIVE_GL, MESA), NATIVE),
  firefox: async (name) => {
    const path = process.env.FIREFOX_PATH ?? FIREFOX.find(existsSync);
    const own = [firefox.executablePath()].find(existsSync);
    if (!path && !own) return { name, why: "no firefox-esr, and none of Playwright's" };
    if (!hasDisplay()) return { name, why: "no Xvfb, and no display" };
    const launch = path
      ? onDisplay((env) => launchFirefox({ path, env }))
      : onDisplay((env) => launchByPlaywright("firefox", { path: own ?? "", env }));
    return pair(name, "Firefox", launch, NATIVE);
  },
  webkit: async (name) => {
    const browser = miniBrowser();
    const own = [webkit.executablePath()].find(existsSync);
    const isWhole = existsSync(WEBKIT) && browser;
    if (!isWhole && !own) return { name, why: "no WebKitWebDriver, and no WebKit of Playwright's" };
    if (!hasDisplay()) return { name, why: "no Xvfb, and no display" };
    if (!isWhole) {
      const launch = onDisplay((env) => launchByPlaywright("webkit", { path: own ?? "", env }));
      return pair(name, "WebKit", launch, /./);
    }
    const launch = onDisplay((env) => WebKitDriver.launch({ path: WEBKIT, env }, browser));
    return { ...pair(name, "WebKitGTK", launch, NATIVE), renderer: rendererOfWebKit };
  },
};

function pair(
  name: PairName,
  title: string,
  launch: () => Promise<Driver>,
  expected: RegExp,
): Pair {
  return { name, title, launch: async () => new Visitor(await launch()), renderer, expected };
}

async function chromiumWith(
  flags: readonly string[],
  env: Launch["env"] = {},
): Promise<() => Promise<Driver>> {
  const { path, args } = await findBrowser();
  const all = [...CHROMIUM, ...flags, ...args];
  return () => launchByPlaywright("chromium", { path, args: all, env });
}

/** Launches on a display of its own, which ends with the browser. */
function onDisplay(launch: (env: NonNullable<Launch["env"]>) => Promise<Driver>) {
  return async (): Promise<Driver> => {
    const display = await openDisplay();
    // A session of Wayland's would be taken before the display.
    const own = display.name
      ? { DISPLAY: display.name, WAYLAND_DISPLAY: "", GDK_BACKEND: "x11", MOZ_ENABLE_WAYLAND: "0" }
      : {};
    try {
      const driver = await launch({ ...MESA, ...own });
      const kill = driver.kill.bind(driver);
      driver.kill = () => {
        kill();
        display.close();
      };
      return driver;
    } catch (error) {
      display.close();
      throw error;
    }
  };
}

/** WebKitGTK's own small browser, beside its library. */
function miniBrowser(): string | undefined {
  return (existsSync("/usr/lib") ? readdirSync("/usr/lib") : [])
    .flatMap((folder) =>
      ["webkit2gtk-4.1", "webkit2gtk-4.0"].map((name) =>
        join("/usr/lib", folder, name, "MiniBrowser"),
      ),
    )
    .find(existsSync);
}

function renderer(visitor: Visitor): Promise<string> {
  return visitor.evaluate(() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return "no WebGL2";
    const masked = gl.getParameter(gl.RENDERER);
    // Firefox tells by the plain name, Chromium by the extension alone.
    const { UNMASKED_RENDERER_WEBGL } = gl.getExtension("WEBGL_debug_renderer_info") ?? {};
    const name = UNMASKED_RENDERER_WEBGL ? gl.getParameter(UNMASKED_RENDERER_WEBGL) : masked;
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return String(name);
  });
}

/** WebKit calls every renderer "Apple GPU" in pages; a page of its own tells. */
async function rendererOfWebKit(visitor: Visitor): Promise<string> {
  await visitor.open("webkit://gpu");
  const text = await visitor.evaluate(() => document.body.innerText);
  return /GL_RENDERER\s*(.*)/.exec(text)?.[1] ?? text;
}
