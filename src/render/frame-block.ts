import { fieldOfViewOf, type World } from "../world/world.js";
import { clipFromWorld, projectionScale } from "./camera.js";
import type { Size } from "./frame-input.js";
import type { FrameSettings } from "./frame-settings.js";

/** Members of the shaders' `Frame` block: the visitor's camera, and the exposure. */
export function frameBlock(
  world: World,
  { features }: FrameSettings,
  { width, height }: Size,
  exposure: number,
) {
  const { interpolated } = world;
  const fieldOfView = fieldOfViewOf(world);
  return {
    clipFromWorld: clipFromWorld(
      interpolated.eye,
      interpolated.yaw,
      interpolated.pitch,
      width / height,
      fieldOfView,
    ),
    eyePosition: interpolated.eye,
    exposure,
    viewport: [width, height],
    projectionScale: projectionScale(Math.min(width, height), fieldOfView),
    normalMaps: features.normalMaps ? 1 : 0,
  };
}
