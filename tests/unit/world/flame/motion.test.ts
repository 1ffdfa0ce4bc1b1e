import { describe, expect, test } from "vitest";
import { flameLight, TAPER } from "../../../../src/light/flame-light.ts";
import { Air, CALM } from "../../../../src/world/air/air.ts";
import { TAPER_WICK } from "../../../../src/world/flame/burning.ts";
import { Flame } from "../../../../src/world/flame/flame.ts";
import { PARCELS } from "../../../../src/world/flame/spine.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { TICK } from "../../../../src/world/timeline.ts";

const AT_REST: Vec3 = [0, 0, 0];
const EYE: Vec3 = [0, 1.6, 2];

/** Air whose wind along x changes at once; a room's takes a second. */
class Duct extends Air {
  speed = 0;
  override velocity(_place: Readonly<Vec3>, out: Vec3): Vec3 {
    out[0] = this.speed;
    out[1] = out[2] = 0;
    return out;
  }
}

/** Where the light is along x from the foot, m. */
function lean(flame: Flame, foot: Vec3): number {
  return flameLight({ root: foot, flame }, TAPER).position[0] - foot[0];
}

/** Sideways place along x at a share of the height, m. */
function sideways({ spine, height }: Flame, share: number): number {
  const { positions } = spine;
  let parcel = 0;
  while (parcel < PARCELS - 1 && (positions[parcel * 3 + 1] ?? 0) < share * height) parcel++;
  return positions[parcel * 3] ?? 0;
}

test("what a wind has bent stands upright again after some times that gas takes to its tip", () => {
  const duct = new Duct(1, CALM);
  const flame = new Flame(TAPER_WICK, true);
  const foot: Vec3 = [0, 1, 0];
  duct.speed = 0.3;
  for (let t = 0; t < 1; t += TICK) flame.advance(foot, AT_REST, duct, false, TICK);
  const bent = lean(flame, foot);
  expect(bent).toBeGreaterThan(0.003);
  duct.speed = 0;
  let seconds = 0;
  for (; lean(flame, foot) > 0.1 * bent && seconds < 1; seconds += TICK) {
    flame.advance(foot, AT_REST, duct, false, TICK);
  }
  // Gas takes 60 ms from base to tip; half of the light comes from what is younger than 45 ms.
  expect(seconds).toBeGreaterThan(0.02);
  expect(seconds).toBeLessThan(0.15);
});

describe("carried", () => {
  /** Leans of a flame that is taken along at 0.5 m/s from rest, and then held still, at each tick. */
  function carry() {
    const air = new Air(1, CALM);
    const flame = new Flame(TAPER_WICK, true);
    const foot: Vec3 = [0, 1, 0];
    const leans: number[] = [];
    for (let tick = 0; tick < 2 / TICK; tick++) {
      const speed = tick < 1 / TICK ? 0.5 : 0;
      foot[0] += speed * TICK;
      const motion: Vec3 = [speed, 0, 0];
      // In an open hand: nobody shelters it.
      air.advance(tick + 1, EYE, AT_REST, EYE, AT_REST);
      flame.advance(foot, motion, air, false, TICK);
      leans.push(lean(flame, foot));
    }
    return leans;
  }

  test("its tip stays behind, as in a wind of the same speed, and swings back when it stops", () => {
    const leans = carry();
    const steady = leans[Math.round(0.9 / TICK)] ?? 0;
    const duct = new Duct(1, CALM);
    duct.speed = -0.5;
    const standing = new Flame(TAPER_WICK, true);
    for (let t = 0; t < 1; t += TICK) standing.advance([0, 1, 0], AT_REST, duct, false, TICK);
    expect(steady).toBeLessThan(-0.004);
    expect(steady / lean(standing, [0, 1, 0])).toBeCloseTo(1, 1);
    expect(Math.abs(leans.at(-1) ?? 1)).toBeLessThan(2e-4);
  });

  test("it is left behind at once, and has settled in its lean after a fifth of a second", () => {
    const leans = carry();
    const steady = leans[Math.round(0.9 / TICK)] ?? 0;
    const settled = leans.findLastIndex(
      (x, tick) => tick < 1 / TICK - 1 && Math.abs(x / steady - 1) > 0.1,
    );
    expect((settled + 1) * TICK).toBeGreaterThan(0.01);
    expect((settled + 1) * TICK).toBeLessThan(0.2);
  });
});

test("in a draught the upper third is restless, and the lower one is not", () => {
  const air = new Air(3, { speed: 0.15, direction: 0, gustiness: 1 });
  const flame = new Flame(TAPER_WICK, true);
  const swings = [0.2, 0.85].map((share) => ({ share, sum: 0, squares: 0 }));
  const ticks = 20 / TICK;
  for (let tick = 0; tick < ticks; tick++) {
    air.advance(tick + 1, EYE, AT_REST, EYE, AT_REST);
    flame.advance([0, 1, 0], AT_REST, air, false, TICK);
    for (const swing of swings) {
      const x = sideways(flame, swing.share);
      swing.sum += x;
      swing.squares += x * x;
    }
  }
  const [low, high] = swings.map(({ sum, squares }) =>
    Math.sqrt(squares / ticks - (sum / ticks) ** 2),
  );
  expect(high).toBeGreaterThan(0.0005);
  expect((high ?? 0) / (low ?? 1)).toBeGreaterThan(2);
});

test("a walker's wake: a standing flame leans away from the passing body, and then after it", () => {
  const air = new Air(1, CALM);
  const flame = new Flame(TAPER_WICK, true);
  const foot: Vec3 = [0, 1, 0];
  // Past it at a walk, along x, 0.4 m to its side.
  const leans = Array.from({ length: 2 / TICK }, (_, tick) => {
    const eye: Vec3 = [1.4 * (tick * TICK - 1), 1.6, 0.4];
    air.advance(tick + 1, eye, [1.4, 0, 0], eye, AT_REST);
    flame.advance(foot, AT_REST, air, false, TICK);
    return lean(flame, foot);
  });
  const [first, passing, last] = [0.55, 1, 1.5].map((t) => leans[Math.round(t / TICK)] ?? 0);
  expect(first).toBeGreaterThan(1e-4);
  expect(passing).toBeLessThan(-1e-3);
  expect(last).toBeGreaterThan(1e-4);
  expect(Math.abs(leans.at(-1) ?? 1)).toBeLessThan(Math.abs(passing ?? 0) / 5);
});
