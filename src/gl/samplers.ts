/**
 * How a texture is read. One with mipmaps, repeated: its nearest texel, one level bilinearly, or two by so many taps.
 * "nearest": the nearest texel of a target, up to its edges, which costs a CPU half of a `texelFetch`.
 */
export type Sampling = "nearest" | "texel" | "level" | { readonly anisotropy: number };

/** WebGL sampler objects, one for each way of sampling, bound to texture units. */
export class Samplers {
  readonly #gl: WebGL2RenderingContext;
  readonly #anisotropic: EXT_texture_filter_anisotropic | null;
  readonly #mostTaps: number;
  readonly #samplers = new Map<string | number, WebGLSampler | null>();
  /** By texture unit. */
  readonly #bound: (WebGLSampler | null)[] = [];

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#anisotropic = gl.getExtension("EXT_texture_filter_anisotropic");
    const name = this.#anisotropic?.MAX_TEXTURE_MAX_ANISOTROPY_EXT;
    this.#mostTaps = name ? ((gl.getParameter(name) as number | null) ?? 1) : 1;
  }

  /** @param sampling default: the texture's own */
  bind(unit: number, sampling: Sampling | undefined): void {
    const sampler = sampling ? this.#of(sampling) : null;
    if ((this.#bound[unit] ?? null) === sampler) return;
    this.#bound[unit] = sampler;
    this.#gl.bindSampler(unit, sampler);
  }

  #of(sampling: Sampling): WebGLSampler | null {
    const hasTaps = typeof sampling === "object";
    const taps = hasTaps ? Math.min(sampling.anisotropy, this.#mostTaps) : 1;
    const key = hasTaps ? taps : sampling;
    const existing = this.#samplers.get(key);
    if (existing !== undefined) return existing;
    const gl = this.#gl;
    const sampler = gl.createSampler();
    this.#samplers.set(key, sampler);
    if (!sampler) return null; // a lost context: nothing will be drawn with it
    const isSmooth = hasTaps || sampling === "level";
    const minification = hasTaps
      ? gl.LINEAR_MIPMAP_LINEAR
      : {
          nearest: gl.NEAREST,
          texel: gl.NEAREST_MIPMAP_NEAREST,
          level: gl.LINEAR_MIPMAP_NEAREST,
        }[sampling];
    const wrap = sampling === "nearest" ? gl.CLAMP_TO_EDGE : gl.REPEAT;
    gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, minification);
    gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, isSmooth ? gl.LINEAR : gl.NEAREST);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, wrap);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, wrap);
    if (taps > 1 && this.#anisotropic) {
      gl.samplerParameterf(sampler, this.#anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, taps);
    }
    return sampler;
  }

  dispose(): void {
    for (const sampler of this.#samplers.values()) this.#gl.deleteSampler(sampler);
    this.#samplers.clear();
  }
}
