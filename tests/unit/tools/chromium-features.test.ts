import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { expect, test } from "vitest";
import { DISABLED_FEATURES } from "../../../tools/chromium-features.ts";

test("the features that tests switch off in Chromium begin with those that Playwright does", () => {
  const { resolve } = createRequire(createRequire(import.meta.url).resolve("playwright"));
  const bundle = readFileSync(resolve("playwright-core/lib/coreBundle"), "utf8");
  const [, list = ""] = /disabledFeatures = \[(.*?)\]/s.exec(bundle) ?? [];
  const theirs = [...list.matchAll(/^\s*"(\w+)"/gm)].map(([, name]) => name);
  expect(theirs.length).toBeGreaterThan(5);
  expect(DISABLED_FEATURES.slice(0, theirs.length)).toEqual(theirs);
});
