// npm run test:engines: every look at every tier in every engine and driver, and what one does there; writes
// docs/engines.md and docs/shots/engines.jpg. Needs `npm run build`.
//   --short            the few cases of `npm test`
//   --only firefox     pairs whose name contains this
//   --cases "^phys|lock" cases whose name matches this
// ANGLE_BACKEND=vulkan (gl, gl-egl, …) lets Chromium's native pair draw on the machine's own GPU.
//   --counts file      where the numbers of passed and failed cases go
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { runnerImport } from "vite";

const { values } = parseArgs({
  options: {
    short: { type: "boolean", default: false },
    only: { type: "string" },
    cases: { type: "string" },
    counts: { type: "string" },
  },
});
const { short: isShort, ...filters } = values;
const { module } = await runnerImport(fileURLToPath(new URL("main.ts", import.meta.url)), {
  configFile: false,
});
process.exit((await module.main({ isShort, ...filters })) ? 0 : 1);
