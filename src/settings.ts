/**
 * Every tunable of the element, once: the attribute's name, unit, range and default.
 *
 * The element, the page, the documentation and the tests read this table. A value that cannot be
 * parsed or lies outside its range becomes the nearest legal value, or the default, as with HTML's
 * own attributes.
 */
export interface NumberSetting {
  readonly kind: "number";
  readonly default: number;
  readonly min: number;
  readonly max: number;
  readonly integer?: boolean;
  /** SI, or what the attribute says at the DOM's edge. */
  readonly unit: string;
  readonly meaning: string;
}

export interface ChoiceSetting<Choice extends string = string> {
  readonly kind: "choice";
  readonly choices: readonly Choice[];
  readonly default: Choice;
  readonly meaning: string;
}

export interface FlagSetting {
  readonly kind: "flag";
  readonly meaning: string;
}

export interface TextSetting {
  readonly kind: "text";
  readonly default: string;
  readonly meaning: string;
}

function choice<const Choice extends string>(
  choices: readonly [Choice, ...Choice[]],
  meaning: string,
): ChoiceSetting<Choice> {
  return { kind: "choice", choices, default: choices[0], meaning };
}

function number(
  unit: string,
  [initial, min, max]: readonly [number, number, number],
  meaning: string,
): NumberSetting {
  return { kind: "number", unit, default: initial, min, max, meaning };
}

export const SETTINGS = {
  scene: choice(
    ["room", "candle"],
    "A room to walk in, or the candle alone over the page's own background.",
  ),
  look: choice(
    ["physical", "paper", "original"],
    "Which renderer: light in real units, the paper's final product, or its “before”.",
  ),
  src: { kind: "text", default: "", meaning: "URL of a .glb or .gltf that replaces the room." },
  quality: choice(
    ["auto", "low", "medium", "high", "ultra"],
    "Resolution and detail; auto follows the renderer and the time that frames take.",
  ),
  controls: {
    kind: "flag",
    meaning: "First-person controls; without it the element takes no input.",
  },
  sensitivity: number(
    "",
    [1, 0.1, 5],
    "How far the view turns for a movement of the mouse or a finger.",
  ),
  motion: choice(
    ["auto", "reduced", "full"],
    "Sway and flicker: auto follows the visitor's system; reduced gives a still flame.",
  ),
  paused: {
    kind: "flag",
    meaning: "No time passes; a frame is drawn only when something changes.",
  },
  seed: {
    ...number("", [1, 0, 0xffffffff], "Same seed, same steps, same pixels on the same renderer."),
    integer: true,
  },
  unlit: { kind: "flag", meaning: "The candle starts, or is put, out." },
  wind: number("m/s", [0.05, 0, 5], "Mean draught in the room."),
  "wind-direction": number(
    "degrees",
    [0, -360, 360],
    "Where the wind blows to: 0 is −Z, counter-clockwise from above.",
  ),
  gustiness: number("", [0.5, 0, 1], "How squally the wind is: 0 is steady."),
  wick: number("mm", [2, 1, 50], "Diameter of the wick: a bigger one burns higher."),
  exposure: number("EV", [0, -8, 8], "Exposure compensation."),
  particles: {
    ...number(
      "",
      [0, 0, 1_000_000],
      "Particles that the flame keeps alive; 0 is the look's own count.",
    ),
    integer: true,
  },
  "max-pixel-ratio": number("", [2, 0.25, 4], "Cap on device pixels per CSS pixel."),
  "asset-base": {
    kind: "text",
    default: "",
    meaning: "URL that models and textures are fetched from.",
  },
  loading: choice(
    ["eager", "lazy"],
    "Lazy: nothing is fetched or compiled until the element is near the viewport.",
  ),
  poster: {
    kind: "text",
    default: "",
    meaning: "Image shown until the first frame, or without WebGL 2.",
  },
  alt: {
    kind: "text",
    default: "A burning candle in a dark log room",
    meaning: "Accessible name.",
  },
} as const satisfies Record<string, NumberSetting | ChoiceSetting | FlagSetting | TextSetting>;

export type SettingName = keyof typeof SETTINGS;
export type Look = (typeof SETTINGS.look.choices)[number];
export type Motion = (typeof SETTINGS.motion.choices)[number];
export type SceneName = (typeof SETTINGS.scene.choices)[number];
export type Quality = (typeof SETTINGS.quality.choices)[number];

/** What an attribute's text means under its setting. `null` is an absent attribute. */
export function parseNumber(setting: NumberSetting, text: string | null): number {
  const value = Number.parseFloat(text ?? "");
  if (!Number.isFinite(value)) return setting.default;
  const inRange = Math.min(Math.max(value, setting.min), setting.max);
  return setting.integer ? Math.trunc(inRange) : inRange;
}

export function parseChoice<Choice extends string>(
  setting: ChoiceSetting<Choice>,
  text: string | null,
): Choice {
  const word = text?.trim().toLowerCase();
  return setting.choices.find((known) => known === word) ?? setting.default;
}

/** What a student may switch off, one technique at a time, to see its effect and its cost. */
export const FEATURES = {
  particles: "The flame's particles: update and drawing.",
  core: "The core layer: small, bright, fast, short-lived.",
  hazeLayer: "The haze layer: larger, slower, longer-lived, translucent.",
  gradient: "Sprites shade from a bright centre to a transparent rim, and with height.",
  attenuation: "Light falls off with distance.",
  drift: "Particles are pushed sideways at random.",
  flicker: "The light varies with time.",
  normalMaps: "Relief of walls and wax.",
  candle: "The candle itself.",
  volume: "The flame's body, gathered along each ray; its light stays.",
  shadows: "What stands in the light's way, softly, as wide and high as the flame is.",
  indirect: "Light that comes from the room's surfaces, after any number of bounces.",
  specular: "Highlights: what is smooth mirrors the flame and the room.",
  translucency: "The top of the candle glows from within.",
  haze: "Hot air over the flame bends what is seen through it.",
  smoke: "Smoke of the wick when its flame is out.",
  sparks: "Burning wax that the wick spits, now and then.",
  dust: "Motes that drift through the light.",
  bloom: "Light scattered in the eye, around the flame.",
  autoExposure: "The eye opens in the dark and closes in the light, within seconds and limits.",
  adaptation: "The eye takes candlelight for nearly white.",
  toneMap: "Bright light bends towards white, as on film; else it is clipped.",
} as const;
export type Feature = keyof typeof FEATURES;

/** What each look has of them. */
export const FEATURES_OF: Readonly<Record<Look, readonly Feature[]>> = {
  physical: [
    "volume",
    "candle",
    "shadows",
    "indirect",
    "specular",
    "translucency",
    "normalMaps",
    "haze",
    "smoke",
    "sparks",
    "dust",
    "bloom",
    "autoExposure",
    "adaptation",
    "toneMap",
  ],
  paper: [
    "particles",
    "core",
    "hazeLayer",
    "gradient",
    "attenuation",
    "drift",
    "flicker",
    "normalMaps",
    "candle",
  ],
  original: ["particles", "core", "candle"],
};
export type Features = Record<Feature, boolean>;

export function allFeatures(): Features {
  return Object.fromEntries(Object.keys(FEATURES).map((name) => [name, true])) as Features;
}

/** What may be looked at instead of the picture, in the physical look: `element.inspect = "depth"`. */
export const INSPECTIONS = {
  picture: "What the eye sees.",
  radiance:
    "Luminance in false colour: from 0.001 cd/m² (black) by 0.1 (blue), 3 (green) and 100 (yellow) to 10,000 (white).",
  exposure:
    "Zones of a photograph, a stop each; grey is middle grey, red is burnt out, blue is lost in the dark.",
  bloom: "Light scattered in the eye, before it is mixed in.",
  normals: "Which way surfaces face: red to the right, green up, blue towards +Z.",
  depth: "How far away things are: white is near, black 10 m away.",
  "shadow-cube":
    "How far the flame sees, in all directions, unfolded: the walls in a row, ceiling above, floor below.",
  "irradiance-volume":
    "Light from all around at each probe of the room, planes of them side by side.",
  haze: "How far hot air moves what is behind it: reddish to the right, greenish up, grey nowhere.",
  soot: "The flame's glowing soot alone.",
  blue: "The flame's blue base alone: light of CH* and C2*.",
  temperature: "Colour temperature of the flame's soot: from 1400 K (dark red) to 2000 K (white).",
} as const;
export type Inspection = keyof typeof INSPECTIONS;
