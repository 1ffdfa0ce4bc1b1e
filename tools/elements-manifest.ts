import type { CandleFlameElement, CandleFlameEventMap } from "../src/candle-flame-element.ts";
import type { ReflectedAttributes } from "../src/element/reflected-attributes.ts";
import { SETTING_MEANINGS } from "../src/page/meanings.ts";
import { INSPECTIONS, SETTINGS, type SettingName } from "../src/settings.ts";

const TYPES = { number: "number", flag: "boolean", text: "string" } as const;

const EVENTS: Readonly<Record<keyof CandleFlameEventMap, string>> = {
  progress: "Loading goes on; detail.totalProgress is 0 to 1.",
  load: "The first frame is there, or that of another look or room.",
  error: "detail.type, detail.message and detail.cause say what failed.",
  play: "Time passes from now on.",
  pause: "Time stands still, for `paused` or for want of a visitor who sees it.",
  light: "The candle was lit.",
  extinguish: "The candle went out.",
  place: "The candle was put down.",
  take: "The candle was taken up.",
  enter: "The visitor went in.",
  leave: "The visitor left.",
  qualitychange: "Another quality draws, by `quality` or by `auto`.",
  camerachange: "The visitor moved, looked around or was moved.",
  contextlost: "The graphics driver took the picture away.",
  contextrestored: "The picture is back.",
};

type Method = {
  [Name in keyof CandleFlameElement]-?: Name extends keyof HTMLElement
    ? never
    : CandleFlameElement[Name] extends (...parameters: never) => unknown
      ? Name
      : never;
}[keyof CandleFlameElement];
type Callback = "connectedCallback" | "disconnectedCallback" | "attributeChangedCallback";

const METHODS: Readonly<Record<Exclude<Method, Callback>, string>> = {
  play: "Lets time pass.",
  pause: "Stops time.",
  step: "Advances by exactly so many seconds, at most 60, then draws; works while paused.",
  reset: "Time 0, as if new; with a seed, another chance.",
  light: "Lights the candle.",
  extinguish: "Puts the candle out.",
  place: "Puts the candle down ahead.",
  take: "Takes the candle up.",
  blow: "A breath from the camera, 0 to 10 times as strong as one that puts the candle out.",
  mirror: "Takes over another element's moment, visitor and candle.",
  enter: "Goes in, as a click does.",
  readRadiance: "Linear RGB of canvas pixels before exposure and tone mapping, cd/m².",
  toBlob: "The picture, as of the last frame.",
};

type Own = Exclude<keyof CandleFlameElement, keyof HTMLElement>;
type Attribute = keyof ReflectedAttributes;

/** Properties that are no attribute's. */
const FIELDS: Readonly<
  Record<
    Exclude<Own, Method | Callback | Attribute>,
    { readonly type: string; readonly meaning: string; readonly readonly?: boolean }
  >
> = {
  lit: { type: "boolean", meaning: "Whether the candle burns." },
  held: { type: "boolean", meaning: "Whether the candle is in the hand.", readonly: true },
  camera: {
    type: "Camera",
    meaning: "Where the visitor stands and looks, and how widely: metres, radians.",
  },
  currentTime: { type: "number", meaning: "Seconds simulated since reset().", readonly: true },
  ready: { type: "Promise<void>", meaning: "Resolves after the first frame.", readonly: true },
  flame: { type: "FlameReport | null", meaning: "The flame, in SI units.", readonly: true },
  stats: { type: "Stats", meaning: "Numbers of the last frame.", readonly: true },
  features: { type: "Features", meaning: "Techniques that can be switched off, one by one." },
  inspect: {
    type: INSPECTIONS.map((name) => `"${name}"`).join(" | "),
    meaning: "What is shown of each frame: the picture, or what a pass leaves for the next.",
  },
};

const SLOTS = {
  poster: "In place of the poster's image.",
  progress: "In place of the bar, while loading.",
  hint: "In place of the line that lists the controls.",
  error: "In place of the sentence that says what failed.",
} as const;

const PARTS = {
  canvas: "The picture.",
  poster: "The image until the first frame, and without a picture.",
  progress: "The bar that shows how far loading is.",
  hint: "What the visitor should know for a moment.",
  error: "What stands in the picture's place when there is none.",
  reload: "The button that begins anew, where a lost picture does not come back.",
  glow: 'The light that falls on the page, with `scene="candle"`.',
} as const;

const STATES = {
  loading: "There is no picture yet.",
  lit: "The candle burns.",
  walking: "The visitor is in the room.",
  playing: "Time passes.",
  alone: "The candle stands alone on the page.",
} as const;

const described = (table: Readonly<Record<string, string>>) =>
  Object.entries(table).map(([name, description]) => ({ name, description }));

/** What editors learn of the tag: the custom elements manifest, schema 1.0.0, from the settings' table. */
export function manifest() {
  const attributes = Object.entries(SETTINGS).map(([name, setting]) => ({
    name,
    fieldName: name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase()),
    description: SETTING_MEANINGS[name as SettingName],
    type: {
      text:
        setting.kind === "choice"
          ? setting.choices.map((choice) => `"${choice}"`).join(" | ")
          : TYPES[setting.kind],
    },
    ...("default" in setting ? { default: JSON.stringify(setting.default) } : {}),
  }));
  const path = "candle-flame-element.js";
  const declaration = { name: "CandleFlameElement", module: path };
  return {
    schemaVersion: "1.0.0",
    modules: [
      {
        kind: "javascript-module",
        path,
        declarations: [
          {
            kind: "class",
            customElement: true,
            name: "CandleFlameElement",
            tagName: "candle-flame",
            description: "A candle in a dark room, or alone on the page.",
            superclass: { name: "HTMLElement" },
            attributes,
            members: [
              ...attributes.map(({ fieldName, description, type }) => ({
                kind: "field",
                name: fieldName,
                description,
                type,
              })),
              ...Object.entries(FIELDS).map(([name, { type, meaning, ...flags }]) => ({
                kind: "field",
                name,
                description: meaning,
                type: { text: type },
                ...flags,
              })),
              ...described(METHODS).map((method) => ({ kind: "method", ...method })),
            ],
            events: described(EVENTS).map((event) => ({ ...event, type: { text: "CustomEvent" } })),
            slots: described(SLOTS),
            cssParts: described(PARTS),
            cssStates: described(STATES),
            cssProperties: [
              { name: "--candle-flame-progress-color", default: "#f0a54a" },
              { name: "--candle-flame-progress-height", default: "3px" },
              { name: "--candle-flame-glow", default: "0" },
            ],
          },
        ],
        exports: [{ kind: "js", name: declaration.name, declaration }],
      },
      {
        kind: "javascript-module",
        path: "define.js",
        exports: [{ kind: "custom-element-definition", name: "candle-flame", declaration }],
      },
    ],
  };
}
