import type { Vec3 } from "../geometry.js";
import type { CollisionMesh } from "../room/collision-mesh.js";
import type { World } from "../world.js";
import { type AdaptationView, ExposureAdaptation } from "./exposure-adaptation.js";

/** Middle of a flame from its foot, metres. */
const MIDDLE = 0.025;

/** The eye's adaptation to what a world shows of a room in real light. */
export class RoomAdaptation {
  readonly #exposure = new ExposureAdaptation();
  readonly #view: AdaptationView;

  /** @param eye the player's */
  constructor(collision: CollisionMesh, eye: Readonly<Vec3>) {
    const flame: Vec3 = [0, 0, 0];
    const light = { flame, candle: 0, luminousIntensity: 0, moonlight: 0 };
    this.#view = { collision, eye, yaw: 0, pitch: 0, fieldOfView: 0, ...light };
  }

  /** Stops by which the eye is open wider than the view asks for. */
  get lag(): number {
    return this.#exposure.lag;
  }

  /** Adaptation to moonlight, 0 to 1. */
  get darkness(): number {
    return this.#exposure.darkness;
  }

  advance(world: World, seconds: number): void {
    this.#exposure.advance(this.#viewOf(world), seconds);
  }

  /** Adapts fully, to the dark as well: in a new world. */
  adaptFully(world: World): void {
    this.#exposure.adaptToDark(this.#viewOf(world));
    this.settle(world);
  }

  /** Adapts to the view: after a cut. */
  settle(world: World): void {
    this.#exposure.settle(this.#viewOf(world));
  }

  /** Lags behind: after a sudden change. */
  notice(world: World): void {
    this.#exposure.notice(this.#viewOf(world));
  }

  #viewOf(world: World): AdaptationView {
    const { player } = world;
    const view = this.#view;
    // Chosen by branches: as the value of an expression that may be null, a number is boxed.
    if (world.fieldOfView === null) view.fieldOfView = world.setup.fieldOfView;
    else view.fieldOfView = world.fieldOfView;
    view.yaw = player.yaw;
    view.pitch = player.pitch;
    const root = brightestRoot(world);
    for (let axis = 0; axis < 3; axis++) view.flame[axis] = root.place[axis]!;
    view.flame[1] += MIDDLE;
    view.candle = root.candle;
    view.luminousIntensity = root.glow;
    view.moonlight = world.moon?.illuminance ?? 0;
    return view;
  }
}

const brightest: { candle: number; place: Readonly<Vec3>; glow: number } = {
  candle: 0,
  place: [0, 0, 0],
  glow: 0,
};
/** How much brighter than the carried flame, which is near, another one has to be. */
const BRIGHTER = 2;

/** Root of the carried flame, or of a brighter one. */
function brightestRoot({ flame, emitter, standing }: World): typeof brightest {
  brightest.candle = 0;
  brightest.place = emitter;
  brightest.glow = flame.glow;
  let most = flame.glow * BRIGHTER;
  for (let i = 0; i < standing.length; i++) {
    const candle = standing[i]!;
    if (!(candle.flame.glow > most)) continue;
    most = candle.flame.glow;
    brightest.candle = i + 1;
    brightest.place = candle.root;
    brightest.glow = most;
  }
  return brightest;
}
