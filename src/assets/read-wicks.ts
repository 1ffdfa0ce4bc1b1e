import { type Object3D, Vector3 } from "three";
import type { Wick } from "./model.js";

/** Most wicks of a model that burn. */
const MOST = 16;
/** Of the diameter: default, least and most. Metres. */
const DIAMETER = { default: 0.002, least: 0.001, most: 0.05 } as const;
/** Cosine of the lean from which a wick burns upright: 45 degrees. */
const LEANING = Math.SQRT1_2;
/** Scale of a wick's own node, or its reciprocal, beyond which the author probably meant its diameter. */
const SCALED = 50;
/** Farthest from the origin, metres. */
const FARTHEST = 10_000;

/** Suffix of a wick's name; undefined for other nodes, such as `wickerwork`. */
export function wickEnding(name: string): string | undefined {
  return /^wick(?![a-z])(.*)$/s.exec(name)?.[1];
}

/** The wicks of a scene in the file's order; sentences about what is wrong with them are added. */
export function readWicks(scene: Object3D, warnings: Set<string>): Wick[] {
  const found: Object3D[] = [];
  const flames = new Map<string, Object3D>();
  scene.traverse((object) => {
    const { name, order, isMisplaced } = object.userData;
    if (typeof name !== "string" || typeof order !== "number") return;
    if (wickEnding(name) !== undefined) found.push(object);
    if (name.startsWith("flame") && !flames.has(name) && isMisplaced !== true) {
      flames.set(name, object);
    }
  });
  const wicks = found
    .toSorted((a, b) => a.userData.order - b.userData.order)
    .flatMap((object) => readWick(object, flames, warnings) ?? []);
  if (wicks.length > MOST) warnings.add(`Of its ${wicks.length} wicks ${MOST} burn.`);
  return wicks.slice(0, MOST).map(numbered(warnings));
}

/** Gives wicks of one name a number each: light and events go by names. */
function numbered(warnings: Set<string>): (wick: Wick) => Wick {
  const names = new Set<string>();
  return (wick) => {
    let { name } = wick;
    for (let count = 2; names.has(name); count++) name = `${wick.name}#${count}`;
    names.add(name);
    if (name === wick.name) return wick;
    warnings.add("Wicks of one name are numbered.");
    return { ...wick, name };
  };
}

/** The flame of a wick: beside it or below it in the tree, else the first of that name. */
function flameOf(object: Object3D, flames: ReadonlyMap<string, Object3D>): Object3D {
  const name = `flame${wickEnding(object.userData.name)}`;
  const near = [...object.children, ...(object.parent?.children ?? [])].find(
    ({ userData }) => userData.name === name && userData.isMisplaced !== true,
  );
  return near ?? flames.get(name) ?? object;
}

function readWick(
  object: Object3D,
  flames: ReadonlyMap<string, Object3D>,
  warnings: Set<string>,
): Wick | null {
  const { name, wickDiameter, isMisplaced } = object.userData;
  const root = flameOf(object, flames);
  const position = new Vector3().setFromMatrixPosition(root.matrixWorld);
  if (isMisplaced === true || !(position.length() <= FARTHEST)) {
    warnings.add("Wicks whose places are no numbers are left out.");
    return null;
  }
  // Its own: a whole model may be in centimetres.
  const scale = object.scale.length() / Math.sqrt(3);
  if (!(scale < SCALED && scale > 1 / SCALED)) {
    warnings.add("The scale of a wick is ignored: its diameter is wickDiameter, in mm.");
  }
  const up = new Vector3().setFromMatrixColumn(object.matrixWorld, 1).normalize();
  // NaN leans, too.
  if (!(up.y >= LEANING)) warnings.add("Wicks that lean by more than 45 degrees burn upright.");
  return {
    name,
    position: position.toArray(),
    wickDiameter: readDiameter(wickDiameter, warnings),
  };
}

/** Wick diameter, metres, from millimetres in the file. */
function readDiameter(value: unknown, warnings: Set<string>): number {
  if (value === undefined) return DIAMETER.default;
  const asked = typeof value === "number" ? value / 1000 : Number.NaN;
  const diameter = Number.isFinite(asked)
    ? Math.min(Math.max(asked, DIAMETER.least), DIAMETER.most)
    : DIAMETER.default;
  if (diameter !== asked) {
    warnings.add("Wick diameters are 1 to 50 mm: what is no number is 2 mm, all else the nearest.");
  }
  return diameter;
}
