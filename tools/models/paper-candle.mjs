/**
 * The paper's candle in the paper's units: 64 segments, radius 0.2, height 1, a top dished 0.05 deep,
 * and a wick. It has burnt a while: the rim has softened, and wax has run over it in three places.
 */
import { writeModel } from "./gltf.mjs";
import { joined, lathe } from "./lathe.mjs";

const radius = 0.2;
const height = 1;
const segments = 64;
const dishDepth = 0.05;
const rimRadius = 0.018;
const footRadius = 0.012;
const dishRadius = radius - rimRadius;

const textureRepeats = 2;
const tile = (2 * Math.PI * radius) / textureRepeats;

// The profile is measured from the crest of the rim: inwards across the dish it is negative,
// outwards it runs over the rim, down the side, round the foot and back to the axis.
const rimEnd = (Math.PI / 2) * rimRadius;
const sideEnd = rimEnd + height - rimRadius - footRadius;
const footEnd = sideEnd + (Math.PI / 2) * footRadius;
const profileEnd = footEnd + radius - footRadius;

function profile(distance) {
  if (distance < 0) {
    const fromAxis = dishRadius + distance;
    const rise = (1 - Math.cos((Math.PI * fromAxis) / dishRadius)) / 2;
    return [fromAxis, height - dishDepth * (1 - rise)];
  }
  if (distance < rimEnd) {
    const angle = distance / rimRadius;
    return [dishRadius + rimRadius * Math.sin(angle), height - rimRadius * (1 - Math.cos(angle))];
  }
  if (distance < sideEnd) return [radius, height - rimRadius - (distance - rimEnd)];
  if (distance < footEnd) {
    const angle = (distance - sideEnd) / footRadius;
    return [radius - footRadius * (1 - Math.cos(angle)), footRadius * (1 - Math.sin(angle))];
  }
  return [profileEnd - distance, 0];
}

const column = (2 * Math.PI) / segments;
const drips = [
  { angle: 6 * column, end: 0.33, halfWidth: 0.042, thickness: 0.017, sway: 0.05 },
  { angle: 25 * column, end: 0.51, halfWidth: 0.048, thickness: 0.02, sway: -0.06 },
  { angle: 45 * column, end: 0.2, halfWidth: 0.038, thickness: 0.014, sway: 0.03 },
];
const gathering = 0.7;

const alongDrip = (drip, distance) => Math.min(Math.max(distance, 0), drip.end);
const swayOf = (drip, distance) => drip.sway * Math.sin((4 * alongDrip(drip, distance)) / drip.end);

/** Sixty-four columns are few for a drip: they gather about it at half their spacing, and follow it. */
function columnAngle(distance, angle) {
  let gathered = angle;
  for (const drip of drips) {
    const beside = angleBetween(angle, drip.angle);
    const window = Math.max(0, 1 - (beside / gathering) ** 2) ** 2;
    gathered += window * (swayOf(drip, distance) - 0.5 * beside);
  }
  return gathered;
}

/** Wax that ran from the rim and set: a stem, and the bead that had just stopped at its end. */
function dripThickness(distance, angle) {
  let thickest = 0;
  for (const drip of drips) {
    const along = alongDrip(drip, distance);
    const beside = radius * angleBetween(angle, drip.angle + swayOf(drip, distance));
    const fromMiddle = Math.hypot(beside, 0.7 * (distance - along));
    const stem = smoothstep(0, 0.08, along);
    const bead = smoothstep(drip.end - 0.16, drip.end, along);
    const halfWidth = drip.halfWidth * (0.75 + 0.25 * bead);
    const dome = Math.max(0, 1 - (fromMiddle / halfWidth) ** 2) ** 2;
    thickest = Math.max(thickest, drip.thickness * (0.15 + 0.45 * stem + 0.4 * bead) * dome);
  }
  return thickest;
}

/** The rim is lower where it gave way to a drip, and uneven elsewhere: within 0.01 of its height. */
function rimOffset(angle) {
  let offset = 0;
  for (const wave of [2, 3, 5, 7]) {
    offset += (0.0075 / wave) * Math.sin(wave * angle + phase(wave));
  }
  for (const drip of drips)
    offset -= 0.004 * Math.exp(-((angleBetween(angle, drip.angle) / 0.3) ** 2));
  return 0.01 * Math.tanh(offset / 0.01);
}

function swelling(distance, angle) {
  const waves =
    Math.sin(2 * angle + 5 * distance + phase(11)) + Math.sin(3 * angle - 9 * distance + phase(13));
  const fade = smoothstep(0, 0.15, distance) * (1 - smoothstep(sideEnd - 0.25, sideEnd, distance));
  return 0.0012 * waves * fade;
}

function waxPoint(distance, evenAngle) {
  const angle = columnAngle(distance, evenAngle);
  const [fromAxis, up] = profile(distance);
  const step = 1e-5;
  const [beforeAxis, beforeUp] = profile(distance - step);
  const [afterAxis, afterUp] = profile(distance + step);
  const lift = dripThickness(distance, angle) + swelling(distance, angle);
  const outwards = fromAxis + (lift * (beforeUp - afterUp)) / (2 * step);
  const upwards = up + (lift * (afterAxis - beforeAxis)) / (2 * step);
  const softened =
    smoothstep(-dishRadius, 0, distance) * (1 - smoothstep(rimEnd, rimEnd + 0.25, distance));
  return around(outwards, upwards + softened * rimOffset(angle), angle);
}

const around = (fromAxis, up, angle) => [
  fromAxis * Math.sin(angle),
  up,
  fromAxis * Math.cos(angle),
];

const wrapped = (distance, turn) => {
  const angle = columnAngle(distance, 2 * Math.PI * turn);
  return [(angle / (2 * Math.PI)) * textureRepeats, distance / tile];
};
const fromAbove = (_distance, _turn, [x, , z]) => [x / tile, z / tile];
const fromBelow = (_distance, _turn, [x, , z]) => [x / tile, -z / tile];

// Wound polar, the texture would shrink to a point on the axis; laid flat it keeps its scale. The two
// meet inside the rim, where the eye does not follow the silhouette.
const dishSeam = -0.03;
const stemRings = [0.06, 0.1, 0.14, 0.29, 0.42, 0.455, 0.72];
const beadRings = drips.flatMap(({ end }) => evenly(end - 0.02, end + 0.076, 6));
const sideRings = [...stemRings, ...beadRings].sort((a, b) => a - b);
const surface = { segments, point: waxPoint };
const wax = joined(
  lathe({ ...surface, distances: evenly(-dishRadius, dishSeam, 8), texcoord: fromAbove }),
  lathe({
    ...surface,
    distances: [
      ...evenly(dishSeam, 0, 2),
      ...evenly(0, rimEnd, 4).slice(1),
      ...sideRings,
      sideEnd,
      ...evenly(sideEnd, footEnd, 2).slice(1),
    ],
    texcoord: wrapped,
  }),
  lathe({ ...surface, distances: [footEnd, profileEnd], texcoord: fromBelow }),
);

const wickBase = height - dishDepth;
const wickTip = 1.07;
const wickLength = wickTip - wickBase;
const wickRadius = { base: 0.012, tip: 0.0075 };
const wickTipEnd = (Math.PI / 2) * wickRadius.tip;
const wickEnd = wickTipEnd + wickLength - wickRadius.tip;
const wickBend = 0.016;
const wickHeading = 1.1;

/** The wick leans over as it rises; its heading lies in the plane it bends in. */
function wickCentre(up) {
  return around(wickBend * ((up - wickBase) / wickLength) ** 2, up, wickHeading);
}

function wickPoint(distance, angle) {
  const onTip = Math.min(distance / wickRadius.tip, Math.PI / 2);
  const below =
    distance < wickTipEnd
      ? wickRadius.tip * (1 - Math.cos(onTip))
      : wickRadius.tip + distance - wickTipEnd;
  const taper = Math.max(0, (distance - wickTipEnd) / (wickEnd - wickTipEnd));
  const fromMiddle =
    (wickRadius.tip + taper * (wickRadius.base - wickRadius.tip)) * Math.sin(onTip);

  const up = wickTip - below;
  const [x, y, z] = wickCentre(up);
  const lean = Math.atan((2 * wickBend * (up - wickBase)) / wickLength ** 2);
  const forwards = fromMiddle * Math.cos(angle - wickHeading);
  const sideways = fromMiddle * Math.sin(angle - wickHeading);
  const level = forwards * Math.cos(lean);
  return [
    x + level * Math.sin(wickHeading) + sideways * Math.cos(wickHeading),
    y - forwards * Math.sin(lean),
    z + level * Math.cos(wickHeading) - sideways * Math.sin(wickHeading),
  ];
}

const wickGirth = 2 * Math.PI * wickRadius.base;
const wick = lathe({
  distances: [...evenly(0, wickTipEnd, 3), ...evenly(wickTipEnd, wickEnd, 7).slice(1)],
  segments: 10,
  point: wickPoint,
  texcoord: (distance, turn) => [turn, distance / wickGirth],
});

function evenly(from, to, steps) {
  return Array.from({ length: steps + 1 }, (_, step) => from + ((to - from) * step) / steps);
}

function smoothstep(from, to, value) {
  const t = Math.min(Math.max((value - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}

function angleBetween(a, b) {
  const turns = (a - b) / (2 * Math.PI);
  return 2 * Math.PI * (turns - Math.round(turns));
}

/** Jarzynski and Olano 2020, "Hash Functions for GPU Rendering": one-dimensional PCG. */
function phase(seed) {
  const state = (Math.imul(seed, 747796405) + 2891336453) >>> 0;
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0;
  return (2 * Math.PI * (((word >>> 22) ^ word) >>> 0)) / 2 ** 32;
}

await writeModel(new URL("../../public/models/paper-candle.glb", import.meta.url), {
  materials: [
    { name: "wax", textures: "wax" },
    { name: "wick", baseColor: 0.05, roughness: 0.9 },
  ],
  meshes: [
    { name: "candle", material: "wax", triangles: wax, centre: [0, height / 2, 0], facing: 1 },
    {
      name: "wick",
      material: "wick",
      triangles: wick,
      centre: wickCentre(wickBase + wickLength / 2),
      facing: 1,
    },
  ],
  anchors: [{ name: "flame", translation: wickCentre(wickTip) }],
});
