/** Linear Rec. 709 whose luma is cd/m², as `readRadiance` gives it. */
export type Radiance = readonly [red: number, green: number, blue: number];

export type Reading = Readonly<NonNullable<ReturnType<typeof readingOf>>>;

/** Farther than this from the Planckian locus, in u'v', a colour has no temperature (CIE 15). */
const FARTHEST = 0.05;
const COLDEST = 1000;
const HOTTEST = 20_000;

type Uv = readonly [u: number, v: number];

/** CIE 1976 u'v' of a black body, kelvin. Krystek 1985, "An algorithm to calculate correlated colour temperature". */
function planckian(kelvin: number): Uv {
  const t = kelvin;
  const u =
    (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
    (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const v =
    (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
    (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  return [u, 1.5 * v]; // his are of 1960
}

/** Temperature of the black body whose colour is nearest, kelvin; null where the colour is no white at all. */
function temperatureOf([u, v]: Uv): number | null {
  const distance = (logarithm: number) => {
    const [x, y] = planckian(Math.exp(logarithm));
    // Nearest in the diagram of 1960, which correlated temperature is defined in.
    return Math.hypot(x - u, (y - v) / 1.5);
  };
  let low = Math.log(COLDEST);
  let high = Math.log(HOTTEST);
  while (high - low > 1e-4) {
    const third = (high - low) / 3;
    if (distance(low + third) < distance(high - third)) high -= third;
    else low += third;
  }
  const nearest = (low + high) / 2;
  return distance(nearest) < FARTHEST ? Math.exp(nearest) : null;
}

/** @param albedo share of the light that the matt surface is taken to send back */
export function readingOf([red, green, blue]: Radiance, albedo: number) {
  // IEC 61966-2-1, D65.
  const X = 0.4124564 * red + 0.3575761 * green + 0.1804375 * blue;
  const Y = 0.2126729 * red + 0.7151522 * green + 0.072175 * blue;
  const Z = 0.0193339 * red + 0.119192 * green + 0.9503041 * blue;
  if (!(Y > 0)) return null;
  const sum = X + Y + Z;
  const prime = X + 15 * Y + 3 * Z;
  return {
    /** cd/m² */
    luminance: Y,
    /** Light on a matt surface that would look like this, lx. */
    illuminance: (Math.PI * Y) / albedo,
    /** CIE 1931. */
    x: X / sum,
    y: Y / sum,
    /** Correlated colour temperature. */
    temperature: temperatureOf([(4 * X) / prime, (9 * Y) / prime]),
  };
}
