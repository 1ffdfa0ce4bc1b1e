import { readFileSync } from "node:fs";

/** A browser as MDN's compatibility data names it, and the oldest version that is supported. */
export interface OldestBrowser {
  readonly name: "chrome" | "edge" | "firefox" | "safari" | "safari_ios";
  readonly version: string;
}

/** Names of the browserslist: MDN's, and the build target's. */
const NAMES = {
  chrome: { mdn: "chrome", target: "chrome" },
  edge: { mdn: "edge", target: "edge" },
  firefox: { mdn: "firefox", target: "firefox" },
  safari: { mdn: "safari", target: "safari" },
  ios_saf: { mdn: "safari_ios", target: "ios" },
} as const;

const { browserslist }: { browserslist: readonly string[] } = JSON.parse(
  readFileSync(new URL("../package.json", import.meta.url), "utf8"),
);

const oldest = browserslist.map((line) => {
  const [, name = "", version = ""] = /^(\w+) >= ([\d.]+)$/.exec(line) ?? [];
  const names = NAMES[name as keyof typeof NAMES];
  if (!names) throw new Error(`package.json's browserslist has a line of another form: ${line}`);
  return { ...names, version };
});

/** The oldest supported browsers: package.json's `browserslist`. */
export const OLDEST_BROWSERS: readonly OldestBrowser[] = oldest.map(({ mdn, version }) => ({
  name: mdn,
  version,
}));

/** The same as the build's target. */
export const BUILD_TARGET: string[] = oldest.map(({ target, version }) => target + version);
