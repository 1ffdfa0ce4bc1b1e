import { once } from "node:events";
import { createServer } from "node:net";
import { expect, test } from "vitest";
import { freePorts } from "../../../tools/free-ports.mjs";
import { codeOf, filesIn } from "../sources.ts";

test("Ports that are free are all different, can all be listened on, and are no longer free then", async () => {
  const ports = await freePorts(8);
  expect(new Set(ports).size).toBe(8);
  const servers = ports.map((port) => createServer().listen(port, "127.0.0.1"));
  await Promise.all(servers.map((server) => once(server, "listening")));
  const others = await freePorts(8);
  for (const server of servers) server.close();
  expect(others.filter((port) => ports.includes(port))).toEqual([]);
});

test("No server of tests and tools wants a port of its own, which another may have", () => {
  const files = [...filesIn("tests", /\.ts$/), ...filesIn("tools", /\.mjs$/)];
  expect(files.length).toBeGreaterThan(100);
  const fixed = files.filter((file) =>
    /\bport(: |=| )[1-9]|(127\.0\.0\.1|localhost):[1-9]/i.test(codeOf(file)),
  );
  expect(fixed).toEqual([]);
});
