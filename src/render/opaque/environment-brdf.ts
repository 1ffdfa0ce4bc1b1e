/** Edge of the table. */
export const ENVIRONMENT_BRDF_SIZE = 32;
/** Samples of the visible facets along each axis. */
const FACETS = 16;

/**
 * Directional albedo of a rough mirror: (with Fresnel's term at 1, its part by that term), by the cosine of the
 * view angle along x and roughness along y, each from 0 to 1 in texels.
 *
 * After Karis 2013, "Real Shading in Unreal Engine 4", by sampling visible normals: Heitz 2018, "Sampling the GGX
 * Distribution of Visible Normals".
 */
export function tabulateEnvironmentBrdf(): Float32Array {
  const table = new Float32Array(ENVIRONMENT_BRDF_SIZE * ENVIRONMENT_BRDF_SIZE * 2);
  for (let y = 0; y < ENVIRONMENT_BRDF_SIZE; y++) {
    for (let x = 0; x < ENVIRONMENT_BRDF_SIZE; x++) {
      const cosine = Math.max(x / (ENVIRONMENT_BRDF_SIZE - 1), 1e-3);
      const roughness = Math.max(y / (ENVIRONMENT_BRDF_SIZE - 1), 0.03);
      table.set(reflectance(cosine, roughness ** 2), (y * ENVIRONMENT_BRDF_SIZE + x) * 2);
    }
  }
  return table;
}

/** Heitz 2014, "Understanding the Masking-Shadowing Function": ratio of hidden to visible area. */
function hidden(alpha: number, cosine: number): number {
  const slope = (alpha * alpha * (1 - cosine * cosine)) / (cosine * cosine);
  return (Math.sqrt(1 + slope) - 1) / 2;
}

/** @param cosine of the view angle */
function reflectance(cosine: number, alpha: number): [number, number] {
  // View direction in the space where facets are spread over a hemisphere; it lies in the plane y = 0.
  const sine = Math.sqrt(Math.max(1 - cosine * cosine, 0));
  const stretch = Math.hypot(alpha * sine, cosine);
  const [ex, ez] = [(alpha * sine) / stretch, cosine / stretch];
  const atEye = hidden(alpha, cosine);
  let whole = 0;
  let fresnel = 0;
  for (let i = 0; i < FACETS * FACETS; i++) {
    const radius = Math.sqrt(((i % FACETS) + 0.5) / FACETS);
    const angle = (2 * Math.PI * (Math.floor(i / FACETS) + 0.5)) / FACETS;
    const across = radius * Math.cos(angle);
    const rest = Math.sqrt(1 - across * across);
    const share = (1 + ez) / 2;
    const up = (1 - share) * rest + share * radius * Math.sin(angle);
    const ahead = Math.sqrt(Math.max(1 - across * across - up * up, 0));
    // Axes: y, and perpendicular to the view direction in its plane.
    const hx = alpha * (ahead * ex - up * ez);
    const hy = alpha * across;
    const hz = Math.max(ahead * ez + up * ex, 1e-6);
    const length = Math.hypot(hx, hy, hz);
    const facing = (hx * sine + hz * cosine) / length;
    const light = (2 * facing * hz) / length - cosine;
    if (light <= 0 || facing <= 0) continue;
    const shown = (1 + atEye) / (1 + atEye + hidden(alpha, light));
    whole += shown;
    fresnel += shown * (1 - facing) ** 5;
  }
  return [whole / FACETS ** 2, fresnel / FACETS ** 2];
}
