import { expect, test } from "vitest";
import { litterPerTick, MOST_LITTER } from "../../support/litter.ts";

// What takes longer to be compiled, walking and smoke, is measured by `npm run bench`.
test("a flame in gusts leaves nothing to the collector", async () => {
  const { gusts } = await litterPerTick(["gusts"], 200);
  expect(gusts).toBeLessThanOrEqual(MOST_LITTER);
});
