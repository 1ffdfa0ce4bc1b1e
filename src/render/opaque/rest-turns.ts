import type { Box } from "../../gl/gpu.js";
import { length3, type Vec3 } from "../../world/geometry.js";
import type { Size } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";
import { tiles } from "../screen-bounds.js";

const { restTiles, calm } = SCHEDULE.lighting;

/**
 * What forward shading draws at rest, where only the flame sways: in turns what is near the flame, and one tile of the frame.
 * While the flame is calm, every other turn of a tile is left out.
 */
export class RestTurns {
  /** Tiles that were shaded for an earlier place of the flame. */
  #stale = 0;
  #tile = 0;
  #isNearDue = true;
  #isLeftOut = false;
  /** Of the flame, when the last tile was shaded. */
  #place: Readonly<Vec3> = [0, 0, 0];

  get isStale(): boolean {
    return this.#stale > 0;
  }

  /** The flame has moved. */
  begin(): void {
    this.#stale = restTiles.rows * restTiles.columns;
  }

  /** All of the frame was drawn. */
  end(): void {
    this.#stale = 0;
  }

  /**
   * @param near what is near the flame; null if that has not moved, or is out of view
   * @param place of the flame, metres
   * @returns pixels to draw; null: none
   */
  next(near: Box | null, place: Readonly<Vec3>, size: Size): Box | null {
    if (!this.isStale) return null;
    const isNear = near && this.#isNearDue;
    this.#isNearDue = !isNear;
    if (isNear) return near;
    const [x, y, z] = place.map((coordinate, axis) => coordinate - this.#place[axis]!) as Vec3;
    this.#isLeftOut = length3(x, y, z) < calm && !this.#isLeftOut;
    if (this.#isLeftOut) return null;
    this.#place = place;
    this.#stale--;
    return tiles(size, restTiles)[this.#tile++ % (restTiles.rows * restTiles.columns)]!;
  }
}
