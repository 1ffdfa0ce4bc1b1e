import type { CandleFlame } from "../candle-flame.js";
import { moveCamera } from "../world/commands.js";
import { fieldOfViewOf, legalFieldOfView } from "../world/player/field-of-view.js";
import type { Camera } from "./element-types.js";

/**
 * The valid members of a value written to `camera`: those that are missing or no numbers stay as they are. An unchanged
 * field of view remains the look's.
 */
export function changeOf(camera: Partial<Camera>, before: Camera): Partial<Camera> {
  const { position: p, yaw, pitch, fieldOfView } = camera ?? {};
  const legal = legalFieldOfView(fieldOfView);
  const isSame = legal === null || legal === before.fieldOfView;
  const [x, y, z] = before.position;
  return {
    ...(p && { position: [numberOr(x, p[0]), numberOr(y, p[1]), numberOr(z, p[2])] }),
    ...(isNumber(yaw) && { yaw: Number(yaw) }),
    ...(isNumber(pitch) && { pitch: Number(pitch) }),
    ...(!isSame && { fieldOfView: legal }),
  };
}

const isNumber = (value: unknown) => !Number.isNaN(Number(value ?? Number.NaN));
const numberOr = (before: number, value: unknown) => (isNumber(value) ? Number(value) : before);

export function cameraOf({ world }: CandleFlame): Required<Camera> {
  const { position, yaw, pitch } = world.player;
  const [x, y, z] = position;
  return { position: [x, y, z], yaw, pitch, fieldOfView: fieldOfViewOf(world) };
}

/** Moves the camera. Members that are missing stay as they are. */
export function setCamera(candle: CandleFlame, camera: Partial<Camera>): void {
  const { position, yaw, pitch } = { ...cameraOf(candle), ...camera };
  moveCamera(candle.world, position, yaw, pitch, camera.fieldOfView);
}
