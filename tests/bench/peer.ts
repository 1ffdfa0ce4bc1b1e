/** One way to draw the same flame. */
export interface Peer {
  readonly name: string;
  readonly gl: WebGL2RenderingContext;
  /** Update and draw, submitted and not waited for. */
  frame(): void;
  /** Light of one sprite where it is brightest. */
  glow: readonly [number, number, number];
  dispose(): void;
}
