import type { InlineConfig } from "vite";

export function serveBuilt(
  outDir?: string,
  options?: InlineConfig,
): Promise<{ readonly url: string; close(): Promise<void> }>;
