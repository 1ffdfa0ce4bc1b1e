/** Wavelengths of a spectrum, nanometres: from the first to the last by steps. */
export const WAVELENGTHS = { first: 380, last: 780, step: 4 } as const;
export const BINS = (WAVELENGTHS.last - WAVELENGTHS.first) / WAVELENGTHS.step + 1;

/** Lumens per watt at 555 nm. */
const EFFICACY = 683;
/** hc/k, nanometre kelvin. */
const SECOND_RADIATION = 1.4387769e7;
/** Bands of CH* and C2* in the blue base: nanometres, width, strength. Gaydon 1957, "The Spectroscopy of Flames". */
const BANDS = [
  { at: 431, width: 4, strength: 1 },
  { at: 473, width: 6, strength: 0.5 },
  { at: 516, width: 6, strength: 1 },
  { at: 563, width: 7, strength: 0.5 },
] as const;

export function wavelengthOf(bin: number): number {
  return WAVELENGTHS.first + bin * WAVELENGTHS.step;
}

/** Photopic luminosity function V(λ) of the CIE, a usual fit; wavelength in nanometres. */
export function photopic(wavelength: number): number {
  const away = wavelength / 1000 - 0.559;
  return 1.019 * Math.exp(-285.4 * away * away);
}

/**
 * Spectral radiant intensity of a flame, W/(sr nm), at each of `WAVELENGTHS`.
 *
 * Soot glows as a black body of the flame's colour temperature; the bands of the blue base lie over it.
 * Both are scaled to the candela that they give.
 *
 * @param soot candela
 * @param blue candela
 * @param temperature kelvin
 */
export function spectrumOf(soot: number, blue: number, temperature: number): Float64Array {
  const glow = new Float64Array(BINS);
  const bands = new Float64Array(BINS);
  for (let bin = 0; bin < BINS; bin++) {
    const wavelength = wavelengthOf(bin);
    const exponent = SECOND_RADIATION / (wavelength * Math.max(temperature, 300));
    glow[bin] = 1 / ((wavelength / 560) ** 5 * Math.expm1(exponent));
    for (const { at, width, strength } of BANDS) {
      const away = (wavelength - at) / width;
      bands[bin] = (bands[bin] ?? 0) + strength * Math.exp(-0.5 * away * away);
    }
  }
  const [ofGlow, ofBands] = [soot / candelaOf(glow), blue / candelaOf(bands)];
  return glow.map((power, bin) => power * ofGlow + (bands[bin] ?? 0) * ofBands);
}

/** Luminous intensity of a spectrum, candela. */
export function candelaOf(spectrum: Float64Array): number {
  const sum = spectrum.reduce((sum, power, bin) => sum + power * photopic(wavelengthOf(bin)), 0);
  return EFFICACY * WAVELENGTHS.step * sum;
}
