// Types of the element's properties, apart from what has them: declarations of the package need no other package.

/** The camera, as the property `camera` has it. */
export interface Camera {
  /** Metres; the origin is on the floor, in the middle of the room. */
  readonly position: readonly [number, number, number];
  /** Radians, counter-clockwise from above; 0 looks along -Z. */
  readonly yaw: number;
  /** Radians, up positive. */
  readonly pitch: number;
  /** Radians across the frame's shorter side, 0.3 to 2.1; the look's own if it is not given. */
  readonly fieldOfView?: number;
}

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
