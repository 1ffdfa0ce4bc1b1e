import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { carriedPlacement } from "../../../src/render/carried-placement.ts";
import type { World } from "../../../src/world/world.ts";
import { WORLD_SETUPS } from "../../../src/world/world-setup.ts";

/** The node `flame` of the chamberstick's model, metres. */
function flameNode(): readonly number[] {
  const file = readFileSync("public/models/chamberstick.glb");
  const json = file.subarray(20, 20 + file.readUInt32LE(12)).toString();
  const { nodes } = JSON.parse(json) as { nodes: { name: string; translation: number[] }[] };
  return nodes.find(({ name }) => name === "flame")!.translation;
}

test.each([0, 1, -2.5, Math.PI])(
  "The carried candle's wick is below its flame, at yaw %d",
  (yaw) => {
    const foot = [1, 0.8, -2] as const;
    const setup = WORLD_SETUPS.physical;
    const flame = setup.wick.map((x, axis) => x + foot[axis]!);
    const world = { interpolated: { foot, flame, candleYaw: yaw }, setup } as unknown as World;
    const [x, y, z, turn] = carriedPlacement(world);
    // As in shaders/mesh/mesh.vert.
    const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
    const [across = 0, , away = 0] = flameNode();
    expect(x + cos * across + sin * away).toBeCloseTo(flame[0]!, 6);
    expect(z + cos * away - sin * across).toBeCloseTo(flame[2]!, 6);
    expect(y).toBe(foot[1]);
    expect(Math.hypot(x - foot[0], z - foot[2]), "its foot").toBeLessThan(0.0025);
  },
);
