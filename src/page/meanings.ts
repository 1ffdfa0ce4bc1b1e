import type { Feature, Inspection, SettingName } from "../settings.js";

/** What each attribute is for, for the page and the manifest; the element does not contain it. */
export const SETTING_MEANINGS: Readonly<Record<SettingName, string>> = {
  scene: "A room to walk in, or the candle alone over the page's own background.",
  look: "Which renderer: light in real units, the paper's final product, or its “before”.",
  src: "URL of a .glb or .gltf that replaces the room.",
  quality: "Resolution and detail; auto starts at low and rises as far as frame times allow.",
  controls: "First-person controls; without it the element takes no input.",
  sensitivity: "How far the view turns for a movement of the mouse or a finger.",
  motion: "Sway and flicker: auto follows the visitor's system; reduced gives a still flame.",
  paused: "No time passes; a frame is drawn only when something changes.",
  seed: "Same seed, same steps, same pixels on the same renderer.",
  unlit: "The candle starts, or is put, out.",
  "lit-wicks":
    "Which candles burn at first, by their numbers, such as “0 2”: 0 is the carried one.",
  wind: "Mean draught in the room.",
  "wind-direction": "Where the wind blows to: 0 is −Z, counter-clockwise from above.",
  gustiness: "Gusts of the wind: 0 is steady.",
  wick: "Diameter of the wick: a bigger one burns higher.",
  moonlight:
    "Light of a full moon outside; none by default in a room of yours without a node “moon”.",
  "moon-direction":
    "Where the moon stands, such as “120 30”: azimuth (0 is −Z, counter-clockwise from above) and elevation, degrees.",
  exposure: "Exposure compensation.",
  particles:
    "Particles alive at once: the flame's in the paper's looks, dust and sparks in the physical one; 0 is the look's own count.",
  "max-pixel-ratio": "Cap on device pixels per CSS pixel.",
  "asset-base": "URL that models and textures are fetched from.",
  loading: "Lazy: nothing is fetched or compiled until the element is near the viewport.",
  poster: "Image shown until the first frame, or without WebGL 2.",
  alt: "Accessible name.",
};

/** What each technique does. */
export const FEATURE_MEANINGS: Readonly<Record<Feature, string>> = {
  particles: "The flame's particles: update and drawing.",
  core: "The core layer: small, bright, fast, short-lived.",
  hazeLayer: "The haze layer: larger, slower, longer-lived, translucent.",
  gradient: "Sprites shade from a bright centre to a transparent rim, and with height.",
  attenuation: "Light falls off with distance.",
  drift: "Particles are pushed sideways at random.",
  flicker: "The light varies with time.",
  normalMaps: "Relief of walls and wax.",
  candle: "The candle itself.",
  volume: "The flame itself, ray-marched; its light on the room remains.",
  shadows: "Shadows, as soft as the flame is wide and high.",
  indirect: "Light reflected by the room's surfaces, after any number of bounces.",
  specular: "Highlights: smooth surfaces mirror the flame and the room.",
  translucency: "The top of the candle glows from within.",
  haze: "Hot air over the flame refracts the view through it.",
  smoke: "Smoke of the wick when its flame is out.",
  sparks: "Drops of burning wax that the wick ejects at times.",
  dust: "Motes that drift through the light.",
  bloom: "Light scattered in the eye, around the flame.",
  autoExposure: "The eye opens in the dark and closes in the light, within seconds and limits.",
  adaptation: "The adapted eye sees candlelight as nearly white.",
  toneMap: "Bright light bends towards white, as on film; else it is clipped.",
};

/** What each inspection shows. */
export const INSPECTION_MEANINGS: Readonly<Record<Inspection, string>> = {
  picture: "The frame itself.",
  radiance:
    "Luminance in false colour: from 0.001 cd/m² (black) by 0.1 (blue), 3 (green) and 100 (yellow) to 10,000 (white).",
  exposure:
    "Zones of a photograph, a stop each; grey is middle grey, red is burnt out, blue is lost in the dark.",
  bloom: "Light scattered in the eye, before it is mixed in.",
  normals: "Direction of surfaces: red to the right, green up, blue towards +Z.",
  depth: "How far away things are: white is near, black 10 m away.",
  "shadow-cube":
    "Distance of surfaces from the flame in all directions, unfolded: the walls in a row, ceiling above, floor below.",
  "irradiance-volume":
    "Light from all around at each probe of the room, planes of them side by side.",
  haze: "Offset of the background by hot air: reddish to the right, greenish up, grey for none.",
  soot: "The flame's glowing soot alone.",
  blue: "The flame's blue base alone: light of CH* and C2*.",
  temperature: "Colour temperature of the flame's soot: from 1400 K (dark red) to 2000 K (white).",
};
