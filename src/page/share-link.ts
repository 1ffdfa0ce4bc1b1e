import type { Camera } from "../candle-flame-element.js";
import {
  FIELDS_OF_VIEW,
  parseChoice,
  parseIndices,
  parseNumber,
  SETTINGS,
  type Setting,
} from "../settings.js";

/** Settings that a link carries and the page's dialog shows. */
export const SHOWN = [
  "quality",
  "exposure",
  "wind",
  "wind-direction",
  "gustiness",
  "wick",
  "moonlight",
  "moon-direction",
] as const;
/** Settings that a link carries beside the camera. */
export const SHARED = ["look", "seed", ...SHOWN, "particles", "unlit", "lit-wicks"] as const;
export type Shared = (typeof SHARED)[number];

/** A view: camera, candle, and the attributes that are not at their defaults. */
export interface View {
  readonly camera: Camera | null;
  /** Camera from which the candle was put down; null if it is held. */
  readonly candle: Camera | null;
  readonly settings: Readonly<Partial<Record<Shared, string>>>;
}

/** Decimals: a tenth of a millimetre, and of a milliradian. */
const DIGITS = 4;

const NUMBER = /^-?\d{1,5}(\.\d{1,9})?$/;

/** The view as a location's hash. */
export function writeShareLink({ camera, candle, settings }: View): string {
  const words = new URLSearchParams();
  const usual = FIELDS_OF_VIEW[parseChoice(SETTINGS.look, settings.look ?? null)];
  for (const [name, stand] of Object.entries({ camera, candle })) {
    if (!stand) continue;
    const numbers = [...stand.position, stand.yaw, stand.pitch];
    const { fieldOfView } = stand;
    if (name === "camera" && fieldOfView && fieldOfView !== usual) numbers.push(fieldOfView);
    words.set(name, numbers.map((value) => Number(value.toFixed(DIGITS))).join("_"));
  }
  for (const name of SHARED) {
    const text = legalText(name, settings[name] ?? null);
    if (text !== null) words.set(name, text);
  }
  return `#${words}`;
}

/** The view of a location's hash. It is untrusted input: illegal values are left out. */
export function readShareLink(hash: string): View {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  const settings: Partial<Record<Shared, string>> = {};
  for (const name of SHARED) {
    const text = legalText(name, words.get(name));
    if (text !== null) settings[name] = text;
  }
  return {
    camera: readCamera(words.get("camera")),
    candle: readCamera(words.get("candle")),
    settings,
  };
}

function readCamera(text: string | null): Camera | null {
  const words = text?.split("_") ?? [];
  if (!/^[56]$/.test(`${words.length}`) || !words.every((word) => NUMBER.test(word))) return null;
  const [x = 0, y = 0, z = 0, yaw = 0, pitch = 0, fieldOfView] = words.map(Number);
  const stand: Camera = { position: [x, y, z], yaw, pitch };
  return fieldOfView === undefined ? stand : { ...stand, fieldOfView };
}

/** The legal text of a setting; null where that is its default. A flag is set by any text. */
function legalText(name: Shared, text: string | null): string | null {
  if (name === "lit-wicks") return parseIndices(text ?? "")?.join(" ") ?? null;
  if (name === "moon-direction") return moonPlaceOf(text ?? "");
  const setting: Exclude<Setting, { kind: "text" }> = SETTINGS[name];
  if (setting.kind === "flag") return text === null ? null : "";
  const value = setting.kind === "number" ? parseNumber(setting, text) : parseChoice(setting, text);
  return value === setting.default ? null : String(value);
}

/** Azimuth and elevation of the moon, by the element's own rules; null where it reads none. */
function moonPlaceOf(text: string): string | null {
  const numbers = (text.match(/[^\s,]+/g) ?? []).map(Number);
  if (numbers.length !== 2 || !numbers.every(Number.isFinite)) return null;
  return numbers.map((degrees) => Number(degrees.toFixed(DIGITS))).join(" ");
}
