import type { UniformBlock } from "../../gl/gpu.js";
import { luma, type Rgb } from "../../light/color.js";
import { flameLight, TAPER } from "../../light/flame-light.js";
import { adaptedMoonlight } from "../../light/moonlight.js";
import type { World } from "../../world/world.js";
import { type CachedLight, candlesOf, hasStandingFlames, isUnlit } from "../cached-light.js";
import type { FrameInput } from "../frame-input.js";
import { flameIntensity, lightBlock } from "../light-block.js";

const WHITE: Rgb = [1, 1, 1];
/** A flame that is out lights nothing, candela. */
const LEAST = 1e-6;

/** The light that a refined image is per candela of: the flame; the moon alone; or all flames as they burnt at the beginning. */
export class ImageLight {
  readonly block: UniformBlock;
  /** Whether that is the flame. */
  isOfFlame = true;
  /** Whether all flames were out at the beginning. */
  isUnlit = false;
  /** Colour of the flame, luma 1, as it was at the beginning. */
  flameColor: Rgb = TAPER.color;
  /** Of the carried flame then, candela. */
  carried: Rgb = TAPER.color;
  /** Of the image's light then. */
  #intensity: Rgb = TAPER.color;
  /** What that is a multiple of, candela. */
  #unit: Rgb = WHITE;
  /** Of the standing candles by name when the first tile was drawn, candela. */
  #candles: ReadonlyMap<string, Rgb> | null = null;

  /** @param block `Light` */
  constructor(block: UniformBlock) {
    this.block = block;
  }

  begin(frame: FrameInput): void {
    const { world } = frame;
    this.#candles = null;
    this.carried = flameIntensity(world);
    this.isUnlit = isUnlit(world);
    const total = this.#total(world);
    this.#unit = hasStandingFlames(world) ? total : WHITE;
    this.update(frame);
    this.#intensity = divide(total, this.#unit);
    const strength = luma(this.#intensity);
    if (strength > 0) this.flameColor = divide(this.#intensity, [strength, strength, strength]);
  }

  update({ world, settings }: FrameInput): void {
    const intensity = divide(this.#total(world), this.#unit);
    this.block.update({ ...lightBlock(world, settings.features.candle), intensity });
  }

  /** A light as a multiple of the flame's at the beginning, since the flame changes while the image is refined. */
  perCandela(intensity: Rgb): Rgb {
    return divide(intensity, this.#intensity);
  }

  /** The standing candles among the cached lights, as they burnt when this was first asked. */
  candlesOf(cached: readonly CachedLight[]): readonly CachedLight[] {
    const candles = candlesOf(cached);
    this.#candles ??= new Map(candles.map(({ name, intensity }) => [name, intensity]));
    const known = this.#candles;
    return candles.map((one) => ({ ...one, intensity: known.get(one.name) ?? one.intensity }));
  }

  /** Of all flames, or of the moon where that is all that shines. */
  #total(world: World): Rgb {
    const { moon, standing } = world;
    const isAlone = isUnlit(world);
    this.isOfFlame = !isAlone && !hasStandingFlames(world);
    if (moon && isAlone) return adaptedMoonlight(moon.illuminance);
    const lights = standing.map((candle) => flameLight(candle, TAPER).intensity);
    const sum = (i: 0 | 1 | 2) =>
      lights.reduce((all, one) => all + one[i], flameIntensity(world)[i]);
    return this.isOfFlame ? flameIntensity(world) : [sum(0), sum(1), sum(2)];
  }
}

function divide(one: Rgb, other: Rgb): Rgb {
  const part = (i: 0 | 1 | 2) => one[i] / Math.max(other[i], LEAST);
  return [part(0), part(1), part(2)];
}
