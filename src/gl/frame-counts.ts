/** Counts of a view's last frame; its GPU time is that of the newest frame whose result has arrived. */
export interface FrameCounts {
  drawCalls: number;
  triangles: number;
  /** Null where the driver does not tell. */
  seconds: number | null;
}

export const noCounts = (): FrameCounts => ({ drawCalls: 0, triangles: 0, seconds: null });
