import type { mat4 } from "gl-matrix";
import { describe, expect, test } from "vitest";
import { clipFromWorld } from "../../../src/render/camera.ts";
import type { ReprojectionSource } from "../../../src/render/gbuffer/reprojection.ts";
import { SampleJitter } from "../../../src/render/gbuffer/sample-jitter.ts";

const SIZE = { width: 427, height: 240 };

/** A camera that looks along -Z, turned to the left (rad). */
function turnedBy(yaw: number): ReprojectionSource {
  const clip = clipFromWorld([0, 1.6, 0], yaw, 0, 16 / 9, 1);
  return { clipFromWorld: clip, clipFromHeld: clip, key: "room" };
}

/** A G-buffer is drawn for a camera. */
function draw(jitter: SampleJitter, source: ReprojectionSource): mat4 {
  const clip = jitter.next(source.clipFromWorld, SIZE);
  jitter.drawn(source);
  return clip;
}

describe("SampleJitter", () => {
  test("four G-buffers sample a texel at the centers of its four pixels", () => {
    const jitter = new SampleJitter();
    const offsets = Array.from({ length: 4 }, () => {
      draw(jitter, turnedBy(0));
      return jitter.offset.map((x, axis) => x * [SIZE.width, SIZE.height][axis]!);
    });
    expect(new Set(offsets.map(String)).size).toBe(4);
    for (const offset of offsets.flat()) expect(Math.abs(offset)).toBeCloseTo(0.25);
    draw(jitter, turnedBy(0));
    expect(jitter.offset[0] * SIZE.width).toBeCloseTo(offsets[0]![0]!);
  });

  test("the camera is shifted so that a sample shows what lies at its offset from the texel's center", () => {
    const jitter = new SampleJitter();
    const source = turnedBy(0.3);
    const [plain, shifted] = [source.clipFromWorld, draw(jitter, source)].map((clip) => {
      const [x, y, , w] = [0, 1, 2, 3].map((row) => {
        const point = [-1, 1.2, -3, 1];
        return point.reduce((sum, value, column) => sum + clip[4 * column + row]! * value, 0);
      });
      return [x! / w!, y! / w!]; // normalized device coordinates, 2 across the image
    });
    for (const axis of [0, 1] as const) {
      expect(plain![axis]! - shifted![axis]!).toBeCloseTo(2 * jitter.offset[axis], 6);
    }
  });

  test("a frame is reprojected once, from a G-buffer that was drawn to its end in the frame before", () => {
    const jitter = new SampleJitter();
    const may = (yaw: number) => jitter.mayReproject(jitter.historyOf(turnedBy(yaw)));
    expect(may(0)).toBe(false);
    draw(jitter, turnedBy(0));
    expect(may(0.01)).toBe(true);
    expect(may(0.02)).toBe(false);
    jitter.next(turnedBy(0.02).clipFromWorld, SIZE); // given up
    expect(jitter.historyOf(turnedBy(0.02))).toBeNull();
    expect(may(0.03)).toBe(false);
    draw(jitter, turnedBy(0.03));
    jitter.reset();
    expect(may(0.04)).toBe(false);
  });

  test("a fast turn has a history but is drawn; a cut has none", () => {
    const jitter = new SampleJitter();
    for (const [turn, hasHistory] of [
      [0.15, true],
      [1, false],
    ] as const) {
      draw(jitter, turnedBy(0));
      const found = jitter.historyOf(turnedBy(turn));
      expect(found !== null, `${turn} rad`).toBe(hasHistory);
      expect(jitter.mayReproject(found)).toBe(false);
    }
  });
});
