import type { Camera } from "../../src/candle-flame-element.ts";
import type { Attributes, RoomDriver } from "../support/room-driver.ts";

export type Point = readonly [number, number, number];

/** Of the physical look, radians: src/world/world-setup.ts. */
const FIELD_OF_VIEW = (56 * Math.PI) / 180;

/** What is set, where the eye is, how long it has burnt. */
export interface Shot {
  readonly name: string;
  readonly attributes: Attributes;
  readonly camera: Camera;
  /** Where the candle is put down first, as seen by a visitor who then goes to `camera`. */
  readonly place?: Camera;
  readonly seconds: number;
}

/** A camera at an eye, looking at a point. Metres. */
export function lookingAt(position: Point, [x, y, z]: Point): Camera {
  const [dx, dy, dz] = [x - position[0], y - position[1], z - position[2]];
  return { position, yaw: Math.atan2(-dx, -dz), pitch: Math.atan2(dy, Math.hypot(dx, dz)) };
}

/** Pixels from the upper left, of a place in the room. */
export function onScreen(
  { position, yaw, pitch }: Camera,
  place: readonly number[],
  { width, height }: { readonly width: number; readonly height: number },
): [number, number] {
  const [dx = 0, dy = 0, dz = 0] = position.map((from, axis) => (place[axis] ?? 0) - from);
  const right = dx * Math.cos(yaw) - dz * Math.sin(yaw);
  const level = -dx * Math.sin(yaw) - dz * Math.cos(yaw);
  const ahead = level * Math.cos(pitch) + dy * Math.sin(pitch);
  const up = dy * Math.cos(pitch) - level * Math.sin(pitch);
  const scale = height / (2 * Math.tan(FIELD_OF_VIEW / 2));
  return [width / 2 + (right / ahead) * scale, height / 2 - (up / ahead) * scale];
}

/** Takes a shot with an element that is open, as a PNG. */
export async function take(room: RoomDriver, shot: Omit<Shot, "attributes">): Promise<Buffer> {
  const { camera, place, seconds, name } = shot;
  await room.evaluate((element) => element.reset());
  if (place) {
    const { held, eye } = await room.evaluate((element, place) => {
      element.camera = place;
      element.place();
      return { held: element.held, eye: element.camera.position };
    }, place);
    if (held) throw new Error(`${name}: the candle cannot be put down, seen from ${eye}`);
  }
  await room.stand(camera);
  await room.step(seconds);
  return room.page.locator("candle-flame").screenshot();
}
