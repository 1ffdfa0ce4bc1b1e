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
