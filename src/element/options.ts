import type { Options } from "../candle-flame.js";
import { resolveUrl } from "../scenes/resolve-url.js";
import { type Look, parseIndices } from "../settings.js";
import { type MoonWish, parseMoonPlace } from "../world/moon.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

const LESS_MOTION = "(prefers-reduced-motion: reduce)";

/** Options of the candle, in SI units, from the element's attributes. */
export function optionsOf(element: ReflectedAttributes, look: Look): Options {
  const { seed, quality, exposure, particles, motion, unlit, wick, gustiness } = element;
  const isStill = motion === "reduced" || (motion === "auto" && matchMedia(LESS_MOTION).matches);
  const direction = (element.windDirection * Math.PI) / 180;
  const wind = { speed: element.wind, direction, gustiness };
  const wickDiameter = isNumber(element, "wick") ? wick / 1000 : null;
  const flame = { unlit, litWicks: parseIndices(element.litWicks), wick: wickDiameter, wind };
  return { look, seed, quality, exposure, particles, isStill, ...flame, moon: moonWish(element) };
}

function isNumber(element: Element, name: string): boolean {
  return Number.isFinite(Number.parseFloat(element.getAttribute(name) ?? ""));
}

/** The attributes of the moon; null leaves a value to the room. */
function moonWish(element: ReflectedAttributes): MoonWish {
  return {
    illuminance: isNumber(element, "moonlight") ? element.moonlight : null,
    direction: parseMoonPlace(element.moonDirection),
  };
}

export function observeLessMotion(signal: AbortSignal, onChange: () => void): void {
  matchMedia(LESS_MOTION).addEventListener("change", onChange, { signal });
}

/** URL of the folder of the built-in models: `asset-base`, or the one that this module lies in. */
export function assetRootOf({ assetBase }: ReflectedAttributes): string {
  const module = new URL(".", import.meta.url).href;
  if (assetBase === "") return module;
  return (
    resolveUrl(assetBase.endsWith("/") ? assetBase : `${assetBase}/`, document.baseURI) ?? module
  );
}
