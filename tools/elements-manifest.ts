import { SETTINGS } from "../src/settings.ts";

const TYPES = { number: "number", flag: "boolean", text: "string" } as const;

/** What editors learn of the tag: the custom elements manifest, schema 1.0.0, from the settings' table. */
export function manifest() {
  const attributes = Object.entries(SETTINGS).map(([name, setting]) => ({
    name,
    fieldName: name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase()),
    description: setting.meaning,
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
            members: attributes.map(({ fieldName, description, type }) => ({
              kind: "field",
              name: fieldName,
              description,
              type,
            })),
            cssParts: ["canvas", "poster", "progress", "hint", "error", "glow"].map((name) => ({
              name,
            })),
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
