/**
 * How different two displayed pictures look when one is flipped to the other: 0 not at all, 1 at most.
 *
 * Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
 * Evaluator for Alternating Images", for pictures of sRGB's range.
 */

/** Linear Rec. 709, 0 to 1, three numbers a pixel, rows from the top. */
export interface Shown {
  readonly width: number;
  readonly height: number;
  readonly linear: Float32Array;
}

/** 4K, 0.7 m wide, seen from 0.7 m: the paper's screen. */
const PIXELS_PER_DEGREE = (0.7 * 3840 * Math.PI) / (0.7 * 180);
const COLOR_EXPONENT = 0.7;
const FEATURE_EXPONENT = 0.5;
/** Degrees. */
const FEATURE_WIDTH = 0.082;
/** Where the error of a colour is bent: this share of the largest counts as this much. */
const BEND = { share: 0.4, error: 0.95 };
const D65 = [0.950428545, 1, 1.088900371] as const;

type Triple = [number, number, number];
type Plane = Float32Array;

/** The difference at each pixel. */
export function flip(reference: Shown, test: Shown): Float32Array {
  const [a, b] = [opponent(reference), opponent(test)];
  const [seenA, seenB] = [seen(a, reference), seen(b, reference)];
  const features = featureDifference(a[0], b[0], reference);
  const largest = hyab(hunt(labOf([0, 1, 0])), hunt(labOf([0, 0, 1]))) ** COLOR_EXPONENT;
  const bend = BEND.share * largest;
  return features.map((feature, i) => {
    const colors = [seenA, seenB].map((planes) => {
      const xyz = xyzOf([planes[0]?.[i] ?? 0, planes[1]?.[i] ?? 0, planes[2]?.[i] ?? 0]);
      return hunt(labOf(linearOf(xyz).map((x) => Math.min(Math.max(x, 0), 1)) as Triple));
    }) as [Triple, Triple];
    const error = hyab(...colors) ** COLOR_EXPONENT;
    const bent =
      error < bend
        ? (error / bend) * BEND.error
        : BEND.error + ((error - bend) / (largest - bend)) * (1 - BEND.error);
    return bent ** (1 - feature);
  });
}

/** YyCxCz: luminance and two differences of colours, each linear in light. */
function opponent({ linear, width, height }: Shown): [Plane, Plane, Plane] {
  const planes: [Plane, Plane, Plane] = [0, 1, 2].map(
    () => new Float32Array(width * height),
  ) as never;
  for (let i = 0; i < width * height; i++) {
    const [x, y, z] = xyzOfLinear([...linear.subarray(i * 3, i * 3 + 3)] as Triple);
    const [u, v, w] = [x / D65[0], y / D65[1], z / D65[2]];
    planes[0][i] = 116 * v - 16;
    planes[1][i] = 500 * (u - v);
    planes[2][i] = 200 * (v - w);
  }
  return planes;
}

function xyzOf([y, cx, cz]: Triple): Triple {
  const v = (y + 16) / 116;
  return [D65[0] * (v + cx / 500), D65[1] * v, D65[2] * (v - cz / 200)];
}

/** The planes as the eye blurs them: contrast sensitivity as sums of Gaussians, amount and width. */
function seen(planes: readonly [Plane, Plane, Plane], size: Shown): Plane[] {
  const sensitivity = [
    [[1, 0.0047]],
    [[1, 0.0053]],
    [
      [34.1, 0.04],
      [13.5, 0.025],
    ],
  ] as const;
  const radius = Math.ceil(3 * Math.sqrt(0.04 / (2 * Math.PI ** 2)) * PIXELS_PER_DEGREE);
  return planes.map((plane, index) => {
    const terms = (sensitivity[index] ?? []).map(([amount, width]) => {
      const kernel = kernelOf(radius, (x) => Math.exp((-(Math.PI ** 2) * x * x) / width));
      const sum = kernel.reduce((a, b) => a + b);
      return { kernel, sum, weight: amount * Math.sqrt(Math.PI / width) };
    });
    const total = terms.reduce((all, { weight, sum }) => all + weight * sum * sum, 0);
    const out = new Float32Array(plane.length);
    for (const { kernel, weight } of terms) {
      const blurred = convolve(plane, size, kernel, kernel);
      for (let i = 0; i < out.length; i++)
        out[i] = (out[i] ?? 0) + ((blurred[i] ?? 0) * weight) / total;
    }
    return out;
  });
}

/** Where edges or points of one are not in the other. */
function featureDifference(a: Plane, b: Plane, size: Shown): Float32Array {
  const deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
  const radius = Math.ceil(3 * deviation);
  const inPixels = (shape: (x: number) => number) =>
    kernelOf(radius, (x) => shape(x * PIXELS_PER_DEGREE));
  const gauss = (x: number) => Math.exp((-x * x) / (2 * deviation * deviation));
  const smooth = halvesToOne(inPixels(gauss));
  const edge = halvesToOne(inPixels((x) => -x * gauss(x)));
  const point = halvesToOne(inPixels((x) => (x * x - deviation * deviation) * gauss(x)));
  const strength = (plane: Plane, kernel: number[]) => {
    const grey = plane.map((y) => (y + 16) / 116);
    const across = convolve(grey, size, kernel, smooth);
    const down = convolve(grey, size, smooth, kernel);
    return across.map((x, i) => Math.hypot(x, down[i] ?? 0));
  };
  const [edgeA, edgeB] = [strength(a, edge), strength(b, edge)];
  const [pointA, pointB] = [strength(a, point), strength(b, point)];
  return edgeA.map((x, i) => {
    const edges = Math.abs(x - (edgeB[i] ?? 0));
    const points = Math.abs((pointA[i] ?? 0) - (pointB[i] ?? 0));
    return (Math.max(edges, points) / Math.SQRT2) ** FEATURE_EXPONENT;
  });
}

/** Samples of a function of degrees, one a pixel. */
function kernelOf(radius: number, shape: (degrees: number) => number): number[] {
  return Array.from({ length: 2 * radius + 1 }, (_, i) => shape((i - radius) / PIXELS_PER_DEGREE));
}

/** What is positive adds to 1, what is negative to -1. */
function halvesToOne(kernel: number[]): number[] {
  const above = kernel.reduce((sum, x) => sum + Math.max(x, 0), 0);
  const below = kernel.reduce((sum, x) => sum + Math.max(-x, 0), 0);
  return kernel.map((x) => x / (x > 0 ? above : Math.max(below, 1e-12)));
}

/** Beyond its edge the picture goes on as at the edge. */
function convolve(
  plane: Plane,
  { width, height }: Shown,
  across: number[],
  down: number[],
): Float32Array {
  const pass = (from: Plane, kernel: number[], isAcross: boolean) => {
    const to = new Float32Array(from.length);
    const radius = (kernel.length - 1) / 2;
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        let sum = 0;
        for (let k = -radius; k <= radius; k++) {
          const column = isAcross ? Math.min(Math.max(x + k, 0), width - 1) : x;
          const row = isAcross ? y : Math.min(Math.max(y + k, 0), height - 1);
          sum += (kernel[k + radius] ?? 0) * (from[row * width + column] ?? 0);
        }
        to[y * width + x] = sum;
      }
    }
    return to;
  };
  return pass(pass(plane, across, true), down, false);
}

function xyzOfLinear([r, g, b]: Triple): Triple {
  return [
    0.412390799 * r + 0.357584339 * g + 0.180480788 * b,
    0.212639006 * r + 0.715168679 * g + 0.072192315 * b,
    0.019330819 * r + 0.11919478 * g + 0.950532152 * b,
  ];
}

function linearOf([x, y, z]: Triple): Triple {
  return [
    3.240969942 * x - 1.53738318 * y - 0.49861076 * z,
    -0.96924364 * x + 1.8759675 * y + 0.04155506 * z,
    0.05563008 * x - 0.20397696 * y + 1.05697151 * z,
  ];
}

/** CIE 1976 L*a*b*. */
function labOf(linear: Triple): Triple {
  const [x, y, z] = xyzOfLinear(linear).map((value, i) => {
    const t = value / (D65[i] ?? 1);
    const limit = 6 / 29;
    return t > limit ** 3 ? Math.cbrt(t) : t / (3 * limit * limit) + 4 / 29;
  }) as Triple;
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** Hunt 1952: what is dark has less colour. */
function hunt([lightness, a, b]: Triple): Triple {
  return [lightness, 0.01 * lightness * a, 0.01 * lightness * b];
}

/** Abasi, Amani Tehran and Fairchild 2020, "Distance metrics for very large color differences". */
function hyab(p: Triple, q: Triple): number {
  return Math.abs(p[0] - q[0]) + Math.hypot(p[1] - q[1], p[2] - q[2]);
}
