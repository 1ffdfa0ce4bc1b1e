import type { Flame } from "../world/flame/flame.js";
import { PARCELS } from "../world/flame/spine.js";
import type { Vec3 } from "../world/geometry.js";
import { BODY_REACH, BODY_SIZE, type FlameBody, outline } from "./flame-body.js";

/** Sections along the spine, evenly spaced along the way from the foot to the tip. */
const NODES = 16;
/** Bounding spheres of the body: rays are marched inside of them only. */
export const BALLS = 8;

/** More of the fuel burns blue then, by this factor. */
const BLUENESS = 2.5;

/**
 * The body of a flame as it is bent, stretched and dimmed at this moment: what is drawn, and what
 * lights the room. Lengths in metres from the foot of the flame.
 */
export type FlameShape = ReturnType<typeof createShape>;

export function createShape() {
  return {
    /** Luminous length along the spine, and largest radius. */
    length: 0,
    radius: 0,
    /** From the foot. */
    tip: [0, 0, 0] as Vec3,
    /** Factors on the table's soot and blue. */
    soot: 0,
    blue: 0,
    /** Of each node: x, y, z, share of the length. */
    nodes: new Float32Array(NODES * 4),
    /** Of each node, in every fourth: factor on the radius. */
    necks: new Float32Array(NODES * 4),
    /** Of each ball: x, y, z, radius. */
    balls: new Float32Array(BALLS * 4),
    /** Candela: of soot and of the blue bands. */
    sootIntensity: 0,
    blueIntensity: 0,
    centre: new Float64Array(3),
    /** From the centre to the upper end of the light, as a capsule. */
    reach: new Float64Array(3),
  };
}

/** Pieces of the spine, for integrals along it. */
const PIECES = 64;
const path = new Float64Array((PIECES + 1) * 3);
/** How far along the way from the foot to the tip each of its points is, share. */
const ways = new Float64Array(PIECES + 1);

/**
 * Bends, stretches and dims a body as the flame has it, into `shape`. Nothing is allocated.
 *
 * @param leastRadius to which it is widened, and lengthened to twice of it, metres; its light stays
 */
export function shapeFlame(
  flame: Flame,
  body: FlameBody,
  shape: FlameShape,
  leastRadius = 0,
): FlameShape {
  const { glow, effectiveStrain, presence } = flame;
  const length = Math.max(flame.height, 2 * leastRadius);
  const radius = Math.max(flame.radius, leastRadius);
  shape.length = length;
  shape.radius = radius;
  tracePath(flame.spine.positions, length);
  placeNodes(shape, flame);
  measureSections(shape);
  const volume = (length / body.height) * (radius / body.radius) ** 2;
  // However its volume swings, the light is the limiter's, on the canvas and in the room.
  shape.soot = volume > 0 ? glow / (volume * bulging(body)) : 0;
  // The blue sheet is as thick and as bright on any flame: its light goes as its area.
  const sheet = (body.radius * flame.radius * flame.height) / (radius ** 2 * length);
  shape.blue = glow > 0 ? sheet * (1 + BLUENESS * effectiveStrain) * presence : 0;
  gatherLight(body, shape, volume);
  placeBalls(shape);
  return shape;
}

/** The middle of the flame from its foot to its tip, in pieces of equal length. */
function tracePath(spine: Float64Array, length: number): void {
  path.fill(0, 0, 3);
  const step = length / PIECES;
  let x = 0;
  let y = 0;
  let z = 0;
  let parcel = 0;
  let dx = 0;
  let dy = 1;
  let dz = 0;
  for (let piece = 1; piece <= PIECES; piece++) {
    let remaining = step;
    while (remaining > 0) {
      // V8 would deoptimize a read past the end.
      const at = Math.min(parcel, PARCELS - 1) * 3;
      const toX = (spine[at] ?? 0) - x;
      const toY = (spine[at + 1] ?? 0) - y;
      const toZ = (spine[at + 2] ?? 0) - z;
      const distance = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
      // Parcels that have not risen, or sink, are passed over; past the last one it goes on straight.
      const isNext = parcel < PARCELS && toY > 1e-7 && distance > 1e-7;
      if (parcel < PARCELS && !isNext) {
        parcel++;
        continue;
      }
      if (isNext) {
        dx = toX / distance;
        dy = toY / distance;
        dz = toZ / distance;
      }
      const way = isNext ? Math.min(remaining, distance) : remaining;
      x += dx * way;
      y += dy * way;
      z += dz * way;
      remaining -= way;
      if (isNext && way === distance) parcel++;
    }
    path[piece * 3] = x;
    path[piece * 3 + 1] = y;
    path[piece * 3 + 2] = z;
  }
}

function placeNodes({ tip, nodes, necks }: FlameShape, flame: Flame): void {
  for (let axis = 0; axis < 3; axis++) tip[axis] = path[PIECES * 3 + axis] ?? 0;
  const squared = tip[0] * tip[0] + tip[1] * tip[1] + tip[2] * tip[2] + 1e-12;
  for (let piece = 0, at = 0; piece <= PIECES; piece++, at += 3) {
    const along = (path[at] ?? 0) * tip[0] + (path[at + 1] ?? 0) * tip[1];
    ways[piece] = (along + (path[at + 2] ?? 0) * tip[2]) / squared;
  }
  let piece = 0;
  for (let node = 0; node < NODES; node++) {
    const way = node / (NODES - 1);
    while (piece < PIECES - 1 && (ways[piece + 1] ?? 0) < way) piece++;
    const low = ways[piece] ?? 0;
    const high = ways[piece + 1] ?? 0;
    const t = Math.min(Math.max((way - low) / Math.max(high - low, 1e-9), 0), 1);
    const at = piece * 3;
    for (let axis = 0; axis < 3; axis++) {
      nodes[node * 4 + axis] = mix(path[at + axis] ?? 0, path[at + 3 + axis] ?? 0, t);
    }
    nodes[node * 4 + 3] = (piece + t) / PIECES;
    necks[node * 4] = flame.neck(nodes[node * 4 + 1] ?? 0);
  }
}

/** Factor on the section of the body at each row, as it puffs. */
const sections = new Float64Array(BODY_SIZE.height);

function measureSections({ necks }: FlameShape): void {
  for (let row = 0; row < sections.length; row++) {
    const piece = Math.floor(((row + 0.5) / BODY_SIZE.height) * PIECES);
    const place = Math.max((ways[piece] ?? 0) * (NODES - 1), 0);
    const node = Math.min(Math.floor(place), NODES - 2);
    const low = necks[node * 4] ?? 1;
    const high = necks[node * 4 + 4] ?? 1;
    const neck = mix(low, high, Math.min(place - node, 1));
    sections[row] = neck * neck;
  }
}

/** The body's soot, as its sections swing, over what it is at rest. */
function bulging({ sootRows }: FlameBody): number {
  let swung = 0;
  let still = 0;
  for (let row = 0; row < BODY_SIZE.height; row++) {
    const soot = sootRows[row] ?? 0;
    swung += soot * (sections[row] ?? 1);
    still += soot;
  }
  return swung / still;
}

/** Intensity, centre and extent of the light, integrated over the rows of the table. */
function gatherLight(body: FlameBody, shape: FlameShape, volume: number): void {
  const { sootRows, blueRows } = body;
  const { centre, reach } = shape;
  const rows = BODY_SIZE.height;
  const sootFactor = shape.soot * volume;
  const blueFactor = shape.blue * volume;
  let soot = 0;
  let blue = 0;
  centre.fill(0);
  for (let row = 0; row < rows; row++) {
    const swing = sections[row] ?? 1;
    const ofSoot = (sootRows[row] ?? 0) * sootFactor * swing;
    const ofBlue = (blueRows[row] ?? 0) * blueFactor * swing;
    soot += ofSoot;
    blue += ofBlue;
    const at = Math.floor(((row + 0.5) / rows) * PIECES) * 3;
    for (let axis = 0; axis < 3; axis++) {
      centre[axis] = (centre[axis] ?? 0) + (ofSoot + ofBlue) * (path[at + axis] ?? 0);
    }
  }
  shape.sootIntensity = soot;
  shape.blueIntensity = blue;
  const total = Math.max(soot + blue, 1e-12);
  for (let axis = 0; axis < 3; axis++) centre[axis] = (centre[axis] ?? 0) / total;
  // The capsule's ends: where the brightest nine tenths of the body begin and end.
  const low = Math.round(0.2 * PIECES) * 3;
  const high = Math.round(0.92 * PIECES) * 3;
  for (let axis = 0; axis < 3; axis++) {
    reach[axis] = ((path[high + axis] ?? 0) - (path[low + axis] ?? 0)) / 2;
  }
}

function placeBalls(shape: FlameShape): void {
  const stride = PIECES / BALLS;
  let widest = 1;
  for (let node = 0; node < NODES; node++) {
    widest = Math.max(widest, shape.necks[node * 4] ?? 1);
  }
  for (let ball = 0; ball < BALLS; ball++) {
    const first = ball * stride;
    const middle = (first + stride / 2) * 3;
    const at = ball * 4;
    for (let axis = 0; axis < 3; axis++) shape.balls[at + axis] = path[middle + axis] ?? 0;
    let radius = 0;
    for (let piece = first; piece <= first + stride; piece++) {
      const dx = (path[piece * 3] ?? 0) - (path[middle] ?? 0);
      const dy = (path[piece * 3 + 1] ?? 0) - (path[middle + 1] ?? 0);
      const dz = (path[piece * 3 + 2] ?? 0) - (path[middle + 2] ?? 0);
      const outer = shape.radius * outline(piece / PIECES) * BODY_REACH * widest;
      radius = Math.max(radius, Math.sqrt(dx * dx + dy * dy + dz * dz + outer * outer));
    }
    shape.balls[at + 3] = radius;
  }
}

function mix(from: number, to: number, t: number): number {
  return from + (to - from) * t;
}
