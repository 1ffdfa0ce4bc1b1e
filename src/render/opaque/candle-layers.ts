import compositeFrag from "../../../shaders/opaque/forward-composite.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { TextureFormat } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Size } from "../frame-input.js";
import type { KeptLight } from "../kept-light.js";

/** Radiance that each standing candle gives for 1 cd: kept until camera or models have moved. */
export class CandleLayers {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #format: TextureFormat;
  readonly #layers = new Map<string, { readonly target: RenderTarget; key: string }>();
  #size: Size = { width: 1, height: 1 };

  constructor(gpu: Gpu, screen: VertexArray) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#format = gpu.drawsToFloats ? "R11F_G11F_B10F" : "RGBA16F";
  }

  resize(size: Size): void {
    this.#size = size;
    for (const { target } of this.#layers.values()) target.dispose();
    this.#layers.clear();
  }

  /**
   * Shades for each candle whose layer is of another frame.
   *
   * @param frameKey of all but the lights
   * @param shade draws the surfaces, and returns their radiance
   * @returns whether any was shaded
   */
  update(
    candles: readonly KeptLight[],
    frameKey: string,
    shade: (candle: KeptLight) => RenderTarget,
  ): boolean {
    for (const [name, { target }] of this.#layers) {
      if (candles.some((candle) => candle.name === name)) continue;
      target.dispose();
      this.#layers.delete(name);
    }
    let isAny = false;
    for (const candle of candles) {
      const layer = this.#layerOf(candle.name);
      const key = JSON.stringify([frameKey, candle.key]);
      if (layer.key === key) continue;
      layer.key = key;
      isAny = true;
      this.#copy(shade(candle), layer.target, [1, 1, 1]);
    }
    return isAny;
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

  /** Adds the candles' radiance, cd/m², within a region. */
  add(candles: readonly KeptLight[], target: TextureView | RenderTarget, scissor: Box): void {
    for (const { name, intensity } of candles) {
      const layer = this.#layers.get(name);
      if (layer) this.#copy(layer.target, target, intensity, scissor);
    }
  }

  #copy(
    from: RenderTarget,
    target: TextureView | RenderTarget,
    uIntensity: readonly number[],
    scissor?: Box,
  ): void {
    this.#gpu.draw({
      program: this.#gpu.program("opaque/forward-composite", fullscreenVert, compositeFrag, {
        defines: { CANDLE: 1 },
      }),
      target,
      vertexArray: this.#screen,
      textures: { uRadiance: from.color },
      uniforms: { uIntensity },
      blend: scissor ? "premultiplied" : "replace",
      scissor,
    });
  }
}
