import type { CandleFlame } from "../candle-flame.js";
import { FARTHEST, moveCamera } from "../world/commands.js";
import { MAX_PITCH } from "../world/player/player.js";
import { fieldOfViewOf } from "../world/world.js";
import type { Camera } from "./element-types.js";

/** Fields of view, radians. */
const NARROWEST = 0.3;
const WIDEST = 2.1;

/**
 * The members of a value written to `camera`, in the range that is legal in any room: those that are missing or not
 * finite stay as they are. An unchanged field of view remains the look's.
 */
export function changeOf(camera: Partial<Camera>, before: Camera): Partial<Camera> {
  const { position: p, yaw, pitch, fieldOfView } = camera ?? {};
  const legal = legalFieldOfView(fieldOfView);
  const isSame = legal === null || legal === before.fieldOfView;
  const [x, y, z] = before.position;
  return {
    ...(p && { position: [numberOr(x, p[0]), numberOr(y, p[1]), numberOr(z, p[2])] }),
    ...(isNumber(yaw) && { yaw: Number(yaw) }),
    ...(isNumber(pitch) && { pitch: within(MAX_PITCH, pitch) }),
    ...(!isSame && { fieldOfView: legal }),
  };
}

/** The nearest legal field of view, radians; null where the value is no number. */
function legalFieldOfView(value: unknown): number | null {
  if (typeof value !== "number" || Number.isNaN(value)) return null;
  return Math.min(Math.max(value, NARROWEST), WIDEST);
}

const isNumber = (value: unknown) => Number.isFinite(Number(value ?? Number.NaN));
const within = (limit: number, value: unknown) => Math.min(Math.max(Number(value), -limit), limit);
const numberOr = (before: number, value: unknown) =>
  isNumber(value) ? within(FARTHEST, value) : before;

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
