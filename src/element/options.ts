import type { Options } from "../candle-flame.js";
import { resolveUrl } from "../scenes/resolve-url.js";
import { type Look, parseIndices, type SettingName } from "../settings.js";
import { windowOf } from "../window-of.js";
import { parseMoonPlace } from "../world/moon.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

/** Attributes that decide which models are fetched, and with others what the driver is asked for. */
export const SCENE_ATTRIBUTES: readonly string[] = ["scene", "look", "src", "asset-base"];
const COSTS = ["quality", "max-pixel-ratio", "particles"];
export const RENDERER_ATTRIBUTES: readonly string[] = [...SCENE_ATTRIBUTES, ...COSTS];

/** Options of the candle, in SI units, from the element's attributes; null leaves a value to the room. */
export function optionsOf(element: ReflectedAttributes, look: Look): Options {
  const { seed, quality, exposure, particles, motion, unlit, wick, gustiness } = element;
  const isStill = motion === "reduced" || (motion === "auto" && lessMotion(element).matches);
  const direction = (element.windDirection * Math.PI) / 180;
  const wind = { speed: element.wind, direction, gustiness: isStill ? 0 : gustiness };
  const isGiven = (name: SettingName) =>
    Number.isFinite(Number.parseFloat(element.getAttribute(name) ?? ""));
  const moon = {
    illuminance: isGiven("moonlight") ? element.moonlight : null,
    direction: parseMoonPlace(element.moonDirection),
  };
  const wickDiameter = isGiven("wick") ? wick / 1000 : null;
  const flame = { unlit, litWicks: parseIndices(element.litWicks), wick: wickDiameter, wind };
  return { look, seed, quality, exposure, particles, isStill, ...flame, moon };
}

/** The visitor's wish for less motion. */
export const lessMotion = (element: Element): MediaQueryList =>
  windowOf(element).matchMedia("(prefers-reduced-motion: reduce)");

/**
 * URL of the folder of the built-in models: `asset-base`, or the one that this module lies in; empty where neither is
 * known.
 *
 * @param module address of this module; a bundler may leave none, and nothing lies beside that of a blob
 */
export function assetRootOf(
  { assetBase, baseURI }: ReflectedAttributes,
  module: string = import.meta.url,
): string {
  const folder = assetBase.endsWith("/") ? assetBase : `${assetBase}/`;
  const own = assetBase === "" ? null : resolveUrl(folder, baseURI);
  return own ?? resolveUrl(".", module) ?? "";
}
