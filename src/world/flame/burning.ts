/**
 * How a wick burns: laws between its width, its fuel and the size of the flame, all SI.
 *
 * Roper 1977, "The prediction of laminar jet diffusion flame sizes", has height linear in the rate of
 * fuel; between his theory (0.28 mm per mg/min for paraffin) and a measured candle (0.40) we take 0.36.
 */

/** The wick of a household taper, m, and what it burns, kg/s: 0.105 g/min (Hamins et al. 2005). */
export const TAPER_WICK = 0.002;
export const TAPER_RATE = 0.105e-3 / 60;
/** Height of the flame per rate of fuel, m per kg/s. */
const HEIGHT_PER_RATE = 0.36e-3 / (1e-6 / 60);
/** A wider wick burns more, though less than its area does. */
const RATE_EXPONENT = 0.58;
/** Between the wick and the edge of the flame: vapour that air has not yet met. Metres. */
const SHEATH = 0.0032;
/** Heat of burning paraffin, J/kg. */
export const HEAT = 43.5e6;

/** Fuel rate of a wick of this diameter (m) in still air, kg/s. */
export function fuelRate(wick: number): number {
  return TAPER_RATE * (wick / TAPER_WICK) ** RATE_EXPONENT;
}

/** Height of a flame in still air that burns this much (kg/s), m. */
export function flameHeight(rate: number): number {
  return HEIGHT_PER_RATE * rate;
}

/** Height of the full flame of a wick of this diameter (m) in still air, m. */
export function fullHeight(wick: number): number {
  return flameHeight(fuelRate(wick));
}

/** The same as a multiple of a taper's. */
export function heightInTapers(wick: number): number {
  return fuelRate(wick) / TAPER_RATE;
}

/** Largest radius of the luminous flame, m. `fuel` is the share of what its wick can burn. */
export function flameRadius(wick: number, fuel: number): number {
  return wick / 2 + SHEATH * fuel ** 0.4;
}

/** Soot takes time to grow: flames much shorter than this are blue. Metres. */
const SOOT_LENGTH = 0.015;
/** Loss of soot by strain: a factor e for a third of the strain that puts the flame out. */
const SOOT_LOSS = 3;

const TAPER_SOOT = TAPER_RATE * grownSoot(fullHeight(TAPER_WICK));

/** How much of its fuel a flame of this length (m) turns to glowing soot where no air passes. */
function grownSoot(length: number): number {
  return 1 - Math.exp(-((length / SOOT_LENGTH) ** 1.5));
}

/** Combustion and its light. An object, since V8 boxes numbers that are passed. */
export interface Combustion {
  /** Rate of burning, kg/s. */
  rate: number;
  /** Luminous length, metres. */
  height: number;
  /** Strain, as a share of that which puts it out. */
  effectiveStrain: number;
  /** Of its soot, as a share of a taper's in still air. */
  light: number;
}

export function updateLight(fire: Combustion): void {
  const soot = fire.rate * grownSoot(fire.height) * Math.exp(-SOOT_LOSS * fire.effectiveStrain);
  fire.light = soot / TAPER_SOOT;
}

/** Upward acceleration of the gas on the axis, m/s²: Roper's w = √(2 a z). */
export const BUOYANCY = 25;

/**
 * Top speed of the gas, m/s, at a height (m) over a fire of this fuel rate (kg/s), in the flame and above
 * it: McCaffrey 1979, "Purely Buoyant Diffusion Flames".
 */
export function topSpeed(rate: number, height: number): number {
  return Math.min(flameSpeed(rate), plumeSpeed(rate) / Math.cbrt(Math.max(height, 1e-3)));
}

/** Speed within the flame, m/s. */
export function flameSpeed(rate: number): number {
  return 1.9 * kilowatts(rate) ** 0.2;
}

/** Speed in the plume 1 m above, m/s; it falls as the cube root of the height. */
export function plumeSpeed(rate: number): number {
  return 1.1 * Math.cbrt(kilowatts(rate));
}

function kilowatts(rate: number): number {
  return Math.max((rate * HEAT) / 1000, 1e-4);
}

/** How long gas takes from the foot of a flame that burns this much (kg/s) to a height within it (m). */
export function riseTime(rate: number, height: number): number {
  const speedLimit = topSpeed(rate, 0);
  const freeHeight = Math.min(height, (speedLimit * speedLimit) / (2 * BUOYANCY));
  return Math.sqrt((2 * freeHeight) / BUOYANCY) + (height - freeHeight) / speedLimit;
}
