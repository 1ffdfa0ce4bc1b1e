/** How a texture with mipmaps is read: its nearest texel, one level bilinearly, or two by so many taps. */
export type Sampling = "texel" | "level" | { readonly anisotropy: number };

/** WebGL sampler objects, one for each way of sampling, bound to texture units. They repeat textures. */
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
    const taps = typeof sampling === "object" ? Math.min(sampling.anisotropy, this.#mostTaps) : 1;
    const key = typeof sampling === "object" ? taps : sampling;
    const existing = this.#samplers.get(key);
    if (existing !== undefined) return existing;
    const gl = this.#gl;
    const sampler = gl.createSampler();
    this.#samplers.set(key, sampler);
    if (!sampler) return null; // a lost context: nothing will be drawn with it
    const isTexel = sampling === "texel";
    const oneLevel = isTexel ? gl.NEAREST_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_NEAREST;
    const minification = typeof sampling === "object" ? gl.LINEAR_MIPMAP_LINEAR : oneLevel;
    gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, minification);
    gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, isTexel ? gl.NEAREST : gl.LINEAR);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, gl.REPEAT);
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
