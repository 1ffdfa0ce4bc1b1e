/** A candle of the scene, as its page may use it: metres, candela, kelvin. */
export interface Candle {
  /** Of its wick's node in the model. */
  readonly name: string;
  /** Whether it burns; writing lights it or puts it out. */
  lit: boolean;
  /** Centre of its light. */
  readonly position: readonly [number, number, number];
  readonly luminousIntensity: number;
  readonly colorTemperature: number;
  light(): void;
  extinguish(): void;
  /** A breath from half a metre away, level, at this candle. */
  blow(strength?: number): void;
}
