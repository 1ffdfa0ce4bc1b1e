import { describe, expect, test } from "vitest";
import { chromaticity } from "../../../../src/light/color.ts";
import { carriedFlame, flameLight, flameReport, TAPER } from "../../../../src/light/flame-light.ts";
import { CHAMBERSTICK } from "../../../../src/render/light-block.ts";
import { advance } from "../../../../src/world/advance.ts";
import { CALM } from "../../../../src/world/air/air.ts";
import { Gusts } from "../../../../src/world/air/gusts.ts";
import { blow } from "../../../../src/world/commands.ts";
import { flameHeight, TAPER_RATE, TAPER_WICK } from "../../../../src/world/flame/burning.ts";
import { Flame } from "../../../../src/world/flame/flame.ts";
import { heightAfter } from "../../../../src/world/flame/spine.ts";
import { type Intent, STILL } from "../../../../src/world/player/intent.ts";
import { TICK } from "../../../../src/world/timeline.ts";
import type { World } from "../../../../src/world/world.ts";
import { createWorld } from "../../../support/world.ts";

const DEGREE = Math.PI / 180;
const wind = (speed: number, gustiness = 0) => ({ speed, direction: 0, gustiness });

function inWind(speed: number, seconds: number): World {
  const world = createWorld("physical", 1);
  world.plume = null; // hot air above the flame costs time, and carries nothing here
  world.air.wind = wind(speed);
  advance(world, STILL, seconds);
  return world;
}

/** The centre of the light from the foot of the flame, metres. */
function centre(world: World) {
  const { position } = flameLight(carriedFlame(world), TAPER);
  return position.map((x, axis) => x - (world.interpolated.flame[axis] ?? 0)) as [
    number,
    number,
    number,
  ];
}

describe("a taper in still air", () => {
  test("is as high and as wide as one, and 1 cd strong", () => {
    const { height, width, luminousIntensity } = flameReport(
      carriedFlame(createWorld("physical", 1)),
    );
    expect(height).toBeGreaterThan(0.025);
    expect(height).toBeLessThan(0.045);
    expect(height / width).toBeGreaterThan(3);
    expect(height / width).toBeLessThan(6);
    expect(luminousIntensity).toBeCloseTo(1, 6);
  });

  test("has the colour of candlelight", () => {
    const [u, v] = chromaticity(
      flameLight(carriedFlame(createWorld("physical", 1)), TAPER).intensity,
    );
    expect(Math.hypot(u - 0.3159, v - 0.5398)).toBeLessThan(0.01);
    const { colorTemperature } = flameReport(carriedFlame(createWorld("physical", 1)));
    expect(colorTemperature).toBeGreaterThan(1780);
    expect(colorTemperature).toBeLessThan(1980);
  });

  test("is as high as its fuel asks for: 0.25 to 0.45 mm per mg/min", () => {
    const milligramPerMinute = 1e-6 / 60;
    expect(flameHeight(milligramPerMinute)).toBeGreaterThan(0.25e-3);
    expect(flameHeight(milligramPerMinute)).toBeLessThan(0.45e-3);
    const flame = new Flame(TAPER_WICK, true);
    flame.glow = 0; // no light lingers
    const heights = [0.5, 1, 1.5].map((share) => {
      flame.fuel = share;
      return flame.height;
    });
    const slope = Math.log((heights[2] ?? 0) / (heights[0] ?? 1)) / Math.log(3);
    expect(Math.abs(slope - 1)).toBeLessThan(0.15);
  });

  test("stands upright and does not flicker", () => {
    const world = createWorld("physical", 1, { wind: CALM });
    const seen = Array.from({ length: 120 }, () => {
      advance(world, STILL, TICK);
      return flameReport(carriedFlame(world));
    });
    const first = seen[0]?.luminousIntensity ?? 0;
    for (const { luminousIntensity, tilt } of seen) {
      expect(Math.abs(luminousIntensity / first - 1)).toBeLessThan(0.03);
      expect(tilt).toBeLessThan(3 * DEGREE);
    }
  });

  test("rises as measured plumes do", () => {
    const speed = (z: number) => (heightAfter(z, 1e-4, TAPER_RATE) - z) / 1e-4;
    for (const [z, measured] of [
      [0.01, 0.71],
      [0.02, 1.0],
      [0.04, 1.2],
    ] as const) {
      expect(speed(z) / measured).toBeGreaterThan(0.6);
      expect(speed(z) / measured).toBeLessThan(1.2);
    }
    const tip = flameHeight(TAPER_RATE);
    const slope = Math.log(speed(tip) / speed(0.01)) / Math.log(tip / 0.01);
    expect(Math.abs(slope - 0.5)).toBeLessThan(0.15);
  });
});

describe("in a wind", () => {
  test("it leans the more, and shines the less, the stronger it blows", () => {
    const [light, fair, fresh] = [0.1, 0.3, 0.5].map((speed) =>
      flameReport(carriedFlame(inWind(speed, 2))),
    );
    if (!light || !fair || !fresh) throw new Error("Three winds, three flames.");
    expect(light.tilt).toBeLessThan(20 * DEGREE);
    expect(fair.tilt).toBeGreaterThan(12 * DEGREE);
    expect(fair.tilt).toBeLessThan(50 * DEGREE);
    expect(fresh.tilt).toBeGreaterThan(25 * DEGREE);
    expect(fresh.tilt).toBeLessThan(60 * DEGREE);
    expect(light.tilt).toBeLessThan(fair.tilt);
    expect(fair.tilt).toBeLessThan(fresh.tilt);
    expect(fresh.luminousIntensity).toBeLessThan(fair.luminousIntensity);
    expect(fresh.height).toBeLessThan(light.height);
  });

  test("it leans to where the wind blows, and straightens soon after", () => {
    const world = inWind(0.5, 1);
    expect(centre(world)[2]).toBeLessThan(-0.004);
    world.air.wind = CALM;
    advance(world, STILL, 1.6);
    expect(Math.abs(centre(world)[2])).toBeLessThan(0.001);
  });

  test("at 90 degrees it blows to -X", () => {
    const world = createWorld("physical", 1);
    world.air.wind = { ...wind(0.5), direction: Math.PI / 2 };
    advance(world, STILL, 1);
    const [x, , z] = centre(world);
    expect(x).toBeLessThan(-0.004);
    expect(Math.abs(z)).toBeLessThan(0.001);
  });

  test("it lives at 0.5 m/s for ten seconds, and is out within a second at 4 m/s", () => {
    expect(inWind(0.5, 10).flame.isLit).toBe(true);
    expect(inWind(4, 1).flame.isLit).toBe(false);
  });

  test("a remnant recovers if the gust ends in time", () => {
    const world = createWorld("physical", 1);
    const { flame, air } = world;
    air.wind = wind(4);
    while (flame.isLit && flame.fuel > 0.3) advance(world, STILL, TICK);
    const least = flame.fuel;
    expect(least).toBeLessThan(0.6);
    air.wind = CALM;
    advance(world, STILL, 1.5);
    expect(flame.isLit).toBe(true);
    expect(flame.fuel).toBeGreaterThan(0.9);
  });
});

test("carried, it lags behind; put at rest, it is upright again", () => {
  const world = createWorld("physical", 1);
  const { yaw } = world.player;
  const walking: Intent = { ...STILL, forward: 1 };
  advance(world, walking, 0.6);
  const [x, , z] = centre(world);
  const ahead = -x * Math.sin(yaw) - z * Math.cos(yaw);
  expect(ahead).toBeLessThan(-0.003);
  advance(world, STILL, 1.5);
  const [restX, , restZ] = centre(world);
  expect(Math.hypot(restX, restZ)).toBeLessThan(0.001);
});

describe("out and in again", () => {
  test("a full breath blows it out, a faint one does not", () => {
    const [faint, full] = [0.2, 1].map((strength) => {
      const world = createWorld("physical", 1);
      blow(world, strength);
      advance(world, STILL, 1.5);
      return world.flame.isLit;
    });
    expect(faint).toBe(true);
    expect(full).toBe(false);
  });

  test("what still shines while it is blown out is a flame, not a bare wick", () => {
    const world = createWorld("physical", 1);
    const { flame } = world;
    blow(world, 1);
    const heights: number[] = [];
    for (let i = 0; i < 0.6 / TICK; i++) {
      advance(world, STILL, TICK);
      if (flame.relativeLight > 0.1) heights.push(flame.height);
    }
    expect(flame.isLit).toBe(false);
    expect(Math.min(...heights)).toBeGreaterThan(0.003);
  });

  test("soft breaths, three a second, are one that goes on", () => {
    const world = createWorld("physical", 1);
    world.plume = null;
    const felt: number[] = [];
    for (let i = 0; i < 30; i++) {
      if (i % 3 === 0) blow(world, 0.1);
      advance(world, STILL, 0.1);
      if (i >= 10) felt.push(Math.hypot(...world.air.velocity(world.emitter, [0, 0, 0])));
    }
    expect(Math.min(...felt)).toBeGreaterThan(0.2);
    expect(Math.max(...felt) / Math.min(...felt)).toBeLessThan(1.5);
    expect(world.flame.isLit).toBe(true);
  });

  test("lit again once the breath is over, it burns on", () => {
    const world = createWorld("physical", 1);
    world.plume = null;
    blow(world, 3);
    advance(world, STILL, 1);
    expect(world.flame.isLit).toBe(false);
    world.flame.light();
    advance(world, STILL, 0.5);
    expect(world.flame.isLit).toBe(true);
    expect(world.flame.fuel).toBeGreaterThan(0.9); // its vapour caught, so it grows at once
  });

  test("a dying flame shines from the wick's tip, over the candle's rim", () => {
    const world = createWorld("physical", 1);
    const rim = CHAMBERSTICK.rim - world.setup.wick[1];
    world.flame.extinguish();
    for (let i = 0; i < 1 / TICK; i++) {
      expect(centre(world)[1], `after ${i} ticks`).toBeGreaterThan(rim + 0.004);
      advance(world, STILL, TICK);
    }
    expect(world.flame.glow).toBe(0);
  });

  test("the ember fades, and vapour with it", () => {
    const { flame, air } = createWorld("physical", 1);
    flame.extinguish();
    const vapour = flame.vapour;
    expect(flame.ember).toBeGreaterThan(1000);
    expect(vapour).toBeGreaterThan(0);
    for (let i = 0; i < 5 / TICK; i++) flame.advance([0, 0, 0], [0, 0, 0], air, true, TICK);
    expect(flame.vapour).toBeLessThan(vapour);
    for (let i = 0; i < 10 / TICK; i++) flame.advance([0, 0, 0], [0, 0, 0], air, true, TICK);
    expect(flame.ember).toBeLessThan(798);
    expect(flame.vapour).toBe(0);
  });

  test("lit again, it is not darker than its ember was", () => {
    const world = createWorld("physical", 1);
    world.flame.extinguish();
    advance(world, STILL, 3);
    const { luminousIntensity } = flameReport(carriedFlame(world));
    expect(luminousIntensity).toBeGreaterThan(0);
    world.flame.light();
    for (let i = 0; i < 10; i++) {
      const relit = flameReport(carriedFlame(world)).luminousIntensity;
      expect(relit, `after ${i} ticks`).toBeGreaterThan(0.9 * luminousIntensity);
      advance(world, STILL, TICK);
    }
  });

  test("lit, it grows over about a second", () => {
    const world = createWorld("physical", 1, { isLit: false });
    expect(flameReport(carriedFlame(world)).luminousIntensity).toBeLessThan(1e-6);
    expect(world.flame.light()).toBe(true);
    expect(world.flame.light()).toBe(false);
    advance(world, STILL, 0.3);
    expect(world.flame.fuel).toBeLessThan(0.5);
    advance(world, STILL, 0.9);
    expect(world.flame.fuel).toBeGreaterThan(0.95);
  });
});

test("where motion is reduced it stands still in any draught, and still goes out in a gale", () => {
  const world = createWorld("physical", 1, { wind: wind(1, 1), wick: 0.05 });
  world.plume = null;
  world.sways = false;
  advance(world, STILL, 3);
  const first = flameReport(carriedFlame(world));
  for (let i = 0; i < 60; i++) {
    advance(world, STILL, 1 / 60);
    const { height, luminousIntensity, tilt, width } = flameReport(carriedFlame(world));
    expect(tilt).toBeLessThan(1e-6);
    expect(height).toBeCloseTo(first.height, 6);
    expect(width).toBeCloseTo(first.width, 6);
    expect(luminousIntensity).toBeCloseTo(first.luminousIntensity, 4);
  }
  const taper = createWorld("physical", 1);
  taper.sways = false;
  taper.air.wind = wind(4);
  advance(taper, STILL, 1.5);
  expect(taper.flame.isLit).toBe(false);
});

test("the same seed is the same flame at 30 and 144 Hz", () => {
  const at = (hertz: number) => {
    const world = createWorld("physical", 7, { wind: wind(0.3, 1) });
    for (let i = 0; i < hertz; i++) advance(world, STILL, 1 / hertz);
    return [...world.flame.spine.positions];
  };
  expect(at(144)).toEqual(at(30));
});

test("gusts have no divergence", () => {
  const gusts = new Gusts(3);
  gusts.strength = 1;
  gusts.time = 2.5;
  const STEP = 1e-4;
  const at = (x: number, y: number, z: number) => {
    const velocity: [number, number, number] = [0, 0, 0];
    gusts.add([x, y, z], velocity);
    return velocity;
  };
  let [divergence, gradient] = [0, 0];
  for (let i = 0; i < 20; i++) {
    const [x, y, z] = [0.31 * i, 0.17 * i, 0.23 * i];
    const across = [
      (at(x + STEP, y, z)[0] - at(x - STEP, y, z)[0]) / (2 * STEP),
      (at(x, y + STEP, z)[1] - at(x, y - STEP, z)[1]) / (2 * STEP),
      (at(x, y, z + STEP)[2] - at(x, y, z - STEP)[2]) / (2 * STEP),
    ];
    divergence = Math.max(divergence, Math.abs(across.reduce((sum, value) => sum + value)));
    gradient = Math.max(gradient, ...across.map(Math.abs));
  }
  expect(divergence).toBeLessThan(1e-5 * gradient);
});
