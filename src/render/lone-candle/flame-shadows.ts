import shadowFrag from "../../../shaders/candle/custom-shadow.frag";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type { Gpu, Program, RenderTarget, Texture } from "../../gl/gpu.js";
import type { RootedFlame } from "../../light/flame-light.js";
import { heightInTapers } from "../../world/flame/burning.js";
import type { Flame } from "../../world/flame/flame.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Mesh } from "../mesh/mesh.js";
import { clipFromFace, FACES } from "../shadow/cube-map.js";

const NEAR = 0.003;
const FAR = 20;
/** Nothing is farther, metres. */
const NOTHING = [1e3, 0, 0, 1] as const;
/** A taper's middle above its root, metres. */
const MIDDLE = 0.016;

/** Height above a flame's root from which its shadows are seen, metres: its middle at rest. */
export const shadowHeight = ({ wick }: Flame) => MIDDLE * heightInTapers(wick);

/**
 * Shadow cubes of all flames of a model in one atlas: distances from each flame's middle at rest. Model and
 * flames stand, so each is drawn once, and again for a wick of another width. The tiles of a cube are in the order of `FACES`, which is that of
 * `shaders/lib/flame-shadows.glsl`.
 */
export class FlameShadows {
  readonly tiles: readonly [across: number, down: number];
  /** Texels of a face's side. */
  readonly face: number;
  readonly #gpu: Gpu;
  readonly #target: RenderTarget;
  /** Heights of the flames that their tiles are drawn for, metres. */
  readonly #drawn: number[] = [];

  constructor(gpu: Gpu, flames: number, face: number) {
    this.#gpu = gpu;
    this.face = face;
    const across = Math.min(flames, 4);
    this.tiles = [across, Math.ceil(flames / across)];
    const [x, y] = this.tiles;
    const size = { width: x * 3 * face, height: y * 2 * face };
    const format = { color: ["R16F"], depth: "buffer", filter: "nearest" } as const;
    this.#target = gpu.renderTarget({ label: "candle/shadow-atlas", ...size, ...format });
  }

  /** Requests the programs of some casters, which compile while others do. */
  request(casters: readonly Mesh[]): void {
    for (const { isCutOut } of casters) this.#programOf(isCutOut);
  }

  render(flames: readonly RootedFlame[], casters: readonly Mesh[]): Texture {
    for (const [tile, { root, flame }] of flames.entries()) {
      const height = shadowHeight(flame);
      if (this.#drawn[tile] === height) continue;
      this.#drawn[tile] = height;
      const [x, y, z] = root;
      const [column, row] = this.#placeOf(tile);
      this.#gpu.clear(this.#target, NOTHING, [column, row, 3 * this.face, 2 * this.face]);
      for (const face of FACES.keys()) this.#drawFace(tile, face, [x, y + height, z], casters);
    }
    return this.#target.color;
  }

  /** Its lower left corner in the atlas, texels. */
  #placeOf(tile: number): readonly [number, number] {
    const across = this.tiles[0];
    return [(tile % across) * 3 * this.face, Math.floor(tile / across) * 2 * this.face];
  }

  #programOf(isCutOut: boolean): Program {
    const defines = isCutOut ? { COLORED: 1 } : {};
    return this.#gpu.program("candle/custom-shadow", cubeFaceVert, shadowFrag, { defines });
  }

  #drawFace(tile: number, face: number, uFlame: Vec3, casters: readonly Mesh[]): void {
    const uClipFromWorld = clipFromFace(face, uFlame, 1, NEAR, FAR);
    const side = this.face;
    const [left, bottom] = this.#placeOf(tile);
    const [column, row] = [left + (face % 3) * side, bottom + Math.floor(face / 3) * side];
    for (const { vertexArray, textures, uniforms, isCutOut } of casters) {
      this.#gpu.draw({
        program: this.#programOf(isCutOut),
        target: this.#target,
        vertexArray,
        textures,
        viewport: [column, row, side, side],
        uniforms: { ...(isCutOut ? uniforms : {}), uClipFromWorld, uFlame },
        depth: "test-and-write",
        cull: "none",
      });
    }
  }
}
