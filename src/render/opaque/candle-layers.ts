import compositeFrag from "../../../shaders/opaque/forward-composite.frag";
import type { Box, Gpu, RenderTarget, Texture, TextureFormat, TextureView } from "../../gl/gpu.js";
import type { Rgb } from "../../light/color.js";
import type { CachedLight } from "../cached-light.js";
import type { Size } from "../frame-input.js";

const GROUP = 4;
const DARK: Rgb = [0, 0, 0];
const ONE: Rgb = [1, 1, 1];

/** Radiance for 1 cd, and the intensity that it is multiplied by, cd. */
interface Layer {
  readonly uRadiance: Texture;
  readonly uIntensity: Rgb;
}

/** Draws one to `GROUP` layers. Within a scissor they are added to what is there. */
export function drawScaled(
  gpu: Gpu,
  layers: readonly Layer[],
  target: TextureView | RenderTarget,
  scissor?: Box,
): void {
  const textures: Record<string, Texture> = {};
  const uniforms: Record<string, Rgb> = {};
  const isGroup = layers.length > 1;
  for (let i = 0; i < (isGroup ? GROUP : 1); i++) {
    const suffix = i > 0 ? String(i) : "";
    const { uRadiance, uIntensity } = layers[i] ?? { ...layers[0]!, uIntensity: DARK };
    textures[`uRadiance${suffix}`] = uRadiance;
    uniforms[`uIntensity${suffix}`] = uIntensity;
  }
  const defines = { CANDLE: 1, ...(isGroup && { CANDLES: 1 }) };
  gpu.draw({
    program: gpu.pass("opaque/forward-composite", compositeFrag, { defines }),
    target,
    textures,
    uniforms,
    blend: scissor ? "premultiplied" : "replace",
    scissor,
  });
}

/** Radiance that each standing candle gives for 1 cd: kept until camera or models have moved. */
export class CandleLayers {
  readonly #gpu: Gpu;
  readonly #format: TextureFormat;
  readonly #layers = new Map<string, { readonly target: RenderTarget; key: string }>();
  #size: Size = { width: 1, height: 1 };

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#format = gpu.drawsToFloats ? "R11F_G11F_B10F" : "RGBA16F";
  }

  resize(size: Size): void {
    this.#size = size;
    this.release();
  }

  /** Frees all layers: in motion none is used, and each is of another frame afterwards. */
  release(): void {
    for (const { target } of this.#layers.values()) target.dispose();
    this.#layers.clear();
  }

  /**
   * Shades for each candle whose layer is of another frame.
   *
   * @param frameKey of all but the lights
   * @param shade draws the surfaces, and returns their radiance
   * @param most candles that are shaded
   * @returns whether any was shaded
   */
  update(
    candles: readonly CachedLight[],
    frameKey: string,
    shade: (candle: CachedLight) => RenderTarget,
    most: number,
  ): boolean {
    for (const [name, { target }] of this.#layers) {
      if (candles.some((candle) => candle.name === name)) continue;
      target.dispose();
      this.#layers.delete(name);
    }
    let shaded = 0;
    for (const candle of candles) {
      const layer = this.#layerOf(candle.name);
      const key = JSON.stringify([frameKey, candle.key]);
      if (layer.key === key || shaded === most) continue;
      layer.key = key;
      shaded++;
      drawScaled(this.#gpu, [{ uRadiance: shade(candle).color, uIntensity: ONE }], layer.target);
    }
    return shaded > 0;
  }

  #layerOf(name: string): { readonly target: RenderTarget; key: string } {
    const known = this.#layers.get(name);
    if (known) return known;
    const target = this.#gpu.renderTarget({
      label: `forward/candle ${name}`,
      ...this.#size,
      color: [this.#format],
      filter: "nearest",
    });
    const layer = { target, key: "" };
    this.#layers.set(name, layer);
    return layer;
  }

  /** Adds the candles' radiance, cd/m², within a region: of up to four in a draw. */
  add(candles: readonly CachedLight[], target: TextureView | RenderTarget, scissor: Box): void {
    const shaded = candles.flatMap(({ name, intensity }) => {
      const uRadiance = this.#layers.get(name)?.target.color;
      return uRadiance ? [{ uRadiance, uIntensity: intensity }] : [];
    });
    for (let first = 0; first < shaded.length; first += GROUP) {
      drawScaled(this.#gpu, shaded.slice(first, first + GROUP), target, scissor);
    }
  }
}
