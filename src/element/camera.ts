import type { CandleFlame } from "../candle-flame.js";
import { moveCamera } from "../world/commands.js";
import { fieldOfViewOf, legalFieldOfView } from "../world/player/field-of-view.js";
import type { Camera } from "./element-types.js";

/** The valid members of a value written to `camera`. An unchanged field of view remains the look's. */
export function changeOf(camera: Partial<Camera>, before: Camera): Partial<Camera> {
  // Spreading a string would make an object of its letters.
  const { fieldOfView, ...others } = typeof camera === "object" ? { ...camera } : {};
  const legal = legalFieldOfView(fieldOfView);
  const isSame = legal === null || legal === before.fieldOfView;
  return isSame ? others : { ...others, fieldOfView: legal };
}

export function cameraOf({ world }: CandleFlame): Required<Camera> {
  const { position, yaw, pitch } = world.player;
  const [x, y, z] = position;
  return { position: [x, y, z], yaw, pitch, fieldOfView: fieldOfViewOf(world) };
}

/** Moves the camera. Members that are missing or no numbers stay as they are. */
export function setCamera(candle: CandleFlame, camera: Partial<Camera>): void {
  const { position, yaw, pitch } = { ...cameraOf(candle), ...camera };
  moveCamera(
    candle.world,
    position ?? candle.world.player.position,
    Number(yaw),
    Number(pitch),
    camera.fieldOfView,
  );
}
