import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { BUILD_TARGET } from "../../../tools/oldest-browsers.ts";
import {
  declaredIn,
  lacksOfCss,
  lacksOfHtml,
  lacksOfPicture,
  lacksOfScript,
} from "../../support/compatibility.ts";

/** What may be used although some of the oldest browsers lack it, and why. */
const STYLE_EXCEPTIONS: Readonly<Record<string, string>> = {
  "text-wrap": "lines break elsewhere",
  "scrollbar-color": "the scroll bar has the system's colour",
  "scrollbar-width": "the scroll bar is the system's",
  "forced-color-adjust": "Safari has no forced colours",
  "@page": "the margins are those of the dialog that prints",
  "break-after": "a page may end with a heading",
  cursor: "a phone has no pointer",
  ":popover-open": "rules of their own, for popovers that the browser does not have",
  "accent-color": "Safari does not adapt the tick's colour to it",
  ":marker": "Safari has only colour and font of it, which is all that is set",
  "overscroll-behavior": "lacks only where nothing can be scrolled",
  "user-select": "stands beside `-webkit-user-select`",
};
const MARKUP_EXCEPTIONS: Readonly<Record<string, string>> = {
  "<dialog closedby>": "Esc and the button close it",
  "<img fetchpriority>": "the poster is fetched in its turn",
};
const SCRIPT_EXCEPTIONS: Readonly<Record<string, string>> = {
  ".currentCSSZoom": "`device-pixels.ts` takes it as 1 without it",
  ".devicePixelContentBoxSize": "`device-pixels.ts` guesses without it",
  ".devicePixelRatio": "Safari's leaves out the page's zoom",
  ".drawingBufferColorSpace": "sRGB without it",
  ".exitPointerLock": "phones do not lock the pointer",
  ".getLayoutMap": "keys are named as on an English keyboard without it",
  ".movementX": "phones do not lock the pointer",
  ".movementY": "phones do not lock the pointer",
  ".pointerLockElement": "phones do not lock the pointer",
  ".requestPointerLock": "phones do not lock the pointer",
  ".exitFullscreen": "iPhones have none, and no button for it",
  ".fullscreenElement": "iPhones have none, and no button for it",
  ".fullscreenEnabled": "iPhones have none, and no button for it",
  ".requestFullscreen": "iPhones have none, and no button for it",
  ".postTask": "questions to the driver come without a pause",
  ".toArray": "three's vectors",
};

const filesOf = (folder: string, ending: RegExp) =>
  readdirSync(folder, { recursive: true, encoding: "utf8" })
    .filter((path) => ending.test(path))
    .map((path) => `${folder}/${path}`);
const read = (path: string) => readFileSync(path, "utf8");

const STYLES = filesOf("src", /\.css$/);
const PAGES = ["index.html", "how.html", "use.html", ...filesOf("src", /\.html$/)];
const SCRIPTS = filesOf("src", /\.ts$/);

/** The lacks that no exception names, and the exceptions that name none. */
function surprises(lacks: readonly string[], exceptions: Readonly<Record<string, string>>) {
  const names = Object.keys(exceptions);
  const isNamed = (lack: string, name: string) => lack.split(": ").some((word) => word === name);
  return {
    unexpected: lacks.filter((lack) => !names.some((name) => isNamed(lack, name))),
    unused: names.filter((name) => !lacks.some((lack) => isNamed(lack, name))),
  };
}
const NONE = { unexpected: [], unused: [] };

test("the build aims at the oldest browsers that package.json names", () => {
  expect(BUILD_TARGET).toEqual(["chrome111", "edge121", "firefox115", "safari16.4", "ios16.4"]);
});

test("the styles of pages, documentation and element work in the oldest browsers", () => {
  const [, shadow = ""] = /const STYLE = `([^`]*)`/.exec(read("src/element/style.ts")) ?? [];
  expect(shadow).toContain(":host");
  const sheets = new Map([...STYLES.map((path) => [path, read(path)] as const), ["style", shadow]]);
  for (const page of PAGES) {
    const own = [...read(page).matchAll(/<style>([^<]*)<\/style>/g)].map(([, css = ""]) => css);
    sheets.set(page, own.join("\n"));
  }
  const lacks = [...sheets].flatMap(([path, css]) =>
    lacksOfCss(css).map((lack) => `${path}: ${lack}`),
  );
  expect(surprises(lacks, STYLE_EXCEPTIONS)).toEqual(NONE);
});

test("so does the markup of the pages", () => {
  const lacks = PAGES.flatMap((path) => lacksOfHtml(read(path)).map((lack) => `${path}: ${lack}`));
  expect(surprises(lacks, MARKUP_EXCEPTIONS)).toEqual(NONE);
});

test("so do the scripts", () => {
  const ours = new Set(SCRIPTS.flatMap((path) => declaredIn(read(path))));
  const lacks = SCRIPTS.flatMap((path) =>
    lacksOfScript(read(path), ours).map((lack) => `${path}: ${lack}`),
  );
  expect(surprises(lacks, SCRIPT_EXCEPTIONS)).toEqual(NONE);
});

test("and all of them read the pictures that are shipped, which have no twins of another kind", () => {
  const kinds = new Set(readdirSync("public/textures").map((name) => name.split(".").at(-1)));
  expect([...kinds]).toEqual(["avif"]);
  expect(lacksOfPicture("avif")).toEqual([]);
  expect(lacksOfPicture("jxl")).toHaveLength(1);
});

test("what is newer is found", () => {
  const firefox = (feature: string) => [`${feature}: not in firefox 115`];
  expect(lacksOfCss("body:has(.lab) p { color: red }")).toEqual(firefox(":has"));
  expect(lacksOfCss("p:not(:has(b)) { color: red }")).toEqual(firefox(":has"));
  expect(lacksOfCss("p:is(:has(b), .b), q { color: color-mix(in srgb, red, blue) }")).toEqual([]);
  expect(lacksOfCss("p:is(:has(b)) { color: red }")).toEqual(firefox(":has"));
  expect(lacksOfCss("a:state(lit) { color: red }")).toEqual([
    expect.stringMatching(/^:state: not in chrome 111, edge 121, firefox 115, safari 16.4/),
  ]);
  expect(lacksOfCss("a { &:hover { color: red } }")).toEqual([expect.stringMatching(/^nesting/)]);
  expect(lacksOfCss("a { b { color: red } }")).toEqual([expect.stringMatching(/^syntax/)]);
  expect(lacksOfCss("@starting-style { a { color: light-dark(red, blue) } }")).toHaveLength(2);
  expect(lacksOfCss("a { anchor-name: --a; height: 3dvh }")).toHaveLength(1);
  expect(lacksOfHtml('<button popovertarget="a">b</button><div popover inert>')).toHaveLength(2);
  const script = (code: string) =>
    lacksOfScript(code, new Set(["close"])).map((lack) => lack.split(":")[0]);
  expect(script("AbortSignal.any([a, b])")).toEqual(["AbortSignal.any"]);
  expect(script("if (URL.canParse(a)) return Promise.any(b).then(c)")).toEqual(["URL.canParse"]);
  expect(script("this.ariaLabel = 1; internals.states.add(2)")).toEqual([".ariaLabel", ".states"]);
  expect(script("Object.groupBy(a); Promise.withResolvers(); a.toSorted().at(-1)")).toEqual([
    "Object.groupBy",
    "Promise.withResolvers",
  ]);
  expect(script("new CloseWatcher(); scheduler.yield(); // a.showPopover()")).toHaveLength(2);
});
