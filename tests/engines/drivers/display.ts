import { existsSync } from "node:fs";
import { killGroup, spawnGroup } from "./paged-driver.ts";

const XVFB = "/usr/bin/Xvfb";

/** Whether windows can be opened: on a virtual display, or on whatever the system has. */
export const hasDisplay = (): boolean =>
  process.platform !== "linux" || existsSync(XVFB) || Boolean(process.env.DISPLAY);

/** A display of one's own, so that no window takes another's focus. */
export async function openDisplay(): Promise<{ readonly name?: string; close(): void }> {
  if (!existsSync(XVFB)) return { close: () => {} };
  // It takes whatever number is free, and says which.
  const server = spawnGroup(
    XVFB,
    ["-displayfd", "3", "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
    { stdio: ["ignore", "ignore", "ignore", "pipe"] },
  );
  const close = () => {
    if (server.pid) killGroup(server.pid);
  };
  const output = server.stdio[3];
  const number = await new Promise<string>((resolve, reject) => {
    output?.once("data", (data) => resolve(String(data).trim()));
    server.once("exit", () => reject(new Error("Xvfb ended at once.")));
    server.once("error", reject);
  });
  return { name: `:${number}`, close };
}
