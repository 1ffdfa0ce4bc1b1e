import { closeModel } from "../assets/model.js";
import { nextTask } from "../gl/next-task.js";
import { uploadNextImage } from "../render/mesh/upload-steps.js";
import { PaperRenderer } from "../render/paper-renderer.js";
import { PhysicalRenderer } from "../render/physical-renderer.js";
import { preparePhysicalRenderer } from "../render/prepare-physical-renderer.js";
import type { Models } from "../render/renderer.js";
import { createPlume } from "../world/air/plume.js";
import type { Vec3 } from "../world/geometry.js";
import { CABIN_MOON, moonOf } from "../world/moon.js";
import { createSample } from "../world/particles/particles.js";
import { CollisionMesh } from "../world/room/collision-mesh.js";
import { createRoom } from "../world/room/room.js";
import { NextRenderer } from "./next-renderer.js";
import { Refinement } from "./refinement.js";
import { loadModels } from "./room-models.js";
import { warnOfRoom } from "./room-warnings.js";
import { placeWicks } from "./room-wicks.js";
import type { Loading, Scene, SceneRequest } from "./scene.js";

/** The candle in a room to walk in. */
export async function loadRoom(request: SceneRequest, loading: Loading): Promise<Scene> {
  const models = await loadModels(request, loading);
  const close = () => [models.room, models.candle].forEach(closeModel);
  try {
    return { ...(await read(models, request)), close };
  } catch (error) {
    close();
    throw error;
  }
}

async function read(models: Models, { look, src }: SceneRequest): Promise<Omit<Scene, "close">> {
  const { parts, anchors } = models.room;
  await nextTask();
  const collision = new CollisionMesh(parts);
  await nextTask();
  const room = createRoom(collision, anchors.spawn ?? null);
  if (src !== "") warnOfRoom(models.room, collision, room);
  await nextTask();
  // The paper's looks have their box, unless the visitor brought a room.
  const isBox = look !== "physical" && src === "";
  const moon: Vec3 | null = anchors.moon ? [...anchors.moon.forward] : null;
  const moonDirection = look === "physical" && src === "" ? (moon ?? CABIN_MOON) : moon;
  return {
    room: isBox ? null : room,
    first: null,
    wicks: look === "physical" ? placeWicks(models.room, collision, room.start) : [],
    createPlume,
    createSample,
    moonDirection,
    isModelAlone: false,
    prepareRenderer: ({ gpu }, tier, { look, moon }) =>
      uploadNextImage(gpu, models.room) &&
      uploadNextImage(gpu, models.candle) &&
      (look !== "physical" ||
        preparePhysicalRenderer(gpu, models, collision, {
          tier,
          isMoonlit: moonOf(moon, moonDirection) !== null,
        })),
    createRenderer: ({ gpu }, tier, look) =>
      look === "physical"
        ? new PhysicalRenderer(gpu, models, collision, tier)
        : new PaperRenderer(gpu, models, tier, look),
    createRefinement: (parts) => new Refinement(parts),
    createNext: (parts) => new NextRenderer(parts),
  };
}
