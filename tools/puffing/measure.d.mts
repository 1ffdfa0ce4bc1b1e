export interface Puffing {
  /** Hz */
  readonly frequency: number;
  /** Of the luminous volume, as a share of its mean. */
  readonly rms: number;
  /** rms of the second half of the time to that of the first. */
  readonly growth: number;
}
export interface Trial {
  readonly settling: number;
  readonly seconds: number;
  readonly diameter: number;
  readonly fuelSpeed: number;
  readonly gravity?: number;
  readonly cellsPerDiameter?: number;
}
export function measure(trial: Trial): Puffing;
export function strongest(values: readonly number[], rate?: number): number;
