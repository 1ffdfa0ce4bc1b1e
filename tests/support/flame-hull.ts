import { mat4 } from "gl-matrix";
import flameVert from "../../shaders/volumetric/flame.vert";
import { type Draw, Gpu } from "../../src/gl/gpu.ts";
import { clipFromWorld, projectionScale } from "../../src/render/camera.ts";
import { carriedWick, FlamePass } from "../../src/render/volumetric/flame-pass.ts";
import { advance } from "../../src/world/advance.ts";
import { createPlume } from "../../src/world/air/plume.ts";
import type { Vec3 } from "../../src/world/geometry.ts";
import { STILL } from "../../src/world/player/intent.ts";
import countFrag from "./count.frag";
import { createWorld } from "./world.ts";

const SIZE = 128;
const FIELD = 0.5;
/** Of the eye from the flame's foot, metres. */
const AWAY = 0.15;

/**
 * Share of the pixels of a flame's hull that are drawn more than once, from all sides. Runs in the browser.
 *
 * @param direction of a gusty wind, radians, and how long it has blown, seconds
 */
export function drawnTwice(direction: number, seconds: number): number[] {
  const gpu = new Gpu(document.createElement("canvas"));
  const pass = new FlamePass(gpu);
  const counter = gpu.program("count", flameVert, countFrag);
  const frame = gpu.uniformBlock(counter, "Frame");
  const source = { width: SIZE, height: SIZE };
  const counts = gpu.texture({ label: "counts", format: "RGBA32F", source });
  const target = gpu.textureView({ label: "counts", textures: [counts], image: 0 });
  const wind = { speed: 0.5, direction, gustiness: 1 };
  const world = createWorld("physical", 1, { wind, createPlume });
  advance(world, STILL, seconds);
  const [x, y, z] = world.interpolated.flame;
  let draw: Draw | null = null;
  gpu.draw = (drawn) => {
    draw = drawn;
  };
  pass.render(target, frame, carriedWick(world), 1);
  Reflect.deleteProperty(gpu, "draw");
  const shares = [0, 1, 2, 3, 4, 5, 6, 7].map((eighth) => {
    const yaw = (eighth * Math.PI) / 4;
    const eye: Vec3 = [x + AWAY * Math.sin(yaw), y + 0.04, z + AWAY * Math.cos(yaw)];
    frame.update({
      clipFromWorld: mat4.copy(mat4.create(), clipFromWorld(eye, yaw, -0.2, 1, FIELD)),
      eyePosition: eye,
      projectionScale: projectionScale(SIZE, FIELD),
    });
    gpu.clear(target, [0, 0, 0, 0]);
    if (draw) gpu.draw({ ...draw, program: counter, textures: {} });
    const reds = gpu.readFloats(target, [0, 0, SIZE, SIZE]).filter((_, i) => i % 3 === 0);
    const drawn = reds.filter((red) => red > 0).length;
    return reds.filter((red) => red > 1).length / Math.max(drawn, 1);
  });
  gpu.dispose();
  return shares;
}
