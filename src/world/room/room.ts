import { CANDLE_CYLINDER } from "../candle.js";
import type { Vec3 } from "../geometry.js";
import { ExposureAdaptation } from "../player/exposure-adaptation.js";
import { EYE_HEIGHT } from "../player/gait.js";
import { gazeDirection, type Player } from "../player/player.js";
import type { World } from "../world.js";
import type { CollisionMesh } from "./collision-mesh.js";
import { FloorPlan } from "./floor-plan.js";
import type { MovementBounds } from "./movement-bounds.js";
import { canTake, findSpot, type Refusal } from "./placement.js";
import { findWayToWick } from "./wick-reach.js";

/** The eye keeps this far from floor and ceiling, metres. */
const HEADROOM = 0.15;

export type Room = Readonly<ReturnType<typeof createRoom>>;

/** @param spawn where to start and which way to face, if the room says so */
export function createRoom(
  collision: CollisionMesh,
  spawn: { readonly position: readonly [number, number, number]; readonly yaw: number } | null,
) {
  const plan = new FloorPlan(collision, spawn ? [...spawn.position] : null);
  const { min, max } = collision.bounds;
  const lowest = Math.min(min[1], plan.floor) + HEADROOM;
  const highest = Math.max(max[1], plan.floor + EYE_HEIGHT + 2 * HEADROOM) - HEADROOM;
  const movementBounds: MovementBounds = {
    move: (position, way, velocity) => plan.walk(position, way, velocity),
    clamp(position) {
      position[1] = Math.min(Math.max(position[1], lowest), highest);
      plan.settle(position);
    },
  };
  const [x, y, z] = plan.start;
  return {
    collision,
    plan,
    movementBounds,
    createAdaptation: () => new ExposureAdaptation(collision),
    /** Initial eye position, metres, and yaw. */
    start: [x, y + EYE_HEIGHT, z] as Readonly<Vec3>,
    yaw: spawn?.yaw ?? 0,
    /** Whether another one is of the same model: each element loads its own. */
    isSame({ collision: { triangles } }: { readonly collision: CollisionMesh }): boolean {
      const mine = collision.triangles;
      return mine.length === triangles.length && mine.every((x, i) => x === triangles[i]);
    },
    /** Finds a place for the candle, and writes its foot's to `spot`. Null, or why there is none. */
    findSpot(player: Player, spot: Vec3): Refusal | null {
      const { position: eye } = player;
      const direction = gazeDirection(player);
      return findSpot({ collision, plan, eye, direction, cylinder: CANDLE_CYLINDER }, spot);
    },
    /** Whether a candle that stands at a place can be taken up. */
    canTake: ({ position }: Player, foot: Readonly<Vec3>): boolean =>
      canTake(collision, position, foot, CANDLE_CYLINDER),
    /** Finds the hand's way to a wick. False if there is none in reach. */
    findWayToWick: (world: World, way: Vec3): boolean => findWayToWick(world, way, collision),
    /** Distance that a breath reaches: to what it meets first, and the flame of a candle that it meets. Metres. */
    reachOfBreath(mouth: Readonly<Vec3>, direction: Readonly<Vec3>): number {
      const wall = collision.raycast(mouth, direction, Infinity)?.distance ?? Infinity;
      return wall + CANDLE_CYLINDER.radius;
    },
  };
}
