import type { Gpu } from "../gl/gpu.js";
import type { CollisionMesh } from "../world/room/collision-mesh.js";
import { fitToRoom } from "./gi/fit-to-room.js";
import { probeTraceOf } from "./gi/probe-rays.js";
import { kindOf } from "./mesh/mesh.js";
import { uploadNextPart } from "./mesh/upload-steps.js";
import { areForwardProgramsCompiled } from "./opaque/forward-programs.js";
import type { Tier } from "./quality.js";
import type { Models } from "./renderer.js";
import { SCHEDULE } from "./schedule.js";
import { clustersOf } from "./shadow/shadow-casters.js";

/**
 * Prepares a `PhysicalRenderer` a little at a time: uploads meshes, compiles, clusters the casters, and traces the
 * probes' rays.
 *
 * @returns whether all of it is done
 */
export function preparePhysicalRenderer(
  gpu: Gpu,
  { room, candle }: Models,
  collision: CollisionMesh,
  { tier, isMoonlit }: { readonly tier: Tier; readonly isMoonlit: boolean },
): boolean {
  const { opaque, indirect, casterError } = tier.physical;
  const kinds = [...room.parts, ...candle.parts].map(({ material }) => kindOf(material));
  const isCompiled =
    opaque === "deferred" || areForwardProgramsCompiled(gpu, tier, { isMoonlit }, kinds);
  return (
    uploadNextPart(gpu, room) &&
    uploadNextPart(gpu, candle) &&
    clustersOf(room, { error: casterError }).proceed() &&
    // A refined image begins in another renderer's light.
    (opaque === "refined" ||
      probeTraceOf(collision, room, fitToRoom(indirect, collision, room)).proceed(
        SCHEDULE.probesPerFrame,
      )) &&
    isCompiled
  );
}
