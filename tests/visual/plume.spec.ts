import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

test("A flame put out smokes for seconds, and no longer than twenty", async ({ page }) => {
  const options = { look: "physical", controls: "", quality: "low" };
  const room = await new RoomDriver(page).open(options, { width: 160, height: 90 });
  const withAndWithout = async () => {
    const whole = await room.pixels();
    await room.switchFeatures({ smoke: false });
    const without = await room.pixels();
    await room.switchFeatures({ smoke: true });
    return { whole, without };
  };
  await room.step(0.5);
  const lit = await withAndWithout();
  expect(lit.whole, "a lit candle does not smoke").toBe(lit.without);
  await room.evaluate((element) => {
    element.enter();
    const press = { code: "KeyE", bubbles: true };
    element.dispatchEvent(new KeyboardEvent("keydown", press));
    element.dispatchEvent(new KeyboardEvent("keyup", press));
  });
  await room.step(2);
  const smoking = await withAndWithout();
  expect(smoking.whole, "smoke is seen").not.toBe(smoking.without);
  await room.step(18);
  const over = await withAndWithout();
  expect(over.whole, "all smoke has gone").toBe(over.without);
  expect(room.complaints).toEqual([]);
});

test("Hot air bends what is behind it, and nothing else", async ({ page }) => {
  const room = await new RoomDriver(page).open(
    { look: "physical", quality: "low", "max-pixel-ratio": "2" },
    { width: 320, height: 180 },
  );
  await room.step(0.5);
  const differences = await room.evaluate((element) => {
    const { width, height } = element.stats;
    const bent = element.readRadiance(0, 0, width, height);
    element.features.haze = false;
    const plain = element.readRadiance(0, 0, width, height);
    element.features.haze = true;
    const columns: number[] = [];
    const rows: number[] = [];
    for (let i = 0; i < width * height; i++) {
      const one = bent[i * 3 + 1] ?? 0;
      const other = plain[i * 3 + 1] ?? 0;
      if (Math.abs(one - other) <= 0.002 * Math.max(one, other)) continue;
      columns.push(i % width);
      rows.push(Math.floor(i / width));
    }
    return { width, height, columns, rows };
  });
  const { width, height, columns, rows } = differences;
  expect(columns.length, "it is seen").toBeGreaterThan(20);
  // The candle is held right of the middle; its column is a few centimetres wide, and above it.
  expect(Math.max(...columns) - Math.min(...columns)).toBeLessThan(0.2 * width);
  expect(Math.min(...columns)).toBeGreaterThan(0.5 * width);
  expect(Math.max(...rows)).toBeLessThan(0.75 * height);
  expect(room.complaints).toEqual([]);
});
