import displayFrag from "../../shaders/post/display.frag";
import displayVert from "../../shaders/post/display.vert";
import { Gpu } from "../../src/gl/gpu.ts";
import type { Texture } from "../../src/gl/texture.ts";
import { BloomPass } from "../../src/render/post/bloom-pass.ts";
import { toneLut } from "../../src/render/post/display-lut.ts";
import {
  DisplayPass,
  displayTransform,
  displayUniforms,
} from "../../src/render/post/display-pass.ts";
import { ExposurePass } from "../../src/render/post/exposure-pass.ts";
import { allFeatures } from "../../src/settings.ts";
import { EXPOSURE_LAW } from "../../src/world/player/exposure-adaptation.ts";

/** Linear Rec. 709, cd/m². */
type Radiance = readonly [number, number, number];

/** A picture made of colours, each as wide and high as asked, in a row. Runs in the browser. */
export class Eye {
  readonly #canvas = document.createElement("canvas");
  readonly #gpu: Gpu;

  constructor(width: number, height: number) {
    this.#canvas.width = width;
    this.#canvas.height = height;
    this.#gpu = new Gpu(this.#canvas);
  }

  #picture(radianceAt: (x: number, y: number) => Radiance): Texture {
    const { width, height } = this.#canvas;
    const data = new Float32Array(width * height * 4);
    for (let i = 0; i < width * height; i++) {
      data.set([...radianceAt(i % width, Math.floor(i / width)), 1], i * 4);
    }
    const source = { width, height, data };
    return this.#gpu.texture({ label: "picture", format: "RGBA32F", source });
  }

  /** 8-bit sRGB or, where asked for, Display P3: what the canvas has, and what a page that copies it sees. */
  show(
    radianceAt: (x: number, y: number) => Radiance,
    stops: number,
    gamut: PredefinedColorSpace = "srgb",
    usesToneLut = false,
  ): { own: number[]; seen: number[] } {
    const { width, height } = this.#canvas;
    const gpu = this.#gpu;
    const frame = gpu.uniformBlock(
      gpu.program("frame", displayVert, displayFrag, {
        defines: { TONE_LUT: Number(usesToneLut) },
      }),
      "Frame",
    );
    frame.update({
      clipFromWorld: new Float32Array(16),
      eyePosition: [0, 0, 0],
      exposure: 1,
      viewport: [width, height],
      projectionScale: 1,
      normalMaps: 1,
    });
    const picture = this.#picture(radianceAt);
    const exposure = this.#texel(stops);
    const view = { features: { ...allFeatures(), bloom: false }, gamut };
    const transform = displayTransform(gpu, view, 0);
    const uniforms = displayUniforms(transform, view, [1, 1, 0, 0]);
    const textures = {
      uRadiance: picture,
      uBloom: picture,
      uExposure: exposure,
      ...(usesToneLut && { uToneLut: toneLut(gpu)(transform) }),
    };
    new DisplayPass(gpu, usesToneLut).render(textures, uniforms, transform, frame);
    const own = [...gpu.readCanvas([0, 0, width, height])];
    const paper = new OffscreenCanvas(width, height).getContext("2d", { colorSpace: "srgb" });
    paper?.drawImage(this.#canvas, 0, 0);
    const seen = [...(paper?.getImageData(0, 0, width, height).data ?? [])];
    gpu.clearObjects();
    return { own, seen };
  }

  /** Sums of light over the pixels, before and after scattering, of the whole frame or of a flame alone. */
  scatter(
    radianceAt: (x: number, y: number) => Radiance,
    levels: number,
    isFrugal: boolean,
  ): [number, number] {
    const { width, height } = this.#canvas;
    const gpu = this.#gpu;
    const pass = new BloomPass(gpu, levels, "RGBA16F", isFrugal);
    pass.resize(width, height);
    const scattered = pass.render(this.#picture(radianceAt), [[0, 0, width, height]], []);
    const target = gpu.textureView({ label: "scattered", textures: [scattered], image: 0 });
    const after = gpu
      .readFloats(target, [0, 0, target.width, target.height])
      .reduce((sum, value) => sum + value * (isFrugal ? 16 / 0.7 ** 2 : 4), 0); // pixels that each covers, its share
    let before = 0;
    for (let i = 0; i < width * height; i++) {
      const [r, g, b] = radianceAt(i % width, Math.floor(i / width));
      before += r + g + b;
    }
    gpu.clearObjects();
    return [before, after];
  }

  /** How far an earlier frame's bloom is shifted, uv, with flames that were here and are there now. */
  shift(
    before: Parameters<BloomPass["render"]>[2],
    now: Parameters<BloomPass["transform"]>[0],
  ): readonly number[] {
    const { width, height } = this.#canvas;
    const pass = new BloomPass(this.#gpu, 3, "RGBA16F", true);
    pass.resize(width, height);
    pass.render(
      this.#picture(() => [0, 0, 0]),
      [[0, 0, width, height]],
      before,
    );
    const [, , ...shift] = pass.transform(now);
    this.#gpu.clearObjects();
    return shift;
  }

  /** Metered exposure in a room of the cabin's reflectance, stops. */
  meter(radianceAt: (x: number, y: number) => Radiance, lag = 0): number {
    const gpu = this.#gpu;
    const exposure = new ExposurePass(gpu).render(
      { uRadiance: this.#picture(radianceAt) },
      this.#texel(EXPOSURE_LAW.reflectance),
      { lag, darkness: 0 },
    );
    const target = gpu.textureView({ label: "exposure", textures: [exposure], image: 0 });
    const [stops = Number.NaN] = gpu.readFloats(target, [0, 0, 1, 1]);
    gpu.clearObjects();
    return stops;
  }

  /** A texture of one number. */
  #texel(value: number): Texture {
    const source = { width: 1, height: 1, data: new Float32Array([value]) };
    return this.#gpu.texture({ label: "texel", format: "R32F", filter: "nearest", source });
  }

  dispose(): void {
    this.#gpu.dispose();
  }
}
