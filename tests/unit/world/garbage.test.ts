import { expect, test } from "vitest";
import { garbagePerTick, MOST_GARBAGE } from "../../support/garbage.ts";

// What takes longer to be compiled, walking and smoke, is measured by `npm run bench`.
test("a flame in gusts leaves nothing to the collector", async () => {
  const { gusts } = await garbagePerTick(["gusts"], 200);
  expect(gusts).toBeLessThanOrEqual(MOST_GARBAGE);
});
