import { defineConfig } from "playwright/test";
import config from "./playwright.config.ts";
export default defineConfig({ ...config, expect: { ...config.expect, toHaveScreenshot: { animations: "disabled", threshold: 0, maxDiffPixels: 0 } } });
