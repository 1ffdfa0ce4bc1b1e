import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { build } from "vite";

/** Bytes that a tick of the world may leave to the collector: one number that a compiler boxes. */
export const MOST_GARBAGE = 16;

/** Megabytes of nursery: so many that nothing is collected while it is measured. */
const NURSERY = 64;
/** Compiles early, and at once. */
const EAGER = ["--interrupt-budget=10000", "--no-concurrent-recompilation"];

/**
 * Bytes that each tick of the world leaves to the collector, in a process of its own, by what happens.
 *
 * @param cases of `garbage/child.ts`
 * @param warmUp frames, until all is compiled
 */
export async function garbagePerTick(
  cases: readonly string[],
  warmUp: number,
): Promise<Readonly<Record<string, number>>> {
  const built = await build({
    configFile: false,
    logLevel: "error",
    build: {
      write: false,
      minify: false,
      target: "esnext",
      ssr: fileURLToPath(new URL("garbage/child.ts", import.meta.url)),
    },
  });
  const code = "output" in built ? built.output[0].code : "";
  const nursery = [`--min-semi-space-size=${NURSERY}`, `--max-semi-space-size=${NURSERY}`];
  const flags = [...EAGER, ...nursery, "--input-type=module", "-"];
  const output = execFileSync(process.execPath, [...flags, String(warmUp), ...cases], {
    input: code,
    encoding: "utf8",
  });
  return JSON.parse(output);
}
