import { created, type GpuContext, GpuObject } from "./gpu-object.js";
import type { Texture } from "./texture.js";

/** Which image of each texture: a face of a cube. */
export interface TextureViewOptions {
  readonly label: string;
  readonly textures: readonly Texture[];
  /** Face 0-5 in GL's order (+X -X +Y -Y +Z -Z); default: 0, which alone a two-dimensional texture has. */
  readonly image?: number;
  /** A depth buffer of its own, or one shared with the views of the other images. Alone it is all that is drawn to. */
  readonly depth?: Texture;
}

/** Textures, or a face of each, to draw to. It does not own the textures. */
export class TextureView extends GpuObject {
  readonly bytes = 0;
  readonly width: number;
  readonly height: number;
  readonly framebuffer: WebGLFramebuffer;
  readonly depth: Texture | undefined;

  constructor(context: GpuContext, { label, textures, image, depth }: TextureViewOptions) {
    super(context, label);
    const { gl } = context;
    const first = textures[0] ?? depth;
    if (!first) throw new Error(`${label}: nothing to draw to.`);
    this.width = first.width;
    this.height = first.height;
    this.depth = depth;
    this.framebuffer = created(gl, gl.createFramebuffer(), label);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    attachTextures(gl, textures, depth ?? null, image);
    gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  protected free(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}

/** Attaches textures, or an image of each, to the framebuffer that is bound. */
export function attachTextures(
  gl: WebGL2RenderingContext,
  colors: readonly Texture[],
  depth: Texture | null,
  image = 0,
): void {
  for (const [i, { target, handle }] of colors.entries()) {
    const face = target === gl.TEXTURE_2D ? target : gl.TEXTURE_CUBE_MAP_POSITIVE_X + image;
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, face, handle, 0);
  }
  if (depth) {
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth.handle, 0);
  }
}
