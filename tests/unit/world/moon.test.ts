import { expect, test } from "vitest";
import { CABIN_MOON, lightFrom, moonOf, parseMoonPlace } from "../../../src/world/moon.ts";

test("a moon over -Z sends its light to +Z, and one to its left to the right", () => {
  const [x, y, z] = lightFrom(0, 30);
  expect(x).toBeCloseTo(0);
  expect(y).toBeCloseTo(-0.5);
  expect(z).toBeCloseTo(Math.cos(Math.PI / 6));
  expect(lightFrom(90, 0)[0]).toBeCloseTo(1);
});

test("a place in the sky is two numbers; what is none is the room's own", () => {
  expect(parseMoonPlace(" 90 30 ")).toEqual(lightFrom(90, 30));
  expect(parseMoonPlace("450, 30")).toEqual(lightFrom(90, 30));
  expect(parseMoonPlace("90 -20")).toEqual(lightFrom(90, 1));
  expect(parseMoonPlace("90 120")).toEqual(lightFrom(90, 90));
  for (const text of ["90,", ",", "", "90", "east 30", "1 2 3", "NaN 3", "Infinity 3"]) {
    expect(parseMoonPlace(text), text).toBeNull();
  }
});

test("a room of its own moon has a full one, others none unless the page asks for it", () => {
  const none = { illuminance: null, direction: null };
  expect(moonOf(none, null)).toBeNull();
  expect(moonOf(none, [0, -1, 0])).toEqual({ illuminance: 0.15, direction: [0, -1, 0] });
  expect(moonOf({ ...none, illuminance: 0 }, [0, -1, 0])).toBeNull();
  expect(moonOf({ ...none, illuminance: 0.3 }, null)).toEqual({
    illuminance: 0.3,
    direction: CABIN_MOON,
  });
  const wish = { illuminance: 0.1, direction: lightFrom(3, 4) };
  expect(moonOf(wish, [0, -1, 0])).toEqual(wish);
});
